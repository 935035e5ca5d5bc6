// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes machines as text and as machine.toml.
#include "ncsim/setup/machine_text.h"

#include "ncsim/setup/coordinate_systems.h"

#include "files/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <string_view>
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

void add_link(std::string& text, const MachineFile& file, const machine::Joint& joint,
              std::string_view parent) {
    text += fmt::format("[[link]]\nname = \"{}\"\n", joint.letter);
    if (!parent.empty()) text += fmt::format("parent = \"{}\"\n", parent);
    text += fmt::format("axis = \"{}\"\n{} = {}\n", joint.letter,
                        joint.turns ? "turns_about" : "moves_along", vector(joint.direction));
    if (!joint.turns) return;
    const setup::SpecifiedKinematics& specified = *file.kinematics;
    if (specified.unspecified_pivots.find(joint.letter) == std::string::npos)
        text += fmt::format("through = {}\n", vector(joint.through));
    if (const auto travel = specified.travels.find(joint.letter); travel != specified.travels.end())
        text += fmt::format("travel = [{}, {}]\n", travel->second.min, travel->second.max);
    const RotaryWay way = file.rotary_ways[static_cast<std::size_t>(joint.letter - 'A')];
    if (way != RotaryWay::Linear) text += fmt::format("way = \"{}\"\n", name_of(way));
}

// Adds a line for each specified axis.
template <class Values, class Print>
void add_axes(std::string& text, std::string_view table, const Values& values, const Print& print) {
    if (std::ranges::none_of(values, [](const auto& v) { return v.has_value(); })) return;
    text += fmt::format("[{}]\n", table);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i]) text += fmt::format("{} = {}\n", "xyz"[i], print(*values[i]));
    }
}

