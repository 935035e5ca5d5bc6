// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of cut parts, of distances from a design, and of findings.
#include "ncsim/export/image.h"

#include "../support/read_png.h"
#include "run/sheet_layout.h"
#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

namespace ncsim::cli_test {
namespace {

using exporter::Image;
using exporter::Rgba8;

void expect_refused(const Ran& ran, const std::string& message) {
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, message)) << ran.err;
}

// Copies the example of a rule, with all of its files.
void copy_example(const Folder& folder, const std::string& rule) {
    const std::filesystem::path from =
        std::filesystem::path(NCSIM_SOURCE_DIR) / "examples/rules" / rule;
    std::filesystem::copy(from, folder.path());
}

std::size_t count(const Image& image, bool (*matches)(Rgba8)) {
    return static_cast<std::size_t>(std::ranges::count_if(image.pixels, matches));
}

bool is_red(Rgba8 c) {
    return c.r > 100 && c.r > 2 * c.g && c.r > 2 * c.b;
}
bool is_orange(Rgba8 c) {
    return c.r > 100 && c.g > c.b + 40 && c.r > c.g + 40 && c.r < 3 * c.g;
}
bool is_green(Rgba8 c) {
    return c.g > c.r + 20 && c.g > c.b + 20;
}

TEST(Picture, ViewsAreAsOnADrawing) {
    using exporter::View;
    using Cells = std::vector<exporter::SheetCell>;
    const auto cells = [](std::vector<View> views) { return app::third_angle(views); };
    EXPECT_EQ(cells({View::Iso, View::Top, View::Front}), (Cells{{1, 0}, {0, 0}, {0, 1}}));
    EXPECT_EQ(cells({View::Front, View::Right}), (Cells{{0, 0}, {1, 0}}));
    EXPECT_EQ(cells({View::Front, View::Iso}), (Cells{{0, 0}, {1, 0}}));
    EXPECT_EQ(cells({View::Left, View::Front, View::Back, View::Bottom, View::Top, View::Iso}),
              (Cells{{0, 1}, {1, 1}, {3, 1}, {1, 2}, {1, 0}, {2, 0}}));
    EXPECT_TRUE(cells({View::Iso, View::Top}).empty());
    EXPECT_TRUE(cells({View::Front, View::Front}).empty());
}

// Returns the first and the last column, or row, with material: the part is 40 mm wide, 30 mm deep.
std::pair<std::uint32_t, std::uint32_t> extent(const Image& image, bool along_x, std::uint32_t left,
                                               std::uint32_t right, std::uint32_t top,
                                               std::uint32_t bottom) {
    std::uint32_t first = ~0U, last = 0;
    for (std::uint32_t y = top; y < bottom; ++y) {
        for (std::uint32_t x = left; x < right; ++x) {
            if (image.at(x, y) == Rgba8{255, 255, 255}) continue;
            first = std::min(first, along_x ? x : y);
            last = std::max(last, along_x ? x : y);
        }
    }
    return {first, last};
}

