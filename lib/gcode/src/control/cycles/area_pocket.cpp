// SPDX-License-Identifier: GPL-3.0-or-later
//
// G150 of Haas: a pocket of any shape. The outline is in a subprogram that is not executed but
// recorded: a line from the starting hole to the outline, then once around the outline.
#include "ncsim/base/angles.h"

#include "control/cycles/area.h"
#include "control/machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ncsim::gcode {
namespace {

/// Limits above any real program; a larger value is a wrong word.
constexpr double kMostStrokes = 100'000.0;  // Strokes at all levels.
constexpr double kMostWork = 1e9;           // Strokes × sides of the outline.

/// Chord tolerance of the outline's arcs, mm.
constexpr double kChord = 0.001;

/// Largest distance between the ends of a closed outline, mm.
constexpr double kMaxClosingGap = 0.005;

}  // namespace

/// Starts recording moves instead of making moves, at X and Y of the G150 block.
bool Machine::begin_contour(const Command& command) {
    if (control_.corner) settle_corner();
    Axes start{};
    AxisMask mask = 0;
    if (!find_ends(command, start, mask)) return false;
    outline_ = Outline{control_, {}, false};
    state_.position[kX] = start[kX];
    state_.position[kY] = start[kY];
    state_.motion = Code::G1;
    state_.cycle = {};
    state_.feed_mode = FeedMode::PerMinute;
    // Satisfies the feed check of the outline; the feed of the G150 block counts.
    state_.feed = std::max(state_.feed, 1.0);
    return true;
}

/// Keeps the recorded moves for the G150 block and restores the control.
void Machine::end_outline() {
    if (control_.corner) settle_corner();
    restore(outline_->before);
    contour_ = std::move(outline_->moves);
    is_outline_valid_ = !outline_->is_foreign;
    outline_.reset();
}

bool Machine::belongs_to_outline(const Command& command) {
    const Code motion = command.group(Group::Motion);
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        const bool may =
            group == Group::Motion || group == Group::Distance || group == Group::Ignored;
        if (!may && command.group(group) != Code::None) return false;
    }
    return (motion == Code::None || motion == Code::G1 || motion == Code::G2 ||
            motion == Code::G3) &&
           command.group(MGroup::Stop) == kNone && command.group(MGroup::ToolChange) == kNone;
}

/// Records a move of the outline: a line to `end`, or the arc `arc`.
bool Machine::record_outline_move(const Axes& end, const ProgramArc* arc) {
    const Axes& from = state_.position;
    OutlineMove move;
    move.from = {from[kX], from[kY]};
    move.to = {end[kX], end[kY]};
    if (arc) move.centre = {arc->centre_1, arc->centre_2}, move.turns = arc->turns;
    for (std::size_t i = 0; i < end.size(); ++i)
        outline_->is_foreign |= i != kX && i != kY && end[i] != from[i];
    outline_->is_foreign |= state_.plane != Plane::XY || std::abs(move.turns) > 1;
    const bool moves = arc || move.from.x != move.to.x || move.from.y != move.to.y;
    if (moves) outline_->moves.push_back(move);
    state_.position = end;
    return true;
}

