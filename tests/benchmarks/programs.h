// SPDX-License-Identifier: GPL-3.0-or-later
//
// NC programs of any length, written as CAM systems write them: what the engine is measured with.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ncsim::bench {

/// wave-N: a raster of N straight moves over crossed sines with a ball nose of 6 mm; step and
/// step-over shrink with N as in real finishing. Block of 100 × 100 × 40 mm.
std::string wave_program(std::size_t moves);

/// pocket-N: trochoidal clearing with a flat end mill of 10 mm, in steps of 0.1 to 0.5 mm, layer by
/// layer; after each layer the block is as long as N asks for.
std::string pocket_program(std::size_t moves);

/// drill-N: a plate with N / 8 holes, each drilled in pecks by G1 and G0 moves along one line.
std::string drill_program(std::size_t moves);

/// contour-N: a wall followed by a tilted flat end mill (A and B turn a little with each of N
/// moves).
std::string contour_program(std::size_t moves);

/// finish-N: a raster with a ball nose of 2 mm over steps with upright walls, N moves.
std::string finish_program(std::size_t moves);

/// passes-N: the same contour, 80 moves around, N times, each deeper by the Nth of 20 mm.
std::string passes_program(std::size_t passes);

/// bores-N: N helical bores of three turns, a flat end mill of 6 mm.
std::string bores_program(std::size_t bores);

/// rotary-N: a raster of N moves around a bar: A turns, the ball nose goes along X.
std::string rotary_program(std::size_t moves);

/// "wave-10000" and so on. Throws std::invalid_argument if there is no such program.
std::string program_named(std::string_view name);

}  // namespace ncsim::bench
