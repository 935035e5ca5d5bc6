// SPDX-License-Identifier: GPL-3.0-or-later
//
// Algorithms that build a surface between the ends of rays.
#pragma once

#include <cstdint>

namespace ncsim::dexel {

/// Algorithm of Dexel::boundary().
enum class Mesher : std::uint8_t {
    DualContouring,  ///< Edges stay sharp.
    MarchingCubes,   ///< As in the thesis (2.2), for comparison.
};

}  // namespace ncsim::dexel
