// SPDX-License-Identifier: GPL-3.0-or-later
#include "outcome.h"

namespace ncsim::app {

report::RunFacts run_facts(const Outcome& outcome) {
    report::RunFacts facts;
    facts.name = outcome.plan.job.program.name;
    facts.program = &outcome.survey;
    facts.cutting = simulation::cutting_facts(outcome.plan);
    facts.part = outcome.simulation;
    facts.boundary = outcome.boundary;
    if (outcome.simplified) {
        facts.simplified = {*outcome.options.simplify, outcome.simplified->deviation_mm,
                            outcome.simplified->boundary.faces.size()};
    }
    return facts;
}

}  // namespace ncsim::app
