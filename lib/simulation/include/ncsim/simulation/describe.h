// SPDX-License-Identifier: GPL-3.0-or-later
//
// Descriptions of boxes and stock.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/toolpath/stock.h"

#include <string>

namespace ncsim::simulation {

/// Returns "50 x 40 x 10 mm, X 0 to 50, Y 0 to 40, Z -10 to 0".
std::string describe(const Box& box);
/// Returns a description of the stock: kind, box and file.
std::string describe(const toolpath::Stock& stock);

}  // namespace ncsim::simulation
