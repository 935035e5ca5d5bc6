// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs: the surface in the written file is closed, whatever the program does, and the
// same for both models.
#include "support/random_programs.h"

#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/gltf.h"
#include "ncsim/export/stl.h"
#include "ncsim/export/vrml.h"
#include "ncsim/mesh/simplify.h"

#include "support/written_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

namespace ncsim::exporter {
namespace {

using ncsim::test::MilledPart;
using ncsim::test::NcProgram;
using ncsim::test::Soundness;

const cda::TreeCda kTree{cda::TreeParameters{}};

std::string stl_of(const MilledPart& part) {
    std::ostringstream out;
    write_stl(out, cda::triangulate(part.boundary));
    return out.str();
}

std::string glb_of(const MilledPart& part) {
    std::ostringstream out;
    write_gltf(out, part.boundary, part.provenance);
    return out.str();
}

std::string vrml_of(const MilledPart& part) {
    std::ostringstream out;
    write_vrml(out, mesh::simplify(part.boundary, mesh::kFlatTolerance, &part.provenance).boundary,
               part.provenance);
    return out.str();
}

void expect_sound(const ncsim::test::WrittenMesh& mesh, const MilledPart& part) {
    const Soundness found = ncsim::test::soundness(mesh);
    EXPECT_TRUE(found.is_sound()) << to_string(found);
    // Each corner is within half a float and a step of its exact place.
    const double step = std::ldexp(1.0, std::ilogb(found.largest) - 23);
    EXPECT_NEAR(found.volume, part.volume, 2.0 * step * found.area);
}

TEST(RandomPrograms, LeaveAClosedSurfaceInFloats) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const MilledPart part = mill(ncsim::test::random_program(seed), kTree);
        expect_sound(ncsim::test::read_stl(stl_of(part)), part);
        expect_sound(ncsim::test::read_glb(glb_of(part)), part);
    }
}

// Two moves of an engraver. Rounding lays an edge upon a second edge, which must not occur four
// times in the file.
TEST(RandomPrograms, TwoMovesOfAnEngraverLeaveAClosedSurface) {
    const NcProgram program{.text =
                                "G21 G90 G17\n"
                                "T1 M6\n"
                                "S1000 M3 F500\n"
                                "G0 X31.69 Y-22.89 Z-10\n"
                                "G1 X39.84 Y-20.74 Z-15.78\n"
                                "G1 X37.30 Y-22.57 Z-16.00\n"
                                "M30\n",
                            .stock = "29.94,-24.21,-15.91:39.94,-18.21,-14.91",
                            .tools = {"T1=v:D3:L20:A86"},
                            .tolerance_mm = 0.006,
                            .tool_tolerance_mm = 0.01};
    const MilledPart part = mill(program, kTree);
    expect_sound(ncsim::test::read_stl(stl_of(part)), part);
    expect_sound(ncsim::test::read_glb(glb_of(part)), part);
}

// Hulls of a rotating tool have corners that are equal except for the last bits.
TEST(RandomPrograms, OfTurningToolsAreTheSameForBothModels) {
    for (const std::uint64_t seed : {14, 30, 75, 97}) {
        SCOPED_TRACE(seed);
        const NcProgram program = ncsim::test::random_program(seed, true);
        const MilledPart tree = mill(program, kTree);
        const MilledPart flat = mill(program, cda::FlatCda());
        EXPECT_TRUE(stl_of(tree) == stl_of(flat));
        EXPECT_TRUE(glb_of(tree) == glb_of(flat));
        EXPECT_TRUE(vrml_of(tree) == vrml_of(flat));
        expect_sound(ncsim::test::read_stl(stl_of(tree)), tree);
    }
}

}  // namespace
}  // namespace ncsim::exporter
