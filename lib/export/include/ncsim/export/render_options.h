// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a picture is drawn: size, camera, colours.
#pragma once

#include "ncsim/export/camera.h"

#include <cstdint>

namespace ncsim::exporter {

/// Pixels along a side of the largest picture.
inline constexpr std::uint32_t kMaxImageSide = 16384;

enum class Background { White, Dark };

/// What the colour of a cut face says. Uncut stock is grey in any case.
enum class Colouring {
    Tool,   ///< Which tool made it, as in all file formats.
    Line,   ///< How late in the program it was made: yellow, green, blue, violet.
    Depth,  ///< How deep it lies, point by point: yellow, green, blue, violet.
};

/// Drawing of polygons. Pictures of both differ in a few pixels at edges.
enum class Renderer {
    Own,     ///< Rasteriser of ncsim: the same bytes on every machine.
    Osmesa,  ///< OSMesa, which is loaded at run time. Slower.
};

struct RenderOptions {
    std::uint32_t width = 1280, height = 960;  ///< In pixels, 1 … kMaxImageSide each.
    Camera camera;  ///< For instance fit_camera(stock, View::Iso, 4 / 3.).
    Background background = Background::White;
    Renderer renderer = Renderer::Own;
    Colouring colouring = Colouring::Tool;
    /// In mm, z of the workpiece: where the colours of Colouring::Depth begin and end.
    double depth_top = 0.0, depth_bottom = -10.0;
    /// Every pixel is the mean of samples × samples; 1 … 4.
    std::uint32_t samples = 2;
    /// Samples that are drawn at once, about, some 16 bytes each: bounds the memory of a picture
    /// and changes no byte of it.
    std::uint32_t band_samples = 1U << 19;
    /// Draws all samples of all pixels, also where no edge is near: slower, the same bytes.
    bool samples_everywhere = false;
    /// Uncut stock is pale, as if the background shone through it: nobody told what it is.
    bool ghost_stock = false;
    bool edges = true;  ///< Lines where faces meet at an angle and around the silhouette.
};

}  // namespace ncsim::exporter
