// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strokes of taps and helices of thread mills, as the interpreter sends them.
#include "threads.h"

#include "ncsim/base/angles.h"
#include "ncsim/toolpath/tool.h"

#include "motions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <variant>

namespace ncsim::simulation {

namespace {

// Two lengths of a program are equal, mm: the rounding of three decimals.
constexpr double kSame = 2e-3;

bool is_same(double a, double b) {
    return std::abs(a - b) <= kSame;
}

bool is_upright(const gcode::Position& p) {
    return p.a == gcode::Angle{} && p.b == gcode::Angle{} && p.c == gcode::Angle{};
}

// Returns the angle of the arc about its centre, in turns.
double turns_of(const gcode::Arc& arc) {
    const auto angle = [&](const gcode::Position& p) {
        return angle_of(p.x.mm() - arc.centre_1.mm(), p.y.mm() - arc.centre_2.mm());
    };
    constexpr double kFullTurn = 360.0, kLeast = 1e-6;
    const double ahead =
        arc.turns > 0 ? angle(arc.to) - angle(arc.from) : angle(arc.from) - angle(arc.to);
    double part = std::fmod(ahead + 2.0 * kFullTurn, kFullTurn);
    if (part < kLeast) part = kFullTurn;
    return part / kFullTurn + std::abs(arc.turns) - 1.0;
}

// Thread before its mouth is known.
struct Course {
    Vec3 at;  // on the axis, at the lowest tip
    double path_radius = 0.0, tool_radius = 0.0;
    std::optional<double> pitch{};
    double turns = 0.0;  // of helices
    std::vector<std::uint32_t> lines{};
    int tool = 0;
};

class ThreadFinder {
public:
    explicit ThreadFinder(const Survey& survey) : survey_(survey) {}

    void take(const gcode::Motion& motion) {
        const auto tool = survey_.tools.find(motion.tool);
        const gcode::Position *from = gcode::start_of(motion), *to = gcode::end_of(motion);
        if (tool == survey_.tools.end() || !from || !to || motion.kind != gcode::MoveKind::Feed ||
            !is_upright(*from) || !is_upright(*to))
            return;
        const toolpath::ToolKind kind = tool->second.tool.kind;
        tool_radius_ = 0.5 * toolpath::cutting_diameter_of(tool->second.tool);
        if (kind == toolpath::ToolKind::Tap && from->x == to->x && from->y == to->y &&
            to->z < from->z)
            add_stroke(motion, *to, tool->second.spec.pitch);
        const bool is_mill =
            kind == toolpath::ToolKind::ThreadMill || kind == toolpath::ToolKind::SlotMill;
        const auto* arc = std::get_if<gcode::Arc>(&motion.action);
        if (is_mill && arc && arc->plane == gcode::Plane::XY && !arc->tilted &&
            arc->from.z != arc->to.z)
            add_helix(motion, *arc);
    }

    const std::vector<Course>& courses() const { return courses_; }

private:
    void add_stroke(const gcode::Motion& motion, const gcode::Position& to,
                    std::optional<double> pitch) {
        const Vec3 at{to.x.mm(), to.y.mm(), to.z.mm()};
        add(motion, {at, 0.0, tool_radius_, pitch, 1.0, {}, motion.tool});
    }

    void add_helix(const gcode::Motion& motion, const gcode::Arc& arc) {
        const double x = arc.centre_1.mm(), y = arc.centre_2.mm();
        const auto radius_at = [&](const gcode::Position& p) {
            return norm(Vec3{p.x.mm() - x, p.y.mm() - y, 0.0});
        };
        const double radius = radius_at(arc.to);
        if (!is_same(radius, radius_at(arc.from))) return;
        const double turns = turns_of(arc);
        const double pitch = std::abs(arc.to.z.mm() - arc.from.z.mm()) / turns;
        const double low = std::min(arc.from.z.mm(), arc.to.z.mm());
        add(motion, {{x, y, low}, radius, tool_radius_, pitch, turns, {}, motion.tool});
    }

    // Adds the motion to the thread of the same tool at the same place, or begins a thread.
    void add(const gcode::Motion& motion, Course next) {
        const auto continues = [&](const Course& c) {
            return c.tool == next.tool && is_same(c.at.x, next.at.x) &&
                   is_same(c.at.y, next.at.y) && is_same(c.path_radius, next.path_radius) &&
                   c.pitch.has_value() == next.pitch.has_value() &&
                   (!c.pitch || std::abs(*c.pitch - *next.pitch) <= 0.01 * *c.pitch);
        };
        auto found = std::ranges::find_if(courses_, continues);
        if (found == courses_.end()) {
            found = courses_.insert(courses_.end(), std::move(next));
        } else {
            found->at.z = std::min(found->at.z, next.at.z);
            found->turns += next.turns;
        }
        if (std::ranges::find(found->lines, motion.span.line) == found->lines.end())
            found->lines.push_back(motion.span.line);
    }

    const Survey& survey_;
    double tool_radius_ = 0.0;
    std::vector<Course> courses_;
};

bool is_about(Vec3 on_axis, Vec3 axis, Vec3 at) {
    constexpr double kUpright = 1e-9;
    return axis.z > 1.0 - kUpright && is_same(on_axis.x, at.x) && is_same(on_axis.y, at.y);
}

MeasuredThread thread_of(const Course& course, const MeasureSheet& sheet) {
    MeasuredThread thread;
    std::optional<double> top;
    const auto reach = [&](double z) { top = std::max(top.value_or(z), z); };
    for (const MeasuredBoss& boss : sheet.bosses) {
        const bool is_stud = is_about(boss.foot, boss.axis, course.at) &&
                             0.5 * boss.diameter < course.path_radius + kSame;
        if (!is_stud) continue;
        thread.is_inside = false;
        reach(boss.foot.z + boss.height);
    }
    if (thread.is_inside) {
        for (const MeasuredBore& bore : sheet.bores) {
            if (is_about(bore.mouth, bore.axis, course.at)) reach(bore.mouth.z);
        }
        for (const MeasuredCountersink& sink : sheet.countersinks) {
            if (is_about(sink.mouth, sink.axis, course.at)) reach(sink.mouth.z);
        }
    }
    thread.mouth = {course.at.x, course.at.y, top.value_or(sheet.extents.max.z)};
    const double side = thread.is_inside ? course.tool_radius : -course.tool_radius;
    thread.diameter = 2.0 * (course.path_radius + side);
    thread.pitch = course.pitch;
    thread.depth = thread.mouth.z - course.at.z;
    thread.by.lines = course.lines;
    std::ranges::sort(thread.by.lines);
    thread.by.tools = {static_cast<std::uint32_t>(std::max(0, course.tool))};
    return thread;
}

}  // namespace

std::vector<MeasuredThread> threads_of(const Plan& plan, const Survey& survey,
                                       const MeasureSheet& sheet) {
    ThreadFinder finder(survey);
    for_each_motion(plan, [&](const gcode::Motion& motion) { finder.take(motion); });
    // Three decimals of a centre are less than a turn by this much.
    constexpr double kFullTurn = 0.999;
    std::vector<MeasuredThread> threads;
    for (const Course& course : finder.courses()) {
        if (course.turns < kFullTurn || sheet.extents.is_empty()) continue;
        MeasuredThread thread = thread_of(course, sheet);
        if (thread.depth > 0.0 && thread.diameter > 0.0) threads.push_back(std::move(thread));
    }
    return threads;
}

}  // namespace ncsim::simulation
