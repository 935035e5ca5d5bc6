// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/verifier.h"

#include "ncsim/toolpath/machine.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool_polytope.h"

#include "air_cut.h"
#include "body.h"
#include "clock.h"
#include "finding_log.h"
#include "fixture.h"
#include "rule_table.h"

#include <algorithm>
#include <cmath>

namespace ncsim::verify {

using cda::Box;
using cda::Cell;
using cda::Vec3;
using gcode::MoveKind;
using toolpath::Step;

namespace {

// What a tool is watched for while it moves.
struct Watched {
    struct Part {
        std::size_t piece;
        Body body;
        double raise_mm = 0.0;  // so far
    };
    std::vector<Part> bodies;                   // shanks and holders
    std::optional<Body> core;                   // what does not cut at the centre
    std::optional<Body> too_high;               // what cuts, but above the limit of depth
    std::optional<Body> within;                 // what cuts below it
    std::vector<Vec3> probes_T;                 // points strictly inside the cutting pieces
    bool prism = true;                          // all of what cuts
    std::optional<toolpath::Cutter> inscribed;  // the cutter, for certainty
};

// A cylinder about the tool axis, from `low` to `high` mm above the tip.
toolpath::ToolPiece cylinder(double diameter, double low, double high) {
    return {{{diameter / 2, low, 0.0}, {diameter / 2, high, 0.0}}, true};
}

// The corners of the piece's inscribed polytope, drawn in by a thousandth towards their middle.
void add_probes(const toolpath::ToolPiece& piece, const cda::Lattice& lattice,
                const toolpath::ToolAccuracy& inscribed, std::vector<Vec3>& probes_T) {
    const toolpath::PiecePolytope polytope = toolpath::approximate(piece, lattice, inscribed);
    Vec3 middle;
    for (const cda::LatticePoint& p : polytope.points_T)
        middle = middle + lattice.to_mm(p);
    middle =
        (1.0 / static_cast<double>(std::max<std::size_t>(1, polytope.points_T.size()))) * middle;
    for (const cda::LatticePoint& p : polytope.points_T)
        probes_T.push_back(middle + 0.999 * (lattice.to_mm(p) - middle));
}

Watched watch(const ToolFacts& facts, const cda::Lattice& lattice,
              const toolpath::ToolAccuracy& accuracy) {
    Watched w;
    for (std::size_t i = 0; i < facts.tool.pieces.size(); ++i) {
        const toolpath::ToolPiece& piece = facts.tool.pieces[i];
        if (!piece.cutting) w.bodies.push_back({i, Body(piece, lattice, accuracy)});
    }
    const double height = toolpath::cutting_height_of(facts.tool);
    const double diameter = toolpath::cutting_diameter_of(facts.tool);
    if (facts.blind_diameter && *facts.blind_diameter > 0.0) {
        w.core.emplace(cylinder(*facts.blind_diameter, 0.0, height), lattice, accuracy);
    }
    if (facts.max_depth && *facts.max_depth < height) {
        w.too_high.emplace(cylinder(diameter, *facts.max_depth, height), lattice, accuracy);
        w.within.emplace(cylinder(diameter, 0.0, *facts.max_depth), lattice, accuracy);
    }
    toolpath::ToolAccuracy inner = accuracy;
    inner.side = toolpath::Side::Inscribed;
    w.inscribed.emplace(facts.tool, lattice, inner);
    for (const toolpath::ToolPiece& piece : facts.tool.pieces) {
        if (piece.cutting) w.prism &= is_prism(piece);
        if (piece.cutting) add_probes(piece, lattice, inner, w.probes_T);
    }
    return w;
}

// Towards the spindle, or not? Only then a shank can meet what its own cutter takes away later in
// the same motion; else the cutter was there first.
bool ascends(const Step& step) {
    return step.X_WA.rows == step.X_WB.rows &&
           dot(step.X_WB.translation - step.X_WA.translation, axis_of(step.X_WA)) > 0.0;
}

// Of an arc, which may be a spiral; mm.
double smallest_radius(const gcode::Arc& arc) {
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

bool goes_straight_down(const Step& step) {
    if (step.X_WA.rows != step.X_WB.rows) return false;
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    const Vec3 axis = axis_of(step.X_WA);
    const double along = dot(way, axis);
    if (along >= 0.0) return false;
    // Copied coordinates differ by exactly nothing; under a turned axis rounding is all there is.
    return norm(way - along * axis) <= 1e-9 * norm(way);
}

}  // namespace

class Verifier::Impl {
public:
    Impl(Setup setup, const Box& stock, const cda::Lattice& lattice)
        : setup_(std::move(setup)),
          stock_(stock),
          lattice_(lattice),
          log_(setup_.selection, setup_.suppressions),
          scene_(setup_),
          clock_(setup_.machine) {
        for (const Rule& rule : rule_table()) {
            if (!asked(rule.info.id)) continue;
            if (rule.missing) {
                if (auto reason = rule.missing(setup_)) {
                    skipped_.push_back({std::string(rule.info.id), std::move(*reason)});
                }
            }
            if (rule.judge) judges_.push_back(rule.judge);
        }
        volumes_ = setup_.ledger ||
                   (asked("engagement-limit") && !needs_engagement_limit(setup_)) ||
                   (asked("removal-rate") && !needs_removal_limit(setup_));
        contacts_ = volumes_ || asked("air-cut");
        if (setup_.not_simulated) return;
        for (const auto& [number, facts] : setup_.tools) {
            watched_.emplace(number, watch(facts, lattice_, setup_.accuracy));
        }
    }

