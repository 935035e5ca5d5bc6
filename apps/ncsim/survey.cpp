// SPDX-License-Identifier: GPL-3.0-or-later
#include "survey.h"

#include "ncsim/toolpath/machine.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::app {

namespace {

using gcode::Diagnostic;
using gcode::Severity;
using toolpath::ToldBy;

// No machine is that large: then a unit is wrong, or a number.
constexpr double kLargestStock = 1e5;

void tell(Survey& survey, Severity severity, const char* code, std::string message,
          gcode::SourceSpan span) {
    Diagnostic d;
    d.severity = severity;
    d.code = code;
    d.message = std::move(message);
    d.span = span;
    survey.diagnostics.push_back(std::move(d));
}

std::optional<double> sum(std::optional<double> a, std::optional<double> b) {
    return a && b ? std::optional(*a + *b) : std::nullopt;
}

// Of a move at its feed all the way; `length` in mm. Turns of rotary axes alone go by degrees.
std::optional<double> seconds_of(const gcode::Motion& motion, double length) {
    if (!(motion.feed > 0.0)) return std::nullopt;
    if (motion.feed_mode == gcode::FeedMode::InverseTime) return 60.0 / motion.feed;
    if (length == 0.0) {
        const gcode::Position* from = start_of(motion);
        const gcode::Position* to = end_of(motion);
        length = norm(cda::Vec3{to->a.degrees(), to->b.degrees(), to->c.degrees()} -
                      cda::Vec3{from->a.degrees(), from->b.degrees(), from->c.degrees()});
    }
    if (motion.feed_mode == gcode::FeedMode::PerMinute) return 60.0 * length / motion.feed;
    if (!(motion.spindle_rpm > 0.0)) return std::nullopt;
    return 60.0 * length / (motion.feed * motion.spindle_rpm);
}

toolpath::Samples coarse_samples(const gcode::Motion& motion) {
    toolpath::SamplingOptions coarse;
    coarse.chord_tolerance_mm = 0.01;
    coarse.rotation_miss_mm = 0.5;
    return toolpath::sample(motion, {}, coarse);
}

void add_length(Distances& distances, const gcode::Motion& motion,
                const toolpath::Samples& samples) {
    double length = 0.0;
    for (std::size_t i = 1; i < samples.poses.size(); ++i)
        length += norm(samples.poses[i].translation - samples.poses[i - 1].translation);
    if (motion.kind == gcode::MoveKind::Rapid) {
        distances.rapid_mm += length;
        return;
    }
    distances.feed_mm += length;
    distances.feed_seconds = sum(distances.feed_seconds, seconds_of(motion, length));
}

// What the motions alone tell, gathered in one pass.
class MotionSurvey {
public:
    explicit MotionSurvey(Survey& result) : result_(result) {}

    struct ToolTrack {
        gcode::SourceSpan first;
        cda::Box cutting_tips;  // ends of feed moves, mm
        double highest_tip = -std::numeric_limits<double>::infinity();
    };

    void take(const gcode::Motion& motion) {
        const gcode::Position* from = start_of(motion);
        const gcode::Position* to = end_of(motion);
        if (!from || !to) return;
        if (result_.moves++ == 0) result_.first_move = motion.span;
        const bool feed = motion.kind == gcode::MoveKind::Feed;
        if (feed) ++result_.feed_moves;
        result_.uses_machine_coordinates |= motion.machine_coordinates;
        result_.turns_tools |=
            to->a.degrees() != 0.0 || to->b.degrees() != 0.0 || to->c.degrees() != 0.0;
        if (!toolpath::has_known_start(motion)) {
            ++result_.moves_from_nowhere;
            if (feed && !result_.cuts_from_nowhere) {
                result_.cuts_from_nowhere = true;
                first_cut_from_nowhere_ = motion.span;
            }
            return;
        }
        const auto [track, is_new] = tracks_.try_emplace(motion.tool);
        if (is_new) track->second.first = motion.span;

        const toolpath::Samples samples = coarse_samples(motion);
        for (std::size_t i = 0; i < samples.poses.size(); ++i) {
            const cda::Vec3 p = samples.poses[i].translation;
            result_.tip_positions.add(p);
            if (!feed) continue;
            track->second.cutting_tips.add(p);
            if (i > 0) track->second.highest_tip = std::max(track->second.highest_tip, p.z);
        }
        add_length(result_.distances[motion.tool], motion, samples);
    }

