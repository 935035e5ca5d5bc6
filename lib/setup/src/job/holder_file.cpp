// SPDX-License-Identifier: GPL-3.0-or-later
//
// Holder files, and completion of tools from these files.
#include "job/holder_file.h"

#include "files/schema.h"
#include "files/toml_reader.h"
#include "files/tool_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace ncsim::setup {

std::vector<toolpath::ToolSpec> read_holder_file(const std::string& path, InputSet& inputs) {
    const TomlReader r(name_of_input(path), inputs.read(path, kMostSetUpBytes), kHoldersSchema);
    std::map<std::string, std::vector<toolpath::ToolSegment>> holders;
    const auto read_holder = [&](const toml::node& node, const std::string& where) {
        std::string name;
        std::vector<toolpath::ToolSegment> segments;
        TomlReader::each(TomlReader::table(node), where,
                         {{"name", into(name)}, {"segments", [&](const auto& n, const auto& k) {
                                                     segments = read_segments(r, n, k);
                                                 }}});
        if (name.empty() || segments.empty()) r.fail(node, "a holder has a name and segments");
        if (!holders.emplace(name, std::move(segments)).second)
            r.fail(node, fmt::format("the holder '{}' is described twice", name));
    };
    std::vector<toolpath::ToolSpec> tools;
    const auto read_tool = [&](const toml::node& node, const std::string& where) {
        toolpath::ToolSpec spec;
        TomlReader::each(
            TomlReader::table(node), where,
            {{"number", into(spec.number)},
             {"holder",
              [&](const auto& n, const auto& k) {
                  const auto found = holders.find(TomlReader::text(n));
                  if (found == holders.end())
                      r.fail(n, fmt::format("'{}': no [[holder]] above has this name", k));
                  spec.holder = found->second;
              }},
             {"stick_out", into(spec.stick_out)},
             {"flutes", into(spec.length)},
             {"shank", into(spec.shank_diameter)},
             {"neck", [&](const toml::node& n, const std::string&) {
                  const toml::array& neck = TomlReader::list(n);
                  spec.neck_diameter = TomlReader::number(neck[0]);
                  spec.neck_length = TomlReader::number(neck[1]);
              }}});
        if (!node.as_table()->contains("number")) r.fail(node, "a tool has a number");
        const auto same = [&](const auto& t) { return t.number == spec.number; };
        if (std::ranges::any_of(tools, same))
            r.fail(node, fmt::format("tool {} is described twice", spec.number));
        tools.push_back(std::move(spec));
    };
    // Holders are read first, wherever they are in the file.
    if (const toml::node* node = r.root().get("holder"))
        TomlReader::each_of(*node, "holder", read_holder);
    if (const toml::node* node = r.root().get("tool"))
        TomlReader::each_of(*node, "tool", read_tool);
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
