// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as glTF 2.0, for viewers, web pages and scripts.
// Source: Khronos Group, glTF 2.0 Specification (ISO/IEC 12113:2022).
#pragma once

#include "ncsim/brep/part_shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/moving_scene.h"
#include "ncsim/mesh/provenance.h"
#include "ncsim/mesh/seams.h"

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace ncsim::exporter {

/// Writes `boundary` as binary glTF (.glb): one mesh with a primitive and a material for each tool.
/// Faces that `shading` knows to be round have the normals of their surface. Uncut stock is shaded
/// flat. Other facets by the same tool that meet at less than 25° are shaded as one round surface,
/// with weights by area; facets known to be flat ignore adjacent round facets.
///
/// Positions are in mm relative to the centre of the part, which keeps the rounding errors of
/// floats small. The node carries the centre and converts millimetres, z up, to the metres, y up,
/// of glTF. Each vertex has the attributes _NC_LINE (program line, 0 for uncut stock) and _TOOL.
/// Both are floats because glTF has no 32-bit integers for attributes; floats are exact up to 2^24.
/// The extras of the asset hold the name of the program, the unit, and in `lines` the text of each
/// line that cut a remaining face, by line number. The extras of a material hold the tool number.
/// Corners of one tool with equal position, normal and line are one vertex; indices have two bytes
/// if possible. Base colours are linear values from 0 to 1, converted from sRGB.
///
/// Guarantees: if equal positions in all primitives are joined, the triangles are a closed oriented
///     2-manifold, and no triangle has a repeated corner or zero area; the corners are moved as
///     write_stl() does. An empty part gives a valid file with an empty scene. Equal input gives
///     equal bytes, for any number of `threads` (as in cda::triangulate()).
/// Throws: std::invalid_argument if `boundary` is not closed; std::runtime_error if the file would
///     exceed the 4 GiB of the format, or if the stream fails.
void write_gltf(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, std::size_t threads = 1,
                const brep::Shading& shading = {});

/// Writes a piece of a surface that is split into several files. The piece is open where it meets
/// other pieces. Each corner is rounded by itself, relative to `centre` (mm), which is the same for
/// all files; therefore corners shared by two files are equal in both. Triangles whose corners
/// coincide after rounding are omitted; a triangle may have zero area.
/// Returns: the edges that no other triangle of the file uses in the opposite direction. Another
///     file has their partners.
std::vector<mesh::FloatEdge> write_gltf_piece(std::ostream& out, const cda::Boundary& piece,
                                              const mesh::Provenance& provenance, Vec3 centre,
                                              const brep::Shading& shading = {});

/// Writes `scene` with the part and the motion. The node `machine` stands for machine coordinates
/// and converts millimetres, z up, to the metres, y up, of glTF. Each node of the scene becomes a
/// node below the parent, with the origin of the node's frame as translation and with meshes in mm.
/// The extras of a node describe the joint: `axis` (letter), `turns`, `direction_x`, _y, _z, and
/// for a rotary joint `through_x`, _y, _z, a point of the axis; all with all joints at 0. Bodies
/// are shaded flat, with unchanged triangles.
///
/// If a joint moves or a node is not always visible, there is an animation. Each moving joint has a
/// translation or a rotation with LINEAR interpolation; rotations have at most 90° between keys. A
/// node that is not always visible has a scale with STEP interpolation, which is 0 while the node
/// is hidden. The extras of the animation hold `seconds` and `lines` (the time at which each line
/// of the program begins) and `error_mm` (MovingScene::missed_mm). Times are floats: keys whose
/// times are equal as floats become a single key.
///
/// Guarantees: as the first overload, for the part.
/// Throws: as the first overload; std::runtime_error also if a body is too large for floats.
void write_gltf(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, const MovingScene& scene,
                const brep::Shading& shading = {});

}  // namespace ncsim::exporter
