// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of bodies of a machine, checked directly: which pairs exist, and which of several contacts
// of a pair counts.
#include "machine_scene.h"

#include "verify/verified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::verify_test {
namespace {

using machine::joint_of;
using verify::Certainty;
using verify::LinkBodies;
using verify::MachineContact;
using verify::MachineScene;

TriangleMesh box(Vec3 a, Vec3 b) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A head of 20 mm, moved along X, Y and Z, whose lower end is the nose, and a post that stands
/// from X100 to X120. Zero of the workpiece is zero of the machine.
LinkBodies head_and_post(double clearance_mm) {
    LinkBodies specified;
    specified.tool_moved_by = {{joint_of('X', false, {1, 0, 0}), joint_of('Y', false, {0, 1, 0}),
                                joint_of('Z', false, {0, 0, 1})}};
    specified.links.push_back(
        {"head", box({-10, -10, 0}, {10, 10, 50}), specified.tool_moved_by, clearance_mm});
    specified.links.push_back({"post", box({100, -50, -50}, {120, 50, 50}), {}});
    return specified;
}

verify::Setup setup_of(LinkBodies specified) {
    verify::Setup setup = plain_setup();
    toolpath::Kinematics kinematics;
    kinematics.chain = specified.tool_moved_by;
    setup.kinematics = std::make_shared<const toolpath::Kinematics>(kinematics);
    setup.machine.work_zero = Vec3{};
    setup.bodies = std::make_shared<const verify::MachineBodies>(std::move(specified));
    return setup;
}

gcode::Motion move_along_x(double from, double to) {
    const auto at = [](double x) {
        gcode::Position position;
        position.x = gcode::Length::from_mm(x);
        return position;
    };
    gcode::Motion motion;
    motion.action = gcode::Linear{at(from), at(to)};
    motion.kind = gcode::MoveKind::Rapid;
    return motion;
}

/// Contacts of a move of the nose; no tool is in the spindle.
std::vector<MachineContact> contacts_of(const verify::Setup& setup, double from, double to) {
    MachineScene scene(setup, {});
    std::vector<MachineContact> contacts;
    scene.begin(move_along_x(from, to), {.nose_known = true, .gauge_mm = 0.0}, nullptr, contacts);
    scene.end(nullptr, contacts);
    return contacts;
}

TEST(MachineScene, WithoutKinematicsZeroMeshesOrRulesChecksNothing) {
    const verify::Setup whole = setup_of(head_and_post(0));
    EXPECT_FALSE(MachineScene(whole, {}).is_empty());
    verify::Setup setup = whole;
    setup.bodies = nullptr;
    EXPECT_TRUE(MachineScene(setup, {}).is_empty());
    setup = whole, setup.kinematics = nullptr;
    EXPECT_TRUE(MachineScene(setup, {}).is_empty());
    setup = whole, setup.machine.work_zero.reset();
    EXPECT_TRUE(MachineScene(setup, {}).is_empty());
    setup = whole, setup.selection.ignored = {{"machine-collision", "--ignore"}};
    EXPECT_FALSE(MachineScene(setup, {}).is_empty()) << "near misses";
    setup.selection.ignored.emplace("machine-near-miss", "--ignore");
    EXPECT_TRUE(MachineScene(setup, {}).is_empty());
    LinkBodies bare = head_and_post(0);
    for (verify::LinkBody& link : bare.links)
        link.mesh = {};
    EXPECT_TRUE(MachineScene(setup_of(bare), {}).is_empty());
}

// The head is 10 mm wide on each side of its axis, so it reaches the post at X90.
TEST(MachineScene, ContactsOfAHeadWithAPost) {
    struct Row {
        double from, to;
        std::string meets;  ///< Without a clearance, and with 5 mm: "touches", "near" or "".
        std::string near;
        double amount_mm;  ///< Penetration, or the distance with the clearance.
    };
    for (const Row& row : {
             Row{0, 80, "", "", 0.0}, Row{0, 84.9, "", "", 0.0}, Row{0, 86, "", "near", 4.0},
             Row{0, 89.99, "", "near", 0.01}, Row{0, 90.01, "touches", "touches", 0.01},
             Row{0, 95, "touches", "touches", 5.0}, Row{131, 180, "", "near", 1.0},
             Row{0, 300, "touches", "touches", 20.0},  // through the post; both are 20 mm wide
         }) {
        SCOPED_TRACE(row.to);
        for (const bool reversed : {false, true}) {
            const double from = reversed ? row.to : row.from, to = reversed ? row.from : row.to;
            for (const double clearance : {0.0, 5.0}) {
                const std::string& expected = clearance == 0.0 ? row.meets : row.near;
                const auto contacts = contacts_of(setup_of(head_and_post(clearance)), from, to);
                ASSERT_EQ(contacts.size(), expected.empty() ? 0U : 1U);
                if (expected.empty()) continue;
                const MachineContact& contact = contacts[0];
                EXPECT_EQ(contact.touches, expected == "touches");
                EXPECT_EQ(contact.certainty, Certainty::Certain);
                EXPECT_EQ(contact.clearance_mm, clearance);
                EXPECT_NEAR(contact.amount_mm, row.amount_mm, 0.02);
                EXPECT_EQ(std::min(contact.first, contact.second), "the link 'head'");
                EXPECT_EQ(std::max(contact.first, contact.second), "the link 'post'");
                ASSERT_TRUE(contact.point);
                if (!contact.touches) continue;
                EXPECT_TRUE((Box{{100, -10, 0}, {120, 10, 50}}).contains(*contact.point));
            }
        }
    }
}

TEST(MachineScene, NotesTheWorstContactOfAPair) {
    const verify::Setup setup = setup_of(head_and_post(5));
    const MachineScene scene(setup, {});
    const auto seen = [](bool touches, bool certain, double value) {
        verify::Observation observation;
        observation.subject = verify::Subject::Link;
        observation.touches = touches;
        observation.certain = certain;
        observation.value = value;
        observation.values = machine::Values{1, 2, value};
        return observation;
    };
    // Contacts in order of severity, the worst last: a large distance, a small one, certainty, an
    // open touch, depth.
    const std::vector<verify::Observation> rising{seen(false, false, 4.0), seen(false, false, 3.0),
                                                  seen(false, true, 4.5),  seen(false, true, 1.0),
                                                  seen(true, false, 0.5),  seen(true, false, 0.7),
                                                  seen(true, true, 0.1),   seen(true, true, 0.2)};
    for (std::size_t a = 0; a < rising.size(); ++a) {
        for (std::size_t b = 0; b < rising.size(); ++b) {
            std::vector<MachineContact> contacts;
            scene.note(rising[a], contacts);
            scene.note(rising[b], contacts);
            ASSERT_EQ(contacts.size(), 1U);
            const verify::Observation& worst = rising[std::max(a, b)];
            EXPECT_EQ(contacts[0].touches, worst.touches) << a << ' ' << b;
            EXPECT_EQ(contacts[0].certainty == Certainty::Certain, worst.certain) << a << ' ' << b;
            EXPECT_EQ(contacts[0].amount_mm, *worst.value) << a << ' ' << b;
            EXPECT_EQ(contacts[0].values, worst.values);
        }
    }
    std::vector<MachineContact> contacts;
    verify::Observation wrong = rising[0];
    wrong.index = 999;
    EXPECT_THROW(scene.note(wrong, contacts), std::runtime_error);
    wrong = rising[0], wrong.value.reset();
    EXPECT_THROW(scene.note(wrong, contacts), std::runtime_error);
    wrong = rising[0], wrong.values.reset();
    EXPECT_THROW(scene.note(wrong, contacts), std::runtime_error);
    EXPECT_TRUE(contacts.empty());
}

TEST(MachineScene, MissesALengthOnlyWhereThePairNeedsIt) {
    const verify::Setup setup = setup_of(head_and_post(0));
    MachineScene scene(setup, {});
    std::vector<MachineContact> contacts;
    scene.begin(move_along_x(0, 300), {.nose_known = false, .gauge_mm = 80.0}, nullptr, contacts);
    EXPECT_TRUE(contacts.empty());
    EXPECT_TRUE(scene.misses_length());
    scene.begin(move_along_x(0, 300), {.nose_known = true, .gauge_mm = 0.0}, nullptr, contacts);
    EXPECT_FALSE(scene.misses_length());
    EXPECT_EQ(contacts.size(), 1U);
}

}  // namespace
}  // namespace ncsim::verify_test
