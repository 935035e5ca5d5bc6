// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines with rotary axes from machine files: run and check.
#include "cli/run_program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

constexpr double kPi = 3.14159265358979;

const char* const kTrt =
    "preset = \"xyzac-trt\"\n"
    "pivot = { A = [0, 0, -40], C = [0, 0, 0] }\n"
    "control = { m_codes = { M428 = \"tip\", M429 = \"axes\" }, tip_frame = \"table\" }\n"
    "[offsets]\n"
    "G54 = [0, 0, 0]\n";

// Returns a hole of 12 mm along the tool under tip control, entered from 5 mm above the top of the
// block, at A and C. Moves along the tool prove the kinematics of the program, as in the demos of
// LinuxCNC.
std::string hole(double a, double c, const std::string& begin, const std::string& end) {
    const double ra = a * kPi / 180, rc = c * kPi / 180;
    // Axis of a table that turns by the right hand: A, then C, inverted.
    const double axis[] = {std::sin(rc) * std::sin(ra), std::cos(rc) * std::sin(ra), std::cos(ra)};
    const auto at = [&](double along) {
        return fmt::format("X{:.6f} Y{:.6f} Z{:.6f}", along * axis[0], along * axis[1],
                           along * axis[2]);
    };
    return "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n"
           "(FROM/0.,0.,50.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG43 H1\nG0 X0 Y0 Z50\n" +
           begin + "\n" + fmt::format("G0 {} A{} C{}\n", at(30), a, c) + "G0 " + at(6) + "\n" +
           "G1 " + at(-12) + " F300\nG0 " + at(30) + "\n" + end + "M30\n";
}

const std::string kBack = "G0 A0 C0\nM429\n";
// Without tip control the program would make a different part.
const std::vector<std::string> kTool{"--tool", "T1=flat:D6:L40"};

std::vector<std::string> with(std::vector<std::string> first,
                              const std::vector<std::string>& more) {
    first.insert(first.end(), kTool.begin(), kTool.end());
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

double removed(const Folder& folder, const std::string& program,
               const std::vector<std::string>& more) {
    folder.write("a.nc", program);
    std::vector<std::string> all{"--report", "r.json"};
    all.insert(all.end(), more.begin(), more.end());
    const Ran ran = folder.run(with({"run", "a.nc"}, all));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    if (ran.exit_code != 0) return 0.0;
    return json::parse(folder.read("r.json"))["volume_mm3"]["removed"];
}

// A plunge along the tool makes a hole as wide as the tool: a cylinder whose axis meets the top of
// the block at the zero, cut obliquely by the top, and a flat end.
TEST(Machine, MovesAtFixedAnglesAlongTheToolAreHoles) {
    Folder folder;
    folder.write("m.toml", kTrt);
    for (const auto& [a, c] : {std::pair{0.0, 0.0}, {-30.0, 0.0}, {-30.0, 75.0}, {25.0, -110.0}}) {
        const double volume = removed(folder, hole(a, c, "M428", kBack), {"--machine", "m.toml"});
        EXPECT_NEAR(volume, kPi * 9 * 12, 0.012 * kPi * 9 * 12) << a << " " << c;
        const double by_length =
            removed(folder, hole(a, c, "G43.4 H1", "G0 A0 C0\nG49\n"), {"--machine", "m.toml"});
        EXPECT_EQ(by_length, volume);
    }
}

// The same hole with positions of the axes, as a post-processor without tip control writes them.
// For a quarter turn the positions are known without a formula. A turns about Y0 Z-40.
TEST(Machine, AxesOfAChainThatIsToldMakeTheSameHole) {
    Folder folder;
    folder.write("m.toml", kTrt);
    const std::string head =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n"
        "(FROM/0.,0.,50.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG0 X0 Y0 Z80\n";
    // A90 moves points at Y30 to Z-10: a hole of 12 mm into the side, 8 mm below the top.
    const std::string by_axes = "G0 A90\nG0 X0 Y-32 Z0\nG1 Z-22 F300\nG0 Z80\nG0 A0\nM30\n";
    const std::string by_tip =
        "M428\nG0 X0 Y60 Z50\nG0 Y60 Z-8 A90\nG1 Y18 F300\nG0 Y60\nM429\nM30\n";
    const double axes = removed(folder, head + by_axes, {"--machine", "m.toml"});
    const double tip = removed(folder, head + by_tip, {"--machine", "m.toml"});
    EXPECT_NEAR(tip, kPi * 9 * 12, 0.012 * kPi * 9 * 12);
    EXPECT_NEAR(axes, tip, 0.002 * tip);
}

// The same hole in a tilted working plane: a cycle along Z of the plane.
TEST(Machine, ACycleInATiltedPlaneIsTheHoleAlongTheTool) {
    Folder folder;
    folder.write("m.toml", kTrt);
    const std::string head =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n"
        "(FROM/0.,0.,60.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG43 H1\nG0 X0 Y0 Z60\n";
    // Euler angles: about Z, then about the rotated X.
    const std::string plane = head +
                              "G68.2 X0 Y0 Z0 I75 J30 K10\nG53.1\nG0 X0 Y0 Z30\n"
                              "G98 G81 Z-12 R6 F300\nG80\nG69\nG0 A0 C0\nM30\n";
    const double tip = removed(folder, hole(-30, 75 + 180, "M428", kBack), {"--machine", "m.toml"});
    const double drilled = removed(folder, plane, {"--machine", "m.toml"});
    EXPECT_NEAR(drilled, tip, 1e-3 * tip);
    folder.write("a.nc", plane);
    const Ran ran = folder.run(with({"run", "a.nc"}, {}));
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.err.find("G68.2 needs the rotary axes of the machine"), std::string::npos);
    folder.write("m.toml", "preset = \"4axis-a\"\npivot = { A = [0, 0, 0] }\n");
    const Ran cannot = folder.run(with({"run", "a.nc"}, {"--machine", "m.toml"}));
    EXPECT_EQ(cannot.exit_code, 1);
    EXPECT_NE(cannot.err.find("no turn of its rotary axes leads there"), std::string::npos);
}