    void set_frame(const gcode::ProgramFrame& frame) {
        const double unit = frame.inches ? 25.4 : 1.0;
        tool_offset_ = {unit * frame.tool_offset[gcode::kX], unit * frame.tool_offset[gcode::kY],
                        unit * frame.tool_offset[gcode::kZ]};
    }

    void begin(const gcode::Motion& motion) {
        move_ = {};
        move_.motion = &motion;
        move_.number = ++motions_;
        const auto* from = gcode::start_of(motion);
        const auto* to = gcode::end_of(motion);
        move_.is_move = from && to;
        move_.after_probe = probed_;
        probed_ |= motion.kind == MoveKind::Probe;
        if (!move_.is_move) return;
        measure_path(motion, *from, *to);
        const auto watched = watched_.find(motion.tool);
        now_ = watched == watched_.end() ? nullptr : &watched->second;
        move_.is_traced = now_ && toolpath::has_known_start(motion);
        move_.asked = move_.is_traced && asks(motion);
        move_.volume_known = move_.asked && (volumes_ || motion.kind == MoveKind::Rapid ||
                                             !turns_well(motion, is_left_handed(motion.tool)));
    }

    double cut(const Step& step, cda::TreeCda& part) {
        const bool up = ascends(step);
        const bool down = goes_straight_down(step);
        if (up) meet_bodies(step, part);
        if (down && asked("plunge")) meet_core(step, part);
        const bool depth_asked =
            now_->too_high && asked("depth-limit") && move_.motion->kind == MoveKind::Feed;
        if (depth_asked) meet_too_high(step, part, up);
        // One step that meets material answers for its motion.
        met_ = move_.asked && !move_.volume_known && move_.motion->kind == MoveKind::Feed &&
               !step.cells.empty() && (move_.meets_material || find_material(step, part));
        double removed = 0.0;
        for (const Cell& cell : step.cells)
            removed += take_away(cell, step, part);
        if (!up) meet_bodies(step, part);
        if (down) move_.plunges = true;
        if (!scene_.is_empty()) scene_.meet(move_.motion->tool, step, move_.fixtures);
        return removed;
    }

    void end() {
        for (const auto judge : judges_)
            judge(setup_, move_, log_);
        if (!move_.is_move) {
            if (setup_.ledger && std::holds_alternative<gcode::Dwell>(move_.motion->what)) enter();
            clock_.rest(*move_.motion, row());
            return;
        }
        if (contacts_) air_.take(move_);
        (move_.motion->kind == MoveKind::Rapid ? ledger_.rapid_mm : ledger_.feed_mm) +=
            move_.length_mm;
        if (setup_.ledger) enter();
        clock_.take(move_, row());
        ledger_.removed_mm3 += move_.removed_mm3;
    }

    bool measures_all() const { return volumes_; }

    void add(const gcode::Diagnostics& diagnostics) {
        diagnostics_.insert(diagnostics_.end(), diagnostics.begin(), diagnostics.end());
    }

