// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/verifier.h"

#include "ncsim/gcode/state.h"
#include "ncsim/toolpath/extent.h"
#include "ncsim/toolpath/machine.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/trig/angles.h"
#include "ncsim/verify/rule.h"

#include "air_cut.h"
#include "body.h"
#include "clock.h"
#include "finding_log.h"
#include "fixture.h"
#include "ledger_book.h"
#include "machine_scene.h"
#include "measuring.h"
#include "rule_table.h"
#include "watched.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ncsim::verify {

using cda::Box;
using cda::Cell;
using cda::Vec3;
using gcode::MoveKind;
using toolpath::Step;

namespace {

// Straight down along an axis that is upright.
bool falls_straight(const Step& step) {
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    return is_upright(step) && way.x == 0.0 && way.y == 0.0 && way.z < 0.0;
}

// Of an arc, which may be a spiral; mm.
double smallest_radius(const gcode::Arc& told) {
    const gcode::Arc arc = gcode::in_own_frame(told);
    const auto radius = [&arc](const gcode::Position& p) {
        double first = p.x.mm(), second = p.y.mm();
        switch (arc.plane) {
            case gcode::Plane::XY: break;
            case gcode::Plane::ZX: first = p.z.mm(), second = p.x.mm(); break;
            case gcode::Plane::YZ: first = p.y.mm(), second = p.z.mm(); break;
            case gcode::Plane::UV: first = p.u.mm(), second = p.v.mm(); break;
            case gcode::Plane::WU: first = p.w.mm(), second = p.u.mm(); break;
            case gcode::Plane::VW: first = p.v.mm(), second = p.w.mm(); break;
        }
        first -= arc.centre_1.mm();
        second -= arc.centre_2.mm();
        return std::sqrt(first * first + second * second);
    };
    return std::min(radius(arc.from), radius(arc.to));
}

// As most tools want it; what else is there is worth a closer look.
bool turns_well(const gcode::Motion& motion, bool left_hand) {
    const auto right_way =
        left_hand ? gcode::SpindleTurning::Counterclockwise : gcode::SpindleTurning::Clockwise;
    return motion.spindle == right_way && motion.spindle_rpm > 0.0;
}

// Does a rule ask how much every step removes?
bool needs_volumes(const Setup& setup) {
    const auto asked = [&](std::string_view rule) { return setup.selection.includes(rule); };
    return (asked("engagement-limit") && !needs_engagement_limit(setup)) ||
           (asked("removal-rate") && !needs_removal_limit(setup));
}

}  // namespace

toolpath::Watch watch_of(const Setup& setup) {
    toolpath::Watch watch;
    watch.shanks = true;
    for (const Fixture& f : setup.machine.fixtures)
        watch.place.add(f.place());
    return watch;
}

class Verifier::Impl {
public:
    Impl(Setup setup, const Box& stock, const cda::Lattice& lattice, Share share)
        : setup_(std::move(setup)),
          stock_(stock),
          lattice_(lattice),
          share_(std::move(share)),
          log_(setup_),
          scene_(setup_),
          machine_(setup_, stock_, share_),
          clock_(setup_.machine),
          volumes_(needs_volumes(setup_)),
          books_(setup_.ledger && !volumes_),
          measuring_(setup_, stock_, lattice_, move_, volumes_),
          ledger_book_(ledger_, stock_) {
        for (const Rule& rule : rule_table()) {
            if (!asked(rule.info.id)) continue;
            if (rule.missing) {
                if (auto reason = rule.missing(setup_)) {
                    skipped_.push_back({std::string(rule.info.id), std::move(*reason)});
                }
            }
            if (rule.judge) judges_.push_back(rule.judge);
        }
        contacts_ = volumes_ || (asked("air-cut") && setup_.air_cuts);
        if (!stock_.is_empty()) highest_ = stock_.max.z;
        for (const Fixture& fixture : setup_.machine.fixtures)
            highest_ = std::max(highest_, fixture.place().max.z);
        needs_part_ = needs_part(setup_);
        if (setup_.not_simulated) return;
        for (const auto& [number, facts] : setup_.tools) {
            watched_.emplace(number, watch(facts, setup_.selection, lattice_, setup_.accuracy));
        }
    }

