// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares a part with its design. For each of the two surfaces, as seen from the opposite surface:
//
//  1. Clip a triangle, later a piece, by the points within the tolerance of single triangles of the
//     opposite surface. Most triangles vanish.
//  2. Measure the distance of the rest at its corners and in its middle. A point that is too far
//     away is a finding. If no point can be too far away, because distance is a 1-Lipschitz
//     function, the piece is clear.
//  3. Halve the rest and start again, the largest pieces first.
//
// Findings are gathered in cubes; cubes that touch form a region.
#include "ncsim/verify/design_comparison.h"

#include "ncsim/base/triangle_tree.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/triangulate.h"

#include "common_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace ncsim::verify {

using cda::Origin;

namespace {

using Polygon = std::vector<Vec3>;  // convex, flat

// Largest number of pieces; beyond this number, which takes minutes, the search stops.
constexpr std::size_t kMostPieces = 1'000'000;
// A piece that is near to more triangles, or divides into more pieces, is halved first.
constexpr std::size_t kManyTriangles = 48, kManyPieces = 24;

// Distance (mm) below which points in double precision are equal; closes cracks between prisms.
constexpr double kSame = 1e-9;

struct Halfspace {
    Vec3 normal;  // unit, outwards
    double offset = 0.0;
};

// Moves the part outside `h` to `outside`; `inside` keeps the rest.
void split(Polygon& inside, const Halfspace& h, Polygon& outside) {
    outside.clear();
    Polygon in;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const Vec3 a = inside[i], b = inside[(i + 1) % inside.size()];
        const double ha = dot(h.normal, a) - h.offset, hb = dot(h.normal, b) - h.offset;
        (ha <= 0.0 ? in : outside).push_back(a);
        if ((ha <= 0.0) != (hb <= 0.0)) {
            const Vec3 cut = a + (ha / (ha - hb)) * (b - a);
            in.push_back(cut);
            outside.push_back(cut);
        }
    }
    if (in.size() < 3) in.clear();
    if (outside.size() < 3) outside.clear();
    inside = std::move(in);
}

// Returns the prism over the triangle from -`reach` to `reach`.
std::array<Halfspace, 5> prism(const TriangleCorners& t, double reach) {
    const Vec3 n = normalized(cross(t[1] - t[0], t[2] - t[0]));
    std::array<Halfspace, 5> all;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 out = normalized(cross(t[(k + 1) % 3] - t[k], n));
        all[k] = {out, dot(out, t[k]) + kSame};
    }
    all[3] = {n, dot(n, t[0]) + reach};
    all[4] = {-n, reach - dot(n, t[0])};
    return all;
}

Vec3 middle_of(const Polygon& polygon) {
    Vec3 sum;
    for (const Vec3& p : polygon)
        sum = sum + p;
    return (1.0 / static_cast<double>(polygon.size())) * sum;
}

double farthest_corner(const Polygon& polygon, const TriangleCorners& triangle) {
    double worst = 0.0;
    for (const Vec3& p : polygon)
        worst = std::max(worst, distance(p, triangle));
    return worst;
}

// Findings of one side, by cube.
class Places {
public:
    Places(Vec3 origin, double grain) : origin_(origin), grain_(grain) {}

    /// Adds a point. `below(least)` returns DesignRegion::below_mm; only values above `least` need
    /// to be exact.
    template <class Below>
    void add(Vec3 point, double depth, Origin face, const Below& below) {
        Place& place = places_[cube_of(point)];
        place.below = std::max(place.below, below(place.below));
        if (depth > place.depth) {
            place.depth = depth;
            place.point = point;
        }
        if (face != cda::kStockOrigin && depth > place.cut_depth) {
            place.cut_depth = depth;
            place.face = face;
        }
        place.box.add(point);
        place.faces.insert(face);
        largest_ = std::max(largest_, depth);
    }
    double largest() const { return largest_; }

