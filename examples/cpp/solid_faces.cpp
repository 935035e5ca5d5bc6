// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulates a program, and lists the faces of the part as a CAD system sees them.
//     solid_faces part.nc
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/survey.h"

#include <exception>
#include <iostream>
#include <variant>

int main(int argc, char** argv) {
    using namespace ncsim;
    if (argc != 2) return std::cerr << "usage: solid_faces PROGRAM\n", 2;
    try {
        setup::InputSet inputs;
        setup::JobOptions options;
        options.program = argv[1];
        simulation::Plan plan;
        plan.job = setup::read_job(options, inputs);
        plan.keep_boundary = true;
        const simulation::Survey survey = simulation::survey(plan);
        if (!survey.is_ready())
            return std::cerr << simulation::reason_not_simulated(survey) << '\n', 1;
        simulation::Verification verification;
        verification.keep_cuts = true;  // the motions that left the faces
        const simulation::Simulation part = simulation::simulate(plan, survey, verification, {});

        constexpr double kTolerance = 1e-4;  // mm, within which facets are joined
        const simulation::Solid solid =
            simulation::refined_solid(plan, survey, part, kTolerance, {});
        for (const brep::Face& face : solid.recognised.part.faces) {
            std::cout << brep::kForms.at(face.surface.form.index());
            if (const auto* hole = std::get_if<brep::Cylinder>(&face.surface.form))
                std::cout << (face.surface.is_hollow ? ", bore D" : ", boss D")
                          << 2.0 * hole->radius;
            const mesh::Provenance::Entry by = solid.provenance.of(face.origin);
            if (by.is_stock()) {
                std::cout << ", stock\n";
            } else {
                std::cout << ", line " << by.nc_line << ", T" << by.tool << '\n';
            }
        }
    } catch (const std::exception& e) {
        return std::cerr << e.what() << '\n', 2;
    }
}
