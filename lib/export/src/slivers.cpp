// SPDX-License-Identifier: GPL-3.0-or-later
//
// A low triangle has a short edge (a needle), or its corners lie on one line almost, with one
// between the two others (a cap). Needles vanish with their edge, shortest first, where the surface
// stays a manifold (the link condition: Dey, Edelsbrunner, Guha, Nekhayev, Topology Preserving Edge
// Contraction, 1999). Caps vanish by an edge flip: the neighbour across the longest edge is cut in
// two at the corner opposite (Botsch and Kobbelt, A Robust Procedure to Eliminate Degenerate Faces
// from Triangle Meshes, 2001).
#include "slivers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace ncsim::exporter {

namespace {

using cda::Vec3;
using Vertex = std::uint32_t;
using Triangle = std::array<Vertex, 3>;

// Flips and contractions make room for each other. Where they chase each other around, it ends.
constexpr int kMostRounds = 20;

class Slivers {
public:
    Slivers(cda::TriangleMesh& mesh, double least)
        : mesh_(mesh),
          least_(least),
          triangles_at_(mesh.vertices.size()),
          radius_(mesh.vertices.size(), 0.0),
          is_gone_(mesh.triangles.size(), false) {
        std::vector<std::uint32_t> counts(mesh.vertices.size(), 0);
        for (const Triangle& corners : mesh.triangles) {
            for (const Vertex v : corners)
                ++counts[v];
        }
        for (Vertex v = 0; v < counts.size(); ++v)
            triangles_at_[v].reserve(counts[v]);
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (const Vertex v : mesh.triangles[t])
                triangles_at_[v].push_back(t);
        }
        for (auto& triangles : triangles_at_)
            make_set(triangles);
    }

    void run() {
        for (int round = 0; round < kMostRounds; ++round) {
            const bool contracted = contract_needles();
            if (!flip_caps() && !contracted) break;
        }
        drop_leaves();
        std::size_t kept = 0;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (is_gone_[t]) continue;
            mesh_.triangles[kept] = mesh_.triangles[t];
            mesh_.face[kept++] = mesh_.face[t];
        }
        mesh_.triangles.resize(kept);
        mesh_.face.resize(kept);
    }

private:
    static void make_set(std::vector<std::uint32_t>& numbers) {
        std::sort(numbers.begin(), numbers.end());
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    }

    double length(Vertex a, Vertex b) const {
        return cda::norm(mesh_.vertices[b] - mesh_.vertices[a]);
    }

    bool contract_needles() {
        std::vector<std::pair<double, std::pair<Vertex, Vertex>>> edges;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (is_gone_[t]) continue;
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
        return changed;
    }

    std::vector<std::uint32_t> with_both(Vertex a, Vertex b) const {
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

    // Corners of the part have more than those on its edges, these more than others.
    std::size_t faces_at(Vertex v) const {
        std::vector<std::uint32_t> faces;
        for (const std::uint32_t t : triangles_at_[v])
            faces.push_back(mesh_.face[t]);
        make_set(faces);
        return faces.size();
    }

    // `gone` becomes `kept`, if that changes nothing but lengths.
    bool contract(Vertex gone, Vertex kept, double far) {
        if (triangles_at_[gone].empty() || triangles_at_[kept].empty()) return false;
        if (faces_at(gone) > faces_at(kept)) std::swap(gone, kept);
        if (radius_[gone] + far > 2.0 * least_) std::swap(gone, kept);
        if (radius_[gone] + far > 2.0 * least_) return false;

        const std::vector<std::uint32_t> both = with_both(gone, kept);
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
            take_out(t);
        for (const std::uint32_t t : triangles_at_[gone]) {
            std::replace(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), gone, kept);
            triangles_at_[kept].push_back(t);
        }
        make_set(triangles_at_[kept]);
        triangles_at_[gone].clear();
        radius_[kept] = std::max(radius_[kept], radius_[gone] + far);
        return true;
    }

    void take_out(std::uint32_t t) {
        is_gone_[t] = true;
        for (const Vertex v : mesh_.triangles[t])
            std::erase(triangles_at_[v], t);
    }

    struct Cap {
        double base = 0.0;  // length of the longest edge
        bool is_low = false;
        Vertex from = 0, to = 0, opposite = 0;  // the longest edge, and the corner opposite
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
        result.is_low = doubled_area(t) < least_ * result.base;
        return result;
    }

    bool flip_caps() {
        std::vector<std::pair<double, std::uint32_t>> caps;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (is_gone_[t]) continue;
            if (const Cap found = cap(t); found.is_low) caps.emplace_back(-found.base, t);
        }
        // Longest first: a cap upon a longer one waits until that one is gone.
        std::sort(caps.begin(), caps.end());
        bool changed = false;
        for (const auto& [base, t] : caps)
            changed |= flip(t);
        return changed;
    }

    bool flip(std::uint32_t t) {
        const Cap low = cap(t);
        if (is_gone_[t] || !low.is_low) return false;
        // A needle whose edge could not be contracted.
        if (length(low.from, low.opposite) < least_ || length(low.opposite, low.to) < least_)
            return false;
        const std::vector<std::uint32_t> both = with_both(low.from, low.to);
        if (both.size() != 2) return false;
        const std::uint32_t other = both[0] == t ? both[1] : both[0];
        const Cap across = cap(other);
        if (across.is_low && across.base > low.base) return false;
        Vertex tip = 0;
        for (const Vertex v : mesh_.triangles[other]) {
            if (v != low.from && v != low.to) tip = v;
        }
        if (tip == low.opposite || !with_both(tip, low.opposite).empty()) return false;
        mesh_.face[t] = mesh_.face[other];
        set(t, {low.from, tip, low.opposite}, low.to);
        set(other, {tip, low.to, low.opposite}, low.from);
        return true;
    }

    bool has(std::uint32_t t, Vertex v) const {
        const Triangle& corners = mesh_.triangles[t];
        return std::find(corners.begin(), corners.end(), v) != corners.end();
    }

    double doubled_area(std::uint32_t t) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return cda::norm(cda::cross(mesh_.vertices[b] - mesh_.vertices[a],
                                    mesh_.vertices[c] - mesh_.vertices[a]));
    }

    // The triangle loses a corner and wins another.
    void set(std::uint32_t t, Triangle corners, Vertex lost) {
        mesh_.triangles[t] = corners;
        std::erase(triangles_at_[lost], t);
        for (const Vertex v : corners) {
            auto& at = triangles_at_[v];
            const auto place = std::lower_bound(at.begin(), at.end(), t);
            if (place == at.end() || *place != t) at.insert(place, t);
        }
    }

    // What is left of a shell that was smaller than `least_`: two triangles, back to back.
    void drop_leaves() {
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
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
                take_out(s);
        }
    }

    cda::TriangleMesh& mesh_;
    double least_;
    std::vector<std::vector<std::uint32_t>> triangles_at_;  // ascending
    std::vector<double> radius_;                            // farthest vertex that became this one
    std::vector<bool> is_gone_;
};

}  // namespace

void remove_slivers(cda::TriangleMesh& mesh, double least_mm) {
    if (least_mm > 0.0) Slivers(mesh, least_mm).run();
}

}  // namespace ncsim::exporter
