// SPDX-License-Identifier: GPL-3.0-or-later
//
// Patterns of ncsim.toml. Effects on programs are tested with the whole program in
// cli/project_test.cpp.
#include "ncsim/setup/project_file.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::setup {
namespace {

TEST(ProjectFile, PatternsMeanWhatPeopleExpect) {
    for (const char* path : {"a.nc", "ab.nc", ".nc"})
        EXPECT_TRUE(matches("*.nc", path)) << path;
    for (const char* path : {"b/a.nc", "a.nc/b", "a.ncx", ""})
        EXPECT_FALSE(matches("*.nc", path)) << path;
    for (const char* path : {"a.nc", "x/a.nc", "x/y/a.nc"})
        EXPECT_TRUE(matches("**/*.nc", path)) << path;
    for (const char* path : {"turning/a.nc", "turning/x/y/b.nc"})
        EXPECT_TRUE(matches("turning/**", path)) << path;
    EXPECT_FALSE(matches("turning/**", "milling/turning/a.nc"));
    EXPECT_TRUE(matches("op?_*.nc", "op1_rough.nc"));
    EXPECT_FALSE(matches("op?_*.nc", "op10_rough.nc"));
    EXPECT_TRUE(matches("a/**/b/**/c.nc", "a/b/x/b/c.nc"));
    EXPECT_FALSE(matches("a/**/b/**/c.nc", "a/x/c.nc"));
    EXPECT_TRUE(matches("a.nc", "a.nc"));
    EXPECT_FALSE(matches("A.nc", "a.nc"));
    EXPECT_FALSE(matches("../x.nc", "x.nc"));
}

TEST(ProjectFile, PatternsOfManyStarsEnd) {
    std::string stars;
    std::string folders;
    for (int i = 0; i < 200; ++i) {
        stars += "**/*a*a*a*a*/";
        folders += "aaaaaaaaaaaaaaaaaaab/";
    }
    EXPECT_FALSE(matches(stars + "c", folders + "d"));
    EXPECT_TRUE(matches(stars + "d", folders + "d"));
}

TEST(ProjectFile, OfSettingsOfOneOptionTheLastHolds) {
    ProjectFile project;
    project.name = "ncsim.toml";
    project.sections = {
        {{}, {{"machine", {"all.toml"}, false, true, ""}, {"strict", {}, true, true, ""}}},
        {{"a/**"}, {{"machine", {"a.toml"}, false, true, ""}}},
        {{"**/b.nc", "c.nc"}, {{"machine", {"b.toml"}, false, true, ""}}}};
    const auto machine = [&](const std::string& program) {
        const auto settings = settings_for(project, program);
        EXPECT_EQ(settings.size(), 2U) << program;
        std::string result;
        for (const OptionSetting& setting : settings) {
            if (setting.option == "machine") result = setting.values.at(0);
        }
        return result;
    };
    EXPECT_EQ(machine("x.nc"), "all.toml");
    EXPECT_EQ(machine("a/x.nc"), "a.toml");
    EXPECT_EQ(machine("./a/y/../x.nc"), "a.toml");
    EXPECT_EQ(machine("a/b.nc"), "b.toml");
    EXPECT_EQ(machine("c.nc"), "b.toml");
    EXPECT_EQ(machine("-"), "all.toml");
}

}  // namespace
}  // namespace ncsim::setup
