// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contacts of a tool with the block in one motion, against lengths and volumes computed by hand.
// Each motion gives the same contacts backwards, and moved along the block.
#include "step_measurement.h"

#include "verify/verified.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::verify_test {
namespace {

using verify::Certainty;
using verify::Measuring;
using verify::Move;
using verify::Observation;
using verify::Subject;
using verify::ToolMonitors;

gcode::Motion line(Vec3 from, Vec3 to, gcode::MoveKind kind) {
    const auto at = [](Vec3 p) {
        gcode::Position position;
        position.x = gcode::Length::from_mm(p.x);
        position.y = gcode::Length::from_mm(p.y);
        position.z = gcode::Length::from_mm(p.z);
        return position;
    };
    gcode::Motion motion;
    motion.action = gcode::Linear{at(from), at(to)};
    motion.kind = kind;
    motion.tool = 1;
    motion.span.line = 7;
    return motion;
}

/// One motion of T1 in the block of 40 x 30 x 10 mm with its top at Z0.
class Measured {
public:
    using Ask = std::function<void(Measuring&, const toolpath::Step&, const cda::TreeCda&)>;

    explicit Measured(verify::Setup setup = plain_setup(), bool volumes = false)
        : setup_(std::move(setup)),
          part_(cda::box_cell(lattice_.round(kBlock.min), lattice_.round(kBlock.max), lattice_),
                lattice_),
          walk_(lattice_, kBlock, {}),
          monitors_(watch(setup_.tools.at(1), setup_.selection, lattice_, {})),
          measuring_(setup_, kBlock, lattice_, move_, volumes) {
        walk_.add_tool(1, setup_.tools.at(1).tool);
    }

    Move& take(Vec3 from, Vec3 to, gcode::MoveKind kind, const Ask& ask) {
        motion_ = line(from, to, kind);
        move_ = {};
        move_.motion = &motion_;
        move_.number = ++number_;
        move_.volume_known = true;
        measuring_.begin(&monitors_);
        walk_.take(motion_, cda::Origin{1}, [&](const toolpath::Step& step) {
            measuring_.begin_step();
            ask(measuring_, step, part_);
            if (cuts) part_.subtract_unmeasured(step.cells);
        });
        return move_;
    }
    Move& feed(Vec3 from, Vec3 to) {
        return take(from, to, gcode::MoveKind::Feed,
                    [](Measuring& m, const auto& step, const auto& part) {
                        m.measure_feed_move(step, part);
                    });
    }
    Move& rapid(Vec3 from, Vec3 to) {
        return take(
            from, to, gcode::MoveKind::Rapid,
            [](Measuring& m, const auto& step, const auto& part) { m.measure_rapid(step, part); });
    }
    Measuring& measuring() { return measuring_; }
    ToolMonitors& monitors() { return monitors_; }

