// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons in a plane, and segments on a line of two planes, for the inner loop of the tree.
// Corners are doubles with an error bound. The planes of each corner are stored, so that integers
// decide if doubles cannot. The results equal those of polygon.h, without allocation per cut.
#pragma once

#include "ncsim/cda/polygon.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ncsim::cda {

/// A plane with coefficients in doubles, exactly (at most 24 and 52 bits).
struct FilterPlane {
    FilterPlane() = default;
    explicit FilterPlane(const Plane& p, std::uint32_t source_number = 0)
        : nx(p.nx),
          ny(p.ny),
          nz(p.nz),
          d(static_cast<double>(p.d)),
          exact(p),
          source(source_number) {
        one_norm = std::abs(nx) + std::abs(ny) + std::abs(nz);
    }
    double nx = 0, ny = 0, nz = 0, d = 0;
    double one_norm = 0;  ///< |nx| + |ny| + |nz|
    Plane exact;
    std::uint32_t source = 0;  ///< Number chosen by the creator of the plane.
};

/// Planes in rows, for SIMD classification.
class PlaneRows {
public:
    void clear() { size_ = 0; }
    void add(const FilterPlane& plane);
    std::size_t size() const { return size_; }
    const FilterPlane& operator[](std::size_t i) const { return *planes_[i]; }

private:
    friend class FilteredPolygon;
    std::size_t size_ = 0;
    std::vector<const FilterPlane*> planes_;
    // longer than size_, so that vector loads stay within
    std::vector<double> nx_, ny_, nz_, d_, one_norm_;
};

/// Position of a polygon relative to a plane, as far as doubles decide.
enum class FilterResult : std::int64_t { Doubtful = 0, Below = 1, Above = 2, Across = 4 };

/// Position for each plane of some rows, with the approximate heights of the lowest and the highest
/// corner above the plane.
struct FilterResults {
    std::vector<FilterResult> where;
    std::vector<double> low, high;
};

/// A point with an error bound, in lattice units.
struct FilteredPoint {
    Vec3 p;
    double error = 0;  ///< Bound for each coordinate.
};

/// A piece of the line where two planes meet, in direction n_plane × n_line. Planes are stored as
/// pointers and must outlive the segment.
struct FilteredSegment {
    const FilterPlane* plane = nullptr;
    const FilterPlane* line = nullptr;
    const FilterPlane* tail_cut = nullptr;  ///< Planes that the line meets at the ends.
    const FilterPlane* head_cut = nullptr;
    FilteredPoint tail, head;

    enum class Clipped : std::uint8_t {
        Whole,    ///< The segment is below the plane.
        Tail,     ///< The tail was cut off.
        Head,     ///< The head was cut off.
        Nothing,  ///< The segment is above the plane and is undefined afterwards.
        Inside,   ///< The segment lies in the plane.
    };
    /// Keeps the part below `cut`.
    Clipped clip(const FilterPlane& cut);
};

/// A convex polygon. Planes are stored as pointers and must outlive the polygon.
class FilteredPolygon {
public:
    /// Sets the polygon to the part of `plane` within a box of half units; false if the part has no
    /// area. walls[2·axis] is the lower wall, walls[2·axis + 1] the upper wall.
    bool assign_section(const FilterPlane& plane, const std::array<std::int64_t, 3>& min,
                        const std::array<std::int64_t, 3>& max,
                        const std::array<FilterPlane, 6>& walls);

    void assign(const FilteredPolygon& other);

    const FilterPlane& plane() const { return *plane_; }
    std::size_t size() const { return corners().size; }
    /// Returns the plane that cuts off the edge from corner `i` to the next corner.
    const FilterPlane& edge_plane(std::size_t i) const { return *corners().edge[i]; }
    /// Returns the edge from corner `i` to the next corner.
    FilteredSegment edge(std::size_t i) const;

    /// Keeps the part below `cut`. False if the part has no area; the polygon is undefined
    /// afterwards.
    bool clip(const FilterPlane& cut);

    /// Classifies the polygon against planes [begin, end) of the rows. Results have the same
    /// indices; a few more entries are overwritten with undefined values.
    /// Cost: O(corners · planes), with a small factor.
    void classify_rows(const PlaneRows& planes, std::size_t begin, std::size_t end,
                       FilterResults& results) const;

    /// Returns 1 if the polygon is below or in the plane, -1 if no part is below, 0 if parts are on
    /// both sides. Exact. Not const, because sides and heights are cached.
    int classify(const FilterPlane& cut) { return classify_corners(cut); }

private:
    struct Corners {
        std::vector<double> x, y, z;
        std::vector<const FilterPlane*> edge;  // edge from corner i to the next
        std::size_t size = 0;

        // Removes all corners and reserves space for `most`.
        void clear(std::size_t most) {
            size = 0;
            if (x.size() < most + kPadding) make_room(most);
        }
        void add(const Vec3& p, const FilterPlane* edge_after) {
            x[size] = p.x;
            y[size] = p.y;
            z[size] = p.z;
            edge[size] = edge_after;
            ++size;
        }
        void add(const Corners& other, std::size_t i) { add(other.at(i), other.edge[i]); }
        Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
        // Repeats the first corner so that vector loops have no remainder; returns the padded size.
        std::size_t pad();

    private:
        static constexpr std::size_t kPadding = 2;  // for pad()
        void make_room(std::size_t most);
    };
    Corners& corners() { return sets_[now_]; }
    const Corners& corners() const { return sets_[now_]; }
    // Second set of corners that clip() fills; turn() makes it current.
    Corners& spare_corners() { return sets_[1 - now_]; }
    void swap_corners() { now_ = 1 - now_; }
    FilteredPoint corner(std::size_t i) const { return {corners().at(i), error_}; }
    std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
    std::size_t previous(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
    // Returns 1 if all corners are below or on, -1 if none is below, 0 if cut; sides_ and heights_
    // are then valid.
    int classify_corners(const FilterPlane& cut);
    int classify_doubtful(const FilterPlane& cut, double bound);
    bool clip_to_walls(const FilterPlane& lower, const FilterPlane& upper);

    const FilterPlane* plane_ = nullptr;
    std::array<Corners, 2> sets_;
    std::size_t now_ = 0;
    std::size_t padded_ = 0;
    double error_ = 0.0;  // bound for each coordinate of the corners
    // Results of the last classification.
    std::vector<Side> sides_;
    std::vector<double> heights_;
};

}  // namespace ncsim::cda