TEST(Picture, ViewsOfASheetHaveOneScaleAndAreAligned) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran = folder.run({"run", "slot.nc", "-q", "--marks", "none", "--size", "400x300",
                                "--views", "top,front,right", "--png", "a.png"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const Image image = test::read_png(folder.read("a.png"));
    EXPECT_EQ(image.width, 800U);
    EXPECT_EQ(image.height % 2, 0U);
    // The labels are in the upper left corners.
    const auto top = extent(image, true, 0, 400, 60, 240);
    const auto depth = extent(image, false, 100, 300, 0, 300);
    const auto front = extent(image, true, 0, 400, 330, 380);
    const auto right = extent(image, true, 400, 800, 330, 380);
    EXPECT_EQ(front, top);
    const double scale = (top.second - top.first) / 40.0;
    EXPECT_NEAR(depth.second - depth.first, 30.0 * scale, 2.0);
    EXPECT_NEAR(right.second - right.first, 30.0 * scale, 2.0);
    // Rows are cropped: the front view is 10 mm high.
    EXPECT_LT(image.height, 600U);
}

TEST(Picture, CutViewShowsTheCutInEachViewAndFrame) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"run",     "slot.nc", "-q",   "--size",
                                           "240x240", "--png",   "a.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = folder.run(arguments);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read("a.png");
    };
    const std::string whole = run({}), cut = run({"--cut-view", "x=3.5"});
    EXPECT_NE(cut, whole);
    EXPECT_EQ(run({"--cut-view", "X=3.5"}), cut);
    EXPECT_NE(run({"--cut-view", "x=3"}), cut);
    EXPECT_NE(run({"--views", "iso,left,right"}),
              run({"--views", "iso,left,right", "--cut-view", "x=3.5"}));
    EXPECT_NE(run({"--model", "cda-flat"}), run({"--model", "cda-flat", "--cut-view", "x=3.5"}));
    EXPECT_NE(run({"--model", "dexel"}), run({"--model", "dexel", "--cut-view", "x=3.5"}));
    run({"--cut-view", "y=0", "--frames", "film", "--gif", "a.gif", "--apng", "a.apng", "--every",
         "1"});
    EXPECT_EQ(folder.read("a.apng").substr(1, 3), "PNG");
    EXPECT_TRUE(contains(folder.read("a.apng"), "acTL"));
}

TEST(Picture, CutViewRefusesPlanesThatDoNotCutThePart) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const auto run = [&](const std::string& plane) {
        return folder.run({"run", "slot.nc", "-q", "--cut-view", plane, "--png", "a.png"});
    };
    for (const char* plane : {"q=1", "x", "x=", "=3", "x=nan", "x=1e999", "x=1,y=2", ""})
        expect_refused(run(plane), "expected x=, y= or z= and a number of mm");
    expect_refused(run("x=1e9"), "a number of mm within 1 km");
    expect_refused(run("x=99999"),
                   "--cut-view x=99999: the plane does not cut the stock, X -20 to 20 mm");
    expect_refused(run("x=20"), "the plane does not cut the stock");
    expect_refused(run("x=-20"), "the plane does not cut the stock");
    EXPECT_EQ(run("x=19.999").exit_code, 0);
    expect_refused(folder.run({"run", "slot.nc", "--cut-view", "x=1"}),
                   "--cut-view changes pictures: it needs --png");
    // The top of the stock is milled away.
    std::string faced(kSlot);
    faced.replace(faced.find("D=10."), 5, "D=90.");
    folder.write("slot.nc", faced);
    std::filesystem::remove(folder.path() / "a.png");
    expect_refused(run("z=-1"), "the plane does not cut the part, Z -10 to -2 mm");
    EXPECT_FALSE(folder.has("a.png"));
}

TEST(Picture, ShadeAndTransparencyChangeEachPicture) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"run",    "slot.nc", "-q",    "--size", "240x240",
                                           "--view", "top",     "--png", "a.png",  "--apng",
                                           "a.apng", "--every", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = folder.run(arguments);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return std::pair{folder.read("a.png"), folder.read("a.apng")};
    };
    const auto usual = run({}), plain = run({"--shade", "none"}), open = run({"--see-through"});
    EXPECT_EQ(run({"--shade", "recesses"}), usual);
    EXPECT_NE(plain.first, usual.first);
    EXPECT_NE(plain.second, usual.second);
    EXPECT_NE(open.first, usual.first);
    EXPECT_NE(open.second, usual.second);
    EXPECT_EQ(run({"--see-through", "--shade", "none"}), open);
    EXPECT_EQ(run({"--see-through", "--model", "cda-flat"}).first, open.first);

    const auto refused = [&](std::vector<std::string> more, const char* message) {
        more.insert(more.begin(), {"run", "slot.nc", "-q"});
        expect_refused(folder.run(more), message);
    };
    refused({"--png", "b.png", "--shade", "x"}, "--shade 'x': expected recesses or none");
    refused({"--see-through"}, "--see-through changes pictures: it needs --png");
    refused({"--png", "b.png", "--see-through", "--renderer", "osmesa"},
            "--see-through: OSMesa draws no transparent part; omit --renderer");
    EXPECT_FALSE(folder.has("b.png"));
    expect_refused(folder.run({"check", "slot.nc", "--see-through"}),
                   "--see-through changes pictures: it needs --png");
}

