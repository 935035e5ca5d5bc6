// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/report/check_text.h"

#include "ncsim/report/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

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
    auto out = std::back_inserter(text);
    // As it was given, so that a click in a terminal finds it.
    text += shown_path(f.place.file == 0 ? checked.path : file_of(checked, f.place));
    if (f.place.span.line > 0) {
        fmt::format_to(out, ":{}:{}", f.place.span.line, f.place.span.column);
    }
    fmt::format_to(out, ": {}: {}", verify::name_of(f.severity), one_line(headline(f)));
    fmt::format_to(out, " [{}{}{}]\n", f.rule, f.code.empty() ? "" : ":", f.code);
    put_excerpt(text, line, f.place.span);
    if (f.count > 1 && f.last_motion > 0 && f.rule != "air-cut") {
        if (f.goes_on) {
            fmt::format_to(out, "  in {} motions up to line {}, and there may be more\n", f.count,
                           f.last.span.line);
        } else if (f.last.span.line == f.place.span.line) {
            fmt::format_to(out, "  in {} motions of this line\n", f.count);
        } else {
            fmt::format_to(out, "  in {} motions, the last one at line {}\n", f.count,
                           f.last.span.line);
        }
    } else if (f.count > 1 && f.last_motion == 0) {
        fmt::format_to(out, "  {} times, first here\n", f.count);
    }
    for (const std::string& assumption : f.assumptions)
        fmt::format_to(out, "  assumed {}\n", one_line(assumption));
    if (f.last_motion > 0) fmt::format_to(out, "  hint: {}\n", f.hint);
}

void put_doubt(std::string& text, const Checked& checked, const verify::Doubt& d) {
    auto out = std::back_inserter(text);
    text += shown_path(d.place.file == 0 ? checked.path : file_of(checked, d.place));
    if (d.place.span.line > 0)
        fmt::format_to(out, ":{}:{}", d.place.span.line, d.place.span.column);
    fmt::format_to(out, ": {}: {}", d.accepted ? "accepted doubt" : "doubt", one_line(d.message));
    if (d.count > 1) fmt::format_to(out, ", {} times", d.count);
    fmt::format_to(out, " [{}]\n", d.reason);
}

// What to tell, so that a program can be proven: a line for each reason, and how to accept them
// all.
void put_remedy(std::string& text, const std::vector<verify::Doubt>& doubts) {
    auto out = std::back_inserter(text);
    std::string ids;
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        const auto is_open = [&](const verify::Doubt& d) {
            return d.reason == reason.id && !d.accepted;
        };
        if (std::ranges::none_of(doubts, is_open)) continue;
        fmt::format_to(out, "  {:<8} {}: {}\n", ids.empty() ? "to tell" : "", reason.id,
                       reason.tell);
        if (!ids.empty()) ids += ',';
        ids += reason.id;
    }
    if (!ids.empty()) fmt::format_to(out, "  or       --accept {}\n", ids);
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
        fmt::format_to(std::back_inserter(text), "  skipped  {}: {}\n", rules, one_line(s.reason));
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
    auto out = std::back_inserter(text);
    const std::string path = shown_path(checked.path);
    if (!checked.failure.empty()) {
        fmt::format_to(out, "{}: not verified: {}\n", path, one_line(checked.failure));
        return text;
    }
    const verify::Verdict& v = checked.verdict;
    for (std::size_t i = 0; i < v.findings.size(); ++i) {
        const Finding& f = v.findings[i];
        if (f.suppressed || (f.severity == Severity::Note && !options.notes)) continue;
        put_finding(text, checked, f, checked.lines[i]);
    }
    for (const auto& [rule, more] : v.unlisted) {
        fmt::format_to(out, "{}: {} more findings of {} are not listed\n", path, more, rule);
    }
    for (const verify::Doubt& d : v.doubts) {
        if (!d.accepted || options.notes) put_doubt(text, checked, d);
    }
    if (options.quiet) return text;
    fmt::format_to(out, "{}: {}: {}, {}, {}, {}", path, name_of_verdict(checked),
                   counted(v.count(Severity::Error), "error"),
                   counted(v.count(Severity::Warning), "warning"),
                   counted(v.count(Severity::Note), "note"), counted(v.open_doubts(), "doubt"));
    const std::size_t accepted = v.doubts.size() - v.open_doubts();
    if (accepted > 0) fmt::format_to(out, ", {} accepted", accepted);
    if (v.suppressed() > 0) fmt::format_to(out, ", {} suppressed", v.suppressed());
    text += '\n';
    put_remedy(text, v.doubts);
    if (!checked.stock.empty()) fmt::format_to(out, "  stock    {}\n", one_line(checked.stock));
    if (!checked.time.empty()) fmt::format_to(out, "  time     {}\n", checked.time);
    if (checked.design) fmt::format_to(out, "  design   {}\n", one_line(text_of(*checked.design)));
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
