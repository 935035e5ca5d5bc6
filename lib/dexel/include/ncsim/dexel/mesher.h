// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a surface is put between the ends of rays.
#pragma once

#include <cstdint>

namespace ncsim::dexel {

enum class Mesher : std::uint8_t {
    DualContouring,  ///< Edges stay sharp.
    MarchingCubes,   ///< As the thesis has it (2.2), to compare with.
};

}  // namespace ncsim::dexel
