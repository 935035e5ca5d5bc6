// SPDX-License-Identifier: GPL-3.0-or-later
//
// Index that stands for no element.
#pragma once

#include <cstdint>
#include <limits>

namespace ncsim::brep {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace ncsim::brep
