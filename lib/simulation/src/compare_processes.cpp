// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of feed, spindle, coolant and dwells of two programs.
#include "compare_processes.h"

#include "motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ncsim::simulation {

namespace {

/// Conditions of a feed move or a dwell.
struct Condition {
    double dwell_s = 0.0;  ///< Seconds of a dwell; 0 for feed moves.
    int tool = 0;
    gcode::FeedMode feed_mode = gcode::FeedMode::PerMinute;
    double feed = 0.0;
    gcode::SpindleTurning spindle = gcode::SpindleTurning::Stopped;
    double rpm = 0.0;
    gcode::Coolant coolant;
    std::uint32_t file = 0, line = 0;  ///< Place of the first block.
};

// True if equal except for the rounding of values in inches.
bool is_nearly_equal(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

bool same(const Condition& a, const Condition& b) {
    return is_nearly_equal(a.dwell_s, b.dwell_s) && a.tool == b.tool &&
           a.feed_mode == b.feed_mode && is_nearly_equal(a.feed, b.feed) &&
           a.spindle == b.spindle && is_nearly_equal(a.rpm, b.rpm) && a.coolant == b.coolant;
}

Condition condition_of(const gcode::Motion& m) {
    Condition c;
    c.tool = m.tool;
    c.spindle = m.spindle;
    if (m.spindle != gcode::SpindleTurning::Stopped) c.rpm = m.spindle_rpm;
    c.coolant = m.coolant;
    c.file = m.file;
    c.line = m.span.line;
    if (const auto* dwell = std::get_if<gcode::Dwell>(&m.action)) {
        c.dwell_s = dwell->seconds;
    } else {
        c.feed_mode = m.feed_mode;
        c.feed = m.feed;
    }
    return c;
}

std::vector<Condition> conditions_of(const Plan& plan) {
    std::vector<Condition> all;
    for_each_motion(plan, [&](const gcode::Motion& m) {
        const bool dwells = std::holds_alternative<gcode::Dwell>(m.action);
        if (!dwells && (!gcode::start_of(m) || m.kind == gcode::MoveKind::Rapid)) return;
        const Condition c = condition_of(m);
        if (all.empty() || dwells || !same(all.back(), c)) all.push_back(c);
    });
    return all;
}

std::string_view unit_of(gcode::FeedMode mode) {
    switch (mode) {
        case gcode::FeedMode::InverseTime: return "1/min";
        case gcode::FeedMode::PerRevolution: return "mm/rev";
        case gcode::FeedMode::PerMinute: break;
    }
    return "mm/min";
}

std::string_view words_for(const gcode::Coolant& coolant) {
    return coolant.mist && coolant.flood ? "M7 M8"
           : coolant.mist                ? "M7"
           : coolant.flood               ? "M8"
                                         : "off";
}

std::string_view word_for(gcode::SpindleTurning turning) {
    return turning == gcode::SpindleTurning::Clockwise ? "M3" : "M4";
}

std::string words_for(const Condition& c) {
    std::string text = fmt::format("T{}, ", c.tool);
    text += c.dwell_s > 0.0 ? fmt::format("dwell {:.6g} s", c.dwell_s)
                            : fmt::format("feed {:.6g} {}", c.feed, unit_of(c.feed_mode));
    if (c.spindle == gcode::SpindleTurning::Stopped) {
        text += ", spindle stopped";
    } else {
        text += fmt::format(", spindle {} {:.6g} rpm", word_for(c.spindle), c.rpm);
    }
    return text + ", coolant " + std::string(words_for(c.coolant));
}

using ConditionIterator = std::vector<Condition>::const_iterator;

std::vector<ProcessDifference::Run> runs_of(ConditionIterator first, ConditionIterator last,
                                            const Plan& plan, const Survey& survey) {
    std::vector<ProcessDifference::Run> runs;
    for (; first != last; ++first) {
        const auto& files = survey.interpretation.files;
        runs.push_back({first->file < files.size() && first->file != 0 ? files[first->file]
                                                                       : plan.job.program.name,
                        first->line, words_for(*first)});
    }
    return runs;
}

// Smallest and largest value.
struct ValueRange {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    std::string text() const {
        if (is_nearly_equal(least, most)) return fmt::format("{:.6g}", most);
        return fmt::format("{:.6g} to {:.6g}", least, most);
    }
};

// Values of the feed moves of a tool.
struct ToolValues {
    std::map<gcode::FeedMode, ValueRange> feeds;
    std::map<gcode::SpindleTurning, ValueRange> speeds;
    std::set<std::string_view> coolants;
};

void append_part(std::string& text, const std::string& part) {
    text += (text.empty() ? "" : ", ") + part;
}

ToolProcess text_of(const ToolValues& values) {
    ToolProcess process;
    for (const auto& [mode, feeds] : values.feeds)
        append_part(process.feed, feeds.text() + ' ' + std::string(unit_of(mode)));
    for (const auto& [turning, speeds] : values.speeds) {
        append_part(process.spindle,
                    turning == gcode::SpindleTurning::Stopped
                        ? "stopped"
                        : fmt::format("{} {} rpm", word_for(turning), speeds.text()));
    }
    for (const std::string_view coolant : values.coolants)
        append_part(process.coolant, std::string(coolant));
    return process;
}

}  // namespace

std::map<int, ToolProcess> processes_by_tool(const Plan& plan) {
    std::map<int, ToolValues> values;
    for (const Condition& c : conditions_of(plan)) {
        if (c.dwell_s > 0.0) continue;
        ToolValues& of_tool = values[c.tool];
        of_tool.feeds[c.feed_mode].add(c.feed);
        of_tool.speeds[c.spindle].add(c.rpm);
        of_tool.coolants.insert(words_for(c.coolant));
    }
    std::map<int, ToolProcess> processes;
    for (const auto& [tool, of_tool] : values)
        processes.emplace(tool, text_of(of_tool));
    return processes;
}

ProcessDifference compare_processes(const Plan& old_plan, const Survey& old_survey,
                                    const Plan& new_plan, const Survey& new_survey) {
    const std::vector<Condition> a = conditions_of(old_plan);
    const std::vector<Condition> b = conditions_of(new_plan);
    const auto [front_a, front_b] = std::ranges::mismatch(a, b, same);
    ConditionIterator back_a = a.end(), back_b = b.end();
    while (back_a != front_a && back_b != front_b && same(*(back_a - 1), *(back_b - 1))) {
        --back_a;
        --back_b;
    }
    return {runs_of(front_a, back_a, old_plan, old_survey),
            runs_of(front_b, back_b, new_plan, new_survey)};
}

}  // namespace ncsim::simulation
