// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lookup of G codes in codes.def, and the classes of M codes.
#include "control/codes.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ncsim::gcode {
namespace {

/// Name of a code as programs write the name, with a point in place of the '_'.
template <std::size_t Size>
struct CodeText {
    std::array<char, Size> text{};
    constexpr explicit CodeText(const char (&name)[Size]) {
        for (std::size_t i = 0; i < Size; ++i)
            text[i] = name[i] == '_' ? '.' : name[i];
    }
    constexpr operator std::string_view() const { return {text.data(), Size - 1}; }
};

constexpr std::uint32_t bits_of(std::string_view letters) {
    std::uint32_t bits = 0;
    for (const char letter : letters) {
        if (letter != '+') bits |= 1U << static_cast<unsigned>(letter - 'A');
    }
    return bits;
}

#define NCSIM_G(name, group, takes_axes, letters, availability) constexpr CodeText k##name(#name);
#include "control/codes.def"
#undef NCSIM_G

constexpr auto kCodes = std::to_array<GCode>({
#define NCSIM_G(name, group, takes_axes, letters, availability) \
    {Code::name,                                                \
     k##name,                                                   \
     Group::group,                                              \
     takes_axes,                                                \
     bits_of(letters),                                          \
     std::string_view(letters).ends_with('+'),                  \
     Availability::availability},
#include "control/codes.def"
#undef NCSIM_G
});

constexpr int kMaxTenths = 2920;  // Upper bound: the last known code is G291.

constexpr auto kIndex = [] {
    std::array<std::uint8_t, kMaxTenths> index{};
    for (std::size_t i = 0; i < kCodes.size(); ++i) {
        index[static_cast<std::size_t>(tenths_of(kCodes[i].code))] =
            static_cast<std::uint8_t>(i + 1);
    }
    return index;
}();

}  // namespace

/// Returns the code with `tenths` = 10 × number, or None.
Code find_g(int tenths) {
    if (tenths < 0 || tenths >= kMaxTenths || kIndex[static_cast<std::size_t>(tenths)] == 0) {
        return Code::None;
    }
    return static_cast<Code>(tenths);
}

const GCode& entry_of(Code code) {
    return kCodes[kIndex[static_cast<std::size_t>(tenths_of(code))] - 1U];
}

bool is_cycle(Code code) {
    switch (code) {
        case Code::G73:
        case Code::G74:
        case Code::G76:
        case Code::G81:
        case Code::G82:
        case Code::G83:
        case Code::G84:
        case Code::G85:
        case Code::G86:
        case Code::G87:
        case Code::G88:
        case Code::G89: return true;
        default: return false;
    }
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
        case 99:
        case 198: return MGroup::Call;
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

bool is_harmless_m(int number, Dialect dialect) {
    // M29: rigid tapping, which G84 always simulates.
    if (dialect == Dialect::Fanuc) return number == 29;
    if (dialect != Dialect::Haas) return false;
    const auto is_in = [number](int first, int last) { return number >= first && number <= last; };
    // Brakes of rotary axes; user outputs; chips and coolant; gears; display, doors, air, mist and
    // jets; variation of the spindle speed. Excluded: M16, M36, M46, M50, M82, M86, M96, M109.
    return is_in(10, 12) || is_in(21, 29) || is_in(31, 35) || is_in(41, 42) || is_in(51, 59) ||
           is_in(62, 69) || is_in(73, 74) || is_in(76, 77) || is_in(80, 81) || is_in(83, 84) ||
           is_in(88, 89) || is_in(130, 131) || is_in(138, 139) || is_in(158, 163);
}

}  // namespace ncsim::gcode
