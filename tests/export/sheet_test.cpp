// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests lettering, and sheets of labelled pictures.
#include "ncsim/export/contact_sheet.h"

#include "render/lettering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::exporter {
namespace {

Image plain(std::uint32_t width, std::uint32_t height, Rgba8 colour) {
    return {width, height, std::vector<Rgba8>(std::size_t{width} * height, colour)};
}

std::vector<LabelledImage> pictures(std::size_t count) {
    std::vector<LabelledImage> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back({"", plain(60, 40, {static_cast<std::uint8_t>(10 * (i + 1)), 0, 0})});
    }
    return result;
}

// Returns the pixels as rows of '#', '+' and ' ' by darkness.
std::string drawn(const Image& image) {
    std::string text(1, '\n');
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const std::uint8_t grey = image.at(x, y).r;
            text += grey < 100 ? '#' : grey < 200 ? '+' : ' ';
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

TEST(DrawText, DrawsLettersAsOneReadsThem) {
    Image image = plain(28, 17, {255, 255, 255});
    draw_text(image, 2, 14, 12, {0, 0, 0}, "N7");
    EXPECT_EQ(drawn(image), R"(

 ##        +# +############
 ##+       ## +############
 ###+      ##           ##
 ####+     ##          +#+
 ##+##     ##          ##
 ## +##    ##         ##+
 ##  +##   ##        +##
 ##   +##  ##        ##
 ##    ##+ ##       +##
 ##     ##+##       ##
 ##      ####      +#+
 ##      +###      ##
 ##       +##     +#+
 ##        ##     +#


)");
}

TEST(DrawText, CutsOffWhatIsBeyondThePicture) {
    Image image = plain(10, 10, {255, 255, 255});
    draw_text(image, -30, 5, 8, {0, 0, 0}, "MMMMMMMMMMMMMM");
    draw_text(image, 5, -100, 8, {0, 0, 0}, "M");
    draw_text(image, 5, 1e9, 8, {0, 0, 0}, "M");
    EXPECT_NE(image, plain(10, 10, {255, 255, 255}));
}

TEST(DrawText, OtherAlphabetsAreABoxPerCharacter) {
    EXPECT_EQ(text_width(10, "\xC3\xBC\xE2\x82\xAC"), text_width(10, "xy"));
}

TEST(ContactSheet, PutsUpToThreeInARowAndMoreInAGrid) {
    const auto size = [](std::size_t count) {
        const Image sheet = contact_sheet(pictures(count), {});
        return std::pair(sheet.width / 60, sheet.height / 40);
    };
    EXPECT_EQ(size(1), std::pair(1U, 1U));
    EXPECT_EQ(size(3), std::pair(3U, 1U));
    EXPECT_EQ(size(4), std::pair(2U, 2U));
    EXPECT_EQ(size(5), std::pair(3U, 2U));
    EXPECT_EQ(size(7), std::pair(3U, 3U));
}

TEST(ContactSheet, KeepsThePicturesInOrder) {
    const Image sheet = contact_sheet(pictures(4), {});
    EXPECT_EQ(sheet.at(0, 0).r, 10);
    EXPECT_EQ(sheet.at(119, 0).r, 20);
    EXPECT_EQ(sheet.at(0, 79).r, 30);
    EXPECT_EQ(sheet.at(119, 79).r, 40);
}

TEST(ContactSheet, ThereIsRoomForEachLineOfTheCaption) {
    const std::vector<std::string> lines{"pocket.nc", "60 x 40 x 15 mm"};
    const Image one = contact_sheet(pictures(2), std::span(lines).first(1), Background::Dark);
    const Image two = contact_sheet(pictures(2), lines, Background::Dark);
    EXPECT_GT(one.height, 40U);
    EXPECT_GT(two.height, one.height);
    EXPECT_EQ(one.at(0, one.height - 1), (Rgba8{30, 33, 38, 255}));
}

TEST(ContactSheet, IsAsLargeWhateverTheCaptionSays) {
    const std::vector<LabelledImage> one{{"", plain(400, 300, {255, 255, 255})}};
    const auto size = [&](const std::string& line) {
        const Image sheet = contact_sheet(one, std::vector<std::string>{"pocket.nc", line});
        return std::pair(sheet.width, sheet.height);
    };
    EXPECT_EQ(size("after line 7: " + std::string(60, 'M')), size("after line 7: G0"));
    EXPECT_EQ(size(std::string(500, 'M')), size(""));
}

TEST(ContactSheet, ALongLineLeavesTheOthersAsTheyWere) {
    const std::vector<LabelledImage> one{{"", plain(400, 300, {255, 255, 255})}};
    const Image brief = contact_sheet(one, std::vector<std::string>{"pocket.nc", ""});
    const Image full =
        contact_sheet(one, std::vector<std::string>{"pocket.nc", std::string(60, 'M')});
    const auto above = static_cast<std::ptrdiff_t>(std::size_t{400} * (300 + 24));
    EXPECT_TRUE(
        std::equal(brief.pixels.begin(), brief.pixels.begin() + above, full.pixels.begin()));
    EXPECT_NE(brief, full);
}

TEST(ContactSheet, PicturesAreInTheirCells) {
    std::vector<LabelledImage> three;
    for (const std::uint8_t shade : {std::uint8_t{10}, std::uint8_t{20}, std::uint8_t{30}})
        three.push_back({"", plain(60, shade == 30 ? 12 : 40, {shade, shade, shade})});
    const std::vector<SheetCell> cells{{1, 0}, {0, 0}, {0, 1}};
    const Image sheet = contact_sheet(three, cells, {}, Background::White);
    EXPECT_EQ(sheet.width, 120U);
    EXPECT_EQ(sheet.height, 52U);
    EXPECT_EQ(sheet.at(119, 39).r, 10);
    EXPECT_EQ(sheet.at(0, 39).r, 20);
    EXPECT_EQ(sheet.at(0, 51).r, 30);
    EXPECT_EQ(sheet.at(119, 51).r, 255);
    // Rows have one height.
    EXPECT_THROW(
        contact_sheet(three, std::vector<SheetCell>{{1, 0}, {0, 1}, {1, 1}}, {}, Background::White),
        std::runtime_error);
}

// Video formats need an even number of rows.
TEST(ContactSheet, HasAnEvenNumberOfRows) {
    const std::vector<std::string> lines{"a", "b", "c", "d"};
    for (const std::uint32_t height : {200U, 300U, 302U, 334U, 400U, 960U}) {
        const std::vector<LabelledImage> one{{"", plain(400, height, {255, 255, 255})}};
        for (std::size_t n = 1; n <= lines.size(); ++n)
            EXPECT_EQ(contact_sheet(one, std::span(lines).first(n)).height % 2, 0U);
    }
}

TEST(ContactSheet, WrapsLongLinesAtSpaces) {
    const std::string text = "error: the cutter of T1 meets the fixture 'rear jaw' in line 6";
    EXPECT_EQ(wrapped(text, 4000, 300), (std::vector<std::string>{text}));
    const std::vector<std::string> lines = wrapped(text, 300, 300);
    EXPECT_GT(lines.size(), 1U);
    std::string joined;
    for (const std::string& line : lines) {
        EXPECT_LT(text_width(7.0, line), 300);
        joined += (joined.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(joined, text);
    // A long word, of ASCII or of letters with two bytes.
    for (const std::string letter : {"M", "\xC3\xA4"}) {
        std::string word;
        for (int i = 0; i < 200; ++i)
            word += letter;
        std::string parts;
        for (const std::string& line : wrapped("x " + word, 100, 100)) {
            EXPECT_LE(text_width(7.0, line), 100.0 - 2.0 * 1.5 * 7.0);
            EXPECT_EQ(line.size() % letter.size(), line == "x" ? 1 % letter.size() : 0U);
            parts += line;
        }
        EXPECT_EQ(parts, "x" + word);
    }
    EXPECT_EQ(wrapped("", 100, 100), (std::vector<std::string>{""}));
}

TEST(ContactSheet, RefusesWhatCannotBe) {
    EXPECT_THROW(contact_sheet({}, {}), std::runtime_error);
    auto mixed = pictures(2);
    mixed[1].picture = plain(60, 41, {});
    EXPECT_THROW(contact_sheet(mixed, {}), std::runtime_error);
    std::vector<LabelledImage> wide(2, {"", plain(kMaxImageSide / 2 + 1, 1, {})});
    EXPECT_THROW(contact_sheet(wide, {}), std::runtime_error);
}

// All lines have letters of one size; a line that does not fit ends in "...".
TEST(ContactSheet, LinesThatDoNotFitAreAbbreviated) {
    const std::vector<LabelledImage> one{{"", plain(600, 600, {255, 255, 255})}};
    const auto sheet = [&](const std::string& line) {
        return contact_sheet(one, std::vector<std::string>{line});
    };
    const double capitals = 600 / 46.0;
    std::string longest;
    while (text_width(capitals, longest + "M") <= 600 - 3.0 * capitals)
        longest += "M";
    const std::string shown = longest.substr(3) + "...";
    EXPECT_EQ(sheet(std::string(200, 'M')), sheet(shown));
    EXPECT_EQ(sheet(longest + "MM"), sheet(shown));
    EXPECT_NE(sheet(longest), sheet(shown));
    EXPECT_EQ(sheet(longest + "M").height, sheet("").height);
    // Nothing fits.
    const std::vector<LabelledImage> narrow{{"", plain(8, 60, {255, 255, 255})}};
    EXPECT_EQ(contact_sheet(narrow, std::vector<std::string>{"MM"}),
              contact_sheet(narrow, std::vector<std::string>{""}));
}

}  // namespace
}  // namespace ncsim::exporter
