// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the contacts of a tool with the part.
#include "step_measurement.h"

#include "ncsim/base/angles.h"
#include "ncsim/toolpath/tool_polytope.h"

#include "body.h"
#include "rule_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace ncsim::verify {

using cda::Cell;
using gcode::MoveKind;
using toolpath::Step;

namespace {

// Returns the tangent of the angle of descent along the tool axis; 0 if the step does not descend.
double steepness_of(const Step& step) {
    if (step.X_WA.rows != step.X_WB.rows) return 0.0;
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    const Vec3 axis = axis_of(step.X_WA);
    const double down = -dot(way, axis);
    if (down <= 0.0) return 0.0;
    return down / std::max(norm(way + down * axis), 1e-9 * norm(way));
}

}  // namespace

double Measuring::rounding_now(const Step& step) const {
    return rounding_of(step, current_->prism, lattice_);
}

// Returns a point common to the part and to the cell shrunk by `rounding`.
std::optional<Vec3> Measuring::contact(const Cell& cell, double rounding,
                                       const cda::VerifyingModel& part) const {
    return part.contact(rounding > 0.0 ? shrink_cell(cell, rounding, lattice_) : cell);
}

// True if the body does not overlap the tile.
bool Measuring::is_away(const Body& body, const Step& step, double raise) const {
    return place_ && !place_->overlaps(body.bounds(step, raise));
}

Observation Measuring::current_observation(Subject subject, std::size_t index) const {
    Observation seen;
    seen.motion = move_.number;
    seen.step = step_;
    seen.subject = subject;
    seen.index = static_cast<std::uint32_t>(index);
    return seen;
}

void Measuring::record(Observation seen) {
    note(seen);
    if (kept_) kept_->push_back(std::move(seen));
}

namespace {

[[noreturn]] void refuse_evidence() {
    throw std::runtime_error("the tiles do not agree on what was asked");
}

}  // namespace

void Measuring::note(const Observation& seen) {
    switch (seen.subject) {
        case Subject::FeedCut:
            if (!seen.touches || (move_.meets_material && !move_.volume_known)) return;
            has_contact_ = true;
            move_.meets_material = true;
            move_.contact.add(seen.box);
            if (!move_.contact_point) move_.contact_point = seen.point;
            if (!volumes_) book(seen.value);
            return;
        case Subject::RapidCut:
            move_.contact.add(seen.box);
            book(seen.value);
            if (!seen.touches) return;
            if (seen.certain) move_.certainty = Certainty::Certain;
            if (!seen.places.empty()) {
                std::vector<Box>& open = open_[std::nullopt];
                open.insert(open.end(), seen.places.begin(), seen.places.end());
            }
            move_.meets_material = true;
            if (!move_.contact_point) move_.contact_point = seen.point;
            return;
        case Subject::Removed: {
            const double volume = seen.value.value_or(0.0);
            move_.meets_material |= seen.touches || (seen.certain && volume > 0.0);
            if (volume <= 0.0) return;
            move_.removed_mm3 += volume;
            move_.contact.add(seen.box);
            return;
        }
        case Subject::Body: {
            if (!current_) refuse_evidence();
            const auto watched =
                std::ranges::find(current_->bodies, seen.index, &ToolMonitors::Part::piece);
            if (watched == current_->bodies.end()) refuse_evidence();
            watched->raise_mm = std::max(watched->raise_mm, seen.value.value_or(0.0));
            auto old = std::ranges::find(move_.bodies, seen.index, &BodyContact::piece);
            if (old == move_.bodies.end()) {
                move_.bodies.push_back({seen.index, Certainty::Within, 0.0, {}, {}});
                old = move_.bodies.end() - 1;
            }
            if (!seen.places.empty()) {
                std::vector<Box>& open = open_[seen.index];
                open.insert(open.end(), seen.places.begin(), seen.places.end());
            }
            old->raise_mm = watched->raise_mm;
            old->box.add(seen.box);
            if (!old->point) old->point = seen.point;
            if (seen.certain) old->certainty = Certainty::Certain;
            return;
        }
        case Subject::TooHigh:
            move_.too_deep_mm = std::max(move_.too_deep_mm, seen.value.value_or(0.0));
            return;
        case Subject::UnspecifiedFlutes: {
            if (!current_) refuse_evidence();
            const double known = current_->uncertain_mm;
            current_->uncertain_mm = std::max(known, seen.value.value_or(0.0));
            if (known == 0.0 && current_->uncertain_mm > 0.0)
                current_->uncertain_place = Place{move_.motion->file, move_.motion->span};
            return;
        }
        case Subject::Wall:
            move_.is_at_wall = true;
            move_.contact.add(seen.box);
            return;
        case Subject::Mouth: {
            const double z = seen.value.value_or(0.0);
            move_.mouth_z = std::max(move_.mouth_z.value_or(z), z);
            return;
        }
        case Subject::Tip:
            move_.tip_cuts = true;
            move_.contact.add(seen.box);
            return;
        case Subject::Core:
        case Subject::Fixture:
        case Subject::Link: break;
    }
    refuse_evidence();
}

