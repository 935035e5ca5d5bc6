// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares pixels with golden pictures, or rewrites the pictures.
#include "support/golden.h"

#include "ncsim/export/png.h"

#include "support/read_png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace ncsim::test {

namespace {

// Largest permitted difference of a colour channel. One pixel in kAllowedShare may differ by more.
constexpr int kTolerance = 16;
constexpr std::size_t kAllowedShare = 200;

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

}  // namespace

void expect_like_golden(const exporter::Image& image, const std::string& file) {
    const std::string golden_path = std::string(NCSIM_SOURCE_DIR "/tests/") + file;
    if (std::getenv("NCSIM_UPDATE_GOLDENS") != nullptr) {
        std::ofstream out(golden_path, std::ios::binary);
        exporter::write_png(out, image);
    }
    const exporter::Image golden = read_png(bytes_of(golden_path));
    ASSERT_EQ(image.width, golden.width);
    ASSERT_EQ(image.height, golden.height);
    std::size_t different = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const exporter::Rgba8 a = image.pixels[i];
        const exporter::Rgba8 b = golden.pixels[i];
        const int difference =
            std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        different += difference > kTolerance ? 1 : 0;
    }
    if (different <= image.pixels.size() / kAllowedShare) return;
    const std::string actual_path =
        testing::TempDir() + std::filesystem::path(file).stem().string() + ".actual.png";
    std::ofstream out(actual_path, std::ios::binary);
    exporter::write_png(out, image);
    ADD_FAILURE() << different << " pixels of " << actual_path << " are not as in " << golden_path;
}

}  // namespace ncsim::test
