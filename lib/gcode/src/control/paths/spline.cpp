// SPDX-License-Identifier: GPL-3.0-or-later
//
// G5, G5.1 (Bézier curves), G5.2/G5.3 and G6.2 (NURBS) in the XY plane.
// Source: Piegl, Tiller, "The NURBS Book", 1997.
#include "control/paths/path_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode {
namespace {

/// Limit above the memory of any control.
constexpr std::size_t kMostPoints = 100'000;

Spline::ControlPoint point(double x, double y, double weight = 1.0) {
    // In program coordinates, as Path::spline requires.
    return {Length::from_mm(x), Length::from_mm(y), weight};
}

/// Returns a clamped knot vector: the curve begins and ends at the outer control points.
std::vector<double> clamped_knots(std::size_t points, int order) {
    const auto k = static_cast<std::size_t>(order);
    std::vector<double> knots;
    for (std::size_t i = 0; i < points + k; ++i) {
        const std::size_t inner = i < k ? 0 : std::min(i - k + 1, points - k + 1);
        knots.push_back(static_cast<double>(inner));
    }
    return knots;
}

// Returns the name of an axis in `command` that is not in `followed`; nullopt: none.
std::optional<std::string_view> other_axis(const Command& command, std::string_view followed) {
    static constexpr std::string_view kAxes = "XYZABCUVW@^";
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        if (command.has(kAxes[i]) && followed.find(kAxes[i]) == std::string_view::npos)
            return kAxes.substr(i, 1);
    }
    return std::nullopt;
}

/// Moves along the curve, and discards the points.
void finish_curve(ControlState& control, std::vector<double> knots, Context& context) {
    MachineState& state = control.machine;
    const Curve curve = std::exchange(control.curve, {});
    Spline spline;
    spline.order = curve.order;
    spline.control_points.assign(curve.points.begin(), curve.points.end());
    spline.knots = std::move(knots);
    Axes end = state.position;
    end[kX] = curve.points.back().x.mm();
    end[kY] = curve.points.back().y.mm();
    context.path.spline(state, spline, end, 1U << kX | 1U << kY);
}

}  // namespace

bool spline_move(MachineState& state, const Command& command, Code motion, Context& context) {
    const std::string_view name = motion == Code::G5 ? "G5" : "G5.1";
    if (state.plane != Plane::XY) return fail(context, Message::SplinePlane, command.span, {name});
    if (const auto axis = other_axis(command, context.rules.strict ? "XYUVW@^" : "XYZUVW@^")) {
        return fail(context, Message::SplineAxes, command.span,
                    {name, context.rules.strict ? "X and Y" : "linear axes", *axis});
    }
    if (!needs_feed(state, command, name, context)) return false;
    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(state, command, end, mask, context)) return false;
    const double x0 = state.position[kX];
    const double y0 = state.position[kY];
    Spline out;
    if (motion == Code::G5_1) {
        if (!command.has('I') && !command.has('J')) {
            return fail(context, Message::SplineWords, command.span, {name, "I or J"});
        }
        out.order = 3;
        out.control_points = {point(x0, y0),
                              point(x0 + command.get('I', 0.0), y0 + command.get('J', 0.0)),
                              point(end[kX], end[kY])};
        state.previous_was_spline = false;
    } else {
        if (!command.has('P') || !command.has('Q')) {
            return fail(context, Message::SplineWords, command.span, {name, "P and Q"});
        }
        double i = command.get('I', 0.0);
        double j = command.get('J', 0.0);
        if (!command.has('I') && !command.has('J')) {
            if (!state.previous_was_spline)
                return fail(context, Message::SplineWords, command.span, {name, "I and J"});
            i = -state.last_pq[0];  // Continues the tangent of the previous curve.
            j = -state.last_pq[1];
        }
        state.last_pq = {command['P'], command['Q']};
        out.control_points = {point(x0, y0), point(x0 + i, y0 + j),
                              point(end[kX] + state.last_pq[0], end[kY] + state.last_pq[1]),
                              point(end[kX], end[kY])};
        state.previous_was_spline = true;
    }
    out.knots = clamped_knots(out.control_points.size(), out.order);
    context.path.spline(state, out, end, mask);
    return true;
}

