// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses the canonical functions of a reference, and compares events.
#include "reference.h"

#include "ncsim/gcode/print.h"

#include <zlib.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace ncsim::corpus {
namespace {

using gcode::Axes;
using gcode::Plane;

struct PlaneAxes {
    std::size_t first, second, third;
};
PlaneAxes axes_of(Plane plane) {
    switch (plane) {
        case Plane::ZX: return {2, 0, 1};
        case Plane::YZ: return {1, 2, 0};
        default: return {0, 1, 2};
    }
}

bool is_rotary(std::size_t axis) {
    return axis >= 3 && axis <= 5;
}

std::vector<double> numbers_in(std::string_view text) {
    std::vector<double> out;
    const char* p = text.data();
    const char* const end = p + text.size();
    while (p < end) {
        double value = 0.0;
        const auto [next, error] = std::from_chars(p, end, value);
        if (error == std::errc() && next != p) {
            out.push_back(value);
            p = next;
        } else {
            ++p;
        }
    }
    return out;
}

struct Frame {
    bool inches = false;
    Axes g5x{}, g92{}, tool{};  // active units
    double rotation = 0.0;

    double unit() const { return inches ? 25.4 : 1.0; }

    Axes to_machine(const Axes& p) const {
        Axes m{};
        for (std::size_t i = 0; i < 9; ++i)
            m[i] = p[i] + g92[i];
        const double a = rotation * std::numbers::pi / 180.0;
        const double x = m[0] * std::cos(a) - m[1] * std::sin(a);
        m[1] = m[0] * std::sin(a) + m[1] * std::cos(a);
        m[0] = x;
        for (std::size_t i = 0; i < 9; ++i)
            m[i] = (m[i] + g5x[i]) * (is_rotary(i) ? 1.0 : unit());
        return m;
    }
    Axes in_mm(const Axes& a) const {
        Axes out = a;
        for (std::size_t i = 0; i < 9; ++i)
            out[i] *= is_rotary(i) ? 1.0 : unit();
        return out;
    }
    void set_units(bool to_inches) {
        if (to_inches == inches) return;
        const double factor = to_inches ? 1.0 / 25.4 : 25.4;
        for (Axes* axes : {&g5x, &g92, &tool}) {
            for (std::size_t i = 0; i < 9; ++i) {
                if (!is_rotary(i)) (*axes)[i] *= factor;
            }
        }
        inches = to_inches;
    }
};

void copy_numbers(Axes& axes, const std::vector<double>& numbers, std::size_t from) {
    for (std::size_t i = 0; i < 9 && from + i < numbers.size(); ++i)
        axes[i] = numbers[from + i];
}

}  // namespace

std::optional<std::string> read_gzip(const std::string& path) {
    gzFile file = gzopen(path.c_str(), "rb");
    if (!file) return std::nullopt;
    std::string out;
    std::array<char, 65536> buffer{};
    int n = 0;
    while ((n = gzread(file, buffer.data(), buffer.size())) > 0) {
        out.append(buffer.data(), static_cast<std::size_t>(n));
    }
    gzclose(file);
    return out;
}

