// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verification of a long list of programs in parts (shards), and the combination of the results. A
// file holds the result of a shard: a head, a line for each program, and an end, which shows that
// the file is complete.
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

/// Data of a shard file. Except for `shard`, all shards of a list have the same values.
struct ShardHead {
    std::string list;     ///< Digest of the list.
    std::string options;  ///< Digest of the options.
    std::uint32_t shard = 0, of = 1;
    std::uint64_t programs = 0;  ///< Number of programs in the list.
    bool operator==(const ShardHead&) const = default;
};

/// An entry and its position in the list.
struct Placed {
    std::uint64_t index = 0;
    Entry entry;
};

/// Returns "shard-0003-of-0200.ndjson"; the names sort in the order of the numbers.
std::string shard_file_name(std::uint32_t shard, std::uint32_t of);

/// Writes `entries`, which are in the order of the list. `excluded` are the files of the list that
/// were left out.
void write_shard(std::ostream& out, const ShardHead& head,
                 const std::vector<ExcludedEntry>& excluded, std::span<const Placed> entries);

/// True if `file` is the complete result of the shard described by `head`.
bool is_whole(const std::string& file, const ShardHead& head);

/// Returns the indices of the programs of shard `shard` of `of`, ascending. `sizes` are the sizes
/// of all programs. The largest program goes first, to the shard with the smallest load so far. The
/// loads are similar, and every process computes the same distribution without communication.
std::vector<std::size_t> programs_of_shard(std::span<const std::uint64_t> sizes,
                                           std::uint32_t shard, std::uint32_t of);

/// All shards of a list.
class Shards {
public:
    /// Reads the heads and the position of each program.
    /// Throws: std::runtime_error with the name of the file if a file is unreadable, incomplete or
    ///     not a shard, if the list, the options or the version differ from those of the first
    ///     file, if two results of a program differ, or if a program has no result.
    explicit Shards(const std::vector<std::string>& files);

    std::uint64_t programs() const { return places_.size(); }
    std::size_t files() const { return files_.size(); }
    /// Returns the files that any of the shards left out.
    const std::vector<ExcludedEntry>& excluded() const { return excluded_; }
    /// Returns the entries in the order of the list, read one at a time.
    /// Throws: as the constructor.
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
    std::vector<ExcludedEntry> excluded_;
};

}  // namespace ncsim::report
