// SPDX-License-Identifier: GPL-3.0-or-later
//
// A known finding does not hide a different finding: each identifying property is changed
// separately.
#include "ncsim/report/baseline.h"

#include "ncsim/report/make_entry.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {
namespace {

// Returns a program with a single finding, as `check` makes the program.
Checked checked_with(verify::Finding finding, std::string line) {
    Checked checked;
    checked.path = "part.nc";
    checked.word = "failed";
    checked.verdict.files = {"part.nc", "sub.nc"};
    checked.verdict.findings.push_back(std::move(finding));
    checked.lines.push_back(std::move(line));
    return checked;
}

verify::Finding rapid() {
    verify::Finding f;
    f.rule = "rapid-in-material";
    f.severity = verify::Severity::Error;
    f.place.span.line = f.last.span.line = 8;
    f.tool = 1;
    f.message = "rapid move through material";
    f.quantity = verify::Quantity{"removed", 800.0, "mm3"};
    f.point = Vec3{-20.0, 0.0, 9.0};
    f.box = {{-20.0, -5.0, 8.0}, {20.0, 5.0, 10.0}};
    return f;
}

// True if `now` is accepted by a baseline written for `known`.
bool is_accepted(const Checked& known, Checked now) {
    EntryOptions options;
    options.known = true;
    const Entry entry = entry_of(known, 1, options);
    std::ostringstream text;
    write_baseline(
        text, "known.json", [&](const auto& each) { each(entry); }, nullptr);
    Baseline("known.json", text.str()).accept(now, {});
    return now.verdict.findings[0].accepted.has_value();
}

bool is_accepted(const verify::Finding& known, const verify::Finding& now) {
    return is_accepted(checked_with(known, "G0 X30."), checked_with(now, "G0 X30."));
}

TEST(Baseline, KnowsAFindingByAllThatItIs) {
    using Change = std::function<void(verify::Finding&)>;
    const std::vector<std::pair<Change, bool>> changes{
        {[](auto&) {}, true},
        {[](auto& f) { f.place.span.line = 80; }, true},  // it moved
        {[](auto& f) { f.quantity->value = 799.0; }, true},
        {[](auto& f) { f.box.min.x = -19.0; }, true},
        {[](auto& f) { f.quantity->value = 800.1; }, false},
        {[](auto& f) { f.quantity->unit = "mm"; }, false},
        {[](auto& f) { f.quantity.reset(); }, false},
        {[](auto& f) { f.box.min.z = 7.9; }, false},
        {[](auto& f) { f.box.max.y = 5.1; }, false},
        {[](auto& f) { f.point->x = -20.5; }, false},
        {[](auto& f) { f.rule = "non-cutting-contact"; }, false},
        {[](auto& f) { f.code = "x"; }, false},
        {[](auto& f) { f.message = "rapid move through material that is assumed"; }, false},
        {[](auto& f) { f.severity = verify::Severity::Warning; }, false},
        {[](auto& f) { f.certainty = verify::Certainty::Within; }, false},
        {[](auto& f) { f.tool = 2; }, false},
        {[](auto& f) { f.count = 2; }, false},
        {[](auto& f) { f.goes_on = true; }, false},
        {[](auto& f) { f.row = 17; }, false},
        {[](auto& f) { f.place.file = 1; }, false},
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        verify::Finding now = rapid();
        changes[i].first(now);
        EXPECT_EQ(is_accepted(rapid(), now), changes[i].second) << i;
    }
    EXPECT_FALSE(is_accepted(checked_with(rapid(), "G0 X30."), checked_with(rapid(), "G0 X3.")));
}

// Within a finding of several motions, a new violation could hide. Therefore a row with a different
// digest is a new finding, even with fewer motions.
TEST(Baseline, KnowsARowByAllOfIt) {
    verify::Finding row = rapid();
    row.count = 3;
    row.row = 0x123456789abcdef1;
    EXPECT_TRUE(is_accepted(row, row));
    verify::Finding now = row;
    now.row = 0x123456789abcdef3;
    EXPECT_FALSE(is_accepted(row, now));
    now.count = 2;
    EXPECT_FALSE(is_accepted(row, now));
    EXPECT_FALSE(is_accepted(row, rapid()));
}

TEST(Baseline, KnowsThatNearerIsWorse) {
    verify::Finding f = rapid();
    f.rule = "machine-near-miss";
    f.severity = verify::Severity::Warning;
    f.quantity = verify::Quantity{"apart", 0.8, "mm"};
    verify::Finding now = f;
    now.quantity->value = 0.9;
    EXPECT_TRUE(is_accepted(f, now));
    now.quantity->value = 0.1;
    EXPECT_FALSE(is_accepted(f, now));
}

// The bounding box covers the whole path of the links; the point is the place of the contact.
TEST(Baseline, KnowsWhereLinksMeet) {
    verify::Finding f = rapid();
    f.rule = "machine-collision";
    verify::Finding now = f;
    EXPECT_TRUE(is_accepted(f, now));
    now.point = Vec3{0.0, 0.0, 9.0};
    EXPECT_FALSE(is_accepted(f, now));
    now.point.reset();
    EXPECT_FALSE(is_accepted(f, now));
}

// A baseline with numbers out of range is invalid.
TEST(Baseline, HasWholeNumbers) {
    for (const char* number : {"1e126", "-1", "4294967296", "1.5", "\"1\""}) {
        const std::string text =
            R"({"ncsim-baseline": 1, "findings": [{"program": "a.nc", "rule": "r", "message": "m",)"
            R"("severity": "error", "line": )" +
            std::string(number) + "}]}";
        EXPECT_THROW(Baseline("known.json", text), std::runtime_error) << number;
    }
}

}  // namespace
}  // namespace ncsim::report
