// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outline, for each shell:
//  1. Label: each facet with the surface of its own motion that it turns away from least.
//  2. Group: neighbours with the same surface are a face; where the boundaries of faces meet is a
//  vertex, what runs between two vertices a chain of edges.
//  3. Solve: vertices on all surfaces around them, then the curves between them.
//  4. Absorb: what has no width on the true surfaces joins a neighbour; where nothing fits, labels
//  come off the smallest group. From 2 again.
//  5. Check, as a stranger would. What fails goes the way of 4; what fails too often stays facets.
#include "ncsim/brep/recognise.h"

#include "ncsim/brep/apart.h"
#include "ncsim/brep/check.h"
#include "ncsim/cda/disjoint_sets.h"
#include "ncsim/trig/angles.h"

#include "contact.h"
#include "spline.h"
#include "surface_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr int kMostRounds = 40;
// A facet and the surface it approximates turn away from each other by less, as a chord (0.45 rad).
constexpr double kMostTurn = 0.45;
constexpr double kMostTurnOfNeighbours = 0.6;
// Where planes of a simplified boundary meet, mm.
constexpr double kFlat = 1e-4;
constexpr double kPoint = 1e-7;
constexpr int kTip = -1;  // no number of edges
constexpr double kNoWidth = 1e-3;

struct Facet {
    std::uint32_t face = 0;  // in the boundary
    Vec3 centroid, normal;
    double area = 0.0;
    double error_mm = 0.0;  // of what it approximates
    std::uint32_t own = 0;  // its own plane
    std::uint32_t label = 0;
    bool may_be_true = false;  // its own plane is no approximation
};

struct HalfEdge {
    std::uint32_t from = 0, facet = 0, next = 0, twin = kNone;
};

double area_of(const cda::Boundary& boundary, const cda::BoundaryFace& face, Vec3& centroid) {
    const Vec3 apex = boundary.vertices[face.loops[0][0]];
    double sum = 0.0;
    Vec3 moment;
    for (const auto& loop : face.loops) {
        const Vec3 a = boundary.vertices[loop[0]] - apex;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const Vec3 b = boundary.vertices[loop[i]] - apex;
            const Vec3 c = boundary.vertices[loop[i + 1]] - apex;
            const double part = 0.5 * dot(cross(b - a, c - a), face.normal);
            sum += part;
            moment = moment + (part / 3.0) * (a + b + c);
        }
    }
    centroid = sum > 0.0 ? apex + (1.0 / sum) * moment : apex;
    return sum;
}

class ShellRecogniser {
public:
    ShellRecogniser(const cda::Boundary& boundary,
                    const std::vector<std::vector<cda::Origin>>& origins,
                    const std::map<cda::Origin, Source>& sources,
                    const std::vector<std::uint32_t>& faces)
        : boundary_(boundary), origins_(origins) {
        for (const std::uint32_t f : faces)
            facets_.push_back(labelled(f, sources));
        link();
    }

    // The shell as a part without solids; nothing if it cannot be had.
    std::optional<Part> operator()() {
        if (broken_) return std::nullopt;
        for (int round = 0; round < kMostRounds; ++round) {
            group();
            if (unify() || give_up_rings()) continue;
            trace();
            solve_vertices();
            solve_chains();
            if (relabel()) continue;
            if (!failed_.empty()) return std::nullopt;
            Part part = build();
            if (relabel()) continue;
            if (!failed_.empty()) return std::nullopt;
            if (!has_the_volume(part)) return std::nullopt;
            return part;
        }
        return std::nullopt;
    }

private:
    // --- 1. Label ---

    // How far a facet turns away from the surface: in its middle, or, where that is off the surface
    // (of a ring: the bottom of a round groove), on average over its corners.
    double turn_from(const Facet& facet, const Surface& surface, double most) const {
        const auto at = [&](Vec3 p) { return norm(facet.normal - outward(surface, p)); };
        if (std::abs(distance(surface.form, facet.centroid)) <= most) return at(facet.centroid);
        double sum = 0.0, corners = 0.0;
        for (const auto& loop : boundary_.faces[facet.face].loops) {
            for (const std::uint32_t v : loop) {
                sum += at(boundary_.vertices[v]);
                corners += 1.0;
            }
        }
        return sum / corners;
    }

