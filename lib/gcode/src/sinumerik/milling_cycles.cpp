// SPDX-License-Identifier: GPL-3.0-or-later
//
// Milling cycles POCKET1 … POCKET4, CYCLE76, CYCLE77 (spigots), CYCLE90 (threads).
// Source: SINUMERIK 840D sl, Programming Manual Cycles, 2007, and NC Programming, 06/2019.
#include "ncsim/base/angles.h"

#include "sinumerik/sinumerik_control.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::gcode::sinumerik {
namespace {

constexpr auto kMillingCycles = std::to_array<std::string_view>(
    {"POCKET1", "POCKET2", "POCKET3", "POCKET4", "CYCLE76", "CYCLE77", "CYCLE61", "CYCLE71",
     "CYCLE72", "CYCLE90", "SLOT1", "SLOT2", "LONGHOLE"});

/// Width of passes without a specified width, in diameters of the tool.
constexpr double kUsualWidth = 0.8;

}  // namespace

int digit(double value, int place) {
    constexpr double kMost = 1e9;
    auto rest = static_cast<long>(std::clamp(std::round(value), 0.0, kMost));
    for (int i = 0; i < place; ++i)
        rest /= 10;
    return static_cast<int>(rest % 10);
}

/// Places of the arguments of a milling cycle; -1: the cycle has no such argument.
struct Control::MillingArguments {
    int depth_relative = -1, length = -1, width = -1, corner = -1, first = -1, second = -1;
    int angle = -1, infeed = -1, allowance = -1, floor_allowance = -1, feed = -1, plunge_feed = -1;
    int direction = -1, variant = -1, step = -1, blank_length = -1, blank_width = -1;
    int blank_depth = -1, helix_radius = -1, helix_pitch = -1;
    int finishing_infeed = -1, finishing_feed = -1, finishing_speed = -1;
    int geometry_mode = -1, mode = -1;
};

bool Control::is_milling_cycle(std::string_view name) {
    return std::ranges::find(kMillingCycles, name) != kMillingCycles.end();
}

/// Returns the places of the arguments of the pocket or spigot cycle `name`.
Control::MillingArguments Control::milling_arguments(std::string_view name) {
    MillingArguments a;
    const bool is_rectangle = name == "POCKET1" || name == "POCKET3" || name == "CYCLE76";
    const bool has_relative_depth = name != "POCKET3" && name != "POCKET4";
    int next = 4;
    if (has_relative_depth) a.depth_relative = next++;
    a.length = next++;
    if (is_rectangle) a.width = next++, a.corner = next++;
    a.first = next++, a.second = next++;
    if (is_rectangle) a.angle = next++;
    if (name == "POCKET1" || name == "POCKET2") {
        a.plunge_feed = next++, a.feed = next++, a.infeed = next++, a.direction = next++;
        a.allowance = next++, a.variant = next++, a.finishing_infeed = next++;
        a.finishing_feed = next++, a.finishing_speed = next++;
        return a;
    }
    a.infeed = next++, a.allowance = next++, a.floor_allowance = next++, a.feed = next++;
    a.plunge_feed = next++, a.direction = next++, a.variant = next++;
    const bool is_spigot = name.starts_with("CYCLE");
    if (!is_spigot) a.step = next++;
    a.blank_length = next++;
    if (is_rectangle) a.blank_width = next++;
    if (is_spigot) return a;
    a.blank_depth = next++, a.helix_radius = next++, a.helix_pitch = next++;
    next += 3;  // _UMODE, _FS, _ZFS
    a.geometry_mode = next, a.mode = next + 2;
    return a;
}

