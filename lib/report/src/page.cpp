// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pages and their index as HTML.
#include "ncsim/report/page.h"

#include "ncsim/report/check_text.h"
#include "ncsim/report/file_names.h"
#include "ncsim/report/plain_text.h"
#include "ncsim/report/version.h"

#include "append.h"
#include "json.h"
#include "markup.h"
#include "plot.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <ostream>
#include <string_view>

namespace ncsim::report {

extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;
extern const std::string_view kThreeScript;

namespace {

using verify::Finding;
using verify::Severity;

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve(bytes.size() / 3 * 4 + 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
        }
    }
    return out;
}

// Appends four bytes, little-endian, as typed arrays of browsers require.
template <class Word>
void put_word(std::string& bytes, Word word) {
    const auto bits = std::bit_cast<std::uint32_t>(word);
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(bits >> shift & 0xffU);
}

// Appends a number from -1 to 1 in 16 bits; for a unit normal, a step is below 0.002°.
void put_share(std::string& bytes, double share) {
    constexpr double kWhole = 32767.0;
    const auto bits = static_cast<std::uint16_t>(std::lround(kWhole * share));
    bytes += static_cast<char>(bits & 0xffU);
    bytes += static_cast<char>(bits >> 8U);
}

Json mesh_json(const PageData& page_data) {
    std::string vertices, triangles, lines, normals;
    for (const cda::Vec3& v : page_data.mesh.vertices) {
        for (const double c : {v.x, v.y, v.z})
            put_word(vertices, static_cast<float>(c));
    }
    for (const auto& triangle : page_data.mesh.triangles) {
        for (const std::uint32_t corner : triangle)
            put_word(triangles, corner);
    }
    for (const std::uint32_t line : page_data.lines)
        put_word(lines, line);
    for (const cda::Vec3& n : page_data.normals) {
        for (const double c : {n.x, n.y, n.z})
            put_share(normals, c);
    }
    return {{"vertices", base64(vertices)},
            {"triangles", base64(triangles)},
            {"lines", base64(lines)},
            {"normals", base64(normals)}};
}

// Returns for each joint: index of the value, rotary or linear, direction, a point of the axis.
Json joints_json(const std::vector<MachinePageData::Joint>& joints) {
    Json all = Json::array();
    for (const MachinePageData::Joint& j : joints) {
        const cda::Vec3 &d = j.direction, &p = j.through;
        all.push_back({j.axis, j.turns, {d.x, d.y, d.z}, {p.x, p.y, p.z}});
    }
    return all;
}

Json machine_json(const MachinePageData& machine) {
    Json json;
    json["bodies"] = Json::array();
    for (const MachinePageData::Body& body : machine.bodies) {
        std::string corners;
        for (const auto& triangle : body.mesh.triangles) {
            for (const std::uint32_t corner : triangle) {
                const cda::Vec3& v = body.mesh.vertices[corner];
                for (const double c : {v.x, v.y, v.z})
                    put_word(corners, static_cast<float>(c));
            }
        }
        json["bodies"].push_back({{"name", one_line(body.name)},
                                  {"colour", body.colour},
                                  {"corners", base64(corners)},
                                  {"moved_by", joints_json(body.moved_by)},
                                  {"tool", body.tool}});
    }
    json["part_moved_by"] = joints_json(machine.part_moved_by);
    json["zero"] = {machine.zero.x, machine.zero.y, machine.zero.z};
    std::string lines, values, tools;
    for (const auto& [line, stand] : machine.line_poses) {
        put_word(lines, line);
        for (const double value : stand.values)
            put_word(values, static_cast<float>(value));
        put_word(tools, stand.tool);
    }
    json["lines"] = base64(lines);
    json["values"] = base64(values);
    json["tools"] = base64(tools);
    return json;
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find_first_of("\r\n");
        lines.push_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
        const bool pair = text.substr(end, 2) == "\r\n";
        text.remove_prefix(end + (pair ? 2 : 1));
    }
    return lines;
}

