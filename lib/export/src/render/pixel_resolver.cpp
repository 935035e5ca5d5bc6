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

// Light in the camera frame, so every view has the same light: a key light from the left, low
// enough to show the relief of faces that look up, a weak light from the right, a sky, ambient
// light, and a sheen for milled metal. On a box seen from Iso, the top, the left and the right side
// get about 0.9, 0.6 and 0.4.
const Vec3 kKeyLight = normalized({-0.65, 0.38, 0.66});
const Vec3 kFillLight = normalized({0.70, -0.10, 0.70});
const Vec3 kMirror = normalized(kKeyLight + Vec3{0, 0, 1});  // reflects the key light
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

// True if the next kRun samples see the same surface as the sample before `ids`.
constexpr std::size_t kRun = 8;
bool continue_run(const SurfaceId* ids) {
    SurfaceId changes = 0;
    for (std::size_t i = 0; i < kRun; ++i)
        changes |= ids[i] ^ *(ids - 1);
    return changes == 0;
}

// Returns `colour` with `share` of its sRGB values.
Rgba8 darkened(Rgba8 colour, float share) {
    const auto scaled = [share](std::uint8_t channel) {
        return rounded(share * static_cast<float>(channel));
    };
    return {scaled(colour.r), scaled(colour.g), scaled(colour.b), colour.a};
}

// Returns the change of depth per mm across the picture, along x plus along y.
double slope(const Surface& surface) {
    return (std::abs(surface.n_C.x) + std::abs(surface.n_C.y)) / surface.n_C.z;
}

}  // namespace

LinearColour colour_of(Background background) {
    return to_linear(background == Background::White ? kWhite : kDark);
}

Resolver::Resolver(const ScreenMap& map, const RenderOptions& options, const SurfaceTable& table,
                   RecessShade* shade)
    : map_(map),
      options_(options),
      surfaces_(table.surfaces),
      bends_(table.bends),
      ramps_(table.ramps),
      shade_(shade),
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
        const Vec3 d = map_.direction_in_camera(normalized(across));
        // The depth of the plane changes across the picture, too.
        const double along_x = d.x - d.z * n.x / n.z, along_y = d.y - d.z * n.y / n.z;
        return Hatch{d, std::sqrt(along_x * along_x + along_y * along_y)};
    };
    part_hatch_ = hatch(u - v);
    body_hatch_ = hatch(u + v);
}

Resolver::Lighting Resolver::lighting(Vec3 n_C) {
    const double diffuse = kEverywhere + kSky * n_C.y + kKey * std::max(0.0, dot(n_C, kKeyLight)) +
                           kFill * std::max(0.0, dot(n_C, kFillLight));
    const double sheen = kSheen * square(square(square(std::max(0.0, dot(n_C, kMirror)))));
    return {static_cast<float>(diffuse), static_cast<float>(sheen)};
}

void Resolver::light_new_surfaces() {
    for (std::size_t i = lit_.size() - 1; i < surfaces_.size(); ++i) {
        const Surface& surface = surfaces_[i];
        LinearColour colour = surface.colour;
        if (!surface.is_line) colour = lit(colour, surface.n_C);
        lit_.push_back(colour);
        plain_.push_back(mean_of(colour));
    }
}

// Returns the colour of the material at a point of a surface without a hatch.
LinearColour Resolver::material_at(const Surface& surface, Vec3 p_C) const {
    if (surface.pattern == Pattern::Depth) {
        const Camera& camera = map_.camera();
        const double z_W =
            camera.target.z + p_C.x * camera.right.z + p_C.y * camera.up.z + p_C.z * camera.back.z;
        return scale_colour((options_.depth_top - z_W) /
                            (options_.depth_top - options_.depth_bottom));
    }
    if (surface.pattern == Pattern::Distance)
        return distance_colour(ramps_[surface.ramp].value_at(p_C), options_.distances->tolerance_mm,
                               options_.distances->largest_mm);
    return surface.colour;
}

LinearColour Resolver::lit(LinearColour material, Vec3 n_C) {
    const Lighting light = lighting(n_C);
    return light.diffuse * material + light.sheen * kWhiteLight;
}

// Returns the point of a surface at (x, y), in mm from the centre of the picture.
Vec3 Resolver::point_of(const Surface& surface, double x, double y) const {
    return map_.point_at(x, y, map_.depth_of(surface.n_C, surface.offset, x, y));
}

