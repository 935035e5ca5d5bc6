// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which colour a face has: one for uncut stock, one for each tool, one for the tool of a program
// that calls none; the same in every format.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/provenance.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// Light is added up in linear terms and stored as sRGB. The curve between them is
/// taken to be a plain square: close to the real one, and exact arithmetic on every machine, which
/// a power function is not.
struct LinearColour {
    float r = 0, g = 0, b = 0;

    friend LinearColour operator+(LinearColour a, LinearColour b) {
        return {a.r + b.r, a.g + b.g, a.b + b.b};
    }
    friend LinearColour operator*(float s, LinearColour a) { return {s * a.r, s * a.g, s * a.b}; }
};

LinearColour to_linear(Rgba8 colour);
Rgba8 to_srgb(LinearColour colour);

/// A channel from 0 to 1, in whole thousandths, which every format writes the same.
inline double unit_share(std::uint8_t channel) {
    const int thousandths = channel * 1000 / 255;
    return static_cast<double>(thousandths) / 1000.0;
}

/// The linear share, 0 to 1, of a channel in sRGB (IEC 61966-2-1), as glTF files have it. Computed
/// without powers of the C library: the same on every machine.
double linear_share(std::uint8_t channel);

/// The colours of a scale from 0 to 1: yellow, green, blue, violet, ever darker, so that the order
/// can be seen without telling hues apart. Numbers beyond are clamped.
LinearColour scale_colour(double t);

/// Who left a face.
struct Maker {
    bool is_tool = false;    ///< Else nobody: it is the stock's own.
    std::uint32_t tool = 0;  ///< Its number; 0 where the program calls none.

    explicit Maker(Provenance::Entry entry) : is_tool(!entry.is_stock()), tool(entry.tool) {}
    auto operator<=>(const Maker&) const = default;

    /// "stock", "T3", "T0".
    std::string name() const;
};

/// The stock and the tools of a program, each with a colour. Tools are coloured by their rank among
/// the numbers used, so neighbours in a program differ even where numbers are far apart; from the
/// ninth on colours come again. Tool 0 has a colour of its own.
class Palette {
public:
    explicit Palette(const Provenance& provenance);

    Rgba8 colour(Maker maker) const;
    Rgba8 colour(Provenance::Entry entry) const { return colour(Maker(entry)); }
    /// The stock, whether there is a face of it or not, then tools in the order of their numbers.
    const std::vector<Maker>& makers() const { return makers_; }
    /// Position of the maker in makers(); that of the stock for a tool that is not there.
    std::size_t rank(Maker maker) const;
    std::size_t rank(Provenance::Entry entry) const { return rank(Maker(entry)); }

private:
    std::vector<Maker> makers_;
    std::size_t first_numbered_ = 1;  // in makers_
};

}  // namespace ncsim::exporter
