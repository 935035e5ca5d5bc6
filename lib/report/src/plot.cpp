// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of the ledger as SVG.
#include "plot.h"

#include "append.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace ncsim::report {

namespace {

constexpr double kWidth = 560, kHeight = 184, kLeft = 62, kBottom = 30, kTop = 24, kRight = 12;
constexpr std::size_t kBins = 400;  // bins of about one pixel

// Row of the ledger: interval on the x axis, and removed volume.
struct Span {
    double from = 0.0, to = 0.0, removed = 0.0;
};

struct Course {
    std::vector<Span> spans;
    double length = 0.0;
    bool is_time = true;
};

Course course_of(const verify::Ledger& ledger, LengthUnit unit) {
    const double length = in_unit(1.0, unit), volume = length * length * length;
    Course course;
    // A first move from an unknown position has no length and no time, and removes no material.
    course.is_time = std::ranges::all_of(ledger.rows, [](const verify::LedgerRow& row) {
        return row.seconds.has_value() || row.length_mm <= 0.0;
    });
    for (const verify::LedgerRow& row : ledger.rows) {
        const double step = course.is_time ? row.seconds.value_or(0.0) : length * row.length_mm;
        course.spans.push_back({course.length, course.length + step, volume * row.removed_mm3});
        course.length += step;
    }
    return course;
}

// Returns the largest power of ten that is at most `x`, exactly; 0 for 0.
double decade_below(double x) {
    double whole = 1.0;
    while (whole < 1e300 && 10.0 * whole <= x)
        whole *= 10.0;
    if (whole <= x) return whole;
    double parts = 1.0;
    while (1.0 / parts > x)
        parts *= 10.0;
    return 1.0 / parts;
}

// Returns 1, 2 or 5 times a power of ten, so about four ticks fit into `range`.
double tick_for(double range) {
    const double rough = range / 4;
    const double power = decade_below(rough);
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough) return factor * power;
    }
    return 10 * power;
}

std::string frame(double x_max, double y_max, const std::string& x_name,
                  const std::string& y_name) {
    std::string svg =
        fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\"><title>{} over {}</title>", kWidth,
                    kHeight, y_name, x_name);
    const double w = kWidth - kLeft - kRight;
    const double h = kHeight - kTop - kBottom;
    for (int i = 0; i * tick_for(y_max) <= y_max * 1.0001; ++i) {
        const double y = i * tick_for(y_max);
        const double at = kTop + h * (1 - y / y_max);
        append(svg,
               "<path d=\"M{} {:.1f}h{:.1f}\" stroke=\"#808890\" stroke-opacity=\".3\"/><text "
               "x=\"{}\" "
               "y=\"{:.1f}\" text-anchor=\"end\">{:.6g}</text>",
               kLeft, at, w, kLeft - 5, at + 4, y);
    }
    for (int i = 0; i * tick_for(x_max) <= x_max * 1.0001; ++i) {
        const double x = i * tick_for(x_max);
        append(svg, "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:.6g}</text>",
               kLeft + w * x / x_max, kHeight - 14, x);
    }
    append(svg, "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", kWidth - kRight,
           kHeight - 2, x_name);
    append(svg, "<text x=\"{}\" y=\"{}\">{}</text>", kLeft + 4, kTop - 10, y_name);
    return svg;
}

// Draws values at the ends of equal steps as a line from left to right.
std::string curve(const std::vector<double>& values, double y_max, bool filled) {
    const double w = kWidth - kLeft - kRight;
    const double h = kHeight - kTop - kBottom;
    std::string path;
    if (filled) append(path, "M{} {}", kLeft, kTop + h);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x =
            kLeft + w * static_cast<double>(i) / static_cast<double>(values.size() - 1);
        append(path, "{}{:.1f} {:.1f}", i == 0 && !filled ? "M" : "L", x,
               kTop + h * (1 - values[i] / y_max));
    }
    if (filled) append(path, "L{:.1f} {}Z", kLeft + w, kTop + h);
    return fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"#1c7ed6\" stroke-width=\"1.2\"/></svg>",
                       path, filled ? "#d0ebff" : "none");
}

// Returns the removed volume in each bin.
std::vector<double> bin_volumes(const Course& course) {
    std::vector<double> bins(kBins, 0.0);
    const double width = course.length / static_cast<double>(kBins);
    for (const Span& s : course.spans) {
        if (s.removed <= 0.0 || s.to <= s.from) continue;
        const auto bin_of = [&](double x) {
            return std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0, x / width)));
        };
        for (std::size_t b = bin_of(s.from); b <= bin_of(s.to); ++b) {
            const double low = std::max(s.from, width * static_cast<double>(b));
            const double high = std::min(s.to, width * static_cast<double>(b + 1));
            if (high > low) bins[b] += s.removed * (high - low) / (s.to - s.from);
        }
    }
    return bins;
}

std::string plot(const verify::Ledger& ledger, bool rate, LengthUnit unit) {
    const Course course = course_of(ledger, unit);
    if (course.length <= 0.0 || ledger.removed_mm3 <= 0.0) return {};
    std::vector<double> values = bin_volumes(course);
    const double width = course.length / static_cast<double>(kBins);
    if (rate) {
        for (double& v : values)
            v *= (course.is_time ? 60.0 : 1.0) / width;
    } else {
        double sum = 0.0;
        for (double& v : values)
            v = sum += v;
        values.insert(values.begin(), 0.0);
    }
    const double most = *std::ranges::max_element(values);
    if (most <= 0.0) return {};
    const std::string name(name_of(unit));
    const std::string y_name = !rate            ? "removed, " + name + "³"
                               : course.is_time ? "rate, " + name + "³/min"
                                                : "per path, " + name + "³/" + name;
    return frame(course.length, most, course.is_time ? "time, s" : "path, " + name, y_name) +
           curve(values, most, rate);
}

}  // namespace

std::string removed_plot(const verify::Ledger& ledger, LengthUnit unit) {
    return plot(ledger, false, unit);
}

std::string rate_plot(const verify::Ledger& ledger, LengthUnit unit) {
    return plot(ledger, true, unit);
}

}  // namespace ncsim::report
