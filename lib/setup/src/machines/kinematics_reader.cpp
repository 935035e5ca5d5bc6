// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads presets, links and functions of the control in a machine file.
#include "machines/kinematics_reader.h"

#include "ncsim/base/ascii.h"
#include "ncsim/base/number_text.h"
#include "ncsim/machine/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string_view>

namespace ncsim::setup {

namespace {

using gcode::Coordinates;

constexpr std::size_t kMostLinks = 100;
constexpr std::string_view kBed = "bed";

bool turns(char letter) {
    return letter <= 'C';
}

std::size_t index_of(char rotary_axis) {
    return static_cast<std::size_t>(rotary_axis - 'A');
}

Coordinates tip_or_axes(std::string_view mode) {
    return mode == "tip" ? Coordinates::Tip : Coordinates::Axes;
}

gcode::RotaryWay way_of(const toml::node& node) {
    using gcode::RotaryWay;
    const std::string word = TomlReader::text(node);
    return word == "shortest"   ? RotaryWay::Shortest
           : word == "sign"     ? RotaryWay::Sign
           : word == "positive" ? RotaryWay::Positive
                                : RotaryWay::Linear;
}

// Reads the number of "M428". Numbers below `first` have a fixed meaning on all controls.
std::optional<int> m_code_named(std::string_view name, int first) {
    constexpr int kLast = 9999;
    if (name.size() < 2 || name[0] != 'M') return std::nullopt;
    const auto number = number_in<int>(name.substr(1));
    return number && *number >= first && *number <= kLast ? number : std::nullopt;
}

// Reads "#c08040".
std::optional<std::array<std::uint8_t, 3>> colour_named(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t i = 0; i < 3; ++i) {
        const char* first = text.data() + 1 + 2 * i;
        const auto read = std::from_chars(first, first + 2, colour[i], 16);
        if (read.ec != std::errc() || read.ptr != first + 2) return std::nullopt;
    }
    return colour;
}

}  // namespace

void KinematicsReader::read(const TomlTable& root) {
    along_tool_ = name_at(root, "along_tool");
    assumed_ = name_at(root, "assumed");
    read_clamps(root);
    control_node_ = root["control"];
    read_control(root.table("control"));
    root.each("link", [this](const TomlTable& link) { read_link(link); });
    part_ = name_at(root.table("part"), "link");
    pivots_node_ = root["pivot"];
    root.each_key("pivot", [this](const toml::node& node, const std::string& axis) {
        pivots_[axis[0]] = TomlReader::vector(node);
    });
    preset_ = name_at(root, "preset");
    tool_ = name_at(root.table("spindle"), "link");
    read_travels(root.table("travel"));
    root.each_key("way", [this](const toml::node& node, const std::string& axis) {
        file_.rotary_ways[index_of(axis[0])] = way_of(node);
    });
    file_.kinematics = kinematics();
    for (const Link& link : links_)
        add_body(link);
    if (part_) file_.part_link = part_->name;
    if (tool_) file_.tool_link = tool_->name;
    if (part_ && !links_.empty()) file_.part_moved_by = moved_by(*part_);
    if (tool_ && !links_.empty()) file_.tool_moved_by = moved_by(*tool_);
}

// Returns a text with its place; empty if the table does not have the key.
std::optional<KinematicsReader::Name> KinematicsReader::name_at(const TomlTable& t,
                                                                std::string_view key) const {
    const toml::node* const node = t[key];
    return node ? std::optional(Name{node, TomlReader::text(*node)}) : std::nullopt;
}

void KinematicsReader::read_control(const TomlTable& t) {
    gcode::TipControl& control = file_.tip_control;
    // True if a key has the word `built`; the word `other` is valid but not simulated.
    const auto is_built = [this, &t](const char* key, std::string_view built,
                                     std::string_view other) {
        if (!t[key]) return false;
        const std::string word = TomlReader::text(*t[key]), name = t.name_of(key);
        if (word == other) {
            r_.fail(*t[key],
                    fmt::format("'{}': \"{}\" is not simulated, only \"{}\"", name, other, built));
        }
        if (word != built) r_.fail(*t[key], fmt::format("'{}': expected \"{}\"", name, built));
        return true;
    };
    if (t["at_start"]) control.at_start = tip_or_axes(TomlReader::text(*t["at_start"]));
    read_table_offsets(t, "fixture_offset", file_.fixture_offsets);
    std::vector<std::string> modes;
    t.read("kinematics", modes);
    std::ranges::transform(modes, std::back_inserter(control.kinematics), tip_or_axes);
    t.each_key("m_codes", [&](const toml::node& node, const std::string& name) {
        constexpr int kFree = 100;
        const auto number = m_code_named(name, kFree);
        if (!number)
            r_.fail(node,
                    fmt::format("'{}.{}': expected M100 to M9999", t.name_of("m_codes"), name));
        control.m_codes[*number] = tip_or_axes(TomlReader::text(node));
    });
    std::string orient;
    t.read("orient", orient);
    using machine::SolutionPreference;
    prefer_ = orient == "positive"   ? SolutionPreference::EndPositive
              : orient == "negative" ? SolutionPreference::EndNegative
                                     : SolutionPreference::Shortest;
    read_table_offsets(t, "setting_error", file_.setting_errors);
    t.read("setting_error_turns_axes", file_.setting_errors.axes_take_turns);
    control.by_length_word = is_built("tip_frame", "table", "work");
    control.frame_at_zero = is_built("tip_frame_at", "zero", "start");
    (void)is_built("tip_turns", "joints", "vector");
}

