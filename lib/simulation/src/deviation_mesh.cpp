// SPDX-License-Identifier: GPL-3.0-or-later
//
// Halves the edges of a surface where the distance from the design is not linear.
#include "deviation_mesh.h"

#include "ncsim/base/triangle_tree.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Longest and shortest edge that is left whole or halved, as parts of the size of the part.
constexpr double kLongest = 1.0 / 60, kShortest = 1.0 / 1000;
// With more triangles, edges stay as they are. The last halving makes at most four of each.
constexpr std::size_t kManyTriangles = 60'000;
// Distances below this value count as none, mm: they are errors of rounding.
constexpr double kNone = 1e-6;

constexpr std::uint32_t kWhole = ~std::uint32_t{0};

class Halving {
public:
    Halving(const TriangleMesh& part, const Design& design)
        : design_(design.mesh), tolerance_(design.tolerance_mm), points_(part.vertices) {
        Box box;
        for (const Vec3& v : points_)
            box.add(v);
        const double size = norm(box.size());
        longest_ = kLongest * size;
        shortest_ = kShortest * size;
        for (const Vec3& v : points_)
            values_.push_back(deviation_at(v));
        triangles_ = part.triangles;
        face_ = part.face;
    }

    DeviationMesh run() {
        while (halve_once()) {
        }
        DeviationMesh result;
        result.mesh.vertices = std::move(points_);
        result.mesh.triangles = std::move(triangles_);
        result.mesh.face = std::move(face_);
        result.deviation_mm = std::move(values_);
        result.tolerance_mm = tolerance_;
        return result;
    }

private:
    double deviation_at(Vec3 point) const {
        const double distance = design_.nearest(point).distance_mm;
        if (distance < kNone) return 0.0;
        return design_.contains(point) ? -distance : distance;
    }

    // Returns the point in the middle of an edge; kWhole if the edge is not halved. The answer
    // depends on the edge alone, so that adjacent triangles fit together.
    std::uint32_t middle_of(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        const auto [known, is_new] =
            middles_.try_emplace(std::uint64_t{a} << 32U | std::uint64_t{b}, kWhole);
        if (!is_new) return known->second;
        const double length = norm(points_[b] - points_[a]);
        if (length < 2.0 * shortest_) return kWhole;
        const Vec3 middle = 0.5 * (points_[a] + points_[b]);
        const double value = deviation_at(middle);
        const bool is_linear = std::abs(value - 0.5 * (values_[a] + values_[b])) < 0.5 * tolerance_;
        if (is_linear && length < longest_) return kWhole;
        known->second = static_cast<std::uint32_t>(points_.size());
        points_.push_back(middle);
        values_.push_back(value);
        return known->second;
    }

    // Divides a triangle at the middles of its edges; false if no edge is halved.
    bool divide(const Triangle& t, std::vector<Triangle>& out) {
        std::array<std::uint32_t, 3> middle{};
        std::size_t halved = 0, first = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            middle[i] = middle_of(t[i], t[(i + 1) % 3]);
            halved += middle[i] != kWhole ? 1 : 0;
        }
        if (halved == 0) return false;
        if (halved == 3) {
            out.insert(out.end(), {{t[0], middle[0], middle[2]},
                                   {middle[0], t[1], middle[1]},
                                   {middle[2], middle[1], t[2]},
                                   {middle[0], middle[1], middle[2]}});
            return true;
        }
        // Edge `first` is halved; with two halved edges, the edge before `first` is whole.
        while (middle[first] == kWhole || (halved == 2 && middle[(first + 2) % 3] != kWhole))
            ++first;
        const std::uint32_t a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
        const std::uint32_t ab = middle[first], bc = middle[(first + 1) % 3];
        if (halved == 1) {
            out.insert(out.end(), {{a, ab, c}, {ab, b, c}});
        } else {
            out.insert(out.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
        }
        return true;
    }

    bool halve_once() {
        if (triangles_.size() > kManyTriangles) return false;
        bool has_halved = false;
        std::vector<Triangle> next;
        std::vector<std::uint32_t> face;
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            if (divide(triangles_[t], next)) {
                has_halved = true;
            } else {
                next.push_back(triangles_[t]);
            }
            face.resize(next.size(), face_[t]);
        }
        triangles_.swap(next);
        face_.swap(face);
        return has_halved;
    }

    TriangleTree design_;
    double tolerance_;
    double longest_ = 0.0, shortest_ = 0.0;  // mm
    std::vector<Vec3> points_;
    std::vector<double> values_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> face_;  // of the part, by triangle
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

}  // namespace

DeviationMesh deviation_mesh(const TriangleMesh& part, const Design& design) {
    return Halving(part, design).run();
}

}  // namespace ncsim::simulation
