// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons in a plane for the inner loop of the tree: corners are doubles with a bound on
// their error; the planes that make a corner are kept, so that a question the doubles cannot
// answer is put to integers. Same answers as polygon.h, no allocation per cut.
#pragma once

#include "ncsim/cda/polygon.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::cda {

/// Planes are referred to by their address, which must outlive the polygon.
class FilteredPolygon {
public:
    /// The part of `plane` within a box of half units: walls[2·axis] is the lower wall,
    /// walls[2·axis + 1] the upper one. False if it has no area.
    bool assign_section(const Plane& plane, const std::array<std::int64_t, 3>& min,
                        const std::array<std::int64_t, 3>& max, const std::array<Plane, 6>& walls);

    const Plane& plane() const { return *plane_; }

    /// Keeps what lies below `cut`; false, and then undefined, if that has no area.
    bool clip(const Plane& cut);

    /// As overlap() of polygon.h; `crossing` as addresses.
    Overlap overlap(std::span<const Plane* const> cuts, std::vector<const Plane*>& crossing) const;

    /// Appends this less the points below all of `cuts` to `rest` (whole, if it loses no area),
    /// reusing what `rest` holds beyond `count`.
    void subtract(std::span<const Plane* const> cuts, std::vector<FilteredPolygon>& rest,
                  std::size_t& count) const;

    /// With exact corners.
    ConvexPolygon exact() const;

private:
    struct Corner {
        Vec3 p;            // lattice units
        double error = 0;  // of each coordinate
    };
    Side side_of(std::size_t corner, const Plane& cut, double& height) const;
    // 1: all below or on; -1: none below; 0: cut.
    int classify_corners(const Plane& cut) const;
    bool clip_classified(const Plane& cut, bool keep_below, FilteredPolygon& out) const;
    Corner crossing_of(std::size_t edge, const Plane& cut, double from, double to) const;

    const Plane* plane_ = nullptr;
    std::vector<Corner> corners_;
    std::vector<const Plane*> edges_;  // edges_[i]: corners_[i] → corners_[i + 1]
    // Of the last classification.
    mutable std::vector<Side> sides_;
    mutable std::vector<double> heights_;
};

}  // namespace ncsim::cda