    void set_frame(const gcode::ProgramFrame& frame) {
        const double unit = frame.inches ? 25.4 : 1.0;
        tool_offset_ = {unit * frame.tool_offset[gcode::kX], unit * frame.tool_offset[gcode::kY],
                        unit * frame.tool_offset[gcode::kZ]};
        frame_ = frame;
    }

    void begin(const gcode::Motion& motion, const cda::WorkpieceModel* part) {
        move_ = {};
        ledger_book_.begin();
        move_.motion = &motion;
        move_.number = ++motions_;
        const auto* from = gcode::start_of(motion);
        const auto* to = gcode::end_of(motion);
        move_.is_move = from && to;
        move_.after_probe = probed_;
        probed_ |= motion.kind == MoveKind::Probe;
        if (!move_.is_move) return;
        if (!share_.tile) {
            measure_path(motion, *from, *to);
            move_.passes_above = passes_above(motion, *from, *to);
            look_at_length(motion, *from, *to);
        } else if (part && !place_) {
            place_ = part->wanted().value_or(stock_);
            measuring_.keep(evidence_, *place_);
        }
        const auto watched = watched_.find(motion.tool);
        now_ = watched == watched_.end() ? nullptr : &watched->second;
        measuring_.begin(now_);
        move_.is_traced = now_ && toolpath::has_known_start(motion);
        look_at_spindle(motion);
        move_.asked = move_.is_traced && asks(motion);
        const bool is_fault =
            motion.kind == MoveKind::Rapid || !turns_well(motion, is_left_handed(motion.tool));
        move_.volume_known = move_.asked && (volumes_ || is_fault);
        if (!share_.tile) doubt_what_is_guessed();
        if (machine_.is_empty()) return;
        machine_.begin(motion, tool_length(motion), part, move_.machine);
        keep_links(0);
        if (share_.tile) return;
        if (machine_.misses_length()) doubt_length(motion);
        if (is_turned(motion) && !setup_.axes_guess.empty())
            log_.doubt("kinematics-guess",
                       "links are where they are taken to be: " + setup_.axes_guess, place());
    }

    void look(const Step& step, const cda::WorkpieceModel& part) {
        measuring_.begin_step();
        if (share_.evidence) {
            note_step(&step);
            return;
        }
        if (ascends(step)) measuring_.meet_bodies(step, part);
        if (now_->core) {
            if (move_.motion->kind == MoveKind::Feed) {
                measuring_.meet_core(step, part);
            } else {
                now_->aside_since.reset();
            }
        }
        if (!now_->too_high.bodies.empty() && move_.motion->kind == MoveKind::Feed)
            measuring_.meet_too_high(step, part);
        const bool goes_on = has_cut_at(step.X_WA);
        const bool only_up = goes_on && goes_back_up(step);
        // Going straight down, what is certain cuts ahead of what is not.
        const bool only_down =
            goes_on && now_->straight_from_mm <= now_->uncertain.from_mm && falls_straight(step);
        if (!now_->uncertain.bodies.empty() && !only_up && !only_down && !is_found_rapid())
            measuring_.meet_uncertain(step, part);
        if (books_) ledger_book_.note_cells(step, measuring_.rounding_now(step));
        if (!move_.asked || step.cells.empty()) return;
        if (move_.motion->kind == MoveKind::Rapid) {
            if (!only_up || volumes_) measuring_.meet_rapidly(step, part);
        } else if (!volumes_ || measuring_.rounding_now(step) > 0.0) {
            // One step that meets material answers for its motion, if nobody asks how much it is.
            measuring_.meet_at_feed(step, part);
        }
    }

