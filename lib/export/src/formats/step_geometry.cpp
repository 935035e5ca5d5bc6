// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes geometry of STEP files.
#include "formats/step_geometry.h"

#include "ncsim/base/angles.h"
#include "ncsim/brep/divided_edge.h"
#include "ncsim/brep/edge_deviation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

namespace ncsim::exporter {

namespace {

// Points that are off a plane by less, mm, lie on it but for the rounding of doubles.
constexpr double kRounding = 1e-9;

struct Knots {
    Knots(const std::vector<double>& knots, int degree) {
        const std::string end = std::to_string(degree + 1);
        const std::string inner = std::to_string((degree + 1) / 2);
        for (std::size_t i = 0; i < knots.size(); ++i) {
            multiplicities += i == 0 ? '(' : ',';
            places += i == 0 ? '(' : ',';
            multiplicities += i == 0 || i + 1 == knots.size() ? end : inner;
            places += StepValue(knots[i]).text;
        }
        multiplicities += ')';
        places += ')';
    }
    std::string multiplicities, places;
};

}  // namespace

StepGeometry::StepGeometry(std::ostream& out, const brep::Part& part)
    : StepFile(out),
      part_(part),
      vertices_(part.vertices.size()),
      edges_(part.edges.size()),
      surfaces_(part.faces.size()),
      faces_of_edge_(part.edges.size(), {kNoFace, kNoFace}) {
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        for (const brep::Loop& loop : part.faces[f].loops) {
            for (const brep::EdgeUse& use : loop)
                faces_of_edge_[use.edge][use.is_forward ? 0 : 1] = f;
        }
    }
}

// Returns a shared entity for equal directions, because parts have many parallel edges.
Entity StepGeometry::direction(Vec3 v) {
    const StepValue key(v);
    Entity& made = directions_[key.text];
    if (!made) made = add("DIRECTION('',{})", {key});
    return made;
}

const StepGeometry::Vertex& StepGeometry::vertex(std::uint32_t number) {
    Vertex& v = vertices_[number];
    if (!v.vertex) {
        v.point = point(part_.vertices[number]);
        v.vertex = add("VERTEX_POINT('',{})", {v.point});
    }
    return v;
}

std::vector<Entity> StepGeometry::points(const std::vector<Vec3>& places) {
    std::vector<Entity> made;
    made.reserve(places.size());
    for (const Vec3& p : places)
        made.push_back(point(p));
    return made;
}

const std::vector<Entity>& StepGeometry::edges_of(std::uint32_t number) {
    std::vector<Entity>& made = edges_[number];
    if (!made.empty()) return made;
    const brep::Edge& e = part_.edges[number];
    const Vertex from = vertex(e.from);
    const Vertex to = vertex(e.to);
    std::vector<OnSurface> whole, first, second;
    whole.reserve(2);
    brep::EdgeDeviation deviation(part_, e);
    const auto& faces = faces_of_edge_[number];
    for (const std::uint32_t f : faces) {
        if (f == kNoFace || faces[0] == faces[1]) continue;
        const Surface& on = parameters_of(f);
        if (auto curve = on.parameters ? on.parameters->curve_of(part_, e) : std::nullopt) {
            whole.push_back({on.entity, std::move(*curve)});
            deviation.add(*on.parameters, whole.back().curve);
        } else {
            deviation.add(part_.faces[f].surface.form);
        }
    }
    const auto farthest = deviation.unmeasured_maximum();
    if (!farthest) {
        made.push_back(add_edge(part_, e, whole, from, to));
        return made;
    }
    const brep::EdgeHalves halves = brep::divide_edge(part_, e, *farthest);
    for (const OnSurface& on : whole) {
        auto curves = brep::divide_curve(on.curve, part_, e, *farthest);
        first.push_back({on.surface, std::move(curves[0])});
        second.push_back({on.surface, std::move(curves[1])});
    }
    brep::Part ends;
    ends.vertices = {part_.vertices[e.from], halves.middle, part_.vertices[e.to]};
    Vertex middle{point(halves.middle), {}};
    middle.vertex = add("VERTEX_POINT('',{})", {middle.point});
    made.push_back(add_edge(ends, {0, 1, halves.first}, first, from, middle));
    made.push_back(add_edge(ends, {1, 2, halves.second}, second, middle, to));
    return made;
}

