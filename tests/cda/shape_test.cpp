// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests stock of any shape: from meshes, in convex pieces, placed, and in files.
#include "ncsim/cda/shape.h"

#include "ncsim/cda/triangulate.h"

#include "support/rounds.h"
#include "support/scene.h"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>
#include <string>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::Random;

// Returns a block after some cuts. Its surface is not convex.
TreeCda cut_block(std::uint64_t seed, bool oblique) {
    Random random(seed);
    constexpr int n = test::UnitCubes::kSize;
    TreeCda part(mm_box(0, 0, 0, n, n, n), kLattice, {40, 1});
    for (std::uint32_t i = 0; i < 6; ++i) {
        if (oblique) {
            LatticePoint centre = test::random_point(random, n * 50000);
            centre = centre + LatticePoint{n * 50000, n * 50000, n * 50000};
            part.subtract(test::random_hull(random, centre, n * 30000, 10, Origin{i + 1}));
        } else {
            const auto b = test::random_grid_box(random);
            part.subtract(mm_box(b[0], b[1], b[2], b[3], b[4], b[5], Origin{i + 1}));
        }
    }
    return part;
}

double area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        sum += 0.5 * norm(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                                mesh.vertices[t[2]] - mesh.vertices[t[0]]));
    }
    return sum;
}

std::string written(const Shape& shape) {
    std::ostringstream out;
    write_shape(out, shape);
    return out.str();
}

Shape read_back(const std::string& text) {
    std::istringstream in(text);
    return read_shape(in);
}

TEST(ShapeOf, AConvexSurfaceIsOneCell) {
    const TreeCda block(mm_box(1, 2, 3, 4, 6, 8), kLattice);
    const Shape shape = shape_of(triangulate(block.boundary()), kLattice);
    EXPECT_TRUE(shape.carved.empty());
    EXPECT_NEAR(create(block, shape)->volume(), 3.0 * 4.0 * 5.0, 1e-9);
}

TEST(ShapeOf, SurfacesOnAGridAreExact) {
    int carved = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const TreeCda part = cut_block(seed, false);
        if (part.volume() == 0.0) continue;
        const Shape shape = shape_of(triangulate(part.boundary()), kLattice);
        const auto again = create(part, shape);
        EXPECT_NEAR(again->volume(), part.volume(), 1e-9 * part.volume());
        const TriangleMesh mesh = triangulate(again->boundary());
        EXPECT_TRUE(check(mesh).is_closed());
        EXPECT_NEAR(area(mesh), area(triangulate(part.boundary())), 1e-9);
        carved += shape.carved.empty() ? 0 : 1;
    }
    EXPECT_GT(carved, 40);
}

TEST(ShapeOf, ObliqueSurfacesAreWithinTwoUnits) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const TreeCda part = cut_block(seed, true);
        const TriangleMesh mesh = triangulate(part.boundary());
        const Shape shape = shape_of(mesh, kLattice);
        const auto again = create(part, shape);
        EXPECT_NEAR(again->volume(), part.volume(), 4.0 * kLattice.unit_mm * area(mesh));
        EXPECT_TRUE(check(again->boundary()).is_closed());
        Random random(seed);
        constexpr int n = test::UnitCubes::kSize;
        const auto unit = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
        for (int i = 0; i < 300; ++i) {
            const Vec3 p{n * unit(), n * unit(), n * unit()};
            EXPECT_EQ(again->contains(p), part.contains(p)) << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
}

