// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as text.
#include "ncsim/report/check_text.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/design_facts.h"
#include "ncsim/verify/rule.h"

#include "append.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::report {

namespace {

using verify::Finding;
using verify::Severity;

// Appends the line, cut to the width of a terminal, with a marker below the span. The quote mark at
// the start distinguishes the line from text of ncsim.
void put_excerpt(std::string& text, const std::string& line, gcode::SourceSpan span) {
    constexpr std::size_t kWidth = 100;
    if (line.empty()) return;
    std::size_t column = std::min<std::size_t>(std::max(span.column, 1U) - 1, line.size());
    const std::size_t first = column > kWidth * 3 / 4 ? column - kWidth / 2 : 0;
    const std::string shown = one_line(std::string_view(line).substr(first, kWidth));
    column -= first;
    const std::size_t room = shown.size() > column ? shown.size() - column : 1;
    text.append(gcode::kQuoteMark).append(shown).append(1, '\n');
    text.append(gcode::kQuoteMark).append(column, ' ').append(1, '^');
    text.append(std::clamp<std::size_t>(span.length, 1, room) - 1, '~').append(1, '\n');
}

// Rounds to a tenth of a micrometre, without -0.
Vec3 rounded(const Vec3& v) {
    const auto round = [](double x) { return std::round(1e4 * x) / 1e4 + 0.0; };
    return {round(v.x), round(v.y), round(v.z)};
}

// Appends the first point and the box, whose height is the depth.
void put_place(std::string& text, const Finding& f, LengthUnit unit) {
    if (!f.point) return;
    const Vec3 at = rounded(*f.point);
    text += in_unit(fmt::format("  at X{:.6g} Y{:.6g} Z{:.6g}", at.x, at.y, at.z), unit);
    if (!f.box.is_empty()) {
        Box box;
        box.add(rounded(f.box.min));
        box.add(rounded(f.box.max));
        append(text, ", within {}", in_unit(describe(box), unit));
    }
    text += '\n';
}

void put_finding(std::string& text, const Checked& checked, const Finding& f,
                 const std::string& line, LengthUnit unit) {
    // The path is shown as specified, so a click in a terminal finds the file.
    text += printable_path(f.place.file == 0 ? checked.path : file_of(checked, f.place));
    if (f.place.span.line > 0) {
        append(text, ":{}:{}", f.place.span.line, f.place.span.column);
    }
    append(text, ": {}: {}", verify::name_of(f.severity), one_line(in_unit(headline(f), unit)));
    append(text, " [{}{}{}]\n", f.rule, f.code.empty() ? "" : ":", f.code);
    put_excerpt(text, line, f.place.span);
    put_place(text, f, unit);
    if (f.count > 1 && f.last_motion > 0 && f.rule != "air-cut") {
        if (f.goes_on) {
            append(text, "  in {} motions up to line {}, and there may be more\n", f.count,
                   f.last.span.line);
        } else if (f.last.span.line == f.place.span.line) {
            append(text, "  in {} motions of this line\n", f.count);
        } else {
            append(text, "  in {} motions, the last one at line {}\n", f.count, f.last.span.line);
        }
    } else if (f.count > 1 && f.last_motion == 0) {
        append(text, "  {} times, first here\n", f.count);
    }
    for (const std::string& assumption : f.assumptions)
        append(text, "  assumed {}\n", one_line(in_unit(assumption, unit)));
    if (f.last_motion > 0) append(text, "  hint: {}\n", in_unit(f.hint, unit));
}

void put_doubt(std::string& text, const Checked& checked, const verify::Doubt& d, LengthUnit unit) {
    text += printable_path(d.place.file == 0 ? checked.path : file_of(checked, d.place));
    if (d.place.span.line > 0) append(text, ":{}:{}", d.place.span.line, d.place.span.column);
    append(text, ": {}: {}", d.accepted ? "accepted doubt" : "doubt",
           one_line(in_unit(d.message, unit)));
    if (d.count > 1) append(text, ", {} times", d.count);
    append(text, " [{}]\n", d.reason);
}

constexpr std::string_view kSkipped = "  skipped";
// Start of the reason of a deselected rule.
constexpr std::string_view kDeselectedBy = "deselected by ";

// Appends the rules that could not be checked, in a line for each reason.
void put_skipped(std::string& text, const std::vector<verify::Skipped>& skipped) {
    std::vector<std::string_view> specified;
    for (const verify::Skipped& s : skipped) {
        if (std::ranges::find(specified, s.reason) != specified.end()) continue;
        specified.push_back(s.reason);
        std::string rules;
        for (const verify::Skipped& same : skipped) {
            if (same.reason == s.reason) rules += (rules.empty() ? "" : ", ") + same.rule;
        }
        append(text, "{}  {}: {}\n", kSkipped, rules, one_line(s.reason));
    }
}

// Appends the rules whose severity the user lowered.
void put_demotions(std::string& text, const std::vector<verify::Demotion>& demotions) {
    for (const verify::Demotion& d : demotions)
        append(text, "{}  {}\n", kSkipped, one_line(demotion_text(d)));
}

void put_settings(std::string& text, const std::string& file) {
    if (!file.empty()) append(text, "  settings {}\n", file);
}

void put_baseline(std::string& text, const std::string& file) {
    if (!file.empty()) append(text, "  baseline {}\n", file);
}

std::string name_of_verdict(const Checked& checked) {
    std::string name(checked.word);
    std::ranges::replace(name, '-', ' ');
    return name;
}

// Largest number of programs of one verdict that the summary names.
constexpr std::uint64_t kMostListed = 20;

std::string counted(std::uint64_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

// Lines from the programs, without repetition, in the order of their first occurrence.
class Lines {
public:
    void add(const std::string& lines) {
        for (std::size_t at = 0; at < lines.size();) {
            const std::size_t end = lines.find('\n', at);
            std::string line = lines.substr(at, end - at);
            const auto [place, is_new] = places_.try_emplace(line, lines_.size());
            if (is_new) lines_.emplace_back(std::move(line), 0);
            ++lines_[place->second].second;
            at = end + 1;
        }
    }
    /// Returns the lines; a line of fewer than `programs` programs gets their number.
    std::string text(std::uint64_t programs = 0) const {
        std::string text;
        for (const auto& [line, count] : lines_) {
            text += line;
            if (count < programs) text += fmt::format(" ({})", counted(count, "program"));
            text += '\n';
        }
        return text;
    }
    const std::vector<std::pair<std::string, std::uint64_t>>& all() const { return lines_; }

private:
    std::vector<std::pair<std::string, std::uint64_t>> lines_;
    std::map<std::string, std::size_t> places_;
};

// Appends the remedies, a line for each reason, and the option that accepts all reasons.
void put_remedies(std::string& text, const std::string& remedies) {
    std::string ids;
    for (std::size_t at = 0; at < remedies.size();) {
        const std::size_t end = remedies.find('\n', at);
        const std::string line = remedies.substr(at, end - at);
        append(text, "  {:<8} {}\n", ids.empty() ? "fix" : "", line);
        ids += (ids.empty() ? "" : ",") + line.substr(0, line.find(':'));
        at = end + 1;
    }
    if (!ids.empty()) append(text, "  or       --accept {}\n", ids);
}

// Returns the rules that some program could not be checked, in one line.
std::string rules_of(const Lines& skipped) {
    std::string rules;
    std::set<std::string_view> specified;
    for (const auto& [line, count] : skipped.all()) {
        std::string_view rest = line;
        rest.remove_prefix(std::min(rest.find_first_not_of(' ', kSkipped.size()), rest.size()));
        rest = rest.substr(0, rest.find(':'));
        while (!rest.empty()) {
            const std::size_t comma = std::min(rest.find(", "), rest.size());
            if (specified.insert(rest.substr(0, comma)).second)
                rules.append(rules.empty() ? "" : ", ").append(rest.substr(0, comma));
            rest.remove_prefix(std::min(comma + 2, rest.size()));
        }
    }
    if (rules.empty()) return {};
    return fmt::format("  skipped  {}; why: --notes\n", rules);
}

}  // namespace

std::vector<std::size_t> listed_findings(const verify::Verdict& verdict, bool notes) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < verdict.findings.size(); ++i) {
        const Finding& f = verdict.findings[i];
        if (f.counts() && (notes || f.severity != Severity::Note)) places.push_back(i);
    }
    return places;
}

