// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of rotation_bounds.h against the motions of tools: random points of hulls and sweeps.
#include "ncsim/toolpath/rotation_bounds.h"

#include "ncsim/cda/polytope.h"
#include "ncsim/machine/presets.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/trace.h"
#include "ncsim/toolpath/walk.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::toolpath {
namespace {

using gcode::Angle;
using gcode::Length;
using gcode::Position;

constexpr double kInf = std::numeric_limits<double>::infinity();

struct Point2 {
    double r, h;
};

// Returns the half section of a round piece from axis to axis; arcs become chords within 1 µm.
std::vector<Point2> section_of(const ToolPiece& piece, double high, double low = -kInf) {
    const auto profile = slice(piece, low, high).profile;
    std::vector<Point2> line{{0.0, profile.front().height}};
    for (const ProfilePoint& corner : profile)
        line.push_back({corner.radius, corner.height});
    line.push_back({0.0, profile.back().height});
    return line;
}

// Returns the distance from the piece, 0 inside.
double distance_from(const std::vector<Point2>& line, Vec3 p_T) {
    const Point2 p{std::sqrt(p_T.x * p_T.x + p_T.y * p_T.y), p_T.z};
    bool inside = true;
    double least = kInf;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point2 a = line[i - 1];
        const Point2 way{line[i].r - a.r, line[i].h - a.h};
        const double squared = way.r * way.r + way.h * way.h;
        if (squared < 1e-18) continue;  // arcs that meet up to rounding
        const Point2 to{p.r - a.r, p.h - a.h};
        inside = inside && way.r * to.h - way.h * to.r >= 0.0;
        const double t = std::clamp((way.r * to.r + way.h * to.h) / squared, 0.0, 1.0);
        least = std::min(least, std::hypot(to.r - t * way.r, to.h - t * way.h));
    }
    return inside ? 0.0 : least;
}

Vec3 to_tool(const Pose& X_WT, Vec3 p_W) {
    const Vec3 p = p_W - X_WT.translation;
    const auto& r = X_WT.rows;
    return {r[0].x * p.x + r[1].x * p.y + r[2].x * p.z, r[0].y * p.x + r[1].y * p.y + r[2].y * p.z,
            r[0].z * p.x + r[1].z * p.y + r[2].z * p.z};
}

struct Case {
    ToolPiece piece;
    Position from, to;
    std::optional<Box> place;

    Position at(double t) const {
        const auto between = [t](double a, double b) { return a + t * (b - a); };
        Position p;
        p.x = Length::from_mm(between(from.x.mm(), to.x.mm()));
        p.y = Length::from_mm(between(from.y.mm(), to.y.mm()));
        p.z = Length::from_mm(between(from.z.mm(), to.z.mm()));
        p.a = Angle::from_degrees(between(from.a.degrees(), to.a.degrees()));
        p.b = Angle::from_degrees(between(from.b.degrees(), to.b.degrees()));
        p.c = Angle::from_degrees(between(from.c.degrees(), to.c.degrees()));
        return p;
    }
    // Samples of the motion in a single step.
    Samples samples() const {
        gcode::Motion motion;
        motion.action = gcode::Linear{from, to};
        SamplingOptions options;
        options.max_steps = 1;
        return sample(motion, {{extent_of(piece)}}, options, place);
    }
    // Returns the distance from the nearest of many poses of the tool; the true distance is smaller
    // by at most `error`.
    double distance_from_sweep(Vec3 p_W) const {
        const std::vector<Point2> section = section_of(piece, kInf);
        const auto distance = [&](double t) {
            return distance_from(section, to_tool(pose_at(at(t)), p_W));
        };
        double best = 0.0, least = kInf, width = 1.0 / 64;
        for (int i = 0; i <= 64; ++i) {
            const double d = distance(i / 64.0);
            if (d < least) best = i / 64.0, least = d;
        }
        for (; width > 1e-7 && least > 0.0; width /= 2) {
            for (const double t : {best - width, best + width}) {
                if (t < 0.0 || t > 1.0) continue;
                const double d = distance(t);
                if (d < least) best = t, least = d;
            }
        }
        return least;
    }
};

