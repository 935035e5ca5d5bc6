// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of a tool that are watched during a motion.
#pragma once

#include "ncsim/verify/setup.h"

#include "body.h"
#include "passes.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::verify {

// Cutter above a height at which it should meet no material.
struct FlutesAbove {
    double from_mm = 0.0;      ///< Above the tip.
    std::vector<Body> bodies;  ///< Cutter above the height.
    std::vector<Body> below;   ///< Cutter below the height.
};

struct ToolMonitors {
    struct Part {
        std::size_t piece;  ///< Index into Tool::pieces.
        Body body;
        double raise_mm = 0.0;  ///< Needed so far.
    };
    std::vector<Part> bodies;         ///< Shanks and holders.
    std::optional<Body> core;         ///< Core, which does not cut.
    std::optional<Vec3> aside_since;  ///< Position at which the tool last was aside.
    double fallen_mm = 0.0;           ///< Length of the descent on the core since.
    FlutesAbove too_high;             ///< Limit: the permitted depth.
    FlutesAbove uncertain;            ///< Limit: the certain flute length.
    double uncertain_mm = 0.0;        ///< Length of uncertain flutes needed so far.
    Place uncertain_place;            ///< First block that needed uncertain flutes.
    std::optional<Body> wall;         ///< Thread mill, enlarged by the depth of its thread.
    std::optional<Body> mouth;        ///< Column of the largest diameter above the tip.
    std::optional<Body> tip;          ///< Flat tip of a chamfer mill.
    std::vector<Vec3> probes_T;       ///< Points strictly inside the cutting pieces.
    bool prism = true;                ///< All cutting pieces are prisms.
    bool widens = true;               ///< The cutter is nowhere narrower above.
    /// Height above the tip (mm) from which the cutter is a cylinder of its largest radius.
    double straight_from_mm = 0.0;
    Passes passes;                              ///< Passes of the cutter.
    std::optional<toolpath::Cutter> inscribed;  ///< Inscribed cutter, for certainty.
};

/// Creates the bodies of a tool on `lattice`, without bodies that no selected rule needs.
ToolMonitors watch(const ToolFacts& facts, const Selection& selection, const cda::Lattice& lattice,
                   const toolpath::ToolAccuracy& accuracy);

}  // namespace ncsim::verify
