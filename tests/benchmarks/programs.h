// SPDX-License-Identifier: GPL-3.0-or-later
//
// NC programs of any length in the style of CAM systems, for measurements of the engine.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ncsim::bench {

/// Returns wave-N: a raster of N straight moves over crossed sines with a ball nose of 6 mm. Step
/// and step-over shrink with N, as in real finishing. The block is 100 × 100 × 40 mm.
std::string wave_program(std::size_t moves);

/// Returns pocket-N: trochoidal clearing in N moves of about 0.3 mm, with a flat end mill of 10 mm,
/// in layers of 2 mm.
std::string pocket_program(std::size_t moves);

/// Returns drill-N: a plate with N / 8 holes, each drilled in pecks by G1 and G0 moves along a
/// line.
std::string drill_program(std::size_t moves);

/// Returns contour-N: a tilted flat end mill follows a wall. A and B change a little in each of N
/// moves.
std::string contour_program(std::size_t moves);

/// Returns finish-N: a raster of N moves with a ball nose of 2 mm over steps with vertical walls.
std::string finish_program(std::size_t moves);

/// Returns passes-N: the same contour of 80 moves, N times, each pass deeper by 20 mm / N.
std::string passes_program(std::size_t passes);

/// Returns bores-N: N helical bores of three turns, with a flat end mill of 6 mm.
std::string bores_program(std::size_t bores);

/// Returns rotary-N: a raster of N moves around a bar. A rotates, and the ball nose moves along X.
std::string rotary_program(std::size_t moves);

/// Returns the program of a name like "wave-10000".
/// Throws: std::invalid_argument if there is no program of that name.
std::string program_named(std::string_view name);

}  // namespace ncsim::bench