// Returns the data for the script. The mark of a line is its highest severity.
Json data_json(const Checked& checked) {
    const PageData& page_data = *checked.page_data;
    Json data;
    data["source"] = Json::array();
    for (const std::string_view line : lines_of(page_data.source))
        data["source"].push_back(one_line(line));
    std::map<std::uint32_t, Severity> marks;
    for (const Finding& f : checked.verdict.findings) {
        if (!f.counts() || f.place.file != 0 || f.place.span.line == 0) continue;
        auto& mark = marks.try_emplace(f.place.span.line, f.severity).first->second;
        mark = std::max(mark, f.severity);
    }
    data["marks"] = Json::object();
    for (const auto& [line, severity] : marks)
        data["marks"][std::to_string(line)] = verify::name_of(severity);
    std::map<std::uint32_t, double> removed;
    for (const verify::LedgerRow& row : checked.verdict.ledger.rows) {
        if (row.file == 0) removed[row.line] += row.removed_mm3;
    }
    data["removed"] = Json::object();
    for (const auto& [line, volume] : removed)
        data["removed"][std::to_string(line)] = std::stod(fmt::format("{:.6g}", volume));
    if (!page_data.mesh.triangles.empty()) data["mesh"] = mesh_json(page_data);
    if (page_data.machine) data["machine"] = machine_json(*page_data.machine);
    return data;
}

// Returns JSON for a script element, with '<' escaped because "</script>" would end the element.
std::string for_script(const Json& json) {
    std::string out;
    for (const char c : to_line(json)) {
        if (c == '<') {
            out += "\\u003c";
        } else {
            out += c;
        }
    }
    return out;
}

