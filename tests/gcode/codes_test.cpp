// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each code, and each situation in which controls differ, as a line: the block and the resulting
// motions. Codes of messages follow "!".
#include "control/codes.h"

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

enum class By : unsigned char { Default, Strict, Fanuc, Haas, Grbl, Unspecified };

struct Case {
    const char* what;
    By by;
    const char* program;  // '~' is a line end
    const char* made;
};

// Runs the block between a start at the origin (metric, F100) and an end; returns the motions in
// order.
std::string made_of(const Case& c) {
    std::string text = std::string("G21 G90 G17 F100\nG0 X0 Y0 Z0\n") + c.program + "\nM2\n";
    std::ranges::replace(text, '~', '\n');
    InterpreterOptions options;
    options.strict = c.by == By::Strict;
    options.dialect = c.by == By::Fanuc  ? Dialect::Fanuc
                      : c.by == By::Haas ? Dialect::Haas
                      : c.by == By::Grbl ? Dialect::Grbl
                                         : Dialect::Rs274;
    options.limits.repeated_blocks = 20;
    options.limits.call_depth = 5;
    options.work_offsets[0].z = Length::from_mm(-300);  // home is above the part
    options.work_offsets_specified.fill(c.by != By::Unspecified);
    if (c.by == By::Unspecified) options.work_offsets.fill(options.work_offsets[0]);
    ToolTableEntry tool;
    tool.number = 1;
    tool.offset[2] = Length::from_mm(50);
    tool.diameter = Length::from_mm(4);
    options.tools = {tool};
    std::string out;
    std::size_t motions = 0;
    const Interpretation result = interpret({"t.nc", text}, options, [&](const Motion& motion) {
        if (++motions == 1) return;  // the start
        if (motions > 12) return;
        std::string line;
        print(line, motion);
        line.erase(0, line.find(' ') + 1);
        out.append(out.empty() ? "" : "; ").append(line);
    });
    std::vector<std::string> said;
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity != Severity::Note) {
            said.push_back((d.severity == Severity::Error ? "error " : "") + d.code);
        }
    }
    for (const std::string& s : said)
        out.append(" ! ").append(s);
    return out;
}

void expect_all(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
        SCOPED_TRACE(std::string(c.what) + ": " + c.program);
        EXPECT_EQ(made_of(c), c.made);
    }
}

