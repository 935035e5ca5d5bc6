// SPDX-License-Identifier: GPL-3.0-or-later
//
// The remaining area of a facet while cells remove parts of the facet: convex polygons in the
// facet's plane, in doubles.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/base/vec3.h"
#include "ncsim/cda/plane.h"

#include "exact/half_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A region of a facet; areas are in square units. The error of a corner is a few 2^-52 of the
/// extent of the box, divided by the sine of the angle between the planes that meet at the corner;
/// the error of an area is the corner error times the length of the outline. Planes parallel to the
/// facet must be decided exactly by the caller.
class FacetRegion {
public:
    using Point = Vec2;
    /// The half-plane a u + b v <= c.
    struct Line {
        double a = 0, b = 0, c = 0;
        double above(const Point& p) const { return a * p.x + b * p.y - c; }
    };
    /// Range of corners, in the orientation of the plane's projection.
    struct Polygon {
        std::size_t first = 0, count = 0;
    };

    /// Sets the region to the part of `plane` within a box; false if the part is empty.
    bool assign(const Plane& plane, const HalfBox& box);
    /// Keeps the part below `cut`; false if the part is empty.
    bool clip(const Plane& cut);
    /// Keeps the part below all of `planes`; false if the part is empty. Planes parallel to
    /// `facet`, the plane of the region, are decided exactly: they keep the whole region or
    /// nothing.
    bool clip_to(const Plane& facet, std::span<const Plane> planes);
    /// False if one cut has the whole region above, so that no part is below all of `cuts`.
    bool meets(std::span<const Plane* const> cuts) const;
    /// Removes the part below all of `cuts` and returns the removed area.
    double remove(std::span<const Plane* const> cuts);

    double area() const;
    bool is_empty() const { return polygons_.empty(); }

    /// Return the remaining polygons and the polygons removed last. Valid until the next facet. A
    /// polygon may have no area.
    std::span<const Polygon> polygons() const { return polygons_; }
    std::span<const Polygon> removed() const { return removed_; }
    std::span<const Point> corners(const Polygon& polygon) const {
        return std::span(points_).subspan(polygon.first, polygon.count);
    }
    /// Returns the position of a corner, lattice units.
    Vec3 position_of(const Point& corner) const;
    /// True if corners() run counter-clockwise seen from the side to which the normal points.
    bool is_counter_clockwise() const { return n_[axes_[2]] > 0.0; }
    /// Returns the line in which the facet meets a plane, in the coordinates of the corners.
    /// Line::above() is the distance from the plane times the length of the plane's normal.
    Line line_of(const Plane& cut) const;
    /// Converts `along`, a length times the length of the facet's normal, into a factor for areas
    /// in the coordinates of the corners.
    double flattened(double along) const { return along / std::abs(n_[axes_[2]]); }

private:
    enum class LinePosition : std::uint8_t { Below, Above, Cut };

    static LinePosition position(std::span<const Point> corners, const Line& line);
    Polygon part(const Polygon& polygon, const Line& line, bool above);
    double flat_area(const Polygon& polygon) const;
    double remove(Polygon polygon);

    // Coordinates are relative to the middle of the box, along two axes; the third coordinate
    // follows.
    std::array<std::size_t, 3> axes_{};
    std::array<double, 3> middle_{}, n_{};
    double e_ = 0;
    double area_ratio_ = 1;  // ratio of true areas to projected areas
    std::vector<Point> points_;
    std::vector<Polygon> polygons_, remaining_, removed_;
    std::vector<Line> lines_;
};

/// Sets `cuts` to the planes of a cell that bound the part that the cell removes from a region of
/// `facet`; false if the part is empty. Parallel planes are decided exactly. `takes_same` and
/// `takes_opposite`: true if the cell owns the facet where it has a facet of the same or the
/// opposite direction in the plane.
bool cuts_of_facet(const Plane& facet, std::span<const Plane> planes, bool takes_same,
                   bool takes_opposite, std::vector<const Plane*>& cuts);

}  // namespace ncsim::cda
