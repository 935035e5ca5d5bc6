// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimate of an undescribed tool from its moves: sufficient for a first picture, never for a
// verdict.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/kinematics.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace ncsim::setup {

/// Statistics of a tool's feed moves.
class ToolClues {
public:
    /// Adds a feed move. Requires: the start of `motion` is known; `poses` belongs to `motion`.
    void take(const gcode::Motion& motion, const toolpath::Poses& poses);

    /// Returns an estimate in the form of --assume-tool: "flat:D6", "ball:D1/8in". Only vertical
    /// moves suggest a drill; many sloping moves a ball end mill; many short moves of little depth
    /// an engraver. The diameter is the largest standard size, in the unit of the program, that is
    /// at most
    /// - twice the radius of the tightest arc in the plane,
    /// - a few steps from line to line,
    /// - the least distance of two holes, for a drill,
    /// - a quarter of the width of the moves' area.
    std::string guess(bool inches) const;

private:
    static constexpr std::size_t kMostLines = 4096;

    double width_mm() const;
    double step_mm() const;
    double hole_spacing_mm() const;

    Box tips_;
    std::size_t moves_ = 0, falling_ = 0, slanting_ = 0;
    double length_mm_ = 0.0;
    double smallest_arc_mm_ = std::numeric_limits<double>::infinity();
    std::array<std::set<std::int64_t>, 2> lines_;            // positions along X and Y, µm
    std::set<std::pair<std::int64_t, std::int64_t>> holes_;  // positions of moves straight down, µm
};

}  // namespace ncsim::setup
