// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of a small workpiece with cuts against all known properties of the result, for the fuzzer
// and the nightly run. Throws std::runtime_error with the violated property.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"

#include "support/oracle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::test {

inline void require(bool holds, const char* what) {
    if (!holds) throw std::runtime_error(what);
}

inline void require_equal(const cda::Boundary& a, const cda::Boundary& b) {
    require(a.vertices == b.vertices, "the vertices differ");
    require(a.faces.size() == b.faces.size(), "the number of faces differs");
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
        require(a.faces[i].loops == b.faces[i].loops, "the loops of a face differ");
        require(a.faces[i].origin == b.faces[i].origin, "a face has another origin");
    }
}

/// Returns the boundary of `part` after checking that the surface is closed and encloses the volume
/// of the aggregate.
inline cda::Boundary sound_boundary(const cda::TreeCda& part, double scale) {
    const cda::Boundary boundary = part.boundary();
    require(cda::check(boundary).is_closed(), "the surface is not closed");
    require(std::abs(cda::volume(boundary) - part.volume()) <= 1e-9 * scale,
            "the volume of the surface is not that of the aggregate");
    return boundary;
}

/// Checks that the account kept during the cuts equals the removed volume per origin, within 1e-9
/// of the stock. An origin that removed no material must have no volume.
inline void require_booked(const cda::RemovalByMotion& account, const cda::RemovalByMotion& taken,
                           double stock) {
    double sum = 0.0;
    for (const auto& [origin, expected] : taken) {
        const auto found = account.find(origin);
        const double booked = found == account.end() ? 0.0 : found->second.volume;
        const double off = booked - expected.volume;
        require(std::abs(off) <= 1e-9 * stock, "the account of an origin is wrong");
        sum += off;
    }
    require(std::abs(sum) <= 1e-9 * stock, "the account does not add up");
}

/// Checks boxes on the grid of the unit cubes, in any order and with leaves of any size.
inline void check_boxes(const std::vector<std::array<int, 6>>& boxes, std::uint32_t leaf,
                        bool at_once) {
    constexpr int n = UnitCubes::kSize;
    UnitCubes cubes;
    std::vector<cda::Cell> cells;
    cda::RemovalByMotion taken;
    for (const auto& b : boxes) {
        const cda::Origin origin{static_cast<std::uint32_t>(cells.size() + 1)};
        taken[origin].volume = cubes.volume();
        cubes.remove(b);
        taken[origin].volume -= cubes.volume();
        cells.push_back(ranked(mm_box(b[0], b[1], b[2], b[3], b[4], b[5], origin)));
    }
    cda::TreeCda part(mm_box(0, 0, 0, n, n, n), kLattice, {leaf, 1});
    if (at_once) {
        part.track_removal();
        part.subtract_unmeasured(cells);
        require_booked(part.account(), taken, 1.0);
    } else {
        double left = n * n * n;
        for (const cda::Cell& cell : cells)
            left -= part.subtract(cell);
        require(std::abs(left - cubes.volume()) < 1e-9, "the removed volumes do not add up");
    }
    const cda::Boundary boundary = sound_boundary(part, 1.0);
    require(std::abs(cda::volume(boundary) - cubes.volume()) < 1e-9, "the volume is wrong");
    require(std::abs(cda::area(boundary) - cubes.area()) < 1e-9, "the area is wrong");
}

/// Compares oblique hulls in a cube of 6 mm with the flat aggregate, face for face.
inline void check_hulls(std::vector<cda::Cell> cells, std::uint32_t leaf) {
    std::ranges::transform(cells, cells.begin(), ranked);
    const cda::Cell stock = mm_box(-3, -3, -3, 3, 3, 3);
    cda::TreeCda part(stock, kLattice, {leaf, 1});
    part.track_removal();
    part.subtract_unmeasured(cells);
    cda::FlatCda flat(stock, kLattice);
    for (const cda::Cell& cell : cells)
        flat.subtract(cell);
    require_booked(part.account(), flat.account(), 216.0);
    const cda::Boundary boundary = sound_boundary(part, 216.0);
    require_equal(boundary, flat.boundary());
    require(cda::check(cda::triangulate(boundary)).is_closed(), "the mesh is not closed");
}

}  // namespace ncsim::test
