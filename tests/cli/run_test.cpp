// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim run: parts, pictures, meshes, reports and exit codes.
#include "cli/run_program.h"
#include "support/count.h"
#include "support/random_programs.h"
#include "support/written_mesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

TEST(Run, SaysWhatItStandsOnAndWhatIsLeft) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran = folder.run({"run", "slot.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(
        contains(ran.out, "part      11.200 cm3 of 12.000 cm3; 0.800 cm3 removed in 1 hulls"))
        << ran.out;
    EXPECT_TRUE(contains(ran.err, "units      millimetres, as the program says")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "line 1: (T1 D=10. CR=0. - ZMIN=-2. - flat end mill)"));
    EXPECT_TRUE(contains(ran.err, "line 2: (STOCK/BLOCK,40.,30.,10.,20.,15.,10.)"));
    EXPECT_EQ(folder.files(), std::vector<std::string>{"slot.nc"});
}

// The volumes are those of the tools, and add up.
TEST(Run, TellsPathTimeAndVolumeOfOperations) {
    Folder folder;
    folder.write("part.nc",
                 "(T1 D=10. CR=0. - flat end mill)\n(T2 D=4. CR=0. - flat end mill)\n"
                 "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\nG21 G90\n(FACE <1>)\nT1 M6\nS8000 M3\n"
                 "G0 X-30. Y0. Z5.\nG0 Z-2.\nG1 X30. F300.\nG0 Z5.\n(POCKET 2 mm)\n"
                 "G0 X-30. Y10.\nG0 Z-4.\nG1 X30. F300.\n(NOTE)\nG0 Z5.\nT2 M6\nM3\n"
                 "G0 X0. Y-20. Z5.\nG0 Z-1.\nG1 Y20.\nG0 Z5.\nM30\n");
    const Ran ran = folder.run({"run", "part.nc", "--report", "part.json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(
        contains(ran.out, "    line 5, 'FACE <1>': 0.800 cm3 removed, 60.0 mm at feed, ") &&
        contains(ran.out, "    line 12, 'POCKET 2 mm': 1.600 cm3 removed, 60.0 mm at feed, "))
        << ran.out;
    const json report = json::parse(folder.read("part.json"));
    ASSERT_EQ(report["operations"].size(), 3U);
    double removed = 0.0, seconds = 0.0, of_tools = 0.0;
    for (const json& operation : report["operations"]) {
        removed += operation["removed_mm3"].get<double>();
        seconds += operation["time"]["total_seconds"].get<double>();
    }
    for (const json& tool : report["tools"])
        of_tools += tool["time"]["total_seconds"].get<double>();
    EXPECT_NEAR(removed, report["volume_mm3"]["removed"].get<double>(), 1e-6);
    EXPECT_NEAR(seconds, of_tools, 1e-6);
    EXPECT_FALSE(report["operations"][2].contains("name"));
    const Ran inches = folder.run({"run", "part.nc", "--report-units", "inch"});
    EXPECT_TRUE(contains(inches.out, "'POCKET 2 mm': ")) << inches.out;
    EXPECT_FALSE(contains(inches.out, "mm at feed")) << inches.out;
    // Paths and times are those of the whole program.
    const Ran stopped = folder.run({"run", "part.nc", "--at-line", "10"});
    EXPECT_FALSE(contains(stopped.out, "POCKET 2")) << stopped.out;
}

// What a tool does again under the same name is one row; names from a file stay text on the sheet.
TEST(Run, SumsOperationsOfToolsThatComeBack) {
    Folder folder;
    std::string program =
        "(T1 D=10. CR=0. - flat end mill)\n(T2 D=4. CR=0. - flat end mill)\n"
        "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\nG21 G90\n(FACE <b>)\nT1 M6\nS8000 M3\n"
        "G0 X-30. Y0. Z5.\nG0 Z-2.\nG1 X30. F300.\nG0 Z5.\n";
    for (int i = 0; i < 3; ++i)
        program +=
            "T2 M6\nM3\nG0 X0. Y-20. Z5.\nG0 Z-1.\nG1 Y20.\nG0 Z5.\nT1 M6\nM3\n"
            "G0 X-30. Y10. Z5.\nG0 Z-4.\nG1 X30.\nG0 Z5.\n";
    folder.write("part.nc", program + "M30\n");
    const Ran ran = folder.run({"run", "part.nc"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "    line 5, 'FACE <b>': 0.800 cm3 removed, 60.0 mm at feed, ") &&
                contains(ran.out, "    without a name: 1.560 cm3 removed, 180.0 mm at feed, "))
        << ran.out;
    EXPECT_EQ(test::count(ran.out, "mm at feed"), 5U) << ran.out;
    ASSERT_EQ(folder.run({"sheet", "part.nc", "--html", "sheet.html"}).exit_code, 0);
    const std::string page = folder.read("sheet.html");
    EXPECT_TRUE(
        contains(page, "<tr><td>5</td><td>FACE &lt;b&gt;</td><td>T1</td><td>60 mm feed, ") &&
        contains(page, "<tr><td></td><td></td><td>T2</td><td>120 mm feed, "))
        << page;
}

TEST(Run, IsSilentWhenAskedTo) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran = folder.run({"run", "slot.nc", "-q"});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err, "");
}

