// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes each frame in three steps:
//  1. Find the rectangle in which the frame differs from the frame before (changed_region()).
//  2. Collect the colours of the changed pixels; reduce more than 255 colours by median cut.
//  3. Write the rectangle, with unchanged pixels transparent.
// Source: Heckbert, Color Image Quantization for Frame Buffer Display, 1982.
#include "ncsim/export/gif.h"

#include "render/frame_change.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::exporter {

namespace {

// The last entry of each palette is for transparent pixels.
constexpr std::size_t kColours = 255;
constexpr GifByteType kTransparent = 255;
constexpr std::uint32_t kMaxGifSide = 65535;

using Rgb = std::array<std::uint8_t, 3>;

Rgb rgb(Rgba8 pixel) {
    return {pixel.r, pixel.g, pixel.b};
}

struct Colour {
    Rgb rgb{};
    std::uint64_t count = 0;
    GifByteType index = 0;
};

// Colours that share an entry of the palette.
struct ColourBox {
    std::span<Colour> colours;
    std::size_t widest = 0;    // channel
    std::uint64_t spread = 0;  // of that channel, times the number of pixels

    explicit ColourBox(std::span<Colour> of) : colours(of) {
        std::uint64_t pixels = 0;
        Rgb low{255, 255, 255};
        Rgb high{};
        for (const Colour& c : colours) {
            pixels += c.count;
            for (std::size_t i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], c.rgb[i]);
                high[i] = std::max(high[i], c.rgb[i]);
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint64_t range = static_cast<std::uint64_t>(high[i] - low[i]) * pixels;
            if (range > spread) spread = range, widest = i;
        }
    }

    std::pair<ColourBox, ColourBox> halves() const {
        std::stable_sort(colours.begin(), colours.end(), [&](const Colour& a, const Colour& b) {
            return a.rgb[widest] < b.rgb[widest];
        });
        std::uint64_t pixels = 0;
        for (const Colour& c : colours)
            pixels += c.count;
        std::size_t split = 0;
        for (std::uint64_t below = 0; split + 1 < colours.size(); ++split) {
            if (split > 0 && 2 * below >= pixels) break;
            below += colours[split].count;
        }
        return {ColourBox(colours.first(split)), ColourBox(colours.subspan(split))};
    }

    GifColorType mean() const {
        std::array<std::uint64_t, 3> sum{};
        std::uint64_t pixels = 0;
        for (const Colour& c : colours) {
            pixels += c.count;
            for (std::size_t i = 0; i < 3; ++i)
                sum[i] += c.count * c.rgb[i];
        }
        const auto channel = [&](std::size_t i) {
            return static_cast<GifByteType>((sum[i] + pixels / 2) / pixels);
        };
        return {channel(0), channel(1), channel(2)};
    }
};

// Step 2: returns a palette and sets the index of each colour.
std::array<GifColorType, 256> palette_for(std::vector<Colour>& colours) {
    std::array<GifColorType, 256> palette{};
    if (colours.empty()) return palette;
    std::vector<ColourBox> boxes{ColourBox(colours)};
    while (boxes.size() < kColours) {
        const auto largest = std::max_element(
            boxes.begin(), boxes.end(),
            [](const ColourBox& a, const ColourBox& b) { return a.spread < b.spread; });
        if (largest->spread == 0) break;
        auto [lower, upper] = largest->halves();
        *largest = lower;
        boxes.push_back(upper);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        palette[i] = boxes[i].mean();
        for (Colour& c : boxes[i].colours)
            c.index = static_cast<GifByteType>(i);
    }
    std::sort(colours.begin(), colours.end(),
              [](const Colour& a, const Colour& b) { return a.rgb < b.rgb; });
    return palette;
}

std::vector<Colour> colours_of(std::vector<Rgb> pixels) {
    std::sort(pixels.begin(), pixels.end());
    std::vector<Colour> colours;
    for (const Rgb& pixel : pixels) {
        if (colours.empty() || colours.back().rgb != pixel) colours.push_back({pixel, 0, 0});
        ++colours.back().count;
    }
    return colours;
}

int write_bytes(GifFileType* file, const GifByteType* bytes, int count) {
    auto& out = *static_cast<std::ostream*>(file->UserData);
    out.write(reinterpret_cast<const char*>(bytes), count);
    return out ? count : 0;
}

