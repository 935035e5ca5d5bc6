// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which colour a face has: one for uncut stock, one for each tool, the same in every format.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/provenance.h"

#include <cstdint>
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

/// The colours of a scale from 0 to 1: yellow, green, blue, violet, ever darker, so that the order
/// can be seen without telling hues apart. Numbers beyond are clamped.
LinearColour scale_colour(double t);

/// The tools of a program, each with a colour. Tools are coloured by their rank among the tools
/// used, so neighbours in a program differ even where numbers are far apart; from the ninth tool
/// on colours come again.
class Palette {
public:
    explicit Palette(const Provenance& provenance);

    Rgba8 colour(Provenance::Entry entry) const;
    /// Tools in the order of their numbers; 0, the stock, always first.
    const std::vector<std::uint32_t>& tools() const { return tools_; }
    /// Position of the tool in `tools`; that of the stock for a tool that is not there.
    std::size_t rank(std::uint32_t tool) const;

private:
    std::vector<std::uint32_t> tools_;
};

}  // namespace ncsim::exporter
