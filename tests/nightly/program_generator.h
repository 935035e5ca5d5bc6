// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random NC programs whose motions are known without reading them: text and motions are built side
// by side.
#pragma once

#include "nightly/nc_writer.h"
#include "nightly/round_tool.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::nightly {

/// A block, or a round bar that stands upright in it. mm, W.
struct StockShape {
    Vec min{}, max{};
    bool is_round = false;
};

struct Program {
    std::uint64_t seed = 0;
    std::string text;
    /// Of `ncsim run`, without the program's name.
    std::vector<std::string> arguments;
    StockShape stock;
    std::vector<RoundTool> tools;
    /// All that cut: the first one, which comes from an unknown place, does not.
    std::vector<Move> moves;
    /// Places worth a look: the middle of thin walls.
    std::vector<Vec> probes;
    double tolerance_mm = 0.0;       ///< --tolerance
    double tool_tolerance_mm = 0.0;  ///< --tool-tolerance
};

/// The same for the same seed, wherever sines and powers are the same.
///
/// Stock from 0.01 mm to 5 m, at the origin or away from it; one to three tools of all kinds;
/// straight moves, ramps, plunges, arcs and helices in all planes by centre and by radius, spirals
/// of rounding, full circles and several turns, canned cycles, walls and floors of 1 to 100 nm,
/// passes that are repeated, reversed, or meet faces of the stock; tools turned about A, B and C
/// between moves and in moves; millimetres and inches, absolute and incremental, shifted by G92.
Program random_program(std::uint64_t seed);

/// The same, but that tools are long and most motions turn them.
Program random_turning_program(std::uint64_t seed);

}  // namespace ncsim::nightly