    std::vector<DesignRegion> regions() const {
        std::vector<DesignRegion> regions;
        std::set<Cube> done;
        for (const auto& [start, unused] : places_) {
            if (!done.insert(start).second) continue;
            DesignRegion region;
            double cut_depth = 0.0;
            std::set<Origin> faces;
            std::vector<Cube> open{start};
            while (!open.empty()) {
                const Cube cube = open.back();
                open.pop_back();
                const Place& place = places_.at(cube);
                // Ties are decided by position, so the result does not depend on the order of the
                // search.
                if (std::tuple(place.depth, -place.point.x, -place.point.y, -place.point.z) >
                    std::tuple(region.depth_mm, -region.point.x, -region.point.y,
                               -region.point.z)) {
                    region.depth_mm = place.depth;
                    region.point = place.point;
                }
                if (std::pair(place.cut_depth, region.origin) > std::pair(cut_depth, place.face)) {
                    cut_depth = place.cut_depth;
                    region.origin = place.face;
                }
                region.below_mm = std::max(region.below_mm, place.below);
                region.box.add(place.box);
                faces.insert(place.faces.begin(), place.faces.end());
                for (const Cube& next : neighbours(cube)) {
                    if (places_.contains(next) && done.insert(next).second) open.push_back(next);
                }
            }
            region.origins.assign(faces.begin(), faces.end());
            regions.push_back(std::move(region));
        }
        std::ranges::stable_sort(regions, std::ranges::greater{}, &DesignRegion::depth_mm);
        return regions;
    }

private:
    using Cube = std::array<std::int64_t, 3>;
    struct Place {
        double depth = 0.0, below = 0.0;
        Vec3 point;
        double cut_depth = 0.0;  // at cut faces
        Origin face = cda::kStockOrigin;
        Box box;
        std::set<Origin> faces;
    };

    Cube cube_of(Vec3 p) const {
        Cube cube{};
        for (int axis = 0; axis < 3; ++axis) {
            cube[static_cast<std::size_t>(axis)] =
                static_cast<std::int64_t>(std::floor((p[axis] - origin_[axis]) / grain_));
        }
        return cube;
    }
    static std::vector<Cube> neighbours(const Cube& cube) {
        std::vector<Cube> all;
        for (std::int64_t i = 0; i < 27; ++i)
            all.push_back({cube[0] + i % 3 - 1, cube[1] + i / 3 % 3 - 1, cube[2] + i / 9 - 1});
        return all;
    }

    Vec3 origin_;
    double grain_;
    double largest_ = 0.0;
    std::map<Cube, Place> places_;
};

struct Limits {
    double tolerance = 0.0, resolution = 0.0, grain = 0.0;
};

// Search of one surface, as seen from the opposite surface.
class Search {
public:
    /// Creates a search. `inside` and `outside` collect points inside and outside the opposite
    /// surface.
    Search(const TriangleMesh& surface, const TriangleTree& other, const Limits& limits,
           Places& inside, Places& outside)
        : surface_(surface), other_(other), limits_(limits), inside_(inside), outside_(outside) {}

    /// Searches the surface and calls `add(places, point, triangle of the surface, nearest point of
    /// the opposite surface)` for each point found.
    template <class Add>
    void run(const Add& add) {
        for (const Vec3& v : surface_.vertices)
            deviation_ = std::max(deviation_, other_.nearest(v).distance_mm);
        for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
            const TriangleCorners c = corners_of(surface_, t);
            const Vec3 middle = (1.0 / 3.0) * (c[0] + c[1] + c[2]);
            deviation_ = std::max(deviation_, other_.nearest(middle).distance_mm);
            examine({{c.begin(), c.end()}, t}, add);
        }
        while (!open_.empty() && examined_ < kMostPieces) {
            const Piece piece = open_.top().piece;
            open_.pop();
            examine(piece, add);
        }
    }

    double deviation() const { return deviation_; }
    /// Returns the radius down to which every piece was searched.
    double resolution() const {
        return open_.empty() ? limits_.resolution
                             : std::max(limits_.resolution, open_.top().radius);
    }

