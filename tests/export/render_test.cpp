// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the renderers of models and boundaries, and tests overlays and sampling.
#include "ncsim/export/render.h"

#include "ncsim/export/png.h"

#include "support/box_part.h"
#include "support/polytope_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>

namespace ncsim::exporter {
namespace {

RenderOptions options_for(const cda::Boundary& boundary, View view,
                          Projection projection = Projection::Orthographic) {
    RenderOptions options;
    options.width = 400;
    options.height = 300;
    options.camera = fit_camera(cda::bounds(boundary), view, 4 / 3.0, projection);
    return options;
}

int difference(Rgba8 a, Rgba8 b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// True if all pixels within two pixels have the same colour.
bool is_flat(const Image& image, std::uint32_t x, std::uint32_t y) {
    for (std::uint32_t v = y < 2 ? 0 : y - 2; v < std::min(y + 3, image.height); ++v) {
        for (std::uint32_t u = x < 2 ? 0 : x - 2; u < std::min(x + 3, image.width); ++u) {
            if (difference(image.at(u, v), image.at(x, y)) > 2) return false;
        }
    }
    return true;
}

struct Comparison {
    std::size_t flat = 0;            // pixels away from edges
    std::size_t flat_different = 0;  // flat pixels that differ
    std::size_t edge = 0;
    std::size_t edge_different = 0;
};

Comparison compare(const Image& stencil, const Image& boundary) {
    Comparison result;
    for (std::uint32_t y = 0; y < boundary.height; ++y) {
        for (std::uint32_t x = 0; x < boundary.width; ++x) {
            const bool differs = difference(stencil.at(x, y), boundary.at(x, y)) > 2;
            const bool flat = is_flat(boundary, x, y);
            (flat ? result.flat : result.edge) += 1;
            (flat ? result.flat_different : result.edge_different) += differs ? 1 : 0;
        }
    }
    return result;
}

template <class Model>
void expect_same_picture(const Model& model, const mesh::Provenance& provenance, View view,
                         Projection projection) {
    SCOPED_TRACE(name(view));
    const cda::Boundary boundary = model.boundary();
    const RenderOptions options = options_for(boundary, view, projection);
    const Image a = render_model(model, provenance, options);
    const Image b = render_boundary(boundary, provenance, options);
    const Comparison result = compare(a, b);
    EXPECT_GT(result.flat, 40000U);
    EXPECT_EQ(result.flat_different, 0U);
    EXPECT_LE(result.edge_different, result.edge / 50);
}

TEST(Render, StencilAndBoundaryShowTheSamePicture) {
    for (const auto& part : {test::grooved_part(), test::raster_part(),
                             test::grooved_part().tilted(), test::raster_part().tilted()}) {
        for (const View view : {View::Iso, View::Top, View::Front}) {
            for (const Projection projection :
                 {Projection::Orthographic, Projection::Perspective}) {
                expect_same_picture(test::BoxModel(part), test::provenance_of(part), view,
                                    projection);
            }
        }
    }
}

TEST(Render, EveryColouringAndBackgroundIsTheSameForBoth) {
    const auto part = test::grooved_part().tilted();
    const cda::Boundary boundary = test::boundary_of(part);
    RenderOptions options = options_for(boundary, View::Iso, Projection::Perspective);
    options.depth_top = cda::bounds(boundary).max.z;
    options.depth_bottom = cda::bounds(boundary).min.z;
    for (const Colouring colouring : {Colouring::Tool, Colouring::Line, Colouring::Depth}) {
        for (const Background background : {Background::White, Background::Dark}) {
            options.colouring = colouring;
            options.background = background;
            const Image a = render_model(test::BoxModel(part), test::provenance_of(part), options);
            const Image b = render_boundary(boundary, test::provenance_of(part), options);
            EXPECT_EQ(compare(a, b).flat_different, 0U);
        }
    }
}

TEST(Render, RefusesDepthsUpsideDown) {
    RenderOptions options;
    options.colouring = Colouring::Depth;
    options.depth_bottom = options.depth_top;
    EXPECT_THROW(render_boundary({}, {}, options), std::runtime_error);
}

TEST(Render, StencilAndBoundaryOfAFlatCdaShowTheSamePicture) {
    const cda::FlatCda part = test::polytope_part();
    for (const View view : {View::Iso, View::Top, View::Right}) {
        expect_same_picture(part, test::provenance_of_polytope_part(), view,
                            Projection::Perspective);
    }
}

TEST(Render, AnEmptyPartIsAnEmptyPicture) {
    const auto part = test::vanished_part();
    RenderOptions options = options_for(test::boundary_of(part), View::Iso);
    const Image stencil = render_model(test::BoxModel(part), {}, options);
    const Image boundary = render_boundary(test::boundary_of(part), {}, options);
    EXPECT_EQ(stencil, boundary);
    EXPECT_EQ(stencil.pixels, std::vector<Rgba8>(stencil.pixels.size(), Rgba8{255, 255, 255}));
}

TEST(Render, TellsStockAndToolsApart) {
    const auto part = test::grooved_part();
    const cda::Boundary boundary = test::boundary_of(part);
    RenderOptions options = options_for(boundary, View::Top);
    options.edges = false;
    const Image image = render_boundary(boundary, test::provenance_of(part), options);
    std::vector<std::array<int, 3>> colours;
    for (const Rgba8& p : image.pixels) {
        const std::array colour{int{p.r}, int{p.g}, int{p.b}};
        if (std::count(colours.begin(), colours.end(), colour) == 0) colours.push_back(colour);
    }
    // White, stock and two tools; all further colours are averages.
    std::size_t plain = 0;
    for (const auto& colour : colours) {
        const auto count = std::count_if(image.pixels.begin(), image.pixels.end(), [&](Rgba8 p) {
            return std::array{int{p.r}, int{p.g}, int{p.b}} == colour;
        });
        if (count > 1000) ++plain;
    }
    EXPECT_EQ(plain, 4U);
}

// Returns the number of pixels that clearly differ: the ink of a path, on white.
std::size_t path_pixels(const Image& with, const Image& without) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        count += difference(with.pixels[i], without.pixels[i]) > 40;
    return count;
}

// Expects the same picture from all ways of drawing. The slow way, which draws every sample of
// every pixel, is the oracle.
template <class Model>
void expect_same_in_all_ways(const Model& model, const mesh::Provenance& provenance,
                             const RenderOptions& options, const Overlay& overlay = {}) {
    const cda::Boundary boundary = model.boundary();
    const auto draw = [&](bool by_masks, const RenderOptions& how) {
        return by_masks ? render_model(model, provenance, how, overlay)
                        : render_boundary(boundary, provenance, how, overlay);
    };
    for (const bool by_masks : {false, true}) {
        SCOPED_TRACE(by_masks ? "by masks" : "boundary");
        RenderOptions slow = options;
        slow.samples_everywhere = true;
        const Image expected = draw(by_masks, slow);
        EXPECT_TRUE(draw(by_masks, options) == expected);
        for (const std::uint32_t band : {1U, 40000U, 1U << 22}) {
            SCOPED_TRACE(band);
            RenderOptions how = options;
            how.band_samples = band;
            EXPECT_TRUE(draw(by_masks, how) == expected);
            how.samples_everywhere = true;
            EXPECT_TRUE(draw(by_masks, how) == expected);
        }
    }
}

const cda::Lattice kLattice = cda::Lattice::for_stock({{0, 0, 0}, {40, 30, 10}});

cda::Cell box(Vec3 min, Vec3 max, std::uint32_t origin) {
    return cda::box_cell(kLattice.round(min), kLattice.round(max), kLattice, cda::Origin{origin});
}

// Returns a plate of 40 × 30 × 10 mm with two slots: few edges, large faces.
cda::FlatCda slotted_plate() {
    cda::FlatCda part(box({0, 0, 0}, {40, 30, 10}, 0), kLattice);
    part.subtract(box({5, -1, 6}, {14, 31, 11}, 1));
    part.subtract(box({-1, 17, 3}, {41, 21, 11}, 2));
    return part;
}

const mesh::Provenance kTwoSlots{{{0, 0}, {10, 1}, {20, 7}}, "plate.nc"};

TEST(Render, OsmesaDrawsTheSamePictureButForPixelsAtEdges) {
    const cda::FlatCda part = slotted_plate();
    const cda::Boundary boundary = part.boundary();
    for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
        RenderOptions options = options_for(boundary, View::Iso, projection);
        const Image own = render_boundary(boundary, kTwoSlots, options);
        const Image own_by_masks = render_model(part, kTwoSlots, options);
        options.renderer = Renderer::Osmesa;
        const Image osmesa = render_boundary(boundary, kTwoSlots, options);
        const Image osmesa_by_masks = render_model(part, kTwoSlots, options);
        for (const auto& [a, b] :
             {std::pair{&own, &osmesa}, std::pair{&own_by_masks, &osmesa_by_masks}}) {
            const Comparison c = compare(*a, *b);
            EXPECT_EQ(c.flat_different, 0U);
            EXPECT_GT(c.flat, c.edge);
            EXPECT_LE(c.edge_different, c.edge / 20);
        }
    }
}

TEST(Render, OnlyTilesWithEdgesAreSampledAndNoByteShowsIt) {
    for (const View view : {View::Iso, View::Top}) {
        for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
            for (const std::uint32_t samples : {1U, 2U, 3U}) {
                SCOPED_TRACE(samples);
                const cda::FlatCda plate = slotted_plate(), polytopes = test::polytope_part();
                RenderOptions options = options_for(plate.boundary(), view, projection);
                options.width = 409;  // not a whole number of tiles
                options.samples = samples;
                expect_same_in_all_ways(plate, kTwoSlots, options);
                expect_same_in_all_ways(polytopes, test::provenance_of_polytope_part(), options);
            }
        }
    }
    const auto raster = test::raster_part().tilted();
    expect_same_in_all_ways(test::BoxModel(raster), test::provenance_of(raster),
                            options_for(test::boundary_of(raster), View::Iso));
}

