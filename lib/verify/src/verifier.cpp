// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the rules on every motion of a program.
#include "ncsim/verify/verifier.h"

#include "ncsim/gcode/state.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/trace.h"
#include "ncsim/verify/rule.h"

#include "air_cut.h"
#include "body.h"
#include "clock.h"
#include "finding_log.h"
#include "fixture.h"
#include "guesses.h"
#include "hole_course.h"
#include "idle_spindle.h"
#include "ledger_book.h"
#include "machine_scene.h"
#include "path_facts.h"
#include "rule_table.h"
#include "step_measurement.h"
#include "tool_monitors.h"
#include "unknown_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::verify {

using cda::Cell;
using gcode::MoveKind;
using toolpath::Step;

namespace {

// True for a motion straight down with an upright tool.
bool moves_straight_down(const Step& step) {
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    return is_upright(step) && way.x == 0.0 && way.y == 0.0 && way.z < 0.0;
}

bool moves_straight_up(const Step& step) {
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    return is_upright(step) && way.x == 0.0 && way.y == 0.0 && way.z > 0.0;
}

// True if the spindle turns in the usual direction of the tool; other states need a closer check.
bool turns_well(const gcode::Motion& motion, bool left_hand) {
    const auto right_way =
        left_hand ? gcode::SpindleTurning::Counterclockwise : gcode::SpindleTurning::Clockwise;
    return motion.spindle == right_way && motion.spindle_rpm > 0.0;
}

// True if a rule needs the removed volume of every step.
bool needs_volumes(const Setup& setup) {
    const auto is_selected = [&](std::string_view rule) { return setup.selection.includes(rule); };
    return (is_selected("engagement-limit") && !needs_engagement_limit(setup)) ||
           (is_selected("removal-rate") && !needs_removal_limit(setup));
}

}  // namespace

