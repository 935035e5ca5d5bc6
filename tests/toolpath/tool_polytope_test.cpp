// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/tool_polytope.h"

#include "ncsim/cda/hull.h"
#include "ncsim/cda/polytope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

namespace ncsim::toolpath {
namespace {

constexpr cda::Lattice kLattice{1e-5};

cda::ConvexPolytope polytope_of(const PiecePolytope& piece) {
    const auto cell = cda::convex_hull(piece.points_T, kLattice, cda::kStockOrigin);
    return *cda::ConvexPolytope::of(*cell, kLattice);
}

std::int64_t largest_x(const PiecePolytope& piece) {
    std::int64_t x = 0;
    for (const auto& p : piece.points_T)
        x = std::max(x, p.x);
    return x;
}

// Returns the signed distance of a point from a ball end mill of radius r, positive outside. The
// point is at or below the upper end.
double outside_ball_nose(Vec3 p, double r) {
    const double aside = std::hypot(p.x, p.y);
    return p.z < r ? std::hypot(aside, p.z - r) - r : aside - r;
}

TEST(ToolPolytope, OfNothingIsNothing) {
    EXPECT_TRUE(approximate({}, kLattice, {}).points_T.empty());
    EXPECT_TRUE(approximate({{{0, 0, 0}, {0, 5, 0}}, true}, kLattice, {}).points_T.empty());
}

TEST(ToolPolytope, FlatEndMillHasItsNominalWidthInXAndY) {
    for (const double diameter : {10.0, 3.175, 0.1, 19.05, 100.0, 6.00001}) {
        SCOPED_TRACE(diameter);
        const PiecePolytope mill = approximate(flat_end_mill(diameter, 20).pieces[0], kLattice, {});
        const auto radius = static_cast<std::int64_t>(std::ceil(diameter / 2 / 1e-5 - 1e-6));
        EXPECT_EQ(largest_x(mill), radius);
        const cda::ConvexPolytope p = polytope_of(mill);
        for (const cda::Plane plane :
             {cda::Plane{1, 0, 0, radius}, cda::Plane{-1, 0, 0, radius},
              cda::Plane{0, 1, 0, radius}, cda::Plane{0, -1, 0, radius}, cda::Plane{0, 0, -1, 0}}) {
            EXPECT_TRUE(p.facet_in(plane));
        }
        EXPECT_EQ(p.facets().size(), static_cast<std::size_t>(mill.sides) + 2);
        EXPECT_EQ(mill.sides % 4, 0);
    }
}

TEST(ToolPolytope, OfAShankAsThickAsWhatIsBelowHasItsCorners) {
    const ToolPiece shank{{{5.188 / 2, 6.0, 0}, {5.188 / 2, 30.0, 0}}, false};
    const ToolPiece ball = ball_end_mill(5.188, 6.0).pieces[0];
    for (const Side side : {Side::Circumscribed, Side::Inscribed}) {
        ToolAccuracy accuracy;
        accuracy.side = side;
        const PiecePolytope below = approximate(ball, kLattice, accuracy);
        const PiecePolytope above = approximate_above(ball, shank, kLattice, accuracy);
        EXPECT_EQ(above.points_T.size(), 2 * static_cast<std::size_t>(below.sides));
        for (const cda::LatticePoint& p : above.points_T) {
            EXPECT_TRUE(p.z == 600000 || p.z == 3000000);
            EXPECT_TRUE(std::ranges::any_of(below.points_T, [&p](const cda::LatticePoint& q) {
                return p.x == q.x && p.y == q.y;
            }));
        }
        // A thicker piece has separate corners.
        const ToolPiece thick{{{3.0, 6.0, 0}, {3.0, 30.0, 0}}, false};
        EXPECT_EQ(approximate_above(ball, thick, kLattice, accuracy).points_T,
                  approximate(thick, kLattice, accuracy).points_T);
    }
}

TEST(ToolPolytope, StaysWithinTheToleranceItReports) {
    for (const double diameter : {1.0, 6.0, 10.0, 25.4, 80.0}) {
        for (const double tolerance : {0.2, 0.05, 0.01}) {
            SCOPED_TRACE(testing::Message() << diameter << " within " << tolerance);
            const double r = diameter / 2;
            if (tolerance < r / 1000) continue;
            const PiecePolytope flat =
                approximate(flat_end_mill(diameter, 20).pieces[0], kLattice, {tolerance});
            const PiecePolytope ball =
                approximate(ball_end_mill(diameter, r + 20).pieces[0], kLattice, {tolerance});
            EXPECT_LE(flat.error_mm, tolerance);
            EXPECT_LE(ball.error_mm, tolerance);
            for (const auto& corner : flat.points_T) {
                const Vec3 p = kLattice.to_mm(corner);
                EXPECT_LE(std::hypot(p.x, p.y) - r, flat.error_mm);
                EXPECT_GE(std::hypot(p.x, p.y), r);
            }
            for (const auto& corner : ball.points_T) {
                EXPECT_LE(outside_ball_nose(kLattice.to_mm(corner), r), ball.error_mm);
            }
        }
    }
}

// 35.978 mm are 8 · 25 · 17989 units. Multiples of the only divisor of suitable size, 0.18 mm, are
// too far apart for the tip.
TEST(ToolPolytope, StaysWithinItsToleranceWhereTheRadiusHasNoFineDivisor) {
    for (const Side side : {Side::Circumscribed, Side::Inscribed}) {
        const PiecePolytope piece =
            approximate(v_cutter(71.956, 3.35, 75, 80).pieces[0], kLattice, {0.05, side});
        EXPECT_LE(piece.error_mm, 0.05);
        EXPECT_NEAR(static_cast<double>(largest_x(piece)), 3597800,
                    side == Side::Circumscribed ? 10 : 10000);
    }
}

TEST(ToolPolytope, CircumscribedContainsTheBallAndInscribedIsContainedInIt) {
    for (const double diameter : {2.0, 3.175, 6.0, 16.0}) {
        SCOPED_TRACE(diameter);
        const double r = diameter / 2;
        const ToolPiece piece = ball_end_mill(diameter, r + 10).pieces[0];
        const PiecePolytope around = approximate(piece, kLattice, {0.05, Side::Circumscribed});
        const PiecePolytope within = approximate(piece, kLattice, {0.05, Side::Inscribed});
        // No facet of the outer polytope may be closer to the centre of the ball than r.
        const cda::ConvexPolytope outer = polytope_of(around);
        for (const auto& facet : outer.facets()) {
            const double d = offset_mm(facet.plane, kLattice) - r * unit_normal(facet.plane).z;
            EXPECT_GE(d, r - 1e-9);
        }
        for (const auto& corner : within.points_T) {
            EXPECT_LE(outside_ball_nose(kLattice.to_mm(corner), r), 2e-5);
        }
        EXPECT_LE(within.error_mm, 0.05);
        const double exact = std::numbers::pi * r * r * 10 + 2.0 / 3 * std::numbers::pi * r * r * r;
        const double unit3 = 1e-15;
        EXPECT_GT(outer.volume() * unit3, exact);
        EXPECT_LT(polytope_of(within).volume() * unit3, exact);
    }
}

// A cone ends in a disc at a height between two lattice points. Rounding only the rim to the next
// lattice height would shrink the cone by nanometres. The last case is the cone of a holder that
// begins in a disc at such a height.
TEST(ToolPolytope, CircumscribedContainsAConeWithoutACylinderBesideIt) {
    Tool holder;
    add_holder_segment(holder, 5, 5, 3.123456789);
    add_holder_segment(holder, 45.17, 32, 8.7);
    for (const Tool& tool : {v_cutter(71.76278, 0, 120, 19), v_cutter(6, 0.5, 70, 1),
                             drill(5, 118, 1), tapered_end_mill(3, 0, 5, 20.000004), holder}) {
        const ToolPiece& piece = tool.pieces.back();
        SCOPED_TRACE(testing::Message() << name_of(tool.kind) << ' ' << piece.profile[1].height);
        const cda::ConvexPolytope outer = polytope_of(approximate(piece, kLattice, {0.2}));
        for (const auto& facet : outer.facets()) {
            const Vec3 n = unit_normal(facet.plane);
            for (const ProfilePoint& p : piece.profile) {
                const double farthest = std::hypot(n.x, n.y) * p.radius + n.z * p.height;
                EXPECT_GE(offset_mm(facet.plane, kLattice), farthest - 1e-10);
            }
        }
    }
}

// Planes with rounded normals do not meet in a common corner, so each corner splits into several.
// With exact corners, a hole with a drill point has 9,000 edges; with split corners, 20,000 more of
// nanometre length.
TEST(ToolPolytope, FacetsOfConesMeetInTheirCorners) {
    std::vector<Tool> tools;
    for (int tenths = 4; tenths <= 200; tenths += 7) {
        for (const double point : {90.0, 118.0, 140.0})
            tools.push_back(drill(tenths / 10.0, point, 60));
    }
    for (int sixtyfourths = 1; sixtyfourths <= 32; sixtyfourths += 2)
        tools.push_back(drill(sixtyfourths * 25.4 / 64, 118, 60));
    for (const double angle : {20.0, 60.0, 90.0}) {
        for (const double diameter : {3.175, 6.0, 32.0})
            tools.push_back(v_cutter(diameter, 0, angle, 70));
    }
    for (const Tool& tool : tools) {
        for (const Side side : {Side::Circumscribed, Side::Fair}) {
            SCOPED_TRACE(testing::Message() << name_of(tool.kind) << cutting_diameter_of(tool)
                                            << ' ' << static_cast<int>(side));
            const auto points = approximate(tool.pieces[0], kLattice, {0.05, side}).points_T;
            const auto sweep = cda::TranslationSweep::of(points, kLattice);
            for (const cda::Plane& plane : (*sweep)({}, {}, cda::kStockOrigin).planes) {
                const auto corners = std::ranges::count_if(points, [&](const auto& p) {
                    return plane.nx * p.x + plane.ny * p.y + plane.nz * p.z == plane.d;
                });
                // The plane below the tip is not a facet.
                EXPECT_TRUE(corners >= 3 || plane == (cda::Plane{0, 0, -1, 0}));
            }
        }
    }
}

// Returns the number of planes of the hull of a move that touch fewer than three corners of the
// tool at both ends of the move.
std::ptrdiff_t loose_planes(const std::vector<cda::LatticePoint>& points, cda::LatticePoint move) {
    const auto sweep = cda::TranslationSweep::of(points, kLattice);
    const auto planes = (*sweep)({}, move, cda::kStockOrigin).planes;
    return std::ranges::count_if(planes, [&](const cda::Plane& plane) {
        std::ptrdiff_t corners = 0;
        for (const cda::LatticePoint& p : points) {
            for (const cda::LatticePoint& q : {p, p + move})
                corners += plane.nx * q.x + plane.ny * q.y + plane.nz * q.z == plane.d ? 1 : 0;
        }
        return corners < 3;
    });
}

// Walls with rounded normals touch the tool in a single corner. The walls of the next move then do
// not meet them in an edge, and slivers of nanometres remain.
TEST(ToolPolytope, WallsOfMovesWithThreeDecimalsTouchWholeEdges) {
    const std::vector<cda::LatticePoint> moves{
        {322600, 0, 198700}, {-322600, 0, 57300}, {0, 101000, -33300}, {157900, 88700, 61300}};
    for (const double diameter : {1.0, 2.0, 6.0, 8.0, 12.0}) {
        SCOPED_TRACE(diameter);
        const ToolPiece ball = ball_end_mill(diameter, diameter / 2 + 20).pieces[0];
        std::ptrdiff_t loose = 0, loose_of_turning = 0;
        for (const cda::LatticePoint& move : moves) {
            loose += loose_planes(approximate(ball, kLattice, {0.05, Side::Fair}).points_T, move);
            loose_of_turning +=
                loose_planes(approximate(ball, kLattice, {0.05, Side::Fair, true}).points_T, move);
        }
        EXPECT_EQ(loose, 0);
        EXPECT_GT(loose_of_turning, 0);
    }
}

// The last corner above the equator is at the top and not below the top.
TEST(ToolPolytope, CircumscribedContainsAWholeBall) {
    for (const double diameter : {20.0, 3.0218, 146.663238843, 0.713}) {
        SCOPED_TRACE(diameter);
        const double r = diameter / 2;
        const ToolPiece piece = lollipop_mill(diameter).pieces[0];
        const PiecePolytope around = approximate(piece, kLattice, {r / 20});
        EXPECT_LE(around.error_mm, r / 20);
        const cda::ConvexPolytope outer = polytope_of(around);
        for (const auto& facet : outer.facets()) {
            const double d = offset_mm(facet.plane, kLattice) - r * unit_normal(facet.plane).z;
            EXPECT_GE(d, r - 1e-9);
        }
        for (const auto& corner : around.points_T)
            EXPECT_LE(kLattice.to_mm(corner).z, diameter + kLattice.unit_mm);
    }
}

// Strips between two circles of corners have a facet for each direction in which either circle has
// a side, so no facet splits into triangles. Circles near the tip have fewer sides.
TEST(ToolPolytope, FacetsOfABallAreFlatAndNoMoreThanNeeded) {
    struct Case {
        double diameter, tolerance;
        std::size_t most;  // lower bound up to the equator: 1.2 R/eps, with planar facets or
                           // without
    };
    for (const Case& c : {Case{6, 0.05, 136}, Case{2, 0.05, 50}, Case{10, 0.05, 212},
                          Case{6, 0.15, 58}, Case{50, 0.05, 990}}) {
        SCOPED_TRACE(testing::Message() << c.diameter << " within " << c.tolerance);
        const double r = c.diameter / 2;
        const PiecePolytope ball =
            approximate(ball_end_mill(c.diameter, r + 20).pieces[0], kLattice, {c.tolerance});
        std::map<std::int64_t, std::size_t> rings;
        for (const cda::LatticePoint& p : ball.points_T)
            ++rings[p.z];
        std::size_t expected = 2;
        for (auto ring = rings.begin(), next = std::next(ring); next != rings.end();
             ++ring, ++next) {
            expected += ring->second + next->second - std::gcd(ring->second, next->second);
        }
        const cda::ConvexPolytope p = polytope_of(ball);
        EXPECT_LE(p.facets().size(), expected);
        EXPECT_LE(p.facets().size(), c.most);
        EXPECT_LE(rings.begin()->second, static_cast<std::size_t>(ball.sides));
        EXPECT_TRUE(p.facet_in({0, 0, -1, 0}));
        const auto radius = static_cast<std::int64_t>(std::round(r / 1e-5));
        EXPECT_TRUE(p.facet_in({1, 0, 0, radius}));
        EXPECT_TRUE(p.facet_in({0, -1, 0, radius}));
    }
}

TEST(ToolPolytope, ShapedEndsAreWithinTheirErrorToo) {
    for (const Tool& tool : {bull_nose_end_mill(12, 2, 25), tapered_end_mill(3, 1.5, 5, 30),
                             tapered_end_mill(4, 0.5, 10, 20), v_cutter(6, 0.2, 60, 20),
                             drill(8.5, 118, 60), face_mill(63, 10)}) {
        SCOPED_TRACE(name_of(tool.kind));
        const PiecePolytope outer =
            approximate(tool.pieces[0], kLattice, {0.05, Side::Circumscribed});
        const PiecePolytope inner = approximate(tool.pieces[0], kLattice, {0.05, Side::Inscribed});
        EXPECT_LE(outer.error_mm, 0.05);
        EXPECT_LE(inner.error_mm, 0.05);
        const double around = polytope_of(outer).volume() * 1e-15;
        const double within = polytope_of(inner).volume() * 1e-15;
        EXPECT_LT(within, around);
        // The difference is at most a shell as thick as the sum of both errors.
        const double side = std::numbers::pi * cutting_diameter_of(tool) *
                            (cutting_height_of(tool) + cutting_diameter_of(tool));
        EXPECT_LT(around - within, side * (outer.error_mm + inner.error_mm));
    }
}

TEST(ToolPolytope, AWholeBallHasBothItsHalves) {
    const ToolPiece ball{{{3, 0, 3}, {3, 6, 3}}, true};
    const PiecePolytope p = approximate(ball, kLattice, {});
    EXPECT_LE(p.error_mm, 0.05);
    const double volume = polytope_of(p).volume() * 1e-15;
    const double exact = 4.0 / 3 * std::numbers::pi * 27;
    EXPECT_GT(volume, exact);
    EXPECT_LT(volume, exact * 1.05);
}

// A ball that ends at the equator must not be extended along the last tangent by the spacing of the
// circles, which would be up to 0.1 mm too high.
TEST(ToolPolytope, ABallWithoutACylinderEndsAtItsHeight) {
    for (const double diameter : {1.90992, 9.9598, 44.204636, 57.122758, 78.481112}) {
        for (const double share : {0.004, 0.01, 0.03}) {
            for (const Side side : {Side::Circumscribed, Side::Fair}) {
                SCOPED_TRACE(testing::Message() << diameter << " mm, " << share);
                const Tool tool = ball_end_mill(diameter, diameter / 2);
                const PiecePolytope polytope =
                    approximate(tool.pieces.at(0), kLattice, {share * diameter / 2, side});
                const auto [low, high] =
                    std::ranges::minmax(polytope.points_T, {}, [](const auto& p) { return p.z; });
                EXPECT_EQ(low.z, 0);
                const double units = diameter / 2 / kLattice.unit_mm;
                EXPECT_EQ(high.z, std::llround(std::ceil(units - 1e-3)));
            }
        }
    }
}

// If an arc ends vertically, the last chord is extended to the height of the end.
TEST(ToolPolytope, InscribedLosesNoMoreThanItReports) {
    for (const double diameter : {15.361, 6.0, 0.97}) {
        SCOPED_TRACE(diameter);
        const double r = diameter / 2;
        const ToolPiece piece = ball_end_mill(diameter, r).pieces[0];
        const PiecePolytope within = approximate(piece, kLattice, {r / 102, Side::Inscribed});
        for (int half_degrees = -180; half_degrees <= 0; ++half_degrees) {
            const double angle = half_degrees * std::numbers::pi / 360;
            double reach = 0.0;
            for (const auto& corner : within.points_T) {
                const Vec3 p = kLattice.to_mm(corner);
                reach = std::max(reach, std::cos(angle) * p.x + std::sin(angle) * (p.z - r));
            }
            EXPECT_LE(r - reach, within.error_mm) << half_degrees;
        }
    }
}

TEST(ToolPolytope, IsTheSameForCoarserLattices) {
    const cda::Lattice coarse{5e-4};
    const PiecePolytope p = approximate(ball_end_mill(6, 20).pieces[0], coarse, {});
    EXPECT_LE(p.error_mm, 0.05);
    EXPECT_EQ(largest_x(p), 6000);
}

double reach_of(const PiecePolytope& piece, Vec3 n) {
    double reach = -std::numeric_limits<double>::infinity();
    for (const cda::LatticePoint& p : piece.points_T)
        reach = std::max(reach, dot(n, kLattice.to_mm(p)));
    return reach;
}

// Vertical walls and floors of fair tools equal walls and floors of circumscribed tools. On rounded
// parts, fair tools err to both sides and on average slightly outwards; ridges between passes
// compensate the excess (FairTools.LeaveTheVolumeThatRoundOnesLeave).
TEST(ToolPolytope, FairErrsToBothSides) {
    std::mt19937 random(5);
    const auto unit = [&] { return (static_cast<double>(random()) + 0.5) / 0x1p32; };
    for (const double diameter : {1.0, 2.0, 6.0, 10.0, 16.0}) {
        for (const double tolerance : {0.05, 0.02}) {
            SCOPED_TRACE(testing::Message() << diameter << " within " << tolerance);
            const double r = diameter / 2;
            if (tolerance > r / 20) continue;
            const ToolPiece piece = ball_end_mill(diameter, r + 10).pieces[0];
            const PiecePolytope fair = approximate(piece, kLattice, {tolerance, Side::Fair});
            EXPECT_LE(fair.error_mm, tolerance);
            const cda::ConvexPolytope p = polytope_of(fair);
            const PiecePolytope outer = approximate(piece, kLattice, {tolerance});
            EXPECT_LE(p.facets().size(), polytope_of(outer).facets().size());
            EXPECT_TRUE(p.facet_in({0, 0, -1, 0}));
            const auto radius = static_cast<std::int64_t>(std::round(r / 1e-5));
            EXPECT_TRUE(p.facet_in({1, 0, 0, radius}));
            EXPECT_TRUE(p.facet_in({0, -1, 0, radius}));
            double sum = 0.0, weights = 0.0, least = 0.0, most = 0.0;
            for (int i = 0; i < 20000; ++i) {
                // Normals weighted by the projection seen from above; gentle slopes have more
                // weight.
                const double aside = std::sqrt(unit());
                const double around = 2 * std::numbers::pi * unit();
                const Vec3 n{aside * std::cos(around), aside * std::sin(around),
                             -std::sqrt(1 - aside * aside)};
                const double more = reach_of(fair, n) - (r + n.z * r);
                const double weight = -n.z * n.z * n.z;
                sum += weight * more;
                weights += weight;
                least = std::min(least, more);
                most = std::max(most, more);
            }
            // About a fifth of the depth, as far as the steps of radii and heights and the
            // tolerance permit. A circumscribed tool deviates by two thirds of the tolerance.
            EXPECT_GT(sum / weights, 0.0);
            EXPECT_LT(sum / weights, 0.5 * tolerance);
            EXPECT_LT(least, -0.3 * tolerance);
            EXPECT_GT(most, 0.1 * tolerance);
        }
    }
}

// --- Random tools against the support function of the round tools ---

// Returns the support function of a body of revolution for a unit vector: a corner of the profile,
// or the point of an arc with this normal.
double reach_of(const ToolPiece& piece, Vec3 n) {
    const double aside = std::hypot(n.x, n.y);
    double reach = -std::numeric_limits<double>::infinity();
    const auto& profile = piece.profile;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const ProfilePoint& p = profile[i];
        if (p.fillet == 0.0) {
            reach = std::max(reach, aside * p.radius + n.z * p.height);
            continue;
        }
        const ProfilePoint before = i > 0 ? profile[i - 1] : ProfilePoint{0, p.height, 0};
        const ProfilePoint after =
            i + 1 < profile.size() ? profile[i + 1] : ProfilePoint{0, p.height, 0};
        const double a = std::atan2(p.height - before.height, p.radius - before.radius);
        const double b = std::atan2(after.height - p.height, after.radius - p.radius);
        const double leg = p.fillet * std::tan((b - a) / 2);
        const double r = p.radius - leg * std::cos(a) - p.fillet * std::sin(a);
        const double h = p.height - leg * std::sin(a) + p.fillet * std::cos(a);
        const double normal = std::atan2(n.z, aside);  // normals of an arc cover a - 90° to b - 90°
        const double nearest =
            std::clamp(normal, a - std::numbers::pi / 2, b - std::numbers::pi / 2);
        reach = std::max(reach, aside * (r + p.fillet * std::cos(nearest)) +
                                    n.z * (h + p.fillet * std::sin(nearest)));
    }
    return reach;
}

struct RandomTools {
    std::mt19937 random{20261122};

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 0x1p32);
    }
    // Mostly rounded to micrometres.
    double size(double low, double high) {
        const double v = low * std::pow(high / low, between(0, 1));
        return random() % 4 == 0 ? v : std::round(v * 1000) / 1000;
    }
    ToolPiece operator()() {
        const double d = size(0.2, 40);
        switch (random() % 10) {
            case 0: return flat_end_mill(d, size(1, 60)).pieces[0];
            case 1:
            case 2: return ball_end_mill(d, d / 2 + size(0.01, 60)).pieces[0];
            case 3: return bull_nose_end_mill(d, size(d / 100, d / 2), d + 5).pieces[0];
            case 4:
                return v_cutter(d, random() % 2 ? 0.0 : d / 7, between(10, 150), 3 * d).pieces[0];
            case 5: return drill(d, between(60, 160), 5 * d).pieces[0];
            case 6: return tapered_end_mill(d, d / 2, between(0.5, 40), 3 * d).pieces[0];
            case 7: return tapered_end_mill(d, size(d / 50, d / 2), between(0.5, 60), d).pieces[0];
            case 8: return lollipop_mill(d).pieces[0];
            default: break;
        }
        // A form tool: rounded below, conical, rounded above, and narrower above the second
        // rounding.
        const double r = d / 2;
        return {{{0.6 * r, 0, between(0.05, 0.5) * r},
                 {r, between(0.6, 1.5) * r, between(0.02, 0.2) * r},
                 {between(0.3, 0.9) * r, 2.5 * r, 0}},
                true};
    }
};

