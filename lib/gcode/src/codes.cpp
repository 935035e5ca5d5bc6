// SPDX-License-Identifier: GPL-3.0-or-later
#include "codes.h"

#include <array>

namespace ncsim::gcode {
namespace {

constexpr auto kCodes = std::to_array<GCode>({
#define NCSIM_G(number, group, uses_axes, in_rs274) {number, Group::group, uses_axes, in_rs274},
#include "codes.def"
#undef NCSIM_G
});

constexpr int kMaxNumber = 2700;  // above G269 none is known

constexpr auto kIndex = [] {
    std::array<std::uint8_t, kMaxNumber> index{};
    for (std::size_t i = 0; i < kCodes.size(); ++i) {
        index[static_cast<std::size_t>(kCodes[i].number)] = static_cast<std::uint8_t>(i + 1);
    }
    return index;
}();

}  // namespace

const GCode* find_g(int number) {
    if (number < 0 || number >= kMaxNumber) return nullptr;
    const std::uint8_t entry = kIndex[static_cast<std::size_t>(number)];
    return entry == 0 ? nullptr : &kCodes[entry - 1U];
}

MGroup m_group(int number) {
    switch (number) {
        case 0:
        case 1:
        case 2:
        case 30:
        case 60: return MGroup::Stop;
        case 6:
        case 61: return MGroup::ToolChange;
        case 3:
        case 4:
        case 5:
        case 13:
        case 14:
        case 19: return MGroup::Spindle;
        case 7:
        case 8:
        case 9: return MGroup::Coolant;
        case 48:
        case 49:
        case 50:
        case 51:
        case 52:
        case 53: return MGroup::Override;
        case 62:
        case 63:
        case 64:
        case 65:
        case 66:
        case 67:
        case 68: return MGroup::Io;
        case 97:
        case 98:
        case 99: return MGroup::Call;
        case 70:
        case 71:
        case 72:
        case 73: return MGroup::Other;
        case 428:
        case 429:
        case 430: return MGroup::Kinematics;
        default: return MGroup::Unknown;
    }
}

}  // namespace ncsim::gcode
