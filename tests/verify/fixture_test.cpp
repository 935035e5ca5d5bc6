// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contacts of a tool with fixtures, against distances computed by hand: an upright cylinder meets a
// box where the distance of its axis is less than its radius.
#include "fixture.h"

#include "ncsim/verify/machine_description.h"

#include "verify/verified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::verify_test {
namespace {

using toolpath::Pose;
using verify::Certainty;
using verify::Fixture;
using verify::FixtureContact;
using verify::FixtureScene;

constexpr Box kJaw{{50, 0, -10}, {60, 10, 5}};
constexpr double kRadius = 5.0;

Fixture box_fixture(std::string name, const Box& box) {
    Fixture fixture;
    fixture.name = std::move(name);
    fixture.box = box;
    return fixture;
}

verify::Setup setup_with(const Box& box, double clearance_mm) {
    verify::Setup setup = plain_setup();
    Fixture jaw = box_fixture("jaw", box);
    jaw.clearance_mm = clearance_mm;
    setup.machine.fixtures = {jaw};
    return setup;
}

TriangleMesh mesh_of(const Box& b) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({(i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y,
                                 (i & 4) != 0 ? b.max.z : b.min.z});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

Pose pose_at(Vec3 tip) {
    Pose pose;
    pose.translation = tip;
    return pose;
}

void find(FixtureScene& scene, Vec3 from, Vec3 to, std::vector<FixtureContact>& contacts,
          int tool = 1) {
    const Pose a = pose_at(from), b = pose_at(to);
    scene.find_contact(tool, {a, b, {}, {}, {}, {}, false, {}, {}}, contacts);
}

std::vector<FixtureContact> contacts_of(const verify::Setup& setup, Vec3 from, Vec3 to,
                                        int tool = 1) {
    FixtureScene scene(setup);
    std::vector<FixtureContact> contacts;
    find(scene, from, to, contacts, tool);
    return contacts;
}

/// Returns "touches", "near" or "", followed by "?" if the contact is open.
std::string text_of(const std::vector<FixtureContact>& contacts) {
    std::string text;
    for (const FixtureContact& c : contacts) {
        text += c.touches ? "touches" : "near";
        if (c.certainty == Certainty::Within) text += '?';
    }
    return text;
}

TEST(Fixture, PlaceIsGrownByClearanceAndDeflection) {
    Fixture fixture;
    fixture.name = "rear jaw";
    fixture.box = kJaw;
    EXPECT_EQ(fixture.place(), kJaw);
    fixture.clearance_mm = 2.0;
    EXPECT_EQ(fixture.place(), (Box{{48, -2, -12}, {62, 12, 7}}));
    fixture.deflection_mm = 0.5;
    EXPECT_EQ(fixture.place(), (Box{{47.5, -2.5, -12.5}, {62.5, 12.5, 7.5}}));
    EXPECT_EQ(name_of(fixture), "the fixture 'rear jaw'");
}

TEST(FixtureScene, WithoutFixturesFindsNothing) {
    const verify::Setup setup = plain_setup();
    EXPECT_TRUE(FixtureScene(setup).is_empty());
    EXPECT_TRUE(contacts_of(setup, {0, 0, 0}, {99, 0, 0}).empty());
    const verify::Setup jaw = setup_with(kJaw, 0.0);
    EXPECT_FALSE(FixtureScene(jaw).is_empty());
    EXPECT_TRUE(contacts_of(jaw, {55, 5, 0}, {55, 5, 0}, 7).empty()) << "an undescribed tool";
}

// Each row is a path with the distance of the cylinder from the jaw, computed by hand; every path
// is also reversed.
TEST(FixtureScene, ContactsAreThoseOfADisc) {
    struct Row {
        Vec3 from, to;
        std::string without, with_clearance;  ///< Clearance 2 mm.
    };
    const double corner = kRadius / std::numbers::sqrt2;
    const double near_corner = (kRadius + 2.0) / std::numbers::sqrt2;
    for (const Row& row : {
             Row{{44.99, -20, 0}, {44.99, 20, 0}, "", "near"},
             Row{{45.01, -20, 0}, {45.01, 20, 0}, "touches", "touches"},
             Row{{42.99, -20, 0}, {42.99, 20, 0}, "", ""},
             Row{{43.01, -20, 0}, {43.01, 20, 0}, "", "near"},
             Row{{55, 15.01, 0}, {55, 30, 0}, "", "near"},
             Row{{55, 14.99, 0}, {55, 30, 0}, "touches", "touches"},
             // The tip above the jaw, which ends at Z5.
             Row{{0, 5, 5.01}, {99, 5, 5.01}, "", "near"},
             Row{{0, 5, 4.99}, {99, 5, 4.99}, "touches", "touches"},
             Row{{0, 5, 7.01}, {99, 5, 7.01}, "", ""},
             // 20 mm of flutes below the jaw, which begins at Z-10.
             Row{{55, 5, -30.01}, {55, 5, -40}, "", "near"},
             Row{{55, 5, -29.99}, {55, 5, -40}, "touches", "touches"},
             // Past the corner, where the distance is that of the diagonal.
             Row{{50 - corner - 0.01, -corner - 0.01, 0},
                 {50 - corner - 0.01, -corner - 0.01, 1},
                 "",
                 "near"},
             Row{{50 - corner + 0.01, -corner + 0.01, 0},
                 {50 - corner + 0.01, -corner + 0.01, 1},
                 "touches",
                 "touches"},
             Row{{50 - near_corner + 0.01, -near_corner + 0.01, 0},
                 {50 - near_corner + 0.01, -near_corner + 0.01, 1},
                 "",
                 "near"},
             // Through the jaw between two positions outside.
             Row{{0, 5, 0}, {99, 5, 0}, "touches", "touches"},
         }) {
        SCOPED_TRACE(testing::Message() << row.from.x << ' ' << row.from.y << ' ' << row.from.z);
        const verify::Setup without = setup_with(kJaw, 0.0), with = setup_with(kJaw, 2.0);
        EXPECT_EQ(text_of(contacts_of(without, row.from, row.to)), row.without);
        EXPECT_EQ(text_of(contacts_of(without, row.to, row.from)), row.without) << "reversed";
        EXPECT_EQ(text_of(contacts_of(with, row.from, row.to)), row.with_clearance);
        EXPECT_EQ(text_of(contacts_of(with, row.to, row.from)), row.with_clearance) << "reversed";
        verify::Setup mesh = with;
        mesh.machine.fixtures[0].mesh = mesh_of(kJaw);
        EXPECT_EQ(text_of(contacts_of(mesh, row.from, row.to)), row.with_clearance) << "mesh";
        // A fixture far away changes nothing.
        verify::Setup both = with;
        both.machine.fixtures.push_back(box_fixture("far", {{900, 0, 0}, {910, 10, 10}}));
        EXPECT_EQ(text_of(contacts_of(both, row.from, row.to)), row.with_clearance) << "two";
    }
}

TEST(FixtureScene, BoxOfAContactIsInItsFixture) {
    const verify::Setup setup = setup_with(kJaw, 2.0);
    const auto contacts = contacts_of(setup, {48, 5, 0}, {48, 5, 0});
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].fixture, 0U);
    EXPECT_EQ(contacts[0].piece, 0U);
    // The box reaches from the clearance at X48 to the edge of the tool at X53, and from Z0 to the
    // clearance at Z7.
    EXPECT_NEAR(contacts[0].box.min.x, 48.0, 1e-9);
    EXPECT_NEAR(contacts[0].box.max.x, 53.0, 0.02);
    EXPECT_NEAR(contacts[0].box.min.y, 0.0, 0.02);
    EXPECT_NEAR(contacts[0].box.max.y, 10.0, 0.02);
    EXPECT_NEAR(contacts[0].box.min.z, 0.0, 1e-3);
    EXPECT_NEAR(contacts[0].box.max.z, 7.0, 1e-9);
}

