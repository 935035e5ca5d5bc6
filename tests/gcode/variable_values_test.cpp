// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of system variables: what blocks set, the variables show, each axis and system on its own.
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace ncsim::gcode {
namespace {

constexpr std::string_view kAxes = "XYZABCUVW";

/// Returns the value of an expression behind `blocks`, read as the time of a dwell.
double value_after(const std::string& blocks, const std::string& expression, Dialect dialect) {
    constexpr double kAbove = 10'000.0;  // A dwell is not negative.
    InterpreterOptions options;
    options.dialect = dialect;
    options.work_offsets_specified.fill(true);
    options.work_offsets = {};
    ToolTableEntry tool;
    tool.number = 7;
    tool.length_specified = true;
    tool.diameter = Length::from_mm(12.0);
    for (std::size_t i = 0; i < 3; ++i)
        tool.offset[i] = Length::from_mm(70.0 + static_cast<double>(i));
    options.tools.push_back(tool);
    double seconds = std::numeric_limits<double>::quiet_NaN();
    const std::string word = dialect == Dialect::Fanuc ? "X" : "P";
    const Interpretation made =
        interpret({"t.nc", "G21 G90 G17 G94 F100\nG0 X0 Y0 Z0 A0 B0 C0 U0 V0 W0\n" + blocks +
                               "\nG4 " + word + "[" + expression + "+10000]\nM2\n"},
                  options, [&](const Motion& motion) {
                      if (const auto* const dwell = std::get_if<Dwell>(&motion.action))
                          seconds = dwell->seconds;
                  });
    EXPECT_FALSE(has_errors(made.diagnostics)) << blocks << ' ' << expression;
    return seconds - kAbove;
}

void expect_value(const std::string& blocks, int number, double value,
                  Dialect dialect = Dialect::Rs274) {
    EXPECT_NEAR(value_after(blocks, "#" + std::to_string(number), dialect), value, 1e-9)
        << blocks << " #" << number;
}

/// "X<first> Y<first + 1> …" for the first `count` axes.
std::string words(int first, std::size_t count = kAxes.size()) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += kAxes[i] + std::to_string(first + static_cast<int>(i)) + ' ';
    return text;
}

TEST(VariableValues, OffsetsOfEachSystemAndAxis) {
    std::string set;
    for (int system = 1; system <= 9; ++system)
        set += "G10 L2 P" + std::to_string(system) + ' ' + words(100 * system) + "R" +
               std::to_string(system) + '\n';
    for (int system = 1; system <= 9; ++system) {
        const int first = 5221 + 20 * (system - 1);
        for (int axis = 0; axis < 9; ++axis)
            expect_value(set, first + axis, 100 * system + axis);
        expect_value(set, first + 9, system);
        expect_value(set + (system <= 6 ? "G" + std::to_string(53 + system)
                                        : "G59." + std::to_string(system - 6)),
                     5220, system);
        // A written variable sets the offset, too.
        for (int axis = 0; axis < 9; ++axis)
            expect_value("#" + std::to_string(first + axis) + "=4", first + axis, 4);
    }
}

TEST(VariableValues, OffsetsOfG92HomesAndProbes) {
    const std::string move = "G1 " + words(11) + '\n';
    for (int axis = 0; axis < 9; ++axis) {
        // G92 at X11 Y12 … names the place X1 Y1 …: the offset is 10, 11, ….
        const std::string ones = "G92 X1 Y1 Z1 A1 B1 C1 U1 V1 W1";
        expect_value(move + ones, 5211 + axis, 10 + axis);
        expect_value(move + "G28.1\nG0 X0 Y0", 5161 + axis, 11 + axis);
        expect_value(move + "G30.1\nG0 X0 Y0", 5181 + axis, 11 + axis);
        expect_value(move, 5420 + axis, 11 + axis);
    }
    expect_value(move + "G92 X1", 5210, 1);
    expect_value(move + "G92 X1\nG92.2", 5210, 0);
    expect_value(move + "G92 X1\nG92.2", 5211, 10);
    expect_value(move + "G92 X1\nG92.1", 5211, 0);
    expect_value(move + "G92 X1\nG92.2\nG92.3", 5210, 1);
    for (int axis = 0; axis < 3; ++axis)
        expect_value("G38.2 X5 Y6 Z-7 F50", 5061 + axis, axis == 0 ? 5 : axis == 1 ? 6 : -7);
}

TEST(VariableValues, DataOfTheTool) {
    expect_value("T7 M6", 5400, 7);
    for (int axis = 0; axis < 3; ++axis)
        expect_value("T7 M6\nG43", 5401 + axis, 70 + axis);
    expect_value("T7 M6\nG43\nG49", 5403, 0);
    expect_value("T7 M6\nG41 G1 X50", 5410, 12);
}

TEST(VariableValues, PositionsAndModesOfFanuc) {
    const std::string place = "G10 L2 P1 X100. Y200. Z300.\nG54 G1 X1. Y2. Z3.\n";
    for (int axis = 0; axis < 3; ++axis) {
        expect_value(place, 5001 + axis, 1 + axis, Dialect::Fanuc);
        expect_value(place, 5041 + axis, 1 + axis, Dialect::Fanuc);
        expect_value(place, 5021 + axis, 101 + 101 * axis, Dialect::Fanuc);
        expect_value("G10 L2 P0 X5. Y6. Z7.\n", 5201 + axis, 5 + axis, Dialect::Fanuc);
    }
    struct Row {
        const char* blocks;
        int number;
        double value;
    };
    for (const Row& row :
         {Row{"G1 X1.", 4001, 1}, Row{"G0 X1.", 4001, 0}, Row{"G3 X2. I1.", 4001, 3},
          Row{"G91", 4003, 91}, Row{"G90", 4003, 90}, Row{"G20", 4006, 20}, Row{"G21", 4006, 21},
          Row{"G57", 4014, 57}, Row{"F250.", 4109, 250}, Row{"F250.", 4009, 250},
          Row{"S1234", 4119, 1234}, Row{"T7 M6", 4120, 7}}) {
        expect_value(row.blocks, row.number, row.value, Dialect::Fanuc);
    }
}

TEST(VariableValues, NamedParametersOfLinuxCnc) {
    struct Row {
        const char* blocks;
        const char* name;
        double value;
    };
    for (const Row& row : {Row{"G1 X3", "_x", 3},
                           Row{"G1 Y4", "_y", 4},
                           Row{"G1 Z5", "_z", 5},
                           Row{"G1 A6", "_a", 6},
                           Row{"G1 V8", "_v", 8},
                           Row{"G10 L2 P1 X10\nG1 X3", "_abs_x", 13},
                           Row{"G92 Y4\nG1 Y6", "_abs_y", 2},
                           Row{"G21", "_metric", 1},
                           Row{"G20", "_metric", 0},
                           Row{"G20", "_imperial", 1},
                           Row{"G91", "_incremental", 1},
                           Row{"G91", "_absolute", 0},
                           Row{"F250", "_feed", 250},
                           Row{"S900", "_rpm", 900},
                           Row{"T7 M6", "_current_tool", 7},
                           Row{"T3", "_selected_tool", 3},
                           Row{"G1 X1", "_motion_mode", 10},
                           Row{"G2 X2 I1", "_motion_mode", 20},
                           Row{"G17", "_plane", 170},
                           Row{"G18", "_plane", 180},
                           Row{"G19", "_plane", 190},
                           Row{"G54", "_coord_system", 540},
                           Row{"G59", "_coord_system", 590},
                           Row{"G59.1", "_coord_system", 591},
                           Row{"G59.3", "_coord_system", 593},
                           Row{"G40", "_ccomp", 400},
                           Row{"T7 M6\nG41", "_ccomp", 410},
                           Row{"T7 M6\nG42", "_ccomp", 420},
                           Row{"G94", "_units_per_minute", 1},
                           Row{"G93", "_inverse_time", 1},
                           Row{"G95", "_units_per_rev", 1},
                           Row{"G93", "_units_per_minute", 0},
                           Row{"S9 M3", "_spindle_on", 1},
                           Row{"S9 M4", "_spindle_on", 1},
                           Row{"M5", "_spindle_on", 0},
                           Row{"S9 M3", "_spindle_cw", 1},
                           Row{"S9 M4", "_spindle_cw", 0},
                           Row{"G90.1", "_ijk_absolute_mode", 1},
                           Row{"G91.1", "_ijk_absolute_mode", 0},
                           Row{"G99", "_retract_r_plane", 1},
                           Row{"G98", "_retract_r_plane", 0},
                           Row{"G98", "_retract_old_z", 1},
                           Row{"G8", "_lathe_radius_mode", 1}}) {
        EXPECT_NEAR(value_after(row.blocks, "#<" + std::string(row.name) + ">", Dialect::Rs274),
                    row.value, 1e-9)
            << row.blocks << ' ' << row.name;
    }
}

}  // namespace
}  // namespace ncsim::gcode
