// SPDX-License-Identifier: GPL-3.0-or-later
//
// Descriptions of boxes, stock, volumes and lines.
#include "ncsim/report/describe.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"

#include <fmt/format.h>

namespace ncsim::report {

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

std::string volume_text(double mm3) {
    return fmt::format("{:.3f} cm3", mm3 / 1000);
}

std::string lines_text(const std::vector<verify::LineRange>& lines) {
    constexpr std::size_t kShown = 6;
    std::string text;
    for (std::size_t i = 0; i < lines.size() && i < kShown; ++i) {
        text += fmt::format("{}{}", i == 0 ? "" : ", ", lines[i].first);
        if (lines[i].last != lines[i].first) text += fmt::format("-{}", lines[i].last);
    }
    if (lines.size() > kShown) text += fmt::format(" and {} more", lines.size() - kShown);
    return text;
}

}  // namespace ncsim::report
