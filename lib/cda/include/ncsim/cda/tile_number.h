// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace ncsim::cda {

/// Of `of` tiles of a part that one.
struct TileNumber {
    std::uint32_t tile = 0, of = 1;
    bool operator==(const TileNumber&) const = default;
};

/// A tree has no more blocks, a power of two.
inline constexpr int kMostHalvings = 12;
inline constexpr std::uint32_t kMostTiles = 1U << kMostHalvings;

/// The model whose parts may be cut in tiles.
inline constexpr std::string_view kTiledModel = "cda";

}  // namespace ncsim::cda
