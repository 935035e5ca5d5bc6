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

/// Lengths in mm, angles in degrees. What was not said is empty.
struct ToolSpec {
    int number = 0;
    std::optional<ToolKind> kind;
    std::optional<double> diameter;  ///< Of the cutting part; of the tip for TaperedEndMill.
    std::optional<double> corner_radius;
    std::optional<double> tip_diameter;  ///< Of V-cutters.
    std::optional<double> angle;         ///< Included angle of V-cutters, point angle of drills.
    std::optional<double> taper;         ///< Per side.
    std::optional<double> length;        ///< Of the cutting part.
    std::optional<double> shank_diameter;
    std::vector<ToolPiece> pieces;  ///< Where given, they are the tool and the rest is only told.
    std::string description;
    bool operator==(const ToolSpec&) const = default;
};

/// Can a tool be made of it? It needs a positive diameter, or pieces.
bool is_complete(const ToolSpec& spec);

/// The tool. Requires is_complete(). What was not said is filled in as a machinist would: a kind
/// from the corner radius and the angles (none of them: a flat end mill), 118 degrees for drills,
/// 90 for V-cutters; `assumed_length` for a missing length, which should be more than the depth of
/// any cut.
Tool make_tool(const ToolSpec& spec, double assumed_length);

/// `spec` with everything make_tool() would fill in.
ToolSpec filled(const ToolSpec& spec, double assumed_length);

/// What make_tool() had to fill in, in words, for the assumption sheet: "length 45 mm". Empty if
/// nothing.
std::string filled_in(const ToolSpec& spec, double assumed_length);

/// One line for people: "flat end mill D10 L40".
std::string describe(const Tool& tool);

/// Reads `T1=flat:D10:L40`: a number, a kind (flat, ball, bull, face, v, chamfer, drill, taper; may
/// be left out) and values: D diameter, R corner radius, L length, A angle (included; per side for
/// taper), P tip diameter, S shank diameter. Numbers are mm, or inches with `in` behind them; case
/// does not matter. Nothing if it is not of that form; the message then says why.
std::optional<ToolSpec> parse_tool_option(std::string_view text, std::string& message);

}  // namespace ncsim::toolpath
