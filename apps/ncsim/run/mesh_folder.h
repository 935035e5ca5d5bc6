// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of a part that was cut in tiles, in a file a tile.
#pragma once

#include "ncsim/simulation/simulate.h"

#include "system/output.h"

#include <string>

namespace ncsim::app {

/// Does `--gltf` name a folder for them: "mold/", or one that is there?
bool names_a_folder(const std::string& path);
/// "mold/" → "mold.json"
std::string list_of_meshes(const std::string& folder);

/// One of them after the other, each as it is whole; then what stands in list_of_meshes(), which is
/// reserved in `outputs`. Holds as many of them as there are threads. Throws std::runtime_error
/// where not every edge has its partner.
void write_mesh_folder(const std::string& folder, const simulation::Plan& plan,
                       const simulation::Survey& survey, const simulation::Simulation& simulation,
                       OutputSet& outputs);

}  // namespace ncsim::app
