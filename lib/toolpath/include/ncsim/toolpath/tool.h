// SPDX-License-Identifier: GPL-3.0-or-later
//
// Milling tools: stacks of convex pieces of revolution about the tool axis. Frame T: tip at
// the origin, +z towards the spindle. Lengths in mm, angles in degrees.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath {

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
    SlotMill,            ///< A disc on a neck: T-slots, keyseats, thread mills of one row.
    DovetailMill,        ///< Widest at its tip.
    LollipopMill,        ///< A ball on a neck.
    CornerRoundingMill,  ///< A concave quarter circle above its tip: rounds edges.
    // Shape of a flat end mill.
    Tap,
    Reamer,
    BoringBar,
    ThreadMill,
    Other,  ///< Put together by hand, piece by piece.
};

/// Is it wider below than above, so that it needs a neck?
bool is_undercutting(ToolKind kind);

/// True for tools with the shape of a V-cutter.
bool is_conical(std::optional<ToolKind> kind);

/// True for tools that cut along their axis alone, in a hole or into solid material: drills, taps,
/// reamers, boring bars.
bool is_axial(ToolKind kind);

/// "flat end mill", "ball end mill" …
std::string_view name_of(ToolKind kind);

/// A corner of a profile; `fillet` rounds it with an arc tangent to both neighbouring lines.
struct ProfilePoint {
    double radius = 0.0;
    double height = 0.0;
    double fillet = 0.0;
    bool operator==(const ProfilePoint&) const = default;
};

/// A convex body of revolution. `profile` runs from the lower end to the upper one, as seen on
/// paper with the axis on the left: heights do not fall, all turns are to the left. Where it does
/// not start or end on the axis, a flat disc closes it.
struct ToolPiece {
    std::vector<ProfilePoint> profile;
    bool cutting = true;   ///< Else a shank or a holder, which may not touch material.
    bool assumed = false;  ///< Nobody described it: it stands for what must be there.
    bool operator==(const ToolPiece&) const = default;
};

struct Tool {
    int number = 0;
    ToolKind kind = ToolKind::Other;
    std::string description;
    std::vector<ToolPiece> pieces;  ///< From the tip upwards.
    bool operator==(const Tool&) const = default;
};

/// Cutters of one piece. `length` is the height of the cutting part, from the tip. All arguments
/// must be finite and positive (`corner_radius`, `tip_diameter` may be 0). Where they
/// contradict each other the nearest possible tool is made: a corner radius is at most half the
/// diameter, a length at least the height of the shaped end.
Tool flat_end_mill(double diameter, double length);
Tool face_mill(double diameter, double length);
Tool ball_end_mill(double diameter, double length);
Tool bull_nose_end_mill(double diameter, double corner_radius, double length);
/// A cone of `included_angle` (tip to tip, 90 for a 90 degree chamfer mill) up to `diameter`, then
/// a cylinder. The tip is a flat of `tip_diameter`.
Tool v_cutter(double diameter, double tip_diameter, double included_angle, double length);
Tool drill(double diameter, double point_angle, double length);
/// A cone that opens by `taper` degrees per side from a flat or rounded tip. The tip's rounding
/// keeps its radius, as in a tapered ball end mill of tip diameter 2 · corner_radius.
Tool tapered_end_mill(double tip_diameter, double corner_radius, double taper, double length);

/// `length` is the height of the disc; `corner_radius` rounds its lower edge.
Tool slot_mill(double diameter, double corner_radius, double length);
/// Closes by `taper` degrees per side from `diameter` at the tip upwards.
Tool dovetail_mill(double diameter, double taper, double length);
/// A whole ball.
Tool lollipop_mill(double diameter);

/// A concave arc of `radius` from the edge of the tip upwards and outwards, up to `diameter`; above
/// the arc a cylinder up to `length`. A diameter beyond the quarter circle is a flat shoulder.
/// The arc consists of cones along its chords, one convex piece each: the tool is larger than the
/// round one by at most kConcaveChord.
Tool corner_rounding_mill(double diameter, double tip_diameter, double radius, double length);
inline constexpr double kConcaveChord = 0.005;  ///< mm

/// Puts a segment that does not cut on top of the tool: a shank, or one step of a holder.
void add_holder_segment(Tool& tool, double lower_diameter, double upper_diameter, double height);

/// What of a piece lies between two heights (mm above the tip); nothing, without a profile, if that
/// is not a body. Its arcs become chords that lie within 1 µm of them, inside.
ToolPiece slice(const ToolPiece& piece, double low, double high);

/// Height of the topmost point; 0 without pieces.
double height_of(const Tool& tool);
/// Height up to which the tool cuts.
double cutting_height_of(const Tool& tool);
/// Largest diameter of the cutting pieces.
double cutting_diameter_of(const Tool& tool);

}  // namespace ncsim::toolpath
