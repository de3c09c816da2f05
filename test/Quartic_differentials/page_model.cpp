// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Large surfaces are shown by regular grids on their patches: the points are where the map of the whole surface to the
// patches has them.

#include "check.h"
#include "run_pipeline.h"
#include "typed_arrays.h"

#include "page_model.h"

#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace QD = CGAL::Quartic_differentials;

using Quartic_test::Point;
using Quartic_test::doubled_area;

// A surface on the page.
struct Shown
{
  explicit Shown(const nlohmann::json& surface)
    : points(Quartic_test::points(Quartic_test::floats(surface["points"]))),
      point(Quartic_test::indices(surface["corner"]["point"])),
      patch(Quartic_test::indices(surface["corner"]["patch"])),
      triangles(Quartic_test::indices(surface["triangles"])), uv(Quartic_test::floats(surface["corner"]["uv"])) {}

  std::vector<Point>         points;
  std::vector<std::uint32_t> point, patch, triangles;
  std::vector<float>         uv;
};

// how far the point at a place in a patch is from where the triangle that holds the place has it; infinite if none does
double distance(const Shown& whole, std::uint32_t patch, std::array<float, 2> z, const Point& p)
{
  double least = INFINITY;
  for (std::size_t t = 0; t < whole.triangles.size(); t += 3) {
    const std::array<std::uint32_t, 3> corner{whole.triangles[t], whole.triangles[t + 1], whole.triangles[t + 2]};
    if (whole.patch[corner[0]] != patch) continue;
    std::vector<float> uv{z[0], z[1]};
    for (std::uint32_t c : corner) uv.insert(uv.end(), {whole.uv[2 * c], whole.uv[2 * c + 1]});
    const double area = doubled_area(uv, 1, 2, 3);
    const std::array<double, 3> weight{doubled_area(uv, 0, 2, 3) / area, doubled_area(uv, 0, 3, 1) / area,
                                       doubled_area(uv, 0, 1, 2) / area};
    if (area <= 0 || *std::min_element(weight.begin(), weight.end()) < -1e-3) continue;
    double squares = 0;
    for (int k = 0; k < 3; ++k) {
      double x = -p[k];
      for (int i = 0; i < 3; ++i) x += weight[i] * whole.points[whole.point[corner[i]]][k];
      squares += x * x;
    }
    least = std::min(least, std::sqrt(squares));
  }
  return least;
}

int main()
{
  const QD::Intrinsic_triangulation input(QD::handle_chain(2, 6));
  const QD::Quartic_differential_result result = Quartic_test::run_pipeline(input);
  const nlohmann::json all = page_model(input, result), some = page_model(input, result, 1000);
  CHECK(!all["surface"].contains("reduced_from"));
  CHECK(some["surface"]["reduced_from"] == result.refined->differential.triangulation.number_of_faces());
  CHECK(Quartic_test::indices(some["surface"]["edges"]).empty());
  CHECK(some["tmesh"] == all["tmesh"]);
  const Shown whole(all["surface"]), grids(some["surface"]);
  CHECK(grids.triangles.size() > 3 * 500 && grids.triangles.size() < 3 * 2000);
  CHECK(grids.triangles.size() < whole.triangles.size());

  std::vector<double> area(some["tmesh"]["patches"].size(), 0.0);
  for (std::size_t t = 0; t < grids.triangles.size(); t += 3) {
    const double a = doubled_area(grids.uv, grids.triangles[t], grids.triangles[t + 1], grids.triangles[t + 2]) / 2;
    CHECK(a > 0);
    area[grids.patch[grids.triangles[t]]] += a;
  }
  for (std::size_t p = 0; p < area.size(); ++p) {
    const nlohmann::json& patch = some["tmesh"]["patches"][p];
    CHECK_NEAR(area[p] / (patch["width"].get<double>() * patch["height"].get<double>()), 1, 1e-3);   // floats
  }
  const double size = std::sqrt(input.area());
  for (std::uint32_t c = 0; c < grids.point.size(); ++c)
    CHECK(distance(whole, grids.patch[c], {grids.uv[2 * c], grids.uv[2 * c + 1]}, grids.points[grids.point[c]])
          < 1e-3 * size);
  return Quartic_test::result();
}
