// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distance of hulls by GJK, common points, and penetration depth.
#include "ncsim/cda/separation.h"

#include "ncsim/base/int128.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/intersect.h"
#include "ncsim/cda/polytope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ncsim::cda {

namespace {

using Points = std::span<const LatticePoint>;

Vec3 in_doubles(LatticePoint p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

// A corner of the Minkowski difference b - a, with the indices of both corners.
struct Corner {
    Vec3 at;
    std::size_t of_a = 0, of_b = 0;
};

std::size_t farthest(Points points, Vec3 way) {
    std::size_t best = 0;
    double most = -Box::kInf;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double height = dot(way, in_doubles(points[i]));
        if (height > most) most = height, best = i;
    }
    return best;
}

// Returns the corner of b - a farthest against `way`.
Corner support(Points a, Points b, Vec3 way) {
    const std::size_t i = farthest(a, way), k = farthest(b, -way);
    return {in_doubles(b[k] - a[i]), i, k};
}

// Returns integers of kNormalBits along `way`; 0 if there is no direction.
LatticePoint to_integers(Vec3 way) {
    const double largest = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) return {};
    const double scale = std::ldexp(1.0, kNormalBits) / largest;
    const auto number = [scale](double v) {
        return static_cast<std::int64_t>(std::nearbyint(scale * v));
    };
    return {number(way.x), number(way.y), number(way.z)};
}

// True if a slab of `width` perpendicular to `way` lies between the hulls. Exact.
bool is_slab(Points a, Points b, Vec3 way, std::int64_t width) {
    const LatticePoint n = to_integers(way);
    if (n == LatticePoint{}) return false;
    const auto height = [&n](LatticePoint p) { return n.x * p.x + n.y * p.y + n.z * p.z; };
    std::int64_t highest = height(a[0]), lowest = height(b[0]);
    for (const LatticePoint& p : a)
        highest = std::max(highest, height(p));
    for (const LatticePoint& p : b)
        lowest = std::min(lowest, height(p));
    if (lowest < highest) return false;
    // (lowest - highest) / |n| >= width
    const Int128 gap = Int128{lowest} - highest;
    const Int128 square = Int128{n.x} * n.x + Int128{n.y} * n.y + Int128{n.z} * n.z;
    // Gaps whose squares exceed 128 bits are wide enough.
    constexpr std::int64_t kFar = std::int64_t{1} << 62;
    if (gap >= kFar) return width < (std::int64_t{1} << 36);
    return gap * gap >= square * width * width;
}

// The point of the hull of up to four corners that is nearest to the origin, and the corners that
// span the face with this point.
struct Closest {
    Vec3 at;
    unsigned used = 0;  // bits
};

std::optional<Vec3> of_edge(Vec3 p, Vec3 q) {
    const Vec3 along = q - p;
    const double t = -dot(p, along) / dot(along, along);
    if (!(t > 0.0 && t < 1.0)) return std::nullopt;
    return p + t * along;
}

std::optional<Vec3> of_face(Vec3 p, Vec3 q, Vec3 r) {
    const Vec3 n = cross(q - p, r - p);
    const double size = dot(n, n);
    if (!(size > 0.0)) return std::nullopt;
    const double u = dot(n, cross(q, r)), v = dot(n, cross(r, p)), w = dot(n, cross(p, q));
    if (!(u > 0.0 && v > 0.0 && w > 0.0)) return std::nullopt;
    return (dot(n, p) / size) * n;
}

bool contains_origin(const std::vector<Corner>& s) {
    const auto side = [](Vec3 p, Vec3 q, Vec3 r, Vec3 o) {
        return dot(cross(q - p, r - p), o - p);
    };
    const Vec3 zero;
    constexpr std::array<std::array<std::size_t, 4>, 4> kFaces{
        {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
    return std::ranges::all_of(kFaces, [&](const auto& f) {
        const double inner = side(s[f[0]].at, s[f[1]].at, s[f[2]].at, s[f[3]].at);
        const double origin = side(s[f[0]].at, s[f[1]].at, s[f[2]].at, zero);
        return inner != 0.0 && inner * origin >= 0.0;
    });
}

Closest closest(const std::vector<Corner>& s) {
    Closest best;
    double least = Box::kInf;
    const auto take = [&](Vec3 at, unsigned used) {
        const double size = dot(at, at);
        if (size < least) least = size, best = {at, used};
    };
    const std::size_t n = s.size();
    for (std::size_t i = 0; i < n; ++i)
        take(s[i].at, 1U << i);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = i + 1; k < n; ++k) {
            if (const auto at = of_edge(s[i].at, s[k].at)) take(*at, 1U << i | 1U << k);
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = i + 1; k < n; ++k) {
            for (std::size_t l = k + 1; l < n; ++l) {
                if (const auto at = of_face(s[i].at, s[k].at, s[l].at))
                    take(*at, 1U << i | 1U << k | 1U << l);
            }
        }
    }
    if (n == 4 && contains_origin(s)) best = {{}, 15U};
    return best;
}

// Returns the halfspaces of the hull, moved inwards by `margin`.
std::vector<Plane> inset(const Cell& hull, std::int64_t margin) {
    std::vector<Plane> planes;
    for (const Plane& p : hull.planes) {
        const Vec3 n{static_cast<double>(p.nx), static_cast<double>(p.ny),
                     static_cast<double>(p.nz)};
        const auto shift =
            static_cast<std::int64_t>(std::ceil(static_cast<double>(margin) * norm(n)));
        planes.push_back(canonical(p.nx, p.ny, p.nz, p.d - shift));
    }
    return planes;
}

