// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output of `--save-job`: all inputs of a run, for a repetition.
#pragma once

#include "ncsim/setup/job.h"
#include "ncsim/simulation/survey.h"

#include <iosfwd>
#include <string>

namespace ncsim::app {

/// Writes the tools, the stock and the settings that were used. Assumed values have a comment.
/// `path` is the final path of the file; the path of the program is relative to it.
void save_job(std::ostream& out, const setup::Job& job, const simulation::Survey& survey,
              const std::string& path);

}  // namespace ncsim::app
