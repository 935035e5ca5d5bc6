// SPDX-License-Identifier: GPL-3.0-or-later
#include "filtered_polygon.h"

#include <algorithm>
#include <cmath>

namespace ncsim::cda {

namespace {

// Error of a corner computed by one division from planes of 24 bits, coordinates below 2^26: a few
// ulp.
constexpr double kCornerError = 0x1p-24;
// A corner with a larger bound is computed from its planes instead.
constexpr double kLargestError = 1e-2;
// Rounding of n·p − d itself: products below 2^50, |d| below 2^52.
constexpr double kHeightError = 4.0;

// On which side of `cut` the point lies where the planes a, b and c meet; how far, in units of its
// normal.
Side side_of(const FilteredPoint& point, const FilterPlane& a, const FilterPlane& b,
             const FilterPlane& c, const FilterPlane& cut, double& height) {
    height = point.p.x * cut.nx + point.p.y * cut.ny + point.p.z * cut.nz - cut.d;
    const double bound = kHeightError + cut.one_norm * point.error;
    if (height > bound) return Side::Above;
    if (height < -bound) return Side::Below;
    const Side side = classify_exact(*meet(a.exact, b.exact, c.exact), cut.exact);
    if (side == Side::On) height = 0.0;
    return side;
}

// Where the line of `plane` and `line`, on which a and b lie, meets `cut`; heights of both above
// it.
FilteredPoint crossing(const FilterPlane& plane, const FilterPlane& line, const FilterPlane& cut,
                       const FilteredPoint& a, const FilteredPoint& b, double from, double to) {
    const Vec3 along = b.p - a.p;
    const double length = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
    const double error = std::max(a.error, b.error);
    const double bound = kHeightError + cut.one_norm * error;
    const double span = std::abs(from - to);
    FilteredPoint c;
    // How far the crossing may slide along the line, and how far the line may lie off.
    c.error = span > 0.0 ? error + kCornerError + 2.0 * length * bound / span : 1.0;
    if (c.error <= kLargestError) {
        c.p = a.p + (from / (from - to)) * along;
    } else {
        c.p = meet(plane.exact, line.exact, cut.exact)->approx;
        c.error = kCornerError;
    }
    return c;
}

}  // namespace

FilteredSegment::Clipped FilteredSegment::clip(const FilterPlane& cut) {
    double at_tail = 0.0;
    double at_head = 0.0;
    const Side from = side_of(tail, *plane, *line, *tail_cut, cut, at_tail);
    const Side to = side_of(head, *plane, *line, *head_cut, cut, at_head);
    if (from == Side::On && to == Side::On) return Clipped::Inside;
    if (from != Side::Above && to != Side::Above) return Clipped::Whole;
    if (from != Side::Below && to != Side::Below) return Clipped::Nothing;
    const FilteredPoint at = crossing(*plane, *line, cut, tail, head, at_tail, at_head);
    if (from == Side::Above) {
        tail = at;
        tail_cut = &cut;
        return Clipped::Tail;
    }
    head = at;
    head_cut = &cut;
    return Clipped::Head;
}

bool FilteredPolygon::assign_section(const FilterPlane& plane,
                                     const std::array<std::int64_t, 3>& min,
                                     const std::array<std::int64_t, 3>& max,
                                     const std::array<FilterPlane, 6>& walls) {
    plane_ = &plane;
    // Four walls around the axis along which the plane is steepest cut a parallelogram out of it.
    const std::array<double, 3> n{plane.nx, plane.ny, plane.nz};
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(n[i]) > std::abs(n[axis])) axis = i;
    }
    std::size_t u = (axis + 1) % 3;
    std::size_t v = (axis + 2) % 3;
    if (n[axis] < 0) std::swap(u, v);
    edges_.assign({&walls[2 * v], &walls[2 * u + 1], &walls[2 * v + 1], &walls[2 * u]});
    corners_.clear();
    const auto corner = [&](const std::array<std::int64_t, 3>& at_u,
                            const std::array<std::int64_t, 3>& at_v) {
        const double cu = 0.5 * static_cast<double>(at_u[u]);
        const double cv = 0.5 * static_cast<double>(at_v[v]);
        FilteredPoint c;
        c.p[static_cast<int>(u)] = cu;
        c.p[static_cast<int>(v)] = cv;
        c.p[static_cast<int>(axis)] = (plane.d - n[u] * cu - n[v] * cv) / n[axis];
        c.error = kCornerError;
        corners_.push_back(c);
    };
    has_box_ = false;
    corner(min, min);
    corner(max, min);
    corner(max, max);
    corner(min, max);
    return clip(walls[2 * axis + 1]) && clip(walls[2 * axis]);
}