// Adds an edge with the curves in the parameters of the adjacent surfaces. Without these curves,
// CAD readers project the edge, and Boolean operations fail because of the distance between edge
// and projection.
Entity StepGeometry::add_edge(const brep::Part& part, const brep::Edge& edge,
                              const std::vector<OnSurface>& in_parameters, const Vertex& from,
                              const Vertex& to) {
    Entity curve = curve_of(part, edge, from);
    std::vector<Entity> curves;
    curves.reserve(in_parameters.size());
    for (const OnSurface& on : in_parameters)
        curves.push_back(parameter_curve(on.surface, on.curve));
    if (!curves.empty()) curve = add("SURFACE_CURVE('',{},{},.CURVE_3D.)", {curve, curves});
    return add("EDGE_CURVE('',{},{},{},.T.)", {from.vertex, to.vertex, curve});
}

Entity StepGeometry::parameter_curve(Entity surface, const brep::ParameterCurve& curve) {
    if (!flat_context_)
        flat_context_ =
            add("(GEOMETRIC_REPRESENTATION_CONTEXT(2) PARAMETRIC_REPRESENTATION_CONTEXT() "
                "REPRESENTATION_CONTEXT('',''))");
    std::vector<Entity> points;
    points.reserve(curve.points.size());
    // Further digits are smaller than the error of the curve.
    const auto rounded = [](double x) { return std::round(1e11 * x) / 1e11; };
    for (const auto& [u, v] : curve.points)
        points.push_back(add("CARTESIAN_POINT('',({},{}))", {rounded(u), rounded(v)}));
    const Entity spline = b_spline(points, curve.knots);
    const Entity definition =
        add("DEFINITIONAL_REPRESENTATION('',({}),{})", {spline, flat_context_});
    return add("PCURVE('',{},{})", {surface, definition});
}

Entity StepGeometry::b_spline(const std::vector<Entity>& points, const std::vector<double>& at) {
    const Knots knots(at, 3);
    return add("B_SPLINE_CURVE_WITH_KNOTS('',3,{},.UNSPECIFIED.,.F.,.F.,{},{},.UNSPECIFIED.)",
               {points, knots.multiplicities, knots.places});
}

Entity StepGeometry::curve_of(const brep::Part& part, const brep::Edge& e, const Vertex& from) {
    const Vec3 start = part.vertices[e.from];
    if (const auto* const c = std::get_if<brep::Circle>(&e.curve)) {
        // The parameter of the circle is 0 at the start of the edge.
        const Vec3 out = start - c->centre;
        const Vec3 x = normalized(out - dot(out, c->axis) * c->axis);
        return add("CIRCLE('',{},{})", {placement(c->centre, c->axis, x), c->radius});
    }
    if (const auto* const c = std::get_if<brep::Ellipse>(&e.curve)) {
        return add("ELLIPSE('',{},{},{})",
                   {placement(c->centre, c->axis, c->major), c->major_radius, c->minor_radius});
    }
    if (const auto* const c = std::get_if<brep::Spline>(&e.curve))
        return b_spline(points(c->points), c->knots);
    const Vec3 along = normalized(part.vertices[e.to] - start);
    const Entity vector = add("VECTOR('',{},1.)", {direction(along)});
    return add("LINE('',{},{})", {from.point, vector});
}

const StepGeometry::Surface& StepGeometry::parameters_of(std::uint32_t number) {
    Surface& made = surfaces_[number];
    if (made.entity) return made;
    const brep::Face& face = part_.faces[number];
    std::shared_ptr<const brep::Patch> patch;
    if (brep::is_spline_in_files(face.surface.form))
        patch = std::make_shared<brep::Patch>(brep::patch_of(part_, face));
    made.entity = patch ? patch_surface(*patch) : surface_of(face);
    made.parameters = brep::ParameterSurface::of(part_, face, std::move(patch));
    return made;
}