private:
    struct Piece {
        Polygon polygon;
        std::uint32_t triangle = 0;
    };
    struct OpenPiece {
        double radius = 0.0;
        std::uint64_t number = 0;
        Piece piece;
        bool operator<(const OpenPiece& other) const {
            return std::pair(radius, other.number) < std::pair(other.radius, number);
        }
    };

    // Steps 1 and 2.
    template <class Add>
    void examine(const Piece& piece, const Add& add) {
        subtract_covered(piece.polygon);
        for (Polygon& polygon : rest_)
            enqueue({std::move(polygon), piece.triangle}, add);
    }

    // Leaves in rest_ the parts that are not proven to be within the tolerance.
    void subtract_covered(const Polygon& polygon) {
        rest_.assign(1, polygon);
        Box box;
        for (const Vec3& p : polygon)
            box.add(p);
        const Vec3 reach{limits_.tolerance, limits_.tolerance, limits_.tolerance};
        box = {box.min - reach, box.max + reach};
        near_.clear();
        other_.visit(
            [&](const Box& b) { return near_.size() <= kManyTriangles && b.overlaps(box); },
            [&](std::uint32_t t) { near_.push_back(t); });
        if (near_.size() > kManyTriangles) return;
        for (const std::uint32_t t : near_) {
            const TriangleCorners triangle = corners_of(other_.mesh(), t);
            if (norm(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) == 0.0) continue;
            const auto walls = prism(triangle, limits_.tolerance);
            next_.clear();
            for (Polygon& part : rest_) {
                // The distance from a convex body is largest in a corner.
                if (farthest_corner(part, triangle) <= limits_.tolerance) continue;
                Polygon within = part;
                const std::size_t before = next_.size();
                for (const Halfspace& wall : walls) {
                    split(within, wall, outside_piece_);
                    if (!outside_piece_.empty()) next_.push_back(outside_piece_);
                    if (within.empty()) break;
                }
                if (within.empty()) {  // no progress: keep the part as before
                    next_.resize(before);
                    next_.push_back(std::move(part));
                }
            }
            rest_.swap(next_);
            if (rest_.empty()) return;
            if (rest_.size() > kManyPieces) {
                rest_.assign(1, polygon);
                return;
            }
        }
    }

    template <class Add>
    void enqueue(Piece piece, const Add& add) {
        ++examined_;
        const Vec3 middle = middle_of(piece.polygon);
        double radius = 0.0;
        for (const Vec3& p : piece.polygon)
            radius = std::max(radius, norm(p - middle));
        const auto nearest = other_.nearest(middle);
        const double most =
            std::min(nearest.distance_mm + radius,
                     farthest_corner(piece.polygon, corners_of(other_.mesh(), nearest.triangle)));
        if (most <= limits_.tolerance) return;
        bool found = false;
        double known = 0.0;
        const auto tell = [&](Vec3 p, const TriangleTree::Nearest& near) {
            deviation_ = std::max(deviation_, near.distance_mm);
            if (near.distance_mm <= limits_.tolerance) return;
            found = true;
            Places& places = other_.contains(p) ? inside_ : outside_;
            if (radius <= limits_.grain) {
                add(places, p, piece.triangle, near);
            }
            known = std::max(known, places.largest());
        };
        tell(middle, nearest);
        for (const Vec3& p : piece.polygon)
            tell(p, other_.nearest(p));
        if (radius <= limits_.resolution) return;
        if (found && radius <= limits_.grain && most <= 1.02 * known + limits_.resolution) return;
        halve(piece, radius);
    }

    // Step 3: halves the piece across the longest extent.
    void halve(const Piece& piece, double radius) {
        Box box;
        for (const Vec3& p : piece.polygon)
            box.add(p);
        const Vec3 size = box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        Halfspace half;
        half.normal[axis] = 1.0;
        half.offset = box.centre()[axis];
        Polygon first = piece.polygon, second;
        split(first, half, second);
        for (Polygon* part : {&first, &second}) {
            if (part->empty()) continue;
            open_.push({radius, number_++, {std::move(*part), piece.triangle}});
        }
    }

    const TriangleMesh& surface_;
    const TriangleTree& other_;
    Limits limits_;
    Places& inside_;
    Places& outside_;
    double deviation_ = 0.0;
    std::size_t examined_ = 0;
    std::uint64_t number_ = 0;
    std::priority_queue<OpenPiece> open_;
    std::vector<Polygon> rest_, next_;  // kept to reuse memory
    Polygon outside_piece_;
    std::vector<std::uint32_t> near_;
};

