// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lighting, lines between faces, removal of specks, and averages over pixels.
#include "render/pixel_resolver.h"

#include "render/crease.h"
#include "render/line_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ncsim::exporter {

namespace {

using cda::Vec3;

// Light in the camera frame, so every view has the same light: a key light from the left, low
// enough to show the relief of faces that look up, a weak light from the right, a sky, ambient
// light, and a sheen for milled metal. On a box seen from Iso, the top, the left and the right side
// get about 0.9, 0.6 and 0.4.
const Vec3 kKeyLight = cda::normalized({-0.65, 0.38, 0.66});
const Vec3 kFillLight = cda::normalized({0.70, -0.10, 0.70});
const Vec3 kMirror = cda::normalized(kKeyLight + Vec3{0, 0, 1});  // reflects the key light
constexpr double kKey = 0.66;
constexpr double kFill = 0.15;
constexpr double kSky = 0.22;
constexpr double kEverywhere = 0.26;
constexpr double kSheen = 0.16;

// Share of ink in a line at a silhouette, where a face is in front of another face, and at a
// crease, where two faces meet.
constexpr float kSilhouetteInk = 0.75F;
constexpr float kCreaseInk = 0.5F;
constexpr Rgba8 kInk{24, 28, 34};

// Distance and width of the lines of a cut, in pixels of a picture with 960 rows (line_scale());
// share of ink.
constexpr double kHatchPeriod = 13.0;
constexpr double kHatchWidth = 1.4;
constexpr double kHatchInk = 0.6;

constexpr Rgba8 kWhite{255, 255, 255};
constexpr Rgba8 kDark{30, 33, 38};

double square(double x) {
    return x * x;
}

constexpr LinearColour kWhiteLight{1, 1, 1};

// Returns the change of depth per mm across the picture, along x plus along y.
double slope(const Surface& surface) {
    return (std::abs(surface.n_C.x) + std::abs(surface.n_C.y)) / surface.n_C.z;
}

}  // namespace

LinearColour colour_of(Background background) {
    return to_linear(background == Background::White ? kWhite : kDark);
}

Resolver::Resolver(const ScreenMap& map, const RenderOptions& options, const SurfaceTable& table)
    : map_(map),
      options_(options),
      surfaces_(table.surfaces),
      bends_(table.bends),
      ramps_(table.ramps),
      ink_colour_(to_linear(kInk)) {
    lit_.push_back(colour_of(options.background));
    plain_.push_back(mean_of(lit_.back()));
    if (options.cut) prepare_hatches(*options.cut);
}

void Resolver::prepare_hatches(const mesh::CutPlane& cut) {
    const Vec3 n = map_.direction_in_camera(cut.normal);
    int axis = 0;
    while (axis < 2 && std::abs(cut.normal[axis]) < 0.5)
        ++axis;
    Vec3 u, v;
    u[axis == 0 ? 1 : 0] = v[axis == 2 ? 1 : 2] = 1.0;
    const auto hatch = [&](Vec3 across) {
        const Vec3 d = map_.direction_in_camera(cda::normalized(across));
        // The depth of the plane changes across the picture, too.
        const double along_x = d.x - d.z * n.x / n.z, along_y = d.y - d.z * n.y / n.z;
        return Hatch{d, std::sqrt(along_x * along_x + along_y * along_y)};
    };
    part_hatch_ = hatch(u - v);
    body_hatch_ = hatch(u + v);
}

Resolver::Lighting Resolver::lighting(Vec3 n_C) {
    const double diffuse = kEverywhere + kSky * n_C.y +
                           kKey * std::max(0.0, cda::dot(n_C, kKeyLight)) +
                           kFill * std::max(0.0, cda::dot(n_C, kFillLight));
    const double sheen = kSheen * square(square(square(std::max(0.0, cda::dot(n_C, kMirror)))));
    return {static_cast<float>(diffuse), static_cast<float>(sheen)};
}

void Resolver::light_new_surfaces() {
    for (std::size_t i = lit_.size() - 1; i < surfaces_.size(); ++i) {
        const Surface& surface = surfaces_[i];
        LinearColour colour = surface.colour;
        if (!surface.is_line) {
            const Lighting light = lighting(surface.n_C);
            colour = light.diffuse * surface.colour + light.sheen * kWhiteLight;
        }
        lit_.push_back(colour);
        plain_.push_back(mean_of(colour));
    }
}

