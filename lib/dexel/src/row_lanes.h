// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIMD code for several rays against a moving tool, without branches that depend on a ray. The file
// is included once per vector length, each time into a separate namespace. The results are
// bit-identical, because there is no fused multiplication and no sum across rays.
//
// NCSIM_DEXEL_LANES: the namespace; NCSIM_DEXEL_WIDTH: the number of rays.

namespace ncsim::dexel {
namespace {
namespace NCSIM_DEXEL_LANES {

using Tip = SweptTool::Tip;
using Course = SweptTool::Course;
using Numbers = SweptTool::Numbers;

constexpr std::size_t kWidth = NCSIM_DEXEL_WIDTH;
using V [[gnu::vector_size(8 * kWidth)]] = double;

constexpr double kNowhere = 1e30;
// Steps of a bisection on the way: the optimum is flat, or is needed to this number of bits.
constexpr int kHalvings = 26;

#define NCSIM_DEXEL_INLINE [[gnu::always_inline]] inline

// Returns the result of a bisection: exactly an end of the interval if every step went towards this
// end.
NCSIM_DEXEL_INLINE V end_of(V low, V high, V first, V last) {
    const V middle = 0.5 * (low + high);
    return low == first ? first : high == last ? last : middle;
}

/// Intervals of kWidth rays, as in RowMeeting.
struct Ray {
    V low, high, s_low, s_high;
};

NCSIM_DEXEL_INLINE V all(double x) {
    return V{} + x;
}
// Returns a < b ? a : b, and a > b ? a : b: the second of equals.
NCSIM_DEXEL_INLINE V least(V a, V b) {
#if defined(__x86_64__) && NCSIM_DEXEL_WIDTH == 2
    return reinterpret_cast<V>(
        _mm_min_pd(reinterpret_cast<__m128d>(a), reinterpret_cast<__m128d>(b)));
#elif defined(__x86_64__)
    return reinterpret_cast<V>(
        _mm256_min_pd(reinterpret_cast<__m256d>(a), reinterpret_cast<__m256d>(b)));
#else
    return a < b ? a : b;
#endif
}
NCSIM_DEXEL_INLINE V most(V a, V b) {
#if defined(__x86_64__) && NCSIM_DEXEL_WIDTH == 2
    return reinterpret_cast<V>(
        _mm_max_pd(reinterpret_cast<__m128d>(a), reinterpret_cast<__m128d>(b)));
#elif defined(__x86_64__)
    return reinterpret_cast<V>(
        _mm256_max_pd(reinterpret_cast<__m256d>(a), reinterpret_cast<__m256d>(b)));
#else
    return a > b ? a : b;
#endif
}
NCSIM_DEXEL_INLINE V between(V x, V low, V high) {
    return least(most(x, low), high);
}
NCSIM_DEXEL_INLINE V size_of(V x) {
    return most(x, -x);
}
using Is [[gnu::vector_size(8 * kWidth)]] = std::int64_t;
NCSIM_DEXEL_INLINE std::uint32_t bits_of(Is is) {
#if defined(__x86_64__) && NCSIM_DEXEL_WIDTH == 2
    return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(is)));
#elif defined(__x86_64__)
    return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(is)));
#else
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < kWidth; ++i)
        bits |= static_cast<std::uint32_t>(is[i] != 0) << i;
    return bits;
#endif
}
// Returns the square root; 0 for negative values.
NCSIM_DEXEL_INLINE V root(V x) {
    x = most(x, V{});
#if defined(__x86_64__) && NCSIM_DEXEL_WIDTH == 2
    return reinterpret_cast<V>(_mm_sqrt_pd(reinterpret_cast<__m128d>(x)));
#elif defined(__x86_64__)
    return reinterpret_cast<V>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(x)));
#else
    for (std::size_t i = 0; i < kWidth; ++i)
        x[i] = __builtin_sqrt(x[i]);
    return x;
#endif
}

