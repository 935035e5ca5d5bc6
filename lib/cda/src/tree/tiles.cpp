// SPDX-License-Identifier: GPL-3.0-or-later
//
// Combination of tiles: headers, volumes, and surfaces stitched from the tiles' outlines.
#include "ncsim/cda/tiles.h"

#include "ncsim/base/parallel.h"

#include "surface/stitch.h"
#include "tree/tile_bytes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace ncsim::cda {

namespace {

// Volumes are requested after each tool.
constexpr std::uint32_t kMostAsked = 10'000'000;

constexpr std::size_t kNoTile = ~std::size_t{0};

}  // namespace

// Header of a tile's data; outlines follow.
struct TileHeader {
    std::uint32_t tile = 0, of = 0, blocks = 0, asked = 0;
    std::vector<std::uint32_t> own;  // blocks, ascending
    std::vector<double> volumes;     // per request and own block; cubic units
};

// A box in units of 2^-24 lattice units.
struct FixedBox {
    std::array<std::int64_t, 3> min{}, max{};

    explicit FixedBox(const Outlines& outlines) {
        min.fill(std::numeric_limits<std::int64_t>::max());
        max.fill(std::numeric_limits<std::int64_t>::min());
        for (const Outlines::Point& point : outlines.points()) {
            for (std::size_t i = 0; i < 3; ++i) {
                min[i] = std::min(min[i], point.fixed.at[i]);
                max[i] = std::max(max[i], point.fixed.at[i]);
            }
        }
    }
    bool touches(const FixedBox& o) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (min[i] > o.max[i] || max[i] < o.min[i]) return false;
        }
        return true;
    }
};

namespace {

TileHeader header_of(TileBytes& bytes) {
    TileHeader header;
    std::uint32_t own = 0;
    for (std::uint32_t* number : {&header.tile, &header.of, &header.blocks, &own, &header.asked})
        *number = bytes.u32();
    if (header.blocks > kMostTiles || own > header.blocks || header.asked > kMostAsked)
        throw std::invalid_argument("it is of another part");
    for (std::uint32_t i = 0; i < own; ++i) {
        header.own.push_back(bytes.u32());
        if (header.own[i] >= header.blocks || (i > 0 && header.own[i] <= header.own[i - 1]))
            throw std::invalid_argument("it has a block that there is not");
    }
    for (std::uint64_t k = 0; k < std::uint64_t{header.asked} * own; ++k)
        header.volumes.push_back(bytes.number());
    return header;
}

std::string tile_error(std::size_t tile, const std::invalid_argument& why) {
    return "tile " + std::to_string(tile) + ": " + why.what();
}

// Converts a gap in the surface into a runtime error. Without tiles a gap is a bug of this program;
// with tiles the data may be inconsistent.
template <class Make>
Boundary fitting(const Make& make) {
    try {
        return make();
    } catch (const std::logic_error& e) {
        throw std::runtime_error(std::string("the tiles do not fit together: ") + e.what());
    }
}

}  // namespace

struct Tiles::Tile {
    TileHeader header;
    Outlines border;
    FixedBox bounds{border};
};

class Tiles::Model final : public WorkpieceModel {
public:
    explicit Model(std::shared_ptr<const Tiles> tiles, const Lattice& lattice = {})
        : tiles_(std::move(tiles)), lattice_(lattice) {}

    std::string_view name() const override { return kTiledModel; }
    const Lattice& lattice() const override { return lattice_; }
    std::unique_ptr<WorkpieceModel> create(const Cell&, const Lattice& lattice) const override {
        return std::make_unique<Model>(tiles_, lattice);
    }
    // No cell removes more, because the tiles contain all cuts.
    double subtract(const Cell&) override { return 0.0; }
    std::unique_ptr<WorkpieceModel> clone() const override {
        return std::make_unique<Model>(*this);
    }

