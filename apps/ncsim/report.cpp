// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include "findings.h"
#include "machining_time.h"
#include "sheet.h"
#include "version.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>

namespace ncsim::app {

namespace {

// Keys in the order in which they are told.
using Json = nlohmann::ordered_json;

// To a millionth: what a length (mm), an area or a volume can mean; the dust of decimal fractions
// in binary is not worth a reader's time.
double tidy(double value) {
    return std::round(value * 1e6) / 1e6 + 0.0;
}

Json to_json(cda::Vec3 v) {
    return Json::array({tidy(v.x), tidy(v.y), tidy(v.z)});
}

Json to_json(const cda::Box& box) {
    if (box.is_empty()) return nullptr;
    return {{"min", to_json(box.min)}, {"max", to_json(box.max)}};
}

Json source(toolpath::ToldBy by, gcode::SourceSpan span, const std::string& text) {
    Json json{{"by", name_of(by)}};
    if (span.line != 0) json["line"] = span.line;
    if (!text.empty()) json["text"] = text;
    return json;
}

// null: a feed is not told.
Json time_json(const Distances& distances) {
    const MachiningTime time = time_of(distances);
    const auto known = [](const std::optional<double>& s) { return s ? Json(tidy(*s)) : Json(); };
    return {{"model", "constant feeds, no acceleration"},
            {"total_seconds", known(time.total())},
            {"feed_seconds", known(time.feed)},
            {"rapid_seconds", tidy(time.rapid)},
            {"rapid_mm_per_min", kAssumedRapid},
            {"tool_changes", distances.tool_changes},
            {"tool_change_seconds", tidy(time.tool_changes)},
            {"dwell_seconds", tidy(time.dwells)}};
}

Json tools_json(const Outcome& o) {
    Json tools = Json::array();
    for (const auto& [number, used] : o.survey.tools) {
        Json tool{{"number", number},
                  {"shape", toolpath::describe(used.tool)},
                  {"diameter_mm", toolpath::cutting_diameter_of(used.tool)},
                  {"length_mm", toolpath::cutting_height_of(used.tool)},
                  {"told", source(used.told_by, used.span, used.text)},
                  {"assumed", used.filled_in}};
        if (const auto d = o.survey.distances.find(number); d != o.survey.distances.end()) {
            tool["rapid_mm"] = tidy(d->second.rapid_mm);
            tool["feed_mm"] = tidy(d->second.feed_mm);
            tool["time"] = time_json(d->second);
        }
        if (o.simulation) {
            const auto removed = o.simulation->removed_by_tool.find(number);
            tool["removed_mm3"] =
                removed == o.simulation->removed_by_tool.end() ? 0.0 : tidy(removed->second);
            const CutterFacts facts = o.simulation->cutters.at(number);
            tool["sides"] = facts.sides;
            tool["error_mm"] = tidy(facts.error_mm);
        }
        tools.push_back(std::move(tool));
    }
    return tools;
}

}  // namespace

std::string volume_text(double mm3) {
    return fmt::format("{:.3f} cm3", mm3 / 1000);
}

std::string summary(const Outcome& o) {
    std::string text;
    auto out = std::back_inserter(text);
    if (o.simulation) {
        const Simulation& s = *o.simulation;
        fmt::format_to(out, "part      {} of {}; {} removed in {} hulls\n",
                       volume_text(s.part_volume), volume_text(s.stock_volume),
                       volume_text(s.stock_volume - s.part_volume), s.hulls);
        for (const auto& [number, used] : o.survey.tools) {
            const auto removed = s.removed_by_tool.find(number);
            fmt::format_to(out, "  T{:<7} {} removed\n", number,
                           volume_text(removed == s.removed_by_tool.end() ? 0.0 : removed->second));
        }
        if (o.boundary) {
            const cda::Box box = cda::bounds(*o.boundary);
            fmt::format_to(out, "extents   {}\n",
                           box.is_empty() ? "nothing is left" : describe(box));
        }
        if (o.simplified) {
            fmt::format_to(out, "simpler   {} faces instead of {}, {:.3g} mm off at most\n",
                           o.simplified->boundary.faces.size(), o.boundary->faces.size(),
                           o.simplified->deviation_mm);
        }
        fmt::format_to(out,
                       "accuracy  {:.3g} mm missed, {:.3g} mm gained by {}arcs and turning tools\n",
                       s.bounds.missed_mm, s.bounds.gained_mm,
                       o.job.options.join_tolerance > 0.0 ? "joined moves, " : "");
    }
    if (o.simulation && o.job.options.at_line)
        fmt::format_to(out, "stopped   after line {}\n", *o.job.options.at_line);
    const Distances distances = o.simulation ? o.simulation->distances : total_distances(o.survey);
    fmt::format_to(out, "path      {:.1f} mm at feed, {:.1f} mm rapid\n", distances.feed_mm,
                   distances.rapid_mm);
    fmt::format_to(out, "time      {}\n", time_line(distances));
    return text;
}

void write_report(std::ostream& out, const Outcome& o) {
    const Distances distances = o.simulation ? o.simulation->distances : total_distances(o.survey);
    const gcode::Interpretation& read = o.survey.interpretation;
    Json json;
    json["ncsim"] = kVersion;
    json["program"] = {{"file", o.job.program.name},
                       {"lines", read.lines},
                       {"moves", o.survey.moves},
                       {"feed_moves", o.survey.feed_moves}};
    json["assumptions"] = {{"units", read.uses_inches ? "inch" : "mm"},
                           {"units_stated", read.units_stated},
                           {"moves_from_unknown_start", o.survey.moves_from_nowhere},
                           {"machine_zero_above_program_zero_mm", kHomeHeight},
                           {"uses_machine_coordinates", o.survey.uses_machine_coordinates}};
    if (o.survey.stock) {
        json["stock"] = to_json(o.survey.stock->box);
        if (const auto& from = o.survey.stock->from) {
            json["stock"]["file"] = base_name(from->path);
            if (!from->turn.empty()) json["stock"]["turned"] = from->turn;
            json["stock"]["moved"] = to_json(from->move);
        }
        json["stock"]["told"] =
            source(o.survey.stock->told_by, o.survey.stock->span, o.survey.stock->text);
    }
    json["simulated"] = o.simulation != nullptr;
    if (o.job.options.at_line) json["at_line"] = *o.job.options.at_line;
    if (o.simulation) {
        const Simulation& s = *o.simulation;
        json["model"] = {{"name", o.job.options.model},
                         {"lattice_unit_mm", s.lattice.unit_mm},
                         {"hulls", s.hulls}};
        json["accuracy_mm"] = {{"chord_tolerance", o.job.options.tolerance},
                               {"tool_tolerance", o.job.options.tool_tolerance},
                               {"missed", tidy(s.bounds.missed_mm)},
                               {"gained", tidy(s.bounds.gained_mm)}};
        json["volume_mm3"] = {{"stock", tidy(s.stock_volume)},
                              {"part", tidy(s.part_volume)},
                              {"removed", tidy(s.stock_volume - s.part_volume)}};
    }
    if (o.boundary) {
        json["part"] = {{"extents", to_json(cda::bounds(*o.boundary))},
                        {"area_mm2", tidy(cda::area(*o.boundary))},
                        {"faces", o.boundary->faces.size()},
                        {"vertices", o.boundary->vertices.size()},
                        {"shells", o.boundary->shells}};
    }
    if (o.simplified) {
        json["simplified"] = {{"tolerance_mm", *o.job.options.simplify},
                              {"deviation_mm", o.simplified->deviation_mm},
                              {"faces", o.simplified->boundary.faces.size()}};
    }
    json["distance_mm"] = {{"rapid", tidy(distances.rapid_mm)}, {"feed", tidy(distances.feed_mm)}};
    if (distances.feed_seconds) json["feed_seconds"] = tidy(*distances.feed_seconds);
    json["time"] = time_json(distances);
    json["tip_extents"] = to_json(o.survey.tip_positions);
    json["tools"] = tools_json(o);
    if (o.simulation && !o.simulation->removed_by_block.empty()) {
        Json blocks = Json::array();
        for (const auto& [place, removed] : o.simulation->removed_by_block) {
            const auto& [file, line] = place;
            Json block{{"line", line}, {"removed_mm3", tidy(removed)}};
            if (file > 0 && file < read.files.size()) block["file"] = read.files[file];
            blocks.push_back(std::move(block));
        }
        json["blocks"] = std::move(blocks);
    }
    json["findings"] = findings_json(o.survey.diagnostics);
    // Bytes of the program that are no UTF-8 become U+FFFD.
    out << to_text(json);
}

}  // namespace ncsim::app
