// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded NC programs with tools and stock, and the parts that the programs leave. The programs are
// harder than real programs: stock of odd size near and far from the origin, passes that touch,
// moves that differ by 0.01 µm, thin walls, all kinds of tools.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/mesh/provenance.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::test {

struct NcProgram {
    std::string text;
    std::string stock;               ///< Value of --stock.
    std::vector<std::string> tools;  ///< Values of --tool.
    double tolerance_mm = 0.005;
    double tool_tolerance_mm = 0.05;
};

/// Returns the program of `seed`, identical in each run and on each machine. If `rotary`, some
/// moves turn A, B or C.
NcProgram random_program(std::uint64_t seed, bool rotary = false);

struct MilledPart {
    cda::Boundary boundary;
    mesh::Provenance provenance;
    double volume = 0.0;  ///< Volume according to the aggregate, mm³.
};

/// Runs the program.
/// Throws: std::runtime_error if the program, the stock or a tool is invalid.
MilledPart mill(const NcProgram& program, const cda::WorkpieceModel& prototype);

}  // namespace ncsim::test