    // Sums block by block in the order of the blocks: the same sum as without tiles.
    double volume() const override {
        if (requests_ == tiles_->volumes_)
            throw std::logic_error("tiles were not asked that often for their volume");
        double sum = 0.0;
        for (const auto& [tile, number] : tiles_->blocks_) {
            const TileHeader& header = tiles_->tiles_[tile].header;
            sum += header.volumes[requests_ * header.own.size() + number];
        }
        ++requests_;
        return sum * lattice_.cubic_unit_mm3();
    }
    Boundary boundary() const override {
        Stitcher stitcher(lattice_, tiles_->threads_);
        make_in_parallel(
            tiles_->threads_, tiles_->size(),
            [&](std::size_t tile) { return tiles_->outlines_of(tile); },
            [&](std::size_t, const std::vector<Outlines>& blocks) {
                for (const Outlines& block : blocks)
                    stitcher.add_part(block);
            });
        return fitting([&] { return stitcher.finish(); });
    }

private:
    std::shared_ptr<const Tiles> tiles_;
    Lattice lattice_;
    mutable std::size_t requests_ = 0;
};

Tiles::Tiles(std::size_t count, Read read, std::size_t threads)
    : read_(std::move(read)), threads_(threads) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::string all = read_(i);
        try {
            TileBytes bytes(all);
            Tile tile;
            tile.header = header_of(bytes);
            const TileHeader& header = tile.header;
            if (header.tile != i || header.of != count)
                throw std::invalid_argument("it is another one, or there are more of them");
            if (i == 0) blocks_.assign(header.blocks, {kNoTile, 0});
            if (header.blocks != blocks_.size() || (i > 0 && header.asked != volumes_))
                throw std::invalid_argument("it is of another part");
            volumes_ = header.asked;
            for (std::uint32_t k = 0; k < header.own.size(); ++k) {
                auto& [known, number] = blocks_[header.own[k]];
                if (known != kNoTile) throw std::invalid_argument("it has a block of another one");
                known = i, number = k;
                (void)bytes.outlines_as_bytes();
            }
            tile.border = bytes.outlines();
            tile.bounds = FixedBox(tile.border);
            if (!bytes.is_at_end()) throw std::invalid_argument("there is more in it");
            tiles_.push_back(std::move(tile));
        } catch (const std::invalid_argument& e) {
            throw std::invalid_argument(tile_error(i, e));
        }
    }
    if (blocks_.empty() || std::ranges::count(blocks_, kNoTile, &TileIndex::tile) > 0)
        throw std::invalid_argument("not all blocks of the part are there");
}

Tiles::Tiles(const std::vector<std::string>& tiles)
    : Tiles(tiles.size(), [kept = std::make_shared<const std::vector<std::string>>(tiles)](
                              std::size_t i) { return (*kept)[i]; }) {}

Tiles::~Tiles() = default;

std::size_t Tiles::size() const {
    return tiles_.size();
}

std::vector<Outlines> Tiles::outlines_of(std::size_t tile) const {
    const std::string all = read_(tile);
    try {
        TileBytes bytes(all);
        const TileHeader header = header_of(bytes);
        if (header.tile != tile || header.own != tiles_[tile].header.own)
            throw std::invalid_argument("it is not what it was");
        std::vector<Outlines> blocks;
        for (std::size_t b = 0; b < header.own.size(); ++b)
            blocks.push_back(bytes.outlines());
        return blocks;
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(tile_error(tile, e));
    }
}

Boundary Tiles::surface(std::size_t tile, const Lattice& lattice) const {
    Stitcher stitcher(lattice, 1);
    for (const Outlines& block : outlines_of(tile))
        stitcher.add_part(block);
    for (std::size_t other = 0; other < size(); ++other) {
        if (other != tile && tiles_[other].bounds.touches(tiles_[tile].bounds))
            stitcher.add_outside(tiles_[other].border);
    }
    return fitting([&] { return stitcher.finish_open(); });
}

std::unique_ptr<WorkpieceModel> Tiles::model(std::shared_ptr<const Tiles> tiles) {
    return std::make_unique<Model>(std::move(tiles));
}

}  // namespace ncsim::cda