void Measuring::add_removed(const Step& step, double volume, bool is_exact) {
    Observation seen = current_observation(Subject::Removed);
    // Inexact cells may remove slivers that earlier steps left.
    seen.touches = !is_exact && has_contact_;
    seen.certain = is_exact;
    seen.value = volume;
    if (!seen.touches && volume == 0.0) return;
    for (const Cell& cell : step.cells)
        seen.box.add(intersection(cell.bounds, stock_));
    record(std::move(seen));
}

void Measuring::measure_feed_move(const Step& step, const cda::VerifyingModel& part) {
    if (move_.meets_material && !move_.volume_known) return;
    const double rounding = rounding_now(step);
    Observation seen = current_observation(Subject::FeedCut);
    if (!volumes_) seen.point = find_material(step, part, seen.rank);
    for (const Cell& cell : step.cells) {
        if (seen.point) break;
        seen.point = contact(cell, rounding, part);
        ++seen.rank;
    }
    // In a different tile the contact may exceed rounding.
    seen.touches = seen.point.has_value();
    const auto has_sliver = [&] {
        return kept_ && !volumes_ && wants_volume() &&
               std::ranges::any_of(
                   step.cells, [&](const Cell& cell) { return part.contact(cell).has_value(); });
    };
    if (!seen.touches && !has_sliver()) return;
    for (const Cell& cell : step.cells)
        seen.box.add(intersection(cell.bounds, stock_));
    if (!volumes_ && wants_volume()) seen.value = common_volume(step, part);
    record(std::move(seen));
}

// True in a faulty motion, as long as volumes of faults are reported.
bool Measuring::wants_volume() const {
    return move_.volume_known && (volumes_ || measured_ < kMostMeasured);
}

void Measuring::book(const std::optional<double>& volume) {
    if (!volumes_ && move_.volume_known) move_.volume_known = measured_++ < kMostMeasured;
    if (!move_.volume_known) return;
    if (!volume) refuse_evidence();
    move_.removed_mm3 += *volume;
}

// Returns the common volume of the part and all cells of the step, which may overlap.
double Measuring::common_volume(const Step& step, const cda::VerifyingModel& part) {
    if (step.cells.size() == 1) return part.common_volume(step.cells[0]);
    const std::unique_ptr<cda::WorkpieceModel> rest = part.clone();
    double volume = 0.0;
    for (const Cell& cell : step.cells)
        volume += rest->subtract(cell);
    return volume;
}

void Measuring::measure_rapid(const Step& step, const cda::VerifyingModel& part) {
    // For example, back into a hole that a peck left.
    if (current_->widens && current_->passes.cover(step, 0.0)) return;
    const double rounding = rounding_now(step);
    // In a motion that certainly meets material, only the boxes of further contacts are needed.
    const bool is_known =
        move_.certainty == Certainty::Certain && move_.contact_point && !move_.volume_known;
    Observation seen = current_observation(Subject::RapidCut);
    for (const Cell& cell : step.cells) {
        const Box box = intersection(cell.bounds, stock_);
        const Box& known = move_.contact;
        if (is_known && known.contains(box.min) && known.contains(box.max)) continue;
        if (!seen.point) ++seen.rank;
        if (!part.contact(cell)) continue;
        seen.box.add(box);
        // Less than rounding: the cutter was there before.
        if (!seen.point) seen.point = contact(cell, rounding, part);
    }
    if (seen.box.is_empty()) return;
    if (wants_volume()) seen.value = common_volume(step, part);
    seen.touches = seen.point.has_value();
    if (seen.touches && move_.certainty != Certainty::Certain) {
        if (const auto inside = certain_point(step, part)) {
            seen.certain = true;
            seen.point = inside;
        } else if (keeps_places()) {
            for (const Cell& cell : step.cells)
                find_places(cell, part, stock_, seen.places);
        }
    }
    record(std::move(seen));
}