// Lines, and a body that crosses the part, opaque or transparent.
TEST(Render, OverlaysAndColoursByDepthAreSampledWhereTheyHaveEdges) {
    const cda::FlatCda plate = slotted_plate();
    RenderOptions options = options_for(plate.boundary(), View::Iso, Projection::Perspective);
    options.camera.depth *= 3.0;
    options.depth_top = 10;
    options.depth_bottom = 0;
    Overlay overlay{
        {{{{0, 0, 0}, {40, 30, 10}, {40, 0, 15}}, false}, {{{0, 30, 19}, {40, 30, 10}}, true}},
        {},
        {{{{-2, -2, -2}, {42, 32, 12}}}}};
    for (const std::uint8_t alpha : {std::uint8_t{255}, std::uint8_t{100}}) {
        test::BoxPart body;
        body.cell_mm = 8.0;
        body.stock = {{1, 1, 0}, {2, 2, 5}};
        overlay.bodies.assign(1, {test::boundary_of(body), {200, 40, 90, alpha}});
        for (const Colouring colouring : {Colouring::Tool, Colouring::Depth}) {
            options.colouring = colouring;
            expect_same_in_all_ways(plate, kTwoSlots, options, overlay);
        }
    }
}

// A plate with pockets 1, 3 and 9 mm deep, and a hole.
cda::FlatCda plate_with_pockets() {
    cda::FlatCda part(box({0, 0, 0}, {40, 30, 10}, 0), kLattice);
    part.subtract(box({3, 5, 9}, {11, 25, 11}, 1));
    part.subtract(box({15, 5, 7}, {23, 25, 11}, 1));
    part.subtract(box({27, 5, 1}, {35, 25, 11}, 1));
    part.subtract(box({37, 12, 2}, {39, 14, 11}, 2));
    return part;
}

