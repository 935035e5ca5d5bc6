// SPDX-License-Identifier: GPL-3.0-or-later
//
// Python module ncsim._ncsim: the functions and classes behind the package ncsim.
#include "ncsim/base/version.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/simulation/models.h"

#include "checked_program.h"
#include "failures.h"
#include "mesh_data.h"
#include "simulated.h"
#include "solid_data.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace py = pybind11;

namespace {

std::vector<std::string> model_list() {
    std::vector<std::string> names;
    for (const ncsim::simulation::ModelInfo& model : ncsim::simulation::models())
        names.emplace_back(model.name);
    return names;
}

// Returns tuples (number, set-up, name of the set-up, program, label).
py::list steps(const std::string& job) {
    namespace setup = ncsim::setup;
    std::vector<setup::JobStep> found;
    try {
        setup::InputSet inputs;
        found = setup::steps_of(setup::read_job_file(job, inputs),
                                std::filesystem::path(job).parent_path().string());
    } catch (const std::runtime_error& e) {
        throw ncsim::python::UsageFailure(e.what());
    }
    py::list list;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const setup::JobStep& step = found[i];
        list.append(py::make_tuple(i + 1, step.set_up, step.name, step.program, step.label));
    }
    return list;
}

}  // namespace

PYBIND11_MODULE(_ncsim, module) {
    ncsim::python::register_failures();
    ncsim::python::define_mesh(module);
    ncsim::python::define_solid(module);
    ncsim::python::define_simulation(module);
    ncsim::python::define_check(module);
    module.def("steps", &steps, py::arg("job"));
    module.attr("models") = py::tuple(py::cast(model_list()));
    module.attr("version") = std::string(ncsim::kVersion);
}
