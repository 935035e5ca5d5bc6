// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_outputs.h"

#include "plain_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <ostream>
#include <system_error>

namespace ncsim::app {

namespace {

// Of workflow commands: data, and the properties before it. Printable, too: the log that shows
// them is a terminal of a kind, and may be that of another service.
std::string escaped(std::string_view text, bool property) {
    std::string out;
    for (const char c : printable(text)) {
        if (c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','))) {
            fmt::format_to(std::back_inserter(out), "%{:02X}", static_cast<unsigned char>(c));
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

// Nine digits: beyond them is the dust of decimal fractions in binary. Nothing for what is not
// known.
std::string number(std::optional<double> value) {
    return value ? fmt::format("{:.9g}", *value) : std::string();
}

std::string csv_path(const std::string& path) {
    const std::string text = shown_path(path);
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

const char* name_of(gcode::MoveKind kind) {
    switch (kind) {
        case gcode::MoveKind::Rapid: return "rapid";
        case gcode::MoveKind::Feed: return "feed";
        case gcode::MoveKind::Probe: break;
    }
    return "probe";
}

}  // namespace

std::string relative_path(const std::string& path) {
    std::error_code error;
    const std::filesystem::path given(path);
    std::filesystem::path relative = given.lexically_normal();
    if (given.is_absolute()) {
        const auto here = std::filesystem::current_path(error);
        const auto seen = relative.lexically_relative(here);
        if (!error && !seen.empty() && *seen.begin() != "..") relative = seen;
    }
    return relative.generic_string();
}

std::string file_of(const Checked& checked, const verify::Place& place) {
    const auto& files = checked.verdict.files;
    if (place.file == 0 || place.file >= files.size()) return relative_path(checked.path);
    const auto folder = std::filesystem::path(checked.path).parent_path();
    return relative_path((folder / files[place.file]).string());
}

std::string headline(const verify::Finding& f) {
    std::string text = f.message;
    if (f.quantity) text += ": " + verify::text_of(*f.quantity);
    if (f.certainty == verify::Certainty::Within) {
        text += ", not certain: within the accuracy of the tool";
    }
    return text;
}

std::string github_annotations(const Checked& checked) {
    std::string text;
    auto out = std::back_inserter(text);
    if (!checked.failure.empty()) {
        fmt::format_to(out, "::error file={}::not verified: {}\n",
                       escaped(relative_path(checked.path), true), escaped(checked.failure, false));
    }
    for (const verify::Finding& f : checked.verdict.findings) {
        if (f.suppressed) continue;
        const auto& span = f.place.span;
        fmt::format_to(out, "::{} file={}", command_for(f.severity),
                       escaped(file_of(checked, f.place), true));
        if (span.line > 0) {
            const bool is_range = f.last.file == f.place.file && f.last.span.line > span.line;
            fmt::format_to(out, ",line={}", span.line);
            if (is_range) {
                fmt::format_to(out, ",endLine={}", f.last.span.line);
            } else {
                fmt::format_to(out, ",col={}", span.column);
            }
        }
        std::string message = headline(f);
        for (const std::string& assumption : f.assumptions)
            message += "\nassumed " + assumption;
        if (f.last_motion > 0) message += "\nhint: " + f.hint;
        fmt::format_to(out, ",title={}::{}\n", escaped(f.rule, true), escaped(message, false));
    }
    for (const verify::Doubt& d : checked.verdict.doubts) {
        if (d.accepted) continue;
        fmt::format_to(out, "::warning file={}", escaped(file_of(checked, d.place), true));
        if (d.place.span.line > 0)
            fmt::format_to(out, ",line={},col={}", d.place.span.line, d.place.span.column);
        const std::string message = fmt::format("not proven: {}\nto tell: {}", d.message,
                                                verify::find_reason(d.reason)->tell);
        fmt::format_to(out, ",title={}::{}\n", escaped(d.reason, true), escaped(message, false));
    }
    return text;
}

void write_ledger_csv(std::ostream& out, std::span<const Checked> all) {
    out << "program,file,line,first_motion,last_motion,tool,kind,length_mm,removed_mm3,seconds,"
           "mm3_per_minute,contact_min_x,contact_min_y,contact_min_z,contact_max_x,contact_max_y,"
           "contact_max_z\n";
    for (const Checked& checked : all) {
        const std::string program = csv_path(relative_path(checked.path));
        for (const verify::LedgerRow& row : checked.verdict.ledger.rows) {
            out << fmt::format("{},{},{},{},{},{},{},{},{},{},{}", program,
                               csv_path(file_of(checked, {row.file, {}})), row.line,
                               row.first_motion, row.last_motion, row.tool, name_of(row.kind),
                               number(row.length_mm), number(row.removed_mm3), number(row.seconds),
                               number(row.removal_rate()));
            for (const cda::Vec3& corner : {row.contact.min, row.contact.max}) {
                for (int axis = 0; axis < 3; ++axis) {
                    out << ',';
                    if (!row.contact.is_empty()) out << number(corner[axis]);
                }
            }
            out << '\n';
        }
    }
}

}  // namespace ncsim::app
