// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small modules without a part: reasons for doubt, the balance of a ledger, the lines of
// suppressions, feed moves in air, and rules that need the part.
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/ledger.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/rule_info.h"
#include "ncsim/verify/setup.h"
#include "ncsim/verify/suppression.h"

#include "air_cut.h"
#include "finding_log.h"
#include "move.h"
#include "verify/verified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify_test {
namespace {

using verify::Suppressions;

// --- Reasons for doubt ---

TEST(Reasons, HaveUniqueIdsInKebabCaseAndTexts) {
    std::set<std::string_view> ids;
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        SCOPED_TRACE(reason.id);
        EXPECT_TRUE(ids.insert(reason.id).second);
        EXPECT_TRUE(std::ranges::all_of(reason.id,
                                        [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; }));
        EXPECT_EQ(verify::find_reason(reason.id), &reason);
        EXPECT_TRUE(reason.why.ends_with('.'));
        EXPECT_EQ(std::ranges::count(reason.why, '.'), 1) << "one sentence";
        EXPECT_FALSE(reason.fix.empty() || reason.fix.ends_with('.'));
    }
    EXPECT_EQ(verify::reasons().data(), verify::reasons().data());
}

TEST(Reasons, OfUnknownIdsAreNull) {
    for (const char* id : {"", "stock", "stock-guess ", "Stock-guess", "all"})
        EXPECT_EQ(verify::find_reason(id), nullptr) << id;
}

// --- Ledger ---

TEST(Ledger, ImbalanceIsAShareOfTheStock) {
    struct Row {
        double stock, removed, rest, imbalance;
    };
    for (const Row& row : {Row{100, 40, 60, 0.0}, Row{100, 40, 61, 0.01}, Row{100, 40, 59, 0.01},
                           Row{100, 0, 100, 0.0}, Row{100, 100, 0, 0.0}, Row{0, 0, 0, 0.0},
                           Row{0, 1, 1, 0.0}, Row{1000, 400, 610, 0.01}}) {
        verify::Ledger ledger;
        ledger.stock_mm3 = row.stock;
        ledger.removed_mm3 = row.removed;
        ledger.rest_mm3 = row.rest;
        EXPECT_DOUBLE_EQ(ledger.imbalance(), row.imbalance) << row.stock << ' ' << row.rest;
    }
}

TEST(Ledger, RemovalRateNeedsATime) {
    verify::LedgerRow row;
    row.removed_mm3 = 5.0;
    EXPECT_FALSE(row.removal_rate());
    row.seconds = 0.0;
    EXPECT_FALSE(row.removal_rate());
    row.seconds = 30.0;
    EXPECT_EQ(row.removal_rate(), 10.0) << "per minute";
    row.removed_mm3 = 0.0;
    EXPECT_EQ(row.removal_rate(), 0.0);
}

// --- Suppressions ---

/// Returns the lines up to 9 that `rule` is suppressed in.
std::string lines_of(const Suppressions& read, std::string_view rule) {
    std::string lines;
    for (std::uint32_t line = 0; line <= 9; ++line) {
        if (read.covers(line, rule)) lines += std::to_string(line);
    }
    return lines;
}