    bool cuts = false;  ///< The motions remove material after they are measured.

private:
    verify::Setup setup_;
    cda::Lattice lattice_ = cda::Lattice::for_stock(kBlock);
    cda::TreeCda part_;
    toolpath::Walk walk_;
    ToolMonitors monitors_;
    gcode::Motion motion_;
    Move move_;
    Measuring measuring_;
    std::uint64_t number_ = 0;
};

// A cylinder of radius 5 mm removes 10 mm times the depth for each mm of its path.
TEST(StepMeasurement, ContactsOfStraightMoves) {
    struct Row {
        Vec3 from, to;
        bool meets;
        double volume;
    };
    const double half_disc = std::numbers::pi * 25 / 2;
    for (const Row& row : {
             Row{{-30, 0, 0}, {30, 0, 0}, false, 0.0},  // a touch on top
             Row{{-30, 0, -0.01}, {30, 0, -0.01}, true, 4.0},
             Row{{-30, 0, -2}, {30, 0, -2}, true, 800.0},
             Row{{-30, 0, -10}, {30, 0, -10}, true, 4000.0},
             Row{{-30, 20.1, -2}, {30, 20.1, -2}, false, 0.0},
             Row{{-30, 19, -2}, {30, 19, -2}, true, 80.0},
             Row{{-30, 0, -2}, {-25.1, 0, -2}, false, 0.0},
             Row{{-30, 0, -2}, {0, 0, -2}, true, 2 * (200 + half_disc)},
             Row{{0, 0, 20}, {0, 0, 0}, false, 0.0},
             Row{{0, 0, 20}, {0, 0, -4}, true, 8 * half_disc},
             Row{{0, 0, 20}, {0, 0, -40}, true, 20 * half_disc},
             Row{{0, 0, -30}, {5, 0, -30}, false, 0.0},  // 20 mm of flutes, below the block
         }) {
        SCOPED_TRACE(testing::Message() << row.from.x << ' ' << row.from.y << ' ' << row.from.z);
        for (const bool reversed : {false, true}) {
            const Vec3 from = reversed ? row.to : row.from, to = reversed ? row.from : row.to;
            const double near = 0.01 * row.volume + 1e-9;  // the polygon around the disc
            Measured measured;
            const Move& fed = measured.feed(from, to);
            EXPECT_EQ(fed.meets_material, row.meets) << reversed;
            EXPECT_NEAR(fed.removed_mm3, row.volume, near);
            EXPECT_EQ(fed.contact.is_empty(), !row.meets);
            EXPECT_EQ(fed.contact_point.has_value(), row.meets);
            const Move& fast = measured.rapid(from, to);
            EXPECT_EQ(fast.meets_material, row.meets);
            EXPECT_NEAR(fast.removed_mm3, row.volume, near);
            for (const auto& point : {fed.contact_point, fast.contact_point}) {
                if (!point) continue;
                EXPECT_TRUE(kBlock.contains(*point));
                EXPECT_TRUE(fast.contact.contains(*point));
            }
            EXPECT_TRUE(kBlock.contains(fast.contact.centre()) || !row.meets);
        }
    }
}

TEST(StepMeasurement, FindsNoMaterialWhereItIsCutAway) {
    for (const auto move : {&Measured::feed, &Measured::rapid}) {
        Measured measured;
        measured.cuts = true;
        EXPECT_TRUE((measured.*move)({-30, 0, -2}, {30, 0, -2}).meets_material);
        EXPECT_FALSE((measured.*move)({30, 0, -2}, {-30, 0, -2}).meets_material) << "the way back";
        EXPECT_FALSE((measured.*move)({-30, 0, -2}, {30, 0, -1}).meets_material);
        const Move& deeper = (measured.*move)({30, 0, -3}, {-30, 0, -3});
        EXPECT_TRUE(deeper.meets_material);
        EXPECT_NEAR(deeper.removed_mm3, 400.0, 4.0);
        EXPECT_LE(deeper.contact_point->z, -2.0);
        EXPECT_GE(deeper.contact_point->z, -3.0);
    }
}

TEST(StepMeasurement, VolumesOfARunAddUp) {
    Measured measured(plain_setup(), true);
    const auto add = [&](double volume, bool is_exact, bool meets) {
        return measured.take({-30, 0, -2}, {30, 0, -2}, gcode::MoveKind::Feed,
                             [&](Measuring& m, const auto& step, const auto& part) {
                                 if (meets) m.measure_feed_move(step, part);
                                 m.add_removed(step, volume, is_exact);
                                 m.add_removed(step, 0.0, is_exact);
                                 m.add_removed(step, volume, is_exact);
                             });
    };
    const Move exact = add(1.5, true, false);
    EXPECT_EQ(exact.removed_mm3, 3.0);
    EXPECT_TRUE(exact.meets_material);
    EXPECT_FALSE(exact.contact.is_empty());
    const Move none = add(0.0, true, false);
    EXPECT_EQ(none.removed_mm3, 0.0);
    EXPECT_FALSE(none.meets_material);
    EXPECT_TRUE(none.contact.is_empty());
    const Move sliver = add(1e-9, false, false);
    EXPECT_FALSE(sliver.meets_material) << "inexact cells may remove slivers";
    EXPECT_EQ(sliver.removed_mm3, 2e-9);
    EXPECT_TRUE(add(1e-9, false, true).meets_material);
}

// Each wall of the block is parallel to a side of the polygon only for some tools; in between lies
// the accuracy of the tool, in which a contact is open.
TEST(StepMeasurement, OpenContactsGetADecision) {
    verify::Setup setup = plain_setup();
    setup.decides_contacts = true;
    const auto at = [&](Measured& measured, double y) -> Move& {
        return measured.rapid({-30, y, -2}, {30, y + 1e-9, -2});
    };
    double open_y = 0.0;
    for (double y = 20.0; y > 19.9; y -= 0.0005) {
        Measured measured(setup);
        const Move& move = at(measured, y);
        EXPECT_LE(measured.measuring().open_contacts().size(), 1U);
        if (move.certainty == Certainty::Certain) break;
        if (move.meets_material) open_y = y;
    }
    ASSERT_NE(open_y, 0.0);
    Measured certain(setup);
    EXPECT_EQ(at(certain, 19.9).certainty, Certainty::Certain);
    EXPECT_TRUE(certain.measuring().open_contacts().empty()) << "a certain contact is not open";
    for (const verify::ContactDecision decision :
         {verify::ContactDecision{}, verify::ContactDecision{Certainty::Within},
          verify::ContactDecision{Certainty::Certain}}) {
        Measured measured(setup);
        Move& move = at(measured, open_y);
        ASSERT_TRUE(move.meets_material);
        const auto contacts = measured.measuring().open_contacts();
        ASSERT_EQ(contacts.size(), 1U);
        EXPECT_EQ(contacts[0].rule, "rapid-in-material");
        EXPECT_EQ(contacts[0].motion, 1U);
        EXPECT_EQ(contacts[0].tool, 1);
        EXPECT_FALSE(contacts[0].piece);
        EXPECT_FALSE(contacts[0].boxes.empty());
        measured.measuring().decide(std::array{decision});
        EXPECT_EQ(move.meets_material, decision.has_value());
        EXPECT_EQ(move.certainty, decision.value_or(Certainty::Within));
    }
}

// The shank is from 5 to 30 mm above the tip, the holder from 30 mm.
TEST(StepMeasurement, RaiseOfShankAndHolder) {
    struct Row {
        double z;
        std::optional<double> shank, holder;
    };
    const std::optional<double> none;
    for (const Row& row : {Row{-5.0, none, none}, Row{-5.01, 0.01, none}, Row{-5.005, 0.01, none},
                           Row{-6.0, 1.0, none}, Row{-30.0, 25.0, none}, Row{-30.005, 25.01, 0.01},
                           Row{-31.0, 26.0, 1.0}}) {
        for (const double x : {0.0, 3.0}) {
            Measured measured(setup_with_holder());
            const Move& move =
                measured.take({x, 0, row.z}, {x + 5, 0, row.z}, gcode::MoveKind::Feed,
                              [](Measuring& m, const auto& step, const auto& part) {
                                  m.measure_bodies(step, part);
                                  m.measure_bodies(step, part);
                              });
            const auto raise_of = [&](std::size_t piece) -> std::optional<double> {
                std::optional<double> raise;
                for (const verify::BodyContact& contact : move.bodies) {
                    if (contact.piece != piece) continue;
                    EXPECT_FALSE(raise) << "a contact for each piece";
                    EXPECT_EQ(contact.certainty, Certainty::Certain);
                    raise = contact.raise_mm;
                }
                return raise;
            };
            for (const auto& [piece, expected] : {std::pair(1, row.shank), {2, row.holder}}) {
                const std::optional<double> raise = raise_of(static_cast<std::size_t>(piece));
                EXPECT_EQ(raise.has_value(), expected.has_value()) << row.z;
                EXPECT_NEAR(raise.value_or(0), expected.value_or(0), 1e-9) << row.z;
            }
        }
    }
}

TEST(StepMeasurement, RaiseNeverDecreases) {
    Measured measured(setup_with_holder());
    const auto raise_at = [&](double z) {
        const Move& move = measured.take(
            {0, 0, z}, {5, 0, z}, gcode::MoveKind::Feed,
            [](Measuring& m, const auto& step, const auto& part) { m.measure_bodies(step, part); });
        return move.bodies.empty() ? 0.0 : move.bodies[0].raise_mm;
    };
    EXPECT_NEAR(raise_at(-6.0), 1.0, 1e-9);
    EXPECT_NEAR(raise_at(-8.0), 3.0, 1e-9);
    EXPECT_NEAR(raise_at(-7.0), 3.0, 1e-9) << "of all motions so far";
    EXPECT_EQ(raise_at(-5.0), 0.0);
}

// The core has a radius of 2 mm. A steep descent of tan 5° times the radius is permitted, and four
// times as much on a ramp of at most 5 degrees.
TEST(StepMeasurement, DescentOnTheCore) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).blind_diameter = 4.0;
    const double allowed = std::tan(5.0 * std::numbers::pi / 180.0) * 2.0;  // 0.175
    const auto plunge = [&](const std::vector<Vec3>& path) {
        Measured measured(setup);
        measured.cuts = true;
        double most = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const Move& move = measured.take(path[i - 1], path[i], gcode::MoveKind::Feed,
                                             [](Measuring& m, const auto& step, const auto& part) {
                                                 m.measure_core(step, part);
                                             });
            most = std::max(most, move.plunged_mm);
        }
        return most;
    };
    EXPECT_EQ(plunge({{0, 0, 0}, {0, 0, -(allowed - 0.01)}}), 0.0);
    EXPECT_NEAR(plunge({{0, 0, 0}, {0, 0, -(allowed + 0.01)}}), allowed + 0.01, 0.011);
    EXPECT_NEAR(plunge({{0, 0, 0}, {0, 0, -3}}), 3.0, 1e-6);
    EXPECT_NEAR(plunge({{0, 0, 2}, {0, 0, -3}}), 3.0, 0.011) << "air above the block";
    EXPECT_NEAR(plunge({{0, 0, 0}, {0, 0, -0.1}, {0, 0, -0.2}}), 0.2, 0.011) << "in pecks";
    // Aside by the radius of the core, the button is gone; by less, it is not.
    EXPECT_EQ(plunge({{0, 0, 0}, {0, 0, -0.1}, {2.001, 0, -0.1}, {2.001, 0, -0.2}}), 0.0);
    EXPECT_NEAR(plunge({{0, 0, 0}, {0, 0, -0.1}, {1.9, 0, -0.1}, {1.9, 0, -0.2}}), 0.2, 0.011);
    EXPECT_EQ(plunge({{0, 0, 0}, {0, 0, 5}}), 0.0) << "upwards";
    EXPECT_EQ(plunge({{-30, 0, -3}, {30, 0, -3}}), 0.0) << "level";
    EXPECT_EQ(plunge({{40, 0, 0}, {40, 0, -5}}), 0.0) << "outside the block";
    const double at_limit = 10 * std::tan(4.9 * std::numbers::pi / 180.0);
    EXPECT_EQ(plunge({{-5, 0, 0}, {5, 0, -at_limit}}), 0.0) << "a ramp of 4.9 degrees";
    EXPECT_GT(plunge({{-5, 0, 0}, {5, 0, -10 * std::tan(10 * std::numbers::pi / 180.0)}}), 0.0);
    setup.tools.at(1).max_ramp = 12.0;
    EXPECT_EQ(plunge({{-5, 0, 0}, {5, 0, -10 * std::tan(10 * std::numbers::pi / 180.0)}}), 0.0);
}

