// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program, run through ncsim as `ncsim run` does it: from its text and options to the part.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/simulate.h"

#include "nightly/judge.h"
#include "nightly/program_generator.h"

#include <string>
#include <vector>

namespace ncsim::nightly {

/// Where programs are written to before they are read. Disappears with it.
class ProgramFile {
public:
    ProgramFile();
    ~ProgramFile();
    ProgramFile(const ProgramFile&) = delete;
    ProgramFile& operator=(const ProgramFile&) = delete;

    /// With these options in addition to the program's own. Throws std::runtime_error if anything
    /// about the program is an error: what is generated is right.
    simulation::Simulation run(const Program& program, const std::vector<std::string>& more) const;

private:
    std::string folder_;
    std::string path_;
};

StatedAccuracy stated_accuracy(const simulation::Simulation& simulation, const Program& program);

/// Of all that a boundary says, to the last bit.
std::uint64_t hash_of(const cda::Boundary& boundary);

}  // namespace ncsim::nightly
