// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulates a program and writes the outputs.
#include "run/run.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/brep/flat_part.h"
#include "ncsim/brep/recognise.h"
#include "ncsim/cda/cell_model.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/drawing.h"
#include "ncsim/export/gltf.h"
#include "ncsim/export/ply.h"
#include "ncsim/export/png.h"
#include "ncsim/export/step.h"
#include "ncsim/export/stl.h"
#include "ncsim/export/threemf.h"
#include "ncsim/export/vrml.h"
#include "ncsim/mesh/simplify.h"
#include "ncsim/report/assumption_sheet.h"
#include "ncsim/report/page.h"
#include "ncsim/report/run_report.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/fixtures.h"
#include "ncsim/simulation/left_shape.h"
#include "ncsim/simulation/machine_time.h"
#include "ncsim/simulation/page_data.h"
#include "ncsim/simulation/plan_reader.h"
#include "ncsim/simulation/play_recorder.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/shading.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/stock_history.h"

#include "options/job_steps.h"
#include "options/plan_options.h"
#include "run/animation.h"
#include "run/machine_picture.h"
#include "run/mesh_folder.h"
#include "run/moving_machine.h"
#include "run/outcome.h"
#include "run/picture.h"
#include "run/placed_fixtures.h"
#include "run/run_job.h"
#include "run/save_job.h"
#include "run/standing_bodies.h"
#include "run/tile.h"
#include "system/console.h"
#include "system/output.h"
#include "system/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

// Returns the fixtures of the job and the machine, in W.
// Throws: std::runtime_error if there is none.
std::vector<verify::Fixture> fixtures_of(const simulation::Plan& plan,
                                         const simulation::Survey& survey,
                                         const std::optional<setup::MachineFile>& machine) {
    std::vector<verify::Fixture> fixtures = placed_fixtures(plan, survey, machine);
    if (fixtures.empty()) {
        throw std::runtime_error(
            "--show-fixtures: neither the job nor the machine has a fixture ([[fixture]])");
    }
    return fixtures;
}

// Returns the text of the lines that left a face, because a program may have ten million lines.
// With called files, line numbers are ambiguous, so there is no text.
std::map<std::uint32_t, std::string> text_of_lines(const simulation::Plan& plan,
                                                   const simulation::Survey& survey,
                                                   const mesh::Provenance& provenance,
                                                   const cda::Boundary& boundary) {
    std::map<std::uint32_t, std::string> text;
    if (survey.interpretation.files.size() > 1) return text;
    const std::vector<std::string_view> lines = gcode::lines_of(plan.job.program);
    for (const cda::BoundaryFace& face : boundary.faces) {
        const std::uint32_t line = provenance.of(face.origin).nc_line;
        if (line == 0 || line > lines.size()) continue;
        text.try_emplace(line, lines[line - 1]);
    }
    return text;
}

brep::Shading shading_of_mesh(const Outcome& outcome) {
    if (!outcome.simplified) return outcome.shading ? *outcome.shading : brep::Shading();
    return simulation::shading_of(outcome.plan, outcome.survey, *outcome.simulation,
                                  outcome.simplified->boundary, *outcome.options.simplify);
}