    void add(Finding finding) {
        if (!asked(finding.rule)) return;
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

    Verdict finish(const gcode::Interpretation& interpretation, const cda::TreeCda* part,
                   double stock_mm3) {
        Verdict verdict;
        verdict.files = interpretation.files;
        for (const gcode::Diagnostic& d : diagnostics_)
            tell(d, verdict.files);
        for (const Suppressions::Unknown& u : setup_.suppressions.unknown()) {
            Finding f;
            f.rule = "suppression";
            f.severity = Severity::Warning;
            f.place = f.last = {0, u.span};
            f.message = "'" + u.name + "' is no rule, so nothing is suppressed by it";
            log_.add(std::move(f));
        }
        if (asked("air-cut")) air_.conclude(setup_, log_);
        log_.finish(verdict);
        verdict.skipped = std::move(skipped_);
        clock_.finish(ledger_);
        ledger_.measured = volumes_ && part != nullptr;
        ledger_.air_known = contacts_ && part != nullptr;
        ledger_.air_mm = air_.air_mm();
        if (part) ledger_.rest_mm3 = part->volume();
        ledger_.stock_mm3 = stock_mm3;
        verdict.ledger = std::move(ledger_);
        return verdict;
    }

private:
    // The row that a time belongs to.
    std::size_t row() const { return ledger_.rows.empty() ? 0 : ledger_.rows.size() - 1; }

    bool asked(std::string_view rule) const { return setup_.selection.includes(rule); }

    // Does somebody want to know what the cutter meets in this motion?
    bool asks(const gcode::Motion& motion) const {
        switch (motion.kind) {
            case MoveKind::Rapid: return volumes_ || asked("rapid-in-material");
            case MoveKind::Probe: return volumes_;
            case MoveKind::Feed: break;
        }
        return contacts_ || (!turns_well(motion, is_left_handed(motion.tool)) &&
                             (asked("spindle-off") || asked("spindle-reversed")));
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
            path.add(a);
            path.add(b);
            move_.length_mm = norm(b - a);
            move_.enters = move_.leaves = normalized(b - a);
        } else {
            toolpath::SamplingOptions coarse;
            coarse.chord_tolerance_mm = 0.01;
            const toolpath::Samples samples = toolpath::sample(motion, {}, coarse);
            for (std::size_t i = 0; i < samples.poses.size(); ++i) {
                path.add(samples.poses[i].translation);
                if (i > 0) {
                    const Vec3 chord =
                        samples.poses[i].translation - samples.poses[i - 1].translation;
                    move_.length_mm += norm(chord);
                    move_.leaves = normalized(chord);
                    if (i == 1) move_.enters = move_.leaves;
                }
            }
            if (const auto* arc = std::get_if<gcode::Arc>(&motion.what)) {
                move_.radius_mm = smallest_radius(*arc);
            }
        }
        if (!toolpath::has_known_start(motion)) {
            move_.length_mm = 0.0;
            path = {};
            path.add(toolpath::linear_axes(to));
        }
        move_.way_before = way_;
        way_.add(path);
        move_.way = way_;
        if (setup_.machine.work_zero) {
            const Vec3 shift = *setup_.machine.work_zero + tool_offset_;
            move_.machine_path = Box{path.min + shift, path.max + shift};
            move_.tool_length_told = tool_offset_.z != 0.0;
        }
    }

    double take_away(const Cell& cell, const Step& step, cda::TreeCda& part) {
        if (!move_.asked || met_) {
            if (met_) move_.contact.add(intersection(cell.bounds, stock_));
            part.subtract_unmeasured(cell);
            return 0.0;
        }
        return move_.motion->kind == MoveKind::Rapid ? take_rapidly(cell, step, part)
                                                     : carve(cell, part, rounding_now(step));
    }

    // How far the cutter's cells of this step may lie off for rounding alone.
    double rounding_now(const Step& step) const { return rounding_of(step, now_->prism, lattice_); }

    // Where the cell, less what may be rounding, and the part have volume in common.
    std::optional<Vec3> contact(const Cell& cell, double rounding, const cda::TreeCda& part) const {
        return part.contact(rounding > 0.0 ? shrunk(cell, rounding, lattice_) : cell);
    }

    double carve(const Cell& cell, cda::TreeCda& part, double rounding) {
        if (!move_.volume_known) {
            const std::optional<Vec3> point = contact(cell, rounding, part);
            part.subtract_unmeasured(cell);
            if (point) meet_material(cell, 0.0, point);
            return 0.0;
        }
        // Cells that are exact meet material if they remove some; of the others slivers may be
        // left where they were before.
        const bool meets = rounding > 0.0 && contact(cell, rounding, part);
        const double volume = std::max(0.0, part.subtract(cell));
        if (meets || (rounding == 0.0 && volume > 0.0)) {
            meet_material(cell, volume, {});
        } else {
            book(cell, volume);
        }
        return volume;
    }

