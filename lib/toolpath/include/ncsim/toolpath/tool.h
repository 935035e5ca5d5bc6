// SPDX-License-Identifier: GPL-3.0-or-later
//
// Milling tools as stacks of convex pieces of revolution about the tool axis. Tool frame T: tip at
// the origin, +z towards the spindle. Lengths in mm, angles in degrees.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath {

/// Kind of a milling or drilling tool.
enum class ToolKind : std::uint8_t {
    FlatEndMill,
    BallEndMill,
    BullNoseEndMill,
    FaceMill,
    VCutter,  ///< Engravers, V-bits, spot and centre drills.
    // Shape of a V-cutter.
    ChamferMill,
    Countersink,
    Drill,
    TaperedEndMill,
    SlotMill,      ///< A disc on a neck: T-slot cutter, keyseat cutter, single-row thread mill.
    DovetailMill,  ///< Widest at the tip.
    LollipopMill,  ///< A ball on a neck.
    CornerRoundingMill,  ///< A concave quarter circle above the tip: rounds edges.
    // The following kinds have the shape of a flat end mill.
    Tap,
    Reamer,
    BoringBar,
    ThreadMill,
    Other,  ///< Put together from explicit pieces.
};

/// True if the tool is wider below than above, so that it needs a neck.
bool is_undercutting(ToolKind kind);

/// True for tools with the shape of a V-cutter.
bool is_conical(std::optional<ToolKind> kind);

/// True for tools that cut only along their axis, in a hole or into solid material: drills, taps,
/// reamers, boring bars.
bool is_axial(ToolKind kind);

/// Returns the English name of `kind`, such as "flat end mill".
std::string_view name_of(ToolKind kind);

/// A corner of a profile, mm. `fillet` is the radius of an arc that rounds the corner, tangent to
/// both adjacent lines.
struct ProfilePoint {
    double radius = 0.0;
    double height = 0.0;
    double fillet = 0.0;
    bool operator==(const ProfilePoint&) const = default;
};

/// A convex body of revolution. `profile` runs from the lower to the upper end, drawn with the axis
/// on the left: heights do not decrease, and all corners turn left. A flat disc closes a profile
/// that does not start or end on the axis.
struct ToolPiece {
    std::vector<ProfilePoint> profile;
    bool cutting = true;   ///< False for a shank or a holder, which must not touch material.
    bool assumed = false;  ///< True if the piece was not specified.
    bool operator==(const ToolPiece&) const = default;
};

/// A tool as a stack of pieces.
struct Tool {
    int number = 0;
    ToolKind kind = ToolKind::Other;
    std::string description;
    std::vector<ToolPiece> pieces;  ///< In order from the tip upwards.
    bool operator==(const Tool&) const = default;
};

/// Make cutters of one piece. `length` is the height of the cutting part above the tip.
/// Contradictory arguments give the nearest possible tool: a corner radius is at most half the
/// diameter, a length at least the height of the shaped end.
///
/// Requires: all arguments are finite and positive; `corner_radius` and `tip_diameter` may be 0.
Tool flat_end_mill(double diameter, double length);
Tool face_mill(double diameter, double length);
Tool ball_end_mill(double diameter, double length);
Tool bull_nose_end_mill(double diameter, double corner_radius, double length);
/// Makes a cone of `included_angle` (90 for a 90 degree chamfer mill) up to `diameter`, followed by
/// a cylinder. The tip is a flat of `tip_diameter`.
Tool v_cutter(double diameter, double tip_diameter, double included_angle, double length);
/// Makes a cylinder with a cone of `point_angle` at the tip.
Tool drill(double diameter, double point_angle, double length);
/// Makes a cone that opens by `taper` degrees per side from a flat or rounded tip. The rounding of
/// the tip keeps its radius: a tapered ball end mill has the tip diameter 2 · corner_radius.
Tool tapered_end_mill(double tip_diameter, double corner_radius, double taper, double length);

/// Makes a disc of height `length`; `corner_radius` rounds the lower edge.
Tool slot_mill(double diameter, double corner_radius, double length);
/// Makes a cone that closes upwards by `taper` degrees per side from `diameter` at the tip.
Tool dovetail_mill(double diameter, double taper, double length);
/// Makes a whole ball.
Tool lollipop_mill(double diameter);

/// Returns a mill with a concave arc of `radius` from the edge of the tip upwards and outwards, up
/// to `diameter`, and a cylinder above the arc up to `length` (mm). A diameter beyond the quarter
/// circle is a flat shoulder. The arc consists of cones along its chords, one convex piece each:
/// the tool is larger than the round tool by at most kConcaveChord.
Tool corner_rounding_mill(double diameter, double tip_diameter, double radius, double length);
inline constexpr double kConcaveChord = 0.005;  ///< mm

/// Adds a segment that does not cut on top of the tool: a shank, or a step of a holder.
void add_holder_segment(Tool& tool, double lower_diameter, double upper_diameter, double height);

/// Returns the part of `piece` between the heights `low` and `high` (mm above the tip), or a piece
/// without a profile if that part is not a body. Arcs become chords that lie inside, at most 1 µm
/// from the arc.
ToolPiece slice(const ToolPiece& piece, double low, double high);

/// Returns the height of the topmost point; 0 without pieces.
double height_of(const Tool& tool);
/// Returns the height up to which the tool cuts.
double cutting_height_of(const Tool& tool);
/// Returns the largest diameter of the cutting pieces.
double cutting_diameter_of(const Tool& tool);

}  // namespace ncsim::toolpath
