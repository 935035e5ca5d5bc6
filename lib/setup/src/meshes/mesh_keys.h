// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of a mesh in machine files, for links and fixtures.
#pragma once

#include "ncsim/setup/mesh_file.h"

#include "files/toml_reader.h"

#include <optional>
#include <string>

namespace ncsim::setup {

/// Collects the keys of a mesh.
class MeshKeys {
public:
    /// Reads files relative to `folder`. Requires: all arguments outlive this object.
    MeshKeys(const TomlReader& reader, const std::string& folder, InputSet& inputs)
        : r_(reader), folder_(folder), inputs_(inputs) {}

    // The following functions throw std::runtime_error with file, line and column.
    void take_mesh(const toml::node& node, const std::string& key);
    void take_scale(const toml::node& node);
    void take_hull(const toml::node& node);
    /// Returns the mesh in mm, after all keys were read; empty if no mesh is specified. A file
    /// without unit and without scale is in mm. If it would then be shorter than 5 mm, it is
    /// refused, because it is probably in metres, and such a small body would never collide.
    std::optional<SurfaceFile> finish();
    /// Returns the place of the key `mesh`. Requires: finish() was called.
    std::string place() const { return mesh_at_ ? r_.place_of(*mesh_at_) : std::string(); }
    /// True if the convex hull replaces the mesh.
    bool as_hull() const { return as_hull_; }

private:
    const TomlReader& r_;
    const std::string& folder_;
    InputSet& inputs_;
    const toml::node* mesh_at_ = nullptr;
    const toml::node* scale_at_ = nullptr;
    SurfaceFile file_;
    std::optional<double> scale_;
    const toml::node* hull_at_ = nullptr;
    bool as_hull_ = false;
};

}  // namespace ncsim::setup
