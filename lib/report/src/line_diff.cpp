// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds equal lines of two texts with the greedy algorithm of Myers. Lines that only one text has
// are left out first: they are never equal, and most lines of a renumbered program are such lines.
#include "line_diff.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace ncsim::report {

namespace {

// Edits after which the search takes the path that is furthest, and continues from its end.
constexpr std::ptrdiff_t kMostEdits = 1000;
constexpr std::ptrdiff_t kNone = -1;

using LineClass = std::uint32_t;  // Equal lines have equal classes.
using Match = std::pair<std::size_t, std::size_t>;

// A text without the lines that only one text has: numbers, and places in the whole text.
struct SharedLines {
    std::vector<LineClass> numbers;
    std::vector<std::size_t> places;
};

std::pair<SharedLines, SharedLines> shared_lines(std::span<const std::string_view> a,
                                                 std::span<const std::string_view> b) {
    struct Known {
        LineClass number = 0;
        bool in_a = false, in_b = false;
    };
    std::unordered_map<std::string_view, Known> known;
    for (const std::string_view line : a)
        known.try_emplace(line, Known{static_cast<LineClass>(known.size())}).first->second.in_a =
            true;
    for (const std::string_view line : b)
        known.try_emplace(line, Known{static_cast<LineClass>(known.size())}).first->second.in_b =
            true;
    const auto shared = [&](std::span<const std::string_view> lines) {
        SharedLines result;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Known& line = known.at(lines[i]);
            if (!line.in_a || !line.in_b) continue;
            result.numbers.push_back(line.number);
            result.places.push_back(i);
        }
        return result;
    };
    return {shared(a), shared(b)};
}

// Search from the start of two sequences. Diagonal k has the places (x, y) with x - y = k.
class Search {
public:
    Search(std::span<const LineClass> a, std::span<const LineClass> b)
        : a_(a),
          b_(b),
          n_(static_cast<std::ptrdiff_t>(a.size())),
          m_(static_cast<std::ptrdiff_t>(b.size())) {}

    // Returns the matches of the path to the end, or of the furthest path with kMostEdits edits,
    // backwards; then the end of the path.
    std::pair<std::vector<Match>, Match> run() {
        std::ptrdiff_t last = 0;
        bool is_whole = false;
        for (std::ptrdiff_t d = 0; d <= kMostEdits && !is_whole; ++d) {
            reach_.emplace_back(static_cast<std::size_t>(2 * d + 1), kNone);
            for (std::ptrdiff_t k = -d; k <= d && !is_whole; k += 2) {
                std::ptrdiff_t x = d == 0 ? 0 : start(d, k);
                if (x == kNone) continue;
                while (x < n_ && x - k < m_ && number(a_, x) == number(b_, x - k))
                    ++x;
                at(d, k) = x;
                is_whole = x == n_ && x - k == m_;
                if (is_whole) last = k;
            }
        }
        if (!is_whole) last = furthest();
        return path_to(last);
    }

private:
    static LineClass number(std::span<const LineClass> numbers, std::ptrdiff_t i) {
        return numbers[static_cast<std::size_t>(i)];
    }
    std::ptrdiff_t& at(std::ptrdiff_t d, std::ptrdiff_t k) {
        return reach_[static_cast<std::size_t>(d)][static_cast<std::size_t>(k + d)];
    }
    std::ptrdiff_t reached(std::ptrdiff_t d, std::ptrdiff_t k) {
        return std::abs(k) <= d ? at(d, k) : kNone;
    }

    // Returns x after d - 1 edits and a further edit that leads to diagonal k; kNone if no edit
    // does.
    std::ptrdiff_t start(std::ptrdiff_t d, std::ptrdiff_t k) {
        const std::ptrdiff_t left = reached(d - 1, k - 1), above = reached(d - 1, k + 1);
        const std::ptrdiff_t right = left == kNone || left == n_ ? kNone : left + 1;
        const std::ptrdiff_t down = above == kNone || above - k > m_ ? kNone : above;
        return std::max(right, down);
    }

    // Returns the diagonal of the furthest place after the last edit.
    std::ptrdiff_t furthest() {
        const auto d = static_cast<std::ptrdiff_t>(reach_.size()) - 1;
        std::ptrdiff_t best = -d;
        const auto length = [&](std::ptrdiff_t k) {
            return at(d, k) == kNone ? kNone : 2 * at(d, k) - k;
        };
        for (std::ptrdiff_t k = -d; k <= d; k += 2) {
            if (length(k) > length(best)) best = k;
        }
        return best;
    }

    std::pair<std::vector<Match>, Match> path_to(std::ptrdiff_t k) {
        std::vector<Match> matches;
        auto d = static_cast<std::ptrdiff_t>(reach_.size()) - 1;
        const Match end{static_cast<std::size_t>(at(d, k)), static_cast<std::size_t>(at(d, k) - k)};
        for (; d >= 0; --d) {
            const std::ptrdiff_t first = d == 0 ? 0 : start(d, k);
            for (std::ptrdiff_t x = at(d, k) - 1; x >= first; --x)
                matches.emplace_back(static_cast<std::size_t>(x), static_cast<std::size_t>(x - k));
            if (d == 0) break;
            const std::ptrdiff_t left = reached(d - 1, k - 1);
            k += left != kNone && left < n_ && left + 1 == first ? -1 : 1;
        }
        return {std::move(matches), end};
    }

    std::span<const LineClass> a_, b_;
    std::ptrdiff_t n_, m_;
    // By number of edits and diagonal: the largest x; kNone: the diagonal is not reached.
    std::vector<std::vector<std::ptrdiff_t>> reach_;
};

// Returns the places of equal lines, in order.
std::vector<Match> matches_of(const SharedLines& a, const SharedLines& b) {
    std::vector<Match> all;
    std::size_t x = 0, y = 0;
    while (x < a.numbers.size() && y < b.numbers.size()) {
        const auto [matches, end] =
            Search(std::span(a.numbers).subspan(x), std::span(b.numbers).subspan(y)).run();
        for (auto match = matches.rbegin(); match != matches.rend(); ++match)
            all.emplace_back(a.places[x + match->first], b.places[y + match->second]);
        x += end.first;
        y += end.second;
    }
    return all;
}

}  // namespace

std::vector<LineStretch> compare_lines(std::span<const std::string_view> old_lines,
                                       std::span<const std::string_view> new_lines) {
    const auto [a, b] = shared_lines(old_lines, new_lines);
    std::vector<Match> matches = matches_of(a, b);
    matches.emplace_back(old_lines.size(), new_lines.size());
    std::vector<LineStretch> stretches;
    std::size_t x = 0, y = 0;
    for (const auto& [to_x, to_y] : matches) {
        if (x < to_x || y < to_y) stretches.push_back({false, x, to_x - x, y, to_y - y});
        x = to_x + 1;
        y = to_y + 1;
        if (to_x == old_lines.size()) break;
        if (!stretches.empty() && stretches.back().equal) {
            ++stretches.back().old_count;
            ++stretches.back().new_count;
        } else {
            stretches.push_back({true, to_x, 1, to_y, 1});
        }
    }
    return stretches;
}

}  // namespace ncsim::report
