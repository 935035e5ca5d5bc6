// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as a STEP solid, for CAD. ISO 10303-21:2016 (the text form), ISO 10303-214 (automotive
// design), ISO 10303-42 (geometry and topology).
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/provenance.h"

#include <cstddef>
#include <iosfwd>

namespace ncsim::exporter {

/// Faces of the largest part that is written without being asked for more: beyond it most CAD
/// programs take minutes to open the file.
inline constexpr std::size_t kStepMaxFaces = 100'000;

/// Writes `boundary` as STEP AP214, in millimetres: a solid for each connected part, with its
/// voids. Faces are flat with any number of holes; neighbours in one plane are one face, whoever
/// cut them, and no edge has a vertex in its middle. Points, edges and directions are shared.
/// A face is named after the lines that cut it (LINE_10, LINE_10_20; STOCK) and has the colour of
/// its first one's tool.
///
/// Nothing is moved and no edge is left out, however short. Where planes nearly meet in a point,
/// exact edges of 1e-11 mm arise; readers take their two ends for one point (OpenCASCADE below 1e-7
/// mm) and may then find the shell open, as with samples/complex.nc.
///
/// A part of which nothing is left gives a valid file without a solid. Equal input gives equal
/// bytes: the time in the header is that of 1970. Throws std::runtime_error if there are more
/// than `max_faces` faces after merging, or the stream fails.
void write_step(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance,
                std::size_t max_faces = kStepMaxFaces);

}  // namespace ncsim::exporter
