// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reader of the kinematics in a machine file: a preset with its pivots, or links; and functions of
// the control.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/machine_body.h"
#include "ncsim/setup/specified_kinematics.h"

#include "files/toml_reader.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// Collects the kinematic keys of a machine file.
class KinematicsReader {
public:
    /// Reads meshes from `folder`. Requires: all arguments outlive this object, except `folder`.
    KinematicsReader(const TomlReader& reader, std::string folder, InputSet& inputs)
        : r_(reader), folder_(std::move(folder)), inputs_(inputs) {}

    // The following functions throw std::runtime_error with file, line and column.
    void take_preset(const toml::node& node, const std::string& key);
    void take_pivots(const toml::node& node, const std::string& key);
    void take_control(const toml::node& node, const std::string& key);
    void take_assumed(const toml::node& node, const std::string& key);
    void take_along_tool(const toml::node& node, const std::string& key);
    void take_link(const toml::node& node, const std::string& key);
    void take_part(const toml::node& node, const std::string& key);
    void take_spindle_link(const toml::node& node, const std::string& key);
    /// Reads { C = "shortest" } for the axes A, B and C.
    void take_ways(const toml::node& node, const std::string& key);
    void take_clamps(const toml::node& node, const std::string& key);
    void take_travel(char letter, const toml::node& node, const std::string& key);
    /// Returns the travel of an axis.
    machine::Travel travel(const toml::node& node, const std::string& key) const;

    // Results, after all keys were read. They throw std::runtime_error if keys contradict each
    // other.
    std::optional<SpecifiedKinematics> kinematics() const;
    std::vector<MachineBody> bodies() const;       ///< Links with a mesh.
    std::vector<MachineBody> other_links() const;  ///< Links without a mesh.
    std::string part_link() const { return part_ ? part_->name : std::string(); }
    std::string tool_link() const { return tool_ ? tool_->name : std::string(); }
    machine::Chain part_moved_by() const;
    machine::Chain tool_moved_by() const;
    const gcode::TipControl& tip_control() const { return control_; }
    const gcode::TableOffsets& fixture_offsets() const { return fixture_offsets_; }
    const gcode::TableOffsets& setting_errors() const { return setting_errors_; }
    const std::array<gcode::RotaryWay, 3>& ways() const { return ways_; }
    const std::vector<gcode::RotaryClamp>& clamps() const { return clamps_; }
    /// Travels in keys of links; X, Y and Z are used.
    const machine::Travels& travels() const { return travels_; }

private:
    struct Link {
        const toml::node* node;
        std::string name, parent;
        std::optional<machine::Joint> joint;
        bool is_placed = false;
        std::optional<TriangleMesh> mesh;
        std::optional<std::array<std::uint8_t, 3>> colour;
        double clearance_mm = 0.0;
        double deflection_mm = 0.0;  // deflection of the mesh
        std::string assumed{};
        std::string mesh_at;
        bool as_hull = false;
    };
    struct Name {
        const toml::node* node;
        std::string name;
    };
    SpecifiedKinematics of_preset() const;
    SpecifiedKinematics of_links() const;
    std::vector<const Link*> chain_to_base(const Name& from) const;
    machine::Chain moved_by(const Name& link) const;
    std::vector<MachineBody> links_that(bool have_a_mesh) const;
    const Link* find(const std::string& name) const;
    void take_table_offsets(const toml::node& node, const std::string& key, bool may_turn,
                            gcode::TableOffsets& offsets) const;
    std::array<double, 3> angles(const toml::node& node, const std::string& key) const;
    void finish(SpecifiedKinematics& specified) const;

    const TomlReader& r_;
    std::string folder_;
    InputSet& inputs_;
    std::optional<Name> preset_, part_, tool_;
    const toml::node* pivots_node_ = nullptr;
    std::map<char, Vec3> pivots_;
    std::vector<Link> links_;
    const toml::node* control_node_ = nullptr;
    gcode::TipControl control_;
    gcode::TableOffsets fixture_offsets_, setting_errors_;
    std::optional<Name> assumed_, along_tool_;
    std::array<gcode::RotaryWay, 3> ways_{};  // for A, B and C
    std::vector<gcode::RotaryClamp> clamps_;
    machine::Travels travels_;
    const toml::node* travels_node_ = nullptr;  // for A, B or C
    machine::SolutionPreference prefer_ = machine::SolutionPreference::Shortest;
};

}  // namespace ncsim::setup