// An arc in a tilted working plane is the same circle in a different place.
TEST(Machine, AGrooveRoundAboutInATiltedPlane) {
    Folder folder;
    folder.write("m.toml", kTrt);
    const std::string head =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,60.,30.,30.,30.)\n"
        "(FROM/0.,0.,90.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG43 H1\nG0 X0 Y0 Z90\n";
    const std::string groove = "G0 X15 Y0 Z35\nG1 Z25 F300\nG3 X15 Y0 I-15 F900\nG0 Z60\n";
    const double upright =
        removed(folder, head + "G0 X0 Y0 Z60\n" + groove + "M30\n", {"--machine", "m.toml"});
    const double side =
        removed(folder, head + "G68.2 J90\nG53.1\nG0 X0 Y0 Z60\n" + groove + "G69\nM30\n",
                {"--machine", "m.toml"});
    EXPECT_NEAR(side, upright, 1e-4 * upright);
    const double aslant = removed(folder,
                                  head +
                                      "G68.2 J40 I20\nG53.1\nG0 X0 Y0 Z70\nG0 X15 Y0\nG1 Z25 "
                                      "F300\nG3 X15 Y0 I-15 F900\nG0 Z70\nG69\nM30\n",
                                  {"--machine", "m.toml"});
    EXPECT_GT(aslant, upright);
}

// After a quarter turn of the table, the result equals the part programmed there, byte for byte.
TEST(Machine, AQuarterTurnOfTheTableMovesNothing) {
    Folder folder;
    folder.write("m.toml", kTrt);
    const std::string head =
        "(T1 D=6. CR=1. - bull nose end mill)\n(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n"
        "(FROM/0.,0.,50.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG0 X0 Y0 Z50\n";
    const auto bytes = [&](const std::string& body) {
        folder.write("a.nc", head + body + "M30\n");
        const Ran ran =
            folder.run(with({"run", "a.nc"}, {"--machine", "m.toml", "--save-stock", "p.ncstock"}));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read_cells("p.ncstock");
    };
    // The table turns the part by +90: points at X of the machine are then at -Y of the part.
    const std::string turned =
        bytes("G0 C90\nG0 X-40 Y5\nZ-3\nG1 X40 F900\nG2 X20 Y25 I-20 J0\nG0 Z50\nG0 C0\n");
    const std::string there = bytes("G0 X5 Y40\nZ-3\nG1 Y-40 F900\nG2 X25 Y-20 I0 J20\nG0 Z50\n");
    EXPECT_EQ(turned, there);
    // The same in a tilted working plane, with G68.2 and G53.1.
    const std::string in_plane = bytes(
        "G68.2 K-90\nG53.1\nG0 X-40 Y5 Z50\nZ-3\nG1 X40 F900\nG2 X20 Y25 I-20 J0\nG0 "
        "Z50\nG69\n");
    EXPECT_EQ(in_plane, there);
}

