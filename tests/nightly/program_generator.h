// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random NC programs with known motions: the generator writes the text and the motions together.
#pragma once

#include "nightly/nc_writer.h"
#include "nightly/round_tool.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::nightly {

/// Block, or upright round bar inscribed in the block; mm, frame W.
struct StockShape {
    Vec min{}, max{};
    bool is_round = false;
};

struct Program {
    std::uint64_t seed = 0;
    std::string text;
    /// Arguments of `ncsim run`, without the program file.
    std::vector<std::string> arguments;
    StockShape stock;
    std::vector<RoundTool> tools;
    /// Moves that cut. The first move starts at an unknown position and does not cut.
    std::vector<Move> moves;
    /// Points to be checked: the middle of thin walls.
    std::vector<Vec> probes;
    double tolerance_mm = 0.0;       ///< --tolerance
    double tool_tolerance_mm = 0.0;  ///< --tool-tolerance
};

/// Returns the program of `seed`, identical for equal implementations of sine and power.
///
/// Stock from 0.01 mm to 5 m, at the origin or away from the origin; one to three tools of all
/// kinds; straight moves, ramps, plunges, arcs and helices in all planes by centre and by radius,
/// spirals by rounding, full circles and several turns, canned cycles, walls and floors of 1 to 100
/// nm, passes that are repeated, reversed, or meet faces of the stock; tools rotated about A, B and
/// C between moves and in moves; millimetres and inches, absolute and incremental, shifted by G92.
Program random_program(std::uint64_t seed);

/// Returns a program like random_program(), with long tools and mostly rotary moves.
Program random_turning_program(std::uint64_t seed);

}  // namespace ncsim::nightly
