// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the text of the review of a change.
#include "ncsim/report/review_page.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace ncsim::report {
namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string page_of(const std::vector<simulation::Review>& reviews,
                    LengthUnit unit = LengthUnit::Millimetre) {
    std::ostringstream out;
    write_review(out, reviews, unit);
    return out.str();
}

// A pocket that the new program makes deeper, with a slower feed.
simulation::Review deeper_pocket() {
    simulation::Review review;
    Difference& d = review.difference;
    d.old_name = "old.nc";
    d.new_name = "new.nc";
    d.differs = true;
    d.old_mm3 = 10'000.0;
    d.new_mm3 = 9'000.0;
    const Box box{{0, 0, -2}, {10, 10, 0}};
    d.only_old = {1000.0, {{1000.0, box, {{0, 2, 2}}}}, {"new.nc"}};
    d.process.only_old.push_back({"old.nc", 2, "T1, feed 800 mm/min"});
    d.process.only_new.push_back({"sub.nc", 1, "T1, feed 700 mm/min"});
    review.old_side.source = "G21\nG1 Z-4.\nM30\n";
    review.new_side.source = "G21\nG1 Z-6.\nM30\n";
    review.old_side.files = {"old.nc"};
    review.new_side.files = {"new.nc", "lib/sub.nc"};
    review.old_side.tools[1] = {
        {"800 mm/min", "M3 5000 rpm", "off"}, "flat end mill D10", {100.0, 200.0, 15.0, 0.0, 1}};
    review.new_side.tools[1] = review.old_side.tools[1];
    review.new_side.tools[1].feed = "700 mm/min";
    review.new_side.tools[1].distances.feed_seconds = 20.0;
    review.new_side.tools[2] = review.old_side.tools[1];
    review.old_side.tools[0].distances.rapid_mm = 10.0;  // before the first tool
    review.regions.push_back(
        {true, 1000.0, box, {5, 5, -1}, {{0, 2, 2}}, {{0, 2, 2}, {1, 7, 9}}, true});
    review.pictures.push_back({"isometric", "BEFORE", "AFTER", "CHANGE", {{0, 0.25, 0.5}}});
    return review;
}

TEST(ReviewPage, LinksRegionsAndLinesOfBothPrograms) {
    const std::string page = page_of({deeper_pocket()});
    for (const char* part :
         {"<header class=\"failed\">",
          "<h1>old.nc → new.nc: the parts differ, the process differs</h1>",
          "only in old.nc: 1000 mm3",
          "<p>surface by old.nc: line <a href=\"#s1o-2\">2</a>, and uncut stock</p>",
          "<p>removed by new.nc: lines <a href=\"#s1n-2\">2</a>, sub.nc:7–9</p>",
          "href=\"#s1r-1\" title=\"difference 1\" style=\"left:25.00%;top:50.00%\">1</a>",
          "<li class=\"old\">− <a href=\"#s1o-2\">old.nc:2</a>: T1, feed 800 mm/min</li>",
          "<li class=\"new\">+ sub.nc:1: T1, feed 700 mm/min</li>",
          "src=\"data:image/png;base64,QkVGT1JF\"",  // BEFORE
          "alt=\"difference, isometric\"", "lines only in old.nc: 1; only in new.nc: 1"})
        EXPECT_TRUE(contains(page, part)) << part;
    EXPECT_FALSE(contains(page, "http"));
}

TEST(ReviewPage, ShowsChangesOfValues) {
    const std::string page = page_of({deeper_pocket()});
    for (const char* row :
         {"<tr class=\"differs\"><th scope=\"row\">volume of the part</th><td>10000 mm3</td>"
          "<td>9000 mm3</td><td>-1000 mm3 (-10.0 %)</td></tr>",
          "<tr class=\"differs\"><th scope=\"row\">feed</th><td>800 mm/min</td>"
          "<td>700 mm/min</td><td>changed</td></tr>",
          "<tr><th scope=\"row\">spindle</th><td>M3 5000 rpm</td><td>M3 5000 rpm</td><td></td>",
          "<tr class=\"differs\"><th scope=\"row\">shape</th><td>not used</td>"})
        EXPECT_TRUE(contains(page, row)) << row;
    EXPECT_TRUE(contains(page, "+5 s (+"));
    EXPECT_TRUE(contains(page, "rapid path</th><td>110.0 mm</td><td>200.0 mm</td>"));
    EXPECT_FALSE(contains(page, "T0"));
    EXPECT_TRUE(contains(page_of({deeper_pocket()}, LengthUnit::Inch), "<td>0.6102 in3</td>"));
}

TEST(ReviewPage, SaysThatProgramsAreIdentical) {
    simulation::Review review = deeper_pocket();
    review.difference = {};
    review.difference.old_name = "old.nc";
    review.difference.new_name = "copy.nc";
    review.difference.same_motions = true;
    review.new_side = review.old_side;
    review.regions.clear();
    review.pictures = {{"isometric", "BEFORE", "", "", {}}};
    const std::string page = page_of({review});
    for (const char* part : {"<header class=\"clean\"><h1>old.nc → copy.nc: the same part</h1>",
                             "Both programs make the same motions with the same tools.",
                             "The texts are the same.", "both, isometric"})
        EXPECT_TRUE(contains(page, part)) << part;
    for (const char* part : {"changed\"", "Differences of the part", "alt=\"new part", "differs\""})
        EXPECT_FALSE(contains(page, part)) << part;
}

TEST(ReviewPage, HasAPartForEachSetUp) {
    simulation::Review first = deeper_pocket(), second = deeper_pocket();
    first.difference.set_up = "set-up 1, front";
    second.difference.set_up = "set-up 2, back";
    second.difference.differs = false;
    second.difference.process = {};
    const std::string page = page_of({first, second});
    EXPECT_TRUE(contains(page, "<h1>2 programs: the parts differ, the process differs</h1>"));
    EXPECT_TRUE(contains(page, ">set-up 2, back: old.nc → new.nc: the same part</h2>"));
    EXPECT_TRUE(contains(page, "id=\"s1o-2\"") && contains(page, "id=\"s2o-2\""));
}

TEST(ReviewPage, IsHarmlessForAnyNames) {
    simulation::Review review = deeper_pocket();
    const std::string bad = "<img src=x onerror=\"alert(1)\">\n\x1b\xff&";
    Difference& d = review.difference;
    d.old_name = d.new_name = d.set_up = d.stocks = bad;
    d.process.only_old[0] = {bad, 1, bad};
    review.old_side.source = review.new_side.source = bad;
    review.new_side.files = {bad, bad};
    review.old_side.tools[1].shape = review.old_side.tools[1].feed = bad;
    const std::string page = page_of({review});
    for (const char* part : {"<img src=x", "\x1b", "\xff"})
        EXPECT_FALSE(contains(page, part)) << part;
    EXPECT_TRUE(contains(page, "&lt;img src=x onerror=&quot;alert(1)&quot;&gt;"));
}

}  // namespace
}  // namespace ncsim::report