std::vector<Event> read_reference(const std::string& text) {
    std::vector<Event> events;
    Frame frame;
    double feed = 0.0;  // mm
    bool sync = false;
    double selected = 0.0;
    Plane plane = Plane::XY;
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t end = text.find('\n', at);
        if (end == std::string::npos) end = text.size();
        const std::string_view line = std::string_view(text).substr(at, end - at);
        at = end + 1;
        const std::size_t l = line.find('L');
        const std::size_t open = line.find('(');
        if (l == std::string_view::npos || open == std::string_view::npos || l > open) continue;
        std::size_t name_start = line.rfind(' ', open);
        name_start = name_start == std::string_view::npos ? 0 : name_start + 1;
        const std::string_view name = line.substr(name_start, open - name_start);
        const std::string_view arguments = line.substr(open);
        const std::vector<double> n = numbers_in(arguments);
        Event event;
        std::from_chars(line.data() + l + 1, line.data() + line.size(), event.line);
        const auto push = [&](Call call) {
            event.call = call;
            event.feed = feed;
            event.compare_feed = !sync && (call == Call::Feed || call == Call::Arc);
            event.inches = frame.inches;
            event.work_offset = frame.in_mm(frame.g5x);
            event.offset_92 = frame.in_mm(frame.g92);
            event.rotation = frame.rotation;
            events.push_back(event);
        };
        Axes p{};
        if (name == "STRAIGHT_FEED" || name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_PROBE") {
            copy_numbers(p, n, 0);
            event.end = frame.to_machine(p);
            push(name == "STRAIGHT_FEED"       ? Call::Feed
                 : name == "STRAIGHT_TRAVERSE" ? Call::Traverse
                                               : Call::Probe);
        } else if (name == "ARC_FEED" && n.size() >= 6) {
            const PlaneAxes axes = axes_of(plane);
            p[axes.first] = n[0];
            p[axes.second] = n[1];
            p[axes.third] = n[5];
            for (std::size_t i = 6; i < n.size() && i < 9; ++i)
                p[i - 3] = n[i];
            event.end = frame.to_machine(p);
            p[axes.first] = n[2];
            p[axes.second] = n[3];
            const Axes centre = frame.to_machine(p);
            event.centre_1 = centre[axes.first];
            event.centre_2 = centre[axes.second];
            event.turns = static_cast<int>(n[4]);
            event.plane = plane;
            push(Call::Arc);
        } else if (name.starts_with("NURBS")) {
            event.value = n.empty() ? 0.0 : n[0];
            push(Call::Spline);
        } else if (name == "RIGID_TAP" && n.size() >= 3) {
            copy_numbers(p, {n[0], n[1], n[2]}, 0);
            event.end = frame.to_machine(p);
            sync = true;
            Event back = events.empty() ? Event{} : events.back();
            push(Call::Feed);
            event.end = back.end;
            push(Call::Feed);
        } else if (name == "USE_LENGTH_UNITS") {
            const bool inches = arguments.find("INCH") != std::string_view::npos;
            frame.set_units(inches);
        } else if (name == "SET_G5X_OFFSET") {
            copy_numbers(frame.g5x, n, 1);
        } else if (name == "SET_G92_OFFSET") {
            copy_numbers(frame.g92, n, 0);
        } else if (name == "SET_XY_ROTATION" && !n.empty()) {
            frame.rotation = n[0];
        } else if (name == "SELECT_PLANE") {
            plane = arguments.find("XZ") != std::string_view::npos   ? Plane::ZX
                    : arguments.find("YZ") != std::string_view::npos ? Plane::YZ
                                                                     : Plane::XY;
        } else if (name == "SET_FEED_RATE" && !n.empty()) {
            feed = n[0] * frame.unit();
        } else if (name == "START_SPEED_FEED_SYNC") {
            sync = true;
        } else if (name == "STOP_SPEED_FEED_SYNCH") {
            sync = false;
        } else if (name == "DWELL" && !n.empty()) {
            event.value = n[0];
            push(Call::Dwell);
        } else if (name == "SELECT_TOOL" && !n.empty()) {
            selected = n[0];
        } else if (name == "CHANGE_TOOL") {
            event.value = selected;
            push(Call::ToolChange);
        } else if (name == "CHANGE_TOOL_NUMBER" && !n.empty()) {
            event.value = n[0];
            push(Call::ToolChange);
        }
    }
    return events;
}

