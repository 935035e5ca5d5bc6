// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stroke font and its drawing.
#include "render/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ncsim::exporter {

namespace {

// The characters from ' ' to '~' on a grid of 8 by 8. Each pair of digits is a point, x to the
// right, y upwards; commas separate strokes. The base line is y = 2; capitals reach up to 8, small
// letters to 6, and descenders down to 0. A stroke from a point to itself is a dot.
// clang-format off
constexpr std::array<std::string_view, 95> kGlyphs{
    "",  //  
    "48 44,42 42",  // !
    "38 36,58 56",  // "
    "22 38,52 68,14 74,16 76",  // #
    "86 67 27 06 25 65 84 63 23 04,48 42",  // $
    "02 88,17 17,73 73",  // %
    "82 16 17 28 48 57 56 03 12 42 84",  // &
    "48 46",  // '
    "58 37 33 52",  // (
    "38 57 53 32",  // )
    "43 47,24 66,26 64",  // *
    "25 65,43 47",  // +
    "42 31",  // ,
    "25 65",  // -
    "42 42",  // .
    "02 88",  // /
    "38 17 13 32 52 73 77 58 38",  // 0
    "17 48 42,22 62",  // 1
    "07 28 68 87 86 02 82",  // 2
    "07 28 68 87 86 65 35,65 84 83 62 22 03",  // 3
    "62 68 04 84",  // 4
    "78 18 15 26 66 85 83 62 22 03",  // 5
    "77 58 28 06 03 22 62 83 84 65 25 04",  // 6
    "08 88 32",  // 7
    "25 06 07 28 68 87 86 65 25 04 03 22 62 83 84 65",  // 8
    "13 32 62 84 87 68 28 07 06 25 65 86",  // 9
    "42 42,45 45",  // :
    "42 31,45 45",  // ;
    "77 15 73",  // <
    "26 66,24 64",  // =
    "17 75 13",  // >
    "07 28 68 87 86 45 44,42 42",  // ?
    "63 65 45 34 43 63 84 86 68 28 06 03 22 62",  // @
    "02 48 82,25 65",  // A
    "02 08 58 77 76 55 05,55 84 83 62 02",  // B
    "87 68 28 07 03 22 62 83",  // C
    "02 08 58 86 84 52 02",  // D
    "82 02 08 88,05 65",  // E
    "02 08 88,05 65",  // F
    "87 68 28 07 03 22 62 83 85 55",  // G
    "02 08,82 88,05 85",  // H
    "42 48,22 62,28 68",  // I
    "88 83 62 22 03",  // J
    "02 08,88 05 82",  // K
    "08 02 82",  // L
    "02 08 44 88 82",  // M
    "02 08 82 88",  // N
    "28 07 03 22 62 83 87 68 28",  // O
    "02 08 68 87 86 65 05",  // P
    "28 07 03 22 62 83 87 68 28,54 82",  // Q
    "02 08 68 87 86 65 05,45 82",  // R
    "87 68 28 07 06 25 65 84 83 62 22 03",  // S
    "08 88,48 42",  // T
    "08 03 22 62 83 88",  // U
    "08 42 88",  // V
    "08 22 46 62 88",  // W
    "08 82,02 88",  // X
    "08 45 88,45 42",  // Y
    "08 88 02 82",  // Z
    "58 38 32 52",  // [
    "08 82",  // backslash
    "38 58 52 32",  // ]
    "26 48 66",  // ^
    "01 81",  // _
    "38 57",  // `
    "16 56 75 72,74 24 03 22 52 73",  // a
    "08 02,05 26 56 75 73 52 22 03",  // b
    "75 56 26 05 03 22 52 73",  // c
    "78 72,75 56 26 05 03 22 52 73",  // d
    "04 74 75 56 26 05 03 22 52 73",  // e
    "68 48 37 32,16 56",  // f
    "76 71 50 20 01,75 56 26 05 03 22 52 73",  // g
    "08 02,05 26 56 75 72",  // h
    "46 42,48 48",  // i
    "46 41 30 10,48 48",  // j
    "08 02,66 04 72",  // k
    "38 33 42 52",  // l
    "06 02,05 16 36 45 42,45 56 76 85 82",  // m
    "06 02,05 26 56 75 72",  // n
    "26 05 03 22 52 73 75 56 26",  // o
    "06 00,05 26 56 75 73 52 22 03",  // p
    "76 70,75 56 26 05 03 22 52 73",  // q
    "16 12,14 36 66",  // r
    "75 56 26 05 24 54 73 52 22 03",  // s
    "38 33 42 62,16 66",  // t
    "06 03 22 52 73,76 72",  // u
    "06 42 86",  // v
    "06 22 45 62 86",  // w
    "06 72,02 76",  // x
    "06 42,86 20 00",  // y
    "06 76 02 72",  // z
    "58 47 46 35 44 43 52",  // {
    "48 42",  // |
    "38 47 46 55 44 43 32",  // }
    "14 25 35 54 64 75",  // ~
};
// clang-format on
constexpr std::string_view kUnknown = "02 08 88 82 02";

constexpr double kBaseLine = 2.0;
constexpr double kCapHeight = 6.0;
constexpr double kAdvance = 10.5;
constexpr double kXScale = 0.64;  // letters are slimmer than their grid
constexpr double kStroke = 0.85;  // width of a stroke, in units of the grid

double distance(Vec2 p, Vec2 a, Vec2 b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double t =
        length2 > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
    const double ex = p.x - (a.x + t * dx);
    const double ey = p.y - (a.y + t * dy);
    return std::sqrt(ex * ex + ey * ey);
}

std::uint8_t mix(std::uint8_t under, std::uint8_t over, double share) {
    return static_cast<std::uint8_t>(std::lround(under + share * (over - under)));
}

bool is_continuation_byte(char c) {
    return (static_cast<std::uint8_t>(c) & 0xC0) == 0x80;
}

std::string_view glyph(char c) {
    const int index = static_cast<std::uint8_t>(c) - ' ';
    const bool is_known = index >= 0 && index < static_cast<int>(kGlyphs.size());
    return is_known ? kGlyphs[static_cast<std::size_t>(index)] : kUnknown;
}

}  // namespace

