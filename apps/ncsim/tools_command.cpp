// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools_command.h"

#include "findings.h"
#include "job.h"
#include "output.h"
#include "save_job.h"
#include "sheet.h"
#include "survey.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

namespace ncsim::app {

namespace {

using Json = nlohmann::ordered_json;

// How far a tool moves; null if it does not.
const Distances* distances_of(const Survey& survey, int number) {
    const auto found = survey.distances.find(number);
    if (found == survey.distances.end()) return nullptr;
    const Distances& d = found->second;
    return d.rapid_mm > 0.0 || d.feed_mm > 0.0 ? &d : nullptr;
}

// The numbers of all tools that move or are described, in order.
std::set<int> numbers_of(const Job& job, const Survey& survey) {
    std::set<int> numbers;
    for (const auto& [number, distances] : survey.distances) {
        if (distances_of(survey, number)) numbers.insert(number);
    }
    for (const auto& [number, used] : survey.tools)
        numbers.insert(number);
    for (const auto& [number, first] : survey.unknown_tools)
        numbers.insert(number);
    for (const toolpath::ToolEntry& entry : job.tools)
        numbers.insert(entry.spec.number);
    return numbers;
}

// A tool as it is used, else as it is described; with a length that nobody told left open.
std::string shape_of(const Job& job, const Survey& survey, int number) {
    const auto used = survey.tools.find(number);
    if (used != survey.tools.end()) return toolpath::describe(used->second.tool);
    const toolpath::ToolEntry* entry = toolpath::find_tool(job.tools, number);
    if (!entry) return survey.unknown_tools.contains(number) ? "not described" : "only positioned";
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
    ToolSheet(const Job& job, const Survey& survey) : job_(job), survey_(survey) {}

    std::string text() {
        for (const int number : numbers_of(job_, survey_))
            add_tool(number);
        if (text_.empty()) add("no tool", "none is called, and none is described");
        if (survey_.stock) {
            const toolpath::StockEntry& stock = *survey_.stock;
            add("stock", describe(stock.box));
            add("  told", told(stock.told_by, stock.span, stock.text, stock.file, "--stock"));
        } else {
            add("stock", "not told");
        }
        return std::move(text_);
    }

private:
    void add(const std::string& key, const std::string& what) {
        fmt::format_to(std::back_inserter(text_), "{:<10}{}\n", key, what);
    }

    void add_tool(int number) {
        add(number == 0 ? "no T" : fmt::format("T{}", number), shape_of(job_, survey_, number));
        const auto used = survey_.tools.find(number);
        if (used != survey_.tools.end()) {
            const UsedTool& tool = used->second;
            add("  told", told(tool.told_by, tool.span, tool.text, tool.file, "--tool"));
            if (!tool.filled_in.empty()) add("  assumed", tool.filled_in);
        } else if (const auto* entry = toolpath::find_tool(job_.tools, number)) {
            add("  told", told(entry->told_by, entry->span, entry->text, entry->file, "--tool"));
        }
        const Distances* distances = distances_of(survey_, number);
        if (!distances) {
            add("  used", survey_.unknown_tools.contains(number) ? "yes" : "no");
        } else {
            const auto unknown = survey_.unknown_tools.find(number);
            const std::uint32_t line = used != survey_.tools.end() ? used->second.first.line
                                       : unknown != survey_.unknown_tools.end()
                                           ? unknown->second.line
                                           : 0;
            const std::string from = line > 0 ? fmt::format("from line {}, ", line) : "";
            add("  used", fmt::format("{}{:.1f} mm cutting, {:.1f} mm in rapid moves", from,
                                      distances->feed_mm, distances->rapid_mm));
        }
    }

    const Job& job_;
    const Survey& survey_;
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

Json told_json(toolpath::ToldBy by, gcode::SourceSpan span, const std::string& file,
               const std::string& text) {
    Json json{{"by", name_of(by)}};
    if (!file.empty()) json["file"] = file;
    if (span.line > 0) json["line"] = span.line;
    if (!text.empty()) json["text"] = text;
    return json;
}

std::string sheet_json(const Job& job, const Survey& survey) {
    const auto tidy = [](double mm) { return std::round(mm * 1e6) / 1e6 + 0.0; };
    Json tools = Json::array();
    for (const int number : numbers_of(job, survey)) {
        Json tool{{"number", number}};
        const auto used = survey.tools.find(number);
        const auto* entry = toolpath::find_tool(job.tools, number);
        const Distances* distances = distances_of(survey, number);
        tool["described"] = used != survey.tools.end() || entry != nullptr;
        tool["used"] = distances != nullptr || survey.unknown_tools.contains(number);
        if (used != survey.tools.end()) {
            const UsedTool& u = used->second;
            add_spec(tool, u.spec);
            tool["told"] = told_json(u.told_by, u.span, u.file, u.text);
            tool["assumed"] = u.filled_in;
            tool["first_line"] = u.first.line;
        } else if (entry) {
            add_spec(tool, entry->spec);
            tool["told"] = told_json(entry->told_by, entry->span, entry->file, entry->text);
        }
        if (distances) {
            tool["feed_mm"] = tidy(distances->feed_mm);
            tool["rapid_mm"] = tidy(distances->rapid_mm);
        }
        tools.push_back(std::move(tool));
    }
    Json json{{"program", base_name(job.program.name)}, {"tools", std::move(tools)}};
    if (survey.stock) {
        const toolpath::StockEntry& stock = *survey.stock;
        const cda::Box& box = stock.box;
        json["stock"] = {{"min", {box.min.x, box.min.y, box.min.z}},
                         {"max", {box.max.x, box.max.y, box.max.z}},
                         {"told", told_json(stock.told_by, stock.span, stock.file, stock.text)}};
    }
    json["findings"] = findings_json(survey.diagnostics);
    return to_text(json);
}

}  // namespace

CLI::App* add_tools(CLI::App& app, ToolsOptions& options) {
    CLI::App* tools =
        app.add_subcommand("tools", "List the tools of a program: shape, source, use, conflicts");
    add_program_options(*tools, options);
    add_setup_options(*tools, options);
    tools->add_flag("--json", options.json, "As JSON");
    return tools;
}

int run(const ToolsOptions& options) {
    Options all;
    static_cast<ProgramOptions&>(all) = options;
    InputSet inputs;
    OutputSet outputs(inputs);
    if (options.json) outputs.claim_standard_output("--json");
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    Job job = read_job(std::move(all), inputs);
    outputs.reserve(options.save_job);
    const Survey survey = app::survey(job);
    if (options.json) {
        put_out(sheet_json(job, survey));
    } else {
        put_text(ToolSheet(job, survey).text(), outputs.takes_standard_output());
    }
    print_findings(job.program, survey.diagnostics);
    outputs.write(options.save_job,
                  [&](std::ostream& out) { save_job(out, job, survey, options.save_job); });
    outputs.commit();
    return gcode::has_errors(survey.diagnostics) ? kFindings : kClean;
}

}  // namespace ncsim::app