// Searches for material around points inside the tool, the foremost points first, because most feed
// moves cut. Material is found if all corners of a tetrahedron of the size of a lattice unit, well
// within the tool, are in the part. A single point does not suffice: the part of an aggregate
// contains walls of zero thickness between two touching cuts. Such walls are flat; the corners are
// not coplanar. If no tetrahedron is found, contact() of the whole sweep decides. `rank` counts the
// points that were checked.
std::optional<Vec3> Measuring::find_material(const Step& step, const cda::VerifyingModel& part,
                                             std::uint32_t& rank) {
    if (step.X_WA.rows != step.X_WB.rows) return std::nullopt;
    const Vec3 way = step.X_WB.translation - step.X_WA.translation;
    for (const double t : {1.0, 0.5, 0.25, 0.75}) {
        toolpath::Pose pose = step.X_WA;
        pose.translation = pose.translation + t * way;
        for (const Vec3& p_T : current_->probes_T) {
            ++rank;
            const Vec3 p_W = pose * p_T;
            if (dot(p_W - pose.translation, way) < 0.0 || !stock_.contains(p_W)) continue;
            if (place_ && !place_->contains(p_W)) continue;
            const double u = lattice_.unit_mm;
            const Vec3 corners[] = {p_W, p_W + Vec3{1.3 * u, 0.4 * u, 0.7 * u},
                                    p_W + Vec3{-0.6 * u, 1.1 * u, -0.9 * u},
                                    p_W + Vec3{0.2 * u, -1.4 * u, 0.5 * u}};
            if (!std::ranges::all_of(corners, [&](Vec3 p) { return part.contains(p); })) {
                continue;
            }
            return p_W;
        }
    }
    return std::nullopt;
}

bool Measuring::is_rapid_open() const {
    return move_.meets_material && move_.motion->kind == MoveKind::Rapid &&
           move_.certainty == Certainty::Within;
}

std::vector<OpenContact> Measuring::open_contacts() {
    std::vector<OpenContact> contacts;
    const auto add = [&](std::string_view rule, std::optional<std::size_t> piece) {
        const auto places = open_.find(piece);
        if (places == open_.end()) return;
        // The order must not depend on the tile that found the boxes.
        std::vector<Box>& boxes = places->second;
        const auto corners = [](const Box& b) {
            return std::array{b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z};
        };
        std::ranges::sort(boxes, {}, corners);
        boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
        contacts.push_back({move_.number, rule, move_.motion->tool, piece, boxes});
    };
    if (is_rapid_open()) add("rapid-in-material", std::nullopt);
    for (const BodyContact& contact : move_.bodies) {
        if (contact.certainty != Certainty::Certain) add("non-cutting-contact", contact.piece);
    }
    return contacts;
}

void Measuring::decide(std::span<const ContactDecision> decisions) {
    auto next = decisions.begin();
    const auto decided = [&](std::optional<std::size_t> piece) {
        return open_.contains(piece) ? *next++ : Certainty::Within;
    };
    if (is_rapid_open()) {
        const ContactDecision decision = decided(std::nullopt);
        move_.meets_material = decision.has_value();
        move_.certainty = decision.value_or(Certainty::Within);
    }
    std::erase_if(move_.bodies, [&](BodyContact& contact) {
        if (contact.certainty == Certainty::Certain) return false;
        const ContactDecision decision = decided(contact.piece);
        contact.certainty = decision.value_or(Certainty::Within);
        return !decision;
    });
}