TEST(ToolPolytope, OfRandomToolsHoldsThemOrIsHeldWithinTheErrorThatItTells) {
    RandomTools tools;
    for (int i = 0; i < 200; ++i) {
        const ToolPiece piece = tools();
        double r = 0.0;
        for (const ProfilePoint& p : piece.profile)
            r = std::max(r, p.radius);
        // Tolerances as fine as the lattice permits (tool_polytope.h), or coarser. Form tools have
        // two radii, and both need multiples of a single number.
        const double units = piece.profile.size() > 2 ? 4 : 2;
        const double finest = std::max(r / 1000, units * std::sqrt(r * 1e-5));
        const double tolerance =
            finest * std::pow(std::min(40.0, r / 5 / finest), tools.between(0, 1));
        for (const Side side : {Side::Circumscribed, Side::Inscribed, Side::Fair}) {
            const PiecePolytope p = approximate(piece, kLattice, {tolerance, side});
            SCOPED_TRACE(testing::Message()
                         << i << ": " << piece.profile.size() << " corners, radius " << r
                         << ", tolerance " << tolerance << ", side " << static_cast<int>(side));
            ASSERT_FALSE(p.points_T.empty());
            ASSERT_LE(p.error_mm, tolerance);
            const bool outside = side != Side::Inscribed;
            const bool is_rounded =
                std::ranges::any_of(piece.profile, [](const auto& q) { return q.fillet > 0; });
            const auto holds = [&](Vec3 n) {
                const double less = outside ? reach_of(piece, n) : reach_of(p, n);
                const double more = outside ? reach_of(p, n) : reach_of(piece, n);
                const double missed = side == Side::Fair && is_rounded ? p.error_mm
                                      : outside                        ? 1e-9
                                                                       : 2e-5;
                return less <= more + missed && more <= less + p.error_mm;
            };
            const auto cell = cda::convex_hull(p.points_T, kLattice, cda::kStockOrigin);
            ASSERT_TRUE(cell);
            for (const cda::Plane& plane : cell->planes)
                ASSERT_TRUE(holds(unit_normal(plane)));
            for (int k = 0; k < 200; ++k) {
                const Vec3 n =
                    normalized({tools.between(-1, 1), tools.between(-1, 1), tools.between(-1, 1)});
                ASSERT_TRUE(holds(n)) << n.x << ' ' << n.y << ' ' << n.z;
            }
            // Mirrors and quarter turns.
            const std::set<cda::LatticePoint> corners(p.points_T.begin(), p.points_T.end());
            for (const cda::LatticePoint& c : corners) {
                ASSERT_TRUE(corners.contains({-c.x, c.y, c.z}));
                ASSERT_TRUE(corners.contains({c.y, c.x, c.z}));
            }
            if (outside) {
                EXPECT_NEAR(reach_of(p, {0, 0, -1}), -piece.profile.front().height, 1e-12);
            }
        }
    }
}