bool nurbs_move(ControlState& control, const Command& command, Code motion, Context& context) {
    MachineState& state = control.machine;
    Curve& curve = control.curve;
    if (motion == Code::G5_2) {
        if (!curve.by_points) {
            curve.order = static_cast<int>(std::clamp(command.get('L', 3.0), 2.0, 20.0));
            curve.points.push_back(
                point(state.position[kX], state.position[kY], command.get('P', 1.0)));
            curve.by_points = true;
        }
        if (const auto axis = other_axis(command, "XY")) {
            return fail(context, Message::SplineAxes, command.span, {"G5.2", "X and Y", *axis});
        }
        if (!command.has_any(letters('X', 'Y'))) return true;
        if (curve.points.size() >= kMostPoints) {
            return fail(context, Message::SplineTooLong, command.span);
        }
        const Spline::ControlPoint& last = curve.points.back();
        double x = command.get('X', state.incremental ? 0.0 : last.x.mm());
        double y = command.get('Y', state.incremental ? 0.0 : last.y.mm());
        if (state.incremental) x += last.x.mm(), y += last.y.mm();
        curve.points.push_back(point(x, y, command.get('P', 1.0)));
        return true;
    }
    if (!curve.by_points) return fail(context, Message::SplineNotOpen, command.span);
    context.curve_fails = true;  // Reset if the curve is completed.
    const std::size_t points = curve.points.size();
    if (points < static_cast<std::size_t>(curve.order)) {
        return fail(context, Message::SplineTooFewPoints, command.span);
    }
    if (!needs_feed(state, command, "G5.3", context)) return false;
    finish_curve(control, clamped_knots(points, curve.order), context);
    return true;
}

bool nurbs_move_with_knots(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    Curve& curve = control.curve;
    if (state.plane != Plane::XY)
        return fail(context, Message::SplinePlane, command.span, {"G6.2"});
    if (const auto axis = other_axis(command, "XY")) {
        return fail(context, Message::SplineAxes, command.span, {"G6.2", "X and Y", *axis});
    }
    if (!needs_feed(state, command, "G6.2", context)) return false;
    if (!curve.by_knots) {
        if (!command.has('P'))
            return fail(context, Message::SplineWords, command.span, {"G6.2", "P"});
        curve.order = static_cast<int>(std::clamp(command['P'], 2.0, 20.0));
        curve.by_knots = true;
    }
    if (!command.has('K')) return fail(context, Message::SplineWords, command.span, {"G6.2", "K"});
    if (curve.points.size() >= kMostPoints) {
        return fail(context, Message::SplineTooLong, command.span);
    }
    const bool falls = !curve.knots.empty() && command['K'] < curve.knots.back();
    curve.knots.push_back(command['K']);
    if (command.has_any(letters('X', 'Y'))) {
        Axes end{};
        AxisMask mask = 0;
        if (!find_ends(state, command, end, mask, context)) return false;
        curve.points.push_back(point(end[kX], end[kY], command.get('R', 1.0)));
    }
    const std::size_t points = curve.points.size();
    const auto order = static_cast<std::size_t>(curve.order);
    if (!falls && curve.knots.size() < points + order) return true;
    if (falls || points < order || !(curve.knots[points] > curve.knots[order - 1])) {
        context.curve_fails = true;
        return fail(context, falls ? Message::SplineKnots : Message::SplineTooFewPoints,
                    command.span);
    }
    // The tool moves to the first control point before the curve.
    Axes start = state.position;
    start[kX] = curve.points.front().x.mm();
    start[kY] = curve.points.front().y.mm();
    if (start != state.position) {
        context.path.linear_move(state, start, MoveKind::Feed, 1U << kX | 1U << kY);
    }
    finish_curve(control, {curve.knots.begin(), curve.knots.end()}, context);
    return true;
}

}  // namespace ncsim::gcode