/// Executes a milling cycle; the tool ends at the retraction plane over the middle of the area.
bool Control::mill_cycle(const CycleCall& call) {
    if (side_ != CutterSide::Off)
        return fail(Message::NotRead, call.span, {call.name + " under G41 or G42"});
    if (machine_.state().feed_mode == FeedMode::InverseTime)
        return fail(Message::NotRead, call.span, {call.name + " under G93"});
    if (records_contour_) return fail(Message::NotRead, call.span, {call.name + " in a contour"});
    cycle_span_ = call.span;
    const std::optional<double> diameter = diameter_of(tool_);
    if (edge_ == 0)
        return fail(Message::BlockNeeds, call.span, {call.name, "the radius of the tool (D1)"});
    if (!(diameter.value_or(0.0) > 0.0)) {
        report_unknown_radius(call.name);
        return true;
    }
    const double feed = machine_.state().feed;
    const FeedMode mode = machine_.state().feed_mode;
    const double radius = *diameter / 2.0;
    const bool is_straight_slot = call.name == "SLOT1" || call.name == "LONGHOLE";
    const bool done = call.name == "CYCLE61"   ? mill_face_cycle(call, radius)
                      : call.name == "CYCLE71" ? mill_old_face_cycle(call, radius)
                      : call.name == "CYCLE72" ? mill_path_cycle(call, radius)
                      : call.name == "CYCLE90" ? mill_thread_cycle(call, radius)
                      : is_straight_slot       ? mill_slots_cycle(call, radius)
                      : call.name == "SLOT2"   ? mill_circular_slots_cycle(call, radius)
                                               : mill_area_cycle(call, radius);
    if (machine_.state().feed_mode == mode) machine_.state().feed = feed;
    return done;
}

/// Raises the tool to the retraction plane, if the tool is lower or its height is unknown.
bool Control::rise(double retract) {
    const std::size_t axis = axes_of(plane_).third;
    const bool is_low = at_[axis] < retract || is_unknown(static_cast<AxisMask>(1U << axis));
    return !is_low || move_to(retract, std::nullopt);
}

bool Control::mill_area_cycle(const CycleCall& call, double radius) {
    const std::string& name = call.name;
    const MillingArguments a = milling_arguments(name);
    language::Milling m;
    m.is_stud = name.starts_with("CYCLE");
    m.tool_radius = radius;
    const auto last_plain =
        static_cast<std::size_t>(m.is_stud ? std::max(a.blank_length, a.blank_width)
                                           : std::max(a.helix_pitch, a.finishing_speed));
    const bool has_modes = call.arguments.size() > last_plain + 1;
    if (m.is_stud && has_modes)
        return fail(Message::NotRead, call.span, {name + " with _GMODE or _AMODE"});
    Hole hole;
    if (!read_milling_depth(call, a, hole) || !read_area(call, a, has_modes, m)) return false;
    m.surface = hole.surface;
    m.bottom = hole.bottom;
    m.clear = hole.clear;
    if (m.is_stud && !read_spigot_blank(call, a, m)) return false;
    read_passes(call, a, has_modes, m);
    if (!read_variant(call, a, m)) return false;
    return rise(hole.retract) && mill(m, name) && move_to(hole.retract, std::nullopt);
}

/// Returns the argument at `place`; 0 if the cycle or the call has no such argument.
double Control::milling_argument(const CycleCall& call, int place) const {
    return place < 0 ? 0.0 : argument(call, static_cast<std::size_t>(place), 0.0);
}

/// Reads size, place and angle of the area.
bool Control::read_area(const CycleCall& call, const MillingArguments& a, bool has_modes,
                        language::Milling& m) {
    const auto at = [&](int place) { return milling_argument(call, place); };
    const std::string& name = call.name;
    const bool is_rectangle = a.width >= 0;
    language::MilledArea& area = m.area;
    area.length = std::abs(at(a.length));
    // A circle of POCKET2 and of the short POCKET4 is given by its radius.
    const bool is_radius = name == "POCKET2" || (name == "POCKET4" && !has_modes);
    if (is_radius) area.length *= 2.0;
    if (name == "POCKET4" && has_modes) log_.add(Message::PocketDiameter, call.span, {name});
    area.width = is_rectangle ? std::abs(at(a.width)) : area.length;
    area.corner = is_rectangle ? std::abs(at(a.corner)) : area.length / 2.0;
    area.corner = std::min(area.corner, area.half_width());
    area.angle = at(a.angle);
    area.centre = {at(a.first), at(a.second)};
    if (area.length > 0.0 && area.width > 0.0) return true;
    return fail(Message::BlockNeeds, call.span, {name, "a length and a width above 0"});
}

