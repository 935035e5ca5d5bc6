// SPDX-License-Identifier: GPL-3.0-or-later
//
// nightly_models WHAT COUNT: checks models of the workpiece against known results. Exit code 1 at
// the first error, with the number of the failed case.
//
//   nef COUNT         random scenes of unit cubes, a tenth as many oblique scenes, and two samples:
//                     the exact model against boundary evaluation, corner for corner
//   rays COUNT        random parts with walls of 0.3 to 3 pitches: closed, equal for 1, 2 and 8
//                     threads and for any order of the cuts, the volume within the stated error
//   points COUNT      points of random parts, farther than a pitch from the surface: in or out
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/tree.h"
#include "ncsim/dexel/dexel.h"

#include "nef/agreement.h"
#include "support/random.h"
#include "support/random_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace ncsim;
using test::kLattice;

void require(bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error(what);
}

void for_each_number(const char* what, long count, const std::function<void(std::uint64_t)>& work) {
    for (long i = 0; i < count; ++i) {
        try {
            work(static_cast<std::uint64_t>(i));
        } catch (const std::exception& e) {
            throw std::runtime_error(std::string(what) + " " + std::to_string(i) + ": " + e.what());
        }
        if ((i + 1) % std::max(1L, count / 10) == 0) {
            std::printf("%s: %ld of %ld\n", what, i + 1, count);
            std::fflush(stdout);
        }
    }
}

// --- boundary evaluation ---

void compare_with_nef(long count) {
    const auto agree = [](const std::string& disagreement) {
        require(disagreement.empty(), disagreement);
    };
    for_each_number("unit cubes", count,
                    [&](std::uint64_t i) { agree(test::disagreement_of_boxes(i)); });
    for_each_number("hulls", count / 10,
                    [&](std::uint64_t i) { agree(test::disagreement_of_hulls(i)); });
    for (const char* name : {"simple", "complex"}) {
        agree(
            test::disagreement_of_program(std::string(NCSIM_SOURCE_DIR "/samples/") + name + ".nc",
                                          static_cast<std::size_t>(count)));
        std::printf("%s.nc: the first %ld hulls at most\n", name, count);
    }
}

// --- rays ---

using Cut = std::variant<cda::Cell, cda::RoundSweep>;

struct Scene {
    double pitch = 0.5;
    bool only_z = false;
    std::vector<Cut> cuts;
};

Vec3 somewhere(test::Random& random) {
    return {random.within(0, 10), random.within(0, 10), random.within(0, 6)};
}

// Returns a pocket with ribs or slots of 0.3 to 3 pitches, boxes of any size, oblique hulls, round
// tools.
Scene scene_of(std::uint64_t number) {
    test::Random random(70000 + number);
    Scene scene;
    scene.pitch = random.within(0.35, 0.8);
    scene.only_z = random.one_in(4);
    std::uint32_t motion = 0;
    const auto add_box = [&](Vec3 min, Vec3 max) {
        scene.cuts.emplace_back(cda::box_cell(kLattice.round(min), kLattice.round(max), kLattice,
                                              cda::Origin{++motion}));
    };
    const auto thin = [&] { return scene.pitch * random.within(0.3, 3.0); };
    double x = random.within(-1, 3);
    for (std::uint64_t i = random.next() % 4; i > 0 && x < 9; --i) {
        const double wide = random.one_in(2) ? thin() : random.within(1, 4);
        add_box({x, random.within(-1, 4), random.within(-1, 4)},
                {x + wide, random.within(5, 11), 7});
        x += wide + thin();
    }
    for (std::uint64_t i = random.next() % 12; i > 0; --i) {
        const Vec3 at = somewhere(random);
        if (random.one_in(3)) {
            add_box(at, at + Vec3{thin(), random.within(0.5, 5), random.within(0.5, 5)});
        } else if (random.one_in(2)) {
            std::vector<cda::LatticePoint> points;
            for (int k = 0; k < 7; ++k)
                points.push_back(kLattice.round(
                    at + Vec3{random.within(-3, 3), random.within(-3, 3), random.within(-3, 3)}));
            if (const auto hull = cda::convex_hull(points, kLattice, cda::Origin{++motion}))
                scene.cuts.emplace_back(*hull);
        } else {
            cda::RoundSweep sweep;
            sweep.radius = random.within(0.3, 2);
            sweep.flat_radius = sweep.radius;
            if (!random.one_in(3)) {
                sweep.flat_radius *= random.one_in(2) ? 0.0 : random.within(0, 1);
                sweep.is_cone = random.one_in(2);
                sweep.tip_height =
                    sweep.is_cone ? random.within(0.1, 3) : sweep.radius - sweep.flat_radius;
            }
            sweep.height = sweep.tip_height + random.within(0.5, 12);
            sweep.from = at;
            sweep.to = at + Vec3{random.within(-4, 4), random.within(-4, 4), random.within(-2, 2)};
            if (random.one_in(3)) sweep.to.z = at.z;
            sweep.origin = cda::Origin{++motion};
            for (const Vec3& end : {sweep.from, sweep.to}) {
                sweep.bounds.add(end - Vec3{sweep.radius, sweep.radius, 0});
                sweep.bounds.add(end + Vec3{sweep.radius, sweep.radius, sweep.height});
            }
            scene.cuts.emplace_back(sweep);
        }
    }
    return scene;
}

