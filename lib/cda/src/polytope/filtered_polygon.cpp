// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clipping of convex polygons in doubles with error bounds; integers decide doubtful cases.
#include "polytope/filtered_polygon.h"

#include "exact/filter_counts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ncsim::cda {

namespace {

// Lanes of a vector that every machine of the target architecture supports.
constexpr std::size_t kLanes = 2;
using Doubles = double __attribute__((vector_size(kLanes * sizeof(double))));

Doubles load(const double* from) {
    Doubles result;
    std::memcpy(&result, from, sizeof result);
    return result;
}

// Error of a corner computed by one division from planes of 24 bits, coordinates below 2^26: a few
// ulp.
constexpr double kCornerError = 0x1p-24;
// A corner with a larger error bound is computed from its planes instead.
constexpr double kLargestError = 1e-2;
// Rounding error of n·p − d, for a plane with |n|₁ = 1. Coordinates are below 2^26, and so is |d|
// of a plane that meets the stock. Three products, two sums and a difference have an error of at
// most 5 · 2^-27.
constexpr double kHeightError = 0x1p-24;

// Returns the largest error of a point's height above a plane, in units of the plane's normal.
double height_error(const FilterPlane& plane, double error) {
    return plane.one_norm * (kHeightError + error);
}

// Returns the side of `cut` on which the meeting point of a, b and c lies. Doubles found the point
// within `most` of `cut`. Successive hulls share many planes, because they share a pose: corners of
// a hull lie in planes of the next.
Side side_exactly(const FilterPlane& a, const FilterPlane& b, const FilterPlane& c,
                  const FilterPlane& cut, double most) {
    count_doubtful(Filter::Corner);
    for (const FilterPlane* plane : {&a, &b, &c}) {
        if (plane->exact == cut.exact) {
            count_touching(Filter::Corner);
            return Side::On;
        }
    }
    const Side side = classify_near(a.exact, b.exact, c.exact, cut.exact, most);
    if (side == Side::On) count_touching(Filter::Corner);
    return side;
}

// The same, in doubles first. `height` receives the height above `cut` in units of the normal.
Side side_of(const FilteredPoint& point, const FilterPlane& a, const FilterPlane& b,
             const FilterPlane& c, const FilterPlane& cut, double& height) {
    count_query(Filter::Corner);
    height = point.p.x * cut.nx + point.p.y * cut.ny + point.p.z * cut.nz - cut.d;
    const double bound = height_error(cut, point.error);
    if (height > bound) return Side::Above;
    if (height < -bound) return Side::Below;
    const Side side = side_exactly(a, b, c, cut, 2.0 * bound);
    if (side == Side::On) height = 0.0;
    return side;
}

// Returns the point where the line of `plane` and `line`, which contains a and b, meets `cut`.
// `from` and `to` are the heights of a and b above `cut`.
FilteredPoint crossing(const FilterPlane& plane, const FilterPlane& line, const FilterPlane& cut,
                       const FilteredPoint& a, const FilteredPoint& b, double from, double to) {
    const Vec3 along = b.p - a.p;
    const double length = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
    const double error = std::max(a.error, b.error);
    const double bound = height_error(cut, error);
    // Lower bound of the difference of the true end points' heights above `cut`.
    const double span = std::abs(from - to) - 2.0 * bound;
    FilteredPoint c;
    // A point between a and b is as close to the true line as a and b. There, the height above
    // `cut` has the error `bound`, so the error of the crossing along the line is at most length ·
    // bound / span.
    c.error = span > 0.0 ? error + kCornerError + length * bound / span : 1.0;
    if (c.error <= kLargestError) {
        c.p = a.p + (from / (from - to)) * along;
    } else {
        c.p = meet(plane.exact, line.exact, cut.exact)->approx;
        c.error = kCornerError;
    }
    return c;
}

// Numbers of corners certainly above and certainly below a plane.
struct CornerCounts {
    std::int64_t above = 0, below = 0;
};

// Requires: `count` is a multiple of kLanes.
CornerCounts heights_above(const FilterPlane& cut, double bound, const double* x, const double* y,
                           const double* z, std::size_t count, double* heights) {
    using Lanes = decltype(Doubles{} > Doubles{});
    Lanes certainly_above{};
    Lanes certainly_below{};
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Doubles height =
            load(x + i) * cut.nx + load(y + i) * cut.ny + load(z + i) * cut.nz - cut.d;
        std::memcpy(heights + i, &height, sizeof height);
        // A true comparison sets all bits of a lane: -1.
        certainly_above -= height > bound;
        certainly_below -= height < -bound;
    }
    return {certainly_above[0] + certainly_above[1], certainly_below[0] + certainly_below[1]};
}

