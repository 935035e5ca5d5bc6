// SPDX-License-Identifier: GPL-3.0-or-later
//
// From surfaces seen at samples to the pixels of a picture: light, lines, average.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/render_options.h"

#include "render/surface.h"
#include "render/visibility.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// Samples around a tile that belong to its neighbours: lines and specks look two samples beyond
/// it.
inline constexpr std::uint32_t kTileMargin = 4;

/// What is seen where nothing stands.
LinearColour colour_of(Background background);

/// Pixels of a picture.
struct PixelRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Turns samples into pixels, tile by tile. Depends on surfaces only, not on how they were drawn.
class Resolver {
public:
    /// `table` must outlive the resolver and may grow between tiles.
    Resolver(const ScreenMap& map, const RenderOptions& options, const SurfaceTable& table);

    /// Fills the pixels of `tile`. `ids` are the samples of `seen`, which holds the samples of the
    /// tile and kTileMargin more on each side.
    void resolve(std::span<const SurfaceId> ids, const SampleRect& seen, const PixelRect& tile,
                 Image& image);
    /// Fills the pixels of `tile`, all samples of which see `id`.
    void fill(SurfaceId id, const PixelRect& tile, Image& image);

private:
    // Light on a surface: its colour times `diffuse`, and `sheen` of white.
    struct Lighting {
        float diffuse = 0, sheen = 0;
    };
    static Lighting lighting(cda::Vec3 n_C);
    void light_new_surfaces();
    LinearColour colour_at(SurfaceId id, double x, double y) const;
    cda::Vec3 normal_at(const Surface& surface, double x, double y, double depth) const;
    LinearColour colour_of_pixel(SurfaceId id, std::uint32_t x, std::uint32_t y) const;
    Rgba8 mean_of(LinearColour colour) const;
    Rgba8 uniform_pixel(SurfaceId id, std::uint32_t x, std::uint32_t y) const;
    Rgba8 mixed_pixel(std::uint32_t x, std::uint32_t y, std::size_t first) const;
    bool is_uniform(std::size_t first) const;
    void resolve_pixels(const PixelRect& tile, Image& image) const;
    void remove_specks();
    void find_lines();
    float line_between(SurfaceId a, SurfaceId b, double x, double y) const;
    double depth_at(const Surface& surface, double x, double y) const;
    bool is_same_plane(SurfaceId a, SurfaceId b) const;
    bool is_round(SurfaceId id) const;
    bool is_line(SurfaceId id) const;

    ScreenMap map_;
    const RenderOptions& options_;
    const std::vector<Surface>& surfaces_;
    const std::vector<Bend>& bends_;
    LinearColour ink_colour_;
    // By SurfaceId; unused for surfaces that are round or coloured by depth.
    std::vector<LinearColour> lit_;
    std::vector<Rgba8> plain_;  // pixels whose samples all have that colour
    // The tile at hand with its margin.
    std::vector<SurfaceId> ids_;
    std::vector<float> ink_;                                 // for each sample, 0 … 1
    std::vector<std::pair<std::size_t, SurfaceId>> specks_;  // samples and what they get
    SampleRect rect_;
};

}  // namespace ncsim::exporter
