// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks all possible lengths of a tool whose length is unspecified.
#include "unknown_length.h"

#include "ncsim/gcode/state.h"
#include "ncsim/toolpath/tool.h"

#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ncsim::verify {

namespace {

// Largest length of an unspecified holder, mm.
constexpr double kLongestHolder = 60.0;
constexpr double kRounding = 1e-6;  // mm

struct Lengths {
    double least = 0.0, most = 0.0;
};

// Returns the possible lengths (mm) from the spindle nose to the tip.
Lengths possible_lengths(const ToolFacts& facts) {
    double least = facts.certain_flutes.value_or(0.0);
    for (const toolpath::ToolPiece& piece : facts.tool.pieces) {
        if (!piece.assumed && !facts.certain_flutes)
            least = std::max(least, piece.profile.back().height);
    }
    return {least, least + (facts.holder_specified ? 0.0 : kLongestHolder)};
}

double widest_radius(const toolpath::Tool& tool) {
    double radius = 0.0;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        for (const toolpath::ProfilePoint& p : piece.profile)
            radius = std::max(radius, p.radius);
    }
    return radius;
}

bool is_over(const Box& path, double radius, const Box& body) {
    for (int axis = 0; axis < 2; ++axis) {
        if (path.max[axis] + radius <= body.min[axis] || path.min[axis] - radius >= body.max[axis])
            return false;
    }
    return true;
}

// Returns the name of a body under the path that reaches above `height` (mm, W).
std::optional<std::string> body_below_path(const Setup& setup, const Move& move, double radius,
                                           double height) {
    const auto meets = [&](const Box& body) {
        return is_over(move.path, radius, body) && body.max.z > height + kRounding;
    };
    if (setup.stock && meets(*setup.stock)) return "the stock";
    for (const Fixture& fixture : setup.machine.fixtures) {
        if (meets(fixture.place())) return name_of(fixture);
    }
    return std::nullopt;
}

}  // namespace

bool has_unknown_length(const Setup& setup, const Move& move) {
    return setup.uses_length_offsets && move.motion->tool != 0 && !move.tool_length &&
           !move.length_specified && facts_of(setup, move.motion->tool);
}

void doubt_unknown_length(const Setup& setup, const Move& move, FindingLog& log) {
    const gcode::Motion& motion = *move.motion;
    if (!move.is_move || !setup.machine.work_zero || is_turned(motion)) return;
    if (!toolpath::has_known_end(motion) || !has_unknown_length(setup, move)) return;
    const ToolFacts& facts = *facts_of(setup, motion.tool);
    const Lengths lengths = possible_lengths(facts);
    const Place place{motion.file, motion.span};
    const auto doubt = [&](const std::string& what) {
        log.doubt("length-offset",
                  fmt::format("the length of T{} is not specified; between {:.6g} and {:.6g} mm {}",
                              motion.tool, lengths.least, lengths.most, what),
                  place);
    };
    // Heights (mm, W) of the tip, and of the spindle nose, at the ends of the move.
    double highest_tip = -std::numeric_limits<double>::infinity();
    double lowest_nose = std::numeric_limits<double>::infinity();
    const auto take = [&](double z, bool is_nose) {
        if (is_nose) lowest_nose = std::min(lowest_nose, z);
        if (!is_nose) highest_tip = std::max(highest_tip, z);
    };
    take(gcode::end_of(motion)->z.mm(), move.ends_at_nose);
    if (motion.known_start.z) take(gcode::start_of(motion)->z.mm(), move.starts_at_nose);
    const auto& travel = setup.machine.travel[2];
    const bool has_length = move.length_register != gcode::kNoLength;
    if (travel && has_length &&
        highest_tip + setup.machine.work_zero->z + lengths.most > travel->max + kRounding) {
        doubt("Z runs beyond its upper end");
    }
    if (!std::isfinite(lowest_nose)) return;
    const auto body =
        body_below_path(setup, move, widest_radius(facts.tool), lowest_nose - lengths.most);
    if (body) doubt("it meets " + *body + " in machine coordinates");
}

}  // namespace ncsim::verify
