// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares whole pictures with the pictures in golden/.
#include "support/golden.h"

#include "ncsim/export/contact_sheet.h"
#include "ncsim/export/render.h"

#include "support/box_part.h"
#include "support/polytope_part.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::exporter {
namespace {

RenderOptions options_for(const Box& box, View view, Projection projection) {
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
    const Box box = cda::bounds(part.boundary());
    test::expect_like_golden(render_model(part, test::provenance_of_polytope_part(),
                                          options_for(box, View::Iso, Projection::Perspective)),
                             "export/golden/polytopes.png");
}

TEST(Golden, GroovesByDepthOnADarkGround) {
    const auto part = test::grooved_part();
    const cda::Boundary boundary = test::boundary_of(part);
    RenderOptions options = options_for(cda::bounds(boundary), View::Iso, Projection::Perspective);
    options.background = Background::Dark;
    options.colouring = Colouring::Depth;
    test::expect_like_golden(render_boundary(boundary, test::provenance_of(part), options),
                             "export/golden/grooves.png");
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
    test::expect_like_golden(contact_sheet(pictures, caption), "export/golden/sheet.png");
}

TEST(Golden, ThePathAndABodyOverThePart) {
    const auto part = test::grooved_part();
    const cda::Boundary boundary = test::boundary_of(part);
    const Box box = cda::bounds(boundary);
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
    Box seen = box;
    seen.add(body.to_W({26, 16, 14.0 + top}));
    test::expect_like_golden(
        render_boundary(boundary, test::provenance_of(part),
                        options_for(seen, View::Iso, Projection::Orthographic), overlay),
        "export/golden/path.png");
}

}  // namespace
}  // namespace ncsim::exporter
