// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tool sheet as text and JSON.
#include "ncsim/report/tool_sheet.h"

#include "ncsim/base/file_names.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/value_source.h"

#include "append.h"
#include "json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <set>
#include <utility>

namespace ncsim::report {

namespace {

// Returns the distances of a tool; null if the tool does not move.
const verify::Distances* distances_of(const simulation::ProgramFacts& program, int number) {
    const auto found = program.distances.find(number);
    if (found == program.distances.end()) return nullptr;
    const verify::Distances& d = found->second;
    return d.rapid_mm > 0.0 || d.feed_mm > 0.0 ? &d : nullptr;
}

// Returns the numbers of all tools that move or are described, ascending.
std::set<int> numbers_of(const std::vector<toolpath::ToolEntry>& described,
                         const simulation::ProgramFacts& program) {
    std::set<int> numbers;
    for (const auto& [number, distances] : program.distances) {
        if (distances_of(program, number)) numbers.insert(number);
    }
    for (const auto& [number, used] : program.tools)
        numbers.insert(number);
    for (const auto& [number, first] : program.unknown_tools)
        numbers.insert(number);
    for (const toolpath::ToolEntry& entry : described)
        numbers.insert(entry.spec.number);
    return numbers;
}

// Returns the shape of a tool as used, or as described. An unspecified length is omitted.
std::string shape_of(const std::vector<toolpath::ToolEntry>& described,
                     const simulation::ProgramFacts& program, int number) {
    const auto used = program.tools.find(number);
    if (used != program.tools.end()) return toolpath::describe(used->second.tool);
    const toolpath::ToolEntry* entry = toolpath::find_tool(described, number);
    if (!entry) return program.unknown_tools.contains(number) ? "not described" : "only positioned";
    constexpr double kLengthLeftOpen = 50.0;
    const toolpath::Tool tool = toolpath::make_tool(entry->spec, kLengthLeftOpen);
    std::string text = toolpath::describe(tool);
    if (!entry->spec.length && entry->spec.pieces.empty()) {
        const std::size_t length = text.find(" L");
        text.erase(length, text.find(',', length) - length);
    }
    return text;
}

class ToolSheet {
public:
    ToolSheet(const std::vector<toolpath::ToolEntry>& described,
              const simulation::ProgramFacts& program, const Plunges& plunges, LengthUnit unit)
        : described_(described), program_(program), plunges_(plunges), unit_(unit) {}

    std::string text() {
        for (const int number : numbers_of(described_, program_))
            add_tool(number);
        if (text_.empty()) add("no tool", "none is called, and none is described");
        if (program_.stock) {
            const toolpath::StockEntry& stock = *program_.stock;
            add("stock", in_unit(describe(stock.box), unit_));
            add("  source",
                specified(stock.specified_by, stock.span, stock.text, stock.file, "--stock"));
        } else {
            add("stock", "not specified");
        }
        if (plunges_.is_tilted) add_plunges();
        return std::move(text_);
    }

private:
    void add(const std::string& key, const std::string& what) {
        append(text_, "{:<10}{}\n", key, what);
    }

    void add_tool(int number) {
        add(number == 0 ? "no T" : fmt::format("T{}", number),
            tool_in_unit(shape_of(described_, program_, number), unit_));
        const auto used = program_.tools.find(number);
        if (used != program_.tools.end()) {
            const simulation::UsedTool& tool = used->second;
            add("  source",
                specified(tool.specified_by, tool.span, tool.text, tool.file, "--tool"));
            if (!tool.assumed_values_text.empty())
                add("  assumed", in_unit(tool.assumed_values_text, unit_));
        } else if (const auto* entry = toolpath::find_tool(described_, number)) {
            add("  source",
                specified(entry->specified_by, entry->span, entry->text, entry->file, "--tool"));
        }
        const verify::Distances* distances = distances_of(program_, number);
        if (!distances) {
            add("  used", program_.unknown_tools.contains(number) ? "yes" : "no");
        } else {
            const auto unknown = program_.unknown_tools.find(number);
            const std::uint32_t line = used != program_.tools.end() ? used->second.first.line
                                       : unknown != program_.unknown_tools.end()
                                           ? unknown->second.line
                                           : 0;
            const std::string from = line > 0 ? fmt::format("from line {}, ", line) : "";
            add("  used", in_unit(fmt::format("{}{:.1f} mm cutting, {:.1f} mm rapid", from,
                                              distances->feed_mm, distances->rapid_mm),
                                  unit_));
        }
    }