TEST(Run, WritesEveryFormat) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran =
        folder.run({"run",    "slot.nc", "-q",    "--png", "a.png",  "--gltf", "a.glb",
                    "--vrml", "a.wrl",   "--stl", "a.stl", "--step", "a.step", "--report",
                    "a.json", "--stats", "a.csv", "--xml", "a.xml",  "--size", "200x100",
                    "--ply",  "a.ply",   "--3mf", "a.3mf"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(folder.read("a.png").substr(1, 3), "PNG");
    EXPECT_EQ(folder.read("a.glb").substr(0, 4), "glTF");
    EXPECT_EQ(folder.read("a.wrl").substr(0, 10), "#VRML V2.0");
    EXPECT_EQ(folder.read("a.step").substr(0, 12), "ISO-10303-21");
    EXPECT_GT(folder.read("a.stl").size(), 84U);
    EXPECT_TRUE(contains(folder.read("a.xml"), "<"));
    EXPECT_TRUE(contains(folder.read("a.csv"), ","));
    EXPECT_EQ(folder.read("a.ply").substr(0, 4), "ply\n");
    EXPECT_EQ(folder.read("a.3mf").substr(0, 2), "PK");
    EXPECT_EQ(folder.files().size(), 11U) << "nothing but what was asked for";
}

// Returns width and height from the header of a PNG file.
std::pair<int, int> size_of_png(const std::string& bytes) {
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = at; i < at + 4; ++i)
            value = value * 256 + static_cast<unsigned char>(bytes.at(i));
        return value;
    };
    return {number(16), number(20)};
}

TEST(Run, SeveralViewsAreOneSheetWithACaption) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran one = folder.run({"run", "slot.nc", "-q", "--png", "one.png", "--size", "200x150"});
    EXPECT_EQ(one.exit_code, 0) << one.err;
    EXPECT_EQ(size_of_png(folder.read("one.png")), std::pair(200, 150));
    const Ran three = folder.run({"run", "slot.nc", "-q", "--png", "three.png", "--size", "200x150",
                                  "--views", "iso,top,front", "--background", "dark"});
    EXPECT_EQ(three.exit_code, 0) << three.err;
    const auto [width, height] = size_of_png(folder.read("three.png"));
    // In third angle: the front below the top, the iso to the right.
    EXPECT_EQ(width, 400);
    EXPECT_GT(height, 150) << "there is a caption";
    EXPECT_LT(height, 300) << "rows are cropped";
}

TEST(Run, ASheetThatIsTooLargeIsRefusedAndNothingIsWritten) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran = folder.run(
        {"run", "slot.nc", "-q", "--png", "a.png", "--size", "9000x10", "--views", "iso,top"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "18000")) << ran.err;
    EXPECT_FALSE(folder.has("a.png"));
}

TEST(Run, TheMeshQuotesTheLinesThatCutIt) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.run({"run", "slot.nc", "-q", "--gltf", "a.glb"});
    const std::string glb = folder.read("a.glb");
    EXPECT_TRUE(contains(glb, R"("lines":{"8":"G1 X30. F500."})"));
}

// A block with a groove that a tilted tool cuts: bottom, two sides, two ends, a divided top, and
// the floor and two walls of the groove. Rounding the corners of the tilted tool to the lattice
// must not split any of these faces.
TEST(Run, TheSolidHasTheFacesThatAPersonCounts) {
    Folder folder;
    for (const char* angle : {"0.", "7.", "-3."}) {
        SCOPED_TRACE(angle);
        std::string text(kSlot);
        text.replace(text.find("G0 Z-2."), 7, std::string("G0 A").append(angle));
        text.replace(text.find("G1 X30."), 7, "G0 Z-2.\nG1 X30.");
        folder.write("slot.nc", text);
        const Ran ran = folder.run({"run", "slot.nc", "-q", "--step", "a.step"});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_EQ(ncsim::test::count(folder.read("a.step"), "ADVANCED_FACE"), 10U);
    }
}

