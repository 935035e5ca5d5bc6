// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names and numbers of coordinate systems.
#include "ncsim/setup/coordinate_systems.h"

#include "ncsim/base/number_text.h"

#include <fmt/format.h>

#include <string_view>

namespace ncsim::setup {

namespace {

constexpr int kNamedSystems = 9;  // G54 … G59.3

}  // namespace

std::optional<int> system_named(const std::string& name) {
    for (int system = 1; system <= kNamedSystems; ++system) {
        if (name_of_system(system) == name) return system;
    }
    constexpr std::string_view kExtended = "G54.1 P";
    if (!name.starts_with(kExtended)) return std::nullopt;
    const auto number = number_in<int>(std::string_view(name).substr(kExtended.size()));
    if (!number || *number < 1 || *number > 300) return std::nullopt;
    return kNamedSystems + *number;
}

std::string name_of_system(int system) {
    if (system > kNamedSystems) return fmt::format("G54.1 P{}", system - kNamedSystems);
    return system > 6 ? fmt::format("G59.{}", system - 6) : fmt::format("G{}", 53 + system);
}

void tell_offset(gcode::InterpreterOptions& options, int system, Vec3 origin) {
    gcode::Position at;
    at.x = gcode::Length::from_mm(origin.x);
    at.y = gcode::Length::from_mm(origin.y);
    at.z = gcode::Length::from_mm(origin.z);
    const auto named = options.work_offsets.size();
    const auto index = static_cast<std::size_t>(system - 1);
    if (index < named) {
        options.work_offsets[index] = at;
        options.work_offsets_specified[index] = true;
    } else {
        options.extended_offsets[system - static_cast<int>(named)] = at;
    }
}

std::optional<Vec3> origin_of(const gcode::InterpreterOptions& options, int system) {
    const auto vector = [](const gcode::Position& p) { return Vec3{p.x.mm(), p.y.mm(), p.z.mm()}; };
    const int named = static_cast<int>(options.work_offsets.size());
    if (system > named) {
        const auto found = options.extended_offsets.find(system - named);
        if (found == options.extended_offsets.end()) return std::nullopt;
        return vector(found->second);
    }
    const auto index = static_cast<std::size_t>(system - 1);
    if (!options.work_offsets_specified[index]) return std::nullopt;
    return vector(options.work_offsets[index]);
}

}  // namespace ncsim::setup
