// SPDX-License-Identifier: GPL-3.0-or-later
//
// What drawings in all formats have in common.
#pragma once

#include "ncsim/export/drawing.h"

#include "render/palette.h"

#include <limits>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// A number of a drawing: nanometres are enough, and no exponents.
std::string drawn(double number);

struct DrawnBox {
    double left = std::numeric_limits<double>::infinity(), bottom = left;
    double right = -left, top = -left;
    bool is_empty() const { return left > right; }
    void add(brep::FlatPoint p);
    void add(const DrawnBox& box, double moved);
};

/// Around it; of arcs what the circles take, of ellipses what their long axes do.
DrawnBox box_of(const brep::Section& section);
DrawnBox box_of(const std::vector<DrawnSection>& sections);

/// Points of the piece behind its start, in order, the last one its end: as many as keep the chords
/// within brep::kChordsMm.
std::vector<brep::FlatPoint> chords_of(const brep::SectionPiece& piece);

/// The angle of a point about another one, degrees in [0, 360).
double angle_about(brep::FlatPoint centre, brep::FlatPoint p);

/// "Z-4 of part.nc", and what is to be known of it.
std::string title_of(const DrawnSection& section, double moved, const std::string& program);

}  // namespace ncsim::exporter
