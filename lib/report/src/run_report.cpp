// SPDX-License-Identifier: GPL-3.0-or-later
//
// Report at the end of a run.
#include "ncsim/report/run_report.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/value_source.h"
#include "ncsim/verify/machine_description.h"
#include "ncsim/verify/machining_time.h"

#include "append.h"
#include "json.h"
#include "operation_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace ncsim::report {

namespace {

Json source(toolpath::ValueSource by, gcode::SourceSpan span, const std::string& text) {
    Json json{{"by", report::name_of(by)}};
    if (span.line != 0) json["line"] = span.line;
    if (!text.empty()) json["text"] = text;
    return json;
}

// Returns the times; a time is null if a feed is not specified.
Json time_json(const verify::Distances& distances) {
    const verify::MachiningTime time = time_of(distances);
    return {{"model", "constant feeds, no acceleration"},
            {"total_seconds", rounded_json(time.total())},
            {"feed_seconds", rounded_json(time.feed)},
            {"rapid_seconds", round_value(time.rapid)},
            {"rapid_mm_per_min", verify::kAssumedRapid},
            {"tool_changes", distances.tool_changes},
            {"tool_change_seconds", round_value(time.tool_changes)},
            {"dwell_seconds", round_value(time.dwells)}};
}

// Returns the times; a time is null if a rate is not specified.
Json machine_time_json(const verify::Ledger& ledger) {
    return {{"feed_seconds", rounded_json(ledger.feed_seconds)},
            {"rapid_seconds", rounded_json(ledger.rapid_seconds)},
            {"other_seconds", rounded_json(ledger.other_seconds)}};
}

Json tools_json(const RunFacts& run) {
    Json tools = Json::array();
    for (const auto& [number, used] : run.program->tools) {
        Json tool{{"number", number},
                  {"shape", toolpath::describe(used.tool)},
                  {"diameter_mm", toolpath::cutting_diameter_of(used.tool)},
                  {"length_mm", toolpath::cutting_height_of(used.tool)},
                  {"source", source(used.specified_by, used.span, used.text)},
                  {"assumed", used.assumed_values_text}};
        if (const auto d = run.program->distances.find(number); d != run.program->distances.end()) {
            tool["rapid_mm"] = round_value(d->second.rapid_mm);
            tool["feed_mm"] = round_value(d->second.feed_mm);
            tool["time"] = time_json(d->second);
        }
        if (run.part) {
            const auto removed = run.part->removed_by_tool.find(number);
            tool["removed_mm3"] =
                removed == run.part->removed_by_tool.end() ? 0.0 : round_value(removed->second);
            const simulation::CutterFacts facts = run.part->cutters.at(number);
            tool["sides"] = facts.sides;
            tool["error_mm"] = round_value(facts.error_mm);
        }
        tools.push_back(std::move(tool));
    }
    return tools;
}

// Returns the effect of the budget of work on facets that remain; empty if there is none.
std::string budget_text(const SolidFacts& solid) {
    if (solid.cuts_not_tried == 0 && !solid.has_ended_early) return {};
    std::string text = "          to limit the work, ";
    if (solid.has_ended_early) text += "corrections ended early";
    if (solid.has_ended_early && solid.cuts_not_tried > 0) text += " and ";
    if (solid.cuts_not_tried > 0) {
        text += fmt::format("{} finer cut{} not tried", solid.cuts_not_tried,
                            solid.cuts_not_tried == 1 ? " was" : "s were");
    }
    return text + "; --step-refine 6 has no limit\n";
}

// Returns "47 faces: 21 planes, 20 cylinders, 3 tori; edges within 1e-09 mm", and the facets that
// were not recognised.
std::string solid_text(const SolidFacts& solid) {
    std::string text = fmt::format("step      {} face{}", solid.faces, solid.faces == 1 ? "" : "s");
    const char* before = ": ";
    for (const auto& [kind, count] : solid.kinds) {
        if (count == 0) continue;
        const std::string many = kind == "torus" ? "tori" : kind + "s";
        text += fmt::format("{}{} {}", before, count, count == 1 ? kind : many);
        before = ", ";
    }
    // Smaller distances cannot be measured.
    constexpr double kLeast = 1e-9;
    text += fmt::format("; edges within {:.2g} mm\n", std::max(solid.miss_mm, kLeast));
    text += fmt::format("          {} inside the true surfaces; the polyhedron has {}\n",
                        volume_text(solid.volume_mm3), volume_text(solid.polyhedron_mm3));
    if (solid.own_cut) {
        text += fmt::format(
            "          from a cut with round tools within {:g} mm, arcs within {:g} mm, made for "
            "it\n",
            solid.own_cut->tools_mm, solid.own_cut->arcs_mm);
    }
    if (solid.mitred_mm > kLeast) {
        text += fmt::format("          without lunes at bends of balls, up to {:.2g} mm high\n",
                            solid.mitred_mm);
    }
    if (solid.tolerance_factor > 1.0) {
        text += fmt::format(
            "          facets alone are joined within {:g} times the tolerance: finer ones cross "
            "or "
            "touch\n",
            solid.tolerance_factor);
    }
    if (solid.stock_facets > 0) {
        text += fmt::format("          {} of the planes are facets of the mesh of the stock\n",
                            solid.stock_facets);
    }
    const std::size_t of_tools = solid.facets_kept - solid.stock_facets;
    if (of_tools == 0) return text;
    text += fmt::format("          {} of the planes {} of round tools", of_tools,
                        of_tools == 1 ? "is a facet" : "are facets");
    if (solid.facet_miss_mm > kLeast)
        text += fmt::format(", within {:.2g} mm of the adjacent faces", solid.facet_miss_mm);
    constexpr std::size_t kMostLines = 6;
    before = ": line ";
    for (std::size_t i = 0; i < std::min(kMostLines, solid.facet_lines.size()); ++i) {
        text += fmt::format("{}{}", before, solid.facet_lines[i]);
        before = ", ";
    }
    text += solid.facet_lines.size() > kMostLines ? ", …\n" : "\n";
    return text + budget_text(solid);
}

// Returns "section   z=-4: 2 outlines, 4421.46 mm2 of material; 6 lines, 2 arcs".
std::string section_text(const SectionFacts& section) {
    std::string text = fmt::format("section   {}: ", section.plane);
    if (section.outlines == 0) return text + "nothing of the part is there\n";
    text += fmt::format("{} outline{}, {:.6g} mm2 of material", section.outlines,
                        section.outlines == 1 ? "" : "s", section.area_mm2);
    constexpr std::array<const char*, 4> kNames{"line", "arc", "ellipse", "other curve"};
    const char* before = "; ";
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const std::size_t count = section.curves[i];
        if (count == 0) continue;
        text += fmt::format("{}{} {}{}", before, count, kNames[i], count == 1 ? "" : "s");
        before = ", ";
    }
    if (section.is_faceted) {
        text += "\n          of facets: its true surfaces make no closed outlines";
    } else if (section.facets > 0) {
        text += fmt::format("\n          {} of the lines {} of round tools", section.facets,
                            section.facets == 1 ? "is of a facet" : "are of facets");
    }
    if (section.moved_mm != 0.0)
        text += fmt::format("\n          drawn {:g} mm farther to the right", section.moved_mm);
    return text + "\n";
}

