// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies a program and returns the report as JSON.
#include "checked_program.h"

#include "ncsim/report/baseline.h"
#include "ncsim/report/make_entry.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/simulation/design_check.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/program_check.h"

#include "arrays.h"
#include "failures.h"
#include "interruptible.h"
#include "motion_records.h"
#include "prepared_plan.h"
#include "request.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::python {

namespace py = pybind11;

namespace {

// Report of a verification.
struct Verified {
    std::string json, text;
    std::shared_ptr<const std::vector<LedgerRecord>> ledger;  // null: not requested
};

// Files of a verification, in addition to those of the plan.
struct VerificationFiles {
    std::optional<simulation::Design> design;
    std::optional<report::Baseline> baseline;
    setup::MachineFile machine;
};

VerificationFiles read_files(const CheckRequest& request, setup::InputSet& inputs) {
    VerificationFiles files;
    try {
        if (!request.machine.empty()) files.machine = setup::read_machine(request.machine, inputs);
        if (!request.baseline.empty())
            files.baseline.emplace(request.baseline, inputs.read(request.baseline));
        if (!request.design.empty())
            files.design =
                simulation::read_design(request.design, request.design_tolerance, inputs);
    } catch (const std::runtime_error& e) {
        throw UsageFailure(e.what());
    }
    if (files.design && request.design_tolerance < simulation::smallest_tolerance(*files.design)) {
        throw UsageFailure(fmt::format("design_tolerance: {:g}: '{}' needs at least {:g} mm",
                                       request.design_tolerance, request.design,
                                       simulation::smallest_tolerance(*files.design)));
    }
    return files;
}

simulation::VerificationOptions options_of(const CheckRequest& request,
                                           const VerificationFiles& files, const setup::Job& job) {
    simulation::VerificationOptions options;
    options.selection = request.selection;
    options.machine = files.machine;
    options.bodies = simulation::bodies_of(options.machine);
    simulation::add_fixtures(options, job);
    options.design = files.design ? &*files.design : nullptr;
    options.baseline = files.baseline ? &*files.baseline : nullptr;
    options.dog_leg = request.dog_leg.value_or(false);
    options.is_rapid_specified = request.dog_leg.has_value();
    options.detached_pieces = request.detached_pieces;
    options.air_cuts = request.air_cuts;
    options.ledger = request.ledger;
    options.warnings_as_errors = request.warnings_as_errors;
    return options;
}

Verified verify_program(const CheckRequest& request, const std::stop_token& stop) {
    PreparedPlan prepared = prepare(request, stop);
    simulation::Plan& plan = prepared.plan;
    if (plan.model.empty()) plan.model = simulation::verifying_model().name;
    try {
        simulation::require_verifying(plan);
    } catch (const std::invalid_argument& e) {
        throw UsageFailure(fmt::format("model: {}", e.what()));
    }
    const VerificationFiles files = read_files(request, *prepared.inputs);
    report::Checked checked;
    checked.path = plan.job.program.name;
    checked.program = plan.job.label;
    const simulation::VerificationOptions options = options_of(request, files, plan.job);
    simulation::check(plan, options, checked);
    report::EntryOptions formats;
    formats.sarif = formats.junit = formats.github = false;
    const report::Entry entry = report::entry_of(checked, 0, formats);
    Verified verified{entry.json, entry.text, nullptr};
    if (request.ledger)
        verified.ledger = std::make_shared<const std::vector<LedgerRecord>>(
            ledger_records(checked.verdict.ledger));
    return verified;
}

// Returns the report as JSON, the report as text, and the ledger or None.
py::tuple check(const std::string& program, const std::optional<std::string>& text,
                const py::dict& arguments) {
    const CheckRequest request = check_request(program, text, arguments);
    const Verified verified =
        interruptible([&](const std::stop_token& stop) { return verify_program(request, stop); });
    if (verified.ledger) register_records();
    const py::object ledger =
        verified.ledger ? py::object(view_of(*verified.ledger, verified.ledger)) : py::none();
    return py::make_tuple(verified.json, verified.text, ledger);
}

}  // namespace

void define_check(py::module_& module) {
    module.def("check", &check, py::arg("program"), py::arg("text"), py::arg("arguments"));
}

}  // namespace ncsim::python
