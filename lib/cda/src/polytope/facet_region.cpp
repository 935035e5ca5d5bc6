// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clipping of planar regions in doubles.
#include "polytope/facet_region.h"

#include "ncsim/cda/predicates.h"

#include <algorithm>
#include <cmath>

namespace ncsim::cda {

bool FacetRegion::assign(const Plane& plane, const HalfBox& box) {
    const BoxFrame frame(box);
    n_ = {static_cast<double>(plane.nx), static_cast<double>(plane.ny),
          static_cast<double>(plane.nz)};
    std::size_t w = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(n_[i]) > std::abs(n_[w])) w = i;
    }
    axes_ = {(w + 1) % 3, (w + 2) % 3, w};
    e_ = static_cast<double>(plane.d);
    for (std::size_t i = 0; i < 3; ++i) {
        middle_[i] = 0.5 * frame.centre[i];
        e_ -= n_[i] * middle_[i];
    }
    area_ratio_ = std::sqrt(n_[0] * n_[0] + n_[1] * n_[1] + n_[2] * n_[2]) / std::abs(n_[w]);
    const double u = 0.5 * frame.half[axes_[0]];
    const double v = 0.5 * frame.half[axes_[1]];
    points_.assign({{-u, -v}, {u, -v}, {u, v}, {-u, v}});
    polygons_.assign({{0, 4}});
    // -h <= x_w = (e - n_u u - n_v v) / n_w <= h
    const double h = 0.5 * frame.half[w] * std::abs(n_[w]);
    for (const double sign : {1.0, -1.0}) {
        const Line wall{sign * n_[axes_[0]], sign * n_[axes_[1]], h + sign * e_};
        switch (position(corners(polygons_[0]), wall)) {
            case LinePosition::Below: break;
            case LinePosition::Above: polygons_.clear(); return false;
            case LinePosition::Cut: polygons_[0] = part(polygons_[0], wall, false); break;
        }
    }
    return true;
}

Vec3 FacetRegion::position_of(const Point& corner) const {
    const double along = e_ - n_[axes_[0]] * corner.x - n_[axes_[1]] * corner.y;
    std::array<double, 3> at = middle_;
    at[axes_[0]] += corner.x;
    at[axes_[1]] += corner.y;
    at[axes_[2]] += along / n_[axes_[2]];
    return {at[0], at[1], at[2]};
}

FacetRegion::Line FacetRegion::line_of(const Plane& cut) const {
    const std::array<double, 3> m{static_cast<double>(cut.nx), static_cast<double>(cut.ny),
                                  static_cast<double>(cut.nz)};
    const double along = m[axes_[2]] / n_[axes_[2]];
    double g = static_cast<double>(cut.d);
    for (std::size_t i = 0; i < 3; ++i)
        g -= m[i] * middle_[i];
    return {m[axes_[0]] - along * n_[axes_[0]], m[axes_[1]] - along * n_[axes_[1]], g - along * e_};
}

FacetRegion::LinePosition FacetRegion::position(std::span<const Point> corners, const Line& line) {
    bool any_below = false;
    bool any_above = false;
    for (const Point& p : corners) {
        const double above = line.above(p);
        any_below |= above < 0.0;
        any_above |= above > 0.0;
        if (any_below && any_above) return LinePosition::Cut;
    }
    return any_above ? LinePosition::Above : LinePosition::Below;
}

// Appends the part of a polygon on a side of a line that cuts the polygon.
FacetRegion::Polygon FacetRegion::part(const Polygon& polygon, const Line& line, bool above) {
    const double sign = above ? -1.0 : 1.0;
    Polygon result{points_.size(), 0};
    Point q = points_[polygon.first];
    double at_q = sign * line.above(q);
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Point p = q;
        const double at_p = at_q;
        q = points_[polygon.first + (i + 1 == polygon.count ? 0 : i + 1)];
        at_q = sign * line.above(q);
        if (at_p <= 0.0) points_.push_back(p);
        if ((at_p < 0.0 && at_q > 0.0) || (at_p > 0.0 && at_q < 0.0)) {
            const double t = at_p / (at_p - at_q);
            points_.push_back(p + t * (q - p));
        }
    }
    result.count = points_.size() - result.first;
    return result;
}