TEST(Run, SimplifiesAndSaysByHowMuch) {
    Folder folder;
    // A shallow arc: many narrow facets in nearly one plane.
    std::string text(kSlot);
    text.replace(text.find("G1 X30. F500."), 13, "G3 X30. Y0. I30. J300. F500.");
    folder.write("part.nc", text);
    const Ran exact = folder.run({"run", "part.nc", "--report", "a.json", "--stl", "a.stl"});
    EXPECT_EQ(exact.exit_code, 0) << exact.err;
    EXPECT_FALSE(contains(exact.out, "simpler"));
    const Ran ran = folder.run(
        {"run", "part.nc", "--report", "b.json", "--stl", "b.stl", "--simplify", "0.05"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "mm off at most")) << ran.out;
    const json simplified = json::parse(folder.read("b.json"))["simplified"];
    EXPECT_EQ(simplified["tolerance_mm"], 0.05);
    EXPECT_GT(simplified["deviation_mm"], 0.0);
    EXPECT_LE(simplified["deviation_mm"], 0.05);
    EXPECT_LT(folder.read("b.stl").size(), folder.read("a.stl").size());
}

// Two separate slots of 800 mm³, the second in a loop.
constexpr const char* kTwoSlots =
    "(T1 D=10. CR=0. - ZMIN=-2. - flat end mill)\n"
    "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n"
    "G21 G90 G17\n"
    "T1 M6\n"
    "G0 X-30. Y-9. Z5.\n"
    "G0 Z-2.\n"
    "G1 X30. F500.\n"
    "(between them)\n"
    "G0 Y9.\n"
    "G1 X-30.\n"
    "M30\n";

TEST(Run, StopsAfterALine) {
    Folder folder;
    folder.write("slots.nc", kTwoSlots);
    const auto removed = [&](const char* line) {
        const Ran ran =
            folder.run({"run", "slots.nc", "-q", "--report", "a.json", "--at-line", line});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return json::parse(folder.read("a.json"))["volume_mm3"]["removed"].get<double>();
    };
    EXPECT_EQ(removed("6"), 0.0);
    EXPECT_EQ(removed("7"), 800.0);
    EXPECT_EQ(removed("8"), 800.0);
    EXPECT_EQ(removed("10"), 1600.0);
    EXPECT_EQ(json::parse(folder.read("a.json"))["at_line"], 10);
    const Ran beyond = folder.run({"run", "slots.nc", "-q", "--png", "a.png", "--at-line", "12"});
    EXPECT_EQ(beyond.exit_code, 2);
    EXPECT_TRUE(contains(beyond.err, "--at-line 12: the program has 11 lines")) << beyond.err;
    EXPECT_FALSE(folder.has("a.png"));
}

