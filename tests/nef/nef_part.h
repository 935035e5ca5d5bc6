// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part by boundary evaluation with exact numbers: the stock less each cell, by successive Boolean
// operations, as the thesis describes (2.1) but could not make stable. The class is an independent
// oracle, because it shares only the planes of the cells with the aggregates.
//
// Uses CGAL's Nef_polyhedron_3 over Exact_predicates_exact_constructions_kernel.
// Source: Laidlaw, Trumbore, Hughes 1986, for the operation but not for the algorithm.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/cell.h"

#include <memory>
#include <vector>

namespace ncsim::test {

class NefPart {
public:
    explicit NefPart(const cda::Cell& stock);
    ~NefPart();
    NefPart(const NefPart&) = delete;
    NefPart& operator=(const NefPart&) = delete;

    void subtract(const cda::Cell& cell);

    /// Returns the corners of the boundary in lattice units, sorted. Each coordinate is the double
    /// nearest to the exact coordinate. A corner is a point where the boundary is neither flat nor
    /// straight.
    std::vector<Vec3> corners() const;
    /// Returns the volume in cubic units, the double nearest to the exact volume.
    double volume() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::test