// The same with G54.2: the zero of the part follows the table, by the sign convention of the
// control.
TEST(Machine, AFixtureOffsetGoesWithTheTable) {
    Folder folder;
    const std::string head =
        "(T1 D=6. CR=1. - bull nose end mill)\n(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n"
        "(FROM/0.,0.,50.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\n";
    const auto bytes = [&](const std::string& control, const std::string& body) {
        folder.write("m.toml",
                     "preset = \"xyzac-trt\"\npivot = { A = [40, -7, 10], C = [40, -7, "
                     "0] }\noffsets = { G54 = [40, -7, 0] }\ncontrol = { " +
                         control + " }\n");
        folder.write("a.nc", head + body + "M30\n");
        const Ran ran = folder.run(with({"run", "a.nc", "--dialect", "fanuc"},
                                        {"--machine", "m.toml", "--save-stock", "p.ncstock"}));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read_cells("p.ncstock");
    };
    const std::string there =
        bytes("", "G0 X0 Y0 Z50\nG0 X5 Y40\nZ-3\nG1 Y-40 F900\nG2 X25 Y-20 I0 J20\nG0 Z50\n");
    // The part is 100 mm to the right of the centre, or behind the centre with the table at C-90:
    // +90 turns the part by the right hand.
    const std::string by_x = "P3 = { offset = [100, 0, 2], at = {} }";
    const std::string by_y = "P3 = { offset = [0, -100, 2], at = { C = -90 } }";
    for (const std::string& specified : {by_x, by_y}) {
        for (const bool moves : {true, false}) {
            const std::string control = "fixture_offsets = { " + specified +
                                        " }, fixture_offset_moves = " + (moves ? "true" : "false");
            const std::string turned = bytes(
                control,
                "G54.2 P3\nG0 X0 Y0 Z50\nG0 C90\nG0 X-40 Y5\nZ-3\nG1 X40 F900\nG2 X20 Y25 I-20 "
                "J0\nG0 Z50\nG54.2 P0\nG0 Z80\nG0 C0\n");
            EXPECT_EQ(turned, there) << control;
        }
    }
}

json verdict(const Folder& folder, const std::vector<std::string>& more) {
    std::vector<std::string> all{"--json", "v.json"};
    all.insert(all.end(), more.begin(), more.end());
    folder.run(with({"check", "a.nc"}, all));
    return json::parse(folder.read("v.json"));
}

std::vector<std::string> reasons(const json& v) {
    std::vector<std::string> ids;
    for (const json& doubt : v["programs"][0]["doubts"])
        ids.push_back(doubt["reason"]);
    return ids;
}

bool has(const std::vector<std::string>& ids, const std::string& id) {
    return std::ranges::find(ids, id) != ids.end();
}

// G54.4 specifies the position of the part. The program means the part as drawn; the verdict says
// that axis positions are known only for an untilted part.
TEST(Machine, ASettingErrorIsOfThePartAsItLies) {
    Folder folder;
    const std::string head =
        "(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n(FROM/0.,0.,50.)\nG21 G90 G17 G94\nT1 M6\nG43 "
        "H1\nS5000 M3\n";
    const auto machine = [&](const std::string& control) {
        folder.write("m.toml",
                     "preset = \"xyzac-trt\"\npivot = { A = [40, -7, 10], C = [40, -7, "
                     "0] }\noffsets = { G54 = [40, -7, 0] }\ncontrol = { tip_frame = "
                     "\"table\", " +
                         control + " }\n");
    };
    const auto bytes = [&](const std::string& before, const std::string& after) {
        folder.write("a.nc", head + before +
                                 "G43.4 H1\nG0 X0 Y-40 Z50\nZ-3\nG1 Y0 A-20 C30 F900\nX10 Y40 Z-1 "
                                 "A-40\nG0 Z60\nG49\n" +
                                 after + "M30\n");
        const Ran ran = folder.run(with({"run", "a.nc", "--dialect", "fanuc"},
                                        {"--machine", "m.toml", "--save-stock", "p.ncstock"}));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read_cells("p.ncstock");
    };
    machine(
        "setting_errors = { P1 = { offset = [0.3, -0.2, 0.1], at = {} }, P2 = { offset = [0, 0, "
        "0], at = {}, turns = [0.1, 0, 0.5] } }, setting_error_moves = false, "
        "setting_error_turns_axes = true");
    const std::string straight = bytes("", "");
    EXPECT_EQ(bytes("G54.4 P1\n", "G54.4 P0\n"), straight);
    const auto is_doubted = [&] {
        return has(reasons(verdict(folder, {"--machine", "m.toml", "--dialect", "fanuc"})),
                   "kinematics-guess");
    };
    EXPECT_FALSE(is_doubted());
    EXPECT_EQ(bytes("G54.4 P2\n", "G54.4 P0\n"), straight);
    EXPECT_TRUE(is_doubted());
}

