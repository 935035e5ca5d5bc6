// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of `ncsim merge`.
#include "options/merge_options.h"

namespace ncsim::app {

cli::App* add_merge(cli::App& app, MergeOptions& o) {
    cli::App* merge =
        app.add_subcommand("merge", "Combine results of --shard or --tile into those of one run");
    merge->add_option("sources", o.sources, "Folders or files with results")
        ->required()
        ->type_name("DIRS");
    add_report_options(*merge, o);
    const auto of_run = [&](const char* name, const char* type, const char* what) {
        merge
            ->add_option_function<std::string>(
                std::string("--") + name,
                [&o, name](const std::string& value) { o.of_run.emplace_back(name, value); }, what)
            ->type_name(type);
    };
    merge->begin_group("Outputs of tiles");
    of_run("gltf", "FILE", "Mesh with NC lines, binary glTF 2.0; DIR/: a mesh per tile");
    of_run("stl", "FILE", "Mesh, binary STL");
    of_run("3mf", "FILE", "Mesh with a material per tool, 3MF");
    of_run("ply", "FILE", "Mesh with the NC line of each face, PLY");
    of_run("vrml", "FILE", "Mesh with the NC line of each face, VRML97");
    of_run("png", "FILE", "Picture of the part");
    of_run("view", "VIEW", "iso, top, bottom, front, back, left, right [iso]");
    of_run("simplify", "TOL", "Merge faces of meshes within TOL mm");
    of_run("report", "FILE", "Volumes, distances, times, JSON");
    of_run("threads", "N", "Number of threads; no effect on results");
    return merge;
}

}  // namespace ncsim::app