TEST(ShapeOf, ManyTriangles) {
    // A torus: none of its planes has the whole torus on one side.
    TriangleMesh ring;
    constexpr std::uint32_t kAround = 48;
    constexpr std::uint32_t kSection = 24;
    for (std::uint32_t i = 0; i < kAround; ++i) {
        for (std::uint32_t k = 0; k < kSection; ++k) {
            const double u = 2 * std::numbers::pi * i / kAround;
            const double v = 2 * std::numbers::pi * k / kSection;
            const double r = 20 + 6 * std::cos(v);
            ring.vertices.push_back({r * std::cos(u), r * std::sin(u), 6 * std::sin(v)});
            const auto at = [](std::uint32_t a, std::uint32_t b) {
                return (a % kAround) * kSection + b % kSection;
            };
            ring.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            ring.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    ASSERT_GT(volume(ring), 0.0);
    const TreeCda prototype;
    const Shape shape = shape_of(ring, kLattice);
    const auto part = create(prototype, shape);
    EXPECT_NEAR(part->volume(), volume(ring), 4.0 * kLattice.unit_mm * area(ring));
    EXPECT_TRUE(check(part->boundary()).is_closed());
    EXPECT_TRUE(part->contains({20, 0, 0}));
    EXPECT_FALSE(part->contains({0, 0, 0}));
    EXPECT_FALSE(part->contains({20, 0, 6.0001}));
}

// The pieces together are the body, without overlap, gap or excess.
TEST(ConvexPieces, FillTheBodyOnce) {
    std::size_t most = 0;
    for (std::uint64_t seed = 0; seed < test::rounds(60U); ++seed) {
        SCOPED_TRACE(seed);
        const TreeCda part = cut_block(seed, seed % 2 == 1);
        if (part.volume() == 0.0) continue;
        const TriangleMesh mesh = triangulate(part.boundary());
        const auto pieces = convex_pieces(mesh, kLattice);
        TreeCda rest(part);
        double sum = 0.0;
        for (const ConvexPolytope& piece : pieces) {
            sum += piece.volume() * kLattice.cubic_unit_mm3();
            Cell cell;
            for (const auto& facet : piece.facets())
                cell.planes.push_back(facet.plane);
            cell.bounds = {kLattice.to_mm(piece.bounds().min), kLattice.to_mm(piece.bounds().max)};
            rest.subtract(cell);
        }
        const double sliver = 2e-5 * area(mesh);
        EXPECT_NEAR(sum, part.volume(), sliver);
        EXPECT_LE(rest.volume(), sliver);
        most = std::max(most, pieces.size());
    }
    EXPECT_GT(most, 5U);
}

TEST(ConvexPieces, AConvexBodyIsOne) {
    const TreeCda block(mm_box(1, 2, 3, 4, 6, 8), kLattice);
    EXPECT_EQ(convex_pieces(triangulate(block.boundary()), kLattice).size(), 1U);
}

TEST(ShapeOf, RefusesASurfaceWithoutVolume) {
    TriangleMesh flat;
    flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    flat.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_THROW(shape_of(flat, kLattice), std::invalid_argument);
    EXPECT_THROW(shape_of({}, kLattice), std::invalid_argument);
}

TEST(ShapeOf, RefusesBodiesThatOverlap) {
    TriangleMesh both = triangulate(TreeCda(mm_box(0, 0, 0, 4, 4, 4), kLattice).boundary());
    const TriangleMesh other = triangulate(TreeCda(mm_box(3, 3, 3, 6, 6, 6), kLattice).boundary());
    const auto first = static_cast<std::uint32_t>(both.vertices.size());
    both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles)
        both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    EXPECT_THROW(shape_of(both, kLattice), std::invalid_argument);
    // Convex pieces of bodies that overlap are permitted.
    double volume = 0.0;
    for (const ConvexPolytope& piece : convex_pieces(both, kLattice))
        volume += piece.volume();
    const double unit = kLattice.unit_mm;
    EXPECT_NEAR(volume * unit * unit * unit, 64 + 27, 1e-9);
    // If a body is hollow, no pieces are made: the volume inside the second body would be
    // ambiguous.
    TriangleMesh inside_out = both;
    for (std::size_t t = inside_out.triangles.size() - other.triangles.size();
         t < inside_out.triangles.size(); ++t)
        std::swap(inside_out.triangles[t][0], inside_out.triangles[t][1]);
    EXPECT_THROW(convex_pieces(inside_out, kLattice), std::invalid_argument);
    // Disjoint bodies are two bodies of the same stock.
    for (std::size_t i = first; i < both.vertices.size(); ++i)
        both.vertices[i] = both.vertices[i] + Vec3{2, 2, 2};
    EXPECT_NEAR(create(TreeCda(), shape_of(both, kLattice))->volume(), 64 + 27, 1e-9);
}

TEST(Placement, TurnsCounterClockwiseAndMoves) {
    const TreeCda block(mm_box(1, 2, 3, 4, 6, 8), kLattice);
    const Shape shape = shape_of(triangulate(block.boundary()), kLattice);
    Placement about_z = Placement{}.turned(2, 1);
    about_z.shift = kLattice.round({0, 0, 10});
    // Rotates by 90 degrees about z and shifts: (x, y, z) goes to (-y, x, z + 10).
    EXPECT_EQ(placed(shape, about_z).outer.bounds, (Box{{-6, 1, 13}, {-2, 4, 18}}));
    // A further rotation about x: (x, y, z) goes to (x, -z, y).
    const Shape twice = placed(shape, about_z.turned(0, 1));
    EXPECT_EQ(twice.outer.bounds, (Box{{-6, -18, 1}, {-2, -13, 4}}));
    EXPECT_EQ(placed(shape, about_z.turned(1, 3).turned(1, 1)).outer.bounds,
              placed(shape, about_z).outer.bounds);
    EXPECT_EQ(placed(shape, Placement{}.turned(0, 2)).outer.bounds,
              (Box{{1, -6, -8}, {4, -2, -3}}));
}

TEST(Placement, KeepsWhatIsInside) {
    const TreeCda part = cut_block(3, true);
    Shape shape = shape_of(triangulate(part.boundary()), kLattice);
    Placement flipped = Placement{}.turned(0, 2);
    flipped.shift = kLattice.round({1, 20, 3});
    const auto turned = create(part, placed(shape, flipped));
    const auto original = create(part, shape);
    EXPECT_NEAR(turned->volume(), original->volume(), 1e-9 * original->volume());
    Random random(1);
    constexpr int n = test::UnitCubes::kSize;
    const auto unit = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p{n * unit(), n * unit(), n * unit()};
        EXPECT_EQ(turned->contains({p.x + 1, 20 - p.y, 3 - p.z}), original->contains(p));
    }
}

