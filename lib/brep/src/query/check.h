// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is it what it says: closed, on its surfaces, without folds? Asked as a stranger would, of the
// result alone.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::brep {

/// What is wrong with it.
struct Fault {
    std::uint32_t face = 0;
    std::string what;
    std::vector<std::uint32_t> edges{};  ///< Where, if that can be told: indices into Part::edges.
};

/// Nearer than this, readers take two points for one, mm.
inline constexpr double kClear = 2e-6;

/// What is said of loops that do.
inline constexpr const char* kCrossOrTouch = "its loops cross or touch";

/// Of a flat face with straight edges alone: does it do no more than touch itself, in corners that
/// lie on edges or in each other within `clear_mm`? Polyhedra of tools that come to a point do,
/// where grooves of one depth cross: readers part such faces there. O(n²) for n edges.
bool only_touches_itself(const Part& part, const Face& face, double clear_mm = kClear);

/// Of edges on the surface of the face within `tolerance_mm`; of loops that neither cross nor come
/// nearer to themselves or each other than `clear_mm`, go round the face on the side where it is,
/// and one of them around all others on planes. Also what the edges miss: `miss_mm` is raised to
/// it. O(n log n) for n edges that are spread evenly. Who has measured the face tells its area,
/// which takes long of envelopes.
std::vector<Fault> faults_of(const Part& part, std::uint32_t face, double tolerance_mm,
                             double& miss_mm, double clear_mm = kClear,
                             std::optional<double> area_mm2 = {});

/// Of all faces; and each edge is used twice, in opposite directions. Sets part.miss_mm.
std::vector<Fault> check(Part& part, double tolerance_mm);

}  // namespace ncsim::brep
