// SPDX-License-Identifier: GPL-3.0-or-later
//
// The examples of the rules: examples/rules/RULE/fails.nc fails by the rule, passes.nc is clean.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kExamples = fs::path(NCSIM_SOURCE_DIR) / "examples/rules";

std::string text_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Returns the text as a page shows it: each line behind two blanks.
std::string indented(const std::string& text) {
    std::istringstream lines(text);
    std::string all;
    for (std::string line; std::getline(lines, line);)
        all += "  " + line + "\n";
    return all;
}

TEST(RuleExamples, FailAndPass) {
    const Folder folder;
    const Ran ran = folder.run({"check", kExamples.string(), "--json", "out.json", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    const json report = json::parse(folder.read("out.json"));
    std::set<std::string> fails, passes;
    for (const json& program : report["programs"]) {
        const fs::path file = program["file"].get<std::string>();
        const std::string rule = file.parent_path().filename().string();
        SCOPED_TRACE(rule);
        bool has_rule = false;
        for (const json& finding : program["findings"])
            has_rule |= finding["rule"] == rule;
        if (file.filename() == "fails.nc") {
            fails.insert(rule);
            EXPECT_TRUE(has_rule) << program["findings"];
        } else {
            passes.insert(rule);
            EXPECT_EQ(file.filename(), "passes.nc");
            EXPECT_FALSE(has_rule);
            EXPECT_EQ(program["verdict"], "clean") << program["doubts"];
            EXPECT_TRUE(program["findings"].empty()) << program["findings"];
        }
    }
    std::set<std::string> rules;
    const json list = json::parse(folder.run({"rules", "--json"}).out);
    for (const json& rule : list["rules"])
        rules.insert(rule["id"]);
    EXPECT_EQ(fails, rules);
    EXPECT_EQ(passes, rules);
}

TEST(RuleExamples, AreOnThePageOfTheRule) {
    const Folder folder;
    for (const auto& entry : fs::directory_iterator(kExamples)) {
        const std::string rule = entry.path().filename().string();
        SCOPED_TRACE(rule);
        const std::string page = folder.run({"rules", rule}).out;
        for (const auto& file : fs::directory_iterator(entry.path())) {
            const std::string name = file.path().filename().string();
            if (file.path().extension() == ".stl" || file.path().extension() == ".obj") {
                EXPECT_TRUE(contains(page, "Mesh: " + name + "\n")) << page;
                continue;
            }
            const std::string shown = "(" + name + "):\n\n" + indented(text_of(file.path()));
            EXPECT_TRUE(contains(page, shown)) << page;
        }
        EXPECT_LT(page.find("(fails.nc)"), page.find("(passes.nc)"));
    }
    EXPECT_FALSE(contains(folder.run({"rules", "collision"}).out, "fails.nc"));
}

}  // namespace
}  // namespace ncsim::cli_test
