// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rectangles of pixels.
#pragma once

#include <cstdint>

namespace ncsim::exporter {

/// Rectangle of pixels of a picture.
struct PixelRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

}  // namespace ncsim::exporter