std::string seconds_text(const std::optional<double>& seconds) {
    if (!seconds) return "unknown: rates are not specified";
    const auto whole = static_cast<long>(std::lround(*seconds));
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string finding_html(const Checked& checked, const Finding& f, const std::string& line) {
    std::string text = fmt::format("<div class=\"finding {}{}\"{}>", verify::name_of(f.severity),
                                   f.counts() ? "" : " suppressed",
                                   f.place.file == 0 && f.place.span.line > 0
                                       ? fmt::format(" data-line=\"{}\"", f.place.span.line)
                                       : "");
    std::string where = file_of(checked, f.place);
    if (f.place.span.line > 0) where += fmt::format(":{}", f.place.span.line);
    if (f.last.span.line > f.place.span.line) where += fmt::format("-{}", f.last.span.line);
    append(text, "<b>{}</b> {} <small>{} · {}{}</small>", verify::name_of(f.severity),
           escaped(headline(f)), escaped(where), f.rule,
           f.suppressed ? " · suppressed"
           : f.accepted ? " · in the baseline"
                        : "");
    if (!line.empty()) append(text, "<code>{}</code>", escaped(line.substr(0, 200)));
    for (const std::string& assumption : f.assumptions)
        append(text, "<small>assumed {}</small>", escaped(assumption));
    if (f.last_motion > 0) append(text, "<small>{}</small>", escaped(f.hint));
    return text + "</div>\n";
}

std::string findings_html(const Checked& checked) {
    const auto& findings = checked.verdict.findings;
    std::string text = "<section><h2>Findings</h2>\n";
    if (findings.empty()) text += "<p>Nothing was found.</p>\n";
    for (std::size_t i = 0; i < findings.size(); ++i)
        text += finding_html(checked, findings[i], checked.lines[i]);
    for (const auto& [rule, more] : checked.verdict.unlisted)
        text += fmt::format("<p>{} more findings of {} are not listed.</p>\n", more, rule);
    return text + "</section>\n";
}

std::string doubts_html(const Checked& checked) {
    if (checked.verdict.doubts.empty()) return {};
    std::string text = "<section><h2>Doubts</h2>\n";
    for (const verify::Doubt& d : checked.verdict.doubts) {
        std::string where = file_of(checked, d.place);
        if (d.place.span.line > 0) where += fmt::format(":{}", d.place.span.line);
        append(text,
               "<div class=\"finding {}\"{}><b>{}</b> {} <small>{} · {}</small>"
               "<small>fix: {}</small></div>\n",
               d.accepted ? "note suppressed" : "warning",
               d.place.file == 0 && d.place.span.line > 0
                   ? fmt::format(" data-line=\"{}\"", d.place.span.line)
                   : "",
               d.accepted ? "accepted" : "doubt", escaped(d.message), escaped(where), d.reason,
               escaped(std::string(verify::find_reason(d.reason)->fix)));
    }
    return text + "</section>\n";
}

std::string ledger_html(const Checked& checked) {
    const verify::Ledger& l = checked.verdict.ledger;
    std::string text = "<section><h2>Ledger</h2>\n";
    text += removed_plot(l);
    text += rate_plot(l);
    const auto row = [&text](const char* name, const std::string& value) {
        append(text, "<tr><th>{}</th><td>{}</td></tr>\n", name, escaped(value));
    };
    text += "<table>\n";
    if (checked.simulated) {
        row("stock", fmt::format("{:.6g} mm³", l.stock_mm3));
        if (l.measured) row("removed", fmt::format("{:.9g} mm³", l.removed_mm3));
        row("rest", fmt::format("{:.9g} mm³", l.rest_mm3));
        if (l.measured) {
            row("self-check",
                fmt::format("removed + rest - stock = {:.2g} of the stock", l.imbalance()));
        }
        if (l.air_known && l.feed_mm > 0.0) {
            row("air", fmt::format("{:.3g} % of the feed path", 100 * l.air_mm / l.feed_mm));
        }
    }
    if (checked.design) row("design", text_of(*checked.design));
    row("feed", fmt::format("{:.6g} mm, {}", l.feed_mm, seconds_text(l.feed_seconds)));
    row("rapid", fmt::format("{:.6g} mm, {}", l.rapid_mm, seconds_text(l.rapid_seconds)));
    text += "</table></section>\n";
    return text;
}

std::string skipped_html(const Checked& checked) {
    std::string text = "<section><h2>Not asked</h2><table>\n";
    for (const verify::Demotion& d : checked.verdict.demotions)
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", d.rule, escaped(demotion_text(d)));
    for (const verify::Skipped& s : checked.verdict.skipped)
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", s.rule, escaped(s.reason));
    return text + "</table></section>\n";
}

std::string pictures_html(const PageData& page_data) {
    std::string text = "<section><h2>Pictures</h2>\n";
    for (const auto& [name, png] : page_data.pictures) {
        text += fmt::format(
            "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}"
            "</figcaption></figure>\n",
            name, base64(png));
    }
    return text + "</section>\n";
}

std::string title_of(const Checked& checked) {
    const std::string program = checked.program.empty() ? "" : " (" + checked.program + ')';
    return relative_path(checked.path) + program;
}

std::string header_html(const Checked& checked) {
    const verify::Verdict& v = checked.verdict;
    const std::string scope = scope_of(checked);
    std::string text = fmt::format(
        "<header class=\"{0}\"><h1>{1}: {0}{8}</h1><p>errors {2}, warnings {3}, notes {4}, "
        "suppressed {5}, doubts {6} · ncsim {7}</p>",
        checked.word, escaped(title_of(checked)), v.count(Severity::Error),
        v.count(Severity::Warning), v.count(Severity::Note), v.suppressed(), v.open_doubts(),
        kVersion, scope.empty() ? "" : fmt::format(" ({})", escaped(scope)));
    if (!checked.failure.empty()) text += "<p>not verified: " + escaped(checked.failure) + "</p>";
    if (!checked.stock.empty()) text += "<p>stock " + escaped(checked.stock) + "</p>";
    if (!checked.time.empty()) text += "<p>time " + escaped(checked.time) + "</p>";
    if (!checked.not_simulated.empty()) {
        text += "<p>not simulated: " + escaped(checked.not_simulated) + "</p>";
    }
    return text + "</header>\n";
}

// Replaces bytes that are not UTF-8 by U+FFFD.
std::string valid_utf8(const std::string& text) {
    const std::string quoted = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
    return Json::parse(quoted).get<std::string>();
}

}  // namespace

