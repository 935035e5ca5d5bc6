// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulates a program, and makes surface, solid and motions.
#include "simulated.h"

#include "ncsim/export/step.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/measure_sheet.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/part_measures.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/stock_history.h"

#include "arrays.h"
#include "failures.h"
#include "interruptible.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <sstream>
#include <utility>

namespace ncsim::python {

namespace py = pybind11;

namespace {

// Number of further cuts for measures, as in `ncsim measure`.
constexpr simulation::Refinement kRefinementToMeasure{2};

void set_results(simulation::Plan& plan, const SimulateRequest& request) {
    if (plan.model.empty()) plan.model = simulation::models().front().name;
    // Measuring the volume alone takes almost as long.
    plan.keep_boundary = true;
    plan.resolution = request.resolution;
    plan.at_line = request.at_line;
    plan.tool_volumes = request.volumes != Volumes::Total;
    plan.block_volumes = request.volumes == Volumes::ByBlock;
}

// Returns "part.nc:3:5: error: G2 needs a centre", for the first error.
std::string first_error(const gcode::Diagnostics& diagnostics, const std::string& program) {
    for (const gcode::Diagnostic& d : diagnostics) {
        if (d.severity != gcode::Severity::Error) continue;
        return fmt::format("{}:{}:{}: {}", d.file.empty() ? program : d.file, d.span.line,
                           d.span.column, d.message);
    }
    return program + ": the program was not simulated";
}

void append(gcode::Diagnostics& to, const gcode::Diagnostics& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Simulated::Simulated(const SimulateRequest& request, const std::stop_token& stop)
    : accuracy_(request.accuracy), prepared_(prepare(request, stop)) {
    simulation::Plan& plan = prepared_.plan;
    set_results(plan, request);
    if (prepared_.machine) not_used_ = simulation::apply_machine(plan, *prepared_.machine);
    survey_ = simulation::survey(plan);
    const std::string& program = plan.job.program.name;
    const auto fail = [&] {
        throw ProgramFailure(first_error(survey_.diagnostics, program), program,
                             survey_.diagnostics);
    };
    if (!survey_.is_ready()) fail();
    if (!request.allows_errors && gcode::has_errors(survey_.diagnostics)) fail();
    if (request.at_line && *request.at_line > survey_.interpretation.lines) {
        throw UsageFailure(fmt::format("at_line: {}: the program has {} lines", *request.at_line,
                                       survey_.interpretation.lines));
    }
    simulation::choose_rays(plan, survey_);
    simulation::choose_resolution(plan, survey_);
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    nothing.history = simulation::read_stock_history(*survey_.stock);
    result_ = simulation::simulate(plan, survey_, nothing, {});
    append(survey_.diagnostics, result_.diagnostics);
    if (!request.allows_errors && gcode::has_errors(result_.diagnostics)) fail();
}

const std::vector<std::string>& Simulated::assumed() {
    if (!assumed_) {
        const setup::MachineFile none;
        assumed_ = simulation::assumptions_of(prepared_.plan, survey_,
                                              prepared_.machine ? *prepared_.machine : none);
        result_.provenance.assumed = simulation::reasons_of(*assumed_);
    }
    return *assumed_;
}

std::vector<std::string> Simulated::assumptions() {
    const std::scoped_lock lock(mutex_);
    return assumed();
}

std::shared_ptr<MeshData> Simulated::mesh() {
    const std::scoped_lock lock(mutex_);
    if (!mesh_) {
        (void)assumed();  // recorded in STL files
        mesh_ = std::make_shared<MeshData>(
            mesh_data(*result_.boundary, result_.provenance, prepared_.plan.threads));
    }
    return mesh_;
}

std::shared_ptr<const std::vector<MotionRecord>> Simulated::motions() {
    const std::scoped_lock lock(mutex_);
    if (!motions_)
        motions_ =
            std::make_shared<const std::vector<MotionRecord>>(motion_records(prepared_.plan));
    return motions_;
}

std::shared_ptr<SolidData> Simulated::solid_with(const simulation::Refinement& limit,
                                                 const std::stop_token& stop) {
    std::shared_ptr<SolidData>& known = solids_[{limit.most_cuts, limit.has_budget}];
    if (known) return known;
    if (!simulation::find_model(prepared_.plan.model)->exact)
        throw UsageFailure(fmt::format(
            "model: '{}' is not exact; solids and measures need {}", prepared_.plan.model,
            simulation::model_names(
                [](const simulation::ModelInfo& model) { return model.exact; })));
    simulation::Plan plan = prepared_.plan;
    plan.budget = setup::Budget(accuracy_.max_memory_gb, accuracy_.max_seconds);
    plan.budget.stop_with(stop);
    simulation::Solid solid =
        simulation::refined_solid(plan, survey_, result_, exporter::kStepTolerance, limit);
    solid.provenance.assumed = simulation::reasons_of(assumed());
    return known = std::make_shared<SolidData>(std::move(solid));
}

std::shared_ptr<SolidData> Simulated::solid(int refinements, const std::stop_token& stop) {
    const std::scoped_lock lock(mutex_);
    return solid_with({refinements, false}, stop);
}

std::string Simulated::measures(const std::stop_token& stop) {
    const std::scoped_lock lock(mutex_);
    const std::shared_ptr<SolidData> data = solid_with(kRefinementToMeasure, stop);
    report::MeasureSheet sheet =
        simulation::measures_of(prepared_.plan, survey_, data->solid, *result_.boundary);
    sheet.program = prepared_.plan.job.program.name;
    std::ostringstream json;
    report::write_measures(json, sheet);
    return json.str();
}

namespace {

using SharedSimulation = std::shared_ptr<Simulated>;

py::object box_of(const Box& box) {
    if (box.is_empty()) return py::none();
    return py::make_tuple(py::make_tuple(box.min.x, box.min.y, box.min.z),
                          py::make_tuple(box.max.x, box.max.y, box.max.z));
}

// Returns the texts of the tools that move, by number.
std::map<int, std::string> tools_of(const Simulated& simulated) {
    std::map<int, std::string> texts;
    for (const auto& [number, used] : simulated.survey().tools)
        texts[number] = used.text;
    return texts;
}

SharedSimulation simulate(const std::string& program, const std::optional<std::string>& text,
                          const py::dict& arguments) {
    const SimulateRequest request = simulate_request(program, text, arguments);
    return interruptible(
        [&](const std::stop_token& stop) { return std::make_shared<Simulated>(request, stop); });
}

void define_facts(py::class_<Simulated, SharedSimulation>& type) {
    type.def_property_readonly("program",
                               [](const Simulated& s) { return s.plan().job.program.name; })
        .def_property_readonly("files",
                               [](const Simulated& s) { return s.survey().interpretation.files; })
        .def_property_readonly("model", [](const Simulated& s) { return s.plan().model; })
        .def_property_readonly("tolerance", [](const Simulated& s) { return s.plan().tolerance; })
        .def_property_readonly("tool_tolerance",
                               [](const Simulated& s) { return s.plan().tool_tolerance; })
        .def_property_readonly(
            "stock", [](const Simulated& s) { return report::describe(*s.survey().stock); })
        .def_property_readonly("stock_box",
                               [](const Simulated& s) { return box_of(s.survey().stock->box); })
        .def_property_readonly("stock_volume",
                               [](const Simulated& s) { return s.result().stock_volume; })
        .def_property_readonly("volume", [](const Simulated& s) { return s.result().part_volume; })
        .def_property_readonly("volume_error",
                               [](const Simulated& s) { return s.result().part_volume_error; })
        .def_property_readonly("removed_by_tool",
                               [](const Simulated& s) { return s.result().removed_by_tool; })
        .def_property_readonly("removed_by_block",
                               [](const Simulated& s) { return s.result().removed_by_block; })
        .def_property_readonly("hulls", [](const Simulated& s) { return s.result().hulls; })
        .def_property_readonly("not_used", &Simulated::not_used)
        .def_property_readonly("tools", &tools_of)
        .def_property_readonly("diagnostics", [](const Simulated& s) {
            return diagnostic_list(s.survey().diagnostics, s.plan().job.program.name);
        });
}

void define_results(py::class_<Simulated, SharedSimulation>& type) {
    type.def("mesh",
             [](const SharedSimulation& s) {
                 return interruptible([&](const std::stop_token&) { return s->mesh(); });
             })
        .def("motions",
             [](const SharedSimulation& s) {
                 const auto motions =
                     interruptible([&](const std::stop_token&) { return s->motions(); });
                 register_records();
                 return view_of(*motions, motions);
             })
        .def(
            "solid",
            [](const SharedSimulation& s, int refinements) {
                return interruptible(
                    [&](const std::stop_token& stop) { return s->solid(refinements, stop); });
            },
            py::arg("refinements"))
        .def("measures",
             [](const SharedSimulation& s) {
                 return interruptible(
                     [&](const std::stop_token& stop) { return s->measures(stop); });
             })
        .def("assumptions", [](const SharedSimulation& s) {
            return interruptible([&](const std::stop_token&) { return s->assumptions(); });
        });
}

}  // namespace

void define_simulation(py::module_& module) {
    py::class_<Simulated, SharedSimulation> type(module, "Simulation");
    define_facts(type);
    define_results(type);
    module.def("simulate", &simulate, py::arg("program"), py::arg("text"), py::arg("arguments"));
}

}  // namespace ncsim::python
