// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads APNG files back, chunk by chunk, and lays frame over frame, as players do.
#include "ncsim/export/apng.h"

#include "../support/read_png.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::exporter {
namespace {

struct Film {
    std::vector<Image> frames;  // as seen
    std::vector<double> seconds;
    std::vector<std::size_t> pixels;  // stored for each frame
    std::uint32_t announced = 0, repetitions = 1;
};

std::uint32_t number_at(const std::string& bytes, std::size_t at, std::size_t size = 4) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < size; ++i)
        number = number << 8U | static_cast<std::uint8_t>(bytes.at(at + i));
    return number;
}

std::string inflated(const std::string& packed, std::size_t size) {
    std::string rows(size, '\0');
    uLongf length = size;
    if (uncompress(reinterpret_cast<Bytef*>(rows.data()), &length,
                   reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
        length != size)
        throw std::runtime_error("not the pixels of the frame");
    return rows;
}

class Player {
public:
    Film play(const std::string& bytes) {
        if (bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n") throw std::runtime_error("no PNG");
        for (std::size_t at = 8; at < bytes.size();) {
            const std::size_t size = number_at(bytes, at);
            const std::string type = bytes.substr(at + 4, 4), content = bytes.substr(at + 8, size);
            const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + at + 4),
                                    static_cast<uInt>(4 + size));
            if (sum != number_at(bytes, at + 8 + size)) throw std::runtime_error("checksum");
            take(type, content);
            at += 12 + size;
        }
        return std::move(film_);
    }

private:
    void take(const std::string& type, const std::string& content) {
        if (type == "IHDR") {
            screen_ = {number_at(content, 0), number_at(content, 4), {}};
            screen_.pixels.resize(std::size_t{screen_.width} * screen_.height);
        } else if (type == "acTL") {
            film_.announced = number_at(content, 0);
            film_.repetitions = number_at(content, 4);
        } else if (type == "fcTL") {
            expect_next(content);
            control_ = content;
            film_.seconds.push_back(static_cast<double>(number_at(content, 20, 2)) /
                                    number_at(content, 22, 2));
        } else if (type == "IDAT") {
            lay(content);
        } else if (type == "fdAT") {
            expect_next(content);
            lay(content.substr(4));
        }
    }

    void expect_next(const std::string& content) {
        EXPECT_EQ(number_at(content, 0), sequence_);
        ++sequence_;
    }

    void lay(const std::string& packed) {
        const std::uint32_t width = number_at(control_, 4), height = number_at(control_, 8);
        const std::uint32_t left = number_at(control_, 12), top = number_at(control_, 16);
        const std::string rows = inflated(packed, std::size_t{height} * (3 * width + 1));
        std::size_t i = 0;
        for (std::uint32_t y = 0; y < height; ++y) {
            EXPECT_EQ(rows[i++], 0);  // no filter
            for (std::uint32_t x = 0; x < width; ++x, i += 3)
                screen_.at(left + x, top + y) = {static_cast<std::uint8_t>(rows[i]),
                                                 static_cast<std::uint8_t>(rows[i + 1]),
                                                 static_cast<std::uint8_t>(rows[i + 2])};
        }
        film_.frames.push_back(screen_);
        film_.pixels.push_back(std::size_t{width} * height);
    }

    Film film_;
    Image screen_;
    std::string control_;
    std::uint32_t sequence_ = 0;
};

Image frame(std::uint32_t width, std::uint32_t height, std::uint8_t shade) {
    Image image{width, height, {}};
    for (std::uint32_t i = 0; i < width * height; ++i)
        image.pixels.push_back(
            {shade, static_cast<std::uint8_t>(i % 251), static_cast<std::uint8_t>(i / 251 % 256)});
    return image;
}

std::string written(const ApngWriter& writer) {
    std::ostringstream out;
    writer.write(out);
    return std::move(out).str();
}

TEST(Apng, KeepsEveryColourOfEveryFrame) {
    Image second = frame(40, 30, 7);
    second.at(3, 5) = {1, 2, 3};
    second.at(6, 9) = {4, 5, 6};
    const Image third = frame(40, 30, 200);
    ApngWriter writer;
    writer.add(frame(40, 30, 7), 8);
    writer.add(second, 8);
    writer.add(second, 25);
    writer.add(third, 200);
    const std::string bytes = written(writer);
    const Film film = Player().play(bytes);
    EXPECT_EQ(film.announced, 4U);
    EXPECT_EQ(film.repetitions, 0U);  // for ever
    ASSERT_EQ(film.frames.size(), 4U);
    EXPECT_TRUE(film.frames[0] == frame(40, 30, 7));
    EXPECT_TRUE(film.frames[1] == second);
    EXPECT_TRUE(film.frames[2] == second);
    EXPECT_TRUE(film.frames[3] == third);
    EXPECT_EQ(film.seconds, (std::vector<double>{0.08, 0.08, 0.25, 2.0}));
    // Only the rectangle that changes is kept.
    EXPECT_EQ(film.pixels, (std::vector<std::size_t>{1200, 4 * 5, 1, 1200}));
    EXPECT_EQ(written(writer), bytes);
}

TEST(Apng, OtherProgramsReadTheFirstFrame) {
    ApngWriter writer;
    writer.add(frame(33, 17, 90), 8);
    writer.add(frame(33, 17, 91), 8);
    EXPECT_TRUE(test::read_png(written(writer)) == frame(33, 17, 90));
}

TEST(Apng, RefusesFramesOfOtherSizesAndStreamsThatFail) {
    ApngWriter writer;
    EXPECT_THROW(writer.add({}, 8), std::runtime_error);
    writer.add(frame(4, 3, 0), 8);
    EXPECT_THROW(writer.add(frame(3, 4, 0), 8), std::runtime_error);
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(writer.write(out), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