    // In the books, but no contact.
    void book(const Cell& cell, double volume) {
        if (volume <= 0.0) return;
        move_.removed_mm3 += volume;
        move_.contact.add(intersection(cell.bounds, stock_));
    }

    // Most rapid moves meet nothing, which is cheap to ask; the rest is looked at closely.
    double take_rapidly(const Cell& cell, const Step& step, cda::TreeCda& part) {
        std::optional<Vec3> point = part.contact(cell);
        if (!point) return 0.0;  // it would change nothing
        const double volume = std::max(0.0, part.common_volume(cell));
        const double rounding = rounding_now(step);
        if (rounding > 0.0 && !contact(cell, rounding, part)) {
            book(cell, volume);  // it is where the cutter was before
        } else {
            ask_certainty(step, part, point);
            meet_material(cell, volume, point);
        }
        part.subtract_unmeasured(cell);
        return volume;
    }

    // Looks for material around points inside the tool, those in front first: most feed moves cut,
    // and the corners of a tetrahedron of a unit's size, well within the tool, that are all in the
    // part tell so. (One point would not do: the part of an aggregate contains the walls without
    // thickness between two cuts that touch. They are flat, the corners are not.) Where none is
    // found, contact() of the whole sweep has to tell.
    bool find_material(const Step& step, const cda::TreeCda& part) {
        if (step.X_WA.rows != step.X_WB.rows) return false;
        const Vec3 way = step.X_WB.translation - step.X_WA.translation;
        for (const double t : {1.0, 0.5, 0.25, 0.75}) {
            toolpath::Pose pose = step.X_WA;
            pose.translation = pose.translation + t * way;
            for (const Vec3& p_T : now_->probes_T) {
                const Vec3 p_W = pose * p_T;
                if (dot(p_W - pose.translation, way) < 0.0 || !stock_.contains(p_W)) continue;
                const double u = lattice_.unit_mm;
                const Vec3 corners[] = {p_W, p_W + Vec3{1.3 * u, 0.4 * u, 0.7 * u},
                                        p_W + Vec3{-0.6 * u, 1.1 * u, -0.9 * u},
                                        p_W + Vec3{0.2 * u, -1.4 * u, 0.5 * u}};
                if (!std::ranges::all_of(corners, [&](Vec3 p) { return part.contains(p); })) {
                    continue;
                }
                move_.meets_material = true;
                if (!move_.contact_point) move_.contact_point = p_W;
                return true;
            }
        }
        return false;
    }

    void meet_material(const Cell& cell, double volume, const std::optional<Vec3>& point) {
        move_.meets_material = true;
        move_.removed_mm3 += volume;
        move_.contact.add(intersection(cell.bounds, stock_));
        if (!move_.contact_point) move_.contact_point = point;
    }

    // Before the cutter has taken it away. Moves `point` into the inscribed tool, if it meets.
    void ask_certainty(const Step& step, const cda::TreeCda& part, std::optional<Vec3>& point) {
        if (move_.certainty == Certainty::Certain) return;
        cells_.clear();
        now_->inscribed->trace(step.X_WA, step.X_WB, {}, cells_);
        const double less = step.bounds.gained_mm + rounding_now(step);
        for (const Cell& cell : cells_) {
            const auto inside = contact(cell, less, part);
            if (!inside) continue;
            move_.certainty = Certainty::Certain;
            point = inside;
        }
    }

    void meet_bodies(const Step& step, const cda::TreeCda& part) {
        if (!asked("non-cutting-contact")) return;
        for (Watched::Part& watched : now_->bodies) {
            const Meeting meeting = watched.body.meet(step, 0.0, part, stock_);
            if (!meeting.is_there) continue;
            const double limit = norm(stock_.size()) + toolpath::height_of(tool_now());
            if (watched.body.meet(step, watched.raise_mm, part, stock_).is_there) {
                watched.raise_mm =
                    needed_raise(watched.body, step, watched.raise_mm, limit, part, stock_);
            }
            auto old = std::ranges::find(move_.bodies, watched.piece, &BodyContact::piece);
            if (old == move_.bodies.end()) {
                move_.bodies.push_back({watched.piece, Certainty::Within, 0.0, {}, {}});
                old = move_.bodies.end() - 1;
            }
            old->raise_mm = watched.raise_mm;
            old->box.add(meeting.box);
            if (!old->point) old->point = meeting.point;
            if (meeting.certainty == Certainty::Certain) old->certainty = Certainty::Certain;
        }
    }

