// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for equal normals by content.
#include "tree/normals_pool.h"

#include "ncsim/base/mix.h"

#include <algorithm>
#include <bit>

namespace ncsim::cda {

namespace {

std::uint64_t hash_of(const FacetNormals& normals) {
    std::uint64_t hash = 0;
    for (const auto* components : {&normals.x, &normals.y, &normals.z}) {
        for (const double c : *components)
            hash = mix(hash, std::bit_cast<std::uint64_t>(c));
    }
    return hash;
}

}  // namespace

std::shared_ptr<const FacetNormals> NormalsPool::intern(
    const std::shared_ptr<const FacetNormals>& normals) {
    if (!normals) return nullptr;
    const auto [known, is_new] = known_.try_emplace(normals.get());
    if (is_new) {
        auto& same_hash = by_content_[hash_of(*normals)];
        const auto found = std::ranges::find_if(same_hash, [&](const auto& other) {
            return other->x == normals->x && other->y == normals->y && other->z == normals->z;
        });
        const bool is_first = found == same_hash.end();
        known->second = {normals, is_first ? normals : *found};
        if (is_first) same_hash.push_back(normals);
    }
    return known->second.first;
}

}  // namespace ncsim::cda
