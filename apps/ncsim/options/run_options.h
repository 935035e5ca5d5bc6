// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `ncsim run` is asked for.
#pragma once

#include "ncsim/brep/section.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/render.h"
#include "ncsim/export/step.h"
#include "ncsim/report/file_digests.h"
#include "ncsim/simulation/plan.h"

#include "options/program_options.h"
#include "options/shard_number.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Of what a solid for CAD is made: surfaces as tools leave them, or facets of tools that are
/// polygons.
enum class StepSurfaces : std::uint8_t { Analytic, Faceted };

/// What moves in pictures of a machine: the rest of it about its bed, or all about the part.
enum class StandsStill : std::uint8_t { Machine, Part };

/// Empty paths: not asked for.
struct Options : ProgramOptions, SimulationOptions {
    bool shows_machine = false;  ///< Links of the machine in pictures and files that can move.
    std::vector<std::string> transparent;             ///< Links of it.
    StandsStill stands_still = StandsStill::Machine;  ///< In pictures of both.
    std::string machine;  ///< A machine.toml: offsets, and how it turns.
    std::string png, gltf, vrml, stl, ply, threemf, step, report, stats, xml, save_stock;

    /// Of the picture; several are put on one sheet with a caption. Never empty.
    std::vector<exporter::View> views{exporter::View::Iso};
    exporter::Background background = exporter::Background::White;
    exporter::Renderer renderer = exporter::Renderer::Own;
    exporter::Colouring colouring = exporter::Colouring::Tool;
    bool shows_path = false, shows_tool = false, has_caption = false;
    /// Line of the program after which the simulation stops; from 1.
    std::optional<std::uint32_t> at_line;
    std::string frames;       ///< A folder for pictures taken on the way.
    std::string gif;          ///< The same as one moving picture.
    std::uint64_t every = 0;  ///< Moves from one of them to the next; 0: some hundred pictures.
    std::uint32_t width = 1280, height = 960;  ///< Of each view, in pixels.
    /// mm. Where it is not given, glTF and STL are exact, all others within kFlatTolerance.
    std::optional<double> simplify;
    StepSurfaces step_surfaces = StepSurfaces::Analytic;
    int step_refine = 6;       ///< So many other cuts are tried for it, at most.
    bool step_strict = false;  ///< Facets that are kept are a failure.
    exporter::StepSchema step_schema = exporter::StepSchema::Ap242;
    bool step_attributes = false;  ///< Lines, tools and kind with each face.
    std::size_t step_max_faces = exporter::kStepMaxFaces;
    double resolution = 0.0;  ///< Of a model that has one, mm; 0: the one that suits.
    simulation::RayDirections rays = simulation::RayDirections::Chosen;
    bool model_told = false;
    std::vector<brep::SectionPlane> sections;  ///< Where the part is cut open.
    std::string dxf, svg;                      ///< Files for them.
    bool quiet = false;
    /// A first look: tools that nobody describes are guessed, round shapes are coarser.
    bool draft = false;
    /// In the report: what each block removed, which is several times the work.
    bool block_volumes = false;

    std::string tile;                ///< "17/64", "auto"; empty: all of the part.
    ShardNumber number;              ///< What that says.
    std::string tile_out;            ///< Folder for its result.
    bool redo = false;               ///< Though its result is there.
    std::vector<std::string> words;  ///< What decides what the part is like, in one way to say it.
    /// All tiles, cut before, and the files they were made of; null: the part is cut now.
    std::shared_ptr<const simulation::CutTiles> tiles;
    report::FileDigests tile_files;
    std::string mesh_folder;  ///< For a mesh of each of them.
};

/// Is the surface of the part needed as faces, for what was asked for?
bool needs_surface(const Options& options);

/// Is anything asked for that only exact models have?
bool needs_exact_part(const Options& options);

/// The paths of all files that were asked for.
std::vector<std::string> outputs_of(const Options& options);

/// The command `run` of `app`. It reads into `options`, which must outlive it.
cli::App* add_run(cli::App& app, Options& options);
/// The command line that makes the same part: "run", the options that matter, the program.
std::vector<std::string> words_of_part(const cli::App& command);
/// What can be judged only when all options were read; throws Refusal.
void complete(Options& options);

}  // namespace ncsim::app