void write_page(std::ostream& out, const Checked& checked) {
    std::string body = header_html(checked);
    const bool verified = checked.page_data.has_value();
    if (verified) {
        body += "<main>\n<section><h2>Part</h2>";
        if (!checked.page_data->mesh.triangles.empty() && !kThreeScript.empty()) {
            body += "<div id=\"view\"></div>";
            if (checked.page_data->machine) {
                body +=
                    "<p id=\"stand\"><label><input type=\"checkbox\" checked> machine</label>"
                    "<input type=\"range\" aria-label=\"line\"></p>";
            }
        }
        body +=
            "<p id=\"picked\"></p></section>\n"
            "<section><h2>Program</h2><div id=\"source\"></div></section>\n";
        body += findings_html(checked) + doubts_html(checked) + ledger_html(checked);
        if (!checked.page_data->pictures.empty()) body += pictures_html(*checked.page_data);
        body += skipped_html(checked) + "</main>\n";
    }
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>"
        << valid_utf8(escaped(title_of(checked))) << " · ncsim check</title>\n<style>\n"
        << kPageStyle << "</style></head>\n<body>\n"
        << valid_utf8(body);
    if (verified) {
        out << "<script id=\"data\" type=\"application/json\">" << for_script(data_json(checked))
            << "</script>\n<script>" << kThreeScript << "</script>\n<script>\n"
            << kPageScript << "</script>\n";
    }
    out << "</body></html>\n";
}

namespace {

std::string row_html(const Entry& entry, const std::string& link) {
    const std::string program = entry.program.empty() ? "" : " (" + entry.program + ')';
    const std::string name = escaped(relative_path(entry.path) + program);
    return fmt::format("<tr class=\"{0}\"><td>{0}</td><td>{1}</td><td>{2}</td></tr>\n", entry.word,
                       link.empty() ? name : fmt::format("<a href=\"{}\">{}</a>", link, name),
                       escaped(entry.counts));
}

std::string scope_html(const Scope& scope) {
    std::string text;
    if (!scope.called.empty()) text += "<section><h2>Judged with a caller</h2><ul>\n";
    for (const CalledFile& file : scope.called)
        text += fmt::format("<li>{} (with {})</li>\n", escaped(relative_path(file.path)),
                            escaped(relative_path(file.caller)));
    if (!scope.called.empty()) text += "</ul></section>\n";
    if (!scope.excluded.empty()) text += "<section><h2>Left out</h2><ul>\n";
    for (const ExcludedEntry& file : scope.excluded)
        text += fmt::format("<li>{}: {}</li>\n", escaped(relative_path(file.path)), file.why);
    if (!scope.excluded.empty()) text += "</ul></section>\n";
    return text;
}

}  // namespace

void write_page_index(std::ostream& out, const Entries& all,
                      const std::function<std::string(const Entry&)>& link, const Scope& scope) {
    std::map<std::string, std::size_t> words;
    std::size_t programs = 0;
    std::string rows;
    all([&](const Entry& entry) {
        ++words[entry.word];
        ++programs;
        rows += row_html(entry, link(entry));
    });
    std::string counts;
    for (const char* word : {"clean", "accepted", "not-proven", "failed", "not-verified"}) {
        if (words[word] > 0) counts += fmt::format(", {} {}", words[word], word);
    }
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>ncsim check</title>\n"
           "<style>\n"
        << kPageStyle << "</style></head>\n<body>\n"
        << valid_utf8(fmt::format("<header><h1>ncsim check: {} programs{}</h1><p>ncsim {}</p>"
                                  "</header>\n<main>\n<section><table>\n{}</table></section>\n{}"
                                  "</main>\n",
                                  programs, counts, kVersion, rows, scope_html(scope)))
        << "</body></html>\n";
}

}  // namespace ncsim::report
