// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that become two, with a vertex between.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// An edge in two, from where it starts to `middle` and on from there.
struct Halves {
    Vec3 middle;
    Curve first, second;
};

/// Circles and ellipses where `at` of their angle is passed, from 0 to 1; splines end at the knot
/// in the middle. Nothing of lines, and of splines that have no knot inside.
std::optional<Halves> edge_in_two(const Part& part, const Edge& edge, double at = 0.5);

/// Halves edges of a part, in all of its loops at once: between the first of them and finish() the
/// loops are those from before. New vertices and edges are added at the end.
class Halving {
public:
    explicit Halving(Part& part);
    /// There. False: it stays as it is, has been halved, or is a half itself.
    bool halve(std::uint32_t edge, double at = 0.5);
    /// The same, but splines at any place, where they get a knot.
    bool divide(std::uint32_t edge, double at);
    /// Loops run along both halves. O(n) for n edges.
    void finish();

private:
    bool take(std::uint32_t edge, std::optional<Halves> halves);

    Part& part_;
    std::vector<std::uint32_t> second_;  // of each edge that was there
};

}  // namespace ncsim::brep
