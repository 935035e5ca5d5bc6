// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_samples <folder>: writes parts in every format, for independent readers. An .expect file
// next to each part has the values that a reader must find: "volume <mm³>", "lines <numbers,
// ascending>", "faces" and "solids".
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/gltf.h"
#include "ncsim/export/moving_scene.h"
#include "ncsim/export/ply.h"
#include "ncsim/export/png.h"
#include "ncsim/export/render.h"
#include "ncsim/export/step.h"
#include "ncsim/export/stl.h"
#include "ncsim/export/threemf.h"
#include "ncsim/export/vrml.h"
#include "ncsim/mesh/simplify.h"

#include "support/box_part.h"
#include "support/polytope_part.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

namespace ncsim::exporter {

namespace {

// Creates the file.
// Throws: std::ios_base::failure if the file cannot be written.
std::ofstream create(const std::filesystem::path& path) {
    std::ofstream out(path, std::ios::binary);
    out.exceptions(std::ios::failbit | std::ios::badbit);
    return out;
}

void write(const std::filesystem::path& stem, const cda::Boundary& boundary,
           const mesh::Provenance& provenance, int faces, int solids, double moved_mm = 0.0) {
    const auto file = [&](const char* extension) {
        return create(std::filesystem::path(stem).replace_extension(extension));
    };
    auto glb = file(".glb");
    write_gltf(glb, boundary, provenance);
    auto wrl = file(".wrl");
    write_vrml(wrl, boundary, provenance);
    auto ply = file(".ply");
    write_ply(ply, boundary, cda::triangulate(boundary), provenance);
    auto threemf = file(".3mf");
    write_3mf(threemf, boundary, provenance);
    auto stl = file(".stl");
    write_stl(stl, cda::triangulate(boundary));

    auto step = file(".step");
    write_step(step, boundary, provenance);

    std::set<std::uint32_t> lines;
    for (const auto& face : boundary.faces)
        lines.insert(provenance.of(face.origin).nc_line);
    auto expect = file(".expect");
    expect.precision(17);
    expect << "volume " << cda::volume(boundary) << "\nlines";
    for (const std::uint32_t line : lines)
        expect << ' ' << line;
    expect << "\nfaces " << faces << "\nsolids " << solids << '\n';
    if (moved_mm > 0.0) expect << "moved " << moved_mm << '\n';
}

// Returns a prism with a notch that reaches the lower side and, by rounding, beyond. All faces are
// cut.
cda::Boundary notched_prism() {
    const std::vector<std::array<double, 2>> outline{{0, 0}, {4, 0}, {4, 3}, {2, -1e-15}, {0, 3}};
    cda::Boundary b;
    const auto n = static_cast<std::uint32_t>(outline.size());
    const cda::Origin cut{1};
    for (const double z : {0.0, 1.0}) {
        for (const auto& [x, y] : outline)
            b.vertices.push_back({x, y, z});
    }
    b.faces.push_back({{0, 0, -1}, 0.0, cut, 0, {{4, 3, 2, 1, 0}}});
    b.faces.push_back({{0, 0, 1}, 1.0, cut, 0, {{5, 6, 7, 8, 9}}});
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        const Vec3 along = b.vertices[j] - b.vertices[i];
        const Vec3 normal = normalized({along.y, -along.x, 0});
        b.faces.push_back({normal, dot(normal, b.vertices[i]), cut, 0, {{i, j, j + n, i + n}}});
    }
    b.shells = 1;
    return b;
}

// Writes the pictures of the part by both renderers.
void write_pictures(const std::filesystem::path& stem, const test::BoxPart& part) {
    const cda::Boundary boundary = boundary_of(part);
    const mesh::Provenance provenance = provenance_of(part);
    RenderOptions options;
    options.width = 640;
    options.height = 480;
    options.camera = fit_camera(cda::bounds(boundary), View::Iso, 4 / 3.0, Projection::Perspective);
    auto from_boundary = create(stem.string() + "_boundary.png");
    write_png(from_boundary, render_boundary(boundary, provenance, options));
    auto from_model = create(stem.string() + "_model.png");
    write_png(from_model, render_model(test::BoxModel(part), provenance, options));
}

// Writes a machine: a slide with a rotary table that carries the part, and a column with two tools
// in turn.
void write_machine(const std::filesystem::path& folder) {
    const test::BoxPart grooved = test::grooved_part();
    const cda::Boundary part = boundary_of(grooved);
    const auto body = [&](Vec3 shift) {
        test::BoxPart moved = grooved;
        moved.shift = shift;
        return Body{boundary_of(moved), {200, 120, 40}};
    };
    MovingScene scene;
    scene.nodes.push_back({"slide",
                           {},
                           {},
                           SceneJoint{'X', false, {1, 0, 0}, {{0, 5}, {2, 45}}},
                           {body({0, 0, -100})},
                           {}});
    scene.nodes.push_back({"round table",
                           0,
                           {10, 20, -30},
                           SceneJoint{'A', true, {1, 0, 0}, {{0, 0}, {1, 0}, {3, 300}, {4, 300}}},
                           {body({0, 0, -50})},
                           {}});
    scene.nodes.push_back({"column", {}, {}, {}, {body({0, 500, 0})}, {}});
    scene.nodes.push_back({"T1", 2, {0, 0, 300}, {}, {body({0, 0, 300})}, {{0, 1.5}, {3, 4}}});
    scene.nodes.push_back({"T2", 2, {0, 0, 300}, {}, {body({0, 0, 300})}, {{1.5, 3}}});
    scene.part_on = 1;
    scene.zero = {1, 2, 3};
    scene.seconds = 4.0;
    scene.lines = {{0.0, 5}, {2.0, 6}};
    std::set<std::uint32_t> lines;
    for (const auto& face : part.faces)
        lines.insert(provenance_of(grooved).of(face.origin).nc_line);
    // In glTF the part comes first; in VRML all bodies count, even bodies that a Transform makes
    // small.
    const double volume = cda::volume(part);
    const auto expect = [&](const char* name, double all) {
        auto out = create(folder / name);
        out.precision(17);
        out << "volume " << all << "\nlines";
        for (const std::uint32_t line : lines)
            out << ' ' << line;
        return out;
    };
    expect("machine_gltf.expect", volume) << "\nfaces 25\nsolids 1\n";
    auto glb = create(folder / "machine_gltf.glb");
    write_gltf(glb, part, provenance_of(grooved), scene);
    // JOINT_A at 2 of 4 seconds is half of the way from 0 to 300 degrees; JOINT_X at 1 second is
    // half of the way from 5 to 45 mm.
    expect("machine_vrml.expect", 6.0 * volume)
        << "\nturned JOINT_A 0.5 LINK_1_round_table 1 0 0 150"
        << "\nshifted JOINT_X 0.25 LINK_0_slide 25 0 0\n";
    auto wrl = create(folder / "machine_vrml.wrl");
    write_vrml(wrl, part, provenance_of(grooved), scene);
}

void write_all(const std::filesystem::path& folder) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const test::BoxPart grooved = test::grooved_part();
    write(folder / "grooved", boundary_of(grooved), provenance_of(grooved), 25, 1);
    write(folder / "tilted", boundary_of(grooved.tilted()), provenance_of(grooved), 25, 1);