TEST(Render, RecessesAreDarkerTheDeeperTheyAre) {
    const cda::Boundary boundary = plate_with_pockets().boundary();
    RenderOptions options = options_for(boundary, View::Top);
    const Image shaded = render_boundary(boundary, kTwoSlots, options);
    options.shades_recesses = false;
    const Image plain = render_boundary(boundary, kTwoSlots, options);
    const double scale = options.height / options.camera.height;
    const auto loss = [&](double x, double y) {
        const auto column = static_cast<std::uint32_t>(200.0 + (x - 20.0) * scale);
        const auto row = static_cast<std::uint32_t>(150.0 - (y - 15.0) * scale);
        return plain.at(column, row).g - shaded.at(column, row).g;
    };
    // At the walls of the pockets.
    EXPECT_GT(loss(3.3, 15), 3);
    EXPECT_GT(loss(15.3, 15), loss(3.3, 15) + 5);
    EXPECT_GT(loss(27.3, 15), loss(15.3, 15) + 5);
    EXPECT_GT(loss(38, 13), 30);  // the hole
    EXPECT_LT(loss(31, 15), loss(27.3, 15) - 10) << "far from the walls there is more light";
    // The top is as bright as before, up to its edges.
    for (const double x : {1.0, 2.7, 11.3, 13.0, 23.3, 26.7, 35.3, 36.0})
        EXPECT_EQ(loss(x, 15), 0) << x;
}

