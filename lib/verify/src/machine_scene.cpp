// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks the bodies of a machine for contact, motion by motion.
#include "machine_scene.h"

#include "ncsim/cda/hull.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/toolpath/tool_polytope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ncsim::verify {

using machine::Chain;
using machine::Values;

namespace {

// Largest number of measured depths of a pair. A measurement costs as much as ten searches. A
// single fault gets a number; thousands of the same fault get the largest number.
constexpr std::uint64_t kMostMeasured = 16;

// Factor of finer accuracy for tools in open contacts.
constexpr double kFinerTool = 16.0;

// Returns the corners of the circumscribed and of the inscribed polytope of a piece.
ConvexPiece piece_of_tool(const toolpath::ToolPiece& specified, toolpath::ToolAccuracy accuracy,
                          Vec3 tip) {
    constexpr cda::Lattice kFinest;
    const auto corners = [&](toolpath::Side side) {
        accuracy.side = side;
        return toolpath::approximate(specified, kFinest, accuracy).points_T;
    };
    ConvexPiece piece;
    for (const cda::LatticePoint& p : corners(toolpath::Side::Circumscribed))
        piece.outer.push_back(kFinest.to_mm(p) + tip);
    const auto inner = corners(toolpath::Side::Inscribed);
    for (const cda::LatticePoint& p : inner)
        piece.inner.push_back(kFinest.to_mm(p) + tip);
    // For round tools, facets suffice as directions of depth, because edges are nearly parallel to
    // facets.
    if (const auto hull = cda::convex_hull(inner, kFinest, cda::kStockOrigin)) {
        for (const cda::Plane& plane : hull->planes)
            piece.directions.normals.push_back(unit_normal(plane));
    }
    return piece;
}

// Returns the body of a fixture.
// Requires: MachineBodies accepted the mesh.
RigidBody body_of(const Fixture& fixture, Vec3 shift) {
    TriangleMesh mesh = fixture.mesh;
    for (Vec3& p : mesh.vertices)
        p = p + shift;
    if (!reason_for_hull(fixture.mesh, fixture.as_hull).empty())
        return hull_of(mesh, fixture.deflection_mm);
    if (!mesh.triangles.empty()) return body_in_pieces(mesh, fixture.deflection_mm);
    const Vec3 half = 0.5 * fixture.box.size();
    const cda::Lattice lattice = cda::Lattice::for_stock({-half, half});
    const cda::Cell cell = cda::box_cell(lattice.round(-half), lattice.round(half), lattice);
    const auto polytope = cda::ConvexPolytope::of(cell, lattice);
    return {{piece_of(*polytope, lattice, fixture.box.centre() + shift)}, lattice.unit_mm};
}

// True if the cutter reaches each place before the bodies above the cutter: the tool keeps its
// direction and does not ascend. The same argument holds for shanks.
bool leads(const gcode::Motion& leg, const toolpath::Kinematics& machine) {
    const gcode::Position from = *gcode::start_of(leg), to = *gcode::end_of(leg);
    const toolpath::Poses poses(&machine, leg);
    const toolpath::Pose start = poses.at(from);
    for (const double t : {0.25, 0.5, 0.75, 1.0}) {
        if (poses.at(toolpath::interpolate(from, to, t)).rows != start.rows) return false;
    }
    return dot(poses.at(to).translation - start.translation, axis_of(start)) <= 0.0;
}

// Returns the pieces that reach farther from the tool axis than `radius_mm`; null if there are
// none.
std::unique_ptr<const RigidBody> body_outside_radius(const RigidBody& body, double radius_mm) {
    std::vector<ConvexPiece> pieces;
    for (const ConvexPiece& piece : body.pieces()) {
        const bool is_beside = std::ranges::any_of(piece.outer, [radius_mm](Vec3 p) {
            return p.x * p.x + p.y * p.y > radius_mm * radius_mm;
        });
        if (is_beside) pieces.push_back(piece);
    }
    if (pieces.empty()) return nullptr;
    return std::make_unique<const RigidBody>(std::move(pieces), body.accuracy_mm());
}

}  // namespace

