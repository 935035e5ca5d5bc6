// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes machines as text and as machine.toml.
#include "ncsim/setup/machine_text.h"

#include "ncsim/setup/coordinate_systems.h"

#include "files/schema.h"
#include "files/toml_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <ranges>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

using gcode::Coordinates;
using gcode::RotaryWay;

std::string vector(Vec3 v) {
    return fmt::format("[{}, {}, {}]", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

std::string_view name_of(RotaryWay way) {
    switch (way) {
        case RotaryWay::Linear: break;
        case RotaryWay::Shortest: return "shortest";
        case RotaryWay::Sign: return "sign";
        case RotaryWay::Positive: return "positive";
    }
    return "linear";
}

std::string_view name_of(Coordinates coordinates) {
    return coordinates == Coordinates::Tip ? "tip" : "axes";
}

// True for a joint that moves the tip along the tool (U, V, W). Its key is a letter instead of a
// link, because it moves no link.
bool is_along_tool(const machine::Joint& joint) {
    return !joint.turns && joint.letter <= 'W';
}

// Returns the number of rotary joints before the first linear joint. They carry the part; the
// nearest to the part is first.
std::size_t count_of_part(const machine::Chain& chain) {
    const auto straight =
        std::ranges::find_if(chain.joints, [](const machine::Joint& j) { return !j.turns; });
    return static_cast<std::size_t>(straight - chain.joints.begin());
}

TomlValue range(double min, double max) {
    return {min, max};
}

void add_link(TomlSection& machine, const MachineFile& file, const machine::Joint& joint,
              const std::string& parent) {
    TomlSection& link = machine.add("link");
    const std::string letter(1, joint.letter);
    link.set("name", letter);
    link.set_filled("parent", parent);
    link.set("axis", letter);
    link.set(joint.turns ? "turns_about" : "moves_along", toml_value(joint.direction));
    if (!joint.turns) return;
    const setup::SpecifiedKinematics& specified = *file.kinematics;
    if (specified.unspecified_pivots.find(joint.letter) == std::string::npos)
        link.set("through", toml_value(joint.through));
    if (const auto travel = specified.travels.find(joint.letter); travel != specified.travels.end())
        link.set("travel", range(travel->second.min, travel->second.max));
    const RotaryWay way = file.rotary_ways[static_cast<std::size_t>(joint.letter - 'A')];
    if (way != RotaryWay::Linear) link.set("way", name_of(way));
}

// Adds a table with a key for each specified axis.
template <class Values, class Print>
void add_axes(TomlSection& machine, const char* name, const Values& values, const Print& print) {
    if (std::ranges::none_of(values, [](const auto& v) { return v.has_value(); })) return;
    TomlSection& table = machine.table(name);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i]) table.set(std::string(1, "xyz"[i]), print(*values[i]));
}

TomlValue vector_value(const std::array<double, 3>& v) {
    return toml_value({v[0], v[1], v[2]});
}

// Adds offsets of the table to the functions of the control, with a key per number.
void add_table_offsets(TomlValue& control, const std::string& name,
                       const gcode::TableOffsets& offsets) {
    for (const auto& [number, specified] : offsets.by_number) {
        TomlValue& one = control[name + "s"][fmt::format("P{}", number)];
        one["offset"] = vector_value(specified.offset);
        one["at"] = TomlValue::object();
        for (std::size_t i = 0; i < 3; ++i)
            if (specified.at[i] != 0.0) one["at"][std::string(1, "ABC"[i])] = specified.at[i];
        if (specified.turns != std::array<double, 3>{})
            one["turns"] = vector_value(specified.turns);
    }
    if (offsets.moves) control[name + "_moves"] = *offsets.moves;
}

// Describes the offsets of the table that `code` selects.
std::string sheet_of(std::string_view code, const gcode::TableOffsets& offsets) {
    std::string text;
    for (const auto& [number, specified] : offsets.by_number) {
        std::string at;
        for (std::size_t i = 0; i < 3; ++i) {
            if (specified.at[i] != 0.0) at += fmt::format(" {}{:g}", "ABC"[i], specified.at[i]);
        }
        const auto& o = specified.offset;
        const auto& t = specified.turns;
        text += fmt::format("  {} P{}: the zero is {} from that of the system at{}", code, number,
                            vector({o[0], o[1], o[2]}), at.empty() ? " 0" : at);
        if (t != std::array<double, 3>{})
            text += fmt::format(", turned by {} degrees", vector({t[0], t[1], t[2]}));
        text += "\n";
    }
    return text;
}

