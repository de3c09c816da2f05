// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_PAGE_MODEL_H
#define QUARTIC_PAGE_MODEL_H

#include "report.h"

#include <cstddef>

/// What `report.html` draws, as it is embedded there; parts that were not reached are missing. Numbers of many are
/// `{"type": "Float32Array", "length": n, "base64": ...}`, little-endian, which JavaScript takes as they are.
///
/// - `surface`, if the input is embedded: `points` (3 floats); `triangles` of `corner`s {`point`, `uv`, `patch`}: the
///   input, cut along the arcs of the T-mesh if there is one, with the place in the patch [0, width] x [0, height] in
///   units of `flat.obj`; without a T-mesh, in the charts; `uv` and `patch` are missing where there are none. `edges`
///   of the input and pieces of `arcs`, as pairs of points. `reduced_from`: the number of triangles, if every patch is
///   shown by a regular grid instead; `edges` is empty then.
/// - `tmesh`: `order` by node, null where there is no singularity; `arcs` [from, to, length]; `patches` {`width`,
///   `height`, `sides` as in `tmesh.json`, `pattern`}: [k, x, y], so that i^k z + x + iy takes z in the patch to a
///   plane where patches lie side by side along the longest arcs; a pattern there runs on across those.
/// - `loops` {`name`, `kind`, `points`}; `quads` {`points`, `quads`, `patch`};
/// - `histograms`: {`from`, `to`, `share` of the area by bin} of `log_conformal_distortion` and `log_area_scale`, 0 on
///   average.
/// \param most_triangles if there are more, patches are shown by regular grids of about this number
/// Complexity: that of `patch_mesh()`.
Json page_model(const CGAL::Quartic_differentials::Intrinsic_triangulation& input,
                const CGAL::Quartic_differentials::Quartic_differential_result& result,
                std::size_t most_triangles = 150000);

#endif // QUARTIC_PAGE_MODEL_H
