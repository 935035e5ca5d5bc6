// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps for each shell:
// 1. Label (facet_mesh.h): assign to each facet the surface of its motion with the closest
// direction.
// 2. Group (face_groups.h): adjacent facets with the same surface form a face. The boundaries of
// faces meet in vertices, connected by chains of edges.
// 3. Solve (chains.h): vertices on all adjacent surfaces, then the curves between them.
// 4. Absorb: groups without width on the true surfaces join a neighbour. Where surfaces do not fit
// together, remove labels, from the smallest group first. Continue with step 2.
// 5. Check each face as other programs do. Faces that fail are treated as in step 4; after too many
// failures they stay facets.
#include "ncsim/brep/recognise.h"

#include "ncsim/brep/flat_part.h"
#include "ncsim/brep/measure.h"

#include "geometry/tolerances.h"
#include "heal/fine_splines.h"
#include "heal/non_simple_faces.h"
#include "heal/nonplanar_faces.h"
#include "heal/pinched_faces.h"
#include "heal/reader_compatibility.h"
#include "heal/tangent_holes.h"
#include "heal/vertex_distance.h"
#include "query/part_check.h"
#include "recognise/chains.h"
#include "recognise/face_check_cache.h"
#include "recognise/face_groups.h"
#include "recognise/face_loops.h"
#include "recognise/facet_mesh.h"
#include "topology/chords.h"
#include "topology/face_edges.h"
#include "topology/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <variant>

namespace ncsim::brep {

namespace {

// Number of rounds with failures of corners, edges or faces in which labels are removed on trial.
constexpr int kLenientRounds = 8;

class ShellRecogniser {
public:
    ShellRecogniser(const Facets& facets, const std::map<cda::Origin, SweptSurfaces>& sources,
                    std::span<const std::uint32_t> faces, std::uint64_t most_work)
        : mesh_(facets, sources, faces),
          apex_(mesh_.point(mesh_.edges().front().from)),
          most_work_(most_work),
          work_(5 * mesh_.size()),  // Labels and the first solution cost as much as five rounds.
          coils_(count_coils()),
          face_checks_(apex_) {}

    // Returns the shell as a part without solids; empty if the shell cannot be recognised.
    std::optional<Part> operator()() {
        // A round over many facets takes long, so there are fewer rounds. If corners alone have
        // failed in the first rounds, strips are narrower than facets, and more rounds do not help.
        if (mesh_.is_broken() || mesh_.size() > 200'000) return std::nullopt;
        const bool are_many = mesh_.size() > 10'000;
        for (int round = 0; round < (are_many ? 40 : 100); ++round) {
            if (are_many && round == kLenientRounds && spent_[kCorners] == round)
                return std::nullopt;
            work_ += mesh_.size();
            // With twice the allowed work, the shell consists of facets.
            if (work_ / 2 > most_work_) return std::nullopt;
            failures_.clear();
            has_joined_ = false;
            if (!settle_groups()) return std::nullopt;
            chains_.trace();
            // Wrong corners are the usual cause of wrong edges, and wrong edges of wrong faces.
            chains_.solve();
            const Stage stage = failures_.empty()                ? kFaces
                                : failures_.front().is_of_corner ? kCorners
                                                                 : kEdges;
            const int spent = spent_[stage]++;
            Part part;
            if (stage == kFaces) part = build();
            const Strictness strictness = work_ > most_work_           ? Strictness::Full
                                          : spent < kLenientRounds     ? Strictness::Low
                                          : spent < 2 * kLenientRounds ? Strictness::High
                                                                       : Strictness::Full;
            if (groups_.relabel(failures_, strictness) || has_joined_) continue;
            if (!failures_.empty() || !has_the_volume()) return std::nullopt;
            std::vector<bool> is_as_it_was = unmoved(part);
            for (const std::uint32_t f : triangulate_nonplanar_faces(part)) {
                is_as_it_was.push_back(false);
                group_of_face_.push_back(group_of_face_[f]);
            }
            bool are_planes_sound = true;
            const std::vector<std::uint32_t> was =
                enforce_min_vertex_distance(part, &are_planes_sound);
            find_unsound_facets(part, was, is_as_it_was);
            if (!are_planes_sound) find_crossed_planes(part, was);
            if (failures_.empty()) return part;
            if (!groups_.relabel(failures_, Strictness::Full)) return std::nullopt;
        }
        return std::nullopt;
    }

    // Returns the number of facets without label after the last attempt.
    std::size_t demoted_count() const { return mesh_.demoted_count(); }
    bool has_lost_coils() const { return count_coils() < coils_; }
    std::uint64_t work() const { return work_; }
    double mitred_mm() const { return std::max(groups_.mitred_mm(), chains_.mitred_mm()); }

private:
    // Returns the number of facets that are labelled with a coil.
    std::size_t count_coils() const {
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < mesh_.size(); ++i)
            count += std::holds_alternative<Coil>(mesh_.surface(mesh_[i].label).form) ? 1U : 0U;
        return count;
    }