Event to_event(const gcode::Motion& motion, const gcode::ProgramFrame& frame) {
    Event event;
    event.line = motion.span.line;
    event.feed = motion.feed;
    event.compare_feed = motion.feed_mode != gcode::FeedMode::InverseTime;
    event.inches = frame.inches;
    const double unit = frame.inches ? 25.4 : 1.0;
    for (std::size_t i = 0; i < 9; ++i) {
        const double scale = is_rotary(i) ? 1.0 : unit;
        event.work_offset[i] = frame.work_offset[i] * scale;
        event.offset_92[i] = frame.offset_92[i] * scale;
    }
    event.rotation = frame.rotation;
    if (const gcode::Position* p = gcode::end_of(motion)) {
        event.end = {p->x.mm(),      p->y.mm(), p->z.mm(), p->a.degrees(), p->b.degrees(),
                     p->c.degrees(), p->u.mm(), p->v.mm(), p->w.mm()};
    }
    if (std::holds_alternative<gcode::Linear>(motion.action)) {
        event.call = motion.kind == gcode::MoveKind::Rapid   ? Call::Traverse
                     : motion.kind == gcode::MoveKind::Probe ? Call::Probe
                                                             : Call::Feed;
    } else if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
        event.call = Call::Arc;
        event.centre_1 = arc->centre_1.mm();
        event.centre_2 = arc->centre_2.mm();
        event.turns = arc->turns;
        event.plane = arc->plane;
    } else if (const auto* spline = std::get_if<gcode::Spline>(&motion.action)) {
        event.call = Call::Spline;
        event.value = static_cast<double>(spline->control_points.size());
        event.knots = static_cast<double>(spline->knots.size());
    } else if (const auto* dwell = std::get_if<gcode::Dwell>(&motion.action)) {
        event.call = Call::Dwell;
        event.value = dwell->seconds;
    } else if (const auto* change = std::get_if<gcode::ToolChange>(&motion.action)) {
        event.call = Call::ToolChange;
        event.value = change->tool;
    }
    return event;
}

void put_into_machine(std::vector<Event>& events, const gcode::WorkOffset& workpiece) {
    constexpr double kRadians = 3.14159265358979323846 / 180.0;
    const double cosine = std::cos(workpiece.rotation * kRadians);
    const double sine = std::sin(workpiece.rotation * kRadians);
    const auto put = [&](gcode::Axes& p) {
        const double x = p[gcode::kX] * cosine - p[gcode::kY] * sine;
        const double y = p[gcode::kX] * sine + p[gcode::kY] * cosine;
        p[gcode::kX] = x;
        p[gcode::kY] = y;
        for (std::size_t i = 0; i < p.size(); ++i)
            p[i] += workpiece.origin[i];
    };
    constexpr std::size_t kAxes[][2] = {{gcode::kX, gcode::kY}, {gcode::kZ, gcode::kX},
                                        {gcode::kY, gcode::kZ}, {gcode::kU, gcode::kV},
                                        {gcode::kW, gcode::kU}, {gcode::kV, gcode::kW}};
    for (Event& event : events) {
        const auto& axes = kAxes[static_cast<std::size_t>(event.plane)];
        gcode::Axes centre = event.end;
        centre[axes[0]] = event.centre_1;
        centre[axes[1]] = event.centre_2;
        if (event.call == Call::Dwell || event.call == Call::ToolChange) continue;
        put(event.end);
        put(centre);
        if (event.call != Call::Arc) continue;
        event.centre_1 = centre[axes[0]];
        event.centre_2 = centre[axes[1]];
    }
}

namespace {

/// True if `a` and `b` differ by at most 1e-5 in the units of the program, plus the rounding of
/// large numbers to nine printed digits.
bool near(double a, double b, double unit) {
    return std::abs(a - b) <= 1e-5 * unit + 1e-9 * std::max(std::abs(a), std::abs(b));
}

bool near(const Axes& a, const Axes& b, double unit, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        if (!near(a[i], b[i], is_rotary(i) ? 1.0 : unit)) return false;
    }
    return true;
}

const char* name_of(Call call) {
    constexpr const char* kNames[] = {"traverse", "feed",  "arc", "probe",
                                      "spline",   "dwell", "tool"};
    return kNames[static_cast<std::size_t>(call)];
}

