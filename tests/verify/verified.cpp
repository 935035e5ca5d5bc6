// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs interpreter, walk and verifier on a block in memory.
#include "verify/verified.h"

#include "ncsim/gcode/interpreter.h"

namespace ncsim::verify_test {

verify::Setup plain_setup() {
    verify::Setup setup;
    verify::ToolFacts facts;
    facts.tool = toolpath::flat_end_mill(10.0, 20.0);
    facts.tool.number = 1;
    setup.tools.emplace(1, facts);
    return setup;
}

verify::Setup setup_with_holder() {
    verify::Setup setup = plain_setup();
    toolpath::Tool tool = toolpath::flat_end_mill(10.0, 5.0);
    toolpath::add_holder_segment(tool, 10.0, 10.0, 25.0);
    toolpath::add_holder_segment(tool, 40.0, 40.0, 30.0);
    setup.tools.at(1).tool = tool;
    return setup;
}

void take(const gcode::Motion& motion, cda::Origin origin, verify::Verifier& verifier,
          toolpath::Walk& walk, cda::TreeCda* part, const Decide& decide) {
    verifier.begin(motion, part);
    if (part) {
        walk.take(motion, origin, [&](const toolpath::Step& step) {
            verifier.before_cut(step);
            double removed = 0.0;
            for (const cda::Cell& cell : step.cells) {
                if (verifier.measures_all()) {
                    removed += part->subtract(cell);
                } else {
                    part->subtract_unmeasured(cell);
                }
            }
            verifier.after_cut(step, removed);
        });
        walk.at_end_position(motion, origin,
                             [&](const toolpath::Step& step) { verifier.at_end_position(step); });
    }
    if (!decide) return verifier.end();
    std::vector<verify::ContactDecision> decisions;
    for (const verify::OpenContact& contact : verifier.end_steps())
        decisions.push_back(decide(contact));
    verifier.judge(decisions);
}

verify::Verdict verdict_of(const std::string& program, verify::Setup setup, const Decide& decide) {
    const gcode::SourceFile source{"part.nc", program};
    const cda::Lattice lattice = cda::Lattice::for_stock(kBlock);
    const bool simulated = !setup.not_simulated;
    setup.suppressions = verify::Suppressions(source);
    cda::TreeCda part(cda::box_cell(lattice.round(kBlock.min), lattice.round(kBlock.max), lattice),
                      lattice);
    toolpath::Walk walk(lattice, kBlock,
                        {.accuracy = setup.accuracy,
                         .rapid = setup.rapid,
                         .watch = verify::watched_parts(setup),
                         .specified = setup.kinematics});
    for (const auto& [number, facts] : setup.tools)
        walk.add_tool(number, facts.tool);
    const double stock_mm3 = part.volume();
    setup.stock = kBlock;
    verify::Verifier verifier(std::move(setup), simulated ? kBlock : Box{}, lattice);
    gcode::InterpreterOptions options;
    if (verifier.needs_account()) part.track_removal();
    std::uint32_t motions = 0;
    const auto result = gcode::interpret(source, options, [&](const gcode::Motion& motion) {
        take(motion, cda::Origin{++motions}, verifier, walk, simulated ? &part : nullptr, decide);
    });
    verifier.add(result.diagnostics);
    return verifier.finish(result, simulated ? &part : nullptr, stock_mm3);
}

std::vector<verify::Finding> findings_of(const verify::Verdict& verdict, const std::string& rule) {
    std::vector<verify::Finding> found;
    for (const verify::Finding& f : verdict.findings) {
        if (f.rule == rule) found.push_back(f);
    }
    return found;
}

std::string skipped_because(const verify::Verdict& verdict, const std::string& rule) {
    for (const verify::Skipped& s : verdict.skipped) {
        if (s.rule == rule) return s.reason;
    }
    return {};
}

std::set<std::string> doubts_of(const verify::Verdict& verdict) {
    std::set<std::string> ids;
    for (const verify::Doubt& d : verdict.doubts)
        ids.insert(d.reason);
    return ids;
}

}  // namespace ncsim::verify_test
