// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed surfaces from files, as CAD systems export them: fixtures, designs.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/setup/input.h"

#include <string>
#include <vector>

namespace ncsim::setup {

/// How near the triangles are to the surfaces of a STEP file, mm.
inline constexpr double kStepDeflectionMm = 0.01;

struct SurfaceFile {
    cda::TriangleMesh mesh;
    /// Of the faces that mesh.face counts; of files without any, none.
    std::vector<std::string> face_names{};
    double deflection_mm = 0.0;  ///< How far it may be from what the file means.
    bool has_unit = false;       ///< The file tells in which unit its lengths are; else in mm.
    std::string assumed{};       ///< Assumptions of the run of ncsim that wrote it; empty: none.
};

/// Reads STL, binary or text, OBJ and VRML97 with lengths in mm, binary glTF 2.0 (.glb; metres with
/// y up, which become millimetres with z up: what ncsim run --gltf writes comes back where it was),
/// or STEP with lengths in whatever unit it tells, if a program ncsim-step is there to do it. What
/// it is, its first bytes tell. Corners with the same coordinates become one; triangles without
/// area that this leaves are dropped. Polygons of OBJ and VRML become triangles. Of STEP the solids
/// of all parts and assemblies are taken.
///
/// Throws std::runtime_error, naming the file, if it cannot be read, is none of them, uses what
/// is not understood (compressed meshes), or if its surface is not closed (every edge has as many
/// triangles on one side as on the other; surfaces may touch) or turned inside out.
SurfaceFile read_surface_file(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
