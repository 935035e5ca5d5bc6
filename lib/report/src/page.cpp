// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pages as HTML.
#include "ncsim/report/page.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/report/check_text.h"

#include "append.h"
#include "json.h"
#include "markup.h"
#include "page_arrays.h"
#include "page_ledger.h"
#include "source_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <ostream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ncsim::report {

extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;
extern const std::string_view kPageArrays;
extern const std::string_view kPageRenderer;
extern const std::string_view kPagePaint;
extern const std::string_view kPageMarks;
extern const std::string_view kPageLink;

namespace {

using verify::Finding;
using verify::Severity;

// Longer programs are compressed, bytes.
constexpr std::size_t kLongSource = 1'000'000;
// Surfaces of more pieces are rounded to a grid that is coarser by some bits: to 1/8191 of the
// stock.
constexpr std::size_t kManyPieces = 1'000'000;
constexpr unsigned kCoarseBits = 3;
// Step of axes and points of forms, mm.
constexpr double kFormStep = 1e-6;

using Numbers = std::vector<std::uint32_t>;

// Normals, each listed once.
class NormalTable {
public:
    std::uint32_t number_of(const Vec3& normal) {
        components_.clear();
        append_direction(components_, normal);
        const std::uint64_t key = std::uint64_t{components_[0] & 0xffffU} |
                                  std::uint64_t{components_[1] & 0xffffU} << 16U |
                                  std::uint64_t{components_[2] & 0xffffU} << 32U;
        const auto next = static_cast<std::uint32_t>(known_.size());
        const auto [place, is_new] = known_.try_emplace(key, next);
        if (is_new) numbers_.insert(numbers_.end(), components_.begin(), components_.end());
        return place->second;
    }
    const Numbers& numbers() const { return numbers_; }

private:
    std::unordered_map<std::uint64_t, std::uint32_t> known_;
    Numbers numbers_, components_;
};

// Returns a mesh of a page: corners of triangles.
Json mesh_json(const TriangleMesh& mesh) {
    Numbers vertices, triangles;
    for (const Vec3& v : mesh.vertices)
        append_position(vertices, v);
    for (const auto& triangle : mesh.triangles)
        triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    return {{"vertices", packed(vertices, 3)}, {"triangles", packed(triangles, 3)}};
}

Json part_json(const simulation::PageData& page_data) {
    Json json = mesh_json(page_data.mesh);
    NormalTable normals;
    Numbers normal_of;
    for (const Vec3& n : page_data.normals)
        normal_of.push_back(normals.number_of(n));
    json["normals"] = packed(normals.numbers(), 3);
    json["normalOf"] = packed(normal_of);
    json["lines"] = packed(page_data.lines);
    json["tools"] = packed(page_data.tool_of);
    json["formOf"] = packed(page_data.form_of);
    json["forms"] = Json::array();
    const auto list = [](const Vec3& v) {
        Json values = Json::array();
        for (const double c : {v.x, v.y, v.z})
            values.push_back(std::round(c / kFormStep) * kFormStep);
        return values;
    };
    for (const simulation::FaceForm& form : page_data.forms) {
        json["forms"].push_back(Json::array(
            {form.name, form.dimensions, list(form.axis), list(form.origin), form.is_hollow}));
    }
    return json;
}

// Returns the surface with its distances from the design in steps of kPageUnit.
Json deviation_json(const simulation::DeviationMesh& deviation) {
    Json json = mesh_json(deviation.mesh);
    Numbers values;
    for (const double mm : deviation.deviation_mm)
        values.push_back(static_cast<std::uint32_t>(std::llround(mm / kPageUnit)));
    json["deviation"] = packed(values);
    json["tolerance"] = deviation.tolerance_mm;
    return json;
}

Json body_json(const simulation::ColouredMesh& body) {
    Json json = mesh_json(body.mesh);
    json["colour"] = body.colour;
    if (!body.name.empty()) json["name"] = body.name;
    return json;
}

// Returns the states of the part. Normals are listed once each.
Json surface_json(const simulation::PlayData& play) {
    const cda::SurfaceRecorder& surface = play.surface;
    const cda::RecordGrid& grid = surface.grid();
    const unsigned shift = surface.pieces().size() > kManyPieces ? kCoarseBits : 0;
    Numbers sizes, corners, lines, first, end, normal_of;
    NormalTable normals;
    for (const cda::SurfacePiece& piece : surface.pieces()) {
        if (piece.first_state >= surface.states()) continue;
        sizes.push_back(piece.corners);
        for (const cda::GridPoint& p :
             surface.corners().subspan(piece.first_corner, piece.corners)) {
            for (const std::uint16_t c : p)
                corners.push_back(static_cast<std::uint32_t>(c) >> shift);
        }
        const auto origin = static_cast<std::size_t>(piece.origin);
        lines.push_back(origin < play.line_of_origin.size() ? play.line_of_origin[origin] : 0);
        first.push_back(piece.first_state);
        end.push_back(std::min(piece.end_state, surface.states()));
        normal_of.push_back(normals.number_of(piece.normal));
    }
    Numbers state_moves, state_lines;
    for (const simulation::PlayState& state : play.states) {
        state_moves.push_back(state.moves);
        state_lines.push_back(state.line);
    }
    return {{"origin", {grid.origin.x, grid.origin.y, grid.origin.z}},
            {"step", std::ldexp(grid.step, static_cast<int>(shift))},
            {"sizes", packed(sizes)},
            {"corners", packed(corners, 3)},
            {"lines", packed(lines)},
            {"first", packed(first)},
            {"end", packed(end)},
            {"normalOf", packed(normal_of)},
            {"normals", packed(normals.numbers(), 3)},
            {"stateMoves", packed(state_moves)},
            {"stateLines", packed(state_lines)}};
}

Json play_json(const simulation::PlayData& play) {
    Numbers lines, tools, rapid, first, last, times, points, axes;
    for (const simulation::PlayMove& move : play.moves) {
        lines.push_back(move.line);
        tools.push_back(move.tool);
        rapid.push_back(move.is_rapid ? 1 : 0);
        first.push_back(move.first_point);
        last.push_back(move.last_point);
        // 49 days; a dwell may be longer.
        constexpr double kMost = 4294967295.0;
        times.push_back(
            static_cast<std::uint32_t>(std::llround(std::min(1000.0 * move.seconds, kMost))));
    }
    bool is_upright = true;
    for (std::size_t i = 0; i < play.points.size(); ++i) {
        append_position(points, play.points[i]);
        append_direction(axes, play.axes[i]);
        is_upright &= play.axes[i] == Vec3{0, 0, 1};
    }
    Json all_tools = Json::array();
    for (const simulation::PlayTool& tool : play.tools) {
        Json pieces = Json::array();
        for (const simulation::ColouredMesh& piece : tool.pieces)
            pieces.push_back(body_json(piece));
        all_tools.push_back({{"name", one_line(tool.name)}, {"pieces", std::move(pieces)}});
    }
    return {{"surface", surface_json(play)},
            {"lines", packed(lines)},
            {"tools", packed(tools)},
            {"rapid", packed(rapid)},
            {"first", packed(first)},
            {"last", packed(last)},
            {"milliseconds", packed(times)},
            {"points", packed(points, 3)},
            {"axes", is_upright ? "" : packed(axes, 3)},
            {"toolBodies", std::move(all_tools)},
            {"feedsKnown", play.feeds_known}};
}

// Returns for each joint: index of the value, rotary or linear, direction, a point of the axis.
Json joints_json(const std::vector<simulation::MachinePageData::Joint>& joints) {
    Json all = Json::array();
    for (const simulation::MachinePageData::Joint& j : joints) {
        const Vec3 &d = j.direction, &p = j.through;
        all.push_back({j.axis, j.turns, {d.x, d.y, d.z}, {p.x, p.y, p.z}});
    }
    return all;
}

Json machine_json(const simulation::MachinePageData& machine) {
    Json json;
    json["bodies"] = Json::array();
    for (const simulation::MachinePageData::Body& body : machine.bodies) {
        json["bodies"].push_back({{"name", one_line(body.name)},
                                  {"colour", body.colour},
                                  {"mesh", mesh_json(body.mesh)},
                                  {"moved_by", joints_json(body.moved_by)},
                                  {"tool", body.tool}});
    }
    json["part_moved_by"] = joints_json(machine.part_moved_by);
    json["zero"] = {machine.zero.x, machine.zero.y, machine.zero.z};
    Numbers lines, values, tools;
    const auto add = [&](const simulation::MachinePageData::LinePose& pose) {
        for (const double value : pose.values) {
            values.push_back(static_cast<std::uint32_t>(
                static_cast<std::int64_t>(std::llround(value / kPageUnit))));
        }
        tools.push_back(static_cast<std::uint32_t>(pose.tool));
    };
    for (const auto& [line, pose] : machine.line_poses) {
        lines.push_back(line);
        add(pose);
    }
    // Poses of findings follow those of lines.
    json["findings"] = Json::object();
    for (const auto& [finding, pose] : machine.finding_poses) {
        json["findings"][std::to_string(finding)] = tools.size();
        add(pose);
    }
    json["lines"] = packed(lines);
    json["values"] = packed(values, 9);
    json["tools"] = packed(tools);
    return json;
}

// Returns the data for the script. The mark of a line is its highest severity.
Json data_json(const Checked& checked, const simulation::PageData& page_data, LengthUnit unit) {
    Json data;
    if (page_data.source.size() > kLongSource) {
        std::string text;
        for (const std::string_view line : lines_of(page_data.source))
            text += one_line(line) + '\n';
        data["packedSource"] = packed_text(valid_utf8(text));
    } else {
        data["source"] = Json::array();
        for (const std::string_view line : lines_of(page_data.source))
            data["source"].push_back(one_line(line));
    }
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
    const Box& stock = page_data.stock;
    data["inches"] = unit == LengthUnit::Inch;
    data["stock"] = {stock.min.x, stock.min.y, stock.min.z, stock.max.x, stock.max.y, stock.max.z};
    data["findings"] = Json::array();
    for (const Finding& f : checked.verdict.findings) {
        Json place = Json::array();
        if (const auto point = verify::point_of(f)) place = {point->x, point->y, point->z};
        data["findings"].push_back({f.place.file == 0 ? f.place.span.line : 0,
                                    verify::name_of(f.severity), place,
                                    f.category == verify::Category::Collision, f.bodies});
    }
    if (!page_data.mesh.triangles.empty()) data["mesh"] = part_json(page_data);
    if (page_data.deviation) data["deviation"] = deviation_json(*page_data.deviation);
    data["fixtures"] = Json::array();
    for (const simulation::ColouredMesh& body : page_data.fixtures)
        data["fixtures"].push_back(body_json(body));
    if (page_data.play) data["play"] = play_json(*page_data.play);
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

std::string finding_html(const Checked& checked, std::size_t number, LengthUnit unit) {
    const Finding& f = checked.verdict.findings[number];
    const std::string& line = checked.lines[number];
    std::string text = fmt::format(
        "<li><div class=\"finding {}{}\" role=\"button\" tabindex=\"0\" "
        "data-finding=\"{}\"{}>",
        verify::name_of(f.severity), f.counts() ? "" : " suppressed", number,
        f.place.file == 0 && f.place.span.line > 0
            ? fmt::format(" data-line=\"{}\"", f.place.span.line)
            : "");
    std::string where = file_of(checked, f.place);
    if (f.place.span.line > 0) where += fmt::format(":{}", f.place.span.line);
    if (f.last.span.line > f.place.span.line) where += fmt::format("-{}", f.last.span.line);
    append(text, "<b>{}</b> {} <small>{} · {}{}</small>", verify::name_of(f.severity),
           escaped(in_unit(headline(f), unit)), escaped(where), f.rule,
           f.suppressed ? " · suppressed"
           : f.accepted ? " · in the baseline"
                        : "");
    if (!line.empty()) append(text, "<code>{}</code>", escaped(line.substr(0, 200)));
    for (const std::string& assumption : f.assumptions)
        append(text, "<small>assumed {}</small>", escaped(in_unit(assumption, unit)));
    if (f.last_motion > 0) append(text, "<small>{}</small>", escaped(in_unit(f.hint, unit)));
    return text + "</div></li>\n";
}

std::string findings_html(const Checked& checked, LengthUnit unit) {
    const auto& findings = checked.verdict.findings;
    if (findings.empty()) return "<h2>Findings</h2>\n<p>Nothing was found.</p>\n";
    std::string text = fmt::format("<h2>Findings ({})</h2>\n<ul>\n", findings.size());
    // Errors first, accepted and suppressed findings last.
    std::vector<std::size_t> order(findings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) {
        return std::pair{findings[i].counts(), findings[i].severity};
    });
    for (const std::size_t i : order)
        text += finding_html(checked, i, unit);
    text += "</ul>\n";
    for (const auto& [rule, more] : checked.verdict.unlisted)
        text += fmt::format("<p>{} more findings of {} are not listed.</p>\n", more, rule);
    return text;
}

std::string doubts_html(const Checked& checked, LengthUnit unit) {
    if (checked.verdict.doubts.empty()) return {};
    std::string text = fmt::format("<h2>Doubts ({})</h2>\n<ul>\n", checked.verdict.doubts.size());
    for (const verify::Doubt& d : checked.verdict.doubts) {
        std::string where = file_of(checked, d.place);
        if (d.place.span.line > 0) where += fmt::format(":{}", d.place.span.line);
        append(
            text,
            "<li><div class=\"finding {}\"{}><b>{}</b> {} <small>{} · {}</small>"
            "<small>fix: {}</small></div></li>\n",
            d.accepted ? "note suppressed" : "warning",
            d.place.file == 0 && d.place.span.line > 0
                ? fmt::format(" role=\"button\" tabindex=\"0\" data-line=\"{}\"", d.place.span.line)
                : "",
            d.accepted ? "accepted" : "doubt", escaped(in_unit(d.message, unit)), escaped(where),
            d.reason, escaped(std::string(verify::find_reason(d.reason)->fix)));
    }
    return text + "</ul>\n";
}

std::string reasons_html(const Checked& checked, LengthUnit unit) {
    return "<section id=\"reasons\">" + findings_html(checked, unit) + doubts_html(checked, unit) +
           "</section>\n";
}

std::string skipped_html(const Checked& checked) {
    std::string text = "<section><h2>Not asked</h2><table>\n";
    for (const verify::Demotion& d : checked.verdict.demotions)
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", d.rule, escaped(demotion_text(d)));
    for (const verify::Skipped& s : checked.verdict.skipped)
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", s.rule, escaped(s.reason));
    return text + "</table></section>\n";
}

std::string pictures_html(const simulation::PageData& page_data) {
    std::string text =
        "<section><details id=\"pictures\" open><summary><h2>Pictures</h2></summary>\n";
    for (const auto& [name, png] : page_data.pictures) {
        text += fmt::format(
            "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}"
            "</figcaption></figure>\n",
            name, base64(png));
    }
    return text + "</details></section>\n";
}

std::string title_of(const Checked& checked) {
    const std::string program = checked.program.empty() ? "" : " (" + checked.program + ')';
    return relative_path(checked.path) + program;
}

std::string header_html(const Checked& checked, LengthUnit unit) {
    const verify::Verdict& v = checked.verdict;
    const std::string scope = scope_of(checked);
    std::string text = fmt::format(
        "<header class=\"{0}\"><h1>{1}: {0}{8}</h1><p>errors {2}, warnings {3}, notes {4}, "
        "suppressed {5}, doubts {6} · ncsim {7}</p>",
        checked.word, escaped(title_of(checked)), v.count(Severity::Error),
        v.count(Severity::Warning), v.count(Severity::Note), v.suppressed(), v.open_doubts(),
        kVersion, scope.empty() ? "" : fmt::format(" ({})", escaped(scope)));
    if (!checked.failure.empty()) text += "<p>not verified: " + escaped(checked.failure) + "</p>";
    if (!checked.stock.empty())
        text += "<p>stock " + escaped(in_unit(checked.stock, unit)) + "</p>";
    if (!checked.time.empty()) text += "<p>time " + escaped(in_unit(checked.time, unit)) + "</p>";
    if (!checked.not_simulated.empty()) {
        text += "<p>not simulated: " + escaped(checked.not_simulated) + "</p>";
    }
    return text + "</header>\n";
}

}  // namespace

