// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decomposition of the inside of a surface. Space is halved by planes until a part contains no
// surface; parts outside of the surface are carved. The position of triangles relative to planes is
// decided in doubles, within kThickness. Parts are clipped exactly, so that the parts always fill
// space without gap or overlap; only the side of a sliver can be wrong.
#include "ncsim/cda/shape.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/workpiece.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

namespace ncsim::cda {

namespace {

// Distance in units within which a surface counts as lying in a plane.
constexpr double kThickness = 2.0;
// With fewer polygons, every cut follows a polygon's plane.
constexpr std::size_t kFewPolygons = 12;
// Number of planes tried for a cut.
constexpr std::size_t kCandidates = 8;
// A hull with more facets is replaced by a box, because each outer plane costs time everywhere.
constexpr std::size_t kMostOuterPlanes = 200;

double height(const Plane& plane, Vec3 p) {
    const Vec3 n{static_cast<double>(plane.nx), static_cast<double>(plane.ny),
                 static_cast<double>(plane.nz)};
    return (dot(n, p) - static_cast<double>(plane.d)) / norm(n);
}

Vec3 as_vector(LatticePoint p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

// A part of a triangle.
struct Piece {
    std::uint32_t plane = 0;
    std::vector<Vec3> corners;  // units, counter-clockwise seen from outside
};

Vec3 area_vector(const std::vector<Vec3>& corners) {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum = sum + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return 0.5 * sum;
}

Vec3 mean(const std::vector<Vec3>& corners) {
    Vec3 sum;
    for (const Vec3& p : corners)
        sum = sum + p;
    return (1.0 / static_cast<double>(corners.size())) * sum;
}

// Groups of adjacent triangles that lie nearly in a plane, with this plane.
class Planes {
public:
    Planes(const std::vector<LatticePoint>& points,
           const std::vector<std::array<std::uint32_t, 3>>& triangles)
        : points_(points), triangles_(triangles), plane_of_(triangles.size(), kNone) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> at_edge;
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i)
                at_edge[{triangles[t][i], triangles[t][(i + 1) % 3]}].push_back(t);
        }
        neighbours_.resize(triangles.size());
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto other = at_edge.find({triangles[t][(i + 1) % 3], triangles[t][i]});
                if (other == at_edge.end()) continue;
                neighbours_[t].insert(neighbours_[t].end(), other->second.begin(),
                                      other->second.end());
            }
        }
        // Large triangles first, because they determine planes best.
        std::vector<std::pair<double, std::uint32_t>> order;
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            order.emplace_back(-norm(area_vector(corners(t))), t);
        std::sort(order.begin(), order.end());
        for (const auto& [area, t] : order) {
            if (plane_of_[t] == kNone) grow(t);
        }
    }

    std::vector<Vec3> corners(std::uint32_t t) const {
        const auto& c = triangles_[t];
        return {as_vector(points_[c[0]]), as_vector(points_[c[1]]), as_vector(points_[c[2]])};
    }
    /// kNone: the triangle has no area.
    std::uint32_t plane_of(std::uint32_t triangle) const { return plane_of_[triangle]; }
    const std::vector<Plane>& all() const { return planes_; }

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

private:
    void grow(std::uint32_t seed) {
        const auto& c = triangles_[seed];
        const std::array<LatticePoint, 3> corners{points_[c[0]], points_[c[1]], points_[c[2]]};
        const auto first = plane_above(corners, corners);
        if (!first) return;
        const auto number = static_cast<std::uint32_t>(planes_.size());
        std::vector<std::uint32_t> open{seed};
        std::vector<LatticePoint> all;
        plane_of_[seed] = number;
        while (!open.empty()) {
            const std::uint32_t t = open.back();
            open.pop_back();
            for (const std::uint32_t corner : triangles_[t])
                all.push_back(points_[corner]);
            for (const std::uint32_t next : neighbours_[t]) {
                if (plane_of_[next] != kNone || !lies_in(*first, next)) continue;
                plane_of_[next] = number;
                open.push_back(next);
            }
        }
        planes_.push_back(*plane_above(corners, all));
    }
    bool lies_in(const Plane& plane, std::uint32_t triangle) const {
        const auto its_corners = corners(triangle);
        const Vec3 normal = area_vector(its_corners);
        return dot(unit_normal(plane), normal) > 0.0 &&
               std::all_of(its_corners.begin(), its_corners.end(), [&](const Vec3& p) {
                   return std::abs(height(plane, p)) <= 0.5 * kThickness;
               });
    }

    const std::vector<LatticePoint>& points_;
    const std::vector<std::array<std::uint32_t, 3>>& triangles_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
    std::vector<std::uint32_t> plane_of_;
    std::vector<Plane> planes_;
};

