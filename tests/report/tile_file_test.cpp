// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/report/tile_file.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace ncsim::report {
namespace {

std::string any_digest(std::string_view) {
    return std::string(64, 'a');
}

TEST(TileFile, ComesBack) {
    TileFile file;
    file.head = {{"run", "--", "a\xff.nc"}, {{"a\xff.nc", "x"}, {"b", std::nullopt}}, 3, 64};
    file.head.knows_all_files = false;
    file.stock_contacts = {{1, 2}, {77, 1}};
    file.evidence = "1 2\n3\n";
    file.tile = std::string("\n\0 tile", 7);
    const TileFile again = tile_file_from(bytes_of(file, any_digest), "a", any_digest);
    EXPECT_EQ(again.head, file.head);
    EXPECT_EQ(again.stock_contacts, file.stock_contacts);
    EXPECT_EQ(again.evidence, file.evidence);
    EXPECT_EQ(again.tile, file.tile);
    EXPECT_EQ(again.digest, any_digest({}));
}

// Found by the fuzzer: a number of 126 digits is not a valid number of a tile.
TEST(TileFile, HasWholeNumbers) {
    const std::string bytes = bytes_of({{{"run"}, {}, 0, 1}, {}, {}, {}, {}}, any_digest);
    const auto refused = [&](const std::string& from, const std::string& to) {
        std::string changed = bytes;
        const std::size_t at = changed.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        changed.replace(at, from.size(), to);
        EXPECT_THROW(tile_file_from(changed, "a", any_digest), std::runtime_error) << to;
    };
    EXPECT_NO_THROW(tile_file_from(bytes, "a", any_digest));
    for (const char* number : {"1e126", "-1", "4294967296", "1.5", "null"}) {
        refused("\"tile\":0", std::string("\"tile\":") + number);
        refused("\"of\":1", std::string("\"of\":") + number);
        refused("\"ncsim-tile\":3", std::string("\"ncsim-tile\":") + number);
    }
    refused("\"run\"", "[1e126]");
}

}  // namespace
}  // namespace ncsim::report