    void add_plunges() {
        if (plunges_.moves == 0) {
            add("plunges", "none at tilted angles: no move decides what X, Y and Z mean");
            return;
        }
        add("plunges", fmt::format("{} at tilted angles, along the tool of some machine or along Z",
                                   plunges_.moves));
        for (const Plunges::Tip& tip : plunges_.tip) {
            add("  tip",
                fmt::format("{} along the tool of {}", tip.moves, fmt::join(tip.machines, ", ")));
        }
        add("  axes", fmt::format("{} along Z", plunges_.along_z));
    }

    const std::vector<toolpath::ToolEntry>& described_;
    const simulation::ProgramFacts& program_;
    const Plunges& plunges_;
    LengthUnit unit_;
    std::string text_;
};

void add_spec(Json& json, const toolpath::ToolSpec& spec) {
    const auto add = [&json](const char* key, const std::optional<double>& value) {
        if (value) json[key] = *value;
    };
    if (spec.kind) json["kind"] = std::string(toolpath::name_of(*spec.kind));
    add("diameter_mm", spec.diameter);
    add("corner_radius_mm", spec.corner_radius);
    add("tip_diameter_mm", spec.tip_diameter);
    add("angle_deg", spec.angle);
    add("taper_deg", spec.taper);
    add("length_mm", spec.length);
    add("shank_diameter_mm", spec.shank_diameter);
}

Json source_json(toolpath::ValueSource by, gcode::SourceSpan span, const std::string& file,
                 const std::string& text) {
    Json json{{"by", name_of(by)}};
    if (!file.empty()) json["file"] = file;
    if (span.line > 0) json["line"] = span.line;
    if (!text.empty()) json["text"] = text;
    return json;
}

}  // namespace

std::string tool_sheet(const simulation::ProgramFacts& program,
                       const std::vector<toolpath::ToolEntry>& described, const Plunges& plunges,
                       LengthUnit unit) {
    return ToolSheet(described, program, plunges, unit).text();
}

std::string tool_sheet_json(const std::string& name, const std::string& set_up,
                            const simulation::ProgramFacts& program,
                            const std::vector<toolpath::ToolEntry>& described,
                            const Plunges& plunges) {
    Json tools = Json::array();
    for (const int number : numbers_of(described, program)) {
        Json tool{{"number", number}};
        const auto used = program.tools.find(number);
        const auto* entry = toolpath::find_tool(described, number);
        const verify::Distances* distances = distances_of(program, number);
        tool["described"] = used != program.tools.end() || entry != nullptr;
        tool["used"] = distances != nullptr || program.unknown_tools.contains(number);
        if (used != program.tools.end()) {
            const simulation::UsedTool& u = used->second;
            add_spec(tool, u.spec);
            tool["source"] = source_json(u.specified_by, u.span, u.file, u.text);
            tool["assumed"] = u.assumed_values_text;
            tool["first_line"] = u.first.line;
        } else if (entry) {
            add_spec(tool, entry->spec);
            tool["source"] =
                source_json(entry->specified_by, entry->span, entry->file, entry->text);
        }
        if (distances) {
            tool["feed_mm"] = round_value(distances->feed_mm);
            tool["rapid_mm"] = round_value(distances->rapid_mm);
        }
        tools.push_back(std::move(tool));
    }
    Json json{{"program", base_name(name)}};
    if (!set_up.empty()) json["set_up"] = set_up;
    json["tools"] = std::move(tools);
    if (program.stock) {
        const toolpath::StockEntry& stock = *program.stock;
        const Box& box = stock.box;
        json["stock"] = {
            {"min", {box.min.x, box.min.y, box.min.z}},
            {"max", {box.max.x, box.max.y, box.max.z}},
            {"source", source_json(stock.specified_by, stock.span, stock.file, stock.text)}};
    }
    if (plunges.is_tilted) {
        Json tip = Json::array();
        for (const Plunges::Tip& t : plunges.tip)
            tip.push_back({{"machines", t.machines}, {"moves", t.moves}});
        json["plunges"] = {
            {"moves", plunges.moves}, {"along_z", plunges.along_z}, {"tip", std::move(tip)}};
    }
    json["findings"] = findings_json(program.diagnostics);
    return to_text(json);
}

}  // namespace ncsim::report