void write_outputs(const Outcome& outcome, OutputSet& outputs) {
    const Options& o = outcome.options;
    const simulation::Simulation& s = *outcome.simulation;
    const cda::Boundary* mesh =
        outcome.simplified ? &outcome.simplified->boundary : outcome.boundary;
    // Formats with polygons get simplified faces.
    std::optional<mesh::Simplified> counted;
    const auto simplified = [&]() -> const mesh::Simplified& {
        if (outcome.simplified) return *outcome.simplified;
        if (!counted) counted = mesh::simplify(*mesh, mesh::kFlatTolerance, &s.provenance);
        return *counted;
    };
    const auto polygons = [&]() -> const cda::Boundary& { return simplified().boundary; };
    outputs.write(o.png, [&](std::ostream& out) {
        if (o.cut_view) require_cut_view(o, cda::bounds(*outcome.boundary), "part");
        exporter::write_png(out, picture(outcome));
    });
    std::optional<exporter::MovingScene> moving;
    if (!o.gltf.empty() || !o.vrml.empty()) {
        moving = o.shows_machine ? moving_machine(outcome) : exporter::MovingScene();
        add_standing_bodies(outcome, *moving);
        if (moving->nodes.empty()) moving.reset();
    }
    outputs.write(o.gltf, [&](std::ostream& out) {
        const brep::Shading shading = shading_of_mesh(outcome);
        if (moving) {
            exporter::write_gltf(out, *mesh, s.provenance, *moving, shading);
        } else {
            exporter::write_gltf(out, *mesh, s.provenance, outcome.plan.threads, shading);
        }
    });
    outputs.write(o.vrml, [&](std::ostream& out) {
        if (moving) {
            exporter::write_vrml(out, polygons(), s.provenance, *moving);
        } else {
            exporter::write_vrml(out, polygons(), s.provenance);
        }
    });
    outputs.write(o.stl, [&](std::ostream& out) {
        exporter::write_stl(out, cda::triangulate(*mesh, outcome.plan.threads),
                            outcome.plan.threads, s.provenance.assumed);
    });
    outputs.write(o.ply, [&](std::ostream& out) {
        exporter::write_ply(out, polygons(), simplified().mesh, s.provenance);
    });
    outputs.write(o.threemf, [&](std::ostream& out) {
        exporter::write_3mf(out, polygons(), simplified().mesh, s.provenance);
    });
    outputs.write(o.step, [&](std::ostream& out) {
        exporter::StepOptions how;
        how.max_faces = o.step_max_faces;
        how.schema = o.step_schema;
        how.has_attributes = o.step_attributes;
        how.mass = outcome.solid_mass;
        if (!outcome.solid->recognised.is_sound) throw std::runtime_error(exporter::kUnsoundSolid);
        exporter::write_step_solid(out, outcome.solid->recognised.part, outcome.solid->provenance,
                                   how);
    });
    outputs.write(o.html, [&](std::ostream& out) {
        report::write_run_page(out, outcome.plan.job.program.name,
                               report::summary(run_facts(outcome)), *outcome.page_data,
                               outcome.options.report_unit);
    });
    const std::string& program = s.provenance.program;
    outputs.write(o.dxf, [&](std::ostream& out) {
        exporter::write_dxf(out, drawn_sections(outcome), program);
    });
    outputs.write(o.svg, [&](std::ostream& out) {
        exporter::write_svg(out, drawn_sections(outcome), program);
    });
    outputs.write(o.save_stock, [&](std::ostream& out) { cda::write_shape(out, *outcome.left); });
    const auto* const cells = dynamic_cast<const cda::CellModel*>(s.part.get());
    outputs.write(o.stats, [&](std::ostream& out) { cells->write_statistics(out); });
    outputs.write(o.xml, [&](std::ostream& out) { cells->write_cells(out); });
}

// True if an output can be read by ncsim as stock, design or mesh.
bool records_assumptions(const Options& o) {
    const auto is_asked_for = [](const std::string* path) { return !path->empty(); };
    const std::string* const paths[] = {&o.save_stock, &o.stl, &o.gltf, &o.vrml, &o.step};
    return std::ranges::any_of(paths, is_asked_for);
}

// True if a quick preview suffices for the outputs of a long program.
bool is_long(const simulation::Survey& survey, const Options& o) {
    return survey.moves >= simulation::kLongProgram && !needs_exact_part(o);
}

// True if an output shades the part.
bool is_shaded(const Options& o) {
    return !o.png.empty() || !o.gltf.empty() || !o.html.empty();
}

double step_tolerance(const Options& o) {
    return std::max(o.simplify.value_or(0.0), exporter::kStepTolerance);
}

// Returns the solid for --step with facets.
simulation::Solid facets_of(const Outcome& outcome) {
    brep::FlatPart flat = exporter::flat_solid(*outcome.boundary, step_tolerance(outcome.options));
    brep::Recognised solid{std::move(flat.part)};
    solid.tolerance_factor = flat.tolerance_factor;
    solid.is_sound = flat.is_sound;
    return {std::move(solid), outcome.simulation->provenance, outcome.plan.tool_tolerance};
}

// Returns the part with true surfaces if an output needs the solid.
std::optional<simulation::Solid> true_solid(const Outcome& outcome) {
    const Options& o = outcome.options;
    const bool is_written = !o.step.empty() && o.step_surfaces == StepSurfaces::Analytic;
    if (!is_written && o.sections.empty()) return std::nullopt;
    simulation::Refinement limit;
    if (o.step_refine) limit = {*o.step_refine, false};
    return simulation::refined_solid(outcome.plan, outcome.survey, *outcome.simulation,
                                     step_tolerance(o), limit);
}

}  // namespace

