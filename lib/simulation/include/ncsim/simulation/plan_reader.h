// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the files that the options of a job name, and makes the plan of their simulation.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/setup/job_options.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/toolpath/stock.h"

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

namespace ncsim::simulation {

/// Accuracy, model and limits of a simulation. Lengths in mm.
struct SimulationOptions {
    std::string model;             ///< A name in models(); empty: chosen automatically.
    double tolerance = 0.005;      ///< Tolerance of chords and of rotary moves.
    double tool_tolerance = 0.05;  ///< Tolerance of round tools.
    bool tolerance_specified = false, tool_tolerance_specified = false;
    unsigned threads = 0;        ///< 0: number of cores.
    double max_memory_gb = 0.0;  ///< 10^9 bytes; 0: available memory.
    double max_seconds = 0.0;    ///< 0: unlimited.
};

/// Stocks that the programs of a job leave, for all copies of the options. All members may be
/// called from several threads.
class LeftStocks {
public:
    using Make = std::function<toolpath::Stock(setup::InputSet&)>;
    /// Returns the stock of the program `step`. `make` cuts it on the first call, and again if a
    /// file that it reads has changed; every call reads these files through `inputs`.
    toolpath::Stock of(std::size_t step, setup::InputSet& inputs, const Make& make);

private:
    struct Left {
        toolpath::Stock stock;
        setup::ReadFiles files;
    };
    std::recursive_mutex mutex_;  // `make` needs the stock of the step before
    std::map<std::size_t, Left> left_;
};

/// Reads the files that `job` names and returns the plan. For a later step of a job with set-ups,
/// the earlier steps are cut first, on `machine` (a file; empty: none); their part is the stock and
/// is kept in `left_stocks`. `stop` ends their simulation.
/// Throws: as setup::read_job(); std::runtime_error if an earlier step leaves no part.
Plan read_plan(setup::JobOptions job, const SimulationOptions& options, const std::string& machine,
               LeftStocks& left_stocks, setup::InputSet& inputs, const std::stop_token& stop = {});

/// Reads the machine file `path` (empty: none) and adds the fixtures of `job`. Empty if there are
/// neither.
std::optional<setup::MachineFile> machine_for(const std::string& path, const setup::Job& job,
                                              setup::InputSet& inputs);

}  // namespace ncsim::simulation
