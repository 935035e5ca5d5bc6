// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines in URDF.
#include "ncsim/machine/relative.h"
#include "ncsim/setup/machine_formats.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::setup {
namespace {

class Files : public InputSet {
public:
    std::map<std::string, std::string> texts;
    std::string read(const std::string& path, std::uintmax_t) override {
        const auto found = texts.find(path);
        if (found == texts.end()) throw std::runtime_error("there is no " + path);
        return found->second;
    }
};

MachineFile read(const std::string& text, std::map<std::string, std::string> others = {}) {
    Files files;
    files.texts = std::move(others);
    files.texts["m.urdf"] = text;
    return read_machine("m.urdf", files);
}

std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "it was read";
}

std::string link(const std::string& name, const std::string& inside = "") {
    return "<link name=\"" + name + "\">" + inside + "</link>\n";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& more = "") {
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/>" + more + "</joint>\n";
}

const std::string kBox = "<visual><geometry><box size=\"0.1 0.2 0.3\"/></geometry></visual>";

// Returns a machine with a tilting table (A) on a slide (Y) on the bed, and X and Z on the tool
// side. The nose is 0.5 m above the bed and 0.2 m behind the bed; the axis of A is 0.1 m above the
// bed.
std::string machine_of(const std::string& y_axis = "0 -1 0", const std::string& more = "") {
    return "<?xml version=\"1.0\"?>\n<robot name=\"mill\">\n" + link("bed", kBox) +
           link("slide", kBox) + link("cradle", kBox) + link("workpiece") + link("beam", kBox) +
           link("head", kBox) + link("tool") +
           joint("joint_y", "prismatic", "bed", "slide",
                 "<axis xyz=\"" + y_axis +
                     "\"/><limit lower=\"-0.1\" upper=\"0.3\" velocity=\"0.5\"/>") +
           joint("A", "revolute", "slide", "cradle",
                 "<origin xyz=\"0 0.05 0.1\"/><axis xyz=\"1 0 0\"/>"
                 "<limit lower=\"-1.5707963267948966\" upper=\"0.5\"/>") +
           joint("fix", "fixed", "cradle", "workpiece") +
           joint("X-axis", "prismatic", "bed", "beam", "<origin xyz=\"0 0.2 0\"/>") +
           joint("z", "prismatic", "beam", "head",
                 "<origin xyz=\"0 0 0.5\"/><axis xyz=\"0 0 2\"/>") +
           joint("nose", "fixed", "head", "tool") + more + "</robot>\n";
}