/// Mills the pocket. At each level: down at the starting hole; strokes along Y (I) or X (J) over
/// the area whose distance from the outline is at least the cutter radius plus the finishing
/// allowance; once around this area. At the last level, once more around the outline on size.
/// Between strokes without a straight connection inside the area the tool retracts to R. The Haas
/// manual gives the order and the words but not the strokes; the choice of strokes does not change
/// the material left.
bool Machine::area_pocket(const Command& command, Code side, bool words_taken) {
    const SourceSpan span = span_of_g(command, Code::G150);
    const auto needs = [&](std::string_view what) {
        return fail(Message::PocketWord, span, {"G150", what});
    };
    if (compensation_.is_on() || state_.cutter_side != CutterSide::Off)
        return fail(Message::ForbiddenWithCompensation, span, {"G150"});
    if (words_taken || command.group(Group::OneShot) != Code::None)
        return needs("a block of its own");
    if (state_.feed_mode == FeedMode::InverseTime)
        return fail(Message::CycleInverseTime, span, {"G150"});
    if (state_.plane != Plane::XY) return needs("the XY plane (G17)");
    if (state_.frames.programmed.scaled) return needs("scaling and mirroring off (G50)");
    if (state_.incremental) return needs("absolute words (G90)");
    if (!command.has('Z') || !command.has('R')) return needs("a depth (Z) and a height (R)");
    if (command.has('I') == command.has('J')) return needs("one width of cut, I or J");
    if (command.get('L', 1.0) != 1.0) return needs("a block without L");
    if (side != Code::G41 && side != Code::G42) return needs("G41 or G42 in its block");
    const bool along_y = command.has('I');
    const double width = along_y ? command['I'] : command['J'];
    const double allowance = command.get('K', 0.0);
    if (width <= 0.0) return needs("a width of cut above 0");
    if (allowance < 0.0) return needs("a finishing allowance (K) that is not below 0");
    if (!needs_feed(command, "G150")) return false;
    Axes start{};
    AxisMask mask = 0;
    if (!find_ends(command, start, mask)) return false;
    const double bottom = start[kZ];
    const double clear = command['R'];
    const double depth = clear - bottom;
    const double step = command.get('Q', depth);
    if (depth <= 0.0) return needs("a depth (Z) below R");
    if (step <= 0.0 || depth / step > kMostStrokes)
        return needs("an increment of depth (Q) above 0, and not that small");

    // The outline without the line from the starting hole; must be closed.
    if (!is_outline_valid_ || contour_.size() < 2)
        return needs("an outline of G1, G2 and G3 in X and Y");
    if (contour_.front().turns != 0)
        return needs("a line (G1) from the starting hole to the outline");
    const std::vector<OutlineMove> loop(contour_.begin() + 1, contour_.end());
    const double unit = state_.unit_mm();
    if (hypotenuse(loop.back().to.x - loop.front().from.x, loop.back().to.y - loop.front().from.y) >
        kMaxClosingGap / unit) {
        return needs("an outline that ends where it begins");
    }
    const double cutter = std::abs(radius_of_register(command, span));
    std::vector<Vec2> polygon = polygon_of(loop, kChord / unit);
    const CutterSide inside = signed_area(polygon) > 0.0 ? CutterSide::Left : CutterSide::Right;
    if (along_y) {
        for (Vec2& p : polygon)
            std::swap(p.x, p.y);
    }
    const Area area({polygon}, cutter + allowance);
    const Area on_size({polygon}, cutter);
    const auto seen = [&](Vec2 p) { return along_y ? Vec2{p.y, p.x} : p; };
    const Vec2 hole{start[kX], start[kY]};
    if (area.lowest() > area.highest() || !area.contains(seen(hole)))
        return needs("a starting hole (X Y) inside the outline, with room for the cutter");
    const double height = area.highest() - area.lowest();
    const double all_strokes = (height / width + 1.0) * (depth / step + 1.0);
    if (all_strokes > kMostStrokes || all_strokes * static_cast<double>(polygon.size()) > kMostWork)
        return needs("larger increments (Q, I, J)");

    if (!state_.first_length_seen) {
        state_.first_length_seen = true;
        state_.first_length_in_inches = state_.inches;
    }
    constexpr AxisMask kPlane = 1U << kX | 1U << kY;
    constexpr AxisMask kHeight = 1U << kZ;
    const auto go = [&](double x, double y, double z, MoveKind kind) {
        Axes to = state_.position;
        to[kX] = x, to[kY] = y, to[kZ] = z;
        const AxisMask moved = z != state_.position[kZ] ? kHeight : kPlane;
        if (to != state_.position) path_.linear_move(state_, to, kind, moved);
    };
    const auto z = [&] { return state_.position[kZ]; };
    go(hole.x, hole.y, z(), MoveKind::Rapid);
    go(hole.x, hole.y, clear, MoveKind::Rapid);
    const auto reach = [&](Vec2 p, double level) {
        const Vec2 here{state_.position[kX], state_.position[kY]};
        if (area.contains(seen(here), seen(p))) return go(p.x, p.y, level, MoveKind::Feed);
        go(here.x, here.y, clear, MoveKind::Rapid);
        go(p.x, p.y, clear, MoveKind::Rapid);
        go(p.x, p.y, level, MoveKind::Feed);
    };
    const int levels = static_cast<int>(std::ceil(depth / step - 1e-9));
    for (int i = 1; i <= levels; ++i) {
        const double level = i == levels ? bottom : clear - i * step;
        if (i > 1) {
            go(state_.position[kX], state_.position[kY], clear, MoveKind::Rapid);
            go(hole.x, hole.y, clear, MoveKind::Rapid);
        }
        go(hole.x, hole.y, level, MoveKind::Feed);
        const int strokes = static_cast<int>(std::ceil(height / width - 1e-9));
        for (int s = 0; s <= strokes; ++s) {
            const double at = s == strokes ? area.highest() : area.lowest() + s * width;
            std::vector<Stroke> pieces = area.strokes_at(at);
            const bool back = s % 2 == 1;
            if (back) std::ranges::reverse(pieces);
            for (const Stroke& piece : pieces) {
                const Vec2 a = seen({back ? piece.to : piece.from, at});
                const Vec2 b = seen({back ? piece.from : piece.to, at});
                reach(a, level);
                go(b.x, b.y, z(), MoveKind::Feed);
            }
        }
        if (!mill_outline(loop, inside, cutter + allowance, area, along_y, level, clear))
            return false;
        const bool finishes = i == levels && allowance > 0.0;
        if (finishes && !mill_outline(loop, inside, cutter, on_size, along_y, level, clear))
            return false;
    }
    go(state_.position[kX], state_.position[kY], clear, MoveKind::Rapid);
    return true;
}

