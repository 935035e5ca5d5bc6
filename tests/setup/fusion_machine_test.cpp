// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines of Fusion and HSMWorks.
#include "ncsim/setup/machine_formats.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::setup {
namespace {

class FusionText : public InputSet {
public:
    std::string text;
    std::string read(const std::string&, std::uintmax_t) override { return text; }
};

MachineFile read_fusion(const std::string& text) {
    FusionText specified;
    specified.text = text;
    return read_machine("m.machine", specified);
}

std::string fusion_axis(const std::string& letter, const std::string& link,
                        const std::string& more) {
    const bool turns = letter <= "C";
    return "<axis actuator=\"" + std::string(turns ? "rotational" : "linear") + "\" coordinate=\"" +
           letter + "\" link=\"" + link + "\" " + more + "/>\n";
}

std::string fusion_machine(const std::string& more = "") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\n"
           "<machine xmlns=\"http://www.hsmworks.com/xml/2009/machine\">\n"
           "<vendor>Smith &amp; Sons</vendor><model>M5</model>\n"
           "<machiningTime ratio=\"1\" toolChangeTime=\"15s\"/>\n"
           "<capabilities maximumFeedrate=\"8000mm/min\" workOffsets=\"100\"/>\n" +
           fusion_axis("X", "head",
                       "offset=\"0mm 0mm 0mm\" range=\"-800mm 800mm\" "
                       "rapidFeed=\"25400mm/min\"") +
           fusion_axis("Y", "table", "range=\"-10in 0in\" rapidFeed=\"0mm/min\"") +
           fusion_axis("Z", "head", "range=\"0mm 0mm\"") + more +
           "<spindle axis=\"0 0 1\" maximumSpeed=\"8100rpm\" minimumSpeed=\"0rpm\"/>\n</machine>\n";
}

TEST(FusionMachine, TellsItsAxesAndLimits) {
    const MachineFile file = read_fusion(
        fusion_machine(fusion_axis("A", "table",
                                   "axis=\"1 0 0\" offset=\"0mm 1in 5mm\" "
                                   "range=\"-110deg 30deg\"") +
                       fusion_axis("C", "table", "axis=\"0 0 1\" offset=\"0mm 0mm 0mm\"")));
    const auto& m = file.machine;
    EXPECT_EQ(m.name, "Smith & Sons M5");
    EXPECT_EQ(m.travel[0]->min, -800);
    EXPECT_EQ(m.travel[1]->min, -254);
    EXPECT_FALSE(m.travel[2]);
    EXPECT_EQ(m.rapid[0], 25'400);
    EXPECT_FALSE(m.rapid[1]);
    EXPECT_EQ(m.max_rpm, 8100);
    EXPECT_FALSE(m.min_rpm);
    EXPECT_EQ(m.max_feed, 8000);
    ASSERT_TRUE(file.kinematics);
    std::string letters;
    for (const machine::Joint& j : file.kinematics->chain.joints)
        letters += j.letter;
    EXPECT_EQ(letters, "CAYXZ");
    EXPECT_EQ(file.kinematics->chain.find('A')->through, (Vec3{0, 25.4, 5}));
    EXPECT_EQ(file.kinematics->chain.find('A')->direction, (Vec3{-1, 0, 0}));
    EXPECT_EQ(file.kinematics->unspecified_pivots, "C");
    EXPECT_NE(file.kinematics->guess, "");
    EXPECT_EQ(file.kinematics->travels.at('A').max, 30);
    // Without rotary axes there is no assumption.
    EXPECT_EQ(read_fusion(fusion_machine()).kinematics->guess, "");
}

// Returns a file with all elements that Fusion writes in addition to the elements that are read:
// capabilities, coolant, tools, a post, and for each axis home, number, resolution and rates.
std::string whole_fusion_machine(const std::string& axes) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\n"
           "<machine xmlns=\"http://www.hsmworks.com/xml/2009/machine\">\n"
           "  <vendor>Own</vendor>\n  <model>five</model>\n"
           "  <description>for a test</description>\n  <control></control>\n"
           "  <machining additive=\"no\" inspection=\"no\" jet=\"no\" milling=\"yes\" "
           "turning=\"no\"/>\n"
           "  <dimensions depth=\"0mm\" height=\"0mm\" weight=\"0kg\" width=\"0mm\"/>\n"
           "  <capacities depth=\"0mm\" height=\"0mm\" weight=\"0kg\" width=\"0mm\"/>\n"
           "  <coolant options=\"FLOOD\"/>\n"
           "  <tooling maximumToolDiameter=\"0mm\" maximumToolLength=\"0mm\" "
           "maximumToolWeight=\"0kg\" numberOfTools=\"100\" toolChanger=\"yes\" "
           "toolPreload=\"yes\"/>\n"
           "  <machiningTime ratio=\"1\" toolChangeTime=\"4.2s\"/>\n"
           "  <capabilities maximumBlockProcessingSpeed=\"0\" maximumFeedrate=\"0mm/min\" "
           "workOffsets=\"100\"/>\n"
           "  <post>\n    <postProcessor>system://x.cps</postProcessor>\n"
           "    <postProperties>\n      <Parameters/>\n    </postProperties>\n  </post>\n" +
           axes +
           "  <spindle axis=\"0 0 1\" maximumSpeed=\"12000rpm\" minimumSpeed=\"50rpm\">\n"
           "    <description></description>\n  </spindle>\n</machine>\n";
}

