// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facet normals that bodies share: tools of the same shape, and a tool that returns to an
// orientation.
#pragma once

#include "ncsim/cda/cell.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace ncsim::cda {

/// Keeps a single FacetNormals object for all cells with the same normals in the same order.
/// Therefore cells of different bodies are compared like cells of the same body.
class NormalsPool {
public:
    /// Returns the first object with equal content; null for null.
    /// Cost: O(size) for an object that the pool has not seen, O(1) otherwise.
    std::shared_ptr<const FacetNormals> intern(const std::shared_ptr<const FacetNormals>& normals);

private:
    struct Known {
        std::shared_ptr<const FacetNormals> seen;  // kept alive, because the address is the key
        std::shared_ptr<const FacetNormals> first;
    };
    std::unordered_map<const FacetNormals*, Known> known_;
    std::unordered_map<std::uint64_t, std::vector<std::shared_ptr<const FacetNormals>>> by_content_;
};

}  // namespace ncsim::cda
