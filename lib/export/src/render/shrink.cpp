// SPDX-License-Identifier: GPL-3.0-or-later
//
// Averages squares of pixels.
#include "ncsim/export/shrink.h"

#include <array>
#include <cstddef>

namespace ncsim::exporter {

namespace {

Rgba8 mean_of(const Image& image, std::uint32_t left, std::uint32_t top, std::uint32_t side) {
    std::array<std::uint64_t, 4> sums{};
    for (std::uint32_t y = top; y < top + side; ++y) {
        for (std::uint32_t x = left; x < left + side; ++x) {
            const Rgba8& pixel = image.at(x, y);
            sums[0] += pixel.r;
            sums[1] += pixel.g;
            sums[2] += pixel.b;
            sums[3] += pixel.a;
        }
    }
    const std::uint64_t count = std::uint64_t{side} * side;
    const auto mean = [&](std::size_t i) {
        return static_cast<std::uint8_t>((sums[i] + count / 2) / count);
    };
    return {mean(0), mean(1), mean(2), mean(3)};
}

}  // namespace

Image shrink(const Image& image, std::uint32_t factor) {
    Image small{image.width / factor, image.height / factor, {}};
    small.pixels.reserve(std::size_t{small.width} * small.height);
    for (std::uint32_t y = 0; y < small.height; ++y) {
        for (std::uint32_t x = 0; x < small.width; ++x)
            small.pixels.push_back(mean_of(image, x * factor, y * factor, factor));
    }
    return small;
}

}  // namespace ncsim::exporter
