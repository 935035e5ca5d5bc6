// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the marks of a picture.
#include "run/legend.h"

#include "ncsim/report/describe.h"
#include "ncsim/toolpath/tool_spec.h"

#include "run/finding_colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace ncsim::app {

namespace {

std::string depth_text(double z_mm, report::LengthUnit unit) {
    return "Z " + report::in_unit(fmt::format("{:.4g} mm", z_mm), unit);
}

std::string line_text(const mesh::Provenance& provenance, const mesh::Provenance::Entry& entry) {
    if (entry.earlier_program == 0) return fmt::format("line {}", entry.nc_line);
    return fmt::format("{}:{}", provenance.earlier_programs[entry.earlier_program - 1],
                       entry.earlier_line);
}

// Returns the number of a tool, with its description if the program or the job has one. Tools of
// earlier set-ups are in the job.
std::string tool_text(const Outcome& outcome, std::uint32_t number) {
    const auto described = [&](const toolpath::Tool& tool) {
        return fmt::format(
            "T{} {}", number,
            report::tool_in_unit(toolpath::describe(tool), outcome.options.report_unit));
    };
    const auto used = outcome.survey.tools.find(static_cast<int>(number));
    if (used != outcome.survey.tools.end()) return described(used->second.tool);
    const auto& tools = outcome.plan.job.tools;
    const auto entry = std::ranges::find_if(tools, [&](const toolpath::ToolEntry& e) {
        return e.spec.number == static_cast<int>(number) && toolpath::is_complete(e.spec) &&
               (e.spec.length || !e.spec.pieces.empty());
    });
    if (entry == tools.end()) return fmt::format("T{}", number);
    return described(toolpath::make_tool(entry->spec, 0.0));
}

// Adds the colours of distances from the design, with the area of each distance as a bar. Heights
// are roots of areas, so small areas stay visible.
void add_distances(const Outcome& outcome, exporter::Marks& marks) {
    const simulation::DesignView& view = *outcome.design;
    const auto length = [&](const char* name, double mm) {
        return std::string(name) +
               report::in_unit(fmt::format("{:.4g} mm", mm), outcome.options.report_unit);
    };
    marks.scale_begin = length("gouge ", view.distances.largest_mm);
    marks.scale_middle = length("within ", view.distances.tolerance_mm);
    marks.scale_end = length("excess ", view.distances.largest_mm);
    marks.scale_colours = exporter::distance_colours(view.distances, simulation::kDistanceClasses);
    const double largest = *std::ranges::max_element(view.areas_mm2);
    for (const double area : view.areas_mm2)
        marks.scale_bars.push_back(largest > 0.0 ? std::sqrt(area / largest) : 0.0);
}

// Adds the colours of the bodies that meet.
void add_met(const verify::Finding& finding, exporter::Marks& marks) {
    if (finding.category != verify::Category::Collision) return;
    const auto is_body = [](const std::string& name) {
        return name != "the tool" && name != "the part";
    };
    if (finding.tool > 0)
        marks.legend.insert(marks.legend.begin(),
                            {kMarkedTool, fmt::format("T{} at the finding", finding.tool)});
    for (std::size_t i = 0; i < finding.bodies.size() && i < 2; ++i) {
        if (is_body(finding.bodies[i]))
            marks.legend.emplace_back(i == 0 ? kFirstMarkedBody : kSecondMarkedBody,
                                      finding.bodies[i]);
    }
}

// Returns the meaning of the colours: the tools that cut, or the ends of the scale.
void add_legend(const Outcome& outcome, const exporter::RenderOptions& options,
                exporter::Marks& marks) {
    const mesh::Provenance& provenance = outcome.simulation->provenance;
    switch (options.colouring) {
        case exporter::Colouring::Tool:
            for (const auto& [number, colour] : exporter::tool_colours(provenance))
                marks.legend.emplace_back(colour, tool_text(outcome, number));
            break;
        case exporter::Colouring::Line:
            if (provenance.entries.size() < 2) break;
            marks.scale_begin = line_text(provenance, provenance.entries[1]);
            marks.scale_end = line_text(provenance, provenance.entries.back());
            break;
        case exporter::Colouring::Depth:
            marks.scale_begin = depth_text(options.depth_top, outcome.options.report_unit);
            marks.scale_end = depth_text(options.depth_bottom, outcome.options.report_unit);
            break;
        case exporter::Colouring::Design: add_distances(outcome, marks); break;
    }
}

}  // namespace

exporter::Marks marks_of(const Outcome& outcome, const exporter::RenderOptions& options) {
    const MarkOptions& shown = outcome.options.marks;
    exporter::Marks marks;
    marks.axes = shown.axes;
    marks.zero = shown.zero;
    marks.scale = shown.scale;
    const report::LengthUnit unit = outcome.options.report_unit;
    const Vec3 size = outcome.survey.stock->box.size();
    marks.size = report::in_unit(1.0, unit) * size;
    marks.mm_per_unit = 1.0 / report::in_unit(1.0, unit);
    marks.unit = report::name_of(unit);
    if (shown.legend) add_legend(outcome, options, marks);
    if (shown.legend && outcome.finding) add_met(*outcome.finding, marks);
    if (outcome.design) {
        for (const report::DesignPlace& place :
             report::largest(outcome.design->places, kMostDesignPlaces))
            marks.places.push_back({place.point, std::to_string(marks.places.size() + 1)});
    }
    if (outcome.finding) {
        if (const auto point = verify::point_of(*outcome.finding))
            marks.places.push_back({*point, {}});
    }
    return marks;
}

}  // namespace ncsim::app
