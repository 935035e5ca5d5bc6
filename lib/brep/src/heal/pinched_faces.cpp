// SPDX-License-Identifier: GPL-3.0-or-later
//
// A loop is cut off where it returns to a corner. From which corner the loop is followed decides
// which pieces are cut off; correct are those that all surround area.
#include "heal/pinched_faces.h"

#include "ncsim/brep/frames.h"
#include "ncsim/brep/measure.h"

#include "heal/non_simple_faces.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

namespace {

std::uint32_t corner_of(const Part& part, const EdgeUse& use) {
    const Edge& edge = part.edges[use.edge];
    return use.is_forward ? edge.from : edge.to;
}

// Returns the places in the loop at which it is in a corner to which it returns.
std::vector<std::size_t> returns_of(const Part& part, const Loop& loop) {
    std::map<std::uint32_t, std::vector<std::size_t>> places;
    for (std::size_t i = 0; i < loop.size(); ++i)
        places[corner_of(part, loop[i])].push_back(i);
    std::vector<std::size_t> returns;
    for (const auto& [corner, at] : places) {
        if (at.size() > 1) returns.insert(returns.end(), at.begin(), at.end());
    }
    std::ranges::sort(returns);
    return returns;
}

// Follows the loop from `start` and returns what is cut off where it returns to a corner, and the
// rest.
std::vector<Loop> simple_loops(const Part& part, const Loop& loop, std::size_t start) {
    std::vector<Loop> simple;
    Loop open;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const EdgeUse& use = loop[(start + i) % loop.size()];
        const std::uint32_t corner = corner_of(part, use);
        const auto before = std::ranges::find_if(
            open, [&](const EdgeUse& other) { return corner_of(part, other) == corner; });
        if (before != open.end()) {
            simple.emplace_back(before, open.end());
            open.erase(before, open.end());
        }
        open.push_back(use);
    }
    simple.push_back(std::move(open));
    return simple;
}

bool surround_area(const Part& part, const Face& face, const std::vector<Loop>& loops) {
    return std::ranges::all_of(loops, [&](const Loop& loop) {
        Face alone = face;
        alone.loops = {loop};
        alone.frame = frame_for(part, alone);
        return measure(part, alone, alone.frame.origin, Exactness::Rough).area > 0.0;
    });
}

}  // namespace

void split_pinched_faces(Part& part) {
    for (std::uint32_t f = 0, count = static_cast<std::uint32_t>(part.faces.size()); f < count;
         ++f) {
        const Face face = part.faces[f];
        if (std::holds_alternative<Plane>(face.surface.form) || face.loops.size() != 1) continue;
        const std::vector<std::size_t> returns = returns_of(part, face.loops.front());
        if (returns.empty()) continue;
        for (const std::size_t start : returns) {
            const std::vector<Loop> loops = simple_loops(part, face.loops.front(), start);
            if (!surround_area(part, face, loops)) continue;
            for (std::size_t i = 0; i < loops.size(); ++i) {
                Face piece = face;
                piece.loops = {loops[i]};
                piece.frame = frame_for(part, piece);
                if (i == 0) {
                    part.faces[f] = std::move(piece);
                } else {
                    append_face(part, f, std::move(piece));
                }
            }
            break;
        }
    }
}

}  // namespace ncsim::brep