// Returns the colour of a flat surface at (x, y), in mm from the centre of the picture.
LinearColour Resolver::colour_at(SurfaceId id, double x, double y) const {
    if (!has_pattern(id)) return lit_[id];
    const Surface& surface = surfaces_[id - 1];
    const Vec3 p = point_of(surface, x, y);
    const bool is_hatched =
        surface.pattern == Pattern::PartHatch || surface.pattern == Pattern::BodyHatch;
    return is_hatched ? hatched(surface, p) : lit(material_at(surface, p), surface.n_C);
}

// Returns the colour of a point of a cut: the surface's, with parallel lines.
LinearColour Resolver::hatched(const Surface& surface, Vec3 p_C) const {
    const Hatch& hatch = surface.pattern == Pattern::PartHatch ? part_hatch_ : body_hatch_;
    const double h = map_.sample_size(), pixel = line_scale(options_);
    const double across = dot(hatch.across_C, p_C);
    const double period = kHatchPeriod * pixel * h;
    const double from_line = std::abs(across - period * std::round(across / period));
    // In samples of the picture.
    const double covered = 0.5 + 0.5 * kHatchWidth * pixel - from_line / (hatch.slope * h);
    const auto ink = static_cast<float>(kHatchInk * std::clamp(covered, 0.0, 1.0));
    return (1.0F - ink) * surface.colour + ink * ink_colour_;
}

// Returns the normal at (x, y) and `depth`, in mm from the centre of the picture.
Vec3 Resolver::normal_at(const Surface& surface, double x, double y, double depth) const {
    if (surface.bend == 0) return surface.n_C;
    return bends_[surface.bend - 1].normal_at(map_.point_at(x, y, depth));
}

bool Resolver::is_same_plane(SurfaceId a, SurfaceId b) const {
    if (a == b) return true;
    if (a == kBackground || b == kBackground) return false;
    const Surface& p = surfaces_[a - 1];
    const Surface& q = surfaces_[b - 1];
    return dot(p.n_C, q.n_C) > 1.0 - 1e-10 &&
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
    const double depth = map_.depth_of(p.n_C, p.offset, x, y);
    const double other = map_.depth_of(q.n_C, q.offset, x, y);
    const double step = std::abs(depth - other);
    // If two faces meet between the samples, their depths differ by at most half a sample times the
    // sum of their slopes.
    if (step > map_.sample_size() * (1.0 + slope(p) + slope(q))) return kSilhouetteInk;
    return dot(normal_at(p, x, y, depth), normal_at(q, x, y, other)) < kCreaseCosine ? kCreaseInk
                                                                                     : 0.0F;
}

// Finds the runs of samples that see one surface, row by row.
void Resolver::find_runs() {
    const std::uint32_t width = rect_.width;
    runs_.clear();
    first_runs_.clear();
    for (std::uint32_t row = 0; row < rect_.height; ++row) {
        first_runs_.push_back(runs_.size());
        const SurfaceId* const ids = &ids_[std::size_t{row} * width];
        for (std::uint32_t i = 0; i < width;) {
            const std::uint32_t begin = i++;
            while (i + kRun <= width && continue_run(ids + i))
                i += kRun;
            while (i < width && ids[i] == ids[begin])
                ++i;
            runs_.push_back({begin, i, ids[begin]});
        }
    }
    first_runs_.push_back(runs_.size());
}

std::span<const Resolver::Run> Resolver::runs(std::size_t row) const {
    return std::span(runs_).subspan(first_runs_[row], first_runs_[row + 1] - first_runs_[row]);
}

