// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim -q: no text without findings, errors or results.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using Words = std::vector<std::string>;

TEST(Quiet, PrintsNothingIfThereIsNothingToReport) {
    const Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("ncsim.toml", "version = 1\n");
    folder.write("lib.csv", "T,D\n1,6\n");
    for (const Words& words :
         {Words{"run", "a.nc", "--stl", "a.stl"}, Words{"run", "a.nc", "--draft", "--png", "a.png"},
          Words{"check", "a.nc", "--json", "a.json"}, Words{"check", "."},
          Words{"diff", "a.nc", "a.nc"}, Words{"measure", "a.nc", "--json", "m.json"},
          Words{"init", "a.nc"}, Words{"init", "--repo", "--output", "other.toml"},
          Words{"tools", "a.nc", "--save-job", "t.toml"},
          Words{"tools", "--tool-table", "lib.csv", "--convert", "lib.tbl"},
          Words{"sheet", "t.toml", "--html", "s.html"}}) {
        Words quiet = words;
        if (words[0] != "sheet") quiet.emplace_back("-q");
        const Ran ran = folder.run(quiet);
        EXPECT_EQ(ran.exit_code, 0) << words[0];
        EXPECT_EQ(ran.out + ran.err, "") << words[0];
    }
    for (const char* file : {"a.stl", "a.png", "a.json", "m.json", "job.toml", "other.toml",
                             "t.toml", "lib.tbl", "s.html"})
        EXPECT_TRUE(folder.has(file)) << file;
}

TEST(Quiet, PrintsResultsAndFindings) {
    const Folder folder;
    folder.write("a.nc", kSlot);
    std::string rapid = kSlot;
    folder.write("b.nc", rapid.replace(rapid.find("G1 X30. F500."), 13, "G0 X30."));
    EXPECT_TRUE(contains(folder.run({"measure", "a.nc", "-q"}).out, "floors"));
    EXPECT_TRUE(contains(folder.run({"tools", "a.nc", "-q"}).out, "T1"));
    const Ran failed = folder.run({"check", "b.nc", "-q"});
    EXPECT_EQ(failed.exit_code, 1);
    EXPECT_TRUE(contains(failed.out, "[rapid-in-material]"));
    EXPECT_FALSE(contains(failed.out, "skipped"));
    EXPECT_FALSE(folder.run({"run", "none.nc", "-q"}).err.empty());
}

}  // namespace
}  // namespace ncsim::cli_test
