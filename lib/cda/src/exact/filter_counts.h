// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts of decisions by doubles and by integers, only in builds with NCSIM_COUNT_FILTERS (cmake
// -DNCSIM_COUNT_FILTERS=ON); printed by engine_table. Empty functions in all other builds.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace ncsim::cda {

/// Kinds of decisions.
enum class Filter : std::uint8_t {
    Point,  ///< classify(): an exact point and a plane.
    /// FilteredPolygon::look(): a polygon and a plane; undecided pairs are classified again.
    FilterResult,
    Corner,      ///< A corner of a FilteredPolygon, or an end of a segment, and a plane.
    Coordinate,  ///< compare_coordinate().
};
inline constexpr std::size_t kFilters = 4;

#ifdef NCSIM_COUNT_FILTERS
struct FilterCount {
    std::atomic<std::uint64_t> queries{0};
    std::atomic<std::uint64_t> doubtful{0};  ///< Number of decisions that doubles left undecided.
    /// Number of undecided cases with the result On, which doubles can never prove.
    std::atomic<std::uint64_t> touching{0};
};
inline std::array<FilterCount, kFilters> filter_counts;

inline void count_query(Filter filter, std::uint64_t n = 1) {
    filter_counts[static_cast<std::size_t>(filter)].queries += n;
}
inline void count_doubtful(Filter filter, std::uint64_t n = 1) {
    filter_counts[static_cast<std::size_t>(filter)].doubtful += n;
}
inline void count_touching(Filter filter, std::uint64_t n = 1) {
    filter_counts[static_cast<std::size_t>(filter)].touching += n;
}
#else
inline void count_query(Filter /*filter*/, std::uint64_t /*n*/ = 1) {}
inline void count_doubtful(Filter /*filter*/, std::uint64_t /*n*/ = 1) {}
inline void count_touching(Filter /*filter*/, std::uint64_t /*n*/ = 1) {}
#endif

}  // namespace ncsim::cda
