// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_random_parts <folder> <count> [first], or <folder> --seeds <seed>...: parts of random
// programs as STEP, with what ncsim_read_step is to find; says how many have facets.
#include "ncsim/brep/measure.h"
#include "ncsim/export/step.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

#include "brep/random_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <string_view>
#include <vector>

namespace ncsim::brep::test {

namespace {

// How many of its faces are facets.
std::size_t write(const std::filesystem::path& stem, const std::string& text) {
    std::ofstream(stem.string() + ".nc") << text;
    simulation::Plan plan;
    plan.job = setup::job_of({stem.filename().string() + ".nc", text});
    plan.keep_boundary = true;
    const simulation::Survey survey = simulation::survey(plan);
    if (!survey.is_ready()) throw std::runtime_error(simulation::reason_against(survey));
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    const simulation::Simulation milled = simulation::simulate(plan, survey, nothing, {});
    const Recognised solid = simulation::solid_of(plan, survey, milled, exporter::kStepTolerance);
    std::ofstream out(stem.string() + ".step", std::ios::binary);
    exporter::write_step_solid(out, solid.part, milled.provenance);
    // What edges miss moves faces, and OpenCASCADE integrates over splines less exactly.
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
        std::vector<std::uint64_t> seeds;
        if (std::string_view(argv[2]) == "--seeds") {
            for (int i = 3; i < argc; ++i)
                seeds.push_back(number(i));
        } else {
            seeds.resize(number(2));
            std::iota(seeds.begin(), seeds.end(), argc > 3 ? number(3) : 0);
        }
        std::size_t whole = 0;
        for (const std::uint64_t seed : seeds) {
            const auto facets = write(folder / fmt::format("{:06}", seed), random_part(seed));
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
