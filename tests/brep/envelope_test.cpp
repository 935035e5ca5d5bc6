// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares envelopes with their definition: the tool at many times, and finite differences of
// points.
#include "ncsim/brep/envelope.h"

#include "ncsim/brep/surface_forms.h"

#include "brep/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

namespace ncsim::brep {
namespace {

using test::Draw;

// Returns a motion of the tip along a bent line while the axis rotates about a fixed direction;
// empty if `fit_rotary_path` cannot represent the motion.
std::optional<RotaryPath> random_turn(Draw& draw, Vec3 axis) {
    const Vec3 from = draw.point(), along = draw.from(8.0, 30.0) * draw.direction();
    const Vec3 bow = draw.from(0.0, 3.0) * draw.direction();
    const Vec3 about = draw.direction(), side = cross(about, axis);
    const double most = draw.from(0.02, 0.5), level = dot(axis, about);
    return fit_rotary_path([=](double t) {
        const double angle = most * t;
        return TipAndAxis{
            from + t * along + (t * t) * bow,
            std::cos(angle) * (axis - level * about) + std::sin(angle) * side + level * about};
    });
}

// Returns a helix or a spiral about the tool axis or about a random direction.
HelixPath random_helix_path(Draw& draw, Vec3 axis, double tool) {
    HelixPath round;
    round.centre = draw.point();
    round.about = draw.from(0, 1) < 0.5 ? axis : draw.direction();
    round.ahead = any_perpendicular(round.about);
    round.reach = 1.5 * tool + draw.from(0.0, 10.0);
    round.growth = draw.from(0, 1) < 0.5 ? 0.0 : draw.from(-0.3, 0.3);
    round.lead = draw.from(0.1, 1.0);
    round.swept = draw.from(0.3, 6.0) * (draw.from(-1, 1) < 0.0 ? -1.0 : 1.0);
    round.axis = axis;
    return round;
}

// Returns the envelope of the side of an end mill, a tapered tool or a tip. Rejects motions that
// pivot the tool about a point of its axis within the side.
Envelope random_flank(Draw& draw) {
    for (;;) {
        Flank flank{draw.from(2.0, 5.0), draw.from(0.0, 3.0), 1.0, 0.0, draw.from(1.0, 4.0)};
        if (draw.from(0, 1) < 0.5) {
            flank.sine = draw.from(-0.7, 0.4);
            flank.cosine = std::sqrt(1.0 - flank.sine * flank.sine);
        }
        const Vec3 axis = draw.direction();
        ToolPath way = random_helix_path(draw, axis, flank.radius + flank.length);
        if (draw.from(0, 1) < 0.7) {
            const auto turn = random_turn(draw, axis);
            if (!turn) continue;
            way = *turn;
        }
        Envelope envelope{std::make_shared<Sweep>(flank, way)};
        const Sweep& sweep = *envelope.sweep;
        const auto is_usual = [&](const ToolFrame& at) {
            return std::ranges::all_of(std::array{0.5, 1.0, 1.5, 2.0, 2.5}, [&](double place) {
                const Vec3 p = point_across(sweep, at, place * flank.length);
                const ClosestPoint closest = closest_point_at(sweep, at, p);
                return std::abs(closest.rate) < 1e-6 && closest.bend > 0.0 &&
                       !is_at_pivot(sweep, closest);
            });
        };
        if (std::ranges::all_of(sweep.samples(), is_usual)) return envelope;
    }
}

// Returns a random place across the motion: for a fillet an angle between `low` and `high`, for a
// flank any place along the flank.
double random_place(Draw& draw, const Sweep& sweep, double low, double high) {
    const Flank* flank = sweep.flank();
    if (!flank) return draw.from(low, high);
    return draw.from(1.1, 1.9) * (draw.from(-1, 1) < 0.0 ? -flank->length : flank->length);
}

// Returns a random envelope. Balls and bull noses move on lines that are neither level nor too
// steep, on rotary moves, and on helices and spirals wider than the tool, whose axis may be tilted.
// Flanks are included.
Envelope random_envelope(Draw& draw) {
    for (;;) {
        if (draw.from(0, 1) < 0.3) return random_flank(draw);
        const bool is_ball = draw.from(0, 1) < 0.4;
        const Fillet fillet{is_ball ? 0.0 : draw.from(0.5, 4.0), draw.from(0.0, 3.0),
                            draw.from(0.5, 3.0)};
        const Vec3 axis = draw.direction();
        ToolPath way;
        if (draw.from(0, 1) < 0.4) {
            const auto turn = random_turn(draw, axis);
            if (!turn) continue;
            way = *turn;
        } else if (!is_ball && draw.from(0, 1) < 0.5) {
            way = StraightPath{draw.point(), draw.from(2.0, 30.0) * draw.direction(), axis};
        } else {
            way = random_helix_path(draw, axis, fillet.centre_radius + fillet.radius);
        }
        Envelope envelope{std::make_shared<Sweep>(fillet, way)};
        const auto is_usual = [&](const ToolFrame& at) {
            const double lean = std::abs(dot(normalized(at.speed), at.axis));
            return lean < 0.95 && (fillet.centre_radius == 0.0 || lean > 0.05);
        };
        if (has_across(*envelope.sweep) && std::ranges::all_of(envelope.sweep->samples(), is_usual))
            return envelope;
    }
}

// Returns the least distance of `p` from the tool over 2001 times.
double least_off(const Sweep& sweep, Vec3 p) {
    double least = std::numeric_limits<double>::infinity();
    constexpr int kTimes = 2000;
    for (int k = 0; k <= kTimes; ++k)
        least = std::min(least, closest_point_at(sweep, double(k) / kTimes, p).deviation);
    return least;
}

// Tests points that the tool never enters.
TEST(Envelope, HasItsPlacesNormalsAndDistances) {
    Draw draw(11);
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
        const Envelope envelope = random_envelope(draw);
        const Sweep& sweep = *envelope.sweep;
        const double t = draw.from(0.05, 0.95);
        const double across_way = random_place(draw, sweep, 100.0, 260.0);
        const auto point = [&](double time, double place) {
            return point_across(sweep, sweep.at(time), place);
        };
        const Vec3 p = point(t, across_way);
        if (least_off(sweep, p) < -1e-6) continue;
        ++seen;
        constexpr double kTime = 1e-5, kAcross = 1e-3;
        const Vec3 u = point(t, across_way + kAcross) - point(t, across_way - kAcross);
        const Vec3 v = point(t + kTime, across_way) - point(t - kTime, across_way);
        const Vec3 n = normalized(cross(u, v));
        const ClosestPoint place = project_onto(envelope, p);
        EXPECT_NEAR(place.deviation, 0.0, 1e-11);
        EXPECT_NEAR(norm(place.normal - n), 0.0, 1e-5);
        EXPECT_NEAR(place.t, t, 1e-9);
        EXPECT_NEAR(place.rate, 0.0, 1e-9 * sweep.length_mm());
        EXPECT_NEAR(place_across(sweep, place.tool, p), across_way, 1e-8);
        const double deviation = draw.from(-0.05, 0.05);
        EXPECT_NEAR(distance(envelope, p + deviation * n), deviation, 1e-6);
        // Surfaces that cross the envelope at `p`.
        EXPECT_NEAR(distance(Characteristic{envelope, t}, p), 0.0, 1e-10);
        EXPECT_NEAR(distance(Trail{envelope, dot(n, place.tool.axis)}, p), 0.0, 1e-3);
        EXPECT_LT(std::abs(dot(gradient(Characteristic{envelope, t}, p), place.normal)), 1e-6);
    }
    EXPECT_GT(seen, 1000);
}

TEST(Envelope, IsAsFarAsTheNearestOfAllTimes) {
    Draw draw(11);
    for (int i = 0; i < 300; ++i) {
        const Envelope envelope = random_envelope(draw);
        const Sweep& sweep = *envelope.sweep;
        const Vec3 p = point_across(sweep, sweep.at(draw.from(0.1, 0.9)),
                                    random_place(draw, sweep, 120.0, 240.0)) +
                       0.3 * draw.direction();
        const double least = least_off(sweep, p);
        if (least < -0.05) continue;
        const ClosestPoint place = project_onto(envelope, p);
        if (place.t < 0.0 || place.t > 1.0) continue;
        EXPECT_NEAR(place.deviation, least, 1e-3);
        EXPECT_LE(place.deviation, least + 1e-9);
    }
}

// Compares both gradients with finite differences.
TEST(Envelope, WhatCrossesItHasItsGradient) {
    Draw draw(11);
    constexpr double kStep = 1e-6;
    for (int i = 0; i < 500; ++i) {
        const Envelope envelope = random_envelope(draw);
        const Sweep& sweep = *envelope.sweep;
        const Vec3 p = point_across(sweep, sweep.at(draw.from(0.1, 0.9)),
                                    random_place(draw, sweep, 120.0, 240.0)) +
                       0.01 * draw.direction();
        const auto value = [&](Vec3 at) {
            const ClosestPoint closest = project_onto(envelope, at);
            return Vec3{closest.deviation, closest.t, dot(closest.normal, closest.tool.axis)};
        };
        const ClosestPoint closest = project_onto(envelope, p);
        const Vec3 time = gradient_of_time(closest), rise = gradient_of_rise(sweep, closest);
        for (int k = 0; k < 3; ++k) {
            Vec3 step;
            step[k] = kStep;
            const Vec3 slope = (0.5 / kStep) * (value(p + step) - value(p - step));
            EXPECT_NEAR(slope.x, closest.normal[k], 1e-5);
            EXPECT_NEAR(slope.y, time[k], 1e-4 * (1.0 + norm(time)));
            EXPECT_NEAR(slope.z, rise[k], 1e-4 * (1.0 + norm(rise)));
        }
    }
}

// Evaluates points in sequence, each with the projection of the preceding point.
TEST(Envelope, PointsInARowHaveTheirTimesForetold) {
    Draw draw(11);
    constexpr double kStep = 1e-4;
    int seen = 0;
    for (int i = 0; i < 500; ++i) {
        const Envelope envelope = random_envelope(draw);
        const Sweep& sweep = *envelope.sweep;
        const double t = draw.from(0.1, 0.9), place = random_place(draw, sweep, 120.0, 240.0);
        const Vec3 p = point_across(sweep, sweep.at(t), place);
        if (least_off(sweep, p) < -1e-6) continue;
        ++seen;
        ProjectionSeed seed;
        EXPECT_EQ(project_onto(envelope, p, seed).t, project_onto(envelope, p).t);
        const Vec3 q = p + kStep * draw.direction();
        const double expected = *seed.time + dot(seed.slope, q - seed.at);
        const ClosestPoint next = project_onto(envelope, q, seed),
                           alone = project_onto(envelope, q);
        EXPECT_NEAR(next.t, alone.t, 1e-10);
        EXPECT_NEAR(next.deviation, alone.deviation, 1e-10);
        const double gone = std::abs(next.t - t);
        EXPECT_LE(std::abs(expected - next.t), 1e-8 + 0.2 * gone);
        EXPECT_EQ(*seed.time, next.t);
        EXPECT_EQ(norm(seed.at - q), 0.0);
    }
    EXPECT_GT(seen, 200);
}

// If the profile is smooth between side and corner radius, their envelopes are tangent, too.
TEST(Envelope, SidesTouchTheirCornerRadii) {
    Draw draw(11);
    for (int i = 0; i < 200; ++i) {
        const Envelope side = random_flank(draw);
        const Flank& flank = *side.sweep->flank();
        if (flank.radius * flank.cosine < 0.5) continue;
        // A ball about the axis point in which the normal of the flank ends.
        const double radius = flank.radius / flank.cosine;
        const Envelope ball{std::make_shared<Sweep>(
            Fillet{0.0, flank.height - radius * flank.sine, radius}, side.sweep->path())};
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 p =
                point_across(*side.sweep, side.sweep->at(draw.from(0.1, 0.9)), sign * flank.length);
            if (least_off(*side.sweep, p) < -1e-6) continue;
            EXPECT_NEAR(distance(ball, p), 0.0, 1e-9);
            EXPECT_NEAR(norm(gradient(ball, p) - gradient(side, p)), 0.0, 1e-6);
            EXPECT_NEAR(distance(Trail{ball, flank.sine}, p), 0.0, 1e-6);
        }
    }
}