MachineScene::MachineScene(const Setup& setup, const Box& stock, const Share& share)
    : setup_(&setup), stock_(stock), share_(share) {
    const bool is_selected = setup.selection.includes("machine-collision") ||
                             setup.selection.includes("machine-near-miss");
    if (!setup.bodies || !setup.bodies->has_meshes() || !setup.kinematics ||
        !setup.machine.work_zero || !is_selected) {
        return;
    }
    zero_ = *setup.machine.work_zero;
    const LinkBodies& specified = setup.bodies->specified();
    double longest = 0.0;
    const auto add = [&](Member member) {
        if (member.body) longest = std::max(longest, member.body->longest());
        members_.push_back(std::move(member));
    };
    // The part and fixtures come first, because the first member of a pair is the observer.
    if (!stock_.is_empty()) {
        Fixture block;
        block.box = stock_;
        block_ = std::make_unique<const RigidBody>(body_of(block, zero_));
        longest = std::max(longest, block_->longest());
        add({"part", "the part", specified.part_moved_by, nullptr, 0.0, false, true, false});
    }
    for (const Fixture& fixture : setup.machine.fixtures) {
        fixtures_.push_back(std::make_unique<const RigidBody>(body_of(fixture, zero_)));
        add({fixture.name, name_of(fixture), specified.part_moved_by, fixtures_.back().get(),
             fixture.clearance_mm, false, false, false,
             reason_for_hull(fixture.mesh, fixture.as_hull)});
    }
    // Then the links fixed to the part, finally the links fixed to the tool.
    const auto rank = [&specified](const LinkBody& link) {
        return link.moved_by == specified.part_moved_by   ? 0
               : link.moved_by == specified.tool_moved_by ? 2
                                                          : 1;
    };
    for (const int wanted : {0, 1, 2}) {
        for (std::size_t i = 0; i < specified.links.size(); ++i) {
            const LinkBody& link = specified.links[i];
            if (!setup.bodies->body(i) || rank(link) != wanted) continue;
            add({link.name, fmt::format("the link '{}'", link.name), link.moved_by,
                 setup.bodies->body(i), link.clearance_mm, false, false, true,
                 setup.bodies->hull_reason(i)});
        }
    }
    add({"tool", "the tool", specified.tool_moved_by, nullptr, 0.0, true, false, false});
    // Twice the longest piece in 25 bits, because a piece may lie on either side of a place.
    for (const auto& [number, facts] : setup.tools)
        longest = std::max(longest, toolpath::height_of(facts.tool));
    const Vec3 reach{2.0 * longest, 2.0 * longest, 2.0 * longest};
    lattice_ = cda::Lattice::for_stock({-reach, reach});
    add_pairs();
}

bool MachineScene::is_specified(const std::vector<NamePair>& pairs, const Member& a,
                                const Member& b) const {
    return std::ranges::any_of(pairs, [&](const NamePair& pair) {
        return (pair.first == a.name && pair.second == b.name) ||
               (pair.first == b.name && pair.second == a.name);
    });
}

void MachineScene::add_pairs() {
    const LinkBodies& specified = setup_->bodies->specified();
    const Chain whole = machine::seen_from(specified.part_moved_by, specified.tool_moved_by);
    for (std::size_t i = 0; i < members_.size(); ++i) {
        for (std::size_t k = i + 1; k < members_.size(); ++k) {
            const Member& a = members_[i];
            const Member& b = members_[k];
            // Separate rules check the tool against the part and fixtures.
            if (!a.is_link && !b.is_link) continue;
            Pair pair{i,
                      k,
                      machine::seen_from(a.moved_by, b.moved_by),
                      std::max(a.clearance_mm, b.clearance_mm),
                      false,
                      {},
                      nullptr};
            if (pair.way.joints.empty() || is_specified(specified.ignored, a, b)) continue;
            const bool are_neighbours = a.is_link && b.is_link && pair.way.joints.size() == 1;
            if (are_neighbours && !is_specified(specified.checked_neighbours, a, b)) continue;
            pair.of_part_and_tool = pair.way == whole;
            pairs_.push_back(std::move(pair));
        }
    }
}

// Returns the tool up to the spindle nose, where the spindle begins.
const RigidBody* MachineScene::tool(int number, double gauge_mm, double finer) {
    const auto key = std::tuple(number, gauge_mm, finer);
    const auto known = tools_.find(key);
    if (known != tools_.end()) return known->second.get();
    const auto facts = setup_->tools.find(number);
    std::vector<ConvexPiece> pieces;
    double accuracy_mm = 0.0;
    if (facts != setup_->tools.end()) {
        for (const toolpath::ToolPiece& whole : facts->second.tool.pieces) {
            const double top = whole.profile.back().height;
            const toolpath::ToolPiece piece =
                top <= gauge_mm ? whole : toolpath::slice(whole, 0.0, gauge_mm);
            if (piece.profile.empty()) continue;
            toolpath::ToolAccuracy accuracy = setup_->accuracy;
            accuracy.tolerance_mm /= finer;
            pieces.push_back(piece_of_tool(piece, accuracy, {0, 0, -gauge_mm}));
            pieces.back().assumed = whole.assumed || facts->second.is_guess;
        }
        accuracy_mm = 2.0 * cda::Lattice{}.unit_mm;
    }
    auto body = pieces.empty() ? nullptr
                               : std::make_unique<const RigidBody>(std::move(pieces), accuracy_mm);
    return tools_.emplace(key, std::move(body)).first->second.get();
}

