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
    FusionText told;
    told.text = text;
    return read_machine("m.machine", told);
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
    EXPECT_EQ(file.kinematics->chain.find('A')->through, (cda::Vec3{0, 25.4, 5}));
    EXPECT_EQ(file.kinematics->chain.find('A')->direction, (cda::Vec3{-1, 0, 0}));
    EXPECT_EQ(file.kinematics->untold_pivots, "C");
    EXPECT_NE(file.kinematics->guess, "");
    EXPECT_EQ(file.kinematics->travels.at('A').max, 30);
    // Nothing turns: nothing is guessed.
    EXPECT_EQ(read_fusion(fusion_machine()).kinematics->guess, "");
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
             {fusion_machine(fusion_axis("X", "head", "")), "m.machine:9: axis X is told twice"},
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
