// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests that surfaces come back from text as they were, and move with the part.
#include "ncsim/brep/surface_text.h"

#include "brep/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace ncsim::brep {
namespace {

using test::Draw;

Vec3 across(Draw& draw, Vec3 axis) {
    return normalized(cross(axis, draw.direction()));
}

RotaryPath random_rotary_path(Draw& draw) {
    const Vec3 from = draw.point(), way = draw.point(), axis = draw.direction();
    const Vec3 side = across(draw, axis);
    const auto path = fit_rotary_path([&](double t) {
        return TipAndAxis{from + t * way, std::cos(0.4 * t) * axis + std::sin(0.4 * t) * side};
    });
    return path.value();
}

ToolPath random_path(Draw& draw, int kind) {
    if (kind == 0) return StraightPath{draw.point(), draw.point(), draw.direction()};
    if (kind == 2) return random_rotary_path(draw);
    HelixPath helix;
    helix.centre = draw.point();
    helix.about = helix.axis = draw.direction();
    helix.ahead = across(draw, helix.about);
    helix.reach = draw.from(1, 9);
    helix.growth = draw.from(-0.1, 0.1);
    helix.lead = draw.from(-1, 1);
    helix.swept = draw.from(1, 3);
    return helix;
}

// Returns a surface of each form, in the order of kForms, envelopes of all elements and paths last.
std::vector<Form> random_forms(Draw& draw) {
    const Vec3 axis = draw.direction(), ahead = across(draw, axis);
    const auto length = [&] { return draw.from(0.5, 9.0); };
    Vec3 along = draw.direction();
    if (dot(along, axis) < 0.0) along = -along;
    std::vector<Form> forms{
        Plane{draw.point(), axis},
        Cylinder{draw.point(), axis, length()},
        Cone{draw.point(), axis, length()},
        Sphere{draw.point(), length()},
        Torus{draw.point(), axis, length(), length()},
        Extrusion{draw.point(), axis, along, length()},
        Dome{draw.point(), axis, ahead, length(), length()},
        Coil{draw.point(), axis, ahead, length(), length(), draw.from(-2, -1)},
        Spiral{draw.point(), axis, ahead, length(), draw.from(-1, 1), draw.from(-0.4, 0.4)}};
    const auto add_envelope = [&](const auto& element, int path) {
        auto sweep = std::make_shared<const Sweep>(element, random_path(draw, path));
        if (has_across(*sweep)) forms.emplace_back(Envelope{std::move(sweep)});
    };
    for (int path = 0; path < 3; ++path) {
        if (path != 0) add_envelope(Fillet{0.0, length(), length()}, path);
        add_envelope(Fillet{draw.from(0.1, 3), draw.from(0, 3), length()}, path);
    }
    add_envelope(Flank{length(), draw.from(0, 3), 0.8, -0.6, length()}, 2);
    return forms;
}

CandidateSurface with_marks(const Form& form, int marks) {
    CandidateSurface candidate{{form, (marks & 1) != 0}, (marks & 2) != 0};
    constexpr double kInf = std::numeric_limits<double>::infinity();
    if (marks & 4) candidate.place = Box{{-1.5, -kInf, 2}, {kInf, 1e-7, 3}};
    if (marks & 8) candidate.ends = {Plane{{1, 2, 3}, {0, 0, 1}}, Plane{{1, 2, 9}, {0, 0.6, 0.8}}};
    if (marks & 16) candidate.below_side = Vec3{0, 0.6, 0.8};
    return candidate;
}

TEST(SurfaceText, ComesBackAsItWas) {
    Draw draw(5);
    for (int i = 0; i < 32; ++i) {
        for (const Form& form : random_forms(draw)) {
            const CandidateSurface candidate = with_marks(form, i);
            const std::string text = text_of(candidate);
            SCOPED_TRACE(text);
            const auto again = candidate_of(text);
            ASSERT_TRUE(again);
            EXPECT_EQ(again->surface, candidate.surface);
            EXPECT_EQ(again->is_at_rest, candidate.is_at_rest);
            EXPECT_EQ(again->place, candidate.place);
            EXPECT_EQ(again->ends, candidate.ends);
            EXPECT_EQ(again->below_side, candidate.below_side);
        }
    }
}

TEST(SurfaceText, OtherTextIsNoSurface) {
    Draw draw(6);
    for (const Form& form : random_forms(draw)) {
        const std::string text = text_of(with_marks(form, 30));
        for (std::size_t end = 0; end < text.size(); ++end) {
            // A shorter number is a number, and the marks may be missing.
            if (text[end] != ' ' || text.substr(end).starts_with(" rest") ||
                text.substr(end).starts_with(" within") ||
                text.substr(end).starts_with(" between") || text.substr(end).starts_with(" below"))
                continue;
            EXPECT_FALSE(candidate_of(text.substr(0, end))) << text.substr(0, end);
        }
        EXPECT_FALSE(candidate_of(text + " 1"));
        EXPECT_FALSE(candidate_of(text + " rest"));
    }
    for (const char* text : {"",
                             "ball 0 0 0 1",
                             "cylinder 0 0 0 0 0 1 -4",
                             "cylinder 0 0 0 0 0 1 0",
                             "cylinder 0 0 0 0 0 2 4",
                             "cylinder 0 0 0 0 0 0 4",
                             "cylinder nan 0 0 0 0 1 4",
                             "cylinder inf 0 0 0 0 1 4",
                             "cylinder 1e9 0 0 0 0 1 4",
                             "cylinder 0 0 0 0 0 1 4x",
                             "cylinder 0 0 0 0 0 1 4 hollow hollow",
                             "cylinder 0 0 0 0 0 1 4 within 0 0 0 1 1 nan",
                             "dome 0 0 0 0 0 1 0 0.6 0.8 4 4",
                             "envelope ball 1 2 3 line 0 0 0 1 1 1 0 0 1",
                             "envelope fillet 1 2 3 rotary 1e9 0 0 0 0 0 1",
                             "envelope flank 4 0 0.8 -0.6 3 line 0 0 0 1 0 0 0 0 1",
                             "envelope fillet 0 3 3 line 0 0 0 0 0 0 0 0 1",
                             "envelope fillet 0 3 3 helix 0 0 0 0 0 1 1 0 0 9 0 0.2 99 0 0 1",
                             "extrusion 0 0 0 0 0 1 1 0 0 4",
                             "coil 0 0 0 0 0 1 1 0 0 9 2 0",
                             "envelope fillet 1 2 3 rotary 0.5 0"})
        EXPECT_FALSE(candidate_of(text)) << text;
}

// Changed text is refused, or is another surface that comes back as it was.
TEST(SurfaceText, ChangedTextDoesNoHarm) {
    Draw draw(8);
    const std::string letters = "0123456789.-+e naif\t";
    const auto any = [&](std::size_t size) {
        return std::min(size - 1,
                        static_cast<std::size_t>(draw.from(0.0, static_cast<double>(size))));
    };
    int read = 0, distances = 0;
    for (int i = 0; i < 40; ++i) {
        for (const Form& form : random_forms(draw)) {
            for (int k = 0; k < 20; ++k) {
                std::string text = text_of(with_marks(form, 15));
                for (int n = 0; n < 1 + k / 5; ++n)
                    text[any(text.size())] = letters[any(letters.size())];
                const auto candidate = candidate_of(text);
                if (!candidate) continue;
                ++read;
                EXPECT_EQ(candidate_of(text_of(*candidate))->surface, candidate->surface) << text;
                distances += evaluate(candidate->surface.form, draw.point()).distance > 0.0;
            }
        }
    }
    EXPECT_GT(read, 1000);
    EXPECT_GT(distances, 100);
}

// The distance of a moved point from the moved surface is that of the point from the surface.
TEST(SurfaceText, MovesWithThePart) {
    Draw draw(7);
    RigidMotion motion;
    motion.rows = {Vec3{0, 0, 1}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}};
    motion.shift = {3, -20, 0.5};
    const auto place = [&](Vec3 p) {
        return Vec3{dot(motion.rows[0], p), dot(motion.rows[1], p), dot(motion.rows[2], p)} +
               motion.shift;
    };
    for (int i = 0; i < 5; ++i) {
        for (const Form& form : random_forms(draw)) {
            const CandidateSurface before = with_marks(form, 15);
            const CandidateSurface after = moved(before, motion);
            SCOPED_TRACE(text_of(before));
            for (int k = 0; k < 10; ++k) {
                const Vec3 p = draw.point();
                EXPECT_NEAR(distance(before.surface.form, p),
                            distance(after.surface.form, place(p)), 1e-9);
                EXPECT_EQ(before.place->contains(p), after.place->contains(place(p)));
                for (std::size_t end = 0; end < 2; ++end)
                    EXPECT_NEAR(distance((*before.ends)[end], p),
                                distance((*after.ends)[end], place(p)), 1e-9);
            }
        }
    }
}

}  // namespace
}  // namespace ncsim::brep
