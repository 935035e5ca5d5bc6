// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the keys of a mesh.
#include "meshes/mesh_keys.h"

#include "ncsim/setup/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace ncsim::setup {

void MeshKeys::take_mesh(const toml::node& node, const std::string& key) {
    if (mesh_at_) r_.fail(node, fmt::format("'{}': a mesh is specified already", key));
    mesh_at_ = &node;
    const std::string path = seen_in(folder_, TomlReader::text(node));
    try {
        file_ = read_surface_file(path, inputs_);
    } catch (const std::runtime_error& e) {
        r_.fail(node, e.what());
    }
}

void MeshKeys::take_scale(const toml::node& node) {
    scale_at_ = &node;
    scale_ = TomlReader::number(node);
}

void MeshKeys::take_hull(const toml::node& node) {
    hull_at_ = &node;
    as_hull_ = node.as_boolean()->get();
}

std::optional<SurfaceFile> MeshKeys::finish() {
    if (!mesh_at_) {
        if (hull_at_) r_.fail(*hull_at_, "'hull': there is no mesh");
        if (scale_at_) r_.fail(*scale_at_, "'scale': there is no mesh");
        return std::nullopt;
    }
    if (scale_ && file_.has_unit)
        r_.fail(*scale_at_, "'scale': the file states the unit of its lengths");
    Box box;
    for (Vec3& p : file_.mesh.vertices) {
        p = scale_.value_or(1.0) * p;
        box.add(p);
    }
    const Vec3 size = box.size();
    const double longest = std::max({size.x, size.y, size.z});
    constexpr double kShortestMesh = 5.0, kLongestMesh = 1e6;  // mm
    if (!scale_ && !file_.has_unit && longest < kShortestMesh) {
        r_.fail(*mesh_at_,
                fmt::format("the mesh is {:.3g} mm long: if it is in metres, scale = 1000 "
                            "makes it millimetres; scale = 1 says that it is that small",
                            longest));
    }
    if (!(longest < kLongestMesh))
        r_.fail(*mesh_at_, fmt::format("the mesh is {:.3g} m long", 1e-3 * longest));
    return std::move(file_);
}

}  // namespace ncsim::setup
