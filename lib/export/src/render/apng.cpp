// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the chunks of APNG files, which libpng cannot write.
#include "ncsim/export/apng.h"

#include "render/frame_change.h"

#include <zlib.h>

#include <ostream>
#include <stdexcept>
#include <string_view>

namespace ncsim::exporter {

namespace {

// Level of zlib, equal to the level in png.cpp.
constexpr int kApngEffort = 5;

[[noreturn]] void refuse_apng(const std::string& why) {
    throw std::runtime_error("cannot write APNG: " + why);
}

// Appends `number` with `size` bytes, the most significant byte first.
void append_big_endian(std::string& bytes, std::uint32_t number, int size) {
    for (int i = size - 1; i >= 0; --i)
        bytes.push_back(static_cast<char>((number >> (8 * i)) & 0xFFU));
}

void write_chunk(std::ostream& out, std::string_view type, std::string_view content) {
    std::string bytes;
    append_big_endian(bytes, static_cast<std::uint32_t>(content.size()), 4);
    bytes += type;
    bytes += content;
    const uLong check = crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + 4),
                              static_cast<uInt>(bytes.size() - 4));
    append_big_endian(bytes, static_cast<std::uint32_t>(check), 4);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// Returns the compressed rows of the region. Each row begins with the filter type None.
std::string packed(const Image& image, const FrameRegion& region) {
    std::string rows;
    rows.reserve(std::size_t{region.height()} * (3 * std::size_t{region.width()} + 1));
    for (std::uint32_t y = region.top; y < region.bottom; ++y) {
        rows.push_back('\0');
        for (std::uint32_t x = region.left; x < region.right; ++x) {
            const Rgba8& pixel = image.at(x, y);
            for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b})
                rows.push_back(static_cast<char>(channel));
        }
    }
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                  reinterpret_cast<const Bytef*>(rows.data()), static_cast<uLong>(rows.size()),
                  kApngEffort) != Z_OK)
        refuse_apng("zlib gave up");
    result.resize(size);
    return result;
}

}  // namespace

void ApngWriter::add(const Image& frame, int hundredths) {
    if (frame.pixels.empty()) refuse_apng("a frame has no pixels");
    if (!frames_.empty() && (frame.width != last_.width || frame.height != last_.height))
        refuse_apng("its frames differ in size");
    const FrameRegion region = frames_.empty() ? FrameRegion{0, 0, frame.width, frame.height}
                                               : changed_region(last_, frame);
    frames_.push_back({region.left, region.top, region.width(), region.height(), hundredths,
                       packed(frame, region)});
    last_ = frame;
}

void ApngWriter::write(std::ostream& out) const {
    out << "\x89PNG\r\n\x1a\n";
    std::string header;
    append_big_endian(header, last_.width, 4);
    append_big_endian(header, last_.height, 4);
    constexpr char kRgb8[] = {8, 2, 0, 0, 0};  // bits, RGB, deflate, filters, not interlaced
    header.append(kRgb8, sizeof kRgb8);
    write_chunk(out, "IHDR", header);
    std::string animation;
    append_big_endian(animation, static_cast<std::uint32_t>(frames_.size()), 4);
    append_big_endian(animation, 0, 4);  // repetitions: for ever
    write_chunk(out, "acTL", animation);
    write_chunk(out, "sRGB", std::string_view("\0", 1));  // perceptual
    std::uint32_t sequence = 0;
    for (const Frame& frame : frames_) {
        std::string control;
        for (const std::uint32_t number :
             {sequence, frame.width, frame.height, frame.left, frame.top})
            append_big_endian(control, number, 4);
        ++sequence;
        append_big_endian(control, static_cast<std::uint32_t>(frame.hundredths), 2);
        append_big_endian(control, 100, 2);  // parts of a second
        append_big_endian(control, 0, 2);    // the frame stays and replaces the rectangle
        write_chunk(out, "fcTL", control);
        if (&frame == frames_.data()) {
            write_chunk(out, "IDAT", frame.pixels);
            continue;
        }
        std::string content;
        append_big_endian(content, sequence++, 4);
        write_chunk(out, "fdAT", content + frame.pixels);
    }
    write_chunk(out, "IEND", {});
    if (!out) refuse_apng("the stream failed");
}

}  // namespace ncsim::exporter
