// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules wrong-length-offset and no-length-offset: the control must have the true length of the
// tool. With length L and offset h, the tip is h - L above the programmed position.
#include "ncsim/gcode/state.h"

#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ncsim::verify {

namespace {

constexpr double kSame = 1e-6;  // mm: rounding of decimal fractions and inches

void add_length_finding(const Setup& setup, const Move& move, FindingLog& log,
                        std::string_view rule, std::string message, std::optional<double> off) {
    Occurrence s{std::move(message)};
    if (off) s.quantity = Quantity{"tip off by", *off, "mm"};
    s.lasts = true;
    s.box = move.path;
    if (move.motion->offset_unknown) s.rests_on = guesses_of(setup, move);
    log.add(rule, move, std::move(s));
}

void judge_none(const Setup& setup, const Move& move, FindingLog& log) {
    const int tool = move.motion->tool;
    const Place place{move.motion->file, move.motion->span};
    if (move.tool_length && std::abs(*move.tool_length) <= kSame) return;
    if (setup.uses_length_offsets) {
        add_length_finding(
            setup, move, log, "no-length-offset",
            fmt::format("T{} moves without a tool length offset (G43), which the program uses "
                        "elsewhere",
                        tool),
            move.tool_length);
    } else if (setup.cutting_tools.size() > 1) {
        // Some controls, and some operators, set the length at each tool change.
        log.doubt(
            "length-offset",
            "several tools cut, and the program has no G43: their lengths have to be set at the "
            "control",
            place);
    }
}

void judge_register(const Setup& setup, const Move& move, FindingLog& log) {
    const int tool = move.motion->tool;
    const int h = move.length_register;
    const Place place{move.motion->file, move.motion->span};
    if (move.tool_length && move.length_specified) {
        const double off = move.length_offset - *move.tool_length;
        if (std::abs(off) <= kSame) return;
        add_length_finding(
            setup, move, log, "wrong-length-offset",
            h > 0 && h != tool
                ? fmt::format("T{} moves with the length of H{}, which is another", tool, h)
                : fmt::format("T{} moves with a length that is not its own", tool),
            std::abs(off));
        return;
    }
    if (h == tool || h == gcode::kStatedLength) return;
    if (h == gcode::kNegatedLength) {
        log.doubt("length-offset", "G44 subtracts the length of the tool, which is not specified",
                  place);
    } else if (setup.tools.contains(h) || setup.cutting_tools.contains(h) || move.tool_length) {
        add_length_finding(setup, move, log, "wrong-length-offset",
                           fmt::format("T{} moves with the length of T{} (H{})", tool, h, h),
                           std::nullopt);
    } else {
        log.doubt("length-offset",
                  fmt::format("T{} moves with H{}, a length of no known tool", tool, h), place);
    }
}

}  // namespace

void judge_length_offset(const Setup& setup, const Move& move, FindingLog& log) {
    if (!move.is_move || !move.needs_length) return;
    if (move.motion->tool == 0) {
        // A program that selects a length register runs on a machine with a tool table, whose
        // spindle may still hold the last tool.
        if (move.length_register > 0 && move.motion->kind != gcode::MoveKind::Rapid) {
            log.doubt("tool-guess",
                      fmt::format("H{} holds, and no M6 has loaded a tool: the tool in the spindle "
                                  "is not specified",
                                  move.length_register),
                      {move.motion->file, move.motion->span});
        }
        return;
    }
    if (move.length_register == gcode::kNoLength) {
        judge_none(setup, move, log);
    } else {
        log.end_row("no-length-offset");
        judge_register(setup, move, log);
    }
}

}  // namespace ncsim::verify
