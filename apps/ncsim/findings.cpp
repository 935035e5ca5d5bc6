// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings.h"

#include "plain_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

const char* name_of(gcode::Severity severity) {
    switch (severity) {
        case gcode::Severity::Note: return "note";
        case gcode::Severity::Warning: return "warning";
        case gcode::Severity::Error: break;
    }
    return "error";
}

const char* name_of(toolpath::ToldBy by) {
    switch (by) {
        case toolpath::ToldBy::Comment: return "comment";
        case toolpath::ToldBy::Option: return "option";
        case toolpath::ToldBy::Table: return "table";
        case toolpath::ToldBy::Assumption: break;
    }
    return "assumption";
}

void say(std::string_view text) {
    const std::string shown = printable(text);
    std::fwrite(shown.data(), 1, shown.size(), stderr);
}

void put_out(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() ||
        std::fflush(stdout) != 0) {
        throw std::runtime_error(fmt::format("cannot write to the standard output: {}",
                                             std::generic_category().message(errno)));
    }
}

void put_text(std::string_view text, bool aside) {
    if (aside) {
        say(text);
    } else {
        put_out(printable(text));
    }
}

void print_findings(const gcode::SourceFile& program, const gcode::Diagnostics& diagnostics) {
    for (const gcode::Diagnostic& d : diagnostics) {
        say(gcode::render(d, program));
    }
}

nlohmann::ordered_json findings_json(const gcode::Diagnostics& diagnostics) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const gcode::Diagnostic& d : diagnostics) {
        nlohmann::ordered_json finding{
            {"severity", name_of(d.severity)}, {"code", d.code}, {"message", d.message}};
        if (!d.file.empty()) finding["file"] = d.file;
        if (d.span.line != 0) {
            finding["line"] = d.span.line;
            finding["column"] = d.span.column;
        }
        finding["count"] = d.count;
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::string lines_text(const std::vector<verify::LineRange>& lines) {
    constexpr std::size_t kShown = 6;
    std::string text;
    for (std::size_t i = 0; i < lines.size() && i < kShown; ++i) {
        text += fmt::format("{}{}", i == 0 ? "" : ", ", lines[i].first);
        if (lines[i].last != lines[i].first) text += fmt::format("-{}", lines[i].last);
    }
    if (lines.size() > kShown) text += fmt::format(" and {} more", lines.size() - kShown);
    return text;
}

std::string to_line(const nlohmann::ordered_json& json) {
    return shown_json(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

std::string to_text(const nlohmann::ordered_json& json) {
    return shown_json(json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) +
           '\n';
}

}  // namespace ncsim::app
