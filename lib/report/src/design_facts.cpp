// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of the comparison with a design.
#include "ncsim/report/design_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

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

std::vector<DesignPlace> largest(std::vector<DesignPlace> places, std::size_t most) {
    std::ranges::stable_sort(places, std::greater<>(), &DesignPlace::depth_mm);
    if (places.size() > most) places.resize(most);
    return places;
}

std::string text_of(const DesignPlace& place) {
    std::string text =
        fmt::format("{} {:.4g} mm", place.is_gouge ? "gouge" : "excess", place.depth_mm);
    if (place.line > 0) text += fmt::format(", line {}", place.line);
    // + 0.0: no "-0".
    return text + fmt::format(", at X{:.6g} Y{:.6g} Z{:.6g}", place.point.x + 0.0,
                              place.point.y + 0.0, place.point.z + 0.0);
}

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
