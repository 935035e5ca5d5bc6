// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds a rule of a shop to the verdict: rapid moves go aside at least 2 mm above the stock.
//     own_rule part.nc
#include "ncsim/report/check_text.h"
#include "ncsim/simulation/program_check.h"

#include <algorithm>
#include <exception>
#include <iostream>

namespace {

constexpr double kClearance = 2.0;  // mm

bool goes_aside(const ncsim::gcode::Position& from, const ncsim::gcode::Position& to) {
    return from.x != to.x || from.y != to.y;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace ncsim;
    if (argc != 2) return std::cerr << "usage: own_rule PROGRAM\n", 2;
    try {
        setup::InputSet inputs;
        setup::JobOptions options;
        options.program = argv[1];
        simulation::Plan plan;
        plan.job = setup::read_job(options, inputs);
        const report::Checked checked = simulation::check(plan);  // the rules of ncsim
        std::cout << report::text_of(checked, {});

        const double lowest = checked.stock_box.max.z + kClearance;
        int findings = 0;
        gcode::interpret(plan.job.program, plan.job.interpreter, [&](const gcode::Motion& motion) {
            const auto* const move = std::get_if<gcode::Linear>(&motion.action);
            if (!move || motion.kind != gcode::MoveKind::Rapid || !motion.known_start.all()) return;
            const double height = std::min(move->from.z, move->to.z).mm();
            if (height >= lowest || !goes_aside(move->from, move->to)) return;
            ++findings;
            std::cout << argv[1] << ':' << motion.span.line << ':' << motion.span.column
                      << ": error: rapid move aside at Z" << height << " [shop-clearance]\n";
        });
        return checked.outcome == verify::Outcome::Failed || findings > 0 ? 1 : 0;
    } catch (const std::exception& e) {
        return std::cerr << e.what() << '\n', 2;
    }
}
