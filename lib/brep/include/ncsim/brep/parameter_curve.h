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
};

/// Surface of a face with the parameters of ISO 10303-42: radians about the axis and mm along it
/// (cylinders, cones, extrusions), two angles in radians (spheres, tori; spindles from the lower
/// tip), or those of a patch.
class ParameterSurface {
public:
    /// Returns nothing for planes, on which readers need no help, and for half ramps.
    /// `patch` is patch_of() for forms that files store as splines, otherwise null.
    static std::optional<ParameterSurface> of(const Part& part, const Face& face,
                                              std::shared_ptr<const Patch> patch);

    /// Returns the curve of an edge, within 7e-8 mm or 1.0001 times (on patches 1.5 times) the
    /// distance of the edge from the surface. Nothing if the edge is a parameter line that readers
    /// find without error (lines on cylinders and cones, circles about the axis), if it touches a
    /// pole or an apex, if it is off the surface by more than programs round (2e-6 mm on cones and
    /// patches), or if no curve is as near as that.
    std::optional<ParameterCurve> curve_of(const Part& part, const Edge& edge) const;

private:
    using Place = Vec2;
    // A point with the derivatives by both parameters.
    struct Point {
        Vec3 at, by_u, by_v;
    };
    class FileCurve;
    class Fitter;

    ParameterSurface(Form form, Frame frame, std::shared_ptr<const Patch> patch)
        : form_(std::move(form)), frame_(frame), patch_(std::move(patch)) {}

    Point point(Place place) const;
    // Returns the largest distance of an edge that has a curve, mm.
    double farthest() const;
    std::optional<Place> first_place(Vec3 p) const;
    // Returns the place nearest to `p`, from a place nearby.
    std::optional<Place> place(Vec3 p, Place nearby) const;

    Form form_;
    Frame frame_;
    std::shared_ptr<const Patch> patch_;
};

}  // namespace ncsim::brep
