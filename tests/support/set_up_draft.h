// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draft of a seeded set-up before the files are written: lines, tools, fixtures, travels, and the
// faults that can be inserted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::test::set_ups {

// Length in steps of the program: 1 µm, or 0.0001 inch.
using Length = std::int64_t;
enum Axis : std::size_t { X, Y, Z };
inline constexpr std::array<char, 3> kLetters{'X', 'Y', 'Z'};

/// Returns `value` / 10^`places` with a decimal point and without trailing zeros.
std::string decimal(std::int64_t value, int places);

struct Fixture {
    const char* name;
    std::array<Length, 3> min, max;
};

struct Tool {
    std::string kind;
    Length diameter = 0, flutes = 0, corner = 0, neck = 0, neck_length = 0, shank = 0;
    Length stick_out = 0, holder = 0;
    Length blind = 0;        // diameter of the core that does not cut
    Length longer_than = 0;  // lower bound of the flute length,
                             // independent of the cuts
    // deepest: depth below the top; highest_cut: largest depth of a single pass
    Length deepest = 0, highest_cut = 0;
    std::vector<std::pair<std::size_t, Length>> heights;  // line, height of the material that the
                                                          // tool cuts sideways
    std::size_t first_cut = 0, change = 0, spindle = 0, length = 0;  // lines
    bool specified = true;
    bool slopes = false;
    bool has_cut = false;  // true if the tool cuts; first_cut is 0 if the first cut is in a loop
};

// Set-up from which files and options are written.
struct Draft {
    std::vector<std::string> lines;
    std::vector<Tool> tools;
    std::array<Length, 3> travel_min{}, travel_max{}, zero{}, start{};
    bool start_specified = true;
    std::vector<Fixture> fixtures;
    Length below_stock = 0;
    std::array<Length, 3> stock_min{}, stock_max{};
    bool inches = false;

    // Returns line `number`, counted from 1.
    std::string& line(std::size_t number) { return lines.at(number - 1); }
    void insert_before(std::size_t number, const std::string& text) {
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(number) - 1, text);
    }
    void replace(std::size_t number, std::string_view old, const std::string& text) {
        std::string& there = line(number);
        const std::size_t at = there.find(old);
        if (at == std::string::npos)
            throw std::logic_error("no " + std::string(old) + " in " + there);
        there.replace(at, old.size(), text);
    }
    // Replaces a line by a comment, so the numbers of all lines stay the same.
    void drop(std::size_t number) { line(number) = "(dropped)"; }
};

struct Fault {
    std::string name, verdict, tells;
    std::set<std::string> may_tell;
    /// Inserts the fault. Returns the line in which the fault shows; 0: not known.
    std::function<std::size_t(Draft&)> put_in;
};

// Findings that may follow if a tool is in a wrong place.
inline const std::set<std::string> kCollisions{"rapid-in-material",   "fixture-contact",
                                               "non-cutting-contact", "below-stock",
                                               "over-travel",         "drill-depth"};

}  // namespace ncsim::test::set_ups
