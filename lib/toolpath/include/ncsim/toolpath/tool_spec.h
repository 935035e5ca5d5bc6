// SPDX-License-Identifier: GPL-3.0-or-later
//
// What somebody says about a tool, in a comment, a table or an option: never everything,
// and not always enough to make a Tool of it.
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

/// Lengths in mm, angles in degrees. What was not said is empty.
struct ToolSpec {
    int number = 0;
    std::optional<ToolKind> kind;
    std::optional<double> diameter;  ///< Of the cutting part; of the tip for TaperedEndMill.
    std::optional<double> corner_radius;
    std::optional<double> tip_diameter;  ///< Of V-cutters and corner rounding mills.
    std::optional<double> angle;         ///< Included angle of V-cutters, point angle of drills.
    std::optional<double> taper;         ///< Per side.
    std::optional<double> length;        ///< Of the cutting part: of the flutes.
    std::optional<double> pitch;         ///< Of taps and thread mills, mm.
    bool left_hand = false;              ///< Cuts with M4.
    // Above the flutes, from below upwards: neck, shank, holder.
    std::optional<double> neck_diameter, neck_length;
    std::optional<double> shank_diameter, shank_length;
    std::vector<ToolSegment> shaft;   ///< Instead of neck and shank.
    std::optional<double> stick_out;  ///< From the tip to the holder.
    std::vector<ToolSegment> holder;
    std::vector<ToolPiece> pieces;  ///< Where given, they are the tool and the rest is only told.
    std::string description;
    /// Names of values above that were assumed, not specified: those of kAssumable, or "shape" for
    /// the whole tool.
    std::vector<std::string> assumed;
    bool operator==(const ToolSpec&) const = default;
};

/// Values of a ToolSpec that filled() may assume, by the names that ToolSpec::assumed has for them.
inline constexpr std::string_view kAssumable[] = {"shape", "kind",  "diameter",
                                                  "angle", "taper", "length"};

/// Returns `spec` without the values that were assumed: what was specified.
ToolSpec specified_part(const ToolSpec& spec);

/// Can a tool be made of it? It needs a positive diameter, or pieces; of V-cutters the diameter of
/// the tip is enough.
bool is_complete(const ToolSpec& spec);

/// The tool with all that is told of shank and holder. Requires is_complete(). What was not said is
/// filled in as a machinist would: a kind from the corner radius and the angles (none of them: a
/// flat end mill), 118 degrees for drills, 90 for V-cutters, for those of which only the tip is
/// told a shank of 3.175 mm, or twice the tip; `assumed_length` for a missing length, which should
/// be more than the depth of any cut. A shank of which the length is not told reaches to the
/// holder; where the stick-out is not told either, the holder begins right above, as low as it can
/// be, and without a holder the shank is three diameters long. Flutes that are longer than the
/// stick-out are in the holder.
Tool make_tool(const ToolSpec& spec, double assumed_length);

/// Returns one sentence for each specified value that make_tool() cannot keep, with the letter that
/// the value has in options: "a flat end mill has no angle (A)". Requires is_complete(). Flutes
/// and a shank that are longer than the stick-out are in the holder and count as kept. Radii and
/// lengths may differ by a hundredth of the diameter, to which CAM systems round.
std::vector<std::string> unkept_values(const ToolSpec& spec);

/// Is the shape of the cutting part a guess? Nobody says what kind of tool it is, the angle of a
/// cone, or how high a disc is.
bool guesses_shape(const ToolSpec& spec);
/// Does anybody say what is above the flutes?
bool tells_shank(const ToolSpec& spec);
bool tells_holder(const ToolSpec& spec);

/// How high a tool of this kind and diameter (mm) cuts at least, whoever makes it: what the
/// shortest ones that are sold as a series do. 1.25 diameters of end mills (DIN 6527, short), 3 of
/// drills (DIN 6539), a tenth of face mills; a cone up to its diameter.
double least_flute_length(const Tool& tool);

/// Returns `spec` with everything make_tool() would fill in, named in ToolSpec::assumed if nothing
/// that was specified decides it.
ToolSpec filled(const ToolSpec& spec, double assumed_length);

/// What make_tool() had to fill in, in words, for the assumption sheet: "length 45 mm". Empty if
/// nothing.
std::string filled_in(const ToolSpec& spec, double assumed_length);

/// One line for people: "flat end mill D10 L22, D12 to 52, D40 to 77", with what is above the
/// flutes.
std::string describe(const Tool& tool);

/// Returns the taper per side, in degrees, of a dovetail cutter that a catalogue lists with the
/// angle `degrees`: cutters for metal are listed by the angle between floor and flank (45, 60),
/// router bits by the angle between axis and flank (7.5, 14).
double dovetail_taper(double degrees);

/// Reads `T1=flat:D10:L22:S12x30:H28x15,40x25`: a number, a kind (flat, ball, bull, face, v,
/// spot, engraver, chamfer, countersink, drill, taper, slot, dovetail, lollipop, corner, tap,
/// reamer, boring-bar, thread; may be left out) and values: D diameter, K pitch of a thread, R
/// corner radius, L length of the flutes, A angle
/// (included; per side for taper; of dovetail see `dovetail_taper`), P tip diameter, N neck and S
/// shank (diameter, or diameter x length), E stick-out from the tip to the holder, H the holder
/// from below upwards (diameter x height, or lower-upper x height for a cone). Numbers are mm, or
/// inches with `in` behind them; case does not matter. Nothing if it is not of that form; the
/// message then says why.
std::optional<ToolSpec> parse_tool_option(std::string_view text, std::string& message);

}  // namespace ncsim::toolpath
