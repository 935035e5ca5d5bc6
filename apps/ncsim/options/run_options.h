// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of `ncsim run`.
#pragma once

#include "ncsim/brep/section.h"
#include "ncsim/export/render.h"
#include "ncsim/export/step.h"
#include "ncsim/report/file_digests.h"
#include "ncsim/simulation/plan.h"

#include "options/picture_options.h"
#include "options/program_options.h"
#include "options/shard_number.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// Surfaces of a solid for CAD: surfaces as tools leave them, or facets of polygonal tools.
enum class StepSurfaces : std::uint8_t { Analytic, Faceted };

/// Fixed body in pictures of a machine: the bed of the machine, or the part.
enum class FixedBody : std::uint8_t { Machine, Part };

/// Options of `ncsim run`. Empty paths: no output.
struct Options : ProgramOptions, SimulationOptions, PictureOptions {
    bool shows_machine = false;  ///< Show links of the machine in pictures and animated files.
    std::vector<std::string> transparent;  ///< Transparent links.
    /// Fixed body in pictures of machine and part.
    FixedBody fixed_body = FixedBody::Machine;
    std::string png, gltf, vrml, stl, ply, threemf, step, report, stats, xml, save_stock;
    std::string html;  ///< Page on which the program plays.

    exporter::Renderer renderer = exporter::Renderer::Own;
    exporter::Colouring colouring = exporter::Colouring::Tool;
    std::string design;             ///< Design for Colouring::Design: STL, GLB or STEP.
    double design_tolerance = 0.1;  ///< mm
    bool shows_path = false, shows_tool = false, has_caption = false;
    bool shows_fixtures = false;  ///< Draw the fixtures of the job and the machine.
    /// Line of the program after which the simulation stops; from 1.
    std::optional<std::uint32_t> at_line;
    std::string frames;  ///< Folder for pictures of intermediate states.
    std::string gif;     ///< Animated picture of intermediate states.
    std::string apng;    ///< The same in all colours.
    /// Number of moves between two pictures or states of the page; 0: about a hundred.
    std::uint64_t every = 0;
    /// Tolerance in mm. Default: glTF and STL are exact, further formats are within kFlatTolerance.
    std::optional<double> simplify;
    StepSurfaces step_surfaces = StepSurfaces::Analytic;
    /// Largest number of further cuts that are tried for STEP; unspecified: within a budget.
    std::optional<int> step_refine{};
    bool step_strict = false;  ///< Facets that remain are a failure.
    exporter::StepSchema step_schema = exporter::StepSchema::Ap242;
    bool step_attributes = false;  ///< Lines, tools and kind of each face.
    std::size_t step_max_faces = exporter::kStepMaxFaces;
    double resolution = 0.0;  ///< Resolution of a model that has one, mm; 0: chosen automatically.
    simulation::RayDirections rays = simulation::RayDirections::Chosen;
    bool model_specified = false;
    std::vector<brep::SectionPlane> sections;  ///< Planes of sections.
    std::string dxf, svg;                      ///< Output files for sections.
    bool quiet = false;
    /// Quick preview: tools without a description are assumed, round shapes are coarser.
    bool draft = false;
    /// Report the removed volume of each block, which multiplies the work.
    bool block_volumes = false;

    std::string tile;                ///< "17/64", "auto"; empty: the whole part.
    ShardNumber number;              ///< Value of `tile`.
    std::string tile_out;            ///< Folder for the result of a tile.
    std::vector<std::string> words;  ///< Words that determine the part, in canonical form.
    /// All tiles, cut before, and the files from which the tiles were made; null: the part is cut
    /// in this run.
    std::shared_ptr<const simulation::CutTiles> tiles;
    report::FileDigests tile_files;
    std::string mesh_folder;  ///< Folder with a mesh for each tile.
};

/// True if an output is a picture.
bool has_pictures(const Options& options);
/// True if an output is a picture of intermediate states.
bool has_frames(const Options& options);

/// True if pictures are drawn from the cells of the model, without a surface.
bool draws_cells(const Options& options);

/// True if an output needs the surface of the part as faces.
bool needs_surface(const Options& options);

/// True if an output needs an exact model.
bool needs_exact_part(const Options& options);

/// Output file of `ncsim run`.
struct OutputFile {
    std::string_view option;  ///< Name, with its dashes.
    std::string Options::*path;
    std::vector<std::string> endings{};  ///< Endings of the format; empty: any.
};
/// Returns the output files that an option can name, in the order of writing.
const std::vector<OutputFile>& output_files();

/// Returns the paths of all output files.
std::vector<std::string> outputs_of(const Options& options);

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, Options& options);
/// Checks and completes `options` after all options were read.
/// Throws: Refusal.
void complete(Options& options);

}  // namespace ncsim::app
