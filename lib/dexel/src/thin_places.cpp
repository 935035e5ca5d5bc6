// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for thin places, and the error of volumes.
#include "thin_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ncsim::dexel {

namespace {

// Two ends of a ray with material or a gap between.
struct EndPair {
    const End& low;
    const End& high;
};

class Finder {
public:
    Finder(const Rays& rays, const Grid& grid, const cda::Lattice& lattice)
        : rays_(rays), grid_(grid), lattice_(lattice) {}

    void examine(const EndPair& place, std::size_t u, std::size_t v, cda::ThinPlaces& found) {
        const GridAxis& along = grid_.axes[rays_.axis()];
        const double thickness = place.high.at - place.low.at;
        if (thickness >= along.pitch) return;
        ++found.count;
        if (along.from(place.low.at) == along.from(place.high.at)) {
            ++found.missing;
            missing_units += thickness;
        }
        const double mm = thickness * lattice_.unit_mm;
        if (found.thinnest_mm != 0.0 && mm >= found.thinnest_mm) return;
        found.thinnest_mm = mm;
        Vec3 at;
        at[static_cast<int>(rays_.axis())] = 0.5 * (place.low.at + place.high.at);
        at[static_cast<int>(rays_.u_axis())] = grid_.axes[rays_.u_axis()].at[u];
        at[static_cast<int>(rays_.v_axis())] = grid_.axes[rays_.v_axis()].at[v];
        found.at = lattice_.to_mm(at);
        found.origin = std::max(place.low.origin, place.high.origin);
    }

    double missing_units = 0.0;

private:
    const Rays& rays_;
    const Grid& grid_;
    const cda::Lattice& lattice_;
};

double area_of_ray(const Rays& rays, const Grid& grid) {
    return grid.axes[rays.u_axis()].pitch * grid.axes[rays.v_axis()].pitch;
}

}  // namespace

void find_thin_places(const Rays& rays, const Grid& grid, const cda::Lattice& lattice,
                      cda::Aliasing& found) {
    if (rays.rows() == 0) return;
    Finder material(rays, grid, lattice), gaps(rays, grid, lattice);
    const std::size_t row = grid.axes[rays.u_axis()].corners();
    for (std::size_t v = 0; v < rays.rows(); ++v) {
        for (std::size_t u = 0; u < row; ++u) {
            const auto intervals = rays(u, v).intervals();
            for (std::size_t i = 0; i < intervals.size(); ++i) {
                material.examine({intervals[i].low, intervals[i].high}, u, v, found.material);
                if (i > 0)
                    gaps.examine({intervals[i - 1].high, intervals[i].low}, u, v, found.gaps);
            }
        }
    }
    const double each = area_of_ray(rays, grid) * lattice.cubic_unit_mm3();
    found.material.missing_mm3 =
        std::max(found.material.missing_mm3, material.missing_units * each);
    found.gaps.missing_mm3 = std::max(found.gaps.missing_mm3, gaps.missing_units * each);
}

namespace {

// Returns the expected difference in length of the next ray along an axis, from the planes at the
// ends of this ray.
double slope_of(const Ray& ray, std::size_t along, std::size_t axis) {
    double sum = 0.0;
    for (const Interval& interval : ray.intervals()) {
        for (const End* end : {&interval.low, &interval.high}) {
            const Vec3 n = end->normal.unpacked();
            const double up = std::abs(n[static_cast<int>(along)]);
            // Steeper planes are walls.
            constexpr double kSteepest = 0.05;
            if (up > kSteepest) sum -= n[static_cast<int>(axis)] / up;
        }
    }
    return sum;
}

}  // namespace

double doubtful_volume(const Rays& rays, const Grid& grid) {
    const std::size_t row = grid.axes[rays.u_axis()].corners();
    const auto step = [&](const Ray& a, const Ray& b, std::size_t axis) {
        const auto change = static_cast<double>(b.length() - a.length());
        const double expected = 0.5 * grid.axes[axis].pitch *
                                (slope_of(a, rays.axis(), axis) + slope_of(b, rays.axis(), axis));
        return std::min(std::abs(change), std::abs(change - expected));
    };
    double along_u = 0.0, along_v = 0.0;
    // The outermost rays are outside of the stock, whose walls are exact.
    for (std::size_t v = 1; v + 1 < rays.rows(); ++v) {
        for (std::size_t u = 1; u + 1 < row; ++u) {
            if (u + 2 < row) along_u += step(rays(u, v), rays(u + 1, v), rays.u_axis());
            if (v + 2 < rays.rows()) along_v += step(rays(u, v), rays(u, v + 1), rays.v_axis());
        }
    }
    return 0.5 * area_of_ray(rays, grid) * (along_u + along_v);
}

}  // namespace ncsim::dexel
