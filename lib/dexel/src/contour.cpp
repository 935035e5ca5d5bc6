// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dual contouring in three steps:
//
//  1. mark     corners of the grid in the material, a bit each, and cells with both kinds
//  2. place    the vertices of the surface, cell by cell
//  3. facets   around each crossed edge of the grid, from the cell that begins there; along walls
//              parallel to z, one facet for all edges between vertices that are kept
#include "contour.h"

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/base/parallel.h"

#include "cell_components.h"
#include "crossings.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ncsim::dexel {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Least-squares solver: the point nearest to the planes, and to the mean of the points in
// undetermined directions.
class Nearest {
public:
    void add(Vec3 point, Vec3 normal) {
        points_[count_] = point;
        normals_[count_++] = normal;
    }
    Vec3 solve() const {
        Vec3 mean;
        for (std::size_t i = 0; i < count_; ++i)
            mean = mean + points_[i];
        mean = (1.0 / static_cast<double>(count_)) * mean;
        // (Σ n nᵀ + w) x = Σ n (n · p), relative to the mean.
        constexpr double kWeight = 1e-3;
        double xx = kWeight, xy = 0, xz = 0, yy = kWeight, yz = 0, zz = kWeight;
        Vec3 b;
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec3& n = normals_[i];
            xx += n.x * n.x, xy += n.x * n.y, xz += n.x * n.z;
            yy += n.y * n.y, yz += n.y * n.z, zz += n.z * n.z;
            b = b + dot(n, points_[i] - mean) * n;
        }
        const Vec3 r0{xx, xy, xz}, r1{xy, yy, yz}, r2{xz, yz, zz};
        const double det = dot(r0, cross(r1, r2));
        return mean +
               (1.0 / det) * (b.x * cross(r1, r2) + b.y * cross(r2, r0) + b.z * cross(r0, r1));
    }

private:
    std::array<Vec3, 12> points_, normals_;  // one per edge of the cell
    std::size_t count_ = 0;
};

Place corner_at(const Place& cell, int corner) {
    return {cell[0] + static_cast<std::size_t>(corner & 1),
            cell[1] + static_cast<std::size_t>(corner >> 1 & 1),
            cell[2] + static_cast<std::size_t>(corner >> 2 & 1)};
}

class Contouring {
public:
    Contouring(const Grid& grid, const std::array<Rays, 3>& rays, const CuttingCell& stock,
               std::size_t threads)
        : grid_(grid), threads_(threads), crossings_(grid, rays, stock, threads) {}

    void run() {
        place_corners();
        // A closed surface has about two triangles per vertex.
        triangles.reserve(2 * points.size());
        origins.reserve(2 * points.size());
        for (std::size_t x = 0; x < grid_.axes[0].cells(); ++x) {
            for (std::size_t y = 0; y < grid_.axes[1].cells(); ++y) {
                for (std::size_t i = column_[column(x, y)]; i < column_[column(x, y) + 1]; ++i)
                    add_facets({x, y, cells_[i].z}, cells_[i].inside);
            }
        }
    }