    void look_back(const Step& step, const cda::WorkpieceModel& part, double removed) {
        const double tolerance = setup_.path_tolerance_mm;
        if (tolerance > 0.0 && step.bounds.missed_mm > 1.001 * tolerance)
            move_.path_error_mm = std::max(move_.path_error_mm, step.bounds.missed_mm);
        if (share_.evidence) return;
        cut_at_ = CutAt{move_.motion->tool, step.X_WB};
        const bool drills = now_->widens && falls_straight(step);
        if ((asks_above() || drills) && stands_out(step)) now_->passes.add(step);
        if (volumes_ && move_.motion->kind != MoveKind::Rapid) {
            // Cells that are exact meet material if they remove some; of the others slivers may be
            // left where they were before.
            const bool is_exact = measuring_.rounding_now(step) <= 0.0;
            measuring_.take_off(step, removed, is_exact);
        }
        if (!ascends(step)) measuring_.meet_bodies(step, part);
        meet_fixtures(step);
    }

    // At rest: what it meets it meets, wherever it came from.
    void arrive(const Step& step, const cda::WorkpieceModel& part) {
        move_.arrives = true;
        measuring_.begin_step();
        if (share_.evidence) {
            note_step(nullptr);
            return;
        }
        if (move_.motion->kind == MoveKind::Rapid && asked("rapid-in-material"))
            measuring_.meet_rapidly(step, part);
        measuring_.meet_bodies(step, part);
        meet_fixtures(step);
    }

    void end(const cda::WorkpieceModel* part) {
        if (!machine_.is_empty() && move_.is_move && !share_.evidence) {
            const std::size_t before = machine_.seen().size();
            machine_.end(part, move_.machine);
            keep_links(Observation::kAtEnd, before);
        }
        if (share_.evidence) note_end();
        if (share_.tile) {
            keep_fixtures();
            count_idle_cuts();
            return;
        }
        if (setup_.second_look) measuring_.look_closer();
        for (const auto judge : judges_)
            judge(setup_, move_, log_);
        count_idle_cuts();
        if (!move_.is_move) {
            if (setup_.ledger && std::holds_alternative<gcode::Dwell>(move_.motion->what))
                ledger_book_.enter(move_, books_);
            clock_.rest(*move_.motion, ledger_book_.row());
            return;
        }
        if (contacts_) air_.take(move_);
        (move_.motion->kind == MoveKind::Rapid ? ledger_.rapid_mm : ledger_.feed_mm) +=
            move_.length_mm;
        if (setup_.ledger) ledger_book_.enter(move_, books_);
        clock_.take(move_, ledger_book_.row());
        if (!books_) ledger_.removed_mm3 += move_.removed_mm3;
    }

    Evidence take_evidence() { return std::move(evidence_); }

    bool measures_all() const { return volumes_; }
    bool needs_account() const { return books_; }

    void add(const gcode::Diagnostics& diagnostics) {
        diagnostics_.insert(diagnostics_.end(), diagnostics.begin(), diagnostics.end());
    }

    void add(Finding finding) {
        if (!asked(finding.rule)) return;
        if (finding.certainty == Certainty::Within &&
            find_rule(finding.rule)->severity == Severity::Error) {
            log_.doubt("uncertain-contact", finding.message, finding.place);
        }
        if (!setup_.stock_assumption.empty()) {
            finding.assumptions.push_back("stock: " + setup_.stock_assumption);
        }
        const ToolFacts* tool = finding.tool > 0 ? facts_of(setup_, finding.tool) : nullptr;
        if (tool && !tool->assumption.empty()) {
            finding.assumptions.push_back("tool: " + tool->assumption);
        }
        if (!setup_.units_assumption.empty()) {
            finding.assumptions.push_back("units: " + setup_.units_assumption);
        }
        log_.add(std::move(finding));
    }

    void add_doubt(std::string_view reason, std::string message, const Place& place) {
        log_.doubt(reason, std::move(message), place);
    }

