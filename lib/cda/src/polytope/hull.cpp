// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells from convex hulls. Quickhull decides which points form which facet. All stored values are
// then computed from the integer points, so that the rounding of qhull, if used, affects no plane.
#include "ncsim/cda/hull.h"

#include "ncsim/cda/predicates.h"

#include "polytope/lattice_quickhull.h"
#include "polytope/qhull.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

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

// Returns twice the area vector of a loop (Newell). Exact, hence independent of the first corner.
Wide area_vector(std::span<const LatticePoint> points, const std::vector<std::uint32_t>& loop) {
    Wide sum;
    const LatticePoint a = points[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const Wide c = cross(points[loop[i]] - a, points[loop[i + 1]] - a);
        sum = {sum.x + c.x, sum.y + c.y, sum.z + c.z};
    }
    return sum;
}

// Returns the greatest common divisor of absolute values, or 0 if the divisor is less than `least`:
// the remainders of Euclid's algorithm decrease and are multiples of the divisor. 0 for zeros only.
std::int64_t common_divisor(std::array<std::int64_t, 3> values, std::int64_t least) {
    std::int64_t a = 0;
    for (std::int64_t b : values) {
        while (b != 0) {
            if (b < least) return 0;
            const std::int64_t rest = a % b;
            a = b;
            b = rest;
        }
    }
    return a;
}

// Returns the normal of kNormalBits nearest to `v`, without common divisors; exact if possible. v
// and -v give opposite normals. Requires: v != 0, components below 2^100.
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
        const auto x = static_cast<std::int64_t>(v.x), y = static_cast<std::int64_t>(v.y),
                   z = static_cast<std::int64_t>(v.z);
        // Smallest divisor with which the components fit.
        const auto least = static_cast<std::int64_t>((largest + kLimit - 1) >> kNormalBits);
        const std::int64_t g = common_divisor({std::abs(x), std::abs(y), std::abs(z)}, least);
        if (g != 0) return {x / g, y / g, z / g};
    } else {
        // std::gcd does not support 128 bits. Only axis-parallel and diagonal vectors matter here,
        // and for these a division by the largest component suffices.
        const auto divides = [&](Int128 c) { return c % largest == 0; };
        if (divides(v.x) && divides(v.y) && divides(v.z)) {
            return reduced(v.x / largest, v.y / largest, v.z / largest);
        }
    }
    // Rounds halves away from zero, so that opposite vectors give opposite normals.
    const auto scaled = [&](Int128 c) {
        const Int128 q = (2 * absolute(c) * kLimit / largest + 1) / 2;
        return c < 0 ? -q : q;
    };
    return reduced(scaled(v.x), scaled(v.y), scaled(v.z));
}

std::int64_t dot(Normal n, LatticePoint p) {
    return n.x * p.x + n.y * p.y + n.z * p.z;
}

// Returns the distance of the supporting plane: all `points` are below or on the plane.
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

// The hull with facets in lattice coordinates. Normals are quantised on demand, because
// quantisation needs long divisions.
struct LatticeHull {
    std::vector<std::vector<std::uint32_t>> loops;
    std::vector<Wide> areas;  // twice the area vectors
    bool is_exact = false;    // exactly convex

    Normal normal(std::size_t facet) const { return quantised(areas[facet]); }
};

LatticeHull lattice_hull(std::span<const LatticePoint> points, HullFacets facets) {
    LatticeHull hull;
    hull.loops.reserve(facets.loops.size());
    hull.areas.reserve(facets.loops.size());
    for (auto& loop : facets.loops) {
        const Wide v = area_vector(points, loop);
        if (v.x == 0 && v.y == 0 && v.z == 0) continue;
        hull.loops.push_back(std::move(loop));
        hull.areas.push_back(v);
    }
    return hull;
}

// Returns the hull by qhull, with coplanar facets merged.
std::optional<LatticeHull> merged_hull(std::span<const LatticePoint> points) {
    if (points.empty()) return std::nullopt;
    // Relative to a corner, so that doubles represent the differences exactly.
    const Extent e = extent(points);
    std::vector<Vec3> local;
    local.reserve(points.size());
    for (const LatticePoint& p : points) {
        const LatticePoint q = p - e.min;
        local.push_back(
            {static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z)});
    }
    auto facets = quickhull(local);
    if (!facets) return std::nullopt;
    return lattice_hull(points, std::move(*facets));
}

