// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that a machine moves, and who of it is asked about whom: links, fixtures, the tool, what is
// left of the stock.
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/joint_path.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/setup.h"

#include "free_space.h"
#include "move.h"
#include "pair_search.h"
#include "rigid_body.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ncsim::verify {

/// How long the tool is, as far as it was told.
struct ToolLength {
    bool nose_known = false;  ///< Where the spindle nose is when the program says where the tip is.
    std::optional<double> gauge_mm;  ///< Of the tool in the spindle, from the nose to its tip.
};

class MachineScene {
public:
    /// `setup` must outlive it. `stock` in W, mm; empty: nothing is cut.
    /// Of a tile, pairs without the part are asked by one of them each; where all tiles were seen,
    /// none is.
    MachineScene(const Setup& setup, const cda::Box& stock, const Share& share = {});

    /// Is there nothing to ask?
    bool is_empty() const { return pairs_.empty(); }
    /// Asks links, fixtures and the tool about each other, and links about `part`, as it is before
    /// the motion; null: nothing is cut. Adds to `contacts`.
    void begin(const gcode::Motion& motion, const ToolLength& length,
               const cda::WorkpieceModel* part, std::vector<MachineContact>& contacts);
    /// And about the part as it is after it, where that was open.
    void end(const cda::WorkpieceModel* part, std::vector<MachineContact>& contacts);
    /// Adds what tiles saw. Throws std::runtime_error if there is no such pair.
    void note(const Observation& seen, std::vector<MachineContact>& contacts) const;
    /// What was seen in this motion, of a tile.
    const Evidence& seen() const { return seen_; }
    /// What was not asked in this motion, because nobody tells how long its tool is.
    bool misses_length() const { return misses_length_; }

private:
    // One body, or what takes its place with each tool.
    struct Member {
        std::string name;  // as pairs tell it
        std::string what;  // "the link 'cradle'"
        machine::Chain moved_by;
        const RigidBody* body = nullptr;  // null: the tool, the part
        double clearance_mm = 0.0;
        bool is_tool = false, is_part = false, is_link = false;
        std::string why_hull{};  // why it counts as its hull; empty: it does not
    };
    struct Pair {
        std::size_t observer = 0, body = 0;  // of members_
        machine::Chain way;
        double clearance_mm = 0.0;
        bool of_part_and_tool = false;
        // Where the joints on the way stood, and the tool, when it was asked last.
        std::optional<machine::Values> asked_at;
        const RigidBody* asked_with = nullptr;
        std::uint64_t measured = 0;   // times that its depth was
        std::uint64_t not_clear = 0;  // motions in which it was not
        bool met_before = false;      // in the last one that it was asked in
        // What was proven of these two last,
        const RigidBody* free_with = nullptr;
        FreeSpace free{};
        std::uint32_t waits = 0;   // legs until it is worth while to ask that anew,
        std::uint32_t failed = 0;  // and how often it was not
    };
    struct Leg {
        gcode::Motion motion;
        double missed_mm = 0.0;
        std::optional<toolpath::JointPath> path = std::nullopt;
        std::optional<machine::Values> from = std::nullopt, to = std::nullopt;  // at its ends
        std::optional<machine::Going> going = std::nullopt;                     // all of it
    };
    struct Open {
        std::size_t pair = 0, leg = 0;
        bool follows = false;  // what is in the way is where the tool cuts first
    };
    void add_pairs();
    bool is_told(const std::vector<NamePair>& pairs, const Member& a, const Member& b) const;
    const RigidBody* tool(int number, double gauge_mm, double finer = 1.0);
    const RigidBody* beside_cutter(const RigidBody& body, int tool);
    bool stays_free(Pair& pair, const Leg& leg, const RigidBody& observer, const RigidBody& body);
    PairOnLeg on_leg(const Pair& pair, const Leg& leg) const;
    bool moves(const Pair& pair, const Leg& leg) const;
    bool needs_length(const Pair& pair) const;
    void ask(Pair& pair, const Leg& leg, const RigidBody* tool, const ToolLength& length,
             std::vector<MachineContact>& contacts);
    void tell(const Pair& pair, const Encounter& encounter, bool touches,
              std::vector<MachineContact>& contacts);
    bool is_asked(std::size_t pair) const;
    cda::Vec3 in_W(const Pair& pair, const Encounter& encounter) const;

    const Setup* setup_;
    cda::Box stock_;
    Share share_;
    cda::Vec3 zero_;
    cda::Lattice lattice_;
    std::vector<Member> members_;
    std::vector<std::unique_ptr<const RigidBody>> fixtures_;
    std::unique_ptr<const RigidBody> block_;  // all that the part can be
    std::vector<Pair> pairs_;
    // By number, gauge length, and how much finer than their accuracy they are.
    std::map<std::tuple<int, double, double>, std::unique_ptr<const RigidBody>> tools_;
    bool misses_length_ = false;
    // Of links, what is beside the cutter of a tool; never asked in the order of its keys.
    std::map<std::pair<const RigidBody*, int>, std::unique_ptr<const RigidBody>> beside_;
    // Of the motion at hand.
    std::vector<Leg> legs_;
    double length_mm_ = 0.0;
    std::vector<Open> open_;  // pairs with the part
    Evidence seen_;           // of a tile
};

}  // namespace ncsim::verify
