// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that the user requires, whatever the program does.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::verify {

std::optional<std::string> missing_requirement(const Setup& setup, std::string_view requirement) {
    if (requirement == "holder") {
        std::string without;
        for (const auto& [number, facts] : setup.tools) {
            if (!facts.holder_specified)
                without += fmt::format("{}T{}", without.empty() ? "" : ", ", number);
        }
        if (without.empty()) return std::nullopt;
        return "holder: not specified for " + without;
    }
    if (requirement == "lengths") {
        std::string without;
        for (const auto& [number, facts] : setup.tools) {
            if (!facts.gauge_length_specified && setup.cutting_tools.contains(number))
                without += fmt::format("{}T{}", without.empty() ? "" : ", ", number);
        }
        if (without.empty()) return std::nullopt;
        return "lengths: not specified for " + without +
               " (Z in a tool table, offset in a job file)";
    }
    if (requirement == "modes") {
        if (setup.inherited_modes.empty()) return std::nullopt;
        return fmt::format("modes: not set before the first move: {}",
                           fmt::join(setup.inherited_modes, ", "));
    }
    if (requirement == "fixtures") {
        const bool specified = setup.machine.fixtures_specified || !setup.machine.fixtures.empty();
        if (specified) return std::nullopt;
        return "fixtures: not specified; fixture = [] says that there are none";
    }
    if (requirement == "travels") {
        const bool all =
            std::ranges::all_of(setup.machine.travel, [](const auto& t) { return t.has_value(); });
        if (all && setup.machine.work_zero) return std::nullopt;
        return all ? "travels: the position of the workpiece in the machine is not specified"
                   : "travels: not specified for every axis";
    }
    if (requirement == "links") {
        if (auto missing = needs_links(setup)) return "links: " + *missing;
        return std::nullopt;
    }
    if (setup.machine.work_zero) return std::nullopt;
    return "offsets: the position of the workpiece in the machine is not specified";
}

bool needs_part(const Setup& setup) {
    return std::ranges::any_of(rule_table(), [&](const Rule& rule) {
        const bool is_asked = rule.info.id != "air-cut" || setup.air_cuts;
        return rule.of_part && is_asked && setup.selection.includes(rule.info.id);
    });
}

}  // namespace ncsim::verify
