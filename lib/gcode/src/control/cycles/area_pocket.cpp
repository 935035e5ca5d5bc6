// SPDX-License-Identifier: GPL-3.0-or-later
//
// G150 of Haas: a pocket of any shape. The outline is in a subprogram that is not executed but
// recorded: a line from the starting hole to the outline, then once around the outline.
#include "ncsim/base/angles.h"

#include "control/block_steps.h"
#include "control/cycles/area.h"
#include "control/cycles/cycle_steps.h"
#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

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

/// Mills around the outline at the distance `radius` inside, starting at the middle of the first
/// move.
bool mill_outline(ControlState& control, const std::vector<OutlineMove>& loop, CutterSide side,
                  double radius, const Area& area, bool along_y, double level, double clear,
                  Context& context) {
    MachineState& state = control.machine;
    const OutlineMove& first = loop.front();
    const Vec2 middle = point_at(first, 0.5);
    const Vec2 ahead = direction_in_middle(first);
    const double length = hypotenuse(ahead.x, ahead.y);
    const double in = side == CutterSide::Left ? radius / length : -radius / length;
    const Vec2 offset_point{middle.x - in * ahead.y, middle.y + in * ahead.x};

    Axes to = state.position;
    const Vec2 here{to[kX], to[kY]};
    const auto seen = [&](Vec2 p) { return along_y ? Vec2{p.y, p.x} : p; };
    constexpr AxisMask kPlane = 1U << kX | 1U << kY;
    constexpr AxisMask kHeight = 1U << kZ;
    const bool straight = area.contains(seen(here), seen(offset_point));
    if (!straight) {
        to[kZ] = clear;
        context.path.linear_move(state, to, MoveKind::Rapid, kHeight);
    }
    to[kX] = offset_point.x, to[kY] = offset_point.y;
    context.path.linear_move(state, to, straight ? MoveKind::Feed : MoveKind::Rapid, kPlane);
    if (!straight) {
        to[kZ] = level;
        context.path.linear_move(state, to, MoveKind::Feed, kHeight);
    }
    const auto follow = [&](const OutlineMove& move, Vec2 end) {
        Axes target = state.position;
        target[kX] = end.x, target[kY] = end.y;
        if (move.turns == 0) return feed_straight(control, target, MoveKind::Feed, kPlane, context);
        const ProgramArc arc{target, move.centre.x, move.centre.y, move.turns};
        if (control.compensation.is_on())
            return compensation_of(control, context)
                .arc(state, arc, kPlane, context.span, context.file);
        context.path.arc(state, arc, kPlane);
        return true;
    };
    if (radius > 0.0)
        compensation_of(control, context).begin_at_offset(side, radius, state.position);
    state.position[kX] = middle.x;
    state.position[kY] = middle.y;
    bool good = follow(first, first.to);
    for (std::size_t i = 1; i < loop.size() && good; ++i)
        good = follow(loop[i], loop[i].to);
    good = good && follow(first, middle);
    if (good) {
        compensation_of(control, context).end(state);
    } else {
        control.compensation = {};
    }
    context.path.set_origin(context.span, context.file);
    return good;
}

}  // namespace

bool begin_contour(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    if (control.corner) settle_corner(control, context);
    Axes start{};
    AxisMask mask = 0;
    if (!find_ends(state, command, start, mask, context)) return false;
    context.outline = {control, {}, false};
    state.position[kX] = start[kX];
    state.position[kY] = start[kY];
    state.motion = Code::G1;
    state.cycle = {};
    state.feed_mode = FeedMode::PerMinute;
    // Satisfies the feed check of the outline; the feed of the G150 block counts.
    state.feed = std::max(state.feed, 1.0);
    return true;
}

void end_outline(ControlState& control, Context& context) {
    if (control.corner) settle_corner(control, context);
    restore(control, *context.outline.before, context);
    context.outline.before.reset();
}

