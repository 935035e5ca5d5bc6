// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of polytopes: duality in doubles, verified exactly, with an exact fallback.
#include "ncsim/cda/intersect.h"

#include "polytope/linear_program.h"
#include "polytope/qhull.h"

#include <algorithm>
#include <map>

namespace ncsim::cda {

namespace {

// First seed; the next seed is tried if a corner of the linear program is degenerate.
constexpr std::uint64_t kSeed = 2001;
constexpr int kTries = 3;

Box common_box(const Box& a, const Box& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}

bool has_volume(const Box& box) {
    return box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
}

std::vector<Plane> planes_of(const ConvexPolytope& polytope) {
    std::vector<Plane> planes;
    planes.reserve(polytope.facets().size());
    for (const auto& facet : polytope.facets())
        planes.push_back(facet.plane);
    return planes;
}

// Returns the planes of both, sorted, without duplicates.
std::vector<Plane> joint_planes(std::vector<Plane> planes, const std::vector<Plane>& others) {
    planes.insert(planes.end(), others.begin(), others.end());
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    return planes;
}

// Returns a box in integer units that contains the box in mm.
Box box_in_units(const Box& mm, const Lattice& lattice) {
    const auto units = [&](Vec3 p, double widen) {
        const double k = 1.0 / lattice.unit_mm;
        return Vec3{std::round(p.x * k) + widen, std::round(p.y * k) + widen,
                    std::round(p.z * k) + widen};
    };
    return {units(mm.min, -1.0), units(mm.max, 1.0)};
}

std::vector<Halfspace> halfspaces_of(const std::vector<Plane>& planes) {
    std::vector<Halfspace> halfspaces;
    halfspaces.reserve(planes.size());
    for (const Plane& p : planes) {
        const Vec3 n{static_cast<double>(p.nx), static_cast<double>(p.ny),
                     static_cast<double>(p.nz)};
        const double length = norm(n);
        halfspaces.push_back({(1.0 / length) * n, static_cast<double>(p.d) / length});
    }
    return halfspaces;
}

// True if the point, rounded to 2^-16 units, is strictly below all planes.
bool is_strictly_inside(Vec3 point, const std::vector<Plane>& planes) {
    // 2^-16 of a unit is 0.15 fm at 10 nm. Moving the point by this distance is harmless, so the
    // rounded point is tested.
    constexpr double kScale = 65536.0;
    const auto fixed = [](double v) { return static_cast<std::int64_t>(std::round(v * kScale)); };
    const std::int64_t x = fixed(point.x);
    const std::int64_t y = fixed(point.y);
    const std::int64_t z = fixed(point.z);
    return std::all_of(planes.begin(), planes.end(), [&](const Plane& p) {
        const Int128 v = static_cast<Int128>(p.nx) * x + static_cast<Int128>(p.ny) * y +
                         static_cast<Int128>(p.nz) * z;
        return v < static_cast<Int128>(p.d) * 65536;
    });
}

// Computes the primal polytope: dual facets become corners, dual corners become facets. The corner
// of a dual facet is computed from three planes and must lie on the remaining planes, exactly.
std::optional<ConvexPolytope> primal_of(const HullFacets& dual, const std::vector<Plane>& planes) {
    std::vector<ExactPoint> vertices;
    vertices.reserve(dual.loops.size());
    for (const auto& loop : dual.loops) {
        std::optional<ExactPoint> corner;
        for (std::size_t k = 2; k < loop.size() && !corner; ++k) {
            corner = meet(planes[loop[0]], planes[loop[k - 1]], planes[loop[k]]);
        }
        if (!corner) return std::nullopt;
        for (const std::uint32_t p : loop) {
            if (classify(*corner, planes[p]) != Side::On) return std::nullopt;
        }
        vertices.push_back(*corner);
    }

    struct Place {
        /// A dual facet with the edge, and the corner before the edge.
        std::uint32_t facet, previous;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Place> edges;  // i → next
    for (std::uint32_t j = 0; j < dual.loops.size(); ++j) {
        const auto& loop = dual.loops[j];
        const std::size_t n = loop.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Place place{j, loop[(k + n - 1) % n]};
            if (!edges.try_emplace({loop[k], loop[(k + 1) % n]}, place).second) return std::nullopt;
        }
    }

    // Counter-clockwise about dual corner i: from each facet across the edge to the previous
    // corner.
    std::vector<ConvexPolytope::Facet> facets(planes.size());
    for (std::uint32_t i = 0; i < planes.size(); ++i)
        facets[i].plane = planes[i];
    for (const auto& [edge, first] : edges) {
        auto& facet = facets[edge.first];
        if (!facet.vertices.empty()) continue;
        Place at = first;
        do {
            facet.vertices.push_back(at.facet);
            facet.neighbours.push_back(at.previous);
            const auto next = edges.find({edge.first, at.previous});
            if (next == edges.end() || facet.vertices.size() > dual.loops.size()) {
                return std::nullopt;
            }
            at = next->second;
        } while (at.facet != first.facet);
        // Coincident corners belong to an edge of length 0, an artefact of rounding in qhull.
        for (std::size_t k = 0; k < facet.vertices.size(); ++k) {
            const auto& other = dual.loops[facet.vertices[(k + 1) % facet.vertices.size()]];
            const ExactPoint& corner = vertices[facet.vertices[k]];
            if (std::all_of(other.begin(), other.end(), [&](std::uint32_t p) {
                    return classify(corner, planes[p]) == Side::On;
                })) {
                return std::nullopt;
            }
        }
    }
    auto polytope = ConvexPolytope::assemble(std::move(vertices), std::move(facets));
    // Planes that qhull left out must hold as well.
    for (const Plane& plane : planes) {
        for (const ExactPoint& vertex : polytope.vertices()) {
            if (classify(vertex, plane) == Side::Above) return std::nullopt;
        }
    }
    if (!polytope.is_consistent()) return std::nullopt;
    return polytope;
}

std::optional<Vec3> proven_interior_point(const std::vector<Plane>& planes,
                                          const std::vector<Halfspace>& halfspaces,
                                          const Box& box) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
        const auto point =
            interior_point(halfspaces, box, kSeed + static_cast<std::uint64_t>(attempt));
        if (point && is_strictly_inside(*point, planes)) return point;
    }
    return std::nullopt;
}