// Rounds to an integer. Requires: |x| < 2^51.
NCSIM_DEXEL_INLINE V rounded(V x) {
    constexpr double kShift = 6755399441055744.0;  // 1.5 * 2^52
    return (x + kShift) - kShift;
}

// Returns the height above the tip at a squared distance from the axis.
template <Tip tip>
NCSIM_DEXEL_INLINE V rise_at(const Numbers& k, V square) {
    if constexpr (tip == Tip::Flat) return V{};
    if constexpr (tip == Tip::Ball) return k.radius - root(k.radius * k.radius - square);
    const V beyond = most(root(square) - k.flat, V{});
    if constexpr (tip == Tip::Cone) return least(k.steepness * beyond, all(k.tip));
    return k.tip - root(k.tip * k.tip - beyond * beyond);
}

// Returns the radius at a height above the tip, from 0 to the tool's height.
template <Tip tip>
NCSIM_DEXEL_INLINE V radius_at(const Numbers& k, V height) {
    if constexpr (tip == Tip::Flat) return all(k.radius);
    if constexpr (tip == Tip::Cone)
        return least(k.flat + height * ((k.radius - k.flat) / k.tip), all(k.radius));
    const V below = most(k.tip - height, V{});
    return k.flat + root(k.tip * k.tip - below * below);
}

// Returns the intersection with rays along z at (x, y).
template <Tip tip, Course course>
NCSIM_DEXEL_INLINE Ray along_z(const Numbers& k, V x, V y) {
    const V dx = k.from[0] - x, dy = k.from[1] - y;
    const double wx = k.way[0], wy = k.way[1], wz = k.way[2];
    const double square = k.radius * k.radius;
    V first = V{}, last = all(1.0);  // range of s in which the ray is in the cylinder
    V s, room, nearest;
    if constexpr (course == Course::Plunge) {
        room = square - (dx * dx + dy * dy);
    } else {
        const V cross = dx * wy - dy * wx;
        nearest = -(dx * wx + dy * wy) * k.inverse_across;
        room = square - cross * cross * k.inverse_across;
        const V half = root(room) * k.inverse_way_across;
        first = most(V{}, nearest - half);
        last = least(all(1.0), nearest + half);
    }
    const auto meets = (room >= 0.0) & (first <= last);
    const V lower_end = k.way[2] < 0.0 ? last : first;
    if constexpr (course == Course::Level) {
        s = between(nearest, V{}, all(1.0));
    } else if constexpr (course == Course::Plunge || tip == Tip::Flat) {
        s = lower_end;
    } else if constexpr (tip == Tip::Ball) {
        s = between(nearest - k.lead * root(room), first, last);
    } else {
        // Distance from the nearest point along the way, and distance from the axis there. The
        // tool's lower end is level within the disc.
        const V aside = square - room;
        const V of_disc = root(k.flat * k.flat - aside);
        const double slope = (wz < 0.0 ? -wz : wz) / k.way_across;
        V offset;
        if constexpr (tip == Tip::Cone) {
            const double steeper = k.steepness * k.steepness - slope * slope;
            const V of_cone = root(aside) * (slope / std::sqrt(steeper));
            offset = steeper > 0.0 ? most(of_disc, of_cone) : all(kNowhere);
        } else {
            V low = of_disc, high = root(room);
            for (int i = 0; i < kHalvings; ++i) {
                const V middle = 0.5 * (low + high);
                const V away = root(middle * middle + aside);
                const V beyond = most(away - k.flat, V{});
                const auto is_steep =
                    beyond * middle > slope * away * root(k.tip * k.tip - beyond * beyond);
                high = is_steep ? middle : high;
                low = is_steep ? low : middle;
            }
            offset = 0.5 * (low + high);
        }
        offset *= 1.0 / k.way_across;
        s = between(k.way[2] < 0.0 ? nearest + offset : nearest - offset, first, last);
    }
    const V ex = dx + s * wx, ey = dy + s * wy;
    Ray ray;
    ray.s_low = s;
    ray.s_high = k.way[2] < 0.0 ? first : last;
    const V low = k.from[2] + s * wz + rise_at<tip>(k, ex * ex + ey * ey);
    const V high = k.from[2] + k.height + ray.s_high * wz;
    ray.low = meets ? low : all(kNowhere);
    ray.high = meets ? high : all(-kNowhere);
    return ray;
}

