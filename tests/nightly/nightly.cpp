// SPDX-License-Identifier: GPL-3.0-or-later
//
// nightly [SCENES]: checks that take too long for each test run. SCENES (100,000) random scenes of
// boxes against unit cubes, a hundredth as many of oblique hulls against the flat aggregate, and as
// many of bodies with straight paths, whose volumes are reported per step; ten times as many points
// near the surfaces of a part of many hulls against the definition; and for each thirty scenes a
// random NC program, whose STL and glTF must be closed surfaces in floats. Exit code 1 at the first
// error, with the seed of the failed case.
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/gltf.h"
#include "ncsim/export/stl.h"

#include "support/random_programs.h"
#include "support/scene.h"
#include "support/straight_ways.h"
#include "support/written_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <span>
#include <sstream>

namespace {

using namespace ncsim;

void boxes(std::uint64_t seed) {
    test::Random random(seed);
    std::vector<std::array<int, 6>> all(static_cast<std::size_t>(random.between(1, 14)));
    for (auto& box : all) {
        box = test::random_grid_box(random);
        // Some boxes are repeated, some are thin.
        if (random.between(0, 5) == 0) box = all[0];
    }
    test::check_boxes(all, static_cast<std::uint32_t>(random.between(6, 60)),
                      random.between(0, 1) == 1);
}

void hulls(std::uint64_t seed) {
    test::Random random(seed);
    std::vector<cda::Cell> cells;
    const std::int64_t count = random.between(1, 14);
    for (std::int64_t i = 0; i < count; ++i) {
        cells.push_back(test::random_hull(random, test::random_point(random, 300000),
                                          random.between(1000, 300000),
                                          static_cast<int>(random.between(4, 20)),
                                          cda::Origin{static_cast<std::uint32_t>(i + 1)}));
    }
    test::check_hulls(cells, static_cast<std::uint32_t>(random.between(6, 200)));
}

// Any number of pending cells, and queries at any time.
void straight_ways(std::uint64_t seed) {
    test::Random random(seed);
    const cda::Cell stock = test::mm_box(-3, -3, -3, 3, 3, 3);
    const auto batch = static_cast<std::uint32_t>(random.between(1, 60));
    cda::TreeCda measured(stock, test::kLattice);
    cda::TreeCda booked(stock, test::kLattice,
                        {static_cast<std::uint32_t>(random.between(8, 120)), 1, batch});
    booked.track_removal();
    cda::RemovalByMotion taken;
    std::vector<cda::Cell> before;
    for (const test::StraightWay& way :
         test::straight_ways(seed, static_cast<int>(random.between(1, 12)))) {
        for (const cda::Cell& step : way.steps) {
            taken[step.origin].volume = measured.subtract(step);
            booked.subtract_step(std::span(&step, 1), {}, before);
            before.clear();
            if (random.one_in(40)) booked.settle();
        }
        before = {way.all};
    }
    booked.subtract_step({}, {}, before);
    test::sound_boundary(booked, 216.0);
    test::require(std::abs(booked.volume() - measured.volume()) <= 1e-9 * 216.0,
                  "the volumes differ");
    test::require_booked(booked.account(), taken, 216.0);
}

// Lattice points up to three units off surfaces, where rounding errors would appear first.
void membership(std::uint64_t seed, long points) {
    test::Random random(seed);
    const cda::Cell stock = test::mm_box(-3, -3, -3, 3, 3, 3);
    std::vector<cda::Cell> cells;
    for (std::uint32_t i = 0; i < 60; ++i) {
        cells.push_back(test::random_hull(random, test::random_point(random, 300000), 80000, 16,
                                          cda::Origin{i + 1}));
    }
    cda::TreeCda part(stock, test::kLattice, {24, 1});
    part.subtract_unmeasured(cells);
    const TriangleMesh mesh = cda::triangulate(part.boundary());
    const auto unit = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
    for (long i = 0; i < points; ++i) {
        const auto& t = mesh.triangles[random.next() % mesh.triangles.size()];
        double u = unit();
        double v = unit();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const Vec3 a = mesh.vertices[t[0]];
        const Vec3 on = a + u * (mesh.vertices[t[1]] - a) + v * (mesh.vertices[t[2]] - a);
        const cda::LatticePoint p = test::kLattice.round(on) + test::random_point(random, 3);
        const auto is_inside = [&](const cda::Cell& cell) {
            return std::all_of(cell.planes.begin(), cell.planes.end(), [&](const cda::Plane& h) {
                return h.nx * p.x + h.ny * p.y + h.nz * p.z < h.d;
            });
        };
        const bool in_stock = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 300000;
        const bool expected = in_stock && std::none_of(cells.begin(), cells.end(), is_inside);
        test::require(part.contains(test::kLattice.to_mm(p)) == expected,
                      "a point is on the wrong side");
    }
}

// Each fourth program has rotary moves.
void programs(std::uint64_t seed) {
    const test::MilledPart part =
        test::mill(test::random_program(seed, seed % 4 == 3), cda::TreeCda(cda::TreeParameters{}));
    std::ostringstream stl, glb;
    exporter::write_stl(stl, cda::triangulate(part.boundary));
    exporter::write_gltf(glb, part.boundary, part.provenance);
    for (const auto& mesh : {test::read_stl(stl.str()), test::read_glb(glb.str())}) {
        const test::Soundness found = test::soundness(mesh);
        test::require(found.is_sound(), to_string(found).c_str());
        if (found.triangles == 0) continue;
        const double step = std::ldexp(1.0, std::ilogb(found.largest) - 23);
        test::require(std::abs(found.volume - part.volume) <= 2.0 * step * found.area,
                      "the volume of the file is not that of the aggregate");
    }
}

template <class Run>
void all(const char* what, long count, Run run) {
    for (long i = 0; i < count; ++i) {
        try {
            run(static_cast<std::uint64_t>(i));
        } catch (const std::exception& e) {
            std::printf("%s, seed %ld: %s\n", what, i, e.what());
            std::exit(1);
        }
        if ((i + 1) % std::max(1L, count / 10) == 0) {
            std::printf("%s: %ld of %ld\n", what, i + 1, count);
            std::fflush(stdout);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const long scenes = argc > 1 ? std::atol(argv[1]) : 100000;
    constexpr long kPointsAPart = 10000;
    all("boxes", scenes, boxes);
    all("hulls", scenes / 100, hulls);
    all("straight ways", scenes / 100, straight_ways);
    all("programs", scenes / 30, programs);
    all("points (in ten thousands)", std::max(1L, 10 * scenes / kPointsAPart),
        [](std::uint64_t seed) { membership(seed, kPointsAPart); });
}
