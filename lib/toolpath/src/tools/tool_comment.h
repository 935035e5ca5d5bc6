// SPDX-License-Identifier: GPL-3.0-or-later
//
// The forms in which comments speak of tools and stock, one function per form.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/toolpath/tool_spec.h"

#include "tools/text.h"
#include "tools/tool_remark.h"

#include <optional>
#include <string_view>

namespace ncsim::toolpath {

/// Nothing if the comment does not speak of a tool, or tells no size.
std::optional<ToolRemark> read_tool_remark(std::string_view comment);

/// A corner or a size with a unit.
struct Triple {
    cda::Vec3 value;
    text::Unit unit = text::Unit::None;
};

/// What a comment says about the stock: a whole block, or one of two corners.
struct StockRemark {
    enum class What : unsigned char {
        Block,      ///< `first` is the size, `second` the program's zero seen from the corner.
        Min,        ///< `first` is the corner with the smallest coordinates.
        Max,        ///< `first` is the corner with the largest ones.
        Start,      ///< `first` is where the tool stands at the beginning.
        Heading,    ///< The next comment has the size.
        Size,       ///< `first` is the size; where the zero is, other comments say.
        ZeroAtTop,  ///< Z0 is on top of the material …
        ZeroAtBed,  ///< … or below it.
        Zero,       ///< ZeroXY, with `first.value.z` 1 on top of the material, or -1 below it.
        ZeroXY,     ///< Where X0 Y0 is: `first.value` counts from the middle, -1, 0 or 1.
        Elsewhere,  ///< The size lies where nobody here knows.
    } what = What::Block;
    Triple first;
    Triple second;
};

std::optional<StockRemark> read_stock_remark(std::string_view comment);

/// "X= 76.000, Y= 5.500, Z= 1.000": a size, behind a heading.
std::optional<Triple> read_size_remark(std::string_view comment);

/// PowerMill tells a tool in several comments, each one thing: "Tool Number: 3", "DIAMETER: 6.0",
/// "TIP RADIUS: 0.5"; so does PyCAM: "shape = ToroidalCutter", "tool_radius = 3.0", "torus_radius =
/// 0.5". The key and its value.
struct KeyedRemark {
    enum class Key : unsigned char {
        ToolNumber,
        Diameter,
        TipRadius,
        Taper,
        ToolType,
        TorusRadius  ///< The corner of a tool, if its type has one.
    } key;
    double value = 0.0;
    text::Unit unit = text::Unit::None;
    std::optional<ToolKind> kind;  ///< Of ToolType.
};
std::optional<KeyedRemark> read_keyed_remark(std::string_view comment);

}  // namespace ncsim::toolpath