TEST(Render, AConvexPartHasNoRecess) {
    cda::FlatCda block(box({0, 0, 0}, {40, 30, 10}, 0), kLattice);
    block.subtract(box({-1, -1, 8}, {41, 31, 11}, 1));
    const cda::Boundary boundary = block.boundary();
    for (const View view : {View::Iso, View::Top, View::Left}) {
        for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
            RenderOptions options = options_for(boundary, view, projection);
            const Image shaded = render_boundary(boundary, kTwoSlots, options);
            options.shades_recesses = false;
            EXPECT_TRUE(shaded == render_boundary(boundary, kTwoSlots, options));
        }
    }
}

// Bodies make no recess in the part, and are not darker.
TEST(Render, BodiesAreOutsideOfRecesses) {
    cda::FlatCda block(box({0, 0, 0}, {40, 30, 10}, 0), kLattice);
    RenderOptions options = options_for(block.boundary(), View::Top);
    options.camera.depth *= 3.0;
    test::BoxPart body;
    body.stock = {{10, 10, 10}, {20, 20, 30}};
    Overlay overlay;
    overlay.bodies.push_back({test::boundary_of(body), {200, 40, 90}});
    const Image shaded = render_boundary(block.boundary(), kTwoSlots, options, overlay);
    options.shades_recesses = false;
    EXPECT_TRUE(shaded == render_boundary(block.boundary(), kTwoSlots, options, overlay));
}

// Seen from above, a transparent part shows an opaque bar in its bore, and the bore.
TEST(Render, ATransparentPartShowsItsInside) {
    cda::FlatCda part(box({0, 0, 0}, {40, 30, 20}, 0), kLattice);
    part.subtract(box({-1, 10, 8}, {41, 20, 14}, 1));
    const cda::Boundary boundary = part.boundary();
    RenderOptions options = options_for(boundary, View::Top);
    options.edges = false;
    test::BoxPart body;
    body.stock = {{5, 12, 10}, {15, 18, 12}};
    Overlay overlay;
    overlay.bodies.push_back({test::boundary_of(body), {200, 20, 20}});
    const auto draw = [&] { return render_boundary(boundary, kTwoSlots, options, overlay); };
    const auto at = [&](const Image& image, double x, double y) {
        const double scale = options.height / options.camera.height;
        return image.at(static_cast<std::uint32_t>(200.0 + (x - 20.0) * scale),
                        static_cast<std::uint32_t>(150.0 - (y - 15.0) * scale));
    };
    const Image opaque = draw();
    EXPECT_EQ(at(opaque, 10, 15), at(opaque, 30, 5));
    options.see_through = true;
    const Image image = draw();
    const Rgba8 bar = at(image, 10, 15), bore = at(image, 30, 15), block = at(image, 30, 5);
    EXPECT_GT(bar.r, bar.b + 20);
    // Four surfaces hide more of the background than two.
    EXPECT_LT(bore.r + 10, block.r);
    EXPECT_GT(block.r, at(opaque, 30, 5).r + 20);
    EXPECT_EQ(image.at(0, 0), (Rgba8{255, 255, 255}));
    // The faces above and below are 0.35 of the surface, and 0.65 of the pixels behind.
    const auto expected = [&](double face, double background) {
        return 0.35 * face + 0.65 * (0.35 * face + 0.65 * background);
    };
    EXPECT_NEAR(block.g, expected(at(opaque, 30, 5).g, 255), 8);
    // The same bytes in bands, and sample by sample.
    options.edges = true;
    const Image expected_image = draw();
    options.band_samples = 1;
    EXPECT_TRUE(draw() == expected_image);
    options.samples_everywhere = true;
    EXPECT_TRUE(draw() == expected_image);
    options.renderer = Renderer::Osmesa;
    EXPECT_THROW(draw(), std::runtime_error);
}

// The faces of a body cross faces of the part where no edge is drawn.
TEST(Render, FacesThatCrossEachOtherAreSampled) {
    const cda::FlatCda plate = slotted_plate();
    const RenderOptions options = options_for(plate.boundary(), View::Iso);
    test::BoxPart body;
    body.stock = {{0, 0, 0}, {1, 1, 1}};
    body.cell_mm = 30.0;
    body = body.tilted();
    body.shift = body.shift + Vec3{10, -8, -16};
    Overlay overlay;
    overlay.bodies.push_back({test::boundary_of(body), {200, 40, 90}});
    expect_same_in_all_ways(plate, kTwoSlots, options, overlay);
}

