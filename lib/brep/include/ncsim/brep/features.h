// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured on a part with a calliper: bores, bosses, floors, what is between walls. Taken
// from its true surfaces; facets that were not recognised are counted, never measured. mm.
#pragma once

#include "ncsim/brep/part.h"
#include "ncsim/cda/triangle_tree.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::brep {

/// How a bore ends below.
enum class BoreEnd : std::uint8_t {
    Through,   ///< It comes out.
    Flat,      ///< In a plane across its axis.
    Shoulder,  ///< In such a plane, in which another bore begins, or something else goes on.
    Cone,      ///< In a tip, as of a drill.
    Ball,
    Rounded,  ///< In a rounded corner, as of a bull nose.
    Other,
};
std::string_view name_of(BoreEnd end);

/// A cylinder around void, more than half of it.
struct Bore {
    Vec3 mouth;  ///< On the axis, where it is highest.
    Vec3 axis;   ///< Unit, out of the mouth; of what goes through, upwards.
    double diameter = 0.0;
    double depth = 0.0;            ///< From the mouth to where the cylinder ends.
    double mouth_slants_by = 0.0;  ///< How much lower the mouth is elsewhere; 0: it is square.
    double covers_degrees = 360.0;
    BoreEnd end = BoreEnd::Other;
    std::optional<double> tip_depth;          ///< Of cones and balls: from the mouth to the tip.
    std::optional<double> tip_angle_degrees;  ///< Of cones, from side to side.
    std::vector<cda::Origin> origins;
};

/// A cylinder around material, more than half of it.
struct Boss {
    Vec3 foot;  ///< On the axis, where it is lowest.
    Vec3 axis;  ///< Unit, upwards.
    double diameter = 0.0, height = 0.0;
    double covers_degrees = 360.0;
    std::vector<cda::Origin> origins;
};

/// Part of a cylinder, no more than half of it: a rounded corner.
struct Corner {
    double radius = 0.0;
    bool is_inside = true;  ///< Else material is within it.
    double covers_degrees = 0.0;
    Vec3 on_axis;  ///< In the middle of it.
    Vec3 axis;     ///< Unit.
    std::vector<cda::Origin> origins;
};

/// A plane that looks up, Z.
struct Floor {
    double z = 0.0, area = 0.0;
    bool is_closed = false;  ///< Walls rise from all of its outline.
    cda::Box box;
    std::vector<cda::Origin> origins;
};

/// Two planes that look at each other with nothing between (a slot), or away from each other with
/// material between (a wall).
struct Distance {
    double mm = 0.0;
    bool is_void = true;
    Vec3 from, to;  ///< A pair of points of them; one is right opposite the other.
    std::vector<cda::Origin> origins;
};

struct Features {
    std::vector<Bore> bores;
    std::vector<Boss> bosses;
    std::vector<Corner> corners;
    std::vector<Floor> floors;
    std::vector<Distance> distances;
    std::size_t facets = 0;  ///< Faces that are facets of round tools.
    double facet_area = 0.0;
    /// There are too many walls; their distances are left out.
    bool has_too_many_walls = false;
};

/// Each list in the order in which the features were cut, distances by length. Of each plane that
/// to the nearest is told; that of two planes which several pairs of faces lie in, with material
/// between, once. `between` has the triangles of a polyhedron of the part, which say whether
/// anything is there. O(n + p t) for n edges and p pairs of parallel planes, where asking the
/// triangles takes t.
Features features_of(const Part& part, const cda::TriangleTree& between);

}  // namespace ncsim::brep
