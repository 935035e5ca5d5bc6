// SPDX-License-Identifier: GPL-3.0-or-later
//
// A low triangle has a short edge (a needle), or its corners are nearly collinear (a cap). Needles
// vanish by contraction of their short edge, shortest first, if the surface stays a manifold (link
// condition). Caps vanish by an edge flip: the triangle across the longest edge is split at the
// opposite corner.
// Source: Dey, Edelsbrunner, Guha, Nekhayev, Topology Preserving Edge Contraction, 1999 (link
//     condition); Botsch and Kobbelt, A Robust Procedure to Eliminate Degenerate Faces from
//     Triangle Meshes, 2001 (flips).
#include "slivers.h"

#include "ncsim/base/parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::mesh {

namespace {

using Vertex = std::uint32_t;
using Triangle = std::array<Vertex, 3>;

// Flips can make contractions possible, and the reverse. The limit ends cycles.
constexpr int kMostRounds = 20;

void make_set(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

double doubled_area(const TriangleMesh& mesh, const Triangle& corners) {
    const auto& [a, b, c] = corners;
    return norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
}

// True if the triangle has an edge or a height shorter than `least`.
bool is_low(const TriangleMesh& mesh, const Triangle& corners, double least) {
    double base = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double edge = norm(mesh.vertices[corners[(i + 1) % 3]] - mesh.vertices[corners[i]]);
        if (edge < least) return true;
        base = std::max(base, edge);
    }
    return doubled_area(mesh, corners) < least * base;
}

// Triangles at each vertex, ascending: in a common array, except that changed vertices have lists
// of their own.
class TrianglesAt {
public:
    TrianglesAt(const std::vector<Triangle>& triangles, std::size_t vertices)
        : first_(vertices + 1, 0), all_(3 * triangles.size()), own_(vertices, kNone) {
        for (const Triangle& corners : triangles) {
            for (const Vertex v : corners)
                ++first_[v + std::size_t{1}];
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            for (const Vertex v : triangles[t])
                all_[next[v]++] = t;
        }
    }

    std::span<const std::uint32_t> operator[](Vertex v) const {
        if (own_[v] != kNone) return lists_[own_[v]];
        return std::span(all_).subspan(first_[v], first_[v + std::size_t{1}] - first_[v]);
    }
    std::vector<std::uint32_t>& change(Vertex v) {
        if (own_[v] == kNone) {
            const auto before = (*this)[v];
            own_[v] = static_cast<std::uint32_t>(lists_.size());
            lists_.emplace_back(before.begin(), before.end());
        }
        return lists_[own_[v]];
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> first_;  // for each vertex, start of the triangles in `all_`
    std::vector<std::uint32_t> all_;
    std::vector<std::uint32_t> own_;  // index into `lists_`; kNone: unchanged
    std::deque<std::vector<std::uint32_t>> lists_;
};

// Removes low triangles. Vertices do not move, so only triangles whose corners were replaced can
// become low.
class Slivers {
public:
    /// Requires: `low` lists the low triangles.
    Slivers(TriangleMesh& mesh, double least, std::vector<std::uint32_t> low)
        : mesh_(mesh),
          least_(least),
          low_(std::move(low)),
          triangles_at_(mesh.triangles, mesh.vertices.size()),
          radius_(mesh.vertices.size(), 0.0),
          is_gone_(mesh.triangles.size(), false) {}

    bool run() {
        for (int round = 0; round < kMostRounds; ++round) {
            const bool contracted = contract_needles();
            if (!flip_caps() && !contracted) break;
        }
        if (changed_.empty()) return false;
        drop_leaves();
        std::size_t kept = 0;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (is_gone_[t]) continue;
            mesh_.triangles[kept] = mesh_.triangles[t];
            mesh_.face[kept++] = mesh_.face[t];
        }
        mesh_.triangles.resize(kept);
        mesh_.face.resize(kept);
        return true;
    }

private:
    double length(Vertex a, Vertex b) const { return norm(mesh_.vertices[b] - mesh_.vertices[a]); }