std::string text_of(const Checked& checked, const TextOptions& options) {
    std::string text;
    const std::string path = printable_path(name_of(checked));
    if (!checked.failure.empty()) {
        append(text, "{}: not verified: {}\n", path, one_line(checked.failure));
        return text;
    }
    const verify::Verdict& v = checked.verdict;
    for (const std::size_t i : listed_findings(v, options.notes))
        put_finding(text, checked, v.findings[i], checked.lines[i], options.unit);
    for (const auto& [rule, more] : v.unlisted) {
        append(text, "{}: {} more findings of {} are not listed\n", path, more, rule);
    }
    for (const verify::Doubt& d : v.doubts) {
        if (!d.accepted || options.notes) put_doubt(text, checked, d, options.unit);
    }
    if (options.quiet) return text;
    for (const simulation::ResolvedFinding& known : checked.resolved) {
        append(text, "{}: no longer there, but in the baseline: {}: {} [{}]\n", path,
               known.severity, one_line(known.what), known.rule);
    }
    if (options.many) return text;
    const std::string scope = scope_of(checked);
    append(text, "{}: {}{}: {}\n", path, name_of_verdict(checked),
           scope.empty() ? "" : fmt::format(" ({})", scope), counts_of(checked));
    put_remedies(text, remedies_of(checked));
    put_settings(text, printable_path(checked.settings));
    put_baseline(text, printable_path(checked.baseline));
    if (!checked.stock.empty())
        append(text, "  stock    {}\n", one_line(in_unit(checked.stock, options.unit)));
    if (!checked.time.empty()) append(text, "  time     {}\n", in_unit(checked.time, options.unit));
    if (checked.design)
        append(text, "  design   {}\n", one_line(in_unit(text_of(*checked.design), options.unit)));
    return text;
}

