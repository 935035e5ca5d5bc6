// SPDX-License-Identifier: GPL-3.0-or-later
//
// Widths of lines in pictures of any size.
#pragma once

#include "ncsim/export/render_options.h"

#include <algorithm>
#include <cstdint>

namespace ncsim::exporter {

/// Returns the number of samples along a pixel of a picture with 960 rows; lines scale with larger
/// pictures.
inline double line_scale(const RenderOptions& options) {
    constexpr double kUsualHeight = 960.0;
    const std::uint32_t height = options.usual_height > 0 ? options.usual_height : options.height;
    return options.samples * std::max(0.5, height / kUsualHeight);
}

}  // namespace ncsim::exporter
