// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the keys of a mesh.
#include "meshes/mesh_keys.h"

#include "ncsim/base/vec3.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ncsim::setup {

std::optional<NamedMesh> read_mesh(const TomlReader& reader, const std::string& folder,
                                   InputSet& inputs, const TomlTable& table) {
    const toml::node* const mesh_at = table["mesh"] ? table["mesh"] : table["stl"];
    if (table["mesh"] && table["stl"])
        reader.fail(*table["stl"],
                    fmt::format("'{}': a mesh is specified already", table.name_of("stl")));
    if (!mesh_at) {
        for (const char* key : {"hull", "scale"}) {
            if (table[key]) reader.fail(*table[key], fmt::format("'{}': there is no mesh", key));
        }
        return std::nullopt;
    }
    NamedMesh named{{}, reader.place_of(*mesh_at)};
    table.read("hull", named.as_hull);
    SurfaceFile& file = named.file;
    try {
        file = read_surface_file(seen_in(folder, TomlReader::text(*mesh_at)), inputs);
    } catch (const std::runtime_error& e) {
        reader.fail(*mesh_at, e.what());
    }
    std::optional<double> scale;
    table.read("scale", scale);
    if (scale && file.has_unit)
        reader.fail(*table["scale"], "'scale': the file states the unit of its lengths");
    Box box;
    for (Vec3& p : file.mesh.vertices) {
        p = scale.value_or(1.0) * p;
        box.add(p);
    }
    const Vec3 size = box.size();
    const double longest = std::max({size.x, size.y, size.z});
    constexpr double kShortestMesh = 5.0, kLongestMesh = 1e6;  // mm
    if (!scale && !file.has_unit && longest < kShortestMesh) {
        reader.fail(*mesh_at,
                    fmt::format("the mesh is {:.3g} mm long: if it is in metres, scale = 1000 "
                                "makes it millimetres; scale = 1 says that it is that small",
                                longest));
    }
    if (!(longest < kLongestMesh))
        reader.fail(*mesh_at, fmt::format("the mesh is {:.3g} m long", 1e-3 * longest));
    return named;
}

}  // namespace ncsim::setup
