// SPDX-License-Identifier: GPL-3.0-or-later
#include "recognise/face_check_cache.h"

#include "ncsim/brep/frames.h"

#include "geometry/tolerances.h"
#include "heal/tangent_holes.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ncsim::brep {

namespace {

// Returns the number of the outer loop of a plane, the loop with the largest area.
std::size_t outline_of(const Part& part, const Face& face) {
    if (face.loops.size() < 2 || !std::holds_alternative<Plane>(face.surface.form)) return 0;
    std::size_t best = 0;
    double largest = -std::numeric_limits<double>::infinity();
    // Not a copy of `face`: with its loops, ten thousand holes would be copied ten thousand times.
    Face alone;
    alone.surface = face.surface;
    alone.frame = face.frame;
    for (std::size_t i = 0; i < face.loops.size(); ++i) {
        alone.loops = {face.loops[i]};
        const double area = measure(part, alone, face.frame.origin).area;
        if (area <= largest) continue;
        largest = area;
        best = i;
    }
    return best;
}

// True if two uses of the face begin in the same corner.
bool is_pinched(const Part& part, const Face& face) {
    Numbers corners = corners_of(part, face);
    std::sort(corners.begin(), corners.end());
    return std::ranges::adjacent_find(corners) != corners.end();
}

}  // namespace

FaceCheckCache::Entry& FaceCheckCache::lookup(const Part& part, Face& face, std::uint32_t name) {
    std::vector<std::vector<Entry::Piece>> loops;
    for (const Loop& loop : face.loops) {
        auto& pieces = loops.emplace_back();
        for (const EdgeUse& use : loop) {
            const Edge& edge = part.edges[use.edge];
            pieces.push_back(
                {part.vertices[edge.from], part.vertices[edge.to], edge.curve, use.is_forward});
        }
    }
    Entry& entry = entries_[name];
    if (entry.surface_ != face.surface || entry.loops_ != loops) {
        entry = {};
        entry.surface_ = face.surface;
        entry.loops_ = std::move(loops);
        face.frame = frame_for(part, face);
        entry.outline_ = outline_of(part, face);
        std::swap(face.loops.front(), face.loops[entry.outline_]);
        if (entry.outline_ != 0) face.frame = frame_for(part, face);
        entry.frame_ = face.frame;
        entry.measure = measure(part, face, apex_, Exactness::Rough);
        return entry;
    }
    std::swap(face.loops.front(), face.loops[entry.outline_]);
    face.frame = entry.frame_;
    return entry;
}

bool FaceCheckCache::is_faulty(Entry& entry, const Part& part, std::uint32_t face,
                               double tolerance_mm, double clear_mm, double& miss_mm) {
    if (entry.tolerance_mm != tolerance_mm) {
        entry.tolerance_mm = tolerance_mm;
        entry.miss_mm = 0.0;
        const auto faults_within = [&](double clear) {
            return faults_of(part, face, tolerance_mm, entry.miss_mm, clear, entry.measure.area);
        };
        auto faults = faults_within(kReaderClearance);
        // Next to facets, OpenCASCADE makes edges as wide as they are off, so touching loops cross.
        if (const double clear = std::min(clear_mm, entry.miss_mm);
            faults.empty() && clear > kReaderClearance)
            faults = faults_within(clear);
        const bool may_be_touch = std::ranges::all_of(
            faults, [](const Fault& fault) { return fault.what == kCrossOrTouch; });
        // Beside facets readers make edges as wide as they are off, and touching is folding.
        const bool touches = may_be_touch && tolerance_mm <= kTangencyGapMm &&
                             only_touches_itself(part, part.faces[face], clear_mm);
        const bool folds = tolerance_mm > kTangencyGapMm && !part.faces[face].is_facet &&
                           is_pinched(part, part.faces[face]);
        const bool is_cone_on_a_point = touches_base_circle(part, part.faces[face]) &&
                                        !can_split_on_generator(part, part.faces[face]);
        entry.is_faulty = (!faults.empty() && !touches) || folds || is_cone_on_a_point;
        entry.fault_at.clear();
        const bool is_local =
            std::ranges::none_of(faults, [](const Fault& fault) { return fault.edges.empty(); });
        const auto& loops = part.faces[face].loops;
        for (std::size_t l = 0; l < loops.size() && is_local; ++l) {
            for (std::size_t i = 0; i < loops[l].size(); ++i) {
                const bool is_there = std::ranges::any_of(faults, [&](const Fault& fault) {
                    return std::ranges::find(fault.edges, loops[l][i].edge) != fault.edges.end();
                });
                if (is_there) entry.fault_at.emplace_back(l, i);
            }
        }
    }
    miss_mm = std::max(miss_mm, entry.miss_mm);
    return entry.is_faulty;
}

}  // namespace ncsim::brep
