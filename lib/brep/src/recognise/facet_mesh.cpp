// SPDX-License-Identifier: GPL-3.0-or-later
#include "recognise/facet_mesh.h"

#include "geometry/envelope_contact.h"
#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::brep {

namespace {

// Largest deviation of a facet's normal from the surface that the facet approximates, as a chord
// (0.45 rad).
constexpr double kMaxFacetTurn = 0.45;

}  // namespace

FacetMesh::FacetMesh(const Facets& facets, const std::map<cda::Origin, SweptSurfaces>& sources,
                     std::span<const std::uint32_t> faces)
    : source_(facets) {
    for (const std::uint32_t f : faces)
        facets_.push_back(make_facet(f, sources));
    link();
    if (broken_) return;
    label_needles();
    split_fans();
}

// Gives each fan of facets a separate corner where several fans meet in one corner, next to facets
// of turning tools, because hulls of successive poses touch each other.
void FacetMesh::split_fans() {
    std::vector<bool> is_seen(edges_.size(), false), has_fan(points_.size(), false);
    for (std::uint32_t first = 0; first < edges_.size(); ++first) {
        if (is_seen[first]) continue;
        std::vector<std::uint32_t> fan;
        bool turns = false;
        for (std::uint32_t h = first; !is_seen[h]; h = edges_[edges_[h].twin].next) {
            is_seen[h] = true;
            fan.push_back(h);
            const Form& form = surfaces_[facets_[edges_[h].facet].label].form;
            turns = turns || is_of_turning_tool(form);
        }
        const std::uint32_t corner = edges_[first].from;
        const bool is_first = !has_fan[corner];
        has_fan[corner] = true;
        if (is_first || !turns) continue;
        for (const std::uint32_t h : fan)
            edges_[h].from = static_cast<std::uint32_t>(points_.size());
        points_.push_back(points_[corner]);
    }
}

// Gives needles the label of an adjacent facet of a turning tool. The normal of a facet without
// width is arbitrary, and a face with such a facet would overlap itself.
void FacetMesh::label_needles() {
    std::vector<double> perimeter(facets_.size(), 0.0);
    for (std::uint32_t h = 0; h < edges_.size(); ++h)
        perimeter[edges_[h].facet] += lengths_[h];
    const auto is_needle = [&](std::uint32_t i) {
        return 2.0 * facets_[i].area < kFlat * perimeter[i];
    };
    std::vector<double> longest(facets_.size(), 0.0);
    for (std::uint32_t h = 0; h < edges_.size(); ++h) {
        const std::uint32_t i = edges_[h].facet, neighbour = edges_[edges_[h].twin].facet;
        const bool is_its = is_of_turning_tool(surfaces_[facets_[neighbour].label].form) &&
                            facets_[i].was_labelled && is_needle(i) && !is_needle(neighbour);
        if (!is_its || lengths_[h] <= longest[i]) continue;
        longest[i] = lengths_[h];
        facets_[i].label = facets_[neighbour].label;
        facets_[i].plain = facets_[neighbour].plain;
    }
}

bool FacetMesh::fits(const Facet& facet, const Surface& surface, double most,
                     double most_turn) const {
    return brep::fits(shape_of(facet), surface, most, most_turn);
}

std::vector<Vec3> FacetMesh::corners_of(std::uint32_t facet) const {
    std::vector<Vec3> corners;
    for (const auto& loop : source_.boundary.faces[facets_[facet].face].loops) {
        for (const std::uint32_t v : loop)
            corners.push_back(source_.boundary.vertices[v]);
    }
    return corners;
}

FlatFace FacetMesh::shape_of(const Facet& facet) const {
    return {facet.normal, facet.centroid, source_.boundary.faces[facet.face].loops,
            source_.boundary.vertices};
}