std::string whole_linear_axis(const std::string& letter, const std::string& link) {
    return "  <axis actuator=\"linear\" coordinate=\"" + letter + "\" homePosition=\"0mm\" id=\"" +
           letter + "\" link=\"" + link +
           "\" maximumFeed=\"0mm/min\" name=\"\" offset=\"0mm 0mm 0mm\" "
           "range=\"-400mm 400mm\" rapidFeed=\"30000mm/min\" resolution=\"0mm\"/>\n";
}

std::string whole_rotary_axis(const std::string& letter, const std::string& link,
                              const std::string& axis, const std::string& offset,
                              const std::string& range) {
    return "  <axis actuator=\"rotational\" axis=\"" + axis + "\" coordinate=\"" + letter +
           "\" cyclic=\"no\" homePosition=\"0deg\" id=\"" + letter + "\" link=\"" + link +
           "\" maximumFeed=\"0rpm\" name=\"\" offset=\"" + offset +
           "\" preference=\"no\" range=\"" + range +
           "\" rapidFeed=\"0rpm\" reset=\"never\" resolution=\"0deg\" tcp=\"yes\"/>\n";
}

// Returns tip and direction of a tool without length, relative to the part.
machine::Pose pose_at(const MachineFile& file, const machine::Values& joints) {
    return file.kinematics->chain.placed({}, 0.0).pose(joints);
}