// Facts of the last frame are longer than those of the first frame.
TEST(Picture, FramesWithCaptionsHaveOneSize) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    for (const char* size : {"240x240", "320x240", "300x200"}) {
        std::filesystem::remove_all(folder.path() / "film");
        EXPECT_EQ(folder
                      .run({"run", "slot.nc", "-q", "--caption", "--size", size, "--frames", "film",
                            "--every", "1", "--png", "a.png"})
                      .exit_code,
                  0);
        const Image last = test::read_png(folder.read("a.png"));
        std::size_t frames = 0;
        for (const auto& file : std::filesystem::directory_iterator(folder.path() / "film")) {
            const Image frame =
                test::read_png(folder.read("film/" + file.path().filename().string()));
            EXPECT_EQ(frame.height, last.height);
            ++frames;
        }
        EXPECT_GT(frames, 2U);
    }
}

TEST(Picture, AnimationsHaveTheirEndings) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    expect_refused(folder.run({"run", "slot.nc", "--png", "x.apng"}),
                   "--png 'x.apng': the ending is that of another format; 'x.png'");
    expect_refused(folder.run({"run", "slot.nc", "--apng", "x.gif"}),
                   "--apng 'x.gif': the ending is that of another format; 'x.apng'");
    EXPECT_EQ(folder.run({"run", "slot.nc", "-q", "--size", "64x48", "--apng", "x.png"}).exit_code,
              0);
    EXPECT_TRUE(folder.has("x.png"));
}

TEST(Picture, DesignColoursShowGougesExcessAndTolerance) {
    Folder folder;
    copy_example(folder, "gouge");
    const Ran ran = folder.run(
        {"run", "fails.nc", "--colour", "design", "--png", "a.png", "--size", "480x360"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out,
                         "design    design.stl within 0.1 mm; gouged in 1 place, up to 1 mm, 400 "
                         "mm3 in all; farthest apart 1 mm\n"
                         "          1  gouge 1 mm, line 7, at X-40 Y-20 Z-2\n"))
        << ran.out;
    const Image image = test::read_png(folder.read("a.png"));
    EXPECT_GT(count(image, is_green), 5000U);
    EXPECT_GT(count(image, is_red), 500U);
    EXPECT_GT(image.height, 360U);  // with the places below

    const Ran good = folder.run(
        {"run", "passes.nc", "--colour", "design", "--png", "b.png", "--size", "480x360"});
    ASSERT_EQ(good.exit_code, 0) << good.err;
    EXPECT_TRUE(contains(good.out, "within 0.1 mm: nothing beyond")) << good.out;
    EXPECT_LT(count(test::read_png(folder.read("b.png")), is_red), 500U);
    // Plain colours need no comparison.
    const Ran plain = folder.run({"run", "fails.nc", "--png", "c.png"});
    EXPECT_FALSE(contains(plain.out, "design ")) << plain.out;
}

TEST(Picture, DesignColoursRefuseWhatTheyCannotShow) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("bad.stl", "solid nothing\nendsolid nothing\n");
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"run", "slot.nc", "-q", "--colour", "design"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return folder.run(arguments);
    };
    expect_refused(run({"--png", "a.png"}), "--colour design: of which design? --design part.stl");
    expect_refused(run({"--design", "none.stl", "--png", "a.png"}), "none.stl");
    expect_refused(run({"--design", "bad.stl", "--png", "a.png"}), "bad.stl");
    expect_refused(run({"--design", "bad.stl", "--gif", "a.gif"}),
                   "--colour design shows the finished part");
    expect_refused(run({"--design", "bad.stl"}), "--colour design shows the finished part");
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"bad.stl", "slot.nc"}));
}

