// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of the system variables of RS274/NGC, Fanuc and Haas.
#include "control/system_variable.h"

#include <algorithm>
#include <array>
#include <optional>

namespace ncsim::gcode {
namespace {

using Effect = SystemVariable::Effect;

constexpr bool is_within(int n, int first, int count) {
    return n >= first && n < first + count;
}

/// Groups of `count` numbers; the first `items` of a group have a meaning.
struct Range {
    int first, count, items, index;
    Effect effect;
};

constexpr int kSystems = 9;
constexpr int kAxisCount = 9;

SystemVariable rs274_variable(int n) {
    constexpr Range kRanges[] = {
        {5061, 9, 9, 0, Effect::Probed},
        {5161, 9, 9, 0, Effect::Home},
        {5181, 9, 9, 1, Effect::Home},
        {5211, 9, 9, 0, Effect::Stored92},
    };
    for (const Range& range : kRanges) {
        if (is_within(n, range.first, range.items))
            return {range.effect, n, range.index, static_cast<std::size_t>(n - range.first)};
    }
    if (n == 5210 || n == 5220) return {Effect::NotApplied, n};
    if (is_within(n, 5221, 20 * kSystems)) {
        const int item = (n - 5221) % 20;
        if (item > kAxisCount) return {};
        return {Effect::WorkOffset, n, (n - 5221) / 20 + 1, static_cast<std::size_t>(item)};
    }
    return {};
}

/// Returns the offset of G54 … G59 or G54.1 Pn that #`n` is; nullopt if #`n` is no offset. Axes 1
/// to 4 are X, Y, Z, A.
std::optional<SystemVariable> work_offset_of_fanuc(int n, bool haas) {
    constexpr int kExtended = 9;
    struct Systems {
        int first, count, index;
    };
    const std::array<Systems, 3> systems{
        {{5221, 6, 1}, {7001, 48, kExtended + 1}, {14001, haas ? 99 : 300, kExtended + 1}}};
    for (const Systems& s : systems) {
        if (!is_within(n, s.first, 20 * s.count)) continue;
        const int item = (n - s.first) % 20;
        if (item >= kAxisCount) return SystemVariable{Effect::NotApplied, n};
        return SystemVariable{Effect::WorkOffset, n, s.index + (n - s.first) / 20,
                              static_cast<std::size_t>(item)};
    }
    return std::nullopt;
}

/// Returns the tool offset that #`n` is. Haas has one memory of offsets. Fanuc has several kinds of
/// memory, and the program does not show which kind the control has.
SystemVariable tool_offset_of_fanuc(int n, bool haas) {
    constexpr std::array kHaas{Effect::Length, Effect::LengthWear, Effect::Diameter,
                               Effect::DiameterWear};
    const int from = n - 2001;
    if (!haas) return {Effect::NotApplied, n};
    return {kHaas[static_cast<std::size_t>(from / 200)], n, from % 200 + 1};
}

SystemVariable fanuc_variable(int n, bool haas) {
    if (n < 1000) return {};
    if (is_within(n, 2001, 800)) return tool_offset_of_fanuc(n, haas);
    if (n == 3000) return {Effect::Alarm, n};
    if (n == 3006) return {Effect::Stop, n};
    // Clocks, single block and feed hold, counters of parts.
    constexpr std::array kHarmless{3001, 3002, 3003, 3004, 3901, 3902};
    if (std::ranges::find(kHarmless, n) != kHarmless.end()) return {};
    if (is_within(n, 5201, kAxisCount))
        return {Effect::External, n, 0, static_cast<std::size_t>(n - 5201)};
    if (const auto offset = work_offset_of_fanuc(n, haas)) return *offset;
    // Variables of the user on Haas.
    if (haas && is_within(n, 10'000, 1000)) return {};
    return {Effect::NotApplied, n};
}

}  // namespace

SystemVariable system_variable(int number, const Rules& rules) {
    if (!rules.macro_b) return rs274_variable(number);
    return fanuc_variable(number, rules.dialect == Dialect::Haas);
}

}  // namespace ncsim::gcode
