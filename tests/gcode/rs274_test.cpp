// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs with the motions that LinuxCNC's stand-alone interpreter made
// (rs274_programs.txt, written by tests/nightly/rs274/compare.py), and programs that the
// interpreter refuses or accepts (rs274_refusals.txt, by refusals.py).
#include "ncsim/base/angles.h"
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Event {
    std::string kind;
    std::vector<double> values;  ///< X, Y, Z, A; for an arc also centre and turns; for a dwell s.
};

struct Recorded {
    std::string name, text;
    std::vector<Event> events;
    bool is_refused = false;
};

std::vector<Recorded> recorded_programs(const std::string& file) {
    std::ifstream in(std::string(NCSIM_SOURCE_DIR) + "/tests/gcode/" + file);
    std::vector<Recorded> all;
    bool in_text = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) {
            if (!in_text) continue;
        }
        if (line.starts_with("== ")) {
            all.push_back({.name = line.substr(3), .text = {}, .events = {}});
            in_text = true;
        } else if (line == "--") {
            in_text = false;
        } else if (in_text) {
            all.back().text += line + '\n';
        } else if (line == "refused") {
            all.back().is_refused = true;
        } else if (!all.empty()) {
            std::istringstream words(line);
            Event event;
            words >> event.kind;
            for (double value = 0.0; words >> value;)
                event.values.push_back(value);
            all.back().events.push_back(std::move(event));
        }
    }
    return all;
}

std::vector<double> numbers_of(const Position& p) {
    return {p.x.mm(), p.y.mm(), p.z.mm(), p.a.degrees()};
}

/// Returns the events without straight moves of length zero, as in the recorded motions.
std::vector<Event> events_of(const Recorded& program, bool& has_errors) {
    InterpreterOptions options;
    options.strict = true;
    options.work_offsets_specified.fill(true);
    for (auto& start : options.start)
        start = Length();
    const double diameters[] = {6.0, 5.0, 10.0};
    const double lengths[] = {38.1, 50.8, 12.7};
    for (int i = 0; i < 3; ++i) {
        ToolTableEntry tool;
        tool.number = i + 1;
        tool.offset[0] = Length::from_mm(i == 2 ? 2.54 : 0.0);
        tool.offset[2] = Length::from_mm(lengths[i]);
        tool.length_specified = true;
        tool.diameter = Length::from_mm(diameters[i]);
        options.tools.push_back(tool);
    }
    std::vector<Event> events;
    std::vector<bool> in_xy;
    const Interpretation result =
        interpret({"p.ngc", program.text}, options, [&](const Motion& motion) {
            in_xy.push_back(false);
            if (const auto* line = std::get_if<Linear>(&motion.action)) {
                events.push_back(
                    {motion.kind == MoveKind::Rapid ? "rapid" : "feed", numbers_of(line->to)});
            } else if (const auto* arc = std::get_if<Arc>(&motion.action)) {
                events.push_back({"arc", numbers_of(arc->to)});
                for (const double value :
                     {arc->centre_1.mm(), arc->centre_2.mm(), static_cast<double>(arc->turns)})
                    events.back().values.push_back(value);
                in_xy.back() = arc->plane == Plane::XY;
            } else if (const auto* spline = std::get_if<Spline>(&motion.action)) {
                events.push_back({"spline", numbers_of(spline->to)});
            } else if (const auto* dwell = std::get_if<Dwell>(&motion.action)) {
                events.push_back({"dwell", {dwell->seconds}});
            } else {
                in_xy.pop_back();
            }
        });
    has_errors = gcode::has_errors(result.diagnostics);
    std::vector<Event> out;
    std::vector<double> at{0.0, 0.0, 0.0, 0.0};
    const WorkOffset& zero = result.workpiece;
    for (std::size_t i = 0; i < events.size(); ++i) {
        Event event = events[i];
        if (event.kind != "dwell") {
            rotate(event.values[0], event.values[1], zero.rotation);
            for (std::size_t axis = 0; axis < 4; ++axis)
                event.values[axis] += zero.origin[axis];
            if (in_xy[i]) {
                rotate(event.values[4], event.values[5], zero.rotation);
                event.values[4] += zero.origin[kX];
                event.values[5] += zero.origin[kY];
            } else if (event.kind == "arc") {
                event.values.resize(4);
            }
            bool rests = !at.empty() && (event.kind == "rapid" || event.kind == "feed");
            for (std::size_t axis = 0; rests && axis < 4; ++axis)
                rests = std::abs(event.values[axis] - at[axis]) < 2e-4;
            if (rests) continue;
            at = event.values;
            if (event.kind == "spline") at.clear();
        }
        out.push_back(event);
    }
    return out;
}

std::string text_of(const Event& event) {
    std::ostringstream out;
    out << event.kind;
    for (const double value : event.values)
        out << ' ' << value;
    return out.str();
}

/// rs274 prints four digits, also for inches.
bool is_same(const Event& ours, const Event& theirs) {
    constexpr double kRounding = 0.007;
    if (ours.kind != theirs.kind) return false;
    if (ours.kind == "spline") return true;
    for (std::size_t i = 0; i < std::min(ours.values.size(), theirs.values.size()); ++i) {
        if (std::abs(ours.values[i] - theirs.values[i]) > kRounding) return false;
    }
    return true;
}

TEST(Rs274, MakesTheSameMotionsOfRandomPrograms) {
    const std::vector<Recorded> programs = recorded_programs("rs274_programs.txt");
    ASSERT_GE(programs.size(), 300U);
    for (const Recorded& program : programs) {
        bool has_errors = false;
        const std::vector<Event> ours = events_of(program, has_errors);
        EXPECT_EQ(has_errors, program.is_refused) << program.name << '\n' << program.text;
        std::size_t count = std::max(ours.size(), program.events.size());
        if (program.is_refused) count = std::min(ours.size(), program.events.size());
        for (std::size_t i = 0; i < count; ++i) {
            const std::string a = i < ours.size() ? text_of(ours[i]) : "nothing";
            const bool is_there = i < ours.size() && i < program.events.size();
            if (is_there && is_same(ours[i], program.events[i])) continue;
            ADD_FAILURE() << program.name << ", motion " << i << ": " << a << " and not "
                          << (i < program.events.size() ? text_of(program.events[i]) : "nothing")
                          << '\n'
                          << program.text;
            break;
        }
    }
}

TEST(Rs274, RefusesTheSamePrograms) {
    const std::vector<Recorded> programs = recorded_programs("rs274_refusals.txt");
    ASSERT_GE(programs.size(), 390U);
    for (const Recorded& program : programs) {
        bool has_errors = false;
        events_of(program, has_errors);
        EXPECT_EQ(has_errors, program.is_refused) << program.name << '\n' << program.text;
    }
}

}  // namespace
}  // namespace ncsim::gcode
