// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges in the parameters of surfaces, as files store both.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/brep/part.h"
#include "ncsim/brep/spline_surface.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// Cubic B-spline in the parameters u and v of a surface: knots of multiplicity 4 at the ends and 2
/// inside, as Spline. The parameter is that of the edge's curve in a file: mm for lines, radians
/// for circles (from the start of the edge) and ellipses (from the major axis), knots for splines.
struct ParameterCurve {
    std::vector<Vec2> points;
    std::vector<double> knots;
    /// Largest distance from the edge that the fit measured, mm.
    double miss_mm = 0.0;
};

/// Moves a point of the track of an edge onto the circle of the edge, where the curve is in a file.
/// Points of other curves stay.
Vec3 point_in_file(const Track& track, Vec3 p);

/// Surface of a face with the parameters of ISO 10303-42: radians about the axis and mm along it
/// (cylinders, cones, extrusions; half ramps have 0 to 1 around), two angles in radians (spheres,
/// tori; spindles from the lower tip), or those of a patch.
class ParameterSurface {
public:
    /// Returns no value for planes, on which CAD readers need no parameter curves.
    /// `patch` is patch_of() for forms that files store as splines, otherwise null.
    static std::optional<ParameterSurface> of(const Part& part, const Face& face,
                                              std::shared_ptr<const Patch> patch);

    /// Returns the curve of an edge: within 7e-8 mm of the edge, within 3e-8 mm more than 1.0001
    /// times the distance of the edge from the surface, or, on patches, within 1.5 times that
    /// distance. No value if no curve is as near; if the edge is a parameter line that CAD readers
    /// find without error (lines on cylinders and cones, circles about the axis); if the edge
    /// touches a pole or an apex; or if the edge is off the surface by more than programs round
    /// (2e-6 mm on cones, 1e-5 mm on patches).
    std::optional<ParameterCurve> curve_of(const Part& part, const Edge& edge) const;

    /// Returns the point of the surface at `t` of a curve of it, 0 to 1 of the curve's parameter.
    Vec3 point_on(const ParameterCurve& curve, double t) const;

    /// Returns the parameter in a file of the start of the second half of an edge that is divided
    /// at `at`, 0 to 1.
    static double begin_of_rest(const Part& part, const Edge& edge, double at);

private:
    using Place = Vec2;
    // A point with the derivatives by both parameters.
    struct Point {
        Vec3 at, by_u, by_v;
    };
    class FileCurve;
    class Fitter;

    ParameterSurface(Form form, Frame frame, std::shared_ptr<const Patch> patch, bool is_half)
        : form_(std::move(form)), frame_(frame), patch_(std::move(patch)), is_half_(is_half) {}

    Point point(Place place) const;
    Point point_of_half(Place place) const;
    // Returns the largest distance of an edge that has a curve, mm.
    double farthest() const;
    std::optional<Place> first_place(Vec3 p) const;
    std::optional<Place> place_on_patch(Vec3 p) const;
    // Returns the place nearest to `p`, from a place nearby.
    std::optional<Place> place(Vec3 p, Place nearby) const;

    Form form_;
    Frame frame_;
    std::shared_ptr<const Patch> patch_;
    bool is_half_;  // Half of a ramp; the x axis of the frame is where it begins.
};

}  // namespace ncsim::brep
