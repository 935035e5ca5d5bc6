// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of a part, drawn off screen: no display, no graphics card.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/image.h"
#include "ncsim/export/overlay.h"
#include "ncsim/export/provenance.h"

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

struct RenderOptions {
    std::uint32_t width = 1280, height = 960;  ///< In pixels, 1 … kMaxImageSide each.
    Camera camera;  ///< For instance fit_camera(stock, View::Iso, 4 / 3.).
    Background background = Background::White;
    Colouring colouring = Colouring::Tool;
    /// In mm, z of the workpiece: where the colours of Colouring::Depth begin and end.
    double depth_top = 0.0, depth_bottom = -10.0;
    /// Every pixel is the mean of samples × samples; 1 … 4.
    std::uint32_t samples = 2;
    /// Uncut stock is pale, as if the background shone through it: nobody told what it is.
    bool ghost_stock = false;
    bool edges = true;  ///< Lines where faces meet at an angle and around the silhouette.
};

/// Draws what `model` hands out facet by facet, each behind its masks in the stencil buffer
/// (Schüppel 2001, section 5.1): no boundary is computed. Uncut stock and the faces of each
/// tool have a colour of their own.
///
/// `overlay` is drawn over it, hidden by what stands before it.
///
/// Both functions: the same input gives the same bytes for any number of threads. Throws
/// std::runtime_error if the size or the number of samples is out of range, or if no
/// off-screen context can be made.
Image render_model(const cda::WorkpieceModel& model, const Provenance& provenance,
                   const RenderOptions& options, const Overlay& overlay = {});

/// Draws `boundary`. Equal to the picture of the model whose boundary it is, but for pixels on
/// edges.
Image render_boundary(const cda::Boundary& boundary, const Provenance& provenance,
                      const RenderOptions& options, const Overlay& overlay = {});

}  // namespace ncsim::exporter
