// SPDX-License-Identifier: GPL-3.0-or-later
//
// Specification of a tool in a comment, a table or an option. It is never complete, and may be
// insufficient to make a Tool.
#pragma once

#include "ncsim/toolpath/tool.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath {

/// A step of a shank or of a holder, mm.
struct ToolSegment {
    double lower_diameter = 0.0, upper_diameter = 0.0;
    double height = 0.0;
    bool operator==(const ToolSegment&) const = default;
};

/// Specified values of a tool. Lengths in mm, angles in degrees. Unspecified values are empty.
struct ToolSpec {
    int number = 0;
    std::optional<ToolKind> kind;
    /// Diameter of the cutting part; of the tip for TaperedEndMill.
    std::optional<double> diameter;
    std::optional<double> corner_radius;
    std::optional<double> tip_diameter;  ///< For V-cutters and corner rounding mills.
    std::optional<double> angle;         ///< Included angle of V-cutters, point angle of drills.
    std::optional<double> taper;         ///< Angle per side.
    std::optional<double> length;        ///< Flute length.
    std::optional<double> pitch;         ///< Pitch of a tap or a thread mill, mm.
    bool left_hand = false;              ///< True if the tool cuts with M4.
    // Parts above the flutes, from below upwards: neck, shank, holder.
    std::optional<double> neck_diameter, neck_length;
    std::optional<double> shank_diameter, shank_length;
    std::vector<ToolSegment> shaft;   ///< Replaces neck and shank.
    std::optional<double> stick_out;  ///< Distance from the tip to the holder.
    std::vector<ToolSegment> holder;
    /// If given, the pieces define the tool; the remaining values are information only.
    std::vector<ToolPiece> pieces;
    std::string description;
    /// Names of values above that were assumed, not specified: names of kAssumable, or "shape" for
    /// the whole tool.
    std::vector<std::string> assumed;
    bool operator==(const ToolSpec&) const = default;
};

/// Names of values that filled() may assume, as used in ToolSpec::assumed.
inline constexpr std::string_view kAssumable[] = {"shape", "kind",  "diameter",
                                                  "angle", "taper", "length"};

/// Returns `spec` without the assumed values.
ToolSpec specified_part(const ToolSpec& spec);

/// True if make_tool() can make a tool of `spec`: it has pieces or a positive diameter. For
/// V-cutters the tip diameter is sufficient.
bool is_complete(const ToolSpec& spec);

/// Makes the tool with the specified shank and holder. Unspecified values are assumed:
/// - the kind follows from the corner radius and the angles; without these, a flat end mill;
/// - the angle is 118 degrees for drills and 90 degrees for V-cutters;
/// - a V-cutter with only a tip diameter has a shank of 3.175 mm, or twice the tip;
/// - the length is `assumed_length`, which should exceed the depth of any cut, up to the stick-out;
///   a quarter of the diameter for slot mills, half for dovetail mills, the diameter for lollipop
///   mills;
/// - the taper is 30 degrees for dovetail mills; the neck of an undercutting mill has 0.6
///   diameters;
/// - a shank of unknown length reaches to the holder; if the stick-out is unknown, too, the holder
///   begins directly above, as low as possible; without a holder the shank is three diameters long.
///
/// Flutes longer than the stick-out extend into the holder.
///
/// Requires: is_complete(`spec`).
Tool make_tool(const ToolSpec& spec, double assumed_length);

/// Returns a sentence for each specified value that make_tool() cannot keep, with the letter of the
/// value in options: "a flat end mill has no angle (A)". Flutes and a shank that are longer than
/// the stick-out are in the holder and count as kept. Radii and lengths may differ by a hundredth
/// of the diameter, because CAM systems round.
/// Requires: is_complete().
std::vector<std::string> unsupported_values(const ToolSpec& spec);

/// True if the shape of the cutting part is assumed: the kind of tool, the angle of a cone, or the
/// height of a disc is unspecified.
bool guesses_shape(const ToolSpec& spec);
/// True if the holder is specified.
bool specifies_holder(const ToolSpec& spec);

/// Returns the least flute length (mm) of a tool of this kind and diameter, from the shortest
/// standard series: 1.25 diameters for end mills (DIN 6527, short), 3 for drills (DIN 6539), a
/// tenth for face mills; for a cone the height up to its diameter.
double least_flute_length(const Tool& tool);

/// Returns `spec` with all values that make_tool() would assume, listed in ToolSpec::assumed unless
/// specified values determine them.
ToolSpec filled(const ToolSpec& spec, double assumed_length);

/// Returns the values that make_tool() would assume, in words for the assumption sheet: "length 45
/// mm". Empty if there are none.
std::string assumed_values_text(const ToolSpec& spec, double assumed_length);

/// Returns a one-line description, including the parts above the flutes: "flat end mill D10 L22,
/// D12 to 52, D40 to 77".
std::string describe(const Tool& tool);

/// Returns the taper per side, in degrees, of a dovetail cutter that a catalogue lists with the
/// angle `degrees`: cutters for metal are listed by the angle between floor and flank (45, 60),
/// router bits by the angle between axis and flank (7.5, 14).
double dovetail_taper(double degrees);

/// Reads `T1=flat:D10:L22:S12x30:H28x15,40x25`: a number, a kind (flat, ball, bull, face, v,
/// spot, engraver, chamfer, countersink, drill, taper, slot, dovetail, lollipop, corner, tap,
/// reamer, boring-bar, thread; may be omitted) and values: D diameter, K pitch of a thread, R
/// corner radius, L flute length, A angle (included; per side for taper; for dovetail see
/// `dovetail_taper`), P tip diameter, N neck and S shank (diameter, or diameter x length), E
/// stick-out from the tip to the holder, H the holder from below upwards (diameter x height, or
/// lower-upper x height for a cone). Numbers are mm, or inches with the suffix `in`; case does not
/// matter. Returns empty, with the reason in `message`, if the text has another form.
std::optional<ToolSpec> parse_tool_option(std::string_view text, std::string& message);

}  // namespace ncsim::toolpath
