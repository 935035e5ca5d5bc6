// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part by boundary evaluation with exact numbers: the stock less each cell, one Boolean operation
// after the other, as the thesis describes it (2.1) and could not make it stable. It shares nothing
// with the aggregates but the planes of the cells: an oracle of other descent.
//
// CGAL, Nef_polyhedron_3 over Exact_predicates_exact_constructions_kernel; after Laidlaw, Trumbore,
// Hughes 1986 only in what it does, not in how.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/vec.h"

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

    /// Where the boundary is neither flat nor straight, in units, each coordinate the double
    /// nearest to the exact one; in order.
    std::vector<cda::Vec3> corners() const;
    /// Cubic units, the double nearest to the exact volume.
    double volume() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::test
