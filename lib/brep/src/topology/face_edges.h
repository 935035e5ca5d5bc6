// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges and corners of faces, and adjacent faces.
#pragma once

#include "ncsim/brep/part.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

/// Numbers of vertices, edges or faces of a part.
using Numbers = std::vector<std::uint32_t>;

/// Sorts elements and erases duplicates.
template <typename T>
void sort_unique(std::vector<T>& elements) {
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

inline std::uint32_t begin_of(const Part& part, const EdgeUse& use) {
    const Edge& edge = part.edges[use.edge];
    return use.is_forward ? edge.from : edge.to;
}

inline EdgeUse reversed_use(const EdgeUse& use) {
    return {use.edge, !use.is_forward};
}

inline std::uint32_t end_of(const Part& part, const EdgeUse& use) {
    return begin_of(part, reversed_use(use));
}

inline Track track_of(const Part& part, const Edge& edge) {
    return {edge.curve, part.vertices[edge.from], part.vertices[edge.to]};
}

inline double length_of_chord(const Part& part, const Edge& edge) {
    return norm(part.vertices[edge.to] - part.vertices[edge.from]);
}

inline bool is_plane(const Face& face) {
    return std::holds_alternative<Plane>(face.surface.form);
}

inline bool is_straight(const Edge& edge) {
    return std::holds_alternative<Line>(edge.curve);
}

/// Returns the uses of edges by all loops of a face, in order.
std::vector<EdgeUse> uses_of(const std::vector<Loop>& loops);
inline std::vector<EdgeUse> uses_of(const Face& face) {
    return uses_of(face.loops);
}

/// Returns the vertices at which the uses of all loops begin, in order.
Numbers corners_of(const Part& part, const Face& face);

/// True if all edges of the face are lines.
bool is_straight(const Part& part, const Face& face);

/// Returns the face on the left and the face on the right of each edge, or kNone.
std::vector<std::array<std::uint32_t, 2>> sides_of_edges(const Part& part);

/// Returns the faces that meet in each vertex, ascending.
std::vector<Numbers> faces_at_vertices(const Part& part);

/// True for each vertex at which only planes and lines meet.
std::vector<bool> flat_vertices(const Part& part);

/// Widths that readers give to straight edges and their ends, mm: an edge is as wide as it is off
/// the adjacent faces, a corner as wide as its widest edge.
struct ReaderWidths {
    std::vector<double> edges, corners;
};
ReaderWidths reader_widths(const Part& part);

/// Returns the length of each edge up to which readers lose the edge between its ends, mm: the
/// widths of both ends, and twice the width of the edge.
std::vector<double> reader_lengths(const Part& part);

/// Place of a use: loop of the face, use of the loop.
using UsePlace = std::pair<std::size_t, std::size_t>;

/// Erases two uses in opposite directions between the same corners. Uses of two loops: the loops
/// are joined, and the second is left empty. Uses of the same loop: the loop is divided, and the
/// new loop is appended; both may be empty.
void erase_uses(std::vector<Loop>& loops, UsePlace a, UsePlace b);

/// Calls `visit` for each shell of a solid; the outer shell comes first.
template <typename AnySolid, typename Visit>
void for_shells(AnySolid& solid, const Visit& visit) {
    visit(solid.outside);
    std::ranges::for_each(solid.voids, visit);
}

/// Appends a face to the part, and to the shell of face `f`. Returns: the number of the new face.
std::uint32_t append_face(Part& part, std::uint32_t f, Face face);

}  // namespace ncsim::brep