// Returns the intersection with a circle of this radius while s is in [first, last].
NCSIM_DEXEL_INLINE Ray circle(const Side& k, V w, V radius, V first, V last, V margin) {
    Ray ray;
    const V aim = radius * k.best;
    const V up = k.other_way != 0.0 ? (aim - w) * k.inverse_other_way : all(k.upper_end_s);
    const V down = k.other_way != 0.0 ? (-aim - w) * k.inverse_other_way : all(1.0 - k.upper_end_s);
    ray.s_high = between(up, first, last);
    ray.s_low = between(down, first, last);
    const V at_high = w + ray.s_high * k.other_way, at_low = w + ray.s_low * k.other_way;
    const V square = radius * radius;
    const V of_high = square - at_high * at_high, of_low = square - at_low * at_low;
    const auto is_met = (margin >= 0.0) & (first <= last) & (of_high >= 0.0) & (of_low >= 0.0);
    const V high = k.from + ray.s_high * k.way + root(of_high);
    const V low = k.from + ray.s_low * k.way - root(of_low);
    ray.high = is_met ? high : all(-kNowhere);
    ray.low = is_met ? low : all(kNowhere);
    return ray;
}

NCSIM_DEXEL_INLINE Ray joined(const Ray& a, const Ray& b) {
    Ray ray;
    ray.low = least(a.low, b.low);
    ray.s_low = a.low <= b.low ? a.s_low : b.s_low;
    ray.high = most(a.high, b.high);
    ray.s_high = a.high >= b.high ? a.s_high : b.s_high;
    return ray;
}

// Returns the intersection with the whole ball. Requires: the way has a component across the ray.
NCSIM_DEXEL_INLINE Ray ball(const Numbers& n, const Side& k, V w, V below) {
    // (w, below): vector from the ray to the centre. (other_way, wz): the way across the ray.
    const double wz = n.way[2];
    const double across = k.other_way * k.other_way + wz * wz;
    const double inverse_across = 1.0 / across;
    const double square = n.radius * n.radius;
    const V cross = w * wz - below * k.other_way;
    const V nearest = -(w * k.other_way + below * wz) * inverse_across;
    const V room = square - cross * cross * inverse_across;
    const V offset = k.way * root(room * (inverse_across / (across + k.way * k.way)));
    Ray ray;
    ray.s_low = between(nearest - offset, V{}, all(1.0));
    ray.s_high = between(nearest + offset, V{}, all(1.0));
    const V wl = w + ray.s_low * k.other_way, bl = below + ray.s_low * wz;
    const V wh = w + ray.s_high * k.other_way, bh = below + ray.s_high * wz;
    const V of_low = square - (wl * wl + bl * bl), of_high = square - (wh * wh + bh * bh);
    const auto meets = (room >= 0.0) & (of_low >= 0.0) & (of_high >= 0.0);
    const V low = k.from + ray.s_low * k.way - root(of_low);
    const V high = k.from + ray.s_high * k.way + root(of_high);
    ray.low = meets ? low : all(kNowhere);
    ray.high = meets ? high : all(-kNowhere);
    return ray;
}

