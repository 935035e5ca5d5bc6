// SPDX-License-Identifier: GPL-3.0-or-later
//
// Permitted deviations of each move, and the verdict on a point.
#include "nightly/judge.h"

#include <algorithm>
#include <cstdio>

namespace ncsim::nightly {

namespace {

const char* name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::Material: return "material";
        case Verdict::Empty: return "empty";
        case Verdict::Open: break;
    }
    return "open";
}

}  // namespace

double lattice_unit(const StockShape& stock) {
    double reach = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        reach = std::max({reach, std::abs(stock.min[i]), std::abs(stock.max[i])});
    for (double decade = 1e-5;; decade *= 10) {
        for (const double step : {1.0, 2.0, 5.0}) {
            if (reach <= step * decade * 0x1p25) return step * decade;
        }
    }
}

Judge::Judge(const Program& program, const StatedAccuracy& stated)
    : program_(program), stated_(stated) {
    for (const Move& move : program.moves) {
        const Course& course = move.course;
        const RoundTool& tool = program.tools[move.tool];
        Allowance a;
        // "Poses: half a unit an axis"; poses on the lattice are not rounded. Corners of rotated
        // tools are rounded a second time, except for multiples of 90°.
        const double half_unit = std::sqrt(3.0) / 2 * (1 + 0x1p-15) * stated.unit;
        double rounding = half_unit;
        if (course.is_straight() && !course.turns()) {
            const Vec from = course.to_workpiece(0.0, {});
            const Vec to = course.to_workpiece(1.0, {});
            Vec off{};
            for (std::size_t i = 0; i < 3; ++i)
                off[i] = std::max(rounding_of(from[i]), rounding_of(to[i]));
            rounding = norm(off);
        }
        if (!course.is_square()) rounding += half_unit;
        // "Arcs: the chord tolerance, either side"; "rotary moves: both bounds printed": the
        // tolerance on the missed side and ten times the tolerance on the gained side.
        double missed = 0.0;
        double gained = 0.0;
        if (!course.is_straight()) missed += program.tolerance_mm, gained += program.tolerance_mm;
        if (course.turns()) missed += program.tolerance_mm, gained += 10 * program.tolerance_mm;
        a.missed = std::min(missed, stated.missed) + rounding;
        // "Facets: 2^-24 of their length, outward": at a sharp edge between two facets, the edge
        // moves further than both facets.
        const double length =
            norm(course.to().x - course.from().x) + 2 * tool.radius() + tool.height();
        const double sharp = std::max(2.0, 1.2 / std::sin(tool.sharpest_half_angle()));
        a.gained = std::min(gained, stated.gained) + rounding + sharp * 0x1p-24 * length;
        // "Fair" tools err to both sides on rounded parts.
        a.tool = stated.tool_error[move.tool];
        if (tool.is_rounded()) a.missed += a.tool;
        allowances_.push_back(a);
    }
}

// Returns the largest rounding of a coordinate; a queried point is rounded to 2^-16 of a unit.
double Judge::rounding_of(double mm) const {
    return off_lattice(mm) + 0x1p-16 * stated_.unit;
}

double Judge::off_lattice(double mm) const {
    const double units = mm / stated_.unit;
    return std::abs(units - std::round(units)) * stated_.unit;
}

bool Judge::is_inside_stock(const Vec& p_W) const {
    const StockShape& stock = program_.stock;
    for (std::size_t i = 0; i < 3; ++i) {
        if (p_W[i] <= stock.min[i] + rounding_of(stock.min[i])) return false;
        if (p_W[i] >= stock.max[i] - rounding_of(stock.max[i])) return false;
    }
    if (!stock.is_round) return true;
    const Vec aside = p_W - 0.5 * (stock.min + stock.max);
    return std::hypot(aside[0], aside[1]) < 0.5 * (stock.max[0] - stock.min[0]) - 2 * stated_.unit;
}

bool Judge::is_outside_stock(const Vec& p_W) const {
    const StockShape& stock = program_.stock;
    for (std::size_t i = 0; i < 3; ++i) {
        // Corners of a bar are rounded to the lattice.
        const double off = stock.is_round && i < 2 ? stated_.unit : 0.0;
        if (p_W[i] < stock.min[i] - rounding_of(stock.min[i]) - off) return true;
        if (p_W[i] > stock.max[i] + rounding_of(stock.max[i]) + off) return true;
    }
    if (!stock.is_round) return false;
    const Vec aside = p_W - 0.5 * (stock.min + stock.max);
    const double radius = 0.5 * (stock.max[0] - stock.min[0]);
    return std::hypot(aside[0], aside[1]) > radius + program_.tool_tolerance_mm + 2 * stated_.unit;
}

// Values off the lattice are rounded up.
double Judge::rounded_up(double mm) const {
    return off_lattice(mm) > 1e-6 * stated_.unit ? mm + stated_.unit : mm;
}