Facet FacetMesh::make_facet(std::uint32_t f, const std::map<cda::Origin, SweptSurfaces>& sources) {
    const cda::BoundaryFace& face = source_.boundary.faces[f];
    Facet facet;
    facet.face = f;
    facet.normal = face.normal;
    facet.area = area_of(face.loops, source_.boundary.vertices, face.normal, facet.centroid);
    facet.own = surfaces_.add_alone({Plane{facet.centroid, face.normal}, false});
    facet.label = facet.own;
    facet.may_be_true = true;
    double best = std::numeric_limits<double>::infinity();
    const CandidateSurface* chosen = nullptr;
    for (const cda::Origin origin : source_.origins[f]) {
        const auto source = sources.find(origin);
        if (source == sources.end()) continue;
        if (!source->second.candidates.empty()) facet.may_be_true = false;
        if (source->second.may_leave_other_surfaces) facet.is_unknown = true;
        facet.error_mm = std::max(facet.error_mm, source->second.error_mm);
        const CandidateSurface* better = best_of(shape_of(facet), source->second.candidates,
                                                 source->second.error_mm, kMaxFacetTurn, best);
        if (better) chosen = better;
    }
    if (chosen) facet.label = surfaces_.add(chosen->surface);
    facet.plain = facet.label;
    if (chosen && std::holds_alternative<Envelope>(chosen->surface.form))
        facet.plain = plain_label(f, facet, sources);
    facet.was_labelled = chosen != nullptr;
    if (chosen) facet.is_unknown = false;
    return facet;
}

std::uint32_t FacetMesh::plain_label(std::uint32_t f, const Facet& facet,
                                     const std::map<cda::Origin, SweptSurfaces>& sources) {
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t label = facet.own;
    for (const cda::Origin origin : source_.origins[f]) {
        const auto source = sources.find(origin);
        if (source == sources.end()) continue;
        const CandidateSurface* better =
            best_of(shape_of(facet), source->second.candidates, source->second.error_mm,
                    kMaxFacetTurn, best, false);
        if (better) label = surfaces_.add(better->surface);
    }
    return label;
}

DisjointSets FacetMesh::kept_patches() const {
    DisjointSets patches(facets_.size());
    for (const HalfEdge& h : edges_) {
        if (h.twin == kNone) continue;
        const std::uint32_t other = edges_[h.twin].facet;
        if (is_kept(facets_[h.facet]) && is_kept(facets_[other])) patches.unite(h.facet, other);
    }
    return patches;
}

std::size_t FacetMesh::demoted_count() const {
    DisjointSets patches = kept_patches();
    struct Counts {
        std::size_t demoted_count = 0, unknown = 0;
    };
    std::vector<Counts> all(facets_.size());
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
        const Facet& facet = facets_[i];
        if (!is_kept(facet)) continue;
        Counts& patch = all[patches.find(i)];
        if (facet.is_unknown) ++patch.unknown;
        if (facet.was_labelled) ++patch.demoted_count;
    }
    std::size_t count = 0;
    for (const Counts& patch : all) {
        if (patch.demoted_count > patch.unknown) count += patch.demoted_count;
    }
    return count;
}

bool FacetMesh::is_boundary(std::uint32_t h) const {
    return facets_[edges_[h].facet].label != facets_[edges_[edges_[h].twin].facet].label;
}

std::uint32_t FacetMesh::next_boundary(std::uint32_t h) const {
    std::uint32_t n = edges_[h].next;
    while (!is_boundary(n))
        n = edges_[edges_[n].twin].next;
    return n;
}

std::uint32_t FacetMesh::boundary_before(std::uint32_t h) const {
    std::uint32_t before = h;
    while (next_boundary(before) != h)
        before = next_boundary(before);
    return before;
}

std::uint32_t FacetMesh::add_edge(const HalfEdge& edge) {
    edges_.push_back(edge);
    lengths_.push_back(0.0);
    return static_cast<std::uint32_t>(edges_.size() - 1);
}

void FacetMesh::pair_edges(std::uint32_t h, std::uint32_t twin) {
    edges_[h].twin = twin;
    edges_[twin].twin = h;
    lengths_[twin] = lengths_[h];
}

// Divides the corner at the end of `h`: facets of one label between `h` and `last` get a new corner
// at the same place. Returns the new corner.
std::uint32_t FacetMesh::split_corner(std::uint32_t h, std::uint32_t last) {
    const std::uint32_t corner = edges_[last].from,
                        own = static_cast<std::uint32_t>(points_.size());
    points_.push_back(points_[corner]);
    std::uint32_t n = edges_[h].next;
    edges_[n].from = own;
    while (n != last) {
        n = edges_[edges_[n].twin].next;
        edges_[n].from = own;
    }
    return own;
}

