// SPDX-License-Identifier: GPL-3.0-or-later
//
// The walk knows where a whole turn ends that leaves no core.
#include "ncsim/toolpath/walk.h"

#include "ncsim/cda/tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace ncsim::toolpath {
namespace {

using gcode::Length;

gcode::Position at(double x, double y, double z) {
    gcode::Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

gcode::Motion motion(decltype(gcode::Motion::what) what) {
    gcode::Motion m;
    m.kind = gcode::MoveKind::Feed;
    m.tool = 1;
    m.what = std::move(what);
    return m;
}

gcode::Motion line(gcode::Position from, gcode::Position to) {
    return motion(gcode::Linear{from, to});
}

// About (x, y), by so many turns more than the part of one.
gcode::Motion arc(gcode::Position from, gcode::Position to, int turns = 1, double x = 0.0,
                  double y = 0.0) {
    gcode::Arc arc;
    arc.from = from, arc.to = to;
    arc.centre_1 = Length::from_mm(x), arc.centre_2 = Length::from_mm(y);
    arc.turns = turns;
    return motion(arc);
}

const cda::Box kStock{{-20, -20, -20}, {20, 20, 0}};

struct Walked {
    std::vector<cda::Cell> cells, covering;
    std::vector<std::size_t> steps;  // after how many cells the others came
};

// Whatever covers is in the cells before it: taken away after them, it takes nothing.
Walked walked(const std::vector<gcode::Motion>& motions, const Tool& tool) {
    const auto lattice = cda::Lattice::for_stock(kStock);
    Walk walk(lattice, kStock, {}, {});
    walk.add_tool(1, tool);
    const auto unit = [&](double mm) { return std::llround(mm / lattice.unit_mm); };
    cda::TreeCda part(
        cda::box_cell({unit(-20), unit(-20), unit(-20)}, {unit(20), unit(20), unit(0)}, lattice),
        lattice);
    Walked result;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        walk.take(motions[i], cda::Origin{static_cast<std::uint32_t>(i + 1)}, [&](const Step& s) {
            result.cells.insert(result.cells.end(), s.cells.begin(), s.cells.end());
            part.subtract_unmeasured(s.cells);
            for (const cda::Cell& cell : s.covering) {
                EXPECT_EQ(part.subtract(cell), 0.0);
                EXPECT_EQ(cell.origin, cda::Origin{static_cast<std::uint32_t>(i + 1)});
                result.covering.push_back(cell);
                result.steps.push_back(result.cells.size());
            }
        });
    }
    return result;
}

const Tool kFlat = flat_end_mill(10, 40);

TEST(Walk, CoversAFullCircle) {
    for (const int turns : {1, -1}) {
        const Walked w = walked(
            {line(at(0, 0, -5), at(4, 0, -5)), arc(at(4, 0, -5), at(4, 0, -5), turns)}, kFlat);
        ASSERT_EQ(w.covering.size(), 1U);
        EXPECT_EQ(w.steps[0], w.cells.size());
        for (const cda::Cell& cell : w.cells)
            EXPECT_LT(w.covering[0].rank, cell.rank);
    }
}

TEST(Walk, CoversACircleInHalvesAndQuarters) {
    EXPECT_EQ(walked({arc(at(4, 0, -5), at(-4, 0, -5)), arc(at(-4, 0, -5), at(4, 0, -5))}, kFlat)
                  .covering.size(),
              1U);
    // The middles are told with an error of some micrometres; an arc leads in, and one out.
    const Walked w =
        walked({arc(at(2, -2, -5), at(4, 0, -5), 1, 2, 0), arc(at(4, 0, -5), at(0, 4, -5)),
                arc(at(0, 4, -5), at(-4, 0, -5), 1, 0, 0.002),
                arc(at(-4, 0, -5), at(0, -4, -5), 1, 0.001, 0), arc(at(0, -4, -5), at(4, 0, -5)),
                arc(at(4, 0, -5), at(2, 2, -5), 1, 2, 0)},
               kFlat);
    ASSERT_EQ(w.covering.size(), 1U);
    EXPECT_EQ(w.covering[0].origin, cda::Origin{5});
}

TEST(Walk, CoversEachTurnOfAHelix) {
    std::vector<gcode::Motion> motions;
    for (int i = 0; i < 3; ++i)
        motions.push_back(arc(at(4, 0, -2 * i), at(4, 0, -2 * i - 2)));
    motions.push_back(arc(at(4, 0, -6), at(4, 0, -6)));
    const Walked lines = walked(motions, kFlat);
    ASSERT_EQ(lines.covering.size(), 4U);
    EXPECT_DOUBLE_EQ(lines.covering[2].bounds.min.z, -4.0);
    EXPECT_DOUBLE_EQ(lines.covering[3].bounds.min.z, -6.0);
    const Walked once =
        walked({arc(at(4, 0, 0), at(4, 0, -6), 3), arc(at(4, 0, -6), at(4, 0, -6))}, kFlat);
    EXPECT_EQ(once.covering.size(), 4U);
    // Up again, it has been there.
    EXPECT_EQ(walked({arc(at(4, 0, -6), at(4, 0, -2))}, kFlat).covering.size(), 1U);
}

// Of a round nose, what is above it.
TEST(Walk, CoversWhatTheCylinderOfAToolTakes) {
    const Walked w = walked({arc(at(3, 0, -9), at(3, 0, -9))}, ball_end_mill(10, 40));
    ASSERT_EQ(w.covering.size(), 1U);
    EXPECT_NEAR(w.covering[0].bounds.min.z, -4.0, 0.01);
}

TEST(Walk, CoversNothingElse) {
    const auto covers = [](const std::vector<gcode::Motion>& motions, const Tool& tool = kFlat) {
        return !walked(motions, tool).covering.empty();
    };
    EXPECT_TRUE(covers({arc(at(4.8, 0, -5), at(4.8, 0, -5))}));
    EXPECT_FALSE(covers({arc(at(5.1, 0, -5), at(5.1, 0, -5))}));  // a core
    EXPECT_FALSE(covers({arc(at(4, 0, -5), at(0, 4, -5)), arc(at(0, 4, -5), at(0, -4, -5))}));
    EXPECT_FALSE(covers({arc(at(4, 0, -5), at(-4, 0, -5)), line(at(-4, 0, -5), at(-4, 0, 5)),
                         line(at(-4, 0, 5), at(-4, 0, -5)), arc(at(-4, 0, -5), at(4, 0, -5))}));
    // There and back.
    EXPECT_FALSE(covers({arc(at(4, 0, -5), at(-4, 0, -5)), arc(at(-4, 0, -5), at(4, 0, -5), -1)}));
    // A turn in which the table turns as well.
    gcode::Position turned = at(4, 0, -5);
    turned.c = gcode::Angle::from_degrees(30);
    EXPECT_FALSE(covers({arc(at(4, 0, -5), turned)}));
}

std::vector<gcode::Motion> straight(int count, double x, double y, double z) {
    std::vector<gcode::Motion> motions;
    for (int i = 0; i < count; ++i)
        motions.push_back(line(at(-9 + i * x, i * y, -5 + i * z),
                               at(-9 + (i + 1) * x, (i + 1) * y, -5 + (i + 1) * z)));
    return motions;
}

// A straight way in pieces is one cell, as far as the tool is wide: which of the lines was there
// first, nobody can tell of a place more exactly.
TEST(Walk, CoversAStraightWayInPieces) {
    for (const Tool& tool : {kFlat, ball_end_mill(10, 40)}) {
        for (const double slope : {0.0, 0.25}) {
            const Walked w = walked(straight(9, 1, 0.5, slope), tool);
            // Eight of them are 9 mm, nine 10.1 or more.
            EXPECT_GE(w.covering.size(), 7U);
            EXPECT_LE(w.covering.size(), 8U);
            for (std::size_t i = 1; i < w.covering.size(); ++i)
                EXPECT_LT(w.covering[i].rank, w.covering[i - 1].rank);
            for (const cda::Cell& cell : w.cells)
                EXPECT_LT(w.covering[0].rank, cell.rank);
        }
    }
}

TEST(Walk, CoversNoWayThatIsNotStraight) {
    const auto covers = [](const std::vector<gcode::Motion>& motions) {
        return !walked(motions, kFlat).covering.empty();
    };
    EXPECT_TRUE(covers({line(at(0, 0, -5), at(1, 0, -5)), line(at(1, 0, -5), at(3, 0, -5))}));
    EXPECT_FALSE(covers({line(at(0, 0, -5), at(1, 0, -5)), line(at(1, 0, -5), at(2, 1e-5, -5))}));
    EXPECT_FALSE(covers({line(at(0, 0, -5), at(1, 0, -5)), line(at(1, 0, -5), at(0, 0, -5))}));
    EXPECT_FALSE(covers({line(at(0, 0, -5), at(1, 0, -5)), line(at(2, 0, -5), at(3, 0, -5))}));
    EXPECT_FALSE(covers({line(at(0, 0, -5), at(1, 0, -5)), line(at(1, 0, -5), at(1, 0, -6))}));
    EXPECT_FALSE(covers({line(at(0, 0, -5), at(9, 0, -5)), line(at(9, 0, -5), at(10.1, 0, -5))}));
    std::vector<gcode::Motion> rapid = straight(3, 1, 0, 0);
    rapid[1].kind = gcode::MoveKind::Rapid;
    EXPECT_FALSE(covers(rapid));
    EXPECT_FALSE(covers(straight(5, 1, 0, 50)));  // leaves the stock at once
}

}  // namespace
}  // namespace ncsim::toolpath
