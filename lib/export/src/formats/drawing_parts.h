// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functions that the drawings of all formats share.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/export/drawing.h"

#include "render/palette.h"

#include <limits>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// Returns `number` as text with at most six decimals (nanometres) and without an exponent.
std::string drawn(double number);

/// Rectangle around a drawing, in mm.
struct DrawnBox {
    double left = std::numeric_limits<double>::infinity(), bottom = left;
    double right = -left, top = -left;
    bool is_empty() const { return left > right; }
    void add(Vec2 p);
    void add(const DrawnBox& box, double moved);
};

/// Returns a rectangle around `section`. Whole circles are enclosed exactly, whole ellipses by the
/// circle of the major radius, arcs by chords.
DrawnBox box_of(const brep::Section& section);
DrawnBox box_of(const std::vector<DrawnSection>& sections);

/// Returns points of `piece` after the start, in order, up to the end. The points are close enough
/// to keep the chords within brep::kChordsMm of the curve.
std::vector<Vec2> chords_of(const brep::SectionPiece& piece);

/// Returns the angle of `p` about `centre`, in degrees in [0, 360).
double angle_about(Vec2 centre, Vec2 p);

/// Returns the title of `section`, for example "Z-4 of part.nc, moved by 60, of facets". `moved` is
/// in mm.
std::string title_of(const DrawnSection& section, double moved, const std::string& program);

}  // namespace ncsim::exporter