void draw_stroke(Image& image, Vec2 a, Vec2 b, double width, Rgba8 colour) {
    const double reach = width / 2.0 + 1.0;
    const auto bound = [](double value, std::uint32_t size) {
        return static_cast<std::uint32_t>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    const std::uint32_t left = bound(std::min(a.x, b.x) - reach, image.width);
    const std::uint32_t right = bound(std::max(a.x, b.x) + reach + 1.0, image.width);
    const std::uint32_t top = bound(std::min(a.y, b.y) - reach, image.height);
    const std::uint32_t bottom = bound(std::max(a.y, b.y) + reach + 1.0, image.height);
    for (std::uint32_t y = top; y < bottom; ++y) {
        for (std::uint32_t x = left; x < right; ++x) {
            const double d = distance({x + 0.5, y + 0.5}, a, b);
            const double share = std::clamp(width / 2.0 + 0.5 - d, 0.0, 1.0);
            Rgba8& pixel = image.at(x, y);
            pixel.r = mix(pixel.r, colour.r, share);
            pixel.g = mix(pixel.g, colour.g, share);
            pixel.b = mix(pixel.b, colour.b, share);
        }
    }
}

void draw_text(Image& image, double x, double y, double height, Rgba8 colour,
               std::string_view text) {
    const double unit = height / kCapHeight;
    for (const char c : text) {
        if (is_continuation_byte(c)) continue;
        const std::string_view strokes = glyph(c);
        bool starts = true;
        Vec2 last;
        for (std::size_t i = 0; i + 1 < strokes.size(); i += 3) {
            const Vec2 next{x + kXScale * unit * (strokes[i] - '0'),
                            y - unit * (strokes[i + 1] - '0' - kBaseLine)};
            if (!starts) draw_stroke(image, last, next, kStroke * unit, colour);
            last = next;
            starts = i + 2 < strokes.size() && strokes[i + 2] == ',';
        }
        x += kXScale * unit * kAdvance;
    }
}

double text_width(double height, std::string_view text) {
    const auto letters =
        std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation_byte(c); });
    return kXScale * kAdvance * height / kCapHeight * static_cast<double>(letters);
}

}  // namespace ncsim::exporter
