// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as text, annotations, JSON, SARIF, JUnit and CSV: the same verdict gives the same counts
// in each format, and names of files and programs cannot break a format.
#include "ncsim/report/check_json.h"
#include "ncsim/report/check_text.h"
#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/report/junit.h"
#include "ncsim/report/ledger_csv.h"
#include "ncsim/report/make_entry.h"
#include "ncsim/report/sarif.h"
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"

#include "annotations.h"
#include "json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::report {
namespace {

using verify::Certainty;
using verify::Finding;
using verify::Severity;

Finding finding(std::string rule, Severity severity, std::uint32_t line, std::uint32_t last = 0) {
    Finding f;
    f.rule = std::move(rule);
    f.severity = severity;
    f.place.span = f.last.span = {line, 3, 4};
    if (last > 0) f.last.span.line = last;
    f.first_motion = f.last_motion = line;
    f.message = "message";
    f.hint = "hint";
    return f;
}

verify::Doubt doubt(std::string reason, bool accepted = false) {
    return {std::move(reason), "because", {0, {2, 1, 5}}, 1, accepted};
}

/// Errors on lines 1 and 2, of which the second is suppressed; a warning, a note, two doubts.
Checked sample() {
    Checked checked;
    checked.path = "parts/a.nc";
    checked.word = "failed";
    checked.verdict.files = {"a.nc", "sub.nc"};
    checked.verdict.findings = {finding("rapid-in-material", Severity::Error, 1, 4),
                                finding("rapid-in-material", Severity::Error, 2),
                                finding("no-feed", Severity::Warning, 3),
                                finding("air-cut", Severity::Note, 5)};
    checked.verdict.findings[1].suppressed = true;
    checked.lines = {"G0 X1", "G0 X2", "G1 X3", "G1 X5"};
    checked.verdict.doubts = {doubt("stock-guess"), doubt("tool-guess", true)};
    checked.verdict.skipped = {{"over-travel", "no machine", false},
                               {"depth-limit", "deselected by --ignore", true}};
    return checked;
}

Entries entries_of(const std::vector<Entry>& entries) {
    return [&entries](const auto& take) {
        for (const Entry& entry : entries)
            take(entry);
    };
}

Json sarif_of(const std::vector<Entry>& entries) {
    std::ostringstream out;
    write_sarif(out, entries_of(entries));
    return Json::parse(out.str());
}

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + part.size()))
        ++n;
    return n;
}

// --- Names ---

TEST(CheckedNames, OfProgramsAndCalledFiles) {
    Checked checked;
    checked.path = "parts/a.nc";
    EXPECT_EQ(name_of(checked), "parts/a.nc");
    checked.program = "O0101";
    EXPECT_EQ(name_of(checked), "parts/a.nc (O0101)");
    checked.verdict.files = {"a.nc", "sub.nc", "../lib/b.nc"};
    EXPECT_EQ(file_of(checked, {0, {}}), "parts/a.nc");
    EXPECT_EQ(file_of(checked, {1, {}}), "parts/sub.nc");
    EXPECT_EQ(file_of(checked, {2, {}}), "lib/b.nc");
    EXPECT_EQ(file_of(checked, {3, {}}), "parts/a.nc") << "no such file";
    checked.path = "a.nc";
    EXPECT_EQ(file_of(checked, {1, {}}), "sub.nc");
}

TEST(CheckedNames, HeadlineHasQuantityAndCertainty) {
    Finding f = finding("r", Severity::Error, 1);
    EXPECT_EQ(headline(f), "message");
    f.quantity = verify::Quantity{"removed", 12.5, "mm3"};
    EXPECT_EQ(headline(f), "message: removed 12.5 mm3");
    f.certainty = Certainty::Within;
    EXPECT_EQ(headline(f),
              "message: removed 12.5 mm3, not certain: within the accuracy of the tool");
}

// --- Text ---