// An empty polytope would cut nothing without a message.
TEST(ToolPolytope, NoToolIsTooSmallToCut) {
    RandomTools tools;
    for (int i = 0; i < 300; ++i) {
        const double d = 0.0004 * std::pow(100.0, tools.between(0, 1));
        const double fillet = tools.between(0.05, 0.5) * d;
        const std::array pieces{
            ball_end_mill(d, 2 * d).pieces[0], bull_nose_end_mill(d, fillet, 3 * d).pieces[0],
            lollipop_mill(d).pieces[0],
            tapered_end_mill(d, fillet, tools.between(0.5, 40), 2 * d).pieces[0]};
        const double finest = std::max(d / 2000, 2 * std::sqrt(d / 2 * 1e-5));
        const double tolerance =
            finest * std::pow(std::max(1.0, d / 4 / finest), tools.between(0, 1));
        for (const ToolPiece& piece : pieces) {
            for (const Side side : {Side::Circumscribed, Side::Fair}) {
                SCOPED_TRACE(testing::Message() << "diameter " << d << ", fillet " << fillet
                                                << ", tolerance " << tolerance);
                const PiecePolytope p = approximate(piece, kLattice, {tolerance, side});
                ASSERT_FALSE(p.points_T.empty());
                const double missed = side == Side::Fair ? p.error_mm : 1e-9;
                for (int k = 0; k < 20; ++k) {
                    const Vec3 n = normalized(
                        {tools.between(-1, 1), tools.between(-1, 1), tools.between(-1, 1)});
                    ASSERT_LE(reach_of(piece, n), reach_of(p, n) + missed);
                }
            }
        }
    }
}