// A groove between the middles of pixels is found by its edges.
TEST(Render, AGrooveNarrowerThanAPixelIsSampled) {
    const cda::FlatCda plain(box({0, 0, 0}, {40, 30, 10}, 0), kLattice);
    const RenderOptions options = options_for(plain.boundary(), View::Top);
    const double pixel = options.camera.height / options.height;
    for (const double share : {0.1, 0.35, 0.6, 0.85}) {
        cda::FlatCda part = plain;
        const double x = (150 + share) * pixel;
        part.subtract(box({x, -1, 9}, {x + 0.55 * pixel, 31, 11}, 1));
        const Image with = render_boundary(part.boundary(), kTwoSlots, options);
        EXPECT_GT(path_pixels(with, render_boundary(plain.boundary(), kTwoSlots, options)), 0U);
        expect_same_in_all_ways(part, kTwoSlots, options);
    }
}

// At most 4096 samples per side are drawn at once, so 2500 pixels are two by two blocks.
TEST(Render, TilesHaveNoSeams) {
    const auto part = test::grooved_part().tilted();
    const cda::Boundary boundary = test::boundary_of(part);
    RenderOptions options = options_for(boundary, View::Iso);
    options.width = 2500;
    options.height = 2100;
    options.camera = fit_camera(cda::bounds(boundary), View::Iso, 2500.0 / 2100.0);
    const Image tiled = render_boundary(boundary, test::provenance_of(part), options);
    options.samples = 1;
    const Image whole = render_boundary(boundary, test::provenance_of(part), options);
    std::size_t flat_different = 0;
    for (std::uint32_t y = 0; y < tiled.height; ++y) {
        for (std::uint32_t x = 2000; x < 2100; ++x) {  // about the seam at 2044
            if (is_flat(whole, x, y) && difference(tiled.at(x, y), whole.at(x, y)) > 2)
                ++flat_different;
        }
    }
    EXPECT_EQ(flat_different, 0U);
    EXPECT_EQ(compare(render_model(test::BoxModel(part), test::provenance_of(part), options), whole)
                  .flat_different,
              0U);
}

TEST(Render, RefusesSizesThatCannotBe) {
    const cda::Boundary boundary = test::boundary_of(test::grooved_part());
    for (const auto& [width, height, samples] : {std::array{0U, 100U, 2U},
                                                 {100U, 0U, 2U},
                                                 {kMaxImageSide + 1, 100U, 2U},
                                                 {100U, 4000000000U, 2U},
                                                 {100U, 100U, 0U},
                                                 {100U, 100U, 5U}}) {
        RenderOptions options;
        options.width = width;
        options.height = height;
        options.samples = samples;
        EXPECT_THROW(render_boundary(boundary, {}, options), std::runtime_error);
    }
}

TEST(Render, TheNarrowestPictureIsOnePixelWide) {
    const auto part = test::grooved_part();
    RenderOptions options = options_for(test::boundary_of(part), View::Top);
    options.width = 1;
    options.height = 1;
    const Image image = render_boundary(test::boundary_of(part), {}, options);
    EXPECT_EQ(image.pixels.size(), 1U);
    EXPECT_NE(image.pixels[0], (Rgba8{255, 255, 255}));
}

TEST(Render, SaysTheSameTwice) {
    const auto part = test::raster_part().tilted();
    const cda::Boundary boundary = test::boundary_of(part);
    const RenderOptions options = options_for(boundary, View::Iso);
    EXPECT_EQ(render_boundary(boundary, test::provenance_of(part), options),
              render_boundary(boundary, test::provenance_of(part), options));
    EXPECT_EQ(render_model(test::BoxModel(part), test::provenance_of(part), options),
              render_model(test::BoxModel(part), test::provenance_of(part), options));
}

TEST(Render, PathsAreHiddenByWhatStandsBeforeThem) {
    test::BoxPart part;
    part.stock = {{0, 0, 0}, {40, 30, 10}};
    const cda::Boundary boundary = test::boundary_of(part);
    const RenderOptions options = options_for(boundary, View::Top);
    const Image plain = render_boundary(boundary, {}, options);
    const auto ink = [&](double z, bool is_rapid) {
        const Overlay overlay{{{{{5, 15, z}, {35, 15, z}}, is_rapid}}, {}};
        return path_pixels(render_boundary(boundary, {}, options, overlay), plain);
    };
    // The line is 30 mm of 40 mm, which are most of 400 pixels. A line on the face is visible along
    // its whole length.
    const std::size_t full = ink(12.0, false);
    EXPECT_GT(full, 250U);
    EXPECT_EQ(ink(10.0, false), full);
    EXPECT_EQ(ink(5.0, false), 0U);
    // Dashes are three fifths of the line.
    EXPECT_NEAR(static_cast<double>(ink(12.0, true)), 0.6 * static_cast<double>(full),
                0.1 * static_cast<double>(full));
}

