// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the control words and line numbers of a file stand. Built when the first jump needs it;
// plain programs never pay for it.
#pragma once

#include "ncsim/gcode/parser.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

struct Marker {
    ControlWord word = ControlWord::None;
    std::string label;  ///< "100" without leading zeros, or the name.
    std::uint32_t line = 0;
    BlockReader::Place at;     ///< Of the line itself.
    BlockReader::Place after;  ///< Of the next one.
};

class ProgramIndex {
public:
    explicit ProgramIndex(const SourceFile& file);

    const std::vector<Marker>& markers() const { return markers_; }
    const Marker& operator[](std::size_t i) const { return markers_[i]; }

    /// The marker of a line that has one.
    std::optional<std::size_t> at_line(std::uint32_t line) const;
    /// The first marker after (before) `i` with this label and one of these words.
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
    /// The first marker of the file with this label and word.
    std::optional<std::size_t> find(ControlWord word, std::string_view label) const;

    /// The line with this N: the first from `from` on, else the first of the file.
    std::optional<BlockReader::Place> find_number(std::uint32_t number, std::uint32_t from) const;

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
    std::vector<Number> numbers_;  // by number, then by line
};

/// "N" and "10" -> "N10".
inline std::string tagged(std::string_view letter, std::string_view number) {
    return std::string(letter).append(number);
}

/// "0100" -> "100", "<Name>" -> "name"; other labels have to be evaluated first.
std::string plain_label(std::string_view label);

}  // namespace ncsim::gcode
