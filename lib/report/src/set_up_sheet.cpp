// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes set-up sheets.
#include "ncsim/report/set_up_sheet.h"

#include "ncsim/base/version.h"
#include "ncsim/report/describe.h"
#include "ncsim/verify/machining_time.h"

#include "markup.h"
#include "operation_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::report {

extern const std::string_view kSheetStyle;

namespace {

// Returns a drawing of the tool from the profiles: cutting pieces dark, further pieces light.
std::string drawing_of(const toolpath::Tool& tool) {
    double radius = 0.0, height = 0.0;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        for (const toolpath::ProfilePoint& p : piece.profile) {
            radius = std::max(radius, p.radius);
            height = std::max(height, p.height);
        }
    }
    constexpr double kMostMm = 200.0;  // the upper part of long tools is cut off
    height = std::min(height, kMostMm);
    if (radius <= 0.0 || height <= 0.0) return {};
    std::string text = fmt::format(
        "<svg height=\"90\" viewBox=\"{:.3f} {:.3f} {:.3f} {:.3f}\" role=\"img\" "
        "aria-label=\"tool {}\">",
        -radius, -height, 2 * radius, height, tool.number);
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        std::string right, left;
        for (const toolpath::ProfilePoint& p : piece.profile) {
            right += fmt::format("{:.3f},{:.3f} ", p.radius, -p.height);
            left.insert(0, fmt::format("{:.3f},{:.3f} ", -p.radius, -p.height));
        }
        text += fmt::format(
            "<polygon points=\"{}{}\" fill=\"{}\" stroke=\"#000\" "
            "stroke-width=\"{:.3f}\"/>",
            right, left, piece.cutting ? "#777" : "#ddd", height / 200);
    }
    return text + "</svg>";
}

std::string length_text(const std::optional<double>& mm, LengthUnit unit) {
    return mm ? in_unit(fmt::format("{:g} mm", *mm), unit) : std::string("?");
}

std::string holder_of(const toolpath::ToolSpec& spec, LengthUnit unit) {
    const auto number = [unit](double mm) {
        const std::string text = in_unit(fmt::format("{:g} mm", mm), unit);
        return text.substr(0, text.find(' '));
    };
    if (spec.holder.empty()) return "?";
    std::string text;
    for (const toolpath::ToolSegment& s : spec.holder) {
        text += text.empty() ? "" : ", ";
        text += s.lower_diameter == s.upper_diameter
                    ? fmt::format("D{} x {}", number(s.lower_diameter), number(s.height))
                    : fmt::format("D{}-{} x {}", number(s.lower_diameter), number(s.upper_diameter),
                                  number(s.height));
    }
    return text;
}

void write_tools(std::ostream& out, const SheetSetUp& set_up, LengthUnit unit) {
    out << "<h2>Tools</h2>\n<table>\n<tr><th>tool</th><th>picture</th><th>shape</th>"
           "<th>stick-out</th><th>holder</th><th>length offset</th><th>path</th><th>time</th>"
           "</tr>\n";
    for (const auto& [number, used] : set_up.facts->tools) {
        const toolpath::ToolEntry* const entry = toolpath::find_tool(set_up.described, number);
        const double offset = entry ? entry->offset.z : 0.0;
        std::string path, time;
        if (const auto d = set_up.facts->distances.find(number);
            d != set_up.facts->distances.end()) {
            path = in_unit(fmt::format("{:.0f} mm feed, {:.0f} mm rapid", d->second.feed_mm,
                                       d->second.rapid_mm),
                           unit);
            const auto seconds = time_of(d->second).total();
            time = seconds ? verify::time_text(*seconds) : "?";
        }
        std::string shape = tool_in_unit(toolpath::describe(used.tool), unit);
        if (!used.assumed_values_text.empty())
            shape += "; assumed: " + in_unit(used.assumed_values_text, unit);
        if (used.is_guess) shape += "; a guess";
        out << fmt::format(
            "<tr><td>T{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td></tr>\n",
            number, drawing_of(used.tool), escaped(shape), length_text(used.spec.stick_out, unit),
            escaped(holder_of(used.spec, unit)), offset != 0.0 ? length_text(offset, unit) : "?",
            path, time);
    }
    for (const auto& [number, first] : set_up.facts->unknown_tools) {
        out << fmt::format(
            "<tr><td>T{}</td><td></td><td colspan=\"6\">not described; moves from "
            "line {} on</td></tr>\n",
            number, first.line);
    }
    out << "</table>\n";
}

void write_operations(std::ostream& out, const simulation::ProgramFacts& program, LengthUnit unit) {
    const std::vector<OperationRow> rows = operation_rows(program);
    if (rows.empty()) return;
    out << "<h2>Operations</h2>\n<table>\n<tr><th>line</th><th>operation</th><th>tool</th>"
           "<th>path</th><th>time</th></tr>\n";
    for (const auto& [operation, removed] : rows) {
        const auto seconds = time_of(operation.distances).total();
        out << fmt::format(
            "<tr><td>{}</td><td>{}</td><td>T{}</td><td>{}</td><td>{}</td></tr>\n",
            operation.line > 0 ? std::to_string(operation.line) : "", escaped(operation.name),
            operation.tool,
            in_unit(fmt::format("{:.0f} mm feed, {:.0f} mm rapid", operation.distances.feed_mm,
                                operation.distances.rapid_mm),
                    unit),
            seconds ? verify::time_text(*seconds) : "?");
    }
    out << "</table>\n";
}

void write_list(std::ostream& out, const char* title, const char* kind,
                const std::vector<std::string>& lines, LengthUnit unit) {
    if (lines.empty()) return;
    out << "<div class=\"" << kind << "\"><h2>" << title << "</h2>\n<ul>\n";
    for (const std::string& line : lines)
        out << "<li>" << escaped(in_unit(line, unit)) << "</li>\n";
    out << "</ul></div>\n";
}

}  // namespace

void write_set_up_sheet(std::ostream& out, const std::string& job,
                        const std::vector<SheetSetUp>& set_ups, LengthUnit unit) {
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>"
        << escaped(job) << "</title>\n<style>\n"
        << kSheetStyle << "</style></head>\n<body>\n";
    for (const SheetSetUp& set_up : set_ups) {
        out << "<section>\n<h1>" << escaped(job);
        if (!set_up.title.empty()) out << ": " << escaped(set_up.title);
        out << "</h1>\n<table class=\"values\">\n<tr><th>program</th><td>"
            << escaped(set_up.program) << "</td></tr>\n";
        if (set_up.facts->stock) {
            out << "<tr><th>stock</th><td>"
                << escaped(in_unit(describe(*set_up.facts->stock), unit)) << "</td></tr>\n";
        }
        for (const auto& [name, value] : set_up.values)
            out << "<tr><th>" << escaped(name) << "</th><td>" << escaped(in_unit(value, unit))
                << "</td></tr>\n";
        out << "<tr><th>time</th><td>"
            << escaped(in_unit(time_line(verify::total(set_up.facts->distances)), unit))
            << "</td></tr>\n"
            << "</table>\n";
        write_tools(out, set_up, unit);
        write_operations(out, *set_up.facts, unit);
        write_list(out, "Fixtures", "fixtures", set_up.fixtures, unit);
        write_list(out, "To measure at the machine", "open", set_up.assumed, unit);
        out << "<footer>ncsim " << kVersion << "; lengths in "
            << (unit == LengthUnit::Inch ? "inches" : "mm") << "</footer>\n</section>\n";
    }
    out << "</body>\n</html>\n";
}

}  // namespace ncsim::report
