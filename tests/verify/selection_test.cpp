// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selection of rules, and comments that accept findings. Each rule has a program that violates the
// rule at a known line by a known amount, a program that just keeps the rule, and a program for
// which the rule cannot be checked.
#include "ncsim/verify/rule.h"

#include "verify/expected.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::verify_test {
namespace {

using verify::Severity;

TEST(Selection, LeavesRulesOutAndChangesTheirWeight) {
    verify::Setup setup = plain_setup();
    setup.selection.ignored = {{"rapid-in-material", "--ignore"}};
    setup.selection.severities["no-feed"] = {Severity::Note, "shop.toml:2:1"};
    const auto verdict =
        verdict_of("G21 G90 T1 M6 S1000 M3 G0 X-30 Y0 Z-2\nG0 X30\nG1 X0\n", setup);
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
    EXPECT_EQ(only(verdict, "no-feed").severity, Severity::Note);
    EXPECT_TRUE(only(verdict, "no-feed").demoted);
    ASSERT_EQ(verdict.deselected(), 1U);
    const auto deselected = std::ranges::find_if(verdict.skipped, &verify::Skipped::deselected);
    EXPECT_EQ(deselected->rule, "rapid-in-material");
    EXPECT_EQ(deselected->reason, "deselected by --ignore");
    EXPECT_EQ(verdict.demotions,
              (std::vector<verify::Demotion>{{"no-feed", Severity::Note, "shop.toml:2:1"}}));
}

TEST(Selection, ErrorsThatAreDemotedOrSuppressedAreAcceptedAndNeverClean) {
    verify::Setup setup = plain_setup();
    setup.selection.severities["rapid-in-material"] = {Severity::Note, "--severity"};
    EXPECT_TRUE(verdict_of(kStart + "G0 Z-2\nG0 X30\n", setup).is_accepted());
    EXPECT_TRUE(
        verdict_of(kStart + "G0 Z-2\nG0 X30 (ncsim: ignore rapid-in-material)\n").is_accepted());
    verify::Verdict verdict;
    verdict.findings.emplace_back().demoted = true;
    verdict.findings.front().severity = Severity::Note;
    EXPECT_EQ(verdict.outcome(), verify::Outcome::Accepted);
}

TEST(Suppression, IsForTheNextBlockOnly) {
    const auto verdict = verdict_of(kStart +
                                    "G0 Z-2\n(ncsim: ignore rapid-in-material)\n\nG0 X0\n"
                                    "G0 X30\n");
    const auto found = findings_of(verdict, "rapid-in-material");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(found[0].suppressed);
    EXPECT_EQ(found[0].place.span.line, 5U);
    EXPECT_FALSE(found[1].suppressed);
    EXPECT_EQ(verdict.count(Severity::Error), 1U);
    EXPECT_EQ(verdict.suppressed(), 1U);
}

TEST(Suppression, MayStandInTheBlockAndNameACategory) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG0 X30 (ncsim: ignore collision, travel)\n");
    EXPECT_TRUE(only(verdict, "rapid-in-material").suppressed);
}

TEST(Suppression, IsReadWithAnyBlanksAndCase) {
    for (const char* comment :
         {"(ncsim:ignore rapid-in-material)", "(NCSIM :  IGNORE rapid-in-material)",
          "( ncsim: ignore,rapid-in-material)", "; ncsim\t:ignore\trapid-in-material"}) {
        SCOPED_TRACE(comment);
        const auto verdict = verdict_of(kStart + comment + "\nG0 Z-2\nG0 X30\n");
        EXPECT_TRUE(findings_of(verdict, "suppression").empty());
        const verify::Suppressions read({"", std::string("G1 X1 ") + comment + "\n"});
        EXPECT_TRUE(read.covers(1, "rapid-in-material"));
    }
}

TEST(Suppression, ThatCannotBeUnderstoodIsTold) {
    for (const char* comment :
         {"(ncsim: ignores rapid-in-material)", "(ncsim ignore rapid-in-material)",
          "(ncsim: ignore)", "(ncsim:)", "(ncsim-ignore: rapid-in-material)", "(NCSIM, ignoring x)",
          "(ncsim: ingore rapid-in-material)", "(ncsim: ignore: rapid-in-material)"}) {
        SCOPED_TRACE(comment);
        const auto verdict = verdict_of(kStart + comment + "\nG0 Z-2\nG0 X30\n");
        EXPECT_EQ(only(verdict, "suppression").place.span.line, 2U);
        EXPECT_EQ(only(verdict, "suppression").message,
                  "this comment suppresses nothing: it has to read (ncsim: ignore RULE)");
        EXPECT_FALSE(only(verdict, "rapid-in-material").suppressed);
    }
}

TEST(Suppression, IsNotLookedForInWhatPeopleSayOfUs) {
    for (const char* comment : {"(ncsim found this)", "(ncsimulator: ignore all)", "(see ncsim: x)",
                                "(NCSIM 0.1)", "(ncsim)"}) {
        SCOPED_TRACE(comment);
        const auto verdict = verdict_of(kStart + comment + "\nG0 Z-2\nG0 X30\n");
        EXPECT_TRUE(findings_of(verdict, "suppression").empty());
    }
}

TEST(Suppression, OfAnUnknownRuleIsTold) {
    const auto verdict = verdict_of(kStart + "(ncsim: ignore rapids)\nG0 Z-2\nG0 X30\n");
    EXPECT_EQ(only(verdict, "suppression").place.span.line, 2U);
    EXPECT_FALSE(only(verdict, "rapid-in-material").suppressed);
}

TEST(Rules, HaveStableNamesAReasonAndARemedy) {
    for (const verify::RuleInfo& rule : verify::rules()) {
        EXPECT_EQ(verify::find_rule(rule.id), verify::find_rule(std::string(rule.id)));
        EXPECT_FALSE(rule.why.empty());
        EXPECT_FALSE(rule.fix.empty());
        for (const char c : rule.id)
            EXPECT_TRUE((c >= 'a' && c <= 'z') || c == '-') << rule.id;
    }
    EXPECT_EQ(verify::rules_named("travel").size(), 7U);
    EXPECT_TRUE(verify::rules_named("no-such-rule").empty());
}

}  // namespace
}  // namespace ncsim::verify_test
