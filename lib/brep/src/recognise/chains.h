// SPDX-License-Identifier: GPL-3.0-or-later
//
// The third step: where the boundaries of groups meet is a vertex, what runs between two vertices a
// chain of edges. Vertices are solved on all surfaces around them, then the curves between them.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/part.h"

#include "recognise/face_groups.h"

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ncsim::brep {

struct Chain {
    std::vector<std::uint32_t> edges;  ///< Half-edges, with the group on the left.
    std::uint32_t left = 0, right = 0;
    bool is_closed = false;                  ///< Without a vertex.
    std::uint32_t from = kNone, to = kNone;  ///< Vertices.
    bool has_vanished = false;
    bool has_failed = false;          ///< Itself, or one of its ends.
    bool is_flipped = false;          ///< No longer between the groups beside its half-edges.
    Vec3 direction{};                 ///< Which way it went when it was flipped, if that is known.
    bool is_direction_fixed = false;  ///< Contacts of the adjacent faces determine its direction.
    bool is_inserted = false;  ///< Flipped, and has no half-edges: both its ends were one corner.
    /// Made: the chain before which it goes, or that it goes on from.
    std::uint32_t neighbour = kNone;
    bool is_before = false;
    Curve curve;
};

struct Vertex {
    Vec3 at;
    std::vector<std::uint32_t> groups;
    double miss = 0.0;
    bool is_tangency = false;        ///< Of surfaces that touch.
    bool is_bend_elsewhere = false;  ///< Beside the corner of a bend, which is to be another one.
    bool has_failed = false;
    std::uint32_t edge = kNone;  ///< A half-edge between two groups that starts there.
    Vec3 start{};                ///< Where it is in the polyhedron.
};

class Chains {
public:
    /// What cannot be solved is added to `failures`. All of them must outlive it.
    Chains(const FacetMesh& mesh, const Groups& groups, Failures& failures)
        : mesh_(mesh), groups_(groups), failures_(failures) {}

    /// Of the groups as they are.
    void trace();
    /// Where any of these fail, edges are not tried.
    void solve();
    /// Corners of this group that are apart by less than what programs round, each on all that is
    /// around the other one but for that, are one from now on; of planes, cylinders and cones
    /// alone, since elsewhere a corner may be off by more along what touches. True: there are more
    /// of them.
    bool join_corners(std::uint32_t group);
    /// Two edges that meet again beside a corner in which surfaces touch: these cross there from
    /// now on, if they do so well beside it. True: there are more of such corners.
    bool add_crossing(std::uint32_t one, std::uint32_t other);

    /// A corner in which a whole circle begins lies in the plane of that from now on: edges that
    /// end beyond it by what programs round would cross it beside the corner. True: it did not.
    bool snap_to_circle(std::uint32_t of_circle, std::uint32_t vertex);

    const std::vector<Chain>& all() const { return chains_; }
    const std::vector<Vertex>& vertices() const { return vertices_; }
    /// For each group the loops around it, of uses of chains; those that have vanished left out.
    std::vector<std::vector<Loop>> loops() const;
    /// By how much the tips of lunes that the facets did not tell are lower than what is in their
    /// place, at most, mm.
    double mitred_mm() const { return mitred_mm_; }

private:
    std::uint32_t vertex_at(std::uint32_t v);
    bool is_next_to_facet(std::uint32_t h) const;
    bool is_tip(std::uint32_t h) const;
    bool is_bend(std::uint32_t h, const std::vector<int>& degree) const;
    double reach(const std::vector<std::uint32_t>& groups) const;
    /// It may be as far from where it was, or from one of the ways `lines`, as corners of polygons
    /// are from true ones.
    bool solve_vertex(Vertex& v, const std::vector<std::vector<Vec3>>& lines = {}) const;
    bool solve_corner(Vertex& v);
    bool is_above(std::uint32_t ramp, Vec3 p) const;
    void move_to_crossing(Vertex& v, Vec3 start, const std::vector<std::uint32_t>& numbers) const;
    void move_to_ellipse(Vertex& v, Vec3 start) const;
    bool has_bend(std::uint32_t g, Vec3 corner, Vec3 near) const;
    std::optional<Vec3> bend_at(const Vertex& v) const;
    /// A chain as it goes out from a vertex.
    struct Spoke {
        std::uint32_t chain;
        bool is_start;
        std::uint32_t left, right;  ///< Groups.
        Vec3 direction;             ///< Unit.
    };
    std::vector<Spoke> spokes_at(const Vertex& v) const;
    bool split(std::uint32_t number, const std::vector<Spoke>& spokes);
    bool is_bend_elsewhere(const Vertex& v) const;
    bool is_of_turning_tools(const Vertex& v) const;
    bool is_bend_ahead(const Vertex& v, const std::vector<Spoke>& spokes) const;
    void add_chain(std::uint32_t from, std::uint32_t to, std::uint32_t left, std::uint32_t right);
    bool ends_before(const Chain& chain, std::uint32_t other, std::uint32_t end, Vec3 corner);
    bool split_at_crossing(std::uint32_t number);
    void divide(std::uint32_t number, std::size_t i, Vec3 at);
    void bend(std::uint32_t number);
    void split_at(std::uint32_t number, Vec3 corner, bool is_at_start);
    void move_to_wall(std::uint32_t number);
    Vec3 direction_of(std::uint32_t h) const;
    /// Of each vertex, those that meet there, where they are not more than three.
    using ChainsAt = std::vector<std::array<std::uint32_t, 3>>;
    /// The faces around a chain, and the chains at both of its ends.
    struct Crossing {
        std::uint32_t left, right, behind = kNone, ahead = kNone;  ///< Groups.
        std::uint32_t from_left = kNone, from_right = kNone, to_left = kNone, to_right = kNone;
    };
    std::optional<Crossing> crossing_at(std::uint32_t number, const ChainsAt& at) const;
    bool are_walls(const std::vector<std::uint32_t>& groups) const;
    void join_same_corners();
    void join(std::uint32_t removed, std::uint32_t kept);
    std::optional<std::uint32_t> close_pinch(std::uint32_t v);
    ChainsAt chains_at() const;
    bool flip_reversed();
    std::optional<std::array<std::uint32_t, 2>> tangent_sides(const Vertex& v) const;
    void widen(const std::vector<std::uint32_t>& narrow);
    bool is_reversed(Chain& chain) const;
    std::optional<bool> is_past_tangency(const std::array<std::uint32_t, 2>& sides,
                                         std::uint32_t behind, std::uint32_t ahead, Vec3 from,
                                         Vec3 to) const;
    bool flip(std::uint32_t number, ChainsAt& at, int most);
    Vec3 path_direction(const Chain& chain) const;
    /// A use that has no place yet.
    struct PendingUse {
        std::uint32_t group;
        EdgeUse use;
    };
    void remove_flipped(std::uint32_t number, std::vector<std::vector<Loop>>& all) const;
    void insert_flipped(std::uint32_t number, std::vector<std::vector<Loop>>& all,
                        std::vector<PendingUse>& left) const;
    bool insert_use(const PendingUse& one, std::vector<Loop>& loops, bool has_both) const;
    bool solve_next_to_facets(Vertex& v) const;
    double largest_distance(const std::vector<std::uint32_t>& surfaces, Vec3 p) const;
    bool is_rounded_off(const Chain& chain) const;
    void join_ends(const Chain& chain);
    void join_vanished();
    void align_on_generators();
    Vec3 snapped(const Vertex& v, Vec3 p) const;
    std::pair<std::uint32_t, std::uint32_t> corners_of(const Chain& chain) const;
    std::vector<Vec3> points_of(const Chain& chain) const;
    Vec3 middle_of(const Chain& chain) const;
    std::optional<Spline> spline_of(const Chain& chain, const Form& first, const Form& second,
                                    const std::vector<Vec3>& points);
    void solve_chain(Chain& chain);
    bool is_of_rounding(const Chain& chain) const;
    void vanish(Chain& chain) const { chain.has_vanished = true; }
    void fail(Chain& chain) {
        chain.has_failed = true;
        failures_.push_back({{chain.left, chain.right}});
    }

    const FacetMesh& mesh_;
    const Groups& groups_;
    Failures& failures_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> vertex_of_;  // of each corner of the mesh, or none
    std::vector<Chain> chains_;
    std::vector<std::uint32_t> chain_of_;  // of each half-edge
    double mitred_mm_ = 0.0;
    /// Round by round most corners and edges stay what they are: of each corner of the mesh, which
    /// may become several, and of each half-edge with which a chain begins, what was found, and of
    /// what. (Of an edge two splines: on both faces, and on one and what they touch in.)
    struct CachedCorner {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> surfaces;  ///< Surfaces, first facets.
        Vec3 at{};
        double miss = 0.0;
        bool is_tangency = false, is_bend_elsewhere = false, is_solved = false;
    };
    struct CachedSpline {
        std::uint32_t left = kNone, right = kNone;  ///< Surfaces.
        std::vector<Vec3> points;
        std::optional<Spline> spline;
    };
    std::vector<std::vector<CachedCorner>> cached_corners_;
    std::unordered_map<std::uint32_t, CachedSpline> cached_splines_;
    /// Corners of the mesh, and those of them that came in since the last trace: several faces may
    /// fail in one.
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined_, joined_since_trace_;
    std::set<std::uint32_t> crossed_, crossed_since_trace_;
    std::set<std::pair<std::uint32_t, std::uint32_t>>
        snap_circles_;  // corners of the mesh, surfaces
};

}  // namespace ncsim::brep