TEST(FixtureScene, EachFixtureAndPieceHasOneContact) {
    verify::Setup setup =
        setup_with_holder();  // shank from 5 mm, holder of radius 20 mm from 30 mm
    setup.machine.fixtures = {box_fixture("low", {{10, -5, 0}, {20, 5, 4}}),
                              box_fixture("high", {{10, -5, 0}, {20, 5, 40}})};
    FixtureScene scene(setup);
    std::vector<FixtureContact> contacts;
    find(scene, {0, 0, 1}, {6, 0, 1}, contacts);
    find(scene, {6, 0, 1}, {7, 0, 1}, contacts);
    find(scene, {7, 0, 1}, {6, 0, 1}, contacts);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (const FixtureContact& c : contacts) {
        EXPECT_TRUE(c.touches);
        EXPECT_EQ(c.certainty, Certainty::Certain);
        found.emplace_back(c.fixture, c.piece);
    }
    std::ranges::sort(found);
    EXPECT_EQ(found, (decltype(found){{0, 0}, {1, 0}, {1, 1}, {1, 2}}));
}

// The triangles hide the true surface by up to 0.1 mm. The first step is open, the second is
// certainly within the clearance, and neither certainly touches.
TEST(FixtureScene, ACertainClearanceLeavesAnOpenTouchOpen) {
    verify::Setup setup = setup_with(kJaw, 2.0);
    setup.machine.fixtures[0].mesh = mesh_of(kJaw);
    setup.machine.fixtures[0].deflection_mm = 0.1;
    const double open = 45.05, close = 44.0, deep = 46.0;
    struct Row {
        std::vector<double> x;  ///< The axis of the tool in successive steps.
        std::string text;
    };
    for (const Row& row : {Row{{open}, "touches?"}, Row{{close}, "near"}, Row{{deep}, "touches"},
                           Row{{open, close}, "touches?"}, Row{{close, open}, "touches?"},
                           Row{{close, open, close}, "touches?"}, Row{{close, deep}, "touches"},
                           Row{{deep, close}, "touches"}, Row{{open, deep}, "touches"},
                           Row{{deep, open, close}, "touches"}}) {
        FixtureScene scene(setup);
        std::vector<FixtureContact> contacts;
        for (const double x : row.x)
            find(scene, {x, 5, 0}, {x, 6, 0}, contacts);
        EXPECT_EQ(text_of(contacts), row.text) << testing::PrintToString(row.x);
    }
}

}  // namespace
}  // namespace ncsim::verify_test
