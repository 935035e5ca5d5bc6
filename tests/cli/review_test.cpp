// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim diff --html: the review of a change.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::cli_test {
namespace {

std::string replaced(const std::string& from, const std::string& to) {
    std::string text(kSlot);
    return text.replace(text.find(from), from.size(), to);
}

TEST(Review, HasLinesOfBothProgramsForEachDifference) {
    Folder folder;
    folder.write("a.nc", kSlot);
    // Half a millimetre deeper, but only along 30 of the 40 mm.
    folder.write("b.nc",
                 "(changed)\n" + replaced("G0 Z-2.\nG1 X30. F500.", "G0 Z-2.5\nG1 X5. F400."));
    const Ran ran = folder.run({"diff", "a.nc", "b.nc", "--html", "r.html"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_TRUE(contains(ran.out, "the parts differ"));
    const std::string page = folder.read("r.html");
    // The floor is deeper: the old floor is by line 8, the new program removed it in line 9.
    // The rest of the slot: uncut stock in the new part, which line 8 of the old program removed.
    for (const char* part :
         {"surface by a.nc: line <a href=\"#s1o-8\">8</a>, and uncut stock</p>"
          "<p>removed by b.nc: line <a href=\"#s1n-9\">9</a>",
          "removed by a.nc: line <a href=\"#s1o-8\">8</a></p><p>surface by b.nc: line <a "
          "href=\"#s1n-9\">9</a>, and uncut stock",
          "alt=\"old part, isometric\"", "alt=\"difference, from above\"",
          "<td>500 mm/min</td><td>400 mm/min</td><td>changed</td>", "id=\"s1n-11\""})
        EXPECT_TRUE(contains(page, part)) << part;
    folder.run({"diff", "a.nc", "b.nc", "--html", "s.html", "--threads", "3"});
    EXPECT_TRUE(folder.read("s.html") == page);
}

// A ring groove around a bore: the bore is in the box of the difference, but is the same.
TEST(Review, NamesNoLineOfASurfaceThatIsTheSame) {
    const auto ring = [](const char* depth) {
        return "(T1 D=4. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n"
               "(FROM/0.,0.,100.)\nG21 G90 G17 T1 M6\nS1000 M3\nG0 X10. Y0. Z5.\nG1 Z" +
               std::string(depth) +
               " F500.\nG2 X10. Y0. I-10. J0.\nG0 Z5.\nX0. Y0.\nG1 Z-4.\nG0 Z5.\nM30\n";
    };
    Folder folder;
    folder.write("a.nc", ring("-2."));
    folder.write("b.nc", ring("-3."));
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--html", "r.html"}).exit_code, 1);
    const std::string page = folder.read("r.html");
    EXPECT_TRUE(contains(page, "id=\"s1o-8\"><a class=\"region\" href=\"#s1r-1\"")) << page;
    EXPECT_TRUE(contains(page, "id=\"s1o-11\">11</td>"));
    EXPECT_TRUE(contains(page, "id=\"s1n-11\">11</td>"));
}

TEST(Review, ShowsTheSideThatDiffers) {
    const auto slot = [](const char* depth) {
        return "(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,30.,20.,20.,15.,20.)\n"
               "(FROM/0.,0.,100.)\nG21 G90 G17 T1 M6\nS1000 M3\nG0 A90. X-30. Y-10. Z30.\nZ" +
               std::string(depth) + "\nG1 X30. F500.\nG0 Z40.\nM30\n";
    };
    Folder folder;
    folder.write("a.nc", slot("12."));
    folder.write("b.nc", slot("11."));
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--html", "r.html"}).exit_code, 1);
    const std::string page = folder.read("r.html");
    EXPECT_TRUE(contains(page, "alt=\"difference, from the front\""));
    EXPECT_FALSE(contains(page, "from above"));
}

TEST(Review, OfEqualProgramsSaysSo) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", kSlot);
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--html", "r.html"}).exit_code, 0);
    const std::string page = folder.read("r.html");
    for (const char* part : {"the same motions with the same tools", "The texts are the same."})
        EXPECT_TRUE(contains(page, part)) << part;
    // The same part by other motions, and by another feed.
    folder.write("b.nc", replaced("G1 X30. F500.", "G1 X-1. F500.\nG0 Z5.\nX30.\nZ-2.\nG1 X-1."));
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--html", "r.html"}).exit_code, 0);
    EXPECT_TRUE(contains(folder.read("r.html"), "Both programs make the same part."));
    folder.write("b.nc", replaced("F500.", "F400."));
    const Ran ran = folder.run({"diff", "a.nc", "b.nc", "--html", "r.html", "--process", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(contains(folder.read("r.html"), "the same part, the process differs"));
}

TEST(Review, HasAPartForEachSetUpOfAJob) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", replaced("G0 Z-2.\n", "G0 Z-3.\n"));
    const auto job = [](const std::string& second) {
        return "version = 2\n[[setup]]\nname = \"front\"\nprogram = \"a.nc\"\n"
               "[[setup]]\nname = \"back\"\nprogram = \"" +
               second + "\"\nturn = \"X180\"\nmove = [0, 0, -10]\n";
    };
    folder.write("old.toml", job("a.nc"));
    folder.write("new.toml", job("b.nc"));
    const Ran ran = folder.run({"diff", "old.toml", "new.toml", "--html", "r.html"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    const std::string page = folder.read("r.html");
    EXPECT_TRUE(contains(page, "front: a.nc → a.nc: the same part</h2>")) << ran.out;
    EXPECT_TRUE(contains(page, "back: a.nc → b.nc: the parts differ</h2>"));
}

TEST(Review, IsWrittenWholeOrNotAtAll) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", "G21 G90\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F10\nM30\n");
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--html", "r.html"}).exit_code, 2);
    EXPECT_FALSE(folder.has("r.html"));
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--html", "a.nc"}).exit_code, 2);
    EXPECT_EQ(folder.read("a.nc"), kSlot);
    EXPECT_EQ(folder.run({"diff", "a.nc", "a.nc", "--html", "no/r.html"}).exit_code, 2);
    EXPECT_EQ(folder.files().size(), 2U);
    const Ran both = folder.run({"diff", "a.nc", "a.nc", "--html", "-"});
    EXPECT_EQ(both.out.substr(0, 15), "<!DOCTYPE html>");
    EXPECT_TRUE(contains(both.err, "the same motions"));
}

}  // namespace
}  // namespace ncsim::cli_test
