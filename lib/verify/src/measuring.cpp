// SPDX-License-Identifier: GPL-3.0-or-later
#include "measuring.h"

#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/trig/angles.h"

#include "body.h"
#include "rule_table.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace ncsim::verify {

using cda::Box;
using cda::Cell;
using cda::Vec3;
using gcode::MoveKind;
using toolpath::Step;

namespace {

// How steeply it goes down along its axis: the tangent of the angle; 0 if it does not.
double steepness_of(const Step& step) {
    if (step.X_WA.rows != step.X_WB.rows) return 0.0;
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    const Vec3 axis = axis_of(step.X_WA);
    const double down = -dot(way, axis);
    if (down <= 0.0) return 0.0;
    return down / std::max(norm(way + down * axis), 1e-9 * norm(way));
}

}  // namespace

// How far the cutter's cells of this step may lie off for rounding alone.
double Measuring::rounding_now(const Step& step) const {
    return rounding_of(step, now_->prism, lattice_);
}

// Where the cell, less what may be rounding, and the part have volume in common.
std::optional<Vec3> Measuring::contact(const Cell& cell, double rounding,
                                       const cda::WorkpieceModel& part) const {
    return part.contact(rounding > 0.0 ? shrunk(cell, rounding, lattice_) : cell);
}

// In the books.
void Measuring::book(const Step& step, double volume) {
    move_.removed_mm3 += volume;
    for (const Cell& cell : step.cells)
        move_.contact.add(intersection(cell.bounds, stock_));
}

void Measuring::meet_at_feed(const Step& step, const cda::WorkpieceModel& part) {
    if (move_.meets_material && !move_.volume_known) return;
    const double rounding = rounding_now(step);
    if (!volumes_ && find_material(step, part)) {
        meets_now_ = true;
    } else {
        for (const Cell& cell : step.cells) {
            const std::optional<Vec3> point = contact(cell, rounding, part);
            if (!point) continue;
            meets_now_ = true;
            if (!move_.contact_point) move_.contact_point = point;
        }
    }
    if (!meets_now_) return;
    move_.meets_material = true;
    for (const Cell& cell : step.cells)
        move_.contact.add(intersection(cell.bounds, stock_));
    if (!volumes_) measure(step, part);
}

// Of a faulty motion, as long as volumes of faults are told.
void Measuring::measure(const Step& step, const cda::WorkpieceModel& part) {
    if (!volumes_ && move_.volume_known) move_.volume_known = measured_++ < kMostMeasured;
    if (move_.volume_known) move_.removed_mm3 += common_volume(step, part);
}

// Of all cells of the step together, which may overlap.
double Measuring::common_volume(const Step& step, const cda::WorkpieceModel& part) {
    if (step.cells.size() == 1) return part.common_volume(step.cells[0]);
    const std::unique_ptr<cda::WorkpieceModel> rest = part.clone();
    double volume = 0.0;
    for (const Cell& cell : step.cells)
        volume += rest->subtract(cell);
    return volume;
}

// Most rapid moves meet nothing, which is cheap to ask; the rest is looked at closely.
void Measuring::meet_rapidly(const Step& step, const cda::WorkpieceModel& part) {
    // Back into a hole, say, that a peck has left.
    if (now_->widens && now_->passes.cover(step, 0.0)) return;
    const double rounding = rounding_now(step);
    // Of a motion that certainly meets material all that is left to be found out is where else, as
    // a box.
    const bool is_known =
        move_.certainty == Certainty::Certain && move_.contact_point && !move_.volume_known;
    bool touches = false;
    std::optional<Vec3> point;
    for (const Cell& cell : step.cells) {
        const Box box = intersection(cell.bounds, stock_);
        const Box& known = move_.contact;
        if (is_known && known.contains(box.min) && known.contains(box.max)) continue;
        if (!part.contact(cell)) continue;
        touches = true;
        move_.contact.add(box);
        // Less than rounding: it is where the cutter was before.
        if (!point) point = contact(cell, rounding, part);
    }
    if (!touches) return;
    measure(step, part);
    if (!point) return;
    ask_certainty(step, part, point);
    if (setup_.second_look && move_.certainty == Certainty::Within) {
        for (const Cell& cell : step.cells)
            find_places(cell, part, stock_, open_[std::nullopt]);
    }
    move_.meets_material = true;
    if (!move_.contact_point) move_.contact_point = point;
}

