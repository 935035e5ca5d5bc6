// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far two surfaces are from each other.
#pragma once

#include "ncsim/cda/mesh.h"

namespace ncsim::exporter {

/// The farthest, in mm, that a corner or the middle of a triangle of one mesh lies from the other
/// mesh, asked in both directions (the Hausdorff distance, sampled there). Infinite if only one of
/// them is empty. Expected O(n log n).
double deviation(const cda::TriangleMesh& a, const cda::TriangleMesh& b);

}  // namespace ncsim::exporter
