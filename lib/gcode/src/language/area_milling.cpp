// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves of pocket, slot and stud cycles: passes parallel to the outline at each level, then
// finishing of side and floor. Manuals give the order, the levels and the largest distance of
// passes; the passes themselves are a choice of ncsim and leave the same part.
#include "ncsim/base/angles.h"

#include "language/block_control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::gcode::language {
namespace {

constexpr double kRounding = 1e-9;  // Relative to the radius of the tool.
/// Largest distance of passes, in radii of the tool, that leaves no material in square corners.
constexpr double kWidestStep = 1.4;
/// Slope of ramps and helices without a specified pitch.
constexpr double kSlope = 1.0 / 20.0;
constexpr double kLeastDrop = 1.0 / 50.0;  // Drop of a turn or a ramp, in radii of the tool.
constexpr double kStudMargin = 2.0;        // Distance from a blank at which the tool goes down, mm.

double step_of(const Milling& m) {
    const double widest = kWidestStep * m.tool_radius;
    return m.step > 0.0 ? std::min(m.step, widest) : widest;
}

double length_of(const OutlineMove& move) {
    const double chord = hypotenuse(move.to.x - move.from.x, move.to.y - move.from.y);
    if (move.turns == 0) return chord;
    // At least the chord; ramps need no more.
    return std::max(chord, hypotenuse(move.from.x - move.centre.x, move.from.y - move.centre.y));
}

/// Returns the number of passes parallel to the outline, the outermost at `inset`.
double count_of_passes(const Milling& m, double inset) {
    const double step = step_of(m);
    if (m.is_stud)
        return 1.0 + std::max(0.0, std::ceil((m.blank - m.tool_radius + inset) / step - kRounding));
    const double room = m.area.half_width() - inset;
    return room > kRounding * m.tool_radius ? std::ceil(room / step - kRounding) : 0.0;
}

/// Returns the passes of a level: of a pocket from the inside, of a stud from the outside.
/// `inset`: of the pass next to the wall.
std::vector<Pass> passes_of(const Milling& m, double inset) {
    std::vector<Pass> passes;
    const double step = step_of(m);
    const int count = static_cast<int>(count_of_passes(m, inset));
    const double out = m.is_stud ? -1.0 : 1.0;
    const double innermost = m.area.half_width() - inset - (count - 1) * step;
    if (!m.is_stud && (count == 0 || innermost > m.tool_radius * (1.0 + kRounding))) {
        if (Pass line = centre_line_of(m.area); !line.empty()) passes.push_back(std::move(line));
    }
    for (int i = count - 1; i >= 0; --i) {
        Pass& pass = passes.emplace_back(outline_of(m.area, inset + out * i * step));
        if (m.is_clockwise) reverse(pass);
    }
    return passes;
}

}  // namespace

std::vector<double> levels_of(double from, double to, double infeed, bool is_equal) {
    const double depth = from - to;
    const double count = infeed > 0.0 ? std::max(1.0, std::ceil(depth / infeed - kRounding)) : 1.0;
    std::vector<double> levels;
    for (double i = 1.0; i < count && count <= kMostPasses; ++i)
        levels.push_back(from - (is_equal ? depth * i / count : infeed * i));
    levels.push_back(to);
    return levels;
}

/// Makes `move` in the plane, and moves the tool axis to `height` on the way. Without `feed`: a
/// rapid line.
bool BlockControl::cut(const OutlineMove& move, double height, std::optional<double> feed) {
    const PlaneAxes axes = axes_of(plane_);
    Command command = make(cycle_span_);
    const Code code = move.turns > 0   ? Code::G3
                      : move.turns < 0 ? Code::G2
                      : feed           ? Code::G1
                                       : Code::G0;
    put(command, code);
    if (feed) put(command, 'F', *feed);
    put(command, kAxisNames[axes.first], move.to.x);
    put(command, kAxisNames[axes.second], move.to.y);
    if (height != at_[axes.third]) put(command, kAxisNames[axes.third], height);
    if (move.turns != 0) {
        put(command, kCentres[axes.first], move.centre.x);
        put(command, kCentres[axes.second], move.centre.y);
    }
    command.axis_words = true;
    if (!run(command)) return false;
    at_[axes.first] = move.to.x;
    at_[axes.second] = move.to.y;
    at_[axes.third] = height;
    return true;
}

