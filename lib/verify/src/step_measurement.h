// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measurement of the contacts of a tool with the part in one motion, step by step, before and after
// the cells are removed. Changes only the Move in which contacts are noted. Asking and noting are
// separate: a tile asks its part and records observations; a run with the evidence of all tiles
// notes the same observations.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/setup.h"

#include "move.h"
#include "tool_monitors.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::verify {

class Measuring {
public:
    /// Creates a measurement. `stock` (mm, W) and `lattice` are the part's. `volumes`: the caller
    /// measures the removed volume of every step.
    /// Requires: `setup` and `move` outlive the object.
    Measuring(const Setup& setup, const Box& stock, const cda::Lattice& lattice, Move& move,
              bool volumes)
        : setup_(setup), stock_(stock), lattice_(lattice), move_(move), volumes_(volumes) {}

    /// Also records all observations in `evidence`. `place` (mm, W): box of the tile.
    void keep(Evidence& evidence, const Box& place) {
        kept_ = &evidence;
        place_ = place;
    }
    /// Begins a motion with the watched tool; null: the tool is not described.
    void begin(ToolMonitors* tool) {
        current_ = tool;
        open_.clear();
        step_ = 0;
    }
    /// Begins a step; called before all queries about the step.
    void begin_step() {
        ++step_;
        has_contact_ = false;
    }
    /// Returns the number of the step, from 1.
    std::uint64_t step() const { return step_; }

    /// Returns the largest distance (mm) by which rounding displaces the cutter's cells of this
    /// step.
    double rounding_now(const toolpath::Step& step) const;
    void measure_feed_move(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Checks a step of a rapid. Most rapids meet no material, which a cheap query decides; the
    /// rest is checked closely.
    void measure_rapid(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Checks shanks and holders.
    void measure_bodies(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Checks the core, which does not cut.
    void measure_core(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Checks the core with the observation `seen` of tiles; null: no material under the core.
    void measure_core(const toolpath::Step& step, const Observation* seen);
    /// Checks the cutter above the depth limit.
    void measure_too_high(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Checks the flutes above the certain flute length.
    void measure_uncertain_flutes(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Notes whether a thread mill is in the wall of its thread where it starts to move up.
    void measure_wall(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Notes the height of the material into which the tool moves straight down.
    void measure_mouth(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Notes a contact of the flat tip of a chamfer mill.
    void measure_tip(const toolpath::Step& step, const cda::VerifyingModel& part);
    /// Notes that the step removed `volume` (mm³). `is_exact`: a positive volume proves contact.
    void add_removed(const toolpath::Step& step, double volume, bool is_exact);
    /// Notes an observation of the part, except of the core.
    /// Throws: std::runtime_error if the observation is impossible in this motion.
    void note(const Observation& seen);
    /// Returns the contacts of the motion that the accuracy of the tools leaves open.
    std::vector<OpenContact> open_contacts();
    /// Applies a decision to each contact of open_contacts(), in order.
    void decide(std::span<const ContactDecision> decisions);

private:
    using Step = toolpath::Step;

    std::optional<Vec3> contact(const cda::Cell& cell, double rounding,
                                const cda::VerifyingModel& part) const;
    void record_if_certain(const PartContact& meeting, Subject subject);
    bool is_away(const Body& body, const Step& step, double raise) const;
    Observation current_observation(Subject subject, std::size_t index = 0) const;
    void record(Observation seen);
    bool wants_volume() const;
    void book(const std::optional<double>& volume);
    static double common_volume(const Step& step, const cda::VerifyingModel& part);
    std::optional<Vec3> find_material(const Step& step, const cda::VerifyingModel& part,
                                      std::uint32_t& rank);
    bool is_rapid_open() const;
    std::optional<Vec3> certain_point(const Step& step, const cda::VerifyingModel& part);
    bool keeps_places() const { return kept_ || setup_.decides_contacts; }
    double drop_to_material(const Step& step, const cda::VerifyingModel& part, double fall,
                            double allowed);
    void follow_core(const Step& step,
                     const std::function<double(double fall, double allowed)>& on_material);
    double needed_raise_of_flutes(FlutesAbove& above, const Step& step,
                                  const cda::VerifyingModel& part, double known, double raise_step);
    const toolpath::Tool& tool_now() const { return setup_.tools.at(move_.motion->tool).tool; }

    const Setup& setup_;
    Box stock_;
    cda::Lattice lattice_;
    Move& move_;
    bool volumes_;
    ToolMonitors* current_ = nullptr;
    std::uint64_t step_ = 0;
    bool has_contact_ = false;
    Evidence* kept_ = nullptr;  // of a tile
    std::optional<Box> place_;  // box of the tile
    // Number of steps of faulty motions whose volume was measured, and the limit of this number. A
    // measurement costs as much as ten cuts. A single fault gets a number, thousands get "at
    // least".
    std::uint64_t measured_ = 0;
    static constexpr std::uint64_t kMostMeasured = 16;
    std::vector<cda::Cell> cells_;  // kept to reuse memory
    // Boxes of open contacts in this motion, by piece of the tool; no piece: the cutter.
    std::map<std::optional<std::size_t>, std::vector<Box>> open_;
};

}  // namespace ncsim::verify