struct RowsOfPlanes {
    const double *nx, *ny, *nz, *d, *one_norm;
};
struct RowsOfPoints {
    const double *x, *y, *z;
};
struct FilterResultRows {
    FilterResult* where;
    double *low, *high;
};

// Largest number of planes per iteration.
constexpr std::size_t kRowsAtOnce = 8;

// Vector types of several lengths. Not templates, because GCC ignores the attribute on dependent
// types.
struct TwoLanes {
    using Numbers = double __attribute__((vector_size(2 * sizeof(double))));
    using Masks = std::int64_t __attribute__((vector_size(2 * sizeof(double))));
};
struct FourLanes {
    using Numbers = double __attribute__((vector_size(4 * sizeof(double))));
    using Masks = std::int64_t __attribute__((vector_size(4 * sizeof(double))));
};

// Loads from any address, without alignment.
template <class Numbers>
[[gnu::always_inline]] inline void load_into(Numbers& to, const double* from) {
    std::memcpy(&to, from, sizeof to);
}

// Processes two vectors of planes at a time. Compiled for several instruction sets with identical
// results, because no fused multiplication is used and lanes are independent.
template <class Lanes>
[[gnu::always_inline]] inline void classify_lanes(const RowsOfPlanes& planes, std::size_t count,
                                                  const RowsOfPoints& points, std::size_t corners,
                                                  double error, const FilterResultRows& results) {
    using Wide = typename Lanes::Numbers;
    using Mask = typename Lanes::Masks;
    constexpr std::size_t kWide = sizeof(Wide) / sizeof(double);
    constexpr std::size_t kVectors = 2;
    static_assert(kVectors * kWide <= kRowsAtOnce);
    constexpr auto kBelow = static_cast<std::int64_t>(FilterResult::Below);
    constexpr auto kAbove = static_cast<std::int64_t>(FilterResult::Above);
    constexpr auto kAcross = static_cast<std::int64_t>(FilterResult::Across);
    for (std::size_t i = 0; i < count; i += kVectors * kWide) {
        Wide nx[kVectors], ny[kVectors], nz[kVectors], d[kVectors];
        Wide low[kVectors], high[kVectors];
#pragma GCC unroll 2
        for (std::size_t v = 0; v < kVectors; ++v) {
            const std::size_t j = i + v * kWide;
            load_into(nx[v], planes.nx + j);
            load_into(ny[v], planes.ny + j);
            load_into(nz[v], planes.nz + j);
            load_into(d[v], planes.d + j);
            low[v] = high[v] =
                points.x[0] * nx[v] + points.y[0] * ny[v] + points.z[0] * nz[v] - d[v];
        }
        for (std::size_t k = 1; k < corners; ++k) {
#pragma GCC unroll 2
            for (std::size_t v = 0; v < kVectors; ++v) {
                const Wide h =
                    points.x[k] * nx[v] + points.y[k] * ny[v] + points.z[k] * nz[v] - d[v];
                low[v] = h < low[v] ? h : low[v];
                high[v] = h > high[v] ? h : high[v];
            }
        }
#pragma GCC unroll 2
        for (std::size_t v = 0; v < kVectors; ++v) {
            const std::size_t j = i + v * kWide;
            Wide bound;
            load_into(bound, planes.one_norm + j);
            bound *= kHeightError + error;
            const Mask where = ((high[v] < -bound) & kBelow) | ((low[v] > bound) & kAbove) |
                               ((high[v] > bound) & (low[v] < -bound) & kAcross);
            std::memcpy(results.where + j, &where, sizeof(Wide));
            std::memcpy(results.low + j, &low[v], sizeof(Wide));
            std::memcpy(results.high + j, &high[v], sizeof(Wide));
        }
    }
}

