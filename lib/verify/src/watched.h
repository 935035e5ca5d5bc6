// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a tool is watched for while it moves: its parts as bodies of their own.
#pragma once

#include "ncsim/verify/setup.h"

#include "body.h"
#include "passes.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::verify {

// Of what cuts, that above some height, which had better have nothing to cut.
struct Above {
    double from_mm = 0.0;      ///< Above the tip.
    std::vector<Body> bodies;  ///< What cuts above that height,
    std::vector<Body> below;   ///< and what cuts below it.
};

struct Watched {
    struct Part {
        std::size_t piece;  ///< Index into Tool::pieces.
        Body body;
        double raise_mm = 0.0;  ///< Needed so far.
    };
    std::vector<Part> bodies;              ///< Shanks and holders.
    std::optional<Body> core;              ///< What does not cut at the centre,
    std::optional<cda::Vec3> aside_since;  ///< where the tool was when it had last been aside,
    double fallen_mm = 0.0;                ///< and how far it has come down on it since.
    Above too_high;                        ///< The limit of depth.
    Above uncertain;                       ///< The flutes that there certainly are.
    double uncertain_mm = 0.0;             ///< How much of that was needed so far,
    Place uncertain_place;                 ///< and where first.
    std::optional<Body> wall;              ///< A thread mill and the depth of its thread around it.
    std::optional<Body> mouth;        ///< Column of the largest diameter, from the tip upwards.
    std::optional<Body> tip;          ///< Flat tip of a chamfer mill.
    std::vector<cda::Vec3> probes_T;  ///< Points strictly inside the cutting pieces.
    bool prism = true;                ///< All of what cuts.
    bool widens = true;               ///< What cuts is nowhere narrower above.
    /// What cuts is a cylinder of its largest radius from here on, mm above the tip.
    double straight_from_mm = 0.0;
    Passes passes;                              ///< Of what cuts.
    std::optional<toolpath::Cutter> inscribed;  ///< The cutter, for certainty.
};

/// Bodies on `lattice`. Rule by rule: what none of them asks for is left out.
Watched watch(const ToolFacts& facts, const Selection& selection, const cda::Lattice& lattice,
              const toolpath::ToolAccuracy& accuracy);

}  // namespace ncsim::verify
