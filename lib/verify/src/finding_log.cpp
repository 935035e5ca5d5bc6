// SPDX-License-Identifier: GPL-3.0-or-later
//
// Combines observations into findings, and doubts.
#include "finding_log.h"

#include "ncsim/base/mix.h"
#include "ncsim/verify/rule.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace ncsim::verify {

namespace {

// Key of a row: rule and message. No rule id contains a newline, so a prefix search finds all rows
// of a rule.
std::string row_key(std::string_view rule, std::string_view message) {
    return std::string(rule).append(1, '\n').append(message);
}

constexpr std::string_view kAtLeast = " at least";

// Hash of the observation of one motion, for Finding::row.
std::uint64_t print_of(const Occurrence& s) {
    std::uint64_t print = 1;
    const auto add = [&](double value) {
        constexpr double kPerMm = 1000.0;
        // Larger values are clamped.
        const double rounded = std::round(std::clamp(value * kPerMm, -1e15, 1e15));
        print = mix(print, static_cast<std::uint64_t>(static_cast<std::int64_t>(rounded)));
    };
    for (const Vec3& corner : {s.box.min, s.box.max}) {
        if (s.box.is_empty()) break;
        for (int axis = 0; axis < 3; ++axis)
            add(corner[axis]);
    }
    if (s.point) {
        for (int axis = 0; axis < 3; ++axis)
            add((*s.point)[axis]);
    }
    for (const char c : s.quantity ? text_of(*s.quantity) : std::string())
        print = mix(print, static_cast<std::uint8_t>(c));
    return print;
}

void merge(Finding& row, const Move& move, const Occurrence& s) {
    row.last = {move.motion->file, move.motion->span};
    row.last_motion = move.number;
    ++row.count;
    row.box.add(s.box);
    if (s.certainty == Certainty::Certain) row.certainty = Certainty::Certain;
    if (row.quantity && s.sums && !s.quantity && !row.quantity->name.ends_with(kAtLeast))
        row.quantity->name += kAtLeast;  // not all volumes were measured
    if (row.quantity && s.quantity) {
        double& value = row.quantity->value;
        value = s.sums                       ? value + s.quantity->value
                : less_is_worse(*s.quantity) ? std::min(value, s.quantity->value)
                                             : std::max(value, s.quantity->value);
    }
}

}  // namespace

FindingLog::FindingLog(const Setup& setup) : setup_(&setup) {}

void FindingLog::doubt(std::string_view reason, std::string message, const Place& place) {
    const auto [known, is_new] =
        doubt_index_.try_emplace({std::string(reason), message}, doubts_.size());
    if (!is_new) {
        ++doubts_[known->second].count;
        return;
    }
    Doubt doubt;
    doubt.reason = reason;
    doubt.message = std::move(message);
    doubt.place = place;
    doubt.accepted = setup_->accepted.contains(reason);
    doubts_.push_back(std::move(doubt));
}

bool FindingLog::settle(Finding& f, bool weakened) const {
    const RuleInfo& rule = *find_rule(f.rule);
    f.category = rule.category;
    if (f.hint.empty()) f.hint = rule.fix;
    const bool was_error = f.severity == Severity::Error;
    const auto& severities = setup_->selection.severities;
    if (const auto weight = severities.find(f.rule); weight != severities.end()) {
        f.severity = weight->second.severity;
        f.demoted = was_error && f.severity != Severity::Error;
    }
    const bool is_error = was_error || f.severity == Severity::Error;
    if (weakened && f.severity == Severity::Error) f.severity = Severity::Warning;
    f.suppressed = f.place.file == 0 && setup_->suppressions.covers(f.place.span.line, f.rule);
    return is_error;
}

void FindingLog::settle(Finding& f, std::vector<std::string_view>& rests_on) {
    std::erase_if(rests_on, [&](std::string_view r) { return setup_->accepted.contains(r); });
    const bool is_error = settle(f, !rests_on.empty());
    if (!is_error || f.suppressed) return;
    for (const std::string_view reason : rests_on)
        doubt(reason, "an error rests on it: " + f.message, f.place);
}

bool FindingLog::store(Finding finding) {
    if (stored_[finding.rule]++ >= Verdict::kMaxFindings) {
        ++unlisted_[finding.rule];
        return false;
    }
    findings_.push_back(std::move(finding));
    return true;
}

void FindingLog::add(std::string_view rule, const Move& move, Occurrence s) {
    Finding f;
    f.rule = rule;
    f.severity = find_rule(rule)->severity;
    f.certainty = s.certainty;
    f.place = f.last = {move.motion->file, move.motion->span};
    f.first_motion = f.last_motion = move.number;
    f.tool = move.motion->tool;
    if (s.is_note) f.severity = Severity::Note;
    f.message = s.message;
    settle(f, s.rests_on);

    std::string key = row_key(rule, s.message);
    if (const auto open = rows_.find(key); open != rows_.end()) {
        Finding& row = findings_[open->second.finding];
        const bool follows = s.lasts || move.number <= row.last_motion + 1;
        if (follows && row.tool == f.tool && row.place.file == f.place.file &&
            row.suppressed == f.suppressed && row.severity == f.severity) {
            merge(row, move, s);
            row.row = mix(row.row == 0 ? open->second.print : row.row, print_of(s)) | 1U;
            return;
        }
    }
    const std::uint64_t print = print_of(s);
    f.quantity = std::move(s.quantity);
    f.point = s.point;
    f.box = f.first_box = s.box;
    f.bodies = std::move(s.bodies);
    f.joints = s.joints;
    if (!s.hint.empty()) f.hint = std::move(s.hint);
    f.assumptions = std::move(s.assumptions);
    if (store(std::move(f))) rows_[std::move(key)] = {findings_.size() - 1, print};
}

void FindingLog::end_row(std::string_view rule) {
    const std::string begin = row_key(rule, "");
    auto it = rows_.lower_bound(begin);
    while (it != rows_.end() && it->first.starts_with(begin))
        it = rows_.erase(it);
}

void FindingLog::mark_incomplete(std::string_view rule) {
    const std::string begin = row_key(rule, "");
    for (auto it = rows_.lower_bound(begin); it != rows_.end() && it->first.starts_with(begin);
         ++it)
        findings_[it->second.finding].goes_on = true;
}

void FindingLog::add(Finding finding, std::vector<std::string_view> rests_on) {
    settle(finding, rests_on);
    store(std::move(finding));
}

void FindingLog::finish(Verdict& verdict) {
    std::ranges::stable_sort(findings_, {}, [](const Finding& f) {
        return std::tuple(f.place.file, f.place.span.line, f.place.span.column);
    });
    verdict.findings = std::move(findings_);
    verdict.unlisted = std::move(unlisted_);
    std::ranges::stable_sort(doubts_, {}, [](const Doubt& d) { return find_reason(d.reason); });
    verdict.doubts = std::move(doubts_);
}

}  // namespace ncsim::verify
