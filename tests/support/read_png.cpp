// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decodes PNG files.
#include "support/read_png.h"

#include <png.h>

#include <stdexcept>

namespace ncsim::test {

exporter::Image read_png(const std::string& bytes) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
        throw std::runtime_error(header.message);
    }
    header.format = PNG_FORMAT_RGBA;
    exporter::Image image{header.width, header.height, {}};
    image.pixels.resize(std::size_t{header.width} * header.height);
    if (png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr) == 0) {
        throw std::runtime_error(header.message);
    }
    return image;
}

}  // namespace ncsim::test
