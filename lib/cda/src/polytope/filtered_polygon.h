// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons in a plane, and segments on a line of two planes, for the inner loop of the tree:
// corners are doubles with a bound on their error; the planes that make a corner are kept, so that
// a question the doubles cannot answer is put to integers. Same answers as polygon.h, no allocation
// per cut.
#pragma once

#include "ncsim/cda/polygon.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A plane with its coefficients as doubles (exact: they have 24 and 52 bits at most).
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
    std::uint32_t source = 0;  ///< Whoever made it knows it by this number.
};

/// Planes side by side, for looking at many of them at once.
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
    std::vector<double> nx_, ny_, nz_, d_, one_norm_;  // longer, so that none is read beyond
};

/// Where a polygon lies to a plane, as far as doubles tell.
enum class Glance : std::int64_t { Doubtful = 0, Below = 1, Above = 2, Across = 4 };

/// The same for each plane of some rows, and how high above it the lowest and the highest corner
/// are, nearly.
struct Glances {
    std::vector<Glance> where;
    std::vector<double> low, high;
};

/// A point with its error, in lattice units.
struct FilteredPoint {
    Vec3 p;
    double error = 0;  ///< Of each coordinate.
};

/// A piece of the line where two planes meet, in direction n_plane × n_line. Planes are referred to
/// by their address, which must outlive it.
struct FilteredSegment {
    const FilterPlane* plane = nullptr;
    const FilterPlane* line = nullptr;
    const FilterPlane* tail_cut = nullptr;  ///< Ends are where the line meets these.
    const FilterPlane* head_cut = nullptr;
    FilteredPoint tail, head;

    enum class Clipped : std::uint8_t {
        Whole,    ///< Lies below.
        Tail,     ///< Lost its tail.
        Head,     ///< Lost its head.
        Nothing,  ///< Lies above: undefined now.
        Inside,   ///< Lies in the plane.
    };
    /// Keeps what lies below `cut`.
    Clipped clip(const FilterPlane& cut);
};

/// Planes are referred to by their address, which must outlive the polygon.
class FilteredPolygon {
public:
    /// The part of `plane` within a box of half units: walls[2·axis] is the lower wall,
    /// walls[2·axis + 1] the upper one. False if it has no area.
    bool assign_section(const FilterPlane& plane, const std::array<std::int64_t, 3>& min,
                        const std::array<std::int64_t, 3>& max,
                        const std::array<FilterPlane, 6>& walls);

    void assign(const FilteredPolygon& other);

    const FilterPlane& plane() const { return *plane_; }
    std::size_t size() const { return corners().size; }
    /// The plane that cuts off the edge from corner `i` to the next.
    const FilterPlane& edge_plane(std::size_t i) const { return *corners().edge[i]; }
    /// From corner `i` to the next.
    FilteredSegment edge(std::size_t i) const;

    /// Keeps what lies below `cut`; false, and then undefined, if that has no area.
    bool clip(const FilterPlane& cut);

    /// Looks at planes `begin` … `end` of the rows: the glances at the same places, and nobody
    /// knows what at a few more. O(corners · planes), with a small factor.
    void look(const PlaneRows& planes, std::size_t begin, std::size_t end, Glances& glances) const;

    /// 1: lies below or in the plane; -1: no part of it below; 0: on both sides. Exact. Not const:
    /// it notes what it finds.
    int classify(const FilterPlane& cut) { return classify_corners(cut); }

private:
    struct Corners {
        std::vector<double> x, y, z;
        std::vector<const FilterPlane*> edge;  // from corner i to the next
        std::size_t size = 0;

        // None, with room for so many.
        void clear(std::size_t most) {
            size = 0;
            if (x.size() < most + kSpare) make_room(most);
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
        // Repeats the first corner, so that loops over corners have no remainder: until where.
        std::size_t pad();

    private:
        static constexpr std::size_t kSpare = 2;  // for pad()
        void make_room(std::size_t most);
    };
    Corners& corners() { return sets_[now_]; }
    const Corners& corners() const { return sets_[now_]; }
    // What clip() keeps: until turn(), another set of corners.
    Corners& kept() { return sets_[1 - now_]; }
    void turn() { now_ = 1 - now_; }
    FilteredPoint corner(std::size_t i) const { return {corners().at(i), error_}; }
    std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
    std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
    // 1: all below or on; -1: none below; 0: cut, and sides_ and heights_ are known.
    int classify_corners(const FilterPlane& cut);
    int classify_doubtful(const FilterPlane& cut, double bound);
    bool clip_to_walls(const FilterPlane& lower, const FilterPlane& upper);

    const FilterPlane* plane_ = nullptr;
    std::array<Corners, 2> sets_;
    std::size_t now_ = 0;
    std::size_t padded_ = 0;
    double error_ = 0.0;  // of each coordinate of them
    // Of the last classification.
    std::vector<Side> sides_;
    std::vector<double> heights_;
};

}  // namespace ncsim::cda