void drop_parallel(std::vector<Vec3>& directions) {
    const auto before = [](Vec3 a, Vec3 b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    for (Vec3& d : directions) {
        if (before(d, {})) d = -d;
    }
    std::ranges::sort(directions, before);
    constexpr double kSame = 1e-9;
    const auto same = [](Vec3 a, Vec3 b) { return norm(a - b) < kSame; };
    directions.erase(std::unique(directions.begin(), directions.end(), same), directions.end());
}

}  // namespace

BodyDistance body_distance(Points a, Points b, std::int64_t width, Vec3 hint) {
    BodyDistance result;
    result.way = hint;
    if (is_slab(a, b, hint, width)) {
        result.is_apart = true;
        const Corner nearest = support(a, b, hint);
        result.distance = norm(nearest.at);
        return result;
    }
    std::vector<Corner> simplex;
    simplex.reserve(4);
    simplex.push_back({in_doubles(b[0] - a[0]), 0, 0});
    Vec3 v = simplex[0].at;
    constexpr int kMostSteps = 64;
    constexpr double kRounding = 1e-10;
    for (int i = 0; i < kMostSteps; ++i) {
        const double size = dot(v, v);
        result.distance = std::sqrt(size);
        if (size == 0.0) break;
        result.way = v;
        const Corner next = support(a, b, v);
        const double low = dot(v, next.at);
        // All of b - a is at least this far along v.
        if (low > 0.0 && low >= static_cast<double>(width) * result.distance &&
            is_slab(a, b, v, width)) {
            result.is_apart = true;
            break;
        }
        const bool is_known = std::ranges::any_of(
            simplex, [&](const Corner& c) { return c.of_a == next.of_a && c.of_b == next.of_b; });
        if (is_known || size - low <= kRounding * size) break;
        simplex.push_back(next);
        const Closest near = closest(simplex);
        if (near.used == 15U) {
            result.distance = 0.0;
            break;
        }
        std::vector<Corner> kept;
        kept.reserve(4);
        for (std::size_t k = 0; k < simplex.size(); ++k) {
            if (near.used >> k & 1U) kept.push_back(simplex[k]);
        }
        simplex = std::move(kept);
        v = near.at;
    }
    return result;
}

std::optional<Vec3> common_point(Points a, Points b, std::int64_t margin) {
    Box box_a, box_b;
    for (const LatticePoint& p : a)
        box_a.add(in_doubles(p));
    for (const LatticePoint& p : b)
        box_b.add(in_doubles(p));
    if (!box_a.overlaps(box_b)) return std::nullopt;
    // Relative to a point near both, because the kernel has a limited range.
    const LatticePoint centre = a[0];
    const Lattice lattice;
    const auto hull = [&](Points points) {
        std::vector<LatticePoint> near(points.begin(), points.end());
        for (LatticePoint& p : near)
            p = p - centre;
        return convex_hull(near, lattice, kStockOrigin, Rounding::Inward);
    };
    const auto in_a = hull(a), in_b = hull(b);
    if (!in_a || !in_b) return std::nullopt;
    std::vector<Plane> planes = inset(*in_a, margin);
    const std::vector<Plane> others = inset(*in_b, margin);
    planes.insert(planes.end(), others.begin(), others.end());
    const Vec3 origin = in_doubles(centre);
    const Box box{{std::max(box_a.min.x, box_b.min.x) - origin.x,
                   std::max(box_a.min.y, box_b.min.y) - origin.y,
                   std::max(box_a.min.z, box_b.min.z) - origin.z},
                  {std::min(box_a.max.x, box_b.max.x) - origin.x,
                   std::min(box_a.max.y, box_b.max.y) - origin.y,
                   std::min(box_a.max.z, box_b.max.z) - origin.z}};
    const auto point = point_inside(planes, box);
    if (!point) return std::nullopt;
    return *point + origin;
}

Directions directions_of(const ConvexPolytope& body) {
    Directions directions;
    for (const auto& facet : body.facets()) {
        directions.normals.push_back(unit_normal(facet.plane));
        for (std::size_t i = 0; i < facet.vertices.size(); ++i) {
            const std::size_t k = (i + 1) % facet.vertices.size();
            // the adjacent facet has the edge as well
            if (facet.vertices[i] > facet.vertices[k]) continue;
            directions.edges.push_back(normalized(body.vertices()[facet.vertices[k]].approx -
                                                  body.vertices()[facet.vertices[i]].approx));
        }
    }
    drop_parallel(directions.edges);
    return directions;
}

double depth(std::span<const Vec3> a, const Directions& of_a, std::span<const Vec3> b,
             const Directions& of_b) {
    double least = Box::kInf;
    const auto ask = [&](Vec3 n) {
        double a_low = Box::kInf, a_high = -Box::kInf, b_low = Box::kInf, b_high = -Box::kInf;
        for (const Vec3& p : a) {
            const double height = dot(n, p);
            a_low = std::min(a_low, height), a_high = std::max(a_high, height);
        }
        for (const Vec3& p : b) {
            const double height = dot(n, p);
            b_low = std::min(b_low, height), b_high = std::max(b_high, height);
        }
        least = std::min({least, a_high - b_low, b_high - a_low});
    };
    for (const Directions* body : {&of_a, &of_b}) {
        for (const Vec3& normal : body->normals)
            ask(normal);
    }
    for (const Vec3& edge_a : of_a.edges) {
        for (const Vec3& edge_b : of_b.edges) {
            const Vec3 across = cross(edge_a, edge_b);
            constexpr double kParallel = 1e-6;
            if (norm(across) > kParallel) ask(normalized(across));
        }
    }
    return std::max(0.0, least);
}

}  // namespace ncsim::cda
