// SPDX-License-Identifier: GPL-3.0-or-later
//
// Picture of `ncsim check --png`: a finding, with the bodies that meet where they meet.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/report/checked.h"
#include "ncsim/setup/input.h"

#include "check/check_settings.h"

#include <string>

namespace ncsim::app {

/// Draws finding `settings.options.finding` of `checked`; without a number, the first of the
/// gravest findings, collisions first. The part is as after the motion of the finding, or before a
/// rapid move. Without a finding, the finished part is drawn. Throws: std::runtime_error if there
/// is no finding with this number, the program was not
///     simulated, or the picture cannot be drawn.
/// Cost: one simulation without verification.
exporter::Image finding_picture(const std::string& program, const CheckSettings& settings,
                                const report::Checked& checked, setup::InputSet& inputs);

}  // namespace ncsim::app
