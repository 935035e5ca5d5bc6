// SPDX-License-Identifier: GPL-3.0-or-later
//
// From surfaces seen at samples to the pixels of a picture: light, lines, average.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/render_options.h"

#include "render/surface.h"
#include "render/visibility.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// Samples around a tile that belong to its neighbours: lines look one sample to each side.
inline constexpr std::uint32_t kTileMargin = 4;

/// What is seen where nothing stands.
LinearColour colour_of(Background background);

/// Turns samples into pixels, tile by tile. Depends on surfaces only, not on how they were drawn.
class Resolver {
public:
    /// `table` must outlive the resolver and may grow between tiles.
    Resolver(const ScreenMap& map, const RenderOptions& options, const SurfaceTable& table);

    /// Fills the pixels of `image` from (x, y) on, width × height of them. `ids` are the samples of
    /// the tile with kTileMargin more on each side; their specks are removed in place.
    void resolve(std::vector<SurfaceId>& ids, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                 std::uint32_t height, Image& image);

private:
    // Light on a surface: its colour times `diffuse`, and `sheen` of white.
    struct Lighting {
        float diffuse = 0, sheen = 0;
    };
    static Lighting lighting(cda::Vec3 n_C);
    void light_new_surfaces();
    LinearColour colour_at(SurfaceId id, double x, double y) const;
    cda::Vec3 normal_at(const Surface& surface, double x, double y, double depth) const;
    void remove_specks(std::vector<SurfaceId>& ids);
    void find_lines(std::span<const SurfaceId> ids);
    float line_between(SurfaceId a, SurfaceId b, double x, double y) const;
    double depth_at(const Surface& surface, double x, double y) const;
    bool is_same_plane(SurfaceId a, SurfaceId b) const;
    bool is_round(SurfaceId id) const;
    bool is_line(SurfaceId id) const;

    ScreenMap map_;
    const RenderOptions& options_;
    const std::vector<Surface>& surfaces_;
    const std::vector<Bend>& bends_;
    std::vector<LinearColour> lit_;  // by SurfaceId; of those that are round or coloured by depth,
                                     // unused
    std::vector<float> ink_;         // for each sample, 0 … 1
    SampleRect rect_;
};

}  // namespace ncsim::exporter
