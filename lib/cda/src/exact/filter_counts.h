// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often doubles answer a question of the kernel, and how often integers have to: counted in
// builds with NCSIM_COUNT_FILTERS (cmake -DNCSIM_COUNT_FILTERS=ON) alone, printed by engine_table.
// In all others there is nothing of it.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace ncsim::cda {

/// What is asked.
enum class Filter : std::uint8_t {
    Point,       ///< classify(): an exact point and a plane.
    Glance,      ///< FilteredPolygon::look(): a polygon and a plane; doubt is looked at once more.
    Corner,      ///< A corner of a FilteredPolygon, or an end of a segment, and a plane.
    Coordinate,  ///< compare_coordinate().
};
inline constexpr std::size_t kFilters = 4;

#ifdef NCSIM_COUNT_FILTERS
struct FilterCount {
    std::atomic<std::uint64_t> asked{0};
    std::atomic<std::uint64_t> doubtful{0};  ///< Of those asked: doubles could not tell.
    std::atomic<std::uint64_t> touching{0};  ///< Of those doubtful: On, which no double can tell.
};
inline std::array<FilterCount, kFilters> filter_counts;

inline void count_asked(Filter filter, std::uint64_t n = 1) {
    filter_counts[static_cast<std::size_t>(filter)].asked += n;
}
inline void count_doubtful(Filter filter, std::uint64_t n = 1) {
    filter_counts[static_cast<std::size_t>(filter)].doubtful += n;
}
inline void count_touching(Filter filter, std::uint64_t n = 1) {
    filter_counts[static_cast<std::size_t>(filter)].touching += n;
}
#else
inline void count_asked(Filter /*filter*/, std::uint64_t /*n*/ = 1) {}
inline void count_doubtful(Filter /*filter*/, std::uint64_t /*n*/ = 1) {}
inline void count_touching(Filter /*filter*/, std::uint64_t /*n*/ = 1) {}
#endif

}  // namespace ncsim::cda
