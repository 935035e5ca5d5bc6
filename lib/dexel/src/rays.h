// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rays along an axis, with the intervals in the material.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/origin.h"

#include "grid.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ncsim::dexel {

/// A unit normal in 32 bits, error at most 1e-4: the octahedron unfolded to a square.
struct PackedNormal {
    std::int16_t u = 0, v = 0;

    static constexpr double kFull = 32767.0;

    static PackedNormal of(Vec3 normal);
    Vec3 unpacked() const;
};

// Called for each end. Signs are random, so the code avoids branches on signs.
inline PackedNormal PackedNormal::of(Vec3 n) {
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(sum > 0.0)) return {};
    double u = n.x / sum, v = n.y / sum;
    if (n.z < 0.0) {
        const double folded = u < 0.0 ? std::abs(v) - 1.0 : 1.0 - std::abs(v);
        v = v < 0.0 ? std::abs(u) - 1.0 : 1.0 - std::abs(u);
        u = folded;
    }
    const auto whole = [](double x) {
        return static_cast<std::int16_t>(x * kFull + std::copysign(0.5, x));
    };
    return {whole(u), whole(v)};
}

/// The end of an interval, where a ray enters or leaves the material.
struct End {
    std::int32_t at = 0;  ///< Units.
    cda::Origin origin = cda::kStockOrigin;
    PackedNormal normal;  ///< Normal that points out of the material.
};

/// The material between two ends.
struct Interval {
    End low, high;
};

/// An interval without material: between two ends, or beyond all.
struct Gap {
    static constexpr std::int32_t kUnbounded = 1 << 30;

    std::int32_t low = 0, high = 0;
};

/// A ray: most rays have one interval, which is stored in place.
class Ray {
public:
    Ray() = default;
    Ray(const Ray& other);
    Ray& operator=(const Ray& other);
    Ray(Ray&&) = default;
    Ray& operator=(Ray&&) = default;
    ~Ray() = default;

    /// Replaces all intervals.
    void set(const Interval& interval);
    /// Removes the material between two places and returns the gap that then contains both.
    /// end(true) is the new end of the rest below, end(false) of the rest above; each is called at
    /// most once.
    template <class MakeEnd>
    Gap cut(std::int32_t low, std::int32_t high, const MakeEnd& end);

    /// Removes the material above a place and returns the gap above. end() is the new end of the
    /// rest; called only if the ray gets shorter.
    template <class MakeEnd>
    Gap cut_above(std::int32_t low, const MakeEnd& end);

    /// Returns the intervals, ascending.
    std::span<const Interval> intervals() const {
        return list_ ? std::span<const Interval>(*list_)
                     : std::span(&single_, is_empty() ? 0U : 1U);
    }
    bool contains(double place) const;
    std::int64_t length() const;
    /// Returns the memory in bytes in addition to the object.
    std::size_t bytes() const;

private:
    bool is_empty() const { return single_.low.at >= single_.high.at; }
    std::span<Interval> all() {
        return list_ ? std::span<Interval>(*list_) : std::span(&single_, is_empty() ? 0U : 1U);
    }
    void split(std::size_t at, const Interval& below, const Interval& above);
    void erase(std::size_t begin, std::size_t end);

    Interval single_;                              // valid unless list_
    std::unique_ptr<std::vector<Interval>> list_;  // for rays that have ever had two intervals
};

template <class MakeEnd>
Gap Ray::cut(std::int32_t low, std::int32_t high, const MakeEnd& end) {
    const std::span<Interval> known = all();
    std::size_t first = 0;  // first interval that is cut
    while (first < known.size() && known[first].high.at <= low)
        ++first;
    std::size_t last = first;
    while (last < known.size() && known[last].low.at < high)
        ++last;
    Gap gap;
    gap.low = first > 0 ? known[first - 1].high.at : -Gap::kUnbounded;
    gap.high = last < known.size() ? known[last].low.at : Gap::kUnbounded;
    if (first == last) return gap;
    const bool is_left_below = low > known[first].low.at;
    const bool is_left_above = high < known[last - 1].high.at;
    if (is_left_below) gap.low = low;
    if (is_left_above) gap.high = high;
    if (is_left_below && is_left_above && last - first == 1) {
        const Interval cut = known[first];
        split(first, {cut.low, end(true)}, {end(false), cut.high});
        return gap;
    }
    if (is_left_below) known[first++].high = end(true);
    if (is_left_above) known[--last].low = end(false);
    if (first < last) erase(first, last);
    return gap;
}

template <class MakeEnd>
Gap Ray::cut_above(std::int32_t low, const MakeEnd& end) {
    const std::span<Interval> known = all();
    std::size_t left = known.size();
    while (left > 0 && known[left - 1].low.at >= low)
        --left;
    if (left < known.size()) erase(left, known.size());
    if (left == 0) return {-Gap::kUnbounded, Gap::kUnbounded};
    End& top = known[left - 1].high;
    if (low < top.at) top = end();
    return {top.at, Gap::kUnbounded};
}

/// Rays along each side of a block.
inline constexpr std::size_t kBlock = 8;

/// All rays along an axis; `u` and `v` are the next two axes.
class Rays {
public:
    /// Creates an empty set.
    Rays() = default;
    Rays(const Grid& grid, std::size_t axis);

    std::size_t axis() const { return axis_; }
    std::size_t u_axis() const { return (axis_ + 1) % 3; }
    std::size_t v_axis() const { return (axis_ + 2) % 3; }
    std::size_t rows() const { return row_ == 0 ? 0 : rays_.size() / row_; }
    std::span<Ray> row(std::size_t v) { return std::span(rays_).subspan(v * row_, row_); }
    /// Returns a gap of each ray of a row: the gap of the last cut.
    std::span<Gap> gaps(std::size_t v) { return std::span(gaps_).subspan(v * row_, row_); }
    /// Returns the number of rows of blocks.
    std::size_t bands() const { return blocks_ == 0 ? 0 : ceilings_.size() / blocks_; }
    /// Returns the ceiling of each block of a row of blocks: no ray of the block has material at or
    /// above the ceiling. A cutter may lower ceilings or leave them unchanged.
    std::span<std::int32_t> ceilings(std::size_t band) {
        return std::span(ceilings_).subspan(band * blocks_, blocks_);
    }
    const Ray& operator()(std::size_t u, std::size_t v) const { return rays_[v * row_ + u]; }
    std::span<const Ray> all() const { return rays_; }
    /// Returns the sum of all lengths, units.
    double length() const;
    std::size_t bytes() const;

private:
    std::size_t axis_ = 0;
    std::size_t row_ = 0;     // rays per row
    std::size_t blocks_ = 0;  // blocks per row of blocks
    std::vector<Ray> rays_;
    std::vector<Gap> gaps_;
    std::vector<std::int32_t> ceilings_;
};

}  // namespace ncsim::dexel
