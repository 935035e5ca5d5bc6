// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reasons why a program without findings is not proven safe. Each assumed, omitted or unreached
// item makes the verdict "not proven" unless the user accepts the reason.
#pragma once

#include "ncsim/verify/finding.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ncsim::verify {

/// Texts about a reason. The texts are static; ids are stable and kebab-case.
struct ReasonInfo {
    std::string_view id;
    std::string_view why;  ///< Reason: a sentence.
    std::string_view fix;  ///< Remedy: an imperative sentence.
};

/// Returns all reasons, always in the same order.
std::span<const ReasonInfo> reasons();
/// Returns the reason with this id; null if there is none.
const ReasonInfo* find_reason(std::string_view id);

/// Reason for which the program is not proven safe.
struct Doubt {
    std::string reason;
    std::string message;  ///< Lower case, no full stop.
    Place place;          ///< Place of the first occurrence; line 0: none.
    std::uint64_t count = 1;
    bool accepted = false;  ///< Accepted by the user: reported, but does not count.
    bool operator==(const Doubt&) const = default;
};

}  // namespace ncsim::verify