// Reads the keys `name`s and `name`_moves.
void KinematicsReader::read_table_offsets(const TomlTable& control, const std::string& name,
                                          gcode::TableOffsets& offsets) const {
    control.read(name + "_moves", offsets.moves);
    const TomlTable all = control.table(name + "s");
    for (const auto& [key, node] : all.node()) {
        constexpr int kMost = 300;
        const std::string_view text = key.str();
        const auto number = text.starts_with('P') ? number_in<int>(text.substr(1)) : std::nullopt;
        if (!number || *number < 1 || *number > kMost)
            r_.fail(node, fmt::format("'{}': expected P1 to P{}", all.name_of(text), kMost));
        const TomlTable t = all.table(text);
        if (!t["offset"] || !t["at"]) {
            r_.fail(node, fmt::format("'{}': expected offset = [x, y, z], and at which angles of "
                                      "the table, at = {{ B = 0 }}",
                                      t.name()));
        }
        gcode::TableOffsets::One& offset = offsets.by_number[*number];
        t.read("offset", offset.offset);
        t.read("turns", offset.turns);
        t.each_key("at", [&](const toml::node& angle, const std::string& axis) {
            offset.at[index_of(axis[0])] = TomlReader::number(angle);
        });
    }
}

machine::Travel KinematicsReader::travel(const toml::node& node, const std::string& key) const {
    const auto [min, max] = TomlReader::value<std::array<double, 2>>(node);
    if (min >= max) r_.fail(node, fmt::format("'{}': the first end must be below the second", key));
    return {min, max};
}

// Reads travels of axes after those of links, and stores those of X, Y and Z.
void KinematicsReader::read_travels(const TomlTable& t) {
    for (const auto& [key, node] : t.node()) {
        const char letter = upper(key.str()[0]);
        if (turns(letter)) travels_node_ = &node;
        travels_[letter] = travel(node, t.name_of(key.str()));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto specified = travels_.find("XYZ"[i]);
        if (specified == travels_.end()) continue;
        file_.machine.travel[i] = verify::AxisRange{specified->second.min, specified->second.max};
    }
}

void KinematicsReader::read_clamps(const TomlTable& root) {
    root.each_key("clamps", [this](const toml::node& node, const std::string& axis) {
        const auto codes = TomlReader::value<std::array<std::string, 2>>(node);
        constexpr int kFirst = 10;  // smaller numbers have a fixed meaning on all controls
        const auto clamp = m_code_named(codes[0], kFirst);
        const auto release = m_code_named(codes[1], kFirst);
        if (!clamp || !release || clamp == release || *clamp == 30 || *release == 30) {
            r_.fail(node,
                    fmt::format("'clamps.{}': expected two M codes, [\"M10\", \"M11\"]", axis));
        }
        file_.clamps.push_back({axis[0], *clamp, *release});
    });
}

