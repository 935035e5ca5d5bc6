// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds between planes in a box, for all cells at once. Facets of hulls of one tool have common
// normals: the reach of a cell along a normal bounds the reach along a second normal, by two
// numbers that depend only on the box. With a table of these numbers, redundant planes and covered
// cells are found by comparisons of rows. In floats, with a margin for rounding; the caller decides
// equal planes.
#pragma once

#include "exact/half_box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A normal in coordinates in which the half extents of a box are 1, scaled to |x| + |y| + |z| = 1.
/// The box reaches from -1 to 1 along the normal.
struct ScaledNormal {
    ScaledNormal() = default;
    /// `reach`: same as Sight::reach.
    ScaledNormal(double nx, double ny, double nz, const BoxFrame& box, double reach)
        : n{static_cast<float>(nx * box.half[0] / reach),
            static_cast<float>(ny * box.half[1] / reach),
            static_cast<float>(nz * box.half[2] / reach)} {}
    std::size_t longest_axis() const;

    std::array<float, 3> n{};
};

/// For points of the box with m·x <= e, p·x <= slope · e + offset, slope >= 0. The bound is one
/// multiplier λ of the linear program of a box and a halfspace, max p·x <= min over λ of λ e + Σ
/// |p_i − λ m_i|. With row::kMargin added, the bound holds for the planes before rounding to
/// floats: all terms are below 8, and the sum of the errors is below 4e-6.
struct Bound {
    float slope = 0, offset = 0;
};
/// Returns the bound on p·x that follows from a plane along `m`.
Bound bound_along(const ScaledNormal& p, const ScaledNormal& m);

/// Entries of a row: the reach of a cell along each normal of a table.
namespace row {
/// Added to a bound before a comparison.
constexpr float kMargin = 1e-5F;
/// Entry of a normal for which the cell has no plane in the box.
constexpr float kUnknown = 1e30F;
/// Entry of a threshold for which the covering cell has no plane: more than any bound.
constexpr float kAnything = 3e38F;
}  // namespace row

/// Bounds between all pairs of normals in a box.
class NormalTable {
public:
    /// Cost: O(normals²).
    void assign(std::span<const ScaledNormal> normals);

    std::size_t normals() const { return columns_.size(); }
    /// Returns the number of entries of a row, at least the number of normals.
    std::size_t stride() const { return stride_; }
    /// Returns the index in a row of the `i`-th assigned normal.
    std::uint32_t column(std::size_t i) const { return columns_[i]; }

    /// Lowers the bounds in `row` to the bounds that follow from a plane at distance `e` along the
    /// normal of `column`.
    void bound_by(std::uint32_t column, float e, float* row) const;
    /// The same for a plane along any normal.
    void bound_by(const ScaledNormal& m, float e, float* row) const;

private:
    struct Group {
        std::size_t begin = 0, end = 0;
    };
    template <class Take>
    void for_bounds(const ScaledNormal& m, Take take) const;

    std::size_t stride_ = 0;
    std::vector<std::uint32_t> columns_;
    // Normals grouped by longest axis: length_[] is the component along this axis, across_[0][] and
    // across_[1][] along the next two axes in cyclic order.
    std::array<Group, 3> groups_;
    std::vector<float> length_;
    std::array<std::vector<float>, 2> across_;
    std::vector<float> slopes_, offsets_;  // one row per normal
};

/// Planes in coordinates of a box, in groups.
class SeenPlanes {
public:
    void clear();
    void add(const ScaledNormal& normal, float e);
    /// Ends a group. Returns the index at which the next group begins.
    std::size_t end_group();

    /// True if a plane of the group [begin, end) implies p·x < e in the box. A plane does not imply
    /// itself.
    bool imply(std::size_t begin, std::size_t end, const ScaledNormal& p, float e) const;

private:
    std::array<std::vector<float>, 3> n_;
    std::vector<float> e_;
};

/// True if a[i] <= b[i] for all i. Requires: `size` is a stride.
bool is_below(const float* a, const float* b, std::size_t size);

}  // namespace ncsim::cda