std::string thin_text(const cda::ThinPlaces& thin, std::uint32_t line, std::string_view what,
                      double resolution) {
    if (thin.count == 0) return {};
    const std::string made = line == 0 ? "the stock's" : fmt::format("line {}", line);
    return fmt::format(
        "thin      {} thinner than {:.3g} mm on {} rays, {:.3g} mm where thinnest, at X{:.3f} "
        "Y{:.3f} Z{:.3f} ({})\n"
        "          not in the surface on {} of them: {}\n",
        what, resolution, thin.count, thin.thinnest_mm, thin.at.x, thin.at.y, thin.at.z, made,
        thin.missing, volume_text(thin.missing_mm3));
}

std::string aliasing_text(const simulation::AliasingFacts& aliasing, double resolution) {
    std::string text =
        thin_text(aliasing.material, aliasing.material_line, "material", resolution) +
        thin_text(aliasing.gaps, aliasing.gap_line, "gaps", resolution);
    if (aliasing.checks_only_along_z)
        text += "          walls and slots are not looked for along Z alone (--rays xyz)\n";
    return text;
}

Json thin_json(const cda::ThinPlaces& thin, std::uint32_t line) {
    Json json = {{"rays", thin.count},
                 {"missing_rays", thin.missing},
                 {"missing_mm3", round_value(thin.missing_mm3)}};
    if (thin.count > 0) {
        json["thinnest"] = {
            {"mm", round_value(thin.thinnest_mm)}, {"at", vector_json(thin.at)}, {"line", line}};
    }
    return json;
}

