// SPDX-License-Identifier: GPL-3.0-or-later
//
// Both halves of a mesh are closed, and together have its volume.
#include "ncsim/mesh/open_mesh.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/triangulate.h"

#include "support/box_part.h"
#include "support/polytope_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ncsim::mesh {
namespace {

CutPlane plane(int axis, double side, double at) {
    CutPlane cut;
    cut.normal[axis] = side;
    cut.offset = side * at;
    return cut;
}

// Returns the volume of the half, which must be closed and lie behind the plane.
double volume_of_half(const cda::Boundary& part, const CutPlane& cut) {
    const TriangleMesh whole = cda::triangulate(part);
    const auto faces = static_cast<std::uint32_t>(part.faces.size());
    const OpenMesh half = open_mesh(whole, faces, cut);
    EXPECT_EQ(cda::check(half.mesh).unpaired_edges, 0U);
    EXPECT_EQ(half.mesh.triangles.size(), half.mesh.face.size());
    for (std::size_t t = 0; t < half.mesh.triangles.size(); ++t) {
        const bool is_old = half.mesh.face[t] < faces;
        EXPECT_EQ(is_old, t < half.old_triangle.size());
        if (is_old) {
            EXPECT_EQ(half.mesh.face[t], whole.face[half.old_triangle[t]]);
        }
        for (const std::uint32_t v : half.mesh.triangles[t]) {
            const double height = dot(cut.normal, half.mesh.vertices[v]) - cut.offset;
            EXPECT_LE(height, 2e-6);
            if (!is_old) {
                EXPECT_NEAR(height, 0.0, 2e-6);
            }
        }
    }
    return cda::volume(half.mesh);
}

void expect_halves(const cda::Boundary& part, int axis, double at) {
    SCOPED_TRACE(::testing::Message() << "axis " << axis << " at " << at);
    const double lower = volume_of_half(part, plane(axis, 1.0, at));
    const double upper = volume_of_half(part, plane(axis, -1.0, at));
    const double whole = cda::volume(part);
    EXPECT_GE(lower, -1e-9);
    EXPECT_GE(upper, -1e-9);
    EXPECT_NEAR(lower + upper, whole, 1e-9 * whole + 1e-4);
}

TEST(OpenMesh, ABoxKeepsTheShareBehindThePlane) {
    test::BoxPart box;
    box.stock = {{0, 0, 0}, {10, 4, 5}};
    const cda::Boundary part = test::boundary_of(box);
    EXPECT_NEAR(volume_of_half(part, plane(0, 1.0, 2.5)), 50.0, 1e-9);
    EXPECT_NEAR(volume_of_half(part, plane(0, -1.0, 2.5)), 150.0, 1e-9);
    // Faces in the plane.
    EXPECT_NEAR(volume_of_half(part, plane(2, 1.0, 3.0)), 120.0, 1e-3);
    EXPECT_NEAR(volume_of_half(part, plane(2, 1.0, 5.0)), 200.0, 1e-9);
    EXPECT_EQ(volume_of_half(part, plane(2, 1.0, -1.0)), 0.0);
}

TEST(OpenMesh, HalvesAreClosedAndTogetherTheWhole) {
    const cda::Boundary polytopes = test::polytope_part().boundary();
    for (const cda::Boundary& part :
         {test::boundary_of(test::grooved_part()), test::boundary_of(test::raster_part()),
          test::boundary_of(test::raster_part().tilted()), test::boundary_of(test::hollow_part()),
          test::boundary_of(test::halved_part()), test::plate_with_hole(), polytopes}) {
        const Box box = cda::bounds(part);
        for (int axis = 0; axis < 3; ++axis) {
            for (const double share : {0.1, 0.25, 0.5, 0.61803, 0.75, 0.97})
                expect_halves(part, axis, box.min[axis] + share * box.size()[axis]);
        }
    }
}

// Planes through vertices that lie in no regular position.
TEST(OpenMesh, PlanesThroughVertices) {
    const cda::Boundary part = test::polytope_part().boundary();
    for (std::size_t v = 0; v < part.vertices.size(); v += 97) {
        for (int axis = 0; axis < 3; ++axis)
            expect_halves(part, axis, part.vertices[v][axis]);
    }
}

}  // namespace
}  // namespace ncsim::mesh
