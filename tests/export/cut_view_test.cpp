// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of parts cut open, and of distances from a design.
#include "ncsim/cda/flat.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/render.h"

#include "render/palette.h"
#include "support/box_part.h"
#include "support/polytope_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace ncsim::exporter {
namespace {

const cda::Lattice kLattice = cda::Lattice::for_stock({{0, 0, 0}, {40, 30, 10}});
const mesh::Provenance kCuts{{{0, 0}, {10, 1}, {20, 7}, {30, 9}}, "plate.nc"};

cda::Cell box(Vec3 min, Vec3 max, std::uint32_t origin) {
    return cda::box_cell(kLattice.round(min), kLattice.round(max), kLattice, cda::Origin{origin});
}

// Returns a plate of 40 × 30 × 10 mm with a slot and a void that no tool could reach.
cda::FlatCda plate() {
    cda::FlatCda part(box({0, 0, 0}, {40, 30, 10}, 0), kLattice);
    part.subtract(box({-1, 17, 3}, {41, 21, 11}, 1));
    part.subtract(box({12, 4, 2}, {28, 12, 8}, 2));
    return part;
}

RenderOptions options_for(const cda::Boundary& boundary, View view) {
    RenderOptions options;
    options.width = 400;
    options.height = 300;
    options.camera = fit_camera(cda::bounds(boundary), view, 4 / 3.0);
    return options;
}

int difference(Rgba8 a, Rgba8 b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

bool is_flat(const Image& image, std::uint32_t x, std::uint32_t y) {
    for (std::uint32_t v = y - 2; v <= y + 2; ++v) {
        for (std::uint32_t u = x - 2; u <= x + 2; ++u) {
            if (difference(image.at(u, v), image.at(x, y)) > 2) return false;
        }
    }
    return true;
}

// The cut has the colours of no tool and no stock: a pale grey with darker lines.
bool is_cut_colour(Rgba8 c) {
    return difference(c, {c.g, c.g, c.g}) <= 12 && c.g >= 100;
}

// Away from edges, the picture is that of the part without the half in front of the plane, except
// for the hatch.
TEST(CutView, ShowsThePartWithoutTheHalfAndHatchesTheCut) {
    const cda::Boundary whole = plate().boundary();
    cda::FlatCda half = plate();
    half.subtract(box({20, -1, -1}, {41, 31, 11}, 3));
    for (const View view : {View::Iso, View::Right, View::Top}) {
        SCOPED_TRACE(name(view));
        RenderOptions options = options_for(whole, view);
        const Image expected = render_boundary(half.boundary(), kCuts, options);
        // Tool 9 cuts the same half in a second picture with another rank, so its colour differs.
        mesh::Provenance other = kCuts;
        other.entries.back() = {30, 0};
        const Image marked = render_boundary(half.boundary(), other, options);
        options.cut = mesh::CutPlane{{1, 0, 0}, 20.0};
        const Image picture = render_boundary(whole, kCuts, options);
        std::size_t flat = 0, hatched = 0, lines = 0;
        for (std::uint32_t y = 2; y + 2 < options.height; ++y) {
            for (std::uint32_t x = 2; x + 2 < options.width; ++x) {
                if (!is_flat(expected, x, y)) continue;
                if (expected.at(x, y) == marked.at(x, y)) {
                    ++flat;
                    EXPECT_LE(difference(picture.at(x, y), expected.at(x, y)), 2);
                } else {
                    ++hatched;
                    EXPECT_TRUE(is_cut_colour(picture.at(x, y)));
                    lines += picture.at(x, y).g < 200 ? 1U : 0U;
                }
            }
        }
        EXPECT_GT(flat, 20000U);
        if (view == View::Top) {
            EXPECT_EQ(hatched, 0U);
        } else {
            EXPECT_GT(hatched, 1000U);
            EXPECT_GT(lines, hatched / 20);
            EXPECT_LT(lines, hatched / 2);
        }
    }
}

TEST(CutView, OpensBodiesThatAreCutAndNoOthers) {
    const cda::Boundary part = plate().boundary();
    test::BoxPart jaw;
    jaw.stock = {{0, 0, 0}, {40, 5, 10}};
    jaw.shift = {0, -5, 0};
    Overlay overlay;
    overlay.bodies.push_back({test::boundary_of(jaw), {40, 160, 90}});
    RenderOptions options = options_for(part, View::Front);
    options.camera.depth *= 2.0;
    options.cut = mesh::CutPlane{{0, -1, 0}, -8.0};
    const auto green = [&](bool is_cut) {
        overlay.bodies.front().is_cut = is_cut;
        const Image image = render_boundary(part, kCuts, options, overlay);
        return std::ranges::count_if(image.pixels,
                                     [](Rgba8 c) { return c.g > c.r + 20 && c.g > c.b + 20; });
    };
    EXPECT_GT(green(false), 10000);
    EXPECT_EQ(green(true), 0);
    // A plane through the jaw shows its cut in its colour.
    options.cut = mesh::CutPlane{{0, -1, 0}, 2.0};
    EXPECT_GT(green(true), 10000);
}

DesignDistances distances_for(const cda::Boundary& part) {
    DesignDistances distances;
    distances.mesh = cda::triangulate(part);
    // The design has its top at Z 9 and is wider than the part.
    for (const Vec3& p : distances.mesh.vertices)
        distances.distance_mm.push_back(p.z - 9.0);
    distances.tolerance_mm = 0.5;
    distances.largest_mm = 10.0;
    return distances;
}

TEST(CutView, OnlyTilesWithEdgesAreSampledAndNoByteShowsIt) {
    const cda::Boundary boxes = plate().boundary();
    const cda::Boundary polytopes = test::polytope_part().boundary();
    test::BoxPart jaw;
    jaw.stock = {{0, 0, 0}, {40, 5, 10}};
    jaw.shift = {0, -5, 0};
    Overlay overlay;
    overlay.bodies.push_back({test::boundary_of(jaw), {40, 160, 90}, true});
    for (const auto& [part, provenance] :
         {std::pair{&boxes, kCuts}, std::pair{&polytopes, test::provenance_of_polytope_part()}}) {
        const DesignDistances distances = distances_for(*part);
        for (const Colouring colouring : {Colouring::Tool, Colouring::Design}) {
            RenderOptions options = options_for(*part, View::Iso);
            options.camera.depth *= 2.0;
            options.colouring = colouring;
            options.distances = &distances;
            options.cut = mesh::CutPlane{{0, -1, 0}, -8.3};
            const Image picture = render_boundary(*part, provenance, options, overlay);
            options.samples_everywhere = true;
            EXPECT_TRUE(picture == render_boundary(*part, provenance, options, overlay));
            options.samples_everywhere = false;
            options.renderer = Renderer::Osmesa;
            const Image osmesa = render_boundary(*part, provenance, options, overlay);
            std::size_t different = 0;
            for (std::size_t i = 0; i < picture.pixels.size(); ++i)
                different += difference(picture.pixels[i], osmesa.pixels[i]) > 8;
            EXPECT_LT(different, picture.pixels.size() / 100);
        }
    }
}

TEST(DesignColours, EachPointHasTheColourOfItsDistance) {
    const cda::Boundary part = plate().boundary();
    const DesignDistances distances = distances_for(part);
    RenderOptions options = options_for(part, View::Front);
    options.colouring = Colouring::Design;
    EXPECT_THROW(render_boundary(part, kCuts, options), std::runtime_error);
    options.distances = &distances;
    options.edges = false;
    const Image picture = render_boundary(part, kCuts, options);
    // The front is a single plane, so all points have the same light.
    const auto pixel_at = [&](double z) {
        const double row = 0.5 * options.height -
                           (z - options.camera.target.z) * options.height / options.camera.height;
        return picture.at(options.width / 2, static_cast<std::uint32_t>(row));
    };
    const auto is_green = [](Rgba8 c) { return c.g > c.r && c.g > c.b; };
    EXPECT_TRUE(is_green(pixel_at(9.0)));
    EXPECT_TRUE(is_green(pixel_at(8.7)));
    EXPECT_GT(pixel_at(9.8).b, pixel_at(9.8).g);
    EXPECT_GT(pixel_at(8.2).r, pixel_at(8.2).g);
    EXPECT_GT(pixel_at(8.2).g, pixel_at(4.0).g);
    EXPECT_GT(pixel_at(4.0).g, pixel_at(0.5).g);
}

TEST(DesignColours, TheScaleBeginsAtTheTolerance) {
    const auto channel = [](double mm) { return to_srgb(distance_colour(mm, 0.1, 2.0)); };
    EXPECT_EQ(channel(0.0), channel(0.1));
    EXPECT_EQ(channel(0.0), channel(-0.1));
    EXPECT_NE(channel(0.11), channel(0.1));
    EXPECT_NE(channel(-0.11), channel(0.11));
    EXPECT_EQ(channel(2.0), channel(50.0));
    EXPECT_EQ(channel(-2.0), channel(-50.0));
    EXPECT_NE(channel(1.0), channel(2.0));
}

}  // namespace
}  // namespace ncsim::exporter
