// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners between arcs and lines under G41 and G42. The centre of the tool keeps the distance of
// its radius from both elements, on the side of the code; the expected points follow from circles
// and lines on paper.
#include "gcode/language_made.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

constexpr double kToolRadius = 5.0;

struct Point {
    double x, y;
};
Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}
Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
Point operator*(double f, Point a) {
    return {f * a.x, f * a.y};
}
double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}
double length(Point a) {
    return std::hypot(a.x, a.y);
}
Point left_of(Point direction) {
    return {-direction.y, direction.x};
}
Point at_angle(double degrees) {
    const double a = degrees * std::numbers::pi / 180.0;
    return {std::cos(a), std::sin(a)};
}

/// An element that ends or begins at X0 Y0 in the direction `tangent`. `turn`: 0 for a line, 1 for
/// a counter-clockwise arc of 60 degrees, -1 for a clockwise one.
struct Element {
    Point tangent;
    int turn = 0;
    double radius = 0.0;

    Point centre() const { return (turn * radius) * left_of(tangent); }
    /// The other end, `way` 1: after X0 Y0, -1: before.
    Point far_end(double way) const {
        if (turn == 0) return (way * 40.0) * tangent;
        const Point c = centre();
        const double angle = way * turn * 60.0 * std::numbers::pi / 180.0;
        const Point r = Point{0, 0} - c;
        return c + Point{r.x * std::cos(angle) - r.y * std::sin(angle),
                         r.x * std::sin(angle) + r.y * std::cos(angle)};
    }
    /// Signed distance of `p` to the left of the element.
    double left(Point p) const {
        if (turn == 0) return cross(tangent, p);
        return turn * (radius - length(p - centre()));
    }
    /// The block from X0 Y0 or to X0 Y0.
    std::string block(Point from, Point to) const {
        const std::string end = " X" + std::to_string(to.x) + " Y" + std::to_string(to.y);
        if (turn == 0) return "G1" + end;
        const Point ij = centre() - from;
        return (turn > 0 ? "G3" : "G2") + end + " I" + std::to_string(ij.x) + " J" +
               std::to_string(ij.y);
    }
};

Point place(const Position& p) {
    return {p.x.mm(), p.y.mm()};
}

/// Motions of the block in `line`.
std::vector<Motion> motions_of(const language_test::Made& made, std::uint32_t line) {
    std::vector<Motion> found;
    for (const Motion& move : made.moves) {
        if (move.span.line == line) found.push_back(move);
    }
    return found;
}

TEST(CompensationCorners, KeepTheRadiusFromBothElements) {
    const std::array<Element, 6> kinds{{{{}, 0, 0.0},
                                        {{}, 1, 20.0},
                                        {{}, -1, 20.0},
                                        {{}, 1, 33.0},
                                        {{}, -1, 33.0},
                                        {{}, -1, 12.0}}};
    int inside = 0;
    int outside = 0;
    for (const Element& first : kinds) {
        for (const Element& second : kinds) {
            for (const double bend : {-100.0, -40.0, 40.0, 100.0}) {
                for (const int side : {1, -1}) {
                    Element a = first;
                    Element b = second;
                    a.tangent = at_angle(10.0);
                    b.tangent = at_angle(10.0 + bend);
                    const Point start = a.far_end(-1.0);
                    const Point end = b.far_end(1.0);
                    // A lead-in far before the first element, on its side, and a lead-out.
                    const Point before =
                        start + (side * 60.0) * left_of(start.x < 0 ? Point{1, 0} : Point{0, 1});
                    const std::string text =
                        "G21 G90 G17 G40 F100\nT1 M6\nG0 X" + std::to_string(before.x) + " Y" +
                        std::to_string(before.y) + " Z0\n" + (side > 0 ? "G41" : "G42") +
                        " D1 G1 X" + std::to_string(start.x) + " Y" + std::to_string(start.y) +
                        "\n" + a.block(start, {0, 0}) + "\n" + b.block({0, 0}, end) +
                        "\nG40 G1 X200 Y200\nM2\n";
                    SCOPED_TRACE(text);
                    const language_test::Made made =
                        language_test::run(text, {}, Dialect::Fanuc, false, "t.nc");
                    if (!made.errors().empty()) continue;  // The tool does not fit.
                    const std::vector<Motion> one = motions_of(made, 5);
                    const std::vector<Motion> two = motions_of(made, 6);
                    ASSERT_FALSE(one.empty() || two.empty());
                    const bool is_inside = bend * side > 0.0;
                    if (is_inside) {
                        ASSERT_EQ(one.size(), 1U);
                        const Point corner = place(*end_of(one.back()));
                        EXPECT_NEAR(a.left(corner), side * kToolRadius, 2e-5);
                        EXPECT_NEAR(b.left(corner), side * kToolRadius, 2e-5);
                        EXPECT_LT(length(corner), 4.0 * kToolRadius) << "the nearer intersection";
                        EXPECT_EQ(*start_of(two.front()), *end_of(one.back()));
                        ++inside;
                    } else {
                        // The tool rolls around X0 Y0, from the normal of one to that of the other.
                        const auto near = [](Point p, Point q) { return length(p - q) < 2e-5; };
                        const Point leave = (side * kToolRadius) * left_of(a.tangent);
                        const Point meet = (side * kToolRadius) * left_of(b.tangent);
                        EXPECT_TRUE(near(place(*end_of(one.front())), leave));
                        EXPECT_TRUE(near(place(*start_of(two.back())), meet));
                        ++outside;
                    }
                }
            }
        }
    }
    EXPECT_GT(inside, 60);
    EXPECT_GT(outside, 120);
}

TEST(CompensationCorners, ASlotAsWideAsTheToolFits) {
    // Down, 10 across, and up again, with a tool of diameter 10 inside: no way is left across.
    const auto errors = [](double width) {
        const std::string w = std::to_string(width);
        return language_test::run(
                   "G21 G90 G17 F100\nT1 M6\nG0 X-30 Y40 Z0\nG41 D1 G1 X0 Y40\nY0\nX" + w +
                       "\nY40\nG40 X60\nM2\n",
                   {}, Dialect::Fanuc, false, "t.nc")
            .errors();
    };
    EXPECT_EQ(errors(10.0), "");
    EXPECT_EQ(errors(10.01), "");
    EXPECT_NE(errors(9.99), "");
}

}  // namespace
}  // namespace ncsim::gcode
