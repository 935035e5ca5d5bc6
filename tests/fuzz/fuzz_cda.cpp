// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads any bytes as a small scene. If the first byte is even: boxes on a grid, three bytes per
// box, compared with unit cubes. If odd: hulls of six points on a coarse grid, where everything
// coincides, compared with the flat aggregate.
#include "support/scene.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

namespace {

using namespace ncsim;

void boxes(const std::uint8_t* data, std::size_t size, std::uint8_t how) {
    std::vector<std::array<int, 6>> all;
    for (std::size_t i = 0; i + 3 <= size && all.size() < 12; i += 3) {
        std::array<int, 6> box{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int a = data[i + axis] % 9 - 1;
            const int b = data[i + axis] / 9 % 9 - 1;
            box[axis] = std::min(a, b);
            box[axis + 3] = std::max(a, b);
        }
        all.push_back(box);
    }
    test::check_boxes(all, 4U + how % 32U, (how & 0x40U) != 0);
}

void hulls(const std::uint8_t* data, std::size_t size, std::uint8_t how) {
    constexpr std::size_t kPoints = 6;
    std::vector<cda::Cell> cells;
    for (std::size_t i = 0; i + 2 * kPoints <= size && cells.size() < 6; i += 2 * kPoints) {
        std::vector<cda::LatticePoint> points;
        for (std::size_t k = 0; k < kPoints; ++k) {
            // Five bits per coordinate: steps of 0.25 mm from −4 mm on.
            const unsigned bits = data[i + 2 * k] | static_cast<unsigned>(data[i + 2 * k + 1]) << 8;
            const auto at = [&](unsigned shift) {
                return (static_cast<std::int64_t>((bits >> shift) & 31U) - 16) * 25000;
            };
            points.push_back({at(0), at(5), at(10)});
        }
        const cda::Origin origin{static_cast<std::uint32_t>(cells.size() + 1)};
        if (auto cell = cda::convex_hull(points, test::kLattice, origin)) cells.push_back(*cell);
    }
    test::check_hulls(cells, 6U + how % 64U);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        const std::uint8_t how = data[0] >> 1;
        (data[0] & 1U) == 0 ? boxes(data + 1, size - 1, how) : hulls(data + 1, size - 1, how);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        std::abort();
    }
    return 0;
}
