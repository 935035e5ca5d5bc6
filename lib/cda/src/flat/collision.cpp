// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collision tests against the flat aggregate.
#include "ncsim/cda/collision.h"

#include "ncsim/cda/hull.h"

#include "polytope/difference.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <array>
#include <functional>
#include <vector>

namespace ncsim::cda {

namespace {

using Rational = CGAL::Exact_rational;
using RationalPoint = std::array<Rational, 3>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point3 = Kernel::Point_3;

// Returns the first convex piece of body ∩ material that `accept` accepts.
std::optional<ConvexPolytope> first_piece(
    const FlatCda& part, const Cell& body,
    const std::function<bool(const ConvexPolytope&)>& accept) {
    IntersectionCosts costs;
    const auto in_stock = intersect(part.positive().body, body, part.lattice(), costs);
    if (!in_stock) return std::nullopt;
    std::vector<const ConvexPolytope*> milled;
    for (const CdaCell& cell : part.negative()) {
        if (cell.body.bounds().overlaps(in_stock->bounds())) milled.push_back(&cell.body);
    }
    return first_of_difference(*in_stock, milled, accept);
}

// A closed surface with corners on the lattice.
class LatticeSurface {
public:
    LatticeSurface(const TriangleMesh& mesh, const Lattice& lattice) : triangles_(mesh.triangles) {
        points_.reserve(mesh.vertices.size());
        for (const Vec3& v : mesh.vertices)
            points_.push_back(lattice.round(v));
    }
    const std::vector<LatticePoint>& points() const { return points_; }

    // Returns a point of the surface strictly inside the piece, in units.
    std::optional<Vec3> point_inside(const ConvexPolytope& piece) const {
        for (const auto& triangle : triangles_) {
            std::vector<RationalPoint> polygon;
            for (const std::uint32_t v : triangle) {
                const LatticePoint& p = points_[v];
                polygon.push_back({number(p.x), number(p.y), number(p.z)});
            }
            for (const auto& facet : piece.facets())
                polygon = clip(polygon, facet.plane);
            if (polygon.empty()) continue;
            // The middle of the rest is strictly inside if any point of the rest is.
            RationalPoint middle{0, 0, 0};
            for (const RationalPoint& p : polygon) {
                for (std::size_t i = 0; i < 3; ++i)
                    middle[i] += p[i];
            }
            for (Rational& c : middle)
                c /= static_cast<int>(polygon.size());
            bool strictly = true;
            for (const auto& facet : piece.facets())
                strictly &= height(middle, facet.plane) < 0;
            if (strictly) {
                return Vec3{CGAL::to_double(middle[0]), CGAL::to_double(middle[1]),
                            CGAL::to_double(middle[2])};
            }
        }
        return std::nullopt;
    }

    // Casts rays and counts crossings; a ray that meets an edge or a corner is replaced by another
    // ray.
    bool contains(Vec3 p) const {
        constexpr double kFar = 1e12;  // units: beyond every body
        const Point3 from(p.x, p.y, p.z);
        for (int attempt = 1;; ++attempt) {
            const double slope = 0.1 + 0.618034 * attempt;
            const Point3 to(p.x + kFar, p.y + kFar / slope, p.z + kFar / (slope * slope + 1.0));
            if (const auto parity = crossings(from, to)) return *parity % 2 == 1;
        }
    }

private:
    static Rational number(std::int64_t v) { return Rational(static_cast<double>(v)); }

    static Rational height(const RationalPoint& p, const Plane& plane) {
        return p[0] * number(plane.nx) + p[1] * number(plane.ny) + p[2] * number(plane.nz) -
               number(plane.d);
    }

    static std::vector<RationalPoint> clip(const std::vector<RationalPoint>& polygon,
                                           const Plane& plane) {
        std::vector<RationalPoint> part;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const RationalPoint& a = polygon[i];
            const RationalPoint& b = polygon[(i + 1) % polygon.size()];
            const Rational ha = height(a, plane);
            const Rational hb = height(b, plane);
            if (ha <= 0) part.push_back(a);
            if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) {
                const Rational t = ha / (ha - hb);
                RationalPoint cut;
                for (std::size_t k = 0; k < 3; ++k)
                    cut[k] = a[k] + t * (b[k] - a[k]);
                part.push_back(std::move(cut));
            }
        }
        return part;
    }

    std::optional<int> crossings(const Point3& from, const Point3& to) const {
        int count = 0;
        for (const auto& triangle : triangles_) {
            std::array<Point3, 3> c;
            for (std::size_t i = 0; i < 3; ++i) {
                const LatticePoint& p = points_[triangle[i]];
                c[i] = Point3(static_cast<double>(p.x), static_cast<double>(p.y),
                              static_cast<double>(p.z));
            }
            if (CGAL::collinear(c[0], c[1], c[2])) continue;
            const auto start = CGAL::orientation(c[0], c[1], c[2], from);
            const auto end = CGAL::orientation(c[0], c[1], c[2], to);
            if (start == CGAL::ZERO || end == CGAL::ZERO) return std::nullopt;
            if (start == end) continue;
            const auto s0 = CGAL::orientation(from, to, c[0], c[1]);
            const auto s1 = CGAL::orientation(from, to, c[1], c[2]);
            const auto s2 = CGAL::orientation(from, to, c[2], c[0]);
            if (s0 == CGAL::ZERO || s1 == CGAL::ZERO || s2 == CGAL::ZERO) return std::nullopt;
            if (s0 == s1 && s1 == s2) ++count;
        }
        return count;
    }

    std::vector<LatticePoint> points_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::optional<Vec3> collision(const FlatCda& part, const Cell& body) {
    const auto piece = first_piece(part, body, [](const ConvexPolytope&) { return true; });
    if (!piece) return std::nullopt;
    return part.lattice().to_mm(inner_point(*piece));
}

std::optional<Vec3> collision(const FlatCda& part, const TriangleMesh& body) {
    const LatticeSurface surface(body, part.lattice());
    const auto hull = convex_hull(surface.points(), part.lattice(), kStockOrigin);
    if (!hull) return std::nullopt;
    std::optional<Vec3> certificate;
    first_piece(part, *hull, [&](const ConvexPolytope& piece) {
        certificate = surface.point_inside(piece);
        // No surface passes through the piece. So the piece is wholly inside or outside of the
        // body, and an inner point of the piece is not on the surface.
        if (!certificate && surface.contains(inner_point(piece))) {
            certificate = inner_point(piece);
        }
        return certificate.has_value();
    });
    if (!certificate) return std::nullopt;
    return part.lattice().to_mm(*certificate);
}

}  // namespace ncsim::cda