std::string describe(const Event& e) {
    std::string out("L");
    out.append(std::to_string(e.line)).append(" ").append(name_of(e.call));
    for (std::size_t i = 0; i < 6; ++i) {
        out += i == 0 ? " " : ",";
        gcode::print_number(out, std::round(e.end[i] * 1e6) / 1e6);
    }
    if (e.call == Call::Arc) {
        out += " c ";
        gcode::print_number(out, e.centre_1);
        out += ',';
        gcode::print_number(out, e.centre_2);
        out.append(" turns ").append(std::to_string(e.turns));
        out.append(" plane ").append(std::to_string(static_cast<int>(e.plane)));
    }
    out += " F";
    gcode::print_number(out, e.feed);
    if (e.value != 0.0) out += " v", gcode::print_number(out, e.value);
    return out;
}

const char* difference(const Event& a, const Event& b, bool geometry_only) {
    const double unit = b.inches ? 25.4 : 1.0;
    if (a.call != b.call) return "call";
    if (a.call == Call::Dwell || a.call == Call::ToolChange || a.call == Call::Spline) {
        // The reference prints a spline as the number of its points, for G6.2 as the number of its
        // knots, without the spline's end.
        const double knots = std::max(a.knots, b.knots);  // only events of ncsim have knots
        if (knots != 0.0 && (near(knots, a.value, 1.0) || near(knots, b.value, 1.0)))
            return nullptr;
        return near(a.value, b.value, 1.0) ? nullptr : "value";
    }
    if (!near(a.end, b.end, unit, 9)) return "end";
    if (a.call == Call::Arc) {
        if (a.plane != b.plane) return "plane";
        if (a.turns != b.turns) return "turns";
        if (!near(a.centre_1, b.centre_1, unit) || !near(a.centre_2, b.centre_2, unit)) {
            return "centre";
        }
    }
    if (geometry_only) return nullptr;
    if (a.inches != b.inches) return "units";
    if (!near(a.work_offset, b.work_offset, unit, 6) || !near(a.offset_92, b.offset_92, unit, 6)) {
        return "offset";
    }
    if (!near(a.rotation, b.rotation, 1.0)) return "rotation";
    const bool feeds =
        (a.call == Call::Feed || a.call == Call::Arc) && a.compare_feed && b.compare_feed;
    if (feeds && std::abs(a.feed - b.feed) > 1e-5 * unit + 1e-5 * std::abs(b.feed)) return "feed";
    return nullptr;
}

std::vector<Event> without_idle(const std::vector<Event>& events) {
    std::vector<Event> out;
    Axes at{};
    for (const Event& e : events) {
        if (e.call == Call::Dwell || e.call == Call::ToolChange) continue;
        const bool idle = e.call != Call::Arc && e.call != Call::Spline && near(e.end, at, 1.0, 9);
        if (e.call != Call::Spline) at = e.end;
        if (!idle) out.push_back(e);
    }
    return out;
}

}  // namespace

std::optional<Difference> compare(const std::vector<Event>& ours,
                                  const std::vector<Event>& reference, bool geometry_only) {
    if (geometry_only) {
        const std::vector<Event> a = without_idle(ours);
        const std::vector<Event> b = without_idle(reference);
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
            if (const char* what = difference(a[i], b[i], true)) {
                return Difference{
                    i, std::string(what) + ": " + describe(a[i]) + " | " + describe(b[i])};
            }
        }
        if (a.size() != b.size()) {
            const auto& longer = a.size() > b.size() ? a : b;
            return Difference{std::min(a.size(), b.size()),
                              std::to_string(a.size()) + " motions, reference " +
                                  std::to_string(b.size()) + ": " +
                                  describe(longer[std::min(a.size(), b.size())])};
        }
        return std::nullopt;
    }
    for (std::size_t i = 0; i < std::min(ours.size(), reference.size()); ++i) {
        if (const char* what = difference(ours[i], reference[i], false)) {
            return Difference{
                i, std::string(what) + ": " + describe(ours[i]) + " | " + describe(reference[i])};
        }
    }
    if (ours.size() != reference.size()) {
        const std::size_t i = std::min(ours.size(), reference.size());
        const auto& longer = ours.size() > reference.size() ? ours : reference;
        return Difference{i, std::to_string(ours.size()) + " events, reference " +
                                 std::to_string(reference.size()) + ": " + describe(longer[i])};
    }
    return std::nullopt;
}

}  // namespace ncsim::corpus