// A fillet of radius 0: its envelope is the trace of its circle, compared by finite differences.
TEST(Envelope, OfARimIsWhereItsCirclePasses) {
    Draw draw(12);
    int seen = 0;
    while (seen < 200) {
        const Vec3 axis = draw.direction();
        const auto turn = random_turn(draw, axis);
        if (!turn) continue;
        const Envelope rim{
            std::make_shared<Sweep>(Fillet{draw.from(1.0, 5.0), draw.from(0.0, 3.0), 0.0}, *turn)};
        const Sweep& sweep = *rim.sweep;
        const auto is_usual = [&](const ToolFrame& at) {
            const double lean = std::abs(dot(normalized(at.speed), at.axis));
            return lean < 0.9 && lean > 0.1;
        };
        if (!has_across(sweep) || !std::ranges::all_of(sweep.samples(), is_usual)) continue;
        ++seen;
        const double t = draw.from(0.1, 0.9), place = draw.from(110.0, 250.0);
        const auto point = [&](double time, double across_way) {
            return point_across(sweep, sweep.at(time), across_way);
        };
        const Vec3 p = point(t, place);
        constexpr double kTime = 1e-5, kAcross = 1e-3;
        const Vec3 n = normalized(cross(point(t, place + kAcross) - point(t, place - kAcross),
                                        point(t + kTime, place) - point(t - kTime, place)));
        const ClosestPoint on = project_onto(rim, p);
        EXPECT_NEAR(on.deviation, 0.0, 1e-10);
        EXPECT_NEAR(on.t, t, 1e-9);
        EXPECT_NEAR(std::abs(dot(on.normal, n)), 1.0, 1e-8);
        // The normal points down along the tool axis.
        EXPECT_LT(dot(on.normal, on.tool.axis), 0.0);
        EXPECT_NEAR(place_across(sweep, on.tool, p), place, 1e-8);
        const double deviation = draw.from(-0.05, 0.05);
        const Vec3 q = p + deviation * on.normal;
        EXPECT_NEAR(distance(rim, q), deviation, 1e-6);
        EXPECT_NEAR(distance(Trail{rim, dot(on.normal, on.tool.axis)}, p), 0.0, 1e-8);
        EXPECT_NEAR(distance(Characteristic{rim, t}, p), 0.0, 1e-10);
        constexpr double kStep = 1e-6;
        const auto value = [&](Vec3 at) {
            const ClosestPoint closest = project_onto(rim, at);
            return Vec3{closest.deviation, closest.t, dot(closest.normal, closest.tool.axis)};
        };
        const ClosestPoint closest = project_onto(rim, q);
        const Vec3 time = gradient_of_time(closest), rise = gradient_of_rise(sweep, closest);
        for (int k = 0; k < 3; ++k) {
            Vec3 step;
            step[k] = kStep;
            const Vec3 slope = (0.5 / kStep) * (value(q + step) - value(q - step));
            EXPECT_NEAR(slope.x, closest.normal[k], 1e-5);
            EXPECT_NEAR(slope.y, time[k], 1e-4 * (1.0 + norm(time)));
            EXPECT_NEAR(slope.z, rise[k], 1e-4 * (1.0 + norm(rise)));
        }
    }
}