// True if positions of the pair's joints depend on the tool length.
bool MachineScene::needs_length(const Pair& pair) const {
    const bool of_tip = legs_.front().motion.coordinates == gcode::Coordinates::Tip;
    const bool all = of_tip && setup_->kinematics->chain.has_head();
    return std::ranges::any_of(pair.way.joints, [&](const machine::Joint& joint) {
        return !joint.turns && (all || joint.letter == 'Z');
    });
}

// True if the pair has moved since the last check, or moves in `leg`.
bool MachineScene::moves(const Pair& pair, const Leg& leg) const {
    if (!leg.from || !leg.to || !pair.last_values) return true;
    const bool is_curved = !std::holds_alternative<gcode::Linear>(leg.motion.action) ||
                           leg.motion.coordinates == gcode::Coordinates::Tip;
    return std::ranges::any_of(pair.way.joints, [&](const machine::Joint& joint) {
        const std::size_t i = *machine::index_of(joint.letter);
        return (*leg.from)[i] != (*leg.to)[i] || (*leg.from)[i] != (*pair.last_values)[i] ||
               (is_curved && !joint.turns);
    });
}

PairOnLeg MachineScene::pair_on_leg(const Pair& pair, const Leg& leg) const {
    constexpr std::uint64_t kOften = 50;
    return {*leg.path,
            leg.from,
            leg.to,
            leg.missed_mm,
            pair.way,
            pair.of_part_and_tool,
            {0, 0, -length_mm_},
            pair.not_clear < kOften ? kMostStretches : kFewStretches,
            pair.had_contact};
}

Vec3 MachineScene::to_W(const Pair& pair, const Encounter& encounter) const {
    const Vec3 p_M = pose_of(members_[pair.observer].moved_by, encounter.values) * encounter.point;
    const machine::Pose X_MP = pose_of(setup_->bodies->specified().part_moved_by, encounter.values);
    return inverse(X_MP) * p_M - zero_;
}

// True if this Verifier checks the pair, which does not contain the part.
bool MachineScene::is_selected_pair(std::size_t pair) const {
    if (share_.evidence) return false;
    return !share_.tile || pair % share_.tile->of == share_.tile->tile;
}

void MachineScene::report_contact(const Pair& pair, const Encounter& encounter, bool touches,
                                  std::vector<MachineContact>& contacts) {
    Observation seen;
    seen.subject = Subject::Link;
    seen.index = static_cast<std::uint32_t>(&pair - pairs_.data());
    seen.touches = touches;
    seen.certain = encounter.closeness == Closeness::Certain;
    seen.assumed = encounter.assumed;
    seen.value = encounter.amount_mm;
    seen.values = encounter.values;
    if (seen.certain) seen.point = to_W(pair, encounter);
    note(seen, contacts);
    if (share_.tile) seen_.push_back(std::move(seen));
}

void MachineScene::note(const Observation& seen, std::vector<MachineContact>& contacts) const {
    if (seen.index >= pairs_.size() || !seen.value || !seen.values)
        throw std::runtime_error("the tiles do not agree on the links of the machine");
    const Pair& pair = pairs_[seen.index];
    const bool touches = seen.touches;
    MachineContact contact;
    contact.first = members_[pair.observer].what;
    contact.second = members_[pair.body].what;
    contact.touches = touches;
    contact.certainty = seen.certain ? Certainty::Certain : Certainty::Within;
    contact.amount_mm = *seen.value;
    contact.clearance_mm = pair.clearance_mm;
    contact.assumed = seen.assumed;
    contact.values = *seen.values;
    contact.point = seen.point;
    for (const std::size_t i : {pair.observer, pair.body}) {
        const Member& member = members_[i];
        if (!member.hull_reason.empty())
            contact.hulls.push_back(fmt::format("the mesh of '{}' counts as its hull: {}",
                                                member.name, member.hull_reason));
    }
    const auto old = std::ranges::find_if(contacts, [&](const MachineContact& c) {
        return c.first == contact.first && c.second == contact.second;
    });
    if (old == contacts.end()) {
        contacts.push_back(std::move(contact));
        return;
    }
    // The worst contact of all legs counts.
    const auto weight = [](const MachineContact& c) {
        return std::pair(c.touches, c.certainty == Certainty::Certain);
    };
    const bool is_worse =
        weight(contact) > weight(*old) ||
        (weight(contact) == weight(*old) &&
         (touches ? contact.amount_mm > old->amount_mm : contact.amount_mm < old->amount_mm));
    if (is_worse) *old = std::move(contact);
}