namespace {

// Returns the section in which the script draws the part, and a column with `reasons` and the
// program.
std::string viewer_html(const simulation::PageData& page_data, const std::string& reasons) {
    const bool has_part = !page_data.mesh.triangles.empty() || page_data.play;
    std::string text = has_part ? "<section id=\"part\"><h2>Part</h2><div id=\"view\"></div>"
                                  "<div id=\"controls\"></div>"
                                : "<section id=\"part\" class=\"none\"><h2>Part</h2>"
                                  "<p>The program was not simulated.</p>";
    return text + "<p id=\"picked\" aria-live=\"polite\"></p></section>\n<div id=\"side\">" +
           reasons +
           "<section id=\"program\"><h2>Program</h2><div id=\"source\" tabindex=\"0\" "
           "role=\"region\" aria-label=\"program\"></div></section></div>\n";
}

void write_document(std::ostream& out, const std::string& title, const std::string& body,
                    const Checked& checked, const simulation::PageData* page_data,
                    LengthUnit unit) {
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>"
        << valid_utf8(escaped(title)) << "</title>\n<style>\n"
        << kPageStyle << "</style></head>\n<body>\n"
        << valid_utf8(body);
    if (page_data) {
        out << "<script id=\"data\" type=\"application/json\">"
            << for_script(data_json(checked, *page_data, unit)) << "</script>\n";
        for (const std::string_view script :
             {kPageArrays, kPageRenderer, kPagePaint, kPageMarks, kPageLink, kPageScript})
            out << "<script>\n" << script << "</script>\n";
    }
    out << "</body></html>\n";
}

}  // namespace