Entity StepGeometry::surface_of(const brep::Face& face) {
    const brep::Form& any = face.surface.form;
    if (std::holds_alternative<brep::Plane>(any)) {
        // The origin of the plane is the first corner of the outline, unless that is off the plane.
        const brep::EdgeUse& use = face.loops.front().front();
        const brep::Edge& e = part_.edges[use.edge];
        const std::uint32_t corner = use.is_forward ? e.from : e.to;
        const double height = brep::distance(any, part_.vertices[corner]);
        const Entity origin = std::abs(height) < kRounding
                                  ? vertex(corner).point
                                  : point(part_.vertices[corner] - height * face.frame.axis);
        return add("PLANE('',{})", {placement(origin, face.frame.axis, face.frame.x)});
    }
    if (const auto* const form = std::get_if<brep::Cylinder>(&any))
        return add("CYLINDRICAL_SURFACE('',{},{})", {place(face.frame), form->radius});
    if (const auto* const form = std::get_if<brep::Cone>(&any)) {
        const double height = dot(face.frame.origin - form->apex, form->axis);
        return add("CONICAL_SURFACE('',{},{},{})",
                   {place(face.frame), form->slope * height, brep::half_angle_rad(*form)});
    }
    if (const auto* const form = std::get_if<brep::Sphere>(&any)) {
        return add("SPHERICAL_SURFACE('',{},{})",
                   {place(brep::frame_in_file(part_, face)), form->radius});
    }
    if (const auto* const form = std::get_if<brep::Extrusion>(&any)) {
        const auto half = brep::half_of_ramp(part_, face);
        const Entity circle = half ? half_circle(*form, *half)
                                   : add("CIRCLE('',{},{})", {place(face.frame), form->radius});
        const Entity vector = add("VECTOR('',{},1.)", {direction(form->along)});
        return add("SURFACE_OF_LINEAR_EXTRUSION('',{},{})", {circle, vector});
    }
    const auto* const form = std::get_if<brep::Torus>(&any);
    if (!form) throw std::logic_error("the form is a patch, or no face lies on it");
    if (brep::is_spindle(*form)) return spindle(*form, face.frame);
    return add("TOROIDAL_SURFACE('',{},{},{})", {place(face.frame), form->major, form->minor});
}

// Writes an exact half circle as a rational cubic.
Entity StepGeometry::half_circle(const brep::Extrusion& form, Vec3 middle) {
    const Vec3 end = form.radius * cross(form.axis, middle);
    const Vec3 out = (2.0 * form.radius) * middle;
    const Vec3 c = form.centre;
    constexpr double kThird = 1.0 / 3.0;
    return add(
        "(BOUNDED_CURVE()B_SPLINE_CURVE(3,{},.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((4,4),"
        "(0.,1.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,"
        "{},{},1.))REPRESENTATION_ITEM(''))",
        {points({c + -end, c + (out - end), c + (out + end), c + end}), kThird, kThird});
}

Entity StepGeometry::patch_surface(const brep::Patch& patch) {
    std::string rows;
    for (const auto& row : patch.net)
        rows += (rows.empty() ? "(" : ",") + StepValue(points(row)).text;
    const Knots around(patch.around, patch.degree), along(patch.along, patch.degree);
    const std::string degree = std::to_string(patch.degree);
    return add(
        "B_SPLINE_SURFACE_WITH_KNOTS('',{},{},{}),.UNSPECIFIED.,.F.,.F.,.F.,{},{},{},{},"
        ".UNSPECIFIED.)",
        {degree, degree, rows, around.multiplicities, along.multiplicities, around.places,
         along.places});
}

// Writes a spindle torus, for which CAD readers do not accept TOROIDAL_SURFACE, as a surface of
// revolution: the arc of the circle from tip to tip, rotated about the axis. The circle begins in
// the lower tip.
Entity StepGeometry::spindle(const brep::Torus& form, const brep::Frame& frame) {
    const Vec3 y = cross(frame.axis, frame.x);
    const double height =
        std::sqrt(std::max(0.0, form.minor * form.minor - form.major * form.major));
    const Vec3 down = (-1.0 / form.minor) * (form.major * frame.x + height * frame.axis);
    const Entity circle = add("CIRCLE('',{},{})",
                              {place({frame.origin + form.major * frame.x, -y, down}), form.minor});
    const Entity from = point(frame.origin - height * frame.axis);
    // If both tips coincide, a circle trimmed there would be ambiguous.
    constexpr double kLeastApart = 1e-2, kMost = 175.0;
    const auto last = sin_cos(kMost);
    const Entity to = point(height > kLeastApart * form.minor
                                ? frame.origin + height * frame.axis
                                : frame.origin + (form.major + form.minor * last.cos) * frame.x +
                                      form.minor * last.sin * frame.axis);
    const Entity half = add("TRIMMED_CURVE('',{},({}),({}),.T.,.CARTESIAN.)", {circle, from, to});
    const Entity along = direction(frame.axis);
    const Entity axis = add("AXIS1_PLACEMENT('',{},{})", {point(frame.origin), along});
    return add("SURFACE_OF_REVOLUTION('',{},{})", {half, axis});
}

}  // namespace ncsim::exporter
