// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prepares the outcome for reports.
#include "run/outcome.h"

#include <algorithm>

namespace ncsim::app {

namespace {

report::SolidFacts solid_facts(const Outcome& outcome) {
    const simulation::Solid& of = *outcome.solid;
    const brep::Recognised& solid = of.recognised;
    report::SolidFacts facts;
    if (of.tool_tolerance_mm != outcome.plan.tool_tolerance ||
        of.arc_tolerance_mm != outcome.plan.tolerance)
        facts.own_cut = {of.tool_tolerance_mm, of.arc_tolerance_mm};
    facts.mitred_mm = solid.mitred_mm;
    facts.tolerance_factor = solid.tolerance_factor;
    for (const auto& form : brep::kForms)
        facts.kinds.emplace_back(form, 0);
    for (const brep::Face& face : solid.part.faces)
        ++facts.kinds[face.surface.form.index()].second;
    facts.faces = solid.part.faces.size();
    facts.volume_mm3 = outcome.solid_mass->volume;
    facts.polyhedron_mm3 = outcome.simulation->part_volume;
    facts.miss_mm = solid.part.miss_mm;
    facts.cuts = of.cuts;
    facts.cuts_not_tried = of.cuts_not_tried;
    facts.has_ended_early = of.has_ended_early;
    facts.facets_kept = solid.facets_kept;
    facts.stock_facets = solid.stock_facets;
    facts.facet_miss_mm = solid.part.facet_miss_mm;
    for (const cda::Origin origin : solid.of_facets) {
        const std::uint32_t line = of.provenance.of(origin).nc_line;
        if (line != 0) facts.facet_lines.push_back(line);
    }
    std::sort(facts.facet_lines.begin(), facts.facet_lines.end());
    facts.facet_lines.erase(std::unique(facts.facet_lines.begin(), facts.facet_lines.end()),
                            facts.facet_lines.end());
    return facts;
}

std::vector<report::SectionFacts> section_facts(const Outcome& outcome) {
    std::vector<report::SectionFacts> all;
    const auto drawn = drawn_sections(outcome);
    const std::vector<double> places = exporter::places_of(drawn);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const brep::Section& section = *drawn[i].section;
        report::SectionFacts facts;
        facts.plane = brep::name_of(section.plane);
        facts.outlines = section.outlines.size();
        facts.area_mm2 = section.area_mm2;
        facts.length_mm = section.length_mm;
        facts.moved_mm = places[i];
        facts.is_faceted = drawn[i].is_faceted;
        for (const brep::Outline& outline : section.outlines) {
            for (const brep::SectionPiece& piece : outline) {
                if (piece.is_facet) ++facts.facets;
                ++facts.curves[piece.curve.index()];
            }
        }
        all.push_back(facts);
    }
    return all;
}

}  // namespace

std::vector<exporter::DrawnSection> drawn_sections(const Outcome& outcome) {
    std::vector<exporter::DrawnSection> drawn;
    for (const simulation::SectionView& cut : outcome.sections) {
        drawn.push_back(
            {&cut.section,
             cut.is_faceted ? &outcome.simulation->provenance : &outcome.true_solid->provenance,
             cut.is_faceted});
    }
    return drawn;
}

report::RunFacts run_facts(const Outcome& outcome) {
    report::RunFacts facts;
    facts.name = outcome.plan.job.program.name;
    facts.program = &outcome.survey;
    facts.cutting = report::cutting_facts(outcome.plan);
    facts.cutting.unit = outcome.options.report_unit;
    facts.part = outcome.simulation;
    if (outcome.on_machine) facts.on_machine = &*outcome.on_machine;
    facts.boundary = outcome.boundary;
    if (outcome.simplified) {
        facts.simplified = {*outcome.options.simplify, outcome.simplified->deviation_mm,
                            outcome.simplified->boundary.faces.size()};
    }
    facts.sections = section_facts(outcome);
    if (outcome.design) {
        facts.design = outcome.design->facts;
        facts.design_places = report::largest(outcome.design->places, kMostDesignPlaces);
    }
    if (outcome.solid && outcome.options.step_surfaces == StepSurfaces::Analytic)
        facts.solid = solid_facts(outcome);
    return facts;
}

}  // namespace ncsim::app
