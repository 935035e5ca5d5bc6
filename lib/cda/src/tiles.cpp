// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/tiles.h"

#include "ncsim/cda/parallel.h"

#include "stitch.h"
#include "tile_bytes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace ncsim::cda {

namespace {

// Volumes are asked for after each tool.
constexpr std::uint32_t kMostAsked = 10'000'000;

// What stands before the outlines.
struct TileHeader {
    std::uint32_t tile, of, blocks, first, last, asked;
};

TileHeader header_of(TileBytes& bytes) {
    TileHeader header{};
    for (std::uint32_t* number :
         {&header.tile, &header.of, &header.blocks, &header.first, &header.last, &header.asked})
        *number = bytes.u32();
    if (header.last < header.first || header.last > header.blocks || header.blocks > kMostTiles)
        throw std::invalid_argument("it is of another part");
    return header;
}

// 2^-24 of a unit.
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

std::string why_not(std::size_t tile, const std::invalid_argument& why) {
    return "tile " + std::to_string(tile) + ": " + why.what();
}

// Without tiles a gap is a fault of ours.
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
    std::uint32_t blocks = 0;     // of its own
    std::vector<double> volumes;  // each time somebody asked, of each block; cubic units
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
    double subtract(const Cell&) override {
        throw CannotAnswer("of tiles", "how much a cell takes away");
    }
    void subtract_unmeasured(std::span<const Cell>) override {}
    // They were made already.
    std::optional<Box> wanted() const override { return Box{}; }
    Account account() const override { throw CannotAnswer("of tiles", "what cells took away"); }
    void render(FacetCanvas&) const override { throw CannotAnswer("of tiles", "its cells"); }
    std::unique_ptr<WorkpieceModel> clone() const override {
        return std::make_unique<Model>(*this);
    }

    // Block by block, in their order: the same sum as without tiles.
    double volume() const override {
        if (asked_ == tiles_->volumes_)
            throw std::logic_error("tiles were not asked that often for their volume");
        double sum = 0.0;
        for (const Tile& tile : tiles_->tiles_) {
            for (std::uint32_t block = 0; block < tile.blocks; ++block)
                sum += tile.volumes[asked_ * tile.blocks + block];
        }
        ++asked_;
        return sum * lattice_.cubic_unit_mm3();
    }
    Boundary boundary() const override {
        Stitcher stitcher(lattice_, tiles_->threads_);
        make_in_parallel(
            tiles_->threads_, tiles_->size(),
            [&](std::size_t tile) { return tiles_->outlines_of(tile); },
            [&](std::size_t, const std::vector<Outlines>& blocks) {
                for (const Outlines& block : blocks)
                    stitcher.take(block);
            });
        return fitting([&] { return stitcher.finish(); });
    }
    bool contains(Vec3) const override {
        throw CannotAnswer("of tiles", "whether points are in it");
    }

private:
    std::shared_ptr<const Tiles> tiles_;
    Lattice lattice_;
    mutable std::size_t asked_ = 0;
};

Tiles::Tiles(std::size_t count, Read read, std::size_t threads)
    : read_(std::move(read)), threads_(threads) {
    std::optional<TileHeader> first;
    std::uint32_t blocks = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string all = read_(i);
        try {
            TileBytes bytes(all);
            const TileHeader header = header_of(bytes);
            if (header.tile != i || header.of != count)
                throw std::invalid_argument("it is another one, or there are more of them");
            if (!first) first = header;
            if (header.blocks != first->blocks || header.asked != first->asked ||
                header.first != blocks)
                throw std::invalid_argument("it is of another part");
            if (header.asked > kMostAsked) throw std::invalid_argument("it was asked too often");
            Tile tile;
            tile.blocks = header.last - header.first;
            blocks = header.last;
            for (std::uint64_t k = 0; k < std::uint64_t{header.asked} * tile.blocks; ++k)
                tile.volumes.push_back(bytes.number());
            for (std::uint32_t b = 0; b < tile.blocks; ++b)
                (void)bytes.outlines_as_bytes();
            tile.border = bytes.outlines();
            tile.bounds = FixedBox(tile.border);
            if (!bytes.is_at_end()) throw std::invalid_argument("there is more in it");
            tiles_.push_back(std::move(tile));
        } catch (const std::invalid_argument& e) {
            throw std::invalid_argument(why_not(i, e));
        }
    }
    if (!first || blocks != first->blocks)
        throw std::invalid_argument("not all blocks of the part are there");
    volumes_ = first->asked;
}

Tiles::Tiles(std::vector<std::string> tiles)
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
        if (header.tile != tile || header.last - header.first != tiles_[tile].blocks ||
            header.asked != volumes_)
            throw std::invalid_argument("it is not what it was");
        for (std::size_t k = 0; k < tiles_[tile].volumes.size(); ++k)
            (void)bytes.number();
        std::vector<Outlines> blocks;
        for (std::uint32_t b = 0; b < tiles_[tile].blocks; ++b)
            blocks.push_back(bytes.outlines());
        return blocks;
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(why_not(tile, e));
    }
}

Boundary Tiles::surface(std::size_t tile, const Lattice& lattice) const {
    Stitcher stitcher(lattice, 1);
    for (const Outlines& block : outlines_of(tile))
        stitcher.take(block);
    for (std::size_t other = 0; other < size(); ++other) {
        if (other != tile && tiles_[other].bounds.touches(tiles_[tile].bounds))
            stitcher.take_outside(tiles_[other].border);
    }
    return fitting([&] { return stitcher.finish_open(); });
}

std::unique_ptr<WorkpieceModel> Tiles::model(std::shared_ptr<const Tiles> tiles) {
    return std::make_unique<Model>(std::move(tiles));
}

}  // namespace ncsim::cda
