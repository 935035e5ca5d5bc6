// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/report/check_text.h"

#include "ncsim/report/plain_text.h"

#include "append.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::report {

namespace {

using verify::Finding;
using verify::Severity;

// The line, cut to what a terminal shows, with the span marked below; set off, so that nothing in
// it is taken for a line of ours.
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

void put_finding(std::string& text, const Checked& checked, const Finding& f,
                 const std::string& line) {
    // As it was given, so that a click in a terminal finds it.
    text += shown_path(f.place.file == 0 ? checked.path : file_of(checked, f.place));
    if (f.place.span.line > 0) {
        append(text, ":{}:{}", f.place.span.line, f.place.span.column);
    }
    append(text, ": {}: {}", verify::name_of(f.severity), one_line(headline(f)));
    append(text, " [{}{}{}]\n", f.rule, f.code.empty() ? "" : ":", f.code);
    put_excerpt(text, line, f.place.span);
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
        append(text, "  assumed {}\n", one_line(assumption));
    if (f.last_motion > 0) append(text, "  hint: {}\n", f.hint);
}

void put_doubt(std::string& text, const Checked& checked, const verify::Doubt& d) {
    text += shown_path(d.place.file == 0 ? checked.path : file_of(checked, d.place));
    if (d.place.span.line > 0) append(text, ":{}:{}", d.place.span.line, d.place.span.column);
    append(text, ": {}: {}", d.accepted ? "accepted doubt" : "doubt", one_line(d.message));
    if (d.count > 1) append(text, ", {} times", d.count);
    append(text, " [{}]\n", d.reason);
}

// What to tell, so that a program can be proven: a line for each reason, and how to accept them
// all.
void put_remedy(std::string& text, const std::vector<verify::Doubt>& doubts) {
    std::string ids;
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        const auto is_open = [&](const verify::Doubt& d) {
            return d.reason == reason.id && !d.accepted;
        };
        if (std::ranges::none_of(doubts, is_open)) continue;
        append(text, "  {:<8} {}: {}\n", ids.empty() ? "to tell" : "", reason.id, reason.tell);
        if (!ids.empty()) ids += ',';
        ids += reason.id;
    }
    if (!ids.empty()) append(text, "  or       --accept {}\n", ids);
}

// Rules that could not be asked for the same reason share a line.
void put_skipped(std::string& text, const std::vector<verify::Skipped>& skipped) {
    std::vector<std::string_view> told;
    for (const verify::Skipped& s : skipped) {
        if (std::ranges::find(told, s.reason) != told.end()) continue;
        told.push_back(s.reason);
        std::string rules;
        for (const verify::Skipped& same : skipped) {
            if (same.reason == s.reason) rules += (rules.empty() ? "" : ", ") + same.rule;
        }
        append(text, "  skipped  {}: {}\n", rules, one_line(s.reason));
    }
}

std::string name_of_verdict(const Checked& checked) {
    std::string name(checked.word);
    std::ranges::replace(name, '-', ' ');
    return name;
}

std::string counted(std::uint64_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

}  // namespace

std::string text_of(const Checked& checked, const TextOptions& options) {
    std::string text;
    const std::string path = shown_path(checked.path);
    if (!checked.failure.empty()) {
        append(text, "{}: not verified: {}\n", path, one_line(checked.failure));
        return text;
    }
    const verify::Verdict& v = checked.verdict;
    for (std::size_t i = 0; i < v.findings.size(); ++i) {
        const Finding& f = v.findings[i];
        if (f.suppressed || (f.severity == Severity::Note && !options.notes)) continue;
        put_finding(text, checked, f, checked.lines[i]);
    }
    for (const auto& [rule, more] : v.unlisted) {
        append(text, "{}: {} more findings of {} are not listed\n", path, more, rule);
    }
    for (const verify::Doubt& d : v.doubts) {
        if (!d.accepted || options.notes) put_doubt(text, checked, d);
    }
    if (options.quiet) return text;
    append(text, "{}: {}: {}, {}, {}, {}", path, name_of_verdict(checked),
           counted(v.count(Severity::Error), "error"),
           counted(v.count(Severity::Warning), "warning"), counted(v.count(Severity::Note), "note"),
           counted(v.open_doubts(), "doubt"));
    const std::size_t accepted = v.doubts.size() - v.open_doubts();
    if (accepted > 0) append(text, ", {} accepted", accepted);
    if (v.suppressed() > 0) append(text, ", {} suppressed", v.suppressed());
    text += '\n';
    put_remedy(text, v.doubts);
    if (!checked.stock.empty()) append(text, "  stock    {}\n", one_line(checked.stock));
    if (!checked.time.empty()) append(text, "  time     {}\n", checked.time);
    if (checked.design) append(text, "  design   {}\n", one_line(text_of(*checked.design)));
    put_skipped(text, v.skipped);
    return text;
}

std::string summary_of(std::span<const Checked> all) {
    const auto count = [all](std::string_view word) {
        return std::ranges::count(all, word, &Checked::word);
    };
    return fmt::format("{}: {} clean, {} not proven, {} failed, {} not verified\n",
                       counted(all.size(), "program"), count("clean"), count("not-proven"),
                       count("failed"), count("not-verified"));
}

}  // namespace ncsim::report
