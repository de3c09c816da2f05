// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/verify_flat.h"
#include "verify/verify_flat_obj.h"
#include "verify/verify_quads.h"
#include "verify/verify_t_mesh.h"

#include <CGAL/Quartic_differentials/IO/verify_outputs.h>
#include <CGAL/Quartic_differentials/exceptions.h>

namespace CGAL {
namespace Quartic_differentials {

std::vector<Verification> verify_outputs(const std::string& folder, const Intrinsic_triangulation* input)
{
  using namespace verification;
  Checks checks;
  std::string file;
  try {
    file = "report.json";
    const Report report = read_report(folder);
    file = "flat_intrinsic.json";
    const Flat_facts facts = verify_flat("flat_intrinsic", read_flat(folder, report.is_closed()), report, checks);
    file = "flat.obj";
    const Mesh* mesh = input != nullptr && input->is_embedded() ? &input->mesh() : nullptr;
    if (mesh != nullptr || (facts.is_embedded && has_file(folder, file)))
      verify_flat_obj(folder, facts, report, mesh, checks);
    file = "tmesh.json";
    Ids patch_ids;
    if (report.orders.empty() && report.corner_orders.empty() && !has_file(folder, file)) {
      checks.push_back({true, "tmesh: none, there is no singularity"});
    } else {
      patch_ids = verify_t_mesh(folder, facts, report, checks);
    }
    file = "quads.obj";
    if (report.quads || has_file(folder, file))
      verify_quads(folder, report, patch_ids, mesh, checks);
  }
  catch (const Error& e) { checks.push_back({false, file + ": " + e.what()}); }
  return checks;
}

} } // namespace CGAL::Quartic_differentials