TEST(CheckText, ListsWhatCounts) {
    const Checked checked = sample();
    EXPECT_EQ(listed_findings(checked.verdict, false), (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(listed_findings(checked.verdict, true), (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_EQ(counts_of(checked), "1 error, 1 warning, 1 note, 1 doubt, 1 accepted, 1 suppressed");
    EXPECT_EQ(counts_of(Checked{}), "0 errors, 0 warnings, 0 notes, 0 doubts");
    Checked failed = sample();
    failed.failure = "cannot be read";
    EXPECT_EQ(counts_of(failed), "");
    EXPECT_EQ(scope_of(failed), "");
    EXPECT_EQ(text_of(failed, {}), "parts/a.nc: not verified: cannot be read\n");
}

TEST(CheckText, RemediesAreThoseOfOpenReasonsOnce) {
    Checked checked = sample();
    checked.verdict.doubts.push_back(doubt("stock-guess"));
    const auto fix = [](std::string_view id) {
        return std::string(id) + ": " + std::string(verify::find_reason(id)->fix) + "\n";
    };
    EXPECT_EQ(remedies_of(checked), fix("stock-guess"));
    checked.verdict.doubts.push_back(doubt("tool-guess"));
    EXPECT_EQ(remedies_of(checked), fix("stock-guess") + fix("tool-guess")) << "accepted and open";
    EXPECT_EQ(remedies_of({}), "");
}

TEST(CheckText, ScopeNamesWhatIsSwitchedOff) {
    Checked checked = sample();
    const std::size_t all = verify::rules().size();
    const std::string rules =
        std::to_string(all - 1) + " of " + std::to_string(all) + " rules by --ignore";
    EXPECT_EQ(scope_of(checked), rules + "; accepted tool-guess; 1 error suppressed");
    checked.verdict.demotions = {{"no-feed", Severity::Note, "shop.toml:1:1"}};
    EXPECT_EQ(scope_of(checked), rules +
                                     "; 1 rule demoted by shop.toml:1:1; accepted tool-guess; 1 "
                                     "error suppressed");
    EXPECT_EQ(demotion_text(checked.verdict.demotions[0]),
              "no-feed: severity note by shop.toml:1:1");
    EXPECT_EQ(scope_of({}), "");
    EXPECT_EQ(skipped_rules_text({}), "");
    const std::string skipped = skipped_rules_text(checked);
    EXPECT_EQ(std::ranges::count(skipped, '\n'), 3) << skipped;
    for (const char* part : {"over-travel: no machine", "depth-limit: deselected by --ignore",
                             "no-feed: severity note by shop.toml:1:1"})
        EXPECT_NE(skipped.find(part), std::string::npos) << part;
}

TEST(CheckText, OptionsOnlyRemoveLines) {
    const Checked checked = sample();
    const std::string whole = text_of(checked, {.notes = true});
    for (const TextOptions& options :
         {TextOptions{}, TextOptions{.quiet = true}, TextOptions{.many = true},
          TextOptions{.notes = true, .quiet = true}, TextOptions{.notes = true, .many = true}}) {
        const std::string text = text_of(checked, options);
        EXPECT_TRUE(text.ends_with('\n'));
        EXPECT_LT(text.size(), whole.size());
        std::istringstream lines(text);
        std::size_t at = 0;
        for (std::string line; std::getline(lines, line); at += line.size()) {
            at = whole.find(line + "\n", at);
            ASSERT_NE(at, std::string::npos) << line;
        }
        EXPECT_EQ(text.find("air-cut") != std::string::npos, options.notes);
    }
    EXPECT_EQ(text_of({}, {.quiet = true}), "");
}

// The caret is below the first byte of the span, also in the last columns of a long line.
TEST(CheckText, CaretIsBelowTheSpan) {
    Checked checked;
    checked.path = "a.nc";
    checked.verdict.findings = {finding("no-feed", Severity::Error, 1)};
    for (const std::uint32_t column : {1U, 50U, 75U, 76U, 77U, 130U, 299U, 300U}) {
        std::string line(300, '-');
        line[column - 1] = 'X';
        checked.lines = {line};
        checked.verdict.findings[0].place.span = {1, column, 1};
        std::istringstream text(text_of(checked, {.quiet = true}));
        std::string head, shown, caret;
        std::getline(text, head);
        std::getline(text, shown);
        std::getline(text, caret);
        EXPECT_EQ(shown.find('X'), caret.find('^')) << column;
        EXPECT_LE(shown.size(), 110U);
    }
    // A span beyond the line is cut to it.
    checked.lines = {"G1 X1"};
    checked.verdict.findings[0].place.span = {1, 4, 99};
    EXPECT_NE(text_of(checked, {.quiet = true}).find("^~\n"), std::string::npos);
    checked.verdict.findings[0].place.span = {1, 99, 5};
    EXPECT_NE(text_of(checked, {.quiet = true}).find("^\n"), std::string::npos);
}

TEST(CheckText, SummaryCountsProgramsOfEachVerdict) {
    std::vector<Entry> entries;
    const auto add = [&](const char* word, int n) {
        for (int i = 0; i < n; ++i) {
            Entry& entry = entries.emplace_back();
            entry.path = std::string(word) + std::to_string(i) + ".nc";
            entry.word = word;
        }
    };
    add("clean", 3), add("failed", 22), add("not-proven", 1), add("not-verified", 2);
    const std::string text = summary_of(entries_of(entries), {.many = true}, {});
    EXPECT_NE(text.find("28 programs: 3 clean, 1 not proven, 22 failed, 2 not verified\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("  failed19.nc\n  and 2 more\n"), std::string::npos);
    EXPECT_EQ(text.find("failed20"), std::string::npos);
    EXPECT_EQ(text.find("clean0"), std::string::npos);
    EXPECT_EQ(summary_of(entries_of(entries), {.quiet = true, .many = true}, {}), "");
    EXPECT_EQ(summary_of(entries_of({}), {.many = false}, {}), "");
}

// --- Annotations ---

TEST(Annotations, EscapeWhatWouldEndThem) {
    Checked checked = sample();
    checked.path = "a,b:c%.nc";
    checked.verdict.findings[0].message = "first\nsecond: 50%, done";
    const std::string text = github_annotations(checked, false, LengthUnit::Millimetre);
    std::istringstream lines(text);
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line,
              "::error file=a%2Cb%3Ac%25.nc,line=1,endLine=4,title=rapid-in-material::"
              "first%0Asecond: 50%25, done%0Ahint: hint");
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_TRUE(line.starts_with("::warning file=a%2Cb%3Ac%25.nc,line=3,col=3,title=no-feed::"));
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_TRUE(line.starts_with("::warning ") && line.find("title=stock-guess") != line.npos);
    EXPECT_FALSE(std::getline(lines, line)) << "accepted and suppressed are none";
    EXPECT_NE(github_annotations(checked, true, LengthUnit::Millimetre).find("::notice "),
              std::string::npos);
    Checked failed;
    failed.path = "a.nc";
    failed.program = "O1";
    failed.failure = "no\nend";
    EXPECT_EQ(github_annotations(failed, true, LengthUnit::Millimetre),
              "::error file=a.nc::O1: not verified: no%0Aend\n");
    EXPECT_EQ(github_annotations({}, true, LengthUnit::Millimetre), "");
}

// --- JUnit ---

TEST(Junit, HasACaseForEachRuleAndOneForAllDoubts) {
    const Checked checked = sample();
    for (const bool warnings_as_errors : {false, true}) {
        std::vector<Entry> entries{
            entry_of(checked, 1, {.warnings_as_errors = warnings_as_errors})};
        entries.push_back(entries[0]);
        std::ostringstream out;
        write_junit(out, entries_of(entries));
        const std::string text = out.str();
        const std::size_t cases = 2 * (verify::rules().size() + 1);
        EXPECT_EQ(count(text, "<testcase "), cases);
        // The error, the doubt, and the warning if it counts.
        const std::size_t failures = 2 * (warnings_as_errors ? 3 : 2);
        EXPECT_EQ(count(text, "<failure "), failures);
        EXPECT_EQ(count(text, "<skipped "), 4U);
        EXPECT_NE(text.find("<testsuites name=\"ncsim check\" tests=\"" + std::to_string(cases) +
                            "\" failures=\"" + std::to_string(failures) +
                            "\" errors=\"0\" skipped=\"4\""),
                  std::string::npos);
        EXPECT_EQ(count(text, "<testsuite "), 2U);
        EXPECT_EQ(count(text, "</testsuite>"), 2U);
    }
    std::ostringstream none;
    write_junit(none, entries_of({}));
    EXPECT_NE(none.str().find("tests=\"0\" failures=\"0\" errors=\"0\" skipped=\"0\""),
              std::string::npos);
}

TEST(Junit, AcceptsAnyCharacters) {
    Checked checked = sample();
    std::string any;
    for (int c = 1; c < 256; ++c)
        any += static_cast<char>(c);
    checked.verdict.findings[0].message = any;
    Checked failed;
    failed.path = "b.nc";
    failed.failure = any;
    std::ostringstream out;
    write_junit(out, entries_of({entry_of(checked, 1, {}), entry_of(failed, 2, {})}));
    for (const char c : out.str()) {
        const auto byte = static_cast<unsigned char>(c);
        ASSERT_TRUE((byte >= 0x20 && byte < 0x7f) || byte == '\n') << static_cast<int>(byte);
    }
    EXPECT_EQ(count(out.str(), "<error "), 1U);
}

// --- SARIF ---

TEST(Sarif, ResultsNameTheirRules) {
    Checked checked = sample();
    checked.verdict.doubts.push_back(doubt("below-stock"));  // also the id of a rule
    const Json run = sarif_of({entry_of(checked, 1, {.notes = true})})["runs"][0];
    const Json& rules = run["tool"]["driver"]["rules"];
    EXPECT_EQ(rules.size(), verify::rules().size() + verify::reasons().size());
    std::set<std::pair<std::string, bool>> ids;
    const auto is_doubt = [](const Json& rule) {
        return rule["properties"]["category"] == "doubt";
    };
    for (const Json& rule : rules)
        EXPECT_TRUE(ids.emplace(rule["id"].get<std::string>(), is_doubt(rule)).second);
    EXPECT_EQ(run["results"].size(), 7U) << "suppressed and accepted ones, too";
    std::vector<std::string> levels;
    std::size_t suppressed = 0;
    for (const Json& result : run["results"]) {
        const Json& rule = rules[result["ruleIndex"].get<std::size_t>()];
        EXPECT_EQ(rule["id"], result["ruleId"]);
        const std::string message = result["message"]["text"];
        EXPECT_EQ(is_doubt(rule), message.starts_with("Not proven")) << message;
        levels.push_back(result["level"]);
        suppressed += result.contains("suppressions") ? 1 : 0;
    }
    EXPECT_EQ(levels, (std::vector<std::string>{"error", "error", "warning", "warning", "warning",
                                                "warning", "note"}));
    EXPECT_EQ(suppressed, 2U);
    EXPECT_EQ(sarif_of({entry_of(sample(), 1, {})})["runs"][0]["results"].size(), 5U);
    EXPECT_TRUE(run["invocations"][0]["executionSuccessful"]);
    const Json region = run["results"][0]["locations"][0]["physicalLocation"]["region"];
    EXPECT_EQ(region["startLine"], 1);
    EXPECT_EQ(region["startColumn"], 3);
    EXPECT_EQ(region["endLine"], 4);
    EXPECT_EQ(region["endColumn"], 7);
}

std::vector<std::string> fingerprints_of(const Checked& checked) {
    std::vector<std::string> prints;
    const Json sarif = sarif_of({entry_of(checked, 1, {.notes = true})});
    for (const Json& result : sarif["runs"][0]["results"])
        prints.push_back(result["partialFingerprints"]["ncsimFinding/v1"]);
    return prints;
}

TEST(Sarif, FingerprintsSurviveInsertions) {
    const Checked before = sample();
    const auto prints = fingerprints_of(before);
    EXPECT_EQ(std::set<std::string>(prints.begin(), prints.end()).size(), prints.size());
    Checked moved = before;
    for (Finding& f : moved.verdict.findings) {
        f.place.span.line += 100;
        f.last.span.line += 100;
        f.first_motion += 7;
    }
    moved.lines[0] = "  G0 X1\t";
    EXPECT_EQ(fingerprints_of(moved), prints);
    Checked changed = before;
    changed.lines[0] = "G0 X1.5";
    EXPECT_NE(fingerprints_of(changed)[0], prints[0]);
    EXPECT_EQ(fingerprints_of(changed)[1], prints[1]);
    Checked same = before;
    same.lines[1] = same.lines[0];
    const auto twice = fingerprints_of(same);
    EXPECT_NE(twice[0], twice[1]) << "equal lines are counted";
}

TEST(Sarif, PathsAreUris) {
    Checked checked = sample();
    checked.path = "my parts/100%#?ä.nc";
    const Json result = sarif_of({entry_of(checked, 1, {})})["runs"][0]["results"][0];
    EXPECT_EQ(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
              "my%20parts/100%25%23%3F%C3%A4.nc");
}

TEST(Sarif, TheLeastSevereResultsAreLeftOutBeyondTheLimit) {
    constexpr std::size_t kLimit = 25000;
    const auto share = [](std::size_t errors, std::size_t warnings, std::size_t notes) {
        Json json{
            {"verified", true}, {"notifications", Json::array()}, {"configuration", Json::array()}};
        json["error"] = std::vector<int>(errors, 1);
        json["warning"] = std::vector<int>(warnings, 2);
        json["note"] = std::vector<int>(notes, 3);
        Entry entry;
        entry.sarif = to_line(json);
        return entry;
    };
    for (const std::size_t more : {0, 1, 600}) {
        const Json run =
            sarif_of({share(10, 20000, 500), share(5, kLimit - 20515 + more, 0)})["runs"][0];
        const Json& results = run["results"];
        EXPECT_EQ(results.size(), kLimit);
        EXPECT_TRUE(std::ranges::is_sorted(results));
        EXPECT_EQ(std::ranges::count(results, Json(1)), 15);
        EXPECT_EQ(std::ranges::count(results, Json(3)), more < 500 ? 500 - more : 0);
        const Json& notifications = run["invocations"][0]["toolExecutionNotifications"];
        ASSERT_EQ(notifications.size(), more > 0 ? 1U : 0U);
        if (more == 0) continue;
        EXPECT_TRUE(notifications[0]["message"]["text"].get<std::string>().starts_with(
            std::to_string(more) + " results "));
    }
}

// --- JSON ---

TEST(CheckJson, CountsAreThoseOfTheText) {
    const Checked checked = sample();
    Checked failed;
    failed.path = "b.nc";
    failed.failure = "no";
    std::ostringstream out;
    write_check_json(out, entries_of({entry_of(checked, 1, {}), entry_of(failed, 2, {})}),
                     {.excluded = {}, .called = {}, .job = "shop.toml"});
    const Json json = Json::parse(out.str());
    EXPECT_EQ(json["job"], "shop.toml");
    EXPECT_EQ(json["job_verdict"], "not-verified");
    ASSERT_EQ(json["programs"].size(), 2U);
    const Json& program = json["programs"][0];
    EXPECT_EQ(program["verdict"], "failed");
    EXPECT_EQ(program["counts"],
              (Json{{"error", 1}, {"warning", 1}, {"note", 1}, {"suppressed", 1}, {"doubt", 1}}));
    EXPECT_EQ(program["findings"].size(), 4U);
    EXPECT_EQ(program["findings"][0]["last_line"], 4);
    EXPECT_EQ(program["doubts"].size(), 2U);
    EXPECT_EQ(program["rules"]["selected"], verify::rules().size() - 1);
    EXPECT_FALSE(program.contains("ledger")) << "not simulated";
    EXPECT_EQ(json["programs"][1]["failure"], "no");
}

// --- CSV ---

/// Splits a line of CSV as RFC 4180 describes it.
std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[i++];
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
        }
    }
    return fields;
}

TEST(LedgerCsv, HasTheColumnsOfItsHeaderInEachLine) {
    Checked checked = sample();
    checked.path = "a \"b\", c.nc";
    verify::LedgerRow row;
    row.line = 7;
    row.tool = 3;
    row.length_mm = 25.4;
    row.removed_mm3 = 25.4 * 25.4 * 25.4;
    row.seconds = 30.0;
    row.contact = {{0, 0, -25.4}, {25.4, 50.8, 0}};
    checked.verdict.ledger.rows = {row, {}};
    checked.operations = {{"face, \"top\"", 2, 3, 0}};
    for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Inch}) {
        const Entry entry = entry_of(checked, 0, {.csv = true, .csv_unit = unit});
        std::ostringstream out;
        write_ledger_csv(out, entries_of({entry}), unit);
        std::istringstream lines(out.str());
        std::string line;
        ASSERT_TRUE(std::getline(lines, line));
        const auto head = fields_of(line);
        EXPECT_EQ(head[7], unit == LengthUnit::Inch ? "length_in" : "length_mm");
        ASSERT_TRUE(std::getline(lines, line));
        const auto values = fields_of(line);
        ASSERT_EQ(values.size(), head.size());
        EXPECT_EQ(values[0], checked.path);
        EXPECT_EQ(values[2], "7");
        const bool inch = unit == LengthUnit::Inch;
        EXPECT_EQ(values[7], inch ? "1" : "25.4");
        EXPECT_EQ(values[8], inch ? "1" : "16387.064");
        EXPECT_EQ(values[9], "30");
        EXPECT_EQ(values[10], inch ? "2" : "32774.128");
        EXPECT_EQ(values[13], inch ? "-1" : "-25.4");
        EXPECT_EQ(values[15], inch ? "2" : "50.8");
        EXPECT_EQ(values.back(), "face, \"top\"");
        ASSERT_TRUE(std::getline(lines, line));
        const auto bare = fields_of(line);
        ASSERT_EQ(bare.size(), head.size());
        EXPECT_EQ(bare[9] + bare[10] + bare[11] + bare[16], "") << "no time and no contact";
        EXPECT_FALSE(std::getline(lines, line));
    }
    EXPECT_EQ(entry_of(checked, 0, {}).csv, "") << "not requested";
}

// --- Entries ---

TEST(Entries, CallWithoutTheRestAndThenTheRest) {
    Entry entry;
    entry.path = "a.nc";
    entry.program = "O1";
    entry.more.resize(2);
    entry.more[0].program = "O2";
    entry.more[1].program = "O3";
    std::string names;
    for_each_program(entry, [&](const Entry& one) {
        EXPECT_TRUE(one.more.empty());
        names += one.program;
    });
    EXPECT_EQ(names, "O1O2O3");
    EXPECT_EQ(entry_from(line_of(entry)), entry);
    names.clear();
    for_each_program({}, [&](const Entry&) { names += 'x'; });
    EXPECT_EQ(names, "x");
}

}  // namespace
}  // namespace ncsim::report