void write_page(std::ostream& out, const Checked& checked, LengthUnit unit_of_texts) {
    const bool verified = checked.page_data.has_value();
    const LengthUnit unit = verified ? unit_of_texts : LengthUnit::Millimetre;
    std::string body = header_html(checked, unit);
    if (verified) {
        body += "<main>\n" + viewer_html(*checked.page_data, reasons_html(checked, unit));
        body += ledger_html(checked, unit);
        if (!checked.page_data->pictures.empty()) body += pictures_html(*checked.page_data);
        body += skipped_html(checked) + "</main>\n";
    }
    write_document(out, title_of(checked) + " · ncsim check", body, checked,
                   verified ? &*checked.page_data : nullptr, unit);
}

void write_run_page(std::ostream& out, const std::string& path, const std::string& summary,
                    const simulation::PageData& page_data, LengthUnit unit) {
    Checked checked;
    checked.path = path;
    std::string body = fmt::format("<header class=\"run\"><h1>{}</h1><p>ncsim {}</p></header>\n",
                                   escaped(title_of(checked)), kVersion);
    body += "<main>\n" + viewer_html(page_data, {});
    body += "<section><h2>Summary</h2><pre>" + escaped(summary) + "</pre></section>\n</main>\n";
    write_document(out, title_of(checked) + " · ncsim run", body, checked, &page_data, unit);
}

}  // namespace ncsim::report
