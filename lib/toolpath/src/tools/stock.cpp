// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stock options, the stock's shape, and derivation of a stock from cutting moves.
#include "ncsim/toolpath/stock.h"

#include "ncsim/base/angles.h"
#include "ncsim/cda/hull.h"

#include "tools/comment_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ncsim::toolpath {

namespace {

// Reads exactly `count` numbers, three at most, between separators. With `unit`, the numbers are
// lengths in mm that may have units; a length without unit is multiplied by `unit`.
std::optional<Vec3> numbers(std::string_view s, char separator, int count,
                            std::optional<double> unit) {
    using text::Unit;
    const auto parts = text::split(s, separator);
    if (parts.size() != static_cast<std::size_t>(count)) return std::nullopt;
    Vec3 v;
    for (int axis = 0; axis < count; ++axis) {
        const std::string_view part = trimmed(parts[static_cast<std::size_t>(axis)]);
        const auto q = text::quantity_at(part, 0);
        if (!q || q->end != part.size() || q->unit == Unit::Degree) return std::nullopt;
        if (!unit && q->unit != Unit::None) return std::nullopt;
        v[axis] = q->value;
        if (!unit || q->unit == Unit::Millimetre) continue;
        const bool inch = q->unit == Unit::Inch || q->is_fraction;
        v[axis] *= inch ? 25.4 : *unit;
    }
    return v;
}

}  // namespace

std::optional<Vec3> parse_triple(std::string_view text) {
    return numbers(text, ',', 3, std::nullopt);
}

std::optional<Stock> parse_stock_option(std::string_view option, std::string& message) {
    const std::string upper = uppercase(trimmed(option));
    std::string_view s = upper;
    // The unit after the last number is the unit of all numbers without unit.
    double scale = 1.0;
    for (const std::string_view unit : {"IN", "INCH", "INCHES", "\""}) {
        if (s.size() > unit.size() && s.substr(s.size() - unit.size()) == unit) scale = 25.4;
    }
    const auto three = [scale](std::string_view part, char separator) {
        return numbers(part, separator, 3, scale);
    };
    Box box;
    const bool is_round = s.substr(0, 1) == "D";
    int axis = 2;
    if (is_round && (s.substr(1, 1) == "X" || s.substr(1, 1) == "Y")) {
        axis = s[1] - 'X';
        s.remove_prefix(1);
    }
    const std::size_t colon = s.find(':');
    const std::size_t at = s.find('@');
    if (is_round) {
        const auto size =
            numbers(s.substr(1, at == std::string_view::npos ? at : at - 1), 'X', 2, scale);
        std::optional<Vec3> foot;
        if (at != std::string_view::npos) {
            foot = three(s.substr(at + 1), ',');
        } else if (size) {
            foot.emplace();
            (*foot)[axis] = axis == 2 ? -size->y : -size->y / 2;
        }
        if (foot && size && size->x > 0 && size->y > 0) {
            const double r = size->x / 2;
            Vec3 below{-r, -r, -r}, above{r, r, r};
            below[axis] = 0.0, above[axis] = size->y;
            box.add(*foot + below);
            box.add(*foot + above);
        }
    } else if (colon != std::string_view::npos) {
        const auto a = three(s.substr(0, colon), ',');
        const auto b = three(s.substr(colon + 1), ',');
        if (a && b) box.add(*a), box.add(*b);
    } else if (const auto size = three(s.substr(0, at), 'X')) {
        std::optional<Vec3> corner;
        if (at != std::string_view::npos) {
            corner = three(s.substr(at + 1), ',');
        } else {
            corner = Vec3{-size->x / 2, -size->y / 2, -size->z};
        }
        if (corner && size->x > 0 && size->y > 0 && size->z > 0) {
            box.add(*corner), box.add(*corner + *size);
        }
    }
    const auto refuse = [&](std::string_view why) {
        message = text::quoted(option) + ": ";
        message += why;
        return std::nullopt;
    };
    if (box.is_empty()) {
        return refuse(
            "expected x0,y0,z0:x1,y1,z1 or LxWxH or LxWxH@x,y,z, "
            "for a bar DdxH or DdxH@x,y,z (DXdxL, DYdxL: along X, Y)");
    }
    const Vec3 size = box.size();
    for (int i = 0; i < 3; ++i) {
        if (!text::is_sane_length(size[i]) || std::abs(box.min[i]) > 1e6) {
            return refuse("a block must be between 1 nm and 1 km in each direction, near zero");
        }
    }
    return Stock{box, is_round, axis, {}, {}};
}

cda::Lattice stock_lattice(const Stock& stock) {
    return stock.shape ? stock.shape->lattice : cda::Lattice::for_stock(stock.box);
}

