// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of a machine, and the pairs that are checked for contact: links, fixtures, the tool, the
// rest of the stock.
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

/// Length of the tool, as far as specified.
struct ToolLength {
    bool nose_known = false;  ///< The position of the spindle nose follows from the programmed tip.
    std::optional<double> gauge_mm;  ///< Length from the spindle nose to the tip of the tool.
};

class MachineScene {
public:
    /// Creates the scene. `stock` (W, mm) is empty if nothing is cut. Tiles share the pairs without
    /// the part: exactly one tile checks each pair. With the evidence of all tiles, no pair is
    /// checked.
    /// Requires: `setup` outlives the scene.
    MachineScene(const Setup& setup, const Box& stock, const Share& share = {});

    /// True if no pair is checked.
    bool is_empty() const { return pairs_.empty(); }
    /// Checks links, fixtures and the tool against each other, and links against `part` as it is
    /// before the motion (null: nothing is cut). Adds contacts to `contacts`.
    void begin(const gcode::Motion& motion, const ToolLength& length,
               const cda::VerifyingModel* part, std::vector<MachineContact>& contacts);
    /// Checks open contacts with the part again, with `part` as it is after the motion.
    void end(const cda::VerifyingModel* part, std::vector<MachineContact>& contacts);
    /// Adds the contact of an observation of a tile.
    /// Throws: std::runtime_error if the pair does not exist.
    void note(const Observation& seen, std::vector<MachineContact>& contacts) const;
    /// Returns the observations of this motion, for a tile.
    const Evidence& seen() const { return seen_; }
    /// True if a pair was not checked in this motion because the tool length is unspecified.
    bool misses_length() const { return misses_length_; }

private:
    // Body, or placeholder for the tool or the part.
    struct Member {
        std::string name;  // name in pairs
        std::string what;  // "the link 'cradle'"
        machine::Chain moved_by;
        const RigidBody* body = nullptr;  // null: the tool, the part
        double clearance_mm = 0.0;
        bool is_tool = false, is_part = false, is_link = false;
        std::string hull_reason{};  // reason why the hull replaces the mesh; empty: it does not
    };
    struct Pair {
        std::size_t observer = 0, body = 0;  // indices into members_
        machine::Chain way;
        double clearance_mm = 0.0;
        bool of_part_and_tool = false;
        // Joint positions and tool at the last check.
        std::optional<machine::Values> last_values;
        const RigidBody* last_tool_body = nullptr;
        std::uint64_t measured = 0;   // number of measured depths
        std::uint64_t not_clear = 0;  // number of motions that were not clear
        bool had_contact = false;     // contact in the last motion that was checked
        // Last proof of free space for the two bodies.
        const RigidBody* free_with = nullptr;
        FreeSpace free{};
        std::uint32_t legs_until_retry = 0;  // number of legs until the next attempt of a proof
        std::uint32_t failed = 0;            // number of failed attempts in a row
    };
    struct Leg {
        gcode::Motion motion;
        double missed_mm = 0.0;
        std::optional<toolpath::JointPath> path = std::nullopt;
        // joint positions at the ends of the leg
        std::optional<machine::Values> from = std::nullopt, to = std::nullopt;
        // bounds for the whole leg
        std::optional<machine::JointMotion> joint_motion = std::nullopt;
    };
    struct OpenPair {
        std::size_t pair = 0, leg = 0;
        bool follows = false;  // the tool cuts the obstacle first
    };
    void add_pairs();
    bool is_specified(const std::vector<NamePair>& pairs, const Member& a, const Member& b) const;
    const RigidBody* tool(int number, double gauge_mm, double finer = 1.0);
    const RigidBody* body_outside_cutter(const RigidBody& body, int tool);
    bool stays_free(Pair& pair, const Leg& leg, const RigidBody& observer, const RigidBody& body);
    PairOnLeg pair_on_leg(const Pair& pair, const Leg& leg) const;
    bool moves(const Pair& pair, const Leg& leg) const;
    bool needs_length(const Pair& pair) const;
    void check_pair(Pair& pair, const Leg& leg, const RigidBody* tool, const ToolLength& length,
                    std::vector<MachineContact>& contacts);
    void report_contact(const Pair& pair, const Encounter& encounter, bool touches,
                        std::vector<MachineContact>& contacts);
    bool is_selected_pair(std::size_t pair) const;
    Vec3 to_W(const Pair& pair, const Encounter& encounter) const;

    const Setup* setup_;
    Box stock_;
    Share share_;
    Vec3 zero_;
    cda::Lattice lattice_;
    std::vector<Member> members_;
    std::vector<std::unique_ptr<const RigidBody>> fixtures_;
    std::unique_ptr<const RigidBody> block_;  // box of the stock, which contains the part
    std::vector<Pair> pairs_;
    // Tools by number, gauge length, and factor of finer accuracy.
    std::map<std::tuple<int, double, double>, std::unique_ptr<const RigidBody>> tools_;
    bool misses_length_ = false;
    // Parts of links outside the cylinder of a cutter; never iterated, because keys are pointers.
    std::map<std::pair<const RigidBody*, int>, std::unique_ptr<const RigidBody>> outside_cutter_;
    // State of the current motion.
    std::vector<Leg> legs_;
    double length_mm_ = 0.0;
    std::vector<OpenPair> open_;  // pairs with the part
    Evidence seen_;               // of a tile
};

}  // namespace ncsim::verify