    // Updates the list of low triangles from the touched triangles.
    void update_low_triangles() {
        low_.insert(low_.end(), touched_.begin(), touched_.end());
        changed_.insert(changed_.end(), touched_.begin(), touched_.end());
        touched_.clear();
        make_set(low_);
        std::erase_if(low_, [this](std::uint32_t t) {
            return is_gone_[t] || !is_low(mesh_, mesh_.triangles[t], least_);
        });
    }

    bool contract_needles() {
        std::vector<std::pair<double, std::pair<Vertex, Vertex>>> edges;
        for (const std::uint32_t t : low_) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Vertex a = mesh_.triangles[t][i];
                const Vertex b = mesh_.triangles[t][(i + 1) % 3];
                if (a < b && length(a, b) < least_) edges.push_back({length(a, b), {a, b}});
            }
        }
        std::sort(edges.begin(), edges.end());
        bool changed = false;
        for (const auto& [far, ends] : edges)
            changed |= contract(ends.first, ends.second, far);
        update_low_triangles();
        return changed;
    }

    std::vector<std::uint32_t> triangles_with_both(Vertex a, Vertex b) const {
        std::vector<std::uint32_t> both;
        std::set_intersection(triangles_at_[a].begin(), triangles_at_[a].end(),
                              triangles_at_[b].begin(), triangles_at_[b].end(),
                              std::back_inserter(both));
        return both;
    }

    std::vector<Vertex> neighbours(Vertex v) const {
        std::vector<Vertex> all;
        for (const std::uint32_t t : triangles_at_[v]) {
            for (const Vertex w : mesh_.triangles[t]) {
                if (w != v) all.push_back(w);
            }
        }
        make_set(all);
        return all;
    }

    // Returns the number of faces at `v`: largest for corners of the part, smaller on edges, 1
    // inside a face.
    std::size_t faces_at(Vertex v) const {
        std::vector<std::uint32_t> faces;
        for (const std::uint32_t t : triangles_at_[v])
            faces.push_back(mesh_.face[t]);
        make_set(faces);
        return faces.size();
    }

    // Contracts the edge from `gone` to `kept` if the topology does not change and no original
    // vertex moves by more than 2 least_. The roles of the two vertices may be swapped: the vertex
    // with more faces is kept if possible.
    bool contract(Vertex gone, Vertex kept, double far) {
        if (triangles_at_[gone].empty() || triangles_at_[kept].empty()) return false;
        if (faces_at(gone) > faces_at(kept)) std::swap(gone, kept);
        if (radius_[gone] + far > 2.0 * least_) std::swap(gone, kept);
        if (radius_[gone] + far > 2.0 * least_) return false;

        const std::vector<std::uint32_t> both = triangles_with_both(gone, kept);
        if (both.size() != 2) return false;
        std::vector<Vertex> tips;
        for (const std::uint32_t t : both) {
            for (const Vertex v : mesh_.triangles[t]) {
                if (v != gone && v != kept) tips.push_back(v);
            }
        }
        make_set(tips);
        const std::vector<Vertex> near_gone = neighbours(gone);
        const std::vector<Vertex> near_kept = neighbours(kept);
        std::vector<Vertex> common;
        std::set_intersection(near_gone.begin(), near_gone.end(), near_kept.begin(),
                              near_kept.end(), std::back_inserter(common));
        if (common != tips) return false;

        for (const std::uint32_t t : both)
            remove_triangle(t);
        std::vector<std::uint32_t>& at_kept = triangles_at_.change(kept);
        for (const std::uint32_t t : triangles_at_[gone]) {
            std::replace(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), gone, kept);
            at_kept.push_back(t);
            touched_.push_back(t);
        }
        make_set(at_kept);
        triangles_at_.change(gone).clear();
        radius_[kept] = std::max(radius_[kept], radius_[gone] + far);
        return true;
    }

    void remove_triangle(std::uint32_t t) {
        is_gone_[t] = true;
        for (const Vertex v : mesh_.triangles[t])
            std::erase(triangles_at_.change(v), t);
        touched_.push_back(t);
    }

    struct Cap {
        double base = 0.0;  // length of the longest edge
        bool is_low = false;
        Vertex from = 0, to = 0, opposite = 0;  // the longest edge and the opposite corner
    };
    Cap cap(std::uint32_t t) const {
        const Triangle& corners = mesh_.triangles[t];
        Cap result;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex a = corners[i];
            const Vertex b = corners[(i + 1) % 3];
            const double base = length(a, b);
            if (base > result.base) result = {base, false, a, b, corners[(i + 2) % 3]};
        }
        result.is_low = doubled_area(mesh_, corners) < least_ * result.base;
        return result;
    }

    bool flip_caps() {
        std::vector<std::pair<double, std::uint32_t>> caps;
        for (const std::uint32_t t : low_) {
            if (const Cap found = cap(t); found.is_low) caps.emplace_back(-found.base, t);
        }
        // Longest first: a cap on the base of a longer cap waits until that cap is removed.
        std::sort(caps.begin(), caps.end());
        bool changed = false;
        for (const auto& [base, t] : caps)
            changed |= flip(t);
        update_low_triangles();
        return changed;
    }

    bool flip(std::uint32_t t) {
        const Cap low = cap(t);
        if (is_gone_[t] || !low.is_low) return false;
        // The triangle is a needle whose edge could not be contracted.
        if (length(low.from, low.opposite) < least_ || length(low.opposite, low.to) < least_)
            return false;
        const std::vector<std::uint32_t> both = triangles_with_both(low.from, low.to);
        if (both.size() != 2) return false;
        const std::uint32_t other = both[0] == t ? both[1] : both[0];
        const Cap across = cap(other);
        if (across.is_low && across.base > low.base) return false;
        Vertex tip = 0;
        for (const Vertex v : mesh_.triangles[other]) {
            if (v != low.from && v != low.to) tip = v;
        }
        if (tip == low.opposite || !triangles_with_both(tip, low.opposite).empty()) return false;
        mesh_.face[t] = mesh_.face[other];
        set(t, {low.from, tip, low.opposite}, low.to);
        set(other, {tip, low.to, low.opposite}, low.from);
        return true;
    }

    bool has(std::uint32_t t, Vertex v) const {
        const Triangle& corners = mesh_.triangles[t];
        return std::find(corners.begin(), corners.end(), v) != corners.end();
    }

    // Replaces the corners of triangle `t`; `lost` is the corner that `t` no longer has.
    void set(std::uint32_t t, Triangle corners, Vertex lost) {
        mesh_.triangles[t] = corners;
        std::erase(triangles_at_.change(lost), t);
        touched_.push_back(t);
        for (const Vertex v : corners) {
            auto& at = triangles_at_.change(v);
            const auto place = std::lower_bound(at.begin(), at.end(), t);
            if (place == at.end() || *place != t) at.insert(place, t);
        }
    }

    // Removes pairs of triangles with the same corners, the remains of shells smaller than
    // `least_`.
    void drop_leaves() {
        make_set(changed_);
        for (const std::uint32_t t : changed_) {
            if (is_gone_[t]) continue;
            const auto& [a, b, c] = mesh_.triangles[t];
            std::array<std::uint32_t, 2> same{};
            std::size_t count = 0;
            for (const std::uint32_t s : triangles_at_[a]) {
                if (!has(s, b) || !has(s, c)) continue;
                if (count < 2) same[count] = s;
                ++count;
            }
            if (count != 2) continue;
            for (const std::uint32_t s : same)
                remove_triangle(s);
        }
    }

    TriangleMesh& mesh_;
    double least_;
    std::vector<std::uint32_t> low_;  // ascending
    TrianglesAt triangles_at_;
    std::vector<double> radius_;  // distance to the farthest vertex contracted into each vertex
    std::vector<bool> is_gone_;
    std::vector<std::uint32_t> touched_;  // since low_ was updated
    std::vector<std::uint32_t> changed_;  // since the start
};

}  // namespace

bool remove_slivers(TriangleMesh& mesh, double least_mm, std::size_t threads) {
    if (!(least_mm > 0.0)) return false;
    std::vector<std::uint32_t> low =
        filter_indices(threads, static_cast<std::uint32_t>(mesh.triangles.size()),
                       [&](std::uint32_t t) { return is_low(mesh, mesh.triangles[t], least_mm); });
    return !low.empty() && Slivers(mesh, least_mm, std::move(low)).run();
}

}  // namespace ncsim::mesh
