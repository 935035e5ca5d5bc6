// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed surfaces in files exported by CAD systems: fixtures, designs.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/setup/input.h"

#include <string>
#include <vector>

namespace ncsim::setup {

/// Largest distance between the triangles and the surfaces of a STEP file, mm.
inline constexpr double kStepDeflectionMm = 0.01;

/// Content of a surface file.
struct SurfaceFile {
    TriangleMesh mesh;
    /// Names of the faces that mesh.face counts; empty if the file has no faces.
    std::vector<std::string> face_names{};
    /// Largest distance between the mesh and the body that the file describes.
    double deflection_mm = 0.0;
    bool has_unit = false;  ///< True if the file specifies its unit; otherwise lengths are in mm.
    std::string assumed{};  ///< Assumptions of the run of ncsim that wrote the file; empty if none.
};

/// Reads a closed surface. The first bytes decide the format:
///
/// - STL (binary or text), OBJ and VRML97, with lengths in mm; polygons become triangles;
/// - binary glTF 2.0 (.glb): metres with y up become millimetres with z up, so a file of ncsim run
///   --gltf returns to its place;
/// - STEP with any unit, if the program ncsim-step is installed; the solids of all parts and
///   assemblies are read.
///
/// Corners with the same coordinates are merged, and triangles without area that result are
/// removed.
///
/// Throws: std::runtime_error with the name of the file if it cannot be read, has another format,
/// uses an unsupported feature (compressed meshes), or if its surface is not closed (every edge has
/// as many triangles on one side as on the opposite side; surfaces may touch) or is turned inside
/// out.
SurfaceFile read_surface_file(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
