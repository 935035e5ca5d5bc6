// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.h"

#include "ncsim/export/camera.h"
#include "ncsim/export/render.h"
#include "ncsim/export/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::app {

namespace {

exporter::RenderOptions render_options(const Outcome& outcome, exporter::View view) {
    const Options& o = outcome.job.options;
    const cda::Box& stock = outcome.survey.stock->box;
    exporter::RenderOptions options;
    options.width = o.width;
    options.height = o.height;
    options.background = o.background;
    options.colouring = o.colouring;
    options.depth_top = stock.max.z;
    options.depth_bottom = std::max(stock.min.z, outcome.survey.tip_positions.min.z);
    options.camera = exporter::fit_camera(stock, view, static_cast<double>(o.width) / o.height);
    return options;
}

exporter::Image view_of(const Outcome& outcome, exporter::View view) {
    const Simulation& s = *outcome.simulation;
    const exporter::RenderOptions options = render_options(outcome, view);
    // The flat aggregate is drawn by its masks, as the thesis does it.
    if (outcome.job.options.model == "cda-flat")
        return exporter::render_model(*s.part, s.provenance, options);
    return exporter::render_boundary(*outcome.boundary, s.provenance, options);
}

std::vector<std::string> caption(const Outcome& outcome) {
    const Simulation& s = *outcome.simulation;
    const cda::Vec3 size = outcome.survey.stock->box.size();
    const double removed = s.stock_volume - s.part_volume;
    const Distances path = total_distances(outcome.survey);
    std::string travelled = fmt::format("{:.1f} mm at feed", path.feed_mm);
    if (path.feed_seconds) travelled += " in " + time_text(*path.feed_seconds);
    return {fmt::format("{}: {:.6g} x {:.6g} x {:.6g} mm", base_name(outcome.job.program.name),
                        size.x, size.y, size.z),
            fmt::format("{} of {} removed ({:.1f} %)", volume_text(removed),
                        volume_text(s.stock_volume), 100.0 * removed / s.stock_volume),
            fmt::format("{}, {:.1f} mm rapid", travelled, path.rapid_mm)};
}

}  // namespace

exporter::Image picture(const Outcome& outcome) {
    const std::vector<exporter::View>& views = outcome.job.options.views;
    if (views.size() == 1) return view_of(outcome, views.front());
    std::vector<exporter::LabelledImage> pictures;
    for (const exporter::View view : views)
        pictures.push_back({std::string(exporter::name(view)), view_of(outcome, view)});
    return exporter::contact_sheet(pictures, caption(outcome), outcome.job.options.background);
}

}  // namespace ncsim::app
