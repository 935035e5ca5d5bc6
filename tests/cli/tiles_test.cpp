// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part in tiles: the same bytes as in a single run, or an error.
#include "cli/run_program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using Words = std::vector<std::string>;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string sample(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(std::filesystem::path(NCSIM_SOURCE_DIR) / "samples" / name).rdbuf();
    return text.str();
}

std::string tile_name(int i, int n) {
    return fmt::format("tiles/tile-{:04}-of-{:04}.nctile", i, n);
}

Ran cut(const Folder& folder, const Words& program, int i, int n, const Words& more = {}) {
    return folder.run(Words{"run"} + program + Words{"--tile", fmt::format("{}/{}", i, n)} +
                      Words{"--tile-out", "tiles", "-q"} + more);
}

const Words kFormats{"--gltf", "--stl", "--3mf", "--ply", "--vrml", "--png", "--report"};

// Returns the files of a command in all formats and its output.
std::vector<std::string> written(const Folder& folder, Words command) {
    for (const std::string& format : kFormats)
        command = command + Words{format, "out" + format};
    const Ran ran = folder.run(command);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    std::vector<std::string> all{ran.out, ran.err};
    for (const std::string& format : kFormats) {
        all.push_back(folder.read("out" + format));
        EXPECT_FALSE(all.back().empty()) << format;
        std::filesystem::remove(folder.path() / ("out" + format));
    }
    return all;
}

void expect_one_run(const Folder& folder, const Words& program, int n) {
    SCOPED_TRACE(n);
    const std::vector<std::string> once = written(folder, Words{"run"} + program);
    // Tiles in any order, some twice.
    for (int k = 0; k < n + 2; ++k) {
        const int i = (k * 5 + 3) % n;
        const Ran ran = cut(folder, program, i, n);
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
    }
    for (int i = 0; i < n; ++i)
        ASSERT_EQ(cut(folder, program, i, n).exit_code, 0);
    EXPECT_TRUE(written(folder, {"merge", "tiles"}) == once);
    std::filesystem::remove_all(folder.path() / "tiles");
}

TEST(Tiles, AreOneRun) {
    const Folder folder;
    folder.write("complex.nc", sample("complex.nc"));
    for (const int n : {1, 2, 7, 64})
        expect_one_run(folder, {"complex.nc"}, n);
}

// A tile skips motions that stay outside the tile: rotary moves, moves under tip control, arcs.
TEST(Tiles, OfToolsThatTurnAreOneRun) {
    const Folder folder;
    std::string around =
        "(T1 D=8. CR=4. - ball end mill)\n(STOCK/BLOCK,60.,40.,40.,30.,20.,20.)\n"
        "G21 G90 T1 M6 S8000 M3\nG0 X-40. Y0. Z40. A0.\nF1000.\n";
    for (int i = 0; i < 30; ++i)
        around += fmt::format("G1 X{} Z{} A{}.\n", 2 * i - 30, 17 + i % 3, 25 * i);
    folder.write("around.nc", around + "G2 X30. Y10. R20. A800.\nG0 Z60.\nM30\n");
    std::string tip =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,40.,20.,30.,20.,20.)\n"
        "G21 G90 T1 M6 S8000 M3\nG0 X-40. Y0. Z40. A0. B0.\nG43.4 H1\nF1000.\n";
    for (int i = 0; i < 20; ++i)
        tip += fmt::format("G1 X{} Y{} Z-2. A{}. B{}.\n", 2 * i - 20, i % 5, i % 7 * 5, i);
    folder.write("tip.nc", tip + "G49\nG0 Z60.\nM30\n");
    folder.write("m.toml",
                 "preset = \"xyzab-table\"\n"
                 "control = { tip_frame = \"table\", tip_frame_at = \"zero\" }\n");
    for (const Words& program :
         {Words{"around.nc"}, Words{"tip.nc", "--machine", "m.toml", "--tool", "T1=flat:D6:L40"}}) {
        SCOPED_TRACE(program[0]);
        const Ran one = folder.run(Words{"run"} + program +
                                   Words{"-q", "--stl", "one.stl", "--report", "one.json"});
        ASSERT_EQ(one.exit_code, 0) << one.err;
        for (int i = 0; i < 5; ++i)
            ASSERT_EQ(cut(folder, program, i, 5).exit_code, 0);
        const Ran merged =
            folder.run({"merge", "tiles", "-q", "--stl", "merged.stl", "--report", "merged.json"});
        ASSERT_EQ(merged.exit_code, 0) << merged.err;
        EXPECT_TRUE(folder.read("merged.stl") == folder.read("one.stl"));
        EXPECT_EQ(folder.read("merged.json"), folder.read("one.json"));
        std::filesystem::remove_all(folder.path() / "tiles");
    }
}