std::unique_ptr<cda::WorkpieceModel> cut_of(const Scene& scene, std::size_t threads) {
    const dexel::Dexel prototype(
        {threads, scene.pitch, scene.only_z ? dexel::Directions::OnlyZ : dexel::Directions::Three});
    auto part = prototype.create(test::mm_box(0, 0, 0, 10, 10, 6), kLattice);
    for (const Cut& cut : scene.cuts) {
        if (const auto* cell = std::get_if<cda::Cell>(&cut)) {
            part->subtract_unmeasured(*cell);
        } else {
            dynamic_cast<cda::SweepModel&>(*part).subtract_sweep(std::get<cda::RoundSweep>(cut));
        }
    }
    return part;
}

void look_at_rays(std::uint64_t number) {
    Scene scene = scene_of(number);
    const auto part = cut_of(scene, 1);
    const cda::Boundary boundary = part->boundary();
    require(cda::check(boundary).is_closed(), "the surface is not closed");
    for (const std::size_t threads : {2U, 8U}) {
        const auto other = cut_of(scene, threads);
        require(
            other->volume() == part->volume() && other->boundary().vertices == boundary.vertices,
            "threads change the part");
    }
    test::Random random(number);
    for (std::size_t i = scene.cuts.size(); i > 1; --i)
        std::swap(scene.cuts[i - 1], scene.cuts[random.next() % i]);
    require(cut_of(scene, 1)->volume() == part->volume(), "the order of the cuts changes the part");
}

// Returns membership by definition, if `p` is farther than `margin` from all possible surfaces.
std::optional<bool> is_in(const std::vector<cda::Cell>& cells, const cda::Cell& stock, Vec3 p,
                          double margin) {
    const auto distance = [&](const cda::Cell& cell) {
        double most = -1e9;
        for (const cda::Plane& plane : cell.planes)
            most =
                std::max(most, dot(cda::unit_normal(plane), p) - cda::offset_mm(plane, kLattice));
        return most;
    };
    bool is_near = false;
    for (const cda::Cell& cell : cells) {
        const double away = distance(cell);
        if (away < -margin) return false;
        is_near |= away <= margin;
    }
    const double away = distance(stock);
    if (away > margin) return false;
    if (is_near || away > -margin) return std::nullopt;
    return true;
}

void look_at_points(long count) {
    const cda::Cell stock = test::mm_box(0, 0, 0, 10, 10, 6);
    long asked = 0;
    for (std::uint64_t number = 0; asked < count; ++number) {
        test::Random random(90000 + number);
        const double pitch = random.within(0.1, 0.3);
        const auto part = dexel::Dexel({1, pitch}).create(stock, kLattice);
        std::vector<cda::Cell> cells;
        for (int i = 0; i < 8; ++i) {
            const Vec3 at = somewhere(random);
            std::vector<cda::LatticePoint> points;
            for (int k = 0; k < 8; ++k)
                points.push_back(kLattice.round(
                    at + Vec3{random.within(-3, 3), random.within(-3, 3), random.within(-3, 3)}));
            if (const auto hull = cda::convex_hull(points, kLattice, cda::Origin{1}))
                cells.push_back(*hull);
        }
        part->subtract_unmeasured(cells);
        for (int i = 0; i < 20000 && asked < count; ++i) {
            const Vec3 p = somewhere(random);
            const auto expected = is_in(cells, stock, p, pitch);
            if (!expected) continue;
            ++asked;
            require(part->contains(p) == *expected,
                    "a point of part " + std::to_string(number) + " is on the wrong side");
        }
    }
    std::printf("points: %ld\n", asked);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    const long count = argc > 2 ? std::atol(argv[2]) : 0;
    try {
        if (what == "nef" && count > 0) {
            compare_with_nef(count);
        } else if (what == "rays" && count > 0) {
            for_each_number("parts", count, look_at_rays);
        } else if (what == "points" && count > 0) {
            look_at_points(count);
        } else {
            std::fprintf(stderr, "usage: nightly_models nef|rays|points COUNT\n");
            return 2;
        }
    } catch (const std::exception& e) {
        std::printf("%s\n", e.what());
        return 1;
    }
    return 0;
}
