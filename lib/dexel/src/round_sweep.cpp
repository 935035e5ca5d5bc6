// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round tools on their way: parameters, choice of SIMD lanes, normals.
#include "round_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ncsim::dexel {

namespace {

// Motion of the tool relative to rays along x or y.
struct Side {
    double from, way;  // along the rays
    double other_from, other_way;
    double inverse_other_way;  // 1 / other_way
    double best;  // Ratio of the axis's distance from the ray to the radius at the upper end.
    double upper_end_s;  // s of the upper end, if the tool does not move across the rays.
};

struct RowTask {
    const SweptTool::Numbers& numbers;
    Side side;
    std::size_t axis;
    const double* u;
    std::size_t count;
    double v;
    RowMeeting& row;
};

struct JoinTask {
    const PendingRow& pending;
    std::size_t count;
    const RowMeeting& met;
    double body;
    void (*take)(void*, std::size_t);
    void* context;
};

struct LowerTask {
    const SweptTool::Numbers& numbers;
    const double *x, *y;
    std::size_t rows;
    BlockBound bound;
    double number;
    LowestBlock& lowest;
};

struct BoundTask {
    const SweptTool::Numbers& numbers;
    const BlockExtent* columns;
    std::size_t count;
    BlockExtent band;
    BlockBounds& bounds;
};

}  // namespace

}  // namespace ncsim::dexel

#define NCSIM_DEXEL_INLINED __attribute__((always_inline))

#define NCSIM_DEXEL_LANES by_two
#define NCSIM_DEXEL_WIDTH 2
#include "row_lanes.h"
#undef NCSIM_DEXEL_LANES
#undef NCSIM_DEXEL_WIDTH

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#define NCSIM_DEXEL_LANES by_four
#define NCSIM_DEXEL_WIDTH 4
#include "row_lanes.h"
#undef NCSIM_DEXEL_LANES
#undef NCSIM_DEXEL_WIDTH
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

namespace ncsim::dexel {

namespace {

using Tip = SweptTool::Tip;

Tip tip_of(const cda::RoundSweep& sweep) {
    if (sweep.tip_height <= 0.0) return Tip::Flat;
    if (sweep.is_cone) return Tip::Cone;
    // For a ball, the cylinder must contain the upper half.
    const bool is_ball = sweep.flat_radius <= 0.0 && sweep.height >= 2.0 * sweep.radius;
    return is_ball ? Tip::Ball : Tip::Round;
}

Side side_of(const SweptTool::Numbers& n, std::size_t axis) {
    const std::size_t other = 1 - axis;
    Side side{};
    side.from = n.from[axis], side.way = n.way[axis];
    side.other_from = n.from[other], side.other_way = n.way[other];
    side.upper_end_s = side.way > 0.0 ? 1.0 : 0.0;
    if (side.other_way == 0.0) return side;
    side.inverse_other_way = 1.0 / side.other_way;
    side.best = (side.other_way < 0.0 ? -side.way : side.way) / n.way_across;
    return side;
}

}  // namespace

void RowMeeting::resize(std::size_t count) {
    if (low.size() >= count + kWidest) return;
    for (std::vector<double>* each : {&low, &high, &s_low, &s_high})
        each->resize(count + kWidest);
}

void join_row(const PendingRow& pending, std::size_t count, RowMeeting& met, double body,
              Lanes wide, void (*take)(void*, std::size_t), void* context) {
    constexpr double kNowhere = 1e30;
    std::fill_n(met.low.begin() + static_cast<std::ptrdiff_t>(count), kWidest, kNowhere);
    std::fill_n(met.high.begin() + static_cast<std::ptrdiff_t>(count), kWidest, -kNowhere);
    const JoinTask task{pending, count, met, body, take, context};
#if defined(__x86_64__)
    if (wide == Lanes::Four) return by_four::join_row(task);
#endif
    static_cast<void>(wide);
    by_two::join_row(task);
}

void BlockBounds::resize(std::size_t count) {
    if (least.size() >= count + kWidest) return;
    for (std::vector<double>* each :
         {&least, &middle, &slope_x, &slope_y, &opening, &ahead, &behind, &aside})
        each->resize(count + kWidest);
}

Lanes widest_lanes() {
#if defined(__x86_64__)
    static const bool has_four = __builtin_cpu_supports("avx2");
    return has_four ? Lanes::Four : Lanes::Two;
#else
    return Lanes::Two;
#endif
}

SweptTool::SweptTool(const cda::RoundSweep& sweep, const cda::Lattice& lattice, const Grid& grid)
    : box(sweep.bounds, lattice, grid), origin(sweep.origin), numbers_{}, tip_(tip_of(sweep)) {
    Numbers& n = numbers_;
    n.radius = sweep.radius / lattice.unit_mm;
    n.height = sweep.height / lattice.unit_mm;
    n.flat = sweep.flat_radius / lattice.unit_mm;
    n.tip = sweep.tip_height / lattice.unit_mm;
    if (tip_ == Tip::Cone) n.steepness = n.tip / (n.radius - n.flat);
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        n.from[a] = sweep.from[axis] / lattice.unit_mm;
        n.way[a] = sweep.to[axis] / lattice.unit_mm - n.from[a];
    }
    n.across = n.way[0] * n.way[0] + n.way[1] * n.way[1];
    // Motions shorter than half a unit along an axis count as zero, so that no divisor is tiny.
    const auto is_short = [](double length) { return std::abs(length) < 0.5; };
    if (is_short(n.way[0]) && is_short(n.way[1])) n.way[0] = n.way[1] = n.across = 0.0;
    if (is_short(n.way[2])) n.way[2] = 0.0;
    n.way_across = std::sqrt(n.across);
    n.along_x = 1.0;
    if (n.across > 0.0) {
        n.inverse_across = 1.0 / n.across;
        n.inverse_way_across = 1.0 / n.way_across;
        n.along_x = n.way[0] / n.way_across;
        n.along_y = n.way[1] / n.way_across;
        n.lead = n.way[2] / (n.way_across * std::sqrt(n.across + n.way[2] * n.way[2]));
    }
    if (n.flat == 0.0 && (tip_ == Tip::Ball || tip_ == Tip::Round)) n.opening = 0.5 / n.tip;
    course_ = n.way[2] == 0.0 && n.across > 0.0 ? Course::Level
              : n.across > 0.0                  ? Course::Slope
                                                : Course::Plunge;
}

