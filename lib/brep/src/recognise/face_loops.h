// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops around each group, after parts without width are closed: the step from solved chains to
// faces.
#pragma once

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/brep/part.h"

#include "recognise/chains.h"
#include "recognise/face_groups.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::brep {

/// Two vertices of a group.
using Corners = std::pair<std::uint32_t, std::uint32_t>;

class FaceLoops {
public:
    /// Takes the loops of solved chains, unites the ends of vanished chains and closes slits. In a
    /// slit the loop runs along a line and back, as with two walls that touch a third wall in a
    /// line. The faces on both sides of the slit then meet in the line. If the edges have different
    /// lengths, the rest of the longer edge stays in the loop. Both arguments must outlive the
    /// loops.
    FaceLoops(const Groups& groups, const Chains& chains);

    /// Returns pairs of vertices of a group within `near_mm` of each other without an edge between
    /// them: narrow parts between facets may be single points on the true surfaces. The start of a
    /// whole circle is paired with a vertex anywhere on the circle. `loops` are the loops of the
    /// group at the time of the call.
    std::vector<Corners> touching_corners(std::uint32_t group, const std::vector<Loop>& loops,
                                          double near_mm);
    void unite(const Corners& corners) { same_.unite(corners.first, corners.second); }
    /// Joins loops with a common vertex on surfaces that are not planes into one loop that passes
    /// the vertex twice.
    void join_touching_loops();

    /// Returns the loops of a group.
    std::vector<Loop>& operator[](std::uint32_t group) { return loops_[group]; }
    /// Returns the vertices at which a chain begins and ends in the part.
    Corners ends_of(std::uint32_t chain) {
        return {same_.find(joints_[chain].from), same_.find(joints_[chain].to)};
    }

private:
    /// Chain as used in the part, after slits were closed.
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
