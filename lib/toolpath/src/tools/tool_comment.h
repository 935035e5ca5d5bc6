// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forms of comments with a tool or a stock, with a function per form.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/toolpath/tool_spec.h"

#include "tools/comment_text.h"
#include "tools/tool_remark.h"

#include <optional>
#include <string_view>

namespace ncsim::toolpath {

/// Reads the description of a tool. Empty if the comment does not describe a tool or gives no size.
std::optional<ToolRemark> read_tool_remark(std::string_view comment);

/// A corner or a size with a unit.
struct Triple {
    Vec3 value;
    text::Unit unit = text::Unit::None;
};

/// Information of a comment about the stock.
struct StockRemark {
    enum class What : unsigned char {
        Block,      ///< `first` is the size, `second` the program zero relative to the corner.
        Min,        ///< `first` is the corner with the smallest coordinates.
        Max,        ///< `first` is the corner with the largest coordinates.
        Start,      ///< `first` is the start position of the tool.
        Heading,    ///< The next comment has the size.
        Size,       ///< `first` is the size; further comments give the zero.
        ZeroAtTop,  ///< Z0 is on top of the material …
        ZeroAtBed,  ///< … or at the bottom.
        Zero,    ///< ZeroXY with `first.value.z` 1 for the top of the material, -1 for the bottom.
        ZeroXY,  ///< `first.value` is the position of X0 Y0: -1, 0 or 1 from the middle.
        Elsewhere,  ///< The position of the stock is unknown.
    } what = What::Block;
    Triple first;
    Triple second;
};

/// Reads a comment about the stock. Empty if the comment has none of the known forms.
std::optional<StockRemark> read_stock_remark(std::string_view comment);

/// Reads a size after a heading: "X= 76.000, Y= 5.500, Z= 1.000".
std::optional<Triple> read_size_remark(std::string_view comment);

/// Key and value of a comment. PowerMill describes a tool in several comments: "Tool Number: 3",
/// "DIAMETER: 6.0", "TIP RADIUS: 0.5". PyCAM does the same: "shape = ToroidalCutter", "tool_radius
/// = 3.0", "torus_radius = 0.5".
struct KeyedRemark {
    enum class Key : unsigned char {
        ToolNumber,
        Diameter,
        TipRadius,
        Taper,
        ToolType,
        TorusRadius  ///< Corner radius of a tool, if its type has a corner.
    } key;
    double value = 0.0;
    text::Unit unit = text::Unit::None;
    std::optional<ToolKind> kind;  ///< For ToolType.
};
/// Reads a comment of a key and a value. Empty if the key is unknown.
std::optional<KeyedRemark> read_keyed_remark(std::string_view comment);

}  // namespace ncsim::toolpath