// Returns a point of the surface, mostly on an edge.
Vec3 point_of(const std::vector<Point2>& section, test::Random& random) {
    const std::size_t i = 1 + random.next() % (section.size() - 1);
    const Point2 a = section[i - 1], b = section[i];
    const double t = random.one_in(2) ? 0.0 : random.unit();
    const double r = a.r + t * (b.r - a.r);
    const double turn = 2 * std::numbers::pi * random.unit();
    return {r * std::cos(turn), r * std::sin(turn), a.h + t * (b.h - a.h)};
}

Position place_at(double x, double y, double z, double a, double b, double c) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    p.a = Angle::from_degrees(a), p.b = Angle::from_degrees(b), p.c = Angle::from_degrees(c);
    return p;
}

ToolPiece tool_of(test::Random& random) {
    const double d = random.within(2, 20);
    const double l = random.within(d, 60);
    switch (random.next() % 6) {
        case 0: return flat_end_mill(d, l).pieces[0];
        case 1: return ball_end_mill(d, l).pieces[0];
        case 2: return bull_nose_end_mill(d, d / 5, l).pieces[0];
        case 3: return drill(d, 118, l).pieces[0];
        case 4: return tapered_end_mill(d / 3, d / 6, 8, l).pieces[0];
        default: return lollipop_mill(d).pieces[0];
    }
}

// Random case: A about X alone, above or next to the axis; or arbitrary rotations.
Case random_case(test::Random& random) {
    Case c{tool_of(random), {}, {}, {}};
    const auto angle = [&] { return random.within(-180, 180); };
    const double turn = random.within(0.2, 4);
    const double aside = random.one_in(2) ? 0.0 : random.within(-1, 1);
    double x[6] = {random.within(-50, 50), random.within(-20, 20), random.within(-60, 60), 0, 0, 0};
    double v[6] = {aside, aside * random.within(-1, 1), aside * random.within(-1, 1), 0, 0, 0};
    switch (random.next() % 6) {
        case 0: x[3] = angle(), v[3] = turn; break;
        case 1: x[3] = angle() / 9, x[4] = angle(), v[4] = turn; break;
        case 2: x[3] = angle(), x[4] = angle(), x[5] = angle(), v[3] = turn; break;
        case 3: x[3] = angle(), x[4] = angle(), x[5] = angle(), v[4] = turn; break;
        case 4: x[3] = angle(), x[4] = angle(), v[5] = turn; break;
        default:
            for (int i = 3; i < 6; ++i)
                x[i] = angle(), v[i] = random.within(-1, 1) * turn;
    }
    c.from = place_at(x[0], x[1], x[2], x[3], x[4], x[5]);
    c.to = place_at(x[0] + v[0], x[1] + v[1], x[2] + v[2], x[3] + v[3], x[4] + v[4], x[5] + v[5]);
    if (random.one_in(2)) {
        // A box around a point of the tool; most of the tool is outside the box.
        const Vec3 at = pose_at(c.from) * Vec3{0, 0, random.within(0, 20)};
        const double size = random.within(2, 20);
        c.place = Box{at - Vec3{size, size, size}, at + Vec3{size, size, size}};
    }
    return c;
}

// Largest ratio of a measured value to its bound.
struct Worst {
    double ratio = 0.0;
    void add(double found, double bound) { ratio = std::max(ratio, found / bound); }
};

double worst_gain(const Case& c, int points, test::Random& random) {
    const Samples s = c.samples();
    Worst worst;
    if (is_above(extent_of(c.piece), s.turning.top_mm)) return worst.ratio;
    const auto section = section_of(c.piece, cut_off(extent_of(c.piece), s.turning.top_mm));
    for (int i = 0; i < points; ++i) {
        const double t = random.unit();
        const Vec3 p = (1 - t) * (s.poses[0] * point_of(section, random)) +
                       t * (s.poses[1] * point_of(section, random));
        if (c.place && !c.place->contains(p)) continue;
        worst.add(c.distance_from_sweep(p) - 1e-3, s.bounds.gained_mm);
    }
    return worst.ratio;
}