Vec2 BlockControl::point_in_plane() const {
    const PlaneAxes axes = axes_of(plane_);
    return {at_[axes.first], at_[axes.second]};
}

/// Moves along a line in the plane to `to`; without `feed`: rapid.
bool BlockControl::move_in_plane(Vec2 to, std::optional<double> feed) {
    const Vec2 from = point_in_plane();
    const PlaneAxes axes = axes_of(plane_);
    const auto mask = static_cast<AxisMask>(1U << axes.first | 1U << axes.second);
    if (from.x == to.x && from.y == to.y && !is_unknown(mask)) return true;
    return cut({from, to, {}, 0}, at_[axes.third], feed);
}

/// Makes the moves of `pass` at the height of the tool, after a line to their start.
bool BlockControl::follow(const Pass& pass, double feed) {
    const double height = at_[axes_of(plane_).third];
    return move_in_plane(pass.front().from, feed) &&
           std::ranges::all_of(pass,
                               [&](const OutlineMove& move) { return cut(move, height, feed); });
}

/// Moves full circles about `centre`, from the position of the tool, down to `bottom` or up.
/// `pitch`: height of a turn, > 0. The last turn ends at `end`.
bool BlockControl::wind(Vec2 centre, double end, double pitch, bool is_clockwise, double feed) {
    const std::size_t axis = axes_of(plane_).third;
    const Vec2 here = point_in_plane();
    const double start = at_[axis];
    const double way = std::abs(end - start);
    const double turns = pitch > 0.0 ? std::max(1.0, std::ceil(way / pitch - kRounding)) : 1.0;
    if (!(turns <= kMostPasses)) return fail(Message::CycleRepeats, cycle_span_);
    const double step = end < start ? -pitch : pitch;
    for (int i = 1; i <= static_cast<int>(turns); ++i) {
        const double height = i < turns ? start + i * step : end;
        if (!cut({here, here, centre, is_clockwise ? -1 : 1}, height, feed)) return false;
    }
    return true;
}

/// Moves the tool from `from` down to `level`, over the place where it is, and back to that place.
bool BlockControl::plunge(const Milling& m, double from, double level) {
    const Vec2 place = point_in_plane();
    const double room = m.area.half_width() - m.tool_radius - (m.roughs ? m.side_allowance : 0.0);
    const bool has_room = room > kRounding * m.tool_radius;
    if (m.plunge == Plunge::Helix && has_room && !m.is_stud) {
        const double wanted = m.helix_radius > 0.0 ? m.helix_radius : m.tool_radius;
        const double radius = std::min(wanted, room);
        const double turn = 2.0 * std::numbers::pi * radius;
        const double pitch = m.helix_pitch > 0.0
                                 ? m.helix_pitch
                                 : std::max(turn * kSlope, kLeastDrop * m.tool_radius);
        const Vec2 edge{place.x + radius, place.y};
        return move_to(from, m.plunge_feed) && move_in_plane(edge, m.plunge_feed) &&
               wind(place, level, pitch, m.is_clockwise, m.plunge_feed) &&
               wind(place, level, 0.0, m.is_clockwise, m.feed) && move_in_plane(place, m.feed);
    }
    const Pass line = m.is_stud ? Pass{} : centre_line_of(m.area);
    if (m.plunge == Plunge::Ramp && !line.empty()) {
        double length = 0.0;
        for (const OutlineMove& move : line)
            length += length_of(move);
        const double drop = std::max(length * kSlope, kLeastDrop * m.tool_radius);
        const double rounds = std::ceil((from - level) / drop - kRounding);
        if (!(rounds <= kMostPasses)) return fail(Message::CycleRepeats, cycle_span_);
        if (!move_to(from, m.plunge_feed)) return false;
        double way = 0.0;
        for (int i = 0; i < static_cast<int>(rounds); ++i) {
            for (const OutlineMove& move : line) {
                way += length_of(move);
                const double share = way / (length * rounds);
                if (!cut(move, std::max(level, from - (from - level) * share), m.plunge_feed))
                    return false;
            }
        }
        return move_to(level, m.plunge_feed);
    }
    return move_to(level, m.plunge == Plunge::Rapid ? std::nullopt : std::optional(m.plunge_feed));
}

