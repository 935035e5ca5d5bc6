// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/design.h"

#include "ncsim/cda/check.h"
#include "ncsim/report/describe.h"
#include "ncsim/verify/design.h"

namespace ncsim::simulation {

namespace {

using verify::DesignRegion;
using verify::Finding;

std::vector<verify::LineRange> lines_of(const DesignRegion& region, const Simulation& simulation) {
    std::vector<verify::LineRange> lines;
    for (const cda::Origin origin : region.origins) {
        if (origin == cda::kStockOrigin) continue;
        const verify::Place& place = simulation.cuts.at(static_cast<std::size_t>(origin)).place;
        lines.push_back({place.file, place.span.line, place.span.line});
    }
    return verify::merged(std::move(lines));
}

Finding finding_for(const DesignRegion& region, const Simulation& simulation) {
    Finding f;
    const Cut& cut = simulation.cuts.at(static_cast<std::size_t>(region.origin));
    f.place = f.last = cut.place;
    f.first_motion = f.last_motion = cut.motion;
    f.tool = cut.tool;
    f.point = region.point;
    f.box = region.box;
    return f;
}

Finding gouge(const DesignRegion& region, const Design& design, const Simulation& simulation) {
    Finding f = finding_for(region, simulation);
    f.rule = "gouge";
    const auto cutter = simulation.cutters.find(f.tool);
    const double off = (cutter == simulation.cutters.end() ? 0.0 : cutter->second.error_mm) +
                       simulation.bounds.gained_mm;
    const bool certain = region.depth_mm > design.tolerance_mm + off;
    f.certainty = certain ? verify::Certainty::Certain : verify::Certainty::Within;
    f.severity = certain ? verify::Severity::Error : verify::Severity::Warning;
    f.message = "the part is cut into the design";
    const auto lines = lines_of(region, simulation);
    if (lines.size() > 1 || (!lines.empty() && lines.front().first != lines.front().last)) {
        f.message += ", around here by lines " + report::lines_text(lines);
    }
    f.quantity = verify::Quantity{"depth", region.depth_mm, "mm"};
    return f;
}

Finding excess(const DesignRegion& region, const Design& design, const Simulation& simulation) {
    Finding f = finding_for(region, simulation);
    f.rule = "excess";
    const bool certain = region.depth_mm > design.tolerance_mm + simulation.bounds.missed_mm;
    f.certainty = certain ? verify::Certainty::Certain : verify::Certainty::Within;
    f.severity = verify::Severity::Warning;
    f.message = "material is left that the design does not have";
    const auto lines = lines_of(region, simulation);
    f.message += lines.empty() ? ", where nothing was cut"
                               : ", beside what was cut by lines " + report::lines_text(lines);
    f.quantity = verify::Quantity{"thickness", region.depth_mm, "mm"};
    return f;
}

Finding nothing_left(const Design& design) {
    Finding f;
    f.rule = "gouge";
    f.message = "nothing of the part is left";
    f.quantity = verify::Quantity{"missing", cda::volume(design.mesh), "mm3"};
    return f;
}

report::DesignFacts::Side side_of(const verify::DesignSide& side) {
    return {side.regions.empty() ? 0.0 : side.regions.front().depth_mm, side.volume_mm3,
            side.regions.size()};
}

}  // namespace

std::vector<Finding> compare_with(const Design& design, const Simulation& simulation,
                                  report::DesignFacts& facts) {
    std::vector<Finding> findings;
    facts.path = design.path;
    facts.tolerance_mm = design.tolerance_mm;
    const cda::Boundary part = simulation.part->boundary();
    if (part.faces.empty()) {
        facts.gouge.regions = 1;
        facts.gouge.volume_mm3 = cda::volume(design.mesh);
        findings.push_back(nothing_left(design));
    } else {
        const verify::DesignComparison c = verify::compare(part, design.mesh, design.tolerance_mm);
        facts.resolution_mm = c.resolution_mm;
        facts.deviation_mm = c.deviation_mm;
        facts.gouge = side_of(c.gouge);
        facts.excess = side_of(c.excess);
        for (const DesignRegion& region : c.gouge.regions)
            findings.push_back(gouge(region, design, simulation));
        for (const DesignRegion& region : c.excess.regions)
            findings.push_back(excess(region, design, simulation));
    }
    for (Finding& f : findings) {
        f.assumptions.push_back("design: '" + design.path + "' is in the frame of G54");
    }
    return findings;
}

}  // namespace ncsim::simulation
