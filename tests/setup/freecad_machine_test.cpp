// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines of FreeCAD's CAM workbench.
#include "ncsim/setup/machine_formats.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

namespace ncsim::setup {
namespace {

class Specified : public InputSet {
public:
    std::string text;
    std::string read(const std::string&, std::uintmax_t) override { return text; }
};

MachineFile read(const std::string& text) {
    Specified specified;
    specified.text = text;
    return read_machine("m.fcm", specified);
}

std::string axis(const std::string& letter, const std::string& role, const std::string& along,
                 const std::string& more = "") {
    return "\"" + letter + "\": {\"role\": \"" + role + "\", \"joint\": {\"axis\": " + along +
           more + "}}";
}

// Returns a machine with X, Y, Z and the rotary axes `axes`.
std::string machine_of(const std::string& axes, const std::string& units = "metric") {
    return "{\"version\": 1, \"machine\": {\"name\": \"mill\", \"units\": \"" + units +
           "\", \"axes\": {" + axis("X", "table_linear", "[1, 0, 0]") + ", " +
           axis("Y", "table_linear", "[0, 1, 0]") + ", " + axis("Z", "head_linear", "[0, 0, 1]") +
           (axes.empty() ? "" : ", " + axes) +
           "}, \"toolheads\": [{\"min_rpm\": 100, \"max_rpm\": 6000}]}}";
}

std::string letters_of(const MachineFile& file) {
    std::string letters;
    for (const machine::Joint& joint : file.kinematics->chain.joints)
        letters += joint.letter;
    return letters;
}

TEST(FreeCad, OfATableOfTwo) {
    const MachineFile file = read(machine_of(
        axis("A", "table_rotary", "[1, 0, 0]",
             "}, \"limits\": {\"min\": -100, \"max\": 50}, \"x\": {\"origin\": [0, 0, 0]") +
        ", \"C\": {\"role\": \"table_rotary\", \"parent\": \"A\", \"joint\": {\"origin\": [1, 2, "
        "3], "
        "\"axis\": [0, 0, 1]}}"));
    EXPECT_EQ(file.machine.name, "mill");
    EXPECT_EQ(file.machine.max_rpm, 6000.0);
    EXPECT_EQ(letters_of(file), "CAXYZ");
    EXPECT_EQ(file.kinematics->travels.at('A').max, 50.0);
    EXPECT_EQ(file.kinematics->chain.find('C')->through, (Vec3{1, 2, 3}));
    // The table turns by the right hand, so the tool turns in the opposite direction relative to
    // the table.
    EXPECT_EQ(file.kinematics->chain.find('C')->direction, (Vec3{0, 0, -1}));
    EXPECT_FALSE(file.kinematics->guess.empty());
    EXPECT_EQ(file.kinematics->unspecified_pivots, "A");
}

TEST(FreeCad, OfAHead) {
    const MachineFile file = read(
        machine_of(axis("B", "head_rotary", "[0, 1, 0]", "}, \"parent\": \"C\", \"x\": {\"y\": 1") +
                       ", " + axis("C", "head_rotary", "[0, 0, 1]", ", \"origin\": [0, 0, 10]"),
                   "imperial"));
    EXPECT_EQ(letters_of(file), "XYZCB");
    EXPECT_TRUE(file.kinematics->guess.empty());
    EXPECT_EQ(file.kinematics->chain.find('C')->through.z, 254.0);
}

TEST(FreeCad, SaysWhereItIsWrong) {
    for (const auto& [text, message] : std::map<std::string, std::string>{
             {"{\n", "m.fcm:2: "},
             {"[1, 2]", "m.fcm:1: expected 'machine'"},
             {"\n{\"machine\": {\n\"axes\": 5}}", "m.fcm:3: machine: axes: expected a table"},
             {"{\"machine\": {\n\"name\": \"a\",\n\"axes\": {}}}",
              "m.fcm:3: machine: axes: no axis X"},
             {"{\"machine\": {\n\"axes\": {\n\"X\": {\"role\": "
              "\"head_linear\",\n\"joint\":\n{}}}}}",
              "m.fcm:4: machine: axes: X: joint: expected 'axis'"},
             {machine_of(axis("Q", "table_rotary", "[1, 0, 0]")), "axes: Q: expected an axis"},
             {machine_of(axis("A", "table_linear", "[1, 0, 0]")), "A, B and C rotary"},
             {machine_of(axis("A", "robot", "[1, 0, 0]")), "expected table_linear"},
             {machine_of(axis("A", "table_rotary", "[0, 0, 0]")), "it has no length"},
             {machine_of(axis("A", "table_rotary", "[0, 1e300, 0]")), "expected a number"},
             {machine_of(axis("A", "table_rotary", "[0, 1]")), "expected three numbers"},
             {machine_of(
                  axis("A", "table_rotary", "[1, 0, 0]", "}, \"parent\": \"A\", \"x\": {\"y\": 1")),
              "axis A carries itself"},
             {machine_of(
                  axis("A", "table_rotary", "[1, 0, 0]", "}, \"parent\": \"K\", \"x\": {\"y\": 1")),
              "there is no axis 'K'"},
             {machine_of(axis("A", "table_rotary", "[1, 0, 0]",
                              "}, \"limits\": {\"min\": 3, \"max\": 3}, \"x\": {\"y\": 1")),
              "max must be above min"}}) {
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