// True if a proof shows that the pair stays clear. Does not change results: a full check would also
// find the pair clear.
bool MachineScene::stays_free(Pair& pair, const Leg& leg, const RigidBody& observer,
                              const RigidBody& body) {
    // Rounding of sums.
    constexpr double kSumRounding = 1e-6;
    const double needed_mm = pair.clearance_mm + leg.missed_mm + kSumRounding;
    const auto is_enough = [&] {
        const auto ways = joint_motion_bounds(pair.free.at, leg.from, leg.joint_motion);
        return ways && stays_separated(pair.free, *ways, needed_mm);
    };
    if (pair.free_with == &body && is_enough()) return true;
    if (!leg.from || !leg.joint_motion || pair.legs_until_retry > 0) {
        pair.legs_until_retry -= pair.legs_until_retry > 0 ? 1 : 0;
        return false;
    }
    // Distance (mm) larger than a few moves of a machine, and small enough to exclude most pieces.
    constexpr double kFarthest = 200.0;
    pair.free_with = &body;
    pair.free =
        free_space(pair.way, *leg.from, observer, body, lattice_, kFarthest + pair.clearance_mm);
    if (is_enough()) {
        pair.failed = 0;
        return true;
    }
    constexpr std::uint32_t kMostDoublings = 6;
    pair.legs_until_retry = 1U << std::min(pair.failed++, kMostDoublings);
    return false;
}

void MachineScene::check_pair(Pair& pair, const Leg& leg, const RigidBody* tool,
                              const ToolLength& length, std::vector<MachineContact>& contacts) {
    const auto body = [&](std::size_t member) {
        return members_[member].is_tool ? tool : members_[member].body;
    };
    const RigidBody* observer = body(pair.observer);
    const RigidBody* other = body(pair.body);
    if (!observer || !other) return;
    if (pair.last_tool_body == other && !moves(pair, leg)) return;
    pair.last_values = leg.to;
    pair.last_tool_body = other;
    if (stays_free(pair, leg, *observer, *other)) {
        pair.had_contact = false;
        return;
    }
    const PairOnLeg pair_on_leg = this->pair_on_leg(pair, leg);
    pair.had_contact = false;
    Encounter near;
    if (pair.clearance_mm > 0.0) {
        near = search_near(pair_on_leg, *observer, *other, lattice_, pair.clearance_mm);
        if (near.closeness == Closeness::Clear) return;
    }
    Encounter met =
        find_contact(pair_on_leg, *observer, *other, lattice_, pair.measured < kMostMeasured);
    // If the accuracy of the tool leaves the contact open, a finer tool may decide.
    if (met.closeness == Closeness::Open && members_[pair.body].is_tool) {
        const RigidBody* finer = this->tool(leg.motion.tool, *length.gauge_mm, kFinerTool);
        met = find_contact(pair_on_leg, *observer, *finer, lattice_, false);
    }
    const bool touches = met.closeness != Closeness::Clear;
    if (!touches && near.closeness == Closeness::Clear) return;
    report_contact(pair, touches ? met : near, touches, contacts);
    ++pair.not_clear;
    pair.had_contact = touches;
    pair.measured += met.closeness == Closeness::Certain ? 1 : 0;
}

