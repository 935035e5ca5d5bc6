// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random blocks of polar words under G16, compared with the same points in X and Y.
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Point {
    double x = 0.0, y = 0.0;
};

struct Outcome {
    std::vector<Point> points;  // Ends of moves in the plane, or places of holes.
    Interpretation result;
    bool says(std::string_view code) const {
        return std::ranges::any_of(result.diagnostics,
                                   [code](const Diagnostic& d) { return d.code == code; });
    }
};

/// Returns the ends of the feed moves of `text`; of the plane XY.
Outcome run(const std::string& text, Dialect dialect) {
    InterpreterOptions options;
    options.dialect = dialect;
    Outcome outcome;
    outcome.result = interpret({"a.nc", text}, options, [&](const Motion& motion) {
        const Position* end = end_of(motion);
        if (end && motion.kind == MoveKind::Feed)
            outcome.points.push_back({end->x.mm(), end->y.mm()});
    });
    return outcome;
}

Point polar(Point pole, double radius, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {pole.x + radius * std::cos(angle), pole.y + radius * std::sin(angle)};
}

void expect_points(const std::string& text, Dialect dialect, const std::vector<Point>& expected) {
    const Outcome outcome = run(text, dialect);
    ASSERT_EQ(outcome.points.size(), expected.size()) << text;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(outcome.points[i].x, expected[i].x, 1e-6) << i << '\n' << text;
        EXPECT_NEAR(outcome.points[i].y, expected[i].y, 1e-6) << i << '\n' << text;
    }
    EXPECT_FALSE(outcome.says("polar-increment")) << text;
}

const std::string kHead = "G21 G17 G94 G54 G40 G49 G80 F100 S100 M3\nG90 G0 X3 Y4 Z5\n";

TEST(PolarWords, KeepRadiusAndAngleOfTheLastWords) {
    std::mt19937 random(20261130);
    const auto number = [&](int from, int to) {
        return static_cast<double>(std::uniform_int_distribution(from, to)(random));
    };
    for (int program = 0; program < 300; ++program) {
        const bool is_mach3 = program % 3 == 0;
        const Point pole = is_mach3 ? Point{3.0, 4.0} : Point{};
        std::string text = kHead + "G16\n";
        std::vector<Point> expected;
        double radius = number(-20, 20);
        double angle = number(-400, 400);
        text += "G1 X" + std::to_string(radius) + " Y" + std::to_string(angle) + "\n";
        expected.push_back(polar(pole, radius, angle));
        for (int block = 0; block < 8; ++block) {
            const bool has_radius = random() % 2 == 0;
            text += "G90";
            if (has_radius) {
                radius = random() % 4 == 0 ? 0.0 : number(-20, 20);
                text += " X" + std::to_string(radius);
            } else if (random() % 2 == 0) {
                angle = number(-400, 400);
                text += " Y" + std::to_string(angle);
            } else {
                const double step = number(-100, 100);
                angle += step;
                text += " G91 Y" + std::to_string(step);
                text.erase(text.rfind("G90"), 4);
            }
            text += "\n";
            expected.push_back(polar(pole, radius, angle));
        }
        expect_points(text + "G90 G15\nM30\n", is_mach3 ? Dialect::Mach3 : Dialect::Fanuc,
                      expected);
    }
}

/// The pole of an incremental radius is the tool.
TEST(PolarWords, AnIncrementalRadiusBeginsAtTheTool) {
    const Point first = polar({}, 10.0, 30.0);
    expect_points(kHead + "G16 G1 X10 Y30\nG91 X5\nG90 G15\nM30\n", Dialect::Fanuc,
                  {first, polar(first, 5.0, 30.0)});
    const Outcome both = run(kHead + "G16 G1 X10 Y30\nG91 X5 Y60\nG90 G15\nM30\n", Dialect::Fanuc);
    EXPECT_TRUE(both.says("polar-increment"));
}

/// Repeated cycles step the angle, not a fixed distance.
TEST(PolarWords, StepWithTheRepeatsOfACycle) {
    for (const double step : {90.0, -45.0, 120.0, 17.0}) {
        for (const double radius : {15.0, -15.0}) {
            for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Auto}) {
                const std::string repeats = dialect == Dialect::Fanuc ? "K" : "L";
                std::vector<Point> expected;
                for (int i = 0; i < 5; ++i)
                    expected.push_back(polar({}, radius, 30.0 + i * step));
                expect_points(kHead + "G16\nG98 G81 X" + std::to_string(radius) +
                                  " Y30 Z-5 R1\nG91 Y" + std::to_string(step) + " " + repeats +
                                  "4\nG90 G80 G15\nM30\n",
                              dialect, expected);
            }
        }
    }
}

}  // namespace
}  // namespace ncsim::gcode
