// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of `ncsim run`.
#include "options/run_options.h"

#include "ncsim/cda/tiles.h"
#include "ncsim/simulation/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace ncsim::app {

namespace {

exporter::Renderer read_renderer(const std::string& name) {
    if (name == "own") return exporter::Renderer::Own;
    if (name == "osmesa") return exporter::Renderer::Osmesa;
    throw Refusal{fmt::format("--renderer '{}': expected own or osmesa", name)};
}

exporter::Colouring read_colouring(const std::string& name) {
    if (name == "tool") return exporter::Colouring::Tool;
    if (name == "line") return exporter::Colouring::Line;
    if (name == "depth") return exporter::Colouring::Depth;
    if (name == "design") return exporter::Colouring::Design;
    throw Refusal{fmt::format("--colour '{}': expected tool, line, depth or design", name)};
}

FixedBody read_frame(const std::string& name) {
    if (name == "machine") return FixedBody::Machine;
    if (name == "part") return FixedBody::Part;
    throw Refusal{fmt::format("--frame '{}': expected machine or part", name)};
}

exporter::StepSchema read_step_schema(const std::string& name) {
    if (name == "ap242") return exporter::StepSchema::Ap242;
    if (name == "ap214") return exporter::StepSchema::Ap214;
    throw Refusal{fmt::format("--step-schema '{}': expected ap242 or ap214", name)};
}

simulation::RayDirections read_rays(const std::string& name) {
    if (name == "z") return simulation::RayDirections::AlongZ;
    if (name == "xyz") return simulation::RayDirections::AlongAll;
    throw Refusal{fmt::format("--rays '{}': expected z or xyz", name)};
}

StepSurfaces read_step_surfaces(const std::string& name) {
    if (name == "analytic") return StepSurfaces::Analytic;
    if (name == "faceted") return StepSurfaces::Faceted;
    throw Refusal{fmt::format("--step-surfaces '{}': expected analytic or faceted", name)};
}

double read_simplify(double tolerance) {
    if (tolerance == 0.0 || (tolerance >= 1e-6 && tolerance <= 1.0)) return tolerance;
    throw Refusal{fmt::format("--simplify {}: expected 0, or 0.000001 to 1 mm", tolerance)};
}

// Chooses the model: the thesis' model for its own views, otherwise the model that scales.
void choose_model(Options& o) {
    o.model_specified = !o.model.empty();
    const bool needs_cells = !o.stats.empty() || !o.xml.empty();
    const auto shows = [](const simulation::ModelInfo& model) { return model.shows_cells; };
    if (o.model.empty()) {
        o.model = needs_cells ? std::ranges::find_if(simulation::models(), shows)->name
                              : simulation::models().front().name;
    }
    if (needs_cells && !simulation::find_model(o.model)->shows_cells) {
        throw Refusal{fmt::format("--stats and --xml show the cells of --model {}",
                                  simulation::model_names(shows))};
    }
    const simulation::ModelInfo& model = *simulation::find_model(o.model);
    const bool tells_rays = o.rays != simulation::RayDirections::Chosen;
    if ((o.resolution > 0.0 || tells_rays) && !model.has_resolution) {
        throw Refusal{fmt::format(
            "{} is that of --model {}", o.resolution > 0.0 ? "--resolution" : "--rays",
            simulation::model_names([](const auto& known) { return known.has_resolution; }))};
    }
    if (!o.step.empty()) require_exact(o, "--step");
    if (!o.sections.empty()) require_exact(o, "--section");
    if (o.block_volumes) require_exact(o, "--block-volumes");
    if (!o.save_stock.empty()) require_exact(o, "--save-stock");
}

}  // namespace

bool needs_exact_part(const Options& o) {
    return !o.step.empty() || !o.sections.empty() || o.block_volumes || !o.save_stock.empty() ||
           !o.stats.empty() || !o.xml.empty() || !o.tile.empty() || o.tiles;
}

std::vector<std::string> outputs_of(const Options& o) {
    std::vector<std::string> paths;
    for (const std::string* path :
         {&o.png, &o.gltf, &o.vrml, &o.stl, &o.ply, &o.threemf, &o.step, &o.dxf, &o.svg, &o.gif,
          &o.apng, &o.report, &o.stats, &o.xml, &o.save_job, &o.save_stock, &o.html}) {
        if (!path->empty()) paths.push_back(*path);
    }
    return paths;
}