TEST(RotationBounds, NoPointOfAHullIsFartherFromTheSweepThanTheBound) {
    test::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        ASSERT_LE(worst_gain(random_case(random), 40, random), 1.0);
    }
}

// For each slab of a long tool separately: the gain is measured from the sweep of the whole tool.
double worst_gain_in_slabs(const Case& c, int points, test::Random& random) {
    const Samples s = c.samples();
    const PieceExtent whole = extent_of(c.piece);
    Worst worst;
    if (is_above(whole, s.turning.top_mm)) return worst.ratio;
    PieceExtent kept = whole;
    kept.high_mm = cut_off(whole, s.turning.top_mm);
    const double slab_mm = random.within(0.02, 1.0) * (kept.high_mm - kept.low_mm);
    const ToolExtent extents = split_into_slabs(below({{whole}}, s.turning.top_mm), slab_mm);
    const std::vector<Slab> slabs = slabs_of(kept, slab_mm);
    EXPECT_EQ(slabs.size(), extents.pieces.size());
    for (int i = 0; i < points; ++i) {
        const std::size_t k = random.next() % slabs.size();
        const double low = k > 0 ? slabs[k].low_mm : -kInf;
        const auto section = section_of(c.piece, slabs[k].high_mm, low);
        const double t = random.unit();
        const Vec3 p = (1 - t) * (s.poses[0] * point_of(section, random)) +
                       t * (s.poses[1] * point_of(section, random));
        if (c.place && !c.place->contains(p)) continue;
        const double bound = s.turning.chord_mm +
                             gained_mm(s.poses[0], s.poses[1], s.turning, {{extents.pieces[k]}});
        const double gained = c.distance_from_sweep(p) - 1e-3;
        if (gained > 0.0) worst.add(gained, bound);
    }
    return worst.ratio;
}

TEST(RotationBounds, NoPointOfTheHullOfASlabIsFartherFromTheSweepThanItsBound) {
    test::Random random(4);
    double worst = 0.0;
    for (int i = 0; i < 1500; ++i) {
        SCOPED_TRACE(i);
        worst = std::max(worst, worst_gain_in_slabs(random_case(random), 40, random));
        ASSERT_LE(worst, 1.0);
    }
    EXPECT_GT(worst, 0.4) << "the bound is not far from the truth";
}

// Gain of the cells that a cutter really removes, corner by corner: each cell is a slab of the
// stated length.
double worst_gain_of_cells(const Case& c, int points, test::Random& random) {
    const cda::Lattice lattice;
    Tool tool;
    tool.pieces.push_back(c.piece);
    Cutter cutter(tool, lattice, {0.2, Side::Circumscribed});
    Samples s = c.samples();
    Worst worst;
    const ToolExtent kept = below(cutter.extent(), s.turning.top_mm);
    s.turning.slab_mm = random.within(0.1, 1.0) * kept.pieces[0].high_mm;
    const ToolExtent slabs = split_into_slabs(kept, s.turning.slab_mm);
    std::vector<cda::Cell> cells;
    cutter.trace(s.poses[0], s.poses[1], {}, cells, simplification_of(s.turning));
    if (cells.empty()) return worst.ratio;
    EXPECT_EQ(cells.size(), slabs.pieces.size());
    const std::size_t k = random.next() % cells.size();
    const auto body = cda::ConvexPolytope::of(cells[k], lattice);
    if (!body) return worst.ratio;
    const double bound =
        s.turning.chord_mm + gained_mm(s.poses[0], s.poses[1], s.turning, {{slabs.pieces[k]}});
    const auto corner = [&] {
        const auto& corners = body->vertices();
        return lattice.unit_mm * corners[random.next() % corners.size()].approx;
    };
    for (int i = 0; i < points; ++i) {
        const double t = random.one_in(3) ? 0.0 : random.unit();
        const Vec3 p = (1 - t) * corner() + t * corner();
        if (c.place && !c.place->contains(p)) continue;
        const double gained = c.distance_from_sweep(p) - cutter.error_mm() - 1e-3;
        if (gained > 0.0) worst.add(gained, bound);
    }
    return worst.ratio;
}

