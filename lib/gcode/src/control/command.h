// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block with all values evaluated: the input of Machine.
#pragma once

#include "ncsim/gcode/block.h"

#include "control/codes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <vector>

namespace ncsim::gcode {

constexpr int kNone = -1;  ///< No M code.

/// Returns the index of `letter`: A … Z are 0 … 25, '@' is 26, '^' is 27.
constexpr std::size_t letter_index(char letter) {
    return letter == '@' ? 26U : letter == '^' ? 27U : static_cast<std::size_t>(letter - 'A');
}

/// The words of a block, sorted by letter and group.
struct Command {
    const Block* block = nullptr;
    SourceSpan span;            ///< Main word: the motion code, or the first word.
    std::uint32_t present = 0;  ///< A bit per letter.
    std::array<double, 28> value;
    std::array<Code, kGroups> g;           ///< Code of each group.
    std::array<std::int16_t, kMGroups> m;  ///< M code of each group, or kNone.
    double next_tool = -1.0;  ///< Second T of "T1 T2 M6": the tool to prepare in the magazine.
    /// 'R' or 'C' of ",R2", ",C2": corner at the end of the line; 'L': a chamfer by its length.
    char corner = 0;
    double corner_size = 0.0;
    bool corner_is_modal = false;       ///< Without an error if the next block has no corner.
    std::optional<double> corner_feed;  ///< Feed of the corner only.
    SourceSpan corner_span;
    bool has_angle = false;  ///< ",A30": direction of the line.
    double angle = 0.0;      ///< Degrees, from the first axis of the plane to the second.
    SourceSpan angle_span;
    std::vector<int> clamps;      ///< M codes of MGroup::Clamp, in the order of the text.
    bool mist_and_flood = false;  ///< M7 and M8 in one block.
    bool has_m = false;           ///< The block has an M word, known or unknown.
    /// The block has a G code that is ignored, unknown, or declared harmless.
    bool has_others = false;
    bool axis_words = false;  ///< The block has X … W, @, ^ or ,A.

    bool has(char letter) const { return (present >> letter_index(letter) & 1U) != 0; }
    double operator[](char letter) const { return value[letter_index(letter)]; }
    double get(char letter, double otherwise) const {
        return has(letter) ? value[letter_index(letter)] : otherwise;
    }
    Code group(Group group) const { return g[static_cast<std::size_t>(group)]; }
    int group(MGroup group) const { return m[static_cast<std::size_t>(group)]; }
    /// True if a code of the block uses the axis words.
    bool axes_are_taken() const {
        return std::ranges::any_of(
            g, [](Code code) { return code != Code::None && entry_of(code).takes_axes; });
    }
    bool has_any(std::uint32_t letters) const { return (present & letters) != 0; }
};

template <typename... Letters>
constexpr std::uint32_t letters(Letters... letter) {
    return ((1U << letter_index(letter)) | ... | 0U);
}
constexpr std::uint32_t kAxisLetters =
    letters('X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W', '@', '^');

}  // namespace ncsim::gcode
