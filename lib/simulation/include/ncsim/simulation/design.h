// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is the part what it was meant to be?
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/report/design_facts.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/finding.h"

#include <string>
#include <vector>

namespace ncsim::simulation {

struct Design {
    std::string path;  ///< As given on the command line.
    cda::TriangleMesh mesh;
    double tolerance_mm = 0.0;
    std::vector<std::string> face_names{};  ///< Of the faces that mesh.face counts, if it has any.
    /// How far the triangles may be from the design, less than the tolerance. What is beyond the
    /// tolerance less this is found.
    double deflection_mm = 0.0;
    std::string assumed{};  ///< Assumptions of the run that wrote the file; empty: none.
};

/// Findings of the rules gouge and excess, one for each region, at the line that cut the part
/// at its deepest point (at no line where only the stock's own faces are). What could be gouged by
/// no more than the tool and the chords of arcs are off is not certain. `simulation` must have kept
/// its cuts.
std::vector<verify::Finding> compare_with(const Design& design, const Simulation& simulation,
                                          report::DesignFacts& facts);

}  // namespace ncsim::simulation