TEST(RotationBounds, NoCornerOfACellIsFartherFromTheSweepThanTheBoundOfItsSlab) {
    test::Random random(5);
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        ASSERT_LE(worst_gain_of_cells(random_case(random), 30, random), 1.0);
    }
}

// The cylinder begins at a circle of corners, at a height in lattice units; conversion to
// millimetres and back is not always exact.
TEST(RotationBounds, ASlabIsAsLongAsItWasToldWhereverTheCylinderBegins) {
    const cda::Lattice lattice;
    const Pose from = pose_at(place_at(0, 0, 0, -0.1, 0, 0));
    const Pose to = pose_at(place_at(0, 0, 0, 0.1, 0, 0));
    const double slab_mm = 6.0;
    const double aside = 6 * std::sin(0.1 / 180 * std::numbers::pi) + 2e-5;
    for (int i = 0; i < 100; ++i) {
        const double height = 2.0 + 0.00137 * i;
        SCOPED_TRACE(height);
        Tool tool;
        tool.pieces.push_back({{{0, 0, 0}, {4, height, 0}, {4, 30, 0}}, true});
        Cutter cutter(tool, lattice, {});
        const auto slabs = slabs_of(cutter.extent().pieces[0], slab_mm);
        std::vector<cda::Cell> cells;
        cutter.trace(from, to, {}, cells, {.slab_mm = slab_mm});
        ASSERT_EQ(cells.size(), slabs.size());
        for (std::size_t k = 0; k < cells.size(); ++k) {
            EXPECT_GE(cells[k].bounds.min.z, slabs[k].low_mm - aside) << k;
            EXPECT_LE(cells[k].bounds.max.z, slabs[k].high_mm + aside) << k;
        }
    }
}

// A slab counts as rounded below, although a plane truncates the slab: the rolling ball in the
// bound extends below the plane by the radius of the ball.
TEST(RotationBounds, ASlabGainsWhereTheBallThatRollsAroundItReaches) {
    const Case c{flat_end_mill(20, 100).pieces[0],
                 place_at(0, 0, 50, 0, 0, 0),
                 place_at(4, 0, 50, 4, 0, 0),
                 {}};
    const Samples s = c.samples();
    const ToolExtent slabs = split_into_slabs({{extent_of(c.piece)}}, 25);
    const ToolExtent third{{slabs.pieces[2]}};
    const double gained = gained_mm(s.poses[0], s.poses[1], s.turning, third);
    RotationBounds lower = s.turning;
    for (const double below : {0.5, 5.0, 9.5}) {
        lower.top_mm = slabs.pieces[2].low_mm - below;
        EXPECT_EQ(gained_mm(s.poses[0], s.poses[1], lower, third), gained) << below;
    }
    lower.top_mm = slabs.pieces[2].low_mm - 12.0;
    EXPECT_EQ(gained_mm(s.poses[0], s.poses[1], lower, third), 0.0);
}

// Both ends move in opposite directions, so the gain of the undivided hull grows with the length.
TEST(RotationBounds, ALongToolIsCutIntoSlabsInsteadOfTurningInSmallSteps) {
    const auto taken_by = [](double length) {
        gcode::Motion motion;
        motion.action = gcode::Linear{place_at(0, 0, -20, 0, 0, 0), place_at(0, 0, -20, 10, 0, 0)};
        const ToolExtent tool = extent_of(flat_end_mill(6, length));
        const Samples s = sample(motion, tool, {});
        EXPECT_LE(s.bounds.gained_mm, SamplingOptions{}.rotation_gain_mm);
        EXPECT_LE(s.bounds.missed_mm, SamplingOptions{}.rotation_miss_mm);
        for (std::size_t i = 1; i < s.poses.size(); ++i) {
            EXPECT_LE(gained_mm(s.poses[i - 1], s.poses[i], s.turning,
                                split_into_slabs(tool, s.turning.slab_mm)),
                      s.bounds.gained_mm);
        }
        return s;
    };
    EXPECT_EQ(taken_by(12).turning.slab_mm, kInf);
    EXPECT_LT(taken_by(96).turning.slab_mm, 48.0);
    EXPECT_LT(taken_by(96).poses.size(), 4 * taken_by(12).poses.size());
}