    bool fits(const Facet& facet, const Surface& surface, double most, double most_turn,
              double* score = nullptr) const {
        const double turn = turn_from(facet, surface, most);
        if (turn > most_turn) return false;
        double farthest = 0.0;
        const auto* cone = std::get_if<Cone>(&surface.form);
        for (const auto& loop : boundary_.faces[facet.face].loops) {
            for (const std::uint32_t v : loop) {
                const Vec3 p = boundary_.vertices[v];
                farthest = std::max(farthest, std::abs(distance(surface.form, p)));
                if (farthest > most) return false;
                if (cone && dot(p - cone->apex, cone->axis) < -most) return false;
            }
        }
        if (score) *score = turn + 0.1 * farthest / most;
        return true;
    }

    // Corners of hulls that meet may lie farther out than those of the tool.
    static constexpr double kSlack = 1.5;

    Facet labelled(std::uint32_t f, const std::map<cda::Origin, Source>& sources) {
        const cda::BoundaryFace& face = boundary_.faces[f];
        Facet facet;
        facet.face = f;
        facet.normal = face.normal;
        facet.area = area_of(boundary_, face, facet.centroid);
        facet.own = surfaces_.add_alone({Plane{facet.centroid, face.normal}, false});
        facet.label = facet.own;
        facet.may_be_true = true;
        double best = std::numeric_limits<double>::infinity();
        const Candidate* chosen = nullptr;
        for (const cda::Origin origin : origins_[f]) {
            const auto source = sources.find(origin);
            if (source == sources.end()) continue;
            if (!source->second.candidates.empty()) facet.may_be_true = false;
            facet.error_mm = std::max(facet.error_mm, source->second.error_mm);
            for (const Candidate& candidate : source->second.candidates) {
                // A surface that the tool went along is preferred to one where it only stood.
                constexpr double kAtRest = 0.05;
                double score = 0.0;
                if (!fits(facet, candidate.surface, kSlack * source->second.error_mm, kMostTurn,
                          &score))
                    continue;
                if (candidate.is_at_rest) score += kAtRest;
                if (score < best - 1e-9) {
                    best = score;
                    chosen = &candidate;
                }
            }
        }
        if (chosen) facet.label = surfaces_.add(chosen->surface);
        return facet;
    }