TEST(FusionMachine, ReadsATableOnATable) {
    const MachineFile file = read_fusion(whole_fusion_machine(
        whole_linear_axis("X", "table") + whole_linear_axis("Y", "table") +
        whole_linear_axis("Z", "head") +
        whole_rotary_axis("A", "table", "1 0 0", "0mm 0mm 50mm", "-120deg 30deg") +
        whole_rotary_axis("C", "table", "0 0 1", "0mm 10mm 0mm", "0deg 0deg")));
    std::string letters;
    for (const machine::Joint& j : file.kinematics->chain.joints)
        letters += j.letter;
    EXPECT_EQ(letters, "CAYXZ");
    EXPECT_EQ(file.kinematics->unspecified_pivots, "");
    EXPECT_EQ(file.kinematics->travels.at('A').min, -120);
    EXPECT_FALSE(file.kinematics->travels.contains('C'));  // without ends
    EXPECT_EQ(file.machine.rapid[2], 30'000);
    EXPECT_EQ(file.machine.min_rpm, 50);
    EXPECT_EQ(file.machine.tool_change_seconds, 4.2);
    EXPECT_NE(file.kinematics->guess, "");
    // Calculation by hand: the table turns by 90 degrees about Y0 Z50 by the right hand. A point at
    // Z50 + 1 moves to Y-1, so a tool at Y-1 Z50 is at Y0 Z51 of the part and comes from Y of the
    // part.
    machine::Values joints{};
    joints[1] = -1;
    joints[2] = 50;
    joints[3] = 90;
    const machine::Pose X_WT = pose_at(file, joints);
    EXPECT_NEAR(norm(X_WT.translation - Vec3{0, 0, 51}), 0.0, 1e-9);
    EXPECT_NEAR(X_WT.rows[1].z, 1.0, 1e-12);
}

TEST(FusionMachine, ReadsAHeadAndATable) {
    const MachineFile file = read_fusion(whole_fusion_machine(
        whole_linear_axis("X", "head") + whole_linear_axis("Y", "head") +
        whole_linear_axis("Z", "head") +
        whole_rotary_axis("C", "table", "0 0 1", "100mm 0mm 0mm", "-360deg 360deg") +
        whole_rotary_axis("B", "head", "0 1 0", "0mm 0mm 200mm", "-30deg 110deg")));
    std::string letters;
    for (const machine::Joint& j : file.kinematics->chain.joints)
        letters += j.letter;
    EXPECT_EQ(letters, "CXYZB");
    EXPECT_EQ(file.kinematics->unspecified_pivots, "");
    EXPECT_EQ(file.kinematics->travels.at('B').max, 110);
    EXPECT_NE(file.kinematics->guess, "");
    // Calculation by hand: the head turns the nose, 200 mm below its axis, towards -X; the table
    // turns this direction about X100 in the opposite sense: to Y.
    machine::Values joints{};
    joints[4] = 90;
    const machine::Pose tilted = pose_at(file, joints);
    EXPECT_NEAR(norm(tilted.translation - Vec3{-200, 0, 200}), 0.0, 1e-9);
    EXPECT_NEAR(tilted.rows[0].z, 1.0, 1e-12);
    joints[5] = 90;
    const machine::Pose turned = pose_at(file, joints);
    EXPECT_NEAR(norm(turned.translation - Vec3{100, 300, 200}), 0.0, 1e-9);
    EXPECT_NEAR(turned.rows[1].z, -1.0, 1e-12);
}

TEST(FusionMachine, RefusesWhatIsNoMachineWithItsLine) {
    const std::string bomb =
        "<!DOCTYPE m [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">]>\n"
        "<machine><vendor>&b;</vendor></machine>";
    for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
             {"", "m.machine:1: this is no XML"},
             {"<machine>\n<axis", "this is no XML"},
             {"<robot/>", "m.machine:1: expected <machine>"},
             {bomb, "no axis X"},
             {fusion_machine(fusion_axis("X", "head", "")),
              "m.machine:9: axis X is specified twice"},
             {fusion_machine(fusion_axis("U", "head", "")), "expected X, Y, Z, A, B or C"},
             {fusion_machine(fusion_axis("A", "arm", "")), "expected head or table"},
             {fusion_machine("<axis actuator=\"linear\" coordinate=\"A\" link=\"head\"/>"),
              "X, Y and Z are linear"},
             {fusion_machine(fusion_axis("A", "head", "axis=\"0 0 0\"")), "it has no length"},
             {fusion_machine(fusion_axis("A", "head", "axis=\"0 1\"")), "expected 3 numbers"},
             {fusion_machine(fusion_axis("A", "head", "range=\"0deg\"")), "expected 2 numbers"},
             {fusion_machine(fusion_axis("A", "head", "range=\"0 90\"")), "with a unit, as 1deg"},
             {fusion_machine(fusion_axis("A", "head", "range=\"0mm 9mm\"")),
              "with a unit, as 1deg"},
             {fusion_machine(fusion_axis("A", "head", "range=\"9deg 0deg\"")), "below the second"},
             {fusion_machine(fusion_axis("A", "head", "range=\"0deg nandeg\"")),
              "expected 2 numbers"},
             {fusion_machine(fusion_axis("A", "head", "range=\"0deg 1deg 2deg\"")),
              "more than 2 numbers"}}) {
        std::string said = "it was read";
        try {
            read_fusion(text);
        } catch (const std::runtime_error& e) {
            said = e.what();
        }
        EXPECT_NE(said.find(message), std::string::npos) << said << "\n" << text;
    }
}

}  // namespace
}  // namespace ncsim::setup
