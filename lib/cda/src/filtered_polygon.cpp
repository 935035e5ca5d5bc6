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

}  // namespace

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
        Corner c;
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
    const Corner& c = corners_[corner];
    height = c.p.x * cut.nx + c.p.y * cut.ny + c.p.z * cut.nz - cut.d;
    const double bound = kHeightError + cut.one_norm * c.error;
    if (height > bound) return Side::Above;
    if (height < -bound) return Side::Below;
    const std::size_t before = (corner + corners_.size() - 1) % corners_.size();
    const auto exact = meet(plane_->exact, edges_[before]->exact, edges_[corner]->exact);
    const Side side = classify_exact(*exact, cut.exact);
    if (side == Side::On) height = 0.0;
    return side;
}

void FilteredPolygon::update_box() const {
    Vec3 min = corners_[0].p;
    Vec3 max = min;
    error_ = 0.0;
    for (const Corner& c : corners_) {
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

FilteredPolygon::Corner FilteredPolygon::crossing_of(std::size_t edge, const FilterPlane& cut,
                                                     double from, double to) const {
    const Corner& a = corners_[edge];
    const Corner& b = corners_[(edge + 1) % corners_.size()];
    const Vec3 along = b.p - a.p;
    const double length = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
    const double error = std::max(a.error, b.error);
    const double bound = kHeightError + cut.one_norm * error;
    const double span = std::abs(from - to);
    Corner c;
    // How far the crossing may slide along the edge, and how far the edge may lie off.
    c.error = span > 0.0 ? error + kCornerError + 2.0 * length * bound / span : 1.0;
    if (c.error <= kLargestError) {
        c.p = a.p + (from / (from - to)) * along;
    } else {
        c.p = meet(plane_->exact, edges_[edge]->exact, cut.exact)->approx;
        c.error = kCornerError;
    }
    return c;
}

// Uses sides_ and heights_.
bool FilteredPolygon::clip_classified(const FilterPlane& cut, bool keep_below,
                                      FilteredPolygon& out) const {
    const std::size_t n = corners_.size();
    const Side inside = keep_below ? Side::Below : Side::Above;
    const Side outside = opposite(inside);
    out.plane_ = plane_;
    out.corners_.clear();
    out.has_box_ = false;
    out.edges_.clear();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = i + 1 == n ? 0 : i + 1;
        const bool enters = sides_[i] == outside && sides_[k] == inside;
        const bool leaves = sides_[i] == inside && sides_[k] == outside;
        if (sides_[i] != outside) {
            out.corners_.push_back(corners_[i]);
            out.edges_.push_back(sides_[i] == Side::On && sides_[k] != inside ? &cut : edges_[i]);
        }
        if (enters || leaves) {
            out.corners_.push_back(crossing_of(i, cut, heights_[i], heights_[k]));
            out.edges_.push_back(enters ? edges_[i] : &cut);
        }
    }
    return out.corners_.size() >= 3;
}

bool FilteredPolygon::clip(const FilterPlane& cut) {
    const int where = classify_corners(cut);
    if (where != 0) return where > 0;
    thread_local FilteredPolygon part;
    clip_classified(cut, true, part);
    corners_.swap(part.corners_);
    edges_.swap(part.edges_);
    has_box_ = false;
    return true;
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

void FilteredPolygon::subtract(std::span<const FilterPlane* const> cuts,
                               std::vector<FilteredPolygon>& rest, std::size_t& count) const {
    thread_local std::vector<const FilterPlane*> crossing;
    const auto append = [&]() -> FilteredPolygon& {
        if (count == rest.size()) rest.emplace_back();
        return rest[count++];
    };
    const auto append_whole = [&] {
        FilteredPolygon& whole = append();
        whole.plane_ = plane_;
        whole.corners_ = corners_;
        whole.edges_ = edges_;
        whole.has_box_ = false;
    };
    switch (overlap(cuts, crossing)) {
        case Overlap::None: append_whole(); return;
        case Overlap::Covered: return;
        case Overlap::Undecided: break;
    }
    const std::size_t before = count;
    thread_local FilteredPolygon inside;
    thread_local FilteredPolygon next;
    inside.plane_ = plane_;
    inside.corners_ = corners_;
    inside.edges_ = edges_;
    inside.has_box_ = false;
    for (const FilterPlane* cut : crossing) {
        const int where = inside.classify_corners(*cut);
        if (where > 0) continue;
        if (where < 0) {  // no area in common
            count = before;
            append_whole();
            return;
        }
        inside.clip_classified(*cut, false, append());
        inside.clip_classified(*cut, true, next);
        std::swap(inside.corners_, next.corners_);
        std::swap(inside.edges_, next.edges_);
        inside.has_box_ = false;
    }
}

ConvexPolygon FilteredPolygon::exact() const {
    ConvexPolygon polygon;
    polygon.plane = plane_->exact;
    const std::size_t n = corners_.size();
    for (std::size_t i = 0; i < n; ++i) {
        polygon.corners.push_back(
            *meet(plane_->exact, edges_[(i + n - 1) % n]->exact, edges_[i]->exact));
        polygon.edges.push_back(edges_[i]->exact);
    }
    return polygon;
}

}  // namespace ncsim::cda
