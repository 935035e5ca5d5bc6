// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves of cycles that mill along a contour: the way to the contour, the contour with cutter
// compensation, the way back, level by level.
#include "ncsim/base/angles.h"

#include "language/block_control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::language {
namespace {

/// Returns the unit direction of `move` at its start or end.
Vec2 direction_at(const OutlineMove& move, bool at_end) {
    Vec2 ahead{move.to.x - move.from.x, move.to.y - move.from.y};
    if (move.turns != 0) {
        const Vec2 at = at_end ? move.to : move.from;
        const double turn = move.turns > 0 ? 1.0 : -1.0;
        ahead = {-turn * (at.y - move.centre.y), turn * (at.x - move.centre.x)};
    }
    const double length = hypotenuse(ahead.x, ahead.y);
    return length > 0.0 ? Vec2{ahead.x / length, ahead.y / length} : Vec2{1.0, 0.0};
}

Vec2 moved(Vec2 from, Vec2 along, double distance) {
    return {from.x + distance * along.x, from.y + distance * along.y};
}

/// Returns the point at the distance `offset` aside of the start or the end of `move`.
Vec2 point_aside(const OutlineMove& move, bool at_end, CutterSide side, double offset) {
    if (side == CutterSide::Off) return at_end ? move.to : move.from;
    const Vec2 ahead = direction_at(move, at_end);
    const double sign = side == CutterSide::Left ? 1.0 : -1.0;
    return moved(at_end ? move.to : move.from, {-ahead.y, ahead.x}, sign * offset);
}

/// Returns the move from the free end of `lead` to the tangent at `at`, or from `at` to the free
/// end. The tool is on `side`.
OutlineMove move_of(const Lead& lead, Vec2 at, Vec2 ahead, CutterSide side, bool is_way_out) {
    OutlineMove move{at, at, {}, 0};
    Vec2& free_end = is_way_out ? move.to : move.from;
    const double back = is_way_out ? 1.0 : -1.0;
    if (lead.form == Lead::Form::None) return move;
    if (lead.form == Lead::Form::Line) {
        free_end = moved(at, ahead, back * lead.size);
        return move;
    }
    // The arc is on the side of the tool: the tool never comes nearer to the contour.
    const double sign = side == CutterSide::Right ? -1.0 : 1.0;
    const Vec2 away{-sign * ahead.y, sign * ahead.x};
    move.centre = moved(at, away, lead.size);
    move.turns = sign > 0.0 ? 1 : -1;
    free_end = lead.form == Lead::Form::Semicircle ? moved(at, away, 2.0 * lead.size)
                                                   : moved(move.centre, ahead, back * lead.size);
    return move;
}

}  // namespace

/// Follows `contour` at the height `level`, from the point aside of its start.
bool BlockControl::follow_contour(const ContourPath& m, const Pass& contour, CutterSide side,
                                  double level) {
    const auto follow = [&](const OutlineMove& move) { return cut(move, level, m.feed); };
    if (side == CutterSide::Off || m.offset == 0.0) return std::ranges::all_of(contour, follow);
    const PlaneAxes axes = axes_of(plane_);
    at_[axes.first] = contour.front().from.x;
    at_[axes.second] = contour.front().from.y;
    const bool is_left = (side == CutterSide::Left) != m.is_mirrored;
    machine_.begin_compensation_at(is_left ? CutterSide::Left : CutterSide::Right, m.offset, at_);
    bool done = std::ranges::all_of(contour, follow);
    Command command = make(cycle_span_);
    put(command, Code::G40);
    done = done && run(command);
    refresh();
    // The way back may be an arc.
    machine_.state().uncancelled = {};
    machine_.state().just_left_compensation = false;
    return done;
}

bool BlockControl::mill_along(const ContourPath& m, std::string_view name) {
    if (m.contour.empty())
        return fail(Message::BlockNeeds, cycle_span_, {name, "a contour of lines and arcs"});
    const double count = m.infeed > 0.0 ? (m.surface - m.bottom) / m.infeed + 1.0 : 1.0;
    if (!(count * static_cast<double>(m.contour.size()) < kMostPasses))
        return fail(Message::CycleRepeats, cycle_span_);
    Pass contour = m.contour;
    CutterSide side = m.side;
    double above = m.surface;
    bool is_first = true;
    for (const double level : levels_of(m.surface, m.bottom, m.infeed, m.has_equal_infeeds)) {
        const Vec2 begin = point_aside(contour.front(), false, side, m.offset);
        const OutlineMove in =
            move_of(m.in, begin, direction_at(contour.front(), false), side, false);
        if (!move_in_plane(in.from, is_first ? std::nullopt : m.transfer_feed) ||
            (is_first && !move_to(m.clear, std::nullopt)) ||
            !move_to(m.in.in_space ? above : level, m.plunge_feed))
            return false;
        if (m.in.form != Lead::Form::None && !cut(in, level, m.feed)) return false;
        if (!follow_contour(m, contour, side, level)) return false;
        const double lift = m.lift_to.value_or(level + m.lift_by);
        const OutlineMove out =
            move_of(m.out, point_in_plane(), direction_at(contour.back(), true), side, true);
        if (m.out.form != Lead::Form::None &&
            !cut(out, m.out.in_space ? std::min(m.clear, above) : level, m.feed))
            return false;
        if (!m.is_alternating && !move_to(lift, std::nullopt)) return false;
        if (m.is_alternating) {
            reverse(contour);
            if (side != CutterSide::Off)
                side = side == CutterSide::Left ? CutterSide::Right : CutterSide::Left;
        }
        above = level;
        is_first = false;
    }
    return true;
}

}  // namespace ncsim::gcode::language
