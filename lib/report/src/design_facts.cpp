// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of the comparison with a design.
#include "ncsim/report/design_facts.h"

#include <fmt/format.h>

namespace ncsim::report {

namespace {

std::string text_of(const DesignFacts::Side& side, const char* what) {
    if (side.regions == 0) return {};
    std::string text = fmt::format("; {} in {} place{}, up to {:.4g} mm", what, side.regions,
                                   side.regions == 1 ? "" : "s", side.largest_mm);
    if (side.volume_mm3) text += fmt::format(", {:.4g} mm3 in all", *side.volume_mm3);
    return text;
}

}  // namespace

std::string text_of(const DesignFacts& facts) {
    std::string text = fmt::format("{} within {:g} mm", facts.path, facts.tolerance_mm);
    if (facts.gouge.regions == 0 && facts.excess.regions == 0) {
        text += ": nothing beyond";
    } else {
        text += text_of(facts.gouge, "gouged") + text_of(facts.excess, "too much left");
    }
    return text + fmt::format("; farthest apart {:.4g} mm", facts.deviation_mm);
}

}  // namespace ncsim::report