TEST(Run, ALineThatIsRepeatedIsDoneOnce) {
    Folder folder;
    std::string text(kTwoSlots);
    // Line 7 cuts and line 8 steps over, repeatedly.
    text.replace(text.find("G1 X30. F500.\n(between them)"), 28,
                 "o1 repeat [2]\nG1 X30. F500.\nG0 X-30. Y9.\no1 endrepeat");
    folder.write("slots.nc", text);
    const Ran ran = folder.run({"run", "slots.nc", "-q", "--report", "a.json", "--at-line", "8"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(json::parse(folder.read("a.json"))["volume_mm3"]["removed"], 800.0);
}

TEST(Run, TakesPicturesOnTheWay) {
    Folder folder;
    folder.write("slots.nc", kTwoSlots);
    const Ran ran =
        folder.run({"run", "slots.nc", "-q", "--frames", "film", "--gif", "a.gif", "--every", "2",
                    "--size", "80x60", "--show-tool", "--show-path", "--caption"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    // Five moves: pictures after the second, the fourth, and the last.
    const auto frames = folder.path() / "film";
    for (const char* name : {"frame-00001.png", "frame-00002.png", "frame-00003.png"})
        EXPECT_TRUE(std::filesystem::exists(frames / name)) << name;
    EXPECT_FALSE(std::filesystem::exists(frames / "frame-00004.png"));
    EXPECT_NE(folder.read("film/frame-00001.png"), folder.read("film/frame-00002.png"));
    EXPECT_EQ(folder.read("a.gif").substr(0, 6), "GIF89a");
    const std::string first = folder.read("a.gif");
    folder.run({"run", "slots.nc", "-q", "--gif", "a.gif", "--every", "2", "--size", "80x60",
                "--show-tool", "--show-path", "--caption"});
    EXPECT_EQ(folder.read("a.gif"), first);
    const Ran bad = folder.run({"run", "slots.nc", "-q", "--frames", "slots.nc"});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_TRUE(contains(bad.err, "slots.nc")) << bad.err;
}

TEST(Run, FramesAreOfOneSizeWhateverTheirCaptionsSay) {
    Folder folder;
    std::string program(kSlot);
    program.insert(program.find("\nG0 Z5.\nM30"), " (" + std::string(90, 'M') + ")");
    folder.write("slot.nc", program);
    const Ran ran = folder.run({"run", "slot.nc", "-q", "--frames", "film", "--gif", "a.gif",
                                "--every", "1", "--size", "480x360", "--caption"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    // Width and height: in PNG four bytes each, big-endian, in the first chunk; in GIF two bytes
    // each, little-endian, in the header.
    const std::string size = folder.read("film/frame-00001.png").substr(16, 8);
    for (const char* name :
         {"film/frame-00002.png", "film/frame-00003.png", "film/frame-00004.png"})
        EXPECT_EQ(folder.read(name).substr(16, 8), size) << name;
    const std::string head = folder.read("a.gif").substr(6, 4);
    EXPECT_EQ((std::string{head[1], head[0], head[3], head[2]}),
              size.substr(2, 2) + size.substr(6, 2));
}

TEST(Run, ShowsPathAndToolOnlyIfAskedTo) {
    Folder folder;
    folder.write("slots.nc", kTwoSlots);
    const auto picture = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"run",    "slots.nc", "-q",        "--png", "a.png",
                                           "--size", "80x60",    "--at-line", "7"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = folder.run(arguments);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read("a.png");
    };
    const std::string plain = picture({});
    const std::string path = picture({"--show-path"});
    const std::string tool = picture({"--show-tool"});
    EXPECT_NE(path, plain);
    EXPECT_NE(tool, plain);
    EXPECT_NE(tool, path);
    EXPECT_EQ(picture({"--show-path"}), path);
}

TEST(Run, TellsHowLongItCutsIfEveryFeedIsTold) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran specified = folder.run({"run", "slot.nc", "--report", "a.json"});
    // 60 mm at 500 mm/min.
    EXPECT_TRUE(contains(specified.out, "feed 0:07 min, rapid")) << specified.out;
    EXPECT_DOUBLE_EQ(json::parse(folder.read("a.json"))["feed_seconds"], 7.2);
    std::string text(kSlot);
    text.erase(text.find(" F500."), 6);
    folder.write("slot.nc", text);
    folder.run({"run", "slot.nc", "--report", "a.json"});
    EXPECT_FALSE(json::parse(folder.read("a.json")).contains("feed_seconds"));
}

TEST(Run, TellsHowLongAllOfItTakesAndByWhatModel) {
    Folder folder;
    std::string text(kSlot);  // 60 mm at 500 mm/min, and 7 + 7 mm or more at rapid
    folder.write("slot.nc", text.replace(text.find("M30"), 3, "G4 P2.5\nM30"));
    const Ran ran = folder.run({"run", "slot.nc", "--report", "a.json"});
    EXPECT_TRUE(contains(ran.out,
                         "time      0:18 min: feed 0:07 min, rapid 0:01 min at 10 m/min, "
                         "1 tool change of 8 s, dwells 0:03 min; without acceleration"))
        << ran.out;
    const json report = json::parse(folder.read("a.json"));
    const json& time = report["time"];
    EXPECT_EQ(time["feed_seconds"], 7.2);
    EXPECT_EQ(time["dwell_seconds"], 2.5);
    EXPECT_EQ(time["tool_change_seconds"], 8.0);
    const double rapid = report["distance_mm"]["rapid"].get<double>() / 10'000.0 * 60.0;
    EXPECT_NEAR(time["rapid_seconds"].get<double>(), rapid, 1e-6);
    EXPECT_NEAR(time["total_seconds"].get<double>(), 7.2 + 2.5 + 8.0 + rapid, 1e-6);
    EXPECT_EQ(report["tools"][0]["time"]["feed_seconds"], 7.2);
    EXPECT_TRUE(contains(folder.run({"check", "slot.nc"}).out, "\n  time     0:18 min: feed"));
    // With a machine file, the rates of the machine apply.
    folder.write("m.toml",
                 "[rapid]\nx = 6000\ny = 6000\nz = 6000\n[acceleration]\nx = 1000\ny = "
                 "1000\nz = 1000\n[time]\ntool_change = 20\n");
    const Ran specified = folder.run({"check", "slot.nc", "--machine", "m.toml"});
    EXPECT_TRUE(contains(specified.out, "the rest 0:23 min; as the machine is described"))
        << specified.out;
    // run prints the same time as check.
    const Ran same = folder.run({"run", "slot.nc", "--machine", "m.toml", "--report", "a.json"});
    const auto time_of = [](const std::string& of) {
        const std::size_t at = of.find("0:", of.find("time    "));
        return of.substr(at, of.find('\n', at) - at);
    };
    EXPECT_EQ(time_of(same.out), time_of(specified.out)) << same.out;
    EXPECT_EQ(json::parse(folder.read("a.json"))["time_on_machine"]["other_seconds"], 22.5);
}

TEST(Run, ReportsVolumesByToolAndByBlock) {
    for (const char* model : {"cda", "cda-flat"}) {
        SCOPED_TRACE(model);
        Folder folder;
        folder.write("slot.nc", kSlot);
        folder.run({"run", "slot.nc", "-q", "--report", "b.json", "--model", model});
        EXPECT_FALSE(json::parse(folder.read("b.json")).contains("blocks"))
            << "--block-volumes is absent";
        folder.run(
            {"run", "slot.nc", "-q", "--report", "a.json", "--block-volumes", "--model", model});
        const json report = json::parse(folder.read("a.json"));
        EXPECT_DOUBLE_EQ(report["volume_mm3"]["stock"], 12000.0);
        EXPECT_DOUBLE_EQ(report["volume_mm3"]["part"], 11200.0);
        EXPECT_DOUBLE_EQ(report["tools"][0]["removed_mm3"], 800.0);
        EXPECT_EQ(report["blocks"].size(), 1U);
        EXPECT_EQ(report["blocks"][0]["line"], 8);
        EXPECT_DOUBLE_EQ(report["blocks"][0]["removed_mm3"], 800.0);
        EXPECT_EQ(report["tools"][0]["source"]["line"], 1);
        EXPECT_DOUBLE_EQ(report["distance_mm"]["feed"], 60.0);
        EXPECT_EQ(report["part"]["extents"]["max"], json::array({20.0, 15.0, 0.0}));
        EXPECT_TRUE(report["findings"].empty());
    }
}

TEST(Run, GivesTheSameBytesAgainAndForAnyNumberOfThreads) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.run({"run", "slot.nc", "-q", "--png", "a.png", "--gltf", "a.glb", "--report", "a.json",
                "--threads", "1"});
    folder.run({"run", "slot.nc", "-q", "--png", "b.png", "--gltf", "b.glb", "--report", "b.json",
                "--threads", "4"});
    for (const char* type : {".png", ".glb", ".json"}) {
        EXPECT_EQ(folder.read(std::string("a").append(type)),
                  folder.read(std::string("b").append(type)));
    }
}

// Two moves of an engraver. An edge that rounding moves onto a second edge must not occur four
// times.
TEST(Run, WritesMeshesThatAreClosedForThoseWhoHaveNothingButTheFile) {
    Folder folder;
    folder.write("two.nc",
                 "G21 G90 G17\n"
                 "T1 M6\n"
                 "S1000 M3 F500\n"
                 "G0 X31.69 Y-22.89 Z-10\n"
                 "G1 X39.84 Y-20.74 Z-15.78\n"
                 "G1 X37.30 Y-22.57 Z-16.00\n"
                 "M30\n");
    const Ran ran = folder.run({"run", "two.nc", "--stock=29.94,-24.21,-15.91:39.94,-18.21,-14.91",
                                "--tool", "T1=v:D3:L20:A86", "--tolerance", "0.006",
                                "--tool-tolerance", "0.01", "--stl", "a.stl", "--gltf", "a.glb"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    for (const auto& mesh :
         {test::read_stl(folder.read("a.stl")), test::read_glb(folder.read("a.glb"))}) {
        const test::Soundness found = test::soundness(mesh);
        EXPECT_GT(found.triangles, 100U);
        EXPECT_TRUE(found.is_sound()) << to_string(found);
    }
}

// Rays as a quick preview: all outputs are written, the volume is near, and the report says that no
// value is exact.
TEST(Run, LooksAtTheSlotWithRays) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran =
        folder.run({"run", "slot.nc", "--model", "dexel", "--resolution", "0.2", "--png", "a.png",
                    "--stl", "a.stl", "--gltf", "a.glb", "--report", "a.json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.err.find("nothing is exact"), std::string::npos) << ran.err;
    const json report = json::parse(folder.read("a.json"));
    EXPECT_NEAR(report["volume_mm3"]["part"].get<double>(), 11200.0, 40.0);
    EXPECT_GT(report["model"]["resolution_mm"].get<double>(), 0.0);
    EXPECT_GT(folder.read("a.stl").size(), 1000U);
    const Ran again = folder.run({"run", "slot.nc", "-q", "--model", "dexel", "--resolution", "0.2",
                                  "--threads", "3", "--stl", "b.stl"});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(folder.read("a.stl") == folder.read("b.stl"));
    // At most two million rays are permitted.
    const Ran fine = folder.run({"run", "slot.nc", "--model", "dexel", "--resolution", "0.001"});
    EXPECT_EQ(fine.exit_code, 2) << fine.err;
    EXPECT_NE(fine.err.find("too fine for this stock"), std::string::npos) << fine.err;
}

TEST(Run, WritesTheSameBytesWithBothModelsWhenToolsTurn) {
    Folder folder;
    const test::NcProgram program = test::random_program(97, true);
    folder.write("turning.nc", program.text);
    const std::vector<std::string> types{"stl", "gltf", "vrml", "ply", "3mf", "step"};
    for (const std::string model : {"cda", "cda-flat"}) {
        std::vector<std::string> arguments{"run",
                                           "turning.nc",
                                           "-q",
                                           "--stock=" + program.stock,
                                           "--tolerance",
                                           std::to_string(program.tolerance_mm),
                                           "--tool-tolerance",
                                           std::to_string(program.tool_tolerance_mm),
                                           "--model",
                                           model};
        for (const std::string& tool : program.tools)
            arguments.insert(arguments.end(), {"--tool", tool});
        for (const std::string& type : types)
            arguments.insert(arguments.end(), {"--" + type, std::string(model).append(type)});
        const Ran ran = folder.run(arguments);
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
    }
    for (const std::string& type : types) {
        EXPECT_TRUE(folder.read("cda" + type) == folder.read("cda-flat" + type)) << type;
    }
}

TEST(Run, ReportsVolumePathAndTimeOfEachTool) {
    Folder folder;
    // T1 feeds 60 mm at 600 mm/min and T2 feeds 30 mm at 100 mm/min, without rapids and dwells.
    folder.write("two.nc",
                 "G21 G90 G17 G94\n(T1 D=6. - flat end mill)\n(T2 D=4. - flat end mill)\n"
                 "T1 M6\nS5000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F600\nG1 X54\n"
                 "T2 M6\nG1 Y26 F100\nG1 Y22\nM30\n");
    const Ran ran = folder.run({"run", "two.nc", "--stock", "80x40x10"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, " removed, 60.0 mm at feed, 0:")) << ran.out;
    EXPECT_TRUE(contains(ran.out, " removed, 30.0 mm at feed, 0:26 min\n")) << ran.out;
    // The path is that of the whole program.
    const Ran part = folder.run({"run", "two.nc", "--stock", "80x40x10", "--at-line", "8"});
    EXPECT_FALSE(contains(part.out, " removed, ")) << part.out;
}

TEST(Run, TakesToolsAndStockFromTheCommandLineFirst) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran = folder.run({"run", "slot.nc", "--tool", "T1=flat:D5", "--stock", "40x40x10"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "0.400 cm3 removed")) << ran.out;
    EXPECT_TRUE(contains(ran.err, "from --tool"));
    EXPECT_TRUE(contains(ran.err, "from --stock"));
}

TEST(Run, CutsARoundBarAndKeepsItInTheJob) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    ASSERT_EQ(folder
                  .run({"run", "slot.nc", "--tool", "T1=flat:D5", "--stock", "d40x10", "--save-job",
                        "a.toml", "--stl", "a.stl"})
                  .exit_code,
              0);
    EXPECT_TRUE(contains(folder.read("a.toml"), "round = true"));
    const Ran again = folder.run({"run", "slot.nc", "--job", "a.toml", "--stl", "b.stl"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(contains(again.err, "a round bar in 40 x 40 x 10 mm")) << again.err;
    // The header names the doubts, and --tool and --stock against comments are a different doubt
    // than a job file against comments.
    constexpr std::size_t kHeader = 80;
    EXPECT_EQ(folder.read("a.stl").substr(kHeader), folder.read("b.stl").substr(kHeader));
}

TEST(Run, GoesOnWithWhatAnotherProgramHasLeftTurnedOver) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    ASSERT_EQ(folder
                  .run({"run", "slot.nc", "--save-stock", "first.ncstock", "--stl", "first.stl",
                        "--vrml", "first.wrl"})
                  .exit_code,
              0);
    // The same slot again from the opposite side; a surface is as good as cells.
    for (const char* stock : {"first.ncstock", "first.stl", "first.wrl"}) {
        SCOPED_TRACE(stock);
        const Ran ran =
            folder.run({"run", "slot.nc", "--stock", stock, "--stock-turn", "X180", "--stock-move",
                        "0,0,-10", "--save-job", "second.toml", "--stl", "second.stl"});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_TRUE(contains(ran.out, "10.400 cm3 of 11.200 cm3; 0.800 cm3 removed")) << ran.out;
        EXPECT_TRUE(contains(ran.err, "turned X180")) << ran.err;
        const Ran again = folder.run({"run", "slot.nc", "--job", "second.toml", "--stl", "b.stl"});
        EXPECT_EQ(again.exit_code, 0) << again.err;
        EXPECT_TRUE(folder.read("b.stl") == folder.read("second.stl"));
    }
    // Without the turn, the same side has no material left to remove.
    const Ran same = folder.run({"run", "slot.nc", "--stock", "first.ncstock"});
    EXPECT_TRUE(contains(same.out, "11.200 cm3 of 11.200 cm3; 0.000 cm3 removed")) << same.out;
    const Ran flat =
        folder.run({"run", "slot.nc", "--stock", "first.ncstock", "--model", "cda-flat"});
    EXPECT_TRUE(contains(flat.out, "11.200 cm3 of 11.200 cm3; 0.000 cm3 removed")) << flat.out;
}

TEST(Run, TakesStockFromObj) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("block.obj",
                 "v -20 -15 -10\nv 20 -15 -10\nv 20 15 -10\nv -20 15 -10\nv -20 -15 0\nv 20 -15 0\n"
                 "v 20 15 0\nv -20 15 0\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
                 "f 4 1 5 8\n");
    const Ran ran = folder.run({"run", "slot.nc", "--stock", "block.obj"});
    EXPECT_TRUE(contains(ran.out, "11.200 cm3 of 12.000 cm3; 0.800 cm3 removed")) << ran.err;
}

TEST(Run, ChecksAndComparesWithStockFromAFile) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    ASSERT_EQ(folder.run({"run", "slot.nc", "--save-stock", "first.ncstock"}).exit_code, 0);
    const Ran check =
        folder.run({"check", "slot.nc", "--stock", "first.ncstock", "--json", "a.json"});
    EXPECT_TRUE(contains(check.out, "first.ncstock in 40 x 30 x 10 mm")) << check.out;
    EXPECT_TRUE(contains(folder.read("a.json"), "\"stock_mm3\": 11200")) << folder.read("a.json");
    const Ran diff = folder.run({"diff", "slot.nc", "slot.nc", "--stock", "first.ncstock"});
    EXPECT_EQ(diff.exit_code, 0) << diff.out << diff.err;
}

TEST(Run, RefusesStockFilesThatAreNone) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("bad.ncstock", "ncsim stock 1\nunit 1e-05\nnormal 1 0 0\nouter 0 5 7 1\nend 0\n");
    folder.write("bad.stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendsolid\n");
    const auto refusal = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"run", "slot.nc", "--save-stock", "new.ncstock"});
        const Ran ran = folder.run(options);
        EXPECT_EQ(ran.exit_code, 2);
        return ran.err;
    };
    EXPECT_TRUE(contains(refusal({"--stock", "none.ncstock"}), "none.ncstock"));
    EXPECT_TRUE(contains(refusal({"--stock", "bad.ncstock"}), "bad.ncstock:4: a normal that was"));
    EXPECT_TRUE(contains(refusal({"--stock", "bad.stl"}), "bad.stl"));
    EXPECT_TRUE(contains(refusal({"--stock", "new.ncstock"}), "new.ncstock': No such file"));
    EXPECT_TRUE(contains(refusal({"--stock-turn", "X180"}), "--stock FILE"));
    EXPECT_TRUE(
        contains(refusal({"--stock", "40x30x10", "--stock-move", "1,2,3"}), "--stock FILE"));
    EXPECT_TRUE(contains(refusal({"--stock", "a.stl", "--stock-turn", "45"}), "angles about axes"));
    EXPECT_TRUE(contains(refusal({"--stock", "a.stl", "--stock-move", "1,2"}), "expected x,y,z"));
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"bad.ncstock", "bad.stl", "slot.nc"}));
}

