// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim measure: holes, pockets and further features of a part.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

// A through hole, a blind hole, and a pocket of 20 x 30 mm with corner radius 5 mm.
constexpr const char* kPlate =
    "(T1 D=10. CR=0. - flat end mill)\n"
    "(T2 D=6. CR=0. TAPER=118deg - drill)\n"
    "(STOCK/BLOCK,60.,50.,12.,0.,0.,12.)\n"
    "G21 G90 G17 F300 S5000 M3\n"
    "T1 M6\n"
    "G0 X15 Y15 Z5\n"
    "G1 Z-4.5\n"
    "G1 X25\n"
    "G1 Y35\n"
    "G1 X15\n"
    "G1 Y15\n"
    "G0 Z5\n"
    "T2 M6\n"
    "G0 X45 Y15 Z5\n"
    "G1 Z-8\n"
    "G0 Z5\n"
    "G0 X45 Y35\n"
    "G1 Z-15\n"
    "G0 Z5\n"
    "M30\n";

TEST(Measure, ListsWhatACalliperWouldFind) {
    Folder folder;
    folder.write("plate.nc", kPlate);
    const Ran ran = folder.run({"measure", "plate.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.out,
              "part       60 x 50 x 12 mm, X 0 to 60, Y 0 to 50, Z -12 to 0; 32.865 cm3\n"
              "bores      D6        6.197 deep, 8 to the tip of 118°; X45 Y15, from Z0; T2, line "
              "15\n"
              "           D6        through, 12 deep; X45 Y35, from Z0; T2, line 18\n"
              "floors     Z0        0 below the top, 12 above the bottom; 60 x 50, 2364.91 mm2; "
              "stock\n"
              "           Z-4.5     4.5 below the top, 7.5 above the bottom; 20 x 30, 578.54 mm2, "
              "walls all round; T1, line 7, 8, 9, 10, 11\n"
              "inside     20        along X; at X20 Y25 Z-2.25; T1, line 9, 11\n"
              "           30        along Y; at X20 Y25 Z-2.25; T1, line 8, 10\n"
              "outside    7.5       along Z; at X20 Y25 Z-8.25; T1, line 7, 8, 9, 10, 11\n"
              "           10        along X; at X5 Y25 Z-2.25; T1, line 11\n"
              "           10        along Y; at X20 Y5 Z-2.25; T1, line 8\n"
              "           10        along Y; at X20 Y45 Z-2.25; T1, line 10\n"
              "           12        along Z; at X30 Y5 Z-6; stock\n"
              "           30        along X; at X45 Y25 Z-2.25; T1, line 9\n"
              "corners    R5        inside, 4 of them; T1, line 7, 8, 9, 10\n");
}

TEST(Measure, SaysTheSameAsJson) {
    Folder folder;
    folder.write("plate.nc", kPlate);
    const Ran ran = folder.run({"measure", "plate.nc", "--json", "-", "-q"});
    EXPECT_EQ(folder.run({"measure", "plate.nc", "-q"}).out,
              folder.run({"measure", "plate.nc"}).out);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const json sheet = json::parse(ran.out);
    ASSERT_EQ(sheet["bores"].size(), 2U);
    EXPECT_EQ(sheet["bores"][0]["diameter_mm"], 6.0);
    EXPECT_EQ(sheet["bores"][0]["end"], "cone");
    EXPECT_EQ(sheet["bores"][0]["tip_depth_mm"], 8.0);
    EXPECT_EQ(sheet["bores"][0]["tip_angle_degrees"], 118.0);
    EXPECT_EQ(sheet["bores"][1]["through"], true);
    EXPECT_EQ(sheet["bores"][1]["lines"], json::array({18}));
    EXPECT_EQ(sheet["bores"][1]["tools"], json::array({2}));
    EXPECT_EQ(sheet["floors"][1]["below_top_mm"], 4.5);
    EXPECT_EQ(sheet["floors"][1]["walls_all_round"], true);
    EXPECT_EQ(sheet["distances"][0]["between"], "void");
    EXPECT_EQ(sheet["distances"][0]["mm"], 20.0);
    EXPECT_EQ(sheet["not_measured"]["facets"], 0);
}

// A core hole with a countersink and a thread of two turns by a mill of 8 mm, a tapped hole, and a
// chamfered edge.
constexpr const char* kThreads =
    "(T1 D=10. CR=0. - flat end mill)\n"
    "(T2 D=5. CR=0. TAPER=118deg - drill)\n"
    "(T3 D=20. CR=0. TAPER=45deg - chamfer mill)\n"
    "(STOCK/BLOCK,60.,50.,12.,0.,0.,12.)\n"
    "G21 G90 G17 F300 S5000 M3\n"
    "T1 M6\nG0 X20 Y25 Z5\nG1 Z-13\nG1 X20.2\nG3 X20.2 Y25 I-0.2 J0\nG1 X20\nG0 Z5\n"
    "T3 M6\nG0 X20 Y25 Z5\nG1 Z-6\nG0 Z5\nG0 X-15 Y-3\nG1 Z-3.5\nG1 X75\nG0 Z5\n"
    "T2 M6\nG0 X45 Y25 Z5\nG1 Z-11\nG0 Z5\n"
    "T5 M6\nG0 X45 Y25 Z5\nG84 Z-8 R2 F1\nG80\nG0 Z5\n"
    "T4 M6\nG0 X20 Y25 Z5\nG0 Z-10\nG1 X22.25\nG3 X22.25 Y25 Z-8.25 I-2.25 J0\n"
    "G3 X22.25 Y25 Z-6.5 I-2.25 J0\nG1 X20\nG0 Z5\nM30\n";

TEST(Measure, ListsThreadsCountersinksAndChamfers) {
    Folder folder;
    folder.write("threads.nc", kThreads);
    const Ran ran = folder.run({"measure", "threads.nc", "--tool", "T4=slot:D8:L1", "--tool",
                                "T5=tap:D6:K1", "--json", "a.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("threads    D6        inside, pitch 1, 8 deep; X45 Y25, from Z0; T5"),
              std::string::npos)
        << ran.out;
    EXPECT_NE(
        ran.out.find("           D12.5     inside, pitch 1.75, 10 deep; X20 Y25, from Z0; T4"),
        std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("csk        D12       90°, 0.8 deep; X20 Y25, from Z0; T3"),
              std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("chamfers   0.5 x 45° 1 of them; T3"), std::string::npos) << ran.out;
    const json sheet = json::parse(folder.read("a.json"));
    ASSERT_EQ(sheet["threads"].size(), 2U);
    EXPECT_EQ(sheet["threads"][1]["diameter_mm"], 12.5);
    EXPECT_EQ(sheet["threads"][1]["pitch_mm"], 1.75);
    EXPECT_EQ(sheet["threads"][1]["depth_mm"], 10.0);
    EXPECT_EQ(sheet["threads"][1]["inside"], true);
    ASSERT_EQ(sheet["countersinks"].size(), 1U);
    EXPECT_EQ(sheet["countersinks"][0]["diameter_mm"], 12.0);
    EXPECT_EQ(sheet["countersinks"][0]["tip"], false);
    ASSERT_EQ(sheet["chamfers"].size(), 1U);
    EXPECT_EQ(sheet["chamfers"][0]["width_mm"], 0.5);
}

// A stud of 10 mm: the mill runs around the stud.
TEST(Measure, KnowsAThreadOnAStud) {
    Folder folder;
    folder.write("stud.nc",
                 "(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,50.,50.,20.,25.,25.,20.)\n"
                 "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X10 Y0 Z5\nG1 Z-12\n"
                 "G2 X10 Y0 I-10\nG0 Z5\nT2 M6\nG0 X20 Y0 Z5\nG0 Z-8\nG1 X8.5\n"
                 "G2 X8.5 Y0 Z-6.5 I-8.5\nG2 X8.5 Y0 Z-5 I-8.5\nG1 X20\nG0 Z5\nM30\n");
    const Ran ran = folder.run({"measure", "stud.nc", "--tool", "T2=slot:D8:L1"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("threads    D9        outside, pitch 1.5, 8 deep; X0 Y0, from Z0; T2"),
              std::string::npos)
        << ran.out;
}

TEST(Measure, SaysWhatItDidNotMeasure) {
    Folder folder;
    std::string helix = kSlot;
    helix.replace(helix.find("CR=0."), 5, "CR=0. TAPER=45deg");
    helix.replace(helix.find("flat end mill"), 13, "chamfer mill");
    helix.replace(helix.find("G0 X-30."), 8, "G0 X-10.");
    helix.replace(helix.find("G1 X30."), 7, "G2 X10. I10. Z-4.");
    folder.write("helix.nc", helix);
    const Ran ran = folder.run({"measure", "helix.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("not measured: line 8"), std::string::npos) << ran.out;
}

TEST(Measure, OfWhatIsNotSimulatedNothing) {
    Folder folder;
    folder.write("part.nc", "G21 G90 T7 M6\nG1 X10. F100.\nM30\n");
    const Ran ran = folder.run({"measure", "part.nc", "--json", "a.json"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_FALSE(folder.has("a.json"));
    EXPECT_EQ(folder.run({"measure", "none.nc"}).exit_code, 2);
}

}  // namespace
}  // namespace ncsim::cli_test