// Returns the hull in triangles if the integer algorithm succeeds.
std::optional<LatticeHull> hull_of(std::span<const LatticePoint> points) {
    if (auto facets = lattice_quickhull(points)) {
        LatticeHull hull = lattice_hull(points, std::move(*facets));
        hull.is_exact = true;
        return hull;
    }
    return merged_hull(points);
}

// Normals have no common divisor here, so the planes are canonical.
Plane plane_of(Normal n, std::int64_t d) {
    return {static_cast<std::int32_t>(n.x), static_cast<std::int32_t>(n.y),
            static_cast<std::int32_t>(n.z), d};
}

Plane facet_plane(const LatticeHull& hull, std::size_t facet, std::span<const LatticePoint> points,
                  Rounding rounding) {
    const Normal n = hull.normal(facet);
    if (rounding == Rounding::Outward) return plane_of(n, support(n, points));
    std::int64_t d = dot(n, points[hull.loops[facet][0]]);
    for (const std::uint32_t corner : hull.loops[facet])
        d = std::min(d, dot(n, points[corner]));
    return plane_of(n, d);
}

// Adds a plane unless present, so that facets in one plane share the plane. Returns the index.
std::size_t add(std::vector<Plane>& planes, const Plane& plane) {
    const auto same = std::find(planes.begin(), planes.end(), plane);
    const auto index = static_cast<std::size_t>(same - planes.begin());
    if (same == planes.end()) planes.push_back(plane);
    return index;
}

// Returns the cosine between the worst of `normals` (unit vectors) and a unit vector that is close
// to all; negative if no such vector is found. The search stops as soon as the cosine is at least
// `enough`.
double common_cosine(std::span<const Vec3> normals, double enough) {
    const auto worst_of = [&](Vec3 m) {
        return *std::min_element(normals.begin(), normals.end(),
                                 [m](Vec3 a, Vec3 b) { return dot(m, a) < dot(m, b); });
    };
    Vec3 sum;
    for (const Vec3 n : normals)
        sum = sum + n;
    Vec3 m = normalized(sum);
    double best = dot(m, worst_of(m));
    // Moves towards the worst normal by decreasing steps: the centre of the smallest ball around
    // the normals (Badoiu and Clarkson, Smaller core-sets for balls, 2003).
    constexpr int kSteps = 8;
    for (int i = 1; i <= kSteps && !(best > 0.0 && best >= enough); ++i) {
        m = m + (1.0 / (i + 1)) * (worst_of(m) - m);
        const Vec3 unit = normalized(m);
        best = std::max(best, dot(unit, worst_of(unit)));
    }
    return best;
}

// The facet on the opposite side of each edge.
class Neighbours {
public:
    explicit Neighbours(const std::vector<std::vector<std::uint32_t>>& loops) {
        std::uint32_t corners = 0;
        std::size_t edges = 0;
        for (const auto& loop : loops) {
            edges += loop.size();
            for (const std::uint32_t corner : loop)
                corners = std::max(corners, corner + 1);
        }
        // Edges grouped by tail.
        begin_.resize(corners + std::size_t{1});
        for (const auto& loop : loops) {
            for (const std::uint32_t corner : loop)
                ++begin_[corner + std::size_t{1}];
        }
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        edges_.resize(edges);
        std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
        for (std::size_t f = 0; f < loops.size(); ++f) {
            for (std::size_t k = 0; k < loops[f].size(); ++k) {
                const std::uint32_t to = loops[f][(k + 1) % loops[f].size()];
                edges_[end[loops[f][k]]++] = {to, static_cast<std::uint32_t>(f)};
            }
        }
        for (std::uint32_t from = 0; from < corners && is_closed_; ++from) {
            for (std::uint32_t i = begin_[from]; i < begin_[from + std::size_t{1}]; ++i) {
                is_closed_ = is_closed_ && find(from, edges_[i].to) == &edges_[i] &&
                             find(edges_[i].to, from);
            }
        }
    }
    // True if each edge of a facet occurs exactly once in each direction.
    bool is_closed() const { return is_closed_; }
    // Calls `use` with the other end of each edge that begins at a corner.
    template <class Use>
    void for_each_end(std::uint32_t corner, const Use& use) const {
        for (std::uint32_t i = begin_[corner]; i < begin_[corner + std::size_t{1}]; ++i)
            use(edges_[i].to);
    }
    // Requires: is_closed().
    std::uint32_t across(std::uint32_t from, std::uint32_t to) const {
        return find(to, from)->facet;
    }

private:
    struct Edge {
        std::uint32_t to, facet;
    };
    // Returns the first edge with these ends. Few edges begin at a corner.
    const Edge* find(std::uint32_t from, std::uint32_t to) const {
        for (std::uint32_t i = begin_[from]; i < begin_[from + std::size_t{1}]; ++i) {
            if (edges_[i].to == to) return &edges_[i];
        }
        return nullptr;
    }

