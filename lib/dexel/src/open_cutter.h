// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools that are open above the stock against rays along z: a ray ends at the lowest of all tools.
// A block of rays is processed at a time. The tool that may get lowest in the block is first, so
// that most tools are soon proven to stay above the remaining material and are skipped: in a raster
// of many passes, nearly all.
#pragma once

#include "grid.h"
#include "rays.h"
#include "round_sweep.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::dexel {

/// Cuts the rays along z as if by the tools in sequence. The end of a ray has the origin of the
/// tool that is lowest there, in integer units, the first among equals. The result does not depend
/// on the division into pieces.
class OpenCutter {
public:
    OpenCutter(const Grid& grid, Rays& rays, Lanes lanes = widest_lanes());

    /// Cuts the rows of blocks [begin, end). Requires: all tools are is_open_above() the grid.
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
    std::vector<double> x_, y_;               // coordinates of rays, padded to full blocks
    std::vector<BlockExtent> columns_;        // extents of blocks along x
    std::vector<std::vector<Visit>> visits_;  // per block of a band
    BlockBounds bounds_;
    LowestBlock lowest_;
};

}  // namespace ncsim::dexel
