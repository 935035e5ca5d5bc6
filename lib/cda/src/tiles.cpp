// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/tiles.h"

#include "stitch.h"
#include "tile_bytes.h"

#include <optional>
#include <stdexcept>
#include <utility>

namespace ncsim::cda {

struct Tiles::Block {
    std::vector<double> volumes;  // each time somebody asked, cubic units
    std::string outlines;         // as bytes: a fraction of what they take otherwise
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

    double volume() const override {
        if (asked_ == tiles_->volumes_)
            throw std::logic_error("tiles were not asked that often for their volume");
        double sum = 0.0;
        for (const Block& block : tiles_->blocks_)
            sum += block.volumes[asked_];
        ++asked_;
        return sum * lattice_.cubic_unit_mm3();
    }
    Boundary boundary() const override {
        Stitcher stitcher(lattice_, 0);
        for (const Block& block : tiles_->blocks_)
            stitcher.take(TileBytes(block.outlines).outlines());
        return stitcher.finish();
    }
    bool contains(Vec3) const override {
        throw CannotAnswer("of tiles", "whether points are in it");
    }

private:
    std::shared_ptr<const Tiles> tiles_;
    Lattice lattice_;
    mutable std::size_t asked_ = 0;
};

Tiles::Tiles(std::vector<std::string> tiles) {
    std::optional<std::uint32_t> blocks, volumes;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        try {
            TileBytes bytes(tiles[i]);
            if (bytes.u32() != i || bytes.u32() != tiles.size())
                throw std::invalid_argument("it is another one, or there are more of them");
            const std::uint32_t all = bytes.u32(), first = bytes.u32(), last = bytes.u32();
            const std::uint32_t asked = bytes.u32();
            if (blocks.value_or(all) != all || volumes.value_or(asked) != asked ||
                first != blocks_.size() || last < first || last > all || all > kMostTiles)
                throw std::invalid_argument("it is of another part");
            blocks = all, volumes = asked;
            blocks_.resize(last);
            for (std::uint32_t k = 0; k < asked; ++k) {
                for (std::uint32_t b = first; b < last; ++b)
                    blocks_[b].volumes.push_back(bytes.number());
            }
            for (std::uint32_t b = first; b < last; ++b)
                blocks_[b].outlines = bytes.outlines_as_bytes();
            if (!bytes.is_at_end()) throw std::invalid_argument("there is more in it");
            tiles[i] = {};
        } catch (const std::invalid_argument& e) {
            throw std::invalid_argument("tile " + std::to_string(i) + ": " + e.what());
        }
    }
    if (!blocks || blocks_.size() != *blocks)
        throw std::invalid_argument("not all blocks of the part are there");
    volumes_ = *volumes;
}

Tiles::~Tiles() = default;

std::unique_ptr<WorkpieceModel> Tiles::model(std::shared_ptr<const Tiles> tiles) {
    return std::make_unique<Model>(std::move(tiles));
}

}  // namespace ncsim::cda
