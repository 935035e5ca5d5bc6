// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surface of a part that was cut in tiles, with a file for each tile.
#pragma once

#include "ncsim/simulation/simulate.h"

#include "system/output.h"

#include <string>

namespace ncsim::app {

/// True if `--gltf` names a folder for meshes: "mold/", or an existing folder.
bool names_a_folder(const std::string& path);
/// Returns the list file: "mold/" → "mold.json".
std::string list_of_meshes(const std::string& folder);

/// Writes the meshes in the order of the tiles, each completely or not at all, then
/// list_of_meshes(), which is reserved in `outputs`. Holds at most as many meshes as threads.
/// Throws: std::runtime_error if an edge has no partner.
void write_mesh_folder(const std::string& folder, const simulation::Plan& plan,
                       const simulation::Survey& survey, const simulation::Simulation& simulation,
                       OutputSet& outputs);

}  // namespace ncsim::app
