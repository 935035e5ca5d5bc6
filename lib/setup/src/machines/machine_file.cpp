// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads machine files in TOML.
#include "ncsim/setup/machine_file.h"

#include "ncsim/setup/coordinate_systems.h"

#include "files/schema.h"
#include "files/toml_reader.h"
#include "machines/fixture_reader.h"
#include "machines/kinematics_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace ncsim::setup {

namespace {

using verify::AxisRange;
using verify::MachineDescription;

constexpr int kG54 = 1;

// Reads x, y and z.
TomlReader::Take into_axes(std::array<std::optional<double>, 3>& values) {
    return [&values](const toml::node& node, const std::string& key) {
        TomlReader::each(TomlReader::table(node), key,
                         {{"x", into(values[0])}, {"y", into(values[1])}, {"z", into(values[2])}});
    };
}

TomlReader::Take into_travels(std::array<std::optional<AxisRange>, 3>& travels,
                              KinematicsReader& kinematics) {
    return [&](const toml::node& node, const std::string& key) {
        TomlReader::Keys keys;
        for (std::size_t i = 0; i < 3; ++i) {
            keys[std::string(1, "xyz"[i])] = [&, i](const toml::node& n, const std::string& k) {
                const machine::Travel travel = kinematics.travel(n, k);
                travels[i] = AxisRange{travel.min, travel.max};
            };
            keys[std::string(1, "abc"[i])] = [&, i](const auto& n, const auto& k) {
                kinematics.take_travel("ABC"[i], n, k);
            };
        }
        TomlReader::each(TomlReader::table(node), key, keys);
    };
}

void read_tool_limits(const TomlReader& r, const toml::node& node, const std::string& key,
                      std::map<int, verify::ToolFacts>& tools) {
    verify::ToolFacts facts;
    constexpr int kNone = -1;
    int number = kNone;
    TomlReader::each(TomlReader::table(node), key,
                     {{"number", into(number)},
                      {"max_feed", into(facts.max_feed)},
                      {"max_speed", into(facts.max_rpm)},
                      {"max_depth", into(facts.max_depth)},
                      {"max_engagement", into(facts.max_engagement)},
                      {"max_removal_rate", into(facts.max_removal_rate)},
                      {"max_ramp", into(facts.max_ramp)},
                      {"blind_diameter", into(facts.blind_diameter)},
                      {"left_handed", into(facts.left_hand)}});
    if (number == kNone) r.fail(node, "a tool needs its number");
    if (!tools.emplace(number, std::move(facts)).second) {
        r.fail(node, fmt::format("tool {} is described twice", number));
    }
}

// Names with their places in the file.
using NamesAt = std::vector<std::pair<const toml::node*, std::string>>;

// Reads [["table", "column"], …].
TomlReader::Take into_pairs(std::vector<verify::NamePair>& pairs, NamesAt& names) {
    return [&](const toml::node& node, const std::string&) {
        for (const toml::node& element : TomlReader::list(node)) {
            const toml::array& two = TomlReader::list(element);
            pairs.emplace_back(TomlReader::text(two[0]), TomlReader::text(two[1]));
            names.emplace_back(&two[0], pairs.back().first);
            names.emplace_back(&two[1], pairs.back().second);
        }
    };
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

MachineFile read_machine_file(const std::string& path, InputSet& inputs) {
    MachineFile file;
    MachineDescription& m = file.machine;
    const TomlReader r(name_of_input(path), inputs.read(path, kMostSetUpBytes), kMachineSchema);
    const std::string folder = std::filesystem::path(path).parent_path().string();
    KinematicsReader kinematics(r, folder, inputs);
    NamesAt named;
    // Reads a table with these keys.
    const auto table = [](TomlReader::Keys keys) -> TomlReader::Take {
        return [keys = std::move(keys)](const toml::node& n, const std::string& k) {
            TomlReader::each(TomlReader::table(n), k, keys);
        };
    };
    // Passes a value to a function of `kinematics`.
    const auto kinematic = [&kinematics](auto take) -> TomlReader::Take {
        return [&kinematics, take](const auto& n, const auto& k) { (kinematics.*take)(n, k); };
    };
    using K = KinematicsReader;
    TomlReader::each(
        r.root(), "",
        {{"preset", kinematic(&K::take_preset)},
         {"pivot", kinematic(&K::take_pivots)},
         {"control", kinematic(&K::take_control)},
         {"assumed", kinematic(&K::take_assumed)},
         {"along_tool", kinematic(&K::take_along_tool)},
         {"way", kinematic(&K::take_ways)},
         {"clamps", kinematic(&K::take_clamps)},
         {"part", kinematic(&K::take_part)},
         {"ignore", into_pairs(file.ignored, named)},
         {"ask", into_pairs(file.checked_neighbours, named)},
         {"link", tables(kinematic(&K::take_link))},
         {"name", into(m.name)},
         {"travel", into_travels(m.travel, kinematics)},
         {"rapid", into_axes(m.rapid)},
         {"acceleration", into_axes(m.acceleration)},
         {"spindle", table({{"link", kinematic(&K::take_spindle_link)},
                            {"min", into(m.min_rpm)},
                            {"max", into(m.max_rpm)}})},
         {"feed", table({{"max", into(m.max_feed)}})},
         {"position",
          table({{"home", into(m.home)},
                 {"tool_change", into(m.tool_change)},
                 {"start", into(file.start)},
                 {"work_zero", [&](const auto& n,
                                   const auto&) { file.offsets[kG54] = TomlReader::vector(n); }}})},
         {"offsets", [&](const auto& n, const auto&) { file.offsets.merge(read_offsets(r, n)); }},
         {"below_stock", into(m.below_stock)},
         {"path_deviation", into(m.path_deviation)},
         {"time", table({{"tool_change", into(m.tool_change_seconds)},
                         {"junction_deviation", into(m.junction_deviation)}})},
         {"fixture",
          [&](const toml::node& n, const std::string& k) {
              m.fixtures_specified = true;
              TomlReader::each_of(n, k, [&](const toml::node& element, const std::string& key) {
                  read_fixture(r, folder, inputs, element, key, m.fixtures);
              });
          }},
         {"tool", tables([&](const toml::node& element, const std::string& key) {
              read_tool_limits(r, element, key, file.tools);
          })}});
    file.kinematics = kinematics.kinematics();
    file.bodies = kinematics.bodies();
    file.other_links = kinematics.other_links();
    file.part_link = kinematics.part_link();
    file.tool_link = kinematics.tool_link();
    file.part_moved_by = kinematics.part_moved_by();
    file.tool_moved_by = kinematics.tool_moved_by();
    check_names(r, named, file);
    file.tip_control = kinematics.tip_control();
    file.fixture_offsets = kinematics.fixture_offsets();
    file.setting_errors = kinematics.setting_errors();
    file.rotary_ways = kinematics.ways();
    file.clamps = kinematics.clamps();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto specified = kinematics.travels().find("XYZ"[i]);
        if (specified != kinematics.travels().end() && !m.travel[i])
            m.travel[i] = AxisRange{specified->second.min, specified->second.max};
    }
    return file;
}

}  // namespace ncsim::setup
