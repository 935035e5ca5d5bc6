// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the text below a picture.
#include "run/caption.h"

#include "ncsim/base/file_names.h"
#include "ncsim/report/checked.h"
#include "ncsim/report/describe.h"
#include "ncsim/verify/machining_time.h"

#include "run/sheet_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace ncsim::app {

namespace {

// Returns the text of the line; empty if the program has several files.
std::string line_at(const Outcome& outcome) {
    if (outcome.survey.interpretation.files.size() > 1) return {};
    return std::string(gcode::line_text(outcome.plan.job.program, outcome.simulation->line));
}

// Returns the facts after the path `path`, which removed `removed` mm3.
std::vector<std::string> facts_of(const Outcome& outcome, double removed,
                                  const verify::Distances& path) {
    const simulation::Simulation& s = *outcome.simulation;
    const Vec3 size = outcome.survey.stock->box.size();
    const auto shown = [&](const std::string& text) {
        return report::in_unit(text, outcome.options.report_unit);
    };
    std::string travelled = shown(fmt::format("{:.1f} mm at feed", path.feed_mm));
    if (const auto total = verify::time_of(path).total())
        travelled = verify::time_text(*total) + ", " + travelled;
    std::vector<std::string> lines{
        base_name(outcome.plan.job.program.name) + ": " +
            shown(fmt::format("{:.6g} x {:.6g} x {:.6g} mm", size.x, size.y, size.z)),
        s.stock_volume > 0.0
            ? fmt::format("{} of {} removed ({:.1f} %)", shown(report::volume_text(removed)),
                          shown(report::volume_text(s.stock_volume)),
                          100.0 * removed / s.stock_volume)
            : std::string("nothing is cut"),
        travelled + shown(fmt::format(", {:.1f} mm rapid", path.rapid_mm))};
    const Options& o = outcome.options;
    if (o.views.size() > 1)
        lines.emplace_back(third_angle(o.views).empty() ? "one scale" : "third angle, one scale");
    if (o.cut_view) lines.push_back("cut at " + brep::name_of(*o.cut_view) + " mm");
    return lines;
}

// Returns the line after which the part is shown.
std::string line_of(const Outcome& outcome) {
    const std::uint32_t line = outcome.simulation->line;
    return line == 0 ? std::string("before the first move")
                     : fmt::format("after line {}: {}", line, line_at(outcome));
}

// Adds the assumptions of a preview.
void add_guesses(const Outcome& outcome, std::vector<std::string>& lines) {
    const simulation::Survey& survey = outcome.survey;
    for (const auto& [number, used] : survey.tools) {
        if (used.specified_by == toolpath::ValueSource::Assumption && !survey.only_rapid)
            lines.push_back(fmt::format(
                "guessed: T{} {}", number,
                report::tool_in_unit(describe(used.tool), outcome.options.report_unit)));
    }
    if (survey.stock->specified_by == toolpath::ValueSource::Assumption && !survey.only_rapid)
        lines.push_back("guessed: stock " + report::in_unit(report::describe(*survey.stock),
                                                            outcome.options.report_unit));
    if (survey.units_assumed) {
        lines.emplace_back(survey.interpretation.uses_inches ? "guessed: inches"
                                                             : "guessed: millimetres");
    }
    for (std::size_t axis = 0; axis < survey.unspecified.size(); ++axis) {
        if (survey.unspecified[axis]) lines.push_back(fmt::format("guessed: {} 0", "XYZ"[axis]));
    }
}

// Adds the result of the comparison with the design, and the numbered places.
void add_design(const Outcome& outcome, std::vector<std::string>& lines) {
    const auto shown = [&](const std::string& text) {
        return report::in_unit(text, outcome.options.report_unit);
    };
    lines.push_back(shown(report::text_of(outcome.design->facts)));
    const auto places = report::largest(outcome.design->places, kMostDesignPlaces);
    for (std::size_t i = 0; i < places.size(); ++i)
        lines.push_back(fmt::format("{}  {}", i + 1, shown(report::text_of(places[i]))));
}

// Adds a finding with its line.
void add_finding(const Outcome& outcome, std::vector<std::string>& lines) {
    const verify::Finding& f = *outcome.finding;
    std::string text = base_name(outcome.plan.job.program.name);
    const bool has_line = f.place.file == 0 && f.place.span.line > 0;
    if (has_line) text += fmt::format(":{}", f.place.span.line);
    text += fmt::format(": {}: {} [{}]", verify::name_of(f.severity),
                        report::in_unit(report::headline(f), outcome.options.report_unit), f.rule);
    lines.push_back(std::move(text));
    if (!has_line) return;
    lines.emplace_back(gcode::line_text(outcome.plan.job.program, f.place.span.line));
}

// Divides lines into rows that fit.
class Rows {
public:
    explicit Rows(const Options& options)
        : width_(options.width * columns_of(options.views)), height_(options.height) {}

    void add(const std::string& line) {
        std::ranges::move(wrapped(line), std::back_inserter(rows_));
    }
    void add(const std::vector<std::string>& lines) {
        for (const std::string& line : lines)
            add(line);
    }
    // Adds as many rows as the line `most` needs.
    void add_like(const std::string& most, const std::string& line) {
        const std::size_t count = wrapped(most).size();
        std::vector<std::string> rows = wrapped(line);
        for (; rows.size() > count; rows.pop_back())
            rows[rows.size() - 2] += " " + rows.back();
        rows.resize(count);
        std::ranges::move(rows, std::back_inserter(rows_));
    }
    // Adds a row, which may be too long.
    void add_row(const std::string& line) { rows_.push_back(line); }
    std::vector<std::string> take() { return std::move(rows_); }

private:
    std::vector<std::string> wrapped(const std::string& line) const {
        return exporter::wrapped(line, width_, height_);
    }

    std::uint32_t width_, height_;
    std::vector<std::string> rows_;
};

// Adds the facts and the line. All frames of a film have the same size, so in films the facts have
// the rows that are necessary after the whole program, and the line has a single row.
void add_facts(const Outcome& outcome, Rows& rows) {
    const simulation::Simulation& s = *outcome.simulation;
    const std::vector<std::string> facts =
        facts_of(outcome, s.stock_volume - s.part_volume, s.distances);
    if (!has_frames(outcome.options)) {
        rows.add(facts);
        if (outcome.options.at_line) rows.add(line_of(outcome));
        return;
    }
    const std::vector<std::string> most =
        facts_of(outcome, s.stock_volume, verify::total(outcome.survey.distances));
    for (std::size_t i = 0; i < facts.size(); ++i)
        rows.add_like(most[i], facts[i]);
    rows.add_row(line_of(outcome));
}

}  // namespace

std::vector<std::string> caption_of(const Outcome& outcome) {
    const Options& o = outcome.options;
    Rows rows(o);
    if (o.views.size() > 1 || o.has_caption) add_facts(outcome, rows);
    std::vector<std::string> more;
    if (o.draft) add_guesses(outcome, more);
    if (outcome.design) add_design(outcome, more);
    if (outcome.finding) add_finding(outcome, more);
    rows.add(more);
    return rows.take();
}

}  // namespace ncsim::app
