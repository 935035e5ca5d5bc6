// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares polygons in doubles with the exact polygons of polygon.h. Planes cut anywhere or meet in
// corners of the polygon.
#include "polytope/filtered_polygon.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <optional>
#include <vector>

namespace ncsim::cda {
namespace {

using test::Random;

// Returns a random plane. Many of the planes share lattice points and so meet in corners of the
// polygon.
Plane random_plane(Random& random, std::int64_t reach) {
    const std::int64_t size = random.between(0, 2) == 0 ? 2 : 1 << 24;
    Plane plane = test::random_normal(random, size);
    // The plane passes through or near a point of a coarse grid.
    const auto coordinate = [&] { return reach / 4 * random.between(-3, 3); };
    const std::int64_t x = coordinate();
    const std::int64_t y = coordinate();
    const std::int64_t z = coordinate();
    const std::int64_t off = random.between(0, 1) == 0 ? 0 : random.between(-3, 3);
    return canonical(plane.nx, plane.ny, plane.nz,
                     plane.nx * x + plane.ny * y + plane.nz * z + off);
}

struct Scene {
    std::array<std::int64_t, 3> min{}, max{};  // half units
    std::array<FilterPlane, 6> walls;
    std::vector<Plane> wall_planes;

    explicit Scene(std::int64_t reach) {
        for (std::size_t i = 0; i < 3; ++i) {
            min[i] = -2 * reach - 1;
            max[i] = 2 * reach + 1;
            std::array<std::int32_t, 3> n{};
            n[i] = 2;
            walls[2 * i] = FilterPlane({-n[0], -n[1], -n[2], -min[i]});
            walls[2 * i + 1] = FilterPlane({n[0], n[1], n[2], max[i]});
            wall_planes.push_back(walls[2 * i].exact);
            wall_planes.push_back(walls[2 * i + 1].exact);
        }
    }

    // Returns the section of the box in integers: a quadrilateral of four walls, clipped by the
    // remaining two walls.
    std::optional<ConvexPolygon> section(const Plane& plane) const {
        ConvexPolygon polygon;
        polygon.plane = plane;
        const std::array<std::int32_t, 3> n{plane.nx, plane.ny, plane.nz};
        std::size_t axis = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            if (std::abs(n[i]) > std::abs(n[axis])) axis = i;
        }
        std::size_t u = (axis + 1) % 3;
        std::size_t v = (axis + 2) % 3;
        if (n[axis] < 0) std::swap(u, v);
        polygon.edges = {walls[2 * v].exact, walls[2 * u + 1].exact, walls[2 * v + 1].exact,
                         walls[2 * u].exact};
        for (std::size_t i = 0; i < 4; ++i)
            polygon.corners.push_back(*meet(plane, polygon.edges[(i + 3) % 4], polygon.edges[i]));
        return below(polygon, std::vector<Plane>{walls[2 * axis].exact, walls[2 * axis + 1].exact});
    }
};

TEST(FilteredPolygon, IsCutAsWithIntegers) {
    Random random(1);
    const std::int64_t reach = 1 << 20;
    const Scene scene(reach);
    int cut_away = 0;
    int in_corners = 0;
    for (int round = 0; round < 3000; ++round) {
        const FilterPlane own(random_plane(random, reach));
        FilteredPolygon polygon;
        std::optional<ConvexPolygon> exact = scene.section(own.exact);
        ASSERT_EQ(polygon.assign_section(own, scene.min, scene.max, scene.walls),
                  exact.has_value());
        std::deque<FilterPlane> cuts;
        for (int i = 0; i < 12 && exact; ++i) {
            FilterPlane cut(random_plane(random, reach));
            if (i % 3 == 2) {
                // Repeats the plane of an edge, or its opposite.
                const auto& edges = exact->edges;
                const Plane& a = edges[static_cast<std::size_t>(i) % edges.size()];
                cut = FilterPlane(random.between(0, 1) == 0 ? a : a.opposite());
            }
            if (cut.exact.is_parallel_to(own.exact)) continue;
            cuts.push_back(cut);
            const std::size_t before = exact->corners.size();
            exact = below(*exact, cuts.back().exact);
            ASSERT_EQ(polygon.clip(cuts.back()), exact.has_value());
            if (!exact) {
                ++cut_away;
                break;
            }
            ASSERT_EQ(polygon.size(), exact->corners.size());
            in_corners += exact->corners.size() <= before ? 1 : 0;
            // The corners are the same, perhaps in a rotated order.
            const auto is_corner = [&](const FilteredSegment& edge) {
                return std::any_of(
                    exact->corners.begin(), exact->corners.end(), [&](const ExactPoint& p) {
                        return classify_exact(p, edge.line->exact) == Side::On &&
                               classify_exact(p, edge.tail_cut->exact) == Side::On &&
                               norm(p.approx - edge.tail.p) <= 2.0 * edge.tail.error + 1e-6;
                    });
            };
            for (std::size_t k = 0; k < polygon.size(); ++k)
                ASSERT_TRUE(is_corner(polygon.edge(k)));
        }
    }
    EXPECT_GT(cut_away, 100);
    EXPECT_GT(in_corners, 100);
}

// A look at many planes gives the same results as a look at each plane.
TEST(FilteredPolygon, LooksAtManyPlanesAsAtEach) {
    Random random(2);
    const std::int64_t reach = 1 << 22;
    const Scene scene(reach);
    std::array<int, 5> seen{};
    for (int round = 0; round < 2000; ++round) {
        const FilterPlane own(random_plane(random, reach));
        FilteredPolygon polygon;
        if (!polygon.assign_section(own, scene.min, scene.max, scene.walls)) continue;
        std::deque<FilterPlane> planes;
        PlaneRows rows;
        const auto count = static_cast<std::size_t>(random.between(1, 40));
        while (rows.size() < count) {
            planes.emplace_back(random_plane(random, reach));
            if (rows.size() % 4 == 0 && !polygon.clip(planes.back())) break;
            rows.add(planes.back());
        }
        if (rows.size() < count) continue;
        FilterResults results;
        const auto begin =
            static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(count) - 1));
        polygon.classify_rows(rows, begin, count, results);
        for (std::size_t i = begin; i < count; ++i) {
            const FilterResult where = results.where[i];
            ++seen[static_cast<std::size_t>(where)];
            if (where == FilterResult::Doubtful) continue;
            ASSERT_EQ(polygon.classify(rows[i]), where == FilterResult::Below   ? 1
                                                 : where == FilterResult::Above ? -1
                                                                                : 0);
            ASSERT_EQ(results.low[i] < 0.0, where != FilterResult::Above);
            ASSERT_EQ(results.high[i] > 0.0, where != FilterResult::Below);
        }
    }
    for (const FilterResult where :
         {FilterResult::Doubtful, FilterResult::Below, FilterResult::Above, FilterResult::Across})
        EXPECT_GT(seen[static_cast<std::size_t>(where)], 100);
}

}  // namespace
}  // namespace ncsim::cda
