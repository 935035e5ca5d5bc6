// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests STEP files. OpenCASCADE checks that the files are valid solids (read_step.cpp).
#include "ncsim/export/step.h"

#include "support/box_part.h"
#include "support/count.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <variant>

namespace ncsim::exporter {
namespace {

std::string written(const cda::Boundary& boundary, const mesh::Provenance& provenance) {
    std::ostringstream out;
    write_step(out, boundary, provenance);
    return out.str();
}

std::string box_text() {
    test::BoxPart box;
    box.stock = {{0, 0, 0}, {2, 2, 2}};
    return written(test::boundary_of(box), test::provenance_of(box));
}

TEST(WriteStep, ABoxHasSharedPointsEdgesAndDirections) {
    const std::string text = box_text();
    EXPECT_EQ(ncsim::test::count(text, "=VERTEX_POINT("), 8U);
    EXPECT_EQ(ncsim::test::count(text, "=EDGE_CURVE("), 12U);
    EXPECT_EQ(ncsim::test::count(text, "=ADVANCED_FACE('STOCK'"), 6U);
    EXPECT_EQ(ncsim::test::count(text, "=DIRECTION("), 6U);
    // The count includes the origin and the centroid of the part.
    EXPECT_EQ(ncsim::test::count(text, "=CARTESIAN_POINT("), 10U);
}

TEST(WriteStep, NamesFacesAfterTheirLines) {
    const auto part = test::grooved_part();
    const std::string text = written(test::boundary_of(part), test::provenance_of(part));
    EXPECT_EQ(ncsim::test::count(text, "ADVANCED_FACE('LINE_10_20_30'"),
              1U);  // floor of the groove
    EXPECT_GT(ncsim::test::count(text, "ADVANCED_FACE('LINE_40'"), 0U);
}

// Readers would shift the plane into its corner, and find all other corners off the plane.
TEST(WriteStep, PlanesStayWhereTheyAreIfTheirCornersAreOff) {
    test::BoxPart box;
    box.stock = {{0, 0, 0}, {2, 2, 2}};
    brep::Part part = flat_solid(test::boundary_of(box), 0.0).part;
    for (brep::Face& face : part.faces) {
        brep::Plane& plane = std::get<brep::Plane>(face.surface.form);
        if (plane.normal.x > 0.5) plane.origin.x += 1e-5;
    }
    std::ostringstream out;
    write_step_solid(out, part, test::provenance_of(box));
    EXPECT_EQ(ncsim::test::count(out.str(), "=CARTESIAN_POINT('',(2.00001,"), 1U);
}

// gmsh and FreeCAD show the names of products, and solids of one product have none.
TEST(WriteStep, SeveralSolidsAreProductsOfAnAssembly) {
    test::BoxPart box;
    box.stock = {{0, 0, 0}, {6, 2, 2}};
    box.cuts = {{{2, -1, -1}, {3, 3, 3}}};
    const std::string text = written(test::boundary_of(box), test::provenance_of(box));
    EXPECT_EQ(ncsim::test::count(text, "=PRODUCT("), 3U) << text;
    EXPECT_EQ(ncsim::test::count(text, "=PRODUCT('SOLID_1','SOLID_1'"), 1U);
    EXPECT_EQ(ncsim::test::count(text, "=PRODUCT('SOLID_2','SOLID_2'"), 1U);
    EXPECT_EQ(ncsim::test::count(text, "=NEXT_ASSEMBLY_USAGE_OCCURRENCE("), 2U);
    EXPECT_EQ(ncsim::test::count(text, "=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION("), 2U);
    EXPECT_EQ(ncsim::test::count(text, "=ADVANCED_BREP_SHAPE_REPRESENTATION("), 2U);
    EXPECT_EQ(ncsim::test::count(text, "VOLUME_MEASURE(24.)"), 0U);
    EXPECT_EQ(ncsim::test::count(text, "VOLUME_MEASURE(20.)"), 1U);
    EXPECT_EQ(ncsim::test::count(text, "VOLUME_MEASURE(8.)"), 1U);
    EXPECT_EQ(ncsim::test::count(text, "VOLUME_MEASURE(12.)"), 1U);
    EXPECT_EQ(ncsim::test::count(box_text(), "NEXT_ASSEMBLY_USAGE_OCCURRENCE("), 0U);
}

TEST(WriteStep, WritesOtherAlphabetsByNumber) {
    mesh::Provenance provenance;
    provenance.program = "M\xC3\xBC'ller\\\xF0\x9F\x94\xA7.nc";
    EXPECT_EQ(ncsim::test::count(written({}, provenance),
                                 "'M\\X2\\00FC\\X0\\''ller\\\\\\X4\\0001F527\\X0\\.nc'"),
              3U);
}

TEST(WriteStep, APartOfWhichNothingIsLeftHasNoSolid) {
    const std::string text = written({}, {});
    EXPECT_EQ(ncsim::test::count(text, "BREP"), 0U);
    EXPECT_EQ(ncsim::test::count(text, "END-ISO-10303-21;"), 1U);
}

TEST(WriteStep, RefusesMoreFacesThanAskedFor) {
    const auto part = test::grooved_part();
    std::ostringstream out;
    EXPECT_THROW(write_step(out, test::boundary_of(part), {}, {.max_faces = 24}),
                 std::runtime_error);
    EXPECT_EQ(out.str(), "");
    EXPECT_NO_THROW(write_step(out, test::boundary_of(part), {}, {.max_faces = 25}));
}

TEST(WriteStep, TellsVolumeAreaAndCentroid) {
    const std::string text = box_text();
    EXPECT_EQ(ncsim::test::count(text, "VOLUME_MEASURE(8.)"), 1U);
    EXPECT_EQ(ncsim::test::count(text, "AREA_MEASURE(24.)"), 1U);
    EXPECT_EQ(ncsim::test::count(text, "CARTESIAN_POINT('centre point',(1.,1.,1.))"), 1U);
    EXPECT_EQ(ncsim::test::count(text, "MANIFOLD_SOLID_BREP('SOLID_1'"), 1U);
}

TEST(WriteStep, IsAp242OrAp214) {
    test::BoxPart box;
    box.stock = {{0, 0, 0}, {2, 2, 2}};
    for (const StepSchema schema : {StepSchema::Ap242, StepSchema::Ap214}) {
        const bool is_242 = schema == StepSchema::Ap242;
        std::ostringstream out;
        write_step(out, test::boundary_of(box), test::provenance_of(box), {.schema = schema});
        const std::string text = out.str();
        EXPECT_EQ(ncsim::test::count(text, "AP242_MANAGED_MODEL"), is_242 ? 1U : 0U);
        EXPECT_EQ(ncsim::test::count(text, "AUTOMOTIVE_DESIGN"), is_242 ? 0U : 1U);
    }
}

TEST(WriteStep, HangsLinesToolsAndKindOnFacesIfAskedTo) {
    const auto part = test::grooved_part();
    const cda::Boundary boundary = test::boundary_of(part);
    const auto text_of = [&](const StepOptions& options) {
        std::ostringstream out;
        write_step(out, boundary, test::provenance_of(part), options);
        return out.str();
    };
    EXPECT_EQ(ncsim::test::count(text_of({}), "user defined attribute"), 0U);
    const std::string text = text_of({.has_attributes = true});
    const std::size_t faces = ncsim::test::count(text, "=ADVANCED_FACE(");
    EXPECT_EQ(ncsim::test::count(text, "=GEOMETRIC_ITEM_SPECIFIC_USAGE("), faces);
    EXPECT_EQ(ncsim::test::count(text, "'user defined attribute'"), 3U * faces);
    // Equal values are written once.
    EXPECT_EQ(ncsim::test::count(text, "DESCRIPTIVE_REPRESENTATION_ITEM('nc_lines','10 20 30')"),
              1U);
    EXPECT_EQ(ncsim::test::count(text, "DESCRIPTIVE_REPRESENTATION_ITEM('kind','plane')"), 1U);
    const std::string older = text_of({.schema = StepSchema::Ap214, .has_attributes = true});
    EXPECT_EQ(ncsim::test::count(older, "GEOMETRIC_ITEM_SPECIFIC_USAGE"), 0U);
    EXPECT_EQ(ncsim::test::count(older, "'user defined attribute'"), 3U * faces);
}

TEST(WriteStep, SaysTheSameTwice) {
    EXPECT_EQ(box_text(), box_text());
}

TEST(WriteStep, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_step(out, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