// Returns the intersection with circles of increasing radius: a cone or a rounded end on a slope.
template <Tip tip>
NCSIM_DEXEL_INLINE Ray circles(const Numbers& n, const Side& k, V w, V above) {
    // `above`: height of the ray above the tip at s = 0. Range of s in which the ray is at the
    // tip's height:
    const double wz = n.way[2];
    const double by_fall = 1.0 / wz;
    const V one = above * by_fall, two = (above - n.tip) * by_fall;
    const V first = most(V{}, least(one, two)), last = least(all(1.0), most(one, two));
    const double of_cone = (n.radius - n.flat) / n.tip;
    // The derivative of the radius by height is of_cone, or below / q.
    const auto at = [&](V s, V& radius, V& aside, V& below, V& q) NCSIM_DEXEL_INLINED {
        const V height = between(above - s * wz, V{}, all(n.tip));
        aside = w + s * k.other_way;
        if constexpr (tip == Tip::Cone) {
            radius = n.flat + height * of_cone;
            below = all(of_cone);
            q = all(1.0);
        } else {
            below = n.tip - height;
            q = root(n.tip * n.tip - below * below);
            radius = n.flat + q;
        }
    };
    V radius, aside, below, q;
    // s at which the ray is deepest in the circle.
    V low = first, high = last;
    for (int i = 0; i < kHalvings; ++i) {
        const V s = 0.5 * (low + high);
        at(s, radius, aside, below, q);
        const V outward = aside < 0.0 ? all(-k.other_way) : all(k.other_way);
        const auto is_better = -wz * below > outward * q;
        low = is_better ? s : low;
        high = is_better ? high : s;
    }
    const V deepest = end_of(low, high, first, last);
    at(deepest, radius, aside, below, q);
    const auto meets = (first <= last) & (radius >= size_of(aside));
    // Finds s at which the circle reaches farthest along the ray.
    const auto farthest = [&](double sign, V& s_best) NCSIM_DEXEL_INLINED {
        V from = first, to = last;
        for (int i = 0; i < kHalvings; ++i) {
            const V s = 0.5 * (from + to);
            at(s, radius, aside, below, q);
            const V square = radius * radius - aside * aside;
            const V change =
                sign * k.way * root(square) * q - wz * radius * below - k.other_way * aside * q;
            const auto is_inside = square >= 0.0;
            const auto is_ahead = (is_inside & (change > 0.0)) | (~is_inside & (s < deepest));
            from = is_ahead ? s : from;
            to = is_ahead ? to : s;
        }
        s_best = end_of(from, to, first, last);
        at(s_best, radius, aside, below, q);
        return k.from + s_best * k.way + sign * root(radius * radius - aside * aside);
    };
    Ray ray;
    const V reaches = farthest(1.0, ray.s_high), begins = farthest(-1.0, ray.s_low);
    ray.high = meets ? reaches : all(-kNowhere);
    ray.low = meets ? begins : all(kNowhere);
    return ray;
}

// Returns the intersection with rays perpendicular to z; `o` is the coordinate along the second
// level axis.
template <Tip tip, Course course>
NCSIM_DEXEL_INLINE Ray across_z(const Numbers& n, const Side& k, V o, V z) {
    const V w = k.other_from - o;
    const double wz = n.way[2];
    const V above = z - n.from[2];  // height above the tip at s = 0
    if constexpr (course == Course::Level) {
        return circle(k, w, radius_at<tip>(n, above), V{}, all(1.0),
                      least(above, n.height - above));
    } else if constexpr (course == Course::Plunge) {
        const V at_end = above - wz;
        const V highest = most(above, at_end), lowest = least(above, at_end);
        const double end = n.way[2] < 0.0 ? 1.0 : 0.0;
        Ray ray = circle(k, w, radius_at<tip>(n, least(highest, all(n.height))), V{}, all(1.0),
                         least(highest, n.height - lowest));
        ray.s_low = ray.s_high = all(end);
        return ray;
    } else {
        const double by_fall = 1.0 / wz;
        const V at_base = (above - n.tip) * by_fall;
        const V at_top = (above - n.height) * by_fall;
        const V first = most(V{}, least(at_base, at_top));
        const V last = least(all(1.0), most(at_base, at_top));
        const Ray cylinder = circle(k, w, all(n.radius), first, last, V{});
        if constexpr (tip == Tip::Flat) {
            return cylinder;
        } else if constexpr (tip == Tip::Ball) {
            return joined(cylinder, ball(n, k, w, n.radius - above));
        } else {
            return joined(cylinder, circles<tip>(n, k, w, above));
        }
    }
}

