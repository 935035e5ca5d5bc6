// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim machine`: how a machine is built, as a file tells it.
#pragma once

#include "options/cli.h"

#include <string>
#include <vector>

namespace ncsim::app {

struct MachineOptions {
    std::string machine;  ///< What is read.
    std::string save;     ///< A machine.toml to write; empty: not asked for.
    std::string png;      ///< A picture to write; empty: not asked for.
    std::string view = "iso";
    std::vector<std::string> transparent;  ///< Links in the picture.
    std::string pose;  ///< "A30,C45": where the tip is then; empty: not asked for.
};

cli::App* add_machine(cli::App& app, MachineOptions& options);

/// Throws std::runtime_error for what cannot be read or written.
int run(const MachineOptions& options);

}  // namespace ncsim::app