Side FilteredPolygon::side_of(std::size_t corner, const FilterPlane& cut, double& height) const {
    const std::size_t before = (corner + corners_.size() - 1) % corners_.size();
    return cda::side_of(corners_[corner], *plane_, *edges_[before], *edges_[corner], cut, height);
}

void FilteredPolygon::update_box() const {
    Vec3 min = corners_[0].p;
    Vec3 max = min;
    error_ = 0.0;
    for (const FilteredPoint& c : corners_) {
        min = {std::min(min.x, c.p.x), std::min(min.y, c.p.y), std::min(min.z, c.p.z)};
        max = {std::max(max.x, c.p.x), std::max(max.y, c.p.y), std::max(max.z, c.p.z)};
        error_ = std::max(error_, c.error);
    }
    centre_ = 0.5 * (min + max);
    half_ = 0.5 * (max - min);
    has_box_ = true;
}

int FilteredPolygon::classify_corners(const FilterPlane& cut) const {
    const std::size_t n = corners_.size();
    if (!has_box_) update_box();
    const double height = centre_.x * cut.nx + centre_.y * cut.ny + centre_.z * cut.nz - cut.d;
    const double reach = half_.x * std::abs(cut.nx) + half_.y * std::abs(cut.ny) +
                         half_.z * std::abs(cut.nz) + 2.0 * kHeightError +
                         cut.one_norm * (error_ + kCornerError);
    if (height > reach) return -1;
    if (height < -reach) return 1;
    sides_.resize(n);
    heights_.resize(n);
    bool any_below = false;
    bool any_above = false;
    for (std::size_t i = 0; i < n; ++i) {
        sides_[i] = side_of(i, cut, heights_[i]);
        any_below |= sides_[i] == Side::Below;
        any_above |= sides_[i] == Side::Above;
    }
    return !any_below ? -1 : any_above ? 0 : 1;
}

bool FilteredPolygon::clip(const FilterPlane& cut) {
    const int where = classify_corners(cut);
    if (where != 0) return where > 0;
    kept_corners_.clear();
    kept_edges_.clear();
    const std::size_t n = corners_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = after(i);
        const bool enters = sides_[i] == Side::Above && sides_[k] == Side::Below;
        const bool leaves = sides_[i] == Side::Below && sides_[k] == Side::Above;
        if (sides_[i] != Side::Above) {
            kept_corners_.push_back(corners_[i]);
            kept_edges_.push_back(sides_[i] == Side::On && sides_[k] != Side::Below ? &cut
                                                                                    : edges_[i]);
        }
        if (enters || leaves) {
            kept_corners_.push_back(crossing(*plane_, *edges_[i], cut, corners_[i], corners_[k],
                                             heights_[i], heights_[k]));
            kept_edges_.push_back(enters ? edges_[i] : &cut);
        }
    }
    corners_.swap(kept_corners_);
    edges_.swap(kept_edges_);
    has_box_ = false;
    return corners_.size() >= 3;
}

Overlap FilteredPolygon::overlap(std::span<const FilterPlane* const> cuts,
                                 std::vector<const FilterPlane*>& crossing) const {
    crossing.clear();
    for (const FilterPlane* cut : cuts) {
        const int where = classify_corners(*cut);
        if (where < 0) return Overlap::None;
        if (where == 0) crossing.push_back(cut);
    }
    return crossing.empty() ? Overlap::Covered : Overlap::Undecided;
}

FilteredSegment FilteredPolygon::edge(std::size_t i) const {
    const std::size_t n = corners_.size();
    return {plane_,           edges_[i],   edges_[(i + n - 1) % n],
            edges_[after(i)], corners_[i], corners_[after(i)]};
}

FilteredSegment FilteredPolygon::section(const FilterPlane& cut) const {
    // Counter-clockwise, what lies below is left where the section begins.
    classify_corners(cut);
    FilteredSegment segment;
    segment.plane = plane_;
    segment.line = &cut;
    const std::size_t n = corners_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = after(i);
        const Side here = sides_[i];
        const Side next = sides_[k];
        if (here == next || next == Side::On) continue;
        // Past a corner in the plane it goes to one side; that it came from the other is implied.
        const bool on_edge = here != Side::On;
        const FilteredPoint at = on_edge ? crossing(*plane_, *edges_[i], cut, corners_[i],
                                                    corners_[k], heights_[i], heights_[k])
                                         : corners_[i];
        if (next == Side::Above) {
            segment.tail = at;
            segment.tail_cut = edges_[i];
        } else {
            segment.head = at;
            segment.head_cut = edges_[i];
        }
    }
    return segment;
}

}  // namespace ncsim::cda
