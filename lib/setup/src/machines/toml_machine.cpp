// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads machine files in TOML.
#include "machines/toml_machine.h"

#include "ncsim/setup/coordinate_systems.h"

#include "files/schema.h"
#include "files/toml_reader.h"
#include "machines/fixture_reader.h"
#include "machines/kinematics_reader.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace ncsim::setup {

namespace {

using verify::MachineDescription;

constexpr int kG54 = 1;

void read_tool_limits(const TomlReader& r, const TomlTable& t,
                      std::map<int, verify::ToolFacts>& tools) {
    verify::ToolFacts facts;
    t.read("max_feed", facts.max_feed);
    t.read("max_speed", facts.max_rpm);
    t.read("max_depth", facts.max_depth);
    t.read("max_engagement", facts.max_engagement);
    t.read("max_removal_rate", facts.max_removal_rate);
    t.read("max_ramp", facts.max_ramp);
    t.read("blind_diameter", facts.blind_diameter);
    t.read("left_handed", facts.left_hand);
    std::optional<int> number;
    t.read("number", number);
    if (!number) r.fail(t.node(), "a tool needs its number");
    if (!tools.emplace(*number, std::move(facts)).second)
        r.fail(t.node(), fmt::format("tool {} is described twice", *number));
}

// Names with their places in the file.
using NamesAt = std::vector<std::pair<const toml::node*, std::string>>;

// Reads [["table", "column"], …].
std::vector<verify::NamePair> read_pairs(const TomlTable& t, const char* key, NamesAt& names) {
    std::vector<verify::NamePair> pairs;
    if (!t[key]) return pairs;
    for (const toml::node& element : TomlReader::list(*t[key])) {
        const toml::array& two = TomlReader::list(element);
        pairs.emplace_back(TomlReader::text(two[0]), TomlReader::text(two[1]));
        names.emplace_back(&two[0], pairs.back().first);
        names.emplace_back(&two[1], pairs.back().second);
    }
    return pairs;
}

// Checks names of pairs: an unknown name would have no effect, and an ambiguous name would affect
// more than intended.
void check_names(const TomlReader& r, const NamesAt& names, const MachineFile& file) {
    std::map<std::string, int> count{{"tool", 1}, {"part", 1}};
    for (const auto* links : {&file.bodies, &file.other_links}) {
        for (const MachineBody& link : *links)
            ++count[link.link];
    }
    // Fixtures may share a name.
    std::set<std::string> fixtures;
    for (const verify::Fixture& fixture : file.machine.fixtures) {
        if (fixtures.insert(fixture.name).second) ++count[fixture.name];
    }
    for (const auto& [node, name] : names) {
        const auto found = count.find(name);
        if (found == count.end())
            r.fail(*node, fmt::format("there is no link or fixture '{}'", name));
        if (found->second > 1)
            r.fail(*node, fmt::format("'{}' is the name of a link, and of something else", name));
    }
}

}  // namespace

MachineFile read_toml_machine(const std::string& path, InputSet& inputs) {
    MachineFile file;
    MachineDescription& m = file.machine;
    const TomlReader r(name_of_input(path), inputs.read(path, kMostSetUpBytes), kMachineSchema);
    const std::string folder = std::filesystem::path(path).parent_path().string();
    const TomlTable root(r.root(), "");
    KinematicsReader(r, folder, inputs, file).read(root);
    NamesAt named;
    file.checked_neighbours = read_pairs(root, "ask", named);
    file.ignored = read_pairs(root, "ignore", named);
    m.fixtures_specified = root["fixture"] != nullptr;
    root.each("fixture",
              [&](const TomlTable& t) { read_fixture(r, folder, inputs, t, m.fixtures); });
    check_names(r, named, file);
    root.read("name", m.name);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string axis(1, "xyz"[i]);
        root.table("acceleration").read(axis, m.acceleration[i]);
        root.table("rapid").read(axis, m.rapid[i]);
    }
    const TomlTable spindle = root.table("spindle");
    spindle.read("min", m.min_rpm);
    spindle.read("max", m.max_rpm);
    root.table("feed").read("max", m.max_feed);
    file.offsets = read_offsets(r, root);
    const TomlTable position = root.table("position");
    position.read("home", m.home);
    position.read("tool_change", m.tool_change);
    position.read("start", file.start);
    if (position["work_zero"]) position.read("work_zero", file.offsets[kG54]);
    root.read("below_stock", m.below_stock);
    root.read("path_deviation", m.path_deviation);
    const TomlTable time = root.table("time");
    time.read("tool_change", m.tool_change_seconds);
    time.read("junction_deviation", m.junction_deviation);
    root.each("tool", [&](const TomlTable& t) { read_tool_limits(r, t, file.tools); });
    return file;
}

}  // namespace ncsim::setup