    Verdict finish(const gcode::Interpretation& interpretation, const cda::WorkpieceModel* part,
                   double stock_mm3) {
        if (share_.evidence && next_seen_ != share_.evidence->size()) refuse_evidence();
        Verdict verdict;
        verdict.files = interpretation.files;
        for (const gcode::Diagnostic& d : diagnostics_)
            tell(d, verdict.files);
        for (const Suppressions::Unknown& u : setup_.suppressions.unknown()) {
            Finding f;
            f.rule = "suppression";
            f.severity = Severity::Warning;
            f.place = f.last = {0, u.span};
            f.message = u.name.empty()
                            ? "this comment suppresses nothing: it has to read (ncsim: "
                              "ignore RULE)"
                            : "'" + u.name + "' is no rule, so nothing is suppressed by it";
            log_.add(std::move(f));
        }
        if (asked("air-cut")) air_.conclude(setup_, log_);
        clock_.finish(ledger_);
        ledger_.measured = (volumes_ || books_) && part != nullptr;
        ledger_.air_known = (contacts_ || books_) && part != nullptr;
        ledger_.air_mm = air_.air_mm();
        if (books_ && part) ledger_book_.close(part->account(), !contacts_);
        if (part) ledger_.rest_mm3 = part->volume();
        ledger_.stock_mm3 = stock_mm3;
        conclude_doubts(part != nullptr);
        log_.finish(verdict);
        verdict.skipped = std::move(skipped_);
        verdict.ledger = std::move(ledger_);
        return verdict;
    }

private:
    [[noreturn]] static void refuse_evidence() {
        throw std::runtime_error("the tiles do not agree on the motions of the program");
    }

    // Of the tiles, by turns.
    bool is_my_turn() const {
        return !share_.tile || move_.number % share_.tile->of == share_.tile->tile;
    }

    void meet_fixtures(const Step& step) {
        if (!scene_.is_empty() && is_my_turn())
            scene_.meet(move_.motion->tool, step, move_.fixtures);
    }

    // Of a tile: what links met since, as seen at that step.
    void keep_links(std::uint64_t step, std::size_t first = 0) {
        const Evidence& seen = machine_.seen();
        for (std::size_t i = first; i < seen.size(); ++i) {
            Observation& kept = evidence_.emplace_back(seen[i]);
            kept.motion = move_.number;
            kept.step = step;
        }
    }

    void keep_fixtures() {
        for (const FixtureContact& contact : move_.fixtures) {
            Observation& seen = evidence_.emplace_back();
            seen.motion = move_.number;
            seen.step = Observation::kAtEnd;
            seen.subject = Subject::Fixture;
            seen.index = static_cast<std::uint32_t>(contact.fixture);
            seen.other = static_cast<std::uint32_t>(contact.piece);
            seen.touches = contact.touches;
            seen.certain = contact.certainty == Certainty::Certain;
            seen.box = contact.box;
        }
    }

    // What tiles saw in this motion up to the step at hand. Whether it was asked is what a tile
    // cannot know: it may have asked for more.
    const Observation* next_seen(std::uint64_t step) {
        const Evidence& all = *share_.evidence;
        if (next_seen_ == all.size()) return nullptr;
        const Observation& next = all[next_seen_];
        if (next.motion < move_.number) refuse_evidence();
        if (next.motion != move_.number || next.step > step) return nullptr;
        ++next_seen_;
        return &next;
    }

    // `step`: null where the tool is at rest.
    void note_step(const Step* step) {
        const Observation* core = nullptr;
        while (const Observation* seen = next_seen(measuring_.step())) {
            const bool is_cut =
                seen->subject == Subject::FeedCut || seen->subject == Subject::RapidCut;
            if (seen->subject == Subject::Link) {
                machine_.note(*seen, move_.machine);
            } else if (seen->subject == Subject::Core) {
                core = seen;
            } else if (!is_cut || move_.asked || !step) {
                measuring_.note(*seen);
            }
        }
        if (!step || !now_->core) return;
        if (move_.motion->kind != MoveKind::Feed) {
            now_->aside_since.reset();
        } else {
            measuring_.meet_core(*step, core);
        }
    }

    void note_end() {
        while (const Observation* seen = next_seen(Observation::kAtEnd)) {
            if (seen->subject == Subject::Link) {
                machine_.note(*seen, move_.machine);
            } else if (seen->subject == Subject::Fixture &&
                       seen->index < setup_.machine.fixtures.size()) {
                const auto certainty = seen->certain ? Certainty::Certain : Certainty::Within;
                move_.fixtures.push_back(
                    {seen->index, seen->other, seen->touches, certainty, seen->box});
            } else {
                refuse_evidence();
            }
        }
    }

