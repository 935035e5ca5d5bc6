// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first step: each facet of a shell with the surface of its own motion that it turns away from
// least, and how facets hang together.
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
    std::uint32_t face = 0;  ///< In the boundary.
    Vec3 centroid, normal;
    double area = 0.0;
    double error_mm = 0.0;  ///< Of what it approximates.
    std::uint32_t own = 0;  ///< Its own plane.
    std::uint32_t label = 0;
    std::uint32_t plain = 0;    ///< Its label where envelopes are left out.
    bool may_be_true = false;   ///< Its own plane is no approximation.
    bool was_labelled = false;  ///< With a surface of its motion.
    bool is_unknown = false;    ///< With none, for its motion leaves others, too.
    bool is_final = false;      ///< It stays a facet.
    bool was_demoted = false;
    bool was_reassigned = false;  ///< To a neighbour, for a corner that was none.
    bool is_strip = false;        ///< Without width: no polyhedron has it.
};

struct HalfEdge {
    std::uint32_t from = 0, facet = 0, next = 0, twin = kNone;
};

class FacetMesh {
public:
    /// Of the shell with these faces. All of them must outlive it.
    FacetMesh(const Facets& facets, const std::map<cda::Origin, SweptSurfaces>& sources,
              std::span<const std::uint32_t> faces);

    /// Faces do not meet two at an edge: nothing can be made of it.
    bool is_broken() const { return broken_; }
    /// Facets that had a surface and have none any more. Not those that hang together with at least
    /// as many that nobody knows a surface for: finer ones are there, too, and keep theirs from
    /// having one.
    std::size_t demoted_count() const;

    std::size_t size() const { return facets_.size(); }
    const Facet& operator[](std::uint32_t i) const { return facets_[i]; }
    void label(std::uint32_t i, std::uint32_t surface) { facets_[i].label = surface; }
    void reassign_label(std::uint32_t i, std::uint32_t surface) {
        facets_[i].label = facets_[i].plain = surface;
        facets_[i].was_reassigned = true;
    }
    /// A facet for good.
    void fix_as_facet(std::uint32_t i) {
        facets_[i].label = facets_[i].own;
        facets_[i].is_final = true;
    }
    /// A facet until a neighbour takes it in; for good where that has failed before.
    void demote_to_facets(std::uint32_t i) {
        facets_[i].label = facets_[i].own;
        facets_[i].is_final = std::exchange(facets_[i].was_demoted, true);
    }
    /// Off an envelope, onto another surface of its motion. False: it has no other one, or had it.
    bool replace_envelope_label(std::uint32_t i) {
        facets_[i].label = std::exchange(facets_[i].plain, facets_[i].own);
        return facets_[i].label != facets_[i].own;
    }
    /// Beside one that nobody knows a surface for it cannot have its own: as if it had none.
    void mark_unknown(std::uint32_t i) {
        facets_[i].label = facets_[i].own;
        facets_[i].is_unknown = true;
        facets_[i].was_labelled = false;
    }
    /// A strip without width on another surface, between what is on both sides of these half-edges
    /// of one label, each of which goes on where the one before ends, and the last of which does
    /// not end where the first starts. Given up, it is of their label. It is beside what ends
    /// there.
    void insert_strip(std::span<const std::uint32_t> chain, std::uint32_t surface);
    /// The half-edge after that one around what has its label, and the one before.
    std::uint32_t next_boundary(std::uint32_t h) const;
    std::uint32_t boundary_before(std::uint32_t h) const;
    const Surface& surface(std::uint32_t number) const { return surfaces_[number]; }
    std::uint32_t number_of(const Surface& surface) { return surfaces_.add(surface); }
    /// Who cut a facet.
    const std::vector<cda::Origin>& origins(std::uint32_t i) const {
        return source_.origins[facets_[i].face];
    }

    const std::vector<HalfEdge>& edges() const { return edges_; }
    std::uint32_t to(std::uint32_t h) const { return edges_[edges_[h].next].from; }
    /// Corners of this shell have numbers of their own.
    std::size_t corners() const { return points_.size(); }
    Vec3 point(std::uint32_t v) const { return points_[v]; }
    double length(std::uint32_t h) const { return lengths_[h]; }
    std::vector<Vec3> corners_of(std::uint32_t facet) const;

    /// Does the facet lie on the surface, within `most` (mm) and a turn (a chord)?
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
    // Of a round tool, and not a piece of any of its surfaces.
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
