// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 3 of recognition: the boundaries of groups meet in vertices; a chain of half-edges between
// two vertices becomes an edge. Vertices are solved on all adjacent surfaces, then curves between
// the vertices.
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
    bool is_closed = false;                  ///< True for a loop without a vertex.
    std::uint32_t from = kNone, to = kNone;  ///< Numbers of vertices.
    bool has_vanished = false;
    bool has_failed = false;  ///< True if the chain or an end of it has no solution.
    bool is_flipped = false;  ///< True if the chain separates other groups than its half-edges.
    Vec3 direction{};         ///< Direction at the time of the flip; zero if unknown.
    bool is_direction_fixed = false;  ///< True if tangencies of faces determine `direction`.
    /// True for a flipped chain without half-edges, between vertices that were one corner.
    bool is_inserted = false;
    /// Chain that an inserted chain precedes (`is_before`) or follows in loops.
    std::uint32_t neighbour = kNone;
    bool is_before = false;
    Curve curve;
};

struct Vertex {
    Vec3 at;
    std::vector<std::uint32_t> groups;
    double miss = 0.0;
    bool is_tangency = false;  ///< True if two of the surfaces are tangent.
    /// True if the corner of a bend is next to the vertex and becomes another vertex.
    bool is_bend_elsewhere = false;
    bool has_failed = false;
    std::uint32_t edge = kNone;  ///< Half-edge between two groups that starts at the vertex.
    Vec3 start{};                ///< Position in the polyhedron.
};

class Chains {
public:
    /// Adds failures to `failures`. All arguments must outlive the chains.
    Chains(const FacetMesh& mesh, const Groups& groups, Failures& failures)
        : mesh_(mesh), groups_(groups), failures_(failures) {}

    /// Traces vertices and chains from the current groups.
    void trace();
    /// Solves all vertices and then, unless a vertex has failed, all curves.
    void solve();
    /// Merges pairs of corners of `group` that lie within the rounding of programs on each other's
    /// surfaces, in all following rounds. Only corners of planes, cylinders, cones and coils are
    /// merged, because corners of other surfaces may move farther along a tangent surface. Returns
    /// true if pairs were added.
    bool join_corners(std::uint32_t group);
    /// Moves the common corner of two edges that meet a second time next to it, from the next
    /// solution on: surfaces that nearly touch in the corner cross there. Returns true if there is
    /// a new corner to move.
    bool add_crossing(std::uint32_t one, std::uint32_t other);

    /// Moves the vertex into the plane of the whole circle that begins there, from the next
    /// solution on; otherwise edges that end beyond the plane by the rounding of programs would
    /// cross the circle. Returns true if the vertex was not in the plane.
    bool snap_to_circle(std::uint32_t of_circle, std::uint32_t vertex);

    const std::vector<Chain>& all() const { return chains_; }
    const std::vector<Vertex>& vertices() const { return vertices_; }
    /// Returns the loops of each group as uses of chains, without vanished chains.
    std::vector<std::vector<Loop>> loops() const;
    /// Returns the largest height in mm by which the tip of a lune without facets is lower than the
    /// surface in its place.
    double mitred_mm() const { return mitred_mm_; }

private:
    std::uint32_t vertex_at(std::uint32_t v);
    bool is_next_to_facet(std::uint32_t h) const;
    bool is_tip(std::uint32_t h) const;
    bool is_bend(std::uint32_t h, const std::vector<int>& degree) const;
    double reach(const std::vector<std::uint32_t>& groups) const;
    /// Moves the vertex onto all adjacent surfaces; the distance to its start, or to one of the
    /// polylines `lines`, must not exceed the distance between corners of polygons and true
    /// corners. Returns false if there is no such point.
    bool solve_vertex(Vertex& v, const std::vector<std::vector<Vec3>>& lines = {}) const;
    /// Solves the vertex on the curves of tangency that are nearer than `near_tangency`, mm.
    bool solve_vertex(Vertex& v, const std::vector<std::vector<Vec3>>& lines,
                      double near_tangency) const;
    bool solve_corner(Vertex& v);
    bool is_above(std::uint32_t ramp, Vec3 p) const;
    void move_to_crossing(Vertex& v, Vec3 start, const std::vector<std::uint32_t>& numbers) const;
    void move_to_ellipse(Vertex& v, Vec3 start) const;
    void move_to_parting(Vertex& v, Vec3 start, const std::vector<std::uint32_t>& numbers) const;
    bool has_bend(std::uint32_t g, Vec3 corner, Vec3 near) const;
    std::optional<Vec3> bend_at(const Vertex& v) const;
    /// Chain as seen from a vertex, leading outwards.
    struct Spoke {
        std::uint32_t chain;
        bool is_start;
        std::uint32_t left, right;  ///< Numbers of groups.
        Vec3 direction;             ///< Unit vector.
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
    /// Chains at each vertex; only vertices with at most three chains have entries.
    using ChainsAt = std::vector<std::array<std::uint32_t, 3>>;
    /// Faces around a chain, and the chains at both ends of it.
    struct Crossing {
        std::uint32_t left, right, behind = kNone, ahead = kNone;  ///< Numbers of groups.
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
    /// Use of a chain for which no place in a loop is known.
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
    bool is_whole_turn(const Chain& chain) const;
    void vanish(Chain& chain) const { chain.has_vanished = true; }
    void fail(Chain& chain) {
        chain.has_failed = true;
        failures_.push_back({{chain.left, chain.right}});
    }

    const FacetMesh& mesh_;
    const Groups& groups_;
    Failures& failures_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> vertex_of_;  // vertex of each corner of the mesh, or kNone
    std::vector<Chain> chains_;
    std::vector<std::uint32_t> chain_of_;  // chain of each half-edge
    double mitred_mm_ = 0.0;
    /// Results of earlier rounds, because most corners and edges do not change: for each corner of
    /// the mesh, which may become several vertices, and for each first half-edge of a chain, the
    /// surfaces and the solution on them. An edge has two splines: between both faces, and between
    /// one face and the tangency surface.
    struct CachedCorner {
        /// Surface and first facet of each group.
        std::vector<std::pair<std::uint32_t, std::uint32_t>> surfaces;
        Vec3 at{};
        double miss = 0.0;
        bool is_tangency = false, is_bend_elsewhere = false, is_solved = false;
    };
    struct CachedSpline {
        std::uint32_t left = kNone, right = kNone;  ///< Numbers of surfaces.
        std::vector<Vec3> points;
        std::optional<Spline> spline;
    };
    std::vector<std::vector<CachedCorner>> cached_corners_;
    std::unordered_map<std::uint32_t, CachedSpline> cached_splines_;
    /// Pairs of corners to merge, and corners to move to a crossing. The sets `…_since_trace_` have
    /// the additions of this round, because several faces may fail in the same corner.
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined_, joined_since_trace_;
    std::set<std::uint32_t> crossed_, crossed_since_trace_;
    std::set<std::pair<std::uint32_t, std::uint32_t>>
        snap_circles_;  // corners of the mesh, surfaces
};

}  // namespace ncsim::brep
