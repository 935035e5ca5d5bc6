// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/stock.h"

#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ncsim::toolpath {

namespace {

// Exactly three numbers between separators.
std::optional<cda::Vec3> three_numbers(std::string_view s, char separator) {
    const auto parts = text::split(s, separator);
    if (parts.size() != 3) return std::nullopt;
    cda::Vec3 v;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view part = text::trimmed(parts[static_cast<std::size_t>(axis)]);
        const auto q = text::quantity_at(part, 0);
        if (!q || q->end != part.size() || q->unit != text::Unit::None) return std::nullopt;
        v[axis] = q->value;
    }
    return v;
}

}  // namespace

std::optional<cda::Box> parse_stock_option(std::string_view option, std::string& message) {
    const std::string upper = text::upper(text::trimmed(option));
    std::string_view s = upper;
    double scale = 1.0;
    for (const std::string_view unit : {std::string_view("MM"), std::string_view("IN")}) {
        if (s.size() > 2 && s.substr(s.size() - 2) == unit) {
            scale = unit == "IN" ? 25.4 : 1.0;
            s = text::trimmed(s.substr(0, s.size() - 2));
        }
    }
    cda::Box box;
    const std::size_t colon = s.find(':');
    const std::size_t at = s.find('@');
    if (colon != std::string_view::npos) {
        const auto a = three_numbers(s.substr(0, colon), ',');
        const auto b = three_numbers(s.substr(colon + 1), ',');
        if (a && b) box.add(scale * *a), box.add(scale * *b);
    } else if (const auto size = three_numbers(s.substr(0, at), 'X')) {
        std::optional<cda::Vec3> corner;
        if (at != std::string_view::npos) {
            corner = three_numbers(s.substr(at + 1), ',');
        } else {
            corner = cda::Vec3{-size->x / 2, -size->y / 2, -size->z};
        }
        if (corner && size->x > 0 && size->y > 0 && size->z > 0) {
            box.add(scale * *corner), box.add(scale * (*corner + *size));
        }
    }
    const auto refuse = [&](std::string_view why) {
        message = text::quoted(option) + ": ";
        message += why;
        return std::nullopt;
    };
    if (box.is_empty()) {
        return refuse("expected x0,y0,z0:x1,y1,z1 or LxWxH or LxWxH@x,y,z");
    }
    const cda::Vec3 size = box.size();
    for (int axis = 0; axis < 3; ++axis) {
        if (!text::is_sane_length(size[axis]) || std::abs(box.min[axis]) > 1e6) {
            return refuse("a block must be between 1 nm and 1 km in each direction, near zero");
        }
    }
    return box;
}

DerivedStock derive_stock(const cda::Box& swept, double highest_tip) {
    constexpr double kMargin = 0.05;
    constexpr double kLeastMargin = 2.0;
    constexpr double kLeastHeight = 1.0;
    DerivedStock stock;
    if (swept.is_empty()) return stock;
    cda::Box box = swept;
    const auto margin = [&](double size) { return std::max(kLeastMargin, kMargin * size); };
    for (int axis = 0; axis < 2; ++axis) {
        const double m = margin(swept.size()[axis]);
        box.min[axis] = std::floor(swept.min[axis] - m);
        box.max[axis] = std::ceil(swept.max[axis] + m);
    }
    const bool from_zero = swept.min.z < 0;
    box.max.z = from_zero ? 0.0 : std::max(highest_tip, swept.min.z + kLeastHeight);
    box.min.z = std::floor(swept.min.z - margin(box.max.z - swept.min.z));
    stock.box = box;
    stock.rule =
        "derived: what the tools sweep in cutting moves, with 5 % (at least 2 mm) more on all "
        "sides "
        "and below; top at ";
    stock.rule += from_zero
                      ? "Z0, since cuts go below it"
                      : "the highest cutting position of a tool tip, since no cut goes below Z0";
    return stock;
}

}  // namespace ncsim::toolpath