// Returns a common point of the material and the inscribed tool, if one exists.
std::optional<Vec3> Measuring::certain_point(const Step& step, const cda::VerifyingModel& part) {
    std::optional<Vec3> point;
    cells_.clear();
    current_->inscribed->trace(step.X_WA, step.X_WB, {}, cells_,
                               toolpath::simplification_of(step.turning));
    const double less = gain_of(*current_->inscribed, step) + rounding_now(step);
    for (const Cell& cell : cells_) {
        if (const auto inside = contact(cell, less, part)) point = inside;
    }
    return point;
}

void Measuring::measure_bodies(const Step& step, const cda::VerifyingModel& part) {
    for (ToolMonitors::Part& watched : current_->bodies) {
        if (is_away(watched.body, step, 0.0)) continue;
        const PartContact meeting = watched.body.find_contact(step, 0.0, part, stock_);
        if (!meeting.is_there) continue;
        Observation seen = current_observation(Subject::Body, watched.piece);
        seen.point = meeting.point;
        seen.box = meeting.box;
        seen.certain = meeting.certainty == Certainty::Certain;
        const double limit = norm(stock_.size()) + toolpath::height_of(tool_now());
        seen.value = watched.raise_mm;
        if (watched.body.find_contact(step, watched.raise_mm, part, stock_).is_there) {
            seen.value =
                needed_raise(watched.body, step, watched.raise_mm, limit, kRaiseStep, part, stock_);
        }
        const auto old = std::ranges::find(move_.bodies, watched.piece, &BodyContact::piece);
        const bool was_certain = old != move_.bodies.end() && old->certainty == Certainty::Certain;
        if (keeps_places() && !seen.certain && !was_certain) {
            for (const Cell& cell : watched.body.cells(step, 0.0, toolpath::Side::Circumscribed))
                find_places(cell, part, stock_, seen.places);
        }
        record(std::move(seen));
    }
}

