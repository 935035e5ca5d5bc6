// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks of rays along z against tools that are open above: a lower bound of each tool's height in
// a block, and the rays that a tool shortens. Included by row_lanes.h, whose names this file uses.

namespace ncsim::dexel {
namespace {
namespace NCSIM_DEXEL_LANES {

// Returns a bit per group of a block: set if the tool may be lower in the group than the remaining
// material.
inline std::uint64_t groups_to_lower(const LowerTask& t) {
    constexpr std::size_t kInRow = kBlock / kWidest;
    const Numbers& n = t.numbers;
    const BlockBound& k = t.bound;
    const double middle_x = 0.5 * (t.x[0] + t.x[kBlock - 1]);
    const double middle_y = 0.5 * (t.y[0] + t.y[t.rows - 1]);
    const double wx = n.along_x, wy = n.along_y;
    const double slope_x = k.slope_x - t.lowest.slope_x, slope_y = k.slope_y - t.lowest.slope_y;
    const double slope = slope_x < 0.0 ? -slope_x : slope_x;
    const double size_x = wx < 0.0 ? -wx : wx, size_y = wy < 0.0 ? -wy : wy;
    std::uint64_t groups = 0;
    for (std::size_t g = 0; g < kInRow; ++g) {
        const double first = t.x[g * kWidest], last = t.x[(g + 1) * kWidest - 1];
        const double x = 0.5 * (first + last) - middle_x, half = 0.5 * (last - first);
        const double in_row = k.middle + slope_x * x - slope * half;
        for (std::size_t row = 0; row < kBlock; row += kWidth) {
            const V y = load(&t.y[row]) - middle_y;
            const V across = most(size_of(x * wy - y * wx - k.aside) - size_y * half, V{});
            const V along = x * wx + y * wy;
            const V beyond = most(most(along - k.ahead, -along - k.behind) - size_x * half, V{});
            const V bound = in_row + slope_y * y + k.opening * (across * across + beyond * beyond);
            const auto may_be = bound <= load(&t.lowest.group_highest[g * kBlock + row]);
            groups |= std::uint64_t{bits_of(may_be)} << (g * kBlock + row);
        }
    }
    return groups;
}

// Along z, where the tool is open upwards: lowers each ray to the lowest tool so far, the first
// among equals. Groups of kWidest rays are processed or skipped as a whole.
template <Tip tip, Course course>
void lower_block_of(const LowerTask& t) {
    std::uint64_t groups = groups_to_lower(t);
    if (groups == 0) return;
    const Numbers numbers = t.numbers;  // local copy, which the stores below cannot modify
    LowestBlock& lowest = t.lowest;
    for (; groups != 0; groups &= groups - 1) {
        const auto group = static_cast<std::size_t>(std::countr_zero(groups));
        const std::size_t row = group % kBlock, first = group / kBlock * kWidest;
        V highest = all(-kNowhere);
        for (std::size_t i = first; i < first + kWidest; i += kWidth) {
            const std::size_t at = row * kBlock + i;
            const Ray ray = along_z<tip, course>(numbers, load(t.x + i), all(t.y[row]));
            const V known = load(&lowest.at[at]), known_number = load(&lowest.number[at]);
            const V low = rounded(ray.low);
            const auto is_lower = (low < known) | ((low == known) & (t.number < known_number));
            const V lower = is_lower ? low : known;
            store(&lowest.at[at], lower);
            store(&lowest.s[at], is_lower ? ray.s_low : load(&lowest.s[at]));
            store(&lowest.number[at], is_lower ? all(t.number) : known_number);
            highest = most(highest, lower - load(&lowest.plane[at]));
        }
        lowest.group_highest[group] = highest_of(highest);
    }
    lowest.last = lowest.last < t.number ? t.number : lowest.last;
    V highest = all(-kNowhere);
    for (std::size_t i = 0; i < LowestBlock::kGroups; i += kWidth)
        highest = most(highest, load(&lowest.group_highest[i]));
    lowest.highest = highest_of(highest);
}

template <Tip tip>
void lower_block_of(Course course, const LowerTask& t) {
    switch (course) {
        case Course::Level: return lower_block_of<tip, Course::Level>(t);
        case Course::Plunge: return lower_block_of<tip, Course::Plunge>(t);
        case Course::Slope: return lower_block_of<tip, Course::Slope>(t);
    }
}

inline void lower_block_of(Tip tip, Course course, const LowerTask& task) {
    switch (tip) {
        case Tip::Flat: return lower_block_of<Tip::Flat>(course, task);
        case Tip::Ball: return lower_block_of<Tip::Ball>(course, task);
        case Tip::Round: return lower_block_of<Tip::Round>(course, task);
        case Tip::Cone: return lower_block_of<Tip::Cone>(course, task);
    }
}

// Computes lower bounds of the tool's height in blocks. The height F(s, p) of the tool above a
// position p, at a share s of the way, is convex in both. So F is nowhere below a tangent plane at
// any position, here the middle of the block, for an s near the best. For a ball of radius R,
// F − |p − c(s)|² / 2R is convex as well, with c(s) on the axis.
template <Tip tip, Course course>
void bound_blocks_of(const BoundTask& t) {
    const Numbers k = t.numbers;  // local copy, which the stores below cannot modify
    const double wx = k.way[0], wy = k.way[1], wz = k.way[2];
    const double lowest = wz < 0.0 ? k.from[2] + wz : k.from[2];
    BlockBounds& bounds = t.bounds;
    for (std::size_t i = 0; i < t.count; i += kWidth) {
        V x{}, half_x{};
        for (std::size_t lane = 0; lane < kWidth; ++lane) {
            const BlockExtent& column = t.columns[i + lane < t.count ? i + lane : t.count - 1];
            x[lane] = column.middle;
            half_x[lane] = column.half;
        }
        const double half_y = t.band.half;
        const V dx = x - k.from[0], dy = all(t.band.middle - k.from[1]);
        V s, ex = dx, ey = dy;
        if constexpr (course == Course::Plunge) {
            s = all(wz < 0.0 ? 1.0 : 0.0);
        } else {
            const V nearest = (dx * wx + dy * wy) * k.inverse_across;
            s = between(nearest, V{}, all(1.0));
            ex = dx - s * wx;
            ey = dy - s * wy;
            if constexpr (course == Course::Slope && tip == Tip::Ball) {
                const V cross = dx * wy - dy * wx;
                const V room = k.radius * k.radius - cross * cross * k.inverse_across;
                s = between(nearest - k.lead * root(room), V{}, all(1.0));
            }
        }
        const V reach = k.radius + 1.0 + root(half_x * half_x + half_y * half_y);
        const auto meets = ex * ex + ey * ey <= reach * reach;
        if constexpr (tip == Tip::Flat) {
            const V level = rounded(all(lowest));
            store(&bounds.least[i], meets ? level : all(BlockBound::kNoLimit));
            store(&bounds.middle[i], level);
            for (std::vector<double>* each : {&bounds.slope_x, &bounds.slope_y, &bounds.opening,
                                              &bounds.ahead, &bounds.behind, &bounds.aside})
                store(&(*each)[i], V{});
            continue;
        }
        if constexpr (course == Course::Slope && tip == Tip::Ball) {
            ex = dx - s * wx;
            ey = dy - s * wy;
        }
        const V aside = root(ex * ex + ey * ey);
        const V by_aside = 1.0 / most(aside, all(1.0));
        // The point of tangency: the steeper the tool at the middle, the closer to the tool's axis.
        constexpr double kUpright = 0.95;
        V touched = aside, rise, slope;
        if constexpr (tip == Tip::Cone) {
            const V beyond = most(aside - k.flat, V{});
            rise = k.steepness * beyond;
            slope = beyond > 0.0 ? all(k.steepness) : V{};
        } else {
            const V pull = (size_of(ex) * half_x + size_of(ey) * half_y) * by_aside;
            touched = least(aside * most(1.0 - pull * (1.0 / k.radius), V{}),
                            all(k.flat + kUpright * k.tip));
            const V beyond = most(touched - k.flat, V{});
            const V upright = root(k.tip * k.tip - beyond * beyond);
            rise = k.tip - upright;
            slope = beyond / upright;
        }
        const V gx = slope * ex * by_aside, gy = slope * ey * by_aside;
        const V change = wz - (gx * wx + gy * wy);  // derivative along s
        const V of_way = least(-s * change, (1.0 - s) * change);
        constexpr double kRounding = 1.0;
        const V middle = k.from[2] + s * wz + rise + slope * (aside - touched) + of_way - kRounding;
        const V plane = middle - size_of(gx) * half_x - size_of(gy) * half_y;
        store(&bounds.least[i],
              meets ? most(plane, all(lowest - kRounding)) : all(BlockBound::kNoLimit));
        store(&bounds.middle[i], middle);
        store(&bounds.slope_x[i], gx);
        store(&bounds.slope_y[i], gy);
        const V inwards = (aside - touched) * by_aside;
        const V along = -inwards * (ex * k.along_x + ey * k.along_y);
        store(&bounds.opening[i], all(k.opening));
        store(&bounds.ahead[i], along + (1.0 - s) * k.way_across);
        store(&bounds.behind[i], s * k.way_across - along);
        store(&bounds.aside[i], -inwards * (ex * k.along_y - ey * k.along_x));
    }
}

template <Tip tip>
void bound_blocks_of(Course course, const BoundTask& t) {
    switch (course) {
        case Course::Level: return bound_blocks_of<tip, Course::Level>(t);
        case Course::Plunge: return bound_blocks_of<tip, Course::Plunge>(t);
        case Course::Slope: return bound_blocks_of<tip, Course::Slope>(t);
    }
}

inline void bound_blocks_of(Tip tip, Course course, const BoundTask& task) {
    switch (tip) {
        case Tip::Flat: return bound_blocks_of<Tip::Flat>(course, task);
        case Tip::Ball: return bound_blocks_of<Tip::Ball>(course, task);
        case Tip::Round: return bound_blocks_of<Tip::Round>(course, task);
        case Tip::Cone: return bound_blocks_of<Tip::Cone>(course, task);
    }
}

#undef NCSIM_DEXEL_INLINE

}  // namespace NCSIM_DEXEL_LANES
}  // namespace
}  // namespace ncsim::dexel
