// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables of components and loops for all 256 patterns of corners.
#include "cell_components.h"

#include <numeric>
#include <utility>
#include <vector>

namespace ncsim::dexel {

namespace {

bool is_in(std::uint8_t inside, int corner) {
    return (inside >> corner & 1) != 0;
}

// Returns the four corners of a face perpendicular to `axis`, in cyclic order.
std::array<int, 4> corners_of_face(int axis, int side) {
    const int u = 1 << (axis + 1) % 3;
    const int v = 1 << (axis + 2) % 3;
    const int first = side << axis;
    return {first, first + u, first + u + v, first + v};
}

int edge_between(int a, int b) {
    const int low = a < b ? a : b;
    const int along = a ^ b;
    return edge_from(low, along == 1 ? 0 : along == 2 ? 1 : 2);
}

CellComponents find_components(std::uint8_t inside) {
    std::array<int, 12> set{};
    std::iota(set.begin(), set.end(), 0);
    const auto find = [&](int e) {
        while (set[static_cast<std::size_t>(e)] != e)
            e = set[static_cast<std::size_t>(e)];
        return e;
    };
    const auto join = [&](int e, int f) {
        e = find(e);
        f = find(f);
        set[static_cast<std::size_t>(e > f ? e : f)] = e > f ? f : e;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            const auto corners = corners_of_face(axis, side);
            std::array<int, 4> edges{};  // edge from each corner to the next
            std::vector<int> crossed;
            for (std::size_t i = 0; i < 4; ++i) {
                const int next = corners[(i + 1) % 4];
                edges[i] = edge_between(corners[i], next);
                if (is_in(inside, corners[i]) != is_in(inside, next)) crossed.push_back(edges[i]);
            }
            if (crossed.size() == 2) join(crossed[0], crossed[1]);
            if (crossed.size() < 4) continue;
            for (std::size_t i = 0; i < 4; ++i) {
                if (is_in(inside, corners[i])) join(edges[i], edges[(i + 3) % 4]);
            }
        }
    }
    CellComponents result;
    result.of_edge.fill(CellComponents::kNone);
    for (int e = 0; e < 12; ++e) {
        const int a = first_corner(e);
        if (is_in(inside, a) == is_in(inside, a + (1 << e / 4))) continue;
        const int root = find(e);
        auto& number = result.of_edge[static_cast<std::size_t>(e)];
        number = root == e ? result.count++ : result.of_edge[static_cast<std::size_t>(root)];
    }
    return result;
}

std::vector<std::vector<std::uint8_t>> find_loops(std::uint8_t inside) {
    // Finds the next crossed edge for each crossed edge: on each face, the polygon keeps the
    // corners in the material on one side.
    constexpr std::uint8_t kNone = CellComponents::kNone;
    std::array<std::uint8_t, 12> next{};
    next.fill(kNone);
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            auto corners = corners_of_face(axis, side);
            if (side == 0) std::swap(corners[1], corners[3]);
            // A run of corners in the material, in the cyclic order of the face seen from outside.
            for (std::size_t i = 0; i < 4; ++i) {
                if (!is_in(inside, corners[i]) || is_in(inside, corners[(i + 3) % 4])) continue;
                std::size_t last = i;
                while (is_in(inside, corners[(last + 1) % 4]))
                    last = (last + 1) % 4;
                const int begins = edge_between(corners[(i + 3) % 4], corners[i]);
                const int ends = edge_between(corners[last], corners[(last + 1) % 4]);
                next[static_cast<std::size_t>(begins)] = static_cast<std::uint8_t>(ends);
            }
        }
    }
    std::vector<std::vector<std::uint8_t>> loops;
    for (std::uint8_t e = 0; e < 12; ++e) {
        if (next[e] == kNone) continue;
        std::vector<std::uint8_t> loop;
        for (std::uint8_t at = e; next[at] != kNone;) {
            loop.push_back(at);
            const std::uint8_t then = next[at];
            next[at] = kNone;
            at = then;
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace

const std::vector<std::vector<std::uint8_t>>& loops_of(std::uint8_t inside) {
    static const auto all_of = [] {
        std::array<std::vector<std::vector<std::uint8_t>>, 256> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = find_loops(static_cast<std::uint8_t>(i));
        return all;
    }();
    return all_of[inside];
}

int first_corner(int edge) {
    const int axis = edge / 4;
    return (edge & 1) << (axis + 1) % 3 | (edge >> 1 & 1) << (axis + 2) % 3;
}

int edge_from(int corner, int axis) {
    return 4 * axis + (corner >> (axis + 1) % 3 & 1) + 2 * (corner >> (axis + 2) % 3 & 1);
}

const CellComponents& components_of(std::uint8_t inside) {
    static const std::array<CellComponents, 256> all_of = [] {
        std::array<CellComponents, 256> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = find_components(static_cast<std::uint8_t>(i));
        return all;
    }();
    return all_of[inside];
}

}  // namespace ncsim::dexel