TEST(Picture, AFindingShowsTheToolWhereItMeetsTheFixture) {
    Folder folder;
    copy_example(folder, "fixture-contact");
    const Ran ran = folder.run({"check", "fails.nc", "-q", "--png", "a.png", "--size", "480x360"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    const Image image = test::read_png(folder.read("a.png"));
    EXPECT_GT(count(image, is_red), 300U);      // the tool
    EXPECT_GT(count(image, is_orange), 2000U);  // the jaw

    const Ran good =
        folder.run({"check", "passes.nc", "-q", "--png", "b.png", "--size", "480x360"});
    EXPECT_EQ(good.exit_code, 0) << good.err;
    const Image clean = test::read_png(folder.read("b.png"));
    EXPECT_LT(count(clean, is_red), 200U);  // an axis
    EXPECT_EQ(count(clean, is_orange), 0U);
}

// A rapid move through the block: the tool is shown in the block, which is whole there.
TEST(Picture, AFindingShowsTheMaterialBeforeARapidMove) {
    Folder folder;
    copy_example(folder, "rapid-in-material");
    const auto picture = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"check", "fails.nc", "-q",     "--png",
                                           "a.png", "--size",   "480x360"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = folder.run(arguments);
        EXPECT_EQ(ran.exit_code, 1) << ran.err;
        return folder.read("a.png");
    };
    const std::string first = picture({});
    EXPECT_GT(count(test::read_png(first), is_red), 300U);
    EXPECT_EQ(picture({"--finding", "1"}), first);
    EXPECT_NE(picture({"--view", "top"}), first);
    EXPECT_NE(picture({"--cut-view", "y=0"}), first);
}

// Two rapid moves through the block: the tool stands at its left, then at its right.
TEST(Picture, AFindingIsChosenByItsNumber) {
    Folder folder;
    folder.write("a.nc",
                 "G21 G90 G17 G54\n(STOCK/BLOCK,60,40,10,0,0,10)\n(T1 D=6)\nT1 M6\n"
                 "S9000 M3\nG0 X8 Y20 Z5\nZ-4\nG1 Z5 F900\nG0 X52\nZ-4\n"
                 "G1 Z5 F900\nM30\n");
    const auto tool_at = [&](const std::string& number) {
        const Ran ran = folder.run({"check", "a.nc", "-q", "--png", "a.png", "--view", "top",
                                    "--size", "480x360", "--finding", number});
        EXPECT_EQ(ran.exit_code, 4) << ran.err;
        const Image image = test::read_png(folder.read("a.png"));
        double sum = 0.0;
        std::size_t pixels = 0;
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                if (!is_red(image.at(x, y))) continue;
                sum += x;
                ++pixels;
            }
        }
        EXPECT_GT(pixels, 300U);
        return sum / static_cast<double>(pixels) / image.width;
    };
    EXPECT_LT(tool_at("1"), 0.4);
    EXPECT_GT(tool_at("2"), 0.6);
}

TEST(Picture, FindingsRefuseWhatTheyCannotShow) {
    Folder folder;
    copy_example(folder, "rapid-in-material");
    expect_refused(
        folder.run({"check", "fails.nc", "--png", "a.png", "--finding", "9"}),
        "--finding 9: the text lists 1 finding of the program; --notes lists the notes too");
    expect_refused(folder.run({"check", "fails.nc", "--finding", "1"}), "--png");
    expect_refused(folder.run({"check", "fails.nc", "passes.nc", "--png", "a.png"}),
                   "--png: the picture is of a finding of one program");
    expect_refused(folder.run({"check", ".", "--png", "a.png"}), "--png: no picture");
    expect_refused(folder.run({"check", "fails.nc", "--png", "a.jpg"}),
                   "the ending is that of another format");
    expect_refused(folder.run({"check", "fails.nc", "--cut-view", "x=1"}), "it needs --png");
    expect_refused(folder.run({"check", "fails.nc", "--png", "a.png", "--cut-view", "x=999"}),
                   "the plane does not cut the stock");
    expect_refused(folder.run({"check", "fails.nc", "--png", "a.png", "--isolate"}), "--isolate");
    EXPECT_FALSE(folder.has("a.png"));
}

}  // namespace
}  // namespace ncsim::cli_test
