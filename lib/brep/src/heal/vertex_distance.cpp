// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/vertex_distance.h"

#include "ncsim/brep/frames.h"

#include "geometry/newton.h"
#include "geometry/no_index.h"
#include "geometry/tolerances.h"
#include "heal/degenerate_planes.h"
#include "heal/non_simple_faces.h"
#include "heal/short_edges.h"
#include "heal/spikes.h"
#include "sources/label.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// Least distance of vertices that CAD readers keep apart on all adjacent faces, mm.
constexpr double kLeast = 10.0 * kPointError;

Numbers common(const Numbers& a, const Numbers& b) {
    Numbers shared;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
    return shared;
}

// Contraction of edges to points if only lengths change. The link condition decides: the ends of
// the edge have no faces and neighbours in common except the faces on both sides of the edge, and
// the opposite corners of these faces if the faces are triangles.
// Source: Dey, Edelsbrunner, Guha, Nekhayev, Topology Preserving Edge Contraction, 1999.
class Contraction {
public:
    explicit Contraction(Part& part)
        : part_(part),
          faces_at_(faces_at_vertices(part)),
          edges_at_(part.vertices.size()),
          radius_(part.vertices.size(), 0.0),
          is_flat_(flat_vertices(part)) {
        for (const Face& face : part.faces) {
            for (const EdgeUse& use : uses_of(face)) {
                edges_at_[part.edges[use.edge].from].push_back(use.edge);
                edges_at_[part.edges[use.edge].to].push_back(use.edge);
            }
        }
        for (Numbers& edges : edges_at_)
            sort_unique(edges);
    }

    // True if planes and lines alone meet at both ends of the edge.
    bool is_flat(const Edge& edge) const { return is_flat_[edge.from] && is_flat_[edge.to]; }

    // Contracts the edge to either end. Vertices move by at most twice `least_mm`. False if the
    // edge stays.
    bool contract(std::uint32_t number, double least_mm) {
        const Edge edge = part_.edges[number];
        return contract(number, edge.from, edge.to, least_mm) ||
               contract(number, edge.to, edge.from, least_mm);
    }

private:
    // Contracts the edge to its end `kept`. False if the edge stays: the link condition is not met,
    // or vertices would move by more than twice `least_mm`.
    bool contract(std::uint32_t number, std::uint32_t kept, std::uint32_t removed,
                  double least_mm) {
        const Edge short_edge = part_.edges[number];
        if (kept == removed || !is_flat(short_edge)) return false;
        const double radius = radius_[removed] + length_of_chord(part_, short_edge);
        if (radius > 2.0 * least_mm) return false;
        const Numbers sides = common(faces_at_[kept], faces_at_[removed]);
        if (sides.size() != 2) return false;
        Numbers tips;
        for (const std::uint32_t f : sides) {
            if (!is_simple_at(part_.faces[f], number, removed)) return false;
            if (is_triangle(part_.faces[f])) tips.push_back(tip(part_.faces[f], short_edge));
        }
        sort_unique(tips);
        if (common(neighbours(kept), neighbours(removed)) != tips) return false;
        for (const std::uint32_t f : sides) {
            for (Loop& loop : part_.faces[f].loops)
                std::erase_if(loop, [&](const EdgeUse& use) { return use.edge == number; });
        }
        for (const std::uint32_t e : edges_at_[removed]) {
            Edge& edge = part_.edges[e];
            if (edge.from == removed) edge.from = kept;
            if (edge.to == removed) edge.to = kept;
        }
        radius_[kept] = std::max(radius_[kept], radius);
        move_to(kept, removed, faces_at_);
        move_to(kept, removed, edges_at_);
        std::erase(edges_at_[kept], number);
        for (const std::uint32_t f : sides) {
            Face& face = part_.faces[f];
            if (face.loops.front().size() < 3) {
                remove_two_sided_face(f);
            } else {
                face.frame = frame_for(part_, face);
            }
        }
        return true;
    }

    static void move_to(std::uint32_t kept, std::uint32_t removed, std::vector<Numbers>& at) {
        at[kept].insert(at[kept].end(), at[removed].begin(), at[removed].end());
        sort_unique(at[kept]);
        at[removed].clear();
    }

    Numbers neighbours(std::uint32_t v) const {
        Numbers all;
        for (const std::uint32_t e : edges_at_[v])
            all.push_back(part_.edges[e].from == v ? part_.edges[e].to : part_.edges[e].from);
        sort_unique(all);
        return all;
    }

    static bool is_triangle(const Face& face) {
        return face.loops.size() == 1 && face.loops.front().size() == 3;
    }

    std::uint32_t tip(const Face& triangle, const Edge& edge) const {
        for (const EdgeUse& use : triangle.loops.front()) {
            const std::uint32_t v = begin_of(part_, use);
            if (v != edge.from && v != edge.to) return v;
        }
        return edge.from;
    }

