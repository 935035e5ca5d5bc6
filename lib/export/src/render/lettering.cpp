// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stroke font and its drawing.
#include "render/lettering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ncsim::exporter {

// The characters from '!' to '~', a line each: the character, two blanks, and strokes on a grid of
// 8 by 8. Each pair of digits is a point, x to the right, y upwards; commas separate strokes. The
// base line is y = 2; capitals reach up to 8, small letters to 6, and descenders down to 0. A
// stroke from a point to itself is a dot.
extern const std::string_view kFont;

namespace {

// Returns the strokes of the characters of the font.
const std::vector<std::string_view>& font() {
    static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> lines;
        for (std::string_view rest = kFont; !rest.empty();) {
            constexpr std::size_t kHead = 3;
            const std::size_t end = rest.find('\n');
            lines.push_back(rest.substr(kHead, end - kHead));
            rest.remove_prefix(end + 1);
        }
        return lines;
    }();
    return all;
}

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
    if (c == ' ') return {};
    const auto index = static_cast<std::size_t>(static_cast<std::uint8_t>(c) - '!');
    return index < font().size() ? font()[index] : kUnknown;
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
