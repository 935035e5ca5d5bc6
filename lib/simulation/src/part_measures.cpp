// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of a part, with the lines and the tools that cut each feature.
#include "ncsim/simulation/part_measures.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/triangle_tree.h"
#include "ncsim/brep/features.h"
#include "ncsim/brep/measure.h"
#include "ncsim/cda/triangulate.h"

#include "threads.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace ncsim::simulation {

namespace {

CutBy cut_by(const std::vector<cda::Origin>& origins, const mesh::Provenance& provenance) {
    std::set<std::uint32_t> lines, tools;
    std::set<EarlierLine> earlier;
    for (const cda::Origin origin : origins) {
        const auto entry = provenance.of(origin);
        if (entry.is_stock()) continue;
        tools.insert(entry.tool);
        if (entry.earlier_program == 0) {
            lines.insert(entry.nc_line);
        } else {
            earlier.insert(
                {provenance.earlier_programs[entry.earlier_program - 1], entry.earlier_line});
        }
    }
    return {{lines.begin(), lines.end()},
            {tools.begin(), tools.end()},
            {earlier.begin(), earlier.end()}};
}

}  // namespace

MeasureSheet measures_of(const Plan& plan, const Survey& survey, const Solid& solid,
                         const cda::Boundary& boundary) {
    const brep::Part& part = solid.recognised.part;
    const TriangleMesh mesh = cda::triangulate(boundary);
    const brep::Features features = brep::features_of(part, TriangleTree(mesh));
    const auto by = [&](const auto& feature) { return cut_by(feature.origins, solid.provenance); };
    MeasureSheet sheet;
    sheet.extents = cda::bounds(boundary);
    sheet.volume_mm3 = brep::volume(part);
    for (const brep::Bore& b : features.bores) {
        sheet.bores.push_back({b.mouth, b.axis, b.diameter, b.depth, b.mouth_slants_by,
                               b.covers_degrees, std::string(brep::name_of(b.end)), b.tip_depth,
                               b.tip_angle_degrees, by(b)});
    }
    for (const brep::Countersink& c : features.countersinks)
        sheet.countersinks.push_back({c.mouth, c.axis, c.diameter, c.depth, c.angle_degrees,
                                      c.covers_degrees, c.has_tip, by(c)});
    for (const brep::Chamfer& c : features.chamfers)
        sheet.chamfers.push_back({c.width, c.height, c.angle_degrees, c.length, c.at, by(c)});
    for (const brep::Boss& b : features.bosses)
        sheet.bosses.push_back({b.foot, b.axis, b.diameter, b.height, b.covers_degrees, by(b)});
    for (const brep::Corner& c : features.corners)
        sheet.corners.push_back(
            {c.radius, c.is_inside, c.covers_degrees, c.on_axis, c.axis, by(c)});
    for (const brep::Floor& f : features.floors)
        sheet.floors.push_back({f.z, f.area, f.is_closed, f.box, by(f)});
    for (const brep::Distance& d : features.distances)
        sheet.distances.push_back({d.mm, d.is_void, d.from, d.to, by(d)});
    sheet.threads = threads_of(plan, survey, sheet);
    sheet.has_too_many_walls = features.has_too_many_walls;
    sheet.facets = features.facets;
    sheet.facet_area_mm2 = features.facet_area;
    sheet.facet_lines = cut_by(solid.recognised.of_facets, solid.provenance).lines;
    return sheet;
}

}  // namespace ncsim::simulation
