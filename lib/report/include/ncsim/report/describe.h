// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words for boxes, blocks, volumes and lines.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/verify/region.h"

#include <string>
#include <vector>

namespace ncsim::report {

/// "50 x 40 x 10 mm, X 0 to 50, Y 0 to 40, Z -10 to 0"
std::string describe(const cda::Box& box);
std::string describe(const toolpath::Stock& stock);

/// "1.250 cm3".
std::string volume_text(double mm3);

/// "3-7, 12": the first few of them.
std::string lines_text(const std::vector<verify::LineRange>& lines);

}  // namespace ncsim::report
