// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole pictures against those in golden/, which somebody has looked at. Other versions of Mesa may
// round an edge differently, so a few pixels may differ. With NCSIM_UPDATE_GOLDENS set in the
// environment the pictures are written anew: look at them before you commit them.
#include "ncsim/export/png.h"
#include "ncsim/export/render.h"
#include "ncsim/export/sheet.h"

#include "box_part.h"
#include "polytope_part.h"
#include "read_png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace ncsim::exporter {
namespace {

// Pixels that differ by more than this in a channel count; one in two hundred may.
constexpr int kTolerance = 16;
constexpr std::size_t kAllowedShare = 200;

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

void expect_like_golden(const Image& image, const std::string& name) {
    const std::string golden_path = NCSIM_SOURCE_DIR "/tests/export/golden/" + name + ".png";
    if (std::getenv("NCSIM_UPDATE_GOLDENS") != nullptr) {
        std::ofstream out(golden_path, std::ios::binary);
        write_png(out, image);
    }
    const Image golden = test::read_png(bytes_of(golden_path));
    ASSERT_EQ(image.width, golden.width);
    ASSERT_EQ(image.height, golden.height);
    std::size_t different = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Rgba8 a = image.pixels[i];
        const Rgba8 b = golden.pixels[i];
        const int difference =
            std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        different += difference > kTolerance ? 1 : 0;
    }
    if (different <= image.pixels.size() / kAllowedShare) return;
    const std::string actual_path = testing::TempDir() + name + ".actual.png";
    std::ofstream out(actual_path, std::ios::binary);
    write_png(out, image);
    ADD_FAILURE() << different << " pixels of " << actual_path << " are not as in " << golden_path;
}

RenderOptions options_for(const cda::Box& box, View view, Projection projection) {
    RenderOptions options;
    options.width = 320;
    options.height = 240;
    options.camera = fit_camera(box, view, 4 / 3.0, projection);
    options.depth_top = box.max.z;
    options.depth_bottom = box.min.z;
    return options;
}

TEST(Golden, PolytopesFromTheStencilBuffer) {
    const cda::FlatCda part = test::polytope_part();
    const cda::Box box = cda::bounds(part.boundary());
    expect_like_golden(render_model(part, test::provenance_of_polytope_part(),
                                    options_for(box, View::Iso, Projection::Perspective)),
                       "polytopes");
}

TEST(Golden, GroovesByDepthOnADarkGround) {
    const auto part = test::grooved_part();
    const cda::Boundary boundary = test::boundary_of(part);
    RenderOptions options = options_for(cda::bounds(boundary), View::Iso, Projection::Perspective);
    options.background = Background::Dark;
    options.colouring = Colouring::Depth;
    expect_like_golden(render_boundary(boundary, test::provenance_of(part), options), "grooves");
}

TEST(Golden, ASheetOfViews) {
    const auto part = test::grooved_part();
    const cda::Boundary boundary = test::boundary_of(part);
    std::vector<LabelledImage> pictures;
    for (const View view : {View::Iso, View::Top, View::Front, View::Right}) {
        const RenderOptions options =
            options_for(cda::bounds(boundary), view, Projection::Orthographic);
        pictures.push_back({std::string(name(view)),
                            render_boundary(boundary, test::provenance_of(part), options)});
    }
    const std::vector<std::string> caption{"grooves.nc   60 x 40 x 20 mm", "removed 7248 mm3"};
    expect_like_golden(contact_sheet(pictures, caption), "sheet");
}

TEST(Golden, ThePathAndABodyOverThePart) {
    const auto part = test::grooved_part();
    const cda::Boundary boundary = test::boundary_of(part);
    const cda::Box box = cda::bounds(boundary);
    Overlay overlay;
    const double z = box.max.z;
    const int top = part.stock.max[2];
    overlay.paths.push_back(
        {{{box.min.x, box.min.y, z + 8}, {box.max.x, box.max.y, z + 8}, {box.max.x, box.max.y, z}},
         true});
    overlay.paths.push_back(
        {{{box.max.x, box.max.y, z}, {box.min.x, box.max.y, z}, {box.min.x, box.min.y, z}}, false});
    test::BoxPart body;
    body.cell_mm = part.cell_mm;
    body.stock = {{20, 10, top}, {26, 16, top + 14}};
    overlay.bodies.push_back({test::boundary_of(body), {226, 186, 92}});
    cda::Box seen = box;
    seen.add(body.to_W({26, 16, 14.0 + top}));
    expect_like_golden(
        render_boundary(boundary, test::provenance_of(part),
                        options_for(seen, View::Iso, Projection::Orthographic), overlay),
        "path");
}

}  // namespace
}  // namespace ncsim::exporter
