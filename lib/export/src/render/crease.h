// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angle below which two faces count as pieces of the same round surface.
#pragma once

namespace ncsim::exporter {

/// Cosine of 25°. Faces that meet at less than 25° are facets of the same curved surface: pictures
/// have no line between the facets, and glTF shades the facets smoothly. A ball of 66 planes has at
/// most 15° from facet to facet; the point of a drill has 31° and stays sharp.
inline constexpr double kCreaseCosine = 0.9063;

}  // namespace ncsim::exporter
