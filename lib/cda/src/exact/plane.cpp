// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversions and hash of planes.
#include "ncsim/cda/plane.h"

#include "ncsim/base/mix.h"

#include <numeric>

namespace ncsim::cda {

Plane canonical(std::int64_t nx, std::int64_t ny, std::int64_t nz, std::int64_t d) {
    const std::int64_t g = std::gcd(std::gcd(nx, ny), std::gcd(nz, d));
    return {static_cast<std::int32_t>(nx / g), static_cast<std::int32_t>(ny / g),
            static_cast<std::int32_t>(nz / g), d / g};
}

Vec3 unit_normal(const Plane& plane) {
    return normalized({static_cast<double>(plane.nx), static_cast<double>(plane.ny),
                       static_cast<double>(plane.nz)});
}

double offset_mm(const Plane& plane, const Lattice& lattice) {
    const double length = norm({static_cast<double>(plane.nx), static_cast<double>(plane.ny),
                                static_cast<double>(plane.nz)});
    return static_cast<double>(plane.d) / length * lattice.unit_mm;
}

double distance_about(const Plane& plane, Vec3 centre) {
    const Vec3 n{static_cast<double>(plane.nx), static_cast<double>(plane.ny),
                 static_cast<double>(plane.nz)};
    return (static_cast<double>(plane.d) - dot(n, centre)) / norm(n);
}

std::size_t PlaneHash::operator()(const Plane& p) const noexcept {
    std::uint64_t h = static_cast<std::uint64_t>(p.d);
    for (const std::int32_t n : {p.nx, p.ny, p.nz})
        h = mix(h, static_cast<std::uint32_t>(n));
    return h;
}

}  // namespace ncsim::cda