    // As the control counts it, and as the tool is.
    ToolLength tool_length(const gcode::Motion& motion) const {
        const bool is_active = frame_.length_register != gcode::kNoLength;
        const bool is_told = is_active && frame_.length_told;
        ToolLength length;
        length.nose_known = is_active ? is_told : setup_.uses_length_offsets;
        length.gauge_mm = frame_.tool_length;
        if (!length.gauge_mm && is_told) length.gauge_mm = motion.length.mm();
        return length;
    }

    void doubt_length(const gcode::Motion& motion) {
        log_.doubt("length-offset",
                   fmt::format("how far T{} reaches below the spindle nose is not told: not all "
                               "links of the machine were asked",
                               motion.tool),
                   place());
    }

    bool is_suppressed(std::string_view rule) const {
        return move_.motion->file == 0 && setup_.suppressions.covers(move_.motion->span.line, rule);
    }

    bool asked(std::string_view rule) const { return setup_.selection.includes(rule); }

    Place place() const { return {move_.motion->file, move_.motion->span}; }

    // A rapid move that meets material is an error, whichever flutes meet it.
    bool is_found_rapid() const {
        return move_.motion->kind == MoveKind::Rapid && asked("rapid-in-material") &&
               !is_suppressed("rapid-in-material");
    }

    // Does somebody want to know what the cutter meets in this motion?
    bool asks(const gcode::Motion& motion) const {
        switch (motion.kind) {
            case MoveKind::Rapid: return volumes_ || asked("rapid-in-material");
            case MoveKind::Probe: return volumes_;
            case MoveKind::Feed: break;
        }
        const bool well = turns_well(motion, is_left_handed(motion.tool));
        return contacts_ || ((!well || motion.spindle_in_doubt) && idle_.cuts < kMostIdleCuts &&
                             (asked("spindle-off") || asked("spindle-reversed")));
    }

    // Counts cuts with the spindle as it should not be, since it is so.
    void look_at_spindle(const gcode::Motion& motion) {
        const Idle now{motion.tool, motion.spindle, motion.spindle_rpm, motion.spindle_in_doubt};
        if (!idle_.is_same(now)) idle_ = now;
    }

    void count_idle_cuts() {
        if (move_.motion->kind != MoveKind::Feed) return;
        if (move_.asked && move_.meets_material && !is_suppressed("spindle-off") &&
            !is_suppressed("spindle-reversed"))
            ++idle_.cuts;
        if (!move_.is_traced || move_.asked || idle_.cuts < kMostIdleCuts) return;
        for (const char* rule : {"spindle-off", "spindle-reversed"})
            log_.go_on(rule);
    }

    bool is_left_handed(int tool) const {
        const ToolFacts* facts = facts_of(setup_, tool);
        return facts && facts->left_hand;
    }