// Returns the colour of a surface at (x, y), in mm from the centre of the picture.
LinearColour Resolver::colour_at(SurfaceId id, double x, double y) const {
    if (id == kBackground) return lit_[id];
    const Surface& surface = surfaces_[id - 1];
    if (surface.pattern == Pattern::Plain && surface.bend == 0) return lit_[id];
    const double depth = depth_at(surface, x, y);
    LinearColour colour = surface.colour;
    switch (surface.pattern) {
        case Pattern::Plain: break;
        case Pattern::Depth: {
            const Camera& camera = map_.camera();
            const Vec3 p = point_at(x, y, depth);
            const double z_W =
                camera.target.z + p.x * camera.right.z + p.y * camera.up.z + p.z * camera.back.z;
            colour = scale_colour((options_.depth_top - z_W) /
                                  (options_.depth_top - options_.depth_bottom));
            break;
        }
        case Pattern::Distance:
            colour =
                distance_colour(ramps_[surface.ramp].value_at(point_at(x, y, depth)),
                                options_.distances->tolerance_mm, options_.distances->largest_mm);
            break;
        case Pattern::PartHatch:
        case Pattern::BodyHatch: return hatched(surface, point_at(x, y, depth));
    }
    const Lighting light = lighting(normal_at(surface, x, y, depth));
    return light.diffuse * colour + light.sheen * kWhiteLight;
}

// Returns the colour of a point of a cut: the surface's, with parallel lines.
LinearColour Resolver::hatched(const Surface& surface, Vec3 p_C) const {
    const Hatch& hatch = surface.pattern == Pattern::PartHatch ? part_hatch_ : body_hatch_;
    const double h = map_.sample_size(), pixel = line_scale(options_);
    const double across = cda::dot(hatch.across_C, p_C);
    const double period = kHatchPeriod * pixel * h;
    const double from_line = std::abs(across - period * std::round(across / period));
    // In samples of the picture.
    const double covered = 0.5 + 0.5 * kHatchWidth * pixel - from_line / (hatch.slope * h);
    const auto ink = static_cast<float>(kHatchInk * std::clamp(covered, 0.0, 1.0));
    return (1.0F - ink) * surface.colour + ink * ink_colour_;
}

// Returns the point at (x, y) and `depth` in the camera frame. (x, y) is in mm at the target, from
// the centre of the picture.
Vec3 Resolver::point_at(double x, double y, double depth) const {
    const Camera& camera = map_.camera();
    const double scale = camera.is_orthographic() ? 1.0 : 1.0 - depth / camera.distance;
    return {scale * x, scale * y, depth};
}

// Returns the normal at (x, y) and `depth`, in mm from the centre of the picture.
Vec3 Resolver::normal_at(const Surface& surface, double x, double y, double depth) const {
    if (surface.bend == 0) return surface.n_C;
    return bends_[surface.bend - 1].normal_at(point_at(x, y, depth));
}

// Returns the depth at which the line of sight through (x, y) meets the plane of the surface: z in
// the camera frame. (x, y) is in mm at the target, from the centre of the picture.
double Resolver::depth_at(const Surface& surface, double x, double y) const {
    const Vec3 n = surface.n_C;
    if (map_.camera().is_orthographic()) return (surface.offset - n.x * x - n.y * y) / n.z;
    const double d = map_.camera().distance;
    const double s = (n.z * d - surface.offset) / (n.z * d - n.x * x - n.y * y);
    return d * (1.0 - s);
}

bool Resolver::is_same_plane(SurfaceId a, SurfaceId b) const {
    if (a == b) return true;
    if (a == kBackground || b == kBackground) return false;
    const Surface& p = surfaces_[a - 1];
    const Surface& q = surfaces_[b - 1];
    return cda::dot(p.n_C, q.n_C) > 1.0 - 1e-10 &&
           std::abs(p.offset - q.offset) < 0.01 * map_.sample_size();
}

bool Resolver::is_round(SurfaceId id) const {
    return id != kBackground && surfaces_[id - 1].bend != 0;
}

bool Resolver::is_line(SurfaceId id) const {
    return id != kBackground && surfaces_[id - 1].is_line;
}

bool Resolver::has_pattern(SurfaceId id) const {
    return id != kBackground && surfaces_[id - 1].pattern != Pattern::Plain;
}

