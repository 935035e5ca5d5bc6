// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a cell, a facet or a face came from: a number, so that it survives copying,
// sorting and writing to disk. What the number stands for is the caller's business.
#pragma once

#include <cstdint>

namespace ncsim::cda {

/// 0 is the stock; n is the n-th motion of the program.
enum class Origin : std::uint32_t {};

inline constexpr Origin kStockOrigin{0};

}  // namespace ncsim::cda
