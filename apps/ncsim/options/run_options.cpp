// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of `ncsim run`.
#include "options/run_options.h"

#include "ncsim/simulation/models.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::app {

namespace {

using RunArgs = Options;

constexpr Choice<exporter::Renderer> kRenderers[] = {{"own", exporter::Renderer::Own},
                                                     {"osmesa", exporter::Renderer::Osmesa}};
constexpr Choice<exporter::Colouring> kColourings[] = {{"tool", exporter::Colouring::Tool},
                                                       {"line", exporter::Colouring::Line},
                                                       {"depth", exporter::Colouring::Depth},
                                                       {"design", exporter::Colouring::Design}};
constexpr Choice<FixedBody> kFrames[] = {{"machine", FixedBody::Machine},
                                         {"part", FixedBody::Part}};
constexpr Choice<exporter::StepSchema> kStepSchemas[] = {{"ap242", exporter::StepSchema::Ap242},
                                                         {"ap214", exporter::StepSchema::Ap214}};
constexpr Choice<StepSurfaces> kStepSurfaces[] = {{"analytic", StepSurfaces::Analytic},
                                                  {"faceted", StepSurfaces::Faceted}};
constexpr Choice<simulation::RayDirections> kRays[] = {
    {"z", simulation::RayDirections::AlongZ}, {"xyz", simulation::RayDirections::AlongAll}};

void read_simplify(const char* option, const double& tolerance, Options& o) {
    if (tolerance != 0.0 && !(tolerance >= 1e-6 && tolerance <= 1.0))
        throw Refusal{fmt::format("{} {}: expected 0, or 0.000001 to 1 mm", option, tolerance)};
    o.simplify = tolerance;
}

void read_sections(const char* option, const std::vector<std::string>& planes, Options& o) {
    for (const std::string& plane : planes)
        o.sections.push_back(read_plane(option, plane));
}

// Chooses the model: the thesis' model for views that only this model has, otherwise the model that
// scales.
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

const std::vector<OutputFile>& output_files() {
    using O = Options;
    static const std::vector<OutputFile> files{{"--png", &O::png, {".png"}},
                                               {"--gltf", &O::gltf, {".glb"}},
                                               {"--vrml", &O::vrml, {".wrl", ".vrml"}},
                                               {"--stl", &O::stl, {".stl"}},
                                               {"--ply", &O::ply, {".ply"}},
                                               {"--3mf", &O::threemf, {".3mf"}},
                                               {"--step", &O::step, {".step", ".stp", ".p21"}},
                                               {"--dxf", &O::dxf, {".dxf"}},
                                               {"--svg", &O::svg, {".svg"}},
                                               {"--gif", &O::gif, {".gif"}},
                                               {"--apng", &O::apng, {".apng", ".png"}},
                                               {"--report", &O::report, {".json"}},
                                               {"--stats", &O::stats},
                                               {"--xml", &O::xml},
                                               {"--save-job", &O::save_job},
                                               {"--save-stock", &O::save_stock, {".ncstock"}},
                                               {"--html", &O::html, {".html", ".htm"}}};
    return files;
}

std::vector<std::string> outputs_of(const Options& o) {
    std::vector<std::string> paths;
    for (const OutputFile& file : output_files()) {
        if (!(o.*file.path).empty()) paths.push_back(o.*file.path);
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

constexpr OptionRow<RunArgs> kRunOutputs[] = {
    {"--png", "FILE", kOfPart, "Picture of the part", store<&RunArgs::png>},
    {"--gif", "FILE", kWork, "Animation of the cutting", store<&RunArgs::gif>},
    {"--apng", "FILE", kWork, "Animation in all colours, APNG", store<&RunArgs::apng>},
    {"--frames", "DIR", kWork, "Numbered pictures of the cutting", store<&RunArgs::frames>},
    {"--html", "FILE", kWork, "Page on which the program plays; loads nothing",
     store<&RunArgs::html>},
    {"--every", "N", kLook, "Moves per frame [as many as make 100 frames]", store<&RunArgs::every>,
     within(1, 1e9)},
    {"--gltf", "FILE", kOfPart, "Mesh with the NC line of each face, binary glTF",
     store<&RunArgs::gltf>},
    {"--vrml", "FILE", kOfPart, "Mesh with the NC line of each face, VRML97",
     store<&RunArgs::vrml>},
    {"--ply", "FILE", kOfPart, "Mesh with the NC line of each face, PLY", store<&RunArgs::ply>},
    {"--stl", "FILE", kOfPart, "Mesh, binary STL", store<&RunArgs::stl>},
    {"--3mf", "FILE", kOfPart, "Mesh with a material per tool, 3MF", store<&RunArgs::threemf>},
    {"--section", "z=N", kLook, "Plane of a section at x, y or z, mm; repeatable",
     act<read_sections>},
    {"--dxf", "FILE", kWork, "Sections as lines and arcs, DXF R12", store<&RunArgs::dxf>},
    {"--svg", "FILE", kWork, "Sections as lines and arcs, SVG", store<&RunArgs::svg>},
    {"--save-stock", "FILE", kWork, "Part as stock of the next set-up, .ncstock",
     store<&RunArgs::save_stock>},
    {"--report", "FILE", kOfPart, "Volumes, distances, times, JSON", store<&RunArgs::report>},
    {"--block-volumes", "", kLook, "Volume that each block removes, in --report; slower",
     store<&RunArgs::block_volumes>, with("--report")},
    {"--quiet,-q", "", kText, "Print errors and warnings only", store<&RunArgs::quiet>}};

constexpr OptionRow<RunArgs> kStepRows[] = {
    {"--step", "FILE", kWork, "Solid with planes, cylinders, cones etc. for CAD",
     store<&RunArgs::step>},
    {"--step-surfaces", "WHAT", kLook, "analytic or faceted [analytic]",
     choose<&RunArgs::step_surfaces, kStepSurfaces>},
    {"--step-refine", "N", kLook, "Cut up to N times more, without limit of work",
     store<&RunArgs::step_refine>, within(0, 6)},
    {"--step-strict", "", kLook, "Exit with 2 if round surfaces remain facets",
     store<&RunArgs::step_strict>},
    {"--step-schema", "WHAT", kLook, "ap242, or ap214 for older readers [ap242]",
     choose<&RunArgs::step_schema, kStepSchemas>},
    {"--step-attributes", "", kLook, "Line, tool and kind of each face",
     store<&RunArgs::step_attributes>},
    {"--step-max-faces", "N", kLook, "Refuse larger solids [100000]",
     store<&RunArgs::step_max_faces>, within(1, 1e9)}};
static_assert(exporter::kStepMaxFaces == 100'000);

constexpr OptionRow<RunArgs> kRunPictures[] = {
    {"--colour", "WHAT", kLook, "Meaning of colours: tool, line, depth, design [tool]",
     choose<&RunArgs::colouring, kColourings>},
    {"--design", "FILE", kLook, "Design of --colour design: STL (mm), GLB or STEP in G54",
     store<&RunArgs::design>},
    {"--design-tol", "MM", kLook, "Permitted deviation, mm [0.1]",
     store<&RunArgs::design_tolerance>, kDesignTolerances},
    {"--show-path", "", kLook, "Draw the tool path, rapid moves dashed",
     store<&RunArgs::shows_path>},
    {"--show-tool", "", kLook, "Draw the tool", store<&RunArgs::shows_tool>},
    {"--show-fixtures", "", kLook, "Draw vises, clamps and other fixtures",
     store<&RunArgs::shows_fixtures>},
    {"--caption", "", kLook, "Print size, removed volume and time", store<&RunArgs::has_caption>},
    {"--show-machine", "", kLook, "Draw the machine; in --gltf and --vrml it moves",
     store<&RunArgs::shows_machine>},
    {"--frame", "WHAT", kLook, "Fixed frame of --show-machine: machine, part [machine]",
     choose<&RunArgs::fixed_body, kFrames>, with("--show-machine")},
    {"--transparent", "LINKS", kLook, "Links of the machine to look through, by name",
     store_list<&RunArgs::transparent>, with("--show-machine")},
    {"--at-line", "N", kResult, "Stop after line N of the program", store<&RunArgs::at_line>,
     within(1, 1e9)},
    {"--draft", "", kResult, "Quick first look: guess tools, mark the picture",
     store<&RunArgs::draft>},
    {"--renderer", "NAME", kLook, "own (same bytes everywhere) or osmesa [own]",
     choose<&RunArgs::renderer, kRenderers>}};

constexpr OptionRow<RunArgs> kRunAccuracy[] = {
    {"--simplify", "TOL", kOfTiles, "Merge faces of meshes and solids within TOL mm",
     act<read_simplify>},
    {"--resolution", "MM", kResult, "Distance of the rays of dexel, mm [1/250 of the stock]",
     store<&RunArgs::resolution>, within(1e-4, 1e4)},
    {"--rays", "WHAT", kResult, "Rays of dexel: z (faster), xyz [by tools and moves]",
     choose<&RunArgs::rays, kRays>}};

constexpr OptionRow<RunArgs> kRunAdvanced[] = {
    {"--tile", "I/N", kWork, "Cut tile I of N only, from 0, for ncsim merge; auto: as CI says",
     store<&RunArgs::tile>},
    {"--tile-out", "DIR", kWork, "Folder for the result of a tile", store<&RunArgs::tile_out>},
    {"--stats", "FILE", kWork, "Cost of each hull, CSV (cda-flat)", store<&RunArgs::stats>},
    {"--xml", "FILE", kWork, "Cells of the workpiece, XML (cda-flat)", store<&RunArgs::xml>}};

}  // namespace

void add_options(cli::App& run, Options& o) {
    add_program_options(run, o);
    add_setup_options(run, o);
    add_rows(run, "Outputs", kRunOutputs, o);
    add_save_job(run, o);
    add_report_unit(run, o);
    add_watch(run, o);
    add_rows(run, "STEP", kStepRows, o);
    add_rows(run, "Pictures", picture_options(), static_cast<PictureOptions&>(o));
    add_rows(run, "Pictures", kRunPictures, o);
    add_simulation_options(run, o, Models::All);
    add_rows(run, "Accuracy", kRunAccuracy, o);
    add_rows(run, "Advanced", kRunAdvanced, o);
}

namespace {

void complete_tile(Options& o) {
    o.number = tile_number(o.tile, o.tile_out);
    if (o.tile.empty()) return;
    if (!outputs_of(o).empty() || !o.frames.empty())
        throw Refusal{"--tile: pictures, meshes and reports are written by ncsim merge"};
    if (o.program == "-") throw Refusal{"--tile: the program has to have a name"};
    if (o.model != simulation::models().front().name)
        throw Refusal{
            fmt::format("--tile: of --model {} alone", simulation::models().front().name)};
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
    for (const OutputFile& file : output_files()) {
        if (!file.endings.empty())
            refuse_foreign_ending(file.option.data(), options.*file.path, file.endings);
    }
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