// Looks for material around points inside the tool, those in front first: most feed moves cut,
// and the corners of a tetrahedron of a unit's size, well within the tool, that are all in the
// part tell so. (One point would not do: the part of an aggregate contains the walls without
// thickness between two cuts that touch. They are flat, the corners are not.) Where none is
// found, contact() of the whole sweep has to tell.
bool Measuring::find_material(const Step& step, const cda::WorkpieceModel& part) {
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
            if (!move_.contact_point) move_.contact_point = p_W;
            return true;
        }
    }
    return false;
}

// What the accuracy of the tools leaves open, finer ones may decide.
void Measuring::look_closer() {
    if (move_.meets_material && move_.motion->kind == MoveKind::Rapid &&
        move_.certainty == Certainty::Within) {
        const auto decided = second_look("rapid-in-material", std::nullopt);
        if (decided) {
            move_.certainty = *decided;
        } else {
            move_.meets_material = false;
        }
    }
    std::erase_if(move_.bodies, [this](BodyContact& contact) {
        if (contact.certainty == Certainty::Certain) return false;
        const auto decided = second_look("non-cutting-contact", contact.piece);
        contact.certainty = decided.value_or(Certainty::Within);
        return !decided;
    });
}

std::optional<Certainty> Measuring::second_look(std::string_view rule,
                                                std::optional<std::size_t> piece) {
    const auto places = open_.find(piece);
    if (places == open_.end()) return Certainty::Within;
    return setup_.second_look(
        {move_.number, rule, move_.motion->tool, piece, std::move(places->second)});
}

// Moves `point` into the inscribed tool, if that meets something.
void Measuring::ask_certainty(const Step& step, const cda::WorkpieceModel& part,
                              std::optional<Vec3>& point) {
    if (move_.certainty == Certainty::Certain) return;
    cells_.clear();
    now_->inscribed->trace(step.X_WA, step.X_WB, {}, cells_, toolpath::liberties_of(step.turning));
    const double less = gained_by(*now_->inscribed, step) + rounding_now(step);
    for (const Cell& cell : cells_) {
        const auto inside = contact(cell, less, part);
        if (!inside) continue;
        move_.certainty = Certainty::Certain;
        point = inside;
    }
}

void Measuring::meet_bodies(const Step& step, const cda::WorkpieceModel& part) {
    for (Watched::Part& watched : now_->bodies) {
        const Meeting meeting = watched.body.meet(step, 0.0, part, stock_);
        if (!meeting.is_there) continue;
        const double limit = norm(stock_.size()) + toolpath::height_of(tool_now());
        if (watched.body.meet(step, watched.raise_mm, part, stock_).is_there) {
            watched.raise_mm =
                needed_raise(watched.body, step, watched.raise_mm, limit, kRaiseStep, part, stock_);
        }
        auto old = std::ranges::find(move_.bodies, watched.piece, &BodyContact::piece);
        if (old == move_.bodies.end()) {
            move_.bodies.push_back({watched.piece, Certainty::Within, 0.0, {}, {}});
            old = move_.bodies.end() - 1;
        }
        if (setup_.second_look && meeting.certainty == Certainty::Within &&
            old->certainty == Certainty::Within) {
            for (const Cell& cell : watched.body.cells(step, 0.0, toolpath::Side::Circumscribed))
                find_places(cell, part, stock_, open_[watched.piece]);
        }
        old->raise_mm = watched.raise_mm;
        old->box.add(meeting.box);
        if (!old->point) old->point = meeting.point;
        if (meeting.certainty == Certainty::Certain) old->certainty = Certainty::Certain;
    }
}