/// Reads infeeds, allowances, feeds and the distance of passes.
void Control::read_passes(const CycleCall& call, const MillingArguments& a, bool has_modes,
                          language::Milling& m) {
    const auto at = [&](int place) { return milling_argument(call, place); };
    m.infeed = std::abs(at(a.infeed));
    m.has_equal_infeeds = true;
    m.side_allowance = std::abs(at(a.allowance));
    m.floor_allowance = std::abs(at(a.floor_allowance));
    m.feed = feed_of(at(a.feed));
    m.plunge_feed = feed_of(at(a.plunge_feed));
    if (!(m.plunge_feed > 0.0)) m.plunge_feed = m.feed;
    m.finishing_feed = at(a.finishing_feed) > 0.0 ? feed_of(at(a.finishing_feed)) : m.feed;
    m.finishing_infeed = a.finishing_infeed >= 0 ? std::abs(at(a.finishing_infeed)) : m.infeed;
    if (at(a.finishing_speed) > 0.0) m.finishing_speed = at(a.finishing_speed);
    const double diameter = 2.0 * m.tool_radius;
    const double step = std::abs(at(a.step));
    const bool is_percentage = has_modes && digit(at(a.mode), 1) == 1;
    m.step = is_percentage ? step / 100.0 * diameter : step;
    if (m.step == 0.0) m.step = kUsualWidth * diameter;
}

/// Reads RTP, RFP, SDIS and the depth of a pocket or spigot.
bool Control::read_milling_depth(const CycleCall& call, const MillingArguments& a, Hole& hole) {
    if (a.depth_relative >= 0) return read_hole(call, hole);
    CycleCall plain = call;
    // In POCKET3 and POCKET4 the argument after the depth is a size.
    plain.arguments.resize(4);
    const bool has_mode = call.arguments.size() > static_cast<std::size_t>(a.mode);
    const double mode = has_mode ? argument(call, static_cast<std::size_t>(a.mode), 0.0) : 0.0;
    if (digit(mode, 0) == 1) {
        const Value depth = Value::of(argument(call, 3, 0.0));
        plain.arguments = {call.arguments[0], call.arguments[1], call.arguments[2], std::nullopt,
                           depth};
    }
    return read_hole(plain, hole);
}

/// Reads the direction, and what is milled: roughing, finishing, both.
bool Control::read_variant(const CycleCall& call, const MillingArguments& a, language::Milling& m) {
    const auto at = [&](int place) { return milling_argument(call, place); };
    const double direction = at(a.direction);
    const bool turns_left = machine_.state().spindle == SpindleTurning::Counterclockwise;
    if (direction == 2.0 || direction == 3.0) {
        m.is_clockwise = direction == 2.0;
    } else if (direction == 0.0 || direction == 1.0) {
        // 0: climb milling, counter-clockwise in a pocket and clockwise around a spigot.
        m.is_clockwise = ((direction == 0.0) != turns_left) == m.is_stud;
    } else {
        return fail(Message::BlockNeeds, call.span, {call.name, "a direction (CDIR) from 0 to 3"});
    }
    const double variant = at(a.variant);
    const int kind = digit(variant, 0);
    const bool is_old = call.name == "POCKET1" || call.name == "POCKET2";
    const bool is_complete = is_old && kind == 0;
    if (kind != 1 && kind != 2 && kind != 4 && !is_complete)
        return fail(Message::NotRead, call.span, {call.name + " with this VARI"});
    m.roughs = kind == 1 || is_complete;
    m.finishes_side = kind == 2 || kind == 4 || (is_complete && m.side_allowance > 0.0);
    m.finishes_floor = kind == 2;
    const int plunge = is_old ? 1 : digit(variant, 1);
    using enum language::Plunge;
    m.plunge = plunge == 0 ? Rapid : plunge == 2 ? Helix : plunge == 3 ? Ramp : Vertical;
    m.helix_radius = std::abs(at(a.helix_radius));
    m.helix_pitch = std::abs(at(a.helix_pitch));
    if (m.is_stud) {
        m.plunge = Vertical;
        return true;
    }
    const bool has_modes =
        a.geometry_mode >= 0 && call.arguments.size() > static_cast<std::size_t>(a.geometry_mode);
    const int reference = digit(at(a.geometry_mode), 3);
    const int scope = digit(at(a.geometry_mode), 4);
    if (has_modes && (reference > 1 || scope > 1))
        return fail(Message::NotRead, call.span, {call.name + " with this _GMODE"});
    const bool has_blank = !has_modes && (at(a.blank_length) != 0.0 || at(a.blank_width) != 0.0 ||
                                          at(a.blank_depth) != 0.0);
    if (has_blank)
        return fail(Message::NotRead, call.span, {call.name + " with a blank (_AP1, _AD)"});
    return true;
}

