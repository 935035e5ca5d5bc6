// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of a verification: selected rules, machine, design, known findings.
#pragma once

#include "ncsim/report/baseline.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/design.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/machine_bodies.h"
#include "ncsim/verify/selection.h"

#include <memory>

namespace ncsim::simulation {

/// Contacts of all tiles of a part, and the part if it was cut.
struct SeenTiles {
    std::shared_ptr<const CutTiles> cut;  ///< Null: nothing had to be simulated.
    std::shared_ptr<const verify::Evidence> evidence;
};

/// Options of a verification, and the set-up except for the job.
struct Questions {
    verify::Selection selection;
    setup::MachineFile machine;
    /// Its links in pieces, which takes a while; null: check() makes them, for each program anew.
    std::shared_ptr<const verify::MachineBodies> bodies;
    const Design* design = nullptr;  ///< What the part is to be; null: nobody tells.
    /// Findings that were accepted before; null: none.
    const report::Baseline* baseline = nullptr;
    bool dog_leg = false;             ///< Rapid moves go axis by axis.
    bool is_rapid_specified = false;  ///< The user specifies `dog_leg`.
    bool cut_free = false;            ///< Look for pieces that are cut free.
    bool air_cuts = false;            ///< Look for feed moves that remove nothing.
    bool ledger = false;              ///< Keep a row a block, with exact volumes.
    bool look = false;                ///< Show the part, too; with the ledger.
    bool warnings_as_errors = false;
    /// Tools in the options of the job are this program's: one that it does not move is a doubt.
    bool tools_are_meant = true;
    /// Tiles of the part, which were asked before, by check_tile(); null: the part is cut now.
    /// Neither `ledger` nor `look` then.
    std::shared_ptr<const SeenTiles> tiles;
};

}  // namespace ncsim::simulation
