// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small programs that crash a machine in realistic ways, and programs that are safe: each has the
// verdict that a machinist would give, and is listed in docs/verification.md.
#include "cli/run_program.h"
#include "cli/verdict_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kSource = NCSIM_SOURCE_DIR;
const fs::path kVerdicts = kSource / "tests" / "verdicts";

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

const json& table() {
    return verdict_rows();
}

json check(const json& row, int& exit_code) {
    const Folder folder;
    for (const auto& file : fs::directory_iterator(kVerdicts))
        fs::copy(file.path(), folder.path());
    std::vector<std::string> arguments{"check", row["program"], "-q", "--json", "verdict.json"};
    for (const json& option : row["options"])
        arguments.push_back(option);
    const Ran ran = folder.run(arguments);
    exit_code = ran.exit_code;
    const json programs = json::parse(folder.read("verdict.json"))["programs"];
    // For a file with several programs, returns the program of the row.
    for (const json& program : programs) {
        if (program["verdict"] == row["verdict"]) return program;
    }
    return programs[0];
}

// Returns rules with errors and reasons for doubt.
std::set<std::string> found(const json& program) {
    std::set<std::string> ids;
    for (const json& f : program["findings"]) {
        if (f["severity"] == "error" && !f["suppressed"]) ids.insert(f["rule"]);
    }
    for (const json& d : program["doubts"]) {
        if (!d["accepted"]) ids.insert(d["reason"]);
    }
    return ids;
}

class Verdicts : public testing::TestWithParam<std::size_t> {};

TEST_P(Verdicts, IsThatOfAMachinist) {
    const json& row = table()[GetParam()];
    SCOPED_TRACE(row["program"].get<std::string>() + ": " + row["situation"].get<std::string>());
    int exit_code = -1;
    const json program = check(row, exit_code);
    EXPECT_EQ(program["verdict"], row["verdict"]) << program.dump(1);
    const std::map<std::string, int> codes{
        {"clean", 0}, {"accepted", 0}, {"failed", 1}, {"not-proven", 4}};
    EXPECT_EQ(exit_code, codes.at(row["verdict"]));
    const std::set<std::string> ids = found(program);
    for (const json& wanted : row["finds"])
        EXPECT_TRUE(ids.contains(wanted)) << wanted << '\n' << program.dump(1);
    if (row["verdict"] == "clean" || row["verdict"] == "accepted") {
        EXPECT_TRUE(ids.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Programs, Verdicts, testing::Range(std::size_t{0}, table().size()),
                         name_of_row);

TEST(VerdictTable, HasEveryProgram) {
    std::set<std::string> named;
    std::map<std::string, int> count;
    std::set<std::string> situations;
    for (const json& row : table()) {
        named.insert(row["program"]);
        EXPECT_TRUE(situations.insert(row["program"].dump() + row["options"].dump()).second)
            << row.dump();
        ++count[row["verdict"] == "clean" ? "clean" : "not clean"];
    }
    std::set<std::string> files;
    for (const auto& file : fs::directory_iterator(kVerdicts)) {
        const fs::path kind = file.path().extension();
        if (kind == ".nc" || kind == ".mpf" || kind == ".h") files.insert(file.path().filename());
    }
    EXPECT_EQ(named, files);
    EXPECT_GE(count["not clean"], 40);
    EXPECT_GE(count["clean"], 20);
}

TEST(VerdictTable, IsInTheDocumentation) {
    const std::string page = text_of(kSource / "docs" / "verification.md");
    for (const json& row : table()) {
        std::string verdict = row["verdict"] == "failed"       ? "failed: "
                              : row["verdict"] == "not-proven" ? "not proven: "
                                                               : row["verdict"];
        const char* comma = "";
        for (const json& id : row["finds"]) {
            verdict.append(comma).append("`").append(id).append("`");
            comma = ", ";
        }
        std::ostringstream line;
        line << "| " << row["situation"].get<std::string>() << " | " << verdict << " | "
             << row["told"].get<std::string>() << " | ";
        EXPECT_NE(page.find(line.str()), std::string::npos) << line.str();
    }
    Folder folder;
    const Ran ran = folder.run({"rules", "--json"});
    for (const json& reason : json::parse(ran.out)["reasons"])
        EXPECT_NE(page.find("| `" + reason["id"].get<std::string>() + "` | "), std::string::npos)
            << reason["id"];
}

}  // namespace
}  // namespace ncsim::cli_test
