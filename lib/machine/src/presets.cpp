// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table of the predefined machines.
#include "ncsim/machine/presets.h"

namespace ncsim::machine {

namespace {

constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

Joint table(char letter, Vec3 about) {
    return joint_of(letter, true, about, {}, Positive::Part);
}

Joint iso(char letter, Vec3 about) {
    return joint_of(letter, true, about);
}

// Returns X, Y and Z between the joints `part`, which carry the part, the joint nearest to the part
// first, and `head`, which carry the tool, the joint nearest to the tool last.
Chain chain(std::vector<Joint> part, const std::vector<Joint>& head = {}) {
    for (const auto& [letter, along] : {std::pair{'X', kX}, {'Y', kY}, {'Z', kZ}})
        part.push_back(joint_of(letter, false, along));
    part.insert(part.end(), head.begin(), head.end());
    return {std::move(part)};
}

struct Known {
    Preset preset;
    Chain chain;
};

const std::vector<Known>& all() {
    static const std::vector<Known> known{
        {{"xyzac-trt", "table: C turns the part on a cradle A (LinuxCNC xyzac-trt-kins)"},
         chain({table('C', kZ), table('A', kX)})},
        {{"xyzbc-trt", "table: C turns the part on a cradle B (LinuxCNC xyzbc-trt-kins)"},
         chain({table('C', kZ), table('B', kY)})},
        {{"xyzab-table", "table: A turns the part on a table B, signs of ISO 841"},
         chain({iso('A', kX), iso('B', kY)})},
        {{"bridge-cb", "head: B turns the tool on a fork C, B as in LinuxCNC's 5axiskins"},
         chain({}, {iso('C', kZ), table('B', kY)})},
        {{"head-b-table-c", "B turns the tool, C the part, signs of ISO 841"},
         chain({iso('C', kZ)}, {iso('B', kY)})},
        {{"nutating-cb", "head: B turns about an axis that leans 45 degrees from Z to Y, on C"},
         chain({}, {iso('C', kZ), iso('B', {0, 1, 1})})},
        {{"4axis-a", "A turns the part, signs of ISO 841"}, chain({iso('A', kX)})},
        {{"4axis-b", "B turns the part, signs of ISO 841"}, chain({iso('B', kY)})},
        {{"hmc-b", "horizontal machine: B turns the part, signs of ISO 841"},
         chain({iso('B', kY)})},
    };
    return known;
}

}  // namespace

const Chain& default_chain() {
    static const Chain known = chain({iso('C', kZ), iso('B', kY), iso('A', kX)});
    return known;
}

std::vector<Preset> presets() {
    std::vector<Preset> names;
    for (const Known& known : all())
        names.push_back(known.preset);
    return names;
}

std::optional<Chain> preset(std::string_view name) {
    for (const Known& known : all()) {
        if (known.preset.name == name) return known.chain;
    }
    return std::nullopt;
}

}  // namespace ncsim::machine
