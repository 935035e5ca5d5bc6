// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as VRML97, which old and new CAD programs read.
// Source: ISO/IEC 14772-1:1997.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/moving_scene.h"
#include "ncsim/mesh/provenance.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `boundary` as VRML97 text, in mm, z up: a Group for each program line named LINE_<n>
/// (STOCK for uncut stock), with a Shape in the colour of the tool. Convex faces are polygons;
/// other faces are split into triangles, because three.js draws polygons as fans. Points have all
/// digits, so the surface is closed if the boundary is.
///
/// Guarantees: an empty part gives a valid file. Equal input gives equal bytes.
/// Throws: std::runtime_error if the stream fails.
void write_vrml(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance);

/// Writes `scene` with the part and the motion, in machine coordinates, mm, z up. Each node is a
/// Transform below the parent, DEF'd as LINK_<n>_<name>, n from 0; characters of the name that are
/// neither letters nor digits become _. PART is the part. If a joint moves or a node is not always
/// visible, there is a TimeSensor CLOCK, which repeats, and for each joint a PositionInterpolator,
/// or an OrientationInterpolator with at most 90° between keys. Tools that are not in the spindle
/// are scaled to a millionth of their size.
void write_vrml(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, const MovingScene& scene);

}  // namespace ncsim::exporter
