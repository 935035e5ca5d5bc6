// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout of pictures, labels and caption on a sheet.
#include "ncsim/export/contact_sheet.h"

#include "render/lettering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::exporter {

namespace {

// Heights of capitals as shares of the height of a picture, and the smallest readable height in
// pixels.
constexpr double kLabelHeight = 1.0 / 46.0;
constexpr double kCaptionHeight = 1.0 / 46.0;
constexpr double kLeastHeight = 7.0;
constexpr double kCaptionMargin = 1.5;  // margin of text lines, in heights of capitals
constexpr double kLineSpacing = 2.1;    // distance of text lines, in heights of capitals

struct SheetColours {
    Rgba8 background, text, rule;
};

SheetColours sheet_colours(Background background) {
    if (background == Background::White) {
        return {{255, 255, 255, 255}, {40, 44, 50, 255}, {210, 213, 218, 255}};
    }
    return {{30, 33, 38, 255}, {216, 220, 226, 255}, {70, 75, 83, 255}};
}

// Returns the width below the pictures that a line can take.
double room_for_text(double width, double capitals) {
    return std::max(0.0, width - 2.0 * kCaptionMargin * capitals);
}

// Returns the longest beginning of `text` that is at most `room` wide. Characters stay whole.
std::string beginning_of(const std::string& text, double capitals, double room) {
    std::size_t end = 0;
    for (std::size_t next = 1; next <= text.size(); ++next) {
        const bool is_within = next < text.size() && (text[next] & 0xC0) == 0x80;
        if (is_within) continue;
        if (text_width(capitals, text.substr(0, next)) > room) break;
        end = next;
    }
    return text.substr(0, end);
}

// Returns the line, or a beginning of the line and "...".
std::string abbreviated(const std::string& line, double capitals, double room) {
    if (text_width(capitals, line) <= room) return line;
    const std::string dots = beginning_of("...", capitals, room);
    return beginning_of(line, capitals, room - text_width(capitals, dots)) + dots;
}

void paste(Image& sheet, const Image& picture, std::uint32_t left, std::uint32_t top) {
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        std::copy_n(&picture.at(0, y), picture.width, &sheet.at(left, top + y));
    }
}

// Cells of a sheet, in pixels.
struct Grid {
    std::uint32_t width = 0;   // of a column
    std::uint32_t height = 0;  // of the highest row
    std::uint32_t columns = 0;
    std::vector<std::uint32_t> tops;  // of the rows, and the end of the last row
};

Grid grid_of(std::span<const LabelledImage> pictures, std::span<const SheetCell> cells) {
    if (pictures.empty()) throw std::runtime_error("cannot make a sheet of no pictures");
    Grid grid;
    grid.width = pictures[0].picture.width;
    std::vector<std::uint32_t> heights;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Image& picture = pictures[i].picture;
        const auto [column, row] = cells[i];
        grid.columns = std::max(grid.columns, column + 1);
        if (row >= heights.size()) heights.resize(row + 1, 0);
        if (picture.pixels.empty() || picture.width != grid.width ||
            (heights[row] != 0 && heights[row] != picture.height))
            throw std::runtime_error("cannot make a sheet of pictures of different sizes");
        heights[row] = picture.height;
    }
    grid.tops.push_back(0);
    for (const std::uint32_t height : heights) {
        grid.height = std::max(grid.height, height);
        grid.tops.push_back(grid.tops.back() + height);
    }
    return grid;
}

}  // namespace

std::uint32_t columns_for(std::size_t pictures) {
    if (pictures <= 3) return static_cast<std::uint32_t>(pictures);
    std::uint32_t columns = 2;
    while (std::size_t{columns} * columns < pictures)
        ++columns;
    return columns;
}

Image contact_sheet(std::span<const LabelledImage> pictures, std::span<const std::string> caption,
                    Background background) {
    const std::uint32_t columns = columns_for(pictures.size());
    std::vector<SheetCell> cells;
    for (std::uint32_t i = 0; i < pictures.size(); ++i)
        cells.push_back({i % columns, i / columns});
    return contact_sheet(pictures, cells, caption, background);
}

Image contact_sheet(std::span<const LabelledImage> pictures, std::span<const SheetCell> cells,
                    std::span<const std::string> caption, Background background) {
    const Grid grid = grid_of(pictures, cells);
    const std::uint32_t rows_end = grid.tops.back();
    // The space for the caption does not depend on its text, so all frames of a film have the same
    // size.
    const double capitals = std::max(kLeastHeight, kCaptionHeight * grid.height);
    const double margin = caption.empty() ? 0.0 : kLineSpacing * capitals;
    const double text_height =
        caption.empty()
            ? 0.0
            : 2.0 * margin + kLineSpacing * capitals * static_cast<double>(caption.size() - 1);
    const std::uint64_t sheet_width = std::uint64_t{grid.width} * grid.columns;
    const std::uint64_t sheet_height =
        rows_end + 2 * static_cast<std::uint64_t>(std::ceil(0.5 * text_height));
    if (sheet_width > kMaxImageSide || sheet_height > kMaxImageSide) {
        throw std::runtime_error("the sheet would have " + std::to_string(sheet_width) + " by " +
                                 std::to_string(sheet_height) + " pixels, more than " +
                                 std::to_string(kMaxImageSide) + " along a side");
    }

    const SheetColours colours = sheet_colours(background);
    Image sheet{
        static_cast<std::uint32_t>(sheet_width), static_cast<std::uint32_t>(sheet_height), {}};
    sheet.pixels.assign(std::size_t{sheet.width} * sheet.height, colours.background);
    const double label = std::max(kLeastHeight, kLabelHeight * grid.height);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const std::uint32_t left = cells[i].column * grid.width, top = grid.tops[cells[i].row];
        paste(sheet, pictures[i].picture, left, top);
        draw_text(sheet, left + 1.5 * label, top + 2.5 * label, label, colours.text,
                  pictures[i].label);
    }
    if (caption.empty()) return sheet;
    std::fill_n(&sheet.at(0, rows_end), sheet.width, colours.rule);
    double base_line = rows_end + margin + 0.5 * capitals;
    const double left = kCaptionMargin * capitals;
    for (const std::string& line : caption) {
        draw_text(
            sheet, left, base_line, capitals, colours.text,
            abbreviated(line, capitals, room_for_text(static_cast<double>(sheet_width), capitals)));
        base_line += kLineSpacing * capitals;
    }
    return sheet;
}

std::vector<std::string> wrapped(const std::string& line, std::uint32_t width,
                                 std::uint32_t height) {
    const double capitals = std::max(kLeastHeight, kCaptionHeight * height);
    const double room = room_for_text(width, capitals);
    std::vector<std::string> lines{""};
    for (std::size_t begin = 0; begin < line.size();) {
        // A word with the spaces before it.
        std::size_t end = line.find(' ', line.find_first_not_of(' ', begin));
        end = std::min(end, line.size());
        std::string longer = lines.back() + line.substr(begin, end - begin);
        if (!lines.back().empty() && text_width(capitals, longer) > room) {
            longer = line.substr(line.find_first_not_of(' ', begin), end - begin - 1);
            lines.emplace_back();
        }
        // A word that is longer than a line.
        for (;;) {
            const std::string first = beginning_of(longer, capitals, room);
            if (first.empty() || first.size() == longer.size()) break;
            lines.back() = first;
            lines.emplace_back();
            longer.erase(0, first.size());
        }
        lines.back() = std::move(longer);
        begin = end;
    }
    return lines;
}

}  // namespace ncsim::exporter
