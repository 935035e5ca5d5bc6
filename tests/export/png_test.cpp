// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests PNG files by reading them with libpng.
#include "ncsim/export/png.h"

#include "support/read_png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <sstream>
#include <streambuf>
#include <string>

namespace ncsim::exporter {
namespace {

Image chequered(std::uint32_t width, std::uint32_t height, std::uint8_t alpha) {
    Image image{width, height, {}};
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            image.pixels.push_back({static_cast<std::uint8_t>(7 * x),
                                    static_cast<std::uint8_t>(5 * y),
                                    static_cast<std::uint8_t>(x ^ y), alpha});
        }
    }
    return image;
}

std::string written(const Image& image) {
    std::ostringstream out;
    write_png(out, image);
    return out.str();
}

// Stream buffer that accepts `room` bytes and then fails, like a full disk.
class FullDisk : public std::streambuf {
public:
    explicit FullDisk(std::streamsize room) : room_(room) {}

protected:
    std::streamsize xsputn(const char*, std::streamsize count) override {
        const std::streamsize taken = std::min(count, room_);
        room_ -= taken;
        return taken;
    }
    int_type overflow(int_type c) override { return room_-- > 0 ? c : traits_type::eof(); }

private:
    std::streamsize room_;
};

TEST(WritePng, ReadsBackAsItWas) {
    for (const auto& image : {chequered(1, 1, 255), chequered(31, 7, 255), chequered(5, 40, 90)}) {
        EXPECT_EQ(test::read_png(written(image)), image);
    }
}

TEST(WritePng, OpaquePicturesHaveNoAlphaChannel) {
    constexpr std::size_t kColourType = 25;  // signature, IHDR's head, width, height, depth
    EXPECT_EQ(written(chequered(3, 3, 255))[kColourType], PNG_COLOR_TYPE_RGB);
    EXPECT_EQ(written(chequered(3, 3, 254))[kColourType], PNG_COLOR_TYPE_RGBA);
}

TEST(WritePng, HasNoTimeAndNoText) {
    const std::string bytes = written(chequered(9, 9, 255));
    for (const char* chunk : {"tIME", "tEXt", "iTXt", "zTXt"}) {
        EXPECT_EQ(bytes.find(chunk), std::string::npos) << chunk;
    }
}

TEST(WritePng, RefusesAPictureWithoutPixels) {
    std::ostringstream out;
    EXPECT_THROW(write_png(out, Image{}), std::runtime_error);
    EXPECT_EQ(out.str(), "");
}

TEST(WritePng, TellsThatTheDiskIsFullWhereverThatHappens) {
    const Image image = chequered(100, 100, 255);
    const auto size = static_cast<std::streamsize>(written(image).size());
    for (std::streamsize room = 0; room < size; room += 37) {
        FullDisk disk(room);
        std::ostream out(&disk);
        EXPECT_THROW(write_png(out, image), std::runtime_error);
    }
}

TEST(WritePng, PassesOnWhatTheStreamThrows) {
    FullDisk disk(50);
    std::ostream out(&disk);
    out.exceptions(std::ios::badbit);
    EXPECT_THROW(write_png(out, chequered(100, 100, 255)), std::ios_base::failure);
}

}  // namespace
}  // namespace ncsim::exporter