TomlValue control_value(const MachineFile& file) {
    const gcode::TipControl& tip = file.tip_control;
    TomlValue control;
    for (const auto& [number, mode] : tip.m_codes)
        control["m_codes"][fmt::format("M{}", number)] = name_of(mode);
    for (const Coordinates mode : tip.kinematics)
        control["kinematics"].push_back(name_of(mode));
    if (tip.at_start == Coordinates::Tip) control["at_start"] = "tip";
    if (tip.by_length_word) control["tip_frame"] = "table";
    if (tip.frame_at_zero) control["tip_frame_at"] = "zero";
    if (file.kinematics->prefer == machine::SolutionPreference::EndPositive)
        control["orient"] = "positive";
    if (file.kinematics->prefer == machine::SolutionPreference::EndNegative)
        control["orient"] = "negative";
    add_table_offsets(control, "fixture_offset", file.fixture_offsets);
    add_table_offsets(control, "setting_error", file.setting_errors);
    if (file.setting_errors.axes_take_turns) control["setting_error_turns_axes"] = true;
    return control;
}

TomlValue clamps_value(const MachineFile& file) {
    TomlValue clamps;
    for (const gcode::RotaryClamp& c : file.clamps) {
        clamps[std::string(1, c.letter)] = {fmt::format("M{}", c.clamp),
                                            fmt::format("M{}", c.release)};
    }
    return clamps;
}

TomlValue ways_value(const MachineFile& file) {
    TomlValue ways;
    for (std::size_t i = 0; i < file.rotary_ways.size(); ++i) {
        if (file.rotary_ways[i] != RotaryWay::Linear)
            ways[std::string(1, "ABC"[i])] = name_of(file.rotary_ways[i]);
    }
    return ways;
}

// Adds the links from the bed to the part and to the tool. Returns the link that carries the tool.
std::string add_links(TomlSection& machine, const MachineFile& file) {
    const machine::Chain& chain = file.kinematics->chain;
    const std::size_t of_part = count_of_part(chain);
    machine.add("link").set("name", "bench");
    std::string part, tool;
    for (std::size_t i = of_part; i-- > 0;) {
        add_link(machine, file, chain.joints[i], part);
        part = chain.joints[i].letter;
    }
    for (std::size_t i = of_part; i < chain.joints.size(); ++i) {
        if (is_along_tool(chain.joints[i])) {
            machine.set("along_tool", std::string(1, chain.joints[i].letter));
            continue;
        }
        add_link(machine, file, chain.joints[i], tool);
        tool = chain.joints[i].letter;
    }
    machine.set("part", TomlValue::object({{"link", part.empty() ? "bench" : part}}));
    return tool.empty() ? "bench" : tool;
}

}  // namespace

std::string machine_sheet(const MachineFile& file) {
    std::string text =
        fmt::format("{}\n", file.machine.name.empty() ? "a machine" : file.machine.name);
    if (!file.kinematics) {
        text += "  rotary axes not specified: A, B and C turn about the program zero\n";
    } else {
        text += "  from the part to the tool:\n";
        const std::size_t of_part = count_of_part(file.kinematics->chain);
        std::size_t number = 0;
        for (const machine::Joint& joint : file.kinematics->chain.joints) {
            const bool carries_part = number++ < of_part;
            text += fmt::format("    {}  ", joint.letter);
            if (is_along_tool(joint)) {
                text += "moves the tip along the tool, by X, Y and Z\n";
                continue;
            }
            if (!joint.turns) {
                text += fmt::format("moves along {}", vector(joint.direction));
                const auto& travel =
                    file.machine.travel[static_cast<std::size_t>(joint.letter - 'X')];
                if (travel) text += fmt::format(", {:g} to {:g} mm", travel->min, travel->max);
                text += '\n';
                continue;
            }
            // The axis as seen from the bed.
            const Vec3 about = carries_part ? -joint.direction : joint.direction;
            text +=
                fmt::format("turns the {} about {}", carries_part ? "part" : "tool", vector(about));
            const bool is_unspecified =
                file.kinematics->unspecified_pivots.find(joint.letter) != std::string::npos;
            text += is_unspecified ? ", pivot not specified: through the program zero"
                                   : " through " + vector(joint.through);
            const auto travel = file.kinematics->travels.find(joint.letter);
            if (travel != file.kinematics->travels.end()) {
                text +=
                    fmt::format(", {:g} to {:g} degrees", travel->second.min, travel->second.max);
            }
            const RotaryWay way = file.rotary_ways[static_cast<std::size_t>(joint.letter - 'A')];
            if (way != RotaryWay::Linear) text += fmt::format(", way {}", name_of(way));
            text += '\n';
        }
    }
    if (file.kinematics && !file.kinematics->guess.empty())
        text += fmt::format("  assumed: {}\n", file.kinematics->guess);
    for (const MachineBody& body : file.bodies)
        text += fmt::format("  link {}: {} triangles\n", body.link, body.mesh.triangles.size());
    for (const auto& [number, mode] : file.tip_control.m_codes)
        text += fmt::format("  M{}: X Y Z are the {}\n", number,
                            mode == Coordinates::Tip ? "tip" : "axes");
    if (file.tip_control.at_start == Coordinates::Tip) text += "  at the start X Y Z are the tip\n";
    if (file.tip_control.by_length_word) text += "  G43.4: X Y Z are the tip\n";
    text += sheet_of("G54.2", file.fixture_offsets) + sheet_of("G54.4", file.setting_errors);
    for (const gcode::RotaryClamp& clamp : file.clamps)
        text += fmt::format("  M{} holds {}, M{} lets it go\n", clamp.clamp, clamp.letter,
                            clamp.release);
    for (const auto& [system, origin] : file.offsets)
        text += fmt::format("  {} at {}\n", name_of_system(system), vector(origin));
    return text;
}