void KinematicsReader::read_link(const TomlTable& t) {
    Link link{&t.node()};
    t.read("name", link.name);
    t.read("parent", link.parent);
    t.read("clearance", link.clearance_mm);
    if (const toml::node* const colour = t["colour"]) {
        link.colour = colour_named(TomlReader::text(*colour));
        if (!link.colour)
            r_.fail(*colour, fmt::format("'{}': expected \"#rrggbb\"", t.name_of("colour")));
    }
    for (const char* key : {"moves_along", "turns_about"}) {
        constexpr double kNothing = 1e-6;
        if (t[key] && norm(TomlReader::vector(*t[key])) < kNothing)
            r_.fail(*t[key], fmt::format("'{}': it has no length", t.name_of(key)));
    }
    std::optional<machine::Travel> range;
    if (t["travel"]) range = travel(*t["travel"], t.name_of("travel"));
    link.mesh = read_mesh(r_, folder_, inputs_, t);
    if (link.name.empty() || link.name == kBed || find(link.name))
        r_.fail(t.node(), "a link needs a name of its own, which is not \"bed\"");
    if (t["clearance"] && !link.mesh)
        r_.fail(*t["clearance"], fmt::format("link '{}' has no mesh: no clearance", link.name));
    if (links_.size() >= kMostLinks)
        r_.fail(t.node(), fmt::format("more than {} links", kMostLinks));
    if (t["axis"]) {
        const char letter = TomlReader::text(*t["axis"])[0];
        link.joint = read_joint(t, letter);
        link.is_placed = t["through"] != nullptr;
        if (range) travels_[letter] = *range;
        if (t["way"]) file_.rotary_ways[index_of(letter)] = way_of(*t["way"]);
    } else if (t["moves_along"] || t["turns_about"] || t["through"] || t["positive"] || range ||
               t["way"]) {
        r_.fail(t.node(), "a link that moves needs its axis");
    }
    links_.push_back(std::move(link));
}

// Returns the joint of a link that moves.
machine::Joint KinematicsReader::read_joint(const TomlTable& t, char letter) const {
    const bool rotary = turns(letter);
    const char* const key = rotary ? "turns_about" : "moves_along";
    if (!t[key] || t[rotary ? "moves_along" : "turns_about"])
        r_.fail(t.node(), fmt::format("axis {} needs {}, and nothing else", letter, key));
    if (!rotary && (t["through"] || t["positive"]))
        r_.fail(t.node(), fmt::format("axis {} moves straight: no through, no positive", letter));
    const auto is_same = [&](const Link& l) { return l.joint && l.joint->letter == letter; };
    if (std::ranges::any_of(links_, is_same))
        r_.fail(t.node(), fmt::format("axis {} is specified twice", letter));
    Vec3 direction, through;
    std::string positive;
    t.read(key, direction);
    t.read("through", through);
    t.read("positive", positive);
    const machine::Joint joint =
        machine::joint_of(letter, rotary, direction, through,
                          positive == "part" ? machine::Positive::Part : machine::Positive::Tool);
    if (rotary) return joint;
    if (t["way"]) r_.fail(t.node(), fmt::format("axis {} moves straight: no way", letter));
    // X, Y and Z of a position are along the axes of the program.
    Vec3 own;
    own[letter - 'X'] = 1.0;
    if (norm(joint.direction - own) > 1e-9)
        r_.fail(t.node(), fmt::format("axis {0}: only {0} along itself is simulated", letter));
    return joint;
}

const KinematicsReader::Link* KinematicsReader::find(const std::string& name) const {
    const auto found = std::ranges::find(links_, name, &Link::name);
    return found == links_.end() ? nullptr : &*found;
}

// Returns the links from a link to the bed.
std::vector<const KinematicsReader::Link*> KinematicsReader::chain_to_base(const Name& from) const {
    std::vector<const Link*> way;
    const toml::node* named_at = from.node;
    for (std::string name = from.name; !name.empty() && name != kBed;) {
        const Link* link = find(name);
        if (!link) r_.fail(*named_at, fmt::format("there is no link '{}'", name));
        if (way.size() >= links_.size())
            r_.fail(*link->node, fmt::format("link '{}' carries itself", name));
        way.push_back(link);
        named_at = link->node;
        name = link->parent;
    }
    return way;
}

SpecifiedKinematics KinematicsReader::of_preset() const {
    SpecifiedKinematics specified;
    specified.chain = *machine::preset(preset_->name);
    for (const auto& [letter, place] : pivots_) {
        if (!specified.chain.find(letter))
            r_.fail(*pivots_node_,
                    fmt::format("'pivot': {} has no axis {}", preset_->name, letter));
    }
    for (machine::Joint& joint : specified.chain.joints) {
        if (!joint.turns) continue;
        const auto place = pivots_.find(joint.letter);
        if (place == pivots_.end()) {
            specified.unspecified_pivots += joint.letter;
        } else {
            joint.through = place->second;
        }
    }
    return specified;
}

