// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quickhull says which points make which facet; everything that is kept is then computed from
// the integer points, so that qhull's rounding never reaches a plane.
#include "ncsim/cda/hull.h"

#include "ncsim/cda/predicates.h"

#include "qhull.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>

namespace ncsim::cda {

namespace {

struct Normal {
    std::int64_t x = 0, y = 0, z = 0;
    bool operator==(const Normal&) const = default;
};

struct Wide {
    Int128 x = 0, y = 0, z = 0;
};

Int128 absolute(Int128 v) {
    return v < 0 ? -v : v;
}

Wide cross(LatticePoint a, LatticePoint b) {
    const auto product = [](std::int64_t p, std::int64_t q) { return static_cast<Int128>(p) * q; };
    return {product(a.y, b.z) - product(a.z, b.y), product(a.z, b.x) - product(a.x, b.z),
            product(a.x, b.y) - product(a.y, b.x)};
}

// Twice the area vector of a loop (Newell): the same for every starting corner, since it is exact.
Wide area_vector(std::span<const LatticePoint> points, const std::vector<std::uint32_t>& loop) {
    Wide sum;
    const LatticePoint a = points[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const Wide c = cross(points[loop[i]] - a, points[loop[i + 1]] - a);
        sum = {sum.x + c.x, sum.y + c.y, sum.z + c.z};
    }
    return sum;
}

// The nearest normal of kNormalBits to `v`, without common divisors; exact where it fits. v and -v
// give opposite normals. Requires v != 0, components below 2^100.
Normal quantised(const Wide& v) {
    const Int128 largest = std::max({absolute(v.x), absolute(v.y), absolute(v.z)});
    constexpr Int128 kLimit = Int128{1} << kNormalBits;
    const auto reduced = [](Int128 x, Int128 y, Int128 z) -> Normal {
        const auto nx = static_cast<std::int64_t>(x);
        const auto ny = static_cast<std::int64_t>(y);
        const auto nz = static_cast<std::int64_t>(z);
        const std::int64_t g = std::gcd(std::gcd(nx, ny), nz);
        return {nx / g, ny / g, nz / g};
    };
    if (largest < (Int128{1} << 62)) {
        const Normal n = reduced(v.x, v.y, v.z);
        if (std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) <= kLimit) return n;
    } else {
        // Divided by hand, since std::gcd has no 128 bits: only what is axis-parallel or diagonal
        // matters here, and for that a division by the largest component is enough.
        const auto divides = [&](Int128 c) { return c % largest == 0; };
        if (divides(v.x) && divides(v.y) && divides(v.z)) {
            return reduced(v.x / largest, v.y / largest, v.z / largest);
        }
    }
    // Halves away from zero, so that opposite vectors round to opposite normals.
    const auto scaled = [&](Int128 c) {
        const Int128 q = (2 * absolute(c) * kLimit / largest + 1) / 2;
        return c < 0 ? -q : q;
    };
    return reduced(scaled(v.x), scaled(v.y), scaled(v.z));
}

std::int64_t dot(Normal n, LatticePoint p) {
    return n.x * p.x + n.y * p.y + n.z * p.z;
}

// The plane of a normal that has all of `points` below it.
std::int64_t support(Normal n, std::span<const LatticePoint> points) {
    std::int64_t d = dot(n, points[0]);
    for (const LatticePoint& p : points)
        d = std::max(d, dot(n, p));
    return d;
}

struct Extent {
    LatticePoint min, max;
};

Extent extent(std::span<const LatticePoint> points) {
    Extent e{points[0], points[0]};
    for (const LatticePoint& p : points) {
        e.min = {std::min(e.min.x, p.x), std::min(e.min.y, p.y), std::min(e.min.z, p.z)};
        e.max = {std::max(e.max.x, p.x), std::max(e.max.y, p.y), std::max(e.max.z, p.z)};
    }
    return e;
}

// The hull with its facets in lattice coordinates; planes beside the loops.
struct LatticeHull {
    std::vector<std::vector<std::uint32_t>> loops;
    std::vector<Normal> normals;
};

std::optional<LatticeHull> lattice_hull(std::span<const LatticePoint> points) {
    if (points.empty()) return std::nullopt;
    // Relative to a corner: doubles then hold the differences exactly.
    const Extent e = extent(points);
    std::vector<Vec3> local;
    local.reserve(points.size());
    for (const LatticePoint& p : points) {
        const LatticePoint q = p - e.min;
        local.push_back(
            {static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z)});
    }
    const auto facets = quickhull(local);
    if (!facets) return std::nullopt;
    LatticeHull hull;
    for (const auto& loop : facets->loops) {
        const Wide v = area_vector(points, loop);
        if (v.x == 0 && v.y == 0 && v.z == 0) continue;
        hull.loops.push_back(loop);
        hull.normals.push_back(quantised(v));
    }
    return hull;
}

