// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim machine`: prints the structure of a machine, and the set-ups of a job on it.
#pragma once

#include "ncsim/export/camera.h"

#include "options/cli.h"

#include <string>
#include <vector>

namespace ncsim::app {

struct MachineOptions {
    std::string machine;  ///< Machine, or job that names a machine.
    std::string save;     ///< A machine.toml to write; empty: none.
    std::string png;      ///< A picture to write; empty: none.
    exporter::View view = exporter::View::Iso;
    std::vector<std::string> transparent;  ///< Links in the picture.
    std::string pose;  ///< "A30,C45": prints the tip for these axes; empty: none.
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, MachineOptions& options);

/// Prints the machine and writes the outputs.
/// Throws: std::runtime_error if a file cannot be read or written.
int run(const MachineOptions& options);

}  // namespace ncsim::app
