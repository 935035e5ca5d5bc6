// SPDX-License-Identifier: GPL-3.0-or-later
//
// The second step and the fourth: neighbours with the same surface are a face. What has no width on
// the true surfaces joins a neighbour; where nothing fits, labels come off the smallest group.
#pragma once

#include "recognise/facet_mesh.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::brep {

/// What went wrong, and the groups around it.
struct Failure {
    std::vector<std::uint32_t> groups;
    /// Of a corner. Of edges and faces it may be because something else went wrong beside them.
    bool is_of_corner = false;
    bool is_thin = false;        ///< The first of them has no width on its true surfaces.
    std::uint32_t edge = kNone;  ///< Of a corner: a half-edge that starts there.
};
using Failures = std::vector<Failure>;

enum class Strictness { Low, High, Full };

struct Group {
    std::uint32_t surface = 0;
    std::span<const std::uint32_t> facets;  ///< Ascending.
    double area = 0.0;
    bool is_analytic = false;  ///< Its surface was recognised.
};

class Groups {
public:
    explicit Groups(FacetMesh& mesh) : mesh_(mesh) {}

    /// From the labels, anew.
    void gather();
    /// Neighbours whose surfaces differ by what programs round are one; so are what a ball leaves
    /// where its way bends so little that nobody can tell, and a neighbour; ledges on a wall, and
    /// the wall; fins between two walls, and what they stand on; and a facet that stands for
    /// nothing and a neighbour within its error. True: labels have changed.
    bool unify();
    /// Where a corner radius leaves the place in which it stood, nearly level, a ring is left
    /// between its flat end and its envelope, narrower than facets, which do not have it: it is a
    /// strip between both. True: there are more facets.
    bool insert_strips();
    /// Straight edges beside a ring may cross the circles where readers cut it open, and then they
    /// lose the face; and what is off a coil or a dome by little is somewhere else on it beside a
    /// wall, or off a ramp that is less steep than facets are large. Rings, coils, domes and such
    /// ramps have no facets beside them. True: labels have changed.
    bool demote_neighbours_of_tori();
    /// For each failure, merges the smallest group at the failure into a neighbour or demotes it to
    /// facets. With high strictness the change is permanent; with full strictness the adjacent
    /// groups change, too. Returns true if labels have changed.
    bool relabel(const Failures& failures, Strictness strictness);

    /// By how much the lunes at bends that joined a neighbour are lower than what is in their
    /// place, at most, mm.
    double mitred_mm() const { return mitred_mm_; }

    std::uint32_t size() const { return static_cast<std::uint32_t>(groups_.size()); }
    const Group& operator[](std::uint32_t g) const { return groups_[g]; }
    /// Each of its neighbours, ascending, and how long they meet, mm.
    std::span<const std::pair<std::uint32_t, double>> neighbours(std::uint32_t g) const {
        return std::span(neighbours_).subspan(first_[g], first_[g + 1] - first_[g]);
    }
    double perimeter(std::uint32_t g) const;  ///< mm
    const Surface& surface_of(std::uint32_t g) const { return mesh_.surface(groups_[g].surface); }
    const Form& form_of(std::uint32_t g) const { return surface_of(g).form; }
    double error_of(std::uint32_t g) const { return mesh_[groups_[g].facets.front()].error_mm; }
    /// A facet of a round tool that stands for nothing: its edges stay straight.
    bool is_facet(std::uint32_t g) const {
        return !groups_[g].is_analytic && !mesh_[groups_[g].facets.front()].may_be_true;
    }

    /// Of a half-edge.
    std::uint32_t group_at(std::uint32_t h) const { return group_of_[mesh_.edges()[h].facet]; }
    std::uint32_t opposite_group(std::uint32_t h) const { return group_at(mesh_.edges()[h].twin); }
    bool is_boundary(std::uint32_t h) const { return group_at(h) != opposite_group(h); }
    /// The next one around its group, and the one before.
    std::uint32_t next_boundary(std::uint32_t h) const { return mesh_.next_boundary(h); }
    std::uint32_t boundary_before(std::uint32_t h) const { return mesh_.boundary_before(h); }

private:
    void find_neighbours();
    struct Pipe {
        std::uint32_t group;
        double shared;
        Form across;  ///< What crosses it where the tool stood.
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
    std::vector<std::uint32_t> facets_;    // by group
    std::vector<std::uint32_t> group_of_;  // of each facet
    std::vector<std::uint32_t> first_;     // of each group, in neighbours_
    std::vector<std::pair<std::uint32_t, double>> neighbours_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> walls_;  // facets of one, and what it became
    double mitred_mm_ = 0.0;
};

/// Of the tools that round off what is small, mm.
inline constexpr double kLargeRadius = 5.0;

}  // namespace ncsim::brep
