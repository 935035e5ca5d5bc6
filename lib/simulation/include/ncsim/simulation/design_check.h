// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the part with its design.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/setup/input.h"
#include "ncsim/simulation/design_facts.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/finding.h"

#include <string>
#include <vector>

namespace ncsim::simulation {

/// A design and its tolerance.
struct Design {
    std::string path;  ///< Path on the command line.
    TriangleMesh mesh;
    double tolerance_mm = 0.0;
    std::vector<std::string> face_names{};  ///< Names of the faces that mesh.face counts, if any.
    /// Largest distance between the triangles and the design, less than the tolerance. Deviations
    /// of more than tolerance minus this value are found.
    double deflection_mm = 0.0;
    std::string assumed{};  ///< Assumptions of the run that wrote the file; empty if none.
};

/// Reads the design in the surface file `path`.
/// Throws: as setup::read_surface_file().
Design read_design(const std::string& path, double tolerance_mm, setup::InputSet& inputs);
/// Returns the smallest tolerance with which `design` can be compared, mm.
double smallest_tolerance(const Design& design);
/// Throws: std::runtime_error if the tolerance of `design` is smaller; the message names
///     --design-tol.
void require_tolerance(const Design& design);

/// Returns findings of the rules gouge and excess, one per region, at the line that cut the part at
/// the deepest point (no line if only faces of the stock are there). A gouge within the error of
/// the tool and of the chords of arcs is not certain. Requires: `simulation` kept its cuts.
std::vector<verify::Finding> compare_with(const Design& design, const Simulation& simulation,
                                          DesignFacts& facts);

}  // namespace ncsim::simulation