// What does not cut at its centre leaves a button there, until it has been aside by its radius.
// How far down may it go before? Down a ramp, as steeply as it may, no button is left; its
// double is left where the ramp turns back, and twice that is let pass. What goes down more
// steeply may only do so for as much as the ramp falls under it.
void Measuring::meet_core(const Step& step, const cda::WorkpieceModel& part) {
    Watched& w = *now_;
    const ToolFacts& facts = *facts_of(setup_, move_.motion->tool);
    const double radius = *facts.blind_diameter / 2;
    const Vec3 axis = axis_of(step.X_WA);
    const auto aside = [&axis](Vec3 v) { return norm(v - dot(v, axis) * axis); };
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    if (!w.aside_since || step.X_WA.rows != step.X_WB.rows) {
        w.aside_since = step.X_WA.translation;
        w.fallen_mm = 0.0;
    }
    const double steepness = steepness_of(step);
    const bool is_aside = aside(step.X_WB.translation - *w.aside_since) >= radius;
    if (steepness > 0.0) {
        constexpr double kUsualRamp = 5.0;  // degrees
        const double slope =
            trig::tangent(std::clamp(facts.max_ramp.value_or(kUsualRamp), 0.0, 89.0));
        const double allowed = (steepness > slope ? 1.0 : 4.0) * slope * radius;
        double fall = -dot(way, axis);
        if (is_aside) fall = std::min(fall, steepness * radius);
        fall = fall_on_material(step, part, fall, allowed);
        w.fallen_mm += fall;
        if (fall > 0.0 && w.fallen_mm > allowed) {
            move_.plunged_mm = std::max(move_.plunged_mm, w.fallen_mm);
            move_.contact.add(intersection(w.core->bounds(step, 0.0), stock_));
        }
    }
    if (!is_aside) return;
    w.aside_since = step.X_WB.translation;
    w.fallen_mm = 0.0;
}

// How much of `fall` has material under the core; to the hundredth where it matters.
double Measuring::fall_on_material(const Step& step, const cda::WorkpieceModel& part, double fall,
                                   double allowed) {
    // The core is not known to a hundredth; a rim that touches is no plunge.
    if (!now_->core->meets_certainly(step, 0.0, part, stock_)) return 0.0;
    if (now_->fallen_mm + fall <= allowed) return fall;
    if (now_->core->meet(step, fall, part, stock_).is_there) return fall;
    return needed_raise(*now_->core, step, 0.0, fall, kRaiseStep, part, stock_);
}

// How much higher than at `known` what cuts above some height would have to sit not to cut,
// where what cuts below it has not been before.
double Measuring::needed_above(Above& above, const Step& step, const cda::WorkpieceModel& part,
                               double known, double raise_step) {
    if (now_->passes.cover(step, above.from_mm + known - now_->straight_from_mm)) return known;
    const auto meets = [&](const cda::WorkpieceModel& rest) {
        return std::ranges::any_of(above.bodies, [&](Body& body) {
            return body.meets_certainly(step, known, rest, stock_);
        });
    };
    if (!meets(part)) return known;
    const std::unique_ptr<cda::WorkpieceModel> rest = part.clone();
    if (!ascends(step)) {
        for (Body& body : above.below)
            rest->subtract_unmeasured(body.cells(step, 0.0, toolpath::Side::Inscribed));
        if (!meets(*rest)) return known;
    }
    const double height = toolpath::cutting_height_of(tool_now());
    for (Body& body : above.bodies) {
        if (!body.meet(step, known, *rest, stock_).is_there) continue;
        known = needed_raise(body, step, known, height, raise_step, *rest, stock_);
    }
    return known;
}

void Measuring::meet_too_high(const Step& step, const cda::WorkpieceModel& part) {
    move_.too_deep_mm = needed_above(now_->too_high, step, part, move_.too_deep_mm, kRaiseStep);
}

// Flutes that nobody told: only what was not needed before is new. How much it is is told
// roughly; a program that goes down a helix needs a little more with every step.
void Measuring::meet_uncertain(const Step& step, const cda::WorkpieceModel& part) {
    constexpr double kPart = 1.0 / 16.0;  // of what is certain
    const double known = now_->uncertain_mm;
    const double raise_step = std::max(
        kRaiseStep, kPart * facts_of(setup_, move_.motion->tool)->certain_flutes.value_or(0.0));
    now_->uncertain_mm = needed_above(now_->uncertain, step, part, known, raise_step);
    if (known == 0.0 && now_->uncertain_mm > 0.0)
        now_->uncertain_place = Place{move_.motion->file, move_.motion->span};
}

}  // namespace ncsim::verify