// Returns the strength of the line between two adjacent samples that see `a` and `b`; (x, y) is the
// point between them.
float Resolver::line_between(SurfaceId a, SurfaceId b, double x, double y) const {
    if (a == b) return 0.0F;
    if (is_line(a) || is_line(b)) return 0.0F;
    if (a == kBackground || b == kBackground) return kSilhouetteInk;
    const Surface& p = surfaces_[a - 1];
    const Surface& q = surfaces_[b - 1];
    // Both are triangles of one face.
    if (p.n_C == q.n_C && p.offset == q.offset) return 0.0F;
    const double depth = depth_at(p, x, y), other = depth_at(q, x, y);
    const double step = std::abs(depth - other);
    // If two faces meet between the samples, their depths differ by at most half a sample times the
    // sum of their slopes.
    if (step > map_.sample_size() * (1.0 + slope(p) + slope(q))) return kSilhouetteInk;
    return cda::dot(normal_at(p, x, y, depth), normal_at(q, x, y, other)) < kCreaseCosine
               ? kCreaseInk
               : 0.0F;
}

// Rounding can separate the edges of adjacent facets. A sample can then see through the gap, or see
// a facet that is masked there. A sample is a speck if none of its four neighbours sees the same
// plane; the speck gets the surface that most neighbours see.
void Resolver::remove_specks() {
    const std::size_t width = rect_.width;
    specks_.clear();
    for (std::size_t y = 1; y + 1 < rect_.height; ++y) {
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const std::size_t i = y * width + x;
            if (ids_[i] == ids_[i - 1] || ids_[i] == ids_[i + 1]) continue;
            const std::array<SurfaceId, 4> around{ids_[i - 1], ids_[i + 1], ids_[i - width],
                                                  ids_[i + width]};
            const bool is_alone = std::none_of(around.begin(), around.end(), [&](SurfaceId id) {
                return is_same_plane(id, ids_[i]);
            });
            if (!is_alone || is_line(ids_[i])) continue;
            const auto votes = [&](SurfaceId id) {
                return std::count_if(around.begin(), around.end(),
                                     [&](SurfaceId other) { return is_same_plane(id, other); });
            };
            const auto winner =
                *std::max_element(around.begin(), around.end(),
                                  [&](SurfaceId a, SurfaceId b) { return votes(a) < votes(b); });
            if (votes(winner) >= 2) specks_.emplace_back(i, winner);
        }
    }
    // Specks are replaced last, so the result does not depend on where tiles begin.
    for (const auto& [i, id] : specks_)
        ids_[i] = id;
}

void Resolver::find_lines() {
    ink_.assign(ids_.size(), 0.0F);
    if (!options_.edges) return;
    const std::size_t width = rect_.width;
    const double h = map_.sample_size();
    const double left = static_cast<double>(rect_.x) - 0.5 * options_.samples * options_.width;
    const double top = static_cast<double>(rect_.y) - 0.5 * options_.samples * options_.height;
    const auto mark = [&](std::size_t i, float ink) {
        if (ids_[i] != kBackground) ink_[i] = std::max(ink_[i], ink);
    };
    const auto compare = [&](std::size_t i, std::size_t j, double x, double y) {
        if (ids_[i] == ids_[j]) return;
        const float ink = line_between(ids_[i], ids_[j], h * x, h * y);
        mark(i, ink);
        mark(j, ink);
    };
    for (std::size_t row = 0; row + 1 < rect_.height; ++row) {
        for (std::size_t column = 0; column + 1 < width; ++column) {
            const std::size_t i = row * width + column;
            const double x = left + static_cast<double>(column);
            const double y = top + static_cast<double>(row);
            compare(i, i + 1, x + 1.0, -(y + 0.5));
            compare(i, i + width, x + 0.5, -(y + 1.0));
        }
    }
}

// Returns a pixel whose samples all have the colour.
Rgba8 Resolver::mean_of(LinearColour colour) const {
    const std::uint32_t count = options_.samples * options_.samples;
    LinearColour sum;
    for (std::uint32_t s = 0; s < count; ++s)
        sum = sum + colour;
    return to_srgb((1.0F / static_cast<float>(count)) * sum);
}

// Returns the colour of a surface in the middle of the pixel.
LinearColour Resolver::colour_of_pixel(SurfaceId id, std::uint32_t x, std::uint32_t y) const {
    const double h = map_.sample_size();
    const double samples = options_.samples;
    return colour_at(id, h * (samples * (x + 0.5 - 0.5 * options_.width)),
                     -h * (samples * (y + 0.5 - 0.5 * options_.height)));
}

// Returns pixel (x, y) of the picture, whose samples all see the surface. The surface must not
// have a pattern.
Rgba8 Resolver::uniform_pixel(SurfaceId id, std::uint32_t x, std::uint32_t y) const {
    return is_round(id) ? mean_of(colour_of_pixel(id, x, y)) : plain_[id];
}

