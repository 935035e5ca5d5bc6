// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of a verification: selected rules, machine, design, known findings.
#pragma once

#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/design_check.h"
#include "ncsim/simulation/known_findings.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/machine_bodies.h"
#include "ncsim/verify/selection.h"

#include <memory>

namespace ncsim::simulation {

/// Contacts of all tiles of a part, and the part if it was cut.
struct TileResults {
    std::shared_ptr<const CutTiles> cut;  ///< Null: nothing had to be simulated.
    std::shared_ptr<const verify::Evidence> evidence;
};

/// Options of a verification, and the set-up except for the job.
struct VerificationOptions {
    verify::Selection selection;
    setup::MachineFile machine;
    /// Links of the machine as prepared bodies, which takes time; null: check() prepares them for
    /// each program.
    std::shared_ptr<const verify::MachineBodies> bodies;
    const Design* design = nullptr;  ///< Design of the part; null if unspecified.
    /// Findings accepted before; null if none.
    const KnownFindings* baseline = nullptr;
    bool dog_leg = false;             ///< Rapid moves run axis by axis.
    bool is_rapid_specified = false;  ///< The user specifies `dog_leg`.
    bool detached_pieces = false;     ///< Search for pieces that are cut free.
    bool air_cuts = false;            ///< Search for feed moves that remove no material.
    bool ledger = false;              ///< Keep a row per block, with exact volumes.
    bool wants_page = false;          ///< Show the part, too; with the ledger.
    bool warnings_as_errors = false;
    /// True if the tools in the options of the job belong to this program: an unused tool is a
    /// doubt.
    bool tools_are_meant = true;
    /// Tiles of the part, from check_tile(); null: the part is cut by check().
    /// Requires: neither `ledger` nor `look` with tiles.
    std::shared_ptr<const TileResults> tiles;
};

}  // namespace ncsim::simulation