class Timer {
public:
    Timer(Clock clock, double& total) : clock_(clock), total_(total) {
        if (clock_) start_ = clock_();
    }
    ~Timer() {
        if (clock_) total_ += clock_() - start_;
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

private:
    Clock clock_;
    double& total_;
    double start_ = 0.0;
};

}  // namespace

IntersectionCosts& IntersectionCosts::operator+=(const IntersectionCosts& other) {
    linear_programming_seconds += other.linear_programming_seconds;
    convex_hull_seconds += other.convex_hull_seconds;
    intersections += other.intersections;
    empty += other.empty;
    exact_fallbacks += other.exact_fallbacks;
    return *this;
}

std::optional<ConvexPolytope> intersect_exact(const ConvexPolytope& a, const ConvexPolytope& b) {
    return a.clip(planes_of(b));
}

namespace {

// Intersects within `box`, which contains the intersection.
std::optional<ConvexPolytope> intersect_within(const Box& box, const ConvexPolytope& a,
                                               const std::vector<Plane>& cuts,
                                               IntersectionCosts& costs, Clock clock) {
    ++costs.intersections;
    if (!has_volume(box)) {
        ++costs.empty;
        return std::nullopt;
    }
    const std::vector<Plane> planes = joint_planes(planes_of(a), cuts);
    const std::vector<Halfspace> halfspaces = halfspaces_of(planes);
    std::optional<Vec3> inside;
    {
        const Timer timer(clock, costs.linear_programming_seconds);
        inside = proven_interior_point(planes, halfspaces, box);
    }
    const Timer timer(clock, costs.convex_hull_seconds);
    if (inside) {
        std::vector<Vec3> polar;
        polar.reserve(planes.size());
        for (const Halfspace& h : halfspaces) {
            polar.push_back((1.0 / (h.distance - dot(h.normal, *inside))) * h.normal);
        }
        if (const auto dual = quickhull(polar)) {
            if (auto polytope = primal_of(*dual, planes)) return polytope;
        }
    }
    auto polytope = a.clip(cuts);
    ++(polytope ? costs.exact_fallbacks : costs.empty);
    return polytope;
}

}  // namespace

std::optional<ConvexPolytope> intersect(const ConvexPolytope& a, const ConvexPolytope& b,
                                        IntersectionCosts& costs, Clock clock) {
    return intersect_within(common_box(a.bounds(), b.bounds()), a, planes_of(b), costs, clock);
}

std::optional<ConvexPolytope> intersect(const ConvexPolytope& a, const Cell& cell,
                                        const Lattice& lattice, IntersectionCosts& costs,
                                        Clock clock) {
    std::vector<Plane> cuts;
    for (const Plane& plane : cell.planes) {
        switch (classify_box(a.bounds(), plane)) {
            case Side::Below: break;
            case Side::On: cuts.push_back(plane); break;
            case Side::Above:
                ++costs.intersections;
                ++costs.empty;
                return std::nullopt;
        }
    }
    return intersect_within(common_box(a.bounds(), box_in_units(cell.bounds, lattice)), a, cuts,
                            costs, clock);
}

namespace {

Vec3 middle_of_corners(const ConvexPolytope& polytope) {
    Vec3 sum;
    for (const ExactPoint& v : polytope.vertices())
        sum = sum + v.approx;
    return (1.0 / static_cast<double>(polytope.vertices().size())) * sum;
}

}  // namespace

std::optional<Vec3> common_point(const ConvexPolytope& a, const ConvexPolytope& b) {
    const Box box = common_box(a.bounds(), b.bounds());
    if (!has_volume(box)) return std::nullopt;
    const std::vector<Plane> planes = joint_planes(planes_of(a), planes_of(b));
    if (const auto point = proven_interior_point(planes, halfspaces_of(planes), box)) return point;
    const auto polytope = intersect_exact(a, b);
    if (!polytope) return std::nullopt;
    return middle_of_corners(*polytope);
}

std::optional<Vec3> point_inside(const std::vector<Plane>& specified, const Box& box) {
    const std::vector<Plane> planes = joint_planes(specified, {});
    if (!has_volume(box)) return std::nullopt;
    if (const auto point = proven_interior_point(planes, halfspaces_of(planes), box)) return point;
    Cell cell;
    cell.planes = planes;
    const Lattice lattice;
    cell.bounds = {lattice.to_mm(box.min), lattice.to_mm(box.max)};
    const auto polytope = ConvexPolytope::of(cell, lattice);
    if (!polytope) return std::nullopt;
    const Vec3 middle = middle_of_corners(*polytope);
    // For slivers below the resolution of doubles, the middle may lie outside.
    return is_strictly_inside(middle, planes) ? std::optional(middle) : std::nullopt;
}

}  // namespace ncsim::cda
