// SPDX-License-Identifier: GPL-3.0-or-later
//
// thesis_table FOLDER SAMPLE.nc…: repeats the measurements of thesis chapter 7. Prints a row of a
// table per sample, and writes FOLDER/<sample>.csv with a row per negative cell (time in
// milliseconds).
#include "ncsim/cda/flat.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/render.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include "options/plan_options.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace ncsim;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void measure(const std::filesystem::path& folder, const std::filesystem::path& file) {
    app::Options options;
    options.program = file.string();
    options.model = "cda-flat";
    options.stats = "timed";  // gives the model a clock; no file is written
    setup::InputSet inputs;
    simulation::Plan plan = app::plan_for(options, inputs);
    const simulation::Survey survey = simulation::survey(plan);
    const simulation::Simulation run = simulation::simulate(plan, survey, {}, {});
    const auto& part = dynamic_cast<const cda::FlatCda&>(*run.part);

    // Renders along the way: inserts the same cells again and draws about 20 pictures at even
    // steps.
    exporter::RenderOptions render;
    render.width = 1024;
    render.height = 768;
    render.samples = 1;
    render.edges = false;
    render.camera = exporter::fit_camera(survey.stock->box, exporter::View::Iso, 1024.0 / 768.0);
    const auto steps = part.steps().size();
    std::vector<double> rendering(steps, -1.0);
    cda::FlatCda stock(cda::box_cell(run.lattice.round(survey.stock->box.min),
                                     run.lattice.round(survey.stock->box.max), run.lattice),
                       run.lattice);
    for (std::size_t i = 0; i < steps; ++i) {
        cda::Cell cell;
        for (const auto& facet : part.negative()[i].body.facets())
            cell.planes.push_back(facet.plane);
        cell.origin = part.negative()[i].origin;
        cell.bounds = survey.stock->box;
        stock.subtract(cell);
        if (i % std::max<std::size_t>(1, steps / 20) != 0 && i + 1 != steps) continue;
        const double start = seconds();
        exporter::render_model(stock, run.provenance, render);
        rendering[i] = seconds() - start;
    }

    std::ofstream csv(folder / (file.stem().string() + ".csv"));
    csv << "negative_cell,lp_negative,hull_negative,lp_zero,hull_zero,rendering,"
           "stencilled_negative,visible_negative,zero_facets,zero_per_negative\n";
    double zero_cells = 0.0;
    double lp = 0.0;
    double hull = 0.0;
    std::uint64_t fallbacks = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const cda::StepStatistics& s = part.steps()[i];
        zero_cells += s.new_zero_cells;
        lp += s.negative.linear_programming_seconds + s.zero.linear_programming_seconds;
        hull += s.negative.convex_hull_seconds + s.zero.convex_hull_seconds;
        fallbacks += s.negative.exact_fallbacks + s.zero.exact_fallbacks;
        csv << i + 1 << ',' << 1e3 * s.negative.linear_programming_seconds << ','
            << 1e3 * s.negative.convex_hull_seconds << ','
            << 1e3 * s.zero.linear_programming_seconds << ',' << 1e3 * s.zero.convex_hull_seconds
            << ',';
        if (rendering[i] >= 0.0) csv << 1e3 * rendering[i];
        csv << ',' << s.stencilled_negative_facets << ',' << s.visible_negative_facets << ','
            << s.zero_facets << ',' << s.new_zero_cells << '\n';
    }
    const cda::StepStatistics& last = part.steps().back();
    std::printf("| %s | %zu | %.0f | %.1f | %llu | %llu | %llu | %.3f | %.3f | %.3f | %llu |\n",
                file.stem().c_str(), steps, zero_cells, zero_cells / static_cast<double>(steps),
                static_cast<unsigned long long>(last.stencilled_negative_facets),
                static_cast<unsigned long long>(last.visible_negative_facets),
                static_cast<unsigned long long>(last.zero_facets), lp, hull, rendering.back(),
                static_cast<unsigned long long>(fallbacks));
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::puts(
            "| program | negative cells | zero cells | zero per negative | stencilled negative "
            "facets | visible negative facets | zero facets | linear programs, s | hulls, s | "
            "rendering, s a frame | exact fallbacks |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|");
        for (int i = 2; i < argc; ++i)
            measure(argv[1], argv[i]);
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "thesis_table: %s\n", e.what());
        return 2;
    }
}
