// SPDX-License-Identifier: GPL-3.0-or-later
//
// Descriptions of boxes, stock, volumes and lines.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/verify/region.h"

#include <string>
#include <vector>

namespace ncsim::report {

/// Returns "50 x 40 x 10 mm, X 0 to 50, Y 0 to 40, Z -10 to 0".
std::string describe(const Box& box);
/// Returns a description of the stock: its kind, box and file.
std::string describe(const toolpath::Stock& stock);

/// Returns "1.250 cm3".
std::string volume_text(double mm3);

/// Returns "3-7, 12"; long lists are shortened.
std::string lines_text(const std::vector<verify::LineRange>& lines);

}  // namespace ncsim::report
