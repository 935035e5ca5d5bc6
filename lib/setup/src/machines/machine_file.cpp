// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads machine files in TOML.
#include "ncsim/setup/machine_file.h"

#include "ncsim/setup/coordinate_systems.h"

#include "files/toml_reader.h"
#include "files/tool_keys.h"
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

// Reads x, y and z by `read`.
template <class Value, class Read>
void read_axes(const TomlReader& r, const toml::node& node, const std::string& key,
               std::array<std::optional<Value>, 3>& into, const Read& read) {
    TomlReader::Keys keys;
    for (std::size_t i = 0; i < 3; ++i) {
        keys[std::string(1, "xyz"[i])] = [&into, &read, i](const auto& n, const auto& k) {
            into[i] = read(n, k);
        };
    }
    r.each(r.table(node, key), key, keys);
}

void read_travels(const TomlReader& r, const toml::node& node, const std::string& key,
                  std::array<std::optional<AxisRange>, 3>& into, KinematicsReader& kinematics) {
    TomlReader::Keys keys;
    for (std::size_t i = 0; i < 3; ++i) {
        keys[std::string(1, "xyz"[i])] = [&r, &into, i](const toml::node& n, const std::string& k) {
            const toml::array& ends = r.list(n, k, 2);
            into[i] = AxisRange{r.number(ends[0], k), r.number(ends[1], k)};
            if (into[i]->min >= into[i]->max)
                r.fail(n, fmt::format("'{}': the first end must be below the second", k));
        };
        keys[std::string(1, "abc"[i])] = [&kinematics, i](const auto& n, const auto& k) {
            kinematics.take_travel("ABC"[i], n, k);
        };
    }
    r.each(r.table(node, key), key, keys);
}

void read_tool_limits(const TomlReader& r, const toml::node& node, const std::string& key,
                      std::map<int, verify::ToolFacts>& tools) {
    verify::ToolFacts facts;
    std::optional<int> number;
    const auto limit = [&r](std::optional<double>& into) {
        return [&r, &into](const toml::node& n, const std::string& k) { into = r.positive(n, k); };
    };
    r.each(r.table(node, key), key,
           {{"number",
             [&](const toml::node& n, const std::string& k) {
                 number = static_cast<int>(r.integer(n, k, 0, kMostTools));
             }},
            {"max_feed", limit(facts.max_feed)},
            {"max_speed", limit(facts.max_rpm)},
            {"max_depth", limit(facts.max_depth)},
            {"max_engagement", limit(facts.max_engagement)},
            {"max_removal_rate", limit(facts.max_removal_rate)},
            {"max_ramp", limit(facts.max_ramp)},
            {"blind_diameter",
             [&](const auto& n, const auto& k) { facts.blind_diameter = r.not_negative(n, k); }},
            {"left_handed",
             [&](const auto& n, const auto& k) { facts.left_hand = r.yes_or_no(n, k); }}});
    if (!number) r.fail(node, "a tool needs its number");
    if (!tools.emplace(*number, std::move(facts)).second) {
        r.fail(node, fmt::format("tool {} is described twice", *number));
    }
}

// Names with their places in the file.
using NamesAt = std::vector<std::pair<const toml::node*, std::string>>;