// Half of the bound would be too small: for a tool that turns about a point on its axis, for a tool
// far from the axis of rotation, where only the width matters, and for a tool that also translates.
TEST(RotationBounds, TheBoundOfWhatIsGainedIsNotFarFromTheTruth) {
    test::Random random(2);
    const ToolPiece flat = flat_end_mill(10, 40).pieces[0];
    const ToolPiece thin = flat_end_mill(1, 40).pieces[0];
    const Case about_itself{flat, place_at(0, 0, -20, 0, 0, 0), place_at(0, 0, -20, 2, 0, 0), {}};
    const Case far_away{flat, place_at(0, 0, 40, 0, 0, 0), place_at(0, 0, 40, 2, 0, 0), {}};
    const Case goes_on{thin, place_at(0, 0, 20, 0, 0, 0), place_at(2, 0, 20, 2, 0, 0), {}};
    EXPECT_GT(worst_gain(about_itself, 4000, random), 0.5);
    EXPECT_GT(worst_gain(far_away, 4000, random), 0.5);
    EXPECT_GT(worst_gain(goes_on, 4000, random), 0.5);
}

// Rotation about a point of the tool axis.
TEST(RotationBounds, ACylinderGainsByItsHeightOrByItsWidthAndNotByBoth) {
    test::Random random(6);
    double worst = 0.0;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        const double d = random.within(2, 20);
        const double l = random.within(0.3, 3) * d;
        const double low = -random.within(0, 1) * l;
        const Case c{flat_end_mill(d, l).pieces[0],
                     place_at(0, 0, low, 0, 0, 0),
                     place_at(0, 0, low, random.within(1, 5), 0, 0),
                     {}};
        const Samples s = c.samples();
        const double s_mm = norm(axis_of(s.poses[1]) - axis_of(s.poses[0])) * std::max(d, l) / 4;
        EXPECT_LT(s.bounds.gained_mm, 1.06 * s_mm + s.bounds.missed_mm);
        const double ratio = worst_gain(c, 200, random);
        ASSERT_LE(ratio, 1.0);
        worst = std::max(worst, ratio);
    }
    EXPECT_GT(worst, 0.7) << "the bound is not far from the truth";
}

// A table at C90 with the stock does not change the effect of A and B.
TEST(RotationBounds, AxesThatStandStillTurnTheOnesBeforeThem) {
    const auto bounds = [](double b, double c, Box place) {
        return Case{ball_end_mill(10, 60).pieces[0], place_at(0, 50, 5, 0, b, c),
                    place_at(0, 50, 5, 4, b, c), place}
            .samples()
            .bounds;
    };
    const SampleBounds straight = bounds(0, 0, {{-5, 40, 0}, {5, 60, 20}});
    const SampleBounds turned = bounds(0, 90, {{-60, -5, 0}, {-40, 5, 20}});
    const SampleBounds twice = bounds(90, 90, {{-60, 0, -5}, {-40, 20, 5}});
    EXPECT_DOUBLE_EQ(turned.missed_mm, straight.missed_mm);
    EXPECT_DOUBLE_EQ(turned.gained_mm, straight.gained_mm);
    EXPECT_DOUBLE_EQ(twice.missed_mm, straight.missed_mm);
}

TEST(RotationBounds, ABallFarFromTheAxisGainsNothingOfFirstOrder) {
    const Box place{{-5, -45, -45}, {5, 45, 45}};
    const Case c{ball_end_mill(10, 60).pieces[0], place_at(0, 0, 40, 0, 0, 0),
                 place_at(0, 0, 40, 1, 0, 0), place};
    const Samples s = c.samples();
    EXPECT_LT(s.bounds.gained_mm, 1.5 * s.bounds.missed_mm);
}

