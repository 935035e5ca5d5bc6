// SPDX-License-Identifier: GPL-3.0-or-later
//
// Descriptions of boxes and stock.
#include "ncsim/simulation/describe.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"

#include <fmt/format.h>

namespace ncsim::simulation {

std::string describe(const Box& box) {
    const Vec3 size = box.size();
    return fmt::format(
        "{:.6g} x {:.6g} x {:.6g} mm, X {:.6g} to {:.6g}, Y {:.6g} to {:.6g}, Z {:.6g} to {:.6g}",
        size.x, size.y, size.z, box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z);
}

std::string describe(const toolpath::Stock& stock) {
    constexpr const char* kBars[] = {"a round bar along X in ", "a round bar along Y in ",
                                     "a round bar in "};
    if (!stock.from) return (stock.is_round ? kBars[stock.axis] : "") + describe(stock.box);
    std::string text = fmt::format("{} in {}", base_name(stock.from->path), describe(stock.box));
    if (!stock.from->turn.empty()) text += ", turned " + stock.from->turn;
    if (stock.deflection_mm > 0.0)
        text += fmt::format(", triangles within {:g} mm of its surfaces", stock.deflection_mm);
    return one_line(text);
}

}  // namespace ncsim::simulation