/// Mills all passes of the levels down to the floor.
bool BlockControl::rough(const Milling& m, Vec2 entry) {
    const double inset = m.tool_radius + m.side_allowance;
    const double floor = m.bottom + m.floor_allowance;
    const std::vector<Pass> passes = passes_of(m, m.is_stud ? -inset : inset);
    double above = m.surface;
    for (const double level : levels_of(m.surface, floor, m.infeed, m.has_equal_infeeds)) {
        if (!plunge(m, above, level)) return false;
        for (const Pass& pass : passes) {
            if (!follow(pass, m.feed)) return false;
        }
        const double lift = std::min(m.clear, level + (m.clear - m.surface));
        if (!leave(m, lift, entry)) return false;
        above = level;
    }
    return true;
}

/// Lifts the tool to `height`, and moves it back to `entry`: of a stud above the part.
bool BlockControl::leave(const Milling& m, double height, Vec2 entry) {
    if (!m.is_stud) return move_to(height, std::nullopt) && move_in_plane(entry, std::nullopt);
    return move_in_plane(entry, m.feed) && move_to(height, std::nullopt);
}

/// Mills the outline on size in levels, then the floor.
bool BlockControl::finish(const Milling& m, Vec2 entry) {
    const double inset = m.is_stud ? -m.tool_radius : m.tool_radius;
    const std::vector<Pass> passes = passes_of(m, inset);
    const double lift = m.clear - m.surface;
    if (m.finishes_side && !passes.empty()) {
        for (const double level :
             levels_of(m.surface, m.bottom, m.finishing_infeed, m.has_equal_infeeds)) {
            if (!move_to(level, m.plunge_feed) || !follow(passes.back(), m.finishing_feed) ||
                !leave(m, std::min(m.clear, level + lift), entry))
                return false;
        }
    }
    if (!m.finishes_floor) return true;
    if (!move_to(m.bottom, m.plunge_feed)) return false;
    return std::ranges::all_of(passes,
                               [&](const Pass& pass) { return follow(pass, m.finishing_feed); }) &&
           leave(m, m.clear, entry);
}

bool BlockControl::mill(const Milling& m, std::string_view name) {
    const double depth = m.surface - m.bottom;
    const double tiny = kRounding * m.tool_radius;
    const double inset = m.tool_radius + (m.roughs ? m.side_allowance : 0.0);
    if (!m.is_stud && m.area.half_width() < inset - tiny)
        return fail(Message::BlockNeeds, cycle_span_,
                    {name, "a width of at least the tool and the allowances"});
    if (m.area.is_band() && m.area.arc_radius <= m.area.width / 2.0)
        return fail(Message::BlockNeeds, cycle_span_, {name, "a slot narrower than its circle"});
    if (m.floor_allowance >= depth && m.roughs)
        return fail(Message::BlockNeeds, cycle_span_, {name, "a depth below the allowance"});
    const double levels = m.infeed > 0.0 ? depth / m.infeed + 1.0 : 1.0;
    const double finishes = m.finishing_infeed > 0.0 ? depth / m.finishing_infeed + 1.0 : 1.0;
    const double passes = count_of_passes(m, m.is_stud ? -m.tool_radius : m.tool_radius) + 1.0;
    const double most = kMostPasses / m.repeats;
    if (!(passes * levels < most && finishes < most))
        return fail(Message::CycleRepeats, cycle_span_);
    Vec2 entry = middle_of(m.area);
    if (m.is_stud) {
        const double outermost =
            m.area.reach() + inset + (count_of_passes(m, -inset) - 1.0) * step_of(m);
        const double margin = kStudMargin / machine_.state().unit_mm();
        const double outside = m.blank_length / 2.0 + m.tool_radius + margin;
        entry = point_in(m.area, std::max(outermost, outside), 0.0);
    }
    if (!move_in_plane(entry, std::nullopt) || !move_to(m.clear, std::nullopt)) return false;
    if (m.roughs && !rough(m, entry)) return false;
    if (m.finishes_side || m.finishes_floor) {
        const double speed = machine_.state().spindle_rpm;
        if (m.finishing_speed) machine_.state().spindle_rpm = *m.finishing_speed;
        const bool done = finish(m, entry);
        machine_.state().spindle_rpm = speed;
        if (!done) return false;
    }
    return move_to(m.clear, std::nullopt);
}

