// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `--save-job` writes: everything a program stood on, so that it can be run again.
#pragma once

#include "ncsim/setup/job.h"
#include "ncsim/simulation/survey.h"

#include <iosfwd>
#include <string>

namespace ncsim::app {

/// The tools, the stock and the reading of the program as they were used, also what had to be
/// assumed (with a comment that says so). `path` is where it will stand: the program is named as
/// seen from there.
void save_job(std::ostream& out, const setup::Job& job, const simulation::Survey& survey,
              const std::string& path);

}  // namespace ncsim::app