    std::vector<std::uint32_t> begin_;  // index of each corner's first edge
    std::vector<Edge> edges_;
    bool is_closed_ = true;
};

// Returns the outline of the facets of a patch; empty if the outline is not one loop.
std::vector<std::uint32_t> outline(const LatticeHull& hull, std::span<const std::uint32_t> patch,
                                   const std::vector<std::uint32_t>& patch_of,
                                   const Neighbours& neighbours) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const std::uint32_t f : patch) {
        const auto& loop = hull.loops[f];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::uint32_t from = loop[k], to = loop[(k + 1) % loop.size()];
            if (patch_of[neighbours.across(from, to)] != patch_of[f]) edges.emplace_back(from, to);
        }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::uint32_t> loop;
    if (edges.empty()) return loop;
    std::uint32_t at = edges.front().first;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        loop.push_back(at);
        at = std::lower_bound(edges.begin(), edges.end(), std::pair{at, std::uint32_t{0}})->second;
        if (at == loop.front()) break;
    }
    if (loop.size() != edges.size()) loop.clear();
    return loop;
}

// Heights of points along one normal at a time, each computed at its first use.
class Heights {
public:
    Heights(std::span<const LatticePoint> points, const LatticeHull& hull,
            const Neighbours& neighbours)
        : points_(points),
          is_exact_(hull.is_exact),
          neighbours_(neighbours),
          heights_(points.size()),
          known_(points.size(), 0) {}

    void set_normal(Normal normal) {
        normal_ = normal;
        ++number_;
    }
    std::int64_t operator[](std::uint32_t point) {
        if (known_[point] != number_) {
            known_[point] = number_;
            heights_[point] = dot(normal_, points_[point]);
        }
        return heights_[point];
    }
    // Returns the largest height of all points. On a convex surface a corner without a higher
    // neighbour is a highest point, so the search climbs from `corner`. A rounded hull may have
    // several such corners, so the search compares all points.
    std::int64_t largest(std::uint32_t corner) {
        if (!is_exact_) return support(normal_, points_);
        for (std::uint32_t next = corner;; corner = next) {
            neighbours_.for_each_end(corner, [&](std::uint32_t end) {
                if ((*this)[end] > (*this)[next]) next = end;
            });
            if (next == corner) break;
        }
        return (*this)[corner];
    }

private:
    std::span<const LatticePoint> points_;
    bool is_exact_;
    const Neighbours& neighbours_;
    Normal normal_;
    std::uint32_t number_ = 0;  // number of the normal
    std::vector<std::int64_t> heights_;
    std::vector<std::uint32_t> known_;  // number of the normal of each height
};

// A hull of merged facets, closed if the facets are.
struct Patches {
    LatticeHull hull;
    std::vector<Plane> planes;  // one per patch, with all points below
};

