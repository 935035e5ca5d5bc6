// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface in several files: where one of them ends, another goes on.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

namespace ncsim::exporter {

/// An edge of a triangle, from corner to corner, by their coordinates as files have them: mm, as
/// seen from the place that all files of a surface have in common.
using FloatEdge = std::array<std::array<float, 3>, 2>;

/// Edges of triangles that have no partner yet: one with the same corners in the other direction,
/// of whichever file.
class Seams {
public:
    /// Expected O(1).
    void add(const FloatEdge& edge);
    void add(std::span<const FloatEdge> edges);
    /// How many there are.
    std::size_t open() const { return open_; }
    /// All of them, sorted.
    std::vector<FloatEdge> edges() const;

private:
    struct Hash {
        std::size_t operator()(const FloatEdge& edge) const;
    };
    // The smaller corner first: how often there, less how often back.
    std::unordered_map<FloatEdge, int, Hash> net_;
    std::size_t open_ = 0;
};

}  // namespace ncsim::exporter
