// SPDX-License-Identifier: GPL-3.0-or-later
//
// The invalid index.
#pragma once

#include <cstdint>

namespace ncsim::cda {

/// The index of no element.
inline constexpr std::uint32_t kNone = ~std::uint32_t{0};

}  // namespace ncsim::cda