    // True if the face visits the vertex once, and uses the edge in a loop that keeps three edges,
    // or is the only loop of a triangle.
    bool is_simple_at(const Face& face, std::uint32_t edge, std::uint32_t vertex) const {
        bool has_edge = false;
        int visits = 0;
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                if (use.edge == edge) has_edge = loop.size() > 3 || is_triangle(face);
                if (begin_of(part_, use) == vertex) ++visits;
            }
        }
        return has_edge && visits == 1;
    }

    // Removes a face with two edges between the same vertices. Both adjacent faces use the first
    // edge afterwards.
    void remove_two_sided_face(std::uint32_t f) {
        Loop& loop = part_.faces[f].loops.front();
        const EdgeUse kept_use = loop[0], removed_use = loop[1];
        const Edge edge = part_.edges[removed_use.edge];
        for (const std::uint32_t other : faces_at_[edge.from]) {
            if (other == f) continue;
            for (Loop& other_loop : part_.faces[other].loops) {
                for (EdgeUse& use : other_loop) {
                    if (use.edge != removed_use.edge) continue;
                    // `use` is opposite to `removed_use`, which is opposite to `kept_use`; so the
                    // direction of `use` is the direction of `kept_use`.
                    use = {kept_use.edge, kept_use.is_forward};
                }
            }
        }
        loop.clear();
        for (const std::uint32_t v : {edge.from, edge.to}) {
            std::erase(faces_at_[v], f);
            std::erase(edges_at_[v], removed_use.edge);
        }
        part_.edges[removed_use.edge].to = edge.from;
    }

    Part& part_;
    std::vector<Numbers> faces_at_, edges_at_;  // of each vertex, ascending
    std::vector<double> radius_;  // bound of the distance of the vertices merged into each, mm
    std::vector<bool> is_flat_;   // true for vertices at which planes and lines alone meet
};

// Holes whose extent is at most kLeast, which are closed by merging their corners. A hole of this
// size results if a corner protrudes through a face by less than CAD readers distinguish.
class Pinholes {
public:
    explicit Pinholes(Part& part) : part_(part), faces_at_(faces_at_vertices(part)) {}

    // Closes all holes of this size. True if the part changed.
    bool close() {
        bool any = false;
        for (Face& face : part_.faces) {
            for (std::size_t l = face.loops.size(); l-- > 1;) {
                if (!close(face.loops[l])) continue;
                face.loops.erase(face.loops.begin() + static_cast<std::ptrdiff_t>(l));
                any = true;
            }
        }
        return any;
    }

private:
    bool close(const Loop& hole) {
        double length = 0.0;
        Numbers corners, edges, faces;
        for (const EdgeUse& use : hole) {
            const Edge& edge = part_.edges[use.edge];
            if (!is_straight(edge)) return false;
            length += length_of_chord(part_, edge);
            edges.push_back(use.edge);
            corners.insert(corners.end(), {edge.from, edge.to});
        }
        if (length > 2.0 * kLeast) return false;
        sort_unique(corners);
        sort_unique(edges);
        for (const std::uint32_t v : corners)
            faces.insert(faces.end(), faces_at_[v].begin(), faces_at_[v].end());
        sort_unique(faces);
        const bool is_clear = std::ranges::all_of(faces, [&](std::uint32_t f) {
            return can_remove_hole(part_.faces[f], hole, corners, edges);
        });
        if (!is_clear) return false;
        for (const std::uint32_t f : faces) {
            for (Loop& loop : part_.faces[f].loops) {
                if (&loop == &hole) continue;
                std::erase_if(loop, [&](const EdgeUse& use) {
                    return std::ranges::binary_search(edges, use.edge);
                });
            }
            for (const EdgeUse& use : uses_of(part_.faces[f]))
                gather(part_.edges[use.edge], corners);
        }
        faces_at_[corners.front()] = faces;
        for (const std::uint32_t f : faces)
            part_.faces[f].frame = frame_for(part_, part_.faces[f]);
        return true;
    }

    static void gather(Edge& edge, const Numbers& corners) {
        for (std::uint32_t* v : {&edge.from, &edge.to}) {
            if (std::ranges::binary_search(corners, *v)) *v = corners.front();
        }
    }

    // True if a face with a corner of the hole stays valid when the hole is closed: the face is
    // planar with straight edges only, visits the corners of the hole once (several corners along
    // edges of the hole), and keeps at least three edges in each loop.
    bool can_remove_hole(const Face& face, const Loop& hole, const Numbers& corners,
                         const Numbers& edges) const {
        if (!is_plane(face)) return false;
        int visits = 0;
        for (const Loop& loop : face.loops) {
            if (&loop == &hole) continue;
            std::size_t left = 0;
            for (const EdgeUse& use : loop) {
                if (!is_straight(part_.edges[use.edge])) return false;
                const bool begins = std::ranges::binary_search(corners, begin_of(part_, use));
                const bool is_gone = std::ranges::binary_search(edges, use.edge);
                // Each visit ends with an edge that starts at a corner of the hole and is not of
                // the hole.
                if (begins && !is_gone) ++visits;
                if (!is_gone) ++left;
            }
            if (left < 3) return false;
        }
        return visits <= 1;
    }

