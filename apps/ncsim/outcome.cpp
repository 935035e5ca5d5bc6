// SPDX-License-Identifier: GPL-3.0-or-later
#include "outcome.h"

namespace ncsim::app {

report::CuttingFacts cutting_facts(const Job& job) {
    const Options& o = job.options;
    return {o.model, o.tolerance, o.tool_tolerance, o.join_tolerance, o.at_line};
}

report::RunFacts run_facts(const Outcome& outcome) {
    report::RunFacts facts;
    facts.name = outcome.job.program.name;
    facts.program = &outcome.survey;
    facts.cutting = cutting_facts(outcome.job);
    facts.part = outcome.simulation;
    facts.boundary = outcome.boundary;
    if (outcome.simplified) {
        facts.simplified = {*outcome.job.options.simplify, outcome.simplified->deviation_mm,
                            outcome.simplified->boundary.faces.size()};
    }
    return facts;
}

}  // namespace ncsim::app
