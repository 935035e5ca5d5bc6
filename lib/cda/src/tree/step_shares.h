// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shares of steps in the volume that a cell removed, where one cell represents many steps of a body
// on a straight line.
//
// The body reaches a point x when the last of the body's forward-facing planes passes x: t(x) = max
// over these planes of 1 + (n·x − d) / (n·way), as a share of the way, where d is the distance of
// the plane at the end of the way, as in the cell. On a line along the way, t(x) grows with x. So
// the volume removed until t is a sum over the faces of the whole removed volume: min(t(x), t)
// times the area projected along the way, positive if the way leaves through the face, negative if
// it enters. Faces that the cell leaves at the end of the way have t(x) = 1. Faces parallel to the
// way have no projected area. Faces at the start affect only the first step, which gets the
// remainder.
#pragma once

#include "polytope/facet_region.h"
#include "tree/block_tree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Accumulator of the steps' shares for one cell.
class StepShares {
public:
    /// Requires: a cell with steps.
    explicit StepShares(const IncomingCell& cell);

    /// Adds a facet of the cell that becomes a wall of the part, with area in square units.
    void add_wall(const Plane& plane, double area);
    /// Adds polygons of a facet in `plane` that the cell removes; `sign`: 1 if the facet's normal
    /// points out of the part.
    void add_removed(const Plane& plane, double sign, const FacetRegion& facet,
                     std::span<const FacetRegion::Polygon> polygons);

    Origin origin(std::size_t step) const { return steps_->steps[step].origin; }
    /// Returns the volume of each step, where all steps together removed `whole`; cubic units.
    std::vector<double> of(double whole) const;

private:
    // A forward-facing plane, and the dot product of normal and way.
    struct ForwardPlane {
        const Plane* plane;
        double along;
    };
    using Point = FacetRegion::Point;
    using Line = FacetRegion::Line;

    double along_way(const Plane& plane) const;
    void enqueue(std::span<const Point> polygon);
    void enqueue(std::span<const Point> polygon, const Line& time);
    bool clip(const Line& line, bool above);

    const StraightSteps* steps_;
    std::vector<ForwardPlane> forward_planes_;
    std::vector<double> shares_;  // shares except the first
    // Projected areas, signed, that the body reaches in step i; the last entry is the end of the
    // way. Each step before i gets the area times the step's length.
    std::vector<double> areas_before_;
    // The current facet: weight of the areas, and arrival times of the fronts.
    double weight_ = 0.0;
    std::vector<Line> times_;
    // Current polygon: fronts that may be last, and parts.
    std::vector<Line> last_;
    std::vector<Point> part_, cut_;
};

}  // namespace ncsim::cda