    void measure_path(const gcode::Motion& motion, const gcode::Position& from,
                      const gcode::Position& to) {
        Box& path = move_.path;
        if (std::holds_alternative<gcode::Linear>(motion.what)) {
            const Vec3 a = toolpath::linear_axes(from);
            const Vec3 b = toolpath::linear_axes(to);
            move_.length_mm = norm(b - a);
            move_.enters = move_.leaves = normalized(b - a);
        } else {
            toolpath::SamplingOptions coarse;
            coarse.chord_tolerance_mm = 0.01;
            const toolpath::Samples samples =
                toolpath::sample(motion, {}, coarse, {}, setup_.kinematics.get());
            for (std::size_t i = 1; i < samples.poses.size(); ++i) {
                const Vec3 chord = samples.poses[i].translation - samples.poses[i - 1].translation;
                move_.length_mm += norm(chord);
                move_.leaves = normalized(chord);
                if (i == 1) move_.enters = move_.leaves;
            }
            if (const auto* arc = std::get_if<gcode::Arc>(&motion.what)) {
                move_.radius_mm = smallest_radius(*arc);
            }
        }
        path = toolpath::extent_of_path(motion);
        if (!toolpath::has_known_start(motion)) {
            move_.length_mm = 0.0;
            path = {};
            path.add(toolpath::linear_axes(to));
        }
        // Axes are elsewhere than the tip then.
        move_.is_tilted_tip = motion.coordinates == gcode::Coordinates::Tip && is_turned(motion);
        move_.way_before = way_;
        if (!move_.is_tilted_tip) way_.add(path);
        move_.way = way_;
        const auto is_told = [](const auto& travel) { return travel.has_value(); };
        const bool has_joints = setup_.kinematics && setup_.axes_guess.empty() &&
                                setup_.machine.work_zero && toolpath::has_known_start(motion) &&
                                (!setup_.kinematics->chain.has_head() || motion.length.mm() > 0.0);
        if (move_.is_tilted_tip && has_joints) {
            const Vec3 shift = *setup_.machine.work_zero + tool_offset_;
            const Box joints = toolpath::extent_of_joints(motion, *setup_.kinematics);
            if (!joints.is_empty())
                move_.machine_path = Box{joints.min + shift, joints.max + shift};
        } else if (move_.is_tilted_tip && std::ranges::any_of(setup_.machine.travel, is_told)) {
            log_.doubt("told-not-used",
                       "travels: where the axes go under tip control is not compared with them",
                       place());
        } else if (setup_.machine.work_zero && toolpath::has_known_end(motion)) {
            const Vec3 shift = *setup_.machine.work_zero + tool_offset_;
            move_.machine_path = Box{path.min + shift, path.max + shift};
        }
    }

    void look_at_length(const gcode::Motion& motion, const gcode::Position& from,
                        const gcode::Position& to) {
        move_.length_register = frame_.length_register;
        move_.length_told = frame_.length_told;
        move_.length_offset = tool_offset_.z;
        move_.tool_length = frame_.tool_length;
        const double a = toolpath::linear_axes(from).z;
        const double b = toolpath::linear_axes(to).z;
        move_.needs_length = !motion.machine_coordinates &&
                             (motion.kind != MoveKind::Rapid || (motion.known_start.z && b < a) ||
                              (!motion.known_start.z && motion.known_end.z));
    }

    // Meets it nothing, whatever is not told of where it comes from and where home is? The
    // convention: the reference point lies above all that stands on the table, as on every mill.
    bool passes_above(const gcode::Motion& motion, const gcode::Position& from,
                      const gcode::Position& to) const {
        if (is_turned(motion)) return false;
        const Vec3 a = toolpath::linear_axes(from);
        const Vec3 b = toolpath::linear_axes(to);
        const auto& start = motion.known_start;
        const auto& end = motion.known_end;
        if (a == b && start == end && !motion.start_assumed) return true;  // goes nowhere
        constexpr double kRounding = 1e-6;                                 // mm
        const bool to_home =
            motion.machine_coordinates && end.z && b.z >= setup_.home_z - kRounding;
        const bool only_z = a.x == b.x && a.y == b.y && start.x == end.x && start.y == end.y;
        if (to_home && only_z) return true;
        const bool certain = !motion.start_assumed && !motion.offset_unknown &&
                             (!motion.machine_coordinates || setup_.home_assumption.empty());
        return start.z && end.z && std::min(a.z, b.z) > highest_ && (certain || to_home);
    }

    // What a verdict about this motion would rest on that nobody told.
    void doubt_what_is_guessed() {
        const gcode::Motion& m = *move_.motion;
        if (move_.passes_above) return;
        if (!toolpath::has_known_start(m)) {
            log_.doubt("start-unknown", "where the tool comes from is not told", place());
        } else if (m.start_assumed) {
            log_.doubt(
                "start-unknown",
                "the program goes on by increments from a place that nobody told; taken as 0",
                place());
        }
        if (m.offset_unknown) {
            log_.doubt(
                "offset-guess",
                "a coordinate system lies nobody knows where; it was taken to be that of the "
                "first cut",
                place());
        } else if (m.machine_coordinates && !setup_.home_assumption.empty()) {
            log_.doubt("offset-guess",
                       "a move goes to a place of the machine (G28, G30, G53), and where the "
                       "workpiece lies in it is not told",
                       place());
        }
        if (!needs_part_) return;
        if (!now_ && !setup_.not_simulated && (m.tool != 0 || toolpath::has_known_start(m))) {
            log_.doubt("not-simulated",
                       m.tool == 0 ? "moves before the first tool change were not simulated"
                                   : fmt::format("T{} moves, and nobody describes it", m.tool),
                       place());
        }
        if (!setup_.kinematics && is_turned(m)) {
            log_.doubt("kinematics-guess",
                       "rotary axes turn; taken to turn the tool about the program zero (ISO 841)",
                       place());
        } else if (std::string guess = kinematics_guess(setup_, move_); !guess.empty()) {
            log_.doubt("kinematics-guess", "rotary axes turn; taken: " + guess, place());
        }
        if (move_.after_probe && now_)
            log_.doubt("probe-guess", "moves after a probe stand on what it met", place());
    }

