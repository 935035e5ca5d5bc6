// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keyword arguments of the Python functions.
#pragma once

#include "ncsim/setup/job_options.h"
#include "ncsim/simulation/plan_reader.h"
#include "ncsim/verify/selection.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace ncsim::python {

/// Program, set-up and accuracy, of all functions.
struct Request {
    setup::JobOptions job;
    simulation::SimulationOptions accuracy;
    std::string machine;  ///< Machine file; empty: none.
    /// Text of the program, which then has the name job.program; empty: job.program is a file.
    std::optional<std::string> text;
};

/// Measured removed volumes: the total, by tool, or by block.
enum class Volumes : std::uint8_t { Total, ByTool, ByBlock };

/// Arguments of ncsim.simulate().
struct SimulateRequest : Request {
    std::optional<std::uint32_t> at_line;
    double resolution = 0.0;  ///< For a model with resolution, mm; 0: suitable for the stock.
    Volumes volumes = Volumes::Total;
    bool allows_errors = false;  ///< Blocks with errors do not raise ncsim.ProgramError.
};

/// Arguments of ncsim.check().
struct CheckRequest : Request {
    verify::Selection selection;
    std::string baseline, design;  ///< Files; empty: none.
    double design_tolerance = 0.1;
    std::optional<bool> dog_leg;
    bool detached_pieces = false, air_cuts = false, warnings_as_errors = false, ledger = false;
};

/// Convert keyword arguments. `program` is a path or the name of `text`.
/// Throws: UsageFailure for an unusable value; pybind11::type_error for an unknown argument or a
/// value of another type.
SimulateRequest simulate_request(std::string program, std::optional<std::string> text,
                                 const pybind11::dict& arguments);
CheckRequest check_request(std::string program, std::optional<std::string> text,
                           const pybind11::dict& arguments);

}  // namespace ncsim::python