// Returns pixel (x, y) of the picture, whose first sample is at `first` in ids_.
Rgba8 Resolver::mixed_pixel(std::uint32_t x, std::uint32_t y, std::size_t first) const {
    const std::uint32_t samples = options_.samples;
    const double h = map_.sample_size();
    const double left = samples * (x - 0.5 * options_.width) + 0.5;
    const double top = samples * (y - 0.5 * options_.height) + 0.5;
    LinearColour sum, light;
    SurfaceId lit = kBackground;  // round surface whose light is known for the pixel
    for (std::uint32_t s = 0; s < samples * samples; ++s) {
        const std::uint32_t row = s / samples, column = s % samples;
        const std::size_t i = first + std::size_t{row} * rect_.width + column;
        const SurfaceId id = ids_[i];
        const bool round = is_round(id);
        if (!round) {
            light = colour_at(id, h * (left + column), -h * (top + row));
        } else if (id != lit) {
            // Round surfaces are lit once per pixel, in its middle, because the light hardly
            // changes within a pixel.
            light = colour_of_pixel(id, x, y);
        }
        lit = round ? id : kBackground;
        sum = sum + (1.0F - ink_[i]) * light + ink_[i] * ink_colour_;
    }
    return to_srgb((1.0F / static_cast<float>(samples * samples)) * sum);
}

// True if all samples of a pixel see the same surface, without lines and without a pattern.
bool Resolver::is_uniform(std::size_t first) const {
    const SurfaceId id = ids_[first];
    for (std::uint32_t row = 0; row < options_.samples; ++row) {
        const std::size_t begin = first + std::size_t{row} * rect_.width;
        for (std::size_t i = begin; i < begin + options_.samples; ++i) {
            if (ids_[i] != id || ink_[i] != 0.0F) return false;
        }
    }
    return !has_pattern(id);
}

void Resolver::fill(SurfaceId id, const PixelRect& tile, Image& image) {
    light_new_surfaces();
    if (has_pattern(id)) {
        const std::uint32_t samples = options_.samples;
        const SampleRect all{0, 0, tile.width * samples + 2 * kTileMargin,
                             tile.height * samples + 2 * kTileMargin};
        rect_ = {std::int64_t{tile.x} * samples - kTileMargin,
                 std::int64_t{tile.y} * samples - kTileMargin, all.width, all.height};
        ids_.assign(std::size_t{all.width} * all.height, id);
        ink_.assign(ids_.size(), 0.0F);
        return resolve_pixels(tile, image);
    }
    for (std::uint32_t y = tile.y; y < tile.y + tile.height; ++y) {
        Rgba8* const row = &image.at(tile.x, y);
        if (!is_round(id)) {
            std::fill_n(row, tile.width, plain_[id]);
            continue;
        }
        for (std::uint32_t x = 0; x < tile.width; ++x)
            row[x] = uniform_pixel(id, tile.x + x, y);
    }
}

void Resolver::resolve(std::span<const SurfaceId> ids, const SampleRect& seen,
                       const PixelRect& tile, Image& image) {
    const std::uint32_t samples = options_.samples;
    rect_ = {std::int64_t{tile.x} * samples - kTileMargin,
             std::int64_t{tile.y} * samples - kTileMargin, tile.width * samples + 2 * kTileMargin,
             tile.height * samples + 2 * kTileMargin};
    light_new_surfaces();
    ids_.resize(std::size_t{rect_.width} * rect_.height);
    bool is_one = true;
    for (std::uint32_t row = 0; row < rect_.height; ++row) {
        const auto from = ids.begin() + ((rect_.y - seen.y + row) * std::int64_t{seen.width} +
                                         (rect_.x - seen.x));
        const auto to = ids_.begin() + std::int64_t{row} * rect_.width;
        std::copy_n(from, rect_.width, to);
        is_one = is_one && std::all_of(to, to + rect_.width, [first = ids_.front()](SurfaceId id) {
                     return id == first;
                 });
    }
    if (is_one) return fill(ids_.front(), tile, image);
    remove_specks();
    find_lines();
    resolve_pixels(tile, image);
}

void Resolver::resolve_pixels(const PixelRect& tile, Image& image) const {
    const std::uint32_t samples = options_.samples;
    for (std::uint32_t y = 0; y < tile.height; ++y) {
        for (std::uint32_t x = 0; x < tile.width; ++x) {
            const std::size_t first = std::size_t{kTileMargin + y * samples} * rect_.width +
                                      kTileMargin + std::size_t{x} * samples;
            image.at(tile.x + x, tile.y + y) =
                is_uniform(first) ? uniform_pixel(ids_[first], tile.x + x, tile.y + y)
                                  : mixed_pixel(tile.x + x, tile.y + y, first);
        }
    }
}

}  // namespace ncsim::exporter
