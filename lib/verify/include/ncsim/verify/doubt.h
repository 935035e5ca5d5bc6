// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why a program is not proven to be safe although nothing was found: a verdict never rests on
// silence. What was guessed, left out or not reached makes it "not proven", unless somebody accepts
// that.
#pragma once

#include "ncsim/verify/finding.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ncsim::verify {

/// What people are told about a reason. The texts are static; ids are stable and kebab-case.
struct ReasonInfo {
    std::string_view id;
    std::string_view why;  ///< One sentence.
    std::string_view fix;  ///< What to specify or to change, as an imperative.
};

/// All reasons; the order never depends on anything.
std::span<const ReasonInfo> reasons();
/// Null if there is none of this id.
const ReasonInfo* find_reason(std::string_view id);

struct Doubt {
    std::string reason;
    std::string message;  ///< Lower case, no full stop.
    Place place;          ///< Where it came up first; line 0: nowhere.
    std::uint64_t count = 1;
    bool accepted = false;  ///< Somebody decided otherwise: told, but does not count.
    bool operator==(const Doubt&) const = default;
};

}  // namespace ncsim::verify
