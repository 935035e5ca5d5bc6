// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons in a plane for the inner loop of the tree: corners are doubles with a bound on
// their error; the planes that make a corner are kept, so that a question the doubles cannot
// answer is put to integers. Same answers as polygon.h, no allocation per cut.
#pragma once

#include "ncsim/cda/polygon.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::cda {

/// A plane with its coefficients as doubles (exact: they have 24 and 52 bits at most).
struct FilterPlane {
    FilterPlane() = default;
    explicit FilterPlane(const Plane& p)
        : nx(p.nx), ny(p.ny), nz(p.nz), d(static_cast<double>(p.d)), exact(p) {
        one_norm = std::abs(nx) + std::abs(ny) + std::abs(nz);
    }
    double nx = 0, ny = 0, nz = 0, d = 0;
    double one_norm = 0;  ///< |nx| + |ny| + |nz|
    Plane exact;
};

/// Planes are referred to by their address, which must outlive the polygon.
class FilteredPolygon {
public:
    /// The part of `plane` within a box of half units: walls[2·axis] is the lower wall,
    /// walls[2·axis + 1] the upper one. False if it has no area.
    bool assign_section(const FilterPlane& plane, const std::array<std::int64_t, 3>& min,
                        const std::array<std::int64_t, 3>& max,
                        const std::array<FilterPlane, 6>& walls);

    const Plane& plane() const { return plane_->exact; }

    /// Keeps what lies below `cut`; false, and then undefined, if that has no area.
    bool clip(const FilterPlane& cut);

    /// As overlap() of polygon.h; `crossing` as addresses.
    Overlap overlap(std::span<const FilterPlane* const> cuts,
                    std::vector<const FilterPlane*>& crossing) const;

    /// Appends this less the points below all of `cuts` to `rest` (whole, if it loses no area),
    /// reusing what `rest` holds beyond `count`.
    void subtract(std::span<const FilterPlane* const> cuts, std::vector<FilteredPolygon>& rest,
                  std::size_t& count) const;

    /// With exact corners.
    ConvexPolygon exact() const;

private:
    struct Corner {
        Vec3 p;            // lattice units
        double error = 0;  // of each coordinate
    };
    void update_box() const;
    Side side_of(std::size_t corner, const FilterPlane& cut, double& height) const;
    // 1: all below or on; -1: none below; 0: cut.
    int classify_corners(const FilterPlane& cut) const;
    bool clip_classified(const FilterPlane& cut, bool keep_below, FilteredPolygon& out) const;
    Corner crossing_of(std::size_t edge, const FilterPlane& cut, double from, double to) const;

    const FilterPlane* plane_ = nullptr;
    std::vector<Corner> corners_;
    std::vector<const FilterPlane*> edges_;  // edges_[i]: corners_[i] → corners_[i + 1]
    // The box of the corners, by centre and half size: most planes pass it by.
    mutable Vec3 centre_;
    mutable Vec3 half_;
    mutable double error_ = 0.0;  // largest of the corners
    mutable bool has_box_ = false;
    // Of the last classification.
    mutable std::vector<Side> sides_;
    mutable std::vector<double> heights_;
};

}  // namespace ncsim::cda
