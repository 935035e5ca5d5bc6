// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several pictures on one sheet, with a caption.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/render.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// A picture and the text in its upper left corner.
struct LabelledImage {
    std::string label;
    Image picture;
};

/// Place of a picture on a sheet, from the upper left corner.
struct SheetCell {
    std::uint32_t column = 0, row = 0;

    bool operator==(const SheetCell&) const = default;
};

/// Returns the number of columns of a sheet of so many pictures.
std::uint32_t columns_for(std::size_t pictures);

/// Puts `pictures` side by side and the lines of `caption` below. Up to three pictures are in a
/// row; more are in a grid that is as square as possible. Text is ASCII; any other character is
/// drawn as a box. The letters scale with the pictures, and all lines of the caption have one size;
/// a line that does not fit ends in "...", see wrapped(). The size of the sheet depends on the size
/// of the pictures and the number of lines only. The number of rows is even, as video formats
/// require, if the pictures have an even number of rows.
///
/// Throws: std::runtime_error if there is no picture, if pictures differ in size, or if a side of
///     the sheet would exceed kMaxImageSide.
Image contact_sheet(std::span<const LabelledImage> pictures, std::span<const std::string> caption,
                    Background background = Background::White);
/// Does the same with each picture in its cell. Rows may differ in height.
/// Requires: a cell for each picture.
Image contact_sheet(std::span<const LabelledImage> pictures, std::span<const SheetCell> cells,
                    std::span<const std::string> caption, Background background);

/// Divides a line at spaces so that each part fits below pictures of `width` by `height` pixels in
/// letters of the usual size. A word that is longer is divided, too.
std::vector<std::string> wrapped(const std::string& line, std::uint32_t width,
                                 std::uint32_t height);

}  // namespace ncsim::exporter
