// SPDX-License-Identifier: GPL-3.0-or-later
//
// The facet rule in a leaf. The owner of a facet on coincident planes is decided exactly; corners
// are doubles.
#include "tree/leaf_surface.h"

#include "exact/none.h"

#include <algorithm>

namespace ncsim::cda {

SurfaceRecorder::Hash LeafSurface::read(const BlockTree& tree, const HalfBox& box,
                                        std::span<const Entry> entries) {
    box_ = box;
    stock_.clear();
    planes_.clear();
    cells_.clear();
    SurfaceRecorder::Hash hash{};
    const auto add = [&hash](std::int64_t number) {
        hash = extended(hash, static_cast<std::uint64_t>(number));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        add(box.min[i]);
        add(box.max[i]);
    }
    const BoxFrame frame(box);
    for (const Plane& plane : all_stock_) {
        if (side_of(frame, HalfPlane(plane)) == Side::On) stock_.push_back(plane);
    }
    for (const Entry& entry : entries) {
        cells_.push_back({entry.cell, planes_.size(), entry.planes.size()});
        add(entry.cell);
        for (const std::uint32_t index : entry.planes) {
            planes_.push_back(tree.plane(entry.cell, index, table_));
            const Plane& p = planes_.back();
            for (const std::int64_t c :
                 {std::int64_t{p.nx}, std::int64_t{p.ny}, std::int64_t{p.nz}, p.d})
                add(c);
        }
    }
    return hash;
}

// Removes the part of facet_ that cell `other` removes; `self`: the facet's cell, or kNone for the
// stock. False if nothing is left.
bool LeafSurface::remove(const Plane& plane, std::size_t other, std::size_t self) {
    const bool is_wall = self != kNone;
    const bool takes_same =
        !is_wall || table_.comes_before(cells_[other].number, cells_[self].number);
    if (!cuts_of_facet(plane, planes_of(cells_[other]), takes_same, is_wall, cuts_)) return true;
    facet_.remove(cuts_);
    return !facet_.is_empty();
}

void LeafSurface::add_polygons(const RecordGrid& grid, double unit_mm,
                               SurfaceRecorder::Polygons& polygons) {
    // The cell that covered the previous facet usually covers the next facet, too.
    std::size_t last_cover = 0;
    const auto follow = [&](const Plane& plane, std::size_t self) {
        if (!facet_.clip_to(plane, stock_)) return;
        const bool has_last = last_cover < cells_.size() && last_cover != self;
        if (has_last && !remove(plane, last_cover, self)) return;
        for (std::size_t other = 0; other < cells_.size(); ++other) {
            if (other == self || (has_last && other == last_cover)) continue;
            if (remove(plane, other, self)) continue;
            last_cover = other;
            return;
        }
        const bool is_wall = self != kNone;
        const double sign = is_wall ? -1.0 : 1.0;
        const Vec3 n{static_cast<double>(plane.nx), static_cast<double>(plane.ny),
                     static_cast<double>(plane.nz)};
        for (const FacetRegion::Polygon& polygon : facet_.polygons()) {
            corners_.clear();
            for (const FacetRegion::Point& point : facet_.corners(polygon))
                corners_.push_back(unit_mm * facet_.position_of(point));
            if (facet_.is_counter_clockwise() == is_wall) std::ranges::reverse(corners_);
            polygons.add(grid, (sign / norm(n)) * n,
                         is_wall ? table_.origin(cells_[self].number) : kStockOrigin, corners_);
        }
    };
    for (const Plane& plane : stock_) {
        if (facet_.assign(plane, box_)) follow(plane, kNone);
    }
    for (std::size_t self = 0; self < cells_.size(); ++self) {
        for (const Plane& plane : planes_of(cells_[self])) {
            if (std::ranges::find(stock_, plane) != stock_.end()) continue;
            if (facet_.assign(plane, box_) && facet_.clip_to(plane, planes_of(cells_[self])))
                follow(plane, self);
        }
    }
}

}  // namespace ncsim::cda