// The tool pivots about a fixed point of its axis.
TEST(Envelope, HasNoSideWhereTheToolPivots) {
    const auto way = fit_rotary_path([](double t) {
        const double angle = 0.3 * t;
        const Vec3 axis{std::sin(angle), 0.0, std::cos(angle)};
        return TipAndAxis{Vec3{0, 0, 20} - 20.0 * axis, axis};
    });
    ASSERT_TRUE(way.has_value());
    const Envelope side{std::make_shared<Sweep>(Flank{3.0, 0.0, 1.0, 0.0, 40.0}, *way)};
    const auto pivots = [&](double height) {
        const ToolFrame at = side.sweep->at(0.5);
        const Vec3 p = point_across(*side.sweep, at, 40.0 + height);
        return is_at_pivot(*side.sweep, closest_point_at(*side.sweep, at, p));
    };
    EXPECT_TRUE(pivots(19.0));
    EXPECT_TRUE(pivots(22.0));
    EXPECT_FALSE(pivots(10.0));
    EXPECT_FALSE(pivots(30.0));
}

// Motion as on a machine: rotary axes move uniformly, and positions rotate with the axes.
TEST(RotaryPath, GoesThroughWhatItIsMadeOf) {
    const auto pose = [](double t) {
        const double b = 2.5 * t, c = 1.0 - 1.5 * t;
        const Vec3 tip{60.0 + 30.0 * t, -20.0, 5.0 - 10.0 * t};
        const auto turned = [&](Vec3 p) {
            const Vec3 q{p.x * std::cos(b) + p.z * std::sin(b), p.y,
                         p.z * std::cos(b) - p.x * std::sin(b)};
            return Vec3{q.x * std::cos(c) - q.y * std::sin(c),
                        q.x * std::sin(c) + q.y * std::cos(c), q.z};
        };
        return TipAndAxis{turned(tip), turned({0, 0, 1})};
    };
    const auto way = fit_rotary_path(pose);
    ASSERT_TRUE(way.has_value());
    constexpr double kStep = 1e-4;
    for (const double t : {-0.2, 0.0, 0.1, 0.37, 0.5, 0.93, 1.0, 1.2}) {
        const ToolFrame at = tool_frame(*way, t);
        const TipAndAxis here = pose(t), before = pose(t - kStep), after = pose(t + kStep);
        EXPECT_NEAR(norm(at.tip - here.tip), 0.0, 1e-10);
        EXPECT_NEAR(norm(at.axis - here.axis), 0.0, 1e-12);
        EXPECT_NEAR(norm(at.speed - (0.5 / kStep) * (after.tip - before.tip)), 0.0, 1e-4);
        EXPECT_NEAR(norm(at.turn - (0.5 / kStep) * (after.axis - before.axis)), 0.0, 1e-6);
        const Vec3 bow = after.tip + before.tip - 2.0 * here.tip;
        EXPECT_NEAR(norm(at.change - (1.0 / kStep / kStep) * bow), 0.0, 1e-3);
        const Vec3 bend = after.axis + before.axis - 2.0 * here.axis;
        EXPECT_NEAR(norm(at.bend - (1.0 / kStep / kStep) * bend), 0.0, 1e-4);
    }
}