// Returns the parts of a piece below and above a plane; both empty if the piece lies in the plane.
std::pair<Piece, Piece> split(const Piece& piece, const Plane& plane) {
    std::vector<double> heights;
    double lowest = 0.0;
    double highest = 0.0;
    for (const Vec3& p : piece.corners) {
        heights.push_back(height(plane, p));
        lowest = std::min(lowest, heights.back());
        highest = std::max(highest, heights.back());
    }
    Piece below{piece.plane, {}};
    Piece above{piece.plane, {}};
    if (highest <= kThickness) {
        if (lowest < -kThickness) below = piece;
        return {below, above};
    }
    if (lowest >= -kThickness) return {below, piece};
    const std::size_t n = piece.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = (i + 1) % n;
        (heights[i] < 0.0 ? below : above).corners.push_back(piece.corners[i]);
        if ((heights[i] < 0.0) == (heights[k] < 0.0)) continue;
        const double t = heights[i] / (heights[i] - heights[k]);
        const Vec3 crossing = piece.corners[i] + t * (piece.corners[k] - piece.corners[i]);
        below.corners.push_back(crossing);
        above.corners.push_back(crossing);
    }
    return {below, above};
}

class Carver {
public:
    /// `kept`: receives the parts inside of the surface; may be null.
    Carver(const std::vector<Plane>& planes, const Lattice& lattice, std::vector<Cell>& carved,
           std::vector<ConvexPolytope>* kept)
        : planes_(planes), lattice_(lattice), carved_(carved), kept_(kept) {}

    void carve(const ConvexPolytope& part, std::vector<Piece> pieces) {
        const std::optional<Plane> median =
            pieces.size() > kFewPolygons ? median_plane(part, pieces) : std::nullopt;
        const std::size_t follows = median ? 0 : best_plane(pieces);
        const Plane cut = median ? *median : planes_[pieces[follows].plane];
        std::vector<Piece> below, above;
        for (const Piece& piece : pieces) {
            if (!median && piece.plane == pieces[follows].plane) continue;
            auto [b, a] = split(piece, cut);
            if (b.corners.size() >= 3) below.push_back(std::move(b));
            if (a.corners.size() >= 3) above.push_back(std::move(a));
        }
        for (const bool is_above : {false, true}) {
            const auto half = part.clip(is_above ? cut.opposite() : cut);
            if (!half) continue;
            std::vector<Piece>& its_pieces = is_above ? above : below;
            if (!its_pieces.empty()) {
                carve(*half, std::exchange(its_pieces, {}));
            } else if (median ? is_outside(*half, pieces) : is_above) {
                add(*half);
            } else if (kept_) {
                kept_->push_back(*half);
            }
        }
    }

    /// Returns the volume in cubic lattice units.
    double carved_volume() const { return volume_; }

private:
    void add(const ConvexPolytope& part) {
        volume_ += part.volume();
        Cell cell;
        for (const auto& facet : part.facets())
            cell.planes.push_back(facet.plane);
        cell.bounds = {lattice_.to_mm(part.bounds().min), lattice_.to_mm(part.bounds().max)};
        carved_.push_back(std::move(cell));
    }

