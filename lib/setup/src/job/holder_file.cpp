// SPDX-License-Identifier: GPL-3.0-or-later
//
// Holder files, and completion of tools from these files.
#include "job/holder_file.h"

#include "files/toml_reader.h"
#include "files/tool_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace ncsim::setup {

std::vector<toolpath::ToolSpec> read_holder_file(const std::string& path, InputSet& inputs) {
    const TomlReader r(name_of_input(path), inputs.read(path, kMostSetUpBytes));
    std::map<std::string, std::vector<toolpath::ToolSegment>> holders;
    const auto read_holder = [&](const toml::node& node, const std::string& where) {
        std::string name;
        std::vector<toolpath::ToolSegment> segments;
        r.each(r.table(node, where), where,
               {{"name", [&](const auto& n, const auto& k) { name = r.text(n, k); }},
                {"segments",
                 [&](const auto& n, const auto& k) { segments = read_segments(r, n, k); }}});
        if (name.empty() || segments.empty()) r.fail(node, "a holder has a name and segments");
        if (!holders.emplace(name, std::move(segments)).second)
            r.fail(node, fmt::format("the holder '{}' is described twice", name));
    };
    std::vector<toolpath::ToolSpec> tools;
    const auto read_tool = [&](const toml::node& node, const std::string& where) {
        toolpath::ToolSpec spec;
        r.each(r.table(node, where), where,
               {{"number",
                 [&](const auto& n, const auto& k) {
                     spec.number = static_cast<int>(r.integer(n, k, 0, kMostTools));
                 }},
                {"holder",
                 [&](const auto& n, const auto& k) {
                     const auto found = holders.find(r.text(n, k));
                     if (found == holders.end()) {
                         r.fail(n, fmt::format("'{}': no [[holder]] above has this name", k));
                     }
                     spec.holder = found->second;
                 }},
                {"stick_out",
                 [&](const auto& n, const auto& k) { spec.stick_out = r.positive(n, k); }},
                {"flutes", [&](const auto& n, const auto& k) { spec.length = r.positive(n, k); }},
                {"shank",
                 [&](const auto& n, const auto& k) { spec.shank_diameter = r.positive(n, k); }},
                {"neck", [&](const toml::node& n, const std::string& k) {
                     const toml::array& neck = r.list(n, k, 2);
                     spec.neck_diameter = r.positive(neck[0], k);
                     spec.neck_length = r.positive(neck[1], k);
                 }}});
        if (!node.as_table()->contains("number")) r.fail(node, "a tool has a number");
        const auto same = [&](const auto& t) { return t.number == spec.number; };
        if (std::ranges::any_of(tools, same))
            r.fail(node, fmt::format("tool {} is described twice", spec.number));
        tools.push_back(std::move(spec));
    };
    // Holders are read first, wherever they are in the file.
    if (const toml::node* node = r.root().get("holder")) r.each_of(*node, "holder", read_holder);
    r.each(r.root(), "",
           {{"holder", [](const auto&, const auto&) {}},
            {"tool", [&](const auto& n, const auto& k) { r.each_of(n, k, read_tool); }}});
    return tools;
}

void complete_assembly(toolpath::ToolSpec& spec, const toolpath::ToolSpec& more) {
    const auto take = [](std::optional<double>& into, const std::optional<double>& from) {
        if (!into) into = from;
    };
    take(spec.length, more.length);
    take(spec.stick_out, more.stick_out);
    if (spec.shaft.empty()) {
        if (!spec.neck_diameter) {
            spec.neck_diameter = more.neck_diameter;
            spec.neck_length = more.neck_length;
        }
        take(spec.shank_diameter, more.shank_diameter);
    }
    if (spec.holder.empty()) spec.holder = more.holder;
}

}  // namespace ncsim::setup