// Follows the core of the tool. A tool that does not cut at the centre leaves a button there until
// it has moved aside by the radius of the core.
//
// Limits of the descent before that, with the slope s of the steepest permitted ramp and the radius
// r of the core: a ramp of slope s leaves no button, but 2 s r where it reverses; 4 s r is
// permitted. A steeper descent is permitted up to s r.
void Measuring::follow_core(const Step& step,
                            const std::function<double(double fall, double allowed)>& on_material) {
    ToolMonitors& w = *current_;
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
        const double slope = tangent(std::clamp(facts.max_ramp.value_or(kUsualRamp), 0.0, 89.0));
        const double allowed = (steepness > slope ? 1.0 : 4.0) * slope * radius;
        double fall = -dot(way, axis);
        if (is_aside) fall = std::min(fall, steepness * radius);
        fall = on_material(fall, allowed);
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

// A tile knows neither the material under the tool in other tiles nor the length of the descent.
// The tile records the length of this step above material.
void Measuring::measure_core(const Step& step, const cda::VerifyingModel& part) {
    if (!kept_) {
        follow_core(step, [&](double fall, double allowed) {
            return drop_to_material(step, part, fall, allowed);
        });
        return;
    }
    if (steepness_of(step) <= 0.0 || is_away(*current_->core, step, 0.0)) return;
    const double fall = -dot(step.X_WB.translation - step.X_WA.translation, axis_of(step.X_WA));
    Observation seen = current_observation(Subject::Core);
    seen.value = drop_to_material(step, part, fall, -1.0);
    if (*seen.value > 0.0) kept_->push_back(std::move(seen));
}

void Measuring::measure_core(const Step& step, const Observation* seen) {
    follow_core(step, [&](double fall, double allowed) {
        if (!seen) return 0.0;
        return current_->fallen_mm + fall <= allowed ? fall
                                                     : std::min(fall, seen->value.value_or(0.0));
    });
}

// Returns the length of `fall` that has material under the core, to 0.01 mm where it matters.
double Measuring::drop_to_material(const Step& step, const cda::VerifyingModel& part, double fall,
                                   double allowed) {
    // The size of the core is not known to 0.01 mm; a rim that touches is no plunge.
    if (!current_->core->meets_certainly(step, 0.0, part, stock_)) return 0.0;
    if (current_->fallen_mm + fall <= allowed) return fall;
    if (current_->core->find_contact(step, fall, part, stock_).is_there) return fall;
    return std::min(fall, needed_raise(*current_->core, step, 0.0, fall, kRaiseStep, part, stock_));
}

// Returns the smallest raise, at least `known`, at which the cutter above a height meets no
// material, except material that the cutter below this height removes in this step or removed on
// the same path.
double Measuring::needed_raise_of_flutes(FlutesAbove& above, const Step& step,
                                         const cda::VerifyingModel& part, double known,
                                         double raise_step) {
    if (current_->passes.cover(step, above.from_mm + known - current_->straight_from_mm))
        return known;
    const auto meets = [&](const cda::VerifyingModel& material) {
        return std::ranges::any_of(above.bodies, [&](Body& body) {
            return !is_away(body, step, known) &&
                   body.meets_certainly(step, known, material, stock_);
        });
    };
    if (!meets(part)) return known;
    const std::unique_ptr<cda::WorkpieceModel> copy = part.clone();
    auto& rest = dynamic_cast<cda::VerifyingModel&>(*copy);
    if (!ascends(step)) {
        for (Body& body : above.below)
            rest.subtract_unmeasured(body.cells(step, 0.0, toolpath::Side::Inscribed));
        if (!meets(rest)) return known;
    }
    const double height = toolpath::cutting_height_of(tool_now());
    for (Body& body : above.bodies) {
        if (!body.find_contact(step, known, rest, stock_).is_there) continue;
        known = needed_raise(body, step, known, height, raise_step, rest, stock_);
    }
    return known;
}

void Measuring::measure_too_high(const Step& step, const cda::VerifyingModel& part) {
    Observation seen = current_observation(Subject::TooHigh);
    seen.value =
        needed_raise_of_flutes(current_->too_high, step, part, move_.too_deep_mm, kRaiseStep);
    if (*seen.value > move_.too_deep_mm) record(std::move(seen));
}

void Measuring::record_if_certain(const PartContact& meeting, Subject subject) {
    if (meeting.certainty != Certainty::Certain) return;
    Observation seen = current_observation(subject);
    seen.certain = true;
    seen.point = meeting.point;
    seen.box = meeting.box;
    record(std::move(seen));
}

void Measuring::measure_wall(const Step& step, const cda::VerifyingModel& part) {
    if (!is_away(*current_->wall, step, 0.0))
        record_if_certain(current_->wall->find_contact(step, 0.0, part, stock_), Subject::Wall);
}

void Measuring::measure_mouth(const Step& step, const cda::VerifyingModel& part) {
    if (!current_->mouth->meets_certainly(step, 0.0, part, stock_)) return;
    const double end = step.X_WB.translation.z;
    const double limit = std::max(0.0, stock_.max.z - end);
    Observation seen = current_observation(Subject::Mouth);
    seen.value = end + needed_raise(*current_->mouth, step, 0.0, limit, kRaiseStep, part, stock_);
    record(std::move(seen));
}

void Measuring::measure_tip(const Step& step, const cda::VerifyingModel& part) {
    if (!move_.tip_cuts)
        record_if_certain(current_->tip->find_contact(step, 0.0, part, stock_), Subject::Tip);
}

// Checks the flutes above the certain flute length: only a larger raise than before is new. The
// raise is reported coarsely, because a program on a helix needs a little more with every step.
void Measuring::measure_uncertain_flutes(const Step& step, const cda::VerifyingModel& part) {
    constexpr double kPart = 1.0 / 16.0;  // relative to the certain flute length
    const double known = current_->uncertain_mm;
    const double raise_step = std::max(
        kRaiseStep, kPart * facts_of(setup_, move_.motion->tool)->certain_flutes.value_or(0.0));
    Observation seen = current_observation(Subject::UnspecifiedFlutes);
    seen.value = needed_raise_of_flutes(current_->uncertain, step, part, known, raise_step);
    if (*seen.value > known) record(std::move(seen));
}

}  // namespace ncsim::verify
