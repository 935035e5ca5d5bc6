// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects and prints diagnostics.
#include "ncsim/gcode/diagnostic.h"

#include <algorithm>

namespace ncsim::gcode {
namespace {

std::string fill(std::string_view text, std::initializer_list<std::string_view> arguments) {
    std::string out;
    const auto* argument = arguments.begin();
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "{}" && argument != arguments.end()) {
            out += *argument++;
            ++i;
        } else {
            out += text[i];
        }
    }
    return out;
}

/// Returns `text` with blanks in place of control characters.
std::string printable(std::string_view text) {
    std::string out(text);
    std::ranges::replace_if(
        out, [](char c) { return c >= 0 && c < ' '; }, ' ');
    return out;
}

/// Returns a file name for the beginning of a line, with "./" before a name that looks like a
/// command.
std::string named(std::string_view name) {
    const std::size_t begin = name.find_first_not_of(" \t");
    const std::string_view rest = begin == std::string_view::npos ? "" : name.substr(begin);
    const bool is_command = rest.starts_with("::") || rest.starts_with("##");
    return (is_command ? "./" : "") + printable(name);
}

const char* name_of(Severity severity) {
    switch (severity) {
        case Severity::Note: return "note";
        case Severity::Warning: return "warning";
        case Severity::Error: return "error";
    }
    return "";
}

}  // namespace

Diagnostic diagnostic_of(const MessageText& message, SourceSpan span,
                         std::initializer_list<std::string_view> arguments) {
    return {message.severity,
            std::string(message.code),
            printable(fill(message.text, arguments)),
            span,
            {},
            1};
}

bool has_errors(const Diagnostics& diagnostics) {
    return std::ranges::any_of(diagnostics,
                               [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

void DiagnosticLog::add(const MessageText& message, SourceSpan span,
                        std::initializer_list<std::string_view> arguments) {
    add(message.severity, message, span, arguments);
}

void DiagnosticLog::add(Severity severity, const MessageText& message, SourceSpan span,
                        std::initializer_list<std::string_view> arguments) {
    if (severity == Severity::Error) ++errors_;
    const auto put = [&](Diagnostic d) {
        d.file = file_;
        diagnostics_.push_back(std::move(d));
    };
    Diagnostic d = diagnostic_of(message, span, arguments);
    d.severity = severity;
    key_.assign(d.code).append(1, '\n').append(d.message).append(1, '\n').append(file_);
    key_.push_back(static_cast<char>('0' + static_cast<int>(severity)));
    if (const auto known = index_.find(key_); known != index_.end()) {
        ++diagnostics_[known->second].count;
        return;
    }
    if (diagnostics_.size() >= kMaxDifferent) {
        if (!closed_) put(diagnostic_of(kTooMany, span));
        closed_ = true;
        return;
    }
    index_.emplace(key_, diagnostics_.size());
    put(std::move(d));
}

std::string render(const Diagnostic& diagnostic, const SourceFile& file) {
    std::string out = named(diagnostic.file.empty() ? file.name : diagnostic.file);
    const SourceSpan& span = diagnostic.span;
    if (span.line > 0) {
        out += ':' + std::to_string(span.line) + ':' + std::to_string(span.column);
    }
    out.append(": ").append(name_of(diagnostic.severity)).append(": ").append(diagnostic.message);
    out.append(" [").append(diagnostic.code).append("]");
    if (diagnostic.count > 1) {
        out.append(" (").append(std::to_string(diagnostic.count)).append(" times, first here)");
    }
    out += '\n';
    if (span.line == 0 || (!diagnostic.file.empty() && diagnostic.file != file.name)) return out;

    // Lines may have any length; only the part around the caret is shown.
    constexpr std::size_t kWidth = 100;
    const std::string_view line = line_text(file, span.line);
    std::size_t column = std::min<std::size_t>(std::max(span.column, 1U) - 1, line.size());
    const std::size_t first = column > kWidth * 3 / 4 ? column - kWidth / 2 : 0;
    const std::string_view shown = line.substr(first, kWidth);
    column -= first;
    if (shown.empty()) return out;
    out.append(kQuoteMark).append(printable(shown)).append(1, '\n');
    const std::size_t room = shown.size() > column ? shown.size() - column : 1;
    const std::size_t length = std::clamp<std::size_t>(span.length, 1, room);
    out.append(kQuoteMark).append(column, ' ').append(1, '^');
    out.append(length - 1, '~').append(1, '\n');
    return out;
}

}  // namespace ncsim::gcode