// With a radius of 127 units, a prime, no circle of corners divides the radius exactly.
TEST(ToolPolytope, OfWholeBallsOfAFewUnitsIsAsFineAsTheLatticeAllows) {
    for (int units = 4; units < 400; ++units) {
        for (const double over : {2.0, 2.6}) {
            const double r = (units - 0.4) * kLattice.unit_mm;
            const double tolerance = over * 2 * std::sqrt(r * kLattice.unit_mm);
            for (const Side side : {Side::Circumscribed, Side::Inscribed, Side::Fair}) {
                const Tool ball = lollipop_mill(2 * r);
                const PiecePolytope p = approximate(ball.pieces[0], kLattice, {tolerance, side});
                EXPECT_LE(p.error_mm, tolerance) << units << " units, tolerance " << tolerance
                                                 << ", side " << static_cast<int>(side);
            }
        }
    }
}

// The radius of the polygon must be a multiple, so the polygon can be wider than the circle. Its
// corners then extend further by the same ratio.
TEST(ToolPolytope, CornersOfAConeStandOutByNoMoreThanItTells) {
    for (const double degrees : {1.0, 3.0, 12.0, 35.0}) {
        for (const double d : {6.26386, 3.217, 11.4083}) {
            const ToolPiece cone = tapered_end_mill(d, 0.0, degrees, 3.31788).pieces[0];
            const PiecePolytope p = approximate(cone, kLattice, {d / 50, Side::Circumscribed});
            const double slope = std::tan(degrees * std::numbers::pi / 180);
            double most = 0.0;
            for (const cda::LatticePoint& corner : p.points_T) {
                const Vec3 at = kLattice.to_mm(corner);
                const double beyond = std::hypot(at.x, at.y) - d / 2 - slope * at.z;
                most = std::max(most, beyond / std::hypot(1.0, slope));
            }
            EXPECT_LE(most, p.error_mm) << degrees << ' ' << d;
        }
    }
}

