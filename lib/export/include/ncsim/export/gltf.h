// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as glTF 2.0, for viewers, web pages and scripts. Khronos Group, glTF 2.0
// Specification (ISO/IEC 12113:2022).
#pragma once

#include "ncsim/brep/shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/moving_scene.h"
#include "ncsim/export/provenance.h"
#include "ncsim/export/seams.h"

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace ncsim::exporter {

/// Writes `boundary` as binary glTF (.glb): one mesh with a primitive and a material for each tool.
/// Faces that `shading` knows to be round have the normals of their surface. Of the others stock is
/// shaded flat; facets cut by the same tool that meet at less than 25° are shaded as one round
/// surface, larger ones weighing more, but for flat ones beside round ones, which stay flat there.
///
/// Positions are millimetres from the centre of the part, so that little is lost in floats; the
/// node carries that centre and turns millimetres, z up, into glTF's metres, y up. Each vertex has
/// the attributes _NC_LINE (program line, 0 for uncut stock) and _TOOL: floats, since glTF has no
/// 32-bit integers there, exact up to 2^24. The extras of the asset hold the program's name, the
/// unit, and as `lines` the text of each line that cut a face that is left, by its number; a
/// material's extras hold its tool number. Corners of one tool with the same position, normal and
/// line are one vertex; indices have two bytes if they fit. Base colours are linear shares of sRGB.
///
/// For a reader who joins equal positions, of all primitives, the triangles are a closed oriented
/// 2-manifold, and none of them has a corner twice or no area; what that takes is what write_stl()
/// does.
///
/// A part of which nothing is left gives a valid file with an empty scene. Equal input
/// gives equal bytes. Throws std::invalid_argument if `boundary` is not closed, std::runtime_error
/// if the file would exceed the format's 4 GiB, or the stream fails. `threads` as in triangulate().
void write_gltf(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance,
                std::size_t threads = 1, const brep::Shading& shading = {});

/// The same of a piece of the surface, which is open where it meets others: one of several files.
/// Each corner is rounded by itself, about the `centre` (mm) that all files have in common, so
/// those that two files share are the same in both; what has no extent then is left out, and
/// triangles may have no area. Returns the edges that no other triangle of the file has in the
/// opposite direction: one of another file has.
std::vector<FloatEdge> write_gltf_piece(std::ostream& out, const cda::Boundary& piece,
                                        const Provenance& provenance, cda::Vec3 centre,
                                        const brep::Shading& shading = {});

/// Writes `scene` with the part in it, and how all of it moves: the node `machine` turns
/// millimetres, z up, into glTF's metres, y up, and stands for machine coordinates; below it each
/// node of the scene has one of its own under that which carries it, with the place of its frame as
/// translation, and meshes in mm. Its extras are those of the joint: `axis` (letter), `turns`,
/// `direction_x`, _y, _z, and `through_x` …, of the axis with all joints at 0. Bodies are shaded
/// flat, with the triangles as they are.
///
/// One animation, if anything moves: a translation or a rotation a joint, LINEAR, rotations no more
/// than 90° from key to key; and the scale of what is not always there, STEP, 0 while it is not.
/// Its extras hold `seconds` and `lines`: when which line of the program begins, and `error_mm`,
/// MovingScene::missed_mm. Times are floats: keys of which one float cannot tell the times apart
/// become one.
///
/// The part, and errors, as above; std::runtime_error, too, if a body is beyond what floats can
/// tell.
void write_gltf(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance,
                const MovingScene& scene, const brep::Shading& shading = {});

}  // namespace ncsim::exporter
