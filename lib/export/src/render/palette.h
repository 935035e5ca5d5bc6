// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of faces: for uncut stock, for each tool, and for cuts without a tool call. All formats
// use the same colours.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/mesh/provenance.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// Colour in linear values, in which light adds up; stored colours are sRGB. The curve between both
/// is approximated by a square, which is close and, unlike a power function, exact on every
/// machine.
struct LinearColour {
    float r = 0, g = 0, b = 0;

    friend LinearColour operator+(LinearColour one, LinearColour other) {
        return {one.r + other.r, one.g + other.g, one.b + other.b};
    }
    friend LinearColour operator*(float s, LinearColour c) { return {s * c.r, s * c.g, s * c.b}; }
};

/// Returns `channel`, from 0 to 255, rounded. The sum of a float and a half is exact as a double.
inline std::uint8_t rounded(float channel) {
    constexpr double kHalf = 0.5;
    return static_cast<std::uint8_t>(static_cast<double>(channel) + kHalf);
}

/// Converts between sRGB and linear colours.
LinearColour to_linear(Rgba8 colour);
Rgba8 to_srgb(LinearColour colour);

/// Returns a channel as a value from 0 to 1 in whole thousandths, which every format writes the
/// same.
inline double unit_share(std::uint8_t channel) {
    const int thousandths = channel * 1000 / 255;
    return static_cast<double>(thousandths) / 1000.0;
}

/// Returns the linear value from 0 to 1 of an sRGB channel, as glTF files store colours. The
/// computation does not use the power function of the C library, so the result is the same on every
/// machine.
/// Source: IEC 61966-2-1.
double linear_share(std::uint8_t channel);

/// Returns the colour at `t` of a scale from 0 to 1: yellow, green, blue, violet, ever darker, so
/// the order is visible without hues. `t` is clamped to [0, 1].
LinearColour scale_colour(double t);

/// Returns the colour of a distance (mm) from the design: green up to `tolerance`, yellow to red
/// where the part is cut into the design (negative), light to dark blue where material is left.
/// The colours end at `largest`.
LinearColour distance_colour(double mm, double tolerance, double largest);

/// The tool that cut a face, or the stock.
struct FaceSource {
    bool is_tool = false;    ///< False: an uncut face of the stock.
    std::uint32_t tool = 0;  ///< Number of the tool; 0 if the program calls no tool.

    explicit FaceSource(mesh::Provenance::Entry entry)
        : is_tool(!entry.is_stock()), tool(entry.tool) {}
    auto operator<=>(const FaceSource&) const = default;

    /// Returns "stock", "T3" or "T0".
    std::string name() const;
};

/// The stock and the tools of a program, each with a colour. The colour of a tool depends on its
/// rank among the used numbers, so successive tools differ even if their numbers are far apart.
/// Colours repeat from the ninth tool on. Tool 0 has a colour of its own.
class Palette {
public:
    explicit Palette(const mesh::Provenance& provenance);

    Rgba8 colour(FaceSource maker) const;
    Rgba8 colour(mesh::Provenance::Entry entry) const { return colour(FaceSource(entry)); }
    /// Returns the stock, even without a face of the stock, then the tools in the order of their
    /// numbers.
    const std::vector<FaceSource>& face_sources() const { return face_sources_; }
    /// Returns the position of `maker` in face_sources(); that of the stock for an unknown tool.
    std::size_t rank(FaceSource maker) const;
    std::size_t rank(mesh::Provenance::Entry entry) const { return rank(FaceSource(entry)); }

private:
    std::vector<FaceSource> face_sources_;
    std::size_t first_numbered_ = 1;  // index of the first tool with a number, in face_sources_
};

}  // namespace ncsim::exporter