void SweptTool::intersect_row(std::size_t axis, const double* u, std::size_t count, double v,
                              Lanes wide, RowMeeting& row) const {
    row.resize(count);
    const RowTask task{numbers_, axis == 2 ? Side{} : side_of(numbers_, axis), axis, u, count, v,
                       row};
#if defined(__x86_64__)
    if (wide == Lanes::Four) return by_four::row_of(tip_, course_, task);
#endif
    static_cast<void>(wide);
    by_two::row_of(tip_, course_, task);
}

void SweptTool::lower_block(const double* x, const double* y, std::size_t rows,
                            const BlockBound& bound, double number, Lanes wide,
                            LowestBlock& lowest) const {
    const LowerTask task{numbers_, x, y, rows, bound, number, lowest};
#if defined(__x86_64__)
    if (wide == Lanes::Four) return by_four::lower_block_of(tip_, course_, task);
#endif
    static_cast<void>(wide);
    by_two::lower_block_of(tip_, course_, task);
}

void SweptTool::bound_blocks(const BlockExtent* columns, std::size_t count, const BlockExtent& band,
                             Lanes wide, BlockBounds& bounds) const {
    bounds.resize(count);
    const BoundTask task{numbers_, columns, count, band, bounds};
#if defined(__x86_64__)
    if (wide == Lanes::Four) return by_four::bound_blocks_of(tip_, course_, task);
#endif
    static_cast<void>(wide);
    by_two::bound_blocks_of(tip_, course_, task);
}

bool SweptTool::is_open_above(double top) const {
    return std::min(numbers_.from[2], numbers_.from[2] + numbers_.way[2]) + numbers_.height > top;
}

std::pair<double, double> SweptTool::reach_along_x(double y) const {
    constexpr double kRoom = 1.0;
    const Side side = side_of(numbers_, 0);
    const by_two::V none{};
    const by_two::Ray met =
        by_two::circle(side, none + (side.other_from - y), none + (numbers_.radius + kRoom), none,
                       none + 1.0, none);
    return {met.low[0], met.high[0]};
}

double SweptTool::lowest_at(double y) const {
    const Numbers& n = numbers_;
    const double end = n.from[1] + n.way[1];
    const double aside =
        std::max({std::min(n.from[1], end) - y, y - std::max(n.from[1], end), 0.0});
    const by_two::V square = by_two::V{} + aside * aside;
    const double lowest = std::min(n.from[2], n.from[2] + n.way[2]);
    switch (tip_) {
        case Tip::Flat: break;
        case Tip::Ball: return lowest + by_two::rise_at<Tip::Ball>(n, square)[0];
        case Tip::Round: return lowest + by_two::rise_at<Tip::Round>(n, square)[0];
        case Tip::Cone: return lowest + by_two::rise_at<Tip::Cone>(n, square)[0];
    }
    return lowest;
}

Vec3 SweptTool::normal(std::size_t axis, double u, double v, bool is_high, double at,
                       double s) const {
    const Numbers& n = numbers_;
    if (axis == 2 && !is_high && tip_ == Tip::Ball) {
        const double below = at - (n.from[2] + s * n.way[2]) - n.radius;
        if (below < 0.0)
            return {u - (n.from[0] + s * n.way[0]), v - (n.from[1] + s * n.way[1]), below};
    }
    std::array<double, 3> q{};  // point on the tool, relative to the tip
    q[axis] = at;
    q[(axis + 1) % 3] = u;
    q[(axis + 2) % 3] = v;
    for (std::size_t a = 0; a < 3; ++a)
        q[a] -= n.from[a] + s * n.way[a];
    const bool is_side = axis != 2;
    // During the motion, the swept surface is tangent to the direction of motion and to the circle
    // around the axis. For a level motion the two may be parallel, and the surface is the tool's;
    // for a ball, always.
    constexpr double kLevel = 1e-6;
    const bool is_on_ball = tip_ == Tip::Ball && q[2] < n.tip && (is_side || !is_high);
    if (0.0 < s && s < 1.0 && !is_on_ball && std::abs(n.way[2]) > kLevel * n.way_across) {
        const Vec3 across = cross({n.way[0], n.way[1], n.way[2]}, {-q[1], q[0], 0.0});
        const double along = across[static_cast<int>(axis)];
        if (along != 0.0) return is_high == (along > 0.0) ? across : -1.0 * across;
    }
    if (!is_side && is_high) return {0, 0, 1};
    if (is_side && q[2] >= n.tip) return {q[0], q[1], 0.0};
    const double aside = std::sqrt(q[0] * q[0] + q[1] * q[1]);
    if (tip_ == Tip::Flat || aside <= n.flat) return {0, 0, -1};
    if (tip_ == Tip::Ball) return {q[0], q[1], std::min(q[2] - n.radius, 0.0)};
    if (tip_ == Tip::Cone) return {q[0] / aside, q[1] / aside, -1.0 / n.steepness};
    const double beyond = (aside - n.flat) / aside;
    return {q[0] * beyond, q[1] * beyond, std::min(q[2] - n.tip, 0.0)};
}

}  // namespace ncsim::dexel
