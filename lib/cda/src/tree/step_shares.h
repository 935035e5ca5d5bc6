// SPDX-License-Identifier: GPL-3.0-or-later
//
// One cell stands for many steps of a body that went straight on: whose share is what of the volume
// that the cell took?
//
// The body is at a place x when the last of its planes that face forward has passed it: at t(x) =
// max over these planes of 1 + (n·x − d) / (n·way), as a share of the way; d is the distance of the
// plane at the end of the way, as the cell has it. On a line along the way t(x) grows as the place
// does. So what was taken until t is a sum over the faces of all that was taken: min(t(x), t) times
// the area as seen along the way, positive where the way leaves through the face, negative where it
// enters. Faces that the cell itself leaves at the end of the way have t(x) = 1, those beside the
// way show no area, and those at its start concern the first step alone, which has the rest.
#pragma once

#include "polytope/facet_region.h"
#include "tree/block_tree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ncsim::cda {

class StepShares {
public:
    /// Of a cell that has steps.
    explicit StepShares(const IncomingCell& cell);

    /// A facet of the cell begins to be a wall of the part, with some area (square units).
    void is_born(const Plane& plane, double area);
    /// The cell takes polygons of a facet in `plane`; `sign`: 1 where it faces out of the part.
    void takes(const Plane& plane, double sign, const FacetRegion& facet,
               std::span<const FacetRegion::Polygon> polygons);

    Origin origin(std::size_t step) const { return steps_->steps[step].origin; }
    /// Of each step, where all of them took `whole`; cubic units.
    std::vector<double> of(double whole) const;

private:
    // A plane that faces forward, and its normal times the way.
    struct Front {
        const Plane* plane;
        double along;
    };
    using Point = FacetRegion::Point;
    using Line = FacetRegion::Line;

    double along_way(const Plane& plane) const;
    void take_in(std::span<const Point> polygon);
    void take_in(std::span<const Point> polygon, const Line& time);
    bool keep(const Line& line, bool above);

    const StraightSteps* steps_;
    std::vector<Front> fronts_;
    std::vector<double> shares_;  // but for the first
    // For the whole way, what those before step i have each for its length.
    std::vector<double> before_;
    // The facet at hand: what its areas count, and when fronts are there.
    double weight_ = 0.0;
    std::vector<Line> times_;
    // A polygon of it: fronts that may be the last, and parts.
    std::vector<Line> last_;
    std::vector<Point> part_, cut_;
};

}  // namespace ncsim::cda
