// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of points in a grid of cells, at two scales, and brightness from the sums. The tangent plane
// of a point is exact, so the shade of a pocket ends at its edge although cells are coarse.
#include "render/recess_shade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ncsim::exporter {

namespace {

// Cells along the height of a picture, and along three quarters of its width.
constexpr double kCells = 240.0;
// Largest loss of brightness.
constexpr double kDarkest = 0.36;
// Lengths are whole numbers of 1 / kUnits of the visible height.
constexpr double kUnits = 1 << 22;

// The weight of a point falls linearly along columns and rows to 0 at `2 * reach` cells.
struct Scale {
    std::uint32_t reach;
    double strength;  // loss of brightness at low heights
};
constexpr std::array<Scale, 2> kScales{{{4, 2.2}, {16, 0.8}}};

// Surfaces of a tile whose heights are kept.
constexpr std::size_t kMostPlanes = 8;

// Sums of coordinates in units, and the number of points.
struct Points {
    std::int64_t x = 0, y = 0, z = 0, count = 0;

    Points& operator+=(const Points& p) {
        x += p.x;
        y += p.y;
        z += p.z;
        count += p.count;
        return *this;
    }
    Points& operator-=(const Points& p) {
        x -= p.x;
        y -= p.y;
        z -= p.z;
        count -= p.count;
        return *this;
    }
};

// Replaces the values of each row of `grid` by their sums over `reach` cells to both sides, twice.
// Returns the result with rows and columns exchanged.
std::vector<Points> sum_rows(const std::vector<Points>& grid, std::size_t width, std::size_t height,
                             std::size_t reach) {
    std::vector<Points> result(grid.size()), line(width + 4 * reach), once(width + 2 * reach);
    for (std::size_t row = 0; row < height; ++row) {
        std::copy_n(&grid[row * width], width, &line[2 * reach]);
        Points sum, twice;
        for (std::size_t i = 0; i < 2 * reach; ++i)
            sum += line[i];
        for (std::size_t i = 0; i < once.size(); ++i) {
            sum += line[i + 2 * reach];
            once[i] = sum;
            twice += sum;
            sum -= line[i];
            if (i < 2 * reach) continue;
            result[(i - 2 * reach) * height + row] = twice;
            twice -= once[i - 2 * reach];
        }
    }
    return result;
}

std::int64_t in_units(double length, double units_per_mm) {
    // Truncation of a positive number.
    constexpr double kPositive = 1LL << 40;
    return static_cast<std::int64_t>(length * units_per_mm + kPositive) -
           static_cast<std::int64_t>(kPositive);
}

// Returns the brightness at a mean height above the tangent plane, relative to the radius of the
// mean and times its strength.
float brightness_at(double height) {
    if (!(height > 0.0)) return 1.0F;
    return static_cast<float>(1.0 - kDarkest * height / (kDarkest + height));
}

double interpolated(double a, double b, double share) {
    return a + share * (b - a);
}

}  // namespace

RecessShade::RecessShade(const ScreenMap& map, const RenderOptions& options)
    : map_(map),
      samples_wide_(static_cast<double>(options.width) * options.samples),
      samples_high_(static_cast<double>(options.height) * options.samples),
      samples_(options.samples) {
    const double rows = options.usual_height > 0 ? options.usual_height : options.height;
    const double size = std::max(rows, 0.75 * options.width) * options.samples / kCells;
    cells_.cell = std::max(1U, static_cast<std::uint32_t>(std::lround(size)));
    // Each pixel is between the centres of two cells.
    cells_.width = options.width * options.samples / cells_.cell + 2;
    cells_.height = options.height * options.samples / cells_.cell + 2;
    columns_ = places(options.width);
    rows_ = places(options.height);
}

std::vector<RecessShade::Place> RecessShade::places(std::uint32_t pixels) const {
    std::vector<Place> result;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
        const double at = std::max(0.0, (pixel + 0.5) * samples_ / cells_.cell - 0.5);
        const auto cell = static_cast<std::uint32_t>(at);
        result.push_back({cell, at - cell});
    }
    return result;
}

