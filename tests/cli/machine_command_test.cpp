// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command ncsim machine: its summary of a machine file, and the file that --save writes.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace ncsim::cli_test {
namespace {

// The summary of a machine; the saved file has the same summary.
TEST(Machine, IsShownAndSaved) {
    Folder folder;
    folder.write(
        "m.toml",
        "name = \"cradle\"\npreset = \"xyzac-trt\"\npivot = { A = [0, 20, 10], C = [0, 0, 0] "
        "}\nway = { C = \"shortest\" }\nclamps = { A = [\"M10\", \"M11\"] }\n"
        "control = { m_codes = { M428 = \"tip\" }, tip_frame = \"table\", orient = "
        "\"positive\", fixture_offsets = { P1 = { offset = [1, 2, 3.5], at = { C = 90 } }, P2 = { "
        "offset = [0, 0, 0], at = {} } }, fixture_offset_moves = false, setting_errors = { P1 = { "
        "offset = [0.1, 0, 0], at = {}, turns = [0, 0.5, 0] } }, setting_error_moves = true, "
        "setting_error_turns_axes = true }\n[travel]\nx = [-100, 100]\na = [-100, "
        "50]\n[offsets]\nG54 = [1, 2, "
        "3]\n");
    const Ran ran = folder.run(
        {"machine", "m.toml", "--pose", "X10,Y20,Z30,A-71.841,C-35.93", "--save", "s.toml"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    for (const char* words :
         {"cradle\n", "C  turns the part about [0, 0, 1] through [0, 0, 0], way shortest",
          "A  turns the part about [1, 0, 0] through [0, 20, 10], -100 to 50 degrees",
          "X  moves along [1, 0, 0], -100 to 100 mm", "M428: X Y Z are the tip",
          "M10 holds A, M11 lets it go",
          "G54.2 P1: the zero is [1, 2, 3.5] from that of the system at C90",
          "G54.4 P1: the zero is [0.1, 0, 0] from that of the system at 0, turned by [0, 0.5, 0] "
          "degrees",
          "G54 at [1, 2, 3]", "X7.51284 Y6.67454 Z16.2331"})
        EXPECT_NE(ran.out.find(words), std::string::npos) << words << "\n" << ran.out;
    const Ran again = folder.run({"machine", "s.toml", "--save", "t.toml"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(folder.read("s.toml"), folder.read("t.toml"));
    // The output is equal except for the line of the pose.
    EXPECT_EQ(again.out, ran.out.substr(0, ran.out.find("  at X10")));
    folder.write("c.ini",
                 "[KINS]\nKINEMATICS = xyzac-trt-kins\n[HAL]\nHALCMD = setp "
                 "xyzac-trt-kins.y-offset 20\n");
    EXPECT_NE(folder.run({"machine", "c.ini"}).out.find("through [0, 20, 0]"), std::string::npos);
    for (const char* pose : {"A", "Q5", "A1e9", "A5;C3"})
        EXPECT_EQ(folder.run({"machine", "m.toml", "--pose", pose}).exit_code, 2) << pose;
    folder.write("c.ini", "[KINS]\nKINEMATICS = genhexkins\n");
    const Ran unknown = folder.run({"machine", "c.ini"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("c.ini:2: KINEMATICS"), std::string::npos) << unknown.err;
}

// A saved file with fewer limits than the original would accept programs that the original rejects.
TEST(Machine, IsSavedWholeOrNotAtAll) {
    Folder folder;
    folder.write("m.toml",
                 "name = \"mill\"\nbelow_stock = 5\nfixture = []\n[spindle]\nmin = 100\nmax = "
                 "12000\n[feed]\nmax = 8000\n[position]\nhome = [0, 0, 1]\ntool_change = [0, 0, "
                 "2]\nstart = [0, 0, 3]\nwork_zero = [4, 5, 6]\n[time]\ntool_change = 6\n"
                 "junction_deviation = 0.02\n");
    EXPECT_EQ(folder.run({"machine", "m.toml", "--save", "s.toml"}).exit_code, 0);
    const std::string saved = folder.read("s.toml");
    for (const char* line :
         {"below_stock = 5\n", "fixture = []\n", "[spindle]\nmin = 100\nmax = 12000\n",
          "[feed]\nmax = 8000\n", "home = [0, 0, 1]\n", "tool_change = [0, 0, 2]\n",
          "start = [0, 0, 3]\n", "G54 = [4, 5, 6]\n", "tool_change = 6\n",
          "junction_deviation = 0.02\n"})
        EXPECT_NE(saved.find(line), std::string::npos) << line << saved;
    EXPECT_EQ(folder.run({"machine", "s.toml", "--save", "t.toml"}).exit_code, 0);
    EXPECT_EQ(folder.read("t.toml"), saved);
    folder.write("v.toml", "[[fixture]]\nname = \"vice\"\nbox = [[0, 0, 0], [9, 9, 9]]\n");
    folder.write("l.toml", "[[tool]]\nnumber = 1\nmax_depth = 2\n");
    for (const auto& [file, what] :
         {std::pair{"v.toml", "1 fixture"}, {"l.toml", "limits of tools"}}) {
        const Ran ran = folder.run({"machine", file, "--save", "n.toml"});
        EXPECT_EQ(ran.exit_code, 2) << file;
        EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
        EXPECT_FALSE(folder.has("n.toml"));
    }
}

// Values that the file of another program leaves open stay doubts in the saved file.
TEST(Machine, SavesWhatWasAssumedAsAssumed) {
    Folder folder;
    folder.write("m.fcm",
                 R"({"machine": {"name": "m", "axes": {
        "X": {"role": "table_linear", "joint": {"axis": [1, 0, 0]}},
        "Y": {"role": "table_linear", "joint": {"axis": [0, 1, 0]}},
        "Z": {"role": "head_linear", "joint": {"axis": [0, 0, 1]}},
        "A": {"role": "table_rotary", "joint": {"axis": [1, 0, 0], "origin": [0, 1, 2]}}},
        "toolheads": [{"max_rpm": 9000}]}})");
    const Ran first = folder.run({"machine", "m.fcm", "--save", "s.toml"});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_NE(first.out.find("assumed: "), std::string::npos) << first.out;
    EXPECT_NE(folder.read("s.toml").find("max = 9000"), std::string::npos);
    const Ran again = folder.run({"machine", "s.toml", "--save", "t.toml"});
    EXPECT_EQ(again.out, first.out) << again.err;
    EXPECT_EQ(folder.read("t.toml"), folder.read("s.toml"));
    folder.write("a.nc",
                 std::string(kSlot).insert(std::string(kSlot).find("G0 X-30."), "G0 A90.\n"));
    for (const char* file : {"m.fcm", "s.toml"}) {
        const Ran checked = folder.run({"check", "a.nc", "--machine", file});
        EXPECT_NE(checked.out.find("right hand"), std::string::npos) << file << checked.out;
        EXPECT_NE(checked.out.find("[kinematics-guess]"), std::string::npos) << file;
    }
}

TEST(Machine, HasNoPoseOfAxesThatItHasNot) {
    Folder folder;
    folder.write("m.toml", "preset = \"xyzac-trt\"\npivot = { A = [0, 0, 0], C = [0, 0, 0] }\n");
    const Ran ran = folder.run({"machine", "m.toml", "--pose", "A30,B20"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("no axis B"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace ncsim::cli_test