std::string counts_of(const Checked& checked) {
    if (!checked.failure.empty()) return {};
    const verify::Verdict& v = checked.verdict;
    std::string text =
        fmt::format("{}, {}, {}, {}", counted(v.count(Severity::Error), "error"),
                    counted(v.count(Severity::Warning), "warning"),
                    counted(v.count(Severity::Note), "note"), counted(v.open_doubts(), "doubt"));
    const std::size_t accepted = v.doubts.size() - v.open_doubts();
    if (accepted > 0) text += fmt::format(", {} accepted", accepted);
    if (v.suppressed() > 0) text += fmt::format(", {} suppressed", v.suppressed());
    if (v.accepted() > 0) text += fmt::format(", {} in the baseline", v.accepted());
    return text;
}

std::string remedies_of(const Checked& checked) {
    std::string text;
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        const auto is_open = [&](const verify::Doubt& d) {
            return d.reason == reason.id && !d.accepted;
        };
        if (std::ranges::any_of(checked.verdict.doubts, is_open))
            text += fmt::format("{}: {}\n", reason.id, reason.fix);
    }
    return text;
}

std::string demotion_text(const verify::Demotion& demotion) {
    return fmt::format("{}: severity {} by {}", demotion.rule, verify::name_of(demotion.severity),
                       demotion.by);
}

