// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings of the rules gouge and excess.
#include "ncsim/simulation/design_check.h"

#include "ncsim/base/triangle_tree.h"
#include "ncsim/cda/check.h"
#include "ncsim/setup/mesh_file.h"
#include "ncsim/simulation/describe.h"
#include "ncsim/verify/design_comparison.h"
#include "ncsim/verify/region.h"

#include "clip_to_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

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

Finding finding_for(const DesignRegion& region, const Simulation& simulation, bool certain) {
    Finding f;
    const CutRecord& cut = simulation.cuts.at(static_cast<std::size_t>(region.origin));
    f.place = f.last = cut.place;
    f.first_motion = f.last_motion = cut.motion;
    f.tool = cut.tool;
    f.point = region.point;
    f.box = region.box;
    f.certainty = certain ? verify::Certainty::Certain : verify::Certainty::Within;
    f.severity = certain ? verify::Severity::Error : verify::Severity::Warning;
    return f;
}

// Returns the area of a triangle in a box, mm².
double area_within(const TriangleCorners& triangle, const Box& box) {
    return area_of_polygon(clip_to_box({triangle.begin(), triangle.end()}, box));
}

// Names of the design's faces near a region.
class FaceNames {
public:
    explicit FaceNames(const Design& design) : design_(design), tree_(design.mesh) {}

    // Returns the name of the face that has the largest area of the design in the region; empty
    // without a name.
    std::string of(const Box& region) const {
        if (design_.face_names.empty()) return {};
        constexpr double kAround = 0.02;  // mm; includes surfaces on the sides of the region
        const Vec3 around{kAround, kAround, kAround};
        const Box box{region.min - around, region.max + around};
        std::map<std::uint32_t, double> areas;
        tree_.visit([&](const Box& other) { return box.overlaps(other); },
                    [&](std::uint32_t t) {
                        areas[design_.mesh.face.at(t)] +=
                            area_within(corners_of(design_.mesh, t), box);
                    });
        const auto largest = std::ranges::max_element(
            areas, [](const auto& a, const auto& b) { return a.second < b.second; });
        if (largest == areas.end() || largest->second <= 0.0) return {};
        const std::string& name = design_.face_names.at(largest->first);
        // Default name of CAD programs.
        return name == "NONE" ? std::string() : name;
    }

private:
    const Design& design_;
    TriangleTree tree_;
};

// Returns how much the tools of a region may have removed in excess, mm.
double excess_in(const DesignRegion& region, const Simulation& simulation) {
    double error = 0.0;
    for (const cda::Origin origin : region.origins) {
        if (origin == cda::kStockOrigin) continue;
        const auto cutter =
            simulation.cutters.find(simulation.cuts.at(static_cast<std::size_t>(origin)).tool);
        if (cutter != simulation.cutters.end()) error = std::max(error, cutter->second.error_mm);
    }
    return error + simulation.bounds.gained_mm;
}

Finding gouge(const DesignRegion& region, const Design& design, const Simulation& simulation) {
    const double off = design.deflection_mm + excess_in(region, simulation);
    // A thin layer removed from the sides of a sharp edge moves the edge by many times its
    // thickness. The sides are gouged only if the missing material is deeper than the error of the
    // tools.
    Finding f = finding_for(region, simulation,
                            region.depth_mm > design.tolerance_mm + off && region.below_mm > off);
    f.rule = "gouge";
    f.message = "the part is cut into the design";
    const auto lines = lines_of(region, simulation);
    if (lines.size() > 1 || (!lines.empty() && lines.front().first != lines.front().last)) {
        f.message += ", around here by lines " + verify::lines_text(lines);
    }
    f.quantity = verify::Quantity{"depth", region.depth_mm, "mm"};
    return f;
}

Finding excess(const DesignRegion& region, const Design& design, const Simulation& simulation) {
    const double off = design.deflection_mm + simulation.bounds.missed_mm;
    // Facets of a design deviate from its curves. Along a sharp edge the deviation is many times
    // the distance from the sides; so material thinner than the tolerance is not certain.
    const bool certain = region.depth_mm > design.tolerance_mm + off &&
                         region.below_mm > design.tolerance_mm / 2 + off;
    Finding f = finding_for(region, simulation, certain);
    f.rule = "excess";
    f.message = "material is left that the design does not have";
    const auto lines = lines_of(region, simulation);
    f.message += lines.empty() ? ", where nothing was cut"
                               : ", adjacent to the cut of lines " + verify::lines_text(lines);
    f.quantity = verify::Quantity{"thickness", region.depth_mm, "mm"};
    return f;
}

Finding nothing_left_finding(const Design& design) {
    Finding f;
    f.rule = "gouge";
    f.message = "nothing of the part is left";
    f.quantity = verify::Quantity{"missing", cda::volume(design.mesh), "mm3"};
    return f;
}

DesignFacts::Side side_of(const verify::DesignSide& side) {
    return {side.regions.empty() ? 0.0 : side.regions.front().depth_mm, side.volume_mm3,
            side.regions.size()};
}

}  // namespace

Design read_design(const std::string& path, double tolerance_mm, setup::InputSet& inputs) {
    setup::SurfaceFile file = setup::read_surface_file(path, inputs);
    return {setup::name_of_input(path), std::move(file.mesh), tolerance_mm,
            std::move(file.face_names), file.deflection_mm,   std::move(file.assumed)};
}

double smallest_tolerance(const Design& design) {
    return 2.0 * design.deflection_mm;
}

void require_tolerance(const Design& design) {
    const double smallest = smallest_tolerance(design);
    if (design.tolerance_mm >= smallest) return;
    throw std::runtime_error(
        fmt::format("--design-tol {:g}: '{}' is read as triangles within {:g} mm of its surfaces; "
                    "{:g} or more",
                    design.tolerance_mm, design.path, design.deflection_mm, smallest));
}

std::vector<Finding> compare_with(const Design& design, const Simulation& simulation,
                                  DesignFacts& facts) {
    std::vector<Finding> findings;
    facts.path = design.path;
    facts.tolerance_mm = design.tolerance_mm;
    const cda::Boundary part = surface_of_program(simulation);
    if (part.faces.empty()) {
        facts.gouge.regions = 1;
        facts.gouge.volume_mm3 = cda::volume(design.mesh);
        findings.push_back(nothing_left_finding(design));
    } else {
        // Deviations that the triangles of the design may hide are searched, too; they are not
        // certain.
        const double looked_for = design.tolerance_mm - design.deflection_mm;
        const verify::DesignComparison c = verify::compare(part, design.mesh, looked_for);
        facts.resolution_mm = c.resolution_mm;
        facts.deviation_mm = c.deviation_mm;
        facts.gouge = side_of(c.gouge);
        facts.excess = side_of(c.excess);
        const FaceNames names(design);
        const auto add = [&](Finding f) {
            const std::string name = names.of(f.box);
            if (!name.empty()) f.message += "; at the face '" + name + "' of the design";
            findings.push_back(std::move(f));
        };
        for (const DesignRegion& region : c.gouge.regions)
            add(gouge(region, design, simulation));
        for (const DesignRegion& region : c.excess.regions)
            add(excess(region, design, simulation));
    }
    for (Finding& f : findings) {
        f.assumptions.push_back("design: '" + design.path + "' is in the frame of G54");
        if (design.deflection_mm > 0.0) {
            f.assumptions.push_back(fmt::format("design: triangles within {:g} mm of its surfaces",
                                                design.deflection_mm));
        }
    }
    return findings;
}

}  // namespace ncsim::simulation