TEST(Machine, NothingIsGuessedOfTurningUnderTipControl) {
    Folder folder;
    folder.write("m.toml", kTrt);
    folder.write("a.nc", hole(-30, 75, "M428", kBack));
    EXPECT_FALSE(has(reasons(verdict(folder, {"--machine", "m.toml"})), "kinematics-guess"));
    // The preset specifies the directions of the axes, and only the directions matter here.
    folder.write("m.toml",
                 "preset = \"xyzac-trt\"\ncontrol = { m_codes = { M428 = \"tip\", "
                 "M429 = \"axes\" } }\n");
    EXPECT_FALSE(has(reasons(verdict(folder, {"--machine", "m.toml"})), "kinematics-guess"));
    // B is not an axis of the machine.
    folder.write("a.nc", hole(-30, 75, "M428\nG0 B5", kBack));
    EXPECT_TRUE(has(reasons(verdict(folder, {"--machine", "m.toml"})), "kinematics-guess"));
}

TEST(Machine, WhatIsNotToldOfAChainIsADoubt) {
    Folder folder;
    folder.write("a.nc", hole(-30, 0, "", "G0 A0 C0\n"));
    const std::string preset = "preset = \"xyzac-trt\"\n";
    const std::string pivots = "pivot = { A = [0, 0, -40], C = [0, 0, 0] }\n";
    const std::string offsets = "[offsets]\nG54 = [0, 0, 0]\n";
    const auto is_guess = [&](const std::string& machine) {
        folder.write("m.toml", machine);
        return has(reasons(verdict(folder, {"--machine", "m.toml"})), "kinematics-guess");
    };
    EXPECT_TRUE(is_guess(offsets));
    EXPECT_TRUE(is_guess(preset + offsets)) << "where A is";
    EXPECT_TRUE(is_guess(preset + pivots)) << "where the program's zero is";
    EXPECT_FALSE(is_guess(preset + pivots + offsets));
}

TEST(Machine, TheLengthOfAToolThatAHeadTurnsHasToBeTold) {
    Folder folder;
    folder.write("m.toml",
                 "preset = \"bridge-cb\"\npivot = { B = [0, 0, 150], C = [0, 0, 0] }\n"
                 "[offsets]\nG54 = [0, 0, 0]\n");
    std::string program = hole(0, 0, "G0 B30", "G0 B0\n");
    folder.write("a.nc", program);
    const std::vector<std::string> machine{"--machine", "m.toml"};
    EXPECT_TRUE(has(reasons(verdict(folder, machine)), "kinematics-guess"));
    folder.write("t.tbl", "T1 P1 Z80 D6\n");
    // A tool of --tool has priority over the table and has no length.
    folder.run(
        {"check", "a.nc", "--machine", "m.toml", "--tool-table", "t.tbl", "--json", "v.json"});
    EXPECT_FALSE(has(reasons(json::parse(folder.read("v.json"))), "kinematics-guess"));
}

const char* const kHead =
    "preset = \"bridge-cb\"\npivot = { B = [0, 0, 150], C = [0, 0, 0] }\n"
    "[offsets]\nG54 = [0, 0, 0]\n";
const std::string kQuill = "along_tool = \"W\"\ncontrol = { at_start = \"tip\" }\n";

// Returns a hole in a block with the head inclined by 30 degrees to X, as 5axisgui.ngc of LinuxCNC
// drills.
std::string leaning_hole(const std::string& drill) {
    return "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n"
           "(FROM/0.,0.,50.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG43 H1\nG0 X0 Y0 Z50\n"
           "G0 X15 Z25.980762 B-30\nG0 X3 Z5.196152\n" +
           drill + "G0 X15 Z25.980762\nG0 B0\nM30\n";
}
const std::string kByW = "G1 W-18 F300\nG0 W0\n";
const std::string kByXAndZ = "G1 X-6 Z-10.392305 F300\n";

TEST(Machine, AWordAlongTheToolDrillsAsXAndZDo) {
    Folder folder;
    folder.write("t.tbl", "T1 P1 Z80 D6\n");
    folder.write("m.toml", kQuill + kHead);
    const std::vector<std::string> machine{"--machine", "m.toml"};
    const double by_w = removed(folder, leaning_hole(kByW), machine);
    const double by_x_and_z = removed(folder, leaning_hole(kByXAndZ), machine);
    EXPECT_NEAR(by_w, kPi * 9 * 12, 0.012 * kPi * 9 * 12);
    EXPECT_NEAR(by_w, by_x_and_z, 1e-6 * by_w);
    // Kinematics of LinuxCNC with tip control from the start.
    folder.write("m.ini",
                 "[KINS]\nKINEMATICS = 5axiskins coordinates=XYZBCW\n[HAL]\n"
                 "HALCMD = setp 5axiskins.pivot-length 150\n");
    EXPECT_NEAR(removed(folder, leaning_hole(kByW), {"--machine", "m.ini"}), by_w, 1e-6 * by_w);
    // The same machine as TOML.
    EXPECT_EQ(folder.run({"machine", "m.ini", "--save", "saved.toml"}).exit_code, 0);
    EXPECT_EQ(removed(folder, leaning_hole(kByW), {"--machine", "saved.toml"}),
              removed(folder, leaning_hole(kByW), {"--machine", "m.ini"}));
}

