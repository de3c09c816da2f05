// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times closest vector problems: random lattices with targets near a lattice vector and anywhere, and lattices of
// periods in the invariant norm. Prints a Markdown table.

#include "measure.h"

#include <CGAL/Quartic_differentials/closest_vector.h>
#include <CGAL/Quartic_differentials/internal/Lattice_basis.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CLI/CLI.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

struct Problem
{
  Eigen::MatrixXd gram;
  Eigen::VectorXd target;
};

double uniform(std::mt19937& random, double a, double b) { return a + (b - a) * (random() / 4294967296.0); }

Eigen::VectorXd random_vector(std::mt19937& random, Eigen::Index n)
{
  Eigen::VectorXd x(n);
  for (double& c : x) c = uniform(random, -1, 1);
  return x;
}

// B^T B of a matrix with entries between -1 and 1
Eigen::MatrixXd random_gram(std::mt19937& random, Eigen::Index n)
{
  Eigen::MatrixXd b(n, n);
  for (Eigen::Index j = 0; j < n; ++j) b.col(j) = random_vector(random, n);
  const Eigen::MatrixXd gram = b.transpose() * b;
  return 0.5 * (gram + gram.transpose());
}

// The shortest vector that a random lattice of this determinant is expected to have (Gaussian heuristic): the radius of
// the ball that is as large as the lattice's cell. Twice the packing radius.
double expected_shortest(const Eigen::MatrixXd& upper)
{
  const double n = static_cast<double>(upper.rows()), pi = 3.14159265358979323846;
  const double log_determinant = upper.diagonal().array().abs().log().sum();
  return std::exp((log_determinant + std::lgamma(n / 2 + 1)) / n) / std::sqrt(pi);
}

// at a tenth of the packing radius from an integer vector with entries up to 20
Eigen::VectorXd near_lattice_target(std::mt19937& random, const Eigen::MatrixXd& gram)
{
  const Eigen::MatrixXd upper = Eigen::LLT<Eigen::MatrixXd>(gram).matrixU();
  const Eigen::VectorXd m = (20 * random_vector(random, gram.rows())).array().round();
  const Eigen::VectorXd away = random_vector(random, gram.rows()).normalized();
  const double distance = 0.1 * expected_shortest(upper) / 2;
  return m + upper.triangularView<Eigen::Upper>().solve(distance * away);
}

Eigen::MatrixXd period_gram(int genus)
{
  Visitor visitor;
  const Riemann_surface s = riemann_surface(Intrinsic_triangulation(handle_chain(genus, 5)), visitor);
  return lattice_gram(Lattice_norm::invariant, {}, s.periods.pi);
}

void measure(const std::string& kind, const std::vector<Problem>& problems, const Closest_vector_options& options)
{
  std::vector<double> reduction, whole, nodes, bound, gaps;
  int optimal = 0;
  for (const Problem& p : problems) {
    reduction.push_back(1e3 * seconds([&] { internal::Lattice_basis lattice(p.gram); }));
    Closest_vectors found;
    whole.push_back(1e3 * seconds([&] { found = closest_vectors(p.gram, p.target, options); }));
    nodes.push_back(static_cast<double>(found.nodes));
    bound.push_back(std::sqrt(found.lower_bound / found.vectors[0].squared_distance));
    optimal += found.optimal;
    if (found.gap) gaps.push_back(*found.gap / std::sqrt(found.vectors[0].squared_distance));
  }
  std::cout << "| " << kind << " | " << problems[0].target.size() << " | " << median(reduction) << " | "
            << std::max(0.0, median(whole) - median(reduction)) << " | " << median(whole) << " | "
            << *std::max_element(whole.begin(), whole.end()) << " | " << median(nodes) << " | " << optimal << " of "
            << problems.size() << " | " << median(bound) << " | ";
  if (gaps.empty()) std::cout << "—";
  else              std::cout << median(gaps) << " (" << gaps.size() << ")";
  std::cout << " |" << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Times closest vector problems: medians over several problems of each kind."};
  int number = 5, most_genus = 12;
  app.add_option("-n,--problems", number, "Number of problems of each kind and dimension (5)")
     ->check(CLI::Range(1, 1000));
  app.add_option("-g,--genus", most_genus, "Largest genus of the surfaces (12)")->check(CLI::Range(0, 50));
  CLI11_PARSE(app, argc, argv);

  std::cout << "| problem | dimension | reduction ms | search ms | whole call ms | slowest ms | nodes | optimal | "
               "bound / distance | gap / distance |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|" << std::endl;
  std::mt19937 random(1);
  const Closest_vector_options one, sixteen{16, 2.0};
  for (int n : {2, 4, 8, 16, 24, 32, 48, 64, 80, 100}) {
    std::vector<Problem> near_lattice, anywhere;
    for (int i = 0; i < number; ++i) {
      const Eigen::MatrixXd gram = random_gram(random, n);
      near_lattice.push_back({gram, near_lattice_target(random, gram)});
      anywhere.push_back({gram, 20 * random_vector(random, n)});
    }
    measure("random lattice, near-lattice target", near_lattice, one);
    if (n <= 48) measure("random lattice, any target", anywhere, one);
  }
  for (int g : {1, 2, 3, 4, 6, 8, 10, 12, 16, 24, 32, 50}) {
    if (g > most_genus) break;
    std::vector<Problem> near_lattice, anywhere;
    const Eigen::MatrixXd gram = period_gram(g);
    for (int i = 0; i < number; ++i) {
      near_lattice.push_back({gram, near_lattice_target(random, gram)});
      anywhere.push_back({gram, 20 * random_vector(random, 2 * g)});
    }
    const std::string name = "periods, genus " + std::to_string(g);
    measure(name + ", near-lattice target", near_lattice, one);
    measure(name + ", any target", anywhere, one);
    measure(name + ", any target, 16 vectors", anywhere, sixteen);
  }
}