TEST(StepMeasurement, CutterAboveItsDepthLimit) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).max_depth = 4.0;
    for (const double z : {-3.0, -4.0, -4.005, -4.5, -6.0, -9.0}) {
        for (const bool reversed : {false, true}) {
            Measured measured(setup);
            const Vec3 left{-30, 0, z}, right{30, 0, z};
            const Move& move = measured.take(reversed ? right : left, reversed ? left : right,
                                             gcode::MoveKind::Feed,
                                             [](Measuring& m, const auto& step, const auto& part) {
                                                 m.measure_too_high(step, part);
                                             });
            const double excess = std::ceil(100 * std::max(0.0, -z - 4.0) - 1e-6) / 100;
            EXPECT_NEAR(move.too_deep_mm, excess, 1e-9) << z;
        }
    }
}

TEST(StepMeasurement, UncertainFlutesKeepTheFirstPlace) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).certain_flutes = 4.0;
    Measured measured(setup);
    const auto at = [&](double z) {
        measured.take({-30, 0, z}, {30, 0, z}, gcode::MoveKind::Feed,
                      [](Measuring& m, const auto& step, const auto& part) {
                          m.measure_uncertain_flutes(step, part);
                      });
        return measured.monitors().uncertain_mm;
    };
    EXPECT_EQ(at(-4.0), 0.0);
    EXPECT_EQ(measured.monitors().uncertain_place.span.line, 0U);
    // In steps of 4/16 mm, rounded up.
    EXPECT_NEAR(at(-4.2), 0.25, 1e-9);
    EXPECT_EQ(measured.monitors().uncertain_place.span.line, 7U);
    EXPECT_NEAR(at(-6.1), 2.25, 1e-9);
    EXPECT_NEAR(at(-5.0), 2.25, 1e-9);
}