    // Has this tool just been there, with all that cuts?
    bool has_cut_at(const toolpath::Pose& X_WT) const {
        return cut_at_ && cut_at_->tool == move_.motion->tool && cut_at_->X_WT == X_WT;
    }

    // Up out of its own cut, where there is nothing: it is nowhere narrower above, and the stock
    // ends below its upper end.
    bool goes_back_up(const Step& step) const {
        const Vec3 way = step.X_WB.translation - step.X_WA.translation;
        return now_->widens && is_upright(step) && way.x == 0.0 && way.y == 0.0 && way.z > 0.0 &&
               stands_out(step);
    }

    // Is the upper end of what cuts above the stock?
    bool stands_out(const Step& step) const {
        return std::min(step.X_WA.translation.z, step.X_WB.translation.z) +
                   toolpath::cutting_height_of(tool_now()) >=
               stock_.max.z;
    }

    bool asks_above() const {
        return !now_->too_high.bodies.empty() || !now_->uncertain.bodies.empty();
    }

    const toolpath::Tool& tool_now() const { return setup_.tools.at(move_.motion->tool).tool; }

    void tell(const gcode::Diagnostic& d, const std::vector<std::string>& files) {
        Place where;
        const auto file = std::ranges::find(files, d.file);
        where.file = d.file.empty() || file == files.end()
                         ? 0
                         : static_cast<std::uint32_t>(file - files.begin());
        where.span = d.span;
        const std::string_view rule = rule_of_diagnostic(d.code);
        const bool is_suppressed =
            !rule.empty() && where.file == 0 && setup_.suppressions.covers(d.span.line, rule);
        const std::string_view reason = doubt_of_diagnostic(d.code);
        if (!reason.empty() && d.severity == Severity::Warning && !is_suppressed)
            log_.doubt(reason, d.message, where);
        if (rule.empty() || !asked(rule)) return;
        Finding f;
        f.rule = rule;
        f.code = d.code;
        f.severity = d.severity;
        f.place = f.last = where;
        f.count = d.count;
        f.message = d.message;
        if (d.severity == Severity::Note) f.hint = "Nothing has to be done about it.";
        log_.add(std::move(f));
    }

    void conclude_doubts(bool simulated) {
        if (!setup_.units_assumption.empty())
            log_.doubt("units-guess", "units: " + setup_.units_assumption);
        if (needs_part_ && setup_.not_simulated) {
            log_.doubt("not-simulated", "the program was not simulated: " + *setup_.not_simulated);
        }
        if (needs_part_ && simulated) {
            if (!setup_.stock_assumption.empty())
                log_.doubt("stock-guess", "stock: " + setup_.stock_assumption);
            for (const auto& [number, facts] : setup_.tools) {
                if (facts.is_guess) {
                    log_.doubt("tool-guess", fmt::format("T{}: {}", number, facts.assumption));
                }
            }
            for (const auto& [number, watched] : watched_) {
                if (watched.uncertain_mm <= 0.0) continue;
                const double told = facts_of(setup_, number)->certain_flutes.value_or(0.0);
                log_.doubt("flutes-guess",
                           fmt::format("T{} would have to cut {:.6g} mm high, and nobody says that "
                                       "its flutes are longer than {:.6g} mm",
                                       number, told + watched.uncertain_mm, told),
                           watched.uncertain_place);
            }
            // The same block, but for the order in which it is added up.
            if (!(ledger_.rest_mm3 < ledger_.stock_mm3 * (1.0 - 1e-12)))
                log_.doubt("nothing-removed", "the program removes nothing from the stock");
        }
        for (const std::string& what : setup_.required) {
            if (auto missing = missing_requirement(setup_, what))
                log_.doubt("required", std::move(*missing));
        }
    }