TEST(RotaryPath, DoesNotGoThroughMoreThanItCan) {
    const auto spin = [](double t) {
        return TipAndAxis{{}, {std::cos(40.0 * t), std::sin(40.0 * t), 0.0}};
    };
    EXPECT_FALSE(fit_rotary_path(spin).has_value());
}

TEST(Envelope, OfLinesIsTheSameWhateverPieceItIs) {
    const Fillet bull{4.0, 2.0, 2.0};
    const Vec3 up{0, 0, 1};
    const auto of = [&](Vec3 from, Vec3 along) {
        return Surface{Envelope{std::make_shared<Sweep>(bull, StraightPath{from, along, up})},
                       true};
    };
    const Surface first = of({1, 2, 3}, {10, 0, -2});
    EXPECT_TRUE(is_same(first, of({21, 2, -1}, {5, 0, -1}), 1e-9));
    EXPECT_TRUE(is_same(first, of({11, 2, 1}, {-10, 0, 2}), 1e-9));
    EXPECT_FALSE(is_same(first, of({11, 2, 1.001}, {-10, 0, 2}), 1e-4));
    EXPECT_FALSE(is_same(first, of({1, 2, 3}, {10, 0.01, -2}), 1e-4));
}

TEST(Envelope, OfArcsIsTheSameThereAndBack) {
    HelixPath way{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, 10.0, 0.0, -0.5, std::numbers::pi, {0, 0, 1}};
    const Fillet ball{0.0, 3.0, 3.0};
    const auto of = [&](const HelixPath& round) {
        return Surface{Envelope{std::make_shared<Sweep>(ball, round)}, true};
    };
    const Surface first = of(way);
    HelixPath back = way;
    back.centre.z += way.lead * way.swept;
    back.ahead = -way.ahead;
    back.swept = -way.swept;
    EXPECT_TRUE(is_same(first, of(back), 1e-9));
    back.centre.z += 1e-3;
    EXPECT_FALSE(is_same(first, of(back), 1e-4));
}

}  // namespace
}  // namespace ncsim::brep