cda::Shape stock_shape(const Stock& stock, double tolerance_mm) {
    if (stock.shape) return *stock.shape;
    const cda::Lattice lattice = stock_lattice(stock);
    const cda::LatticePoint min = lattice.round(stock.box.min);
    const cda::LatticePoint max = lattice.round(stock.box.max);
    if (!stock.is_round) return {lattice, cda::box_cell(min, max, lattice), {}};
    // The number of sides is a multiple of four; four sides lie in the sides of the box.
    const int along = stock.axis;
    const int across = (along + 1) % 3, up = (along + 2) % 3;
    const double radius = 0.5 * stock.box.size()[across];
    int sides = 16;
    const auto beyond = [&] { return radius * (1.0 / sin_cos(180.0 / sides).cos - 1.0); };
    while (beyond() > tolerance_mm && sides < 4096)
        sides += 4;
    const Vec3 centre = 0.5 * (stock.box.min + stock.box.max);
    const double corner = radius / sin_cos(180.0 / sides).cos;
    std::vector<cda::LatticePoint> points;
    for (int i = 0; i < sides; ++i) {
        const SinCos at = sin_cos(180.0 * (2 * i + 1) / sides);
        for (const Vec3& end : {stock.box.min, stock.box.max}) {
            Vec3 p;
            p[across] = centre[across] + corner * at.cos;
            p[up] = centre[up] + corner * at.sin;
            p[along] = end[along];
            points.push_back(lattice.round(p));
        }
    }
    return {lattice, *cda::convex_hull(points, lattice, cda::kStockOrigin), {}};
}

namespace {

constexpr double kMarginShare = 0.05;
constexpr double kLeastMargin = 2.0;
constexpr double kLeastHeight = 1.0;
constexpr double kFarBelow = 10.0;  // mm, below Z0: deeper than a first cut at the side of a block

double margin(double size) {
    return std::max(kLeastMargin, kMarginShare * size);
}

// Widens the box along an axis by the margin, to whole millimetres.
void widen(Box& box, int axis) {
    const double m = margin(box.size()[axis]);
    box.min[axis] = std::floor(box.min[axis] - m);
    box.max[axis] = std::ceil(box.max[axis] + m);
}

}  // namespace

void HighestLevels::add(double z) {
    constexpr double kSame = 1e-6;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        if (std::abs(z - levels_[i]) < kSame) return;
        if (z < levels_[i]) continue;
        std::move_backward(levels_.begin() + static_cast<std::ptrdiff_t>(i), levels_.end() - 1,
                           levels_.end());
        levels_[i] = z;
        return;
    }
}

void HighestLevels::add(const HighestLevels& others) {
    for (const double z : others.levels_) {
        if (z > kNone) add(z);
    }
}

std::optional<double> HighestLevels::step() const {
    if (levels_[2] == kNone) return std::nullopt;
    const double first = levels_[0] - levels_[1];
    const double second = levels_[1] - levels_[2];
    constexpr double kEqual = 0.01;
    if (std::abs(first - second) > kEqual * first) return std::nullopt;
    return first;
}

DerivedStock derive_stock(const Box& swept, double highest_tip, const HighestLevels& levels) {
    DerivedStock derived;
    if (swept.is_empty()) return derived;
    Box box = swept;
    widen(box, 0);
    widen(box, 1);
    const double depth = highest_tip - swept.min.z;
    const bool is_far_below = highest_tip < -kFarBelow && -highest_tip > 4.0 * depth && depth > 0.0;
    const bool from_zero = swept.min.z < 0 && !is_far_below;
    const std::optional<double> step =
        levels.highest() == highest_tip ? levels.step() : std::nullopt;
    const double highest = highest_tip + step.value_or(0.0);
    box.max.z = from_zero ? 0.0 : std::max(highest, swept.min.z + kLeastHeight);
    box.min.z = std::floor(swept.min.z - margin(box.max.z - swept.min.z));
    derived.stock.box = box;
    derived.rule =
        "derived: what the tools sweep in cutting moves (face mills without run-in and run-out), "
        "with 5 % (at least 2 mm) more on all sides and below; top at ";
    derived.rule += from_zero ? "Z0, since cuts go below it"
                    : step    ? "a step above the first of passes in equal steps"
                              : "the highest cutting position of a tool tip";
    if (!from_zero) {
        derived.rule +=
            is_far_below ? ", since all cuts are far below Z0" : ", since no cut goes below Z0";
    }
    return derived;
}

DerivedStock derive_sheet(const Box& tips) {
    DerivedStock derived;
    if (tips.is_empty()) return derived;
    Box box = tips;
    widen(box, 0);
    widen(box, 1);
    box.max.z = tips.min.z;
    box.min.z = box.max.z - kLeastHeight;
    derived.stock.box = box;
    derived.rule = "derived: a sheet below the path, with 5 % (at least 2 mm) more on all sides";
    return derived;
}

DerivedStock derive_bar(const Box& swept, int axis, double radius) {
    DerivedStock derived;
    if (swept.is_empty()) return derived;
    Box box = swept;
    widen(box, axis);
    const double r = std::max(radius, kLeastHeight);
    for (const int across : {(axis + 1) % 3, (axis + 2) % 3}) {
        box.min[across] = -r;
        box.max[across] = r;
    }
    derived.stock.box = box;
    derived.stock.is_round = true;
    derived.stock.axis = axis;
    derived.rule =
        "derived: a bar about the axis that turns, as thick as a tool tip is far from it "
        "where it cuts; at both ends 5 % (at least 2 mm) more than the tools sweep";
    return derived;
}

DerivedStock derive_block(const Box& tips) {
    DerivedStock derived;
    if (tips.is_empty()) return derived;
    Box box = tips;
    for (int axis = 0; axis < 3; ++axis)
        widen(box, axis);
    derived.stock.box = box;
    derived.rule =
        "derived: a block around all cutting positions of tool tips, with 5 % (at least 2 "
        "mm) more on all sides";
    return derived;
}

}  // namespace ncsim::toolpath