    write_pictures(folder / "tilted", grooved.tilted());

    test::BoxPart far_away = test::raster_part().tilted();
    far_away.shift = {1234.5, -4321.25, 987.125};
    write(folder / "far_away", boundary_of(far_away), provenance_of(far_away), 30, 1);

    write_pictures(folder / "far_away", far_away);

    mesh::Provenance odd_name;
    odd_name.entries = {{}, {20, 3}};
    odd_name.program =
        "d\xFC"
        "bel \"quoted\" \\ \n \xE2\x82\xAC.nc";  // Latin-1 and UTF-8 mixed
    write(folder / "plate_with_hole", test::plate_with_hole(), odd_name, 10, 1);

    const test::BoxPart vanished = test::vanished_part();
    write(folder / "vanished", boundary_of(vanished), provenance_of(vanished), 0, 0);

    // A piece of the part hangs in the air, so there are two solids.
    write(folder / "polytopes", test::polytope_part().boundary(),
          test::provenance_of_polytope_part(), 0, 2);

    // Simplification replaces many vertices of this part. In STEP files, some vertices move onto
    // their planes by up to 1e-4 mm; in the mean over the surface, the part moves by 1e-7 mm.
    constexpr double kCoarse = 0.01;
    write(folder / "simplified", mesh::simplify(test::polytope_part().boundary(), kCoarse).boundary,
          test::provenance_of_polytope_part(), 0, 2, 1e-7);

    write(folder / "notched", notched_prism(), {{{}, {5, 2}}, "notched.nc"}, 0, 1);

    const test::BoxPart hollow = test::hollow_part();
    write(folder / "hollow", boundary_of(hollow), provenance_of(hollow), 12, 1);
    const test::BoxPart halves = test::halved_part();
    write_machine(folder);
    write(folder / "halves", boundary_of(halves.tilted()), provenance_of(halves), 12, 2);
}

}  // namespace

}  // namespace ncsim::exporter

int main(int argc, char** argv) {
    try {
        if (argc != 2) throw std::runtime_error("usage: write_samples <folder>");
        ncsim::exporter::write_all(argv[1]);
        return EXIT_SUCCESS;
    } catch (const std::exception& e) {
        std::cerr << "write_samples: " << e.what() << '\n';
        return EXIT_FAILURE;
    }
}