    // Builds the polygons of each cell, with a vertex on each crossed edge of the grid.
    void march() {
        place_corners();
        points.clear();
        std::unordered_map<std::uint64_t, std::uint32_t> on_edge;
        const auto corner_on = [&](const Place& from, std::size_t axis) {
            const std::uint64_t key =
                3 * ((from[0] * grid_.axes[1].corners() + from[1]) * grid_.axes[2].corners() +
                     from[2]) +
                axis;
            const auto [at, is_new] =
                on_edge.try_emplace(key, static_cast<std::uint32_t>(points.size()));
            if (is_new) {
                Vec3 point = crossings_.point_of(from);
                point[static_cast<int>(axis)] = crossings_.at(from, axis).at;
                points.push_back(point);
            }
            return at->second;
        };
        for (std::size_t x = 0; x < grid_.axes[0].cells(); ++x) {
            for (std::size_t y = 0; y < grid_.axes[1].cells(); ++y) {
                for (std::size_t i = column_[column(x, y)]; i < column_[column(x, y) + 1]; ++i) {
                    const Place cell{x, y, cells_[i].z};
                    for (const auto& loop : loops_of(cells_[i].inside)) {
                        std::vector<std::uint32_t> corners;
                        corners.reserve(loop.size());
                        for (const int edge : loop)
                            corners.push_back(corner_on(corner_at(cell, first_corner(edge)),
                                                        static_cast<std::size_t>(edge / 4)));
                        const Place from = corner_at(cell, first_corner(loop.front()));
                        const cda::Origin origin =
                            crossings_.at(from, static_cast<std::size_t>(loop.front() / 4)).origin;
                        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
                            triangles.push_back({corners[0], corners[k], corners[k + 1]});
                            origins.push_back(origin);
                        }
                    }
                }
            }
        }
    }

    std::vector<Vec3> points;  // units
    std::vector<Triangle> triangles;
    std::vector<cda::Origin> origins;  // origins of triangles