int run(Options options) {
    if (has_steps_to_do(options)) {
        setup::InputSet aside;
        const std::vector<ChosenStep> steps = chosen_steps(options, aside);
        if (!steps.empty())
            return run_job(options, steps, [](Options one) { return run(std::move(one)); });
    }
    if (!options.tile.empty()) return run_tile(options);
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    const bool has_design = options.colouring == exporter::Colouring::Design;
    // A project or a job may name the design, so the parser of the command line cannot judge.
    if (has_design && options.design.empty())
        throw std::runtime_error("--colour design: of which design? --design part.stl");
    if (has_design) inputs.expect(options.design);
    setup::RecordedInput recorded(inputs);
    setup::InputSet& read = options.tiles ? recorded : inputs;
    simulation::Plan plan = plan_for(options, read);
    plan.tiles = options.tiles;
    std::vector<std::string> not_used;
    std::optional<setup::MachineFile> machine;
    if (!options.machine.empty())
        machine = simulation::machine_for(options.machine, plan.job, read);
    if (machine) not_used = simulation::apply_machine(plan, *machine);
    if (options.shows_machine && (!machine || machine->bodies.empty()))
        throw std::runtime_error("--show-machine: no link of a machine has a mesh (--machine)");
    if (machine) make_transparent(*machine, options.transparent);
    const Options& o = options;
    for (const std::string& path : outputs_of(o))
        outputs.reserve(path);
    if (!o.mesh_folder.empty()) outputs.reserve(list_of_meshes(o.mesh_folder));

    simulation::Survey survey = simulation::survey(plan);
    if (survey.is_flat() || survey.only_rapid) options.shows_path = plan.keep_paths = true;
    simulation::choose_model(plan, survey);
    simulation::choose_rays(plan, survey);
    simulation::coarsen(plan, survey, o.tolerance_specified, o.tool_tolerance_specified);
    simulation::choose_resolution(plan, survey);
    // For a program that was not read, there are no assumptions.
    if (!o.quiet && !survey.interpretation.refused) {
        report::CuttingFacts cutting = report::cutting_facts(plan);
        cutting.unit = o.report_unit;
        print_error(report::assumption_sheet(plan.job.program.name, survey, cutting));
    }
    if (!o.quiet && survey.is_ready() && !o.draft && !o.model_specified && is_long(survey, o)) {
        print_error(
            fmt::format("hint      {} moves: --model dexel shows them in a fraction of the time, "
                        "not exactly\n",
                        survey.moves));
    }
    if (!o.quiet && !o.project.empty())
        print_error(fmt::format("settings  {}\n", printable_path(o.project)));
    for (const std::string& what : not_used)
        print_error("not used: " + what + "\n");
    print_findings(plan.job.program, survey.diagnostics);

    if (o.at_line && *o.at_line > survey.interpretation.lines) {
        throw std::runtime_error(fmt::format("--at-line {}: the program has {} lines", *o.at_line,
                                             survey.interpretation.lines));
    }
    if (survey.is_ready()) require_cut_view(o, survey.stock->box, "stock");

    Outcome outcome{options, plan, survey};
    outcome.machine = machine ? &*machine : nullptr;
    if (o.shows_fixtures) outcome.fixtures = fixtures_of(plan, survey, machine);
    if (machine && !o.at_line && survey.is_ready())
        outcome.on_machine = simulation::machining_times(plan, survey, machine->machine);
    std::optional<simulation::Design> design;
    std::optional<simulation::DesignView> view;
    if (has_design) {
        design = simulation::read_design(o.design, o.design_tolerance, read);
        simulation::require_tolerance(*design);
    }
    std::optional<simulation::Simulation> simulation;
    std::optional<mesh::Simplified> simplified;
    std::optional<simulation::Solid> true_surfaces, facets;
    std::optional<brep::Shading> shading;
    if (survey.is_ready()) {
        Progress progress(survey.moves, !o.quiet && ::isatty(STDERR_FILENO) != 0);
        Animation animation(options, survey, outputs);
        const auto take_frame = [&](const simulation::Simulation& so_far) {
            Outcome now{options, plan, survey, &so_far};
            now.machine = outcome.machine;
            now.fixtures = outcome.fixtures;
            brep::Shading shading_now;
            if (so_far.boundary) {
                now.boundary = &*so_far.boundary;
                shading_now = simulation::shading_of(plan, survey, so_far, *so_far.boundary);
                now.shading = &shading_now;
            }
            animation.take(now);
        };
        simulation::Verification nothing;
        nothing.keep_cuts = !o.step.empty() || !o.sections.empty() || is_shaded(o) ||
                            animation.every() != 0 || !o.save_stock.empty();
        nothing.own_lines = design.has_value();
        nothing.history = simulation::read_stock_history(*survey.stock);
        std::optional<simulation::PlayRecorder> play;
        if (!o.html.empty()) nothing.play = &play.emplace(plan, survey, o.every);
        simulation = simulation::simulate(plan, survey, nothing,
                                          [&](std::uint64_t done) { progress.update(done); },
                                          {animation.every(), take_frame});
        if (records_assumptions(o)) {
            setup::MachineFile fixtures_alone;
            simulation::add_fixtures(fixtures_alone, plan.job);
            outcome.assumed =
                simulation::assumptions_of(plan, survey, machine ? *machine : fixtures_alone);
        }
        simulation->provenance.assumed = simulation::reasons_of(outcome.assumed);
        if (o.tiles) expect_same_files(o.tile_files, recorded.files());
        if (animation.every() != 0) {
            take_frame(*simulation);
            animation.finish();
        }
        print_findings(plan.job.program, simulation->diagnostics);
        survey.diagnostics.insert(survey.diagnostics.end(), simulation->diagnostics.begin(),
                                  simulation->diagnostics.end());
        outputs.write(o.gif, [&](std::ostream& out) { animation.write_gif(out); });
        outputs.write(o.apng, [&](std::ostream& out) { animation.write_apng(out); });
        if (!o.gltf.empty() && simulation->boundary) {
            simulation->provenance.text =
                text_of_lines(plan, survey, simulation->provenance, *simulation->boundary);
        }
        outcome.simulation = &*simulation;
        if (!o.mesh_folder.empty())
            write_mesh_folder(o.mesh_folder, plan, survey, *simulation, outputs);
        if (simulation->boundary) outcome.boundary = &*simulation->boundary;
        if (outcome.boundary && (!o.png.empty() || !o.gltf.empty())) {
            shading = simulation::shading_of(plan, survey, *simulation, *outcome.boundary);
            outcome.shading = &*shading;
        }
        if (design)
            outcome.design =
                &view.emplace(simulation::design_view(*design, *simulation, *outcome.boundary));
        std::optional<simulation::PageData> page_data;
        if (play && outcome.boundary) {
            page_data = simulation::page_data(plan, survey, *simulation, *outcome.boundary,
                                              placed_fixtures(plan, survey, machine), false);
            page_data->play = simulation::finish_play(*play, *simulation);
            outcome.page_data = &*page_data;
        }
        if (o.simplify && outcome.boundary) {
            simplified = mesh::simplify(*outcome.boundary, *o.simplify);
            outcome.simplified = &*simplified;
        }
        true_surfaces = true_solid(outcome);
        if (true_surfaces) true_surfaces->provenance.assumed = simulation->provenance.assumed;
        if (true_surfaces) outcome.true_solid = &*true_surfaces;
        if (!o.step.empty()) {
            outcome.solid = outcome.true_solid;
            if (o.step_surfaces == StepSurfaces::Faceted)
                outcome.solid = &facets.emplace(facets_of(outcome));
            outcome.solid_mass = brep::mass_of(outcome.solid->recognised.part);
        }
        for (const brep::SectionPlane& plane : o.sections) {
            outcome.sections.push_back(
                simulation::make_section_view(plan, *simulation, *true_surfaces, plane));
        }
        std::optional<cda::Shape> left;
        if (!o.save_stock.empty()) {
            left = simulation::take_left_shape(plan, survey, *simulation, outcome.assumed);
            outcome.left = &*left;
        }
        write_outputs(outcome, outputs);
    }
    outputs.write(o.save_job, [&](std::ostream& out) {
        save_job(out, plan.job, survey, o.machine, o.save_job);
    });
    outputs.write(o.report,
                  [&](std::ostream& out) { report::write_report(out, run_facts(outcome)); });
    outputs.commit();

    const bool faulty = gcode::has_errors(survey.diagnostics);
    if (!survey.is_ready()) {
        print_error("ncsim: the program was not simulated\n");
    } else {
        if (!o.quiet)
            put_text(report::summary(run_facts(outcome)), outputs.takes_standard_output());
        if (faulty)
            print_error("ncsim: the part is not what the blocks with errors would make of it\n");
    }
    if (o.step_strict && outcome.solid && outcome.solid->recognised.facets_kept > 0) {
        print_error("ncsim: --step-strict: facets were kept, see above\n");
        return faulty ? kFindings : kEnvironment;
    }
    return faulty ? kFindings : kClean;
}

}  // namespace ncsim::app
