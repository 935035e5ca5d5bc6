// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks that explain a picture: axes, program zero, scale and legend of colours.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/image.h"
#include "ncsim/export/render_options.h"
#include "ncsim/mesh/provenance.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// Smallest width and height of a picture with marks, in pixels.
inline constexpr std::uint32_t kLeastMarkedSide = 240;

/// A place of the part with a short text, such as a number.
struct MarkedPlace {
    Vec3 point;  ///< mm, W
    std::string text;
};

/// Marks of a picture.
struct Marks {
    double strip_rows = 0.0;  ///< Height of the strip in pixels; 0: that of mark_strip().
    bool axes = false;        ///< Directions of x, y and z of W, in the lower left corner.
    bool zero = false;  ///< Program zero: a circle with two filled quarters, also behind the part.
    /// Scale: a bar, if an axis of W is parallel to the picture; otherwise `size` as text, lower
    /// right.
    bool scale = false;
    bool has_size = true;      ///< The scale shows `size`, too.
    Vec3 size;                 ///< Size of the stock in the unit of the scale, in W.
    double mm_per_unit = 1.0;  ///< Unit of the scale: 1 or 25.4.
    std::string unit = "mm";   ///< Its name.
    /// Colours with their meanings, in the order of the list; empty: none.
    std::vector<std::pair<Rgba8, std::string>> legend;
    /// Meanings of the ends of the colour scale; both empty: none.
    std::string scale_begin, scale_end;
    /// Colours along the scale; empty: those of Colouring::Line and Colouring::Depth.
    std::vector<Rgba8> scale_colours;
    std::string scale_middle;        ///< Meaning of the middle of the scale; empty: none.
    std::vector<double> scale_bars;  ///< Heights of bars along the scale, 0 to 1; empty: none.
    /// Places, each in a ring, also behind the part.
    std::vector<MarkedPlace> places;
};

/// Returns the height of the strip for marks below the part, as a share of the height of a picture
/// of `width` by `height` pixels: 12 % for the usual 4:3, less for narrower pictures, so that the
/// marks fit.
double mark_strip(std::uint32_t width, std::uint32_t height);

/// Returns `camera` with a strip of the share `strip` below the part. `camera` must have been
/// fitted to the picture without the strip.
Camera with_mark_strip(Camera camera, double strip);

/// Returns the number and the colour of each tool that cut, in the order of the numbers.
std::vector<std::pair<std::uint32_t, Rgba8>> tool_colours(const mesh::Provenance& provenance);

/// Returns the colours of Colouring::Design, from the deepest gouge to the largest excess, `count`
/// equal steps of distance.
std::vector<Rgba8> distance_colours(const DesignDistances& distances, std::size_t count);

/// Draws `marks` into the strip below the part; the program zero and the places on top of the part.
/// Guarantees: the same bytes on every machine.
/// Requires: `image` was drawn with `camera`, orthographic, and is at least kLeastMarkedSide wide
///     and high; otherwise nothing is drawn.
void draw_marks(Image& image, const Camera& camera, Background background, const Marks& marks);

}  // namespace ncsim::exporter
