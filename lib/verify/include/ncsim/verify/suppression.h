// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings that the programmer has looked at and accepts: "(ncsim: ignore rapid-in-material)".
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

class Suppressions {
public:
    /// A word after "ignore" that names no rule; without a name, a comment that asks for something
    /// but cannot be understood: "(ncsim: ignores …)", "(ncsim ignore …)", "(ncsim: ignore)".
    struct Unknown {
        std::string name;
        gcode::SourceSpan span;
    };

    Suppressions() = default;
    /// Reads the comments of `program`. A comment in a line with words is about that block, one in
    /// a line of its own about the next line with words; several rules are separated by commas or
    /// blanks; a category or "all" stands for all its rules. Blanks about the colon and the case of
    /// letters do not matter. Total; O(size of the program).
    explicit Suppressions(const gcode::SourceFile& program);

    bool covers(std::uint32_t line, std::string_view rule) const;
    const std::vector<Unknown>& unknown() const { return unknown_; }

private:
    std::map<std::uint32_t, std::set<std::string, std::less<>>> lines_;
    std::vector<Unknown> unknown_;
};

}  // namespace ncsim::verify
