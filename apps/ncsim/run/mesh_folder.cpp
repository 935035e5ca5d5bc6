// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the meshes of tiles.
#include "run/mesh_folder.h"

#include "ncsim/base/parallel.h"
#include "ncsim/cda/tiles.h"
#include "ncsim/export/gltf.h"
#include "ncsim/mesh/seams.h"
#include "ncsim/report/mesh_list.h"
#include "ncsim/setup/digest.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace fs = std::filesystem;

namespace {

struct MadeMesh {
    report::MeshFile file;
    std::string bytes;
    std::vector<mesh::FloatEdge> open;
};

// Returns whole millimetres near the middle of the stock, which are equal for all tiles.
Vec3 common_centre(const simulation::Survey& survey) {
    const Vec3 centre = survey.stock->box.centre();
    return {std::round(centre.x), std::round(centre.y), std::round(centre.z)};
}

fs::path without_slash(const std::string& folder) {
    const fs::path path = fs::path(folder).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

}  // namespace

bool names_a_folder(const std::string& path) {
    std::error_code ignored;
    return path.ends_with('/') || fs::is_directory(path, ignored);
}

std::string list_of_meshes(const std::string& folder) {
    return without_slash(folder).string() + ".json";
}

void write_mesh_folder(const std::string& folder, const simulation::Plan& plan,
                       const simulation::Survey& survey, const simulation::Simulation& simulation,
                       OutputSet& outputs) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot make the folder '{}': {}", folder, error.message()));
    }
    const std::string list = list_of_meshes(folder);
    // An old list would describe different files until it is rewritten.
    fs::remove(list, error);
    const cda::Tiles& tiles = *plan.tiles->tiles;
    const Vec3 centre = common_centre(survey);
    const std::string name = without_slash(folder).filename().string();
    std::vector<report::MeshFile> files;
    mesh::Seams seams;
    make_in_parallel(
        plan.threads, tiles.size(),
        [&](std::size_t tile) {
            MadeMesh made;
            cda::Boundary surface = tiles.surface(tile, simulation.lattice);
            if (surface.faces.empty()) return made;
            simulation::name_motions(surface, simulation);
            std::ostringstream bytes;
            made.open = exporter::write_gltf_piece(bytes, surface, simulation.provenance, centre);
            made.bytes = std::move(bytes).str();
            made.file = {fmt::format("{}/{:04}.glb", name, tile), setup::digest_of(made.bytes),
                         cda::bounds(surface), surface.faces.size(), made.open.size()};
            return made;
        },
        [&](std::size_t tile, const MadeMesh& made) {
            if (made.bytes.empty()) return;
            seams.add(made.open);
            outputs.write_now((fs::path(folder) / fmt::format("{:04}.glb", tile)).string(),
                              [&](std::ostream& out) { out << made.bytes; });
            files.push_back(made.file);
        });
    if (seams.open() > 0) {
        throw std::runtime_error(fmt::format(
            "the meshes of the tiles do not fit together: {} edges have no partner", seams.open()));
    }
    outputs.write(list, [&](std::ostream& out) {
        report::write_mesh_list(out, simulation.provenance.program, centre, files);
    });
}

}  // namespace ncsim::app
