// SPDX-License-Identifier: GPL-3.0-or-later
//
// Features that are measured with a calliper: bores, countersinks, bosses, chamfers, floors,
// distances between walls. All values come from true surfaces; unrecognised facets are counted but
// not measured. mm.
#pragma once

#include "ncsim/base/triangle_tree.h"
#include "ncsim/brep/part.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::brep {

/// Shape of the lower end of a bore.
enum class BoreEnd : std::uint8_t {
    Through,   ///< It comes out.
    Flat,      ///< Plane across the axis.
    Shoulder,  ///< Such a plane with an opening in it, or a cone without its tip.
    Cone,      ///< Tip, as of a drill.
    Ball,
    Rounded,  ///< Rounded corner, as of a bull-nose end mill.
    Other,
};
/// Returns the name of `end`, such as "through".
std::string_view name_of(BoreEnd end);

/// Cylinder around void that covers more than half a turn.
struct Bore {
    Vec3 mouth;  ///< Highest point of the cylinder, on the axis.
    Vec3 axis;   ///< Unit, out of the mouth; upwards for through bores.
    double diameter = 0.0;
    double depth = 0.0;            ///< Distance from the mouth to the end of the cylinder.
    double mouth_slants_by = 0.0;  ///< Height difference of the mouth's rim; 0 for a square mouth.
    double covers_degrees = 360.0;
    BoreEnd end = BoreEnd::Other;
    /// Distance from the mouth to the tip; for cones and balls.
    std::optional<double> tip_depth;
    std::optional<double> tip_angle_degrees;  ///< Full angle; for cones.
    std::vector<cda::Origin> origins;
};

/// Cylinder around material that covers more than half a turn.
struct Boss {
    Vec3 foot;  ///< Lowest point of the cylinder, on the axis.
    Vec3 axis;  ///< Unit, upwards.
    double diameter = 0.0, height = 0.0;
    double covers_degrees = 360.0;
    std::vector<cda::Origin> origins;
};

/// Cone around void that covers more than half a turn and opens at its wide end.
struct Countersink {
    Vec3 mouth;                  ///< Centre of the wide end.
    Vec3 axis;                   ///< Unit, out of the mouth.
    double diameter = 0.0;       ///< At the mouth.
    double depth = 0.0;          ///< Distance from the mouth to the end of the cone.
    double angle_degrees = 0.0;  ///< Included angle.
    double covers_degrees = 360.0;
    bool has_tip = false;  ///< True if the cone ends in its tip.
    std::vector<cda::Origin> origins;
};

/// Plane or cone in the place of a convex edge between a level face and an upright face.
struct Chamfer {
    double width = 0.0,
           height = 0.0;         ///< Lengths by which the level and the upright face end early.
    double angle_degrees = 0.0;  ///< Angle to the level face.
    double length = 0.0;         ///< Length of the longer edge.
    Vec3 at;                     ///< Middle of the edge at the level face.
    std::vector<cda::Origin> origins;
};

/// Rounded corner: cylinder that covers at most half a turn.
struct Corner {
    double radius = 0.0;
    bool is_inside = true;  ///< False if the material is inside the cylinder.
    double covers_degrees = 0.0;
    Vec3 on_axis;  ///< Axis point at half of the height.
    Vec3 axis;     ///< Unit.
    std::vector<cda::Origin> origins;
};

/// Plane with the normal +Z.
struct Floor {
    double z = 0.0, area = 0.0;
    bool is_closed = false;  ///< True if walls rise from the whole outline.
    Box box;
    std::vector<cda::Origin> origins;
};

/// Distance between two parallel planes that face each other across void (a slot), or face away
/// from each other across material (a wall).
struct Distance {
    double mm = 0.0;
    bool is_void = true;
    Vec3 from, to;  ///< A pair of opposite points on the two planes.
    std::vector<cda::Origin> origins;
};

/// Features of a part.
struct Features {
    std::vector<Bore> bores;
    std::vector<Boss> bosses;
    std::vector<Countersink> countersinks;
    std::vector<Chamfer> chamfers;
    std::vector<Corner> corners;
    std::vector<Floor> floors;
    std::vector<Distance> distances;
    std::size_t facets = 0;  ///< Number of faces that are facets of round tools.
    double facet_area = 0.0;
    /// True if there are too many walls; the distances are then left out.
    bool has_too_many_walls = false;
};

/// Returns the features of `part`, each list in the order in which the features were cut, distances
/// by length. Each plane is paired with the nearest opposite plane. The thickness between the same
/// two planes is listed once, even if several pairs of faces lie in them. `between` has the
/// triangles of a polyhedron of the part; it decides whether anything lies between two planes.
/// Cost: O(n + p t) for n edges and p pairs of parallel planes, with t for a query of the
/// triangles.
Features features_of(const Part& part, const TriangleTree& between);

}  // namespace ncsim::brep
