// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace ncsim::cda {

/// The index of nothing.
inline constexpr std::uint32_t kNone = ~std::uint32_t{0};

}  // namespace ncsim::cda
