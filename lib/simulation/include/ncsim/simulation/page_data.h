// SPDX-License-Identifier: GPL-3.0-or-later
//
// The finished part, fixtures and pictures for the page of a program.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/checked.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/play_recorder.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/machine_description.h"

#include <span>

namespace ncsim::simulation {

/// Returns part, source and fixtures; pictures for readers without JavaScript if `has_pictures`.
/// Requires: `simulation` kept the cuts; `boundary` is the surface of the part.
PageData page_data(const Plan& plan, const Survey& survey, const Simulation& simulation,
                   const cda::Boundary& boundary, std::span<const verify::Fixture> fixtures,
                   bool has_pictures);

/// Completes the data of `play` with the lines of `simulation`.
PlayData finish_play(PlayRecorder& play, const Simulation& simulation);

}  // namespace ncsim::simulation
