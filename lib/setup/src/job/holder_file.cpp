// SPDX-License-Identifier: GPL-3.0-or-later
//
// Holder files, and completion of tools from holder files.
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
    const TomlTable root(r.root(), "");
    std::map<std::string, std::vector<toolpath::ToolSegment>> holders;
    // Holders are read first, whatever the order in the file.
    root.each("holder", [&](const TomlTable& t) {
        std::string name;
        t.read("name", name);
        std::vector<toolpath::ToolSegment> segments = read_segments(r, t, "segments");
        if (name.empty() || segments.empty()) r.fail(t.node(), "a holder has a name and segments");
        if (!holders.emplace(name, std::move(segments)).second)
            r.fail(t.node(), fmt::format("the holder '{}' is described twice", name));
    });
    std::vector<toolpath::ToolSpec> tools;
    root.each("tool", [&](const TomlTable& t) {
        toolpath::ToolSpec spec;
        if (const toml::node* const holder = t["holder"]) {
            const auto found = holders.find(TomlReader::text(*holder));
            if (found == holders.end()) {
                r.fail(*holder,
                       fmt::format("'{}': no [[holder]] above has this name", t.name_of("holder")));
            }
            spec.holder = found->second;
        }
        if (const toml::node* const neck = t["neck"]) {
            spec.neck_diameter = TomlReader::number(TomlReader::list(*neck)[0]);
            spec.neck_length = TomlReader::number(TomlReader::list(*neck)[1]);
        }
        t.read("number", spec.number);
        t.read("stick_out", spec.stick_out);
        t.read("flutes", spec.length);
        t.read("shank", spec.shank_diameter);
        if (!t["number"]) r.fail(t.node(), "a tool has a number");
        if (std::ranges::find(tools, spec.number, &toolpath::ToolSpec::number) != tools.end())
            r.fail(t.node(), fmt::format("tool {} is described twice", spec.number));
        tools.push_back(std::move(spec));
    });
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