bool draws_cells(const Options& o) {
    const simulation::ModelInfo* model = simulation::find_model(o.model);
    return model && model->shows_cells && !o.cut_view && !o.see_through &&
           o.colouring != exporter::Colouring::Design;
}

bool has_pictures(const Options& o) {
    return !o.png.empty() || has_frames(o);
}

bool has_frames(const Options& o) {
    return !o.gif.empty() || !o.apng.empty() || !o.frames.empty();
}

bool needs_surface(const Options& o) {
    return (has_pictures(o) && !draws_cells(o)) || !o.gltf.empty() || !o.vrml.empty() ||
           !o.stl.empty() || !o.ply.empty() || !o.threemf.empty() || !o.step.empty() ||
           !o.sections.empty() || !o.report.empty() || !o.html.empty();
}

namespace {

void add_outputs(cli::App& run, Options& o) {
    run.begin_group("Outputs");
    add_report_unit(run, o);
    run.add_option("--png", o.png, "Picture of the part")->type_name("FILE");
    run.add_option("--gif", o.gif, "Animation of the cutting")->type_name("FILE");
    run.add_option("--apng", o.apng, "Animation in all colours, APNG")->type_name("FILE");
    run.add_option("--frames", o.frames, "Numbered pictures of the cutting")->type_name("DIR");
    run.add_option("--html", o.html, "Page on which the program plays; loads nothing")
        ->type_name("FILE");
    run.add_option("--every", o.every, "Moves per frame [as many as make 100 frames]")
        ->range(std::uint64_t{1}, std::uint64_t{1'000'000'000})
        ->type_name("N");
    run.add_option("--gltf", o.gltf, "Mesh with the NC line of each face, binary glTF 2.0")
        ->type_name("FILE");
    run.add_option("--vrml", o.vrml, "Mesh with the NC line of each face, VRML97")
        ->type_name("FILE");
    run.add_option("--ply", o.ply, "Mesh with the NC line of each face, PLY")->type_name("FILE");
    run.add_option("--stl", o.stl, "Mesh, binary STL")->type_name("FILE");
    run.add_option("--3mf", o.threemf, "Mesh with a material per tool, 3MF")->type_name("FILE");
    run.add_option_function<std::vector<std::string>>(
           "--section",
           [&o](const std::vector<std::string>& planes) {
               for (const std::string& plane : planes)
                   o.sections.push_back(read_plane("--section", plane));
           },
           "Plane of a section at x, y or z, mm; repeatable")
        ->type_name("z=N")
        ->no_extra_values();
    run.add_option("--dxf", o.dxf, "Sections as lines and arcs, DXF R12")->type_name("FILE");
    run.add_option("--svg", o.svg, "Sections as lines and arcs, SVG")->type_name("FILE");
    run.add_option("--save-stock", o.save_stock, "Part as stock of the next set-up, .ncstock")
        ->type_name("FILE");
    cli::Option* const report =
        run.add_option("--report", o.report, "Volumes, distances, times, JSON")->type_name("FILE");
    run.add_flag("--block-volumes", o.block_volumes,
                 "Volume that each block removes, in --report; slower")
        ->needs(report);
    run.add_flag("--quiet,-q", o.quiet, "Print errors and warnings only");
    add_watch(run, o);
}

void add_step_options(cli::App& run, Options& o) {
    using Text = const std::string&;
    run.begin_group("STEP");
    run.add_option("--step", o.step, "Solid with planes, cylinders, cones etc. for CAD")
        ->type_name("FILE");
    run.add_option_function<std::string>(
           "--step-surfaces", [&o](Text name) { o.step_surfaces = read_step_surfaces(name); },
           "analytic or faceted [analytic]")
        ->type_name("WHAT");
    run.add_option("--step-refine", o.step_refine, "Cut up to N times more, without limit of work")
        ->range(0, 6)
        ->type_name("N");
    run.add_flag("--step-strict", o.step_strict, "Exit with 2 if round surfaces remain facets");
    run.add_option_function<std::string>(
           "--step-schema", [&o](Text name) { o.step_schema = read_step_schema(name); },
           "ap242, or ap214 for older readers [ap242]")
        ->type_name("WHAT");
    run.add_flag("--step-attributes", o.step_attributes, "Line, tool and kind of each face");
    run.add_option("--step-max-faces", o.step_max_faces,
                   fmt::format("Refuse larger solids [{}]", exporter::kStepMaxFaces))
        ->range(1, 1'000'000'000)
        ->type_name("N");
}

void add_drawing_options(cli::App& run, Options& o) {
    using Text = const std::string&;
    run.begin_group("Pictures");
    add_picture_options(run, o);
    run.add_option_function<std::string>(
           "--colour", [&o](Text name) { o.colouring = read_colouring(name); },
           "Meaning of colours: tool, line, depth, design [tool]")
        ->type_name("WHAT");
    add_design(run, o.design, o.design_tolerance, "Design of --colour design");
    run.add_flag("--show-path", o.shows_path, "Draw the tool path, rapid moves dashed");
    run.add_flag("--show-tool", o.shows_tool, "Draw the tool");
    run.add_flag("--show-fixtures", o.shows_fixtures, "Draw vises, clamps and other fixtures");
    run.add_flag("--caption", o.has_caption, "Print size, removed volume and time");
    run.add_flag("--show-machine", o.shows_machine,
                 "Draw the machine; in --gltf and --vrml it moves");
    run.add_option_function<std::string>(
           "--frame", [&o](Text name) { o.fixed_body = read_frame(name); },
           "Fixed frame of --show-machine: machine, part [machine]")
        ->type_name("WHAT")
        ->needs("--show-machine");
    run.add_option("--transparent", o.transparent, "Links of the machine to look through, by name")
        ->delimiter(',')
        ->type_name("LINKS")
        ->needs("--show-machine");
    run.add_option("--at-line", o.at_line, "Stop after line N of the program")
        ->range(1U, 1'000'000'000U)
        ->type_name("N");
    run.add_flag("--draft", o.draft, "Quick first look: guess tools, mark the picture");
    run.add_option_function<std::string>(
           "--renderer", [&o](Text name) { o.renderer = read_renderer(name); },
           "own (same bytes everywhere) or osmesa [own]")
        ->type_name("NAME");
}

void add_accuracy_options(cli::App& run, Options& o) {
    run.begin_group("Accuracy");
    run.add_option_function<double>(
           "--simplify", [&o](double tolerance) { o.simplify = read_simplify(tolerance); },
           "Merge faces of meshes and solids within TOL mm")
        ->type_name("TOL");
    run.add_option("--resolution", o.resolution,
                   "Distance of the rays of dexel, mm [1/250 of the stock]")
        ->type_name("MM")
        ->number_range(1e-4, 1e4);
    run.add_option_function<std::string>(
           "--rays", [&o](const std::string& name) { o.rays = read_rays(name); },
           "Rays of dexel: z (faster), xyz [by tools and moves]")
        ->type_name("WHAT");
}

void add_advanced_options(cli::App& run, Options& o) {
    run.begin_group("Advanced");
    run.add_option("--tile", o.tile,
                   "Cut tile I of N only, from 0, for ncsim merge; auto: as CI says")
        ->type_name("I/N");
    run.add_option("--tile-out", o.tile_out, "Folder for the result of a tile")->type_name("DIR");
    run.add_flag("--redo", o.redo, "Cut a tile again although its result exists");
    run.add_option("--stats", o.stats, "Cost of each hull, CSV (cda-flat)")->type_name("FILE");
    run.add_option("--xml", o.xml, "Cells of the workpiece, XML (cda-flat)")->type_name("FILE");
}

}  // namespace

cli::App* add_run(cli::App& app, Options& o) {
    cli::App* run =
        app.add_subcommand("run", "Simulate a program; write pictures, meshes and reports");
    add_program_options(*run, o);
    add_setup_options(*run, o);
    run->begin_group("Machine");
    run->add_option("--machine", o.machine,
                    "Machine: TOML, URDF, LinuxCNC INI, FreeCAD .fcm, Fusion")
        ->type_name("FILE");
    add_outputs(*run, o);
    add_step_options(*run, o);
    add_drawing_options(*run, o);
    add_simulation_options(*run, o, Models::All);
    add_accuracy_options(*run, o);
    add_advanced_options(*run, o);
    run->after_parsing([run, &o] {
        o.tolerance_specified = run->count("--tolerance") != 0;
        o.tool_tolerance_specified = run->count("--tool-tolerance") != 0;
    });
    return run;
}

std::vector<std::string> words_of_part(const cli::App& command) {
    static const std::set<std::string, std::less<>> others{
        "tile", "tile-out", "redo", "threads", "quiet", "watch", "max-time", "max-memory"};
    return words_of(command, [](const std::string& name) { return !others.contains(name); });
}

namespace {

void complete_tile(Options& o) {
    if (o.tile.empty() != o.tile_out.empty()) {
        throw Refusal{o.tile.empty() ? "--tile-out: of which tile? --tile I/N"
                                     : "--tile: where to is its result to go? --tile-out DIR"};
    }
    if (o.tile.empty() && o.redo) throw Refusal{"--redo is about a --tile"};
    if (o.tile.empty()) return;
    o.number = shard_number(o.tile, 0, "--tile");
    if (o.number.of > cda::kMostTiles)
        throw Refusal{fmt::format("--tile '{}': {} tiles at most", o.tile, cda::kMostTiles)};
    if (!outputs_of(o).empty() || !o.frames.empty())
        throw Refusal{"--tile: pictures, meshes and reports are written by ncsim merge"};
    if (o.program == "-") throw Refusal{"--tile: the program has to have a name"};
    if (o.model != simulation::models().front().name)
        throw Refusal{
            fmt::format("--tile: of --model {} alone", simulation::models().front().name)};
}

}  // namespace

namespace {

void refuse_foreign_endings(const Options& o) {
    struct Output {
        const char* option;
        const std::string* path;
        std::vector<std::string> endings;
    };
    const Output outputs[] = {{"--png", &o.png, {".png"}},
                              {"--gif", &o.gif, {".gif"}},
                              {"--apng", &o.apng, {".apng", ".png"}},
                              {"--gltf", &o.gltf, {".glb"}},
                              {"--vrml", &o.vrml, {".wrl", ".vrml"}},
                              {"--stl", &o.stl, {".stl"}},
                              {"--ply", &o.ply, {".ply"}},
                              {"--3mf", &o.threemf, {".3mf"}},
                              {"--step", &o.step, {".step", ".stp", ".p21"}},
                              {"--dxf", &o.dxf, {".dxf"}},
                              {"--svg", &o.svg, {".svg"}},
                              {"--html", &o.html, {".html", ".htm"}},
                              {"--report", &o.report, {".json"}},
                              {"--save-stock", &o.save_stock, {".ncstock"}}};
    for (const Output& output : outputs)
        refuse_foreign_ending(output.option, *output.path, output.endings);
}

}  // namespace

namespace {

void require_finished_part(const Options& o) {
    if (o.colouring != exporter::Colouring::Design) return;
    if (o.png.empty() || has_frames(o))
        throw Refusal{
            "--colour design shows the finished part: it needs --png, without --gif, --apng and "
            "--frames"};
}

}  // namespace

void complete(Options& options) {
    complete(static_cast<ProgramOptions&>(options));
    refuse_foreign_endings(options);
    choose_model(options);
    if (options.sections.empty() && !(options.dxf.empty() && options.svg.empty()))
        throw Refusal{"--dxf and --svg draw sections; specify the plane with --section z=-4"};
    if (options.every != 0 && !has_frames(options) && options.html.empty()) {
        throw Refusal{
            "--every says how often pictures are taken: it needs --frames, --gif, --apng or "
            "--html"};
    }
    require_pictures(options, has_pictures(options), "--png, --gif, --apng or --frames");
    if (options.see_through && options.renderer != exporter::Renderer::Own)
        throw Refusal{"--see-through: OSMesa draws no transparent part; omit --renderer"};
    require_finished_part(options);
    complete_tile(options);
    require_watchable(options, inputs_of(options), !options.tile.empty());
}

}  // namespace ncsim::app
