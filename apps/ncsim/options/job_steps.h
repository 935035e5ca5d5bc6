// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of a job that a command is about.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/setup/job_file.h"

#include "options/program_options.h"

#include <cstddef>
#include <vector>

namespace ncsim::app {

/// A program of a job, with the number of its step.
struct ChosenStep : setup::JobStep {
    std::size_t number = 0;  ///< Number from 0, like JobOptions::job_step.
};

/// Returns the steps of options.job that options.set_up selects; all steps without a selection.
/// Empty if there is no job, if options.program selects a program, or if the job has no set-ups and
/// names no program.
/// Throws: std::runtime_error if no set-up has the number or name.
std::vector<ChosenStep> chosen_steps(const ProgramOptions& options, setup::InputSet& inputs);

/// True if a command is about the programs of a job, of which none is selected yet. A job in a pipe
/// has only one program.
bool has_steps_to_do(const ProgramOptions& options);

/// Reads the programs and set-ups of the chosen steps, so that faults are found before any output
/// is written.
/// Throws: as setup::read_job().
void read_ahead(const ProgramOptions& options, const std::vector<ChosenStep>& steps,
                setup::InputSet& inputs);

/// Returns the worse of two exit codes. Not proven ranks between clean and faulty.
int worse_code(int a, int b);

}  // namespace ncsim::app
