// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads any bytes as a stock file. Reading must end, and a file that is no stock must be refused. A
// small stock is cut and must have a closed surface.
#include "ncsim/cda/shape.h"

#include "support/scene.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ncsim;
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    cda::Shape shape;
    try {
        shape = cda::read_shape(in);
    } catch (const std::runtime_error&) {
        return 0;
    }
    constexpr std::size_t kSmall = 12;
    if (shape.carved.size() > kSmall || shape.outer.planes.size() > 4 * kSmall) return 0;
    try {
        const cda::TreeCda prototype;
        const auto part = cda::create(prototype, shape);
        const cda::TreeCda block(shape.outer, shape.lattice);
        // Corners are rounded to 2^-24 of a unit, which counts if the stock is a few units large.
        const Vec3 extent = shape.outer.bounds.size();
        const double area = 2.0 * (extent.x * extent.y + extent.y * extent.z + extent.z * extent.x);
        test::sound_boundary(dynamic_cast<const cda::TreeCda&>(*part),
                             block.volume() + 200.0 * shape.lattice.unit_mm * area);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        std::abort();
    }
    return 0;
}
