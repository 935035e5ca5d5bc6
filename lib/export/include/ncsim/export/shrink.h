// SPDX-License-Identifier: GPL-3.0-or-later
//
// Smaller pictures for lists.
#pragma once

#include "ncsim/export/image.h"

#include <cstdint>

namespace ncsim::exporter {

/// Returns `image` with squares of `factor` × `factor` pixels averaged to one pixel. Columns and
/// rows beyond the last whole square are left out.
/// Requires: 1 <= factor <= min(width, height).
Image shrink(const Image& image, std::uint32_t factor);

}  // namespace ncsim::exporter