bool FacetRegion::clip(const Plane& cut) {
    const Line line = line_of(cut);
    std::size_t kept = 0;
    for (const Polygon& polygon : polygons_) {
        switch (position(corners(polygon), line)) {
            case LinePosition::Below: polygons_[kept++] = polygon; break;
            case LinePosition::Above: break;
            case LinePosition::Cut: polygons_[kept++] = part(polygon, line, false); break;
        }
    }
    polygons_.resize(kept);
    return kept > 0;
}

bool FacetRegion::meets(std::span<const Plane* const> cuts) const {
    return std::ranges::all_of(cuts, [this](const Plane* cut) {
        const Line line = line_of(*cut);
        return std::ranges::any_of(polygons_, [&](const Polygon& polygon) {
            return position(corners(polygon), line) != LinePosition::Above;
        });
    });
}

double FacetRegion::remove(std::span<const Plane* const> cuts) {
    lines_.clear();
    for (const Plane* cut : cuts)
        lines_.push_back(line_of(*cut));
    remaining_.clear();
    removed_.clear();
    double sum = 0.0;
    for (const Polygon& polygon : polygons_)
        sum += remove(polygon);
    polygons_.swap(remaining_);
    return area_ratio_ * sum;
}

// Removes a single polygon's part below all lines; the remainder goes to remaining_.
double FacetRegion::remove(Polygon polygon) {
    const std::size_t before = remaining_.size();
    const Polygon whole = polygon;
    for (const Line& line : lines_) {
        if (position(corners(whole), line) == LinePosition::Above) {
            remaining_.push_back(whole);
            return 0.0;
        }
    }
    for (const Line& line : lines_) {
        switch (position(corners(polygon), line)) {
            case LinePosition::Below: break;
            case LinePosition::Above:
                // Nothing is removed; the pieces are replaced by the whole polygon.
                remaining_.resize(before);
                remaining_.push_back(whole);
                return 0.0;
            case LinePosition::Cut:
                remaining_.push_back(part(polygon, line, true));
                polygon = part(polygon, line, false);
                break;
        }
    }
    removed_.push_back(polygon);
    return flat_area(polygon);
}

double FacetRegion::flat_area(const Polygon& polygon) const {
    const std::span<const Point> p = corners(polygon);
    double doubled = 0.0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        doubled += cross(p[i] - p[0], p[i + 1] - p[0]);
    }
    return 0.5 * std::abs(doubled);
}

double FacetRegion::area() const {
    double sum = 0.0;
    for (const Polygon& polygon : polygons_)
        sum += flat_area(polygon);
    return area_ratio_ * sum;
}

bool FacetRegion::clip_to(const Plane& facet, std::span<const Plane> planes) {
    return std::ranges::all_of(planes, [&](const Plane& cut) {
        if (!cut.is_parallel_to(facet)) return clip(cut);
        const bool same = same_direction(facet, cut);
        const int beyond = distance_beyond(facet, cut, same);
        return beyond > 0 || (beyond == 0 && same);
    });
}

bool cuts_of_facet(const Plane& facet, std::span<const Plane> planes, bool takes_same,
                   bool takes_opposite, std::vector<const Plane*>& cuts) {
    bool has_same = false;
    bool has_opposite = false;
    cuts.clear();
    for (const Plane& cut : planes) {
        if (!cut.is_parallel_to(facet)) {
            cuts.push_back(&cut);
            continue;
        }
        const bool same = same_direction(facet, cut);
        const int beyond = distance_beyond(facet, cut, same);
        if (beyond < 0 || (beyond == 0 && !(same ? takes_same : takes_opposite))) return false;
        if (beyond == 0) (same ? has_same : has_opposite) = true;
    }
    return !(has_same && has_opposite);  // two opposite planes: the cell is flat
}

}  // namespace ncsim::cda