// Counts filter results; empty except in builds that count.
void count_results([[maybe_unused]] std::span<const FilterResult> results) {
#ifdef NCSIM_COUNT_FILTERS
    count_query(Filter::FilterResult, results.size());
    count_doubtful(Filter::FilterResult,
                   static_cast<std::uint64_t>(std::ranges::count(results, FilterResult::Doubtful)));
#endif
}

using Classifier = void (*)(const RowsOfPlanes&, std::size_t, const RowsOfPoints&, std::size_t,
                            double, const FilterResultRows&);

void classify_in_pairs(const RowsOfPlanes& planes, std::size_t count, const RowsOfPoints& points,
                       std::size_t corners, double error, const FilterResultRows& results) {
    classify_lanes<TwoLanes>(planes, count, points, corners, error, results);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void classify_in_fours(const RowsOfPlanes& planes, std::size_t count,
                                               const RowsOfPoints& points, std::size_t corners,
                                               double error, const FilterResultRows& results) {
    classify_lanes<FourLanes>(planes, count, points, corners, error, results);
}

Classifier fastest_classifier() {
    return __builtin_cpu_supports("avx2") ? classify_in_fours : classify_in_pairs;
}
#else
Classifier fastest_classifier() {
    return classify_in_pairs;
}
#endif

}  // namespace

void PlaneRows::add(const FilterPlane& plane) {
    if (size_ + kRowsAtOnce >= nx_.size()) {
        const std::size_t room = 2 * (size_ + kRowsAtOnce);
        planes_.resize(room);
        for (std::vector<double>* row : {&nx_, &ny_, &nz_, &d_, &one_norm_})
            row->resize(room);
    }
    planes_[size_] = &plane;
    nx_[size_] = plane.nx;
    ny_[size_] = plane.ny;
    nz_[size_] = plane.nz;
    d_[size_] = plane.d;
    one_norm_[size_] = plane.one_norm;
    ++size_;
}

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

void FilteredPolygon::Corners::make_room(std::size_t most) {
    static_assert(kPadding >= kLanes);
    const std::size_t room = 2 * (most + kPadding);
    x.resize(room);
    y.resize(room);
    z.resize(room);
    edge.resize(room);
}

std::size_t FilteredPolygon::Corners::pad() {
    std::size_t padded = size;
    for (; padded % kLanes != 0; ++padded) {
        x[padded] = x[0];
        y[padded] = y[0];
        z[padded] = z[0];
    }
    return padded;
}

bool FilteredPolygon::assign_section(const FilterPlane& plane,
                                     const std::array<std::int64_t, 3>& min,
                                     const std::array<std::int64_t, 3>& max,
                                     const std::array<FilterPlane, 6>& walls) {
    plane_ = &plane;
    // The four walls around the axis along which the plane is steepest cut out a parallelogram.
    const std::array<double, 3> n{plane.nx, plane.ny, plane.nz};
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(n[i]) > std::abs(n[axis])) axis = i;
    }
    std::size_t u = (axis + 1) % 3;
    std::size_t v = (axis + 2) % 3;
    if (n[axis] < 0) std::swap(u, v);
    corners().clear(4);
    error_ = kCornerError;
    const auto corner = [&](const std::array<std::int64_t, 3>& at_u,
                            const std::array<std::int64_t, 3>& at_v, std::size_t wall) {
        const double cu = 0.5 * static_cast<double>(at_u[u]);
        const double cv = 0.5 * static_cast<double>(at_v[v]);
        Vec3 p;
        p[static_cast<int>(u)] = cu;
        p[static_cast<int>(v)] = cv;
        p[static_cast<int>(axis)] = (plane.d - n[u] * cu - n[v] * cv) / n[axis];
        corners().add(p, &walls[wall]);
    };
    corner(min, min, 2 * v);
    corner(max, min, 2 * u + 1);
    corner(max, max, 2 * v + 1);
    corner(min, max, 2 * u);
    padded_ = corners().pad();
    return clip_to_walls(walls[2 * axis], walls[2 * axis + 1]);
}

