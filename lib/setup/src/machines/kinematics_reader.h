// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reader of the kinematics in a machine file: a preset with its pivots, or links; and functions of
// the control.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/setup/specified_kinematics.h"

#include "files/toml_reader.h"
#include "meshes/mesh_keys.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// Reads the kinematic keys of a machine file.
class KinematicsReader {
public:
    /// Reads meshes from `folder` and stores values in `file`. Requires: all arguments outlive this
    /// object, except `folder`.
    KinematicsReader(const TomlReader& reader, std::string folder, InputSet& inputs,
                     MachineFile& file)
        : r_(reader), folder_(std::move(folder)), inputs_(inputs), file_(file) {}

    /// Reads the kinematic keys of the root.
    /// Throws: std::runtime_error with file, line and column, also if keys contradict each other.
    void read(const TomlTable& root);

private:
    struct Link {
        const toml::node* node;
        std::string name{}, parent{};
        std::optional<machine::Joint> joint{};
        bool is_placed = false;
        std::optional<NamedMesh> mesh{};
        std::optional<std::array<std::uint8_t, 3>> colour{};
        double clearance_mm = 0.0;
    };
    struct Name {
        const toml::node* node;
        std::string name;
    };
    std::optional<Name> name_at(const TomlTable& t, std::string_view key) const;
    void read_control(const TomlTable& t);
    void read_link(const TomlTable& t);
    void read_clamps(const TomlTable& root);
    void read_travels(const TomlTable& t);
    machine::Joint read_joint(const TomlTable& t, char letter) const;
    machine::Travel travel(const toml::node& node, const std::string& key) const;
    void read_table_offsets(const TomlTable& control, const std::string& name,
                            gcode::TableOffsets& offsets) const;
    std::optional<SpecifiedKinematics> kinematics() const;
    SpecifiedKinematics of_preset() const;
    SpecifiedKinematics of_links() const;
    std::vector<const Link*> chain_to_base(const Name& from) const;
    machine::Chain moved_by(const Name& link) const;
    void add_body(const Link& link) const;
    const Link* find(const std::string& name) const;
    void finish(SpecifiedKinematics& specified) const;

    const TomlReader& r_;
    std::string folder_;
    InputSet& inputs_;
    MachineFile& file_;
    std::optional<Name> preset_, part_, tool_;
    const toml::node* pivots_node_ = nullptr;
    std::map<char, Vec3> pivots_;
    std::vector<Link> links_;
    const toml::node* control_node_ = nullptr;
    std::optional<Name> assumed_, along_tool_;
    machine::Travels travels_;                  // X, Y and Z of links, too
    const toml::node* travels_node_ = nullptr;  // for A, B or C
    machine::SolutionPreference prefer_ = machine::SolutionPreference::Shortest;
};

}  // namespace ncsim::setup