void RecessShade::gather(std::span<const SurfaceId> ids, const std::vector<Surface>& surfaces) {
    const double h = map_.sample_size(), cell = cells_.cell;
    const double units = kUnits / map_.camera().height;
    std::vector<Points> grid(ids.size());
    for (std::uint32_t row = 0; row < cells_.height; ++row) {
        const double y = -h * ((row + 0.5) * cell - 0.5 * samples_high_);
        for (std::uint32_t column = 0; column < cells_.width; ++column) {
            const std::size_t i = std::size_t{row} * cells_.width + column;
            if (ids[i] == kBackground || !surfaces[ids[i] - 1].has_shade) continue;
            const Surface& surface = surfaces[ids[i] - 1];
            const double x = h * ((column + 0.5) * cell - 0.5 * samples_wide_);
            const Vec3 p = map_.point_at(x, y, map_.depth_of(surface.n_C, surface.offset, x, y));
            grid[i] = {in_units(p.x, units), in_units(p.y, units), in_units(p.z, units), 1};
        }
    }
    sums_.assign(ids.size(), {});
    for (const Scale& scale : kScales) {
        const std::vector<Points> sums =
            sum_rows(sum_rows(grid, cells_.width, cells_.height, scale.reach), cells_.height,
                     cells_.width, scale.reach);
        const double side = 2.0 * scale.reach + 1.0, radius = 2.0 * scale.reach * cell * h;
        const double weight = scale.strength / (side * side * side * side * radius);
        const double length = weight / units;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums_[i].x += length * static_cast<double>(sums[i].x);
            sums_[i].y += length * static_cast<double>(sums[i].y);
            sums_[i].z += length * static_cast<double>(sums[i].z);
            sums_[i].weight += weight * static_cast<double>(sums[i].count);
        }
    }
}

void RecessShade::begin(const PixelRect& tile) {
    first_column_ = columns_[tile.x].cell;
    first_row_ = rows_[tile.y].cell;
    tile_columns_ = columns_[tile.x + tile.width - 1].cell + 2 - first_column_;
    tile_rows_ = rows_[tile.y + tile.height - 1].cell + 2 - first_row_;
    count_ = latest_ = 0;
}

const RecessShade::Plane& RecessShade::plane(SurfaceId id, const Surface& surface) {
    if (latest_ < count_ && planes_[latest_].id == id) return planes_[latest_];
    for (latest_ = 0; latest_ < count_; ++latest_) {
        if (planes_[latest_].id == id) return planes_[latest_];
    }
    if (count_ == kMostPlanes) count_ = latest_ = 0;
    if (++count_ > planes_.size()) planes_.emplace_back();
    Plane& plane = planes_[latest_];
    plane.id = id;
    plane.heights.resize(std::size_t{tile_rows_} * tile_columns_);
    double* height = plane.heights.data();
    for (std::uint32_t row = 0; row < tile_rows_; ++row) {
        const Sum* const sums =
            &sums_[std::size_t{first_row_ + row} * cells_.width + first_column_];
        for (std::uint32_t column = 0; column < tile_columns_; ++column)
            *height++ = sums[column].height_above(surface.n_C, surface.offset);
    }
    plane.is_darker = brightness_at(*std::ranges::max_element(plane.heights)) < 1.0F;
    return plane;
}

bool RecessShade::is_darker(SurfaceId id, const Surface& surface) {
    return plane(id, surface).is_darker;
}

std::span<const float> RecessShade::brightness(SurfaceId id, const Surface& surface,
                                               std::uint32_t x, std::uint32_t y,
                                               std::uint32_t count) {
    const Plane& plane = this->plane(id, surface);
    if (count > brightness_.size()) brightness_.resize(count);
    const std::span<float> result = std::span(brightness_).first(count);
    const auto [row, next_row] = rows_[y];
    const double* const above = &plane.heights[std::size_t{row - first_row_} * tile_columns_];
    const double* const below = above + tile_columns_;
    const std::uint32_t first = columns_[x].cell - first_column_;
    const std::uint32_t last = columns_[x + count - 1].cell - first_column_ + 1;
    in_row_.resize(tile_columns_);
    for (std::uint32_t i = first; i <= last; ++i)
        in_row_[i] = interpolated(above[i], below[i], next_row);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto [column, next_column] = columns_[x + i];
        const double* const heights = &in_row_[column - first_column_];
        result[i] = brightness_at(interpolated(heights[0], heights[1], next_column));
    }
    return result;
}

float RecessShade::brightness(Vec3 n_C, double offset, std::uint32_t x, std::uint32_t y) const {
    const auto [column, next_column] = columns_[x];
    const auto [row, next_row] = rows_[y];
    const Sum* const above = &sums_[std::size_t{row} * cells_.width + column];
    const Sum* const below = above + cells_.width;
    const auto in_row = [&, share = next_column](const Sum* sums) {
        return interpolated(sums[0].height_above(n_C, offset), sums[1].height_above(n_C, offset),
                            share);
    };
    return brightness_at(interpolated(in_row(above), in_row(below), next_row));
}

}  // namespace ncsim::exporter
