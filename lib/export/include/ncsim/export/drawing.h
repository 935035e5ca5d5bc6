// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections of a part as drawings: DXF for CAD and machines that cut sheets, SVG for people. Lengths
// are true, in mm.
#pragma once

#include "ncsim/brep/section.h"
#include "ncsim/export/provenance.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace ncsim::exporter {

struct DrawnSection {
    const brep::Section* section = nullptr;
    const Provenance* provenance = nullptr;
    /// Its outlines are those of the polyhedron: no arc is told.
    bool is_faceted = false;
};

/// How far each of them is moved to the right: the first lies where it is, the others beside it.
std::vector<double> places_of(const std::vector<DrawnSection>& sections);

/// DXF of AutoCAD R12 (AC1009), which everybody reads: LINE, ARC, CIRCLE; ellipses and other curves
/// as POLYLINE within brep::kChordsMm of them. Layers are STOCK, T1 …; of facets of round tools
/// that were not recognised T1-FACETS; of several sections with a number before: 1-T1. Layer NOTES
/// names the sections. Throws std::runtime_error if the stream fails.
void write_dxf(std::ostream& out, const std::vector<DrawnSection>& sections,
               const std::string& program);

/// SVG 1.1 in mm, material grey, each tool's pieces in its colour, those of facets dashed. Throws
/// std::runtime_error if the stream fails.
void write_svg(std::ostream& out, const std::vector<DrawnSection>& sections,
               const std::string& program);

}  // namespace ncsim::exporter