// Whole turns must be recognised in a tile that sees only a part of a turn: bores by helices in
// lines of half a turn, on the walls between tiles and next to the walls.
TEST(Tiles, OfBoresByHelicesAreOneRun) {
    const Folder folder;
    std::string bores =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n"
        "G21 G90 T1 M6 S8000 M3\nF1000.\n";
    for (int i = 0; i < 9; ++i) {
        const int x = 12 * (i % 3) - 12, y = 11 * (i / 3) - 11;
        bores += fmt::format("G0 X{} Y{} Z1.\n", x + 2, y);
        for (int turn = 0; turn < 8; ++turn) {
            const bool is_back = turn % 2 != 0;
            bores += fmt::format("G3 X{} Y{} Z{} I{} J0.\n", is_back ? x + 2 : x - 2, y,
                                 std::max(-6, -turn), is_back ? 2 : -2);
        }
        bores += "G0 Z5.\n";
    }
    // Half of the turn is outside the block.
    bores += "G0 X-23. Y3. Z1.\nG1 Z-4.\nG3 Y7. J2.\nG3 Y3. J-2.\nG0 Z5.\n";
    folder.write("bores.nc", bores + "M30\n");
    for (const int n : {2, 7, 64})
        expect_one_run(folder, {"bores.nc"}, n);
}

// Straight paths in short moves, along and across the walls between tiles, horizontal and inclined.
TEST(Tiles, OfStraightWaysInPiecesAreOneRun) {
    const Folder folder;
    std::string ways =
        "(T1 D=6. CR=3. - ball end mill)\n(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n"
        "G21 G90 T1 M6 S8000 M3\nF1000.\n";
    for (int row = 0; row < 12; ++row) {
        const bool is_across = row % 2 != 0;
        ways += fmt::format("G0 X{} Y{} Z2.\nG1 Z{}.\n", is_across ? 3 * row - 18 : -24,
                            is_across ? -24 : 3 * row - 18, -1 - row % 4);
        for (int i = 0; i < 48; ++i)
            ways += fmt::format("{}{}{}\n", is_across ? "Y" : "X", i - 23,
                                row % 3 == 0 ? fmt::format(" Z{}", -1 - row % 4 + 0.0625 * i) : "");
        ways += "G0 Z9.\n";
    }
    folder.write("ways.nc", ways + "M30\n");
    for (const int n : {2, 7, 64})
        expect_one_run(folder, {"ways.nc"}, n);
}

// Enough steps that blocks flush pending cells by count. Rows end far outside the block, with steps
// that are not near the block, and a straight path is completed there.
TEST(Tiles, OfManyStepsAreOneRun) {
    const Folder folder;
    std::string rows =
        "(T1 D=6. CR=3. - ball end mill)\n(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n"
        "G21 G90 T1 M6 S8000 M3\nF1000.\nG0 X-35. Y-20. Z5.\n";
    for (int row = 0; row < 40; ++row) {
        const int to = row % 2 == 0 ? 1 : -1;
        rows += fmt::format("G1 Y{} Z{}\n", row - 20, -1 - 0.1 * (row % 7));
        for (int i = 1; i <= 280; ++i)
            rows += fmt::format("X{:.3f}\n", to * (-35 + 0.25 * i));
    }
    folder.write("rows.nc", rows + "G0 Z20.\nM30\n");
    expect_one_run(folder, {"rows.nc"}, 7);
}

