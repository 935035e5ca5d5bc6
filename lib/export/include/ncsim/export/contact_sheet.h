// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several pictures on one sheet, with a caption.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/render.h"

#include <span>
#include <string>

namespace ncsim::exporter {

/// A picture and the text in its upper left corner.
struct LabelledImage {
    std::string label;
    Image picture;
};

/// Puts `pictures` side by side and the lines of `caption` below. Up to three pictures are in a
/// row; more are in a grid that is as square as possible. Text is ASCII; any other character is
/// drawn as a box. The letters scale with the pictures; a line of the caption that would not fit
/// gets smaller letters. The size of the sheet depends on the size of the pictures and the number
/// of lines only.
///
/// Throws: std::runtime_error if there is no picture, if pictures differ in size, or if a side of
///     the sheet would exceed kMaxImageSide.
Image contact_sheet(std::span<const LabelledImage> pictures, std::span<const std::string> caption,
                    Background background = Background::White);

}  // namespace ncsim::exporter
