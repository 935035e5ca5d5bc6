// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rays along one axis, and where each is in the material.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/vec.h"

#include "grid.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::dexel {

/// A unit normal in 32 bits, off by 1e-4 at most: the octahedron unfolded to a square.
struct PackedNormal {
    std::int16_t u = 0, v = 0;

    static PackedNormal of(cda::Vec3 normal);
    cda::Vec3 unpacked() const;
};

/// Where a ray enters or leaves the material.
struct End {
    std::int32_t at = 0;  ///< Units.
    cda::Origin origin = cda::kStockOrigin;
    PackedNormal normal;  ///< Out of the material.
};

/// The material between two ends.
struct Interval {
    End low, high;

    bool is_empty() const { return low.at >= high.at; }
};

class Ray {
public:
    /// All there is of it.
    void set(const Interval& interval) { first_ = interval; }
    /// Takes what is between the two places away. The end of what is left below is end(true), of
    /// what is left above end(false).
    template <class MakeEnd>
    void cut(std::int32_t low, std::int32_t high, const MakeEnd& end) {
        if (first_.is_empty() || high <= first_.low.at) return;
        if (!rest_.empty()) {
            cut_several(end(true), end(false));
            return;
        }
        if (low >= first_.high.at) return;
        const bool is_left_below = low > first_.low.at;
        const bool is_left_above = high < first_.high.at;
        if (is_left_below && is_left_above) {
            rest_.push_back({end(false), first_.high});
            first_.high = end(true);
        } else if (is_left_below) {
            first_.high = end(true);
        } else if (is_left_above) {
            first_.low = end(false);
        } else {
            first_ = {};
        }
    }
    /// Calls take(interval) from below.
    template <class Take>
    void for_each(Take take) const {
        if (!first_.is_empty()) take(first_);
        for (const Interval& interval : rest_)
            take(interval);
    }
    bool contains(double place) const;
    /// May be true where there is none between two intervals.
    bool has_any_between(double low, double high) const {
        if (first_.is_empty()) return false;
        const Interval& last = rest_.empty() ? first_ : rest_.back();
        return first_.low.at < high && low < last.high.at;
    }
    std::int64_t length() const;

private:
    void cut_several(const End& low, const End& high);

    Interval first_;              // empty: so is the ray
    std::vector<Interval> rest_;  // beyond it, in order
};

/// All rays along an axis: `u` and `v` are the next two axes.
class Rays {
public:
    Rays(const Grid& grid, std::size_t axis);

    std::size_t axis() const { return axis_; }
    std::size_t u_axis() const { return (axis_ + 1) % 3; }
    std::size_t v_axis() const { return (axis_ + 2) % 3; }
    std::size_t rows() const { return rays_.size() / row_; }
    std::span<Ray> row(std::size_t v) { return std::span(rays_).subspan(v * row_, row_); }
    const Ray& operator()(std::size_t u, std::size_t v) const { return rays_[v * row_ + u]; }
    /// The sum of the lengths of all, units.
    double length() const;

private:
    std::size_t axis_;
    std::size_t row_;  // rays a row
    std::vector<Ray> rays_;
};

}  // namespace ncsim::dexel