TEST(Tiles, KnowWhatWasAsked) {
    const Folder folder;
    folder.write("wave.nc", sample("wave.nc"));
    expect_one_run(folder, {"wave.nc", "--tool-tolerance", "0.3", "--at-line", "60"}, 3);
    // A program with a subprogram, with tools from the command line, in a folder.
    std::filesystem::create_directories(folder.path() / "a b");
    folder.write("a b/main.ngc",
                 "G21 G90\nT1 M6\nG0 X-30. Y0. Z5.\nG0 Z-2.\no<cut> call\nG0 Z5.\nM2\n");
    folder.write("a b/cut.ngc", "o<cut> sub\nG1 X30. F500.\no<cut> endsub\nM2\n");
    expect_one_run(
        folder,
        {"--tool", "T1=ball:D6:L30", "--start=0,0,50", "--stock", "40x30x10", "a b/main.ngc"}, 2);
    ASSERT_EQ(cut(folder, {"wave.nc"}, 0, 1).exit_code, 0);
    ASSERT_EQ(
        folder.run({"run", "wave.nc", "-q", "--simplify", "0.05", "--stl", "a.stl"}).exit_code, 0);
    ASSERT_EQ(
        folder.run({"merge", "tiles", "-q", "--simplify", "0.05", "--stl", "b.stl"}).exit_code, 0);
    EXPECT_TRUE(folder.read("a.stl") == folder.read("b.stl"));
}

TEST(Tiles, AreCutAgainWhereTheyAreNotWhole) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    const std::string name = tile_name(1, 3);
    EXPECT_EQ(cut(folder, {"slot.nc"}, 1, 3).out, "tile 1 of 3 was cut: " + name + "\n");
    const std::string whole = folder.read(name);
    EXPECT_EQ(cut(folder, {"slot.nc"}, 1, 3).out, "tile 1 of 3 was cut before: " + name + "\n");
    std::string changed = whole;
    changed[changed.size() / 2] ^= 1;
    for (const std::string& text : {std::string(), whole.substr(0, whole.size() / 2),
                                    whole.substr(0, whole.size() - 1), whole + "x", changed}) {
        folder.write(name, text);
        EXPECT_EQ(folder.run({"merge", name, "--stl", "a.stl"}).exit_code, 2);
        EXPECT_EQ(cut(folder, {"slot.nc"}, 1, 3).out, "tile 1 of 3 was cut: " + name + "\n");
        EXPECT_TRUE(folder.read(name) == whole);
    }
    // Tiles of a different program or a different file.
    folder.write("slot.nc", replaced(kSlot, "Z-2.", "Z-1."));
    EXPECT_EQ(cut(folder, {"slot.nc"}, 1, 3).out, "tile 1 of 3 was cut: " + name + "\n");
    EXPECT_FALSE(folder.read(name) == whole);
}

