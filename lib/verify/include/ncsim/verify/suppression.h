// SPDX-License-Identifier: GPL-3.0-or-later
//
// Suppressions: findings that the programmer accepts in a comment, "(ncsim: ignore
// rapid-in-material)".
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// Suppressions of a program, by line.
class Suppressions {
public:
    /// Word after "ignore" that names no rule. Without a name: a comment that requests something
    /// but is not understood, such as "(ncsim: ignores …)", "(ncsim ignore …)", "(ncsim: ignore)".
    struct Unknown {
        std::string name;
        gcode::SourceSpan span;
    };

    Suppressions() = default;
    /// Reads the comments of `program`. A comment in a line with words applies to that block; a
    /// comment in a line of its own applies to the next line with words. Commas or blanks separate
    /// several rules; a category or "all" stands for all of its rules. Blanks around the colon and
    /// letter case do not matter.
    /// Guarantees: accepts every text.
    /// Cost: O(size of the program).
    explicit Suppressions(const gcode::SourceFile& program);

    bool covers(std::uint32_t line, std::string_view rule) const;
    const std::vector<Unknown>& unknown() const { return unknown_; }

private:
    std::map<std::uint32_t, std::set<std::string, std::less<>>> lines_;
    std::vector<Unknown> unknown_;
};

}  // namespace ncsim::verify
