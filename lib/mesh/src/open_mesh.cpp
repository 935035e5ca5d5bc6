// SPDX-License-Identifier: GPL-3.0-or-later
//
// 1. Divide each triangle that meets the plane. Adjacent triangles share the point on their edge.
// 2. Join the cuts of the triangles to closed loops. 3. Triangulate the region in the loops.
#include "ncsim/mesh/open_mesh.h"

#include "ncsim/cda/triangulate.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace ncsim::mesh {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Distance within which a point counts as behind the plane, mm.
constexpr double kInPlane = 1e-6;

class Opening {
public:
    Opening(const TriangleMesh& mesh, std::uint32_t faces, const CutPlane& plane)
        : mesh_(mesh), faces_(faces), plane_(plane) {
        result_.mesh.vertices = mesh.vertices;
        heights_.reserve(mesh.vertices.size());
        for (const Vec3& p : mesh.vertices)
            heights_.push_back(dot(plane.normal, p) - plane.offset);
    }

    OpenMesh run() {
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
            divide(t);
        if (!next_.empty()) close();
        return std::move(result_);
    }

private:
    bool is_removed(std::uint32_t v) const { return heights_[v] > kInPlane; }

    // Returns the number of the point in which the edge meets the plane.
    std::uint32_t point_on(std::uint32_t a, std::uint32_t b) {
        const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(a, b);
        const auto vertices = static_cast<std::uint32_t>(result_.mesh.vertices.size());
        const auto [known, is_new] = points_.try_emplace(edge, vertices);
        if (is_new) {
            const auto [from, to] = edge;
            const double t = heights_[from] / (heights_[from] - heights_[to]);
            result_.mesh.vertices.push_back(mesh_.vertices[from] +
                                            t * (mesh_.vertices[to] - mesh_.vertices[from]));
        }
        return known->second;
    }

    void add(const Triangle& corners, std::uint32_t t) {
        result_.mesh.triangles.push_back(corners);
        result_.mesh.face.push_back(mesh_.face[t]);
        result_.old_triangle.push_back(t);
    }

    void divide(std::uint32_t t) {
        const Triangle& corners = mesh_.triangles[t];
        std::size_t removed = 0;
        for (const std::uint32_t v : corners)
            removed += is_removed(v) ? 1 : 0;
        if (removed == 3) return;
        if (removed == 0) return add(corners, t);
        // The corner that is alone on its side of the plane.
        std::size_t alone = 0;
        while (is_removed(corners[alone]) != (removed == 1))
            ++alone;
        const std::uint32_t a = corners[alone], b = corners[(alone + 1) % 3];
        const std::uint32_t c = corners[(alone + 2) % 3];
        const std::uint32_t ab = point_on(a, b), ca = point_on(c, a);
        if (removed == 2) {
            add({a, ab, ca}, t);
            next_[ca] = ab;
        } else {
            add({ab, b, c}, t);
            add({ab, c, ca}, t);
            next_[ab] = ca;
        }
    }

    // Adds the triangles of the cut.
    void close() {
        cda::Boundary cut;
        cut.vertices = std::move(result_.mesh.vertices);
        cda::BoundaryFace& face = cut.faces.emplace_back();
        face.normal = plane_.normal;
        face.offset = plane_.offset;
        while (!next_.empty()) {
            std::vector<std::uint32_t>& loop = face.loops.emplace_back();
            for (auto at = next_.begin(); at != next_.end();) {
                loop.push_back(at->first);
                const std::uint32_t next = at->second;
                next_.erase(at);
                at = next_.find(next);
            }
        }
        TriangleMesh cap = cda::triangulate(cut);
        result_.mesh.vertices = std::move(cap.vertices);
        result_.mesh.triangles.insert(result_.mesh.triangles.end(), cap.triangles.begin(),
                                      cap.triangles.end());
        result_.mesh.face.resize(result_.mesh.triangles.size(), faces_);
    }

    const TriangleMesh& mesh_;
    std::uint32_t faces_;
    const CutPlane& plane_;
    std::vector<double> heights_;  // of the vertices above the plane, mm
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> points_;  // by edge
    std::map<std::uint32_t, std::uint32_t> next_;  // end of the cut that starts at a point
    OpenMesh result_;
};

}  // namespace

OpenMesh open_mesh(const TriangleMesh& mesh, std::uint32_t faces, const CutPlane& plane) {
    return Opening(mesh, faces, plane).run();
}

}  // namespace ncsim::mesh