TEST(RotationBounds, NoPointOfTheSweepIsFartherFromTheHullThanTheBound) {
    test::Random random(3);
    const cda::Lattice lattice;
    double worst = 0.0;
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        const Case c = random_case(random);
        Samples s = c.samples();
        const auto section = section_of(c.piece, kInf);
        // In half the cases, the total that slabs miss.
        if (random.one_in(2)) s.turning.slab_mm = random.within(1, 30);
        Tool tool;
        tool.pieces.push_back(c.piece);
        Cutter cutter(tool, lattice, {0.02, Side::Circumscribed});
        std::vector<cda::Cell> cells;
        cutter.trace(s.poses[0], s.poses[1], {}, cells, simplification_of(s.turning));
        for (int k = 0; k < 50; ++k) {
            const Vec3 p = pose_at(c.at(random.unit())) * point_of(section, random);
            if (c.place && !c.place->contains(p)) continue;
            ASSERT_FALSE(cells.empty()) << "a piece that comes there";
            const Vec3 q = (1 / lattice.unit_mm) * p;
            double beyond = kInf;
            for (const cda::Cell& cell : cells) {
                double beyond_this = 0.0;
                for (const cda::Plane& plane : cell.planes) {
                    const Vec3 n{double(plane.nx), double(plane.ny), double(plane.nz)};
                    const double over = dot(n, q) - static_cast<double>(plane.d);
                    beyond_this = std::max(beyond_this, lattice.unit_mm * over / norm(n));
                }
                beyond = std::min(beyond, beyond_this);
            }
            ASSERT_LE(beyond, s.bounds.missed_mm + 4e-5);
            if (s.bounds.missed_mm > 0) worst = std::max(worst, beyond / s.bounds.missed_mm);
        }
    }
    EXPECT_GT(worst, 0.5);
}

// A shank is longer than the cutter, so its hull gains more. A check of the shank requests steps
// small enough for the shank, too.
TEST(Walk, TakesStepsThatAreSmallEnoughForShanksWhereTheyAreWatched) {
    Tool tool = flat_end_mill(10.0, 5.0);
    add_holder_segment(tool, 10.0, 10.0, 60.0);
    gcode::Motion motion;
    motion.action = gcode::Linear{place_at(0, 0, -20, 0, 0, 0), place_at(0, 0, -20, 10, 0, 0)};
    motion.kind = gcode::MoveKind::Feed;
    motion.tool = 1;
    motion.known_start = motion.known_end = {true, true, true};
    const Box stock{{-50, -50, -50}, {50, 50, 50}};
    const auto worst_of_shank = [&](bool shanks) {
        Walk walk(cda::Lattice::for_stock(stock), stock, {.watch = {{}, shanks}});
        walk.add_tool(1, tool);
        double worst = 0.0;
        walk.take(motion, {}, [&](const Step& step) {
            const ToolExtent shank{{extent_of(tool.pieces[1])}};
            worst = std::max(worst, gained_mm(step.X_WA, step.X_WB, step.turning,
                                              split_into_slabs(shank, step.turning.slab_mm)));
        });
        return worst;
    };
    EXPECT_GT(worst_of_shank(false), 2 * SamplingOptions{}.rotation_gain_mm);
    EXPECT_LE(worst_of_shank(true), SamplingOptions{}.rotation_gain_mm);
}

