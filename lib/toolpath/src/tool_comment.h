// SPDX-License-Identifier: GPL-3.0-or-later
//
// The forms in which comments speak of tools and stock, one function per form.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/toolpath/tool_spec.h"

#include "text.h"

#include <optional>
#include <string_view>

namespace ncsim::toolpath {

/// What one comment says about a tool. Lengths are as written, in `unit`, or in the program's
/// units where there is none.
struct ToolRemark {
    ToolSpec spec;  ///< number 0: the comment does not say which.
    text::Unit unit = text::Unit::None;
    bool certain = false;  ///< A form that only tools are written in; else free text.
};

/// Nothing if the comment does not speak of a tool, or tells no size.
std::optional<ToolRemark> read_tool_remark(std::string_view comment);

/// A corner or a size with a unit.
struct Triple {
    cda::Vec3 value;
    text::Unit unit = text::Unit::None;
};

/// What a comment says about the stock: a whole block, or one of two corners.
struct StockRemark {
    enum class What : unsigned char { Block, Min, Max, Start } what = What::Block;
    Triple first;   ///< Size, corner or start.
    Triple second;  ///< Block: the program's zero, seen from the smallest corner.
};

std::optional<StockRemark> read_stock_remark(std::string_view comment);

}  // namespace ncsim::toolpath
