// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of small parts of reports: boxes, bars, lines, sources of values, designs, names of files,
// digests and lists of meshes.
#include "ncsim/base/file_names.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/design_facts.h"
#include "ncsim/report/file_digests.h"
#include "ncsim/report/mesh_list.h"
#include "ncsim/report/value_source.h"
#include "ncsim/verify/region.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {
namespace {

TEST(Describe, BoxesBarsAndFiles) {
    toolpath::Stock stock;
    stock.box = {{0, -5, -10.5}, {50, 40, 0}};
    const std::string box = "50 x 45 x 10.5 mm, X 0 to 50, Y -5 to 40, Z -10.5 to 0";
    EXPECT_EQ(describe(stock.box), box);
    EXPECT_EQ(describe(stock), box);
    stock.is_round = true;
    for (const auto& [axis, text] :
         std::vector<std::pair<int, std::string>>{{0, "a round bar along X in "},
                                                  {1, "a round bar along Y in "},
                                                  {2, "a round bar in "}}) {
        stock.axis = axis;
        EXPECT_EQ(describe(stock), text + box);
    }
    EXPECT_EQ(volume_text(1250.4), "1.250 cm3");
}

TEST(Describe, AtMostSixRangesOfLines) {
    EXPECT_EQ(verify::lines_text({}), "");
    EXPECT_EQ(verify::lines_text({{0, 3, 7}, {0, 12, 12}}), "3-7, 12");
    std::vector<verify::LineRange> many;
    many.reserve(7);
    for (std::uint32_t i = 1; i <= 6; ++i)
        many.push_back({0, 10 * i, 10 * i});
    EXPECT_EQ(verify::lines_text(many), "10, 20, 30, 40, 50, 60");
    many.push_back({0, 70, 71});
    EXPECT_EQ(verify::lines_text(many), "10, 20, 30, 40, 50, 60 and 1 more");
}

TEST(ValueSource, NamesCommentOptionTableAndAssumption) {
    using toolpath::ValueSource;
    const gcode::SourceSpan line{7, 1, 0};
    EXPECT_EQ(specified(ValueSource::Comment, line, "T1 D=6.", "", "--tool"), "line 7: (T1 D=6.)");
    EXPECT_EQ(specified(ValueSource::Option, line, "T1", "", "--tool"), "from --tool");
    EXPECT_EQ(specified(ValueSource::Table, line, "drill", "tool.tbl", "--tool"),
              "from tool.tbl, line 7: drill");
    EXPECT_EQ(specified(ValueSource::Table, {}, "", "tool.tbl", "--tool"), "from tool.tbl");
    EXPECT_EQ(specified(ValueSource::Assumption, line, "flat", "", "--tool"), "assumed: flat");
    EXPECT_EQ(specified(ValueSource::Comment, line, "a\nb", "", "").find('\n'), std::string::npos);
    EXPECT_STREQ(name_of(ValueSource::Comment), "comment");
    EXPECT_STREQ(name_of(ValueSource::Option), "option");
    EXPECT_STREQ(name_of(ValueSource::Table), "table");
    EXPECT_STREQ(name_of(ValueSource::Assumption), "assumption");
}

TEST(DesignText, CountsPlacesOnBothSides) {
    DesignFacts facts;
    facts.path = "part.stl";
    facts.tolerance_mm = 0.1;
    facts.deviation_mm = 0.03;
    EXPECT_EQ(text_of(facts), "part.stl within 0.1 mm: nothing beyond; farthest apart 0.03 mm");
    facts.gouge = {1.25, 8.0, 1};
    facts.excess = {0.5, std::nullopt, 2};
    facts.deviation_mm = 1.25;
    EXPECT_EQ(text_of(facts),
              "part.stl within 0.1 mm; gouged in 1 place, up to 1.25 mm, 8 mm3 in all; too much "
              "left in 2 places, up to 0.5 mm; farthest apart 1.25 mm");
    EXPECT_EQ(text_of(DesignPlace{true, 1.0, {-40, -0.0, -2}, 7}),
              "gouge 1 mm, line 7, at X-40 Y0 Z-2");
    EXPECT_EQ(text_of(DesignPlace{false, 0.5, {1, 2, 3}, 0}), "excess 0.5 mm, at X1 Y2 Z3");
}

TEST(DesignPlaces, LargestComeFirstInTheirOrder) {
    std::vector<DesignPlace> places(4);
    places[0].depth_mm = 1, places[0].line = 1;
    places[1].depth_mm = 3, places[1].line = 2;
    places[2].depth_mm = 1, places[2].line = 3;
    places[3].depth_mm = 2, places[3].line = 4;
    const auto lines = [](const std::vector<DesignPlace>& all) {
        std::string text;
        for (const DesignPlace& place : all)
            text += std::to_string(place.line);
        return text;
    };
    EXPECT_EQ(lines(largest(places, 4)), "2413");
    EXPECT_EQ(lines(largest(places, 3)), "241");
    EXPECT_EQ(lines(largest(places, 0)), "");
    EXPECT_EQ(lines(largest({}, 3)), "");
}

TEST(FileNames, AreRelativeWithinTheFolder) {
    EXPECT_EQ(base_name("a/b/c.nc"), "c.nc");
    EXPECT_EQ(base_name("c.nc"), "c.nc");
    EXPECT_EQ(base_name("a/"), "");
    EXPECT_EQ(relative_path("./a//b/../c.nc"), "a/c.nc");
    EXPECT_EQ(relative_path("../c.nc"), "../c.nc");
    const std::filesystem::path here = std::filesystem::current_path();
    EXPECT_EQ(relative_path((here / "sub" / "c.nc").string()), "sub/c.nc");
    EXPECT_EQ(relative_path((here.parent_path() / "other" / "c.nc").string()),
              (here.parent_path() / "other" / "c.nc").string());
}

TEST(FileDigests, ComeBackFromTheirLine) {
    const FileDigests files{{"a.nc", "12ab"}, {"missing \"b\".nc", std::nullopt}};
    const std::string line = line_of(files);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(file_digests_from(line), files);
    EXPECT_EQ(file_digests_from(line_of(FileDigests{})), FileDigests{});
    for (const char* bad : {"", "{}", "[1]", "[[\"a\"]]", "[[1,\"x\"]]", "[[\"a\",1]]",
                            "[[\"a\",\"x\",\"y\"]]", "[[\"a\",\"x\"]"}) {
        EXPECT_FALSE(file_digests_from(bad)) << bad;
    }
}

TEST(MeshList, IsJsonWithALineForEachFile) {
    std::ostringstream out;
    write_mesh_list(out, "part.nc", {1, 2, 3},
                    {{"a.ply", "00ff", {{0, 0, 0}, {1, 2, 3}}, 12, 4}, {"b.ply", "11", {}, 0, 0}});
    const auto list = nlohmann::json::parse(out.str());
    EXPECT_EQ(list["ncsim-meshes"], 1);
    EXPECT_EQ(list["program"], "part.nc");
    EXPECT_EQ(list["unit"], "mm");
    EXPECT_EQ(list["centre"], (std::vector<double>{1, 2, 3}));
    ASSERT_EQ(list["files"].size(), 2U);
    EXPECT_EQ(list["files"][0]["file"], "a.ply");
    EXPECT_EQ(list["files"][0]["sha256"], "00ff");
    EXPECT_EQ(list["files"][0]["faces"], 12);
    EXPECT_EQ(list["files"][0]["open_edges"], 4);
    EXPECT_EQ(list["files"][0]["box"]["max"], (std::vector<double>{1, 2, 3}));
    std::ostringstream empty;
    write_mesh_list(empty, "part.nc", {}, {});
    EXPECT_TRUE(nlohmann::json::parse(empty.str())["files"].empty());
}

}  // namespace
}  // namespace ncsim::report
