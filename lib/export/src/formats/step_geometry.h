// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points, curves, edges and surfaces of a part in a STEP file.
#pragma once

#include "ncsim/brep/frames.h"
#include "ncsim/brep/parameter_curve.h"
#include "ncsim/brep/patch.h"

#include "formats/step_file.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace ncsim::exporter {

/// STEP file with the geometry of a part. Each edge, vertex, surface and direction is written once,
/// before its first use.
class StepGeometry : public StepFile {
public:
    /// Requires: `out` and `part` outlive this object.
    StepGeometry(std::ostream& out, const brep::Part& part);

    Entity point(Vec3 p) { return add("CARTESIAN_POINT('',{})", {p}); }
    /// Returns a placement at `p`, a point or the entity of a point, with the axes z and x.
    template <class Point>
    Entity placement(Point p, Vec3 z, Vec3 x);
    /// Returns the edges in the file for an edge of the part, in the same direction: a single edge,
    /// or two edges that meet where the edge of the part is farthest from the adjacent surfaces.
    const std::vector<Entity>& edges_of(std::uint32_t number);
    /// Returns the surface of a face.
    Entity surface(std::uint32_t face) { return parameters_of(face).entity; }

private:
    struct Vertex {
        Entity point, vertex;
    };
    struct Surface {
        Entity entity;
        std::optional<brep::ParameterSurface> parameters{};
    };
    Entity direction(Vec3 v);
    const Vertex& vertex(std::uint32_t number);
    const Surface& parameters_of(std::uint32_t face);
    Entity place(const brep::Frame& frame) { return placement(frame.origin, frame.axis, frame.x); }
    std::vector<Entity> points(const std::vector<Vec3>& places);

    // Curve of an edge in the parameters of a surface.
    struct OnSurface {
        Entity surface;
        brep::ParameterCurve curve;
    };
    Entity add_edge(const brep::Part& part, const brep::Edge& edge,
                    const std::vector<OnSurface>& in_parameters, const Vertex& from,
                    const Vertex& to);
    Entity parameter_curve(Entity surface, const brep::ParameterCurve& curve);
    Entity b_spline(const std::vector<Entity>& points, const std::vector<double>& at);
    Entity curve_of(const brep::Part& part, const brep::Edge& e, const Vertex& from);
    Entity surface_of(const brep::Face& face);
    Entity half_circle(const brep::Extrusion& form, Vec3 middle);
    Entity patch_surface(const brep::Patch& patch);
    Entity spindle(const brep::Torus& form, const brep::Frame& frame);

    const brep::Part& part_;
    std::vector<Vertex> vertices_;
    std::vector<std::vector<Entity>> edges_;
    std::vector<Surface> surfaces_;                       // by face
    std::unordered_map<std::string, Entity> directions_;  // by their text
    static constexpr std::uint32_t kNoFace = ~std::uint32_t{0};
    // Faces that use each edge forward and backward.
    std::vector<std::array<std::uint32_t, 2>> faces_of_edge_;
    Entity flat_context_;  // of curves in parameters
};

template <class Point>
Entity StepGeometry::placement(Point p, Vec3 z, Vec3 x) {
    if constexpr (requires { point(p); }) {
        return placement(point(p), z, x);
    } else {
        return add("AXIS2_PLACEMENT_3D('',{},{},{})", {p, direction(z), direction(x)});
    }
}

}  // namespace ncsim::exporter