TEST(StepMeasurement, MouthIsTheHighestMaterialInTheColumn) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::drill(8, 118, 50);
    setup.tools.at(1).flute_length = 40.0;
    Measured measured(setup);
    const auto mouth = [&](double x, double z) {
        return measured
            .take({x, 0, 20}, {x, 0, z}, gcode::MoveKind::Feed,
                  [](Measuring& m, const auto& step, const auto& part) {
                      m.measure_mouth(step, part);
                  })
            .mouth_z;
    };
    ASSERT_TRUE(mouth(0, -3.0));
    EXPECT_NEAR(*mouth(0, -3.0), 0.0, 0.011);
    EXPECT_NEAR(*mouth(0, -9.0), 0.0, 0.011);
    EXPECT_FALSE(mouth(0, 0.5)) << "above the block";
    EXPECT_FALSE(mouth(60, -3)) << "outside";
    // At the edge of the block, half of the column is material.
    EXPECT_NEAR(mouth(20, -3.0).value_or(99), 0.0, 0.011);
}

TEST(StepMeasurement, FlatTipCutsInMaterialOnly) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::v_cutter(12, 6, 90, 20);
    setup.tools.at(1).flat_tip = 6.0;
    const auto cuts = [&](double y, double z) {
        Measured measured(setup);
        return measured
            .take(
                {-30, y, z}, {30, y, z}, gcode::MoveKind::Feed,
                [](Measuring& m, const auto& step, const auto& part) { m.measure_tip(step, part); })
            .tip_cuts;
    };
    EXPECT_TRUE(cuts(0, -1));
    EXPECT_FALSE(cuts(0, 0)) << "a touch";
    EXPECT_FALSE(cuts(18.1, -1)) << "outside by the radius of the tip; the cone cuts the edge";
    EXPECT_TRUE(cuts(17.9, -1));
}

TEST(StepMeasurement, RefusesObservationsThatAreImpossible) {
    Measured measured(setup_with_holder());
    measured.feed({-30, 0, 20}, {30, 0, 20});
    const auto note = [&](Subject subject, std::uint32_t index = 0) {
        Observation seen;
        seen.subject = subject;
        seen.index = index;
        seen.value = 1.0;
        measured.measuring().note(seen);
    };
    for (const Subject subject : {Subject::Core, Subject::Fixture, Subject::Link})
        EXPECT_THROW(note(subject), std::runtime_error);
    EXPECT_THROW(note(Subject::Body, 0), std::runtime_error) << "the cutter";
    EXPECT_THROW(note(Subject::Body, 3), std::runtime_error) << "no such piece";
    EXPECT_NO_THROW(note(Subject::Body, 2));
    measured.measuring().begin(nullptr);
    EXPECT_THROW(note(Subject::Body, 2), std::runtime_error) << "an undescribed tool";
    EXPECT_THROW(note(Subject::UnspecifiedFlutes), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::verify_test
