// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several pictures on one sheet, with what there is to say about them.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/render.h"

#include <span>
#include <string>

namespace ncsim::exporter {

/// A picture and the words in its upper left corner.
struct LabelledImage {
    std::string label;
    Image picture;
};

/// Puts `pictures`, which must be equally large, side by side (up to three in a row, more in as
/// square a grid as possible) and the lines of `caption` below them. Text is ASCII; other
/// characters show as a box. The size of letters follows that of the pictures; a line of the
/// caption that would not fit has smaller ones. The size of the sheet follows from that of the
/// pictures and the number of lines.
///
/// Throws std::runtime_error if there is no picture, if pictures differ in size, or if the sheet
/// would have a side of more than kMaxImageSide.
Image contact_sheet(std::span<const LabelledImage> pictures, std::span<const std::string> caption,
                    Background background = Background::White);

}  // namespace ncsim::exporter