// The number of steps is an integer, so part of the permitted gain is left over; facets use the
// rest, and no step is added for facets.
// The ball rolls inside the piece: its centre is the radius away from the bottom, and from the wall
// at the rim.
TEST(RotationBounds, CoreIsThePieceWithoutItsRounding) {
    struct Row {
        Tool tool;
        double fillet, wall_degrees;  ///< Angle of the wall with the axis.
        bool is_closed;               ///< The rounding goes over the top, too.
    };
    for (const Row& row :
         {Row{bull_nose_end_mill(10, 2, 30), 2, 0, false}, Row{ball_end_mill(10, 30), 5, 0, false},
          Row{tapered_end_mill(4, 2, 8, 30), 2, 8, false},
          Row{tapered_end_mill(6, 1, 20, 25), 1, 20, false}, Row{lollipop_mill(12), 6, 0, true}}) {
        SCOPED_TRACE(row.tool.pieces[0].profile.back().height);
        const PieceExtent e = extent_of(row.tool.pieces[0]);
        const double wall = row.wall_degrees * std::numbers::pi / 180;
        EXPECT_NEAR(e.core_low_mm, row.fillet, 1e-9);
        const double top = height_of(row.tool);
        EXPECT_NEAR(e.core_high_mm,
                    row.is_closed ? top - row.fillet : top + row.fillet * std::sin(wall), 1e-9);
        EXPECT_NEAR(e.core_radius_mm,
                    cutting_diameter_of(row.tool) / 2 - row.fillet * std::cos(wall), 1e-9);
        EXPECT_EQ(e.open_above, !row.is_closed);
        EXPECT_GE(e.core_high_mm, e.core_low_mm);
    }
    const PieceExtent flat = extent_of(flat_end_mill(10, 30).pieces[0]);
    EXPECT_EQ(flat.core_low_mm, 0.0);
    EXPECT_EQ(flat.core_high_mm, 30.0);
    EXPECT_EQ(flat.core_radius_mm, 5.0);
}

// A motion needs about as many steps as its halves together.
TEST(RotationBounds, StepsOfAMotionAreThoseOfItsHalves) {
    test::Random random(8);
    const ToolExtent tool = extent_of(flat_end_mill(10, 30));
    const auto steps = [&](const Position& from, const Position& to) {
        gcode::Motion motion;
        motion.action = gcode::Linear{from, to};
        return sample(motion, tool, SamplingOptions{}).poses.size() - 1;
    };
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        double at[2][6];
        for (auto& place : at) {
            for (int k = 0; k < 6; ++k)
                place[k] = k < 3 ? random.within(-30, 30) : random.within(-90, 90);
        }
        const auto& a = at[0];
        const auto& b = at[1];
        const Position from = place_at(a[0], a[1], a[2], a[3], a[4], a[5]);
        const Position to = place_at(b[0], b[1], b[2], b[3], b[4], b[5]);
        const Position middle = place_at((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2,
                                         (a[3] + b[3]) / 2, (a[4] + b[4]) / 2, (a[5] + b[5]) / 2);
        const std::size_t whole = steps(from, to);
        const std::size_t halves = std::max(steps(from, middle), steps(middle, to));
        EXPECT_LE(whole, 3 * halves + 1) << "bounds of the whole hold for its worst half";
        EXPECT_GE(whole, halves);
    }
}

TEST(RotationBounds, PlacesAreAsFarAsFromEachAxis) {
    Kinematics machine{*machine::preset("xyzac-trt"), {}};
    std::vector<machine::Joint*> rotary;
    for (machine::Joint& joint : machine.chain.joints) {
        if (joint.turns) rotary.push_back(&joint);
    }
    ASSERT_EQ(rotary.size(), 2U);
    gcode::Motion motion;
    motion.action = gcode::Linear{place_at(0, 0, 0, 0, 0, 0), place_at(0, 0, 0, 20, 0, 20)};
    const ToolExtent tool = extent_of(flat_end_mill(10, 30));
    for (const Vec3& apart : {Vec3{0, 0, 0}, Vec3{0, 80, 0}, Vec3{0, 30, -40}}) {
        for (const int moved : {0, 1}) {
            rotary[0]->through = rotary[1]->through = {};
            rotary[static_cast<std::size_t>(moved)]->through = apart;
            for (const Vec3& p : {Vec3{0, 0, 0}, apart, Vec3{5, -20, 10}}) {
                const Samples samples =
                    sample(motion, tool, SamplingOptions{}, Box{p, p}, &machine);
                for (const machine::Joint* joint : rotary) {
                    const Vec3 v = p - joint->through;
                    const double far = norm(v - dot(v, joint->direction) * joint->direction);
                    EXPECT_GE(samples.turning.place_mm, far - 1e-9);
                }
            }
        }
    }
}

