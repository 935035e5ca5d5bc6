// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a mesh in machine files, the same for links and fixtures.
#pragma once

#include "ncsim/setup/mesh_file.h"

#include "files/toml_reader.h"

#include <optional>
#include <string>

namespace ncsim::setup {

class MeshKeys {
public:
    /// Files are named as seen from `folder`. All must outlive it.
    MeshKeys(const TomlReader& reader, const std::string& folder, InputSet& inputs)
        : r_(reader), folder_(folder), inputs_(inputs) {}

    // Each of these throws std::runtime_error as those of TomlReader do.
    void take_mesh(const toml::node& node, const std::string& key);
    void take_scale(const toml::node& node, const std::string& key);
    void take_hull(const toml::node& node, const std::string& key);
    /// In mm, when all keys are read; nothing where no mesh is told. Files that tell no unit are in
    /// mm where no scale is told; one that would be a few millimetres in all is refused then: it is
    /// in metres, and as it stands nothing would ever meet it.
    std::optional<SurfaceFile> finish();
    /// Where the mesh is told, and whether its hull is to stand for it; after finish().
    std::string place() const { return mesh_at_ ? r_.place_of(*mesh_at_) : std::string(); }
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