    // Repeats grouping until no more groups are merged. Returns false if there is no end.
    bool settle_groups() {
        for (int pass = 0; pass < 1000; ++pass) {
            groups_.gather();
            if (!groups_.unify() && !groups_.demote_neighbours_of_tori() &&
                !groups_.insert_strips())
                return true;
        }
        return false;
    }

    Part build() {
        Part part;
        FaceLoops face_loops(groups_, chains_);
        for (const Vertex& v : chains_.vertices())
            part.vertices.push_back(v.at);
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            if (groups_.is_facet(g)) continue;
            for (const Corners& corners :
                 face_loops.touching_corners(g, face_loops[g], near_on(g))) {
                part.vertices[corners.first] = part.vertices[corners.second];
                face_loops.unite(corners);
                if (chains_.snap_to_circle(corners.first, corners.second)) has_joined_ = true;
            }
        }
        face_loops.join_touching_loops();
        for (std::uint32_t c = 0; c < chains_.all().size(); ++c) {
            const auto [from, to] = face_loops.ends_of(c);
            part.edges.push_back({from, to, chains_.all()[c].curve});
        }
        const auto is_sound = [&](std::uint32_t g) {
            return std::ranges::none_of(face_loops[g], [&](const Loop& loop) {
                return std::ranges::any_of(
                    loop, [&](const EdgeUse& use) { return chains_.all()[use.edge].has_failed; });
            });
        };
        group_of_face_.clear();
        volume_ = 0.0;
        std::vector<FaceCheckCache::Entry*> checks;  // of each face
        std::vector<bool> is_removed(groups_.size(), false);
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            if (face_loops[g].empty()) {
                is_removed[g] = true;
                vanish(g, true);
                continue;
            }
            if (!is_sound(g)) continue;
            Face face;
            face.surface = groups_.surface_of(g);
            face.loops = std::move(face_loops[g]);
            name(face, g);
            face.is_facet = groups_.is_facet(g);
            auto& found = face_checks_.lookup(part, face, groups_[g].facets.front());
            // Facets may have any width. Next to facets, OpenCASCADE makes edges as wide as they
            // are off.
            const double width = std::max(kLeastSizeMm, neighbour_error(g));
            is_removed[g] = groups_[g].is_analytic &&
                            2.0 * std::abs(found.measure.area) <= width * found.measure.length;
            if (is_removed[g]) vanish(g, true);
            volume_ += found.measure.volume;
            part.faces.push_back(std::move(face));
            group_of_face_.push_back(g);
            checks.push_back(&found);
        }
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            const std::uint32_t g = group_of_face_[f];
            // Removed groups make the adjacent faces overlap until the next round.
            const bool is_next_to_removed =
                is_removed[g] ||
                std::ranges::any_of(groups_.neighbours(g), [&](const auto& neighbour) {
                    return is_removed[neighbour.first];
                });
            if (is_next_to_removed) continue;
            if (!is_wanted(g)) continue;
            const double error = neighbour_error(g);
            const double tolerance = error > 0.0 ? 1.5 * kFacetSlack * error : kTangencyGapMm;
            // CAD programs project edges that are off a curved surface onto it, each in another
            // way.
            const bool is_flat = std::holds_alternative<Plane>(groups_.form_of(g));
            const double clear = error > 0.0 && !is_flat ? 0.05 * tolerance : kReaderClearance;
            double& miss = error > 0.0 ? part.facet_miss_mm : part.miss_mm;
            if (!is_too_large(g, checks[f]->measure.area) &&
                !FaceCheckCache::is_faulty(*checks[f], part, f, tolerance, clear, miss))
                continue;
            if (chains_.join_corners(g)) {
                has_joined_ = true;
                continue;
            }
            if (add_crossing(part.faces[f], checks[f]->fault_at)) {
                has_joined_ = true;
                continue;
            }
            if (!groups_.is_facet(g) && touching_.insert(groups_[g].surface).second &&
                !face_loops.touching_corners(g, part.faces[f].loops, near_on(g)).empty()) {
                has_joined_ = true;
                continue;
            }
            std::vector<std::uint32_t> groups{g};
            if (!checks[f]->fault_at.empty()) {
                for (const auto& [loop, place] : checks[f]->fault_at) {
                    const Chain& chain = chains_.all()[part.faces[f].loops[loop][place].edge];
                    groups.push_back(chain.left);
                    groups.push_back(chain.right);
                }
                failures_.push_back({std::move(groups)});
                continue;
            }
            // Planes are usually right and their neighbours wrong.
            if (!groups_[g].is_analytic || std::holds_alternative<Plane>(groups_.form_of(g))) {
                for (const auto& [n, shared] : groups_.neighbours(g))
                    groups.push_back(n);
            }
            failures_.push_back({std::move(groups)});
        }
        return part;
    }

    // Returns the distance below which corners of a group are one point, mm.
    double near_on(std::uint32_t g) const {
        return touching_.contains(groups_[g].surface) ? kTangencyGapMm : kReaderMm;
    }

    // Adds crossings where two faulty edges with a common corner meet a second time, because the
    // adjacent surfaces are not tangent there. Returns true if a crossing was added.
    bool add_crossing(const Face& face,
                      const std::vector<std::pair<std::size_t, std::size_t>>& faults) {
        const auto edge = [&](const auto& at) { return face.loops[at.first][at.second].edge; };
        bool any = false;
        for (std::size_t i = 0; i < faults.size(); ++i) {
            for (std::size_t j = i + 1; j < faults.size(); ++j)
                any = chains_.add_crossing(edge(faults[i]), edge(faults[j])) || any;
        }
        return any;
    }

    // Returns the error of the group and its adjacent facets, mm; 0 without facets.
    double neighbour_error(std::uint32_t g) const {
        double error = groups_.is_facet(g) ? groups_.error_of(g) : 0.0;
        for (const auto& [n, shared] : groups_.neighbours(g)) {
            if (groups_.is_facet(n)) error = std::max(error, groups_.error_of(n));
        }
        return error;
    }

    // True if the group, or a neighbour, was recognised. Faces of the polyhedron alone need no
    // check.
    bool is_wanted(std::uint32_t g) const {
        return groups_[g].is_analytic ||
               std::ranges::any_of(groups_.neighbours(g), [&](const auto& neighbour) {
                   return groups_[neighbour.first].is_analytic;
               });
    }

    // Returns for each face whether it is a facet with all corners at their places in the
    // polyhedron.
    std::vector<bool> unmoved(const Part& part) const {
        std::vector<bool> result;
        for (const Face& face : part.faces) {
            result.push_back(
                face.is_facet && std::ranges::all_of(uses_of(face), [&](const EdgeUse& use) {
                    const Chain& chain = chains_.all()[use.edge];
                    const auto is_at = [&](std::uint32_t vertex, std::uint32_t corner) {
                        return part.vertices[vertex] == mesh_.point(corner);
                    };
                    return is_at(part.edges[use.edge].from,
                                 mesh_.edges()[chain.edges.front()].from) &&
                           is_at(part.edges[use.edge].to, mesh_.to(chain.edges.back()));
                }));
        }
        return result;
    }

    // Adds failures for facets whose moved corners make the facet nonplanar or faulty. `was` has
    // the previous number of each face.
    void find_unsound_facets(const Part& part, const std::vector<std::uint32_t>& was,
                             const std::vector<bool>& is_as_it_was) {
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            if (is_as_it_was[was[f]]) continue;
            double miss = 0.0;
            // Edges of facets lie on their planes. With a tolerance of 1 mm, only loops can fail.
            if (part.faces[f].is_facet &&
                (is_nonplanar(part, part.faces[f]) || !faults_of(part, f, 1.0, miss).empty()))
                failures_.push_back({{group_of_face_[was[f]]}});
        }
    }

    // Adds failures for planes that cross other faces, if a group there can still become facets.
    void find_crossed_planes(const Part& part, const std::vector<std::uint32_t>& was) {
        for (const std::uint32_t f : crossed_planes(part)) {
            const std::uint32_t g = group_of_face_[was[f]];
            std::vector<std::uint32_t> groups{g};
            for (const auto& [n, shared] : groups_.neighbours(g))
                groups.push_back(n);
            const bool is_removable = std::ranges::any_of(
                groups, [&](std::uint32_t n) { return groups_[n].is_analytic; });
            if (is_removable) failures_.push_back({std::move(groups)});
        }
    }

    // True if the face is much larger than its group, as with a wrong curve. A facet may be wider
    // than the true face by its own width at each edge.
    bool is_too_large(std::uint32_t g, double area) const {
        const double facet = std::sqrt(8.0 * kLargeRadius * groups_.error_of(g));
        return area > 2.0 * (groups_[g].area + groups_.perimeter(g) * facet);
    }

    // Adds a failure for a group without width on the true surfaces.
    void vanish(std::uint32_t g, bool is_thin = false) {
        std::vector<std::uint32_t> groups{g};
        if (!groups_[g].is_analytic) {
            for (const auto& [n, shared] : groups_.neighbours(g))
                groups.push_back(n);
        }
        failures_.push_back({std::move(groups), false, is_thin});
    }

    void name(Face& face, std::uint32_t g) const {
        for (const std::uint32_t i : groups_[g].facets) {
            const auto& of = mesh_.origins(i);
            face.origins.insert(face.origins.end(), of.begin(), of.end());
        }
        sort_unique(face.origins);
        face.origin = face.origins.empty() ? cda::kStockOrigin : face.origins.front();
    }

    // True if the volume of the last built part agrees with the polyhedron's within the errors of
    // facets.
    bool has_the_volume() const {
        double polyhedral = 0.0, slack = 0.0;
        for (std::uint32_t i = 0; i < mesh_.size(); ++i) {
            const Facet& facet = mesh_[i];
            polyhedral += dot(facet.centroid - apex_, facet.normal) * facet.area / 3.0;
            slack += facet.area * (1.5 * facet.error_mm + kFlat);
        }
        return std::abs(volume_ - polyhedral) <= slack;
    }

    enum Stage { kCorners, kEdges, kFaces };
    std::array<int, 3> spent_{};                // rounds with failures of each stage
    std::vector<std::uint32_t> group_of_face_;  // group of each face of the last built part
    double volume_ = 0.0;  // volume of the last built part, by cones from the apex
    FacetMesh mesh_;
    Vec3 apex_;
    std::uint64_t most_work_, work_;  // facets times rounds
    std::size_t coils_;               // facets with a coil at first
    Groups groups_{mesh_};
    Failures failures_;  // of this round
    Chains chains_{mesh_, groups_, failures_};
    FaceCheckCache face_checks_;  // from the apex
    // Surfaces on which corners within the rounding of programs are one point.
    std::set<std::uint32_t> touching_;
    // True if corners were merged in this round instead of removing labels.
    bool has_joined_ = false;
};

