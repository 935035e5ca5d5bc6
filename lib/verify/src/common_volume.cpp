// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volume of an intersection in three steps:
//
//  1. For every pair of triangles from different surfaces, find the points where edges of either
//     triangle cross the opposite triangle. There are two points or none; between two points lies a
//     segment of both faces.
//  2. Decide for each corner whether the corner is inside the opposite body: by a query for a
// corner
//     of each connected surface, then by counting crossings along the edges.
//  3. Compute the area of every face within the opposite body from the outline of this area, and
// the
//     volume under the area.
#include "common_volume.h"

#include "ncsim/base/triangle_tree.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace ncsim::verify {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Coincidence {};  // thrown and caught in this file: a case that general position excludes

int side(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const auto point = [](Vec3 v) { return Kernel::Point_3(v.x, v.y, v.z); };
    const auto sign = CGAL::orientation(point(a), point(b), point(c), point(d));
    if (sign == CGAL::ZERO) throw Coincidence{};
    return sign == CGAL::POSITIVE ? 1 : -1;
}

// Returns +1 if the segment from `p` to `q` leaves through the front of the triangle (along the
// normal), -1 if the segment enters there, 0 without a crossing.
int passes(Vec3 p, Vec3 q, const TriangleCorners& t) {
    const int before = side(t[0], t[1], t[2], p);
    if (before == side(t[0], t[1], t[2], q)) return 0;
    const int first = side(p, q, t[0], t[1]);
    if (side(p, q, t[1], t[2]) != first || side(p, q, t[2], t[0]) != first) return 0;
    // The normal points to CGAL's positive side.
    return before < 0 ? 1 : -1;
}

double height(Vec3 p, const TriangleCorners& t) {
    return dot(p - t[0], cross(t[1] - t[0], t[2] - t[0]));
}

bool is_flat(const TriangleCorners& t) {
    const auto point = [](Vec3 v) { return Kernel::Point_3(v.x, v.y, v.z); };
    return CGAL::collinear(point(t[0]), point(t[1]), point(t[2]));
}

// Surface with the crossings with the opposite surface.
class Surface {
public:
    Surface(const TriangleMesh& mesh, Vec3 shift) : mesh_(mesh) {
        for (Vec3& v : mesh_.vertices)
            v = v + shift;
        tree_.emplace(mesh_);
        faces_.resize(mesh_.triangles.size());
        for (std::uint32_t t = 0; t < faces_.size(); ++t)
            faces_[t].flat = is_flat(corners_of(mesh_, t));
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    std::uint32_t size() const { return static_cast<std::uint32_t>(faces_.size()); }
    bool is_flat_at(std::uint32_t t) const { return faces_[t].flat; }
    TriangleCorners corners(std::uint32_t t) const { return corners_of(mesh_, t); }
    const TriangleTree& tree() const { return *tree_; }

    // Appends the crossings of the edges of face `t` with a triangle of the opposite surface to
    // `ends`.
    void cross_edges(std::uint32_t t, const TriangleCorners& other, std::vector<Vec3>& ends) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [from, to] = edge(t, k);
            const Vec3 a = mesh_.vertices[from], b = mesh_.vertices[to];
            const int out = passes(a, b, other);
            if (out == 0) continue;
            const double ha = height(a, other), hb = height(b, other);
            const double at = ha != hb ? std::clamp(ha / (ha - hb), 0.0, 1.0) : 0.5;
            Edge& e = faces_[t].edges[k];
            e.inside += out * at;
            e.odd = !e.odd;
            ends.push_back(a + at * (b - a));
        }
    }

    // Adds the segment from `p` to `q`, with the inside of the opposite body on the left.
    void add_segment(std::uint32_t t, Vec3 p, Vec3 q) {
        faces_[t].outline = faces_[t].outline + cross(p, q);
    }

    // Step 2.
    void add_corners(const Surface& other) {
        std::vector<std::vector<std::uint32_t>> at(mesh_.vertices.size());  // faces at each vertex
        for (std::uint32_t t = 0; t < size(); ++t) {
            for (const std::uint32_t v : mesh_.triangles[t])
                at[v].push_back(t);
        }
        std::vector<bool> known(mesh_.vertices.size(), false);
        inside_.assign(mesh_.vertices.size(), false);
        std::vector<std::uint32_t> open;
        for (std::uint32_t start = 0; start < known.size(); ++start) {
            if (known[start] || at[start].empty()) continue;
            known[start] = true;
            inside_[start] = other.encloses(mesh_.vertices[start]);
            open.assign(1, start);
            while (!open.empty()) {
                const std::uint32_t v = open.back();
                open.pop_back();
                for (const std::uint32_t t : at[v]) {
                    if (faces_[t].flat) continue;
                    for (std::size_t k = 0; k < 3; ++k) {
                        const auto [from, to] = edge(t, k);
                        if (from != v && to != v) continue;
                        const std::uint32_t next = from == v ? to : from;
                        if (known[next]) continue;
                        known[next] = true;
                        inside_[next] = inside_[v] != faces_[t].edges[k].odd;
                        open.push_back(next);
                    }
                }
            }
        }
    }

    // Step 3: returns three times the volume under the faces, as seen from the origin.
    double volume() const {
        double sum = 0.0;
        for (std::uint32_t t = 0; t < size(); ++t) {
            const Face& face = faces_[t];
            if (face.flat) continue;
            const TriangleCorners c = corners(t);
            const Vec3 normal = normalized(cross(c[1] - c[0], c[2] - c[0]));
            Vec3 outline = face.outline;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [from, to] = edge(t, k);
                const Vec3 a = mesh_.vertices[from];
                const Vec3 whole = cross(a, mesh_.vertices[to]);
                const double part = face.edges[k].inside + (inside_[to] ? 1.0 : 0.0);
                outline = outline + ((from == mesh_.triangles[t][k] ? part : -part) * whole);
            }
            sum += dot(normal, c[0]) * 0.5 * dot(normal, outline);
        }
        return sum;
    }

