// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pixels of a picture from the surfaces seen at samples: light, lines, averages.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/render_options.h"

#include "render/pixel_rect.h"
#include "render/recess_shade.h"
#include "render/surface.h"
#include "render/visibility.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// Number of samples around a tile that are needed from adjacent tiles: the search for lines and
/// specks looks two samples beyond the tile.
inline constexpr std::uint32_t kTileMargin = 4;

/// Returns the colour of the background.
LinearColour colour_of(Background background);

/// Turns samples into pixels, tile by tile. The result depends on the surfaces only, not on the
/// renderer.
class Resolver {
public:
    /// `shade`: null for the same light in recesses.
    /// Requires: `table` and `shade` outlive the resolver. The table may grow between tiles.
    Resolver(const ScreenMap& map, const RenderOptions& options, const SurfaceTable& table,
             RecessShade* shade);

    /// Fills the pixels of `tile`. `ids` are the samples of `seen`, which contains the samples of
    /// the tile and kTileMargin more on each side.
    void resolve(std::span<const SurfaceId> ids, const SampleRect& seen, const PixelRect& tile,
                 Image& image);
    /// Fills the pixels of `tile` if all samples see `id`.
    void fill(SurfaceId id, const PixelRect& tile, Image& image);

private:
    // Light on a surface: `diffuse` is the factor of its colour, `sheen` that of white.
    struct Lighting {
        float diffuse = 0, sheen = 0;
    };
    static Lighting lighting(Vec3 n_C);
    // Parallel lines in the plane of the cut: direction across the lines, unit vector in C, and the
    // change of the distance across per mm of the picture.
    struct Hatch {
        Vec3 across_C;
        double slope = 1.0;
    };
    // Samples of a row that see one surface.
    struct Run {
        std::uint32_t begin = 0, end = 0;
        SurfaceId id = kBackground;
    };
    void prepare_hatches(const mesh::CutPlane& cut);
    void light_new_surfaces();
    static LinearColour lit(LinearColour material, Vec3 n_C);
    LinearColour material_at(const Surface& surface, Vec3 p_C) const;
    Vec3 point_of(const Surface& surface, double x, double y) const;
    LinearColour colour_at(SurfaceId id, double x, double y) const;
    LinearColour hatched(const Surface& surface, Vec3 p_C) const;
    Vec3 normal_at(const Surface& surface, double x, double y, double depth) const;
    LinearColour colour_of_pixel(SurfaceId id, std::uint32_t x, std::uint32_t y) const;
    bool is_darker(SurfaceId id) const;
    float brightness(SurfaceId id, std::uint32_t x, std::uint32_t y) const;
    Rgba8 mean_of(LinearColour colour) const;
    void fill_pixels(SurfaceId id, std::uint32_t x, std::uint32_t y, std::uint32_t count,
                     Image& image) const;
    Rgba8 mixed_pixel(std::uint32_t x, std::uint32_t y, std::size_t first) const;
    bool is_uniform(std::size_t first) const;
    void resolve_pixels(const PixelRect& tile, Image& image) const;
    void find_runs();
    std::span<const Run> runs(std::size_t row) const;
    void remove_specks();
    void clear_ink();
    void find_changes(const PixelRect& tile);
    float line_between(SurfaceId a, SurfaceId b, double x, double y) const;
    bool is_same_plane(SurfaceId a, SurfaceId b) const;
    bool is_round(SurfaceId id) const;
    bool is_line(SurfaceId id) const;
    bool has_pattern(SurfaceId id) const;

    ScreenMap map_;
    const RenderOptions& options_;
    const std::vector<Surface>& surfaces_;
    const std::vector<Bend>& bends_;
    const std::vector<Ramp>& ramps_;
    RecessShade* shade_;
    LinearColour ink_colour_;
    Hatch part_hatch_, body_hatch_;
    // By SurfaceId; unused for surfaces that are round or have a pattern.
    std::vector<LinearColour> lit_;
    std::vector<Rgba8> plain_;  // pixels whose samples all have the colour in lit_
    // The current tile with its margin.
    std::vector<SurfaceId> ids_;
    std::vector<Run> runs_;
    std::vector<std::size_t> first_runs_;                    // of each row, and the end
    std::vector<std::uint8_t> mixed_;                        // 1 for each pixel with a change
    std::vector<float> ink_;                                 // for each sample, 0 … 1
    std::vector<std::size_t> inked_;                         // samples with ink
    std::vector<std::pair<std::size_t, SurfaceId>> specks_;  // samples and their new surfaces
    SampleRect rect_;
};

}  // namespace ncsim::exporter
