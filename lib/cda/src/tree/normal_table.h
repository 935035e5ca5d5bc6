// SPDX-License-Identifier: GPL-3.0-or-later
//
// What planes tell of each other in a box, for all cells at once. Facets of hulls of one tool have
// normals in common: how far a cell reaches along one of them bounds how far it reaches along
// another, by two numbers that depend on the box alone. With these in a table, what a cell needs
// not keep, and which cell covers which, are comparisons of rows. In floats, with room for their
// rounding; equal planes are left to the caller.
#pragma once

#include "exact/half_box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A normal seen from a box whose half extents are taken for one, |x| + |y| + |z| = 1: the box
/// reaches from -1 to 1 along it.
struct ScaledNormal {
    ScaledNormal() = default;
    /// `reach` as in Sight.
    ScaledNormal(double nx, double ny, double nz, const BoxFrame& box, double reach)
        : n{static_cast<float>(nx * box.half[0] / reach),
            static_cast<float>(ny * box.half[1] / reach),
            static_cast<float>(nz * box.half[2] / reach)} {}
    std::size_t longest_axis() const;

    std::array<float, 3> n{};
};

/// The bound on p·x for points of the box with m·x <= e is slope · e + offset, slope >= 0: one
/// multiplier of the linear program of a box and a halfspace, max p·x <= min over λ of
/// λ e + Σ |p_i − λ m_i|. With Row::kMargin added it holds for the planes before they were rounded
/// to floats: all terms are below 8, and their errors in all below 4e-6.
struct Bound {
    float slope = 0, offset = 0;
};
Bound bound_along(const ScaledNormal& p, const ScaledNormal& m);

/// Numbers for each normal of a table: how far a cell reaches along it.
namespace row {
/// Added to a bound before it is compared.
constexpr float kMargin = 1e-5F;
/// Along a normal of which the cell has no plane in the box.
constexpr float kUnknown = 1e30F;
/// The same, of a cell that others are compared with: more than any bound.
constexpr float kAnything = 3e38F;
}  // namespace row

class NormalTable {
public:
    /// O(normals²).
    void assign(std::span<const ScaledNormal> normals);

    std::size_t normals() const { return columns_.size(); }
    /// Entries of a row: at least as many as normals.
    std::size_t stride() const { return stride_; }
    /// Where in a row normal `i` of those assigned is.
    std::uint32_t column(std::size_t i) const { return columns_[i]; }

    /// Lowers the bounds in `row` to what a plane at distance `e` along a normal tells of all
    /// others.
    void bound_by(std::uint32_t column, float e, float* row) const;
    /// The same of a plane along any normal.
    void bound_by(const ScaledNormal& m, float e, float* row) const;

private:
    struct Group {
        std::size_t begin = 0, end = 0;
    };
    template <class Take>
    void for_bounds(const ScaledNormal& m, Take take) const;

    std::size_t stride_ = 0;
    std::vector<std::uint32_t> columns_;
    // By their longest axis, along which a normal has length_[], and across_[0][] and across_[1][]
    // along the two axes that come after it.
    std::array<Group, 3> groups_;
    std::vector<float> length_;
    std::array<std::vector<float>, 2> across_;
    std::vector<float> slopes_, offsets_;  // a row a normal
};

/// Planes seen from a box, many at a time.
class SeenPlanes {
public:
    void clear();
    void add(const ScaledNormal& normal, float e);
    /// After the last plane of a group: where the next one begins.
    std::size_t end_group();

    /// Does one of the planes of the group that begins at `begin` and ends at `end` imply p·x < e
    /// in the box? A plane does not imply itself.
    bool imply(std::size_t begin, std::size_t end, const ScaledNormal& p, float e) const;

private:
    std::array<std::vector<float>, 3> n_;
    std::vector<float> e_;
};

/// Is a <= b everywhere? Requires a size that is a stride.
bool is_below(const float* a, const float* b, std::size_t size);

}  // namespace ncsim::cda