// Appends `from` to `to`, without unused vertices and edges. Returns the numbers of its faces in
// `to`.
Shell append(Part& to, const Part& from) {
    std::vector<std::uint32_t> vertices(from.vertices.size(), kNone);
    std::vector<std::uint32_t> edges(from.edges.size(), kNone);
    const auto vertex = [&](std::uint32_t v) {
        if (vertices[v] == kNone) {
            vertices[v] = static_cast<std::uint32_t>(to.vertices.size());
            to.vertices.push_back(from.vertices[v]);
        }
        return vertices[v];
    };
    Shell shell;
    for (Face face : from.faces) {
        for (Loop& loop : face.loops) {
            for (EdgeUse& use : loop) {
                std::uint32_t& edge = edges[use.edge];
                if (edge == kNone) {
                    const Edge& e = from.edges[use.edge];
                    edge = static_cast<std::uint32_t>(to.edges.size());
                    const std::uint32_t begin = vertex(e.from), end = vertex(e.to);
                    to.edges.push_back({begin, end, e.curve});
                }
                use.edge = edge;
            }
        }
        shell.push_back(static_cast<std::uint32_t>(to.faces.size()));
        to.faces.push_back(std::move(face));
    }
    to.miss_mm = std::max(to.miss_mm, from.miss_mm);
    to.facet_miss_mm = std::max(to.facet_miss_mm, from.facet_miss_mm);
    return shell;
}