TEST(ToolPolytope, ARoundedCornerThatDoesNotTurnIsNone) {
    for (const Side side : {Side::Circumscribed, Side::Inscribed, Side::Fair}) {
        const PiecePolytope p =
            approximate({{{3, 0, 0}, {3, 5, 1}, {3, 9, 0}}, true}, kLattice, {0.05, side});
        EXPECT_LE(p.error_mm, 0.05);
        EXPECT_EQ(reach_of(p, {0, 0, 1}), 9);
        EXPECT_NEAR(reach_of(p, {1, 0, 0}), 3, 0.05);
    }
}

TEST(Polytope, HasABoundedNumberOfCornersAndTellsItsError) {
    const cda::Lattice lattice;
    const PiecePolytope huge =
        approximate(ball_end_mill(600, 400).pieces[0], lattice, {1e-4, Side::Circumscribed});
    EXPECT_LE(huge.points_T.size(), 8192U);
    EXPECT_GT(huge.error_mm, 1e-4);
    EXPECT_LT(huge.error_mm, 0.2);
    const PiecePolytope small =
        approximate(ball_end_mill(6, 20).pieces[0], lattice, {0.05, Side::Circumscribed});
    EXPECT_LE(small.error_mm, 0.05);
}

}  // namespace
}  // namespace ncsim::toolpath
