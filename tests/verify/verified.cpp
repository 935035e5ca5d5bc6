// SPDX-License-Identifier: GPL-3.0-or-later
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

verify::Verdict verdict_of(const std::string& program, verify::Setup setup) {
    const gcode::SourceFile source{"part.nc", program};
    const cda::Lattice lattice = cda::Lattice::for_stock(kBlock);
    const bool simulated = !setup.not_simulated;
    setup.suppressions = verify::Suppressions(source);
    cda::TreeCda part(cda::box_cell(lattice.round(kBlock.min), lattice.round(kBlock.max), lattice),
                      lattice);
    toolpath::Walk walk(lattice, kBlock, setup.accuracy, {}, setup.rapid);
    for (const auto& [number, facts] : setup.tools)
        walk.add_tool(number, facts.tool);
    const double stock_mm3 = part.volume();
    verify::Verifier verifier(std::move(setup), simulated ? kBlock : cda::Box{}, lattice);
    gcode::InterpreterOptions options;
    options.observe_frame = [&](const gcode::Motion&, const gcode::ProgramFrame& frame) {
        verifier.set_frame(frame);
    };
    const auto result = gcode::interpret(source, options, [&](const gcode::Motion& motion) {
        verifier.begin(motion);
        if (simulated) {
            walk.take(motion, cda::Origin{1},
                      [&](const toolpath::Step& step) { verifier.cut(step, part); });
        }
        verifier.end();
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

}  // namespace ncsim::verify_test