TEST(Suppressions, ApplyToTheirBlockOrToTheNext) {
    struct Row {
        const char* text;
        std::string lines;  ///< In which no-feed is suppressed.
    };
    for (const Row& row : {
             Row{"", ""},
             Row{"G1 X1\n", ""},
             Row{"(ncsim: ignore no-feed)", ""},
             Row{"(ncsim: ignore no-feed)\n\n\n", ""},
             Row{"G1 X1 (ncsim: ignore no-feed)", "1"},
             Row{"(ncsim: ignore no-feed) G1 X1", "1"},
             Row{"(ncsim: ignore no-feed)\nG1 X1\nX2\n", "2"},
             Row{"(ncsim: ignore no-feed)\n\n(text)\n\nG1 X1\nX2\n", "5"},
             Row{"(ncsim: ignore no-feed)\n#1=2\nG1 X1\n", "2"},
             Row{"(ncsim: ignore no-feed)\r\nG1 X1\r\nX2\r\n", "2"},
             Row{"G1 X1 (ncsim: ignore no-feed)\n(ncsim: ignore no-feed)\nX2\nX3\n", "13"},
             Row{"(ncsim: ignore no-feed)\n(ncsim: ignore plunge)\nG1 X1\n", "3"},
             Row{"(ncsim: ignore plunge)\nG1 X1\n", ""},
             Row{"(ncsim: ignore plunge, no-feed)\nG1 X1\n", "2"},
             Row{"(ncsim: ignore plunge no-feed)\nG1 X1\n", "2"},
             Row{"(ncsim: ignore no-such-rule no-feed)\nG1 X1\n", "2"},
             Row{"(ncsim: ignore process)\nG1 X1\n", "2"},
             Row{"(ncsim: ignore travel)\nG1 X1\n", ""},
             Row{"(ncsim: ignore all)\nG1 X1\n", "2"},
             Row{"(ncsim: ignore no-feed)(ncsim: ignore plunge)\nG1 X1\n", "2"},
         }) {
        EXPECT_EQ(lines_of(Suppressions({"part.nc", row.text}), "no-feed"), row.lines) << row.text;
    }
    EXPECT_EQ(lines_of(Suppressions(), "no-feed"), "");
}

TEST(Suppressions, OfACategoryCoverItsRulesAlone) {
    for (const verify::RuleInfo& named : verify::rules()) {
        const std::string category(name_of(named.category));
        const Suppressions read({"part.nc", "G1 X1 (ncsim: ignore " + category + ")\n"});
        for (const verify::RuleInfo& rule : verify::rules())
            EXPECT_EQ(read.covers(1, rule.id), rule.category == named.category) << rule.id;
    }
}

TEST(Suppressions, OfUnknownRulesKeepNameAndPlace) {
    const Suppressions read(
        {"part.nc", "G1 X1 (ncsim: ignore plunge, Rapids)\n\n(ncsim: ignore)\nG1 X2\n"});
    ASSERT_EQ(read.unknown().size(), 2U);
    EXPECT_EQ(read.unknown()[0].name, "rapids");
    EXPECT_EQ(read.unknown()[0].span.line, 1U);
    EXPECT_EQ(read.unknown()[0].span.column, 7U);
    EXPECT_EQ(read.unknown()[1].name, "");
    EXPECT_EQ(read.unknown()[1].span.line, 3U);
    EXPECT_TRUE(read.covers(1, "plunge"));
    EXPECT_FALSE(read.covers(4, "plunge"));
}

TEST(Suppressions, AreReadInEachLanguage) {
    const std::string klartext =
        "0 BEGIN PGM A MM\n1 L X+1 FMAX ; ncsim: ignore no-feed\n2 ; ncsim: ignore no-feed\n"
        "3 L X+2\n4 END PGM A MM\n";
    EXPECT_EQ(lines_of(Suppressions({"a.h", klartext}), "no-feed"), "24");
    const std::string sinumerik =
        "; ncsim: ignore no-feed\nDEF REAL A\nG1 X1 ; ncsim: ignore no-feed\nM30\n";
    EXPECT_EQ(lines_of(Suppressions({"a.mpf", sinumerik}), "no-feed"), "23");
}

// --- Feed moves in air ---

/// Judges one move of 10 mm for each character of `pattern`, on lines from 1: 'a' in air, 'm' in
/// material, 'r' a rapid, 'z' without a length, 'u' not traced, 'n' not asked about contacts.
verify::AirCuts air_cuts_of(std::string_view pattern, std::vector<gcode::Motion>& motions) {
    verify::AirCuts air;
    motions.resize(pattern.size());
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        gcode::Motion& motion = motions[i];
        motion.kind = pattern[i] == 'r' ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed;
        motion.span.line = static_cast<std::uint32_t>(i + 1);
        motion.tool = 3;
        verify::Move move;
        move.motion = &motion;
        move.number = 100 + i;
        move.is_move = true;
        move.is_traced = pattern[i] != 'u';
        move.needs_contacts = pattern[i] != 'n';
        move.meets_material = pattern[i] == 'm';
        move.length_mm = pattern[i] == 'z' ? 0.0 : 10.0;
        move.path = {{static_cast<double>(i), 0, 0}, {static_cast<double>(i) + 1, 0, 0}};
        air.take(move);
    }
    return air;
}

