// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings as workflow commands of GitHub Actions.
#include "annotations.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"

#include "append.h"

#include <fmt/format.h>

#include <string_view>

namespace ncsim::report {

namespace {

// Escapes the data or a property of a workflow command. The text is also made printable, because a
// log is shown in a terminal or by another service.
std::string escaped_command(std::string_view text, bool property) {
    std::string out;
    for (const char c : printable(text)) {
        if (c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','))) {
            append(out, "%{:02X}", static_cast<unsigned char>(c));
        } else {
            out += c;
        }
    }
    return out;
}

const char* command_for(verify::Severity severity) {
    switch (severity) {
        case verify::Severity::Note: return "notice";
        case verify::Severity::Warning: return "warning";
        case verify::Severity::Error: break;
    }
    return "error";
}

}  // namespace

std::string github_annotations(const Checked& checked, bool notes, LengthUnit unit) {
    std::string text;
    if (!checked.failure.empty()) {
        append(text, "::error file={}::{}not verified: {}\n",
               escaped_command(relative_path(checked.path), true),
               checked.program.empty() ? "" : escaped_command(checked.program, false) + ": ",
               escaped_command(checked.failure, false));
    }
    for (const verify::Finding& f : checked.verdict.findings) {
        if (!f.counts() || (f.severity == verify::Severity::Note && !notes)) continue;
        const auto& span = f.place.span;
        append(text, "::{} file={}", command_for(f.severity),
               escaped_command(file_of(checked, f.place), true));
        if (span.line > 0) {
            const bool is_range = f.last.file == f.place.file && f.last.span.line > span.line;
            append(text, ",line={}", span.line);
            if (is_range) {
                append(text, ",endLine={}", f.last.span.line);
            } else {
                append(text, ",col={}", span.column);
            }
        }
        std::string message = headline(f);
        for (const std::string& assumption : f.assumptions)
            message += "\nassumed " + assumption;
        if (f.last_motion > 0) message += "\nhint: " + f.hint;
        append(text, ",title={}::{}\n", escaped_command(f.rule, true),
               escaped_command(in_unit(message, unit), false));
    }
    for (const verify::Doubt& d : checked.verdict.doubts) {
        if (d.accepted) continue;
        append(text, "::warning file={}", escaped_command(file_of(checked, d.place), true));
        if (d.place.span.line > 0)
            append(text, ",line={},col={}", d.place.span.line, d.place.span.column);
        const std::string message =
            fmt::format("not proven: {}\nfix: {}", d.message, verify::find_reason(d.reason)->fix);
        append(text, ",title={}::{}\n", escaped_command(d.reason, true),
               escaped_command(in_unit(message, unit), false));
    }
    return text;
}

}  // namespace ncsim::report
