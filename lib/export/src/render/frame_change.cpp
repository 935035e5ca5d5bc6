// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares frames of an animation.
#include "render/frame_change.h"

#include <algorithm>

namespace ncsim::exporter {

FrameRegion changed_region(const Image& a, const Image& b) {
    FrameRegion r{a.width, a.height, 0, 0};
    for (std::uint32_t y = 0; y < a.height; ++y) {
        for (std::uint32_t x = 0; x < a.width; ++x) {
            if (a.at(x, y) == b.at(x, y)) continue;
            r = {std::min(r.left, x), std::min(r.top, y), std::max(r.right, x + 1),
                 std::max(r.bottom, y + 1)};
        }
    }
    return r.right == 0 ? FrameRegion{0, 0, 1, 1} : r;
}

}  // namespace ncsim::exporter