    Part& part_;
    std::vector<Numbers> faces_at_;  // of each vertex, ascending
};

// Erases faces without edges from the part, from shells and from `original`, which has the original
// face of each face. Erases empty voids.
void drop_empty(Part& part, Numbers& original) {
    std::vector<std::uint32_t> number(part.faces.size());
    std::uint32_t count = 0;
    const auto is_empty = [](const Face& face) {
        return face.loops.empty() || face.loops.front().empty();
    };
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        const bool is_gone = is_empty(part.faces[f]);
        if (!is_gone) original[count] = original[f];
        number[f] = is_gone ? kNone : count++;
    }
    const auto renumber = [&](Shell& shell) {
        for (std::uint32_t& f : shell)
            f = number[f];
        std::erase(shell, kNone);
    };
    for (Solid& solid : part.solids) {
        for_shells(solid, renumber);
        std::erase_if(solid.voids, &Shell::empty);
    }
    std::erase_if(part.faces, is_empty);
    original.resize(count);
}

// Moves corners of planes onto the adjacent planes, or nearer to all of these, by less than kFlat.
void move_onto_planes(Part& part) {
    const std::vector<double> widths = reader_widths(part).corners;
    const std::vector<bool> is_flat = flat_vertices(part);
    const std::vector<Numbers> faces = faces_at_vertices(part);
    for (std::uint32_t v = 0; v < part.vertices.size(); ++v) {
        if (!is_flat[v] || widths[v] <= kReaderMm) continue;
        std::vector<const Form*> planes;
        planes.reserve(faces[v].size());
        for (const std::uint32_t f : faces[v])
            planes.push_back(&part.faces[f].surface.form);
        Vec3 p = part.vertices[v];
        if (solve(planes, p) < widths[v] && norm(p - part.vertices[v]) < kFlat)
            part.vertices[v] = p;
    }
}

// Contracts edges that are shorter than kLeast or that CAD readers lose, the shortest first. True
// if the part changed.
bool contract_short_edges(Part& part) {
    // Corners of polyhedra are off their planes by at most kFlat. Corners that are farther off move
    // by less than a quarter of the length that is lost.
    std::vector<double> least = reader_lengths(part);
    std::vector<std::pair<double, std::uint32_t>> low;
    for (std::uint32_t e = 0; e < part.edges.size(); ++e) {
        least[e] = std::max(kLeast, std::min(least[e], std::max(kFlat, 0.25 * least[e])));
        const double length = length_of_chord(part, part.edges[e]);
        if (length < least[e]) low.emplace_back(length, e);
    }
    if (low.empty()) return false;
    std::sort(low.begin(), low.end());
    Contraction contraction(part);
    bool any = false;
    // An edge may meet the link condition after adjacent edges have been contracted.
    while (std::erase_if(low, [&](const auto& edge) {
               return contraction.contract(edge.second, least[edge.second]);
           }) > 0)
        any = true;
    return any;
}

// Lengthens edges that contract_short_edges() left shorter than 3 kReaderMm to kLeast if planes and
// lines alone meet at both ends.
void lengthen_short_edges(Part& part) {
    const Contraction contraction(part);
    // A longer edge may shorten an adjacent edge, so there are three passes.
    for (int pass = 0; pass < 3; ++pass) {
        for (const Edge& edge : part.edges) {
            Vec3 &a = part.vertices[edge.from], &b = part.vertices[edge.to];
            const double length = length_of_chord(part, edge);
            if (length >= 3.0 * kReaderMm || length == 0.0 || !contraction.is_flat(edge)) continue;
            const Vec3 move = (0.5 * (kLeast - length) / length) * (b - a);
            a = a - move;
            b = b + move;
        }
    }
}

// Loop of a planar face that has the same edges as a loop of an adjacent face; all edges are
// straight.
struct OppositeLoop {
    std::uint32_t face;
    std::size_t loop;
};