// The same as two calls of clip(), for four corners between parallel planes. If doubles decide the
// sides of all corners, one pass around the corners suffices.
bool FilteredPolygon::clip_to_walls(const FilterPlane& lower, const FilterPlane& upper) {
    constexpr std::size_t kCorners = 4;
    std::array<double, kCorners> below, above;
    std::array<int, kCorners> where;
    const double bound = height_error(upper, error_);
    int insiders = 0;
    int uppers = 0;
    for (std::size_t i = 0; i < kCorners; ++i) {
        const Vec3 p = corners().at(i);
        below[i] = p.x * lower.nx + p.y * lower.ny + p.z * lower.nz - lower.d;
        above[i] = p.x * upper.nx + p.y * upper.ny + p.z * upper.nz - upper.d;
        if (std::abs(below[i]) <= bound || std::abs(above[i]) <= bound)
            return clip(upper) && clip(lower);
        where[i] = below[i] > 0.0 ? -1 : above[i] > 0.0 ? 1 : 0;
        insiders += where[i] == 0 ? 1 : 0;
        uppers += where[i] > 0 ? 1 : 0;
    }
    count_query(Filter::Corner, 2 * kCorners);
    if (insiders == kCorners) return true;
    if (insiders == 0 && (uppers == 0 || uppers == kCorners)) return false;
    const Corners& from = corners();
    Corners& to = spare_corners();
    to.clear(2 * kCorners);
    double error = error_;
    for (std::size_t i = 0; i < kCorners; ++i) {
        const std::size_t k = (i + 1) % kCorners;
        const auto cross = [&](int side, const FilterPlane* edge) {
            const FilterPlane& cut = side < 0 ? lower : upper;
            const auto& heights = side < 0 ? below : above;
            const FilteredPoint at =
                crossing(*plane_, *from.edge[i], cut, corner(i), corner(k), heights[i], heights[k]);
            error = std::max(error, at.error);
            to.add(at.p, edge);
        };
        if (where[i] == 0) to.add(from, i);
        if (where[i] == where[k]) continue;
        if (where[i] != 0) cross(where[i], from.edge[i]);
        if (where[k] != 0) cross(where[k], where[k] < 0 ? &lower : &upper);
    }
    swap_corners();
    error_ = error;
    padded_ = to.pad();
    return true;
}

int FilteredPolygon::classify_corners(const FilterPlane& cut) {
    count_query(Filter::Corner, size());
    if (heights_.size() < padded_) heights_.resize(2 * padded_);
    const double bound = height_error(cut, error_);
    const CornerCounts found = heights_above(cut, bound, corners().x.data(), corners().y.data(),
                                             corners().z.data(), padded_, heights_.data());
    if (found.below + found.above < static_cast<std::int64_t>(padded_))
        return classify_doubtful(cut, bound);
    if (found.below == 0) return -1;
    if (found.above == 0) return 1;
    sides_.resize(size());
    for (std::size_t i = 0; i < size(); ++i)
        sides_[i] = heights_[i] > 0.0 ? Side::Above : Side::Below;
    return 0;
}

// The same if doubles do not decide for some corners.
int FilteredPolygon::classify_doubtful(const FilterPlane& cut, double bound) {
    sides_.resize(size());
    bool any_below = false;
    bool any_above = false;
    for (std::size_t i = 0; i < size(); ++i) {
        Side& side = sides_[i];
        if (heights_[i] > bound) {
            side = Side::Above;
        } else if (heights_[i] < -bound) {
            side = Side::Below;
        } else {
            side = side_exactly(*plane_, *corners().edge[previous(i)], *corners().edge[i], cut,
                                2.0 * bound);
            if (side == Side::On) heights_[i] = 0.0;
        }
        any_below |= side == Side::Below;
        any_above |= side == Side::Above;
    }
    return !any_below ? -1 : any_above ? 0 : 1;
}

