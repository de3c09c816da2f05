// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times CHOLMOD on the Laplacian of a surface, and of its subdivisions, with different orders of elimination, with and
// without dense blocks: by these figures src/Quartic_differentials/internal/Sparse_cholesky.cpp chooses. Prints a Markdown
// table.

#include "measure.h"
#include "subject.h"

#include <CGAL/Quartic_differentials/delaunay_flips.h>

#include <CLI/CLI.hpp>
#include <Eigen/CholmodSupport>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::CholmodDecomposition<Matrix, Eigen::Lower>;

struct Method
{
  const char*        name;
  int                ordering;   // CHOLMOD's number; -1: what CHOLMOD does by itself
  Eigen::CholmodMode mode;
};
const Method methods[] = {{"CHOLMOD's choice of order", -1, Eigen::CholmodSupernodalLLt},
                          {"minimum degree (AMD)", CHOLMOD_AMD, Eigen::CholmodSupernodalLLt},
                          {"minimum degree, no blocks", CHOLMOD_AMD, Eigen::CholmodSimplicialLLt},
                          {"nested dissection (METIS)", CHOLMOD_METIS, Eigen::CholmodSupernodalLLt},
                          {"nested dissection, no blocks", CHOLMOD_METIS, Eigen::CholmodSimplicialLLt}};
const int solves = 10;

// A positive definite matrix of the pattern of the Laplacian, without the row and column of the first vertex.
Matrix graph_laplacian(const Intrinsic_triangulation& t)
{
  const int n = static_cast<int>(t.number_of_vertices()) - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (Edge e : t.edges()) {
    const int i = static_cast<int>(t.source(t.halfedge(e)).idx()) - 1;
    const int j = static_cast<int>(t.target(t.halfedge(e)).idx()) - 1;
    for (int v : {i, j})
      if (v >= 0) entries.emplace_back(v, v, 1);
    if (i >= 0 && j >= 0) entries.emplace_back(std::max(i, j), std::min(i, j), -1);
  }
  Matrix m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

void measure(const Subject& subject)
{
  Intrinsic_triangulation t = subject.load();
  make_delaunay(t);
  const Matrix matrix = graph_laplacian(t);
  for (const Method& method : methods) {
    Solver solver;
    solver.setMode(method.mode);
    if (method.ordering >= 0) {
      solver.cholmod().nmethods = 1;
      solver.cholmod().method[0].ordering = method.ordering;
    }
    const double analysis = cpu_seconds([&] { solver.analyzePattern(matrix); });
    const double factorization = cpu_seconds([&] { solver.factorize(matrix); });
    if (solver.info() != Eigen::Success) throw Error("the matrix could not be factorised");
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(matrix.rows());
    const double seconds = cpu_seconds([&] { for (int k = 0; k < solves; ++k) solver.solve(b).eval(); });
    const cholmod_common& counts = solver.cholmod();
    std::cout << "| " << subject.name << " | " << t.number_of_vertices() << " | " << method.name << " | " << cell(analysis)
              << " | " << cell(factorization) << " | " << cell(1000 * seconds / solves) << " | "
              << cell(counts.lnz / 1e6) << " | " << cell(counts.fl / counts.lnz) << " |" << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Times CHOLMOD with different orders of elimination, with and without dense blocks, in seconds of the "
               "processor."};
  std::vector<std::string> meshes;
  int subdivisions = 2;
  app.add_option("MESH", meshes, "Closed meshes; none: two generated surfaces");
  app.add_option("--subdivide", subdivisions, "Also on its subdivisions, up to this one (2)")->check(CLI::Range(0, 4));
  CLI11_PARSE(app, argc, argv);

  std::vector<Subject> subjects;
  for (const std::string& path : meshes) subjects.push_back(from_file(path));
  if (subjects.empty()) subjects = {chain(4, 11), chain(4, 25)};
  std::cout << "| surface | V | method | analysis, CPU s | factorisation | one back-substitution, ms | nonzeros, millions | "
               "operations a nonzero |\n|---|---:|---|---:|---:|---:|---:|---:|" << std::endl;
  bool all_well = true;
  for (const Subject& subject : subjects)
    for (int k = 0; k <= subdivisions; ++k)
      all_well = in_own_process(subject.name, [&] { measure(k == 0 ? subject : finer(subject, k)); }) && all_well;
  return all_well ? EXIT_SUCCESS : EXIT_FAILURE;
}