Json section_json(const SectionFacts& section) {
    return {{"plane", section.plane},
            {"outlines", section.outlines},
            {"area_mm2", round_value(section.area_mm2)},
            {"length_mm", round_value(section.length_mm)},
            {"lines", section.curves[0]},
            {"arcs", section.curves[1]},
            {"ellipses", section.curves[2]},
            {"other_curves", section.curves[3]},
            {"lines_of_facets", section.is_faceted ? section.curves[0] : section.facets},
            {"is_faceted", section.is_faceted},
            {"drawn_to_the_right_mm", section.moved_mm}};
}

// Returns "  T1       48.088 cm3 removed, 1450.2 mm at feed, 1:52 min". The time is omitted if a
// feed or, on a specified machine, a rate of the axes would decide.
std::string tool_line(const RunFacts& run, int number) {
    const auto& volumes = run.part->removed_by_tool;
    const auto removed = volumes.find(number);
    std::string text = fmt::format("  T{:<7} {} removed", number,
                                   volume_text(removed == volumes.end() ? 0.0 : removed->second));
    const auto& by_tool = run.program->distances;
    const auto used = by_tool.find(number);
    // Distances are those of the whole program.
    if (used == by_tool.end() || run.cutting.at_line) return text + "\n";
    append(text, ", {:.1f} mm at feed", used->second.feed_mm);
    const std::optional<double> seconds = time_of(used->second).total();
    if (seconds && !run.on_machine) append(text, ", {}", verify::time_text(*seconds));
    return text + "\n";
}

// True if the volumes are those of the operations of the survey.
bool has_volumes(const RunFacts& run) {
    return run.part && run.part->removed_by_operation.size() == run.program->operations.size();
}

// Returns a name in quotation marks, so that no number in it counts as a length.
std::string quoted(const std::string& name) {
    std::string text = one_line(name);
    std::ranges::replace(text, '\'', '"');
    return "'" + text + "'";
}

// Returns a line for each operation of a tool that has several, if any has a name.
std::string operation_lines(const RunFacts& run, int tool) {
    std::string text;
    if (run.cutting.at_line) return text;
    const bool has_removed = has_volumes(run);
    for (const OperationRow& row : operation_rows(
             *run.program, has_removed ? run.part->removed_by_operation : std::vector<double>{},
             tool)) {
        const simulation::ProgramFacts::Operation& operation = row.operation;
        append(text, "    {}: ",
               operation.name.empty()
                   ? "without a name"
                   : fmt::format("line {}, {}", operation.line, quoted(operation.name)));
        if (has_removed) append(text, "{} removed, ", volume_text(row.removed_mm3));
        append(text, "{:.1f} mm at feed", operation.distances.feed_mm);
        const std::optional<double> seconds = time_of(operation.distances).total();
        if (seconds && !run.on_machine) append(text, ", {}", verify::time_text(*seconds));
        text += "\n";
    }
    return text;
}

Json operations_json(const RunFacts& run) {
    Json operations = Json::array();
    for (const simulation::ProgramFacts::Operation& operation : run.program->operations) {
        Json json{{"tool", operation.tool}};
        if (!operation.name.empty()) {
            json["name"] = operation.name;
            json["line"] = operation.line;
        }
        json["rapid_mm"] = round_value(operation.distances.rapid_mm);
        json["feed_mm"] = round_value(operation.distances.feed_mm);
        json["time"] = time_json(operation.distances);
        if (has_volumes(run))
            json["removed_mm3"] = round_value(run.part->removed_by_operation[operations.size()]);
        operations.push_back(std::move(json));
    }
    return operations;
}

}  // namespace

