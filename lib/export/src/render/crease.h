// SPDX-License-Identifier: GPL-3.0-or-later
//
// When two faces count as pieces of one round surface.
#pragma once

namespace ncsim::exporter {

/// Faces that meet at less than 25° (this is the cosine) are facets of one round surface: pictures
/// have no line between them, glTF shades them as one. A ball of 66 planes has 15° and less from
/// facet to facet; the point of a drill has 31° and stays sharp.
inline constexpr double kCreaseCosine = 0.9063;

}  // namespace ncsim::exporter