bool Control::read_spigot_blank(const CycleCall& call, const MillingArguments& a,
                                language::Milling& m) {
    const auto at = [&](int place) { return std::abs(milling_argument(call, place)); };
    const bool is_rectangle = a.blank_width >= 0;
    const double length = at(a.blank_length);
    const double width = is_rectangle ? at(a.blank_width) : length;
    if (length < m.area.length || width < m.area.width)
        return fail(Message::BlockNeeds, call.span,
                    {call.name, "a blank (_AP1, _AP2) of at least the size of the spigot"});
    m.blank_length = length;
    log_.add(Message::MillsOutside, call.span, {call.name});
    const double x = (length - m.area.length) / 2.0;
    const double y = (width - m.area.width) / 2.0;
    m.blank = is_rectangle ? hypotenuse(x + m.area.corner, y + m.area.corner) - m.area.corner : x;
    return true;
}

/// CYCLE90(RTP, RFP, SDIS, DP, DPR, DIATH, KDIAM, PIT, FFR, CDIR, TYPTH, CPA, CPO): mills a thread.
bool Control::mill_thread_cycle(const CycleCall& call, double radius) {
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    Hole hole;
    if (!read_hole(call, hole)) return false;
    const double direction = at(9);
    if (direction != 2.0 && direction != 3.0)
        return fail(Message::BlockNeeds, call.span, {call.name, "a direction (CDIR) of 2 or 3"});
    if (at(10) != 0.0 && at(10) != 1.0)
        return fail(Message::BlockNeeds, call.span, {call.name, "a kind (TYPTH) of 0 or 1"});
    language::ThreadMilling m;
    m.is_internal = at(10) == 0.0;
    m.centre = {at(11), at(12)};
    m.radius = m.is_internal ? at(5) / 2.0 - radius : at(6) / 2.0 + radius;
    const double margin = std::max(std::abs(at(2)), 1.0 / machine_.state().unit_mm());
    m.entry = std::max(at(5), at(6)) / 2.0 + radius + margin;
    m.top = m.clear = hole.clear;
    m.bottom = hole.bottom;
    m.pitch = std::abs(at(7));
    m.is_clockwise = direction == 2.0;
    m.feed = at(8) > 0.0 ? feed_of(at(8)) : hole.feed;
    if (!m.is_internal && !(at(6) > 0.0))
        return fail(Message::BlockNeeds, call.span, {call.name, "a diameter (KDIAM) above 0"});
    if (!(m.radius > 0.0))
        return fail(Message::BlockNeeds, call.span, {call.name, "a diameter larger than the tool"});
    if (!(m.pitch > 0.0)) return fail(Message::BlockNeeds, call.span, {call.name, "a pitch (PIT)"});
    return rise(hole.retract) && mill_thread(m) && move_to(hole.retract, std::nullopt);
}

}  // namespace ncsim::gcode::sinumerik
