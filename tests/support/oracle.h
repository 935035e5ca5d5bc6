// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simple models of a part for comparison: a grid of unit cubes, and the definition itself.
#pragma once

#include "support/random_shapes.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ncsim::test {

/// Grid of unit cubes that are material or empty (mm). Boxes with integer corners are removed;
/// volume and exposed area are counted, and all coincidences of faces occur.
class UnitCubes {
public:
    static constexpr int kSize = 6;

    UnitCubes() { solid_.fill(true); }

    void remove(const std::array<int, 6>& box) {
        for_each([&](int x, int y, int z, bool& cube) {
            if (box[0] <= x && x < box[3] && box[1] <= y && y < box[4] && box[2] <= z &&
                z < box[5]) {
                cube = false;
            }
        });
    }
    int volume() {
        int n = 0;
        for_each([&](int, int, int, bool& cube) { n += cube ? 1 : 0; });
        return n;
    }
    int area() {
        int n = 0;
        for_each([&](int x, int y, int z, bool& cube) {
            if (!cube) return;
            n += !at(x - 1, y, z) + !at(x + 1, y, z) + !at(x, y - 1, z) + !at(x, y + 1, z) +
                 !at(x, y, z - 1) + !at(x, y, z + 1);
        });
        return n;
    }

private:
    template <class F>
    void for_each(F f) {
        for (int x = 0; x < kSize; ++x) {
            for (int y = 0; y < kSize; ++y) {
                for (int z = 0; z < kSize; ++z)
                    f(x, y, z, solid_[index(x, y, z)]);
            }
        }
    }
    static std::size_t index(int x, int y, int z) {
        return static_cast<std::size_t>((x * kSize + y) * kSize + z);
    }
    bool at(int x, int y, int z) const {
        const auto in = [](int v) { return 0 <= v && v < kSize; };
        return in(x) && in(y) && in(z) && solid_[index(x, y, z)];
    }
    std::array<bool, kSize * kSize * kSize> solid_{};
};

inline std::array<int, 6> random_grid_box(Random& random) {
    std::array<int, 6> box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Corners may lie 1 mm outside the grid, so cuts also reach beyond the stock.
        const auto a = static_cast<int>(random.between(-1, UnitCubes::kSize + 1));
        const auto b = static_cast<int>(random.between(-1, UnitCubes::kSize + 1));
        box[axis] = std::min(a, b);
        box[axis + 3] = std::max(a, b);
    }
    return box;
}

}  // namespace ncsim::test