// The strip has a half-edge next to each half-edge of the chain, and one back next to each twin. At
// both ends, where these have a common corner, there is another half-edge next to the facet beyond
// the label.
void FacetMesh::insert_strip(std::span<const std::uint32_t> chain, std::uint32_t surface) {
    const std::uint32_t first = chain.front(), before = boundary_before(first);
    const std::uint32_t after = next_boundary(chain.back());
    const auto number = static_cast<std::uint32_t>(facets_.size());
    Facet strip = facets_[edges_[first].facet];
    strip.own = strip.label;
    strip.label = strip.plain = surface;
    strip.area = 0.0;
    strip.may_be_true = false;
    strip.was_labelled = false;
    strip.is_strip = true;

    std::vector<std::uint32_t> corners, split_corners;
    corners.push_back(edges_[first].from);
    for (const std::uint32_t h : chain)
        corners.push_back(to(h));
    std::uint32_t from = before;
    for (std::size_t i = 0; i <= chain.size(); ++i) {
        const std::uint32_t last = i < chain.size() ? chain[i] : after;
        split_corners.push_back(split_corner(from, last));
        from = last;
    }
    // Half-edges between the old and the new corner at both ends, in the facets beyond.
    const std::uint32_t begin = edges_[before].twin, end = edges_[after].twin;
    std::uint32_t previous = begin;
    while (edges_[previous].next != begin)
        previous = edges_[previous].next;
    edges_[begin].from = split_corners.front();
    const std::uint32_t at_begin = add_edge({corners.front(), edges_[begin].facet, begin, kNone});
    edges_[previous].next = at_begin;
    const std::uint32_t at_end =
        add_edge({split_corners.back(), edges_[end].facet, edges_[end].next, kNone});
    edges_[end].next = at_end;

    std::vector<std::uint32_t> loop;
    const auto add = [&](std::uint32_t corner, std::uint32_t twin) {
        loop.push_back(add_edge({corner, number, kNone, kNone}));
        pair_edges(twin, loop.back());
    };
    for (std::size_t i = 0; i < chain.size(); ++i)
        add(corners[i], edges_[chain[i]].twin);
    add(corners.back(), at_end);
    for (std::size_t i = chain.size(); i-- > 0;)
        add(split_corners[i + 1], chain[i]);
    add(split_corners.front(), at_begin);
    for (std::size_t i = 0; i < loop.size(); ++i)
        edges_[loop[i]].next = loop[(i + 1) % loop.size()];
    facets_.push_back(strip);
}

void FacetMesh::link() {
    std::vector<std::uint32_t> number(source_.boundary.vertices.size(), kNone);
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
        for (const auto& loop : source_.boundary.faces[facets_[i].face].loops) {
            const auto first = static_cast<std::uint32_t>(edges_.size());
            for (std::size_t k = 0; k < loop.size(); ++k) {
                std::uint32_t& v = number[loop[k]];
                if (v == kNone) {
                    v = static_cast<std::uint32_t>(points_.size());
                    points_.push_back(source_.boundary.vertices[loop[k]]);
                }
                const auto at = static_cast<std::uint32_t>(edges_.size());
                edges_.push_back({v, i, k + 1 < loop.size() ? at + 1 : first, kNone});
            }
        }
    }
    // Twins have equal corners.
    struct Ends {
        std::uint32_t low, high, edge;
        bool operator<(const Ends& o) const {
            return low != o.low ? low < o.low : high != o.high ? high < o.high : edge < o.edge;
        }
    };
    std::vector<Ends> ends;
    for (std::uint32_t h = 0; h < edges_.size(); ++h) {
        const auto [low, high] = std::minmax({edges_[h].from, to(h)});
        ends.push_back({low, high, h});
        lengths_.push_back(norm(points_[high] - points_[low]));
    }
    std::sort(ends.begin(), ends.end());
    broken_ = ends.size() % 2 != 0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        const Ends &a = ends[i], &b = ends[i + 1];
        const bool is_next =
            i + 2 < ends.size() && ends[i + 2].low == a.low && ends[i + 2].high == a.high;
        if (a.low != b.low || a.high != b.high || is_next ||
            edges_[a.edge].from == edges_[b.edge].from) {
            broken_ = true;
            return;
        }
        edges_[a.edge].twin = b.edge;
        edges_[b.edge].twin = a.edge;
    }
}

}  // namespace ncsim::brep
