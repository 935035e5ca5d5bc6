// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds unspecified values on which a verdict would rest.
#include "guesses.h"

#include "ncsim/toolpath/trace.h"

#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace ncsim::verify {

void doubt_guesses_of_move(const Setup& setup, const Move& move, bool is_watched, bool needs_part,
                           FindingLog& log) {
    const gcode::Motion& m = *move.motion;
    const Place place{m.file, m.span};
    if (move.passes_above) return;
    if (!toolpath::has_known_start(m)) {
        log.doubt("start-unknown", "the start of the move is unknown", place);
    } else if (m.start_assumed) {
        log.doubt("start-unknown",
                  "the program continues by increments from an unknown position; taken as 0",
                  place);
    }
    if (m.offset_unknown) {
        log.doubt("offset-guess",
                  "the place of a coordinate system is not specified; its zero was taken to be "
                  "that of the system before it",
                  place);
    } else if (m.machine_coordinates && !setup.home_assumption.empty()) {
        log.doubt("offset-guess",
                  "a move goes to a place of the machine (G28, G30, G53), and where the "
                  "workpiece lies in it is not specified",
                  place);
    }
    if (!needs_part) return;
    if (!is_watched && !setup.not_simulated && (m.tool != 0 || toolpath::has_known_start(m))) {
        log.doubt("not-simulated",
                  m.tool == 0 ? "moves before the first tool change were not simulated"
                              : fmt::format("T{} moves and is not described", m.tool),
                  place);
    }
    if (!setup.kinematics && is_turned(m)) {
        log.doubt("kinematics-guess",
                  "rotary axes turn; taken to turn the tool about the program zero (ISO 841)",
                  place);
    } else if (std::string guess = kinematics_guess(setup, move); !guess.empty()) {
        log.doubt("kinematics-guess", "rotary axes turn; taken: " + guess, place);
    }
    if (move.after_probe && is_watched)
        log.doubt("probe-guess", "moves after a probe stand on what it met", place);
}

namespace {

double widest_radius(const toolpath::Tool& tool) {
    double widest = 0.0;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        for (const toolpath::ProfilePoint& p : piece.profile)
            widest = std::max(widest, p.radius);
    }
    return widest;
}

}  // namespace

void doubt_blend(const Setup& setup, const Move& move, FindingLog& log) {
    if (setup.blend_mm <= 0.0 || move.path.is_empty() || move.motion->machine_coordinates) return;
    const auto tool = setup.tools.find(move.motion->tool);
    const double radius = tool == setup.tools.end() ? 0.0 : widest_radius(tool->second.tool);
    const double reach = setup.blend_mm + radius;
    Box near = move.path;
    near.min = near.min - Vec3{reach, reach, setup.blend_mm};
    near.max = near.max + Vec3{reach, reach, setup.blend_mm};
    for (const Fixture& fixture : setup.machine.fixtures) {
        const Box box = fixture.place();
        const bool is_near = near.min.x < box.max.x && near.max.x > box.min.x &&
                             near.min.y < box.max.y && near.max.y > box.min.y &&
                             near.min.z < box.max.z;
        if (!is_near) continue;
        log.doubt(
            "path-blending",
            fmt::format("the control may miss corners by {:.6g} mm (G64 P), and '{}' is nearer",
                        setup.blend_mm, fixture.name),
            {move.motion->file, move.motion->span});
    }
}

void doubt_guesses_of_setup(const Setup& setup, const std::map<int, ToolMonitors>& tools,
                            bool needs_part, FindingLog& log) {
    if (!setup.units_assumption.empty())
        log.doubt("units-guess", "units: " + setup.units_assumption);
    if (needs_part && setup.not_simulated)
        log.doubt("not-simulated", "the program was not simulated: " + *setup.not_simulated);
    if (!needs_part || setup.not_simulated) return;
    if (setup.setting_askew > 0.0) {
        log.doubt("kinematics-guess",
                  fmt::format("the part is turned by {:.6g} degrees on the table, which G54.4 "
                              "corrects; the axes were taken to be where they are with a straight "
                              "part, and so were moves without G54.4",
                              setup.setting_askew));
    }
    if (!setup.stock_assumption.empty())
        log.doubt("stock-guess", "stock: " + setup.stock_assumption);
    for (const auto& [number, facts] : setup.tools) {
        if (facts.is_guess) {
            log.doubt("tool-guess", fmt::format("T{}: {}", number, facts.assumption));
        }
    }
    for (const auto& [number, watched] : tools) {
        if (watched.uncertain_mm <= 0.0) continue;
        const double specified = facts_of(setup, number)->certain_flutes.value_or(0.0);
        log.doubt("flutes-guess",
                  fmt::format("T{} would have to cut {:.6g} mm high, and its flutes are "
                              "not known to be longer than {:.6g} mm",
                              number, specified + watched.uncertain_mm, specified),
                  watched.uncertain_place);
    }
}

}  // namespace ncsim::verify
