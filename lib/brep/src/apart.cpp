// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/apart.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

constexpr double kShort = 3e-7, kLeast = 1e-5;  // mm
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using Numbers = std::vector<std::uint32_t>;

void make_set(Numbers& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

Numbers common(const Numbers& a, const Numbers& b) {
    Numbers both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

double length_of(const Part& part, const Edge& edge) {
    return cda::norm(part.vertices[edge.to] - part.vertices[edge.from]);
}

// Makes points of edges, where that changes nothing but lengths (the link condition: Dey,
// Edelsbrunner, Guha, Nekhayev, Topology Preserving Edge Contraction, 1999): what is beside such an
// edge on both sides is all that its ends have in common.
class Contraction {
public:
    explicit Contraction(Part& part)
        : part_(part),
          faces_at_(part.vertices.size()),
          edges_at_(part.vertices.size()),
          radius_(part.vertices.size(), 0.0) {
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            for (const Loop& loop : part.faces[f].loops) {
                for (const EdgeUse& use : loop) {
                    const Edge& edge = part.edges[use.edge];
                    for (const std::uint32_t v : {edge.from, edge.to}) {
                        faces_at_[v].push_back(f);
                        edges_at_[v].push_back(use.edge);
                    }
                }
            }
        }
        for (auto* at : {&faces_at_, &edges_at_}) {
            for (Numbers& numbers : *at)
                make_set(numbers);
        }
    }

    void contract(std::uint32_t number) {
        const Edge short_one = part_.edges[number];
        const std::uint32_t kept = short_one.from, gone = short_one.to;
        if (kept == gone) return;
        const double radius = radius_[gone] + length_of(part_, short_one);
        if (radius > 2.0 * kLeast) return;
        const Numbers sides = common(faces_at_[kept], faces_at_[gone]);
        if (sides.size() != 2) return;
        Numbers tips;
        for (const std::uint32_t f : sides) {
            if (!is_simple_at(part_.faces[f], number, gone)) return;
            if (is_triangle(part_.faces[f])) tips.push_back(tip(part_.faces[f], short_one));
        }
        make_set(tips);
        if (common(neighbours(kept), neighbours(gone)) != tips) return;
        for (const std::uint32_t f : sides) {
            for (Loop& loop : part_.faces[f].loops)
                std::erase_if(loop, [&](const EdgeUse& use) { return use.edge == number; });
        }
        for (const std::uint32_t e : edges_at_[gone]) {
            Edge& edge = part_.edges[e];
            if (edge.from == gone) edge.from = kept;
            if (edge.to == gone) edge.to = kept;
        }
        radius_[kept] = std::max(radius_[kept], radius);
        move_to(kept, gone, faces_at_);
        move_to(kept, gone, edges_at_);
        std::erase(edges_at_[kept], number);
        for (const std::uint32_t f : sides) {
            Face& face = part_.faces[f];
            if (face.loops.front().size() < 3) {
                take_out(f);
            } else {
                face.frame = frame_for(part_, face);
            }
        }
    }

private:
    static void move_to(std::uint32_t kept, std::uint32_t gone, std::vector<Numbers>& at) {
        at[kept].insert(at[kept].end(), at[gone].begin(), at[gone].end());
        make_set(at[kept]);
        at[gone].clear();
    }

    Numbers neighbours(std::uint32_t v) const {
        Numbers all;
        for (const std::uint32_t e : edges_at_[v])
            all.push_back(part_.edges[e].from == v ? part_.edges[e].to : part_.edges[e].from);
        make_set(all);
        return all;
    }

    static bool is_triangle(const Face& face) {
        return face.loops.size() == 1 && face.loops.front().size() == 3;
    }

    std::uint32_t begin_of(const EdgeUse& use) const {
        const Edge& edge = part_.edges[use.edge];
        return use.is_forward ? edge.from : edge.to;
    }

    std::uint32_t tip(const Face& triangle, const Edge& edge) const {
        for (const EdgeUse& use : triangle.loops.front()) {
            const std::uint32_t v = begin_of(use);
            if (v != edge.from && v != edge.to) return v;
        }
        return edge.from;
    }

    // Does it have the edge, in a loop that remains one, and come to the vertex once?
    bool is_simple_at(const Face& face, std::uint32_t edge, std::uint32_t vertex) const {
        bool has_edge = false;
        int visits = 0;
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                if (use.edge == edge) has_edge = loop.size() > 3 || is_triangle(face);
                if (begin_of(use) == vertex) ++visits;
            }
        }
        return has_edge && visits == 1;
    }

    // A face with two edges, between the same vertices: its neighbours share one of them.
    void take_out(std::uint32_t f) {
        Loop& loop = part_.faces[f].loops.front();
        const EdgeUse stays = loop[0], goes = loop[1];
        const Edge edge = part_.edges[goes.edge];
        for (const std::uint32_t other : faces_at_[edge.from]) {
            if (other == f) continue;
            for (Loop& around : part_.faces[other].loops) {
                for (EdgeUse& use : around) {
                    if (use.edge != goes.edge) continue;
                    // It ran against one of them, which ran against the other.
                    use = {stays.edge, stays.is_forward};
                }
            }
        }
        loop.clear();
        for (const std::uint32_t v : {edge.from, edge.to}) {
            std::erase(faces_at_[v], f);
            std::erase(edges_at_[v], goes.edge);
        }
        part_.edges[goes.edge].to = edge.from;
    }

    Part& part_;
    std::vector<Numbers> faces_at_, edges_at_;  // of each vertex, ascending
    std::vector<double> radius_;                // how far away from each are those that became it
};

// Faces that have no edges any more.
void drop_empty(Part& part) {
    std::vector<std::uint32_t> number(part.faces.size());
    std::uint32_t count = 0;
    const auto is_empty = [](const Face& face) { return face.loops.front().empty(); };
    for (std::uint32_t f = 0; f < part.faces.size(); ++f)
        number[f] = is_empty(part.faces[f]) ? kNone : count++;
    const auto renumber = [&](Shell& shell) {
        for (std::uint32_t& f : shell)
            f = number[f];
        std::erase(shell, kNone);
    };
    for (Solid& solid : part.solids) {
        renumber(solid.outside);
        for (Shell& shell : solid.voids)
            renumber(shell);
    }
    std::erase_if(part.faces, is_empty);
}

}  // namespace

void keep_apart(Part& part) {
    std::vector<std::pair<double, std::uint32_t>> low;
    for (std::uint32_t e = 0; e < part.edges.size(); ++e) {
        const double length = length_of(part, part.edges[e]);
        if (length < kLeast) low.emplace_back(length, e);
    }
    if (low.empty()) return;
    std::sort(low.begin(), low.end());
    Contraction contraction(part);
    for (const auto& [length, edge] : low)
        contraction.contract(edge);
    drop_empty(part);
    // One may bring another one's ends nearer.
    constexpr int kPasses = 3;
    for (int pass = 0; pass < kPasses; ++pass) {
        for (const Edge& edge : part.edges) {
            Vec3 &a = part.vertices[edge.from], &b = part.vertices[edge.to];
            const double length = length_of(part, edge);
            if (length >= kShort || length == 0.0) continue;
            const Vec3 move = (0.5 * (kLeast - length) / length) * (b - a);
            a = a - move;
            b = b + move;
        }
    }
}

}  // namespace ncsim::brep
