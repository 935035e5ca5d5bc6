// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as VRML97, which CAD programs of every age read. ISO/IEC 14772-1:1997.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/moving_scene.h"
#include "ncsim/export/provenance.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `boundary` as VRML97 text, in millimetres, z up: a Group for each program line named
/// LINE_<n> (STOCK for uncut stock), within it a Shape coloured by its tool. Faces are
/// n-gons; those with holes, or whose outline touches itself, are cut into triangles.
/// All points are written with every
/// digit, so the surface stays as closed as the boundary is.
///
/// A part of which nothing is left gives a valid file. Equal input gives equal bytes. Throws
/// std::runtime_error if the stream fails.
void write_vrml(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance);

/// Writes `scene` with the part in it, and how all of it moves, in machine coordinates, mm, z up: a
/// Transform for each node below that which carries it, DEF'd as LINK_<n>_<name>, n from 0, with
/// what is no letter and no digit in the name as _; PART is the part. If anything moves: the
/// TimeSensor CLOCK, which begins anew at the end, and for each joint a PositionInterpolator, or an
/// OrientationInterpolator whose keys are no more than 90° apart. Tools that are not in the spindle
/// are a millionth of their size.
void write_vrml(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance,
                const MovingScene& scene);

}  // namespace ncsim::exporter
