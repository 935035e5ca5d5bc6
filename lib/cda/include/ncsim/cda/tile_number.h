// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of tiles and limits on tiles.
#pragma once

#include <cstdint>
#include <string_view>

namespace ncsim::cda {

/// The number of a tile and the number of tiles of the part.
struct TileNumber {
    std::uint32_t tile = 0, of = 1;
    bool operator==(const TileNumber&) const = default;
};

/// Largest number of halvings of a tree: a tree has at most 2^kMostHalvings blocks.
inline constexpr int kMostHalvings = 12;
inline constexpr std::uint32_t kMostTiles = 1U << kMostHalvings;

/// Name of the model whose parts can be divided into tiles.
inline constexpr std::string_view kTiledModel = "cda";

}  // namespace ncsim::cda