bool belongs_to_outline(const Command& command) {
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

bool mill_area_pocket(ControlState& control, const Command& command, Code side, bool words_taken,
                      Context& context) {
    MachineState& state = control.machine;
    const SourceSpan span = span_of_g(command, Code::G150);
    const auto needs = [&](std::string_view what) {
        return fail(context, Message::PocketWord, span, {"G150", what});
    };
    if (control.compensation.is_on() || state.cutter_side != CutterSide::Off)
        return fail(context, Message::ForbiddenWithCompensation, span, {"G150"});
    if (words_taken || command.group(Group::OneShot) != Code::None)
        return needs("a block of its own");
    if (state.feed_mode == FeedMode::InverseTime)
        return fail(context, Message::CycleInverseTime, span, {"G150"});
    if (state.plane != Plane::XY) return needs("the XY plane (G17)");
    if (state.frames.programmed.scaled) return needs("scaling and mirroring off (G50)");
    if (state.incremental) return needs("absolute words (G90)");
    if (!command.has('Z') || !command.has('R')) return needs("a depth (Z) and a height (R)");
    if (command.has('I') == command.has('J')) return needs("one width of cut, I or J");
    if (command.get('L', 1.0) != 1.0) return needs("a block without L");
    if (side != Code::G41 && side != Code::G42) return needs("G41 or G42 in its block");
    const bool along_y = command.has('I');
    const double width = along_y ? command['I'] : command['J'];
    const double allowance = command.get('K', 0.0);
    if (width <= 0.0) return needs("a width of cut above 0");
    if (allowance < 0.0) return needs("a finishing allowance (K) that is not below 0");
    if (!needs_feed(state, command, "G150", context)) return false;
    Axes start{};
    AxisMask mask = 0;
    if (!find_ends(state, command, start, mask, context)) return false;
    const double bottom = start[kZ];
    const double clear = command['R'];
    const double depth = clear - bottom;
    const double step = command.get('Q', depth);
    if (depth <= 0.0) return needs("a depth (Z) below R");
    if (step <= 0.0 || depth / step > kMostStrokes)
        return needs("an increment of depth (Q) above 0, and not that small");

    // The outline without the line from the starting hole; must be closed.
    if (context.outline.is_foreign || context.outline.moves.size() < 2)
        return needs("an outline of G1, G2 and G3 in X and Y");
    if (context.outline.moves.front().turns != 0)
        return needs("a line (G1) from the starting hole to the outline");
    const std::vector<OutlineMove>& outline = context.outline.moves;
    const std::vector<OutlineMove> loop(outline.begin() + 1, outline.end());
    const double unit = state.unit_mm();
    if (hypotenuse(loop.back().to.x - loop.front().from.x, loop.back().to.y - loop.front().from.y) >
        kMaxClosingGap / unit) {
        return needs("an outline that ends where it begins");
    }
    const double cutter = std::abs(radius_of_register(control, command, span, context));
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

    note_length(state);
    constexpr AxisMask kPlane = 1U << kX | 1U << kY;
    constexpr AxisMask kHeight = 1U << kZ;
    const auto go = [&](double x, double y, double z, MoveKind kind) {
        Axes to = state.position;
        to[kX] = x, to[kY] = y, to[kZ] = z;
        const AxisMask moved = z != state.position[kZ] ? kHeight : kPlane;
        if (to != state.position) context.path.linear_move(state, to, kind, moved);
    };
    const auto z = [&] { return state.position[kZ]; };
    go(hole.x, hole.y, z(), MoveKind::Rapid);
    go(hole.x, hole.y, clear, MoveKind::Rapid);
    const auto reach = [&](Vec2 p, double level) {
        const Vec2 here{state.position[kX], state.position[kY]};
        if (area.contains(seen(here), seen(p))) return go(p.x, p.y, level, MoveKind::Feed);
        go(here.x, here.y, clear, MoveKind::Rapid);
        go(p.x, p.y, clear, MoveKind::Rapid);
        go(p.x, p.y, level, MoveKind::Feed);
    };
    const int levels = static_cast<int>(std::ceil(depth / step - 1e-9));
    for (int i = 1; i <= levels; ++i) {
        const double level = i == levels ? bottom : clear - i * step;
        if (i > 1) {
            go(state.position[kX], state.position[kY], clear, MoveKind::Rapid);
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
        if (!mill_outline(control, loop, inside, cutter + allowance, area, along_y, level, clear,
                          context))
            return false;
        const bool finishes = i == levels && allowance > 0.0;
        if (finishes &&
            !mill_outline(control, loop, inside, cutter, on_size, along_y, level, clear, context))
            return false;
    }
    go(state.position[kX], state.position[kY], clear, MoveKind::Rapid);
    return true;
}

}  // namespace ncsim::gcode