// Merges the hull into patches, each with the plane of the largest facet: a patch contains the
// connected facets around whose corners are less than `depth` units below the plane. Empty if the
// facets do not close, or a patch is not a disc.
std::optional<Patches> in_patches(const LatticeHull& hull, std::span<const LatticePoint> points,
                                  double depth) {
    const Neighbours neighbours(hull.loops);
    if (!neighbours.is_closed()) return std::nullopt;
    const auto count = static_cast<std::uint32_t>(hull.loops.size());
    struct FacetArea {
        double area;
        std::uint32_t facet;
    };
    std::vector<FacetArea> order;
    order.reserve(count);
    for (std::uint32_t f = 0; f < count; ++f) {
        const Wide& a = hull.areas[f];
        const Vec3 area{static_cast<double>(a.x), static_cast<double>(a.y),
                        static_cast<double>(a.z)};
        order.push_back({norm(area), f});
    }
    std::sort(order.begin(), order.end(), [](const FacetArea& a, const FacetArea& b) {
        return a.area > b.area || (a.area == b.area && a.facet < b.facet);
    });
    constexpr std::uint32_t kNone = ~0U;
    std::vector<std::uint32_t> patch_of(count, kNone);
    std::vector<std::uint32_t> tested_point(count, kNone);  // patch of the last test
    Heights heights(points, hull, neighbours);
    std::vector<std::uint32_t> facets;  // patch by patch
    facets.reserve(count);
    std::vector<std::size_t> begins;
    Patches result;
    for (const FacetArea& seed : order) {
        if (patch_of[seed.facet] != kNone) continue;
        const auto number = static_cast<std::uint32_t>(begins.size());
        const Normal n = hull.normal(seed.facet);
        const double length = norm(
            Vec3{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)});
        heights.set_normal(n);
        const std::int64_t d = heights.largest(hull.loops[seed.facet][0]);
        const auto lowest = d - static_cast<std::int64_t>(depth * length);
        const auto is_near = [&](std::uint32_t f) {
            return std::all_of(hull.loops[f].begin(), hull.loops[f].end(),
                               [&](std::uint32_t p) { return heights[p] >= lowest; });
        };
        begins.push_back(facets.size());
        facets.push_back(seed.facet);
        patch_of[seed.facet] = number;
        for (std::size_t i = begins.back(); i < facets.size(); ++i) {
            const auto& loop = hull.loops[facets[i]];
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const std::uint32_t next = neighbours.across(loop[k], loop[(k + 1) % loop.size()]);
                if (patch_of[next] != kNone || tested_point[next] == number) continue;
                tested_point[next] = number;
                if (!is_near(next)) continue;
                patch_of[next] = number;
                facets.push_back(next);
            }
        }
        result.planes.push_back(plane_of(n, d));
    }
    begins.push_back(facets.size());
    for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
        const std::span<const std::uint32_t> patch(facets.data() + begins[i],
                                                   begins[i + 1] - begins[i]);
        auto loop =
            patch.size() == 1 ? hull.loops[patch[0]] : outline(hull, patch, patch_of, neighbours);
        if (loop.size() < 3) return std::nullopt;
        result.hull.loops.push_back(std::move(loop));
        result.hull.areas.push_back(hull.areas[patch[0]]);
    }
    return result;
}

// True if the cell of these planes, one per facet, is proven to be nowhere farther than `limit`
// units from the hull of the points. Requires: each plane has all points below, and the facets
// close.
//
// Proof: around each corner the normals of the facets span a cone. If the facets close, and each
// faces away from a point inside at all of the facet's corners, these cones cover all directions,
// because the map from the surface to the normals is homotopic to the map from the surface to the
// directions seen from the point inside. So any unit vector u is a sum Σ λi ni over the facets
// around one corner p. No point of the cell is farther along u than Σ λi (ni·p + e) = u·p + e Σ λi,
// where e is the largest height of the planes above p, and p is in the hull. If m is a unit vector
// with m·ni ≥ c for these facets, then c Σ λi ≤ m·u ≤ 1. So the cell is at most e/c farther along
// u.
bool is_within(const LatticeHull& hull, std::span<const LatticePoint> points,
               const std::vector<Plane>& planes, double limit) {
    const auto vec_of = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        return Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    };
    struct Incidence {
        std::uint32_t corner;
        Vec3 normal;
        double above;
    };
    std::vector<Incidence> incidences;
    Vec3 inside;
    for (std::size_t f = 0; f < hull.loops.size(); ++f) {
        const Normal n{planes[f].nx, planes[f].ny, planes[f].nz};
        const double length = norm(vec_of(n.x, n.y, n.z));
        for (const std::uint32_t corner : hull.loops[f]) {
            const auto above = static_cast<double>(planes[f].d - dot(n, points[corner])) / length;
            incidences.push_back({corner, (1 / length) * vec_of(n.x, n.y, n.z), above});
            const LatticePoint p = points[corner] - points[0];
            inside = inside + vec_of(p.x, p.y, p.z);
        }
    }
    inside = (1.0 / static_cast<double>(incidences.size())) * inside;
    std::stable_sort(incidences.begin(), incidences.end(),
                     [](const Incidence& a, const Incidence& b) { return a.corner < b.corner; });
    std::vector<Vec3> normals;
    for (std::size_t i = 0; i < incidences.size();) {
        const std::uint32_t corner = incidences[i].corner;
        const LatticePoint p = points[corner] - points[0];
        double above = 0.0;
        normals.clear();
        for (; i < incidences.size() && incidences[i].corner == corner; ++i) {
            normals.push_back(incidences[i].normal);
            above = std::max(above, incidences[i].above);
            if (!(dot(incidences[i].normal, vec_of(p.x, p.y, p.z) - inside) > 0.0)) return false;
        }
        const double cosine = common_cosine(normals, above / limit);
        if (!(cosine > 0.0) || !(above / cosine <= limit)) return false;
    }
    return true;
}

