// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of tools: each that is specified is kept in the tool that is made, or refused by its
// letter. All kinds, all values, and random combinations of them.
#include "ncsim/toolpath/tool_spec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace ncsim::toolpath {
namespace {

struct Kind {
    const char* name;
    const char* least;  // values without which there is no such tool
};
constexpr Kind kKinds[] = {
    {"flat", ":D10"},        {"ball", ":D10"},       {"bull", ":D10:R2"},  {"face", ":D50"},
    {"v", ":D10:A60"},       {"spot", ":D10"},       {"engraver", ":D6"},  {"chamfer", ":D12"},
    {"countersink", ":D12"}, {"drill", ":D8"},       {"taper", ":D3:A6"},  {"slot", ":D20:L5"},
    {"dovetail", ":D20"},    {"lollipop", ":D12"},   {"corner", ":P6:R4"}, {"tap", ":D8"},
    {"reamer", ":D8"},       {"boring-bar", ":D20"}, {"thread", ":D10"},   {"", ":D10"},
};

constexpr const char* kValues[] = {
    "D4",    "D12", "D30",   "R0",  "R0.5", "R2",  "R5",   "R6",     "R40",
    "L0.5",  "L4",  "L12",   "L40", "A1",   "A30", "A60",  "A118",   "A179",
    "P0",    "P1",  "P8",    "P20", "K0",   "K1",  "K2.5", "N3",     "N6x10",
    "N30x5", "S6",  "S8x20", "S40", "E5",   "E30", "E90",  "H28x15", "H28x15,40x20"};

// Radius of the arc whose first chord this piece is.
double concave_radius(const ToolPiece& piece) {
    const double out = piece.profile.back().radius - piece.profile.front().radius;
    const double up = piece.profile.back().height;
    return (up * up + out * out) / (2 * out);
}

std::vector<const ToolPiece*> bodies_of(const Tool& tool) {
    std::vector<const ToolPiece*> bodies;
    for (const ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) bodies.push_back(&piece);
    }
    return bodies;
}

bool has_step(const Tool& tool, double diameter, const std::optional<double>& length) {
    const auto bodies = bodies_of(tool);
    return std::any_of(bodies.begin(), bodies.end(), [&](const ToolPiece* p) {
        const double height = p->profile.back().height - p->profile.front().height;
        return std::abs(2 * p->profile.front().radius - diameter) < 1e-9 &&
               (!length || std::abs(height - *length) < 1e-9);
    });
}

// The letters of the values that `tool` does not have.
std::string lost_values(const ToolSpec& spec, const Tool& tool) {
    std::string lost;
    const auto expect = [&lost](char letter, bool is_kept) {
        if (!is_kept) lost += letter;
    };
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6; };
    const double reach = spec.stick_out.value_or(1e9);
    const auto& tip = tool.pieces.front().profile;
    const double d = cutting_diameter_of(tool);
    // Flutes that end in the holder show less than all of their shape.
    const bool is_cut_off = spec.length.value_or(0.0) > reach || cutting_height_of(tool) >= reach;
    if (is_cut_off) {
        expect('L', cutting_height_of(tool) <= reach + 1e-9);
    } else {
        if (spec.diameter && spec.kind != ToolKind::TaperedEndMill && !spec.taper)
            expect('D', near(d, *spec.diameter));
        const bool is_ball =
            tool.kind == ToolKind::BallEndMill || tool.kind == ToolKind::LollipopMill;
        if (spec.corner_radius && tool.kind == ToolKind::CornerRoundingMill) {
            expect('R', near(concave_radius(tool.pieces.front()), *spec.corner_radius));
        } else if (spec.corner_radius) {
            expect('R', is_ball ? std::abs(tip.front().fillet - *spec.corner_radius) <= 0.01 * d
                                : near(tip.front().fillet, *spec.corner_radius));
        }
        if (spec.length) expect('L', std::abs(cutting_height_of(tool) - *spec.length) <= 0.01 * d);
        if (spec.tip_diameter) expect('P', near(2 * tip.front().radius, *spec.tip_diameter));
        const auto slope = [&tip] {
            return (tip[1].radius - tip[0].radius) / (tip[1].height - tip[0].height);
        };
        constexpr double kDegree = 0.017453292519943295;
        if (spec.angle && d > spec.tip_diameter.value_or(0.0))
            expect('A', near(slope(), std::tan(*spec.angle / 2 * kDegree)));
        if (spec.taper && tip.size() > 1)
            expect('A', near(std::abs(slope()), std::tan(*spec.taper * kDegree)));
    }
    if (spec.pitch) expect('K', tool.kind == ToolKind::Tap || tool.kind == ToolKind::ThreadMill);
    const bool is_hidden = height_of(tool) >= reach - 1e-9 && !is_cut_off;
    if (spec.neck_diameter)
        expect('N',
               is_cut_off || is_hidden || has_step(tool, *spec.neck_diameter, spec.neck_length));
    // Without a stick-out a holder begins as low as it can.
    const bool is_low = !spec.holder.empty() && !spec.stick_out && !spec.shank_length;
    if (spec.shank_diameter)
        expect('S', is_cut_off || is_hidden || is_low ||
                        has_step(tool, *spec.shank_diameter, spec.shank_length));
    if (!spec.holder.empty() && spec.stick_out) {
        double total = 0.0;
        for (const ToolSegment& segment : spec.holder)
            total += segment.height;
        expect('E', std::abs(height_of(tool) - total - *spec.stick_out) <= 0.01 * d);
    }
    for (const ToolSegment& segment : spec.holder)
        expect('H', has_step(tool, segment.lower_diameter, segment.height));
    return lost;
}