std::string summary(const RunFacts& run) {
    std::string text;
    if (run.part) {
        const simulation::PartFacts& s = *run.part;
        append(text, "part      {} of {}; {} removed in {} hulls\n", volume_text(s.part_volume),
               volume_text(s.stock_volume), volume_text(s.stock_volume - s.part_volume), s.hulls);
        if (s.part_volume_error > 0.0) {
            append(text, "          off by at most {}, as the rays show\n",
                   volume_text(s.part_volume_error));
        }
        if (s.aliasing) text += aliasing_text(*s.aliasing, run.cutting.resolution);
        for (const auto& [number, used] : run.program->tools)
            text += tool_line(run, number) + operation_lines(run, number);
        if (run.boundary) {
            const Box box = cda::bounds(*run.boundary);
            append(text, "extents   {}\n", box.is_empty() ? "nothing is left" : describe(box));
        }
        if (run.simplified && run.boundary) {
            append(text, "simpler   {} faces instead of {}, {:.3g} mm off at most\n",
                   run.simplified->faces, run.boundary->faces.size(), run.simplified->deviation_mm);
        }
        if (run.design) append(text, "design    {}\n", text_of(*run.design));
        for (std::size_t i = 0; i < run.design_places.size(); ++i)
            append(text, "          {}  {}\n", i + 1, text_of(run.design_places[i]));
        if (run.solid) text += solid_text(*run.solid);
        for (const SectionFacts& section : run.sections)
            text += section_text(section);
        append(text, "accuracy  {:.3g} mm missed, {:.3g} mm gained by {}arcs and rotary moves\n",
               s.bounds.missed_mm, s.bounds.gained_mm,
               run.cutting.join_tolerance > 0.0 ? "joined moves, " : "");
    }
    if (run.part && run.cutting.at_line)
        append(text, "stopped   after line {}\n", *run.cutting.at_line);
    const verify::Distances distances =
        run.part ? run.part->distances : verify::total(run.program->distances);
    append(text, "path      {:.1f} mm at feed, {:.1f} mm rapid\n", distances.feed_mm,
           distances.rapid_mm);
    const std::string on_machine = run.on_machine ? time_line(*run.on_machine) : "";
    append(text, "time      {}\n", on_machine.empty() ? time_line(distances) : on_machine);
    return in_unit(text, run.cutting.unit);
}

