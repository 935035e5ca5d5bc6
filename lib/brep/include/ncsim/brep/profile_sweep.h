// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool paths, and elements of tool profiles that move along them. mm, frame W.
#pragma once

#include "ncsim/base/vec3.h"

#include <array>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace ncsim::brep {

/// Tool at a time t, 0 at the start and 1 at the end: position of the tip and direction of the axis
/// (unit), with the first and second derivatives by t.
struct ToolFrame {
    Vec3 tip, speed, change;
    Vec3 axis, turn, bend;
};

/// Straight path: the tip is at from + t along, the axis is constant.
struct StraightPath {
    Vec3 from, along, axis;
    bool operator==(const StraightPath&) const = default;
};

/// Arc, helix or spiral: the tip is at centre + (reach + growth w) (cos w ahead + sin w side) +
/// lead w about, with w = t swept and side = about x ahead; the axis is constant.
struct HelixPath {
    Vec3 centre, about, ahead;  ///< At the start; `about` and `ahead` are unit and perpendicular.
    double reach = 0.0;
    double growth = 0.0, lead = 0.0;  ///< mm per radian.
    double swept = 0.0;               ///< Radians, counter-clockwise about `about`.
    Vec3 axis;
    bool operator==(const HelixPath&) const = default;
};

/// Path on which the axis may turn, as polynomials in s. powers[k] has the coefficients of s^k for
/// X, Y, Z of the tip and X, Y, Z of the axis; s = -1 to 1 corresponds to t = -kPathExtension to 1
/// + kPathExtension.
struct RotaryPath {
    std::vector<std::array<double, 6>> powers;
    bool operator==(const RotaryPath&) const = default;
};
inline constexpr double kPathExtension = 0.25;

/// Tip of a tool and direction of its axis.
struct TipAndAxis {
    Vec3 tip, axis;
};
/// Returns the polynomial path through `pose`, a function of t from -kPathExtension to 1 +
/// kPathExtension.
/// Returns: the path, or no value if the polynomial misses `pose` between the interpolation points
/// by more than 1e-9 mm (axes: at 100 mm), as for rotations of about a full turn.
/// Cost: 66 calls of `pose`.
std::optional<RotaryPath> fit_rotary_path(const std::function<TipAndAxis(double)>& pose);
/// Returns the tool at time `t`.
ToolFrame tool_frame(const RotaryPath& path, double t);

using ToolPath = std::variant<StraightPath, HelixPath, RotaryPath>;

/// Circular arc of a profile; about the tool's axis it generates a piece of a torus or of a sphere.
/// `centre_radius` is the distance of the arc's centre from the axis, `height` the centre's height
/// above the tip, `radius` the arc's radius, 0 for the rim of a flat end.
struct Fillet {
    double centre_radius = 0.0, height = 0.0, radius = 0.0;
    bool operator==(const Fillet&) const = default;
};

/// Straight segment of a profile; about the tool's axis it generates a piece of a cylinder or of a
/// cone. `radius` and `height` above the tip are those of the lower end, (`cosine`, `sine`) is the
/// unit normal, outwards and along the axis.
struct Flank {
    double radius = 0.0, height = 0.0;
    double cosine = 1.0, sine = 0.0;
    double length = 0.0;
    bool operator==(const Flank&) const = default;
};

using Meridian = std::variant<Fillet, Flank>;

/// Element that moves along a path. A flank on a straight path leaves planes, which are no
/// envelopes.
class Sweep {
public:
    Sweep(const Meridian& meridian, const ToolPath& path);

    const Meridian& meridian() const { return meridian_; }
    const Fillet* fillet() const { return std::get_if<Fillet>(&meridian_); }
    const Flank* flank() const { return std::get_if<Flank>(&meridian_); }
    /// True if the fillet is a ball, with its centre on the axis.
    bool is_ball() const { return fillet() && fillet()->centre_radius <= 0.0; }
    /// True if the fillet is the rim of a flat end.
    bool is_rim() const { return fillet() && fillet()->radius <= 0.0; }
    const ToolPath& path() const { return path_; }
    /// Returns the tool at time `t`.
    ToolFrame at(double t) const;
    /// Returns tool positions at equal steps from t = 0 to 1, dense enough to bracket the nearest
    /// time.
    const std::vector<ToolFrame>& samples() const { return samples_; }
    /// Length of the tip's path, nearly; for a flank, the longer of the paths on which its ends
    /// have their centres on the axis.
    double length_mm() const { return length_; }

    bool operator==(const Sweep& o) const { return meridian_ == o.meridian_ && path_ == o.path_; }

private:
    Meridian meridian_;
    ToolPath path_;
    std::vector<ToolFrame> samples_;
    double length_ = 0.0;
};

/// Element at one time, seen from a point: the closest point, with derivatives. For rims, `rate`,
/// `drift` and `bend` are derivatives of deviation² / 2.
struct ClosestPoint {
    ToolFrame tool;
    double t = 0.0;
    Vec3 foot;               ///< Closest point of the element.
    double deviation = 0.0;  ///< Signed distance from the element, negative inside, mm.
    Vec3 normal;             ///< Unit normal of the element at `foot`: the gradient of `deviation`.
    double rate = 0.0;       ///< Derivative of `deviation` by t.
    Vec3 drift;              ///< Gradient of `rate`.
    double bend = 0.0;       ///< Derivative of `rate` by t.
};
/// Returns the gradient of the nearest time with respect to the point.
Vec3 gradient_of_time(const ClosestPoint& closest);

/// Returns the height above the tip of the axis point at which the normal of `flank` ends that
/// starts at the distance `along` from the lower end.
double height_of_centre(const Flank& flank, double along);
/// Returns the height above the tip of the fillet's centre, or height_of_centre() of the flank's
/// lower end.
double lowest_centre(const Sweep& sweep);

/// Frame of a path at the axis point at lowest_centre(). `ahead` is the direction of motion, `up`
/// the direction of the tool's axis made perpendicular to `ahead`.
struct PathFrame {
    Vec3 centre, ahead, up, side;  ///< The directions are unit and right-handed in this order.
};
/// Returns the frame of the sweep for the tool position `tool`.
PathFrame path_frame(const Sweep& sweep, const ToolFrame& tool);
/// Returns the velocity of the axis point at `height` above the tip, mm per unit of t.
Vec3 velocity_at(const ToolFrame& tool, double height);

}  // namespace ncsim::brep