void MachineScene::begin(const gcode::Motion& motion, const ToolLength& length,
                         const cda::VerifyingModel* part, std::vector<MachineContact>& contacts) {
    legs_.clear();
    open_.clear();
    seen_.clear();
    misses_length_ = false;
    if (pairs_.empty() || !gcode::start_of(motion) || !toolpath::has_known_end(motion)) return;
    toolpath::Legs legs;
    if (toolpath::has_known_start(motion)) {
        legs = toolpath::legs_of(motion, setup_->rapid);
    } else {
        // The start position is unknown; only the end position is checked.
        legs.motions.push_back(motion);
        const gcode::Position end = *gcode::end_of(motion);
        legs.motions.back().action = gcode::Linear{end, end};
    }
    length_mm_ = motion.length.mm();
    for (gcode::Motion& leg : legs.motions)
        legs_.push_back({std::move(leg), legs.missed_mm});
    for (Leg& leg : legs_) {
        leg.path.emplace(*setup_->kinematics, leg.motion);
        leg.from = leg.path->at(0.0);
        leg.to = leg.path->at(1.0);
        if (leg.from && leg.to)
            leg.joint_motion = leg.path->joint_motion(0.0, *leg.from, 1.0, *leg.to);
    }
    const RigidBody* tool = length.gauge_mm ? this->tool(motion.tool, *length.gauge_mm) : nullptr;
    // No length, or a length that leaves no part of the tool below the nose.
    const bool lacks_tool = motion.tool != 0 && !tool;
    const Chain& tool_moved_by = setup_->bodies->specified().tool_moved_by;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        Pair& pair = pairs_[i];
        const bool is_of_tool = members_[pair.body].is_tool;
        if ((!length.nose_known && needs_length(pair)) || (is_of_tool && lacks_tool)) {
            misses_length_ = true;
            continue;
        }
        if (!members_[pair.observer].is_part) {
            if (!is_selected_pair(i)) continue;
            for (const Leg& leg : legs_)
                check_pair(pair, leg, tool, length, contacts);
            continue;
        }
        if (!part || share_.evidence) continue;
        const RigidBody& body = *members_[pair.body].body;
        const bool is_on_tool = members_[pair.body].moved_by == tool_moved_by;
        for (std::size_t k = 0; k < legs_.size(); ++k) {
            const Leg& leg = legs_[k];
            if (pair.last_tool_body == &body && !moves(pair, leg)) continue;
            pair.last_values = leg.to;
            pair.last_tool_body = &body;
            if (stays_free(pair, leg, *block_, body)) {
                pair.had_contact = false;
                continue;
            }
            const auto is_clear = [&](const RigidBody& what) {
                return search_part(pair_on_leg(pair, leg), *part, stock_, zero_, what,
                                   pair.clearance_mm, false)
                           .closeness == Closeness::Clear;
            };
            if (is_clear(body)) {
                pair.had_contact = false;
                continue;
            }
            bool follows = is_on_tool && leads(leg.motion, *setup_->kinematics);
            if (follows) {
                const RigidBody* aside = body_outside_cutter(body, leg.motion.tool);
                follows = !aside || is_clear(*aside);
            }
            open_.push_back({i, k, follows});
        }
    }
}

// Returns the parts of a link fixed to the tool that move outside the cylinder of the cutter; null
// if there are none.
const RigidBody* MachineScene::body_outside_cutter(const RigidBody& body, int tool) {
    const auto key = std::pair(&body, tool);
    const auto known = outside_cutter_.find(key);
    if (known != outside_cutter_.end()) return known->second.get();
    const auto facts = setup_->tools.find(tool);
    const double radius_mm =
        facts == setup_->tools.end() ? 0.0 : toolpath::cutting_diameter_of(facts->second.tool) / 2;
    return outside_cutter_.emplace(key, body_outside_radius(body, radius_mm)).first->second.get();
}

void MachineScene::end(const cda::VerifyingModel* part, std::vector<MachineContact>& contacts) {
    if (!part) return;
    for (const OpenPair& open : open_) {
        Pair& pair = pairs_[open.pair];
        const Leg& leg = legs_[open.leg];
        const RigidBody& body = *members_[pair.body].body;
        const bool measured = pair.measured < kMostMeasured;
        const auto ask = [&](double clearance_mm) {
            return search_part(pair_on_leg(pair, leg), *part, stock_, zero_, body, clearance_mm,
                               measured);
        };
        Encounter met = ask(0.0);
        bool touches = met.closeness != Closeness::Clear;
        if (!touches && pair.clearance_mm > 0.0) met = ask(pair.clearance_mm);
        if (met.closeness == Closeness::Clear) {
            pair.had_contact = false;
            if (open.follows) continue;
            // An obstacle existed before the motion; the order of contact and cut is unknown.
            touches = pair.clearance_mm == 0.0;
            met.closeness = Closeness::Open;
            met.values = leg.to.value_or(Values{});
        }
        report_contact(pair, met, touches, contacts);
        ++pair.not_clear;
        pair.had_contact = met.closeness == Closeness::Certain;
        pair.measured += met.closeness == Closeness::Certain ? 1 : 0;
    }
}

}  // namespace ncsim::verify