void write_report(std::ostream& out, const RunFacts& run) {
    const verify::Distances distances =
        run.part ? run.part->distances : verify::total(run.program->distances);
    const gcode::Interpretation& read = run.program->interpretation;
    Json json;
    json["ncsim"] = kVersion;
    json["program"] = {{"file", run.name},
                       {"lines", read.lines},
                       {"moves", run.program->moves},
                       {"feed_moves", run.program->feed_moves}};
    json["assumptions"] = {{"units", read.uses_inches ? "inch" : "mm"},
                           {"units_stated", read.units_stated},
                           {"moves_from_unknown_start", run.program->moves_without_start},
                           {"machine_zero_above_program_zero_mm", verify::kHomeHeight},
                           {"uses_machine_coordinates", run.program->uses_machine_coordinates}};
    if (run.program->stock) {
        json["stock"] = box_json(run.program->stock->box);
        if (const auto& from = run.program->stock->from) {
            json["stock"]["file"] = base_name(from->path);
            if (!from->turn.empty()) json["stock"]["turned"] = from->turn;
            json["stock"]["moved"] = vector_json(from->move);
            if (run.program->stock->deflection_mm > 0.0)
                json["stock"]["deflection_mm"] = run.program->stock->deflection_mm;
        }
        json["stock"]["source"] = source(run.program->stock->specified_by, run.program->stock->span,
                                         run.program->stock->text);
    }
    json["simulated"] = run.part != nullptr;
    if (run.cutting.at_line) json["at_line"] = *run.cutting.at_line;
    if (run.part) {
        const simulation::PartFacts& s = *run.part;
        json["model"] = {{"name", run.cutting.model},
                         {"lattice_unit_mm", s.lattice.unit_mm},
                         {"hulls", s.hulls}};
        if (run.cutting.resolution > 0.0) json["model"]["resolution_mm"] = run.cutting.resolution;
        json["accuracy_mm"] = {{"chord_tolerance", run.cutting.tolerance},
                               {"tool_tolerance", run.cutting.tool_tolerance},
                               {"missed", round_value(s.bounds.missed_mm)},
                               {"gained", round_value(s.bounds.gained_mm)}};
        json["volume_mm3"] = {{"stock", round_value(s.stock_volume)},
                              {"part", round_value(s.part_volume)},
                              {"removed", round_value(s.stock_volume - s.part_volume)}};
        if (s.part_volume_error > 0.0)
            json["volume_mm3"]["error"] = round_value(s.part_volume_error);
        if (run.cutting.resolution > 0.0)
            json["model"]["rays"] = run.cutting.has_rays_along_z_alone ? "z" : "xyz";
        if (s.aliasing) {
            json["thinner_than_resolution"] = {
                {"material", thin_json(s.aliasing->material, s.aliasing->material_line)},
                {"gaps", thin_json(s.aliasing->gaps, s.aliasing->gap_line)},
                {"seen_along_z_alone", s.aliasing->checks_only_along_z}};
        }
    }
    if (run.boundary) {
        json["part"] = {{"extents", box_json(cda::bounds(*run.boundary))},
                        {"area_mm2", round_value(cda::area(*run.boundary))},
                        {"faces", run.boundary->faces.size()},
                        {"vertices", run.boundary->vertices.size()},
                        {"shells", run.boundary->shells}};
    }
    if (run.simplified) {
        json["simplified"] = {{"tolerance_mm", run.simplified->tolerance_mm},
                              {"deviation_mm", run.simplified->deviation_mm},
                              {"faces", run.simplified->faces}};
    }
    if (run.solid) {
        Json kinds = Json::object();
        for (const auto& [kind, count] : run.solid->kinds)
            kinds[kind] = count;
        json["step"] = {{"faces", run.solid->faces},
                        {"volume_mm3", round_value(run.solid->volume_mm3)},
                        {"surfaces", std::move(kinds)},
                        {"edges_within_mm", run.solid->miss_mm},
                        {"facets_kept", run.solid->facets_kept},
                        {"facets_of_stock", run.solid->stock_facets},
                        {"facets_within_mm", run.solid->facet_miss_mm},
                        {"lines_of_facets", run.solid->facet_lines},
                        {"left_out_at_bends_mm", run.solid->mitred_mm}};
        if (run.solid->own_cut) {
            json["step"]["refined_to_mm"] = run.solid->own_cut->tools_mm;
            json["step"]["arcs_refined_to_mm"] = run.solid->own_cut->arcs_mm;
        }
        json["step"]["cuts"] = {{"made", run.solid->cuts},
                                {"not_tried", run.solid->cuts_not_tried},
                                {"ended_early", run.solid->has_ended_early}};
        if (run.solid->tolerance_factor > 1.0)
            json["step"]["facets_coarser"] = run.solid->tolerance_factor;
    }
    for (const SectionFacts& section : run.sections)
        json["sections"].push_back(section_json(section));
    json["distance_mm"] = {{"rapid", round_value(distances.rapid_mm)},
                           {"feed", round_value(distances.feed_mm)}};
    if (distances.feed_seconds) json["feed_seconds"] = round_value(*distances.feed_seconds);
    json["time"] = time_json(distances);
    if (run.on_machine) json["time_on_machine"] = machine_time_json(*run.on_machine);
    json["tip_extents"] = box_json(run.program->tip_positions);
    json["tools"] = tools_json(run);
    json["operations"] = operations_json(run);
    if (run.part && !run.part->removed_by_block.empty()) {
        Json blocks = Json::array();
        for (const auto& [place, removed] : run.part->removed_by_block) {
            const auto& [file, line] = place;
            Json block{{"line", line}, {"removed_mm3", round_value(removed)}};
            if (file > 0 && file < read.files.size()) block["file"] = read.files[file];
            blocks.push_back(std::move(block));
        }
        json["blocks"] = std::move(blocks);
    }
    json["findings"] = findings_json(run.program->diagnostics);
    // Bytes of the program that are not UTF-8 become U+FFFD.
    out << to_text(json);
}

}  // namespace ncsim::report