TEST(Machine, UVAndWOfAHeadThatTurnsAreADoubtWhereNobodyTellsTheirWay) {
    Folder folder;
    folder.write("t.tbl", "T1 P1 Z80 D6\n");
    const auto is_guess = [&](const std::string& machine, const std::string& program) {
        folder.write("m.toml", machine);
        folder.write("a.nc", program);
        folder.run(
            {"check", "a.nc", "--machine", "m.toml", "--tool-table", "t.tbl", "--json", "v.json"});
        return has(reasons(json::parse(folder.read("v.json"))), "kinematics-guess");
    };
    const std::string head = kHead;
    const std::string tip = "control = { at_start = \"tip\" }\n";
    EXPECT_FALSE(is_guess(head, leaning_hole(kByXAndZ)));
    EXPECT_FALSE(is_guess(kQuill + head, leaning_hole(kByW)));
    EXPECT_TRUE(is_guess(head, leaning_hole(kByW)));
    EXPECT_TRUE(is_guess(tip + head, leaning_hole(kByW)));
    EXPECT_TRUE(is_guess("along_tool = \"W\"\n" + head, leaning_hole(kByW))) << "without tip";
    EXPECT_TRUE(is_guess(kQuill + head, leaning_hole("G0 U1\nG0 U0\n")));
    EXPECT_TRUE(is_guess(kQuill + head, leaning_hole("G10 L20 P1 W5\n" + kByW)));
    const std::string table =
        "preset = \"4axis-b\"\npivot = { B = [0, 0, 0] }\n[offsets]\nG54 = [0, 0, 0]\n";
    EXPECT_FALSE(is_guess(table, leaning_hole(kByW)));
}

// X of the machine moves by the sine with the head, which is 150 mm plus the tool length above the
// tip. The verdict states the position.
TEST(Machine, TravelsHoldForWhatMovesTheToolAlongItself) {
    Folder folder;
    folder.write("t.tbl", "T1 P1 Z80 D6\n");
    folder.write("a.nc", leaning_hole("G1 W-18 F300\nG0 W200\nG0 W0\n"));
    const double beside = 0.5 * (150 + 80);
    for (const auto& [most, beyond] : {std::pair{103.5, false}, {102.5, true}}) {
        folder.write("m.toml",
                     kQuill + kHead + fmt::format("[travel]\nx = [-500, {}]\n", beside + most));
        folder.run(
            {"check", "a.nc", "--machine", "m.toml", "--tool-table", "t.tbl", "--json", "v.json"});
        const json v = json::parse(folder.read("v.json"));
        const bool is_beyond = std::ranges::any_of(
            v["programs"][0]["findings"],
            [](const json& finding) { return finding["rule"] == "over-travel"; });
        EXPECT_EQ(is_beyond, beyond) << most;
    }
}

// Solids of cuts with a tilted tool or part: cylinders and cones without facets of the tool's
// polygon.
TEST(Machine, TheSolidOfATiltedCutHasTheSurfacesOfTheTool) {
    Folder folder;
    const auto step_of = [&](const std::string& machine, const std::string& program) {
        folder.write("m.toml", machine);
        folder.write("a.nc", program);
        const Ran ran = folder.run({"run", "a.nc", "--machine", "m.toml", "--step", "a.step",
                                    "--step-strict", "--report", "r.json", "-q"});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return json::parse(folder.read("r.json"))["step"];
    };
    const auto counts = [](const json& step) {
        return std::array{step["surfaces"]["plane"].get<int>(),
                          step["surfaces"]["cylinder"].get<int>(), step["faces"].get<int>()};
    };
    const std::string head =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,40.,30.,30.,40.)\n"
        "(FROM/0.,0.,60.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG43 H1\nG0 X0 Y0 Z60\n";
    // A circular groove around an island, 8.751108... mm deep in the middle: an arc in a tilted
    // plane.
    const json ring = step_of(
        kTrt, head +
                  "G68.2 X-0.878 Y-1.079 Z-0.857 I118.383 J36.188 K119.021\nG53.1\nG0 X0 Y0 Z40\n"
                  "G0 X3.154 Y-5.159\nG0 Z6\nG1 Z-8.402 F300\nG3 X3.154 Y-5.159 I-4.902 J0\n"
                  "G0 Z30\nG0 Z60\nG69\nM30\n");
    EXPECT_EQ(counts(ring), (std::array{8, 2, 10}));
    const double left =
        144000.0 - std::acos(-1.0) * (7.902 * 7.902 - 1.902 * 1.902) * 8.75110872382084;
    EXPECT_NEAR(ring["volume_mm3"].get<double>(), left, 1e-9 * left);
    // Positions of the axes, with the table at 30 degrees: a slot with two round ends.
    const json slot = step_of(
        "preset = \"4axis-a\"\npivot = { A = [0, 0, -20] }\n"
        "[offsets]\nG54 = [0, 0, 0]\n",
        head + "G0 A30\nG0 X-10 Y8\nG1 Z-9 F300\nG1 X10\nG0 Z60\nM30\n");
    EXPECT_EQ(counts(slot), (std::array{9, 2, 11}));
    // An inclined head that drills by W.
    EXPECT_EQ(counts(step_of(kQuill + kHead, leaning_hole(kByW))), (std::array{7, 1, 8}));
}