// Normals of six planes that keep a cell within the box of the points. Without these planes,
// quantisation of nearly parallel facets could move a corner far away.
constexpr std::array<Normal, 6> kBoxNormals{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

Cell cell_of(const std::vector<Plane>& planes, std::span<const LatticePoint> points,
             const Lattice& lattice, Origin origin) {
    Cell cell;
    cell.origin = origin;
    for (const Plane& plane : planes)
        add(cell.planes, plane);
    for (const Normal& n : kBoxNormals)
        add(cell.planes, plane_of(n, support(n, points)));
    const Extent e = extent(points);
    cell.bounds = {lattice.to_mm(e.min), lattice.to_mm(e.max)};
    return cell;
}

}  // namespace

std::optional<Cell> convex_hull(std::span<const LatticePoint> points, const Lattice& lattice,
                                Origin origin, Rounding rounding) {
    const auto hull = hull_of(points);
    if (!hull) return std::nullopt;
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < hull->loops.size(); ++i)
        planes.push_back(facet_plane(*hull, i, points, rounding));
    return cell_of(planes, points, lattice, origin);
}

std::optional<Cell> convex_hull_within(std::span<const LatticePoint> points, const Lattice& lattice,
                                       Origin origin, double slack) {
    // The facets that qhull merges may depend on the order of the points.
    std::vector<LatticePoint> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(), [](const LatticePoint& a, const LatticePoint& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    const auto hull = hull_of(sorted);
    if (!hull) return std::nullopt;
    // If the normals around a corner differ much, the cell reaches farther than the planes.
    constexpr double kShare = 0.5;
    if (kShare * slack >= 1.0) {
        if (const auto patches = in_patches(*hull, sorted, kShare * slack)) {
            if (is_within(patches->hull, sorted, patches->planes, slack))
                return cell_of(patches->planes, sorted, lattice, origin);
        }
    }
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < hull->loops.size(); ++i)
        planes.push_back(facet_plane(*hull, i, sorted, Rounding::Outward));
    return cell_of(planes, sorted, lattice, origin);
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
    const auto hull = merged_hull(points);
    if (!hull) return std::nullopt;
    TranslationSweep sweep;
    sweep.lattice_ = lattice;
    sweep.rounding_ = rounding;

    // Only corners of the hull affect supports.
    std::map<std::uint32_t, std::uint32_t> renumbered;
    for (const auto& loop : hull->loops) {
        for (const std::uint32_t corner : loop)
            renumbered.emplace(corner, 0);
    }
    for (auto& [corner, index] : renumbered) {
        index = static_cast<std::uint32_t>(sweep.vertices_.size());
        sweep.vertices_.push_back(points[corner]);
    }
    const Extent reach = extent(sweep.vertices_);
    sweep.low_ = reach.min;
    sweep.high_ = reach.max;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> facet_at;  // directed edge
    for (std::size_t i = 0; i < hull->loops.size(); ++i) {
        const auto& loop = hull->loops[i];
        const Plane plane = facet_plane(*hull, i, points, rounding);
        const auto index = static_cast<std::uint32_t>(add(sweep.facets_, plane));
        for (std::size_t k = 0; k < loop.size(); ++k)
            facet_at[{renumbered[loop[k]], renumbered[loop[(k + 1) % loop.size()]]}] = index;
    }
    for (const auto& [edge, left] : facet_at) {
        if (edge.first > edge.second) continue;
        const auto right = facet_at.find({edge.second, edge.first});
        if (right == facet_at.end()) continue;  // qhull merged across the edge
        if (right->second == left) continue;    // both quantised to one plane
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
    cell.bounds = bounds(from, to);
    return cell;
}

Box TranslationSweep::bounds(LatticePoint from, LatticePoint to) const {
    const auto least = [](LatticePoint a, LatticePoint b) {
        return LatticePoint{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
    };
    const auto most = [](LatticePoint a, LatticePoint b) {
        return LatticePoint{std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
    };
    return {lattice_.to_mm(low_ + least(from, to)), lattice_.to_mm(high_ + most(from, to))};
}

// Adds the planes along the motion through edges of the silhouette. e × t points outwards if the
// left facet faces forward and the right facet backward (left facet counter-clockwise, e = n_left ×
// n_right).
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
