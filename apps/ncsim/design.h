// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is the part what it was meant to be?
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/verify/finding.h"

#include "pipeline.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

struct Design {
    std::string path;  ///< As given on the command line.
    cda::TriangleMesh mesh;
    double tolerance_mm = 0.0;
};

/// What came out of the comparison, beside the findings; see verify/design.h. mm, mm³.
struct DesignFacts {
    std::string path;
    double tolerance_mm = 0.0, resolution_mm = 0.0, deviation_mm = 0.0;
    struct Side {
        double largest_mm = 0.0;  ///< 0: nothing beyond the tolerance.
        std::optional<double> volume_mm3;
        std::size_t regions = 0;
    };
    Side gouge, excess;
};

/// Findings of the rules gouge and excess, one for each region, at the line that cut the part
/// at its deepest point (at no line where only the stock's own faces are). What could be gouged by
/// no more than the tool and the chords of arcs are off is not certain. `simulation` must have kept
/// its cuts.
std::vector<verify::Finding> compare_with(const Design& design, const Simulation& simulation,
                                          DesignFacts& facts);

/// "part.stl within 0.1 mm: nothing beyond; farthest apart 0.03 mm": a line for people.
std::string text_of(const DesignFacts& facts);

}  // namespace ncsim::app
