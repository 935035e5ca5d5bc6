// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded NC programs with tools and stock, as bad as people's and worse: stock of odd size near and
// far from the origin, passes that touch, moves that differ by a hundredth of a micrometre, thin
// walls, all kinds of tools. And what is left of the stock.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/export/provenance.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::test {

struct NcProgram {
    std::string text;
    std::string stock;               ///< As for --stock.
    std::vector<std::string> tools;  ///< As for --tool.
    double tolerance_mm = 0.005;
    double tool_tolerance_mm = 0.05;
};

/// `rotary`: some moves turn A, B or C. The same program in every run, on every machine.
NcProgram random_program(std::uint64_t seed, bool rotary = false);

struct MilledPart {
    cda::Boundary boundary;
    exporter::Provenance provenance;
    double volume = 0.0;  ///< As the aggregate says, mm³.
};

/// Runs the program. Throws std::runtime_error if the program, its stock or its tools are wrong.
MilledPart mill(const NcProgram& program, const cda::WorkpieceModel& prototype);

}  // namespace ncsim::test