toolpath::WatchedParts watched_parts(const Setup& setup) {
    toolpath::WatchedParts watch;
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
          path_facts_(setup_, stock_),
          measuring_(setup_, stock_, lattice_, move_, volumes_),
          ledger_book_(ledger_, stock_) {
        for (const Rule& rule : rule_table()) {
            if (const auto by = setup_.selection.ignored.find(rule.info.id);
                by != setup_.selection.ignored.end()) {
                skipped_.push_back(
                    {std::string(rule.info.id), "deselected by " + by->second, true});
                continue;
            }
            if (rule.missing) {
                if (auto reason = rule.missing(setup_)) {
                    skipped_.push_back({std::string(rule.info.id), std::move(*reason)});
                }
            }
            if (rule.judge) judges_.push_back(rule.judge);
        }
        contacts_ = volumes_ || (is_selected("air-cut") && setup_.air_cuts);
        needs_part_ = needs_part(setup_);
        if (setup_.not_simulated) return;
        for (const auto& [number, facts] : setup_.tools) {
            const ToolFacts& wanted = facts;
            const auto same = std::ranges::find_if(monitors_, [&](const auto& known) {
                return is_same_shape(setup_.tools.at(known.first), wanted);
            });
            monitors_.emplace(number, same != monitors_.end() ? same->second
                                                              : watch(facts, setup_.selection,
                                                                      lattice_, setup_.accuracy));
        }
    }

    // True if watch() makes the same bodies of both tools.
    static bool is_same_shape(const ToolFacts& a, const ToolFacts& b) {
        return a.tool.kind == b.tool.kind && a.tool.pieces == b.tool.pieces &&
               a.blind_diameter == b.blind_diameter && a.max_depth == b.max_depth &&
               a.certain_flutes == b.certain_flutes && a.pitch == b.pitch &&
               a.flat_tip == b.flat_tip;
    }

    void begin(const gcode::Motion& motion, const cda::VerifyingModel* part) {
        part_ = part;
        move_ = {};
        ledger_book_.begin();
        move_.motion = &motion;
        move_.number = ++motions_;
        if (motion.frame) path_facts_.set_frame(*motion.frame);
        const auto* from = gcode::start_of(motion);
        const auto* to = gcode::end_of(motion);
        move_.is_move = from && to;
        move_.after_probe = probed_;
        probed_ |= motion.kind == MoveKind::Probe;
        if (!move_.is_move) return;
        if (!share_.tile) {
            path_facts_.take(move_, *from, *to, log_);
            doubt_unknown_length(setup_, move_, log_);
        } else if (part && !place_) {
            place_ = part->wanted().value_or(stock_);
            measuring_.keep(evidence_, *place_);
        }
        const auto watched = monitors_.find(motion.tool);
        current_ = watched == monitors_.end() ? nullptr : &watched->second;
        measuring_.begin(current_);
        move_.is_traced = current_ && toolpath::has_known_start(motion);
        idle_.begin(motion);
        move_.needs_contacts = move_.is_traced && needs_cutter_contacts(motion);
        const bool is_fault =
            motion.kind == MoveKind::Rapid || !turns_well(motion, is_left_handed(motion.tool));
        move_.volume_known = move_.needs_contacts && (volumes_ || is_fault);
        if (!share_.tile) {
            doubt_guesses_of_move(setup_, move_, current_ != nullptr, needs_part_, log_);
            doubt_blend(setup_, move_, log_);
        }
        if (machine_.is_empty()) return;
        machine_.begin(motion, path_facts_.tool_length(motion), part, move_.machine);
        keep_links(0);
        if (share_.tile) return;
        if (machine_.misses_length()) doubt_length(motion);
        if (is_turned(motion) && !setup_.axes_guess.empty())
            log_.doubt("kinematics-guess",
                       "links are where they are taken to be: " + setup_.axes_guess, place());
    }

    void before_cut(const Step& step) {
        measuring_.begin_step();
        if (share_.evidence) {
            note_step(&step);
            return;
        }
        if (ascends(step)) measuring_.measure_bodies(step, *part_);
        if (current_->core) {
            if (move_.motion->kind == MoveKind::Feed) {
                measuring_.measure_core(step, *part_);
            } else {
                current_->aside_since.reset();
            }
        }
        if (current_->wall && measuring_.step() == 1 && moves_straight_up(step))
            measuring_.measure_wall(step, *part_);
        if (move_.motion->kind == MoveKind::Feed && is_upright(step)) {
            const bool falls = moves_straight_down(step);
            if (current_->mouth && falls) measuring_.measure_mouth(step, *part_);
            if (current_->tip && !falls && !moves_straight_up(step))
                measuring_.measure_tip(step, *part_);
        }
        if (!current_->too_high.bodies.empty() && move_.motion->kind == MoveKind::Feed)
            measuring_.measure_too_high(step, *part_);
        const bool goes_on = has_cut_at(step.X_WA);
        const bool only_up = goes_on && leaves_own_cut(step);
        // Straight down, the certain flutes cut ahead of the uncertain flutes.
        const bool only_down = goes_on &&
                               current_->straight_from_mm <= current_->uncertain.from_mm &&
                               moves_straight_down(step);
        if (!current_->uncertain.bodies.empty() && !only_up && !only_down && !is_found_rapid())
            measuring_.measure_uncertain_flutes(step, *part_);
        if (books_) ledger_book_.note_cells(step, measuring_.rounding_now(step));
        if (!move_.needs_contacts || step.cells.empty()) return;
        if (move_.motion->kind == MoveKind::Rapid) {
            if (!only_up || volumes_) measuring_.measure_rapid(step, *part_);
        } else if (!volumes_ || measuring_.rounding_now(step) > 0.0) {
            // A single step that meets material suffices for its motion if no volume is needed.
            measuring_.measure_feed_move(step, *part_);
        }
    }

    void after_cut(const Step& step, double removed) {
        const double tolerance = setup_.path_tolerance_mm;
        if (tolerance > 0.0 && step.bounds.missed_mm > 1.001 * tolerance)
            move_.path_error_mm = std::max(move_.path_error_mm, step.bounds.missed_mm);
        if (share_.evidence) return;
        cut_at_ = CutAt{move_.motion->tool, step.X_WB};
        const bool drills = current_->widens && moves_straight_down(step);
        if ((needs_flutes_above() || drills) && extends_above_stock(step))
            current_->passes.add(step);
        if (volumes_ && move_.motion->kind != MoveKind::Rapid) {
            // Exact cells meet material if they remove some. Inexact cells may remove slivers that
            // earlier steps left.
            const bool is_exact = measuring_.rounding_now(step) <= 0.0;
            measuring_.add_removed(step, removed, is_exact);
        }
        if (!ascends(step)) measuring_.measure_bodies(step, *part_);
        measure_fixtures(step);
    }

    // A tool at rest meets the same bodies whatever its start.
    void at_end_position(const Step& step) {
        move_.arrives = true;
        measuring_.begin_step();
        if (share_.evidence) {
            note_step(nullptr);
            return;
        }
        if (move_.motion->kind == MoveKind::Rapid && is_selected("rapid-in-material"))
            measuring_.measure_rapid(step, *part_);
        measuring_.measure_bodies(step, *part_);
        measure_fixtures(step);
    }

    std::vector<OpenContact> end_steps() {
        if (!machine_.is_empty() && move_.is_move && !share_.evidence) {
            const std::size_t before = machine_.seen().size();
            machine_.end(part_, move_.machine);
            keep_links(Observation::kAtEnd, before);
        }
        if (share_.evidence) note_end();
        if (share_.tile) record_fixtures();
        if (share_.tile || !setup_.decides_contacts) return {};
        return measuring_.open_contacts();
    }

    void judge(std::span<const ContactDecision> decisions) {
        if (share_.tile) return count_idle_cuts();
        if (!decisions.empty()) measuring_.decide(decisions);
        hole_.take(move_);
        for (const auto judge : judges_)
            judge(setup_, move_, log_);
        count_idle_cuts();
        if (!move_.is_move) {
            if (setup_.ledger && std::holds_alternative<gcode::Dwell>(move_.motion->action))
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
        if (!is_selected(finding.rule)) return;
        if (finding.certainty == Certainty::Within && finding.severity != Severity::Note &&
            find_rule(finding.rule)->severity == Severity::Error) {
            log_.doubt("uncertain-contact", finding.message, finding.place);
        }
        std::vector<std::string_view> rests_on;
        if (!setup_.stock_assumption.empty()) {
            finding.assumptions.push_back("stock: " + setup_.stock_assumption);
            rests_on.emplace_back("stock-guess");
        }
        const ToolFacts* tool = finding.tool > 0 ? facts_of(setup_, finding.tool) : nullptr;
        if (tool && !tool->assumption.empty()) {
            finding.assumptions.push_back("tool: " + tool->assumption);
            if (tool->is_guess) rests_on.emplace_back("tool-guess");
        }
        if (!setup_.units_assumption.empty()) {
            finding.assumptions.push_back("units: " + setup_.units_assumption);
            rests_on.emplace_back("units-guess");
        }
        log_.add(std::move(finding), std::move(rests_on));
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
            add_diagnostic(d, verdict.files);
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
        if (is_selected("air-cut")) air_.conclude(setup_, log_);
        clock_.finish(ledger_);
        ledger_.measured = (volumes_ || books_) && part != nullptr;
        ledger_.air_known = (contacts_ || books_) && part != nullptr;
        ledger_.air_mm = air_.air_mm();
        if (books_ && part_) ledger_book_.close(part_->account(), !contacts_);
        if (part) ledger_.rest_mm3 = part->volume();
        ledger_.stock_mm3 = stock_mm3;
        conclude_doubts(part != nullptr);
        log_.finish(verdict);
        verdict.skipped = std::move(skipped_);
        verdict.demotions = demotions();
        verdict.ledger = std::move(ledger_);
        return verdict;
    }

private:
    std::vector<Demotion> demotions() const {
        std::vector<Demotion> demotions;
        for (const RuleInfo& rule : rules()) {
            const auto weight = setup_.selection.severities.find(rule.id);
            if (weight == setup_.selection.severities.end()) continue;
            if (weight->second.severity < rule.severity)
                demotions.push_back(
                    {std::string(rule.id), weight->second.severity, weight->second.by});
        }
        return demotions;
    }

    [[noreturn]] static void refuse_evidence() {
        throw std::runtime_error("the tiles do not agree on the motions of the program");
    }

    // True if this tile checks the motion; tiles take turns.
    bool is_own_motion() const {
        return !share_.tile || move_.number % share_.tile->of == share_.tile->tile;
    }

    void measure_fixtures(const Step& step) {
        if (!scene_.is_empty() && is_own_motion())
            scene_.find_contact(move_.motion->tool, step, move_.fixtures);
    }

    // Records the contacts of links since index `first`, as seen at `step`, for a tile.
    void keep_links(std::uint64_t step, std::size_t first = 0) {
        const Evidence& seen = machine_.seen();
        for (std::size_t i = first; i < seen.size(); ++i) {
            Observation& kept = evidence_.emplace_back(seen[i]);
            kept.motion = move_.number;
            kept.step = step;
        }
    }

    void record_fixtures() {
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

    // Returns the next observation of tiles in this motion up to `step`; null if there is none. A
    // tile cannot know whether an observation was needed, so a tile may have recorded too many.
    const Observation* next_observation(std::uint64_t step) {
        const Evidence& all = *share_.evidence;
        if (next_seen_ == all.size()) return nullptr;
        const Observation& next = all[next_seen_];
        if (next.motion < move_.number) refuse_evidence();
        if (next.motion != move_.number || next.step > step) return nullptr;
        ++next_seen_;
        return &next;
    }

    // Notes the observations of tiles in this step. `step`: null if the tool is at rest.
    void note_step(const Step* step) {
        const Observation* core = nullptr;
        while (const Observation* seen = next_observation(measuring_.step())) {
            const bool is_cut =
                seen->subject == Subject::FeedCut || seen->subject == Subject::RapidCut;
            if (seen->subject == Subject::Link) {
                machine_.note(*seen, move_.machine);
            } else if (seen->subject == Subject::Core) {
                core = seen;
            } else if (!is_cut || move_.needs_contacts || !step) {
                measuring_.note(*seen);
            }
        }
        if (!step || !current_->core) return;
        if (move_.motion->kind != MoveKind::Feed) {
            current_->aside_since.reset();
        } else {
            measuring_.measure_core(*step, core);
        }
    }

    void note_end() {
        while (const Observation* seen = next_observation(Observation::kAtEnd)) {
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

    void doubt_length(const gcode::Motion& motion) {
        log_.doubt("length-offset",
                   fmt::format("the reach of T{} below the spindle nose is not specified: not all "
                               "links of the machine were verified",
                               motion.tool),
                   place());
    }

    bool is_suppressed(std::string_view rule) const {
        return move_.motion->file == 0 && setup_.suppressions.covers(move_.motion->span.line, rule);
    }

    bool is_selected(std::string_view rule) const { return setup_.selection.includes(rule); }

    Place place() const { return {move_.motion->file, move_.motion->span}; }

    // True for a rapid that certainly is an error if it meets material, whichever flutes meet it.
    bool is_found_rapid() const {
        return move_.motion->kind == MoveKind::Rapid && is_selected("rapid-in-material") &&
               !is_suppressed("rapid-in-material");
    }

    // True if a rule needs the contacts of the cutter in this motion.
    bool needs_cutter_contacts(const gcode::Motion& motion) const {
        switch (motion.kind) {
            case MoveKind::Rapid: return volumes_ || is_selected("rapid-in-material");
            case MoveKind::Probe: return volumes_;
            case MoveKind::Feed: break;
        }
        const bool well = turns_well(motion, is_left_handed(motion.tool));
        const ToolFacts* tool = facts_of(setup_, motion.tool);
        using toolpath::ToolKind;
        if (tool &&
            (toolpath::is_axial(tool->tool.kind) || tool->tool.kind == ToolKind::ThreadMill ||
             tool->tool.kind == ToolKind::Countersink))
            return true;
        return contacts_ || ((!well || motion.spindle_in_doubt) && !idle_.is_specified() &&
                             (is_selected("spindle-off") || is_selected("spindle-reversed")));
    }

    void count_idle_cuts() {
        if (move_.motion->kind != MoveKind::Feed) return;
        if (move_.needs_contacts && move_.meets_material && !is_suppressed("spindle-off") &&
            !is_suppressed("spindle-reversed"))
            idle_.count_cut();
        if (!move_.is_traced || move_.needs_contacts || !idle_.is_specified()) return;
        for (const char* rule : {"spindle-off", "spindle-reversed"})
            log_.mark_incomplete(rule);
    }

    bool is_left_handed(int tool) const {
        const ToolFacts* facts = facts_of(setup_, tool);
        return facts && facts->left_hand;
    }

    // True if the last step of the same tool ended at this pose.
    bool has_cut_at(const toolpath::Pose& X_WT) const {
        return cut_at_ && cut_at_->tool == move_.motion->tool && cut_at_->X_WT == X_WT;
    }

    // True if the tool moves up out of its own cut and cannot meet material: the cutter is nowhere
    // narrower above, and the stock ends below the upper end of the cutter.
    bool leaves_own_cut(const Step& step) const {
        const Vec3 way = step.X_WB.translation - step.X_WA.translation;
        return current_->widens && is_upright(step) && way.x == 0.0 && way.y == 0.0 &&
               way.z > 0.0 && extends_above_stock(step);
    }

    // True if the upper end of the cutter is above the stock.
    bool extends_above_stock(const Step& step) const {
        return std::min(step.X_WA.translation.z, step.X_WB.translation.z) +
                   toolpath::cutting_height_of(tool_now()) >=
               stock_.max.z;
    }

    bool needs_flutes_above() const {
        return !current_->too_high.bodies.empty() || !current_->uncertain.bodies.empty();
    }

    const toolpath::Tool& tool_now() const { return setup_.tools.at(move_.motion->tool).tool; }

    void add_diagnostic(const gcode::Diagnostic& d, const std::vector<std::string>& files) {
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
        // A tool without a description is missing information, not a fault of the program.
        const bool is_missing = rule == "tool-undefined";
        if (!reason.empty() && (d.severity == Severity::Warning || is_missing) && !is_suppressed)
            log_.doubt(reason, d.message, where);
        if (rule.empty() || !is_selected(rule)) return;
        Finding f;
        f.rule = rule;
        f.code = d.code;
        f.severity = is_missing ? find_rule(rule)->severity : d.severity;
        f.place = f.last = where;
        f.count = d.count;
        f.message = d.message;
        if (d.severity == Severity::Note) f.hint = "Nothing has to be done about it.";
        log_.add(std::move(f));
    }

    void conclude_doubts(bool is_simulated) {
        doubt_guesses_of_setup(setup_, monitors_, needs_part_, log_);
        // An unchanged block can differ by the order of summation.
        if (needs_part_ && is_simulated && !(ledger_.rest_mm3 < ledger_.stock_mm3 * (1.0 - 1e-12)))
            log_.doubt("nothing-removed", "the program removes nothing from the stock");
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
    std::size_t next_seen_ = 0;  // index into the evidence of all tiles
    FindingLog log_;
    FixtureScene scene_;
    MachineScene machine_;
    Clock clock_;
    std::vector<void (*)(const Setup&, const Move&, FindingLog&)> judges_;
    std::vector<Skipped> skipped_;
    std::map<int, ToolMonitors> monitors_;
    bool volumes_;             // the volume of every motion is measured before the next motion
    bool books_;               // the volume of every motion is read from the account at the end
    bool contacts_ = false;    // contacts of every feed motion are needed
    bool needs_part_ = false;  // a selected rule needs the part

    PathFacts path_facts_;
    std::uint64_t motions_ = 0;
    bool probed_ = false;
    const cda::VerifyingModel* part_ = nullptr;  // part of the last motion
    Move move_;
    HoleCourse hole_;
    Measuring measuring_;
    ToolMonitors* current_ = nullptr;
    struct CutAt {
        int tool = 0;
        toolpath::Pose X_WT;
    };
    std::optional<CutAt> cut_at_;  // end of the last step
    IdleSpindle idle_;
    AirCuts air_;
    Ledger ledger_;
    LedgerBook ledger_book_;
    gcode::Diagnostics diagnostics_;
};

Verifier::Verifier(Setup setup, const Box& stock, const cda::Lattice& lattice, Share share)
    : impl_(std::make_unique<Impl>(std::move(setup), stock, lattice, std::move(share))) {}
Verifier::~Verifier() = default;

void Verifier::begin(const gcode::Motion& motion, const cda::VerifyingModel* part) {
    impl_->begin(motion, part);
}

void Verifier::before_cut(const Step& step) {
    impl_->before_cut(step);
}

void Verifier::after_cut(const Step& step, double removed) {
    impl_->after_cut(step, removed);
}

void Verifier::at_end_position(const Step& step) {
    impl_->at_end_position(step);
}

void Verifier::end() {
    (void)impl_->end_steps();
    impl_->judge({});
}

std::vector<OpenContact> Verifier::end_steps() {
    return impl_->end_steps();
}

void Verifier::judge(std::span<const ContactDecision> decisions) {
    impl_->judge(decisions);
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
