// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text drawn like engraving: strokes of constant width with round ends.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/export/image.h"

#include <string_view>

namespace ncsim::exporter {

// A Vec2 is a point of a picture: x to the right, y downwards, in pixels from the upper left
// corner.

/// Draws a stroke of `width` pixels with round ends and a smooth edge of one pixel. Parts beyond
/// the picture are clipped.
void draw_stroke(Image& image, Vec2 from, Vec2 to, double width, Rgba8 colour);

/// Draws `text` with the lower left corner of its first letter at (x, y) and capitals of `height`
/// pixels. Text is ASCII; any other UTF-8 character is drawn as a box. Text beyond the picture is
/// clipped.
void draw_text(Image& image, double x, double y, double height, Rgba8 colour,
               std::string_view text);

/// Returns the width of `text` in pixels.
double text_width(double height, std::string_view text);

}  // namespace ncsim::exporter
