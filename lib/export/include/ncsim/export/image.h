// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture in memory: eight bits a channel, rows from top to bottom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::exporter {

/// Colour of a pixel; `a` is the opacity.
struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;

    constexpr bool operator==(const Rgba8&) const = default;
};

/// A picture in sRGB. Pixel (x, y) is pixels[y * width + x]; (0, 0) is at the top left.
struct Image {
    std::uint32_t width = 0, height = 0;
    std::vector<Rgba8> pixels;

    bool operator==(const Image&) const = default;

    const Rgba8& at(std::uint32_t x, std::uint32_t y) const {
        return pixels[std::size_t{y} * width + x];
    }
    Rgba8& at(std::uint32_t x, std::uint32_t y) { return pixels[std::size_t{y} * width + x]; }
};

}  // namespace ncsim::exporter