TEST(Placement, StaysWithinTheLattice) {
    const TreeCda block(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    const Shape shape = shape_of(triangulate(block.boundary()), kLattice);
    Placement far;
    far.shift = {std::int64_t{1} << kCoordinateBits, 0, 0};
    EXPECT_THROW(placed(shape, far), std::invalid_argument);
}

TEST(ShapeFile, ComesBackAsItWas) {
    const TreeCda part = cut_block(5, true);
    const Shape shape = shape_of(triangulate(part.boundary()), kLattice);
    ASSERT_FALSE(shape.carved.empty());
    const std::string text = written(shape);
    const Shape again = read_back(text);
    EXPECT_EQ(written(again), text);
    EXPECT_EQ(again.lattice, shape.lattice);
    EXPECT_TRUE(create(part, again)->boundary().vertices ==
                create(part, shape)->boundary().vertices);
}

TEST(ShapeFile, KeepsTheAssumptionsOfTheRunThatWroteIt) {
    const TreeCda block(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    Shape shape = shape_of(triangulate(block.boundary()), kLattice);
    EXPECT_TRUE(read_back(written(shape)).assumed.empty());
    shape.assumed = {"tool-guess: T1", "stock-guess: a block"};
    const std::string text = written(shape);
    EXPECT_EQ(read_back(text).assumed, shape.assumed);
    EXPECT_EQ(placed(read_back(text), Placement().turned(0, 2)).assumed, shape.assumed);
    // Version 1 did not record the assumptions.
    shape.assumed.clear();
    std::string old = written(shape);
    old.replace(0, 13, "ncsim stock 1");
    EXPECT_EQ(read_back(old).assumed.size(), 1U);
    std::string long_line = text;
    long_line.replace(long_line.find("T1"), 2, std::string(5000, 'x'));
    EXPECT_THROW(read_back(long_line), std::runtime_error);
}

TEST(ShapeFile, KeepsTheSourcesOfCells) {
    const TreeCda part = cut_block(5, true);
    Shape shape = shape_of(triangulate(part.boundary()), kLattice);
    ASSERT_GT(shape.carved.size(), 3U);
    shape.sources = {
        {"0 0 stock", {"plane 1"}}, {"12 1 a.nc", {"cylinder 2", "plane 3"}}, {"", {}}};
    shape.carved[1].origin = shape.carved[2].origin = Origin{2};
    shape.carved[3].origin = Origin{1};
    const std::string text = written(shape);
    const Shape again = placed(read_back(text), Placement().turned(0, 2));
    ASSERT_EQ(again.sources.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(again.sources[i].text, shape.sources[i].text);
        EXPECT_EQ(again.sources[i].surfaces, shape.sources[i].surfaces);
    }
    EXPECT_EQ(again.sources[1].line, 5U);
    for (std::size_t i = 0; i < shape.carved.size(); ++i)
        EXPECT_EQ(again.carved[i].origin, shape.carved[i].origin) << i;
    EXPECT_EQ(written(read_back(text)), text);
    // Origins without sources are not written: they are numbers of another run.
    Shape unknown = shape;
    unknown.sources.clear();
    for (const Cell& cell : read_back(written(unknown)).carved)
        EXPECT_EQ(cell.origin, kStockOrigin);
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string changed = text;
        return changed.replace(changed.find(what), what.size(), instead);
    };
    EXPECT_THROW(read_back(with("origin 2", "origin 3")), std::runtime_error);
    EXPECT_THROW(read_back(with("origin 2", "origin -1")), std::runtime_error);
    EXPECT_THROW(read_back(with("stock 3", "stock 2")), std::runtime_error);
    EXPECT_THROW(read_back(with("cylinder 2", std::string(30000, 'x'))), std::runtime_error);
    EXPECT_THROW(read_back(with("source 0", "surface 0")), std::runtime_error);
}

TEST(ShapeFile, APlaneThatStandsTwiceCountsOnce) {
    const std::string text =
        "ncsim stock 2\nunit 1e-05\nnormal 1 0 0\nnormal -1 0 0\nnormal 0 1 0\nnormal 0 -1 0\n"
        "normal 0 0 1\nnormal 0 0 -1\nnormal 1 1 2\n"
        "outer 0 500000 1 0 2 500000 3 0 4 500000 5 0\n"
        "cell 6 500000 6 300000 6 300000\nend 1\n";
    const auto part = create(TreeCda(), read_back(text));
    EXPECT_TRUE(check(part->boundary()).is_closed());
    // The corner with x + y + 2 z < 3 has the volume 3 * 3 * 1.5 / 6.
    EXPECT_NEAR(part->volume(), 125.0 - 2.25, 1e-9);
}

TEST(ShapeFile, RefusesWhatIsNoStock) {
    const TreeCda block(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    const std::string good = written(shape_of(triangulate(block.boundary()), kLattice));
    EXPECT_NO_THROW(read_back(good));
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), instead);
    };
    const std::string bad[] = {
        "",
        "solid",
        with("unit 1e-05", "unit 0"),
        with("unit 1e-05", "unit nan"),
        with("unit 1e-05", "unit 9e-05"),
        with("unit 1e-05", "unit 1e-05 7"),
        with("end 0\n", ""),
        with("end 0", "end 1"),
        with("outer ", "cell 0 1 "),
        with("outer ", "outer 99 1 "),
        with("outer ", "outer 0 99999999999999999999 "),
        with("outer ", "outer x "),
        with("outer ", "normal 0 0 0\nouter "),
        with("outer ", "normal 99999999 0 1\nouter "),
        with("outer ", "normal 2 0 0\nouter "),
        with("outer ", "normal 0 0\nouter "),
        // The first cell is unbounded, the second empty.
        "ncsim stock 1\nunit 1e-05\nnormal 1 0 0\nouter 0 5\nend 0\n",
        "ncsim stock 1\nunit 1e-05\nnormal 1 0 0\nnormal -1 0 0\nouter 0 -5 1 -5\nend 0\n",
        good.substr(0, good.size() / 2),
    };
    for (const std::string& text : bad) {
        SCOPED_TRACE(text.substr(0, 200));
        EXPECT_THROW(read_back(text), std::runtime_error);
    }
}

}  // namespace
}  // namespace ncsim::cda
