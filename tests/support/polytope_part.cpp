// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts random polytopes from a block.
#include "support/polytope_part.h"

#include <random>

namespace ncsim::test {

namespace {

constexpr std::uint32_t kCuts = 40;

// Returns a convex body of 12 random planes, 2 to 6 mm from a random point in or above the upper
// half of the stock.
cda::Cell random_cell(std::mt19937& random, const cda::Lattice& lattice, cda::Origin origin) {
    std::uniform_int_distribution<std::int64_t> component(-1000, 1000);
    const auto between = [&](double a, double b) {
        return a + (b - a) * static_cast<double>(component(random) + 1000) / 2000.0;
    };
    const Vec3 centre{between(0, 40), between(0, 30), between(5, 15)};
    cda::Cell cell;
    cell.origin = origin;
    const auto add_plane = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
        const Vec3 n{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        const double d = dot(n, centre) + between(2, 6) * norm(n);
        cell.planes.push_back(
            cda::canonical(x, y, z, static_cast<std::int64_t>(d / lattice.unit_mm)));
    };
    // Six planes are nearly perpendicular to the axes, so the body is bounded; six more are
    // arbitrary.
    for (const std::int64_t sign : {-1, 1}) {
        add_plane(sign * 1000, component(random) / 5, component(random) / 5);
        add_plane(component(random) / 5, sign * 1000, component(random) / 5);
        add_plane(component(random) / 5, component(random) / 5, sign * 1000);
    }
    for (int i = 0; i < 6; ++i)
        add_plane(component(random), component(random), 1 + component(random));
    cell.bounds.add(centre - Vec3{20, 20, 20});
    cell.bounds.add(centre + Vec3{20, 20, 20});
    return cell;
}

}  // namespace

cda::FlatCda polytope_part() {
    std::mt19937 random(20010117);
    const Box stock{{0, 0, 0}, {40, 30, 10}};
    const cda::Lattice lattice = cda::Lattice::for_stock(stock);
    cda::FlatCda part(cda::box_cell(lattice.round(stock.min), lattice.round(stock.max), lattice),
                      lattice);
    for (std::uint32_t i = 1; i <= kCuts; ++i) {
        part.subtract(random_cell(random, lattice, cda::Origin{i}));
    }
    return part;
}

mesh::Provenance provenance_of_polytope_part() {
    mesh::Provenance provenance;
    provenance.program = "polytopes.nc";
    provenance.entries.push_back({});
    for (std::uint32_t i = 1; i <= kCuts; ++i)
        provenance.entries.push_back({i, 1 + i % 5});
    return provenance;
}

}  // namespace ncsim::test