// Returns a lower bound of the depth of the missing body below a point of `surface`, searched along
// the normal for depths above `least`.
// Requires: the opposite surface is at least `free` away from the point.
double missing_below(const TriangleTree& surface, Vec3 point, std::uint32_t triangle, double free,
                     double least) {
    constexpr int kSteps = 20;
    constexpr double kNext = 0.75;
    const TriangleCorners t = corners_of(surface.mesh(), triangle);
    const Vec3 area = cross(t[1] - t[0], t[2] - t[0]);
    if (norm(area) == 0.0) return 0.0;
    const Vec3 down = -normalized(area);
    double deepest = 0.0;
    // The depth of a point is at most its distance from the surface point.
    double away = free;
    for (int step = 0; step < kSteps && away > std::max(deepest, least); ++step, away *= kNext) {
        const Vec3 p = point + away * down;
        if (surface.contains(p)) deepest = std::max(deepest, surface.nearest(p).distance_mm);
    }
    return deepest;
}

}  // namespace

DesignComparison compare(const cda::Boundary& part, const TriangleMesh& design,
                         double tolerance_mm) {
    const TriangleMesh made = cda::triangulate(part);
    Box box;
    for (const TriangleMesh* mesh : {&made, &design}) {
        for (const Vec3& v : mesh->vertices)
            box.add(v);
    }
    Limits limits;
    limits.tolerance = tolerance_mm;
    limits.resolution = tolerance_mm / 8;
    limits.grain = std::max(norm(box.size()) / 64, tolerance_mm);
    Places gouge(box.min, limits.grain), excess(box.min, limits.grain);

    const TriangleTree made_tree(made), design_tree(design);
    const auto face_of = [&](std::uint32_t t) { return part.faces[made.face[t]].origin; };
    Search of_part(made, design_tree, limits, gouge, excess);
    of_part.run([&](Places& places, Vec3 p, std::uint32_t own, const TriangleTree::Nearest& near) {
        places.add(p, near.distance_mm, face_of(own), [&](double least) {
            return &places == &excess ? missing_below(made_tree, p, own, near.distance_mm, least)
                                      : near.distance_mm;
        });
    });
    Search of_design(design, made_tree, limits, excess, gouge);
    of_design.run([&](Places& places, Vec3 p, std::uint32_t own,
                      const TriangleTree::Nearest& near) {
        places.add(p, near.distance_mm, face_of(near.triangle), [&](double least) {
            return &places == &gouge ? missing_below(design_tree, p, own, near.distance_mm, least)
                                     : near.distance_mm;
        });
    });

    DesignComparison result;
    result.gouge.regions = gouge.regions();
    result.excess.regions = excess.regions();
    if (const auto common = common_volume(made, design)) {
        result.gouge.volume_mm3 = std::max(0.0, cda::volume(design) - *common);
        result.excess.volume_mm3 = std::max(0.0, cda::volume(made) - *common);
    }
    result.deviation_mm = std::max(of_part.deviation(), of_design.deviation());
    result.resolution_mm = std::max(of_part.resolution(), of_design.resolution());
    result.grain_mm = limits.grain;
    return result;
}

}  // namespace ncsim::verify
