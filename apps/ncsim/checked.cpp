// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked.h"

#include "ncsim/cda/tree.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/png.h"
#include "ncsim/export/render.h"
#include "ncsim/verify/verifier.h"

#include "cut_free.h"
#include "job.h"
#include "pipeline.h"
#include "sheet.h"
#include "survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <stdexcept>

namespace ncsim::app {

namespace {

Options options_for(const std::string& path, const CheckOptions& check, unsigned threads) {
    Options options;
    static_cast<ProgramOptions&>(options) = static_cast<const ProgramOptions&>(check);
    static_cast<SimulationOptions&>(options) = static_cast<const SimulationOptions&>(check);
    options.program = path;
    options.model = "cda";
    options.threads = threads;
    return options;
}

verify::ToolFacts facts_of(const UsedTool& used, const verify::ToolFacts* told) {
    verify::ToolFacts facts;
    if (told) facts = *told;
    facts.tool = used.tool;
    facts.is_guess = used.told_by == toolpath::ToldBy::Assumption;
    if (facts.is_guess) {
        facts.assumption = "nobody describes it; taken as " + used.text;
    } else {
        facts.assumption = used.filled_in;
    }
    if (!facts.blind_diameter && used.tool.kind == toolpath::ToolKind::FaceMill) {
        facts.blind_diameter = 0.5 * toolpath::cutting_diameter_of(used.tool);
        facts.blind_assumption = "a face mill does not cut in the inner half of its diameter";
    }
    return facts;
}

// The first error that kept the program from being simulated.
std::string reason_of(const Survey& survey) {
    for (const gcode::Diagnostic& d : survey.diagnostics) {
        if (d.severity == gcode::Severity::Error) return d.message;
    }
    return "there is nothing to simulate";
}

verify::Setup setup_for(const Job& job, const Survey& survey, const CheckOptions& options,
                        const MachineFile& machine) {
    verify::Setup setup;
    setup.machine = machine.machine;
    setup.selection = options.selection;
    setup.suppressions = verify::Suppressions(job.program);
    setup.accuracy.tolerance_mm = options.tool_tolerance;
    setup.pieces_counted = options.cut_free;
    setup.design = !options.design.empty();
    setup.ledger = !options.csv.empty() || !options.html.empty();
    setup.rapid = rapid_path(options, machine.machine);
    for (const auto& [number, used] : survey.tools) {
        const auto told = machine.tools.find(number);
        setup.tools.emplace(number,
                            facts_of(used, told == machine.tools.end() ? nullptr : &told->second));
    }
    if (!survey.is_ready()) {
        setup.not_simulated = reason_of(survey);
    } else if (survey.stock->told_by == toolpath::ToldBy::Assumption) {
        setup.stock_assumption = survey.stock->text;
    }
    if (!survey.interpretation.units_stated) {
        setup.units_assumption =
            fmt::format("{}, since neither G20 nor G21 stands before the first length",
                        survey.interpretation.uses_inches ? "inches" : "millimetres");
    }
    if (!machine.machine.work_zero) {
        setup.home_assumption = fmt::format(
            "machine zero {:g} mm above the program zero, since no machine tells it", kHomeHeight);
    }
    return setup;
}

Look look_at(const Survey& survey, const Simulation& simulation) {
    Look look;
    const cda::Boundary boundary = simulation.part->boundary();
    look.mesh = cda::triangulate(boundary);
    for (const std::uint32_t face : look.mesh.face)
        look.lines.push_back(simulation.provenance.of(boundary.faces[face].origin).nc_line);
    exporter::RenderOptions render;
    render.width = 800;
    render.height = 600;
    render.colouring = exporter::Colouring::Tool;
    using exporter::View;
    for (const auto& [name, view] :
         {std::pair{"from above", View::Top}, std::pair{"isometric", View::Iso}}) {
        render.camera = exporter::fit_camera(survey.stock->box, view, 4 / 3.0);
        std::ostringstream png;
        exporter::write_png(png,
                            exporter::render_boundary(boundary, simulation.provenance, render));
        look.pictures.emplace_back(name, png.str());
    }
    return look;
}

void verify_program(Checked& checked, Job job, const CheckOptions& options,
                    const MachineFile& machine, const Design* design) {
    if (const auto& zero = machine.machine.work_zero) {
        for (gcode::Position& origin : job.interpreter.work_offsets) {
            origin.x = gcode::Length::from_mm(zero->x);
            origin.y = gcode::Length::from_mm(zero->y);
            origin.z = gcode::Length::from_mm(zero->z);
        }
    }
    const auto lead = [](gcode::Position& to, const std::optional<cda::Vec3>& told) {
        if (!told) return;
        to.x = gcode::Length::from_mm(told->x);
        to.y = gcode::Length::from_mm(told->y);
        to.z = gcode::Length::from_mm(told->z);
    };
    lead(job.interpreter.homes[0], machine.machine.home);
    lead(job.interpreter.homes[1], machine.machine.tool_change);
    const Survey survey = app::survey(job);
    checked.moves = survey.moves;
    checked.simulated = survey.is_ready();
    verify::Setup setup = setup_for(job, survey, options, machine);
    if (setup.not_simulated) checked.not_simulated = *setup.not_simulated;

    const cda::Box stock = survey.is_ready() ? survey.stock->box : cda::Box{};
    const cda::Lattice lattice =
        survey.is_ready() ? toolpath::stock_lattice(*survey.stock) : cda::Lattice{};
    if (survey.is_ready()) {
        checked.stock =
            describe(*survey.stock) + (setup.stock_assumption.empty() ? "" : ", assumed");
    }
    const toolpath::RapidPath rapid = setup.rapid;
    verify::Verifier verifier(std::move(setup), stock, lattice);
    verifier.add(survey.diagnostics);
    job.interpreter.observe_frame = [&verifier](const gcode::Motion&,
                                                const gcode::ProgramFrame& frame) {
        verifier.set_frame(frame);
    };
    if (survey.is_ready()) {
        Verification verification;
        verification.verifier = &verifier;
        verification.rapid = rapid;
        verification.keep_cuts = design != nullptr;
        const Simulation simulation = simulate(job, survey, verification, {});
        if (options.cut_free) {
            for (verify::Finding& f : cut_free(job, survey, verification, simulation))
                verifier.add(std::move(f));
        }
        const bool compared =
            options.selection.includes("gouge") || options.selection.includes("excess");
        if (design && compared) {
            for (verify::Finding& f : compare_with(*design, simulation, checked.design.emplace()))
                verifier.add(std::move(f));
        }
        const auto* part = dynamic_cast<const cda::TreeCda*>(simulation.part.get());
        checked.verdict = verifier.finish(survey.interpretation, part, simulation.stock_volume);
        if (!options.html.empty()) checked.look = look_at(survey, simulation);
    } else {
        gcode::interpret(job.program, job.interpreter, [&](const gcode::Motion& motion) {
            verifier.begin(motion);
            verifier.end();
        });
        checked.verdict = verifier.finish(survey.interpretation, nullptr, 0.0);
    }
    if (!options.html.empty()) {
        if (!checked.look) checked.look.emplace();
        checked.look->source = job.program.text;
    }
    for (const verify::Finding& f : checked.verdict.findings) {
        std::string line;
        if (f.place.file == 0 && f.place.span.line > 0) {
            line = gcode::line_text(job.program, f.place.span.line);
        }
        checked.lines.push_back(std::move(line));
    }
    const bool fails =
        checked.verdict.count(verify::Severity::Error) > 0 ||
        (options.warnings_as_errors && checked.verdict.count(verify::Severity::Warning) > 0);
    if (fails) checked.exit_code = kFindings;
}

}  // namespace

toolpath::RapidPath rapid_path(const CheckOptions& options,
                               const verify::MachineDescription& machine) {
    toolpath::RapidPath path;
    path.dog_leg = options.dog_leg;
    const bool all_told =
        std::ranges::all_of(machine.rapid, [](const auto& rate) { return rate.has_value(); });
    for (std::size_t i = 0; i < 3 && all_told; ++i)
        path.rates[i] = *machine.rapid[i];
    return path;
}

Checked check_program(const std::string& path, const CheckOptions& options,
                      const MachineFile& machine, const Design* design, unsigned threads) {
    Checked checked;
    checked.path = path;
    try {
        verify_program(checked, read_job(options_for(path, options, threads)), options, machine,
                       design);
    } catch (const std::bad_alloc&) {
        checked.failure = "out of memory";
        checked.exit_code = kEnvironment;
    } catch (const std::logic_error& e) {
        checked.failure = fmt::format("a bug of ours, please report it: {}", e.what());
        checked.exit_code = kBug;
    } catch (const std::exception& e) {
        checked.failure = e.what();
        checked.exit_code = kEnvironment;
    }
    if (!checked.failure.empty()) checked.verdict = {}, checked.lines.clear();
    return checked;
}

}  // namespace ncsim::app
