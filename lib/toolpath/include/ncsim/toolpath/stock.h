// SPDX-License-Identifier: GPL-3.0-or-later
//
// The block of material a program starts with: said by somebody, or derived from what is cut.
#pragma once

#include "ncsim/cda/vec.h"

#include <optional>
#include <string>
#include <string_view>

namespace ncsim::toolpath {

/// Reads `x0,y0,z0:x1,y1,z1` (two corners) or `LxWxH` (sizes; the top at Z0, centred on X0 Y0) or
/// `LxWxH@x,y,z` (sizes and the corner with the smallest coordinates). In mm, or in inches where
/// the text ends in `in`. Nothing if it is of neither form or encloses no volume; the message then
/// says why.
std::optional<cda::Box> parse_stock_option(std::string_view text, std::string& message);

/// A box for a program that does not say what it cuts.
struct DerivedStock {
    cda::Box box;
    std::string rule;  ///< How it was made, in words for the assumption sheet.
};

/// From the box swept by the tools in all cutting moves (mm). The sides and the bottom stand a
/// twentieth of the size away from it, at least 2 mm. The top is Z0 where the tool cuts below Z0:
/// programs put it there; else the highest cutting position of a tool tip, `highest_tip`. At least
/// 1 mm thick.
DerivedStock derive_stock(const cda::Box& swept, double highest_tip);

}  // namespace ncsim::toolpath