    void link() {
        std::unordered_map<std::uint64_t, std::uint32_t> by_ends;
        for (std::uint32_t i = 0; i < facets_.size(); ++i) {
            for (const auto& loop : boundary_.faces[facets_[i].face].loops) {
                const auto first = static_cast<std::uint32_t>(edges_.size());
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    const auto at = static_cast<std::uint32_t>(edges_.size());
                    edges_.push_back({loop[k], i, k + 1 < loop.size() ? at + 1 : first, kNone});
                    const std::uint32_t to = loop[(k + 1) % loop.size()];
                    if (!by_ends.emplace(std::uint64_t{loop[k]} << 32 | to, at).second)
                        broken_ = true;
                }
            }
        }
        for (std::uint32_t h = 0; h < edges_.size(); ++h) {
            const auto twin = by_ends.find(std::uint64_t{to(h)} << 32 | edges_[h].from);
            if (twin == by_ends.end()) {
                broken_ = true;
                return;
            }
            edges_[h].twin = twin->second;
        }
    }

    std::uint32_t to(std::uint32_t h) const { return edges_[edges_[h].next].from; }
    Vec3 point(std::uint32_t v) const { return boundary_.vertices[v]; }
    double length(std::uint32_t h) const { return norm(point(to(h)) - point(edges_[h].from)); }

    // --- 2. Group ---

    struct Group {
        std::uint32_t surface = 0;
        std::vector<std::uint32_t> facets;
        double area = 0.0;
        bool is_analytic = false;  // its surface was recognised
    };

    void group() {
        cda::DisjointSets sets(facets_.size());
        for (const HalfEdge& h : edges_) {
            const std::uint32_t other = edges_[h.twin].facet;
            if (facets_[h.facet].label == facets_[other].label) sets.unite(h.facet, other);
        }
        groups_.clear();
        group_of_.assign(facets_.size(), kNone);
        for (std::uint32_t i = 0; i < facets_.size(); ++i) {
            const std::uint32_t root = sets.find(i);
            if (group_of_[root] == kNone) {
                group_of_[root] = static_cast<std::uint32_t>(groups_.size());
                groups_.push_back({facets_[i].label, {}, 0.0, facets_[i].label != facets_[i].own});
            }
            group_of_[i] = group_of_[root];
            Group& g = groups_[group_of_[i]];
            g.facets.push_back(i);
            g.area += facets_[i].area;
        }
        neighbours_.assign(groups_.size(), {});
        for (std::uint32_t h = 0; h < edges_.size(); ++h) {
            const std::uint32_t g = group_at(h), n = group_at(edges_[h].twin);
            if (g != n) neighbours_[g][n] += length(h);
        }
        failed_.clear();
    }

    std::uint32_t group_at(std::uint32_t h) const { return group_of_[edges_[h].facet]; }
    const Surface& surface_of(std::uint32_t g) const { return surfaces_[groups_[g].surface]; }
    const Form& form_of(std::uint32_t g) const { return surface_of(g).form; }
    bool is_boundary(std::uint32_t h) const { return group_at(h) != group_at(edges_[h].twin); }

    // Neighbours whose surfaces differ by what programs round are one; so are a facet that stands
    // for nothing and a neighbour within its error.
    bool unify() {
        bool any = false;
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            for (const auto& [n, shared] : neighbours_[g]) {
                const bool is_smaller =
                    std::pair(groups_[g].area, g) < std::pair(groups_[n].area, n);
                if (!is_smaller || groups_[g].surface == groups_[n].surface) continue;
                if (!is_same(surface_of(g), surface_of(n), kTouchMm)) continue;
                relabel(g, groups_[n].surface);
                any = true;
                break;
            }
        }
        if (any) return true;
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            const Group& group = groups_[g];
            if (group.is_analytic || facets_[group.facets.front()].may_be_true) continue;
            double perimeter = 0.0;
            for (const auto& [n, shared] : neighbours_[g])
                perimeter += shared;
            const double error = facets_[group.facets.front()].error_mm;
            if (2.0 * group.area < 2.0 * error * perimeter) any = absorb(g, 1.5) || any;
        }
        return any;
    }

    // Straight edges beside a ring may cross the circles where readers cut it open, and then they
    // lose the face: rings have no facets beside them.
    bool give_up_rings() {
        bool any = false;
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            if (!groups_[g].is_analytic || !std::holds_alternative<Torus>(form_of(g))) continue;
            const bool is_beside = std::ranges::any_of(
                neighbours_[g], [&](const auto& beside) { return is_facet(beside.first); });
            if (!is_beside) continue;
            for (const std::uint32_t i : groups_[g].facets)
                facets_[i].label = facets_[i].own;
            any = true;
        }
        return any;
    }

    void relabel(std::uint32_t g, std::uint32_t surface) {
        for (const std::uint32_t i : groups_[g].facets)
            facets_[i].label = surface;
    }

    // Into the neighbour with the longest common boundary on whose surface it lies. Neighbours
    // that change in the same round do not count.
    bool absorb(std::uint32_t g, double errors) {
        std::uint32_t best = kNone;
        double longest = 0.0;
        for (const auto& [n, shared] : neighbours_[g]) {
            if (shared <= longest || !groups_[n].is_analytic ||
                facets_[groups_[n].facets.front()].label != groups_[n].surface)
                continue;
            const auto lies = [&](std::uint32_t i) {
                const Facet& facet = facets_[i];
                const double most =
                    errors * std::max(facet.error_mm, facets_[groups_[n].facets.front()].error_mm);
                return fits(facet, surface_of(n), most, kMostTurnOfNeighbours);
            };
            if (!std::ranges::all_of(groups_[g].facets, lies)) continue;
            longest = shared;
            best = n;
        }
        if (best == kNone) return false;
        relabel(g, groups_[best].surface);
        return true;
    }

    // What went wrong this round joins a neighbour, or goes back to facets. Nothing if that changes
    // nothing.
    bool relabel() {
        bool any = false;
        std::set<std::uint32_t> done;
        for (const auto& around : failed_) {
            // The smallest that can be changed.
            std::vector<std::uint32_t> order = around;
            std::erase_if(order, [&](std::uint32_t g) { return !groups_[g].is_analytic; });
            std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
                return std::pair(groups_[a].area, a) < std::pair(groups_[b].area, b);
            });
            order.erase(std::unique(order.begin(), order.end()), order.end());
            if (order.empty()) continue;
            if (std::ranges::any_of(order, [&](std::uint32_t g) { return done.contains(g); })) {
                any = true;
                continue;
            }
            const bool absorbed = std::ranges::any_of(order, [&](std::uint32_t g) {
                if (!may_be_absorbed(g) || !absorb(g, 3.0)) return false;
                done.insert(g);
                return true;
            });
            any = true;
            if (absorbed) continue;
            const std::uint32_t g = order.front();
            done.insert(g);
            for (const std::uint32_t i : groups_[g].facets)
                facets_[i].label = facets_[i].own;
        }
        return any;
    }

    // Not what is as large as a face that somebody wanted.
    bool may_be_absorbed(std::uint32_t g) const {
        double perimeter = 0.0;
        for (const auto& [n, shared] : neighbours_[g])
            perimeter += shared;
        const Facet& facet = facets_[groups_[g].facets.front()];
        const double width = std::sqrt(8.0 * kLargeRadius * facet.error_mm);
        return 2.0 * groups_[g].area < width * perimeter;
    }

    struct Chain {
        std::vector<std::uint32_t> edges;  // half-edges, with the group on the left
        std::uint32_t left = 0, right = 0;
        bool is_closed = false;                  // without a vertex
        std::uint32_t from = kNone, to = kNone;  // vertices
        bool has_vanished = false;
        Curve curve;
    };

    struct Vertex {
        Vec3 at;
        std::vector<std::uint32_t> groups;
        double miss = 0.0;
    };

    std::uint32_t next_boundary(std::uint32_t h) const {
        std::uint32_t n = edges_[h].next;
        while (!is_boundary(n))
            n = edges_[edges_[n].twin].next;
        return n;
    }

    void trace() {
        chains_.clear();
        vertices_.clear();
        vertex_of_.clear();
        std::unordered_map<std::uint32_t, int> degree;
        std::vector<std::uint32_t> boundary;
        for (std::uint32_t h = 0; h < edges_.size(); ++h) {
            if (!is_boundary(h)) continue;
            boundary.push_back(h);
            ++degree[edges_[h].from];
        }
        for (const std::uint32_t h : boundary) {
            const std::uint32_t v = edges_[h].from;
            if (degree[v] == 2 && (is_tip(h) || is_beside_facet(h))) degree[v] = kTip;
            if (degree[v] == 2) continue;
            const std::uint32_t number = vertex_at(v);
            vertices_[number].groups.push_back(group_at(h));
            vertices_[number].groups.push_back(group_at(edges_[h].twin));
        }
        chain_of_.assign(edges_.size(), kNone);
        const auto follow = [&](std::uint32_t first, bool is_closed) {
            Chain chain;
            chain.left = group_at(first);
            chain.right = group_at(edges_[first].twin);
            chain.is_closed = is_closed;
            const auto number = static_cast<std::uint32_t>(chains_.size());
            std::uint32_t h = first;
            for (;;) {
                chain.edges.push_back(h);
                chain_of_[h] = number;
                chain_of_[edges_[h].twin] = number;
                if (degree[to(h)] != 2) break;
                h = next_boundary(h);
                if (h == first) break;
            }
            chain.from = vertex_at(edges_[first].from);
            chain.to = vertex_at(to(chain.edges.back()));
            for (const std::uint32_t v : {chain.from, chain.to}) {
                if (!is_closed) continue;
                vertices_[v].groups = {chain.left, chain.right};
            }
            chains_.push_back(std::move(chain));
        };
        for (const std::uint32_t h : boundary) {
            if (chain_of_[h] == kNone && degree[edges_[h].from] != 2) follow(h, false);
        }
        for (const std::uint32_t h : boundary) {
            if (chain_of_[h] == kNone) follow(h, true);
        }
        for (Vertex& v : vertices_) {
            std::sort(v.groups.begin(), v.groups.end());
            v.groups.erase(std::unique(v.groups.begin(), v.groups.end()), v.groups.end());
        }
    }

    // A facet of a round tool that stands for nothing: its edges stay straight.
    bool is_facet(std::uint32_t g) const {
        return !groups_[g].is_analytic && !facets_[groups_[g].facets.front()].may_be_true;
    }
    bool is_beside_facet(std::uint32_t h) const {
        return is_facet(group_at(h)) || is_facet(group_at(edges_[h].twin));
    }
    double error_of(std::uint32_t g) const { return facets_[groups_[g].facets.front()].error_mm; }

    // Where a surface passes through the apex of a cone, their edge has a corner.
    bool is_tip(std::uint32_t h) const {
        const std::uint32_t one = group_at(h), other = group_at(edges_[h].twin);
        for (const auto& [g, n] : {std::pair(one, other), std::pair(other, one)}) {
            const auto* cone = std::get_if<Cone>(&form_of(g));
            if (!cone) continue;
            const double error = facets_[groups_[g].facets.front()].error_mm;
            if (norm(point(edges_[h].from) - cone->apex) < 4.0 * error &&
                std::abs(distance(form_of(n), cone->apex)) < kFlat)
                return true;
        }
        return false;
    }

    std::uint32_t vertex_at(std::uint32_t v) {
        const auto [at, is_new] =
            vertex_of_.try_emplace(v, static_cast<std::uint32_t>(vertices_.size()));
        if (is_new) vertices_.push_back({point(v), {}, 0.0});
        return at->second;
    }

    // --- 3. Solve ---

    // How far a corner of the polygon may be from the true one.
    double reach(const std::vector<std::uint32_t>& around) const {
        double radius = kLargeRadius, error = 0.0;
        for (const std::uint32_t g : around) {
            radius = std::max(radius, radius_of(form_of(g)));
            error = std::max(error, facets_[groups_[g].facets.front()].error_mm);
        }
        return 4.0 * std::sqrt(2.0 * radius * error) + 4.0 * error + kFlat;
    }

    void solve_vertices() {
        for (Vertex& v : vertices_) {
            const Vec3 start = v.at;
            if (std::ranges::any_of(v.groups, [&](std::uint32_t g) { return is_facet(g); })) {
                if (!solve_beside_facets(v)) failed_.push_back(v.groups);
                continue;
            }
            std::vector<std::uint32_t> numbers;
            bool all_flat = true;
            for (const std::uint32_t g : v.groups) {
                numbers.push_back(groups_[g].surface);
                all_flat = all_flat && std::holds_alternative<Plane>(form_of(g));
            }
            std::sort(numbers.begin(), numbers.end());
            numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
            std::vector<const Form*> forms;
            for (const std::uint32_t n : numbers)
                forms.push_back(&surfaces_[n].form);
            const std::size_t count = forms.size();
            std::vector<Form> touching;
            touching.reserve(count * count);
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t j = i + 1; j < count; ++j) {
                    if (auto t = touch(*forms[i], *forms[j])) touching.push_back(*t);
                }
            }
            for (const Form& t : touching)
                forms.push_back(&t);
            if (!at_apex(forms, v.at)) solve(forms, v.at);
            v.miss = farthest(numbers, v.at);
            const bool is_lost = !(v.miss <= kTouchMm) || norm(v.at - start) > reach(v.groups);
            if (!is_lost) continue;
            // Planes that were made to meet within less than anybody sees.
            v.at = start;
            v.miss = farthest(numbers, v.at);
            if (!all_flat || v.miss > kFlat) failed_.push_back(v.groups);
        }
    }

    // A corner of facets stays where it is, or goes to where the faces beside them meet: within
    // their error it is a corner of all.
    bool solve_beside_facets(Vertex& v) {
        std::vector<const Form*> forms;
        double error = 0.0;
        bool is_flat = true;
        for (const std::uint32_t g : v.groups) {
            error = std::max(error, error_of(g));
            is_flat = is_flat && !groups_[g].is_analytic;
            if (!is_facet(g)) forms.push_back(&form_of(g));
        }
        if (is_flat) return true;
        const auto off = [&](Vec3 p) {
            double most = 0.0;
            for (const std::uint32_t g : v.groups)
                most = std::max(most, std::abs(distance(form_of(g), p)));
            return most;
        };
        if (forms.size() > 1) {
            std::vector<Form> touching;
            for (std::size_t i = 0; i < forms.size(); ++i) {
                for (std::size_t j = i + 1; j < forms.size(); ++j) {
                    if (auto t = touch(*forms[i], *forms[j])) touching.push_back(*t);
                }
            }
            for (const Form& t : touching)
                forms.push_back(&t);
            Vec3 p = v.at;
            if (solve(forms, p) <= kTouchMm && norm(p - v.at) <= kBesideFacets * error &&
                off(p) <= kBesideFacets * error) {
                v.at = p;
                return true;
            }
        }
        return off(v.at) <= kBesideFacets * error;
    }

    // Newton's method does not find an apex, where a cone has no normal.
    static bool at_apex(const std::vector<const Form*>& forms, Vec3& p) {
        for (const Form* form : forms) {
            const auto* cone = std::get_if<Cone>(form);
            if (!cone || norm(p - cone->apex) > kApexReach) continue;
            const bool all = std::ranges::all_of(
                forms, [&](const Form* f) { return std::abs(distance(*f, cone->apex)) < kFlat; });
            if (!all) continue;
            p = cone->apex;
            return true;
        }
        return false;
    }

    double farthest(const std::vector<std::uint32_t>& surfaces, Vec3 p) const {
        double most = 0.0;
        for (const std::uint32_t n : surfaces)
            most = std::max(most, std::abs(distance(surfaces_[n].form, p)));
        return most;
    }

    std::vector<Vec3> points_of(const Chain& chain) const {
        std::vector<Vec3> points;
        for (const std::uint32_t h : chain.edges)
            points.push_back(point(edges_[h].from));
        points.push_back(point(to(chain.edges.back())));
        return points;
    }

    // The angle by which points go round an axis, degrees, signed.
    static double turned(const std::vector<Vec3>& points, Vec3 centre, Vec3 axis) {
        double sum = 0.0;
        const Vec3 x = across(axis), y = cross(axis, x);
        std::optional<double> last;
        for (const Vec3& p : points) {
            const double angle = trig::angle_of(dot(p - centre, x), dot(p - centre, y));
            if (last) {
                const double step = angle - *last;
                sum += step - 360.0 * std::floor(step / 360.0 + 0.5);
            }
            last = angle;
        }
        return sum;
    }

    void solve_chains() {
        if (!failed_.empty()) return;
        for (Chain& chain : chains_)
            solve_chain(chain);
    }

    void fail(const Chain& chain) { failed_.push_back({chain.left, chain.right}); }

    void solve_chain(Chain& chain) {
        const Form &a = form_of(chain.left), &b = form_of(chain.right);
        Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
        const bool is_loop = chain.from == chain.to;
        std::vector<Vec3> points = points_of(chain);
        if (!is_loop && norm(to.at - from.at) <= kPoint) {
            // A circle that ends where it begins, or nothing?
            Vec3 middle = points[points.size() / 2];
            if (norm(middle - from.at) < reach({chain.left, chain.right})) {
                chain.has_vanished = true;
                return;
            }
        }
        if (is_facet(chain.left) || is_facet(chain.right)) {
            if (is_loop) return fail(chain);
            chain.curve = Line{};
            return;
        }
        std::optional<Curve> curve = meet(a, b, from.at, to.at);
        const bool is_straight = curve && std::holds_alternative<Line>(*curve);
        if (is_straight) {
            // A line that comes back is none; nor is one the other way.
            const bool is_back = dot(to.at - from.at, points.back() - points.front()) < 0.0;
            if (is_loop || (is_back && norm(to.at - from.at) > kPoint)) return fail(chain);
            chain.curve = Line{};
            return;
        }
        if (!curve) {
            points.front() = from.at;
            points.back() = to.at;
            auto spline = spline_between(a, b, points);
            if (!spline) return fail(chain);
            chain.curve = std::move(*spline);
            return;
        }
        auto* circle = std::get_if<Circle>(&*curve);
        auto* ellipse = std::get_if<Ellipse>(&*curve);
        const Vec3 centre = circle ? circle->centre : ellipse->centre;
        Vec3& axis = circle ? circle->axis : ellipse->axis;
        const double rough = turned(points, centre, axis);
        if (is_loop && std::abs(rough) < 180.0) return fail(chain);
        if (rough < 0.0) axis = -axis;
        if (chain.is_closed) {
            // Anywhere: where CAD begins to unroll.
            const Vec3 x = across(axis);
            from.at = circle ? centre + circle->radius * x
                             : centre + ellipse->major_radius * ellipse->major;
            from.miss = std::max(std::abs(distance(a, from.at)), std::abs(distance(b, from.at)));
        }
        if (!is_loop) {
            const double sweep = Track(*curve, from.at, to.at).sweep_degrees();
            // All but a whole turn: it goes back by the rest.
            if (std::abs(sweep - std::abs(rough)) > std::abs(sweep - 360.0 + std::abs(rough)) &&
                std::abs(sweep - std::abs(rough)) > 180.0)
                return fail(chain);
        }
        chain.curve = std::move(*curve);
    }

    // --- Faces ---

    // The loops of all groups, as uses of chains.
    struct ChainUse {
        std::uint32_t chain;
        bool is_forward;
    };

    std::uint32_t first_of(ChainUse use) const {
        const Chain& c = chains_[use.chain];
        return use.is_forward ? c.edges.front() : edges_[c.edges.back()].twin;
    }
    std::uint32_t last_of(ChainUse use) const {
        const Chain& c = chains_[use.chain];
        return use.is_forward ? c.edges.back() : edges_[c.edges.front()].twin;
    }

    std::vector<std::vector<Loop>> loops() const {
        std::vector<std::vector<Loop>> all(groups_.size());
        std::vector<bool> seen(2 * chains_.size(), false);
        for (std::uint32_t i = 0; i < 2 * chains_.size(); ++i) {
            if (seen[i]) continue;
            ChainUse use{i / 2, i % 2 == 0};
            const std::uint32_t g = group_at(first_of(use));
            Loop loop;
            for (;;) {
                seen[2 * use.chain + (use.is_forward ? 0 : 1)] = true;
                if (!chains_[use.chain].has_vanished) loop.push_back({use.chain, use.is_forward});
                const std::uint32_t next = next_boundary(last_of(use));
                use = {chain_of_[next], chains_[chain_of_[next]].edges.front() == next};
                if (seen[2 * use.chain + (use.is_forward ? 0 : 1)]) break;
            }
            if (!loop.empty()) all[g].push_back(std::move(loop));
        }
        return all;
    }

    Part build() {
        Part part;
        // Where chains have vanished, their ends are one vertex.
        cda::DisjointSets same(vertices_.size());
        for (const Chain& chain : chains_) {
            if (chain.has_vanished) same.unite(chain.from, chain.to);
        }
        for (const Vertex& v : vertices_)
            part.vertices.push_back(v.at);
        for (const Chain& chain : chains_)
            part.edges.push_back({same.find(chain.from), same.find(chain.to), chain.curve});
        auto all = loops();
        std::vector<std::uint32_t> group_of_face;
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            if (all[g].empty()) {
                vanish(g);
                continue;
            }
            Face face;
            face.surface = surface_of(g);
            face.loops = std::move(all[g]);
            name(face, g);
            face.is_facet = is_facet(g);
            face.frame = frame_for(part, face);
            if (std::holds_alternative<Plane>(face.surface.form)) outline_first(part, face);
            part.faces.push_back(std::move(face));
            group_of_face.push_back(g);
        }
        if (!failed_.empty()) return part;
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            const std::uint32_t g = group_of_face[f];
            const Measure m = measure(part, part.faces[f], part.faces[f].frame.origin);
            if (2.0 * std::abs(m.area) < kNoWidth * m.length) vanish(g);
        }
        // Before they have gone, they are folds of their neighbours.
        if (!failed_.empty()) return part;
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            const std::uint32_t g = group_of_face[f];
            double error = 0.0;
            if (is_facet(g)) error = error_of(g);
            for (const auto& [n, shared] : neighbours_[g]) {
                if (is_facet(n)) error = std::max(error, error_of(n));
            }
            const double tolerance = error > 0.0 ? 1.5 * kBesideFacets * error : kTouchMm;
            double& miss = error > 0.0 ? part.facet_miss_mm : part.miss_mm;
            if (faults_of(part, f, tolerance, miss).empty()) continue;
            std::vector<std::uint32_t> around{g};
            // A plane is right as a rule; what meets it is not.
            if (!groups_[g].is_analytic || std::holds_alternative<Plane>(form_of(g))) {
                for (const auto& [n, shared] : neighbours_[g])
                    around.push_back(n);
            }
            failed_.push_back(std::move(around));
        }
        return part;
    }

    // A group without a width on the true surfaces.
    void vanish(std::uint32_t g) {
        std::vector<std::uint32_t> around{g};
        if (!groups_[g].is_analytic) {
            for (const auto& [n, shared] : neighbours_[g])
                around.push_back(n);
        }
        failed_.push_back(std::move(around));
    }

    void name(Face& face, std::uint32_t g) const {
        for (const std::uint32_t i : groups_[g].facets) {
            const auto& of = origins_[facets_[i].face];
            face.origins.insert(face.origins.end(), of.begin(), of.end());
        }
        std::sort(face.origins.begin(), face.origins.end());
        face.origins.erase(std::unique(face.origins.begin(), face.origins.end()),
                           face.origins.end());
        face.origin = face.origins.empty() ? cda::kStockOrigin : face.origins.front();
    }

    // The loop around all others is the one with the largest area.
    static void outline_first(const Part& part, Face& face) {
        std::size_t best = 0;
        double largest = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < face.loops.size(); ++i) {
            Face alone = face;
            alone.loops = {face.loops[i]};
            const double area = measure(part, alone, face.frame.origin).area;
            if (area <= largest) continue;
            largest = area;
            best = i;
        }
        std::swap(face.loops[0], face.loops[best]);
        face.frame = frame_for(part, face);
    }

    // --- 5. Check ---

    bool has_the_volume(const Part& part) const {
        const Vec3 apex = point(edges_.front().from);
        double analytic = 0.0, polyhedral = 0.0, slack = 0.0;
        for (const Face& face : part.faces)
            analytic += measure(part, face, apex).volume;
        for (const Facet& facet : facets_) {
            polyhedral += dot(facet.centroid - apex, facet.normal) * facet.area / 3.0;
            slack += facet.area * (1.5 * facet.error_mm + kFlat);
        }
        return std::abs(analytic - polyhedral) <= slack;
    }

    // Of the tools that round off what is small, mm.
    static constexpr double kLargeRadius = 5.0;
    static constexpr double kApexReach = 0.3;  // mm
    // In errors of theirs: how far edges of facets may be off the faces beside them.
    static constexpr double kBesideFacets = 1.6;

    const cda::Boundary& boundary_;
    const std::vector<std::vector<cda::Origin>>& origins_;
    SurfaceSet surfaces_;
    std::vector<Facet> facets_;
    std::vector<HalfEdge> edges_;
    bool broken_ = false;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> group_of_;                      // of each facet
    std::vector<std::map<std::uint32_t, double>> neighbours_;  // of each group: how long they meet
    std::vector<Vertex> vertices_;
    std::unordered_map<std::uint32_t, std::uint32_t> vertex_of_;  // by corner of the boundary
    std::vector<Chain> chains_;
    std::vector<std::uint32_t> chain_of_;             // of each half-edge
    std::vector<std::vector<std::uint32_t>> failed_;  // groups around what went wrong
};

