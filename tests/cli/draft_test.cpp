// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drafts of incomplete programs: guesses must be requested, are named, and never make a verdict.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

const std::string kHead = "G21 G90 G17 S1000 M3 F500\nT3 M6\nG0 X0 Y0 Z5\n";

// Returns the tool that the error message suggests for a program without tool description.
std::string guess_for(const std::string& cuts) {
    Folder folder;
    folder.write("a.nc", cuts + "M30\n");
    const Ran ran = folder.run({"run", "a.nc", "-q", "--png", "a.png"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_FALSE(folder.has("a.png"));
    const std::string option = "--assume-tool ";
    const std::size_t at = ran.err.find(option);
    EXPECT_NE(at, std::string::npos) << ran.err;
    if (at == std::string::npos) return {};
    const std::size_t begin = at + option.size();
    return ran.err.substr(begin, ran.err.find(',', begin) - begin);
}

TEST(Guess, OfAToolFollowsFromItsMoves) {
    const std::string down = "G1 Z-3\n";
    EXPECT_EQ(guess_for(kHead + down + "X100\nY80\nX0\nY0\n"), "flat:D6");
    EXPECT_EQ(guess_for(kHead + down + "X100\nG2 X102 Y-2 J-2\nG1 Y80\nX0\n"), "flat:D4") << "arc";
    EXPECT_EQ(guess_for(kHead + down + "X12\nY8\nX0\nY0\n"), "flat:D2") << "a quarter of 8 mm";
    std::string pocket = kHead + down;
    std::string surface = kHead + "G1 Z0\n";
    std::string letters = kHead;
    for (int i = 0; i < 20; ++i) {
        const std::string y = "Y" + std::to_string(1.2 * i);
        pocket += y + (i % 2 == 0 ? " \nX100\n" : " \nX0\n");
        for (int x = 1; x < 20; ++x) {
            const std::string at = std::to_string(i % 2 == 0 ? 3 * x : 60 - 3 * x);
            surface += "X" + at + " " + y + " Z-" + std::to_string(x % 7) + "\n";
            letters += "G1 Z-0.4\nX" + std::to_string(0.5 * x) + " " + y + "\n";
        }
    }
    EXPECT_EQ(guess_for(pocket), "flat:D3") << "steps of 1.2 mm";
    EXPECT_EQ(guess_for(surface), "ball:D5") << "a quarter of 22.8 mm";
    EXPECT_EQ(guess_for(letters), "v:D6:A60");
    EXPECT_EQ(guess_for(kHead + "G81 X10 Y10 Z-5 R1\nX20\nX30\nG80\n"), "drill:D5");
    EXPECT_EQ(guess_for(kHead + "G81 X10 Y10 Z-5 R1\nX20\nX30\nX31.5\nG80\n"), "drill:D1")
        << "holes 1.5 mm apart";
    EXPECT_EQ(guess_for("G20 G90 S1000 M3 F20\nT3 M6\nG0 X0 Y0 Z0.2\nG1 Z-0.1\nX4\nY4\nX0\n"),
              "flat:D1/4in");
}

TEST(Draft, MakesAPictureAndSaysWhatItGuessed) {
    Folder folder;
    folder.write("a.nc", kHead + "G1 Z-3\nX100\nY80\nX0\nY0\nG0 Z5\nM30\n");
    const Ran ran = folder.run({"run", "a.nc", "--draft", "--png", "a.png", "--size", "400x300"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "flat end mill D6")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "assumed: flat:D6, a guess from its moves")) << ran.err;
    // The picture lists the guesses below the part.
    const std::string png = folder.read("a.png");
    ASSERT_GT(png.size(), 24U);
    const auto byte = [&png](std::size_t i) { return static_cast<unsigned char>(png[i]); };
    const unsigned height = 256U * byte(22) + byte(23);
    EXPECT_GT(height, 300U);
    // A described tool is not guessed.
    const Ran specified = folder.run({"run", "a.nc", "--draft", "--tool", "T3=flat:D8"});
    EXPECT_FALSE(contains(specified.err, "a guess")) << specified.err;
    // A tool that --draft guesses is missing information for check.
    EXPECT_EQ(folder.run({"check", "a.nc", "-q"}).exit_code, 4);
}

TEST(Draft, OfRapidMovesAloneIsADrawing) {
    Folder folder;
    folder.write("air.nc", "G21 G90\nG0 X0 Y0 Z5\nX50\nY50 Z20\nM2\n");
    const Ran refused = folder.run({"run", "air.nc", "--png", "a.png"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_TRUE(contains(refused.err, "for a picture of its path: --draft")) << refused.err;
    const Ran ran = folder.run({"run", "air.nc", "--draft", "--caption", "--png", "a.png"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "only rapid ones; it is drawn as a path")) << ran.err;
    EXPECT_FALSE(contains(ran.out + ran.err, "nan")) << ran.out << ran.err;
    // A different path of equal length and size makes a different picture.
    const std::string before = folder.read("a.png");
    folder.write("air.nc", "G21 G90\nG0 X0 Y0 Z5\nY50\nX50 Z20\nM2\n");
    folder.run({"run", "air.nc", "--draft", "--caption", "--png", "a.png", "-q"});
    EXPECT_NE(folder.read("a.png"), before);
    EXPECT_EQ(folder.run({"check", "air.nc", "-q"}).exit_code, 4);
}

// Returns a curve of `count` points along 120 mm.
std::string curve_of(int count) {
    std::string program = kHead + "G1 Z-3\n";
    for (int i = 0; i < count; ++i) {
        const double x = 120.0 * i / count;
        program += "X" + std::to_string(x) + " Y" + std::to_string(x * x / 1600.0) + "\n";
    }
    return program + "G0 Z5\nM30\n";
}

json report_of_run(const Folder& folder, const std::string& tool,
                   const std::vector<std::string>& options) {
    std::vector<std::string> command{"run", "a.nc", "--tool", "T3=" + tool, "--report", "r.json"};
    command.insert(command.end(), options.begin(), options.end());
    EXPECT_EQ(folder.run(command).exit_code, 0);
    return json::parse(folder.read("r.json"));
}

TEST(Draft, IsCoarserTheLargerTheBlock) {
    Folder folder;
    // A hull of a ball counts as three: 12,600 in total, more than the limit of a short program.
    folder.write("a.nc", curve_of(4200));
    const json exact = report_of_run(folder, "ball:D8", {});
    const json draft = report_of_run(folder, "ball:D8", {"--draft"});
    EXPECT_GT(exact["model"]["hulls"], 4100);
    EXPECT_LT(draft["model"]["hulls"], 60);
    EXPECT_EQ(exact["accuracy_mm"]["chord_tolerance"], 0.005);
    EXPECT_GT(draft["accuracy_mm"]["chord_tolerance"], 0.08);
    EXPECT_GT(draft["accuracy_mm"]["tool_tolerance"], 0.3);
    // A draft serves for a picture, and the picture is nearly the same.
    const double one = exact["volume_mm3"]["removed"];
    const double other = draft["volume_mm3"]["removed"];
    EXPECT_NEAR(other, one, 0.05 * one);
    const json specified = report_of_run(
        folder, "ball:D8", {"--draft", "--tolerance", "0.01", "--tool-tolerance", "0.1"});
    EXPECT_EQ(specified["accuracy_mm"]["chord_tolerance"], 0.01);
    EXPECT_EQ(specified["accuracy_mm"]["tool_tolerance"], 0.1);
}

TEST(Draft, OfAShortProgramIsExact) {
    Folder folder;
    folder.write("a.nc", curve_of(300));
    const Ran ran = folder.run({"run", "a.nc", "--draft", "--tool", "T3=flat:D8"});
    EXPECT_TRUE(contains(ran.err, "exact: the program is short")) << ran.err;
    EXPECT_FALSE(contains(ran.err, "coarse")) << ran.err;
    const json exact = report_of_run(folder, "flat:D8", {"--stl", "exact.stl"});
    const json draft = report_of_run(folder, "flat:D8", {"--draft", "--stl", "draft.stl"});
    EXPECT_EQ(draft["model"]["hulls"], exact["model"]["hulls"]);
    EXPECT_EQ(draft["accuracy_mm"], exact["accuracy_mm"]);
    EXPECT_EQ(folder.read("draft.stl"), folder.read("exact.stl"));
    // A ray model has a separate resolution, so a draft with rays stays coarse.
    const json rays = report_of_run(folder, "flat:D8", {"--draft", "--model", "dexel"});
    EXPECT_GT(rays["accuracy_mm"]["chord_tolerance"], 0.08);
}

TEST(Draft, OfMovesThatTurnTheToolIsCoarseSooner) {
    Folder folder;
    std::string program = kHead + "G1 Z-3 A0\n";
    for (int i = 1; i <= 150; ++i)
        program += "X" + std::to_string(0.5 * i) + " A" + std::to_string(i) + "\n";
    folder.write("a.nc", program + "G0 Z50\nM30\n");
    const std::string block = "0,-30,-30:80,30,0";
    const json draft = report_of_run(folder, "flat:D8", {"--draft", "--stock", block});
    EXPECT_GT(draft["accuracy_mm"]["chord_tolerance"], 0.02);
}

TEST(StockComment, OfASizeAloneLiesWhereTheCutsAre) {
    Folder folder;
    const auto min_of = [&](const std::string& moves) {
        folder.write("a.nc", "(STOCK 100x50x10)\n" + kHead + moves + "M30\n");
        const Ran ran =
            folder.run({"run", "a.nc", "--assume-tool", "flat:D6", "--report", "r.json"});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_TRUE(contains(ran.err, "assumed: where it lies")) << ran.err;
        return json::parse(folder.read("r.json"))["stock"]["min"];
    };
    EXPECT_EQ(min_of("G1 Z-3\nX90\nY40\nX10\n"), json({0.0, 0.0, -10.0}));
    EXPECT_EQ(min_of("G0 X-40 Y-20\nG1 Z-3\nX40\nY20\n"), json({-50.0, -25.0, -10.0}));
    EXPECT_EQ(min_of("G0 X-90 Y40\nG1 Z2\nX-10\nY10\n"), json({-100.0, 0.0, 0.0}));
}

TEST(UnspecifiedAxis, IsTakenAsZeroAndNamed) {
    Folder folder;
    folder.write("wrap.nc",
                 "G21 G90 T1 M6 S1000 M3\nG0 X0 Z30\nG0 A0\nG1 Z20 F500\nX40\nZ18\nX0 A20\nG0 Z30\n"
                 "M30\n");
    const Ran ran =
        folder.run({"run", "wrap.nc", "--assume-tool", "flat:D6", "--report", "r.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "the program never sets Y; taken as 0")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "assumed: Y 0, which the program never sets")) << ran.err;
    EXPECT_GT(json::parse(folder.read("r.json"))["model"]["hulls"], 3);
    const Ran check = folder.run({"check", "wrap.nc", "--assume-tool", "flat:D6"});
    EXPECT_TRUE(contains(check.out, "doubt: the program never sets Y; taken as 0")) << check.out;
    EXPECT_NE(check.exit_code, 0);
    // A specified Y is not assumed.
    const Ran specified =
        folder.run({"run", "wrap.nc", "--assume-tool", "flat:D6", "--start", "0,3,100"});
    EXPECT_FALSE(contains(specified.err, "never sets")) << specified.err;
}

TEST(UnspecifiedAxis, PromisesNoDrawingWhereThereIsNone) {
    Folder folder;
    folder.write("steps.nc", "G21 G91 F100\nG1 X1\nG1 Y1\nM2\n");
    const Ran ran = folder.run({"run", "steps.nc", "--draft", "--png", "a.png"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_FALSE(folder.has("a.png"));
    EXPECT_TRUE(contains(ran.err, "the program never sets Z; taken as 0")) << ran.err;
    EXPECT_FALSE(contains(ran.err, "drawn as a path")) << ran.err;
}

TEST(UnspecifiedAxis, OfHeightMakesADrawing) {
    Folder folder;
    folder.write("plot.nc", "G21 G90 M3 S200 F1000\nG0 X10 Y10\nG1 X50\nY40\nX10 Y10\nM5\nM2\n");
    const Ran ran = folder.run({"run", "plot.nc", "--png", "a.png"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "and the program is drawn as a path")) << ran.err;
    EXPECT_TRUE(folder.has("a.png"));
    EXPECT_TRUE(contains(ran.out, " 0.000 cm3 removed")) << ran.out;
    // A different path makes a different picture.
    const std::string before = folder.read("a.png");
    folder.write("plot.nc", "G21 G90 M3 S200 F1000\nG0 X10 Y10\nG1 X50\nX10 Y40\nX50 Y40\nM2\n");
    folder.run({"run", "plot.nc", "--png", "a.png", "-q"});
    EXPECT_NE(folder.read("a.png"), before);
    EXPECT_EQ(folder.run({"check", "plot.nc", "-q"}).exit_code, 4);
}

}  // namespace
}  // namespace ncsim::cli_test
