// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes job files: the set-up of a run, and a first job for the user to complete.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/setup/job_file.h"

#include <cstdint>
#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace ncsim::setup {

/// Remarks of one line each that explain the values of a job file.
struct JobRemarks {
    std::string stock;
    std::vector<std::vector<std::string>> tools;  ///< Remarks for each tool of JobFile::tools.
    /// Undescribed tools, to be filled in, and the line of their first move.
    std::map<int, std::uint32_t> unknown_tools;
};

/// A set-up of a first job file, for write_first_job().
struct FirstSetUp {
    std::string name, program;
    std::string zero;  ///< Coordinate system of the first cut: "G54".
    Vec3 start{};      ///< Tool position at the start, in G54.
    bool start_is_specified = false;
    double height = 0.0;  ///< Height of the stock; the move of a part that is turned over.
};

/// Writes a first job file for the user to complete: the stock, the tools and the defaults of
/// `file`, and set-ups. Each value that no file specifies is in a list `assumed`, with a comment
/// that says what to measure.
void write_first_job(std::ostream& out, const JobFile& file, const JobRemarks& remarks,
                     const std::vector<FirstSetUp>& set_ups);

/// Writes a tool table for LinuxCNC with the length offset, the diameter, and kind and shape in the
/// remark, from which toolpath::read_tool_file() reads them. Lengths are in inches if `inches`,
/// otherwise in mm.
void write_tool_table(std::ostream& out, const std::vector<toolpath::ToolEntry>& tools,
                      bool inches);

/// Writes a file for parse_job_file(). Paths are written as in `file`.
void write_job_file(std::ostream& out, const JobFile& file, const JobRemarks& remarks);

/// Writes a first ncsim.toml, with a section to be completed for each folder with programs.
/// `folders`: relative to the folder of the file.
void write_first_project(std::ostream& out, const std::set<std::string>& folders);

}  // namespace ncsim::setup