    const std::map<int, ToolTrack>& tracks() const { return tracks_; }
    gcode::SourceSpan first_cut_from_nowhere() const { return first_cut_from_nowhere_; }

private:
    Survey& result_;
    std::map<int, ToolTrack> tracks_;
    gcode::SourceSpan first_cut_from_nowhere_;
};

double lowest_tip(const MotionSurvey& motions) {
    double z = std::numeric_limits<double>::infinity();
    for (const auto& [number, track] : motions.tracks()) {
        if (!track.cutting_tips.is_empty()) z = std::min(z, track.cutting_tips.min.z);
    }
    return z;
}

// A cutting length that is more than the depth of any cut: nothing may be left standing above a
// tool only because nobody said how long it is. Whole centimetres, for the reader.
double assumed_length(const Survey& survey, const MotionSurvey& motions,
                      const std::optional<toolpath::StockEntry>& stock) {
    double depth = 0.0;
    const double low = lowest_tip(motions);
    const double top = stock ? stock->box.max.z : std::max(0.0, low);
    if (low < top) depth = top - low;
    if (survey.turns_tools && stock) depth = norm(stock->box.size());
    return 10.0 * std::ceil((std::clamp(depth, 20.0, kLargestStock) + 10.0) / 10.0);
}

// Which description belongs to this tool number?
const toolpath::ToolEntry* entry_for(const Job& job, int number, bool is_only_tool) {
    if (const auto* entry = toolpath::find_tool(job.tools, number)) return entry;
    // A program that never calls a tool, and one tool that somebody describes: it is that one.
    if (number == 0 && is_only_tool && job.tools.size() == 1) return &job.tools.front();
    return nullptr;
}

void choose_tools(const Job& job, const MotionSurvey& motions, Survey& result) {
    const double length = assumed_length(result, motions, job.stock);
    for (const auto& [number, track] : motions.tracks()) {
        UsedTool used;
        used.first = track.first;
        toolpath::ToolSpec spec;
        if (const auto* entry = entry_for(job, number, motions.tracks().size() == 1)) {
            spec = entry->spec;
            used.told_by = entry->told_by;
            used.span = entry->span;
            used.text = entry->text;
            used.file = entry->file;
        } else if (track.cutting_tips.is_empty()) {
            continue;  // only positioned: what it looks like does not matter
        } else if (job.options.assumed_tool) {
            spec = *job.options.assumed_tool;
            used.told_by = ToldBy::Assumption;
            used.text = spec.description;
        } else {
            const std::string how =
                number == 0
                    ? "no tool is called before this cut; describe one with --assume-tool flat:D10"
                    : fmt::format(
                          "tool {0} is not described; say what it is with --tool T{0}=flat:D10 "
                          "or in a comment such as (T{0} D=10. CR=0. - flat end mill)",
                          number);
            tell(result, Severity::Error, "tool-unknown", how, track.first);
            result.ready = false;
            result.unknown_tools.emplace(number, track.first);
            continue;
        }
        spec.number = number;
        used.spec = toolpath::filled(spec, length);
        used.filled_in = toolpath::filled_in(spec, length);
        used.tool = toolpath::make_tool(spec, length);
        result.tools.emplace(number, std::move(used));
    }
}

void choose_stock(const Job& job, const MotionSurvey& motions, Survey& result) {
    result.stock = job.stock;
    if (result.stock) return;
    cda::Box swept;
    double highest = -std::numeric_limits<double>::infinity();
    for (const auto& [number, track] : motions.tracks()) {
        const auto used = result.tools.find(number);
        if (used == result.tools.end() || track.cutting_tips.is_empty()) continue;
        const double r = toolpath::cutting_diameter_of(used->second.tool) / 2;
        const double height = toolpath::cutting_height_of(used->second.tool);
        swept.add(track.cutting_tips.min - cda::Vec3{r, r, 0});
        swept.add(track.cutting_tips.max + cda::Vec3{r, r, height});
        highest = std::max(highest, track.highest_tip);
    }
    const toolpath::DerivedStock derived = toolpath::derive_stock(swept, highest);
    if (derived.box.is_empty()) return;
    result.stock = toolpath::StockEntry{{derived.box}, ToldBy::Assumption, {}, derived.rule};
}

}  // namespace

void add(Distances& distances, const gcode::Motion& motion) {
    if (start_of(motion) && toolpath::has_known_start(motion))
        add_length(distances, motion, coarse_samples(motion));
}

Distances total_distances(const Survey& survey) {
    Distances total;
    for (const auto& [number, d] : survey.distances) {
        total.rapid_mm += d.rapid_mm;
        total.feed_mm += d.feed_mm;
        total.feed_seconds = sum(total.feed_seconds, d.feed_seconds);
    }
    return total;
}

Survey survey(const Job& job) {
    Survey result;
    MotionSurvey motions(result);
    result.interpretation = gcode::interpret(job.program, job.interpreter,
                                             [&](const gcode::Motion& m) { motions.take(m); });
    result.diagnostics = result.interpretation.diagnostics;
    result.diagnostics.insert(result.diagnostics.end(), job.diagnostics.begin(),
                              job.diagnostics.end());

    if (result.interpretation.refused) return result;  // and the interpreter said why
    result.ready = true;
    if (result.feed_moves == 0) {
        tell(result, Severity::Error, "no-motion",
             result.moves == 0 ? "the program makes no move"
                               : "the program makes no cutting move, only rapid ones",
             result.first_move);
        result.ready = false;
        return result;
    }
    if (result.cuts_from_nowhere) {
        tell(result, Severity::Warning, "start-unknown",
             "this cutting move starts at a place that the program does not tell; it leaves no "
             "trace",
             motions.first_cut_from_nowhere());
    }
    choose_tools(job, motions, result);
    if (!result.ready) return result;
    choose_stock(job, motions, result);
    if (!result.stock) {
        tell(result, Severity::Error, "no-motion",
             "no cutting move starts at a place that the program tells", result.first_move);
        result.ready = false;
        return result;
    }
    const cda::Box& box = result.stock->box;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::max(std::abs(box.min[axis]), std::abs(box.max[axis])) > kLargestStock) {
            tell(
                result, Severity::Error, "stock-size",
                fmt::format(
                    "the stock would reach from {:.6g} to {:.6g} mm: is a unit wrong, or a number? "
                    "Say what the block is with --stock",
                    box.min[axis], box.max[axis]),
                result.stock->span);
            result.ready = false;
            break;
        }
    }
    return result;
}

}  // namespace ncsim::app
