// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of `ncsim merge`.
#include "options/merge_options.h"

namespace ncsim::app {

cli::App* add_merge(cli::App& app, MergeOptions& o) {
    cli::App* merge = app.add_subcommand(
        "merge",
        "Put results of --shard, or of run or check --tile, together: what one run writes");
    merge->add_option("sources", o.sources, "Folders of results, or the files")
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
    of_run("gltf", "FILE",
           "Of tiles: mesh with the NC line of every face, glTF 2.0 binary; DIR/: a mesh of each "
           "tile, closed together, listed in DIR.json");
    of_run("stl", "FILE", "Of tiles: mesh, binary STL");
    of_run("3mf", "FILE", "Of tiles: mesh with a material for each tool, 3MF");
    of_run("ply", "FILE", "Of tiles: mesh with the NC line of every face, PLY");
    of_run("vrml", "FILE", "Of tiles: mesh with the NC line of every face, VRML97");
    of_run("png", "FILE", "Of tiles: picture of the part");
    of_run("view", "VIEW", "Of the picture: iso, top, bottom, front, back, left, right");
    of_run("simplify", "TOL", "Of tiles: merge faces and edges in meshes within TOL mm");
    of_run("report", "FILE", "Of tiles: what happened, JSON");
    of_run("threads", "N", "Of tiles: threads; the result is the same for any number");
    return merge;
}

}  // namespace ncsim::app
