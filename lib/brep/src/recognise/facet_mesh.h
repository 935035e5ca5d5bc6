// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 1 of recognition: the facets of a shell, linked by half-edges. The label of a facet is the
// surface of the facet's motion from which the facet deviates least in direction.
#pragma once

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/brep/facets.h"
#include "ncsim/brep/surface_forms.h"
#include "ncsim/brep/swept_surfaces.h"

#include "geometry/no_index.h"
#include "sources/label.h"
#include "sources/surface_set.h"

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::brep {

struct Facet {
    std::uint32_t face = 0;  ///< Number in the boundary.
    Vec3 centroid, normal;
    double area = 0.0;
    double error_mm = 0.0;      ///< Error of the tool's polygon and of the path, mm.
    std::uint32_t own = 0;      ///< Number of the plane of the facet.
    std::uint32_t label = 0;    ///< Number of the assigned surface.
    std::uint32_t plain = 0;    ///< Number of the best surface other than envelopes.
    bool may_be_true = false;   ///< True if the plane of the facet is exact.
    bool was_labelled = false;  ///< True if a surface of the facet's motion was assigned.
    bool is_unknown = false;    ///< True if no listed surface fits and the motion may leave others.
    bool is_final = false;      ///< True if the facet stays a facet.
    bool was_demoted = false;
    bool was_reassigned = false;  ///< True if a neighbour's surface was assigned.
    bool is_strip = false;        ///< True for inserted strips without width.
};

struct HalfEdge {
    std::uint32_t from = 0, facet = 0, next = 0, twin = kNone;
};

class FacetMesh {
public:
    /// Links the faces with the numbers `faces`, which form a shell, and labels each face. All
    /// arguments must outlive the mesh.
    FacetMesh(const Facets& facets, const std::map<cda::Origin, SweptSurfaces>& sources,
              std::span<const std::uint32_t> faces);

    /// True if an edge does not have two adjacent faces; recognition is not possible then.
    bool is_broken() const { return broken_; }
    /// Returns the number of facets whose label was removed. Facets in a connected patch that has
    /// at least as many unknown facets are not counted, because finer facets would be unknown, too.
    std::size_t demoted_count() const;

    std::size_t size() const { return facets_.size(); }
    const Facet& operator[](std::uint32_t i) const { return facets_[i]; }
    void label(std::uint32_t i, std::uint32_t surface) { facets_[i].label = surface; }
    void reassign_label(std::uint32_t i, std::uint32_t surface) {
        facets_[i].label = facets_[i].plain = surface;
        facets_[i].was_reassigned = true;
    }
    /// Makes the facet permanent.
    void fix_as_facet(std::uint32_t i) {
        facets_[i].label = facets_[i].own;
        facets_[i].is_final = true;
    }
    /// Removes the label, so that a neighbour may absorb the facet. The second removal is
    /// permanent.
    void demote_to_facets(std::uint32_t i) {
        facets_[i].label = facets_[i].own;
        facets_[i].is_final = std::exchange(facets_[i].was_demoted, true);
    }
    /// Replaces an envelope by the best surface of the motion that is no envelope. Returns false if
    /// there is none or if it has been tried.
    bool replace_envelope_label(std::uint32_t i) {
        facets_[i].label = std::exchange(facets_[i].plain, facets_[i].own);
        return facets_[i].label != facets_[i].own;
    }
    /// Removes the label and marks the facet as unknown, for envelopes adjacent to unknown facets.
    void mark_unknown(std::uint32_t i) {
        facets_[i].label = facets_[i].own;
        facets_[i].is_unknown = true;
        facets_[i].was_labelled = false;
    }
    /// Inserts a strip without width on the surface `surface` along the consecutive half-edges of
    /// `chain`, which separate two labels. A strip whose label is removed gets the label on the
    /// left of the chain. The ends of the strip are adjacent to the facets at the ends of the
    /// chain.
    /// Requires: the chain is open.
    void insert_strip(std::span<const std::uint32_t> chain, std::uint32_t surface);
    /// Returns the next or the previous half-edge of the boundary between the label on the left of
    /// `h` and other labels.
    std::uint32_t next_boundary(std::uint32_t h) const;
    std::uint32_t boundary_before(std::uint32_t h) const;
    const Surface& surface(std::uint32_t number) const { return surfaces_[number]; }
    std::uint32_t number_of(const Surface& surface) { return surfaces_.add(surface); }
    /// Returns the motions that cut the facet.
    const std::vector<cda::Origin>& origins(std::uint32_t i) const {
        return source_.origins[facets_[i].face];
    }

    const std::vector<HalfEdge>& edges() const { return edges_; }
    std::uint32_t to(std::uint32_t h) const { return edges_[edges_[h].next].from; }
    /// Returns the number of corners. Corners are numbered within the shell.
    std::size_t corners() const { return points_.size(); }
    Vec3 point(std::uint32_t v) const { return points_[v]; }
    double length(std::uint32_t h) const { return lengths_[h]; }
    std::vector<Vec3> corners_of(std::uint32_t facet) const;

    /// True if the facet lies on the surface within `most` (mm) and a deviation of the normal of
    /// `most_turn` (as a chord).
    bool fits(const Facet& facet, const Surface& surface, double most, double most_turn) const;

private:
    FlatFace shape_of(const Facet& facet) const;
    Facet make_facet(std::uint32_t f, const std::map<cda::Origin, SweptSurfaces>& sources);
    std::uint32_t plain_label(std::uint32_t f, const Facet& facet,
                              const std::map<cda::Origin, SweptSurfaces>& sources);
    void link();
    bool is_boundary(std::uint32_t h) const;
    std::uint32_t split_corner(std::uint32_t h, std::uint32_t last);
    std::uint32_t add_edge(const HalfEdge& edge);
    void pair_edges(std::uint32_t h, std::uint32_t twin);
    void label_needles();
    void split_fans();
    // True if the facet approximates a round surface but has no label.
    bool is_kept(const Facet& facet) const {
        return facet.label == facet.own && !facet.may_be_true;
    }
    DisjointSets kept_patches() const;

    const Facets& source_;
    SurfaceSet surfaces_;
    std::vector<Facet> facets_;
    std::vector<HalfEdge> edges_;
    std::vector<double> lengths_;  // of half-edges
    std::vector<Vec3> points_;
    bool broken_ = false;
};

}  // namespace ncsim::brep