// Positions of the tip are not positions of the axes. Travels are checked where axis positions are
// known.
TEST(Machine, TravelsAreNotJudgedByPlacesOfTheTip) {
    Folder folder;
    folder.write("a.nc", hole(-30, 75, "M428", kBack));
    folder.write("m.toml",
                 "preset = \"xyzac-trt\"\ncontrol = { m_codes = { M428 = \"tip\", M429 = "
                 "\"axes\" } }\n[travel]\nx = [-1, 1]\n[offsets]\nG54 = [0, 0, 0]\n");
    const json v = verdict(folder, {"--machine", "m.toml"});
    EXPECT_TRUE(has(reasons(v), "setting-not-used"));
    const auto is_judged = [](const json& verdict) {
        return std::ranges::any_of(verdict["programs"][0]["findings"], [](const json& finding) {
            return finding["rule"] == "over-travel";
        });
    };
    EXPECT_FALSE(is_judged(v));
    // The tip is at most 17 mm from X0, and X of the machine is, too. Y of the machine is up to 20
    // mm from Y0, because A turns 40 mm above its axis.
    for (const auto& [travel, beyond] :
         {std::pair{"y = [-21, 21]", false}, {"y = [-19, 19]", true}, {"a = [-29, 29]", false}}) {
        folder.write("m.toml", std::string(kTrt) + "[travel]\n" + travel + "\n");
        const json known = verdict(folder, {"--machine", "m.toml"});
        EXPECT_EQ(is_judged(known), beyond) << travel;
        EXPECT_FALSE(has(reasons(known), "setting-not-used"));
    }
    // If G54 is not specified, positions of the tip do not count for the length of the travel,
    // which is 16 mm without them.
    folder.write("a.nc", hole(-30, 75, "M428", kBack + "G0 X-16\n"));
    for (const auto& [travel, beyond] : {std::pair{"17", false}, {"15", true}}) {
        folder.write("m.toml", std::string("preset = \"xyzac-trt\"\ncontrol = { m_codes = { M428 = "
                                           "\"tip\", M429 = \"axes\" } }\n[travel]\nx = [0, ") +
                                   travel + "]\n");
        EXPECT_EQ(is_judged(verdict(folder, {"--machine", "m.toml"})), beyond) << travel;
    }
}