    void meet_core(const Step& step, const cda::TreeCda& part) {
        if (!now_->core || move_.motion->kind != MoveKind::Feed) return;
        const Meeting meeting = now_->core->meet(step, 0.0, part, stock_);
        if (!meeting.is_there) return;
        move_.blind_mm3 += now_->core->common_volume(step, part, stock_);
        move_.contact.add(meeting.box);
    }

    // What cuts above the limit of depth, where what cuts below it has not been before.
    void meet_too_high(const Step& step, cda::TreeCda& part, bool up) {
        if (!up) {
            for (const Cell& cell : now_->within->cells(step, 0.0, toolpath::Side::Inscribed)) {
                if (stock_.overlaps(cell.bounds)) carve(cell, part, rounding_now(step));
            }
        }
        if (now_->too_high->meet(step, 0.0, part, stock_).certainty != Certainty::Certain) return;
        const double height = toolpath::cutting_height_of(tool_now());
        move_.too_deep_mm = std::max(
            move_.too_deep_mm, needed_raise(*now_->too_high, step, 0.0, height, part, stock_));
    }

    const toolpath::Tool& tool_now() const { return setup_.tools.at(move_.motion->tool).tool; }

    void enter() {
        const gcode::Motion& m = *move_.motion;
        auto& rows = ledger_.rows;
        const bool same = !rows.empty() && rows.back().line == m.span.line &&
                          rows.back().file == m.file && rows.back().tool == m.tool &&
                          rows.back().last_motion + 1 == move_.number;
        if (!same) {
            LedgerRow row;
            row.file = m.file;
            row.line = m.span.line;
            row.first_motion = move_.number;
            row.tool = m.tool;
            row.kind = m.kind;
            rows.push_back(row);
        }
        LedgerRow& row = rows.back();
        row.last_motion = move_.number;
        if (m.kind == MoveKind::Feed) row.kind = MoveKind::Feed;
        row.length_mm += move_.length_mm;
        row.removed_mm3 += move_.removed_mm3;
        row.contact.add(move_.contact);
    }

    void tell(const gcode::Diagnostic& d, const std::vector<std::string>& files) {
        const std::string_view rule = rule_of_diagnostic(d.code);
        if (rule.empty() || !asked(rule)) return;
        Finding f;
        f.rule = rule;
        f.code = d.code;
        f.severity = d.severity;
        const auto file = std::ranges::find(files, d.file);
        f.place.file = d.file.empty() || file == files.end()
                           ? 0
                           : static_cast<std::uint32_t>(file - files.begin());
        f.place.span = d.span;
        f.last = f.place;
        f.count = d.count;
        f.message = d.message;
        log_.add(std::move(f));
    }

    Setup setup_;
    Box stock_;
    cda::Lattice lattice_;
    FindingLog log_;
    FixtureScene scene_;
    Clock clock_;
    std::vector<void (*)(const Setup&, const Move&, FindingLog&)> judges_;
    std::vector<Skipped> skipped_;
    std::map<int, Watched> watched_;
    bool volumes_ = false;   // of every motion
    bool contacts_ = false;  // of every feed motion

    Vec3 tool_offset_;
    Box way_;
    std::uint64_t motions_ = 0;
    bool probed_ = false;
    Move move_;
    Watched* now_ = nullptr;
    bool met_ = false;         // this step meets material; nobody asks how much
    std::vector<Cell> cells_;  // kept for its memory
    AirCuts air_;
    Ledger ledger_;
    gcode::Diagnostics diagnostics_;
};

Verifier::Verifier(Setup setup, const Box& stock, const cda::Lattice& lattice)
    : impl_(std::make_unique<Impl>(std::move(setup), stock, lattice)) {}
Verifier::~Verifier() = default;

void Verifier::set_frame(const gcode::ProgramFrame& frame) {
    impl_->set_frame(frame);
}

void Verifier::begin(const gcode::Motion& motion) {
    impl_->begin(motion);
}

double Verifier::cut(const Step& step, cda::TreeCda& part) {
    return impl_->cut(step, part);
}

void Verifier::end() {
    impl_->end();
}

bool Verifier::measures_all() const {
    return impl_->measures_all();
}

void Verifier::add(const gcode::Diagnostics& diagnostics) {
    impl_->add(diagnostics);
}

void Verifier::add(Finding finding) {
    impl_->add(std::move(finding));
}

Verdict Verifier::finish(const gcode::Interpretation& interpretation, const cda::TreeCda* part,
                         double stock_mm3) {
    return impl_->finish(interpretation, part, stock_mm3);
}

}  // namespace ncsim::verify
