// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the table of values of two programs.
#include "review_table.h"

#include "ncsim/verify/machining_time.h"

#include "append.h"
#include "markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace ncsim::report {

namespace {

// Differences below this share are rounding.
constexpr double kRounding = 1e-9;
constexpr double kLeastPercent = 0.05;

std::string volume_text_mm3(double mm3) {
    return fmt::format("{:.6g} mm3", mm3);
}
std::string path_text(double mm) {
    return fmt::format("{:.1f} mm", mm);
}
std::string path_change_text(double mm) {
    return fmt::format("{:.3g} mm", mm);
}
std::string time_change_text(double seconds) {
    return seconds < 60.0 ? fmt::format("{:.3g} s", seconds) : verify::time_text(seconds);
}
std::string count_text(double count) {
    return fmt::format("{:.0f}", count);
}

// Texts of a value and of a change; smaller changes than `least` do not count.
struct Quantity {
    std::string (*text)(double);
    std::string (*change)(double);
    double least = 0.0;
};
constexpr Quantity kVolume{volume_text_mm3, volume_text_mm3};
constexpr Quantity kTime{verify::time_text, time_change_text, 1e-3};
constexpr Quantity kPath{path_text, path_change_text, 1e-3};
constexpr Quantity kCount{count_text, count_text};

class Table {
public:
    explicit Table(LengthUnit unit) : unit_(unit) {}

    void put_text(const std::string& name, const std::string& before, const std::string& after) {
        put(name, before, after, before == after ? "" : "changed", before != after);
    }

    // Adds a row of numbers; empty: not known.
    void put_number(const std::string& name, std::optional<double> before,
                    std::optional<double> after, const Quantity& quantity) {
        const auto shown = [&](const std::optional<double>& value) {
            return value ? quantity.text(*value) : std::string("unknown");
        };
        std::string change;
        bool differs = before.has_value() != after.has_value();
        if (before && after) {
            const double difference = *after - *before;
            const double most = std::max(std::abs(*before), std::abs(*after));
            differs = std::abs(difference) > std::max(quantity.least, kRounding * most);
            if (differs)
                change = (difference > 0 ? "+" : "-") + quantity.change(std::abs(difference));
            const double percent = *before > 0 ? 100.0 * difference / *before : 0.0;
            if (differs && std::abs(percent) >= kLeastPercent)
                change += fmt::format(" ({:+.1f} %)", percent);
        }
        put(name, shown(before), shown(after), change, differs);
    }

    void put_heading(const std::string& name) {
        append(rows_, "<tr><th colspan=\"4\" scope=\"rowgroup\" class=\"tool\">{}</th></tr>\n",
               escaped(name));
    }

    std::string html() const {
        return "<table class=\"values\"><thead><tr><td></td><th scope=\"col\">before</th>"
               "<th scope=\"col\">after</th><th scope=\"col\">change</th></tr></thead>\n<tbody>\n" +
               rows_ + "</tbody></table>\n";
    }

private:
    void put(const std::string& name, const std::string& before, const std::string& after,
             const std::string& change, bool differs) {
        append(rows_, "<tr{}><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
               differs ? " class=\"differs\"" : "", name, escaped(in_unit(before, unit_)),
               escaped(in_unit(after, unit_)), escaped(in_unit(change, unit_)));
    }

    LengthUnit unit_;
    std::string rows_;
};

verify::Distances distances_of(const simulation::ReviewSide& side) {
    std::map<int, verify::Distances> all;
    for (const auto& [number, tool] : side.tools)
        all.emplace(number, tool.distances);
    return verify::total(all);
}

void put_program(Table& table, const simulation::Review& review) {
    const verify::Distances before = distances_of(review.old_side);
    const verify::Distances after = distances_of(review.new_side);
    table.put_number("volume of the part", review.difference.old_mm3, review.difference.new_mm3,
                     kVolume);
    table.put_number("time", time_of(before).total(), time_of(after).total(), kTime);
    table.put_number("feed path", before.feed_mm, after.feed_mm, kPath);
    table.put_number("rapid path", before.rapid_mm, after.rapid_mm, kPath);
    table.put_number("tool changes", static_cast<double>(before.tool_changes),
                     static_cast<double>(after.tool_changes), kCount);
    if (before.dwell_seconds > 0.0 || after.dwell_seconds > 0.0)
        table.put_number("dwells", before.dwell_seconds, after.dwell_seconds, kTime);
}

void put_tool(Table& table, int number, const simulation::ReviewTool* before,
              const simulation::ReviewTool* after, LengthUnit unit) {
    table.put_heading(fmt::format("T{}", number));
    const auto text = [&](const char* name, std::string simulation::ReviewTool::*member) {
        table.put_text(name, before ? before->*member : std::string(),
                       after ? after->*member : std::string());
    };
    table.put_text("shape", before ? tool_in_unit(before->shape, unit) : "not used",
                   after ? tool_in_unit(after->shape, unit) : "not used");
    text("feed", &simulation::ReviewTool::feed);
    text("spindle", &simulation::ReviewTool::spindle);
    text("coolant", &simulation::ReviewTool::coolant);
    const verify::Distances none;
    const verify::Distances& a = before ? before->distances : none;
    const verify::Distances& b = after ? after->distances : none;
    table.put_number("feed path", a.feed_mm, b.feed_mm, kPath);
    table.put_number("time", time_of(a).total(), time_of(b).total(), kTime);
}

}  // namespace

std::string review_table(const simulation::Review& review, LengthUnit unit) {
    Table table(unit);
    put_program(table, review);
    std::set<int> numbers;
    for (const simulation::ReviewSide* side : {&review.old_side, &review.new_side}) {
        for (const auto& [number, tool] : side->tools) {
            if (!tool.shape.empty()) numbers.insert(number);
        }
    }
    const auto find = [](const simulation::ReviewSide& side, int number) {
        const auto found = side.tools.find(number);
        return found == side.tools.end() ? nullptr : &found->second;
    };
    for (const int number : numbers)
        put_tool(table, number, find(review.old_side, number), find(review.new_side, number), unit);
    return table.html();
}

}  // namespace ncsim::report
