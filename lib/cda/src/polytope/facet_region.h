// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a facet while others take from it, as an area: convex polygons in its plane, in
// doubles.
#pragma once

#include "ncsim/cda/plane.h"

#include "exact/half_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Areas in square units. Corners are off by a few 2^-52 of the extent of the box, divided by the
/// sine of the angle between the planes that meet there; areas by as much times their outline.
/// Planes that are parallel to the facet are for the caller to decide, exactly.
class FacetRegion {
public:
    struct Point {
        double u = 0, v = 0;
    };
    /// a u + b v <= c
    struct Line {
        double a = 0, b = 0, c = 0;
        double above(const Point& p) const { return a * p.u + b * p.v - c; }
    };
    /// Corners, counter-clockwise or not as the plane has it.
    struct Polygon {
        std::size_t first = 0, count = 0;
    };

    /// The part of `plane` within a box; false if that is nothing.
    bool assign(const Plane& plane, const HalfBox& box);
    /// Keeps what lies below `cut`; false if nothing does.
    bool clip(const Plane& cut);
    /// Might some of it lie below all of `cuts`? Surely not, if one has all of it above.
    bool meets(std::span<const Plane* const> cuts) const;
    /// Takes away what lies below all of `cuts`. How much that is.
    double take(std::span<const Plane* const> cuts);

    double area() const;
    bool is_empty() const { return polygons_.empty(); }

    /// What is left, and what was taken last. Valid until the next facet; a polygon may have no
    /// area.
    std::span<const Polygon> polygons() const { return polygons_; }
    std::span<const Polygon> taken() const { return taken_; }
    std::span<const Point> corners(const Polygon& polygon) const {
        return std::span(points_).subspan(polygon.first, polygon.count);
    }
    /// Where the facet meets a plane, in the coordinates of the corners; above() is what the normal
    /// has of the distance.
    Line line_of(const Plane& cut) const;
    /// How much of `along`, a length times the normal of the facet, is that length times areas in
    /// the coordinates of the corners.
    double flattened(double along) const { return along / std::abs(n_[axes_[2]]); }

private:
    enum class Where : std::uint8_t { Below, Above, Cut };

    static Where where(std::span<const Point> corners, const Line& line);
    Polygon part(const Polygon& polygon, const Line& line, bool above);
    double flat_area(const Polygon& polygon) const;
    double take(Polygon polygon);

    // Coordinates are about the middle of the box, along two axes; the third follows from them.
    std::array<std::size_t, 3> axes_{};
    std::array<double, 3> middle_{}, n_{};
    double e_ = 0;
    double stretch_ = 1;  // of areas
    std::vector<Point> points_;
    std::vector<Polygon> polygons_, rest_, taken_;
    std::vector<Line> lines_;
};

}  // namespace ncsim::cda
