// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines from configurations of LinuxCNC, compared with the kinematics of LinuxCNC (5c41560e,
// compiled and run); tip in W.
#include "ncsim/setup/machine_formats.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

namespace ncsim::setup {
namespace {

using machine::Values;

// Input files in memory.
class Specified : public InputSet {
public:
    std::map<std::string, std::string> files;
    std::string read(const std::string& path, std::uintmax_t) override {
        const auto found = files.find(path);
        if (found == files.end()) throw std::runtime_error(path + ": no such file");
        return found->second;
    }
    bool is_there(const std::string& path) override { return files.contains(path); }
};

MachineFile read(const std::string& text, const std::map<std::string, std::string>& more = {}) {
    Specified specified;
    specified.files = more;
    specified.files["m.ini"] = text;
    return read_machine("m.ini", specified);
}

void expect_tip(const MachineFile& file, double length, const Values& values, double x, double y,
                double z) {
    ASSERT_TRUE(file.kinematics);
    // With all joints at 0 the tip is at Z-length.
    const auto X_WT = file.kinematics->chain.placed({0, 0, -length}, length).pose(values);
    EXPECT_NEAR(X_WT.translation.x, x, 6e-10);
    EXPECT_NEAR(X_WT.translation.y, y, 6e-10);
    EXPECT_NEAR(X_WT.translation.z - length, z, 6e-10);
}

const std::string kTrt =
    "[EMC]\nMACHINE = table A, C\n[KINS]\n# a remark\n KINEMATICS = xyzac-trt-kins "
    "sparm=identityfirst\n"
    "[TRAJ]\nLINEAR_UNITS = mm\n[HAL]\nHALFILE = LIB:basic_sim.tcl\nHALFILE = offsets.hal\n"
    "HALCMD = net :y-offset xyzac-trt-kins.y-offset gui.y-offset\nHALCMD = sets :y-offset 20\n"
    "[AXIS_X]\nMIN_LIMIT = -200\nMAX_LIMIT = 200 # mm\nMAX_VELOCITY = 20\nMAX_ACCELERATION = 300\n"
    "[AXIS_A]\nMIN_LIMIT = -100\nMAX_LIMIT = 50\n[AXIS_C]\nWRAPPED_ROTARY = 1\n"
    "[RS274NGC]\nSUBROUTINE_PATH = ./subs:./other\nREMAP = M428 modalgroup=10 ngc=428remap\n"
    "REMAP = M429 modalgroup=10 ngc=429remap\nREMAP = M430 modalgroup=10 ngc=430remap\n"
    "REMAP = G68.2 modalgroup=1 python=g682\n";
const std::map<std::string, std::string> kBeside{
    {"offsets.hal", "# of the cradle\nsetp xyzac-trt-kins.z-offset 10\n"},
    {"./subs/428remap.ngc", "o<428remap> sub\n #<kinstype> = 1\n G12.1 P#<kinstype>\n"},
    {"./other/429remap.ngc", "o<429remap> sub\nM68 E3 Q0\n"},
    {"./other/430remap.ngc", "o<430remap> sub\nM68 E3 Q2\n"}};

TEST(LinuxCnc, OfATiltingTable) {
    const MachineFile file = read(kTrt, kBeside);
    EXPECT_EQ(file.machine.name, "table A, C");
    expect_tip(file, 0, {10, 20, 30, -71.841, 0, -35.93}, 7.512840792, 6.674535645, 16.233101057);
    ASSERT_TRUE(file.machine.travel[0]);
    EXPECT_EQ(file.machine.travel[0]->max, 200.0);
    EXPECT_EQ(file.machine.rapid[0], 1200.0);
    EXPECT_EQ(file.machine.acceleration[0], 300.0);
    EXPECT_EQ(file.kinematics->travels.at('A').min, -100.0);
    EXPECT_EQ(file.rotary_ways[2], gcode::RotaryWay::Sign);
    using enum gcode::Coordinates;
    EXPECT_EQ(file.tip_control.m_codes,
              (std::map<int, gcode::Coordinates>{{428, Tip}, {429, Axes}}));
    EXPECT_EQ(file.tip_control.kinematics, (std::vector{Axes, Tip}));
}

TEST(LinuxCnc, OfOtherKinematics) {
    const std::string points =
        "[HAL]\nHALCMD = setp {}.x-rot-point 1\nHALCMD = setp {}.y-rot-point 2\n"
        "HALCMD = setp {}.z-rot-point 3\n";
    const auto with = [](std::string text, const std::string& name) {
        for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}"))
            text.replace(at, 2, name);
        return text;
    };
    expect_tip(read("[KINS]\nKINEMATICS=xyzbc-trt-kins\n" + with(points, "xyzbc-trt-kins") +
                    "HALCMD = setp xyzbc-trt-kins.x-offset -20\n"
                    "HALCMD = setp xyzbc-trt-kins.z-offset 10\n"),
               50, {10, 20, 30, 0, -30, 45}, 5.677325183, 22.778518939, -30.078838325);
    expect_tip(read("[KINS]\nKINEMATICS=xyzab_tdr_kins\n" + with(points, "xyzab_tdr_kins") +
                    "HALCMD = setp xyzab_tdr_kins.z-offset 15\n"),
               50, {10, 20, 30, 30, 40, 0}, -6.889715035, 36.790512608, -6.258935458);
    expect_tip(read("[KINS]\nKINEMATICS = 5axiskins coordinates=xyzbcw\n"), 0,
               {10, 20, 30, 0, -30, 45}, -78.388347648, -68.388347648, 63.493649054);
    const std::string k = "HALCMD = setp xyzacb_trsrn_kins.";
    const MachineFile nutating =
        read("[KINS]\nKINEMATICS = xyzacb_trsrn\n[HAL]\n" + k + "y-pivot 11\n" + k +
             "z-pivot 150\n" + k + "x-offset 3\n" + k + "y-offset 5\n" + k + "y-rot-axis -700\n" +
             k + "z-rot-axis -900\n");
    // LinuxCNC gives the tip relative to 0 at home, and Z without offset: a tool of 60 mm.
    const auto X_WT =
        nutating.kinematics->chain.placed({0, 0, -60}, 60).pose({10, 20, 30, 35, 40, 25});
    EXPECT_NEAR(X_WT.translation.x, -55.094052894, 6e-10);
    EXPECT_NEAR(X_WT.translation.y, -670.979317182, 6e-10);
    EXPECT_NEAR(X_WT.translation.z, 270.812289471, 6e-10);
    EXPECT_FALSE(read("[KINS]\nKINEMATICS = trivkins coordinates=XYZA\n").kinematics);
}

// The first kinematics are active from the start; W of 5axiskins moves along the tool.
TEST(LinuxCnc, WhatIsThereFromTheStart) {
    using enum gcode::Coordinates;
    const auto at_start = [](const std::string& kinematics) {
        return read("[KINS]\nKINEMATICS = " + kinematics + "\n").tip_control.at_start;
    };
    EXPECT_EQ(at_start("5axiskins"), Tip);
    EXPECT_EQ(at_start("5axiskins sparm=identityfirst"), Axes);
    EXPECT_EQ(at_start("xyzac-trt-kins"), Tip);
    EXPECT_EQ(at_start("xyzac-trt-kins sparm=identityfirst"), Axes);
    EXPECT_EQ(at_start("xyzacb_trsrn"), Axes);
    const MachineFile head = read("[KINS]\nKINEMATICS = 5axiskins\n");
    ASSERT_TRUE(head.kinematics->chain.find('W'));
    EXPECT_EQ(*head.kinematics->chain.find('W'), machine::along_tool('W'));
    EXPECT_FALSE(read("[KINS]\nKINEMATICS = xyzac-trt-kins\n").kinematics->chain.find('W'));
}

TEST(LinuxCnc, InInches) {
    const MachineFile file = read(
        "[KINS]\nKINEMATICS = 5axiskins\n[TRAJ]\nLINEAR_UNITS = inch\n[HAL]\n"
        "HALCMD = setp 5axiskins.pivot-length 10\n[AXIS_Z]\nMIN_LIMIT = -5\nMAX_LIMIT = 1\n");
    EXPECT_EQ(file.kinematics->chain.find('B')->through.z, 254.0);
    EXPECT_EQ(file.machine.travel[2]->min, -127.0);
}

TEST(LinuxCnc, SaysWhereItIsWrong) {
    const std::string kins = "[KINS]\nKINEMATICS = xyzac-trt-kins\n";
    for (const auto& [text, message] : std::map<std::string, std::string>{
             {"", "m.ini: [KINS] KINEMATICS is not there"},
             {"[KINS]\nKINEMATICS = genhexkins\n", "m.ini:2: KINEMATICS: 'genhexkins'"},
             {"[KINS\n", "m.ini:1: expected ]"},
             {"[KINS]\nhello\n", "m.ini:2: expected KEY = VALUE"},
             {"#INCLUDE other.inc\n", "m.ini:1: #INCLUDE"},
             {kins + "[HAL]\nHALFILE = x.hal\n", "x.hal: no such file"},
             {kins + "[HAL]\nHALCMD = setp xyzac-trt-kins.y-offset [X]Y\n",
              "m.ini:4: xyzac-trt-kins.y-offset: expected a number"},
             {kins + "[AXIS_X]\nMIN_LIMIT = many\n", "m.ini:4: MIN_LIMIT: expected a number"},
             {kins + "[AXIS_X]\nMIN_LIMIT = 1e300\n", "m.ini:4: MIN_LIMIT: expected a number"},
             {kins + "[AXIS_A]\nMIN_LIMIT = 5\nMAX_LIMIT = 5\n", "m.ini:5: MAX_LIMIT must"}}) {
        try {
            read(text);
            ADD_FAILURE() << text;
        } catch (const std::runtime_error& e) {
            EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
        }
    }
}

}  // namespace
}  // namespace ncsim::setup
