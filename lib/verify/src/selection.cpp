// SPDX-License-Identifier: GPL-3.0-or-later
//
// Origins of deselected rules and changed severities.
#include "ncsim/verify/selection.h"

namespace ncsim::verify {

void Selection::set_origin(std::string_view option, const std::string& place) {
    for (auto& [rule, by] : ignored) {
        if (by == option) by = place;
    }
    for (auto& [rule, weight] : severities) {
        if (weight.by == option) weight.by = place;
    }
    if (accepted_by == option) accepted_by = place;
}

}  // namespace ncsim::verify