// Adds offsets of the table, with a key per number.
void add_table_offsets(std::vector<std::string>& keys, std::string_view name,
                       const gcode::TableOffsets& offsets) {
    std::string all;
    for (const auto& [number, specified] : offsets.by_number) {
        std::string at;
        for (std::size_t i = 0; i < 3; ++i) {
            if (specified.at[i] != 0.0)
                at += fmt::format("{}{} = {}", at.empty() ? " " : ", ", "ABC"[i], specified.at[i]);
        }
        if (!at.empty()) at += " ";
        const auto three = [](const std::array<double, 3>& v) {
            return vector({v[0], v[1], v[2]});
        };
        const std::string turns = specified.turns == std::array<double, 3>{}
                                      ? std::string()
                                      : ", turns = " + three(specified.turns);
        all += fmt::format("{}P{} = {{ offset = {}, at = {{{}}}{} }}", all.empty() ? "" : ", ",
                           number, three(specified.offset), at, turns);
    }
    if (!all.empty()) keys.push_back(fmt::format("{}s = {{ {} }}", name, all));
    if (offsets.moves) keys.push_back(fmt::format("{}_moves = {}", name, *offsets.moves));
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

std::string control_toml(const MachineFile& file) {
    const gcode::TipControl& control = file.tip_control;
    std::vector<std::string> keys;
    std::string codes;
    for (const auto& [number, mode] : control.m_codes)
        codes += fmt::format("{}M{} = \"{}\"", codes.empty() ? "" : ", ", number, name_of(mode));
    if (!codes.empty()) keys.push_back(fmt::format("m_codes = {{ {} }}", codes));
    std::string modes;
    for (const Coordinates mode : control.kinematics)
        modes += fmt::format("{}\"{}\"", modes.empty() ? "" : ", ", name_of(mode));
    if (!modes.empty()) keys.push_back(fmt::format("kinematics = [{}]", modes));
    if (control.at_start == Coordinates::Tip) keys.emplace_back("at_start = \"tip\"");
    if (control.by_length_word) keys.emplace_back("tip_frame = \"table\"");
    if (control.frame_at_zero) keys.emplace_back("tip_frame_at = \"zero\"");
    if (file.kinematics->prefer == machine::SolutionPreference::EndPositive)
        keys.emplace_back("orient = \"positive\"");
    if (file.kinematics->prefer == machine::SolutionPreference::EndNegative)
        keys.emplace_back("orient = \"negative\"");
    add_table_offsets(keys, "fixture_offset", file.fixture_offsets);
    add_table_offsets(keys, "setting_error", file.setting_errors);
    if (file.setting_errors.axes_take_turns) keys.emplace_back("setting_error_turns_axes = true");
    if (keys.empty()) return {};
    return fmt::format("control = {{ {} }}\n", fmt::join(keys, ", "));
}

std::string clamps_toml(const MachineFile& file) {
    if (file.clamps.empty()) return {};
    std::string clamps;
    for (const gcode::RotaryClamp& c : file.clamps) {
        clamps += fmt::format("{}{} = [\"M{}\", \"M{}\"]", clamps.empty() ? "" : ", ", c.letter,
                              c.clamp, c.release);
    }
    return fmt::format("clamps = {{ {} }}\n", clamps);
}

std::string ways_toml(const MachineFile& file) {
    std::string ways;
    for (std::size_t i = 0; i < file.rotary_ways.size(); ++i) {
        if (file.rotary_ways[i] == RotaryWay::Linear) continue;
        ways += fmt::format("{}{} = \"{}\"", ways.empty() ? "" : ", ", "ABC"[i],
                            name_of(file.rotary_ways[i]));
    }
    return ways.empty() ? ways : fmt::format("way = {{ {} }}\n", ways);
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
    // Keys without a table come first: after a [table] they would belong to that table.
    const verify::MachineDescription& m = file.machine;
    std::string text;
    if (!m.name.empty()) text += fmt::format("name = {}\n", quoted(m.name));
    if (file.kinematics && !file.kinematics->guess.empty())
        text += fmt::format("assumed = {}\n", quoted(file.kinematics->guess));
    if (m.below_stock != 0.0) text += fmt::format("below_stock = {}\n", m.below_stock);
    if (m.path_deviation) text += fmt::format("path_deviation = {}\n", *m.path_deviation);
    if (m.fixtures_specified && m.fixtures.empty()) text += "fixture = []\n";
    text += clamps_toml(file);
    std::string spindle, links;
    if (file.kinematics) {
        text += control_toml(file);
        const machine::Chain& chain = file.kinematics->chain;
        const std::size_t of_part = count_of_part(chain);
        links = "[[link]]\nname = \"bench\"\n";
        std::string part = "bench", tool = "bench";
        for (std::size_t i = of_part; i-- > 0;) {
            add_link(links, file, chain.joints[i], part == "bench" ? "" : part);
            part = chain.joints[i].letter;
        }
        for (std::size_t i = of_part; i < chain.joints.size(); ++i) {
            if (is_along_tool(chain.joints[i])) {
                text += fmt::format("along_tool = \"{}\"\n", chain.joints[i].letter);
                continue;
            }
            add_link(links, file, chain.joints[i], tool == "bench" ? "" : tool);
            tool = chain.joints[i].letter;
        }
        text += fmt::format("part = {{ link = \"{}\" }}\n", part);
        spindle = fmt::format("link = \"{}\"\n", tool);
    } else {
        text += ways_toml(file);
    }
    const auto range = [](const verify::AxisRange& r) {
        return fmt::format("[{}, {}]", r.min, r.max);
    };
    const auto number = [](double v) { return fmt::format("{}", v); };
    const auto line = [](const char* key, const auto& value, const auto& print) {
        return value ? fmt::format("{} = {}\n", key, print(*value)) : std::string();
    };
    const auto add_table = [&text](const char* name, const std::string& lines) {
        if (!lines.empty()) text += fmt::format("[{}]\n{}", name, lines);
    };
    add_axes(text, "travel", m.travel, range);
    add_axes(text, "rapid", m.rapid, number);
    add_axes(text, "acceleration", m.acceleration, number);
    add_table("spindle", spindle + line("min", m.min_rpm, number) + line("max", m.max_rpm, number));
    add_table("feed", line("max", m.max_feed, number));
    add_table("position", line("home", m.home, vector) +
                              line("tool_change", m.tool_change, vector) +
                              line("start", file.start, vector));
    std::optional<double> junction;
    if (m.junction_deviation != verify::MachineDescription().junction_deviation)
        junction = m.junction_deviation;
    add_table("time", line("tool_change", m.tool_change_seconds, number) +
                          line("junction_deviation", junction, number));
    if (!file.offsets.empty()) text += "[offsets]\n";
    for (const auto& [system, origin] : file.offsets)
        text += fmt::format("\"{}\" = {}\n", name_of_system(system), vector(origin));
    return text + links;
}

}  // namespace ncsim::setup
