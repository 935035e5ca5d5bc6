// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a tool is watched for while it moves: its parts as bodies of their own.
#pragma once

#include "ncsim/verify/setup.h"

#include "body.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::verify {

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
    std::vector<Body> too_high;            ///< What cuts, but above the limit of depth,
    std::vector<Body> within;              ///< and what cuts below it.
    std::vector<Body> uncertain;           ///< What cuts above the flutes that there certainly are,
    std::vector<Body> certain;             ///< and those.
    double uncertain_mm = 0.0;             ///< How much of that was needed so far,
    Place uncertain_place;                 ///< and where first.
    std::vector<cda::Vec3> probes_T;       ///< Points strictly inside the cutting pieces.
    bool prism = true;                     ///< All of what cuts.
    bool widens = true;                    ///< What cuts is nowhere narrower above.
    /// What cuts is a cylinder above the flutes that there certainly are.
    bool straight_above = false;
    std::optional<toolpath::Cutter> inscribed;  ///< The cutter, for certainty.
};

/// Bodies on `lattice`. Rule by rule: what none of them asks for is left out.
Watched watch(const ToolFacts& facts, const Selection& selection, const cda::Lattice& lattice,
              const toolpath::ToolAccuracy& accuracy);

}  // namespace ncsim::verify
