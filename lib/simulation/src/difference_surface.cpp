// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the surface of a difference. A point just below a face of the part belongs to the
// difference if the common material does not contain the point.
#include "difference_surface.h"

#include "ncsim/base/triangle_tree.h"
#include "ncsim/cda/triangulate.h"

#include "clip_to_box.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ncsim::simulation {

namespace {

// Depth of the queries below a face, mm: beyond the rounding of vertices.
constexpr double kDepth = 1e-4;

// Directions to the eye of kAxisViews.
constexpr std::array<Vec3, kAxisViews.size()> kToEye{
    {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}}};

Vec3 centre_of(std::span<const Vec3> polygon) {
    Vec3 sum;
    for (const Vec3& p : polygon)
        sum = sum + p;
    return (1.0 / static_cast<double>(polygon.size())) * sum;
}

}  // namespace

DifferenceSurface::DifferenceSurface(const Simulation& part, const cda::Boundary& boundary,
                                     const cda::WorkpieceModel& common)
    : part_(part), boundary_(boundary), common_(common), mesh_(cda::triangulate(boundary)) {}

// Returns the centre, or a point between the centre and a corner, if the material below the point
// belongs to the difference.
std::optional<Vec3> DifferenceSurface::exposed_point(std::span<const Vec3> polygon, Vec3 normal) {
    const Vec3 centre = centre_of(polygon);
    const auto is_difference = [&](Vec3 point) {
        if (queries_ >= kMostQueries) return false;
        ++queries_;
        point = point - kDepth * normal;
        return !common_.contains(point) && part_.part->contains(point);
    };
    if (is_difference(centre)) return centre;
    constexpr double kTowardsCorner = 0.8;
    for (const Vec3& corner : polygon) {
        const Vec3 point = centre + kTowardsCorner * (corner - centre);
        if (is_difference(point)) return point;
    }
    return std::nullopt;
}

DifferenceSurface::Found DifferenceSurface::find_in(const Box& box, SeenAreas& seen) {
    Found result;
    // The box holds positions of the tool, whose rounding may leave faces of the region outside.
    const Vec3 margin{kDepth, kDepth, kDepth};
    const Box grown{box.min - margin, box.max + margin};
    std::set<cda::Origin> origins;
    double largest = 0.0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const TriangleCorners corners = corners_of(mesh_, t);
        Box around;
        for (const Vec3& corner : corners)
            around.add(corner);
        if (!around.overlaps(grown)) continue;
        const std::vector<Vec3> polygon = clip_to_box({corners.begin(), corners.end()}, grown);
        const double area = area_of_polygon(polygon);
        if (area <= 0.0) continue;
        const cda::BoundaryFace& face = boundary_.faces[mesh_.face[t]];
        const std::optional<Vec3> point = exposed_point(polygon, face.normal);
        if (!point) continue;
        for (std::size_t i = 0; i < kToEye.size(); ++i)
            seen[i] += area * std::max(0.0, dot(face.normal, kToEye[i]));
        origins.insert(face.origin);
        if (area > largest) result.point = point;
        largest = std::max(largest, area);
    }
    add_lines(origins, result);
    return result;
}

void DifferenceSurface::add_lines(const std::set<cda::Origin>& origins, Found& result) const {
    for (const cda::Origin origin : origins) {
        const auto number = static_cast<std::size_t>(origin);
        if (number <= earlier_origins(part_.history.get())) {
            result.has_stock = true;
            continue;
        }
        const verify::Place& place = part_.cuts.at(number).place;
        result.lines.push_back({place.file, place.span.line, place.span.line});
    }
    result.lines = verify::merged(std::move(result.lines));
}

}  // namespace ncsim::simulation
