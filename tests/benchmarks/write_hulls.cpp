// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_hulls PROGRAM: prints the hulls that a program removes from its stock, for use by external
// libraries. First line: the corners of the stock, mm. Second line: the volume of the part, mm³.
// Each further line: the corners of a hull, mm.
#include "hulls.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>

namespace ncsim::bench {
namespace {

void write_hulls(const Hulls& hulls) {
    const auto& [min, max] = hulls.stock;
    fmt::print("{} {} {} {} {} {}\n", min.x, min.y, min.z, max.x, max.y, max.z);
    fmt::print("{}\n", hulls.exact_volume());
    for (const cda::ConvexPolytope& body : bodies_of(hulls, Within::Lattice)) {
        const char* between = "";
        for (const cda::ExactPoint& corner : body.vertices()) {
            const Vec3 p = hulls.lattice.to_mm(corner.approx);
            fmt::print("{}{} {} {}", between, p.x, p.y, p.z);
            between = " ";
        }
        fmt::print("\n");
    }
}

}  // namespace
}  // namespace ncsim::bench

int main(int argc, char** argv) {
    try {
        ncsim::bench::write_hulls(ncsim::bench::hulls_of(argc > 1 ? argv[1] : ""));
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "write_hulls: %s\n", e.what());
        return 2;
    }
}
