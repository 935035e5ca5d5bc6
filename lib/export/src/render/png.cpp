// SPDX-License-Identifier: GPL-3.0-or-later
//
// libpng reports errors by longjmp, which must not jump over C++ objects. Therefore `encode`
// creates no object after its setjmp, and exceptions of the stream are caught before they reach
// libpng.
#include "ncsim/export/png.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <exception>
#include <ostream>
#include <stdexcept>
#include <string>

namespace ncsim::exporter {

namespace {

// Compression level of zlib, 1 to 9. Above 5, time grows faster than files shrink.
constexpr int kEffort = 5;

struct Sink {
    std::ostream& out;
    std::exception_ptr thrown;  // exception of the stream
    std::string message;        // message of libpng
};

void on_error(png_structp png, png_const_charp message) {
    auto* sink = static_cast<Sink*>(png_get_error_ptr(png));
    try {
        sink->message = message;
    } catch (...) {
        sink->thrown = std::current_exception();
    }
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void write_bytes(png_structp png, png_bytep bytes, png_size_t count) {
    auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
    bool written = false;
    try {
        sink->out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
        written = sink->out.good();
    } catch (...) {
        sink->thrown = std::current_exception();
    }
    if (!written) png_error(png, "the stream cannot be written");
}

void flush(png_structp) {}

// Owns the two structs of libpng.
class Encoder {
public:
    explicit Encoder(Sink& sink)
        : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, on_error, on_warning)),
          info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
        if (png_ != nullptr) png_set_write_fn(png_, &sink, write_bytes, flush);
    }
    ~Encoder() { png_destroy_write_struct(&png_, &info_); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    bool is_ready() const { return info_ != nullptr; }
    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

private:
    png_structp png_;
    png_infop info_;
};

// Packs row `y` into `row`, with alpha or without. The row has a byte more than its pixels.
void pack_row(const Image& image, std::uint32_t y, bool has_alpha, png_byte* row) {
    static_assert(sizeof(Rgba8) == 4);
    // Each pixel overwrites the alpha of the pixel before.
    const std::ptrdiff_t step = has_alpha ? 4 : 3;
    const Rgba8* const pixels = &image.at(0, y);
    for (std::uint32_t x = 0; x < image.width; ++x)
        std::memcpy(row + step * x, pixels + x, sizeof(Rgba8));
}

// Returns false if libpng failed; the reason is in the sink. No object with a destructor may be
// created here.
bool encode(const Encoder& encoder, const Image& image, bool has_alpha, png_byte* row) {
    png_structp png = encoder.png();
    png_infop info = encoder.info();
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_IHDR(png, info, image.width, image.height, 8,
                 has_alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // Rows of one colour repeat without a filter. The choice of a filter for each row takes longer
    // than compression, and pictures with large areas of one colour become larger.
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_compression_level(png, kEffort);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        pack_row(image, y, has_alpha, row);
        png_write_row(png, row);
    }
    png_write_end(png, info);
    return true;
}

}  // namespace

void write_png(std::ostream& out, const Image& image) {
    if (image.pixels.empty()) throw std::runtime_error("cannot write a picture without pixels");
    const bool has_alpha = std::any_of(image.pixels.begin(), image.pixels.end(),
                                       [](const Rgba8& pixel) { return pixel.a != 255; });
    Sink sink{out, nullptr, {}};
    const Encoder encoder(sink);
    if (!encoder.is_ready()) throw std::runtime_error("cannot write PNG: libpng does not start");
    std::vector<png_byte> row(std::size_t{image.width} * (has_alpha ? 4 : 3) + 1);
    if (encode(encoder, image, has_alpha, row.data())) return;
    if (sink.thrown) std::rethrow_exception(sink.thrown);
    throw std::runtime_error("cannot write PNG: " + sink.message);
}

}  // namespace ncsim::exporter
