// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each combination of modes that shift or rotate coordinates, with each event that may disturb the
// modes. The expected positions follow from the formula of each mode, in the order in which a
// control applies the modes: G68, G92 or G52, coordinate system, tool length.
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

using Place = std::array<double, 3>;

constexpr double kLength = 7.0;              // of T1, mm
constexpr Place kG54{-100.0, -50.0, -30.0};  // mm, machine
constexpr Place kG55{-60.0, -20.0, -35.0};
constexpr Place kHome{0.0, 0.0, 0.0};

enum class Event { None, G55, G53, G28, Plane, Incremental, Arc, Dwell, ToolChange };

struct Modes {
    bool length = false, shift_92 = false, shift_52 = false, turned = false, inches = false;
    Event event = Event::None;
};

// Returns a length of `mm` in program units.
std::string value(const Modes& modes, double mm) {
    return std::to_string(modes.inches ? mm / 25.4 : mm);
}

std::string words(const Modes& modes, const Place& place) {
    return "X" + value(modes, place[0]) + " Y" + value(modes, place[1]) + " Z" +
           value(modes, place[2]);
}

constexpr Place kTarget{10.0, 20.0, -3.0}, kCentre{2.0, 3.0, 0.0}, kGiven{4.0, -6.0, 8.0};
constexpr double kAngle = 30.0;
constexpr Place kStart{1.0, 0.0, 0.0};  // position at the G92 block

std::string program(const Modes& modes) {
    std::string text = "G90 G17 G54 F100 S100 T1 M6 M3\n";
    text += modes.inches ? "G20\n" : "G21\n";
    text += "G0 X0 Y0 Z0\nG1 " + words(modes, kStart) + "\n";
    if (modes.shift_92) text += "G92 " + words(modes, kGiven) + "\n";
    if (modes.shift_52) text += "G52 " + words(modes, kGiven) + "\n";
    if (modes.length) text += "G43 H1\n";
    if (modes.event == Event::G55) text += "G55\n";
    if (modes.turned)
        text += "G68 X" + value(modes, kCentre[0]) + " Y" + value(modes, kCentre[1]) + " R" +
                std::to_string(kAngle) + "\n";
    switch (modes.event) {
        case Event::G53: text += "G53 G0 Z0\n"; break;
        case Event::G28: text += "G91 G28 Z0\nG90\n"; break;
        case Event::Plane: text += "G18\nG1 X" + value(modes, 5.0) + "\nG17\n"; break;
        case Event::Incremental: text += "G91\nG1 X" + value(modes, 5.0) + "\nG90\n"; break;
        case Event::Arc:
            text += "G2 X" + value(modes, 5.0) + " R" + value(modes, 90.0) + "\n";
            break;
        case Event::Dwell: text += "G4 P0.1\n"; break;
        case Event::ToolChange: text += "T1 M6\nM3\n"; break;
        default: break;
    }
    return text + "G1 " + words(modes, kTarget) + "\nM30\n";
}

// Returns the machine position of the tip for the target.
Place expected(const Modes& modes) {
    Place p = kTarget;
    if (modes.turned) {
        const double a = kAngle * std::numbers::pi / 180.0;
        const double x = p[0] - kCentre[0];
        const double y = p[1] - kCentre[1];
        p[0] = kCentre[0] + x * std::cos(a) - y * std::sin(a);
        p[1] = kCentre[1] + x * std::sin(a) + y * std::cos(a);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (modes.shift_92) p[i] += kStart[i] - kGiven[i];
        if (modes.shift_52) p[i] += kGiven[i];
        p[i] += (modes.event == Event::G55 ? kG55 : kG54)[i];
    }
    return p;
}

Position position(const Place& place) {
    Position p;
    p.x = Length::from_mm(place[0]);
    p.y = Length::from_mm(place[1]);
    p.z = Length::from_mm(place[2]);
    return p;
}

TEST(ModePairs, LeadToThePlacesOfTheirFormulas) {
    int count = 0;
    for (unsigned bits = 0; bits < 32; ++bits) {
        Modes modes;
        modes.length = (bits & 1U) != 0;
        modes.shift_92 = (bits & 2U) != 0;
        modes.shift_52 = (bits & 4U) != 0;
        modes.turned = (bits & 8U) != 0;
        modes.inches = (bits & 16U) != 0;
        if (modes.shift_92 && modes.shift_52) continue;  // both use the same offset
        for (const Event event :
             {Event::None, Event::G55, Event::G53, Event::G28, Event::Plane, Event::Incremental,
              Event::Arc, Event::Dwell, Event::ToolChange}) {
            modes.event = event;
            InterpreterOptions options;
            options.dialect = Dialect::Fanuc;
            options.work_offsets[0] = position(kG54);
            options.work_offsets[1] = position(kG55);
            options.work_offsets_specified[0] = options.work_offsets_specified[1] = true;
            options.homes[0] = position(kHome);
            options.start = {Length(), Length(), Length()};
            options.tools.push_back({.number = 1,
                                     .offset = {Length(), Length(), Length::from_mm(kLength)},
                                     .length_specified = true,
                                     .diameter = Length::from_mm(4.0)});
            Position last;
            std::vector<double> machine_z;  // of positions in machine coordinates
            const std::string text = program(modes);
            SCOPED_TRACE(text);
            const Interpretation made =
                interpret({"t.nc", text}, options, [&](const Motion& motion) {
                    const Position* end = end_of(motion);
                    if (!end) return;
                    last = *end;
                    if (motion.machine_coordinates)
                        machine_z.push_back(end->z.mm() + kG54[2] + (modes.length ? kLength : 0.0));
                });
            ASSERT_FALSE(has_errors(made.diagnostics));
            // The first cut was in G54, so W is G54, and motions are of the tip.
            const Place wanted = expected(modes);
            EXPECT_NEAR(last.x.mm() + kG54[0], wanted[0], 2e-4);
            EXPECT_NEAR(last.y.mm() + kG54[1], wanted[1], 2e-4);
            EXPECT_NEAR(last.z.mm() + kG54[2], wanted[2], 2e-4);
            if (event == Event::G53 || event == Event::G28) {
                ASSERT_EQ(machine_z.size(), 1U);
                EXPECT_NEAR(machine_z[0], 0.0, 2e-4);
            }
            ++count;
        }
    }
    EXPECT_EQ(count, 24 * 9);
}

}  // namespace
}  // namespace ncsim::gcode
