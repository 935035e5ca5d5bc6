// SPDX-License-Identifier: GPL-3.0-or-later
//
// PATTERN DEF with CYCL CALL PAT makes the motions of CYCL CALL POS at the same places.
#include "gcode/klartext_made.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::gcode::klartext_test {
namespace {

const std::string kDrill =
    "CYCL DEF 200 DRILLING Q200=2 Q201=-5 Q206=150 Q202=9 Q210=0 Q203=+0 Q204=20 Q211=0\n";

using Places = std::vector<std::pair<double, double>>;

std::string text_of(double value) {
    std::ostringstream text;
    text << std::showpos << std::fixed << std::setprecision(9) << value;
    return text.str();
}

std::string calls_at(const Places& places, const std::string& z) {
    std::string calls;
    for (const auto& [x, y] : places) {
        // Q204 above a lower surface is below the height of the call.
        if (!calls.empty() && z.starts_with('-') && !z.starts_with("-0.")) calls += "L Z+20 FMAX\n";
        calls += "CYCL CALL POS X" + text_of(x) + " Y" + text_of(y) + " Z" + z + " FMAX\n";
    }
    return calls;
}

void expect_places(const std::string& pattern, const Places& places, const std::string& z = "+0") {
    SCOPED_TRACE(pattern);
    const std::string above = "L Z+20 FMAX\n";
    language_test::expect_close(
        run(klartext(above + "PATTERN DEF " + pattern + "\n" + kDrill + "CYCL CALL PAT FMAX")),
        run(klartext(above + kDrill + calls_at(places, z))));
}

TEST(KlartextPatterns, AreCallsAtTheirPlaces) {
    std::mt19937 random(20261130);
    std::uniform_int_distribution<int> length(-40, 40);
    std::uniform_int_distribution<int> count(1, 5);
    for (int round = 0; round < 25; ++round) {
        const double x = length(random);
        const double y = length(random);
        const int d = 3 + std::abs(length(random));
        const int e = 3 + std::abs(length(random));
        const int n = count(random);
        const int m = count(random);
        const int rot = 3 * length(random);
        const int z = -std::abs(length(random)) / 4;
        const auto at = [&](double u, double v) {
            const double angle = rot * std::numbers::pi / 180.0;
            return std::pair{x + u * std::cos(angle) - v * std::sin(angle),
                             y + u * std::sin(angle) + v * std::cos(angle)};
        };
        const auto on_circle = [&](double degrees) {
            const double angle = degrees * std::numbers::pi / 180.0;
            return std::pair{x + d / 2.0 * std::cos(angle), y + d / 2.0 * std::sin(angle)};
        };
        const std::string xy = "(X" + text_of(x) + " Y" + text_of(y);
        const std::string end = " Z" + text_of(z) + ")";
        const std::string turned = " ROT" + text_of(rot) + end;
        Places row;
        Places grid;
        Places frame;
        Places circle;
        Places part;
        for (int i = 0; i < n; ++i) {
            row.push_back(at(i * d, 0));
            circle.push_back(on_circle(rot + i * 360.0 / n));
            part.push_back(on_circle(rot + i * 25.0));
        }
        for (int j = 0; j < m; ++j) {
            for (int i = 0; i < n; ++i) {
                grid.push_back(at(i * d, j * e));
                if (j == 0 || j + 1 == m || i == 0 || i + 1 == n) frame.push_back(at(i * d, j * e));
            }
        }
        const std::string num = " NUM" + std::to_string(n);
        const std::string nums = " DX" + std::to_string(d) + " DY" + std::to_string(e) + " NUMX" +
                                 std::to_string(n) + " NUMY" + std::to_string(m) + turned;
        const std::string diameter = " D" + std::to_string(d);
        const std::string start = " START" + text_of(rot);
        expect_places("POS1 " + xy + end, {{x, y}}, text_of(z));
        expect_places("ROW1 " + xy + diameter + num + turned, row, text_of(z));
        expect_places("PAT1 " + xy + nums, grid, text_of(z));
        expect_places("FRAME1 " + xy + nums, frame, text_of(z));
        expect_places("CIRC1 " + xy + diameter + start + num + end, circle, text_of(z));
        expect_places("PITCHCIRC1 " + xy + diameter + start + " STEP+25" + num + end, part,
                      text_of(z));
        if (n > 1) {
            expect_places("PITCHCIRC1 " + xy + diameter + start + " END" +
                              text_of(rot + 25.0 * (n - 1)) + num + end,
                          part, text_of(z));
        }
    }
}

TEST(KlartextPatterns, FollowOneAnotherInABlock) {
    expect_places("POS1 (X+1 Y+2 Z+0) ~\n POS2 (X+3 Y+4 Z+0) ROW1 (X+10 Y+0 D5 NUM2 ROT+0 Z+0)",
                  {{1, 2}, {3, 4}, {10, 0}, {15, 0}});
    // The last PATTERN DEF counts; Q parameters are read where it is defined.
    expect_places("POS1 (X+9 Y+9)\nQ1=+7\nPATTERN DEF POS1 (X+Q1 Y-Q1)\nQ1=+8", {{7, -7}});
}

TEST(KlartextPatterns, KeepTheHeightOfTheCall) {
    const auto highest = [](const std::string& height) {
        const Made made = run(klartext(kDrill + "PATTERN DEF ROW1 (X+0 Y+0 D10 NUM3)\nL Z" +
                                       height + " FMAX\nCYCL CALL PAT FMAX"));
        EXPECT_EQ(made.errors(), "");
        double z = -1e9;
        for (std::size_t i = 0; i + 1 < made.moves.size(); ++i) {
            const Position& from = *end_of(made.moves[i]);
            const Position& to = *end_of(made.moves[i + 1]);
            if (from.x.mm() != to.x.mm()) z = to.z.mm();
        }
        return z;
    };
    EXPECT_EQ(highest("+35"), 35.0);
    EXPECT_EQ(highest("+20"), 20.0);
    EXPECT_EQ(highest("+3"), 20.0) << "Q204";
    EXPECT_EQ(highest("-3"), 20.0);
}

TEST(KlartextPatterns, Refused) {
    EXPECT_TRUE(run(klartext("PATTERN DEF POS1 (X+1 Y+1)\nCYCL CALL PAT")).says("cycle-undefined"));
    for (const std::string pattern :
         {"POS1 (X+1)", "ROW1 (X+1 Y+1 D5)", "ROW1 (X+1 Y+1 D5 NUM0)", "ROW1 (X+1 Y+1 D5 NUM1.5)",
          "PAT1 (X+1 Y+1 DX5 DY5 NUMX200 NUMY200)", "PITCHCIRC1 (X+1 Y+1 D5 NUM3)"})
        EXPECT_TRUE(run(klartext("PATTERN DEF " + pattern)).says("word-missing")) << pattern;
    for (const std::string pattern :
         {"STAR1 (X+1 Y+1)", "POS1 X+1 Y+1", "POS1 (X+1 Y+1", "POS1 (X+1 X+2 Y+1)", "POS1 (X Y)"})
        EXPECT_TRUE(run(klartext("PATTERN DEF " + pattern)).says("klartext-word")) << pattern;
    EXPECT_TRUE(run(klartext("PATTERN DEF PAT1 (X+1 Y+1 DX5 DY5 NUMX2 NUMY2 ROTX+5)"))
                    .says("klartext-verb"));
    EXPECT_TRUE(run(klartext(kDrill + "CYCL CALL PAT")).says("word-missing"));
}

}  // namespace
}  // namespace ncsim::gcode::klartext_test