/// Mills around the outline at the distance `radius` inside, starting at the middle of the first
/// move.
bool Machine::mill_outline(const std::vector<OutlineMove>& loop, CutterSide side, double radius,
                           const Area& area, bool along_y, double level, double clear) {
    const OutlineMove& first = loop.front();
    const Vec2 middle = point_at(first, 0.5);
    const Vec2 ahead = direction_in_middle(first);
    const double length = hypotenuse(ahead.x, ahead.y);
    const double in = side == CutterSide::Left ? radius / length : -radius / length;
    const Vec2 offset_point{middle.x - in * ahead.y, middle.y + in * ahead.x};

    Axes to = state_.position;
    const Vec2 here{to[kX], to[kY]};
    const auto seen = [&](Vec2 p) { return along_y ? Vec2{p.y, p.x} : p; };
    constexpr AxisMask kPlane = 1U << kX | 1U << kY;
    constexpr AxisMask kHeight = 1U << kZ;
    const bool straight = area.contains(seen(here), seen(offset_point));
    if (!straight) {
        to[kZ] = clear;
        path_.linear_move(state_, to, MoveKind::Rapid, kHeight);
    }
    to[kX] = offset_point.x, to[kY] = offset_point.y;
    path_.linear_move(state_, to, straight ? MoveKind::Feed : MoveKind::Rapid, kPlane);
    if (!straight) {
        to[kZ] = level;
        path_.linear_move(state_, to, MoveKind::Feed, kHeight);
    }
    const auto follow = [&](const OutlineMove& move, Vec2 end) {
        Axes target = state_.position;
        target[kX] = end.x, target[kY] = end.y;
        if (move.turns == 0) return feed_straight(target, MoveKind::Feed, kPlane);
        const ProgramArc arc{target, move.centre.x, move.centre.y, move.turns};
        if (compensation_.is_on()) return compensation_.arc(state_, arc, kPlane, span_, file_);
        path_.arc(state_, arc, kPlane);
        return true;
    };
    if (radius > 0.0) compensation_.begin_at_offset(side, radius, state_.position);
    state_.position[kX] = middle.x;
    state_.position[kY] = middle.y;
    bool good = follow(first, first.to);
    for (std::size_t i = 1; i < loop.size() && good; ++i)
        good = follow(loop[i], loop[i].to);
    good = good && follow(first, middle);
    if (good) {
        compensation_.end(state_);
    } else {
        control_.compensation = {};
    }
    path_.set_origin(span_, file_);
    return good;
}

}  // namespace ncsim::gcode
