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

// From this size on, nested dissection (METIS) pays: a factorisation then takes three fifths of the time, and finding the
// order as long as three of them. Below, minimum degree (AMD) is better for the four factorisations of a run.
// (benchmark_orders; METHOD, "Factorisations")
const std::size_t large = 300000;
// A matrix of fewer rows and fewer operations for a nonzero of its factor gets no dense blocks (supernodes): it is
// factorised about as fast without, and a back-substitution takes half to two thirds of the time. (benchmark_orders)
const std::size_t small = 30000;
const double      sparse = 120;
const double      worn = 1.5;   // an order is found anew when the fill has grown by this factor

// A number that a library keeps to itself, set to another value for as long as the object lives; nothing happens where the
// library is not loaded.
class Setting
{
public:
  Setting(const char* get, const char* set, int value) : m_set(function<void (*)(int)>(set))
  {
    const auto current = function<int (*)()>(get);
    if (current == nullptr) m_set = nullptr;
    if (m_set == nullptr) return;
    m_old = current();
    m_set(value);
  }
  ~Setting()
  {
    if (m_set != nullptr) m_set(m_old);
  }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

private:
  template <class Function>
  static Function function(const char* name) { return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name)); }

  void (*m_set)(int);
  int  m_old = 0;
};

// Keeps CHOLMOD and the BLAS to one thread. CHOLMOD 3 asks OpenMP for four, whatever the machine has, and they wait for each
// other most of the time: twice the CPU time, and results that depend on the number of cores.
struct One_thread
{
  Setting openmp{"omp_get_max_active_levels", "omp_set_max_active_levels", 0};   // no level of parallel regions
  Setting blas{"openblas_get_num_threads", "openblas_set_num_threads", 1};
};

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

cholmod_dense view_of(const Eigen::Ref<const Eigen::MatrixXd>& m)
{
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(m.rows());
  view.ncol = static_cast<std::size_t>(m.cols());
  view.d = static_cast<std::size_t>(m.outerStride());
  view.nzmax = view.d * view.ncol;
  view.x = const_cast<double*>(m.data());   // CHOLMOD does not write to it
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
  m_common.supernodal_switch = sparse;
  m_common.final_ll = 1;   // without blocks too it is LL' that is computed, which tells whether the matrix is positive
  m_common.final_asis = 1;
  m_common.nmethods = 1;
}

Sparse_cholesky::~Sparse_cholesky()
{
  free_factor();
  for (cholmod_dense** memory : {&m_solution, &m_workspace[0], &m_workspace[1]}) cholmod_free_dense(memory, &m_common);
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
  m_common.supernodal = matrix.nrow < small ? CHOLMOD_AUTO : CHOLMOD_SUPERNODAL;
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

Eigen::MatrixXd Sparse_cholesky::solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const
{
  const One_thread one_thread;
  cholmod_dense right = view_of(b);
  if (!cholmod_solve2(CHOLMOD_A, m_factor, &right, nullptr, &m_solution, nullptr, &m_workspace[0], &m_workspace[1],
                      &m_common))
    throw Numerical_error("a linear system could not be solved: there is not enough memory");
  return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(m_solution->x), b.rows(), b.cols());
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // QUARTIC_HAS_CHOLMOD