// Adds what `from` has to `to`; the numbers of its faces there. Vertices and edges that are not
// used stay behind.
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

std::vector<std::vector<std::uint32_t>> shells_of(const cda::Boundary& boundary) {
    std::vector<std::vector<std::uint32_t>> shells(boundary.shells);
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        const std::uint32_t shell = boundary.faces[f].shell;
        if (shell >= shells.size()) shells.resize(std::size_t{shell} + 1);
        shells[shell].push_back(f);
    }
    return shells;
}

// One shell as it is.
Part flat_shell(const Facets& facets, const std::vector<std::uint32_t>& faces,
                const std::map<cda::Origin, Source>& sources) {
    cda::Boundary only;
    only.vertices = facets.boundary.vertices;
    std::vector<std::vector<cda::Origin>> of;
    for (const std::uint32_t f : faces) {
        only.faces.push_back(facets.boundary.faces[f]);
        only.faces.back().shell = 0;
        of.push_back(facets.origins[f]);
    }
    only.shells = 1;
    Part part = faceted(only, of);
    keep_apart(part);
    for (Face& face : part.faces) {
        face.is_facet = std::ranges::any_of(face.origins, [&](cda::Origin origin) {
            const auto source = sources.find(origin);
            return source != sources.end() && !source->second.candidates.empty();
        });
    }
    return part;
}

}  // namespace

Recognised recognise(const Facets& facets, const std::map<cda::Origin, Source>& sources,
                     const std::function<Facets()>& kept) {
    Recognised result;
    const auto shells = shells_of(facets.boundary);
    std::optional<Facets> flat;
    std::vector<std::vector<std::uint32_t>> flat_shells;
    const auto add = [&](std::uint32_t s) {
        if (auto part = ShellRecogniser(facets.boundary, facets.origins, sources, shells[s])())
            return append(result.part, *part);
        ++result.shells_kept;
        if (!flat) {
            flat = kept();
            flat_shells = shells_of(flat->boundary);
        }
        const bool is_there = s < flat_shells.size() && !flat_shells[s].empty();
        return append(result.part, is_there ? flat_shell(*flat, flat_shells[s], sources)
                                            : flat_shell(facets, shells[s], sources));
    };
    for (const Nesting& nesting : nesting_of(facets.boundary)) {
        Solid solid{add(nesting.outside), {}};
        for (const std::uint32_t s : nesting.voids)
            solid.voids.push_back(add(s));
        result.part.solids.push_back(std::move(solid));
    }
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