NCSIM_DEXEL_INLINE V load(const double* from) {
    V v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
NCSIM_DEXEL_INLINE void store(double* to, V v) {
    __builtin_memcpy(to, &v, sizeof v);
}

NCSIM_DEXEL_INLINE double highest_of(V v) {
    double highest = v[0];
    for (std::size_t i = 1; i < kWidth; ++i)
        highest = highest < v[i] ? v[i] : highest;
    return highest;
}

// Computes the rays along `axis` through u[0] … u[count - 1] and v; the results have space for
// kWidth more.
template <Tip tip, Course course>
void row_of(const Numbers& n, const Side& side, std::size_t axis, const double* u,
            std::size_t count, double v, RowMeeting& row) {
    for (std::size_t i = 0; i < count; i += kWidth) {
        V here;
        if (i + kWidth <= count) {
            here = load(u + i);
        } else {
            double rest[kWidth];
            for (std::size_t k = 0; k < kWidth; ++k)
                rest[k] = u[i + k < count ? i + k : count - 1];
            here = load(rest);
        }
        Ray ray;
        if (axis == 2) {
            ray = along_z<tip, course>(n, here, all(v));
        } else if (axis == 0) {
            ray = across_z<tip, course>(n, side, here, all(v));
        } else {
            ray = across_z<tip, course>(n, side, all(v), here);
        }
        store(row.low.data() + i, ray.low);
        store(row.high.data() + i, ray.high);
        store(row.s_low.data() + i, ray.s_low);
        store(row.s_high.data() + i, ray.s_high);
    }
}

inline void join_row(const JoinTask& t) {
    const PendingRow& known = t.pending;
    for (std::size_t i = 0; i < t.count; i += kWidth) {
        const V low = rounded(load(&t.met.low[i])), high = rounded(load(&t.met.high[i]));
        V known_low = load(known.low + i), known_high = load(known.high + i);
        const auto is_met = low < high;
        const auto is_apart =
            is_met & (known_low < known_high) & ((low > known_high) | (high < known_low));
        if (std::uint32_t apart = bits_of(is_apart); apart != 0) {
            for (; apart != 0; apart &= apart - 1)
                t.take(t.context, i + static_cast<std::size_t>(std::countr_zero(apart)));
            known_low = load(known.low + i);
            known_high = load(known.high + i);
        }
        const V body = all(t.body);
        const auto is_lower = is_met & (low < known_low), is_higher = is_met & (high > known_high);
        store(known.low + i, is_lower ? low : known_low);
        store(known.s_low + i, is_lower ? load(&t.met.s_low[i]) : load(known.s_low + i));
        store(known.low_body + i, is_lower ? body : load(known.low_body + i));
        store(known.high + i, is_higher ? high : known_high);
        store(known.s_high + i, is_higher ? load(&t.met.s_high[i]) : load(known.s_high + i));
        store(known.high_body + i, is_higher ? body : load(known.high_body + i));
    }
}

template <Tip tip>
void row_of(Course course, const RowTask& t) {
    switch (course) {
        case Course::Level:
            return row_of<tip, Course::Level>(t.numbers, t.side, t.axis, t.u, t.count, t.v, t.row);
        case Course::Plunge:
            return row_of<tip, Course::Plunge>(t.numbers, t.side, t.axis, t.u, t.count, t.v, t.row);
        case Course::Slope:
            return row_of<tip, Course::Slope>(t.numbers, t.side, t.axis, t.u, t.count, t.v, t.row);
    }
}

inline void row_of(Tip tip, Course course, const RowTask& task) {
    switch (tip) {
        case Tip::Flat: return row_of<Tip::Flat>(course, task);
        case Tip::Ball: return row_of<Tip::Ball>(course, task);
        case Tip::Round: return row_of<Tip::Round>(course, task);
        case Tip::Cone: return row_of<Tip::Cone>(course, task);
    }
}

}  // namespace NCSIM_DEXEL_LANES
}  // namespace
}  // namespace ncsim::dexel

#include "block_lanes.h"
