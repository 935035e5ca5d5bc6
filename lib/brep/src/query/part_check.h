// SPDX-License-Identifier: GPL-3.0-or-later
//
// Check of a part from the result alone: closed, edges on surfaces, no folds.
#pragma once

#include "ncsim/brep/part.h"

#include "geometry/tolerances.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::brep {

/// Defect of a face.
struct Fault {
    std::uint32_t face = 0;
    std::string what;
    std::vector<std::uint32_t> edges{};  ///< Edges at fault, if known: indices into Part::edges.
};

/// Distance below which CAD readers take two points for a single point, mm.
inline constexpr double kReaderClearance = 2.0 * kPointError;

/// Text of the fault for loops that cross or touch.
inline constexpr const char* kCrossOrTouch = "its loops cross or touch";

/// True if a planar face with straight edges at most touches itself, in corners that lie on edges
/// or in each other within `clear_mm`. Polyhedra of pointed tools have these faces where grooves of
/// the same depth cross; CAD readers split the faces there. False for all other faces.
/// Cost: O(n²) for n edges.
bool only_touches_itself(const Part& part, const Face& face, double clear_mm = kReaderClearance);

/// Returns the faults of a face. Edges must lie on the surface within `tolerance_mm`. Loops must
/// neither cross nor come nearer to each other or to themselves than `clear_mm`, and must have the
/// face on the left; on planes, exactly one loop must surround all others. Raises `miss_mm` to the
/// largest distance of an edge from the surface. `area_mm2` is the area of the face, if known,
/// because the measurement of envelopes takes long.
/// Cost: O(n log n) for n evenly distributed edges.
std::vector<Fault> faults_of(const Part& part, std::uint32_t face, double tolerance_mm,
                             double& miss_mm, double clear_mm = kReaderClearance,
                             std::optional<double> area_mm2 = {});

/// Returns the faults of all faces; each edge must be used twice, in opposite directions. Sets
/// part.miss_mm.
std::vector<Fault> check_part(Part& part, double tolerance_mm);

}  // namespace ncsim::brep
