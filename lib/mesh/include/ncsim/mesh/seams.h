// SPDX-License-Identifier: GPL-3.0-or-later
//
// Check that a surface split into several files is closed: each open edge of a file has its partner
// in another file.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

namespace ncsim::mesh {

/// Directed edge of a triangle, as the coordinates of its two corners in the files: mm, relative to
/// the centre that all files of a surface share.
using FloatEdge = std::array<std::array<float, 3>, 2>;

/// Edges of triangles without a partner. The partner of an edge is an edge with the same corners in
/// the opposite direction, in any of the files.
class Seams {
public:
    /// Cost: O(1) expected.
    void add(const FloatEdge& edge);
    void add(std::span<const FloatEdge> edges);
    /// Returns the number of edges without a partner.
    std::size_t open() const { return open_; }
    /// Returns the edges without a partner, sorted.
    std::vector<FloatEdge> edges() const;

private:
    struct Hash {
        std::size_t operator()(const FloatEdge& edge) const;
    };
    // Uses from the smaller corner to the larger minus uses in the opposite direction.
    std::unordered_map<FloatEdge, int, Hash> net_;
    std::size_t open_ = 0;
};

}  // namespace ncsim::mesh