private:
    struct MixedCell {
        std::uint32_t z;
        std::uint32_t first_point;
        std::uint8_t inside;
        bool has_equal_ends;      // The edges above are crossed as those below, and no others.
        bool is_dropped = false;  // The vertex is on the line between those above and below.
    };

    std::size_t column(std::size_t x, std::size_t y) const { return x * grid_.axes[1].cells() + y; }

    // --- Step 2: place ---

    struct Slab {
        std::vector<MixedCell> cells;
        std::vector<std::size_t> counts;  // cells per column
        std::vector<Vec3> points;
    };

    // Cache of crossings on the edges of a slab: four cells ask for edges along x, two for all
    // other edges. Entries stay until the second next row of columns reaches the same heights.
    class KnownCrossings {
    public:
        explicit KnownCrossings(std::size_t heights) : heights_(heights), all_(12 * heights) {}

        template <class Find>
        const Crossing& get(const Place& from, std::size_t axis, const Find& find) {
            Known& known =
                all_[((axis * 2 + (from[0] & 1)) * 2 + (from[1] & 1)) * heights_ + from[2]];
            if (known.row != from[1] + 1) known = {from[1] + 1, find()};
            return known.crossing;
        }

    private:
        struct Known {
            std::size_t row = 0;  // row + 1; 0: empty
            Crossing crossing;
        };
        std::size_t heights_;
        std::vector<Known> all_;
    };

    void place_corners() {
        column_.assign(grid_.axes[0].cells() * grid_.axes[1].cells() + 1, 0);
        make_in_parallel(
            threads_, grid_.axes[0].cells(), [&](std::size_t x) { return slab(x); },
            [&](std::size_t x, const Slab& slab) {
                for (std::size_t y = 0; y < slab.counts.size(); ++y)
                    column_[column(x, y) + 1] = column_[column(x, y)] + slab.counts[y];
                for (MixedCell cell : slab.cells) {
                    cell.first_point += static_cast<std::uint32_t>(points.size());
                    cells_.push_back(cell);
                }
                points.insert(points.end(), slab.points.begin(), slab.points.end());
            });
    }

    Slab slab(std::size_t x) const {
        Slab slab;
        KnownCrossings known(grid_.axes[2].corners());
        for (std::size_t y = 0; y < grid_.axes[1].cells(); ++y) {
            const std::size_t before = slab.cells.size();
            const std::array<const std::uint64_t*, 4> columns{
                crossings_.signs().column(x, y), crossings_.signs().column(x + 1, y),
                crossings_.signs().column(x, y + 1), crossings_.signs().column(x + 1, y + 1)};
            std::uint64_t any_below = 0, all_below = 0;  // last corner of the previous word
            for (std::size_t w = 0; w < crossings_.signs().words(); ++w) {
                const std::uint64_t any =
                    columns[0][w] | columns[1][w] | columns[2][w] | columns[3][w];
                const std::uint64_t all =
                    columns[0][w] & columns[1][w] & columns[2][w] & columns[3][w];
                // Bit k is for the cell whose upper corners are bit k of the word.
                const std::uint64_t has_some = any | any << 1 | any_below;
                const std::uint64_t has_all = all & (all << 1 | all_below);
                for (std::uint64_t mixed = has_some & ~has_all; mixed != 0; mixed &= mixed - 1) {
                    const std::size_t upper =
                        64 * w + static_cast<std::size_t>(std::countr_zero(mixed));
                    if (upper > 0 && upper < grid_.axes[2].corners())
                        add_cell(slab, known, {x, y, upper - 1});
                }
                any_below = any >> 63;
                all_below = all >> 63;
            }
            slab.counts.push_back(slab.cells.size() - before);
            drop_vertices_of_walls(slab, before);
        }
        return slab;
    }

    // Drops the vertices in the middle of walls parallel to z, in the last column of the slab,
    // whose cells begin at `first`.
    static void drop_vertices_of_walls(Slab& slab, std::size_t first) {
        const auto is_above = [&](const MixedCell& cell, const MixedCell& below) {
            const Vec3 &p = slab.points[cell.first_point], &q = slab.points[below.first_point];
            return cell.z == below.z + 1 && cell.inside == below.inside && p.x == q.x && p.y == q.y;
        };
        for (std::size_t i = first + 1; i + 1 < slab.cells.size(); ++i) {
            MixedCell& cell = slab.cells[i];
            cell.is_dropped = cell.has_equal_ends && is_above(cell, slab.cells[i - 1]) &&
                              is_above(slab.cells[i + 1], cell);
        }
        if (first == slab.cells.size()) return;
        std::uint32_t kept = slab.cells[first].first_point;
        for (std::size_t i = first; i < slab.cells.size(); ++i) {
            MixedCell& cell = slab.cells[i];
            const std::uint32_t from = std::exchange(cell.first_point, kept);
            if (cell.is_dropped) continue;
            for (std::uint32_t k = 0; k < components_of(cell.inside).count; ++k)
                slab.points[kept++] = slab.points[from + k];
        }
        slab.points.resize(kept);
    }

    // True if the crossed edges of a cell are in pairs of the same crossing, one above the other.
    bool has_equal_ends(KnownCrossings& known, const Place& at, std::uint8_t inside) const {
        constexpr int kLower = 15;
        if ((inside & kLower) != inside >> 4 || components_of(inside).count != 1) return false;
        constexpr std::array<std::pair<int, int>, 4> kPairs{std::pair{0, 2}, std::pair{1, 3},
                                                            std::pair{4, 5}, std::pair{6, 7}};
        return std::ranges::all_of(kPairs, [&](const auto& pair) {
            const auto is_crossed = [&](int e) {
                return components_of(inside).of_edge[static_cast<std::size_t>(e)] !=
                       CellComponents::kNone;
            };
            const auto crossing = [&](int e) -> const Crossing& {
                const Place from = corner_at(at, first_corner(e));
                const auto axis = static_cast<std::size_t>(e / 4);
                return known.get(from, axis, [&] { return crossings_.at(from, axis); });
            };
            return !is_crossed(pair.first) || crossing(pair.first) == crossing(pair.second);
        });
    }

    void add_cell(Slab& slab, KnownCrossings& known, const Place& at) const {
        std::uint8_t inside = 0;
        for (int corner = 0; corner < 8; ++corner) {
            if (crossings_.signs()(corner_at(at, corner)))
                inside = static_cast<std::uint8_t>(inside | 1 << corner);
        }
        const CellComponents& components = components_of(inside);
        slab.cells.push_back({static_cast<std::uint32_t>(at[2]),
                              static_cast<std::uint32_t>(slab.points.size()), inside,
                              has_equal_ends(known, at, inside)});
        for (std::uint8_t piece = 0; piece < components.count; ++piece) {
            Nearest nearest;
            for (int e = 0; e < 12; ++e) {
                if (components.of_edge[static_cast<std::size_t>(e)] != piece) continue;
                const auto axis = static_cast<std::size_t>(e / 4);
                const Place from = corner_at(at, first_corner(e));
                const Crossing& crossing =
                    known.get(from, axis, [&] { return crossings_.at(from, axis); });
                Vec3 point = crossings_.point_of(from);
                point[e / 4] = crossing.at;
                nearest.add(point, crossing.normal);
            }
            slab.points.push_back(clamped(nearest.solve(), at));
        }
    }

    // Clamps to the interior of the cell, so that vertices of two cells never coincide.
    Vec3 clamped(Vec3 p, const Place& cell) const {
        constexpr double kMargin = 1e-3;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double low = grid_.axes[a].at[cell[a]];
            const double high = grid_.axes[a].at[cell[a] + 1];
            const double margin = kMargin * (high - low);
            p[axis] = std::clamp(p[axis], low + margin, high - margin);
        }
        return p;
    }

    // --- Step 3: facets ---

    const MixedCell& cell_at(const Place& at) const {
        const auto begin =
            cells_.begin() + static_cast<std::ptrdiff_t>(column_[column(at[0], at[1])]);
        const auto end =
            cells_.begin() + static_cast<std::ptrdiff_t>(column_[column(at[0], at[1]) + 1]);
        return *std::lower_bound(begin, end, at[2],
                                 [](const MixedCell& c, std::size_t z) { return c.z < z; });
    }

    void add_facets(const Place& at, std::uint8_t inside) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool from_in = (inside & 1) != 0;
            const bool to_in = (inside >> (1 << axis) & 1) != 0;
            if (from_in == to_in) continue;
            add_facet(at, axis, from_in);
        }
    }

    // Adds the facet of the four cells around the edge, counter-clockwise about the edge's axis.
    // The surface faces along the axis if the edge begins in the material.
    void add_facet(const Place& corner, std::size_t axis, bool faces_along) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        // Offset of the corner in each cell where the edge begins.
        constexpr std::array<std::pair<int, int>, 4> kOffsets{std::pair{0, 0}, std::pair{1, 0},
                                                              std::pair{1, 1}, std::pair{0, 1}};
        std::array<Place, 4> cells;
        std::array<std::uint32_t, 4> vertices{};
        std::array<bool, 4> is_dropped{};
        for (std::size_t i = 0; i < 4; ++i) {
            cells[i] = corner;
            cells[i][u] -= static_cast<std::size_t>(kOffsets[i].first);
            cells[i][v] -= static_cast<std::size_t>(kOffsets[i].second);
            const MixedCell& cell = cell_at(cells[i]);
            const int begins = kOffsets[i].first << u | kOffsets[i].second << v;
            const auto edge = static_cast<std::size_t>(edge_from(begins, static_cast<int>(axis)));
            vertices[i] = cell.first_point + components_of(cell.inside).of_edge[edge];
            is_dropped[i] = cell.is_dropped;
        }
        const cda::Origin origin = crossings_.origin_at(corner, axis);
        std::array<std::optional<std::uint32_t>, 4> middles;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            middles[i] =
                middle_of(corner, axis, cells[i], cells[next], vertices[i], vertices[next]);
        }
        const bool any_dropped = std::ranges::find(is_dropped, true) != is_dropped.end();
        if (axis != 2 && (any_dropped || !strips_[axis].is_empty())) {
            add_to_strip(strips_[axis], vertices, is_dropped, middles, u == 2, faces_along, origin);
            return;
        }
        add_polygon(vertices, middles, faces_along, origin);
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, cda::Origin origin) {
        triangles.push_back({a, b, c});
        origins.push_back(origin);
    }

    // Adds the facet with four vertices and the middle vertices after them.
    void add_polygon(const std::array<std::uint32_t, 4>& vertices,
                     const std::array<std::optional<std::uint32_t>, 4>& middles, bool faces_along,
                     cda::Origin origin) {
        std::array<std::uint32_t, 8> loop{};
        std::size_t count = 0, first_middle = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            loop[count++] = vertices[i];
            if (!middles[i]) continue;
            if (first_middle == 0) first_middle = count;
            loop[count++] = *middles[i];
        }
        // The fan starts at a middle vertex, so that no triangle has an edge between the vertices
        // on both sides of the middle vertex.
        const auto begin = loop.begin(), end = begin + static_cast<std::ptrdiff_t>(count);
        std::rotate(begin, begin + static_cast<std::ptrdiff_t>(first_middle), end);
        if (!faces_along) std::reverse(begin + 1, end);
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
            add_triangle(loop[a], loop[b], loop[c], origin);
        };
        if (count > 4) {
            for (std::size_t i = 1; i + 1 < count; ++i)
                add(0, i, i + 1);
            return;
        }
        const double here = norm(points[loop[2]] - points[loop[0]]);
        const double there = norm(points[loop[3]] - points[loop[1]]);
        if (here <= there) {
            add(0, 1, 2);
            add(0, 2, 3);
        } else {
            add(1, 2, 3);
            add(1, 3, 0);
        }
    }

    // Part of a wall between two columns of cells: the vertices of each column, upwards.
    struct Strip {
        std::array<std::vector<std::uint32_t>, 2> sides;
        bool is_empty() const { return sides[0].empty(); }
        void clear() { sides[0].clear(), sides[1].clear(); }
    };

    // Adds the facet of a crossed edge to the strip, and writes the strip if its upper vertices are
    // kept.
    void add_to_strip(Strip& strip, const std::array<std::uint32_t, 4>& vertices,
                      const std::array<bool, 4>& is_dropped,
                      const std::array<std::optional<std::uint32_t>, 4>& middles, bool z_is_u,
                      bool faces_along, cda::Origin origin) {
        // Vertices counter-clockwise about the edge; those of the cells below are 1 and 2 if z is
        // u, otherwise 2 and 3. On the first side they are before those above.
        struct Side {
            std::size_t below, above, between;
        };
        const std::array<Side, 2> sides = z_is_u ? std::array{Side{2, 3, 2}, Side{1, 0, 0}}
                                                 : std::array{Side{3, 0, 3}, Side{2, 1, 1}};
        const bool is_first = strip.is_empty();
        for (std::size_t s = 0; s < 2; ++s) {
            auto& side = strip.sides[s];
            if (is_first) side.push_back(vertices[sides[s].below]);
            if (const auto& middle = middles[sides[s].between]) side.push_back(*middle);
            if (!is_dropped[sides[s].above]) side.push_back(vertices[sides[s].above]);
        }
        if (is_dropped[sides[0].above] || is_dropped[sides[1].above]) return;
        const auto& [a, b] = strip.sides;
        std::size_t i = 0, j = 0;
        while (i + 1 < a.size() || j + 1 < b.size()) {
            const bool on_a =
                j + 1 == b.size() || (i + 1 < a.size() && points[a[i + 1]].z <= points[b[j + 1]].z);
            const std::uint32_t next = on_a ? a[i + 1] : b[j + 1];
            if (faces_along) {
                add_triangle(a[i], next, b[j], origin);
            } else {
                add_triangle(a[i], b[j], next, origin);
            }
            ++(on_a ? i : j);
        }
        strip.clear();
    }

    // Returns the separate vertex between two vertices, if all four edges of the face between two
    // cells are crossed and all belong to the same two vertices; this edge shares the vertex with a
    // second edge.
    std::optional<std::uint32_t> middle_of(const Place& corner, std::size_t axis, const Place& a,
                                           const Place& b, std::uint32_t vertex_a,
                                           std::uint32_t vertex_b) {
        // The face is perpendicular to the axis in which the cells differ; the edge lies in the
        // face.
        std::size_t across = 0;
        while (a[across] == b[across])
            ++across;
        const std::size_t other = 3 - axis - across;
        Place first = a;  // first corner of the face
        first[across] = std::max(a[across], b[across]);
        std::array<bool, 4> in{};  // first, along axis, along other, both
        for (std::size_t i = 0; i < 4; ++i) {
            Place p = first;
            p[axis] += i & 1;
            p[other] += i >> 1;
            in[i] = crossings_.signs()(p);
        }
        if (in[0] != in[3] || in[1] != in[2] || in[0] == in[1]) return std::nullopt;
        const auto all_are = [&](const Place& at, std::uint32_t vertex) {
            const MixedCell& cell = cell_at(at);
            const int side = at[across] == first[across] ? 0 : 1 << across;
            const CellComponents& components = components_of(cell.inside);
            const int x = static_cast<int>(axis), y = static_cast<int>(other);
            for (const int edge : {edge_from(side, x), edge_from(side + (1 << y), x),
                                   edge_from(side, y), edge_from(side + (1 << x), y)}) {
                if (cell.first_point + components.of_edge[static_cast<std::size_t>(edge)] != vertex)
                    return false;
            }
            return true;
        };
        if (!all_are(a, vertex_a) || !all_are(b, vertex_b)) return std::nullopt;
        // The corner in the material at an end of the edge identifies the pair of edges.
        Place inner = corner;
        if (!crossings_.signs()(inner)) ++inner[axis];
        const auto [at, is_new] = middles_.try_emplace(
            {std::min(vertex_a, vertex_b), std::max(vertex_a, vertex_b), inner},
            static_cast<std::uint32_t>(points.size()));
        if (is_new) {
            const Vec3 between = 0.5 * (points[vertex_a] + points[vertex_b]);
            points.push_back(between + 0.25 * (crossings_.point_of(inner) - between));
        }
        return at->second;
    }

    const Grid& grid_;
    std::size_t threads_;
    Crossings crossings_;
    std::vector<std::size_t> column_;  // index in cells_ of each column's first cell
    std::vector<MixedCell> cells_;
    std::array<Strip, 2> strips_;  // The wall across edges along x and along y, unfinished.
    std::map<std::tuple<std::uint32_t, std::uint32_t, Place>, std::uint32_t> middles_;
};

}  // namespace

