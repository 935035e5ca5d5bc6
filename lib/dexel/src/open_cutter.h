// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools that are open above the stock against rays along z: what is left of a ray ends where the
// lowest of all of them is. That is asked of a block of rays at a time. The tools come to it with
// the one first that may get lowest there, so that soon all others are known to stay above what is
// left and need not be looked at: of a raster of many passes, nearly all.
#pragma once

#include "grid.h"
#include "rays.h"
#include "round_sweep.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::dexel {

/// Cuts the rays along z. Of each it makes what would be left after one tool after the other; its
/// end has the origin of the one that is lowest there, in whole units, the first of several. The
/// same in pieces of any size.
class OpenCutter {
public:
    OpenCutter(const Grid& grid, Rays& rays, Lanes lanes = widest_lanes());

    /// In the rows of blocks from `begin` to before `end`. All is_open_above() the grid.
    void cut(std::span<const SweptTool* const> tools, std::size_t begin, std::size_t end);

private:
    struct Visit {
        BlockBound bound;
        std::uint32_t tool;
    };

    void find_visits(std::span<const SweptTool* const> tools,
                     std::span<const std::uint32_t> of_band, std::size_t band);
    void cut_block(std::span<const SweptTool* const> tools, std::size_t column, std::size_t band);
    void load(std::size_t column, std::size_t band);
    void store(std::span<const SweptTool* const> tools, std::size_t column, std::size_t band);

    const Grid& grid_;
    Rays& rays_;
    Lanes lanes_;
    std::vector<double> x_, y_;  // of rays, and beyond the last of them as many as fill a block
    std::vector<BlockExtent> columns_;        // of blocks, along x
    std::vector<std::vector<Visit>> visits_;  // of each block of a band
    BlockBounds bounds_;
    LowestBlock lowest_;
};

}  // namespace ncsim::dexel