private:
    struct Edge {
        // sum of leaving minus entering positions on the edge, as fractions of the length
        double inside = 0.0;
        bool odd = false;  // number of crossings is odd
    };
    struct Face {
        std::array<Edge, 3> edges;
        Vec3 outline;  // Σ p × q over all segments
        bool flat = false;
    };

    // Returns the same vertex order for both faces at the edge, so both compute identical
    // crossings.
    std::pair<std::uint32_t, std::uint32_t> edge(std::uint32_t t, std::size_t k) const {
        const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        return {std::min(a, b), std::max(a, b)};
    }

    // Decides exactly, by the crossings of a segment to the outside.
    bool encloses(Vec3 p) const {
        Box all;
        for (const Vec3& v : mesh_.vertices)
            all.add(v);
        if (!all.contains(p)) return false;
        const Vec3 size = all.size();
        const Vec3 far = all.max + Vec3{1.0 + 0.71 * size.x, 2.0 + 1.31 * size.y, 3.0 + size.z};
        bool in = false;
        tree_->visit([&](const Box& box) { return meets_segment(box, p, far); },
                     [&](std::uint32_t t) {
                         if (!faces_[t].flat && passes(p, far, corners(t)) != 0) in = !in;
                     });
        return in;
    }

    TriangleMesh mesh_;
    std::optional<TriangleTree> tree_;
    std::vector<Face> faces_;
    std::vector<bool> inside_;
};

// Executes step 1 for a pair of triangles.
void find_contact(Surface& a, std::uint32_t t, Surface& b, std::uint32_t s,
                  std::vector<Vec3>& ends) {
    const TriangleCorners in_a = a.corners(t), in_b = b.corners(s);
    ends.clear();
    a.cross_edges(t, in_b, ends);
    b.cross_edges(s, in_a, ends);
    if (ends.empty()) return;
    if (ends.size() != 2) throw Coincidence{};
    const Vec3 along = cross(cross(in_a[1] - in_a[0], in_a[2] - in_a[0]),
                             cross(in_b[1] - in_b[0], in_b[2] - in_b[0]));
    if (dot(ends[1] - ends[0], along) < 0.0) std::swap(ends[0], ends[1]);
    a.add_segment(t, ends[0], ends[1]);
    b.add_segment(s, ends[1], ends[0]);
}

double volume_in_common(const TriangleMesh& mesh_a, const TriangleMesh& mesh_b, Vec3 centre,
                        Vec3 shift) {
    Surface a(mesh_a, -centre), b(mesh_b, shift - centre);
    std::vector<Vec3> ends;
    for (std::uint32_t t = 0; t < a.size(); ++t) {
        if (a.is_flat_at(t)) continue;
        Box box;
        for (const Vec3& corner : a.corners(t))
            box.add(corner);
        b.tree().visit([&](const Box& other) { return box.overlaps(other); },
                       [&](std::uint32_t s) {
                           if (!b.is_flat_at(s)) find_contact(a, t, b, s, ends);
                       });
    }
    a.add_corners(b);
    b.add_corners(a);
    return (a.volume() + b.volume()) / 3.0;
}

}  // namespace

std::optional<double> common_volume(const TriangleMesh& a, const TriangleMesh& b) {
    Box box;
    for (const Vec3& v : a.vertices)
        box.add(v);
    if (box.is_empty() || b.triangles.empty()) return 0.0;
    constexpr double kShift = 1e-10;  // mm
    Vec3 direction{0.7390851, 0.5671433, 0.3678794};
    for (int attempt = 0; attempt < 4; ++attempt) {
        try {
            return std::max(0.0, volume_in_common(a, b, box.centre(), kShift * direction));
        } catch (const Coincidence&) {
            direction = {direction.y + 0.113, -direction.z, direction.x - 0.057};
        }
    }
    return std::nullopt;
}

}  // namespace ncsim::verify
