// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output of `--save-job`: all inputs of a run, for a repetition.
#pragma once

#include "ncsim/setup/job.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/job_writer.h"
#include "ncsim/simulation/survey.h"

#include <iosfwd>
#include <string>

namespace ncsim::app {

/// A job file with its remarks.
struct DescribedJob {
    setup::JobFile file;
    setup::JobRemarks remarks;
};

/// Returns the tools, the stock and the settings that were used, for the file `path`.
DescribedJob describe_job(const setup::Job& job, const simulation::Survey& survey,
                          const std::string& path);
/// Returns the path of a file, relative to the folder of `job_file`.
std::string path_from(const std::string& job_file, const std::string& path);

/// Writes the tools, the stock, the fixtures and the settings that were used. Assumed values have a
/// comment. `machine` is a path, empty if there is none. `path` is the final path of the file; all
/// paths in the file are relative to its folder.
/// Throws: std::runtime_error if a fixture is a mesh.
void save_job(std::ostream& out, const setup::Job& job, const simulation::Survey& survey,
              const std::string& machine, const std::string& path);

}  // namespace ncsim::app