std::string scope_of(const Checked& checked) {
    if (!checked.failure.empty()) return {};
    const verify::Verdict& v = checked.verdict;
    std::string text;
    const auto add = [&text](const std::string& what) {
        text += (text.empty() ? "" : "; ") + what;
    };
    const std::size_t known = verify::rules().size();
    if (const auto deselected = v.deselected(); deselected > 0) {
        std::set<std::string> by;
        for (const verify::Skipped& s : v.skipped) {
            if (s.deselected) by.insert(s.reason.substr(kDeselectedBy.size()));
        }
        add(fmt::format("{} of {} rules by {}", known - deselected, known, fmt::join(by, ", ")));
    }
    if (!v.demotions.empty()) {
        std::set<std::string> by;
        for (const verify::Demotion& d : v.demotions)
            by.insert(d.by);
        add(fmt::format("{} demoted by {}", counted(v.demotions.size(), "rule"),
                        fmt::join(by, ", ")));
    }
    std::string reasons;
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        const auto is_accepted = [&](const verify::Doubt& d) {
            return d.accepted && d.reason == reason.id;
        };
        if (std::ranges::any_of(v.doubts, is_accepted))
            reasons += (reasons.empty() ? "" : ", ") + std::string(reason.id);
    }
    if (!reasons.empty()) add("accepted " + reasons);
    const auto suppressed = std::ranges::count_if(
        v.findings, [](const Finding& f) { return f.suppressed && f.severity == Severity::Error; });
    if (suppressed > 0)
        add(counted(static_cast<std::uint64_t>(suppressed), "error") + " suppressed");
    return text;
}

std::string skipped_rules_text(const Checked& checked) {
    std::string text;
    put_demotions(text, checked.verdict.demotions);
    put_skipped(text, checked.verdict.skipped);
    return text;
}

std::string summary_of(const Entries& all, const TextOptions& options, const Scope& scope) {
    std::string text;
    if (options.quiet) return text;
    std::uint64_t programs = 0;
    std::map<std::string, std::uint64_t> words;
    std::map<std::string, std::string> listed;
    Lines settings;
    Lines skipped;
    Lines remedy_text;
    Lines scopes;
    all([&](const Entry& entry) {
        ++programs;
        std::string specified;
        put_settings(specified, printable_path(entry.settings));
        put_baseline(specified, printable_path(entry.baseline));
        settings.add(specified);
        skipped.add(entry.skipped);
        remedy_text.add(entry.remedy_text);
        if (!entry.scope.empty()) scopes.add("  scope    " + entry.scope + '\n');
        if (++words[entry.word] > kMostListed || entry.word == "clean") return;
        const std::string program = entry.program.empty() ? "" : " (" + entry.program + ')';
        listed[entry.word] += "  " + printable_path(entry.path) + one_line(program);
        if (!entry.scope.empty()) listed[entry.word] += " (" + entry.scope + ")";
        if (!entry.counts.empty()) listed[entry.word] += ": " + entry.counts;
        listed[entry.word] += '\n';
    });
    if (!options.many) return skipped.text();
    text += settings.text(programs);
    text += scopes.text(programs);
    put_remedies(text, remedy_text.text(programs));
    if (options.notes) {
        text += skipped.text(programs);
    } else {
        text += rules_of(skipped);
    }
    for (const auto& [word, title] :
         {std::pair{"not-verified", "not verified"}, std::pair{"not-proven", "not proven"},
          std::pair{"accepted", "accepted"}, std::pair{"failed", "failed"}}) {
        const std::uint64_t n = words[word];
        if (n == 0) continue;
        append(text, "{}:\n{}", title, listed[word]);
        if (n > kMostListed) append(text, "  and {} more\n", n - kMostListed);
    }
    append(text, "{}: {} clean, ", counted(programs, "program"), words["clean"]);
    if (words["accepted"] > 0) append(text, "{} accepted, ", words["accepted"]);
    append(text, "{} not proven, {} failed, {} not verified{}\n", words["not-proven"],
           words["failed"], words["not-verified"], counts_of(scope));
    if (!scope.job.empty()) {
        std::string word = worst_verdict(all);
        std::ranges::replace(word, '-', ' ');
        append(text, "{}: {}\n", printable_path(scope.job), word);
    }
    return text;
}

}  // namespace ncsim::report