// Returns the half width of the polygonal tool along x and y. A cylinder has the exact radius. For
// tools whose radius has no suitable divisor, the half width is larger by less than half of the
// square root of the radius, both in units (tool_polytope.h).
double Judge::widest(const RoundTool& tool) const {
    const double r = rounded_up(tool.radius());
    return tool.is_upright() ? r : r + 0.5 * std::sqrt(r * stated_.unit);
}

// On a straight path the trace of a tool has the size of the tool along x, y and z.
bool Judge::is_beyond_box(std::size_t i, const Vec& p_W) const {
    const Course& course = program_.moves[i].course;
    const RoundTool& tool = program_.tools[program_.moves[i].tool];
    if (!course.is_straight() || course.is_turned()) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = course.from().x[axis];
        const double b = course.to().x[axis];
        const double off = std::max(rounding_of(a), rounding_of(b));
        const double down = axis == 2 ? 0.0 : widest(tool);
        const double up = axis == 2 ? rounded_up(tool.height()) : widest(tool);
        if (p_W[axis] < std::min(a, b) - down - off || p_W[axis] > std::max(a, b) + up + off) {
            return true;
        }
    }
    return false;
}

Judge::Effect Judge::effect(std::size_t i, const Vec& p_W) const {
    const Course& course = program_.moves[i].course;
    const RoundTool& tool = program_.tools[program_.moves[i].tool];
    const Allowance& a = allowances_[i];
    if (is_beyond_box(i, p_W)) return Effect::None;
    const auto round = [&tool](const Vec& p_T) { return tool.signed_distance(p_T); };
    if (closest_approach(round, course, p_W, a.beyond()).lower > a.beyond()) return Effect::None;
    if (closest_approach(round, course, p_W, -a.missed).upper < -a.missed) return Effect::Removes;
    // Within the polygon's error of the round tool, but not in the box around the round tool. For a
    // rotary move the tool counts as round, because the orientation of the polygon does not matter
    // then, nor does the truncation of a ball's polygon.
    const double r = widest(tool);
    const double twist = course.twist(0.0);
    const double c = std::cos(twist), s = std::sin(twist);
    const auto polygon = [&](const Vec& p_T) {
        const double beyond = tool.signed_distance(p_T) - a.tool;
        if (course.turns() && tool.is_rounded()) return beyond;
        const double distance = std::max({beyond, -p_T[2], p_T[2] - rounded_up(tool.height())});
        if (course.turns()) return distance;
        return std::max({distance, std::abs(c * p_T[0] - s * p_T[1]) - r,
                         std::abs(s * p_T[0] + c * p_T[1]) - r});
    };
    if (closest_approach(polygon, course, p_W, a.gained).lower > a.gained) return Effect::None;
    return Effect::Perhaps;
}

Verdict Judge::operator()(const Vec& p_W) const {
    if (is_outside_stock(p_W)) return Verdict::Empty;
    bool perhaps = !is_inside_stock(p_W);
    for (std::size_t i = 0; i < program_.moves.size(); ++i) {
        switch (effect(i, p_W)) {
            case Effect::Removes: return Verdict::Empty;
            case Effect::Perhaps: perhaps = true; break;
            case Effect::None: break;
        }
    }
    return perhaps ? Verdict::Open : Verdict::Material;
}

Bounds Judge::distance(std::size_t i, const Vec& p_W) const {
    const Course& course = program_.moves[i].course;
    const RoundTool& tool = program_.tools[program_.moves[i].tool];
    const auto round = [&tool](const Vec& p_T) { return tool.signed_distance(p_T); };
    // Invariant: lower < minimum <= upper.
    Bounds b{-tool.radius(), tool.signed_distance(course.to_tool(0.0, p_W))};
    for (int halvings = 0; halvings < 50 && b.upper - b.lower > 1e-9; ++halvings) {
        const double middle = 0.5 * (b.lower + b.upper);
        const Bounds at = closest_approach(round, course, p_W, middle);
        b = {std::max(b.lower, at.lower), std::min(b.upper, at.upper)};
        if (at.lower <= middle && at.upper > middle) break;
    }
    return b;
}

std::string Judge::explain(const Vec& p_W) const {
    std::string text = name_of((*this)(p_W));
    if (!is_inside_stock(p_W))
        text += is_outside_stock(p_W) ? ", outside the stock" : ", in its surface";
    text += "\n";
    for (std::size_t i = 0; i < program_.moves.size(); ++i) {
        const Bounds b = distance(i, p_W);
        const Allowance& a = allowances_[i];
        if (b.lower > 2 * a.beyond()) continue;
        char buffer[256];
        std::snprintf(buffer, sizeof buffer,
                      "  line %u: distance from the sweep %.9g to %.9g mm; allowed to miss %.3g, "
                      "to gain %.3g, tool %.3g\n",
                      program_.moves[i].line, b.lower, b.upper, a.missed, a.gained, a.tool);
        text += buffer;
    }
    return text;
}

}  // namespace ncsim::nightly