TEST(UrdfMachine, IsTheChainThatItsJointsTell) {
    const MachineFile file = read(machine_of());
    EXPECT_EQ(file.machine.name, "mill");
    ASSERT_TRUE(file.kinematics);
    EXPECT_EQ(file.kinematics->guess, "");
    EXPECT_EQ(file.kinematics->unspecified_pivots, "");
    std::string letters;
    for (const machine::Joint& j : file.kinematics->chain.joints)
        letters += j.letter;
    EXPECT_EQ(letters, "AYXZ");
    // Motion of the tool relative to the part: the cradle turns the part by the right hand about X.
    const machine::Joint& a = *file.kinematics->chain.find('A');
    EXPECT_EQ(a.direction, (Vec3{-1, 0, 0}));
    // Relative to the spindle nose.
    EXPECT_NEAR(a.through.y, -150, 1e-9);
    EXPECT_NEAR(a.through.z, -400, 1e-9);
    for (const auto& [letter, direction] :
         std::map<char, Vec3>{{'X', {1, 0, 0}}, {'Y', {0, 1, 0}}, {'Z', {0, 0, 1}}}) {
        EXPECT_EQ(file.kinematics->chain.find(letter)->direction, direction) << letter;
    }
    EXPECT_NEAR(file.kinematics->travels.at('A').min, -90, 1e-9);
    ASSERT_TRUE(file.machine.travel[1]);
    EXPECT_NEAR(file.machine.travel[1]->min, -100, 1e-9);
    EXPECT_NEAR(file.machine.travel[1]->max, 300, 1e-9);
    EXPECT_NEAR(file.machine.rapid[1].value(), 30'000, 1e-6);
    EXPECT_FALSE(file.machine.travel[0]);
    // Links with all joints at 0; a frame without body is not a link.
    ASSERT_EQ(file.bodies.size(), 5U);
    EXPECT_TRUE(file.other_links.empty());
    EXPECT_EQ(file.part_link, "cradle");
    EXPECT_EQ(file.tool_link, "head");
    EXPECT_EQ(file.bodies[2].link, "cradle");
    EXPECT_EQ(file.bodies[2].parent, "slide");
    const Vec3 corner = file.bodies[2].mesh.vertices[0];
    EXPECT_NEAR(corner.x, -50, 1e-9);
    EXPECT_NEAR(corner.y, -150 - 100, 1e-9);
    EXPECT_NEAR(corner.z, -400 - 150, 1e-9);
    // Positive values move the slide with the cradle in -Y.
    machine::Values values{};
    values[1] = 10;
    const auto moved = corners_at(file.bodies[2], values);
    EXPECT_NEAR(moved[0].y - corner.y, -10, 1e-9);
}

TEST(UrdfMachine, ATableThatCountsAsItGoesIsAGuess) {
    const MachineFile file = read(machine_of("0 1 0"));
    EXPECT_EQ(file.kinematics->chain.find('Y')->direction, (Vec3{0, 1, 0}));
    EXPECT_NE(file.kinematics->guess.find("Y counts as the tool goes"), std::string::npos);
    EXPECT_NEAR(file.machine.travel[1]->min, -300, 1e-9);
    EXPECT_NEAR(file.machine.travel[1]->max, 100, 1e-9);
}

// Meshes are in metres at the given origin; collision meshes have priority over visual meshes.
TEST(UrdfMachine, PlacesItsMeshes) {
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::string text = machine_of();
    const std::string body =
        "<collision><origin xyz=\"0.5 0 0\" rpy=\"0 0 1.5707963267948966\"/><geometry>"
        "<mesh filename=\"package://mill/a.obj\" scale=\"0.1 0.1 -0.1\"/></geometry></collision>";
    text.replace(text.find(kBox), kBox.size(), kBox + body);
    const MachineFile file = read(text, {{"../a.obj", obj}});
    const auto& mesh = file.bodies[0].mesh;
    ASSERT_EQ(mesh.vertices.size(), 4U);
    // The bed is 200 mm in front of the nose and 500 mm below the nose.
    const Vec3 x = mesh.vertices[0] + Vec3{0, 200, 500};
    double volume = 0.0;
    for (const auto& t : mesh.triangles)
        volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
    EXPECT_NEAR(volume, 1e6 / 6.0, 1e-3);  // mirrored, with outward orientation
    EXPECT_NEAR(x.x, 500, 1e-9);
    bool has_x = false, has_z = false;
    for (const Vec3& p : mesh.vertices) {
        has_x |= norm(p + Vec3{0, 200, 500} - Vec3{500, 100, 0}) < 1e-6;
        has_z |= norm(p + Vec3{0, 200, 500} - Vec3{500, 0, -100}) < 1e-6;
    }
    EXPECT_TRUE(has_x && has_z);
}

TEST(UrdfMachine, RefusesWhatIsNoMachineWithItsLine) {
    const auto with = [](const std::string& more) { return machine_of("0 -1 0", more); };
    std::string deep;
    for (int i = 0; i < 100'000; ++i)
        deep += "<a>";
    const std::string bomb =
        "<!DOCTYPE robot [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">"
        "<!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;&b;\"><!ENTITY d \"&c;&c;&c;&c;&c;&c;&c;&c;\">]>\n"
        "<robot name=\"&d;\"><link name=\"&d;\"/></robot>";
    for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
             {"", "m.urdf:1: this is no XML"},
             {"<!-- nothing -->", "m.urdf:1: "},
             {"<robot>\n<link", "this is no XML"},
             {deep, "this is no XML"},
             {bomb, "there is no link 'workpiece'"},
             {"<sdf/>", "m.urdf:1: expected <robot>"},
             {"<robot><link/></robot>", "<link> needs 'name'"},
             {with(link("bed")), "link 'bed' is specified twice"},
             {with(link("loose")), "m.urdf:16: link 'loose' hangs on nothing"},
             {with(link("a") + link("b") + joint("f", "fixed", "a", "b") +
                   joint("g", "fixed", "b", "a")),
              "carries itself"},
             {with(joint("f", "fixed", "bed", "slide")), "link 'slide' has a joint already"},
             {with(link("a") + joint("f", "fixed", "bed", "b")), "there is no link 'b'"},
             {with(link("a") + joint("arm", "revolute", "bed", "a")), "which axis is it?"},
             {with(link("a") + joint("A", "revolute", "bed", "a")), "axis A is specified twice"},
             {with(link("a") + joint("B", "prismatic", "bed", "a")), "A, B and C turn"},
             {with(link("a") + joint("C", "floating", "bed", "a")), "'floating' is not simulated"},
             {with(link("a") + joint("C", "continuous", "bed", "a")),
              "axis C does not move the tool against the part"},
             {with(link("a") + joint("C", "continuous", "bed", "a", "<axis xyz=\"0 0 0\"/>")),
              "it has no length"},
             {with(link("a") + joint("C", "continuous", "bed", "a", "<axis xyz=\"0 0\"/>")),
              "expected 3 numbers"},
             {with(link("a") + joint("C", "continuous", "bed", "a", "<axis xyz=\"0 0 1 1\"/>")),
              "more than 3 numbers"},
             {with(link("a") + joint("C", "continuous", "bed", "a", "<axis xyz=\"0 0 nan\"/>")),
              "expected 3 numbers"},
             {with(link("a") + joint("C", "continuous", "bed", "a", "<mimic joint=\"A\"/>")),
              "one that follows another"},
             {machine_of("0.1 1 0"), "only Y along itself is simulated"},
             {with(link("a", "<visual/>")), "<visual> needs a <geometry>"},
             {with(link("a", "<visual><geometry><sphere radius=\"1\"/></geometry></visual>")),
              "<sphere> is not read"},
             {with(link("a", "<visual><geometry><box size=\"1 0 1\"/></geometry></visual>")),
              "the box has no volume"},
             {with(
                  link("a", "<visual><geometry><mesh filename=\"gone.stl\"/></geometry></visual>")),
              "there is no gone.stl"},
             {with(link("a",
                        "<visual><geometry><mesh filename=\"http://a/b.stl\"/></geometry>"
                        "</visual>")),
              "expected a file in the folder of this file"}}) {
        const std::string said = refusal(text);
        EXPECT_NE(said.find(message), std::string::npos) << said << "\n" << text.substr(0, 2000);
        EXPECT_TRUE(said.starts_with("m.urdf:")) << said;
    }
}

}  // namespace
}  // namespace ncsim::setup
