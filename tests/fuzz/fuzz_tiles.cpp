// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads any bytes, with a digest that fits, as the file of a tile. Reading must end, and a file
// that is no tile must be refused. A tile has a volume, and a closed surface or none. Its evidence
// is read back as written.
#include "ncsim/cda/check.h"
#include "ncsim/cda/tiles.h"
#include "ncsim/report/tile_file.h"
#include "ncsim/verify/evidence.h"

#include "support/scene.h"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

// Returns a constant digest, because a fuzzer cannot guess SHA-256.
std::string no_digest(std::string_view) {
    return std::string(64, '0');
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ncsim;
    std::string bytes(reinterpret_cast<const char*>(data), size);
    bytes += '\n' + no_digest({}) + '\n';
    std::vector<std::string> tiles;
    try {
        report::TileFile file = report::tile_file_from(bytes, "fuzz", no_digest);
        // A file that is read must be written with the same content.
        const report::TileFile again =
            report::tile_file_from(report::bytes_of(file, no_digest), "again", no_digest);
        if (again.head != file.head || again.stock_contacts != file.stock_contacts ||
            again.tile != file.tile || again.evidence != file.evidence)
            std::abort();
        try {
            const verify::Evidence seen = verify::evidence_from(file.evidence);
            if (verify::evidence_from(verify::bytes_of(seen)) != seen) std::abort();
            if (verify::together({seen, {}}).size() > seen.size()) std::abort();
        } catch (const std::invalid_argument&) {
            // The bytes are no evidence.
        }
        tiles.push_back(std::move(file.tile));
    } catch (const std::runtime_error&) {
        return 0;
    }
    std::shared_ptr<const cda::Tiles> all;
    std::unique_ptr<cda::WorkpieceModel> part;
    try {
        all = std::make_shared<const cda::Tiles>(std::move(tiles));
        part = cda::Tiles::model(all)->create(
            cda::box_cell({-3000, -3000, -3000}, {3000, 3000, 3000}, test::kLattice),
            test::kLattice);
    } catch (const std::invalid_argument&) {
        return 0;
    }
    try {
        (void)part->volume();
    } catch (const std::logic_error&) {
        // The tile has no answer to this query.
    }
    try {
        if (!cda::is_closed(part->boundary())) std::abort();
    } catch (const std::runtime_error&) {
        // The tile's pieces have no closed surface.
    }
    try {
        (void)all->surface(0, test::kLattice);
    } catch (const std::runtime_error&) {
        // The tile's pieces have no surface.
    }
    return 0;
}
