// SPDX-License-Identifier: GPL-3.0-or-later
//
// Origin of a cell, a facet or a face: a number, so that the origin survives copying, sorting and
// writing to disk. The caller defines the meaning of the number.
#pragma once

#include <cstdint>

namespace ncsim::cda {

/// 0 is the stock; n is the n-th motion of the program.
enum class Origin : std::uint32_t {};

inline constexpr Origin kStockOrigin{0};

}  // namespace ncsim::cda
