// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads presets, links and functions of the control in a machine file.
#include "machines/kinematics_reader.h"

#include "ncsim/base/number_text.h"
#include "ncsim/machine/presets.h"

#include "meshes/mesh_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace ncsim::setup {

namespace {

using gcode::Coordinates;

constexpr std::size_t kMostLinks = 100;
constexpr std::string_view kBed = "bed";

// Reads X, Y, Z, A, B or C.
std::optional<char> axis_named(std::string_view name) {
    if (name.size() != 1 || std::string_view("XYZABC").find(name[0]) == std::string_view::npos)
        return std::nullopt;
    return name[0];
}

bool turns(char letter) {
    return letter <= 'C';
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

void KinematicsReader::take_preset(const toml::node& node, const std::string&) {
    preset_ = Name{&node, TomlReader::text(node)};
}

void KinematicsReader::take_pivots(const toml::node& node, const std::string& key) {
    pivots_node_ = &node;
    for (const auto& [name, value] : TomlReader::table(node)) {
        const auto letter = axis_named(name.str());
        if (!letter || !turns(*letter))
            r_.fail(value, fmt::format("'{}.{}': expected A, B or C", key, name.str()));
        pivots_[*letter] = TomlReader::vector(value);
    }
}

void KinematicsReader::take_along_tool(const toml::node& node, const std::string&) {
    along_tool_ = Name{&node, TomlReader::text(node)};
}

void KinematicsReader::take_control(const toml::node& node, const std::string& key) {
    control_node_ = &node;
    // Accepts the word `built`; the word `other` is valid but not simulated.
    const auto choose = [this](std::string_view built, std::string_view other, const auto& done) {
        return [this, built, other, done](const toml::node& n, const std::string& k) {
            const std::string word = TomlReader::text(n);
            if (word == other)
                r_.fail(n,
                        fmt::format("'{}': \"{}\" is not simulated, only \"{}\"", k, other, built));
            if (word != built) r_.fail(n, fmt::format("'{}': expected \"{}\"", k, built));
            done();
        };
    };
    const TomlReader::Take m_codes = [this](const toml::node& n, const std::string& k) {
        for (const auto& [name, value] : TomlReader::table(n)) {
            constexpr int kFree = 100;
            const auto number = m_code_named(name.str(), kFree);
            const std::string whole = fmt::format("{}.{}", k, name.str());
            if (!number) r_.fail(value, fmt::format("'{}': expected M100 to M9999", whole));
            control_.m_codes[*number] = tip_or_axes(TomlReader::text(value));
        }
    };
    TomlReader::each(
        TomlReader::table(node), key,
        {{"m_codes", m_codes},
         {"tip_frame", choose("table", "work", [this] { control_.by_length_word = true; })},
         {"tip_frame_at", choose("zero", "start", [this] { control_.frame_at_zero = true; })},
         {"tip_turns", choose("joints", "vector", [] {})},
         {"at_start",
          [this](const toml::node& n, const std::string&) {
              control_.at_start = tip_or_axes(TomlReader::text(n));
          }},
         {"kinematics",
          [this](const toml::node& n, const std::string&) {
              for (const std::string& mode : TomlReader::texts(n))
                  control_.kinematics.push_back(tip_or_axes(mode));
          }},
         {"fixture_offsets",
          [this](const auto& n, const auto& k) {
              take_table_offsets(n, k, false, fixture_offsets_);
          }},
         {"fixture_offset_moves", into(fixture_offsets_.moves)},
         {"setting_errors",
          [this](const auto& n, const auto& k) {
              take_table_offsets(n, k, true, setting_errors_);
          }},
         {"setting_error_moves", into(setting_errors_.moves)},
         {"setting_error_turns_axes", into(setting_errors_.axes_take_turns)},
         {"orient", [this](const toml::node& n, const std::string&) {
              using machine::SolutionPreference;
              const std::string word = TomlReader::text(n);
              prefer_ = word == "positive"   ? SolutionPreference::EndPositive
                        : word == "negative" ? SolutionPreference::EndNegative
                                             : SolutionPreference::Shortest;
          }}});
}

// Reads { B = 90 }, degrees; unnamed axes are at 0.
std::array<double, 3> KinematicsReader::angles(const toml::node& node,
                                               const std::string& key) const {
    std::array<double, 3> at{};
    for (const auto& [name, value] : TomlReader::table(node)) {
        const auto letter = axis_named(name.str());
        const std::string whole = fmt::format("{}.{}", key, name.str());
        if (!letter || !turns(*letter))
            r_.fail(value, fmt::format("'{}': expected A, B or C", whole));
        at[static_cast<std::size_t>(*letter - 'A')] = TomlReader::number(value);
    }
    return at;
}

void KinematicsReader::take_table_offsets(const toml::node& node, const std::string& key,
                                          bool may_turn, gcode::TableOffsets& offsets) const {
    constexpr int kMost = 300;
    for (const auto& [name, value] : TomlReader::table(node)) {
        const std::string whole = fmt::format("{}.{}", key, name.str());
        const std::string_view text = name.str();
        const auto number = text.starts_with('P') ? number_in<int>(text.substr(1)) : std::nullopt;
        if (!number || *number < 1 || *number > kMost) {
            r_.fail(value, fmt::format("'{}': expected P1 to P{}", whole, kMost));
        }
        std::optional<Vec3> offset;
        std::optional<std::array<double, 3>> at;
        Vec3 turns;
        TomlReader::Keys keys{{"offset", into(offset)},
                              {"at", [&](const auto& n, const auto& k) { at = angles(n, k); }}};
        if (may_turn) keys["turns"] = into(turns);
        TomlReader::each(TomlReader::table(value), whole, keys);
        if (!offset || !at) {
            r_.fail(value, fmt::format("'{}': expected offset = [x, y, z], and at which angles of "
                                       "the table, at = {{ B = 0 }}",
                                       whole));
        }
        offsets.by_number[*number] = {
            {offset->x, offset->y, offset->z}, *at, {turns.x, turns.y, turns.z}};
    }
}

machine::Travel KinematicsReader::travel(const toml::node& node, const std::string& key) const {
    const toml::array& ends = TomlReader::list(node);
    const machine::Travel travel{TomlReader::number(ends[0]), TomlReader::number(ends[1])};
    if (travel.min >= travel.max)
        r_.fail(node, fmt::format("'{}': the first end must be below the second", key));
    return travel;
}

void KinematicsReader::take_ways(const toml::node& node, const std::string& key) {
    for (const auto& [name, value] : TomlReader::table(node)) {
        const auto letter = axis_named(name.str());
        const std::string whole = fmt::format("{}.{}", key, name.str());
        if (!letter || !turns(*letter))
            r_.fail(value, fmt::format("'{}': expected A, B or C", whole));
        ways_[static_cast<std::size_t>(*letter - 'A')] = way_of(value);
    }
}

void KinematicsReader::take_clamps(const toml::node& node, const std::string& key) {
    for (const auto& [name, value] : TomlReader::table(node)) {
        const auto letter = axis_named(name.str());
        const std::string whole = fmt::format("{}.{}", key, name.str());
        if (!letter || !turns(*letter))
            r_.fail(value, fmt::format("'{}': expected A, B or C", whole));
        const toml::array& codes = TomlReader::list(value);
        constexpr int kFirst = 10;  // smaller numbers have a fixed meaning on all controls
        const auto clamp = m_code_named(TomlReader::text(codes[0]), kFirst);
        const auto release = m_code_named(TomlReader::text(codes[1]), kFirst);
        if (!clamp || !release || clamp == release || *clamp == 30 || *release == 30)
            r_.fail(value, fmt::format("'{}': expected two M codes, [\"M10\", \"M11\"]", whole));
        clamps_.push_back({*letter, *clamp, *release});
    }
}

void KinematicsReader::take_assumed(const toml::node& node, const std::string&) {
    assumed_ = Name{&node, TomlReader::text(node)};
}

void KinematicsReader::take_travel(char letter, const toml::node& node, const std::string& key) {
    travels_node_ = &node;
    travels_[letter] = travel(node, key);
}

void KinematicsReader::take_link(const toml::node& node, const std::string& key) {
    Link link;
    link.node = &node;
    std::optional<char> letter;
    std::optional<Vec3> along, about, through;
    std::optional<bool> turns_part;
    std::optional<machine::Travel> range;
    std::optional<gcode::RotaryWay> told_way;
    const toml::node* clearance_at = nullptr;
    MeshKeys mesh(r_, folder_, inputs_);
    const auto into_direction = [this](std::optional<Vec3>& direction) {
        return [this, &direction](const toml::node& n, const std::string& k) {
            direction = TomlReader::vector(n);
            constexpr double kNothing = 1e-6;
            if (norm(*direction) < kNothing) r_.fail(n, fmt::format("'{}': it has no length", k));
        };
    };
    TomlReader::each(
        TomlReader::table(node), key,
        {{"name", into(link.name)},
         {"parent", into(link.parent)},
         {"axis", [&](const toml::node& n,
                      const std::string&) { letter = axis_named(TomlReader::text(n)); }},
         {"moves_along", into_direction(along)},
         {"turns_about", into_direction(about)},
         {"through", into(through)},
         {"travel", [&](const auto& n, const auto& k) { range = travel(n, k); }},
         {"mesh", [&](const auto& n, const auto& k) { mesh.take_mesh(n, k); }},
         {"scale", [&](const auto& n, const auto&) { mesh.take_scale(n); }},
         {"hull", [&](const auto& n, const auto&) { mesh.take_hull(n); }},
         {"colour",
          [&](const toml::node& n, const std::string& k) {
              link.colour = colour_named(TomlReader::text(n));
              if (!link.colour) r_.fail(n, fmt::format("'{}': expected \"#rrggbb\"", k));
          }},
         {"clearance",
          [&](const auto& n, const auto&) {
              clearance_at = &n;
              link.clearance_mm = TomlReader::number(n);
          }},
         {"way", [&](const auto& n, const auto&) { told_way = way_of(n); }},
         {"positive", [&](const toml::node& n, const std::string&) {
              turns_part = TomlReader::text(n) == "part";
          }}});
    if (auto file = mesh.finish()) {
        link.mesh = std::move(file->mesh);
        link.deflection_mm = file->deflection_mm;
        link.assumed = std::move(file->assumed);
        link.mesh_at = mesh.place();
        link.as_hull = mesh.as_hull();
    }
    if (link.name.empty() || link.name == kBed || find(link.name))
        r_.fail(node, "a link needs a name of its own, which is not \"bed\"");
    if (clearance_at && !link.mesh)
        r_.fail(*clearance_at, fmt::format("link '{}' has no mesh: no clearance", link.name));
    if (links_.size() >= kMostLinks) r_.fail(node, fmt::format("more than {} links", kMostLinks));
    if (letter) {
        const bool rotary = turns(*letter);
        const auto& specified = rotary ? about : along;
        if (!specified || (rotary ? along : about)) {
            r_.fail(node, fmt::format("axis {} needs {}, and nothing else", *letter,
                                      rotary ? "turns_about" : "moves_along"));
        }
        if (!rotary && (through || turns_part))
            r_.fail(node, fmt::format("axis {} moves straight: no through, no positive", *letter));
        if (std::ranges::any_of(
                links_, [&](const Link& l) { return l.joint && l.joint->letter == *letter; })) {
            r_.fail(node, fmt::format("axis {} is specified twice", *letter));
        }
        const auto positive =
            turns_part.value_or(false) ? machine::Positive::Part : machine::Positive::Tool;
        link.joint =
            machine::joint_of(*letter, rotary, *specified, through.value_or(Vec3{}), positive);
        link.is_placed = through.has_value();
        if (range) travels_[*letter] = *range;
        if (told_way && !rotary)
            r_.fail(node, fmt::format("axis {} moves straight: no way", *letter));
        if (told_way) ways_[static_cast<std::size_t>(*letter - 'A')] = *told_way;
        // X, Y and Z of a position are along the axes of the program.
        Vec3 own;
        if (!rotary) own[*letter - 'X'] = 1.0;
        if (!rotary && norm(link.joint->direction - own) > 1e-9)
            r_.fail(node,
                    fmt::format("axis {}: only {} along itself is simulated", *letter, *letter));
    } else if (along || about || through || turns_part || range || told_way) {
        r_.fail(node, "a link that moves needs its axis");
    }
    links_.push_back(std::move(link));
}

void KinematicsReader::take_part(const toml::node& node, const std::string& key) {
    TomlReader::each(TomlReader::table(node), key, {{"link", [this](const auto& n, const auto&) {
                                                         part_ = Name{&n, TomlReader::text(n)};
                                                     }}});
}

void KinematicsReader::take_spindle_link(const toml::node& node, const std::string&) {
    tool_ = Name{&node, TomlReader::text(node)};
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

machine::Chain KinematicsReader::part_moved_by() const {
    return part_ && !links_.empty() ? moved_by(*part_) : machine::Chain();
}

machine::Chain KinematicsReader::tool_moved_by() const {
    return tool_ && !links_.empty() ? moved_by(*tool_) : machine::Chain();
}

std::vector<MachineBody> KinematicsReader::links_that(bool have_a_mesh) const {
    std::vector<MachineBody> bodies;
    for (const Link& link : links_) {
        if (link.mesh.has_value() != have_a_mesh) continue;
        MachineBody body;
        body.link = link.name;
        if (link.mesh) body.mesh = *link.mesh;
        if (link.colour) body.colour = *link.colour;
        if (link.parent != kBed) body.parent = link.parent;
        body.moved_by = moved_by({link.node, link.name});
        if (link.joint) body.joint = body.moved_by.joints.back();
        body.clearance_mm = link.clearance_mm;
        body.deflection_mm = link.deflection_mm;
        body.assumed = link.assumed;
        body.mesh_at = link.mesh_at;
        body.as_hull = link.as_hull;
        bodies.push_back(std::move(body));
    }
    return bodies;
}

std::vector<MachineBody> KinematicsReader::bodies() const {
    return links_that(true);
}

std::vector<MachineBody> KinematicsReader::other_links() const {
    return links_that(false);
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
