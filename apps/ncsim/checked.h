// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program, verified: from a path to a verdict, whatever is wrong with it.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/verdict.h"

#include "check_options.h"
#include "design.h"
#include "machine_file.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::app {

/// What a page shows beside the verdict.
struct Look {
    std::string source;                ///< The program.
    cda::TriangleMesh mesh;            ///< Of the part; empty if nothing was simulated.
    std::vector<std::uint32_t> lines;  ///< For each triangle the line that cut it; 0: the stock.
    std::vector<std::pair<std::string, std::string>> pictures;  ///< Name and PNG.
};

struct Checked {
    std::string path;  ///< As given on the command line.
    int exit_code = kClean;
    std::string_view word = "not-verified";  ///< "clean", "not-proven", "failed".
    /// Why there is no verdict: it could not be read, or something broke. Empty: there is one.
    std::string failure;
    verify::Verdict verdict;
    /// For each finding the line it points at, as written; empty where there is none.
    std::vector<std::string> lines;
    bool simulated = false;
    std::string not_simulated;  ///< Why not.
    std::string stock;          ///< What it was verified against, in words.
    std::string time;           ///< How long it takes, in words; empty: it does not move.
    std::uint64_t moves = 0;
    std::optional<DesignFacts> design;  ///< Only where the part was compared with one.
    std::optional<Look> look;           ///< Only where a page was asked for.
};

/// Reads and verifies `path`. Never throws: what is wrong is in the result. The result depends on
/// the file and the options only. `design` may be null. `threads` evaluate at a time. Gives up when
/// it is asked to `stop`.
Checked check_program(const std::string& path, const CheckOptions& options,
                      const MachineFile& machine, const Design* design, unsigned threads,
                      InputSet& inputs, std::stop_token stop);

/// The path of rapid moves that was asked for, at the machine's rates if it tells all of them.
toolpath::RapidPath rapid_path(const CheckOptions& options,
                               const verify::MachineDescription& machine);

}  // namespace ncsim::app
