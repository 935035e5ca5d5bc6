// SPDX-License-Identifier: GPL-3.0-or-later
//
// Between the chains of a shell and its part: the loops around each group, without what has no
// width in them.
#pragma once

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/brep/part.h"

#include "recognise/chains.h"
#include "recognise/face_groups.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::brep {

/// Two corners of a group.
using Corners = std::pair<std::uint32_t, std::uint32_t>;

class FaceLoops {
public:
    /// Of chains that are solved: where one has vanished, both its ends are one corner. Where a
    /// strip of a face has no width, its loop goes along a line and back: two walls that touch the
    /// same third one in one line. What is beside the line on both sides meets in it. One of both
    /// ways may be longer, and goes on beside the face. Both must outlive it.
    FaceLoops(const Groups& groups, const Chains& chains);

    /// Corners of a group in one place, within `near_mm`, without an edge from the one to the
    /// other: what is narrow between facets is only a point between curves that touch there. A
    /// whole circle that begins anywhere begins in such a corner. The loops are those of the group
    /// as they were when they were taken.
    std::vector<Corners> touching_corners(std::uint32_t group, const std::vector<Loop>& loops,
                                          double near_mm);
    void unite(const Corners& corners) { same_.unite(corners.first, corners.second); }
    /// Loops of what is not flat that have a corner in common are one, which comes there twice.
    void join_touching_loops();

    /// Of a group.
    std::vector<Loop>& operator[](std::uint32_t group) { return loops_[group]; }
    /// Of a chain: the corners from and to which the part has it.
    Corners ends_of(std::uint32_t chain) {
        return {same_.find(joints_[chain].from), same_.find(joints_[chain].to)};
    }

private:
    /// A chain as the part has it: what closes slits changes it.
    struct Joint {
        std::uint32_t left, right;  ///< Groups.
        std::uint32_t from, to;     ///< Vertices.
    };
    std::uint32_t& begin_of(const EdgeUse& use) {
        return use.is_forward ? joints_[use.edge].from : joints_[use.edge].to;
    }
    std::uint32_t& end_of(const EdgeUse& use) {
        return use.is_forward ? joints_[use.edge].to : joints_[use.edge].from;
    }
    Vec3 at(std::uint32_t vertex) const { return chains_.vertices()[vertex].at; }
    bool is_flat(std::uint32_t group) const;
    bool is_edge_between(const Corners& corners);
    bool close_slit(std::uint32_t group, std::size_t loop);
    void join(std::vector<Loop>& loops);

    const Groups& groups_;
    const Chains& chains_;
    std::vector<std::vector<Loop>> loops_;  // of each group
    std::vector<Joint> joints_;             // of each chain
    DisjointSets same_;                     // vertices
};

}  // namespace ncsim::brep
