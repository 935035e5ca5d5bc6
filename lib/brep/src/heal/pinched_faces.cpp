// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each return of a loop to a corner cuts off a piece of the loop. The pieces depend on the corner
// at which the traversal starts; the first start for which all pieces are sound faces is taken.
#include "heal/pinched_faces.h"

#include "ncsim/brep/frames.h"

#include "geometry/tolerances.h"
#include "heal/non_simple_faces.h"
#include "query/part_check.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// Returns the positions in the loop at which uses begin in a corner that the loop visits more than
// once, ascending.
std::vector<std::size_t> returns_of(const Part& part, const Loop& loop) {
    std::map<std::uint32_t, std::vector<std::size_t>> places;
    for (std::size_t i = 0; i < loop.size(); ++i)
        places[begin_of(part, loop[i])].push_back(i);
    std::vector<std::size_t> returns;
    for (const auto& [corner, at] : places) {
        if (at.size() > 1) returns.insert(returns.end(), at.begin(), at.end());
    }
    std::ranges::sort(returns);
    return returns;
}

// Follows the loop from `start`. Returns the pieces that are cut off at returns to a corner; the
// last piece is the rest.
std::vector<Loop> simple_loops(const Part& part, const Loop& loop, std::size_t start) {
    std::vector<Loop> simple;
    Loop open;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const EdgeUse& use = loop[(start + i) % loop.size()];
        const std::uint32_t corner = begin_of(part, use);
        const auto before = std::ranges::find_if(
            open, [&](const EdgeUse& other) { return begin_of(part, other) == corner; });
        if (before != open.end()) {
            simple.emplace_back(before, open.end());
            open.erase(before, open.end());
        }
        open.push_back(use);
    }
    simple.push_back(std::move(open));
    return simple;
}

// Returns a face for each loop; empty if a face is not sound.
std::vector<Face> pieces_of(Part& part, std::uint32_t f, const std::vector<Loop>& loops) {
    const Face face = part.faces[f];
    std::vector<Face> pieces;
    for (const Loop& loop : loops) {
        part.faces[f].loops = {loop};
        part.faces[f].frame = frame_for(part, part.faces[f]);
        double miss = 0.0;
        if (!faults_of(part, f, kTangencyGapMm, miss).empty()) break;
        pieces.push_back(part.faces[f]);
    }
    part.faces[f] = face;
    if (pieces.size() < loops.size()) pieces.clear();
    return pieces;
}

}  // namespace

void split_pinched_faces(Part& part) {
    for (std::uint32_t f = 0, count = static_cast<std::uint32_t>(part.faces.size()); f < count;
         ++f) {
        const Face face = part.faces[f];
        if (is_plane(face) || face.loops.size() != 1) continue;
        const std::vector<std::size_t> returns = returns_of(part, face.loops.front());
        if (returns.empty()) continue;
        for (const std::size_t start : returns) {
            std::vector<Face> pieces =
                pieces_of(part, f, simple_loops(part, face.loops.front(), start));
            if (pieces.empty()) continue;
            part.faces[f] = std::move(pieces.front());
            for (std::size_t i = 1; i < pieces.size(); ++i)
                append_face(part, f, std::move(pieces[i]));
            break;
        }
    }
}

}  // namespace ncsim::brep
