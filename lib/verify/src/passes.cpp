// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records and looks up the passes of a tool.
#include "passes.h"

#include "body.h"

#include <algorithm>
#include <utility>

namespace ncsim::verify {

Passes::Pass Passes::pass_of(const toolpath::Step& step) {
    Vec3 a = step.X_WA.translation;
    Vec3 b = step.X_WB.translation;
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
    // Straight up or down: only the lower end matters.
    if (a.x == b.x && a.y == b.y) a.z = b.z = std::min(a.z, b.z);
    return {{a.x, a.y, b.x, b.y}, {a.z, b.z}};
}

void Passes::add(const toolpath::Step& step) {
    if (!is_upright(step)) return;
    const Pass pass = pass_of(step);
    if (lowest_.size() >= kMost) lowest_.clear();
    const auto [old, is_new] = lowest_.try_emplace(pass.way, pass.heights);
    // If neither pass is below the other at both ends, the older pass is kept.
    if (!is_new && pass.heights[0] <= old->second[0] && pass.heights[1] <= old->second[1])
        old->second = pass.heights;
}

bool Passes::cover(const toolpath::Step& step, double rise) const {
    if (!is_upright(step)) return false;
    const Pass pass = pass_of(step);
    const auto found = lowest_.find(pass.way);
    return found != lowest_.end() && found->second[0] <= pass.heights[0] + rise &&
           found->second[1] <= pass.heights[1] + rise;
}

}  // namespace ncsim::verify
