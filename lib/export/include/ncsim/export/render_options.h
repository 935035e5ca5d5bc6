// SPDX-License-Identifier: GPL-3.0-or-later
//
// Size, camera and colours of a picture.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/export/camera.h"
#include "ncsim/mesh/open_mesh.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::exporter {

/// Largest width or height of a picture, in pixels.
inline constexpr std::uint32_t kMaxImageSide = 16384;

/// Number of surfaces of a transparent part that are visible on a line of sight.
inline constexpr std::uint32_t kLayers = 6;

/// Colour behind the part.
enum class Background { White, Dark };

/// Meaning of the colour of a cut face. Uncut stock is always grey.
enum class Colouring {
    Tool,    ///< Tool that cut the face, as in all file formats.
    Line,    ///< Position of the line in the program: yellow, green, blue, violet.
    Depth,   ///< Depth of each point: yellow, green, blue, violet.
    Design,  ///< Distance of each point from the design, also on uncut faces; DesignDistances.
};

/// Distances of the surface of a part from a design.
struct DesignDistances {
    TriangleMesh mesh;  ///< Triangles of the faces of the part, mm, W.
    /// For each vertex, mm; positive: material is left, negative: the part is cut into the design.
    std::vector<double> distance_mm;
    double tolerance_mm = 0.0;
    double largest_mm = 1.0;  ///< Distance at which the colours end; above the tolerance.
};

/// Program that draws polygons. Pictures of the two programs differ in a few pixels at edges.
enum class Renderer {
    Own,     ///< The rasteriser of ncsim: the same bytes on every machine.
    Osmesa,  ///< OSMesa, loaded at run time; slower.
};

/// Size, camera and colours of a picture.
struct RenderOptions {
    std::uint32_t width = 1280, height = 960;  ///< In pixels, each from 1 to kMaxImageSide.
    /// Height of the picture that determines the widths of lines; 0: `height`.
    std::uint32_t usual_height = 0;
    Camera camera;  ///< Example: fit_camera(stock, View::Iso, 4 / 3.).
    Background background = Background::White;
    Renderer renderer = Renderer::Own;
    Colouring colouring = Colouring::Tool;
    /// z in the workpiece frame, in mm, at which the colours of Colouring::Depth begin and end.
    double depth_top = 0.0, depth_bottom = -10.0;
    /// For Colouring::Design, which needs the distances. They outlive the call.
    const DesignDistances* distances = nullptr;
    /// Plane at which the part is cut open; the cut is hatched. Only for render_boundary().
    std::optional<mesh::CutPlane> cut;
    /// Each pixel is the mean of samples × samples; 1 to 4.
    std::uint32_t samples = 2;
    /// Draws the part transparent: the nearest kLayers surfaces of the part on each line of sight,
    /// and the bodies between them; no recess is darker. Only for render_boundary() with the
    /// rasteriser of ncsim.
    bool see_through = false;
    /// Approximate number of samples drawn at once, at some 16 bytes each. Limits the memory of a
    /// picture and changes no byte of the result.
    std::uint32_t band_samples = 1U << 19;
    /// Draws all samples of all pixels, also far from edges: slower, with the same bytes.
    bool samples_everywhere = false;
    /// Draws uncut stock pale, as if the background shone through, because the stock was assumed.
    bool ghost_stock = false;
    /// Less light in recesses of the part, such as pockets and holes. A convex part does not
    /// change.
    bool shades_recesses = true;
    bool edges = true;  ///< Draws lines where faces meet at an angle and around the silhouette.
};

}  // namespace ncsim::exporter
