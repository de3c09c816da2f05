// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Sparse_cholesky.h"

#ifdef QUARTIC_HAS_CHOLMOD

#include <CGAL/Quartic_differentials/exceptions.h>

#include <dlfcn.h>

#include <algorithm>
#include <iterator>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

// From this size on, nested dissection (METIS) pays: a factorisation then takes half the time or less, and finding the
// order as long as three of them. Below, minimum degree (AMD) is as good. (benchmark/README.md, "Orders of elimination")
const std::size_t large = 100000;
const double      worn = 1.5;   // an order is found anew when the fill has grown by this factor

// A number that a library keeps to itself, set to another value for as long as the object lives; nothing happens where the
// library is not loaded.
class Setting
{
public:
  using Get = int (*)();
  using Set = void (*)(int);

  Setting(Get get, Set set, int value) : m_set(get != nullptr ? set : nullptr), m_old(m_set != nullptr ? get() : value)
  {
    if (m_old != value) m_set(value);
    else m_set = nullptr;
  }
  ~Setting()
  {
    if (m_set != nullptr) m_set(m_old);
  }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

private:
  Set m_set;
  int m_old;
};

template <class Function>
Function loaded(const char* name) { return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name)); }

// Keeps CHOLMOD and the BLAS to one thread. CHOLMOD 3 asks OpenMP for four, whatever the machine has, and they wait for each
// other most of the time: twice the CPU time, and results that depend on the number of cores.
class One_thread
{
  static const Setting::Get levels, threads;
  static const Setting::Set set_levels, set_threads;
  const Setting m_openmp{levels, set_levels, 0};   // no level of parallel regions
  const Setting m_blas{threads, set_threads, 1};
};

const Setting::Get One_thread::levels  = loaded<Setting::Get>("omp_get_max_active_levels");
const Setting::Set One_thread::set_levels = loaded<Setting::Set>("omp_set_max_active_levels");
const Setting::Get One_thread::threads = loaded<Setting::Get>("openblas_get_num_threads");
const Setting::Set One_thread::set_threads = loaded<Setting::Set>("openblas_set_num_threads");

// CHOLMOD's view of Eigen's memory.
cholmod_sparse view_of(const Sparse_cholesky::Matrix& lower)
{
  auto& m = const_cast<Sparse_cholesky::Matrix&>(lower);   // CHOLMOD does not write to it
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(m.rows());
  view.ncol = static_cast<std::size_t>(m.cols());
  view.nzmax = static_cast<std::size_t>(m.nonZeros());
  view.p = m.outerIndexPtr();
  view.i = m.innerIndexPtr();
  view.x = m.valuePtr();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

cholmod_dense view_of(Eigen::MatrixXd& m)
{
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(m.rows());
  view.ncol = static_cast<std::size_t>(m.cols());
  view.nzmax = static_cast<std::size_t>(m.size());
  view.d = view.nrow;
  view.x = m.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

// An order of n rows: the known ones as they stood, then the rest.
std::vector<int> extended(const std::vector<int>& order, int n)
{
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(n));
  std::copy_if(order.begin(), order.end(), std::back_inserter(result), [n](int row) { return row < n; });
  for (int row = static_cast<int>(order.size()); row < n; ++row) result.push_back(row);
  return result;
}

} // namespace

Sparse_cholesky::Sparse_cholesky()
{
  cholmod_start(&m_common);
  m_common.print = 0;   // errors are exceptions here
  m_common.supernodal = CHOLMOD_SUPERNODAL;
  m_common.final_asis = 1;
  m_common.nmethods = 1;
}

Sparse_cholesky::~Sparse_cholesky()
{
  free_factor();
  cholmod_finish(&m_common);
}

void Sparse_cholesky::free_factor()
{
  if (m_factor != nullptr) cholmod_free_factor(&m_factor, &m_common);
}

void Sparse_cholesky::find_order(cholmod_sparse& matrix)
{
  free_factor();
  if (matrix.nrow >= large) {
    m_common.method[0].ordering = CHOLMOD_METIS;
    m_factor = cholmod_analyze(&matrix, &m_common);   // fails where CHOLMOD was built without METIS
  }
  if (m_factor == nullptr) {
    m_common.method[0].ordering = CHOLMOD_AMD;
    m_factor = cholmod_analyze(&matrix, &m_common);
  }
  if (m_factor == nullptr) throw Numerical_error("a sparse matrix could not be analysed: there is not enough memory");
  const int* const rows = static_cast<const int*>(m_factor->Perm);
  m_order.rows.assign(rows, rows + matrix.nrow);
  m_order.fill = m_common.lnz / m_common.anz;
}

void Sparse_cholesky::analyze(const Matrix& lower)
{
  cholmod_sparse matrix = view_of(lower);
  if (m_order.rows.empty()) return find_order(matrix);
  free_factor();
  m_order.rows = extended(m_order.rows, static_cast<int>(lower.rows()));
  m_common.method[0].ordering = CHOLMOD_GIVEN;
  m_factor = cholmod_analyze_p(&matrix, m_order.rows.data(), nullptr, 0, &m_common);
  if (m_factor == nullptr || m_common.lnz > worn * m_order.fill * m_common.anz) find_order(matrix);
}

bool Sparse_cholesky::factorize(const Matrix& lower)
{
  const One_thread one_thread;
  cholmod_sparse matrix = view_of(lower);
  cholmod_factorize(&matrix, m_factor, &m_common);
  return m_common.status == CHOLMOD_OK && m_factor->minor == m_factor->n;
}

Eigen::MatrixXd Sparse_cholesky::solve(const Eigen::MatrixXd& b) const
{
  const One_thread one_thread;
  Eigen::MatrixXd x(b.rows(), b.cols());
  cholmod_dense right = view_of(const_cast<Eigen::MatrixXd&>(b));   // CHOLMOD does not write to it
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, m_factor, &right, &m_common);
  if (solution == nullptr) throw Numerical_error("a linear system could not be solved: there is not enough memory");
  std::copy_n(static_cast<const double*>(solution->x), b.size(), x.data());
  cholmod_free_dense(&solution, &m_common);
  return x;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // QUARTIC_HAS_CHOLMOD