TEST(AirCuts, AreOneFindingWithTheShareAndTheLines) {
    struct Row {
        std::string_view pattern;
        std::string message;
        double percent = 0.0;
    };
    const std::string end = " feed moves remove nothing, at lines ";
    for (const Row& row : {
             Row{"", ""},
             Row{"m", ""},
             Row{"mrmz", ""},
             Row{"una", "1 of 1" + end + "3", 100.0},
             Row{"a", "1 of 1" + end + "1", 100.0},
             Row{"ma", "1 of 2" + end + "2", 50.0},
             Row{"aaama", "4 of 5" + end + "1-3, 5", 80.0},
             Row{"arar", "2 of 2" + end + "1-3", 100.0},
             Row{"azam", "2 of 4" + end + "1, 3", 100.0 * 20 / 30},
             Row{"mamamamamamamama", "8 of 16" + end + "2, 4, 6, 8, 10, 12, 14, 16", 50.0},
             Row{"amamamamamamamamaa",
                 "10 of 18" + end + "1, 3, 5, 7, 9, 11, 13, 15 and 1 more places", 1000.0 / 18},
             Row{"amamamamamamamamaama",
                 "11 of 20" + end + "1, 3, 5, 7, 9, 11, 13, 15 and 2 more places", 55.0},
         }) {
        SCOPED_TRACE(row.pattern);
        std::vector<gcode::Motion> motions;
        const verify::AirCuts air = air_cuts_of(row.pattern, motions);
        const verify::Setup setup = plain_setup();
        verify::FindingLog log(setup);
        air.conclude(setup, log);
        verify::Verdict verdict;
        log.finish(verdict);
        ASSERT_EQ(verdict.findings.size(), row.message.empty() ? 0U : 1U);
        if (row.message.empty()) continue;
        const verify::Finding& found = verdict.findings[0];
        EXPECT_EQ(found.message, row.message);
        EXPECT_EQ(found.severity, verify::Severity::Note);
        EXPECT_NEAR(found.quantity->value, row.percent, 1e-9);
        EXPECT_EQ(found.quantity->unit, "%");
        EXPECT_EQ(found.tool, 3);
        const auto first = row.pattern.find('a'), last = row.pattern.rfind('a');
        EXPECT_EQ(found.first_motion, 100 + first);
        EXPECT_EQ(found.last_motion, 100 + last);
        EXPECT_EQ(found.place.span.line, 1 + first);
        EXPECT_EQ(found.last.span.line, 1 + last);
        EXPECT_EQ(found.count, static_cast<std::uint64_t>(std::ranges::count(row.pattern, 'a')));
        EXPECT_EQ(found.box.min.x, static_cast<double>(first));
        EXPECT_EQ(found.box.max.x, static_cast<double>(last) + 1);
        EXPECT_EQ(air.air_mm(), 10.0 * static_cast<double>(found.count));
    }
}

// --- Rules that need the part ---

TEST(NeedsPart, HoldsIfARuleAboutThePartIsSelected) {
    const auto needs = [](std::string_view only) {
        verify::Setup setup = plain_setup();
        for (const verify::RuleInfo& rule : verify::rules()) {
            if (rule.id != only) setup.selection.ignored.emplace(rule.id, "--ignore");
        }
        return needs_part(setup);
    };
    EXPECT_TRUE(needs_part(plain_setup()));
    EXPECT_FALSE(needs("")) << "no rule";
    for (const char* rule :
         {"rapid-in-material", "non-cutting-contact", "plunge", "depth-limit", "fixture-contact"})
        EXPECT_TRUE(needs(rule)) << rule;
    for (const char* rule : {"over-travel", "no-feed", "speed-limit", "suppression"})
        EXPECT_FALSE(needs(rule)) << rule;
}

}  // namespace
}  // namespace ncsim::verify_test
