// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of the control words and line numbers of a file. Built at the first jump; programs
// without jumps need no index.
#pragma once

#include "ncsim/gcode/parser.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// A block with a control word.
struct Marker {
    ControlWord word = ControlWord::None;
    std::string label;  ///< "100" without leading zeros, or a name.
    std::uint32_t line = 0;
    BlockReader::Place at;     ///< Position of the line.
    BlockReader::Place after;  ///< Position of the next line.
};

/// Index of the control words and line numbers of a file.
class ProgramIndex {
public:
    explicit ProgramIndex(const SourceFile& file);

    const std::vector<Marker>& markers() const { return markers_; }
    const Marker& operator[](std::size_t i) const { return markers_[i]; }

    /// Returns the index of the marker in line `line`; nullopt if the line has no marker.
    std::optional<std::size_t> at_line(std::uint32_t line) const;
    /// Returns the index of the first marker after (previous: before) `i` with the label `label`
    /// and a word of `words`; nullopt: none.
    template <typename... Words>
    std::optional<std::size_t> next(std::size_t i, std::string_view label, Words... words) const {
        while (++i < markers_.size()) {
            if (is(i, label, words...)) return i;
        }
        return std::nullopt;
    }
    template <typename... Words>
    std::optional<std::size_t> previous(std::size_t i, std::string_view label,
                                        Words... words) const {
        while (i-- > 0) {
            if (is(i, label, words...)) return i;
        }
        return std::nullopt;
    }
    /// True if no O number is between the lines `a` and `b`, or in the later line.
    bool are_in_one_program(std::uint32_t a, std::uint32_t b) const {
        return std::ranges::upper_bound(heads_, a) == std::ranges::upper_bound(heads_, b);
    }
    /// Returns the index of the first marker of the file with `word` and `label`; nullopt: none.
    std::optional<std::size_t> find(ControlWord word, std::string_view label) const;

    /// Returns the position of the line N`number` of the program that contains line `line`: the
    /// first match from `line` on, otherwise the first match in this program; nullopt: none. A
    /// program begins at an O number and ends at the next O number.
    std::optional<BlockReader::Place> find_number(std::uint32_t number, std::uint32_t line) const;

private:
    template <typename... Words>
    bool is(std::size_t i, std::string_view label, Words... words) const {
        return ((markers_[i].word == words) || ...) && markers_[i].label == label;
    }
    struct Number {
        std::uint32_t number, line;
        BlockReader::Place at;
    };
    std::vector<Marker> markers_;
    std::vector<Number> numbers_;       // Sorted by number, then by line.
    std::vector<std::uint32_t> heads_;  // Lines of O numbers, in ascending order.
};

/// Returns `letter` followed by `number`: "N" and "10" give "N10".
inline std::string join_label(std::string_view letter, std::string_view number) {
    return std::string(letter).append(number);
}

/// Converts "0100" to "100" and "<name>" to "name".
/// Requires: `label` needs no evaluation.
std::string plain_label(std::string_view label);

}  // namespace ncsim::gcode
