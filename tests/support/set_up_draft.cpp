// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decimal numbers of a draft.
#include "support/set_up_draft.h"

#include <cstdlib>

namespace ncsim::test::set_ups {

std::string decimal(std::int64_t value, int places) {
    std::string digits = std::to_string(std::abs(value));
    const auto least = static_cast<std::size_t>(places) + 1;
    if (digits.size() < least) digits.insert(0, least - digits.size(), '0');
    digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
    while (digits.back() == '0')
        digits.pop_back();
    return (value < 0 ? "-" : "") + digits;
}

}  // namespace ncsim::test::set_ups
