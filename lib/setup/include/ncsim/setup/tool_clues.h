// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the moves of a tool that nobody describes tell of it: enough for a first picture, never for
// a verdict.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/machine.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace ncsim::setup {

class ToolClues {
public:
    /// Takes a feed move whose start is known; `poses`: its own.
    void take(const gcode::Motion& motion, const toolpath::Poses& poses);

    /// As --assume-tool reads it: "flat:D6", "ball:D1/8in". Moves that only go down are those of a
    /// drill; many that rise while they go aside, of a ball; short ones of little depth, of an
    /// engraver. No wider than the tightest arc in the plane, than a few steps from line to line,
    /// than the shortest way from hole to hole of a drill, and than a quarter of what it covers; a
    /// size that is sold, in the unit of the program.
    std::string guess(bool inches) const;

private:
    static constexpr std::size_t kMostLines = 4096;

    double width_mm() const;
    double step_mm() const;
    double hole_spacing_mm() const;

    cda::Box tips_;
    std::size_t moves_ = 0, falling_ = 0, slanting_ = 0;
    double length_mm_ = 0.0;
    double smallest_arc_mm_ = std::numeric_limits<double>::infinity();
    std::array<std::set<std::int64_t>, 2> lines_;            // along X and Y: where, µm
    std::set<std::pair<std::int64_t, std::int64_t>> holes_;  // places of moves straight down, µm
};

}  // namespace ncsim::setup