SpecifiedKinematics KinematicsReader::of_links() const {
    const toml::node& first = *links_.front().node;
    if (!part_) r_.fail(first, "which link carries the part? part = { link = \"…\" }");
    if (!tool_) r_.fail(first, "which link carries the tool? [spindle] link = \"…\"");
    SpecifiedKinematics specified;
    const auto add = [&](const Link* link) {
        if (!link->joint) return;
        specified.chain.joints.push_back(*link->joint);
        if (link->joint->turns && !link->is_placed)
            specified.unspecified_pivots += link->joint->letter;
    };
    std::vector<const Link*> up = chain_to_base(*part_);
    std::vector<const Link*> down = chain_to_base(*tool_);
    // Links that carry both the part and the tool do not move the part relative to the tool.
    while (!up.empty() && !down.empty() && up.back() == down.back()) {
        if (up.back()->joint) {
            r_.fail(*up.back()->node,
                    fmt::format("link '{}' carries the part and the tool", up.back()->name));
        }
        up.pop_back();
        down.pop_back();
    }
    std::ranges::for_each(up, add);
    std::for_each(down.rbegin(), down.rend(), add);
    for (const Link& link : links_) {
        if (link.joint && !specified.chain.find(link.joint->letter)) {
            r_.fail(*link.node,
                    fmt::format("axis {} moves neither the part nor the tool", link.joint->letter));
        }
    }
    for (const char letter : {'X', 'Y', 'Z'}) {
        if (!specified.chain.find(letter))
            r_.fail(first, fmt::format("no link moves along {}", letter));
    }
    return specified;
}

// Sets the values that presets and links share.
void KinematicsReader::finish(SpecifiedKinematics& specified) const {
    specified.prefer = prefer_;
    if (assumed_) specified.guess = assumed_->name;
    if (along_tool_)
        specified.chain.joints.push_back(machine::along_tool(along_tool_->name.front()));
    for (const auto& [letter, range] : travels_) {
        if (!turns(letter)) continue;
        if (!specified.chain.find(letter))
            r_.fail(*travels_node_, fmt::format("'travel': there is no axis {}", letter));
        specified.travels[letter] = range;
    }
}

// Returns the joints from the bed on, each as a motion of the link.
machine::Chain KinematicsReader::moved_by(const Name& link) const {
    std::vector<const Link*> carries_part;
    if (part_) carries_part = chain_to_base(*part_);
    machine::Chain chain;
    const std::vector<const Link*> way = chain_to_base(link);
    for (auto next = way.rbegin(); next != way.rend(); ++next) {
        const Link* moved = *next;
        if (!moved->joint) continue;
        machine::Joint joint = *moved->joint;
        // Joints are given as a motion of the tool; a link that carries the part moves in the
        // opposite direction.
        if (std::ranges::find(carries_part, moved) != carries_part.end())
            joint.direction = -joint.direction;
        chain.joints.push_back(joint);
    }
    return chain;
}

// Adds a link to the bodies of the file, or to the links without a mesh.
void KinematicsReader::add_body(const Link& link) const {
    MachineBody body;
    body.link = link.name;
    if (link.colour) body.colour = *link.colour;
    if (link.parent != kBed) body.parent = link.parent;
    body.moved_by = moved_by({link.node, link.name});
    if (link.joint) body.joint = body.moved_by.joints.back();
    body.clearance_mm = link.clearance_mm;
    if (link.mesh) {
        body.mesh = link.mesh->file.mesh;
        body.deflection_mm = link.mesh->file.deflection_mm;
        body.assumed = link.mesh->file.assumed;
        body.mesh_at = link.mesh->place;
        body.as_hull = link.mesh->as_hull;
    }
    (link.mesh ? file_.bodies : file_.other_links).push_back(std::move(body));
}

std::optional<SpecifiedKinematics> KinematicsReader::kinematics() const {
    if (preset_ && !links_.empty())
        r_.fail(*preset_->node,
                "a machine is specified by its preset or by its links, not by both");
    if (pivots_node_ && !preset_) r_.fail(*pivots_node_, "'pivot' belongs to a preset");
    if (links_.empty()) {
        for (const auto& name : {part_, tool_}) {
            if (name) r_.fail(*name->node, fmt::format("there is no link '{}'", name->name));
        }
    }
    if (preset_ || !links_.empty()) {
        SpecifiedKinematics specified = preset_ ? of_preset() : of_links();
        finish(specified);
        return specified;
    }
    if (assumed_) r_.fail(*assumed_->node, "'assumed' needs to know how the machine turns");
    if (along_tool_)
        r_.fail(*along_tool_->node, "'along_tool' needs to know how the machine turns");
    if (travels_node_)
        r_.fail(*travels_node_, "'travel' of a rotary axis needs to know how the machine turns");
    if (control_node_) {
        r_.fail(*control_node_,
                "'control' needs to know how the machine turns: preset or [[link]]");
    }
    return std::nullopt;
}

}  // namespace ncsim::setup
