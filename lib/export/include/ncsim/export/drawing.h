// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections of a part as drawings at true scale, in mm: DXF for CAD and for machines that cut
// sheets, SVG for viewing.
#pragma once

#include "ncsim/brep/section.h"
#include "ncsim/mesh/provenance.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// A section to draw and the provenance of the part.
struct DrawnSection {
    const brep::Section* section = nullptr;
    const mesh::Provenance* provenance = nullptr;
    /// True if the outlines are those of the polyhedron, without arcs.
    bool is_faceted = false;
};

/// Returns by how many mm each section moves to the right on the drawing. The first section stays
/// in place; each further section is placed to the right of the section before.
std::vector<double> places_of(const std::vector<DrawnSection>& sections);

/// Writes `sections` as DXF of AutoCAD R12 (AC1009), the version that most programs read: LINE,
/// ARC, CIRCLE; ellipses and other curves become LINEs within brep::kChordsMm. The layers are
/// STOCK, T1, …; facets of round tools that were not recognised are on T1-FACETS, …. If there are
/// several sections, the layers carry the number of the section: 1-T1. Layer NOTES has a title for
/// each section.
/// Throws: std::runtime_error if the stream fails.
void write_dxf(std::ostream& out, const std::vector<DrawnSection>& sections,
               const std::string& program);

/// Writes `sections` as SVG 1.1 in mm: the material is grey, the pieces of each tool have the
/// colour of the tool, and pieces of facets are dashed.
/// Throws: std::runtime_error if the stream fails.
void write_svg(std::ostream& out, const std::vector<DrawnSection>& sections,
               const std::string& program);

}  // namespace ncsim::exporter