// No bound is negative, and none decreases if the tool turns farther, moves farther, is farther
// away, or if more places matter.
TEST(RotationBounds, GrowWithEachOfTheirValues) {
    using Value = double RotationBounds::*;
    const std::vector<std::pair<Value, std::vector<double>>> values{
        {&RotationBounds::turn_rad, {0.0, 0.01, 0.1, 0.5}},
        {&RotationBounds::tilt_rad, {0.0, 0.05, 0.3}},
        {&RotationBounds::tilt_bend_rad, {0.0, 0.002, 0.1}},
        {&RotationBounds::moved_mm, {0.0, 0.1, 3.0}},
        {&RotationBounds::tip_mm, {0.0, 8.0, 100.0}},
        {&RotationBounds::lean, {0.0, 0.4, 1.0}},
        {&RotationBounds::place_mm, {0.0, 3.0, 20.0, 150.0, kInf}}};
    const Pose start = pose_at(place_at(0, 0, 0, 0, 0, 0));
    const Pose end = pose_at(place_at(0, 0, 0, 0, 0, 2));
    const auto missed = [](const RotationBounds& t, const ToolExtent& tool) {
        return missed_mm(t, tool);
    };
    const auto gained = [&](const RotationBounds& t, const ToolExtent& tool) {
        return gained_mm(start, end, t, tool);
    };
    for (const Tool& tool : {face_mill(100, 10), flat_end_mill(6, 40), ball_end_mill(10, 30)}) {
        const ToolExtent extent{{extent_of(tool.pieces[0])}};
        test::Random random(3);
        for (int i = 0; i < 400; ++i) {
            RotationBounds t;
            for (const auto& [member, choices] : values)
                t.*member = choices[random.next() % choices.size()];
            const double least_missed = missed(t, extent), least_gained = gained(t, extent);
            EXPECT_GE(least_missed, 0.0);
            EXPECT_GE(least_gained, 0.0);
            for (const auto& [member, choices] : values) {
                RotationBounds more = t;
                for (const double choice : choices) {
                    if (choice <= t.*member) continue;
                    more.*member = choice;
                    EXPECT_GE(missed(more, extent), least_missed);
                    EXPECT_GE(gained(more, extent), least_gained * (1 - 1e-12));
                }
            }
        }
    }
}

TEST(Walk, LeavesFacetsWhatStepsDoNotGain) {
    const Tool tool = flat_end_mill(6.0, 6.0);
    const Box stock{{-20, -20, -20}, {20, 20, 0}};
    const double most = SamplingOptions{}.rotation_gain_mm;
    const auto turned = [&](double degrees) {
        Walk walk(cda::Lattice::for_stock(stock), stock, {});
        walk.add_tool(1, tool);
        gcode::Motion motion;
        motion.action =
            gcode::Linear{place_at(0, 0, -5, 0, 0, 0), place_at(0, 0, -5, degrees, 0, 0)};
        motion.kind = gcode::MoveKind::Feed;
        motion.tool = 1;
        motion.known_start = motion.known_end = {true, true, true};
        int steps = 0;
        const SampleBounds bounds = walk.take(motion, {}, [&](const Step&) { ++steps; });
        return std::pair{steps, bounds.gained_mm};
    };
    // 1.7 degrees of a width of 6 mm gain 0.0445 mm.
    const auto [few, whole] = turned(3.4);
    EXPECT_EQ(few, 2);
    EXPECT_GT(whole, 0.99 * most);
    EXPECT_LE(whole, most);
    const auto [same, part] = turned(2.2);
    EXPECT_EQ(same, 2);
    EXPECT_GT(part, 0.0287 + 0.29 * most);
    EXPECT_LE(part, most);
}

}  // namespace
}  // namespace ncsim::toolpath
