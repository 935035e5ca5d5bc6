// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plan of a request, with the inputs that the plan reads later.
#pragma once

#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/plan.h"

#include "program_text.h"
#include "request.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace ncsim::python {

/// Plan with its inputs: subprograms are read while the program is followed.
struct PreparedPlan {
    std::unique_ptr<ProgramText> inputs;
    simulation::Plan plan;
    std::optional<setup::MachineFile> machine;  ///< Machine file, and the fixtures of the job.
};

/// Reads the files of `request`.
/// Throws: UsageFailure with the fault of a file.
PreparedPlan prepare(const Request& request, const std::stop_token& stop);

}  // namespace ncsim::python
