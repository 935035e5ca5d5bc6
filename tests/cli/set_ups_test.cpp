// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generated programs with complete set-ups, half of them with an inserted fault: ncsim check must
// report each fault and no further findings. NCSIM_SET_UPS=COUNT[,FIRST] runs different programs
// than the default.
#include "support/set_ups.h"

#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;
using test::Judged;

constexpr std::uint64_t kPairs = 200;
constexpr std::uint64_t kGroups = 10;

// Returns the error in the verdict; empty if the verdict is correct.
std::string complaint(const Judged& judged, const Ran& ran, const json& program) {
    const std::map<std::string, int> codes{{"clean", 0}, {"failed", 1}, {"not-proven", 4}};
    // The construction specifies no lengths, and the travels leave no room for lengths.
    const bool is_clean = program["verdict"] == "accepted" && judged.verdict == "clean";
    if (program["verdict"] != judged.verdict && !is_clean)
        return "it is " + judged.verdict + ", not " + program["verdict"].get<std::string>();
    if (ran.exit_code != codes.at(judged.verdict))
        return "exit code " + std::to_string(ran.exit_code);
    std::set<std::string> ids;
    bool is_there = judged.line == 0;
    for (const json& f : program["findings"]) {
        if (f["severity"] == "note") continue;
        if (f["severity"] == "warning" && judged.verdict != "clean") continue;
        ids.insert(f["rule"]);
        if (f["rule"] == judged.tells && f.value("line", 0U) == judged.line) is_there = true;
    }
    for (const json& d : program["doubts"]) {
        if (d["accepted"]) continue;
        ids.insert(d["reason"]);
        if (d["reason"] == judged.tells && d.value("line", 0U) == judged.line) is_there = true;
    }
    if (!judged.tells.empty() && !ids.contains(judged.tells)) return "missing: " + judged.tells;
    if (!is_there) return judged.tells + " is missing at line " + std::to_string(judged.line);
    for (const std::string& id : ids) {
        if (id != judged.tells && !judged.may_tell.contains(id)) return "invented: " + id;
    }
    return {};
}

void expect_verdict(const Judged& judged, std::uint64_t seed) {
    const Folder folder;
    folder.write("part.nc", judged.text);
    folder.write("mill.toml", judged.machine);
    std::vector<std::string> arguments{
        "check",     "part.nc", "--machine", "mill.toml",     "-q",      "--json", "verdict.json",
        "--threads", "1",       "--accept",  "length-offset", "--rapid", "linear"};
    arguments.insert(arguments.end(), judged.options.begin(), judged.options.end());
    const Ran ran = folder.run(arguments);
    ASSERT_TRUE(folder.has("verdict.json")) << "seed " << seed << '\n' << ran.err << judged.machine;
    const json report = json::parse(folder.read("verdict.json"));
    const std::string wrong = complaint(judged, ran, report["programs"][0]);
    if (wrong.empty()) return;
    std::string command = "ncsim";
    for (const std::string& word : arguments)
        command += ' ' + word;
    ADD_FAILURE() << "seed " << seed << ", " << (judged.fault.empty() ? "no fault" : judged.fault)
                  << ": " << wrong << '\n'
                  << ran.out << ran.err << command << "\n--- part.nc\n"
                  << judged.text << "--- mill.toml\n"
                  << judged.machine;
}

// Returns for each program the fault that is the least frequent so far, so all faults are as
// frequent as possible.
const std::vector<std::string>& usual_faults() {
    static const std::vector<std::string> chosen = [] {
        std::vector<std::string> faults;
        std::map<std::string, int> count;
        for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
            const std::set<std::string> possible = test::faults_of(seed);
            faults.push_back(*std::ranges::min_element(
                possible, {}, [&count](const std::string& name) { return count[name]; }));
            ++count[faults.back()];
        }
        return faults;
    }();
    return chosen;
}

void expect_verdicts(std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        expect_verdict(test::right_set_up(seed), seed);
        const std::string name = seed < kPairs ? usual_faults()[seed] : std::string();
        expect_verdict(test::wrong_set_up(seed, name), seed);
    }
}

class SetUps : public testing::TestWithParam<std::uint64_t> {};

TEST_P(SetUps, AreJudgedAsTheyWereMade) {
    constexpr std::uint64_t kEach = kPairs / kGroups;
    expect_verdicts(GetParam() * kEach, kEach);
}

INSTANTIATE_TEST_SUITE_P(Programs, SetUps, testing::Range(std::uint64_t{0}, kGroups));

TEST(SetUpsAsked, AreJudgedAsTheyWereMade) {
    const char* const asked = std::getenv("NCSIM_SET_UPS");
    if (!asked) return;
    char* rest = nullptr;
    const std::uint64_t count = std::strtoull(asked, &rest, 10);
    const std::uint64_t first = *rest == ',' ? std::strtoull(rest + 1, nullptr, 10) : 0;
    expect_verdicts(first, count);
}

TEST(SetUpsOfTheTest, HaveAllKindsOfFaults) {
    std::set<std::string> put_in, possible;
    for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
        put_in.insert(usual_faults()[seed]);
        possible.merge(test::faults_of(seed));
    }
    for (const std::string& name : possible)
        EXPECT_TRUE(put_in.contains(name)) << name;
    EXPECT_GE(put_in.size(), 35U);
}

}  // namespace
}  // namespace ncsim::cli_test