// Returns the facets of one shell.
Facets only_shell(const Facets& facets, const std::vector<std::uint32_t>& faces) {
    Facets only;
    only.boundary.vertices = facets.boundary.vertices;
    only.boundary.shells = 1;
    for (const std::uint32_t f : faces) {
        only.boundary.faces.push_back(facets.boundary.faces[f]);
        only.boundary.faces.back().shell = 0;
        only.origins.push_back(facets.origins[f]);
    }
    return only;
}

// Marks the faces that round tools cut as facets.
void mark_facets(Part& part, const std::map<cda::Origin, SweptSurfaces>& sources) {
    for (Face& face : part.faces) {
        face.is_facet = std::ranges::any_of(face.origins, [&](cda::Origin origin) {
            const auto source = sources.find(origin);
            return source != sources.end() && !source->second.candidates.empty();
        });
    }
}

// True if readers lose an edge, because facets are farther off the adjacent surfaces than the edge
// is long.
bool has_lost_edges(const Part& part) {
    const std::vector<double> least = reader_lengths(part);
    for (std::size_t e = 0; e < least.size(); ++e) {
        if (is_straight(part.edges[e]) && length_of_chord(part, part.edges[e]) < least[e])
            return true;
    }
    return false;
}

// True if a part that consists mostly of facets is better than a part of `facets` facets alone: it
// has fewer faces, and at most seven eighths if readers lose an edge.
bool is_better(const Part& part, std::size_t facets) {
    const std::size_t most = has_lost_edges(part) ? facets - facets / 8 : facets;
    return part.faces.size() <= most;
}

