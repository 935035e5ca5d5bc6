// SPDX-License-Identifier: GPL-3.0-or-later
//
// Letters as an engraving cutter would make them: strokes of one width with round ends.
#pragma once

#include "ncsim/export/image.h"

#include <cstdint>
#include <string_view>

namespace ncsim::exporter {

/// Draws `text` (ASCII; other bytes show as a box, one for each UTF-8 character) with the lower
/// left corner of its first letter at (x, y), capitals `height` pixels high. What lies beyond the
/// picture is cut off.
void draw_text(Image& image, double x, double y, double height, Rgba8 colour,
               std::string_view text);

/// Width of the text in pixels.
double text_width(double height, std::string_view text);

}  // namespace ncsim::exporter