std::string not_in_machine_toml(const MachineFile& file) {
    std::vector<std::string> lost;
    const std::size_t fixtures = file.machine.fixtures.size();
    if (fixtures > 0)
        lost.push_back(fmt::format("{} fixture{}", fixtures, fixtures == 1 ? "" : "s"));
    if (!file.bodies.empty()) lost.emplace_back("meshes of links");
    if (!file.ignored.empty() || !file.checked_neighbours.empty())
        lost.emplace_back("which links are asked");
    if (!file.tools.empty()) lost.emplace_back("limits of tools");
    return fmt::format("{}", fmt::join(lost, ", "));
}

std::string machine_toml(const MachineFile& file) {
    const verify::MachineDescription& m = file.machine;
    TomlSection machine;
    machine.set_filled("name", m.name);
    if (file.kinematics) machine.set_filled("assumed", file.kinematics->guess);
    if (m.below_stock != 0.0) machine.set("below_stock", m.below_stock);
    if (m.path_deviation) machine.set("path_deviation", *m.path_deviation);
    if (m.fixtures_specified && m.fixtures.empty()) machine.set("fixture", TomlValue::array());
    machine.set_filled("clamps", clamps_value(file));
    const auto add_table = [&machine](
                               const char* name,
                               std::initializer_list<std::pair<const char*, TomlValue>> values) {
        const auto is_set = [](const auto& value) { return !value.second.is_null(); };
        if (std::ranges::none_of(values, is_set)) return;
        TomlSection& table = machine.table(name);
        for (const auto& [key, value] : values)
            table.set_filled(key, value);
    };
    const auto value_of = [](const auto& value) {
        if constexpr (requires { value->x; })
            return value ? toml_value(*value) : TomlValue();
        else
            return value ? TomlValue(*value) : TomlValue();
    };
    TomlValue spindle;
    if (file.kinematics) {
        machine.set_filled("control", control_value(file));
        spindle = add_links(machine, file);
    } else {
        machine.set_filled("way", ways_value(file));
    }
    const auto number = [](double v) { return TomlValue(v); };
    add_axes(machine, "travel", m.travel,
             [](const verify::AxisRange& r) { return range(r.min, r.max); });
    add_axes(machine, "rapid", m.rapid, number);
    add_axes(machine, "acceleration", m.acceleration, number);
    add_table("spindle",
              {{"link", spindle}, {"min", value_of(m.min_rpm)}, {"max", value_of(m.max_rpm)}});
    add_table("feed", {{"max", value_of(m.max_feed)}});
    add_table("position", {{"home", value_of(m.home)},
                           {"tool_change", value_of(m.tool_change)},
                           {"start", value_of(file.start)}});
    std::optional<double> junction;
    if (m.junction_deviation != verify::MachineDescription().junction_deviation)
        junction = m.junction_deviation;
    add_table("time", {{"tool_change", value_of(m.tool_change_seconds)},
                       {"junction_deviation", value_of(junction)}});
    if (!file.offsets.empty()) {
        TomlSection& offsets = machine.table("offsets");
        for (const auto& [system, origin] : file.offsets)
            offsets.set(name_of_system(system), toml_value(origin));
    }
    return toml_text(kMachineSchema, machine, {.blank_lines = false, .decimal_point = false});
}

}  // namespace ncsim::setup
