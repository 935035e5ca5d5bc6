// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces are tested on a map, on which each surface is laid out flat without a seam. Cones are seen
// along the axis; parts of cylinders and extrusions from the front, whole cylinders and tori as
// annuli; spheres in stereographic projection from the point opposite the face; coils by both
// angles as lengths; envelopes by the place across the path and the time. mm, frame W.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/brep/part.h"

#include "topology/axes.h"
#include "topology/whole_circle.h"

#include <optional>
#include <variant>

namespace ncsim::brep {

/// Map of the surface of a face.
class FaceMap {
public:
    /// Requires: `face` has its frame, and a longer lifetime than the map.
    FaceMap(const Part& part, const Face& face);

    /// Position on the map, and distance from the form, mm.
    struct Place {
        Vec2 at;
        double deviation;
    };
    Place place(Vec3 p, ProjectionSeed& seed) const;
    Vec2 operator()(Vec3 at) const;

    /// Circle on the map, and a bound of the distance of all points from the form, mm.
    struct Round {
        Vec2 centre;
        double radius, deviation;
    };
    /// Returns the image of a whole circle on the map; no value if the image is not a circle.
    /// Images are circles for all circles of a plane, and for circles about the axis of a cylinder
    /// or cone.
    std::optional<Round> round_of(const WholeCircle& circle) const;

    bool is_plane() const { return std::holds_alternative<Plane>(*form_); }
    bool is_cone() const { return std::holds_alternative<Cone>(*form_); }
    /// True if `at` is on the half of a coil's circle that leaves no surface there.
    bool is_of_other_half(Vec2 at, double tolerance_mm) const;
    /// True if straight lines are straight on the map.
    bool keeps_lines() const;

private:
    // True if the form is a cylinder in the coordinates of its axes.
    bool is_straight_up() const {
        return std::holds_alternative<Cylinder>(*form_) ||
               std::holds_alternative<Extrusion>(*form_) || std::holds_alternative<Dome>(*form_);
    }
    Local local(Vec3 p) const;

    const Form* form_;
    Axes axes_;
    double low_ = 0.0, cut_ = 0.0;
    double ahead_ = 1.0;         // Coils: which half of the circle.
    bool faces_one_way_ = true;  // True if the face is seen from the front without hiding itself.
};

}  // namespace ncsim::brep
