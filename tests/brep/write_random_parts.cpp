// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_random_parts <folder> [--faceted] <count> [first], or <folder> [--faceted] --seeds
// <seed>...: writes parts of random programs as STEP, with the values that ncsim_read_step is to
// find, and prints how many parts have facets. Seeds of tilted_parts.h tilt the tool or the part.
// With --faceted all faces are facets.
#include "ncsim/brep/measure.h"
#include "ncsim/export/step.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

#include "brep/cam_parts.h"
#include "brep/groove_parts.h"
#include "brep/random_parts.h"
#include "brep/slot_parts.h"
#include "brep/tilted_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::brep::test {

namespace {

// Writes the program of `seed` and, if needed, its machine; returns a plan for both.
simulation::Plan plan_of(const std::filesystem::path& stem, std::uint64_t seed) {
    const std::string name = stem.filename().string() + ".nc";
    std::ofstream out(stem.string() + ".nc");
    if (seed >= kTilted && seed < kWithSlopes) {
        const TiltedPart part = tilted_part(seed);
        out << part.program;
        std::ofstream(stem.string() + ".toml")
            << "preset = \"" << part.machine << "\"\ncontrol = { tip_frame = \"table\" }\n";
        return plan_of(part, name);
    }
    const std::string program = seed >= kGrooves ? groove_part(seed)
                                : seed >= kSlots ? slot_part(seed)
                                : seed >= kCam   ? cam_part(seed)
                                                 : random_part(seed);
    out << program;
    simulation::Plan plan;
    plan.job = setup::job_of({name, program});
    plan.keep_boundary = true;
    return plan;
}

Recognised facets_of(const simulation::Simulation& milled) {
    FlatPart flat = exporter::flat_solid(*milled.boundary, exporter::kStepTolerance);
    Recognised solid{std::move(flat.part)};
    solid.tolerance_factor = flat.tolerance_factor;
    solid.is_sound = flat.is_sound;
    return solid;
}

// Writes the part of `seed`; returns how many of its faces are facets.
std::size_t write(const std::filesystem::path& stem, std::uint64_t seed, bool is_faceted) {
    simulation::Plan plan = plan_of(stem, seed);
    const simulation::Survey survey = simulation::survey(plan);
    if (!survey.is_ready()) throw std::runtime_error(simulation::reason_not_simulated(survey));
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    const simulation::Simulation milled = simulation::simulate(plan, survey, nothing, {});
    const Recognised solid =
        is_faceted ? facets_of(milled)
                   : simulation::solid_of(plan, survey, milled, exporter::kStepTolerance);
    if (solid.tolerance_factor > 1.0)
        std::cout << seed << ": coarser " << solid.tolerance_factor << " times\n";
    if (!solid.is_sound) std::cout << seed << ": not sound\n";
    std::ofstream out(stem.string() + ".step", std::ios::binary);
    exporter::write_step_solid(out, solid.part, milled.provenance);
    // Gaps at edges move faces, and OpenCASCADE integrates over splines less exactly.
    constexpr double kIntegrals = 1e-6;
    std::ofstream(stem.string() + ".expect") << fmt::format(
        "solids {}\nvolume {}\nmoved {}\n", -int(milled.boundary->shells), volume(solid.part),
        kIntegrals + std::max(solid.part.miss_mm, solid.part.facet_miss_mm));
    return solid.facets_kept;
}

}  // namespace

}  // namespace ncsim::brep::test

int main(int argc, char** argv) {
    using namespace ncsim::brep::test;
    if (argc < 3) return EXIT_FAILURE;
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        const auto number = [&](int i) { return std::strtoull(argv[i], nullptr, 10); };
        const bool is_faceted = std::string_view(argv[2]) == "--faceted";
        const int next = is_faceted ? 3 : 2;
        if (next >= argc) return EXIT_FAILURE;
        std::vector<std::uint64_t> seeds;
        if (std::string_view(argv[next]) == "--seeds") {
            for (int i = next + 1; i < argc; ++i)
                seeds.push_back(number(i));
        } else {
            seeds.resize(number(next));
            std::iota(seeds.begin(), seeds.end(), argc > next + 1 ? number(next + 1) : 0);
        }
        std::size_t whole = 0;
        for (const std::uint64_t seed : seeds) {
            const auto facets = write(folder / fmt::format("{:06}", seed), seed, is_faceted);
            if (facets == 0) ++whole;
            if (facets != 0) std::cout << seed << ": " << facets << " facets\n";
        }
        std::cout << whole << " of " << seeds.size() << " without facets\n";
        return EXIT_SUCCESS;
    } catch (const std::exception& e) {
        std::cerr << "write_random_parts: " << e.what() << '\n';
        return EXIT_FAILURE;
    }
}