// --- Faces and threads ---

/// Mills a face. The strokes begin and end outside of the face; the first and the last stroke cover
/// the sides.
bool BlockControl::mill_face(const FaceMilling& m) {
    const double across = std::abs(m.is_along_second ? m.length : m.width) + m.overrun;
    const double along = std::abs(m.is_along_second ? m.width : m.length);
    const double step = m.step > 0.0 ? std::min(m.step, 2.0 * m.tool_radius) : m.tool_radius;
    const double count = std::max(1.0, std::ceil(across / step - kRounding));
    const double levels = m.infeed > 0.0 ? (m.surface - m.bottom) / m.infeed + 1.0 : 1.0;
    if (!(count * levels < kMostPasses)) return fail(Message::CycleRepeats, cycle_span_);
    const double reach = m.tool_radius + m.margin;
    const SinCos direction = sin_cos(m.angle);
    const auto place = [&](double to, double row) {
        const double x = (m.is_along_second ? row : to) * (m.length < 0.0 ? -1.0 : 1.0);
        const double y = (m.is_along_second ? to : row) * (m.width < 0.0 ? -1.0 : 1.0);
        return Vec2{m.corner.x + x * direction.cos - y * direction.sin,
                    m.corner.y + x * direction.sin + y * direction.cos};
    };
    for (const double level : levels_of(m.surface, m.bottom, m.infeed, true)) {
        for (int i = 0; i < static_cast<int>(count); ++i) {
            const double row = std::min((i + 1) * step, across) - m.tool_radius;
            const bool is_back = m.is_alternating && i % 2 == 1;
            const Vec2 begin = place(is_back ? along + reach : -reach, row);
            const Vec2 end = place(is_back ? -reach : along + reach, row);
            const bool stays_low = i > 0 && m.is_alternating;
            if (stays_low) {
                if (!move_in_plane(begin, m.feed)) return false;
            } else if (!move_to(m.clear, std::nullopt) || !move_in_plane(begin, std::nullopt) ||
                       !move_to(level, m.feed)) {
                return false;
            }
            if (!move_in_plane(end, m.feed)) return false;
        }
    }
    return move_to(m.clear, std::nullopt);
}

/// Mills a thread: a half circle to the thread, one or several helices, a half circle back.
bool BlockControl::mill_thread(const ThreadMilling& m) {
    // Towards an external thread the tool turns in the other direction.
    const int turn = m.is_clockwise ? -1 : 1;
    const int aside = m.is_internal ? turn : -turn;
    const Vec2 out = m.is_internal ? m.centre : Vec2{m.centre.x + m.entry, m.centre.y};
    const Vec2 edge{m.centre.x + m.radius, m.centre.y};
    const Vec2 between{(out.x + edge.x) / 2.0, m.centre.y};
    const double depth = m.top - m.bottom;
    const double offset = m.turns_per_step * m.pitch;
    const double whole = std::max(1.0, std::ceil(depth / m.pitch - kRounding)) * m.pitch;
    if (!(depth / m.pitch < kMostPasses)) return fail(Message::CycleRepeats, cycle_span_);
    const bool is_one = m.turns_per_step <= 1.0;
    const double height = m.turns_per_step == 1.0 ? whole : m.pitch;
    const double steps = is_one ? 1.0 : std::max(1.0, std::ceil(depth / offset - kRounding));
    if (!move_in_plane(out, std::nullopt) || !move_to(m.clear, std::nullopt)) return false;
    for (int i = 0; i < static_cast<int>(steps); ++i) {
        const double low = m.bottom + (m.goes_up ? i : steps - 1.0 - i) * offset;
        const double begin = m.goes_up ? low : low + height;
        const double end = m.goes_up ? low + height : low;
        if (!move_to(begin, m.approach_feed) || !cut({out, edge, between, aside}, begin, m.feed) ||
            !wind(m.centre, end, m.pitch, m.is_clockwise, m.feed) ||
            !cut({edge, out, between, aside}, end, m.feed))
            return false;
    }
    return move_to(m.clear, std::nullopt);
}

}  // namespace ncsim::gcode::language
