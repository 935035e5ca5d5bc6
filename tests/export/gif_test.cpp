// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads GIF files back with giflib's decoder and lays frame over frame, as players do.
#include "ncsim/export/gif.h"

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::exporter {
namespace {

struct Film {
    std::vector<Image> frames;  // as seen
    std::vector<int> hundredths;
    std::vector<std::size_t> pixels;  // stored for each frame
};

int read_bytes(GifFileType* file, GifByteType* bytes, int count) {
    auto& in = *static_cast<std::istream*>(file->UserData);
    in.read(reinterpret_cast<char*>(bytes), count);
    return static_cast<int>(in.gcount());
}

Film play(const std::string& bytes) {
    std::istringstream in(bytes);
    int error = 0;
    GifFileType* file = DGifOpen(&in, read_bytes, &error);
    Film film;
    if (file == nullptr || DGifSlurp(file) != GIF_OK) throw std::runtime_error("no GIF");
    Image screen{
        static_cast<std::uint32_t>(file->SWidth), static_cast<std::uint32_t>(file->SHeight), {}};
    screen.pixels.resize(std::size_t{screen.width} * screen.height);
    for (int i = 0; i < file->ImageCount; ++i) {
        const SavedImage& saved = file->SavedImages[i];
        GraphicsControlBlock control{};
        DGifSavedExtensionToGCB(file, i, &control);
        const GifImageDesc& at = saved.ImageDesc;
        for (int y = 0; y < at.Height; ++y) {
            for (int x = 0; x < at.Width; ++x) {
                const int index = saved.RasterBits[y * at.Width + x];
                if (index == control.TransparentColor) continue;
                const GifColorType c = at.ColorMap->Colors[index];
                screen.at(static_cast<std::uint32_t>(at.Left + x),
                          static_cast<std::uint32_t>(at.Top + y)) = {c.Red, c.Green, c.Blue, 255};
            }
        }
        film.frames.push_back(screen);
        film.hundredths.push_back(control.DelayTime);
        film.pixels.push_back(static_cast<std::size_t>(at.Width * at.Height));
    }
    DGifCloseFile(file, &error);
    return film;
}

std::string written(const std::vector<Image>& frames) {
    std::ostringstream out;
    GifWriter writer(out);
    for (const Image& frame : frames)
        writer.add(frame, 8);
    writer.finish();
    return out.str();
}

Image plain(std::uint32_t width, std::uint32_t height, Rgba8 colour) {
    return {width, height, std::vector<Rgba8>(std::size_t{width} * height, colour)};
}

TEST(GifWriter, FewColoursAreKeptExactly) {
    Image first = plain(20, 10, {200, 10, 30});
    first.at(3, 4) = {1, 2, 3};
    Image second = first;
    second.at(5, 6) = {250, 251, 252};
    second.at(6, 6) = {1, 2, 3};
    const Film film = play(written({first, second, second}));
    ASSERT_EQ(film.frames.size(), 3U);
    EXPECT_EQ(film.frames[0], first);
    EXPECT_EQ(film.frames[1], second);
    EXPECT_EQ(film.frames[2], second);
    EXPECT_EQ(film.hundredths[0], 8);
    // Only differences are stored: two pixels, then a single pixel for a frame without differences.
    EXPECT_EQ(film.pixels[1], 2U);
    EXPECT_EQ(film.pixels[2], 1U);
}

TEST(GifWriter, ManyColoursComeNear) {
    Image frame = plain(128, 128, {});
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) {
            frame.at(x, y) = {static_cast<std::uint8_t>(2 * x), static_cast<std::uint8_t>(2 * y),
                              static_cast<std::uint8_t>(x + y)};
        }
    }
    const Image seen = play(written({frame})).frames.at(0);
    int worst = 0;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        const Rgba8 a = frame.pixels[i];
        const Rgba8 b = seen.pixels[i];
        worst = std::max({worst, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    }
    EXPECT_LE(worst, 16);  // 255 boxes of 16384 colours in a plane: 8 by 8 colours each
}

TEST(GifWriter, RepeatsForEverAndIsTheSameEachTime) {
    const std::string bytes = written({plain(4, 4, {9, 9, 9}), plain(4, 4, {8, 8, 8})});
    EXPECT_EQ(bytes.substr(0, 6), "GIF89a");
    EXPECT_NE(bytes.find("NETSCAPE2.0"), std::string::npos);
    EXPECT_EQ(bytes, written({plain(4, 4, {9, 9, 9}), plain(4, 4, {8, 8, 8})}));
}

TEST(GifWriter, RefusesFramesOfDifferentSizesAndBrokenStreams) {
    std::ostringstream out;
    GifWriter writer(out);
    EXPECT_THROW(writer.add({}, 8), std::runtime_error);
    writer.add(plain(4, 4, {}), 8);
    EXPECT_THROW(writer.add(plain(4, 5, {}), 8), std::runtime_error);
    std::ostringstream broken;
    broken.setstate(std::ios::badbit);
    GifWriter other(broken);
    EXPECT_THROW(other.add(plain(4, 4, {}), 8), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
