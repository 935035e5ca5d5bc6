// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings of docs/tools.md: a tool of each kind, as `--tool` makes the tool.
// NCSIM_UPDATE_GOLDENS=1 in the environment writes docs/tools/*.svg anew.
#include "ncsim/toolpath/tool_spec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace ncsim::toolpath {
namespace {

struct Drawn {
    const char* file;
    const char* option;
};
constexpr Drawn kDrawn[] = {
    {"flat", "T1=flat:D12:L26:S12x30"},
    {"ball", "T1=ball:D12:L26:S12x30"},
    {"bull", "T1=bull:D12:R3:L26:S12x30"},
    {"face", "T1=face:D50:L12:S22x30"},
    {"v", "T1=v:D12:A60:P1:L16:S12x30"},
    {"chamfer", "T1=chamfer:D12:A90:P3:L10:S8x30"},
    {"spot", "T1=spot:D10:A90:L20:S10x30"},
    {"engraver", "T1=engraver:D6:A30:P0.2:L12:S6x25"},
    {"countersink", "T1=countersink:D12:A90:P2:L6:S8x30"},
    {"drill", "T1=drill:D8:A118:L40:S8x20"},
    {"taper", "T1=taper:D3:R1.5:A6:L24:S12x30"},
    {"slot", "T1=slot:D20:L5:N8x12:S12x30"},
    {"dovetail", "T1=dovetail:D20:A60:L8:N8x10:S12x30"},
    {"lollipop", "T1=lollipop:D12:N5x14:S12x30"},
    {"corner", "T1=corner:P6:R4:L8:S10x30"},
    {"tap", "T1=tap:D8:K1.25:L24:S6x30"},
    {"reamer", "T1=reamer:D8:L30:S8x25"},
    {"boring-bar", "T1=boring-bar:D20:L6:N14x40"},
    {"thread", "T1=thread:D10:L14:N7x14:S10x25"},
};

std::string number(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0,
                                   std::chars_format::fixed, 2);
    return {text.data(), end.ptr};
}

// Returns half of a profile from the axis at the lower end to the axis at the upper end. `side` is
// 1 or -1; heights point up in the drawing.
std::string outline(const std::vector<ProfilePoint>& profile, double side, double top) {
    const auto place = [&](double radius, double height) {
        return number(side * radius) + " " + number(top - height);
    };
    std::string path = "M" + place(0.0, profile.front().height);
    std::vector<ProfilePoint> points = profile;
    points.insert(points.begin(), {0.0, profile.front().height, 0.0});
    points.push_back({0.0, profile.back().height, 0.0});
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const ProfilePoint& p = points[i];
        const double ax = p.radius - points[i - 1].radius, ay = p.height - points[i - 1].height;
        const double bx = points[i + 1].radius - p.radius, by = points[i + 1].height - p.height;
        const double a = std::hypot(ax, ay), b = std::hypot(bx, by);
        if (p.fillet <= 0.0 || a == 0.0 || b == 0.0) {
            path += " L" + place(p.radius, p.height);
            continue;
        }
        const double turn = std::acos(std::clamp((ax * bx + ay * by) / (a * b), -1.0, 1.0));
        const double length = p.fillet * std::tan(turn / 2);
        path += " L" + place(p.radius - ax / a * length, p.height - ay / a * length);
        path += " A" + number(p.fillet) + " " + number(p.fillet) + " 0 0 " +
                (side > 0 ? "0 " : "1 ") +
                place(p.radius + bx / b * length, p.height + by / b * length);
    }
    return path + " L" + place(0.0, profile.back().height) + " Z";
}

std::string drawing(const Tool& tool) {
    double top = 0.0, radius = 0.0;
    for (const ToolPiece& piece : tool.pieces) {
        for (const ProfilePoint& p : piece.profile) {
            top = std::max(top, p.height);
            radius = std::max(radius, p.radius);
        }
    }
    constexpr double kMargin = 2.0;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                      number(3 * (2 * radius + 2 * kMargin)) + "\" height=\"" +
                      number(3 * (top + 2 * kMargin)) + "\" viewBox=\"" +
                      number(-radius - kMargin) + " " + number(-kMargin) + " " +
                      number(2 * radius + 2 * kMargin) + " " + number(top + 2 * kMargin) + "\">\n";
    for (const ToolPiece& piece : tool.pieces) {
        const char* colour = piece.cutting ? "#d08a2e" : "#9aa5b1";
        for (const double side : {1.0, -1.0})
            svg += std::string("<path fill=\"") + colour + "\" d=\"" +
                   outline(piece.profile, side, top) + "\"/>\n";
    }
    svg +=
        "<path fill=\"none\" stroke=\"#808080\" stroke-width=\"0.3\" stroke-dasharray=\"3 1 1 1\" "
        "d=\"M0 " +
        number(-kMargin) + " L0 " + number(top + kMargin) + "\"/>\n</svg>\n";
    return svg;
}

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ToolDrawings, ShowTheToolsAsTheyAreMade) {
    const std::string folder = NCSIM_SOURCE_DIR "/docs/tools/";
    const std::string page = text_of(NCSIM_SOURCE_DIR "/docs/tools.md");
    std::set<ToolKind> kinds;
    for (const Drawn& drawn : kDrawn) {
        std::string message;
        const auto spec = parse_tool_option(drawn.option, message);
        ASSERT_TRUE(spec) << drawn.option << ": " << message;
        const Tool tool = make_tool(*spec, 30.0);
        kinds.insert(tool.kind);
        const std::string svg = drawing(tool);
        const std::string path = folder + drawn.file + ".svg";
        if (std::getenv("NCSIM_UPDATE_GOLDENS")) std::ofstream(path, std::ios::binary) << svg;
        EXPECT_EQ(text_of(path), svg) << drawn.file;
        EXPECT_NE(page.find(std::string("tools/") + drawn.file + ".svg"), std::string::npos)
            << "docs/tools.md does not show " << drawn.file;
        EXPECT_NE(page.find(std::string("`") + drawn.option + "`"), std::string::npos)
            << "docs/tools.md does not have " << drawn.option;
    }
    // Each kind except the free form has a drawing.
    for (int kind = 0; kind < static_cast<int>(ToolKind::Other); ++kind)
        EXPECT_TRUE(kinds.contains(static_cast<ToolKind>(kind)))
            << name_of(static_cast<ToolKind>(kind));
}

}  // namespace
}  // namespace ncsim::toolpath