// Rounding can separate the edges of adjacent facets. A sample can then see through the gap, or see
// a facet that is masked there. A sample is a speck if none of its four neighbours sees the same
// plane; the speck gets the surface that most neighbours see.
void Resolver::remove_specks() {
    const std::size_t width = rect_.width;
    specks_.clear();
    for (std::size_t y = 1; y + 1 < rect_.height; ++y) {
        for (const Run& run : runs(y)) {
            if (run.begin == 0 || run.end == width || run.end - run.begin > 1) continue;
            const std::size_t i = y * width + run.begin;
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
    if (!specks_.empty()) find_runs();
}

// Removes the ink of the tile before.
void Resolver::clear_ink() {
    for (const std::size_t i : inked_)
        ink_[i] = 0.0F;
    inked_.clear();
    ink_.resize(ids_.size(), 0.0F);
}

// Finds the pixels that see changes of the surface, and the lines at the changes.
void Resolver::find_changes(const PixelRect& tile) {
    mixed_.assign(std::size_t{tile.width} * tile.height, 0);
    clear_ink();
    const std::size_t width = rect_.width, samples = options_.samples;
    const double h = map_.sample_size();
    const double left = static_cast<double>(rect_.x) - 0.5 * options_.samples * options_.width;
    const double top = static_cast<double>(rect_.y) - 0.5 * options_.samples * options_.height;
    const auto mark = [&](std::size_t row, std::size_t column, float ink) {
        const std::size_t i = row * width + column;
        if (ids_[i] != kBackground && ink > ink_[i]) {
            ink_[i] = ink;
            inked_.push_back(i);
        }
        if (row < kTileMargin || column < kTileMargin) return;
        const std::size_t x = (column - kTileMargin) / samples, y = (row - kTileMargin) / samples;
        if (x < tile.width && y < tile.height) mixed_[y * tile.width + x] = 1;
    };
    // (x, y) is the point between the samples.
    const auto compare = [&](std::size_t row, std::size_t column, std::size_t down,
                             std::size_t right, double x, double y) {
        const SurfaceId a = ids_[row * width + column];
        const SurfaceId b = ids_[(row + down) * width + column + right];
        const float ink = options_.edges ? line_between(a, b, h * x, h * y) : 0.0F;
        mark(row, column, ink);
        mark(row + down, column + right, ink);
    };
    for (std::size_t row = 0; row + 1 < rect_.height; ++row) {
        const double y = top + static_cast<double>(row);
        auto below = runs(row + 1).begin();
        for (const Run& run : runs(row)) {
            if (run.end < width) compare(row, run.end - 1, 0, 1, left + run.end, -(y + 0.5));
            for (std::uint32_t column = run.begin; column < run.end;) {
                if (below->end <= column) ++below;
                const std::uint32_t end = std::min(run.end, below->end);
                if (below->id == run.id) column = end;
                for (; column < end; ++column)
                    compare(row, column, 1, 0, left + column + 0.5, -(y + 1.0));
            }
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

// True if the flat surface is in a recess at some pixel of the tile.
bool Resolver::is_darker(SurfaceId id) const {
    return shade_ != nullptr && id != kBackground && surfaces_[id - 1].has_shade &&
           shade_->is_darker(id, surfaces_[id - 1]);
}

// Returns the brightness of a flat surface in the middle of the pixel, 1 outside of recesses.
float Resolver::brightness(SurfaceId id, std::uint32_t x, std::uint32_t y) const {
    return is_darker(id) ? shade_->brightness(id, surfaces_[id - 1], x, y, 1).front() : 1.0F;
}

// Returns the colour of a round surface in the middle of the pixel.
LinearColour Resolver::colour_of_pixel(SurfaceId id, std::uint32_t x, std::uint32_t y) const {
    const Surface& surface = surfaces_[id - 1];
    const double h = map_.sample_size();
    const double samples = options_.samples;
    const Vec3 p = point_of(surface, h * (samples * (x + 0.5 - 0.5 * options_.width)),
                            -h * (samples * (y + 0.5 - 0.5 * options_.height)));
    const Vec3 n = bends_[surface.bend - 1].normal_at(p);
    const LinearColour colour = lit(material_at(surface, p), n);
    if (shade_ == nullptr || !surface.has_shade) return colour;
    const float share = shade_->brightness(n, dot(n, p), x, y);
    return (share * share) * colour;
}

// Fills `count` pixels of the picture from (x, y) to the right, whose samples all see the surface.
// The surface must not have a pattern.
void Resolver::fill_pixels(SurfaceId id, std::uint32_t x, std::uint32_t y, std::uint32_t count,
                           Image& image) const {
    Rgba8* const pixels = &image.at(x, y);
    if (is_round(id)) {
        for (std::uint32_t i = 0; i < count; ++i)
            pixels[i] = mean_of(colour_of_pixel(id, x + i, y));
        return;
    }
    if (!is_darker(id)) {
        std::fill_n(pixels, count, plain_[id]);
        return;
    }
    const std::span<const float> brightness =
        shade_->brightness(id, surfaces_[id - 1], x, y, count);
    for (std::uint32_t i = 0; i < count; ++i)
        pixels[i] = darkened(plain_[id], brightness[i]);
}

// Returns pixel (x, y) of the picture, whose first sample is at `first` in ids_.
Rgba8 Resolver::mixed_pixel(std::uint32_t x, std::uint32_t y, std::size_t first) const {
    const std::uint32_t samples = options_.samples;
    const double h = map_.sample_size();
    const double left = samples * (x - 0.5 * options_.width) + 0.5;
    const double top = samples * (y - 0.5 * options_.height) + 0.5;
    LinearColour sum, light;
    SurfaceId lit = kBackground;     // round surface whose light is known for the pixel
    SurfaceId shaded = kBackground;  // flat surface whose brightness is known for the pixel
    float share = 1.0F;
    for (std::uint32_t s = 0; s < samples * samples; ++s) {
        const std::uint32_t row = s / samples, column = s % samples;
        const std::size_t i = first + std::size_t{row} * rect_.width + column;
        const SurfaceId id = ids_[i];
        const bool round = is_round(id);
        if (!round) {
            light = colour_at(id, h * (left + column), -h * (top + row));
            if (id != shaded) share = brightness(id, x, y);
            shaded = id;
            light = (share * share) * light;
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

// True if all samples of a pixel see the same surface, without lines.
bool Resolver::is_uniform(std::size_t first) const {
    const SurfaceId id = ids_[first];
    for (std::uint32_t row = 0; row < options_.samples; ++row) {
        const std::size_t begin = first + std::size_t{row} * rect_.width;
        for (std::size_t i = begin; i < begin + options_.samples; ++i) {
            if (ids_[i] != id || ink_[i] != 0.0F) return false;
        }
    }
    return true;
}

void Resolver::fill(SurfaceId id, const PixelRect& tile, Image& image) {
    light_new_surfaces();
    if (shade_ != nullptr) shade_->begin(tile);
    if (has_pattern(id)) {
        const std::uint32_t samples = options_.samples;
        const SampleRect all{0, 0, tile.width * samples + 2 * kTileMargin,
                             tile.height * samples + 2 * kTileMargin};
        rect_ = {std::int64_t{tile.x} * samples - kTileMargin,
                 std::int64_t{tile.y} * samples - kTileMargin, all.width, all.height};
        ids_.assign(std::size_t{all.width} * all.height, id);
        clear_ink();
        mixed_.assign(std::size_t{tile.width} * tile.height, 0);
        return resolve_pixels(tile, image);
    }
    for (std::uint32_t y = tile.y; y < tile.y + tile.height; ++y)
        fill_pixels(id, tile.x, y, tile.width, image);
}

void Resolver::resolve(std::span<const SurfaceId> ids, const SampleRect& seen,
                       const PixelRect& tile, Image& image) {
    const std::uint32_t samples = options_.samples;
    rect_ = {std::int64_t{tile.x} * samples - kTileMargin,
             std::int64_t{tile.y} * samples - kTileMargin, tile.width * samples + 2 * kTileMargin,
             tile.height * samples + 2 * kTileMargin};
    light_new_surfaces();
    ids_.resize(std::size_t{rect_.width} * rect_.height);
    for (std::uint32_t row = 0; row < rect_.height; ++row) {
        const auto from = ids.begin() + ((rect_.y - seen.y + row) * std::int64_t{seen.width} +
                                         (rect_.x - seen.x));
        std::copy_n(from, rect_.width, ids_.begin() + std::int64_t{row} * rect_.width);
    }
    find_runs();
    const bool is_one =
        std::ranges::all_of(runs_, [&](const Run& run) { return run.id == ids_.front(); });
    if (is_one) return fill(ids_.front(), tile, image);
    if (shade_ != nullptr) shade_->begin(tile);
    remove_specks();
    find_changes(tile);
    resolve_pixels(tile, image);
}

void Resolver::resolve_pixels(const PixelRect& tile, Image& image) const {
    const std::uint32_t samples = options_.samples;
    for (std::uint32_t y = 0; y < tile.height; ++y) {
        const std::size_t row = std::size_t{kTileMargin + y * samples} * rect_.width + kTileMargin;
        const auto is_mixed = [&](std::uint32_t x) {
            const std::size_t first = row + std::size_t{x} * samples;
            return has_pattern(ids_[first]) ||
                   (mixed_[std::size_t{y} * tile.width + x] != 0 && !is_uniform(first));
        };
        for (std::uint32_t x = 0; x < tile.width;) {
            const SurfaceId id = ids_[row + std::size_t{x} * samples];
            const std::uint32_t begin = x;
            while (x < tile.width && ids_[row + std::size_t{x} * samples] == id && !is_mixed(x))
                ++x;
            if (x > begin) {
                fill_pixels(id, tile.x + begin, tile.y + y, x - begin, image);
                continue;
            }
            image.at(tile.x + x, tile.y + y) =
                mixed_pixel(tile.x + x, tile.y + y, row + std::size_t{x} * samples);
            ++x;
        }
    }
}

}  // namespace ncsim::exporter
