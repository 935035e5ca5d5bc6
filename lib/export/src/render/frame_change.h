// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of a picture in which two frames of an animation differ.
#pragma once

#include "ncsim/export/image.h"

#include <cstdint>

namespace ncsim::exporter {

/// Rectangle of pixels; `right` and `bottom` are exclusive.
struct FrameRegion {
    std::uint32_t left = 0, top = 0, right = 0, bottom = 0;

    std::uint32_t width() const { return right - left; }
    std::uint32_t height() const { return bottom - top; }
};

/// Returns the smallest rectangle that contains all pixels in which the frames differ; one pixel if
/// the frames are equal, because a frame of an animation must not be empty.
/// Requires: the frames have the same size.
FrameRegion changed_region(const Image& a, const Image& b);

}  // namespace ncsim::exporter
