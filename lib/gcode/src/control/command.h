// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block with all values evaluated: the input of Controller.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/motion.h"

#include "control/codes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

constexpr int kNone = -1;  ///< No M code.

/// Letters of Axes.
inline constexpr std::string_view kAxisNames = "XYZABCUVW";

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
    bool rigid_tapping = false;  ///< M29 of Fanuc.
    bool from_one_side = false;  ///< G60: positions from one direction.
    bool axis_words = false;     ///< The block has X … W, @, ^ or ,A.

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

/// Codes of the coordinate systems 1 … 9.
inline constexpr std::array kSystemCodes{Code::G54, Code::G55,   Code::G56,   Code::G57,  Code::G58,
                                         Code::G59, Code::G59_1, Code::G59_2, Code::G59_3};
/// Returns the code that selects `plane`.
constexpr Code code_of(Plane plane) {
    constexpr std::array kPlanes{Code::G17,   Code::G18,   Code::G19,
                                 Code::G17_1, Code::G18_1, Code::G19_1};
    return kPlanes[static_cast<std::size_t>(plane)];
}

/// Returns a command without words.
/// Requires: `block` outlives the command.
inline Command empty_command(const Block& block, SourceSpan span) {
    Command command{};
    command.block = &block;
    command.span = span;
    command.g.fill(Code::None);
    command.m.fill(kNone);
    return command;
}
inline void put(Command& command, char letter, double value) {
    command.present |= 1U << letter_index(letter);
    command.value[letter_index(letter)] = value;
}
inline void put(Command& command, Code code) {
    command.g[static_cast<std::size_t>(entry_of(code).group)] = code;
}
inline void put(Command& command, MGroup group, int m) {
    command.m[static_cast<std::size_t>(group)] = static_cast<std::int16_t>(m);
}

template <typename... Letters>
constexpr std::uint32_t letters(Letters... letter) {
    return ((1U << letter_index(letter)) | ... | 0U);
}
constexpr std::uint32_t kAxisLetters =
    letters('X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W', '@', '^');

}  // namespace ncsim::gcode
