// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the ledger of a page.
#include "page_ledger.h"

#include "ncsim/report/design_facts.h"

#include "append.h"
#include "ledger_operations.h"
#include "markup.h"
#include "plot.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace ncsim::report {

namespace {

std::string clock_text(double seconds) {
    const auto whole = static_cast<long>(std::lround(seconds));
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string seconds_text(const std::optional<double>& seconds) {
    return seconds ? clock_text(*seconds) : "unknown: rates are not specified";
}

std::string operations_html(const Checked& checked, LengthUnit unit) {
    const std::vector<LedgerOperation> operations = ledger_operations(checked);
    if (operations.empty()) return {};
    const bool is_measured = checked.verdict.ledger.measured;
    std::string text =
        "<table>\n<tr><th>line</th><th>operation</th><th>tool</th><th>feed path</th>"
        "<th>feed time</th>";
    text += is_measured ? "<th>removed</th></tr>\n" : "</tr>\n";
    for (const LedgerOperation& sum : operations) {
        append(text, "<tr><td>{}</td><td>{}</td><td>T{}</td><td>{}</td><td>{}</td>",
               sum.operation.line > 0 ? std::to_string(sum.operation.line) : "",
               escaped(sum.operation.name), sum.operation.tool,
               in_unit(fmt::format("{:.6g} mm", sum.feed_mm), unit),
               sum.seconds ? clock_text(*sum.seconds) : "?");
        if (is_measured)
            append(text, "<td>{}</td>", in_unit(fmt::format("{:.6g} mm³", sum.removed_mm3), unit));
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

}  // namespace

std::string ledger_html(const Checked& checked, LengthUnit unit) {
    const verify::Ledger& l = checked.verdict.ledger;
    std::string text = "<section><h2>Ledger</h2>\n";
    text += removed_plot(l, unit);
    text += rate_plot(l, unit);
    const auto row = [&](const char* name, const std::string& value) {
        append(text, "<tr><th>{}</th><td>{}</td></tr>\n", name, escaped(in_unit(value, unit)));
    };
    text += "<table>\n";
    if (checked.simulated) {
        row("stock", fmt::format("{:.6g} mm³", l.stock_mm3));
        if (l.measured) row("removed", fmt::format("{:.9g} mm³", l.removed_mm3));
        row("rest", fmt::format("{:.9g} mm³", l.rest_mm3));
        if (l.measured) {
            row("self-check",
                fmt::format("removed + rest - stock = {:.2g} of the stock", l.imbalance()));
        }
        if (l.air_known && l.feed_mm > 0.0) {
            row("air", fmt::format("{:.3g} % of the feed path", 100 * l.air_mm / l.feed_mm));
        }
    }
    if (checked.design) row("design", text_of(*checked.design));
    row("feed", fmt::format("{:.6g} mm, {}", l.feed_mm, seconds_text(l.feed_seconds)));
    row("rapid", fmt::format("{:.6g} mm, {}", l.rapid_mm, seconds_text(l.rapid_seconds)));
    text += "</table>\n";
    text += operations_html(checked, unit);
    return text + "</section>\n";
}

}  // namespace ncsim::report