TEST(Tiles, ThatAreNotOfOnePartAreRefused) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    const auto refused = [&](const Words& more, const std::string& why) {
        const Ran ran = folder.run(Words{"merge", "tiles", "--stl", "a.stl"} + more);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_TRUE(contains(ran.err, why)) << ran.err;
        EXPECT_FALSE(folder.has("a.stl"));
    };
    ASSERT_EQ(cut(folder, {"slot.nc"}, 0, 3).exit_code, 0);
    ASSERT_EQ(cut(folder, {"slot.nc"}, 2, 3).exit_code, 0);
    refused({}, "1 of 3 tiles are missing");
    ASSERT_EQ(cut(folder, {"slot.nc"}, 1, 3, {"--tolerance", "0.01"}).exit_code, 0);
    refused({}, "tile-0001-of-0003.nctile': something else was asked for");
    ASSERT_EQ(cut(folder, {"slot.nc"}, 1, 3).exit_code, 0);
    EXPECT_EQ(folder.run({"merge", "tiles", "--stl", "a.stl"}).exit_code, 0);
    std::filesystem::remove(folder.path() / "a.stl");
    // A duplicate tile is permitted if both copies are equal.
    folder.write("tiles/copy.nctile", folder.read(tile_name(1, 3)));
    EXPECT_EQ(folder.run({"merge", "tiles"}).exit_code, 0);
    std::filesystem::remove(folder.path() / "tiles/copy.nctile");
    ASSERT_EQ(cut(folder, {"slot.nc"}, 0, 2).exit_code, 0);
    refused({}, "it is of another number of tiles");
    std::filesystem::remove(folder.path() / tile_name(0, 2));
    refused({"--json", "a.json"}, "no verdicts");
    // The program differs from the program that the tiles were cut with.
    folder.write("slot.nc", replaced(kSlot, "Z-2.", "Z-1."));
    refused({}, "'slot.nc' is not what it was when the tiles were cut");
    ASSERT_EQ(cut(folder, {"slot.nc"}, 1, 3).exit_code, 0);
    refused({}, "tile-0001-of-0003.nctile': it was made of other files");
    folder.write("tiles/x.ndjson", "{}\n");
    refused({}, "shards and tiles are not put together");
}

// Tile files may come from an untrusted source.
TEST(Tiles, DoNotSayWhatIsWritten) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    ASSERT_EQ(cut(folder, {"slot.nc"}, 0, 1).exit_code, 0);
    const std::string whole = folder.read(tile_name(0, 1));
    for (const char* word :
         {"--png=evil.png", "--frames=evil", "--save-job=evil.toml", "--no-such-option", "check"}) {
        const std::string head = "\"words\":[\"run\"";
        std::string body = whole.substr(0, whole.size() - 66);
        body = std::string(word) == "check" ? replaced(body, head, "\"words\":[\"check\"")
                                            : replaced(body, head, head + ",\"" + word + "\"");
        folder.write("body", body);
        const std::string digest = folder.shell("sha256sum < body").out.substr(0, 64);
        folder.write(tile_name(0, 1), body + '\n' + digest + '\n');
        const Ran ran = folder.run({"merge", "tiles", "--stl", "a.stl"});
        EXPECT_EQ(ran.exit_code, 2) << word;
        EXPECT_FALSE(contains(ran.err, "cut off")) << ran.err;
        EXPECT_EQ(folder.files(), (Words{"body", "slot.nc", "tiles"}));
    }
}

TEST(Tiles, TakeOptionsThatMakeSense) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    for (const Words& wrong :
         {Words{"--tile", "0/2"}, Words{"--tile-out", "tiles"},
          Words{"--tile", "2/2", "--tile-out", "tiles"},
          Words{"--tile", "0/4097", "--tile-out", "tiles"},
          Words{"--tile", "auto", "--tile-out", "tiles"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "--stl", "a.stl"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "--model", "cda-flat"}})
        EXPECT_EQ(folder.run(Words{"run", "slot.nc"} + wrong).exit_code, 2);
    EXPECT_EQ(folder
                  .shell("SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_COUNT=4 "
                         "\"$0\" run slot.nc --tile auto --tile-out tiles -q")
                  .out,
              "tile 1 of 4 was cut: " + tile_name(1, 4) + "\n");
    folder.write("x.ndjson", "{}\n");
    const Ran ran = folder.run({"merge", "x.ndjson", "--stl", "a.stl"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "--stl is written of tiles")) << ran.err;
    folder.write("rest.nc", "G21\nG0 X1.\nG2 X5. F10.\n");
    EXPECT_EQ(cut(folder, {"rest.nc"}, 0, 1).exit_code, 1);
    EXPECT_FALSE(folder.has(tile_name(0, 1)));
}

}  // namespace
}  // namespace ncsim::cli_test