TEST(Run, DerivesAStockThatNobodyTells) {
    Folder folder;
    folder.write("part.nc",
                 "(T1 D=10. - flat end mill)\nG21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-2 F100\nG1 X50\nG0 "
                 "Z5\nM30\n");
    const Ran ran = folder.run({"run", "part.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "assumed: derived: what the tools sweep in cutting moves"))
        << ran.err;
}

TEST(Run, DerivesAStockWithoutTheRunsOfFaceMills) {
    // A block of 120 x 80 mm, faced by a D50 from 6 mm before the block to 6 mm beyond.
    Folder folder;
    folder.write("face.nc",
                 "G21 G90 G17 T1 M6 S900 M3\nG0 X-91 Y-19 Z10\nG0 Z-1\nG1 X91 F500\nG0 Z10\n"
                 "G0 X-91 Y19\nG0 Z-1\nG1 X91\nG0 Z10\nM30\n");
    const auto stock_of = [&](const char* tool) {
        folder.run({"run", "face.nc", "-q", "--tool", tool, "--report", "a.json"});
        return json::parse(folder.read("a.json"))["stock"];
    };
    const json faced = stock_of("T1=face:D50:L10");
    EXPECT_NEAR(faced["max"][0].get<double>(), 66.0 + 6.6, 1.0) << faced.dump();
    EXPECT_NEAR(faced["max"][1].get<double>(), 44.0 + 4.4, 1.0);
    const json slotted = stock_of("T1=flat:D50:L10");
    EXPECT_GT(slotted["max"][0].get<double>(), 116.0) << slotted.dump();
}

TEST(Run, AToolWhoseLengthIsUnknownLeavesNothingStandingAboveIt) {
    Folder folder;
    folder.write("part.nc",
                 "(T1 D=10. - flat end mill)\n(STOCK/BLOCK,40,30,100,20,15,100)\nG21 G90\nT1 M6\n"
                 "G0 X-30 Y0 Z5\nZ-90\nG1 X30 F100\nM30\n");
    const Ran ran = folder.run({"run", "part.nc"});
    EXPECT_TRUE(contains(ran.out, "36.000 cm3 removed")) << ran.out << ran.err;
}

TEST(Run, WithoutG20OrG21TheUnitsAreWhatTheUserSays) {
    Folder folder;
    folder.write("part.nc", "T1 M6\nG90\nG0 X-2 Y0 Z1\nZ-.5\nG1 X2 F10\nM30\n");
    const Ran mm = folder.run({"run", "part.nc", "--tool", "T1=flat:D1"});
    EXPECT_TRUE(contains(mm.err, "millimetres, assumed")) << mm.err;
    const Ran inch = folder.run({"run", "part.nc", "--tool", "T1=flat:D1", "--units", "inch"});
    EXPECT_TRUE(contains(inch.err, "inches, as specified")) << inch.err;
    EXPECT_TRUE(contains(inch.out, "101.6 mm at feed")) << inch.out;
}

TEST(Run, BlockDeleteSkipsBlocks) {
    Folder folder;
    folder.write("part.nc",
                 std::string(kSlot).insert(std::string(kSlot).find("G0 Z5.\nM30"), "/G1 Y40.\n"));
    const Ran all = folder.run({"run", "part.nc"});
    const Ran some = folder.run({"run", "part.nc", "--block-delete"});
    EXPECT_TRUE(contains(all.out, "100.0 mm at feed")) << all.out;
    EXPECT_TRUE(contains(some.out, "60.0 mm at feed")) << some.out;
}

TEST(Run, FindsSubprogramsInFilesBesideTheProgram) {
    Folder folder;
    std::string text(kSlot);
    text.replace(text.find("G1 X30. F500."), 13, "O<slot> call");
    folder.write("part.nc", text);
    folder.write("slot.ngc", "O<slot> sub\nG1 X30. F500.\nO<slot> endsub\n");
    const Ran ran = folder.run({"run", "part.nc", "--report", "a.json", "--block-volumes"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "0.800 cm3 removed")) << ran.out;
    const json report = json::parse(folder.read("a.json"));
    EXPECT_EQ(report["blocks"][0]["file"], "slot.ngc");
    EXPECT_EQ(report["blocks"][0]["line"], 2);
}

TEST(Run, RetractsThroughMachineZeroLeadAwayFromThePart) {
    Folder folder;
    std::string text(kSlot);
    text.replace(text.find("G0 Z5.\nM30"), 7, "G53 G0 Z0.\nG28 G91 Z0.\nG90\n");
    folder.write("part.nc", text);
    const Ran ran = folder.run({"run", "part.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "0.800 cm3 removed")) << ran.out;
    EXPECT_TRUE(contains(ran.err, "machine zero 300 mm above the program zero"));
}

}  // namespace
}  // namespace ncsim::cli_test