    // Returns a plane perpendicular to the longest side; empty if the plane would separate little.
    // The plane is 8 units away from the median, so that it is not within the thickness of a
    // surface at the median, and at an integer: half-integers are for boxes of the tree.
    static std::optional<Plane> median_plane(const ConvexPolytope& part,
                                             const std::vector<Piece>& pieces) {
        const Vec3 size = part.bounds().size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::vector<double> middles;
        middles.reserve(pieces.size());
        for (const Piece& piece : pieces)
            middles.push_back(mean(piece.corners)[axis]);
        std::nth_element(middles.begin(),
                         middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2),
                         middles.end());
        const auto d = static_cast<std::int64_t>(std::floor(middles[middles.size() / 2])) + 8;
        std::size_t crossed = 0;
        std::size_t below = 0;
        for (const Piece& piece : pieces) {
            bool is_below = false;
            bool is_above = false;
            for (const Vec3& p : piece.corners)
                (p[axis] < static_cast<double>(d) ? is_below : is_above) = true;
            crossed += is_below && is_above ? 1 : 0;
            below += is_below ? 1 : 0;
        }
        const std::size_t above = pieces.size() - below + crossed;
        if (4 * std::max(below, above) > 3 * pieces.size()) return std::nullopt;
        return Plane{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0, d};
    }

    // Returns the piece whose plane splits the fewest pieces, of the largest pieces; the largest
    // among equals.
    std::size_t best_plane(const std::vector<Piece>& pieces) const {
        std::vector<std::pair<double, std::size_t>> largest;
        for (std::size_t i = 0; i < pieces.size(); ++i)
            largest.emplace_back(-norm(area_vector(pieces[i].corners)), i);
        const std::size_t count = std::min(kCandidates, largest.size());
        std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(count),
                          largest.end());
        std::size_t best = largest[0].second;
        std::size_t fewest = pieces.size() + 1;
        for (std::size_t k = 0; k < count; ++k) {
            const Plane& plane = planes_[pieces[largest[k].second].plane];
            std::size_t crossed = 0;
            for (const Piece& piece : pieces) {
                bool is_below = false;
                bool is_above = false;
                for (const Vec3& p : piece.corners) {
                    const double h = height(plane, p);
                    is_below = is_below || h < -kThickness;
                    is_above = is_above || h > kThickness;
                }
                crossed += is_below && is_above ? 1 : 0;
            }
            if (crossed >= fewest) continue;
            fewest = crossed;
            best = largest[k].second;
        }
        return best;
    }

    // True if a part of the space around the pieces is outside. The part contains no piece. The
    // first piece on the way from the part to some piece decides, by the side that faces the part.
    // Among several ways, the way that meets a piece farthest from the piece's border decides.
    bool is_outside(const ConvexPolytope& part, const std::vector<Piece>& pieces) const {
        const Vec3 from = part.bounds().centre();
        std::vector<Vec3> corners;
        for (const ExactPoint& p : part.vertices())
            corners.push_back(p.approx);
        const Vec3 start = corners.empty() ? from : mean(corners);
        double surest = -1.0;
        bool result = true;
        const std::size_t step = std::max<std::size_t>(1, pieces.size() / kCandidates);
        for (std::size_t i = 0; i < pieces.size(); i += step) {
            const Vec3 way = mean(pieces[i].corners) - start;
            double nearest = 2.0;
            double sure = 0.0;
            bool outside = true;
            for (const Piece& piece : pieces) {
                const Plane& plane = planes_[piece.plane];
                const double slope = dot(unit_normal(plane), way);
                const double t = -height(plane, start) / slope;
                if (!(t > 0.0 && t < nearest)) continue;
                // Distance from the piece's border, relative to the piece's size.
                const double inside = depth(piece, start + t * way);
                if (inside < 0.0) continue;
                nearest = t;
                sure = std::min(inside, std::abs(slope) / norm(way));
                outside = slope < 0.0;
            }
            if (nearest > 1.5 || sure <= surest) continue;
            surest = sure;
            result = outside;
        }
        return result;
    }

    // Returns the distance of a point in the piece's plane from the piece's border, relative to the
    // piece's size; negative outside.
    static double depth(const Piece& piece, Vec3 p) {
        const Vec3 area = area_vector(piece.corners);
        const double size = std::sqrt(norm(area));
        const Vec3 normal = normalized(area);
        double least = Box::kInf;
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            const Vec3 tail = piece.corners[i];
            const Vec3 along = piece.corners[(i + 1) % piece.corners.size()] - tail;
            if (norm(along) == 0.0) continue;
            least = std::min(least, dot(cross(normal, normalized(along)), p - tail));
        }
        return least / size;
    }

    const std::vector<Plane>& planes_;
    const Lattice& lattice_;
    std::vector<Cell>& carved_;
    std::vector<ConvexPolytope>* kept_;
    double volume_ = 0.0;
};