TEST(Render, AGhostIsPaleAndItsEdgesAreSeenWhereNothingStands) {
    test::BoxPart part;
    part.stock = {{0, 0, 0}, {40, 30, 10}};
    const cda::Boundary boundary = test::boundary_of(part);
    for (const Background background : {Background::White, Background::Dark}) {
        RenderOptions options = options_for(boundary, View::Top);
        options.background = background;
        const Image specified = render_boundary(boundary, {}, options);
        options.ghost_stock = true;
        const Image pale = render_boundary(boundary, {}, options);
        // The colour is nearer to the background, but different.
        const auto contrast = [&](const Image& image) {
            return difference(image.at(200, 150), image.at(0, 0));
        };
        EXPECT_LT(contrast(pale), contrast(specified));
        EXPECT_GT(contrast(pale), 10);
        const auto ink = [&](const Box& box) {
            return path_pixels(render_boundary(boundary, {}, options, {{}, {}, {{box}}}), pale);
        };
        EXPECT_EQ(ink({{0, 0, 0}, {40, 30, 10}}), 0U) << "its faces hide them";
        // Seen from above, the outline of a larger box is around the part.
        EXPECT_GT(ink({{-1, -1, 0}, {41, 31, 10}}), 200U);
        EXPECT_EQ(ink({{1, 1, 1}, {39, 29, 9}}), 0U) << "inside";
    }
}

TEST(Render, BothRenderersDrawTheSameOverlay) {
    const cda::FlatCda model = test::polytope_part();
    const cda::Boundary boundary = model.boundary();
    const RenderOptions options = options_for(boundary, View::Iso, Projection::Perspective);
    test::BoxPart body;
    body.stock = {{2, 2, 2}, {20, 20, 20}};
    Overlay overlay{{{{{1, 2, 12}, {38, 27, 13}, {39, 3, 8}}, false}}, {}};
    overlay.bodies.push_back({test::boundary_of(body), {200, 180, 90}});
    const auto provenance = test::provenance_of_polytope_part();
    const Comparison result = compare(render_model(model, provenance, options, overlay),
                                      render_boundary(boundary, provenance, options, overlay));
    EXPECT_EQ(result.flat_different, 0U);
    EXPECT_LE(result.edge_different, result.edge / 50);
}

// Pixels are three tenths of the body and seven tenths of the scene behind, in both renderers.
// Pixels outside the body do not change.
TEST(Render, BehindABodyThatIsTransparentThePartIsSeen) {
    const cda::FlatCda model = test::polytope_part();
    const cda::Boundary boundary = model.boundary();
    const RenderOptions options = options_for(boundary, View::Iso, Projection::Perspective);
    const auto provenance = test::provenance_of_polytope_part();
    test::BoxPart body;
    body.stock = {{2, 2, 2}, {20, 20, 20}};
    const auto with = [&](std::uint8_t alpha) {
        Overlay overlay;
        overlay.bodies.push_back({test::boundary_of(body), {200, 40, 90, alpha}});
        return overlay;
    };
    const Image without = render_boundary(boundary, provenance, options);
    const Image opaque = render_boundary(boundary, provenance, options, with(255));
    const Image through = render_boundary(boundary, provenance, options, with(76));
    std::size_t covered = 0;
    for (std::size_t i = 0; i < through.pixels.size(); ++i) {
        const Rgba8 &below = without.pixels[i], &above = opaque.pixels[i];
        const auto mixed = [](int b, int a) { return (76.0 * a + 179.0 * b) / 255.0; };
        ASSERT_NEAR(through.pixels[i].r, mixed(below.r, above.r), 0.51);
        ASSERT_NEAR(through.pixels[i].g, mixed(below.g, above.g), 0.51);
        ASSERT_NEAR(through.pixels[i].b, mixed(below.b, above.b), 0.51);
        covered += below == above ? 0U : 1U;
    }
    EXPECT_GT(covered, 1000U);
    EXPECT_LT(covered, through.pixels.size() / 2);
    const Comparison result = compare(render_model(model, provenance, options, with(76)), through);
    EXPECT_EQ(result.flat_different, 0U);
}

}  // namespace
}  // namespace ncsim::exporter