TEST(Machine, AFileThatTellsNonsenseIsRefusedWithItsPlace) {
    const std::string linear =
        "[[link]]\nname = \"x\"\naxis = \"X\"\nmoves_along = [1, 0, 0]\n"
        "[[link]]\nname = \"y\"\nparent = \"x\"\naxis = \"Y\"\nmoves_along = [0, 1, 0]\n"
        "[[link]]\nname = \"z\"\nparent = \"y\"\naxis = \"Z\"\nmoves_along = [0, 0, 1]\n";
    const std::string ends = "part = { link = \"cradle\" }\nspindle = { link = \"z\" }\n";
    const auto cradle = [](const std::string& more) {
        return "[[link]]\nname = \"cradle\"\naxis = \"A\"\n" + more;
    };
    const std::string about = "turns_about = [1, 0, 0]\n";
    struct Case {
        std::string text, message;
    };
    const std::vector<Case> cases{
        {"preset = \"robot\"\n", "m.toml:1:10: 'preset': expected \"xyzac-trt\""},
        {"along_tool = \"Z\"\n", "m.toml:1:14: 'along_tool': expected \"U\", \"V\" or \"W\""},
        {"along_tool = \"W\"\n", "m.toml:1:14: 'along_tool' needs to know how the machine turns"},
        {"preset = \"bridge-cb\"\ncontrol = { at_start = \"nose\" }\n",
         "m.toml:2:24: 'control.at_start': expected \"tip\" or \"axes\""},
        {"preset = 3\n", "m.toml:1:10: 'preset': expected a text"},
        {"pivot = { A = [0, 0, 0] }\n", "'pivot' belongs to a preset"},
        {"preset = \"4axis-a\"\npivot = { B = [0, 0, 0] }\n", "m.toml:2:"},
        {"preset = \"4axis-a\"\npivot = { X = [0, 0, 0] }\n", "expected A, B or C"},
        {"preset = \"4axis-a\"\npivot = { A = [0, 0, nan] }\n", "expected a number"},
        {"control = { tip_frame = \"table\" }\n", "'control' needs to know how the machine turns"},
        {"preset = \"4axis-a\"\ncontrol = { tip_frame = \"work\" }\n",
         "\"work\" is not simulated, only \"table\""},
        {"preset = \"4axis-a\"\ncontrol = { tip_turns = \"vector\" }\n", "is not simulated"},
        {"preset = \"4axis-a\"\ncontrol = { tip_frame_at = \"start\" }\n", "is not simulated"},
        {"preset = \"4axis-a\"\ncontrol = { m_codes = { M3 = \"tip\" } }\n",
         "expected M100 to M9999"},
        {"preset = \"4axis-a\"\ncontrol = { m_codes = { M428 = \"plane\" } }\n",
         "expected \"tip\" or \"axes\""},
        {"preset = \"4axis-a\"\ncontrol = { fixture_offsets = { G1 = {} } }\n", "expected P1 to"},
        {"preset = \"4axis-a\"\ncontrol = { fixture_offsets = { P1 = { offset = [1, 2, 3] } } }\n",
         "expected offset = [x, y, z], and at which angles"},
        {"preset = \"4axis-a\"\ncontrol = { fixture_offsets = { P1 = { at = { X = 3 } } } }\n",
         "expected A, B or C"},
        {"preset = \"4axis-a\"\ncontrol = { fixture_offsets = { P1 = { offset = [0, 0, 0], at = "
         "{}, turns = [0, 0, 1] } } }\n",
         "m.toml:2:"},
        {"preset = \"4axis-a\"\ncontrol = { fixture_offset_moves = 1 }\n", "m.toml:2:"},
        {linear + cradle(about), "which link carries the part?"},
        {ends + linear, "there is no link 'cradle'"},
        {ends + linear + cradle(about) + "parent = \"platter\"\n", "there is no link 'platter'"},
        {ends + linear + cradle(about) + "parent = \"cradle\"\n", "link 'cradle' carries itself"},
        {ends + linear + cradle("turns_about = [0, 0, 0]\n"), "it has no length"},
        {ends + linear + cradle(""), "axis A needs turns_about"},
        {ends + linear + cradle(about + "moves_along = [1, 0, 0]\n"), "and nothing else"},
        {ends + linear + cradle(about + "travel = [10, -10]\n"), "the first end must be below"},
        {ends + linear + cradle(about + "mass = 3\n"), "'mass' is not known"},
        {"[travel]\na = [0, 10]\n", "needs to know how the machine turns"},
        {"preset = \"4axis-a\"\n[travel]\nb = [0, 10]\n", "there is no axis B"},
        {"way = { X = \"shortest\" }\n", "expected A, B or C"},
        {"way = { C = \"around\" }\n", "expected \"linear\""},
        {"clamps = { B = [\"M10\", \"M10\"] }\n", "expected two M codes"},
        {"clamps = { B = [\"M3\", \"M4\"] }\n", "expected two M codes"},
        {"clamps = { Q = [\"M10\", \"M11\"] }\n", "expected A, B or C"},
        {"[[link]]\nname = \"w\"\naxis = \"X\"\nmoves_along = [1, 0, 0]\nway = "
         "\"linear\"\n",
         "moves straight: no way"},
        {"preset = \"4axis-a\"\ncontrol = { orient = \"up\" }\n", "expected \"shortest\""},
        {ends + linear + cradle(about) + "[[link]]\nname = \"b\"\naxis = \"A\"\n" + about,
         "axis A is specified twice"},
        {ends + linear + cradle(about) + "[[link]]\nname = \"x\"\n", "a name of its own"},
        {ends + linear + cradle(about) + "[[link]]\nname = \"b\"\naxis = \"B\"\n" + about,
         "axis B moves neither the part nor the tool"},
        {ends + cradle(about) + "[[link]]\nname = \"z\"\n", "no link moves along X"},
        {ends + linear + cradle(about) + "[[link]]\nname = \"b\"\nturns_about = [1, 0, 0]\n",
         "a link that moves needs its axis"},
        {"preset = \"4axis-a\"\n" + ends + linear + cradle(about), "not by both"},
        {"ignore = 3\n" + ends + linear + cradle(about), "expected a list of pairs"},
        {"ignore = [[\"cradle\"]]\n" + ends + linear + cradle(about), "m.toml:1:"},
        {"ignore = [[\"cradle\", \"colum\"]]\n" + ends + linear + cradle(about),
         "there is no link or fixture 'colum'"},
        // The message names the line of the wrong list, not the line of the last list.
        {"ignore = [[\"z\", \"cradle\"],\n[\"z\", \"heap\"]]\nask = [[\"x\", \"y\"]]\n" + ends +
             linear + cradle(about),
         "m.toml:2:7: there is no link or fixture 'heap'"},
        {"ignore = [[\"z\", \"vice\"]]\n" + ends + linear + cradle(about) +
             "[[link]]\nname = \"vice\"\n"
             "[[fixture]]\nname = \"vice\"\nbox = [[0, 0, 0], [1, 1, 1]]\n",
         "m.toml:1:17: 'vice' is the name of a link, and of something else"},
        {"ignore = [[\"z\", \"tool\"]]\n" + ends + linear + cradle(about) +
             "[[link]]\nname = \"tool\"\n",
         "'tool' is the name of a link, and of something else"},
        {"ask = [[\"z\", \"heap\"]]\n" + ends + linear + cradle(about),
         "there is no link or fixture 'heap'"},
        {ends + linear + cradle(about + "clearance = 2\n"),
         "link 'cradle' has no mesh: no clearance"},
        {"path_deviation = -1\n", "'path_deviation'"},
    };
    Folder folder;
    folder.write("a.nc", kSlot);
    for (const Case& c : cases) {
        folder.write("m.toml", c.text);
        for (const char* command : {"run", "check"}) {
            const Ran ran = folder.run({command, "a.nc", "--machine", "m.toml"});
            EXPECT_EQ(ran.exit_code, 2) << c.text;
            EXPECT_NE(ran.err.find(c.message), std::string::npos) << c.text << ran.err;
            EXPECT_NE(ran.err.find("m.toml:"), std::string::npos) << ran.err;
        }
    }
}