// Returns the components that are connected by corners.
std::vector<TriangleMesh> surfaces_of(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> lead(mesh.vertices.size());
    std::iota(lead.begin(), lead.end(), 0U);
    const auto leader = [&lead](std::uint32_t v) {
        while (lead[v] != v)
            v = lead[v] = lead[lead[v]];
        return v;
    };
    for (const auto& t : mesh.triangles) {
        lead[leader(t[1])] = leader(t[0]);
        lead[leader(t[2])] = leader(t[0]);
    }
    constexpr std::uint32_t kNone = 0xffffffffU;
    std::vector<TriangleMesh> surfaces;
    std::vector<std::uint32_t> surface(lead.size(), kNone), number(lead.size(), kNone);
    for (const auto& t : mesh.triangles) {
        std::uint32_t& at = surface[leader(t[0])];
        if (at == kNone) {
            at = static_cast<std::uint32_t>(surfaces.size());
            surfaces.emplace_back();
        }
        TriangleMesh& into = surfaces[at];
        auto corners = t;
        for (std::uint32_t& v : corners) {
            if (number[v] == kNone) {
                number[v] = static_cast<std::uint32_t>(into.vertices.size());
                into.vertices.push_back(mesh.vertices[v]);
            }
            v = number[v];
        }
        into.triangles.push_back(corners);
    }
    return surfaces;
}

Shape carve(const TriangleMesh& mesh, const Lattice& lattice, std::vector<ConvexPolytope>* kept) {
    Shape shape;
    shape.lattice = lattice;
    std::vector<LatticePoint> points;
    LatticePoint min{}, max{};
    for (const Vec3& v : mesh.vertices) {
        const LatticePoint p = lattice.round(v);
        if (points.empty()) min = max = p;
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
        points.push_back(p);
    }
    std::optional<Cell> hull;
    if (!points.empty()) hull = convex_hull(points, lattice, kStockOrigin);
    if (!hull) throw std::invalid_argument("it encloses no volume");
    shape.outer = hull->planes.size() <= kMostOuterPlanes ? *hull : box_cell(min, max, lattice);
    const auto body = ConvexPolytope::of(shape.outer, lattice);
    if (!body) throw std::invalid_argument("it encloses no volume");

    const Planes planes(points, mesh.triangles);
    std::vector<Piece> pieces;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (planes.plane_of(t) == Planes::kNone) continue;
        Piece piece{planes.plane_of(t), planes.corners(t)};
        // There is no space to carve beyond a piece in a facet of the hull.
        const bool is_in_hull = std::any_of(
            body->facets().begin(), body->facets().end(), [&](const ConvexPolytope::Facet& facet) {
                return std::all_of(piece.corners.begin(), piece.corners.end(), [&](const Vec3& p) {
                    return height(facet.plane, p) >= -kThickness;
                });
            });
        if (!is_in_hull) pieces.push_back(std::move(piece));
    }
    Carver carver(planes.all(), lattice, shape.carved, kept);
    if (pieces.empty() && kept) kept->push_back(*body);
    if (!pieces.empty()) carver.carve(*body, std::move(pieces));

    // If bodies overlap or a surface crosses itself, the side of a facet does not imply outside,
    // and the volumes differ.
    double volume = 0.0;
    double area = 0.0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corners = planes.corners(t);
        const Vec3 n = area_vector(corners);
        volume += dot(n, corners[0] - body->bounds().min) / 3.0;
        area += norm(n);
    }
    const double difference = body->volume() - carver.carved_volume() - volume;
    if (std::abs(difference) > 2.0 * kThickness * area + 1e-9 * body->volume()) {
        throw std::invalid_argument("its surface crosses itself, or bodies of it overlap");
    }
    return shape;
}

}  // namespace