// Normals have no common divisor here, so planes are canonical as they are.
Plane plane_of(Normal n, std::int64_t d) {
    return {static_cast<std::int32_t>(n.x), static_cast<std::int32_t>(n.y),
            static_cast<std::int32_t>(n.z), d};
}

std::int64_t facet_distance(const LatticeHull& hull, std::size_t facet,
                            std::span<const LatticePoint> points, Rounding rounding) {
    const Normal n = hull.normals[facet];
    if (rounding == Rounding::Outward) return support(n, points);
    std::int64_t d = dot(n, points[hull.loops[facet][0]]);
    for (const std::uint32_t corner : hull.loops[facet])
        d = std::min(d, dot(n, points[corner]));
    return d;
}

// None stands twice: facets in one plane share it. Its index.
std::size_t add(std::vector<Plane>& planes, const Plane& plane) {
    const auto same = std::find(planes.begin(), planes.end(), plane);
    const auto index = static_cast<std::size_t>(same - planes.begin());
    if (same == planes.end()) planes.push_back(plane);
    return index;
}

// Six planes that keep a cell within the box of its points: where facets are nearly parallel,
// quantising them could let a corner run far away.
constexpr std::array<Normal, 6> kBoxNormals{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

}  // namespace

std::optional<Cell> convex_hull(std::span<const LatticePoint> points, const Lattice& lattice,
                                Origin origin, Rounding rounding) {
    const auto hull = lattice_hull(points);
    if (!hull) return std::nullopt;
    Cell cell;
    cell.origin = origin;
    for (std::size_t i = 0; i < hull->loops.size(); ++i)
        add(cell.planes, plane_of(hull->normals[i], facet_distance(*hull, i, points, rounding)));
    for (const Normal& n : kBoxNormals)
        add(cell.planes, plane_of(n, support(n, points)));
    const Extent e = extent(points);
    cell.bounds = {lattice.to_mm(e.min), lattice.to_mm(e.max)};
    return cell;
}

std::optional<Plane> plane_above(const std::array<LatticePoint, 3>& triangle,
                                 std::span<const LatticePoint> points) {
    const Wide v = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    if (v.x == 0 && v.y == 0 && v.z == 0) return std::nullopt;
    const Normal n = quantised(v);
    return plane_of(n, support(n, points));
}

