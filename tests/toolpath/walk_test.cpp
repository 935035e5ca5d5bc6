// SPDX-License-Identifier: GPL-3.0-or-later
//
// The walk recognises the end of a whole turn that leaves no core, and the end of a straight path
// in pieces.
#include "ncsim/toolpath/walk.h"

#include "ncsim/cda/tree.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ncsim::toolpath {
namespace {

using gcode::Length;

gcode::Position at(double x, double y, double z) {
    gcode::Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

gcode::Motion motion(decltype(gcode::Motion::action) action) {
    gcode::Motion m;
    m.kind = gcode::MoveKind::Feed;
    m.tool = 1;
    m.action = std::move(action);
    return m;
}

gcode::Motion line(gcode::Position from, gcode::Position to) {
    return motion(gcode::Linear{from, to});
}

// Returns an arc about (x, y) with `turns` as in gcode::Arc.
gcode::Motion arc(gcode::Position from, gcode::Position to, int turns = 1, double x = 0.0,
                  double y = 0.0) {
    gcode::Arc arc;
    arc.from = from, arc.to = to;
    arc.centre_1 = Length::from_mm(x), arc.centre_2 = Length::from_mm(y);
    arc.turns = turns;
    return motion(arc);
}

const Box kStock{{-20, -20, -20}, {20, 20, 0}};

struct Walked {
    std::vector<cda::Cell> cells, merged_cells;
    std::vector<std::size_t> steps;  // number of cells before each covering cell
};

// Walks the motions. A covering cell is a subset of the cells before it, so a covering cell removes
// no volume when subtracted last.
Walked walked(const std::vector<gcode::Motion>& motions, const Tool& tool) {
    const auto lattice = cda::Lattice::for_stock(kStock);
    Walk walk(lattice, kStock, {});
    walk.add_tool(1, tool);
    const auto unit = [&](double mm) { return std::llround(mm / lattice.unit_mm); };
    cda::TreeCda part(
        cda::box_cell({unit(-20), unit(-20), unit(-20)}, {unit(20), unit(20), unit(0)}, lattice),
        lattice);
    Walked result;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        walk.take(motions[i], cda::Origin{static_cast<std::uint32_t>(i + 1)}, [&](const Step& s) {
            const auto cover = [&](std::span<const cda::Cell> cells) {
                for (const cda::Cell& cell : cells) {
                    EXPECT_EQ(part.subtract(cell), 0.0);
                    EXPECT_LE(cell.origin, cda::Origin{static_cast<std::uint32_t>(i + 1)});
                    result.merged_cells.push_back(cell);
                    result.steps.push_back(result.cells.size());
                }
            };
            cover(s.preceding_cells);
            result.cells.insert(result.cells.end(), s.cells.begin(), s.cells.end());
            part.subtract_unmeasured(s.cells);
            cover(s.merged_cells);
        });
    }
    return result;
}

const Tool kFlat = flat_end_mill(10, 40);

TEST(Walk, CoversAFullCircle) {
    for (const int turns : {1, -1}) {
        const Walked w = walked(
            {line(at(0, 0, -5), at(4, 0, -5)), arc(at(4, 0, -5), at(4, 0, -5), turns)}, kFlat);
        ASSERT_EQ(w.merged_cells.size(), 1U);
        EXPECT_EQ(w.steps[0], w.cells.size());
        for (const cda::Cell& cell : w.cells)
            EXPECT_LT(w.merged_cells[0].rank, cell.rank);
    }
}

TEST(Walk, CoversACircleInHalvesAndQuarters) {
    EXPECT_EQ(walked({arc(at(4, 0, -5), at(-4, 0, -5)), arc(at(-4, 0, -5), at(4, 0, -5))}, kFlat)
                  .merged_cells.size(),
              1U);
    // Centres anywhere; circles about different centres are not one.
    for (const auto& [x, y] : {std::pair{0.0, 3.0}, {3.0, 0.0}, {-2.0, -3.0}}) {
        EXPECT_EQ(walked({arc(at(x + 4, y, -5), at(x - 4, y, -5), 1, x, y),
                          arc(at(x - 4, y, -5), at(x + 4, y, -5), 1, x, y)},
                         kFlat)
                      .merged_cells.size(),
                  1U);
    }
    // Centres have an error of some micrometres; an arc leads in and a second arc leads out.
    const Walked w =
        walked({arc(at(2, -2, -5), at(4, 0, -5), 1, 2, 0), arc(at(4, 0, -5), at(0, 4, -5)),
                arc(at(0, 4, -5), at(-4, 0, -5), 1, 0, 0.002),
                arc(at(-4, 0, -5), at(0, -4, -5), 1, 0.001, 0), arc(at(0, -4, -5), at(4, 0, -5)),
                arc(at(4, 0, -5), at(2, 2, -5), 1, 2, 0)},
               kFlat);
    ASSERT_EQ(w.merged_cells.size(), 1U);
    EXPECT_EQ(w.merged_cells[0].origin, cda::Origin{5});
}

TEST(Walk, CoversEachTurnOfAHelix) {
    std::vector<gcode::Motion> motions;
    for (int i = 0; i < 3; ++i)
        motions.push_back(arc(at(4, 0, -2 * i), at(4, 0, -2 * i - 2)));
    motions.push_back(arc(at(4, 0, -6), at(4, 0, -6)));
    const Walked lines = walked(motions, kFlat);
    ASSERT_EQ(lines.merged_cells.size(), 4U);
    EXPECT_DOUBLE_EQ(lines.merged_cells[2].bounds.min.z, -4.0);
    EXPECT_DOUBLE_EQ(lines.merged_cells[3].bounds.min.z, -6.0);
    const Walked once =
        walked({arc(at(4, 0, 0), at(4, 0, -6), 3), arc(at(4, 0, -6), at(4, 0, -6))}, kFlat);
    EXPECT_EQ(once.merged_cells.size(), 4U);
    // The same helix upwards adds no further covering cell.
    EXPECT_EQ(walked({arc(at(4, 0, -6), at(4, 0, -2))}, kFlat).merged_cells.size(), 1U);
}

// For a tool with a round nose, the part above the nose.
TEST(Walk, CoversWhatTheCylinderOfAToolTakes) {
    const Walked w = walked({arc(at(3, 0, -9), at(3, 0, -9))}, ball_end_mill(10, 40));
    ASSERT_EQ(w.merged_cells.size(), 1U);
    EXPECT_NEAR(w.merged_cells[0].bounds.min.z, -4.0, 0.01);
}

TEST(Walk, CoversNothingElse) {
    const auto covers = [](const std::vector<gcode::Motion>& motions, const Tool& tool = kFlat) {
        return !walked(motions, tool).merged_cells.empty();
    };
    EXPECT_TRUE(covers({arc(at(4.8, 0, -5), at(4.8, 0, -5))}));
    EXPECT_FALSE(covers({arc(at(5.1, 0, -5), at(5.1, 0, -5))}));  // a core
    EXPECT_FALSE(covers({arc(at(4, 0, -5), at(0, 4, -5)), arc(at(0, 4, -5), at(0, -4, -5))}));
    EXPECT_FALSE(covers({arc(at(4, 0, -5), at(-4, 0, -5)), line(at(-4, 0, -5), at(-4, 0, 5)),
                         line(at(-4, 0, 5), at(-4, 0, -5)), arc(at(-4, 0, -5), at(4, 0, -5))}));
    // There and back.
    EXPECT_FALSE(covers({arc(at(4, 0, -5), at(-4, 0, -5)), arc(at(-4, 0, -5), at(4, 0, -5), -1)}));
    // A turn during which the table turns as well.
    gcode::Position turned = at(4, 0, -5);
    turned.c = gcode::Angle::from_degrees(30);
    EXPECT_FALSE(covers({arc(at(4, 0, -5), turned)}));
}

// Appends a move away from the part, because a straight path is reported at the first motion that
// does not continue the path.
std::vector<gcode::Motion> and_away(std::vector<gcode::Motion> motions) {
    const gcode::Position end = std::get<gcode::Linear>(motions.back().action).to;
    gcode::Position up = end;
    up.z = Length::from_mm(50);
    motions.push_back(line(end, up));
    motions.back().kind = gcode::MoveKind::Rapid;
    return motions;
}

std::vector<gcode::Motion> straight(int count, double x, double y, double z) {
    std::vector<gcode::Motion> motions;
    for (int i = 0; i < count; ++i)
        motions.push_back(line(at(-9 + i * x, i * y, -5 + i * z),
                               at(-9 + (i + 1) * x, (i + 1) * y, -5 + (i + 1) * z)));
    return motions;
}

// A straight path in pieces becomes a single cell if the pieces are no longer than the tool is
// wide. The line that removed a point first is known only to this accuracy.
TEST(Walk, CoversAStraightWayInPieces) {
    for (const Tool& tool : {kFlat, ball_end_mill(10, 40)}) {
        for (const double slope : {0.0, 0.25}) {
            // Seven pieces are at most 9.3 mm long, eight at least 10.4 mm.
            const Walked w = walked(and_away(straight(8, 1.2, 0.5, slope)), tool);
            ASSERT_EQ(w.merged_cells.size(), 1U);
            EXPECT_EQ(w.merged_cells[0].origin, cda::Origin{7});
            EXPECT_EQ(w.steps[0], 7U);
            for (const cda::Cell& cell : w.cells)
                EXPECT_LT(w.merged_cells[0].rank, cell.rank);
            EXPECT_EQ(walked(and_away(straight(17, 1.2, 0.5, 0)), tool).merged_cells.size(), 3U);
            EXPECT_TRUE(walked(straight(7, 1.2, 0.5, slope), tool).merged_cells.empty());
        }
    }
}

// Arcs, tool changes and rotary moves end a straight path as well.
TEST(Walk, TellsAStraightWayWithWhateverComesNext) {
    std::vector<gcode::Motion> motions = straight(4, 1, 0, 0);
    motions.push_back(arc(at(-5, 0, -5), at(-5, 0, -5), 1, -5, 2));
    const Walked w = walked(motions, kFlat);
    ASSERT_EQ(w.merged_cells.size(), 2U);  // the straight path and the circle
    EXPECT_EQ(w.steps[0], 4U);
    EXPECT_EQ(w.merged_cells[0].origin, cda::Origin{4});
    EXPECT_EQ(w.merged_cells[1].origin, cda::Origin{5});
    EXPECT_LT(w.steps[0], w.steps[1]);
    motions = straight(4, 1, 0, 0);
    gcode::Position turned = at(-5, 1, -5);
    turned.a = gcode::Angle::from_degrees(1);
    motions.push_back(line(at(-5, 0, -5), turned));
    EXPECT_EQ(walked(motions, kFlat).merged_cells.size(), 1U);
}

// Moves that do not meet the stock may have the number of a different motion. The line of a
// straight path is the last line that met the stock, and each tile reports the same line.
TEST(Walk, NamesAStraightWayByTheLastMoveThatMeetsTheStock) {
    std::vector<gcode::Motion> motions;
    for (int i = 0; i < 6; ++i)
        motions.push_back(line(at(21.5 + i, 0, -5), at(22.5 + i, 0, -5)));
    motions = and_away(motions);
    const auto lattice = cda::Lattice::for_stock(kStock);
    for (const bool is_tile : {false, true}) {
        Walk walk(lattice, kStock, {});
        walk.add_tool(1, kFlat);
        if (is_tile) walk.restrict_cells(Box{{19, -20, -20}, {20, 20, 0}});
        std::vector<cda::Cell> merged_cells;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            walk.take(motions[i], cda::Origin{static_cast<std::uint32_t>(i + 1)},
                      [&](const Step& s) {
                          merged_cells.insert(merged_cells.end(), s.preceding_cells.begin(),
                                              s.preceding_cells.end());
                      });
        }
        // The tool extends 5 mm to the left: to 19.5 with the third, to 20.5 with the fifth.
        ASSERT_EQ(merged_cells.size(), 1U);
        EXPECT_EQ(merged_cells[0].origin, cda::Origin{4});
    }
}

