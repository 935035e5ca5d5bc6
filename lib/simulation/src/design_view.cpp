// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the distances of a surface from a design, and sums areas by distance.
#include "ncsim/simulation/design_view.h"

#include "ncsim/cda/triangulate.h"

#include "deviation_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace ncsim::simulation {

namespace {

std::vector<double> areas_by_distance(const exporter::DesignDistances& distances) {
    std::vector<double> areas(kDistanceClasses, 0.0);
    const auto& p = distances.mesh.vertices;
    for (const auto& [a, b, c] : distances.mesh.triangles) {
        const double area = 0.5 * norm(cross(p[b] - p[a], p[c] - p[a]));
        const double mean =
            (distances.distance_mm[a] + distances.distance_mm[b] + distances.distance_mm[c]) / 3.0;
        const double share = 0.5 * (mean / distances.largest_mm + 1.0);
        const double number = std::floor(share * static_cast<double>(kDistanceClasses));
        areas[static_cast<std::size_t>(
            std::clamp(number, 0.0, static_cast<double>(kDistanceClasses - 1)))] += area;
    }
    return areas;
}

}  // namespace

DesignView design_view(const Design& design, const Simulation& simulation,
                       const cda::Boundary& boundary) {
    if (boundary.faces.empty())
        throw std::runtime_error("--colour design: nothing of the part is left");
    DesignView view;
    for (const verify::Finding& f : compare_with(design, simulation, view.facts)) {
        if (!f.point || !f.quantity) continue;
        view.places.push_back({f.rule == "gouge", f.quantity->value, *f.point,
                               f.place.file == 0 ? f.place.span.line : 0});
    }
    DeviationMesh measured = deviation_mesh(cda::triangulate(boundary), design);
    view.distances.mesh = std::move(measured.mesh);
    view.distances.distance_mm = std::move(measured.deviation_mm);
    view.distances.tolerance_mm = design.tolerance_mm;
    view.distances.largest_mm = 2.0 * design.tolerance_mm;
    for (const double mm : view.distances.distance_mm)
        view.distances.largest_mm = std::max(view.distances.largest_mm, std::abs(mm));
    view.areas_mm2 = areas_by_distance(view.distances);
    return view;
}

}  // namespace ncsim::simulation