bool FilteredPolygon::clip(const FilterPlane& cut) {
    const int where = classify_corners(cut);
    if (where != 0) return where > 0;
    // Corners above are consecutive: from `first` up to `next`, perhaps across the end.
    const std::size_t n = size();
    std::size_t first = 0;
    while (sides_[first] != Side::Above || sides_[previous(first)] == Side::Above)
        first = after(first);
    std::size_t next = first;
    while (sides_[next] == Side::Above)
        next = after(next);
    const Corners& from = corners();
    Corners& to = spare_corners();
    to.clear(n + 2);
    double error = error_;
    const auto keep = [&](std::size_t begin, std::size_t end) __attribute__((always_inline)) {
        for (std::size_t i = begin; i < end; ++i)
            to.add(from, i);
    };
    const auto cross = [&](std::size_t i, std::size_t k, const FilterPlane* edge)
        __attribute__((always_inline)) {
        const FilteredPoint at =
            crossing(*plane_, *from.edge[i], cut, corner(i), corner(k), heights_[i], heights_[k]);
        error = std::max(error, at.error);
        to.add(at.p, edge);
    };
    // The edge in `cut` begins at the last corner before the corners above, if this corner lies in
    // `cut`.
    const auto leave = [&]() __attribute__((always_inline)) {
        const std::size_t last = previous(first);
        if (sides_[last] == Side::On) {
            to.edge[to.size - 1] = &cut;
        } else {
            cross(last, first, &cut);
        }
    };
    const auto enter = [&]() __attribute__((always_inline)) {
        const std::size_t last = previous(next);
        if (sides_[next] != Side::On) cross(last, next, from.edge[last]);
    };
    if (first < next) {
        keep(0, first);
        if (first > 0) leave();
        enter();
        keep(next, n);
        if (first == 0) leave();
    } else {
        enter();
        keep(next, first);
        leave();
    }
    swap_corners();
    error_ = error;
    if (size() < 3) return false;
    padded_ = to.pad();
    return true;
}

void FilteredPolygon::classify_rows(const PlaneRows& planes, std::size_t begin, std::size_t end,
                                    FilterResults& results) const {
    const std::size_t room = planes.size() + kRowsAtOnce;
    if (results.where.size() < room) {
        results.where.resize(room);
        results.low.resize(room);
        results.high.resize(room);
    }
    const auto from = [&](const std::vector<double>& row) { return row.data() + begin; };
    static const Classifier look_at = fastest_classifier();
    look_at(
        {from(planes.nx_), from(planes.ny_), from(planes.nz_), from(planes.d_),
         from(planes.one_norm_)},
        end - begin, {corners().x.data(), corners().y.data(), corners().z.data()}, size(), error_,
        {results.where.data() + begin, results.low.data() + begin, results.high.data() + begin});
    count_results(std::span(results.where).subspan(begin, end - begin));
}

void FilteredPolygon::assign(const FilteredPolygon& other) {
    plane_ = other.plane_;
    const std::size_t n = other.size();
    corners().clear(n);
    corners().size = n;
    padded_ = other.padded_;
    std::copy_n(other.corners().x.begin(), padded_, corners().x.begin());
    std::copy_n(other.corners().y.begin(), padded_, corners().y.begin());
    std::copy_n(other.corners().z.begin(), padded_, corners().z.begin());
    std::copy_n(other.corners().edge.begin(), n, corners().edge.begin());
    error_ = other.error_;
}

FilteredSegment FilteredPolygon::edge(std::size_t i) const {
    return {plane_,    corners().edge[i], corners().edge[previous(i)], corners().edge[after(i)],
            corner(i), corner(after(i))};
}

}  // namespace ncsim::cda