// Fails if `option` makes a tool without one of its values, or is refused without its letter.
void judge(const std::string& option, const std::string& added) {
    std::string message;
    const auto spec = parse_tool_option(option, message);
    if (!spec) {
        const std::string why = message.substr(message.rfind("': ") + 3);
        EXPECT_TRUE(std::any_of(added.begin(), added.end(),
                                [&](char c) {
                                    return c >= 'A' && c <= 'Z' && why.find(c) != std::string::npos;
                                }) ||
                    why.find("angle") != std::string::npos ||
                    why.find("flank") != std::string::npos ||
                    why.find("length") != std::string::npos)
            << message;
        return;
    }
    EXPECT_EQ(lost_values(*spec, make_tool(*spec, 50.0)), "")
        << option << ": " << describe(make_tool(*spec, 50.0));
}

TEST(ToolValues, AreKeptOrRefusedForEachKind) {
    for (const Kind& kind : kKinds) {
        for (const char* value : kValues) {
            judge(std::string("T1=") + kind.name + kind.least + ":" + value, value);
            judge(std::string("T1=") + value + ":" + kind.name + kind.least, value);
            judge(std::string("T1=") + kind.name + ":" + value, std::string(value) + "DRP");
        }
    }
}

TEST(ToolValues, AreKeptOrRefusedInRandomCombinations) {
    std::mt19937 random(50);
    const auto any = [&random](std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    int made = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text, letters;
        std::vector<std::string> parts{kKinds[any(std::size(kKinds))].name};
        for (std::size_t n = 1 + any(6); n > 0; --n) {
            const std::string value = kValues[any(std::size(kValues))];
            if (letters.find(value.front()) != std::string::npos) continue;
            letters += value.front();
            parts.push_back(value);
        }
        std::shuffle(parts.begin(), parts.end(), random);
        for (const std::string& part : parts)
            text += (part.empty() || text.empty() ? "" : ":") + part;
        judge("T1=" + text, letters + "DRP");
        std::string message;
        made += parse_tool_option("T1=" + text, message).has_value() ? 1 : 0;
    }
    EXPECT_GT(made, 2000);
}

TEST(ToolValues, HaveOneKindAndEachLetterOnce) {
    std::string message;
    EXPECT_FALSE(parse_tool_option("T1=flat:D10:D12", message));
    EXPECT_NE(message.find("D is specified twice"), std::string::npos) << message;
    EXPECT_FALSE(parse_tool_option("T1=flat:ball:D10", message));
    EXPECT_NE(message.find("one kind"), std::string::npos) << message;
}

TEST(CornerRounding, IsMadeOfCones) {
    std::string message;
    const Tool tool = make_tool(parse_tool_option("T1=corner:P6:R4:L8", message).value(), 50);
    EXPECT_EQ(describe(tool), "corner rounding mill D14 P6 R4 L8");
    double error = 0.0, radius = 3.0, height = 0.0;
    for (const ToolPiece& piece : tool.pieces) {
        EXPECT_DOUBLE_EQ(piece.profile.front().radius, radius);
        EXPECT_DOUBLE_EQ(piece.profile.front().height, height);
        radius = piece.profile.back().radius;
        height = piece.profile.back().height;
        // The chord is in the tool: on the side of the axis as seen from the arc about (7, 0).
        const double x = (piece.profile.front().radius + radius) / 2 - 7.0;
        const double y = (piece.profile.front().height + height) / 2;
        if (height > 4.0) continue;
        error = std::max(error, 4.0 - std::hypot(x, y));
        EXPECT_LE(std::hypot(x, y), 4.0);
    }
    EXPECT_LE(error, kConcaveChord);
    EXPECT_GT(error, kConcaveChord / 4);
    EXPECT_EQ(radius, 7.0);
    EXPECT_EQ(height, 8.0);
}

}  // namespace
}  // namespace ncsim::toolpath
