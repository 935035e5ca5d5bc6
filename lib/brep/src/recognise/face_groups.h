// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps 2 and 4 of recognition: adjacent facets with equal labels form a group, which becomes a
// face. Groups without width on the true surfaces join a neighbour. Where the surfaces of groups do
// not fit together, labels are removed, from the smallest group first.
#pragma once

#include "recognise/facet_mesh.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::brep {

/// Groups around a place where surfaces do not fit together.
struct Failure {
    std::vector<std::uint32_t> groups;
    /// True if a corner has no solution. Failures of edges and faces may be consequences of
    /// failures next to them.
    bool is_of_corner = false;
    bool is_thin = false;        ///< True if the first group has no width on the true surfaces.
    std::uint32_t edge = kNone;  ///< Half-edge that starts at the corner, if `is_of_corner`.
};
using Failures = std::vector<Failure>;

enum class Strictness { Low, High, Full };

struct Group {
    std::uint32_t surface = 0;
    std::span<const std::uint32_t> facets;  ///< Numbers, ascending.
    double area = 0.0;
    bool is_analytic = false;  ///< True if a surface was recognised.
};

class Groups {
public:
    explicit Groups(FacetMesh& mesh) : mesh_(mesh) {}

    /// Makes the groups from the current labels.
    void gather();
    /// Merges groups that belong to a single face:
    /// - neighbours whose surfaces are equal within the rounding of programs,
    /// - lunes that balls leave where the path bends by an imperceptible angle, with a neighbour,
    /// - ledges on a wall, with the wall,
    /// - fins between two walls, with the face below,
    /// - narrow facets without a surface, with a neighbour within the error.
    /// Returns true if labels have changed.
    bool unify();
    /// Inserts strips of tori between a flat end and the envelope of the corner radius on nearly
    /// level moves. The true strip is narrower than facets, so the polyhedron lacks it. Returns
    /// true if facets were added.
    bool insert_strips();
    /// Removes the labels of tori, coils, domes, envelopes and flat ramps that have adjacent
    /// facets: straight edges of facets may cross the circles at which OpenCASCADE divides such
    /// faces, and a small deviation from such a surface is a large one along a wall. Returns true
    /// if labels have changed.
    bool demote_neighbours_of_tori();
    /// For each failure, merges the smallest group at the failure into a neighbour or demotes it to
    /// facets. With high strictness the change is permanent; with full strictness the adjacent
    /// groups change, too. Returns true if labels have changed.
    bool relabel(const Failures& failures, Strictness strictness);

    /// Returns the largest height in mm by which a removed lune is lower than the surface in its
    /// place.
    double mitred_mm() const { return mitred_mm_; }

    std::uint32_t size() const { return static_cast<std::uint32_t>(groups_.size()); }
    const Group& operator[](std::uint32_t g) const { return groups_[g]; }
    /// Returns the adjacent groups, ascending, with the lengths of the common boundaries in mm.
    std::span<const std::pair<std::uint32_t, double>> neighbours(std::uint32_t g) const {
        return std::span(neighbours_).subspan(first_[g], first_[g + 1] - first_[g]);
    }
    double perimeter(std::uint32_t g) const;  ///< Returns the length of the boundary, mm.
    const Surface& surface_of(std::uint32_t g) const { return mesh_.surface(groups_[g].surface); }
    const Form& form_of(std::uint32_t g) const { return surface_of(g).form; }
    double error_of(std::uint32_t g) const { return mesh_[groups_[g].facets.front()].error_mm; }
    /// True if the group is an unrecognised facet of a round tool; its edges stay straight.
    bool is_facet(std::uint32_t g) const {
        return !groups_[g].is_analytic && !mesh_[groups_[g].facets.front()].may_be_true;
    }

    /// Returns the group on the left of a half-edge.
    std::uint32_t group_at(std::uint32_t h) const { return group_of_[mesh_.edges()[h].facet]; }
    std::uint32_t opposite_group(std::uint32_t h) const { return group_at(mesh_.edges()[h].twin); }
    bool is_boundary(std::uint32_t h) const { return group_at(h) != opposite_group(h); }
    /// Returns the next or the previous half-edge of the boundary of the group on the left.
    std::uint32_t next_boundary(std::uint32_t h) const { return mesh_.next_boundary(h); }
    std::uint32_t boundary_before(std::uint32_t h) const { return mesh_.boundary_before(h); }

private:
    void find_neighbours();
    struct Pipe {
        std::uint32_t group;
        double shared;
        Form across;  ///< Surface that crosses the pipe where the tool stood.
    };
    std::vector<Pipe> adjacent_pipes(std::uint32_t g) const;
    bool absorb_lunes();
    bool absorb_ledges();
    bool absorb_fins();
    bool absorb_fin(std::uint32_t g, std::uint32_t n);
    bool runs_around_torus(std::uint32_t h, const Torus& torus) const;
    std::uint32_t opposite_group_past_strips(std::uint32_t h) const;
    std::vector<std::uint32_t> chain_from(std::uint32_t h) const;
    void relabel(std::uint32_t g, std::uint32_t surface);
    void demote_to_facets(std::uint32_t g, bool for_good);
    bool absorb(std::uint32_t g, double errors, double most_turn);
    std::optional<std::uint32_t> merge_into_wall(std::uint32_t g);
    bool lies_on(std::uint32_t g, std::uint32_t n, double errors, double most_turn) const;
    bool may_be_absorbed(std::uint32_t g) const;
    bool release_label(std::uint32_t edge);
    bool is_flat_ramp(std::uint32_t g) const;
    std::vector<std::uint32_t> adjacent_analytic_groups(std::vector<std::uint32_t> groups) const;

    FacetMesh& mesh_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> facets_;    // numbers of facets, by group
    std::vector<std::uint32_t> group_of_;  // group of each facet
    std::vector<std::uint32_t> first_;     // first neighbour of each group, in neighbours_
    std::vector<std::pair<std::uint32_t, double>> neighbours_;
    // First facets of merged walls, with the surface that each wall got.
    std::set<std::pair<std::uint32_t, std::uint32_t>> walls_;
    double mitred_mm_ = 0.0;
};

/// Radius of tools that round off small features, mm.
inline constexpr double kLargeRadius = 5.0;

}  // namespace ncsim::brep