// Links describe the same machine as a preset.
TEST(Machine, LinksMakeTheSameMachineAsItsPreset) {
    Folder folder;
    const std::string links =
        "control = { m_codes = { M428 = \"tip\", M429 = \"axes\" } }\n"
        "part = { link = \"platter\" }\nspindle = { link = \"head\" }\n"
        "[[link]]\nname = \"saddle\"\naxis = \"Y\"\nmoves_along = [0, 1, 0]\n"
        "[[link]]\nname = \"table\"\nparent = \"saddle\"\naxis = \"X\"\nmoves_along = [1, 0, 0]\n"
        "[[link]]\nname = \"cradle\"\nparent = \"table\"\naxis = \"A\"\nturns_about = [2, 0, 0]\n"
        "through = [0, 0, -40]\npositive = \"part\"\n"
        "[[link]]\nname = \"platter\"\nparent = \"cradle\"\naxis = \"C\"\n"
        "turns_about = [0, 0, 1]\nthrough = [0, 0, 0]\npositive = \"part\"\n"
        "[[link]]\nname = \"head\"\nparent = \"bed\"\naxis = \"Z\"\nmoves_along = [0, 0, 1]\n"
        "[offsets]\nG54 = [0, 0, 0]\n";
    folder.write("preset.toml", kTrt);
    folder.write("links.toml", links);
    for (const std::string begin : {"M428", ""}) {
        const std::string program = hole(-30, 75, begin, "G0 A0 C0\n");
        EXPECT_EQ(removed(folder, program, {"--machine", "links.toml"}),
                  removed(folder, program, {"--machine", "preset.toml"}));
    }
}

TEST(Machine, TheSampleIsMilledOnItsMachineAndOnNoOther) {
    Folder folder;
    const std::string samples = std::string(NCSIM_SOURCE_DIR) + "/samples/";
    const Ran ran =
        folder.run({"run", samples + "five-axis.nc", "--machine", samples + "machines/trt.toml",
                    "--tolerance", "0.05", "--report", "r.json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    // Volume at the default tolerance: six grooves of 36 x 6 mm, 4 to 12 mm deep.
    const double volume = json::parse(folder.read("r.json"))["volume_mm3"]["removed"];
    EXPECT_NEAR(volume, 11019, 0.03 * 11019);
    const Ran checked = folder.run({"check", samples + "five-axis.nc", "--no-project", "--machine",
                                    samples + "machines/trt.toml", "--tool", "T1=ball:D6:L40"});
    EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
    const Ran alone = folder.run({"run", samples + "five-axis.nc", "--no-project"});
    EXPECT_EQ(alone.exit_code, 1);
    EXPECT_NE(alone.err.find("[kinematics]"), std::string::npos) << alone.err;
}

}  // namespace
}  // namespace ncsim::cli_test