// Returns the opposite loop of `loop`. `sides` has the faces on both sides of each edge.
std::optional<OppositeLoop> opposite_loop(const Part& part,
                                          const std::vector<std::array<std::uint32_t, 2>>& sides,
                                          const Loop& loop) {
    if (loop.empty()) return std::nullopt;
    const EdgeUse& first = loop.front();
    const std::uint32_t other = sides[first.edge][first.is_forward ? 1 : 0];
    if (other == kNone || sides[first.edge][0] == sides[first.edge][1]) return std::nullopt;
    const Face& face = part.faces[other];
    if (!is_plane(face)) return std::nullopt;
    const auto has = [](const Loop& in, std::uint32_t edge) {
        return std::ranges::find(in, edge, &EdgeUse::edge) != in.end();
    };
    const auto same =
        std::ranges::find_if(face.loops, [&](const Loop& l) { return has(l, loop.front().edge); });
    const bool is_same = same != face.loops.end() && same->size() == loop.size() &&
                         std::ranges::all_of(loop, [&](const EdgeUse& use) {
                             return is_straight(part.edges[use.edge]) && has(*same, use.edge);
                         });
    if (!is_same) return std::nullopt;
    return OppositeLoop{other, static_cast<std::size_t>(same - face.loops.begin())};
}

// Empties pairs of planar faces that enclose no volume: two faces with all edges in common, and a
// face with a hole together with a face that fills the hole. Pairs of the second kind count only if
// either face is in `crossed`: then the hole is not inside its face, or the face that fills the
// hole has no width. True if the part changed.
bool remove_flat_pockets(Part& part, const Numbers& crossed) {
    bool any = false;
    const auto sides = sides_of_edges(part);
    const auto empty = [&](std::uint32_t f, std::size_t l, bool may_be_hole) {
        Face& face = part.faces[f];
        if (!is_plane(face)) return;
        const auto other = opposite_loop(part, sides, face.loops[l]);
        if (!other) return;
        Face& beyond = part.faces[other->face];
        const bool are_whole = face.loops.size() == 1 && beyond.loops.size() == 1;
        // Outlines of two faces with holes do not count.
        const bool is_hole =
            (l > 0 && beyond.loops.size() == 1) || (other->loop > 0 && face.loops.size() == 1);
        if (!are_whole && !(may_be_hole && is_hole)) return;
        face.loops[l].clear();
        beyond.loops[other->loop].clear();
        any = true;
    };
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        if (part.faces[f].loops.size() == 1) empty(f, 0, false);
    }
    for (const std::uint32_t f : crossed) {
        for (std::size_t l = 0; l < part.faces[f].loops.size(); ++l)
            empty(f, l, true);
    }
    for (Face& face : part.faces) {
        if (any && face.loops.size() > 1)
            std::erase_if(face.loops, [](const Loop& loop) { return loop.empty(); });
    }
    return any;
}

// Splits planar faces among `faces` that touch themselves within `near_mm`, and erases spikes and
// flat pockets. Updates `original`. True if the part changed.
bool split_at_touching_corners(Part& part, const Numbers& faces, double near_mm,
                               Numbers& original) {
    bool any = join_touching_corners(part, faces, near_mm);
    // Spikes are erased before the split, because the two uses of a spike could become uses of two
    // different loops.
    any = remove_spikes(part) || any;
    drop_empty(part, original);
    for (const std::uint32_t f : split_non_simple_faces(part)) {
        original.push_back(original[f]);
        any = true;
    }
    any = remove_spikes(part) || any;
    any = remove_flat_pockets(part, {}) || any;
    drop_empty(part, original);
    return any;
}

}  // namespace

std::vector<std::uint32_t> enforce_min_vertex_distance(Part& part, bool* is_sound) {
    Numbers original(part.faces.size()), faces, crossed;
    std::iota(original.begin(), original.end(), 0U);
    // Each step may allow changes that were impossible in an earlier step.
    for (int rounds_left = 10; rounds_left > 0; --rounds_left) {
        remove_spikes(part);
        drop_empty(part, original);
        Pinholes(part).close();
        move_onto_planes(part);
        while (contract_short_edges(part)) {
        }
        remove_spikes(part);
        drop_empty(part, original);
        lengthen_short_edges(part);
        faces.resize(part.faces.size());
        std::iota(faces.begin(), faces.end(), 0U);
        split_at_touching_corners(part, faces, kLeast, original);
        crossed = degenerate_planes(part);
        if (crossed.empty()) break;
        if (split_at_touching_corners(part, crossed, kFlat, original))
            crossed = degenerate_planes(part);
        const bool had_pockets = remove_flat_pockets(part, crossed);
        if (had_pockets) {
            drop_empty(part, original);
            crossed = degenerate_planes(part);
        }
        if (rounds_left == 1) break;
        // The first limit includes the edges that were lengthened to kLeast; the larger limits
        // follow if no edge is collapsed.
        const bool has_collapsed = std::ranges::any_of(
            std::array{1.5 * kLeast, 3.0 * kLeast, kFlat},
            [&](double near_mm) { return collapse_short_edges(part, crossed, near_mm); });
        if (!has_collapsed && !had_pockets) break;
    }
    if (is_sound) *is_sound = crossed.empty();
    return original;
}

}  // namespace ncsim::brep