    Setup setup_;
    Box stock_;
    cda::Lattice lattice_;
    Share share_;
    std::optional<Box> place_;   // of the tile
    Evidence evidence_;          // of a tile
    std::size_t next_seen_ = 0;  // of all tiles
    FindingLog log_;
    FixtureScene scene_;
    MachineScene machine_;
    Clock clock_;
    std::vector<void (*)(const Setup&, const Move&, FindingLog&)> judges_;
    std::vector<Skipped> skipped_;
    std::map<int, Watched> watched_;
    bool volumes_;             // of every motion, before the next one
    bool books_;               // of every motion, in the end
    bool contacts_ = false;    // of every feed motion
    bool needs_part_ = false;  // some selected rule looks at it

    gcode::ProgramFrame frame_;
    Vec3 tool_offset_;                                           // mm
    double highest_ = -std::numeric_limits<double>::infinity();  // of all that stands there, W
    Box way_;
    std::uint64_t motions_ = 0;
    bool probed_ = false;
    Move move_;
    Measuring measuring_;
    Watched* now_ = nullptr;
    struct CutAt {
        int tool = 0;
        toolpath::Pose X_WT;
    };
    std::optional<CutAt> cut_at_;  // where the last step ended
    // How many cuts with a spindle that is off are told: a program without M3 has thousands.
    struct Idle {
        int tool = 0;
        gcode::SpindleTurning spindle = gcode::SpindleTurning::Stopped;
        double rpm = 0.0;
        bool in_doubt = false;
        std::uint64_t cuts = 0;

        bool is_same(const Idle& o) const {
            return tool == o.tool && spindle == o.spindle && rpm == o.rpm && in_doubt == o.in_doubt;
        }
    };
    Idle idle_;
    static constexpr std::uint64_t kMostIdleCuts = 20;
    AirCuts air_;
    Ledger ledger_;
    LedgerBook ledger_book_;
    gcode::Diagnostics diagnostics_;
};

Verifier::Verifier(Setup setup, const Box& stock, const cda::Lattice& lattice, Share share)
    : impl_(std::make_unique<Impl>(std::move(setup), stock, lattice, std::move(share))) {}
Verifier::~Verifier() = default;

void Verifier::set_frame(const gcode::ProgramFrame& frame) {
    impl_->set_frame(frame);
}

void Verifier::begin(const gcode::Motion& motion, const cda::WorkpieceModel* part) {
    impl_->begin(motion, part);
}

void Verifier::look(const Step& step, const cda::WorkpieceModel& part) {
    impl_->look(step, part);
}

void Verifier::look_back(const Step& step, const cda::WorkpieceModel& part, double removed) {
    impl_->look_back(step, part, removed);
}

void Verifier::arrive(const Step& step, const cda::WorkpieceModel& part) {
    impl_->arrive(step, part);
}

void Verifier::end(const cda::WorkpieceModel* part) {
    impl_->end(part);
}

bool Verifier::measures_all() const {
    return impl_->measures_all();
}
bool Verifier::needs_account() const {
    return impl_->needs_account();
}

void Verifier::add(const gcode::Diagnostics& diagnostics) {
    impl_->add(diagnostics);
}

void Verifier::add(Finding finding) {
    impl_->add(std::move(finding));
}

void Verifier::add_doubt(std::string_view reason, std::string message, const Place& place) {
    impl_->add_doubt(reason, std::move(message), place);
}

Evidence Verifier::take_evidence() {
    return impl_->take_evidence();
}

Verdict Verifier::finish(const gcode::Interpretation& interpretation,
                         const cda::WorkpieceModel* part, double stock_mm3) {
    return impl_->finish(interpretation, part, stock_mm3);
}

}  // namespace ncsim::verify