const std::vector<Case>& codes() {
    static const std::vector<Case> kCases = {
        {"G0", By::Default, "G0 X1 Y2 Z3", "rapid X1 Y2 Z3"},
        {"G1", By::Default, "G1 X1 Y2 Z-1", "feed X1 Y2 Z-1 F100"},
        {"G2", By::Default, "G2 X10 I5", "arc XY X10 Y0 Z0 centre 5 0 turns -1 F100"},
        {"G2", By::Default, "G2 I5", "arc XY X0 Y0 Z0 centre 5 0 turns -1 F100"},
        {"G2", By::Default, "G2 X10 R5", "arc XY X10 Y0 Z0 centre 5 0 turns -1 F100"},
        {"G2", By::Default, "G2 X10 R-8", "arc XY X10 Y0 Z0 centre 5 6.244997998 turns -1 F100"},
        {"G2", By::Default, "G2 I5 Z-3 P3", "arc XY X0 Y0 Z-3 centre 5 0 turns -3 F100"},
        {"G3", By::Default, "G3 X10 Y10 J10", "arc XY X10 Y10 Z0 centre 0 10 turns 1 F100"},
        {"G4", By::Default, "G4 P1.5", "dwell 1.5"},
        {"G4", By::Fanuc, "G4 P1500", "dwell 1.5"},
        {"G4", By::Fanuc, "G4 P1.5", "dwell 1.5"},
        {"G4", By::Fanuc, "G4 X1.5", "dwell 1.5"},
        // The S of a dwell is neither a spindle speed (Marlin, RepRapFirmware) nor a feed.
        {"G4", By::Default, "S500 M3~G4 S3~G1 X1", "dwell 3; feed X1 Y0 Z0 F100 S500"},
        {"G4", By::Default, "G4 F2~G1 X1", "dwell 2; feed X1 Y0 Z0 F100"},
        {"G4", By::Default, "G4 P2 F50~G1 X1", "dwell 2; feed X1 Y0 Z0 F50"},
        {"G5", By::Default, "G5 X10 Y0 I0 J3 P0 Q-3",
         "spline X10 Y0 Z0 order 4 [0 0 *1] [0 3 *1] [10 -3 *1] [10 0 *1] F100"},
        {"G5", By::Default, "G1 X1~G5 X10 Y0 I0 J3 P0 Q-3~X12",
         "feed X1 Y0 Z0 F100; spline X10 Y0 Z0 order 4 [1 0 *1] [1 3 *1] [10 -3 *1] [10 0 *1] "
         "F100; "
         "feed X12 Y0 Z0 F100"},
        {"G5.1", By::Default, "G5.1 X10 I5 J5",
         "spline X10 Y0 Z0 order 3 [0 0 *1] [5 5 *1] [10 0 *1] F100"},
        {"G5.1", By::Fanuc, "G5.1 Q1", ""},
        {"G5.2", By::Default, "G5.2 X1 Y2 L3~X2 Y2~X2 Y0~G5.3",
         "spline X2 Y0 Z0 order 3 [0 0 *1] [1 2 *1] [2 2 *1] [2 0 *1] F100"},
        {"G5.3", By::Default, "G5.3", " ! error spline-not-open"},
        {"G6.2", By::Default, "G6.2 X0 Y0 R1 K0 P2~X5 Y5 K0~X10 Y0 K1~G6.2 K2~G6.2 K2",
         "spline X10 Y0 Z0 order 2 [0 0 *1] [5 5 *1] [10 0 *1] F100"},
        {"G6.2", By::Default, "G6.2 X0 Y0 K0 P2~G1 X5", " ! error spline-knots"},
        {"G6.2", By::Default, "G6.2 X0 Y0 K1 P2~X5 K0", " ! error spline-knots"},
        {"G7", By::Strict, "G7 X10~G0 X10", "rapid X5 Y0 Z0; rapid X5 Y0 Z0"},
        {"G8", By::Strict, "G8~G0 X10", "rapid X10 Y0 Z0"},
        {"G9", By::Default, "G9 G1 X10", "feed X10 Y0 Z0 F100"},
        {"G10", By::Default, "G10 L2 P1 X10~G0 X0", "rapid X10 Y0 Z0"},
        {"G10", By::Default, "G10 L2 P2 X5 Y5~G55 G0 X0 Y0", "rapid X5 Y5 Z0"},
        {"G10", By::Default, "G10 L20 P1 X100~G0 X100", "rapid X0 Y0 Z0"},
        {"G10", By::Fanuc, "G10 L20 P3 X7 Y0 Z-300~G54.1 P3~G0 X0", "rapid X7 Y0 Z0"},
        {"G10", By::Fanuc, "G10 L20 P3 X7~G54.1 P3~G0 X0",
         "rapid X0 Y0 Z0 ! offset-unknown ! offset-unknown"},
        {"G10", By::Default, "G10 L1 P1 R3 Z5", ""},
        {"G10", By::Default, "G10 L7 P1", " ! error g10-form"},
        {"G11", By::Fanuc, "G11~G0 X1", "rapid X1 Y0 Z0"},
        {"G12", By::Haas, "T1 M6~G12 I5 Z-1 D1 F50.",
         "tool 1 at X0 Y0 Z0; feed X0 Y0 Z-1 F50 T1; arc XY X3 Y0 Z-1 centre 1.5 0 turns -1 F50 "
         "T1; arc XY X3 Y0 Z-1 centre 0 0 turns -1 F50 T1; arc XY X0 Y0 Z-1 centre 1.5 0 turns -1 "
         "F50 T1"},
        {"G12", By::Fanuc, "G12 X7 I5. Z-1 D0",
         "rapid X7 Y0 Z0; feed X7 Y0 Z-1 F100; arc XY X12 Y0 Z-1 centre 9.5 0 turns -1 F100; arc "
         "XY X12 Y0 Z-1 centre 7 0 turns -1 F100; arc XY X7 Y0 Z-1 centre 9.5 0 turns -1 F100"},
        {"G12", By::Fanuc, "G12 I5. Z-1~X1", "rapid X1 Y0 Z0 ! error not-simulated"},
        {"G13", By::Haas, "T1 M6~G91 G13 I3. K5.5 Q2. Z-1. L2 D1 F50.",
         "tool 1 at X0 Y0 Z0; feed X0 Y0 Z-1 F50 T1; arc XY X1 Y0 Z-1 centre 0.5 0 turns 1 F50 T1; "
         "arc XY X1 Y0 Z-1 centre 0 0 turns 1 F50 T1; arc XY X-3 Y0 Z-1 centre -1 0 turns 1 F50 "
         "T1; arc XY X-3 Y0 Z-1 centre 0 0 turns 1 F50 T1; arc XY X3.5 Y0 Z-1 centre 0.25 0 turns "
         "1 F50 T1; arc XY X3.5 Y0 Z-1 centre 0 0 turns 1 F50 T1; arc XY X0 Y0 Z-1 centre 1.75 0 "
         "turns 1 F50 T1; feed X0 Y0 Z-2 F50 T1; arc XY X1 Y0 Z-2 centre 0.5 0 turns 1 F50 T1"},
        {"G13", By::Default, "G13 I5. Z-1 D1~X1", "rapid X1 Y0 Z0 ! error not-simulated"},
        {"G15", By::Default, "G15~G0 X1", "rapid X1 Y0 Z0"},
        {"G16", By::Default, "G16~G0 X10 Y90~G15", "rapid X0 Y10 Z0"},
        {"G17", By::Default, "G17 G2 X2 I1", "arc XY X2 Y0 Z0 centre 1 0 turns -1 F100"},
        {"G17.1", By::Strict, "G17.1~G0 X1", "rapid X1 Y0 Z0"},
        {"G18", By::Default, "G18 G2 X2 I1", "arc ZX X2 Y0 Z0 centre 0 1 turns -1 F100"},
        {"G18.1", By::Strict, "G18.1~G0 X1", "rapid X1 Y0 Z0"},
        {"G19", By::Default, "G19 G2 Y2 J1", "arc YZ X0 Y2 Z0 centre 1 0 turns -1 F100"},
        {"G19.1", By::Strict, "G19.1~G0 X1", "rapid X1 Y0 Z0"},
        {"G20", By::Default, "G20 G0 X1", "rapid X25.4 Y0 Z0"},
        {"G20", By::Default, "G1 X25.4~G20~X2", "feed X25.4 Y0 Z0 F100; feed X50.8 Y0 Z0 F100"},
        {"G21", By::Default, "G21 G0 X1", "rapid X1 Y0 Z0"},
        {"G28", By::Default, "G28 G91 Z0", "rapid X0 Y0 Z0; rapid X0 Y0 Z300 machine"},
        {"G28", By::Default, "G28", "rapid X0 Y0 Z0; rapid X0 Y0 Z300 machine"},
        {"G28", By::Default, "G90 G28 Z5", "rapid X0 Y0 Z5; rapid X0 Y0 Z300 machine"},
        {"G28.1", By::Strict, "G28.1~G0 X5~G28",
         "rapid X5 Y0 Z0; rapid X5 Y0 Z0; rapid X0 Y0 Z0 machine"},
        {"G28.2", By::Default, "G28.2 X0 Y0 Z0",
         "rapid X0 Y0 Z300 machine; rapid X0 Y0 Z300 machine"},
        {"G28.3", By::Default, "G0 X5~G28.3 X0~X1", "rapid X5 Y0 Z0; rapid X6 Y0 Z0"},
        {"G29", By::Fanuc, "G28 X1 Z9~G29 X2 Z3",
         "rapid X1 Y0 Z9; rapid X0 Y0 Z300 machine; rapid X1 Y0 Z9; rapid X2 Y0 Z3"},
        {"G29", By::Fanuc, "G29 X1", "rapid X1 Y0 Z0"},
        {"G30", By::Default, "G30 X1", "rapid X1 Y0 Z0; rapid X0 Y0 Z0 machine"},
        {"G30.1", By::Strict, "G0 X3~G30.1~G0 X9~G30",
         "rapid X3 Y0 Z0; rapid X9 Y0 Z0; rapid X9 Y0 Z0; rapid X3 Y0 Z0 machine"},
        {"G31", By::Fanuc, "G31 Z-5 F100", "probe X0 Y0 Z-5 F100"},
        {"G33", By::Strict, "M3 S500~G33 Z-5 K1", "feed X0 Y0 Z-5 F1/rev S500"},
        {"G33.1", By::Strict, "M3 S500~G33.1 Z-5 K1",
         "feed X0 Y0 Z-5 F1/rev S500; feed X0 Y0 Z0 F1/rev S500"},
        {"G38.2", By::Default, "G38.2 Z-5", "probe X0 Y0 Z-5 F100"},
        {"G38.3", By::Default, "G38.3 Z-5", "probe X0 Y0 Z-5 F100"},
        {"G38.4", By::Default, "G38.4 Z-5", "probe X0 Y0 Z-5 F100"},
        {"G38.5", By::Default, "G38.5 Z-5", "probe X0 Y0 Z-5 F100"},
        {"G40", By::Default, "G40 G1 X1", "feed X1 Y0 Z0 F100"},
        {"G41", By::Default, "T1 M6~G41 D1 G1 X10 Y10~X20~G40 X30",
         "tool 1 at X0 Y0 Z0; feed X8.585786438 Y11.414213562 Z0 F100 T1; arc XY X10 Y12 Z0 centre "
         "10 10 turns -1 F100 T1; feed X20 Y12 Z0 F100 T1; feed X30 Y10 Z0 F100 T1"},
        {"G41.1", By::Default, "G41.1 D2 G1 X10 Y10~X20~G40 X30",
         "feed X9.292893219 Y10.707106781 Z0 F100; arc XY X10 Y11 Z0 centre 10 10 turns -1 F100; "
         "feed X20 Y11 Z0 F100; feed X30 Y10 Z0 F100"},
        {"G42", By::Default, "T1 M6~G42 D1 G1 X10 Y10~X20~G40 X30",
         "tool 1 at X0 Y0 Z0; feed X10.828427125 Y8 Z0 F100 T1; feed X20 Y8 Z0 F100 T1; feed X30 "
         "Y10 Z0 F100 T1"},
        {"G42.1", By::Default, "G42.1 D2 G1 X10 Y10~X20~G40 X30",
         "feed X10.414213562 Y9 Z0 F100; feed X20 Y9 Z0 F100; feed X30 Y10 Z0 F100"},
        {"G43", By::Default, "T1 M6~G43 H1~G0 Z5", "tool 1 at X0 Y0 Z0; rapid X0 Y0 Z5 T1"},
        {"G43.1", By::Default, "G43.1 Z5~G0 Z5", "rapid X0 Y0 Z5"},
        {"G43.1", By::Default, "G43.1 X2~G43.1 Z7~G53 G0 X0 Z0", "rapid X-2 Y0 Z293 machine"},
        {"G43.2", By::Default, "G43 H1~G43.2 H1~G53 G0 Z0", "rapid X0 Y0 Z200 machine"},
        {"G43.4", By::Fanuc, "G43.4 H1", " ! error kinematics"},
        {"G43.5", By::Fanuc, "G43.5 H1", " ! error kinematics"},
        {"G44", By::Fanuc, "G44 H1~G0 Z5", "rapid X0 Y0 Z5"},
        {"G49", By::Default, "G43 H1~G49~G0 Z5", "rapid X0 Y0 Z5"},
        {"G50", By::Fanuc, "G51 X0 Y0 Z0 P2~G50~G0 X5", "rapid X5 Y0 Z0"},
        {"G50.1", By::Fanuc, "G51.1 X0~G50.1 X0~G0 X5", "rapid X5 Y0 Z0"},
        {"G51", By::Fanuc, "G51 X0 Y0 Z0 P2~G0 X5", "rapid X10 Y0 Z0"},
        {"G51.1", By::Fanuc, "G51.1 X0~G0 X5", "rapid X-5 Y0 Z0"},
        {"G52", By::Default, "G52 X10~G0 X1", "rapid X11 Y0 Z0"},
        {"G53", By::Default, "G53 G0 Z0", "rapid X0 Y0 Z300 machine"},
        {"G54", By::Default, "G54 G0 X1", "rapid X1 Y0 Z0"},
        {"G54.1", By::Fanuc, "G54.1 P2 G0 X1", "rapid X1 Y0 Z0 ! offset-unknown ! offset-unknown"},
        {"G54.1", By::Fanuc, "G54.1 G0 X1", " ! error offset-number"},
        {"G110", By::Haas, "G10 L20 P1 X5 Y0 Z-300~G110 G0 X1", "rapid X6 Y0 Z0"},
        {"G129", By::Haas, "G10 L20 P20 X5 Y0 Z-300~G129 G0 X1", "rapid X6 Y0 Z0"},
        {"G110", By::Fanuc, "G110~G0 X1", "rapid X1 Y0 Z0 ! error unknown-g"},
        {"G55", By::Default, "G10 L2 P2 X5~G55 G0 X1", "rapid X6 Y0 Z0"},
        {"G56", By::Default, "G10 L2 P3 X5~G56 G0 X1", "rapid X6 Y0 Z0"},
        {"G57", By::Default, "G10 L2 P4 X5~G57 G0 X1", "rapid X6 Y0 Z0"},
        {"G58", By::Default, "G10 L2 P5 X5~G58 G0 X1", "rapid X6 Y0 Z0"},
        {"G59", By::Default, "G10 L2 P6 X5~G59 G0 X1", "rapid X6 Y0 Z0"},
        {"G59.1", By::Default, "G10 L2 P7 X5~G59.1 G0 X1", "rapid X6 Y0 Z0"},
        {"G59.2", By::Default, "G10 L2 P8 X5~G59.2 G0 X1", "rapid X6 Y0 Z0"},
        {"G59.3", By::Default, "G10 L2 P9 X5~G59.3 G0 X1", "rapid X6 Y0 Z0"},
        {"G60", By::Fanuc, "G60 X1", "rapid X1 Y0 Z0"},
        {"G61", By::Default, "G61 G1 X1", "feed X1 Y0 Z0 F100"},
        {"G61.1", By::Default, "G61.1 G1 X1", "feed X1 Y0 Z0 F100"},
        {"G62", By::Fanuc, "G62 G1 X1", "feed X1 Y0 Z0 F100"},
        {"G63", By::Fanuc, "G63 G1 X1", "feed X1 Y0 Z0 F100"},
        {"G64", By::Default, "G64 P0.01 G1 X1", "feed X1 Y0 Z0 F100"},
        {"G65", By::Fanuc, "G65 P9 A1", " ! error sub-not-found"},
        {"G66", By::Fanuc, "G66 P9 A1~X1", "rapid X1 Y0 Z0 ! error sub-not-found"},
        {"G67", By::Fanuc, "G67~G0 X1", "rapid X1 Y0 Z0"},
        {"G68", By::Fanuc, "G68 X0 Y0 R90~G0 X1", "rapid X0 Y1 Z0"},
        {"G68.2", By::Fanuc, "G68.2 X0 Y0 Z0 I0 J30 K0", " ! error kinematics"},
        {"G68.3", By::Fanuc, "G68.3 X0", " ! error kinematics"},
        {"G68.4", By::Fanuc, "G68.4 I5", " ! error kinematics"},
        {"G268", By::Fanuc, "G268 I5", " ! error kinematics"},
        {"G269", By::Haas, "G269~G1 X1", "feed X1 Y0 Z0 F100"},
        {"G7.1", By::Fanuc, "G7.1 C25~G1 X1", "feed X1 Y0 Z0 F100"},
        {"G107", By::Fanuc, "G107 C25~G1 X1", "feed X1 Y0 Z0 F100"},
        {"G12.1", By::Fanuc, "G12.1~G1 X1 C2", "feed X1 Y2 Z0 F100"},
        {"G112", By::Haas, "G112~G1 X1 Y2", "feed X1 Y2 Z0 F100"},
        {"G13.1", By::Fanuc, "G13.1~G1 X1", "feed X1 Y0 Z0 F100"},
        {"G113", By::Haas, "G113~G1 X1", "feed X1 Y0 Z0 F100"},
        {"G254", By::Haas, "G254", " ! error kinematics"},
        {"G54.4", By::Fanuc, "G54.4 P1", " ! error kinematics"},
        {"G54.2", By::Fanuc, "G54.2 P1", " ! error kinematics"},
        {"G255", By::Haas, "G255~G1 X1", "feed X1 Y0 Z0 F100"},
        {"G53.1", By::Fanuc, "G53.1", " ! error kinematics"},
        {"G53.3", By::Fanuc, "G53.3 X1", " ! error kinematics"},
        {"G53.6", By::Fanuc, "G53.6", " ! error kinematics"},
        {"G69", By::Fanuc, "G68 X0 Y0 R90~G69~G0 X1", "rapid X1 Y0 Z0"},
        {"G70", By::Default, "G70~G0 X1", "rapid X25.4 Y0 Z0"},
        {"G70", By::Haas, "G99 G81 Z-1 R1 L0~G70 X10. Y20. I5. J90. L3~G80",
         "rapid X0 Y0 Z1; rapid X10 Y25 Z1; feed X10 Y25 Z-1 F100; rapid X10 Y25 Z1; rapid "
         "X5.669872981 Y17.5 Z1; feed X5.669872981 Y17.5 Z-1 F100; rapid X5.669872981 Y17.5 Z1; "
         "rapid X14.330127019 Y17.5 Z1; feed X14.330127019 Y17.5 Z-1 F100; rapid X14.330127019 "
         "Y17.5 Z1"},
        {"G70", By::Fanuc, "G0 Z3~G98 G81 G70 Z-1 R1 I-5. J90. L2",
         "rapid X0 Y0 Z3; rapid X0 Y5 Z3; rapid X0 Y5 Z1; feed X0 Y5 Z-1 F100; rapid X0 Y5 Z3; "
         "rapid X0 Y-5 Z3; rapid X0 Y-5 Z1; feed X0 Y-5 Z-1 F100; rapid X0 Y-5 Z3"},
        {"G70", By::Fanuc, "G81 Z-1 R1 K0~G70 I20. L6~G80~G0 X1",
         "rapid X1 Y0 Z0 ! error not-simulated"},
        {"G70", By::Default, "G70 I20. J0. L6~G0 X1", "rapid X1 Y0 Z0 ! error not-simulated"},
        {"G70", By::Fanuc, "G70~G0 X1", "rapid X1 Y0 Z0 ! error not-simulated"},
        {"G71", By::Haas, "G99 G81 Z-1 R1 L0~G71 I10. J30. K60. L2",
         "rapid X0 Y0 Z1; rapid X8.660254038 Y5 Z1; feed X8.660254038 Y5 Z-1 F100; rapid "
         "X8.660254038 Y5 Z1; rapid X0 Y10 Z1; feed X0 Y10 Z-1 F100; rapid X0 Y10 Z1"},
        {"G71", By::Haas, "G99 G81 Z-1 R1 L0~G71 I10. J0. K-90. L2",
         "rapid X0 Y0 Z1; rapid X10 Y0 Z1; feed X10 Y0 Z-1 F100; rapid X10 Y0 Z1; rapid X0 Y-10 "
         "Z1; feed X0 Y-10 Z-1 F100; rapid X0 Y-10 Z1"},
        {"G72", By::Haas, "G99 G81 Z-1 R1 L0~G91 G72 X1. Y1. I4. J90. L2",
         "rapid X0 Y0 Z1; rapid X1 Y1 Z1; feed X1 Y1 Z-1 F100; rapid X1 Y1 Z1; rapid X1 Y5 Z1; "
         "feed X1 Y5 Z-1 F100; rapid X1 Y5 Z1"},
        {"G70.1", By::Default, "G70.1 Q1", " ! error lathe-cycle"},
        {"G71", By::Default, "G71~G0 X1", "rapid X1 Y0 Z0"},
        {"G71.1", By::Default, "G71.1 Q1 X1", " ! error lathe-cycle"},
        {"G71.2", By::Default, "G71.2 Q1 X1", " ! error lathe-cycle"},
        {"G72", By::Default, "G72 Q1 X1", " ! error lathe-cycle"},
        {"G72.1", By::Default, "G72.1 Q1 X1", " ! error lathe-cycle"},
        {"G72.2", By::Default, "G72.2 Q1 X1", " ! error lathe-cycle"},
        {"G73", By::Default, "G73 X1 Z-2 R1 Q1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z0 F100; rapid X1 Y0 Z0.254; feed X1 Y0 Z-1 "
         "F100; rapid X1 Y0 Z-0.746; feed X1 Y0 Z-2 F100; rapid X1 Y0 Z1"},
        {"G74", By::Default, "G74 X1 Z-2 R1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-2 F100; dwell 0; feed X1 Y0 Z1 F100 S0"},
        {"G76", By::Fanuc, "G76 X1 Z-2 R1 Q0.1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-2 F100; rapid X1 Y0 Z1"},
        {"G80", By::Default, "G81 X1 Z-1 R1~G80~X5",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1; rapid X5 Y0 Z1 ! "
         "axes-after-g80"},
        {"G81", By::Default, "G81 X1 Z-1 R1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1"},
        {"G81", By::Default, "G99 G81 X1 Z-1 R1~X2",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1; rapid X2 Y0 Z1; "
         "feed X2 Y0 Z-1 F100; rapid X2 Y0 Z1"},
        {"G81", By::Default, "G81 X1 Z-1 R1 L2",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1; rapid X1 Y0 Z1; "
         "feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1"},
        {"G81", By::Fanuc, "G81 X1 Z-1 R1 K0~X2",
         "rapid X0 Y0 Z1; rapid X2 Y0 Z1; feed X2 Y0 Z-1 F100; rapid X2 Y0 Z1"},
        {"G82", By::Default, "G82 X1 Z-1 R1 P0.5",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; dwell 0.5; rapid X1 Y0 Z1"},
        {"G83", By::Default, "G83 X1 Z-2 R1 Q1.5",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-0.5 F100; rapid X1 Y0 Z1; rapid X1 Y0 "
         "Z-0.246; feed X1 Y0 Z-2 F100; rapid X1 Y0 Z1"},
        {"G84", By::Default, "M3 S100~G84 X1 Z-1 R1",
         "rapid X0 Y0 Z1 S100; rapid X1 Y0 Z1 S100; feed X1 Y0 Z-1 F100 S100; dwell 0; feed X1 Y0 "
         "Z1 F100 S-100"},
        {"G85", By::Default, "G85 X1 Z-1 R1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; feed X1 Y0 Z1 F100"},
        {"G86", By::Default, "G86 X1 Z-1 R1 P0",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; dwell 0; rapid X1 Y0 Z1"},
        {"G87", By::Default, "G87 X1 Z-1 R1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1"},
        {"G88", By::Default, "G88 X1 Z-1 R1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1"},
        {"G89", By::Default, "G89 X1 Z-1 R1 P0",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; dwell 0; feed X1 Y0 Z1 F100"},
        {"G90", By::Default, "G91~G90 G0 X1", "rapid X1 Y0 Z0"},
        {"G90.1", By::Default, "G90.1 G2 X2 I1 J0", "arc XY X2 Y0 Z0 centre 1 0 turns -1 F100"},
        {"G91", By::Default, "G91 G0 X1~X1", "rapid X1 Y0 Z0; rapid X2 Y0 Z0"},
        {"G91.1", By::Default, "G90.1~G91.1 G2 X2 I1", "arc XY X2 Y0 Z0 centre 1 0 turns -1 F100"},
        {"G92", By::Default, "G92 X10~G0 X11", "rapid X1 Y0 Z0"},
        {"G92.1", By::Default, "G92 X10~G92.1~G0 X1", "rapid X1 Y0 Z0"},
        {"G92.2", By::Default, "G92 X10~G92.2~G0 X1", "rapid X1 Y0 Z0"},
        {"G92.3", By::Default, "G92 X10~G92.2~G92.3~G0 X11", "rapid X1 Y0 Z0"},
        {"G92.4", By::Default, "G92.4 A0~G0 A10", "rapid X0 Y0 Z0 A10"},
        {"G93", By::Default, "G93 G1 X1 F10", "feed X1 Y0 Z0 F10/inverse-time"},
        {"G94", By::Default, "G94 G1 X1 F10", "feed X1 Y0 Z0 F10"},
        {"G95", By::Default, "G95 G1 X1 F0.1", "feed X1 Y0 Z0 F0.1/rev"},
        {"G96", By::Default, "G96 S200 M3~G1 X1", "feed X1 Y0 Z0 F100 S200"},
        {"G97", By::Default, "G97 S200 M3~G1 X1", "feed X1 Y0 Z0 F100 S200"},
        {"G98", By::Default, "G98 G81 X1 Z-1 R1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1"},
        {"G99", By::Default, "G99 G81 X1 Z-1 R1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1"},
        {"G154", By::Haas, "G154 P5 G0 X1", "rapid X1 Y0 Z0 ! offset-unknown ! offset-unknown"},
        {"G5", By::Fanuc, "G1 X1~G05 P10000~X2~G05 P0~X3",
         "feed X1 Y0 Z0 F100; feed X2 Y0 Z0 F100; feed X3 Y0 Z0 F100"},
        {"G5.1", By::Fanuc, "G1 X1~G5.1 Q1 X0 Y0 Z0~X2", "feed X1 Y0 Z0 F100; feed X2 Y0 Z0 F100"},
        {"G6.2", By::Fanuc, "G6.2 P2 K0 X0 Y0 R1~K0 X10 Y0~K1~K1",
         "spline X10 Y0 Z0 order 2 [0 0 *1] [10 0 *1] F100"},
    };
    return kCases;
}

TEST(Codes, DoWhatTheyDoOnAMachine) {
    expect_all(codes());
}

// Codes of a group that behave alike; a single case covers the group.
void expect_like_its_group(const std::string& name, Group group) {
    const std::string text = name + "~G1 X1";
    const std::string made = made_of({name.c_str(), By::Default, text.c_str(), ""});
    const std::string moves = "feed X1 Y0 Z0 F100";
    const std::set<std::string> expected =
        group == Group::Ignored        ? std::set<std::string>{moves}
        : group == Group::NotSimulated ? std::set<std::string>{moves + " ! error not-simulated"}
        : group == Group::Unsupported
            ? std::set<std::string>{" ! error tilted-plane", " ! error lathe-cycle",
                                    " ! error kinematics"}
            : std::set<std::string>{made};
    EXPECT_TRUE(expected.contains(made)) << made;
}

TEST(Codes, AreAllInTheTable) {
    std::set<std::string> tested;
    for (const Case& c : codes())
        tested.insert(c.what);
    const auto expect_tested = [&](Code code) {
        const GCode& entry = entry_of(code);
        const std::string name(name_of(code));
        SCOPED_TRACE(name);
        EXPECT_EQ(entry.code, code);
        EXPECT_EQ(find_g(tenths_of(code)), code);
        std::string number = "G";
        print_number(number, tenths_of(code) / 10.0);
        EXPECT_EQ(name, number);
        if (entry.availability == Availability::Haas) return;  // below
        expect_like_its_group(name, entry.group);
        const bool alike = entry.group == Group::Ignored || entry.group == Group::NotSimulated ||
                           entry.group == Group::Unsupported;
        EXPECT_TRUE(alike || tested.contains(name)) << name << " is not";
    };
#define NCSIM_G(name, group, takes_axes, letters, availability) expect_tested(Code::name);
#include "control/codes.def"
#undef NCSIM_G
}

TEST(Codes, OfHaasAloneAreOffsets) {
    // G110 … G129 are G154 P1 …, without P3 and P4.
    int count = 0;
    for (int number = 110; number < 130; ++number) {
        const Code code = find_g(number * 10);
        if (entry_of(code).availability != Availability::Haas) continue;
        ++count;
        SCOPED_TRACE(name_of(code));
        const std::string name(name_of(code));
        const std::string set = "G10 L20 P" + std::to_string(number - 109) + " X5~";
        const std::string by_name = set + name + " G0 X1";
        const std::string by_number = set + "G154 P" + std::to_string(number - 109) + " G0 X1";
        EXPECT_EQ(made_of({"", By::Haas, by_name.c_str(), ""}),
                  made_of({"", By::Haas, by_number.c_str(), ""}));
        EXPECT_EQ(made_of({"", By::Haas, by_name.c_str(), ""}).find("unknown-g"),
                  std::string::npos);
        EXPECT_EQ(made_of({"", By::Fanuc, name.c_str(), ""}), " ! error unknown-g");
    }
    EXPECT_EQ(count, 18);
}

TEST(Traps, AreNotSteppedInto) {
    expect_all({
        {"01 radius within tolerance", By::Strict, "G2 X10.02 I5",
         "arc XY X10.02 Y0 Z0 centre 5 0 turns -1 F100"},
        {"01 radius beyond tolerance", By::Strict, "G2 X10.3 I5", " ! error arc-radius-mismatch"},
        {"01 spiral", By::Default, "G2 X10.2 I5",
         "arc XY X10.2 Y0 Z0 centre 5 0 turns -1 F100 ! arc-spiral"},
        {"02 off-plane word", By::Strict, "G2 X10 I5 K0", " ! error centre-outside-plane"},
        {"02 off-plane word", By::Default, "G2 X10 I5 K0",
         "arc XY X10 Y0 Z0 centre 5 0 turns -1 F100"},
        {"02 radius and centre", By::Default, "G2 X10 I5 R5",
         "arc XY X10 Y0 Z0 centre 5 0 turns -1 F100 ! arc-two-forms"},
        {"02 no centre", By::Default, "G2 X10", " ! error arc-without-centre"},
        {"03 absolute centres without G90.1", By::Default,
         "G0 X50 Y50~G2 X60 Y50 I55 J50~G2 X50 Y50 I55 J50",
         "rapid X50 Y50 Z0; arc XY X60 Y50 Z0 centre 55 50 turns -1 F100; arc XY X50 Y50 Z0 centre "
         "55 50 turns -1 F100 ! arc-centre-mode"},
        {"04 full circle by I", By::Default, "G2 X0 Y0 I5",
         "arc XY X0 Y0 Z0 centre 5 0 turns -1 F100"},
        {"04 full circle by R", By::Default, "G2 X0 Y0 R5", " ! error arc-radius-no-chord"},
        {"05 half a chord beyond R", By::Strict, "G2 X10.002 R5",
         "arc XY X10.002 Y0 Z0 centre 5.001 0 turns -1 F100"},
        {"05 R does not reach", By::Default, "G2 X12 R5", " ! error arc-radius-too-small"},
        {"06 G18 is ZX", By::Strict, "G18 G2 X10 I5", "arc ZX X10 Y0 Z0 centre 0 5 turns -1 F100"},
        {"07 helix", By::Default, "G2 Z-1 I5", "arc XY X0 Y0 Z-1 centre 5 0 turns -1 F100"},
        {"07 zero radius", By::Default, "G2 X0.001 I0.0005",
         "feed X0.001 Y0 Z0 F100 ! arc-too-small"},
        {"08 two codes of a group", By::Strict, "G0 G1 X1", " ! error codes-exclude"},
        {"08 two codes of a group", By::Default, "G0 G1 X1", "feed X1 Y0 Z0 F100 ! codes-exclude"},
        {"08 a word twice", By::Default, "G0 X1 X2", "rapid X2 Y0 Z0 ! word-twice"},
        {"08 order of execution", By::Default, "G1 X10 G91 F50~X10",
         "feed X10 Y0 Z0 F50; feed X20 Y0 Z0 F50"},
        {"09 G0 beside G28", By::Strict, "G0 G91 G28 Z0", " ! error two-codes-use-axes"},
        {"09 G0 beside G28", By::Default, "G0 G91 G28 Z0",
         "rapid X0 Y0 Z0; rapid X0 Y0 Z300 machine"},
        {"10 axis words after G80", By::Strict, "G80~X15", " ! error axes-without-motion"},
        {"10 axis words after G80", By::Default, "G80~X15", "rapid X15 Y0 Z0 ! axes-after-g80"},
        {"11 G0 ends a cycle", By::Default, "G81 X1 Z-1 R1~G0 X5",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1; rapid X5 Y0 Z1"},
        {"12 after M2", By::Default, "M30~G0 X99", ""},
        {"12 text after percent", By::Default, "G0 X1~%~spare",
         "rapid X1 Y0 Z0 ! error number-expected"},
        {"13 blanks in words", By::Default, "G 0 X + 1 2 . 5", "rapid X12.5 Y0 Z0"},
        {"13 points", By::Default, "G0 X5. Y.5", "rapid X5 Y0.5 Z0"},
        {"13 lone point", By::Strict, "G0 X.", " ! error number-expected"},
        {"13 exponent", By::Strict, "G0 X1e-3", " ! error exponent"},
        {"13 nested comment", By::Strict, "G0 X1 (a (b) c)", " ! error comment-nested"},
        {"13 nested comment", By::Default, "G0 X1 (a (b) c)", "rapid X1 Y0 Z0 ! comment-nested"},
        {"13 open comment", By::Default, "G0 X1 (open", "rapid X1 Y0 Z0 ! comment-unclosed"},
        {"13 block delete", By::Default, "/G0 X1", "rapid X1 Y0 Z0"},
        {"14 numbers without a point", By::Fanuc, "G0 X12345", "rapid X12345 Y0 Z0"},
        {"G52 under G7 is a diameter", By::Default, "G7~G52 X3~G0 X7", "rapid X5 Y0 Z0"},
        {"G10 R under G92 turns the position of LinuxCNC", By::Default,
         "G92 X5~G10 L2 P1 R90~G0 X1 Y1", "rapid X-1 Y-4 Z0 ! rotation-under-g92"},
        {"G10 R without G92", By::Default, "G10 L2 P1 R90~G0 X1 Y2", "rapid X-2 Y1 Z0"},
        {"M73 restores no F after G93, which keeps it", By::Strict,
         "F90~o100 sub~M73~G93~o100 endsub~o100 call~G1 X4", " ! error feed-missing"},
        {"M73 restores the number of F", By::Default,
         "o100 sub~M73~F80~o100 endsub~F250~G20~o100 call~G1 X1", "feed X25.4 Y0 Z0 F6350"},
        {"15 G92 stays with G55", By::Default, "G92 X10~G55~G0 X0", "rapid X-10 Y0 Z0"},
        {"15 G92 keeps other axes", By::Default, "G92 X10~G92 Y5~G0 X0 Y0", "rapid X-10 Y-5 Z0"},
        {"15 G52 replaces G92", By::Default, "G92 X10~G52 X5~G0 X0", "rapid X5 Y0 Z0"},
        {"16 G53 is absolute", By::Strict, "G91 G53 G0 Z0", " ! error g53-incremental"},
        {"16 G53 is absolute", By::Default, "G91 G53 G0 Z0",
         "rapid X0 Y0 Z300 machine ! g53-incremental"},
        {"16 G53 sees tool lengths", By::Default, "G43.1 Z7~G53 G0 Z0", "rapid X0 Y0 Z293 machine"},
        {"17 G90 G28 Z0 goes to Z0 first", By::Default, "G0 Z50~G90 G28 Z0",
         "rapid X0 Y0 Z50; rapid X0 Y0 Z0; rapid X0 Y0 Z300 machine"},
        {"17 haas G28 cancels length", By::Haas, "G43 H1 Z10~G28 Z20~G0 Z10",
         "rapid X0 Y0 Z10; rapid X0 Y0 Z20; rapid X0 Y0 Z250 machine; rapid X0 Y0 Z10"},
        {"18 G10 L2 at once", By::Default, "G10 L2 P1 X10~G0 X0", "rapid X10 Y0 Z0"},
        {"18 before the first cut the part moves along", By::Default, "G10 L2 P1 X10~G1 X0",
         "feed X0 Y0 Z0 F100"},
        {"18 after it it does not", By::Default, "G1 X1~G10 L2 P1 X10~G1 X0",
         "feed X1 Y0 Z0 F100; feed X10 Y0 Z0 F100"},
        {"18 unspecified offset", By::Unspecified, "G1 X1~G55 G0 X3",
         "feed X1 Y0 Z0 F100; rapid X3 Y0 Z0 ! offset-unknown"},
        {"18 the system that it cuts in", By::Unspecified, "G55 G0 X3~G1 X4",
         "rapid X3 Y0 Z0; feed X4 Y0 Z0 F100 ! offset-unknown"},
        {"18 G10 with rotation", By::Default, "G10 L2 P1 R90~G0 X10", "rapid X0 Y10 Z0"},
        {"18 P0 is the active system", By::Default, "G55~G10 L2 P0 X3~G0 X0", "rapid X3 Y0 Z0"},
        {"19 units in mid-program", By::Default, "G1 X25.4 F254~G20~G1 X2",
         "feed X25.4 Y0 Z0 F254; feed X50.8 Y0 Z0 F254"},
        {"19 cycle words are not rescaled", By::Strict, "G81 X1 Z-1 R1~G20~X2",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1; rapid X1 Y0 Z25.4; "
         "rapid X50.8 Y0 Z25.4; feed X50.8 Y0 Z-25.4 F100; rapid X50.8 Y0 Z25.4"},
        {"20 G43 moves nothing", By::Default, "T1 M6~G43 H1~G0 X1",
         "tool 1 at X0 Y0 Z0; rapid X1 Y0 Z-50 T1"},
        {"20 T selects and M6 changes", By::Default, "T1~G0 X1~M6~G0 X2",
         "rapid X1 Y0 Z0; tool 1 at X1 Y0 Z0; rapid X2 Y0 Z0 T1"},
        {"20 M6 without T", By::Default, "M6~G0 X1", "rapid X1 Y0 Z0"},
        {"21 entry longer than the radius", By::Default, "T1 M6~G41 D1~G1 X1",
         "tool 1 at X0 Y0 Z0 ! error compensation-entry"},
        // Fanuc and Haas offset the tool perpendicular to the next move; the lead-in may be short,
        // and is straight.
        {"21 entry square to the next move", By::Fanuc, "T1 M6~G41 D1 G1 X10. Y0~Y20.~G40 X30.",
         "tool 1 at X0 Y0 Z0; feed X8 Y0 Z0 F100 T1; feed X8 Y20 Z0 F100 T1; "
         "feed X30 Y20 Z0 F100 T1"},
        {"21 entry square to itself", By::Default, "T1 M6~G41 D1 G1 X10 Y0~Y20~G40 X30",
         "tool 1 at X0 Y0 Z0; feed X8 Y2 Z0 F100 T1; feed X8 Y20 Z0 F100 T1; "
         "feed X30 Y20 Z0 F100 T1"},
        {"21 short entry", By::Haas, "T1 M6~G41 D1 G1 X1. Y0~G3 X1. Y20. J10.~G40 G1 X30.",
         "tool 1 at X0 Y0 Z0; feed X1 Y2 Z0 F100 T1; "
         "arc XY X1 Y18 Z0 centre 1 10 turns 1 F100 T1; feed X30 Y20 Z0 F100 T1"},
        // G40 alone takes effect at the next move in the plane.
        {"21 G40 alone", By::Haas, "T1 M6~G41 D1 G1 X1. Y0~G3 X1. Y20. J10.~G40~G0 Z5.~X30.",
         "tool 1 at X0 Y0 Z0; feed X1 Y2 Z0 F100 T1; "
         "arc XY X1 Y18 Z0 centre 1 10 turns 1 F100 T1; rapid X1 Y18 Z5 T1; rapid X30 Y20 Z5 T1"},
        {"21 G40 alone", By::Fanuc,
         "T1 M6~G41 D1 G1 X1. Y0~G3 X1. Y20. J10.~G40~G91 G1 X9.~G90 Y30.",
         "tool 1 at X0 Y0 Z0; feed X1 Y2 Z0 F100 T1; "
         "arc XY X1 Y18 Z0 centre 1 10 turns 1 F100 T1; feed X10 Y20 Z0 F100 T1; "
         "feed X10 Y30 Z0 F100 T1"},
        {"21 entry on an arc", By::Fanuc, "T1 M6~G41 D1 G2 X10. Y0 I5.",
         "tool 1 at X0 Y0 Z0 ! error compensation-entry"},
        // Codes that grbl 1.1 does not have.
        {"grbl", By::Grbl, "G81 X5 Y5 Z-3 R1", " ! error not-of-control"},
        {"grbl", By::Grbl, "G41 D1~G1 X1", "feed X1 Y0 Z0 F100 ! error not-of-control"},
        {"grbl", By::Grbl, "#1=3~G1 X#1", " ! error not-of-control"},
        {"grbl", By::Grbl, "M98 P5", " ! error not-of-control"},
        {"grbl", By::Grbl, "G38.2 Z-1", "probe X0 Y0 Z-1 F100"},
        {"21 twice", By::Strict, "T1 M6~G41 D1~G41 D1",
         "tool 1 at X0 Y0 Z0 ! error compensation-twice"},
        {"21 no diameter", By::Default, "G41 D9 G1 X10",
         "feed X10 Y0 Z0 F100 ! compensation-radius-unknown"},
        {"22 G98 keeps the first height", By::Default, "G0 Z5~G98 G81 X1 Z-1 R1~G99 X2~G98 X3",
         "rapid X0 Y0 Z5; rapid X1 Y0 Z5; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z5; "
         "rapid X2 Y0 Z5; rapid X2 Y0 Z1; feed X2 Y0 Z-1 F100; rapid X2 Y0 Z1; rapid X3 Y0 Z5; "
         "rapid X3 Y0 Z1"},
        {"22 below R", By::Default, "G0 Z-5~G81 X1 Z-10 R2",
         "rapid X0 Y0 Z-5; rapid X0 Y0 Z2; rapid X1 Y0 Z2; feed X1 Y0 Z-10 F100; rapid X1 Y0 Z2"},
        {"23 other cycle wants its words", By::Strict, "G81 X1 Z-1 R1~G82 X2 P1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1 ! error "
         "cycle-word-missing"},
        {"23 other cycle keeps its words", By::Default, "G81 X1 Z-1 R1~G82 X2 P1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1; rapid X2 Y0 Z1; "
         "feed X2 Y0 Z-1 F100; dwell 1; rapid X2 Y0 Z1"},
        {"23 L0", By::Strict, "G81 X1 Z-1 R1 L0", " ! error cycle-repeats"},
        {"23 incremental", By::Default, "G91 G81 X1 Z-2 R-1 L2",
         "rapid X1 Y0 Z0; rapid X1 Y0 Z-1; feed X1 Y0 Z-3 F100; rapid X1 Y0 Z-1; rapid X2 Y0 Z-1; "
         "feed X2 Y0 Z-3 F100; rapid X2 Y0 Z-1"},
        {"24 pecks", By::Default, "G83 X1 Z-2 R1 Q1",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z0 F100; rapid X1 Y0 Z1; rapid X1 Y0 Z0.254; "
         "feed X1 Y0 Z-1 F100; rapid X1 Y0 Z1; rapid X1 Y0 Z-0.746; feed X1 Y0 Z-2 F100; rapid X1 "
         "Y0 Z1"},
        {"24 Q0", By::Default, "G83 X1 Z-2 R1 Q0",
         "rapid X0 Y0 Z1; rapid X1 Y0 Z1; feed X1 Y0 Z-2 F100; rapid X1 Y0 Z1 ! "
         "cycle-word-missing"},
        {"25 rotary in cycles", By::Strict, "G81 A10 X1 Z-1 R1", " ! error cycle-rotary"},
        {"26 G93 wants F", By::Default, "G93 G1 X1", " ! error inverse-time-feed"},
        {"26 after G94 a new F", By::Strict, "G93 G1 X1 F2~G94 G1 X2",
         "feed X1 Y0 Z0 F2/inverse-time ! error feed-missing"},
        {"27 rotary is not wrapped", By::Default, "G0 A350~G0 A10",
         "rapid X0 Y0 Z0 A350; rapid X0 Y0 Z0 A10"},
        {"28 tool centre point", By::Default, "G43.4 H1", " ! error kinematics"},
        {"29 assignments after the line", By::Default, "#1=6~#1=7 X#1~G0 Y#1",
         "rapid X6 Y0 Z0; rapid X6 Y7 Z0"},
        {"29 unset number is 0", By::Default, "G0 X#100", "rapid X0 Y0 Z0 ! variable-unknown"},
        {"29 unset name", By::Default, "G0 X#<nothing>", " ! error parameter-unset"},
        {"29 vacant word is left out", By::Fanuc, "G0 X#100 Y1",
         "rapid X0 Y1 Z0 ! variable-unknown"},
        {"29 vacant is not 0", By::Fanuc, "IF[#100EQ0]GOTO10~G0 X1~N10 G0 Y1",
         "rapid X1 Y0 Z0; rapid X1 Y1 Z0 ! variable-unknown"},
        {"29 vacant index", By::Fanuc, "IF[#[#120]EQ#0]GOTO10~G0 X1~N10 G0 Y1",
         "rapid X0 Y1 Z0 ! variable-unknown"},
        {"30 power", By::Default, "G0 X[-3**2] Y[2^3]", "rapid X9 Y8 Z0"},
        {"30 left to right", By::Default, "G0 X[1 OR 0 AND 0]", "rapid X0 Y0 Z0"},
        {"30 modulo", By::Default, "G0 X[-10 MOD 3]", "rapid X2 Y0 Z0"},
        {"30 FIX", By::Default, "G0 X[FIX[-2.8]]", "rapid X-3 Y0 Z0"},
        {"30 FIX", By::Fanuc, "G0 X[FIX[-2.8]]", "rapid X-2 Y0 Z0"},
        {"30 ROUND", By::Default, "G0 X[ROUND[-2.5]]", "rapid X-3 Y0 Z0"},
        {"30 ATAN", By::Default, "G0 X[ATAN[1]/[1]]", "rapid X45 Y0 Z0"},
        {"30 bits", By::Fanuc, "G0 X[6AND3]", "rapid X2 Y0 Z0"},
        {"30 no brackets", By::Fanuc, "#1=3~#1=#1+1~G0 X#1", "rapid X4 Y0 Z0"},
        {"31 return value", By::Default, "o<f> sub~o<f> endsub [7]~o<f> call~G0 X#<_value>",
         "rapid X7 Y0 Z0"},
        {"31 M98 with L", By::Default, "M98 P5 L2~M30~O5~G91 G0 X1~M99",
         "rapid X1 Y0 Z0; rapid X2 Y0 Z0"},
        {"31 old Fanuc form", By::Fanuc, "M98 P20005~M30~O5~G91 G0 X1~M99",
         "rapid X1 Y0 Z0; rapid X2 Y0 Z0"},
        {"31 M97", By::Haas, "M97 P5 L2~M30~N5 G91 G0 X1~M99", "rapid X1 Y0 Z0; rapid X2 Y0 Z0"},
        {"31 M99 in the main program", By::Default, "G0 X1~M99", "rapid X1 Y0 Z0"},
        {"32 dwell by F", By::Strict, "G4 F1", " ! error dwell-without-time"},
        {"words nobody uses", By::Default, "G1 X1 Q3", "feed X1 Y0 Z0 F100 ! word-unused"},
        {"words nobody uses", By::Strict, "G1 X1 Q3", " ! error word-unused"},
        {"unknown G", By::Default, "G199 P1", " ! error unknown-g"},
        {"unknown G", By::Default, "G199 G1 X1", " ! error unknown-g"},
        {"harmless G of others", By::Default, "G187 P1~G103 P1~G22~G23~G25~G26~G0 X1",
         "rapid X1 Y0 Z0"},
        {"unknown G with axes", By::Default, "G150 X1", " ! error not-simulated"},
        {"unknown M", By::Default, "M123", " ! unknown-m"},
        {"M13 starts the spindle", By::Default, "S100 M13~G1 X1", "feed X1 Y0 Z0 F100 S100"},
        {"corner rounding", By::Default, "G1 X1 ,R2~X3", "rapid X3 Y0 Z0 ! error corner-word"},
        {"line by its angle", By::Default, "G1 X1 ,A45~G0 X3",
         "rapid X3 Y0 Z0 ! error corner-word"},
        {"line by its angle", By::Fanuc, "G1 X1 ,A45~G0 X3", "feed X1 Y1 Z0 F100; rapid X3 Y1 Z0"},
        {"an arc has no angle", By::Fanuc, "G2 X1 I1 ,A45~G0 X3",
         "rapid X3 Y0 Z0 ! error corner-word"},
        {"lines by angles", By::Fanuc, "G1 ,A90.~X5. Y5. ,A0",
         "feed X0 Y5 Z0 F100; feed X5 Y5 Z0 F100"},
        {"angle of a line that rises", By::Fanuc, "G1 X1 Z1 ,A45~X3",
         "rapid X3 Y0 Z0 ! error angle-form"},
        {"angle that its end gainsays", By::Fanuc, "G1 X1 Y2 ,A45~X3",
         "rapid X3 Y0 Z0 ! error angle-form"},
        {"lines by angles that never meet", By::Fanuc, "G1 ,A45~X5. Y1. ,A45~X3",
         "feed X5 Y1 Z0 F100; feed X3 Y1 Z0 F100 ! error angle-form"},
        {"angle and another code", By::Fanuc, "G1 ,A45~G0 X3", "rapid X3 Y0 Z0 ! error angle-form"},
        {"corner without its comma", By::Fanuc, "G1 X10. R2.~Y5.",
         "rapid X0 Y5 Z0 ! error corner-word"},
        {"corner without its comma", By::Default, "G1 X10. R2.",
         "feed X10 Y0 Z0 F100 ! word-unused"},
        {"chamfer without its comma", By::Haas, "G1 X10. C2.~Y5.",
         "rapid X0 Y5 Z0 ! error corner-word"},
        {"chamfer without its comma", By::Haas, "G90 G1 X10. C2.~Y5.",
         "rapid X0 Y5 Z0 ! error corner-word"},
        {"an axis C", By::Haas, "G0 C0~G1 X10. C2.", "rapid X0 Y0 Z0; feed X10 Y0 Z0 C2 F100"},
        {"corner rounded", By::Fanuc, "G1 X10. ,R2.~Y10. F50.",
         "feed X8 Y0 Z0 F100; arc XY X10 Y2 Z0 centre 8 2 turns 1 F100; feed X10 Y10 Z0 F50"},
        {"corner rounded to the right", By::Fanuc, "G91 G1 X10.,R2.~Y-10.",
         "feed X8 Y0 Z0 F100; arc XY X10 Y-2 Z0 centre 8 -2 turns -1 F100; feed X10 Y-10 Z0 F100"},
        {"corner of 60 degrees", By::Haas, "G1 X10. ,R3.~X5. Y8.660254037844387",
         "feed X4.803847577 Y0 Z0 F100; arc XY X7.401923789 Y4.5 Z0 centre 4.803847577 3 turns 1 "
         "F100; feed X5 Y8.660254038 Z0 F100"},
        {"corner chamfered", By::Fanuc, "G1 X10. ,C2.~Y10.",
         "feed X8 Y0 Z0 F100; feed X10 Y2 Z0 F100; feed X10 Y10 Z0 F100"},
        {"corners in a row", By::Haas, "G1 X10. ,R2.~Y10. ,C3.~X0 ,R7.~Y0",
         "feed X8 Y0 Z0 F100; arc XY X10 Y2 Z0 centre 8 2 turns 1 F100; feed X10 Y7 Z0 F100; feed "
         "X7 Y10 Z0 F100; arc XY X0 Y3 Z0 centre 7 3 turns 1 F100; feed X0 Y0 Z0 F100"},
        {"corner in G18", By::Fanuc, "G18 G1 X10. ,R2.~Z-10.",
         "feed X8 Y0 Z0 F100; arc ZX X10 Y0 Z-2 centre -2 8 turns 1 F100; feed X10 Y0 Z-10 F100"},
        {"corner under a rotation", By::Fanuc, "G68 X0 Y0 R90~G1 X10. ,R2.~Y10.",
         "feed X0 Y8 Z0 F100; arc XY X-2 Y10 Z0 centre -2 8 turns 1 F100; feed X-10 Y10 Z0 F100"},
        {"corner under a scale", By::Fanuc, "G51 X0 Y0 Z0 P2~G1 X10. ,R2.~Y10.",
         "feed X16 Y0 Z0 F100; arc XY X20 Y4 Z0 centre 16 4 turns 1 F100; feed X20 Y20 Z0 F100"},
        {"corner in inches", By::Fanuc, "G20~G1 X1. ,C.5~Y1.",
         "feed X12.7 Y0 Z0 F100; feed X25.4 Y12.7 Z0 F100; feed X25.4 Y25.4 Z0 F100"},
        {"corner with compensation", By::Fanuc, "G41.1 D2~G1 X10. Y10.~X30. ,R5.~Y0~G40 X40.",
         "feed X10 Y11 Z0 F100; "
         "feed X25 Y11 Z0 F100; arc XY X31 Y5 Z0 centre 25 5 turns -1 F100; feed X31 Y0 Z0 F100; "
         "feed X40 Y0 Z0 F100"},
        {"no corner", By::Fanuc, "G1 X10. ,R2.~X20.", "feed X10 Y0 Z0 F100; feed X20 Y0 Z0 F100"},
        {"corner of nothing", By::Fanuc, "G1 X10. ,R0~Y10.",
         "feed X10 Y0 Z0 F100; feed X10 Y10 Z0 F100"},
        {"corner that is as long as its lines", By::Fanuc, "G1 X2. ,R2.~Y2.",
         "arc XY X2 Y2 Z0 centre 0 2 turns 1 F100"},
        {"corner without room", By::Fanuc, "G1 X10. ,R11.~Y20.",
         "feed X10 Y0 Z0 F100; feed X10 Y20 Z0 F100 ! error corner-form"},
        {"corner without room behind it", By::Fanuc, "G1 X10. ,C5.~Y4.",
         "feed X10 Y0 Z0 F100; feed X10 Y4 Z0 F100 ! error corner-form"},
        {"corner of a million", By::Fanuc, "G1 X10. ,R1000000.~Y20.",
         "feed X10 Y0 Z0 F100; feed X10 Y20 Z0 F100 ! error corner-form"},
        {"corner that turns back", By::Fanuc, "G1 X10. ,R1.~X5.",
         "feed X10 Y0 Z0 F100; feed X5 Y0 Z0 F100 ! error corner-form"},
        {"corner of less than nothing", By::Fanuc, "G1 X10. ,R-1.~Y5.",
         "rapid X0 Y5 Z0 ! error negative-value"},
        {"corner out of the plane", By::Fanuc, "G1 X10. ,R1.~Z-5.",
         "feed X10 Y0 Z0 F100; feed X10 Y0 Z-5 F100 ! error corner-form"},
        {"corner of a line out of the plane", By::Fanuc, "G1 Z-5. ,R1.~X5.",
         "feed X0 Y0 Z-5 F100; feed X5 Y0 Z-5 F100 ! error corner-form"},
        {"corner before an arc", By::Fanuc, "G1 X10. ,R1.~G2 X20. R5.",
         "feed X10 Y0 Z0 F100; arc XY X20 Y0 Z0 centre 15 0 turns -1 F100 ! error corner-form"},
        {"corner before a rapid", By::Fanuc, "G1 X10. ,R1.~G0 Y20.",
         "feed X10 Y0 Z0 F100; rapid X10 Y20 Z0 ! error corner-form"},
        {"corner before a stop", By::Fanuc, "G1 X10. ,R1.~M0~G1 Y20.",
         "feed X10 Y0 Z0 F100; feed X10 Y20 Z0 F100 ! error corner-form"},
        {"corner before the end", By::Fanuc, "G1 X10. ,R1.",
         "feed X10 Y0 Z0 F100 ! error corner-form"},
        {"corner of a rapid", By::Fanuc, "G0 X10. ,R1.~Y10.",
         "rapid X0 Y10 Z0 ! error corner-word"},
        {"corner of an arc", By::Fanuc, "G2 X10. R5. ,R1.~G1 Y10.",
         "feed X0 Y10 Z0 F100 ! error corner-word"},
        {"corner twice", By::Fanuc, "G1 X10. ,R1. ,C1.~Y10.",
         "rapid X0 Y10 Z0 ! error corner-word"},
        {"corner in inverse time", By::Fanuc, "G93 G1 X10. ,R1. F1.~Y10. F1.",
         "rapid X0 Y10 Z0 ! error cycle-inverse-time"},
        {"holes under a rotation", By::Haas,
         "G68 X0 Y0 R90~G99 G81 Z-1 R1 L0~G72 X1. Y0 I4. J0. L2~X7",
         "rapid X0 Y0 Z1; rapid X0 Y1 Z1; feed X0 Y1 Z-1 F100; rapid X0 Y1 Z1; rapid X0 Y5 Z1; "
         "feed X0 Y5 Z-1 F100; rapid X0 Y5 Z1; rapid X0 Y7 Z1; feed X0 Y7 Z-1 F100; rapid X0 Y7 "
         "Z1"},
        {"holes want a cycle", By::Haas, "G70 I5. J0. L4", " ! error hole-pattern"},
        {"holes want a cycle that is on", By::Haas, "G81 Z-1 R1 L0~G80~G70 I5. J0. L4",
         " ! error hole-pattern"},
        {"holes want the depth of the cycle", By::Haas, "G81 R1~G70 I5. J0. L4",
         " ! error cycle-word-missing"},
        {"holes want a radius", By::Haas, "G81 Z-1 R1 L0~G70 J0. L4", " ! error hole-pattern"},
        {"holes want an angle", By::Haas, "G81 Z-1 R1 L0~G70 I5. L4", " ! error hole-pattern"},
        {"holes want a number", By::Haas, "G81 Z-1 R1 L0~G70 I5. J0.", " ! error hole-pattern"},
        {"holes want their spacing", By::Haas, "G81 Z-1 R1 L0~G71 I5. J0. L3",
         " ! error hole-pattern"},
        {"no hole", By::Haas, "G81 Z-1 R1 L0~G70 I5. J0. L0", " ! error hole-pattern"},
        {"half a hole", By::Haas, "G81 Z-1 R1 L0~G70 I5. J0. L2.5", " ! error hole-pattern"},
        {"too many holes", By::Haas, "G81 Z-1 R1 L0~G70 I5. J0. L1000000", " ! error hole-pattern"},
        {"fewer than no holes", By::Haas, "G81 Z-1 R1 L0~G70 I5. J0. L-4", " ! error hole-pattern"},
        {"all holes in one", By::Haas, "G81 Z-1 R1 L0~G71 I5. J0. K0. L3", " ! error hole-pattern"},
        {"no radius", By::Haas, "G81 Z-1 R1 L0~G70 I0. J0. L3", " ! error hole-pattern"},
        {"holes in another plane", By::Haas, "G18 G81 Y-1 R1 L0~G70 I5. J0. L3",
         " ! error hole-pattern"},
        {"two patterns", By::Haas, "G81 Z-1 R1 L0~G70 G71 I5. J0. K3. L3",
         " ! error codes-exclude"},
        {"holes beside G28", By::Haas, "G81 Z-1 R1 L0~G28 G72 X5 I5. J0. L3",
         "rapid X5 Y0 Z0; rapid X0 Y0 Z0 machine ! error hole-pattern"},
        {"pocket under a rotation", By::Haas, "G68 X0 Y0 R90~G13 X2 I5. D0",
         "rapid X0 Y2 Z0; arc XY X0 Y7 Z0 centre 0 4.5 turns 1 F100; arc XY X0 Y7 Z0 centre 0 2 "
         "turns 1 F100; arc XY X0 Y2 Z0 centre 0 4.5 turns 1 F100"},
        {"pocket at the depth that there is", By::Haas, "G13 I5. D0~X1",
         "arc XY X5 Y0 Z0 centre 2.5 0 turns 1 F100; arc XY X5 Y0 Z0 centre 0 0 turns 1 F100; arc "
         "XY X0 Y0 Z0 centre 2.5 0 turns 1 F100; rapid X1 Y0 Z0"},
        {"pocket of a cutter that nobody told", By::Haas, "G13 I5. D9",
         "arc XY X5 Y0 Z0 centre 2.5 0 turns 1 F100; arc XY X5 Y0 Z0 centre 0 0 turns 1 F100; arc "
         "XY X0 Y0 Z0 centre 2.5 0 turns 1 F100 ! compensation-radius-unknown"},
        {"pocket wants a radius", By::Haas, "G13 Z-1 D1", " ! error pocket-word"},
        {"pocket of no radius", By::Haas, "G13 I0. Z-1 D1", " ! error pocket-word"},
        {"pocket of a radius below 0", By::Haas, "G13 I-5. Z-1 D1", " ! error pocket-word"},
        {"pocket without steps", By::Haas, "G13 I3. K5. Z-1 D1", " ! error pocket-word"},
        {"pocket with steps of nothing", By::Haas, "G13 I3. K5. Q0 Z-1 D1", " ! error pocket-word"},
        {"pocket with steps to nowhere", By::Haas, "G13 I3. Q1. Z-1 D1", " ! error pocket-word"},
        {"pocket that ends within", By::Haas, "G13 I3. K2. Q1. Z-1 D1", " ! error pocket-word"},
        {"pocket of a million circles", By::Haas, "G13 I3. K5. Q0.000001 Z-1 D1",
         " ! error pocket-word"},
        {"pocket of a million passes", By::Haas, "G91 G13 I3. Z-1 D1 L1000000",
         " ! error pocket-word"},
        {"pocket of no pass", By::Haas, "G91 G13 I3. Z-1 D1 L0", " ! error pocket-word"},
        {"pocket as wide as the cutter", By::Haas, "G13 I2. Z-1 D1", " ! error compensation-arc"},
        {"pocket in another plane", By::Haas, "G18 G13 I5. Y-1 D1", " ! error pocket-word"},
        {"pocket within a cycle", By::Haas, "G81 Z-1 R1 L0~G13 I5. Z-1 D1", " ! error pocket-word"},
        {"pocket within compensation", By::Haas, "G41 D1~G13 I5. Z-1 D1",
         " ! error forbidden-with-compensation"},
        {"pocket in inverse time", By::Haas, "G93 G13 I5. Z-1 D1 F1.",
         " ! error cycle-inverse-time"},
        {"pocket beside G28", By::Haas, "G28 G13 X5 I5. D1",
         "rapid X5 Y0 Z0; rapid X0 Y0 Z0 machine ! error pocket-word"},
        {"endless loop", By::Default, "o1 while [1]~G91 G0 X0~o1 endwhile",
         "rapid X0 Y0 Z0; rapid X0 Y0 Z0; rapid X0 Y0 Z0; rapid X0 Y0 Z0; rapid X0 Y0 Z0; rapid X0 "
         "Y0 Z0; rapid X0 Y0 Z0; rapid X0 Y0 Z0; rapid X0 Y0 Z0; rapid X0 Y0 Z0 ! error "
         "step-limit"},
        {"endless recursion", By::Default, "o<a> sub~o<a> call~o<a> endsub~o<a> call",
         " ! error call-depth"},
        {"two tools and M6", By::Fanuc, "T1 T2 M6~G0 X1~M6~X2",
         "tool 1 at X0 Y0 Z0; rapid X1 Y0 Z0 T1; tool 2 at X1 Y0 Z0; rapid X2 Y0 Z0 T2"},
        {"G8 P1 looks ahead", By::Fanuc, "G08 P1~G0 X1", "rapid X1 Y0 Z0"},
    });
}

}  // namespace
}  // namespace ncsim::gcode