[[noreturn]] void fail(const std::string& why) {
    throw std::runtime_error("cannot write GIF: " + why);
}

void check(int result) {
    if (result != GIF_OK) fail("the stream failed");
}

}  // namespace

struct GifWriter::State {
    GifFileType* file = nullptr;
    Image last;

    ~State() {
        int ignored = 0;
        if (file != nullptr) EGifCloseFile(file, &ignored);
    }

    void begin(const Image& frame) const {
        if (frame.pixels.empty()) fail("a frame has no pixels");
        if (frame.width > kMaxGifSide || frame.height > kMaxGifSide) {
            fail("a frame has more than 65535 pixels along a side");
        }
        EGifSetGifVersion(file, true);
        check(EGifPutScreenDesc(file, static_cast<int>(frame.width), static_cast<int>(frame.height),
                                8, 0, nullptr));
        // An extension by Netscape, supported by all players, makes the animation repeat.
        constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
        check(EGifPutExtensionLeader(file, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(file, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(file, kForEver.size(), kForEver.data()));
        check(EGifPutExtensionTrailer(file));
    }

    // Step 3. `is_new` is true for pixels that differ from the frame before.
    template <typename IsNew>
    void put(const Image& frame, const FrameRegion& r, int hundredths, IsNew is_new) const {
        std::vector<Rgb> changed;
        for (std::uint32_t y = r.top; y < r.bottom; ++y) {
            for (std::uint32_t x = r.left; x < r.right; ++x) {
                if (is_new(x, y)) changed.push_back(rgb(frame.at(x, y)));
            }
        }
        std::vector<Colour> colours = colours_of(std::move(changed));
        const auto palette = palette_for(colours);

        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths, kTransparent};
        std::array<GifByteType, 4> bytes{};
        EGifGCBToExtension(&control, bytes.data());
        check(EGifPutExtension(file, GRAPHICS_EXT_FUNC_CODE, bytes.size(), bytes.data()));
        ColorMapObject* map = GifMakeMapObject(256, palette.data());
        if (map == nullptr) fail("no memory for its colours");
        const auto side = [](std::uint32_t n) { return static_cast<int>(n); };
        const int described =
            EGifPutImageDesc(file, side(r.left), side(r.top), side(r.right - r.left),
                             side(r.bottom - r.top), false, map);
        GifFreeMapObject(map);
        check(described);
        std::vector<GifByteType> row(r.right - r.left);
        for (std::uint32_t y = r.top; y < r.bottom; ++y) {
            for (std::uint32_t x = r.left; x < r.right; ++x) {
                GifByteType& to = row[x - r.left];
                to = kTransparent;
                if (!is_new(x, y)) continue;
                const auto found = std::lower_bound(
                    colours.begin(), colours.end(), rgb(frame.at(x, y)),
                    [](const Colour& c, const Rgb& value) { return c.rgb < value; });
                to = found->index;
            }
            check(EGifPutLine(file, row.data(), static_cast<int>(row.size())));
        }
    }
};

GifWriter::GifWriter(std::ostream& out) : state_(std::make_unique<State>()) {
    int error = 0;
    state_->file = EGifOpen(&out, write_bytes, &error);
    if (state_->file == nullptr) fail("giflib gives up");
}

GifWriter::~GifWriter() = default;

void GifWriter::add(const Image& frame, int hundredths) {
    if (state_->last.pixels.empty()) {
        state_->begin(frame);
        state_->put(frame, {0, 0, frame.width, frame.height}, hundredths,
                    [](std::uint32_t, std::uint32_t) { return true; });
    } else {
        const Image& last = state_->last;
        if (frame.width != last.width || frame.height != last.height) {
            fail("its frames differ in size");
        }
        state_->put(
            frame, changed_region(last, frame), hundredths,
            [&](std::uint32_t x, std::uint32_t y) { return frame.at(x, y) != last.at(x, y); });
    }
    state_->last = frame;
}

void GifWriter::finish() {
    int error = 0;
    if (EGifCloseFile(std::exchange(state_->file, nullptr), &error) != GIF_OK) {
        fail("the stream failed");
    }
}

}  // namespace ncsim::exporter
