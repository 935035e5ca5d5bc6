// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is to be simulated, and how: what options become.
#pragma once

#include "ncsim/report/facts.h"
#include "ncsim/setup/budget.h"
#include "ncsim/setup/job.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/toolpath/machine.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace ncsim::simulation {

/// Lengths in mm.
struct Plan {
    setup::Job job;
    std::string model = "cda";     ///< Of models().
    double resolution = 0.0;       ///< Of a model that has one; 0: the one that suits the stock.
    double tolerance = 0.005;      ///< Of chords and of turning tools.
    double tool_tolerance = 0.05;  ///< Of round tools.
    /// Moves in a row become one where they stay that near to a line; 0: none do.
    double join_tolerance = 0.0;
    /// A first look: tools that nobody describes are guessed.
    bool draft = false;
    /// How the machine turns, if somebody tells it; and with the program's zero, once it was
    /// surveyed.
    std::optional<setup::ToldKinematics> kinematics;
    std::shared_ptr<const toolpath::Kinematics> placed;
    /// Line of the program after which the simulation stops; from 1.
    std::optional<std::uint32_t> at_line;
    unsigned threads = 0;  ///< 0: as many as the machine has.
    setup::Budget budget;

    // What is kept beside the part.
    bool keep_boundary = false;
    bool keep_paths = false;     ///< Of the tip.
    bool keep_carved = false;    ///< The cells that were taken away, of tools that contain theirs.
    bool block_volumes = false;  ///< What each block removed, which is several times the work.
    bool hull_times =
        false;  ///< What each hull cost; only models that show their cells measure it.
};

/// Throws std::invalid_argument, which names the model, if programs are not verified with it.
void require_verifying(const Plan& plan);

/// How it is cut, for reports.
report::CuttingFacts cutting_facts(const Plan& plan);

}  // namespace ncsim::simulation