Shape shape_of(const TriangleMesh& mesh, const Lattice& lattice) {
    return carve(mesh, lattice, nullptr);
}

std::vector<ConvexPolytope> convex_pieces(const TriangleMesh& mesh, const Lattice& lattice) {
    std::vector<ConvexPolytope> pieces;
    try {
        carve(mesh, lattice, &pieces);
        return pieces;
    } catch (const std::invalid_argument&) {
        // Overlapping bodies are not one shape, but each may be a shape. Surfaces with cavities are
        // not.
        const std::vector<TriangleMesh> bodies = surfaces_of(mesh);
        const bool are_bodies = std::ranges::all_of(
            bodies, [](const TriangleMesh& body) { return volume(body) > 0.0; });
        if (bodies.size() < 2 || !are_bodies) throw;
        pieces.clear();
        for (const TriangleMesh& body : bodies)
            carve(body, lattice, &pieces);
        return pieces;
    }
}

std::unique_ptr<WorkpieceModel> create(const WorkpieceModel& prototype, const Shape& shape) {
    auto part = prototype.create(shape.outer, shape.lattice);
    part->subtract_unmeasured(shape.carved);
    return part;
}

Placement Placement::turned(int axis, int quarters) const {
    const auto u = static_cast<std::size_t>((axis + 1) % 3);
    const auto v = static_cast<std::size_t>((axis + 2) % 3);
    Placement result = *this;
    for (int i = 0; i < ((quarters % 4) + 4) % 4; ++i) {
        const auto was_u = result.rows[u];
        for (std::size_t k = 0; k < 3; ++k) {
            result.rows[u][k] = -result.rows[v][k];
            result.rows[v][k] = was_u[k];
        }
        std::swap(u == 0   ? result.shift.x
                  : u == 1 ? result.shift.y
                           : result.shift.z,
                  v == 0   ? result.shift.x
                  : v == 1 ? result.shift.y
                           : result.shift.z);
        auto& moved = u == 0 ? result.shift.x : u == 1 ? result.shift.y : result.shift.z;
        moved = -moved;
    }
    return result;
}

namespace {

Cell placed(const Cell& cell, const Placement& placement, const Lattice& lattice) {
    const auto& rows = placement.rows;
    Cell result = cell;
    result.normals.reset();
    const LatticePoint s = placement.shift;
    for (Plane& plane : result.planes) {
        const std::array<std::int32_t, 3> n{plane.nx, plane.ny, plane.nz};
        std::array<std::int32_t, 3> m{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k)
                m[i] += rows[i][k] * n[k];
        }
        const std::int64_t d = plane.d + std::int64_t{m[0]} * s.x + std::int64_t{m[1]} * s.y +
                               std::int64_t{m[2]} * s.z;
        plane = {m[0], m[1], m[2], d};
    }
    result.bounds = {};
    for (const Vec3 corner : {cell.bounds.min, cell.bounds.max}) {
        Vec3 moved;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                moved[i] +=
                    rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] * corner[k];
            }
        }
        result.bounds.add(moved + lattice.to_mm(s));
    }
    return result;
}

}  // namespace

Shape placed(const Shape& shape, const Placement& placement) {
    Shape result;
    result.lattice = shape.lattice;
    result.assumed = shape.assumed;
    result.sources = shape.sources;
    result.outer = placed(shape.outer, placement, shape.lattice);
    constexpr double kReach = static_cast<double>(std::int64_t{1} << kCoordinateBits);
    for (int i = 0; i < 3; ++i) {
        const double reach =
            std::max(std::abs(result.outer.bounds.min[i]), std::abs(result.outer.bounds.max[i]));
        if (reach > kReach * shape.lattice.unit_mm) {
            throw std::invalid_argument("its lattice does not reach as far from the origin");
        }
    }
    result.carved.reserve(shape.carved.size());
    for (const Cell& cell : shape.carved)
        result.carved.push_back(placed(cell, placement, shape.lattice));
    return result;
}

}  // namespace ncsim::cda
