// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long list of programs, verified in parts (shards) by whoever has time, and put together again.
// A file holds what one shard found: a head, a line a program, an end; so a file that was cut off
// is known as such.
#pragma once

#include "ncsim/report/entry.h"
#include "ncsim/report/scope.h"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace ncsim::report {

/// What all shards of one list have in common, but for `shard`.
struct ShardHead {
    std::string list;     ///< Digest of the list.
    std::string options;  ///< Digest of what was asked.
    std::uint32_t shard = 0, of = 1;
    std::uint64_t programs = 0;  ///< In the list.
    bool operator==(const ShardHead&) const = default;
};

/// An entry and its place in the list.
struct Placed {
    std::uint64_t index = 0;
    Entry entry;
};

/// "shard-0003-of-0200.ndjson": names sort as numbers do.
std::string shard_file_name(std::uint32_t shard, std::uint32_t of);

/// `entries` in the order of the list; `left_out`: the rest of the list.
void write_shard(std::ostream& out, const ShardHead& head, const std::vector<LeftOut>& left_out,
                 std::span<const Placed> entries);

/// Is the file the whole result of this shard of this list?
bool is_whole(const std::string& file, const ShardHead& head);

/// Which of `sizes.size()` programs shard `shard` of `of` takes, ascending: the largest first to
/// whom has the least so far, so that all have about as much, and all of them know it without
/// asking the others.
std::vector<std::size_t> dealt(std::span<const std::uint64_t> sizes, std::uint32_t shard,
                               std::uint32_t of);

/// All shards of a list.
class Shards {
public:
    /// Reads the heads and where each program is. Throws std::runtime_error, naming the file, if
    /// one cannot be read, is cut off or no such file, is of another list, other options or another
    /// version than the first, if a program is told twice and not the same, or one not at all.
    explicit Shards(const std::vector<std::string>& files);

    std::uint64_t programs() const { return places_.size(); }
    std::size_t files() const { return files_.size(); }
    /// Files that any of the shards left out.
    const std::vector<LeftOut>& left_out() const { return left_out_; }
    /// In the order of the list, one at a time. Throws as the constructor does.
    Entries entries() const;

private:
    struct Place {
        std::uint32_t file = 0;
        std::uint64_t offset = kNowhere;
    };
    static constexpr std::uint64_t kNowhere = ~std::uint64_t{0};

    void take(std::uint32_t file);
    std::string line_at(const Place& place) const;

    std::vector<std::string> files_;
    std::vector<Place> places_;
    ShardHead head_;
    std::vector<LeftOut> left_out_;
};

}  // namespace ncsim::report
