// SPDX-License-Identifier: GPL-3.0-or-later
//
// First job files: ncsim init.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

void replace(const Folder& folder, const std::string& old, const std::string& text) {
    std::string job = folder.read("job.toml");
    const std::size_t at = job.find(old);
    ASSERT_NE(at, std::string::npos) << old << '\n' << job;
    folder.write("job.toml", job.replace(at, old.size(), text));
}

TEST(Init, WritesAJobThatIsNotProvenUntilItsAssumptionsAreRemoved) {
    const Folder folder;
    folder.write("part.nc", kSlot);
    const Ran init = folder.run({"init", "part.nc"});
    EXPECT_EQ(init.exit_code, 0) << init.err;
    EXPECT_TRUE(contains(init.out, "ncsim check job.toml")) << init.out;
    const Ran open = folder.run({"check", "job.toml"});
    EXPECT_EQ(open.exit_code, 4) << open.out << open.err;
    EXPECT_TRUE(contains(open.out, "'machine' is marked as assumed")) << open.out;
    EXPECT_TRUE(contains(open.out, "'fixtures' is marked as assumed")) << open.out;
    // The comments of the program specify stock, start and diameter.
    EXPECT_FALSE(contains(open.out, "'start' is marked")) << open.out;
    replace(folder, "assumed = [\"machine\", \"dialect\"]\n", "");
    replace(folder, "assumed = [\"fixtures\"]\n", "");
    replace(folder, "assumed = [\"length\"]\n", "");
    const Ran clean = folder.run({"check", "job.toml"});
    EXPECT_EQ(clean.exit_code, 0) << clean.out << folder.read("job.toml");
}

TEST(Init, WritesASetUpForEachProgram) {
    const Folder folder;
    folder.write("sub/a.nc", "G21 G90\nT1 M6\nS900 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX20\nG0 Z5\nM2\n");
    folder.write("sub/b.nc", kSlot);
    const Ran init = folder.run({"init", "sub/b.nc", "sub/a.nc", "-o", "sub/two.toml"});
    ASSERT_EQ(init.exit_code, 0) << init.err;
    const std::string job = folder.read("sub/two.toml");
    EXPECT_TRUE(contains(job, "program = \"a.nc\"")) << job;
    EXPECT_TRUE(contains(job, "turn = \"X180\"\nmove = [0.0, 0.0, -10.0]")) << job;
    const Ran check = folder.run({"check", "sub/two.toml"});
    EXPECT_EQ(check.exit_code, 4) << check.out << check.err;
    EXPECT_TRUE(contains(check.out, "'place' is marked as assumed")) << check.out;
}

TEST(Init, NeverReplacesAFile) {
    const Folder folder;
    folder.write("part.nc", kSlot);
    folder.write("job.toml", "mine");
    folder.write("ncsim.toml", "version = 1\n");
    std::filesystem::create_symlink("nowhere", folder.path() / "link.toml");
    const std::vector<std::string> before = folder.files();
    for (const std::vector<std::string>& words : {std::vector<std::string>{"init", "part.nc"},
                                                  {"init", "part.nc", "-o", "link.toml"},
                                                  {"init", "--repo"},
                                                  {"init"},
                                                  {"init", "job.toml"},
                                                  {"init", "none.nc", "-o", "x.toml"},
                                                  {"init", "part.nc", "-o", "part.nc"},
                                                  {"init", "part.nc", "-o", "no/x.toml"}}) {
        EXPECT_EQ(folder.run(words).exit_code, 2) << words.back();
    }
    EXPECT_EQ(folder.files(), before);
    EXPECT_EQ(folder.read("job.toml"), "mine");
    EXPECT_EQ(folder.read("part.nc"), kSlot);
}

TEST(Init, OfARepositoryNamesTheFoldersWithPrograms) {
    const Folder folder;
    folder.write("parts/a.nc", kSlot);
    folder.write("notes/text.md", "# Words\n");
    ASSERT_EQ(folder.run({"init", "--repo"}).exit_code, 0);
    const std::string text = folder.read("ncsim.toml");
    EXPECT_TRUE(contains(text, "#files = [\"parts/*\"]")) << text;
    EXPECT_FALSE(contains(text, "notes")) << text;
    EXPECT_EQ(folder.run({"tools", "parts/a.nc"}).exit_code, 0);
}

}  // namespace
}  // namespace ncsim::cli_test