cda::Boundary contour(const Grid& grid, const std::array<Rays, 3>& rays, const CuttingCell& stock,
                      const cda::Lattice& lattice, std::size_t threads, Mesher mesher) {
    Contouring contouring(grid, rays, stock, threads);
    if (mesher == Mesher::MarchingCubes) {
        contouring.march();
    } else {
        contouring.run();
    }
    cda::Boundary boundary;
    boundary.vertices.reserve(contouring.points.size());
    for (const Vec3& p : contouring.points)
        boundary.vertices.push_back(lattice.to_mm(p));
    DisjointSets shells(contouring.points.size());
    for (const auto& [a, b, c] : contouring.triangles) {
        shells.unite(a, b);
        shells.unite(b, c);
    }
    constexpr auto kUnnumbered = ~std::uint32_t{0};
    std::vector<std::uint32_t> number(contouring.points.size(), kUnnumbered);
    boundary.faces.reserve(contouring.triangles.size());
    for (std::size_t t = 0; t < contouring.triangles.size(); ++t) {
        const auto& [a, b, c] = contouring.triangles[t];
        const Vec3 n = cross(boundary.vertices[b] - boundary.vertices[a],
                             boundary.vertices[c] - boundary.vertices[a]);
        cda::BoundaryFace face;
        face.normal = norm(n) > 0.0 ? normalized(n) : Vec3{0, 0, 1};
        face.offset = dot(face.normal, boundary.vertices[a]);
        face.origin = contouring.origins[t];
        face.loops.emplace_back(std::vector{a, b, c});
        std::uint32_t& shell = number[shells.find(a)];
        if (shell == kUnnumbered) shell = boundary.shells++;
        face.shell = shell;
        boundary.faces.push_back(std::move(face));
    }
    return boundary;
}

}  // namespace ncsim::dexel