// A path past a corner of the stock: the joint bounds of both steps overlap the stock, but neither
// step's bounds do.
TEST(Walk, TellsNoStraightWayThatDidNotMeetTheStock) {
    const Walked w = walked(and_away({line(at(22.2, 28.2, -5), at(25.2, 25.2, -5)),
                                      line(at(25.2, 25.2, -5), at(28.2, 22.2, -5))}),
                            kFlat);
    EXPECT_TRUE(w.cells.empty());
    EXPECT_TRUE(w.merged_cells.empty());
}

// For any slope: a covering cell is contained in the steps exactly, and is omitted if rounding of
// the walls prevents containment.
TEST(Walk, CoversStraightWaysExactlyOrNot) {
    test::Random random(5);
    int specified = 0, kept_back = 0;
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        // Decimals as in programs: a tenth to a thousandth of a millimetre.
        const std::int64_t unit = random.between(0, 2) == 0 ? 10
                                  : random.between(0, 1)    ? 100
                                                            : 1000;
        const auto step = [&] {
            return static_cast<double>(random.between(-1000, 1000) / unit * unit) / 1000.0;
        };
        const double x = step(), y = step(), z = i % 2 == 0 ? 0.0 : 0.2 * step();
        if (x == 0.0 && y == 0.0) continue;
        const std::size_t count =
            walked(and_away(straight(4, x, y, z)), i % 3 == 0 ? ball_end_mill(8, 40) : kFlat)
                .merged_cells.size();
        EXPECT_TRUE(i % 2 != 0 || i % 3 == 0 || count == 1U)
            << count;  // horizontal, vertical walls
        (count > 0 ? specified : kept_back) += 1;
    }
    EXPECT_GT(specified, 20);
    EXPECT_GT(kept_back, 2);
}

TEST(Walk, CoversNoWayThatIsNotStraight) {
    const auto covers = [](const std::vector<gcode::Motion>& motions) {
        return !walked(and_away(motions), kFlat).merged_cells.empty();
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
