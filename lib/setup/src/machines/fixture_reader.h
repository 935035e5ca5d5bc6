// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fixtures in machine files and job files: boxes, meshes, and vises and clamps by their sizes.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/verify/machine_description.h"

#include "files/toml_reader.h"

#include <string>
#include <vector>

namespace ncsim::setup {

/// Reads a table [[fixture]] and adds its bodies to `fixtures`: one for a box or a mesh, several
/// for a vise or a clamp. Meshes are relative to `folder`.
///
///     vise = { at = [0, 0, -30], along = "Y", opening = 50, jaw_width = 120, jaw_height = 40,
///              jaw_depth = 25, base_height = 60, parallels = [8, 30] }
///
/// `at` is the middle between the jaws, at the height of the bed. `along` is the direction of
/// clamping, X or Y. `jaw_depth` is the thickness of a jaw in this direction. `parallels` are two
/// bars along the jaws: thickness and height. A base below the bed has the length and the width of
/// the vise.
///
///     clamp = { at = [-40, 0, 0], toward = "-X", length = 80, width = 25, height = 15,
///               table = -20, heel = 20, bolt = [40, 12, 30] }
///
/// `at` is the middle of the lower edge at the tip, which presses on the part. The arm extends from
/// there by `length` in the direction `toward`. With `table`, the height of the table, a block of
/// length `heel` supports the far end. `bolt`: distance from the tip, diameter of the nut, height
/// above the arm.
///
/// Throws: std::runtime_error with file, line and column.
void read_fixture(const TomlReader& r, const std::string& folder, InputSet& inputs,
                  const TomlTable& t, std::vector<verify::Fixture>& fixtures);

}  // namespace ncsim::setup
