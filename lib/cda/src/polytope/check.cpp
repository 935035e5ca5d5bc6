// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that surfaces are closed, and volumes of meshes.
#include "ncsim/cda/check.h"

#include "ncsim/base/mix.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ncsim::cda {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

SurfaceCheck check_edges(std::vector<Edge> edges) {
    SurfaceCheck result;
    result.edges = edges.size();
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i > 0 && edges[i] == edges[i - 1]) ++result.repeated_edges;
        const Edge back{edges[i].second, edges[i].first};
        const auto range = std::equal_range(edges.begin(), edges.end(), back);
        if (range.second - range.first != 1) ++result.unpaired_edges;
    }
    return result;
}

// Returns twice the area vector of a loop, relative to the loop's first corner.
template <class Loop>
Vec3 double_area(const std::vector<Vec3>& vertices, const Loop& loop) {
    Vec3 sum;
    const Vec3 a = vertices[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        sum = sum + cross(vertices[loop[i]] - a, vertices[loop[i + 1]] - a);
    }
    return sum;
}

// Collects loops of boundaries and of meshes.
class Surface {
public:
    explicit Surface(const std::vector<Vec3>& vertices) : vertices_(vertices) {}
    template <class Loop>
    void add(const Loop& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            edges_.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
        }
        const Vec3 a = double_area(vertices_, loop);
        sum_ = sum_ + a;
        total_ += norm(a);
    }
    SurfaceCheck result() {
        SurfaceCheck check = check_edges(std::move(edges_));
        check.relative_area_sum = total_ > 0.0 ? norm(sum_) / total_ : 0.0;
        return check;
    }

private:
    const std::vector<Vec3>& vertices_;
    std::vector<Edge> edges_;
    Vec3 sum_;
    double total_ = 0.0;
};

}  // namespace

SurfaceCheck check(const Boundary& boundary) {
    Surface surface(boundary.vertices);
    for (const BoundaryFace& face : boundary.faces) {
        for (const auto& loop : face.loops)
            surface.add(loop);
    }
    return surface.result();
}

SurfaceCheck check(const TriangleMesh& mesh) {
    Surface surface(mesh.vertices);
    for (const auto& triangle : mesh.triangles)
        surface.add(triangle);
    return surface.result();
}

bool is_closed(const Boundary& boundary) {
    const auto hash = [](std::uint64_t a, std::uint64_t b) { return mix(0, a << 32 | b); };
    std::uint64_t sum = 0;
    for (const BoundaryFace& face : boundary.faces) {
        for (const auto& loop : face.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const std::uint32_t a = loop[i];
                const std::uint32_t b = loop[(i + 1) % loop.size()];
                if (a < b) sum += hash(a, b);
                if (a > b) sum -= hash(b, a);
            }
        }
    }
    return sum == 0;
}

double volume(const TriangleMesh& mesh) {
    Box box;
    for (const Vec3& v : mesh.vertices)
        box.add(v);
    if (box.is_empty()) return 0.0;
    const Vec3 reference = box.centre();
    double sixfold = 0.0;
    for (const auto& t : mesh.triangles) {
        sixfold += dot(mesh.vertices[t[0]] - reference,
                       cross(mesh.vertices[t[1]] - reference, mesh.vertices[t[2]] - reference));
    }
    return sixfold / 6.0;
}

}  // namespace ncsim::cda