std::optional<TranslationSweep> TranslationSweep::of(std::span<const LatticePoint> points,
                                                     const Lattice& lattice, Rounding rounding) {
    const auto hull = lattice_hull(points);
    if (!hull) return std::nullopt;
    TranslationSweep sweep;
    sweep.lattice_ = lattice;
    sweep.rounding_ = rounding;

    // Only corners of the hull count for supports.
    std::map<std::uint32_t, std::uint32_t> renumbered;
    for (const auto& loop : hull->loops) {
        for (const std::uint32_t corner : loop)
            renumbered.emplace(corner, 0);
    }
    for (auto& [corner, index] : renumbered) {
        index = static_cast<std::uint32_t>(sweep.vertices_.size());
        sweep.vertices_.push_back(points[corner]);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> facet_at;  // directed edge
    for (std::size_t i = 0; i < hull->loops.size(); ++i) {
        const auto& loop = hull->loops[i];
        const Plane plane = plane_of(hull->normals[i], facet_distance(*hull, i, points, rounding));
        const auto index = static_cast<std::uint32_t>(add(sweep.facets_, plane));
        for (std::size_t k = 0; k < loop.size(); ++k)
            facet_at[{renumbered[loop[k]], renumbered[loop[(k + 1) % loop.size()]]}] = index;
    }
    for (const auto& [edge, left] : facet_at) {
        if (edge.first > edge.second) continue;
        const auto right = facet_at.find({edge.second, edge.first});
        if (right == facet_at.end()) continue;  // qhull merged across it
        if (right->second == left) continue;    // quantised to one plane
        sweep.edges_.push_back({left, right->second, edge.first, edge.second});
    }
    for (const Normal& n : kBoxNormals)
        add(sweep.facets_, plane_of(n, support(n, points)));
    auto normals = std::make_shared<FacetNormals>();
    for (const Plane& facet : sweep.facets_) {
        normals->x.push_back(facet.nx);
        normals->y.push_back(facet.ny);
        normals->z.push_back(facet.nz);
    }
    sweep.normals_ = std::move(normals);
    return sweep;
}

Cell TranslationSweep::operator()(LatticePoint from, LatticePoint to, Origin origin) const {
    Cell cell;
    cell.origin = origin;
    cell.planes.reserve(facets_.size() + 32);
    const LatticePoint t = to - from;
    const auto normal = [](const Plane& p) { return Normal{p.nx, p.ny, p.nz}; };
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        const Normal n = normal(facets_[i]);
        const std::int64_t at_from = dot(n, from);
        const std::int64_t at_to = dot(n, to);
        cell.planes.push_back(plane_of(n, facets_[i].d + std::max(at_from, at_to)));
    }
    cell.normals = normals_;
    if (t != LatticePoint{}) add_sides(cell, from, to);
    const Extent e = extent(vertices_);
    const auto low = [](std::int64_t a, std::int64_t b) { return std::min(a, b); };
    const auto high = [](std::int64_t a, std::int64_t b) { return std::max(a, b); };
    cell.bounds = {lattice_.to_mm(e.min + LatticePoint{low(from.x, to.x), low(from.y, to.y),
                                                       low(from.z, to.z)}),
                   lattice_.to_mm(e.max + LatticePoint{high(from.x, to.x), high(from.y, to.y),
                                                       high(from.z, to.z)})};
    return cell;
}

// Edges of the silhouette seen along t: e × t points outwards where the left facet goes with the
// motion and the right one against it (left facet counter-clockwise, e = n_left × n_right).
void TranslationSweep::add_sides(Cell& cell, LatticePoint from, LatticePoint to) const {
    const LatticePoint t = to - from;
    const auto normal = [](const Plane& p) { return Normal{p.nx, p.ny, p.nz}; };
    for (const Edge& edge : edges_) {
        const std::int64_t left = dot(normal(facets_[edge.left]), t);
        const std::int64_t right = dot(normal(facets_[edge.right]), t);
        if (!((left > 0 && right < 0) || (left < 0 && right > 0))) continue;
        Wide m = cross(vertices_[edge.head] - vertices_[edge.tail], t);
        if (left < 0) m = {-m.x, -m.y, -m.z};
        if (m.x == 0 && m.y == 0 && m.z == 0) continue;
        const Normal n = quantised(m);
        std::int64_t d = 0;
        if (rounding_ == Rounding::Outward) {
            d = support(n, vertices_) + std::max(dot(n, from), dot(n, to));
        } else {
            d = std::min(dot(n, vertices_[edge.tail]), dot(n, vertices_[edge.head])) +
                std::min(dot(n, from), dot(n, to));
        }
        add(cell.planes, plane_of(n, d));
    }
}

}  // namespace ncsim::cda
