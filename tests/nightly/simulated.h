// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulates a program as `ncsim run` does: from text and options to the part.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/simulate.h"

#include "nightly/judge.h"
#include "nightly/program_generator.h"

#include <string>
#include <vector>

namespace ncsim::nightly {

/// Temporary folder in which programs are written and read, removed by the destructor.
class ProgramFile {
public:
    ProgramFile();
    ~ProgramFile();
    ProgramFile(const ProgramFile&) = delete;
    ProgramFile& operator=(const ProgramFile&) = delete;

    /// Simulates `program` with its options and `more`.
    /// Throws: std::runtime_error if ncsim reports an error, because generated programs are
    /// correct.
    simulation::Simulation run(const Program& program, const std::vector<std::string>& more) const;

private:
    std::string folder_;
    std::string path_;
};

StatedAccuracy stated_accuracy(const simulation::Simulation& simulation, const Program& program);

/// Returns a hash of all data of a boundary, to the last bit.
std::uint64_t hash_of(const cda::Boundary& boundary);

}  // namespace ncsim::nightly
