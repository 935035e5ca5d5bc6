// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids and sections that ncsim run writes.
#include "cli/run_program.h"
#include "support/count.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

TEST(Run, TheSolidHasTheSurfacesThatToolsLeave) {
    Folder folder;
    folder.write("drill.nc",
                 "(T1 D=6. CR=0. TAPER=118deg - drill)\n(STOCK/BLOCK,20.,20.,20.,0.,0.,20.)\n"
                 "G21 G90\nT1 M6 S5000 M3\nG0 X10. Y10. Z5.\nG1 Z-10. F100.\nG0 Z5.\nM30\n");
    const Ran ran =
        folder.run({"run", "drill.nc", "--step", "a.step", "--step-strict", "--report", "a.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    // Cube of 20 mm minus a bore of 6 mm down to the start of the tip, minus the tip.
    const double pi = std::numbers::pi, tip = 3.0 / std::tan(59.0 * pi / 180.0);
    const double left = 8000.0 - 9.0 * pi * (10.0 - tip + tip / 3.0);
    const std::string step = folder.read("a.step"), specified = "VOLUME_MEASURE(";
    ASSERT_TRUE(contains(step, specified));
    EXPECT_NEAR(std::stod(step.substr(step.find(specified) + specified.size())), left, 1e-6);
    const json report = json::parse(folder.read("a.json"));
    EXPECT_NEAR(report["step"]["volume_mm3"].get<double>(), left, 1e-3);
    EXPECT_TRUE(contains(ran.out, "step      8 faces: 6 planes, 1 cylinder, 1 cone; edges within"))
        << ran.out;
    EXPECT_EQ(ncsim::test::count(folder.read("a.step"), "CYLINDRICAL_SURFACE("), 1U);
    const Ran flat =
        folder.run({"run", "drill.nc", "-q", "--step", "a.step", "--step-surfaces", "faceted"});
    EXPECT_EQ(flat.exit_code, 0) << flat.err;
    EXPECT_EQ(ncsim::test::count(folder.read("a.step"), "CYLINDRICAL_SURFACE("), 0U);
    EXPECT_GT(ncsim::test::count(folder.read("a.step"), "ADVANCED_FACE("), 20U);
}

// The first cut must suffice, because finer cuts cost more than the whole rest of the run.
TEST(Run, SolidsOfTheSamplesHaveNoFacets) {
    Folder folder;
    for (const auto& [sample, tolerance] :
         {std::pair("simple", "0.05"), {"complex", "0.05"}, {"complex", "0.1"}, {"wave", "0.05"}}) {
        const Ran ran =
            folder.run({"run", std::string(NCSIM_SOURCE_DIR) + "/samples/" + sample + ".nc",
                        "--tool-tolerance", tolerance, "--step", "a.step", "--step-strict",
                        "--step-refine", "0"});
        EXPECT_EQ(ran.exit_code, 0) << sample << tolerance << ran.err << ran.out;
    }
}

// A ball-nose tool that turns and cuts with its side. Without surfaces for such motions, 5,605 of
// 5,709 faces are facets.
TEST(Run, SidesOfTurningToolsAreSurfaces) {
    Folder folder;
    const std::string samples = std::string(NCSIM_SOURCE_DIR) + "/samples/";
    const Ran ran =
        folder.run({"run", samples + "five-axis.nc", "--machine", samples + "machines/trt.toml",
                    "--step", "a.step", "--step-strict", "--step-refine", "0"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;
    EXPECT_TRUE(contains(ran.out, " 238 faces: 8 planes, 14 cylinders, 10 spheres, 206 envelopes"))
        << ran.out;
}

TEST(Run, CutsThePartOpenInLinesAndArcs) {
    Folder folder;
    std::string pocket = kSlot;
    pocket.replace(pocket.find("G0 X-30."), 8, "G0 X-10.");
    pocket.replace(pocket.find("G1 X30."), 7, "G1 X10.");
    folder.write("slot.nc", pocket);
    const Ran ran = folder.run({"run", "slot.nc", "--section", "z=-2", "--section", "X=0.", "--dxf",
                                "a.dxf", "--svg", "a.svg", "--report", "a.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    // 40 x 30 minus 20 x 10 minus a disc of diameter 10 mm.
    EXPECT_TRUE(
        contains(ran.out, "section   z=-2: 2 outlines, 921.46 mm2 of material; 6 lines, 2 arcs"))
        << ran.out;
    EXPECT_TRUE(contains(ran.out, "section   x=0: 1 outline, 280 mm2 of material; 8 lines"));
    EXPECT_TRUE(contains(folder.read("a.dxf"), "AC1009"));
    EXPECT_TRUE(contains(folder.read("a.svg"), "<svg"));
    const json report = json::parse(folder.read("a.json"));
    EXPECT_EQ(report["sections"][0]["plane"], "z=-2");
    EXPECT_EQ(report["sections"][0]["arcs"], 2);
    EXPECT_EQ(report["sections"][0]["lines_of_facets"], 0);
}

TEST(Run, ASectionOfFacetsSaysSo) {
    Folder folder;
    std::string ramp = kSlot;  // a V-cutter on a helix
    ramp.replace(ramp.find("CR=0."), 5, "CR=0. TAPER=45deg");
    ramp.replace(ramp.find("flat end mill"), 13, "chamfer mill");
    ramp.replace(ramp.find("G1 X30."), 7, "G2 X10. I10. Z-4.");
    ramp.replace(ramp.find("G0 X-30."), 8, "G0 X-10.");
    folder.write("ramp.nc", ramp);
    const Ran ran = folder.run({"run", "ramp.nc", "--section", "y=5", "--dxf", "-"});
    EXPECT_TRUE(contains(ran.err, "of facets of round tools")) << ran.err;
    EXPECT_TRUE(contains(ran.out, "T1-FACETS"));
}

TEST(Run, RefusesDrawingsOfNoSection) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    EXPECT_TRUE(contains(folder.run({"run", "slot.nc", "--dxf", "a.dxf"}).err, "--section z=-4"));
    const Ran ran = folder.run({"run", "slot.nc", "--section", "q=2"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "--section 'q=2': expected x=, y= or z= and a number of mm"));
}

TEST(Run, TellsWhichFacetsOfTheSolidWereKept) {
    Folder folder;
    // Half a turn of a descending V-cutter.
    folder.write("ramp.nc",
                 "(T1 D=10. CR=0. TAPER=45deg - chamfer mill)\n"
                 "(STOCK/BLOCK,60.,40.,20.,0.,0.,20.)\nG21 G90\nT1 M6 S5000 M3\n"
                 "G0 X15. Y15. Z-1.\nG2 X45. Y15. Z-4. I15. J0. F100.\nG0 Z5.\nM30\n");
    const Ran ran =
        folder.run({"run", "ramp.nc", "--step", "a.step", "--step-strict", "--report", "a.json"});
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_TRUE(contains(ran.out, "facets of round tools")) << ran.out;
    EXPECT_TRUE(contains(ran.out, ": line 6")) << ran.out;
    EXPECT_TRUE(contains(ran.err, "--step-strict")) << ran.err;
    EXPECT_TRUE(contains(folder.read("a.json"), "\"facets_kept\"")) << folder.read("a.json");
}

TEST(Run, CutsAgainWhereFacetsAreTooLargeForTheSolid) {
    Folder folder;
    // At the corner X100 Y0 the cylinder of the first line ends less than a facet from the second
    // cylinder.
    folder.write("corner.nc",
                 "(T1 D=6. CR=3. - ball end mill)\n(STOCK/BLOCK,100.,100.,40.,0.,0.,40.)\n"
                 "G21 G90\nT1 M6 S5000 M3\nG0 X0. Y0. Z20.\nG1 X83.333 Y0. Z-4.168 F1500.\n"
                 "X100. Y0. Z-6.265\nX100. Y25. Z-6.265\nG0 Z20.\nM30\n");
    const Ran finer =
        folder.run({"run", "corner.nc", "--step", "a.step", "--step-strict", "--report", "a.json"});
    EXPECT_EQ(finer.exit_code, 0) << finer.err;
    EXPECT_TRUE(contains(finer.out, "from a cut with round tools within 0.0")) << finer.out;
    EXPECT_TRUE(contains(folder.read("a.json"), "\"refined_to_mm\": 0.0"));
    const Ran once = folder.run({"run", "corner.nc", "--step", "a.step", "--step-refine", "0"});
    EXPECT_EQ(once.exit_code, 0) << once.err;
    EXPECT_TRUE(contains(once.out, "of the planes are facets of round tools")) << once.out;
}

// The helix is narrower than the ball. No cut recognises its surfaces.
constexpr const char* kHelixOfBall =
    "(T1 D=4. CR=2. - ball end mill)\n(STOCK/BLOCK,30.,30.,10.,15.,15.,10.)\nG21 G90 G17\n"
    "T1 M6 S3000 M3\nG0 X2.215 Y-1.103 Z5.\nG1 Z0. F300.\n"
    "G3 X2.215 Y-1.103 Z-2.9 I-1.371 J0.\n"
    "G1 X10.23 Y1.355\nG0 Z5.\nM30\n";

TEST(Run, KeepsTheWorkOfASolidWithinABudget) {
    Folder folder;
    folder.write("helix.nc", kHelixOfBall);
    const Ran ran = folder.run({"run", "helix.nc", "--tool-tolerance", "0.01", "--step", "a.step",
                                "--report", "a.json", "--threads", "1"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "          to limit the work, ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "not tried; --step-refine 6 has no limit\n")) << ran.out;
    const json cuts = json::parse(folder.read("a.json"))["step"]["cuts"];
    EXPECT_GE(cuts["not_tried"], 4);
    EXPECT_LE(cuts["made"], 2);
    const Ran again = folder.run(
        {"run", "helix.nc", "--tool-tolerance", "0.01", "--step", "b.step", "--threads", "2"});
    EXPECT_TRUE(folder.read("a.step") == folder.read("b.step")) << "counted, not timed";
    const Ran asked = folder.run(
        {"run", "helix.nc", "--step", "a.step", "--report", "a.json", "--step-refine", "1"});
    EXPECT_FALSE(contains(asked.out, "to limit the work")) << asked.out;
    EXPECT_EQ(json::parse(folder.read("a.json"))["step"]["cuts"]["made"], 1);
}

TEST(Run, NamesTheVolumeOfTheSolidAndOfThePolyhedron) {
    Folder folder;
    folder.write("bore.nc",
                 "(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,30.,30.,10.,15.,15.,10.)\n"
                 "G21 G90 G17\nT1 M6 S3000 M3\nG0 X0. Y0. Z5.\nG1 Z-8. F300.\nG0 Z5.\nM30\n");
    const Ran ran = folder.run({"run", "bore.nc", "--step", "a.step", "--report", "a.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const json report = json::parse(folder.read("a.json"));
    const double whole = report["step"]["volume_mm3"], polyhedron = report["volume_mm3"]["part"];
    EXPECT_NEAR(whole, 9000.0 - 200.0 * std::numbers::pi, 1e-3);
    EXPECT_GT(std::abs(whole - polyhedron), 1e-2);
    EXPECT_TRUE(contains(ran.out, fmt::format("          {:.3f} cm3 inside the true surfaces; the "
                                              "polyhedron has {:.3f} cm3\n",
                                              whole / 1000.0, polyhedron / 1000.0)))
        << ran.out;
}

// Only the second finer cut has no facets. The part is small, so the budget allows the cut.
TEST(Run, CutsSmallPartsAgainThoughItDidNotHelpOnce) {
    Folder folder;
    folder.write("ring.nc",
                 "(T1 D=0.5 CR=0. - flat end mill)\n(STOCK/BLOCK,20.,20.,3.,0.,0.,3.)\n"
                 "G17 G21 G90 G94 G54\nT1 M6\nS5000 M3 F300\nG0 X9 Y10 Z1\nG1 Z-1\n"
                 "G3 X9 Y10 I1 J0\nG0 Z1\nX8.47\nG1 Z-1\nG3 X8.47 Y10 I1.53 J0\nG0 Z1\n");
    const auto run = [&](const std::string& times) {
        return folder.run({"run", "ring.nc", "--draft", "--tolerance", "0.05", "--tool-tolerance",
                           "0.05", "--step", "a.step", "--step-strict", "--step-refine", times});
    };
    const Ran once = run("1"), often = run("2");
    EXPECT_EQ(once.exit_code, 2) << once.out;
    EXPECT_EQ(often.exit_code, 0) << often.err;
    EXPECT_TRUE(contains(often.out, "14 faces: 10 planes, 4 cylinders")) << often.out;
    const Ran within_budget =
        folder.run({"run", "ring.nc", "--draft", "--tolerance", "0.05", "--tool-tolerance", "0.05",
                    "--step", "a.step", "--step-strict"});
    EXPECT_EQ(within_budget.exit_code, 0) << within_budget.out;
}

TEST(Run, TheWavesOfTheSampleAreWhole) {
    Folder folder;
    const Ran ran = folder.run({"run", std::string(NCSIM_SOURCE_DIR) + "/samples/wave.nc", "--step",
                                "a.step", "--step-strict"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "885 cylinders")) << ran.out;
    EXPECT_FALSE(contains(ran.out, "from a cut with")) << ran.out;
}

TEST(Run, ASolidOfTooManyFacesIsRefused) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran =
        folder.run({"run", "slot.nc", "-q", "--step", "a.step", "--step-max-faces", "5"});
    EXPECT_EQ(ran.exit_code, 2);
    // A block with a slot through the block: ten faces.
    EXPECT_TRUE(contains(ran.err, "the part has 10 faces, more than the 5")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "--step-max-faces")) << ran.err;
    EXPECT_FALSE(folder.has("a.step"));
}

}  // namespace
}  // namespace ncsim::cli_test