// Reads [["table", "column"], …].
std::vector<verify::NamePair> read_pairs(const TomlReader& r, const toml::node& node,
                                         const std::string& key, NamesAt& names) {
    std::vector<verify::NamePair> pairs;
    const toml::array* all = node.as_array();
    if (!all) r.fail(node, fmt::format("'{}': expected a list of pairs, [[\"a\", \"b\"]]", key));
    for (const toml::node& element : *all) {
        const toml::array& two = r.list(element, key, 2);
        pairs.emplace_back(r.text(two[0], key), r.text(two[1], key));
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

MachineFile read_machine_file(const std::string& path, InputSet& inputs) {
    MachineFile file;
    MachineDescription& m = file.machine;
    const TomlReader r(name_of_input(path), inputs.read(path, kMostSetUpBytes));
    const std::string folder = std::filesystem::path(path).parent_path().string();
    const auto positive = [&r](const auto& n, const auto& k) { return r.positive(n, k); };
    const auto point = [&r](std::optional<cda::Vec3>& into) {
        return [&r, &into](const toml::node& n, const std::string& k) { into = r.vector(n, k); };
    };
    KinematicsReader kinematics(r, folder, inputs);
    NamesAt named;
    const auto take_pairs = [&](std::vector<verify::NamePair>& into, const toml::node& n,
                                const std::string& k) { into = read_pairs(r, n, k, named); };
    r.each(
        r.root(), "",
        {{"preset", [&](const auto& n, const auto& k) { kinematics.take_preset(n, k); }},
         {"pivot", [&](const auto& n, const auto& k) { kinematics.take_pivots(n, k); }},
         {"control", [&](const auto& n, const auto& k) { kinematics.take_control(n, k); }},
         {"assumed", [&](const auto& n, const auto& k) { kinematics.take_assumed(n, k); }},
         {"along_tool", [&](const auto& n, const auto& k) { kinematics.take_along_tool(n, k); }},
         {"way", [&](const auto& n, const auto& k) { kinematics.take_ways(n, k); }},
         {"clamps", [&](const auto& n, const auto& k) { kinematics.take_clamps(n, k); }},
         {"part", [&](const auto& n, const auto& k) { kinematics.take_part(n, k); }},
         {"ignore", [&](const auto& n, const auto& k) { take_pairs(file.ignored, n, k); }},
         {"ask", [&](const auto& n, const auto& k) { take_pairs(file.checked_neighbours, n, k); }},
         {"link",
          [&](const toml::node& n, const std::string& k) {
              r.each_of(n, k, [&](const toml::node& element, const std::string& key) {
                  kinematics.take_link(element, key);
              });
          }},
         {"name", [&](const auto& n, const auto& k) { m.name = r.text(n, k); }},
         {"travel", [&](const toml::node& n,
                        const std::string& k) { read_travels(r, n, k, m.travel, kinematics); }},
         {"rapid", [&](const auto& n, const auto& k) { read_axes(r, n, k, m.rapid, positive); }},
         {"acceleration",
          [&](const auto& n, const auto& k) { read_axes(r, n, k, m.acceleration, positive); }},
         {"spindle",
          [&](const toml::node& n, const std::string& k) {
              r.each(r.table(n, k), k,
                     {{"link", [&](const auto& v,
                                   const auto& key) { kinematics.take_spindle_link(v, key); }},
                      {"min",
                       [&](const auto& v, const auto& key) { m.min_rpm = r.not_negative(v, key); }},
                      {"max",
                       [&](const auto& v, const auto& key) { m.max_rpm = r.positive(v, key); }}});
          }},
         {"feed",
          [&](const toml::node& n, const std::string& k) {
              r.each(r.table(n, k), k, {{"max", [&](const auto& v, const auto& key) {
                                             m.max_feed = r.positive(v, key);
                                         }}});
          }},
         {"position",
          [&](const toml::node& n, const std::string& k) {
              r.each(r.table(n, k), k,
                     {{"home", point(m.home)},
                      {"tool_change", point(m.tool_change)},
                      {"start", point(file.start)},
                      {"work_zero", [&](const auto& v, const auto& key) {
                           file.offsets[kG54] = r.vector(v, key);
                       }}});
          }},
         {"offsets", [&](const toml::node& n,
                         const std::string& k) { file.offsets.merge(read_offsets(r, n, k)); }},
         {"below_stock",
          [&](const auto& n, const auto& k) { m.below_stock = r.not_negative(n, k); }},
         {"path_deviation",
          [&](const auto& n, const auto& k) { m.path_deviation = r.positive(n, k); }},
         {"time",
          [&](const toml::node& n, const std::string& k) {
              r.each(r.table(n, k), k,
                     {{"tool_change",
                       [&](const auto& v, const auto& key) {
                           m.tool_change_seconds = r.not_negative(v, key);
                       }},
                      {"junction_deviation", [&](const auto& v, const auto& key) {
                           m.junction_deviation = r.positive(v, key);
                       }}});
          }},
         {"fixture",
          [&](const toml::node& n, const std::string& k) {
              m.fixtures_specified = true;
              r.each_of(n, k, [&](const toml::node& element, const std::string& key) {
                  read_fixture(r, folder, inputs, element, key, m.fixtures);
              });
          }},
         {"tool", [&](const toml::node& n, const std::string& k) {
              r.each_of(n, k, [&](const toml::node& element, const std::string& key) {
                  read_tool_limits(r, element, key, file.tools);
              });
          }}});
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