bool is_mostly_facets(const Part& part) {
    const auto facets = std::ranges::count_if(part.faces, &Face::is_facet);
    return 2 * static_cast<std::size_t>(facets) > part.faces.size();
}

}  // namespace

Recognised recognise(const Facets& facets, const std::map<cda::Origin, SweptSurfaces>& sources,
                     const std::function<Facets(double times)>& kept, std::uint64_t most_work) {
    Recognised result;
    const auto shells = shells_of(facets.boundary);
    std::optional<Facets> flat;
    std::vector<std::vector<std::uint32_t>> flat_shells;
    const auto add = [&](std::uint32_t s) {
        ShellRecogniser recogniser(facets, sources, shells[s], most_work);
        const auto part = recogniser();
        result.facets_demoted += recogniser.demoted_count();
        result.has_lost_coils = result.has_lost_coils || recogniser.has_lost_coils();
        result.work += recogniser.work();
        result.has_ended_early = result.has_ended_early || recogniser.work() > most_work;
        if (part) result.mitred_mm = std::max(result.mitred_mm, recogniser.mitred_mm());
        if (part && !is_mostly_facets(*part)) return append(result.part, *part);
        if (!flat) {
            flat = kept(1.0);
            flat_shells = shells_of(flat->boundary);
        }
        const bool is_there = s < flat_shells.size() && !flat_shells[s].empty();
        // Facets of different motions stay separate for recognition; joined, they may be fewer than
        // the faces of the result.
        if (part && (!is_there || is_better(*part, flat_shells[s].size())))
            return append(result.part, *part);
        ++result.shells_kept;
        FlatPart alone = flat_part([&](double times) {
            if (times == 1.0)
                return is_there ? only_shell(*flat, flat_shells[s]) : only_shell(facets, shells[s]);
            const Facets coarse = kept(times);
            const auto coarse_shells = shells_of(coarse.boundary);
            return s < coarse_shells.size() ? only_shell(coarse, coarse_shells[s]) : Facets{};
        });
        result.tolerance_factor = std::max(result.tolerance_factor, alone.tolerance_factor);
        result.is_sound = result.is_sound && alone.is_sound;
        mark_facets(alone.part, sources);
        return append(result.part, alone.part);
    };
    for (const Nesting& nesting : nesting_of(facets.boundary)) {
        Solid solid{add(nesting.outside), {}};
        for (const std::uint32_t s : nesting.voids)
            solid.voids.push_back(add(s));
        result.part.solids.push_back(std::move(solid));
    }
    split_pinched_faces(result.part);
    split_wide_edges(result.part);
    split_edges_of_lenses(result.part);
    split_faces_at_tangent_holes(result.part);
    split_cones_at_base_circle(result.part);
    split_arcs_near_corners(result.part);
    split_arcs_at_cusps(result.part);
    refine_splines(result.part);
    std::set<cda::Origin> of_facets;
    for (const Face& face : result.part.faces) {
        if (!face.is_facet) continue;
        ++result.facets_kept;
        of_facets.insert(face.origins.begin(), face.origins.end());
    }
    result.of_facets.assign(of_facets.begin(), of_facets.end());
    return result;
}

}  // namespace ncsim::brep
