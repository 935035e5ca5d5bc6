// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a tool meets of the part in one motion, measured step by step before and after its cells are
// taken away; changes nothing but the Move it is noted in. What is asked and what is noted are two:
// who has a tile of the part asks, and who has all that tiles saw notes the same.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/setup.h"

#include "move.h"
#include "watched.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::verify {

class Measuring {
public:
    /// `setup` and `move`, in which everything is noted, must outlive it; `stock` (mm, W) and
    /// `lattice` are those of the part. `volumes`: somebody measures what every step removes.
    Measuring(const Setup& setup, const cda::Box& stock, const cda::Lattice& lattice, Move& move,
              bool volumes)
        : setup_(setup), stock_(stock), lattice_(lattice), move_(move), volumes_(volumes) {}

    /// All that is noted is written down, too. `place` (mm, W): where the tile is.
    void keep(Evidence& evidence, const cda::Box& place) {
        kept_ = &evidence;
        place_ = place;
    }
    /// A motion begins, with the tool that is watched; null: nobody describes it.
    void begin(Watched* tool) {
        now_ = tool;
        open_.clear();
        step_ = 0;
    }
    /// A step begins: before anything is asked about it.
    void begin_step() {
        ++step_;
        meets_now_ = false;
    }
    /// Which one is at hand, from 1.
    std::uint64_t step() const { return step_; }

    /// How far the cutter's cells of this step may lie off for rounding alone, mm.
    double rounding_now(const toolpath::Step& step) const;
    void meet_at_feed(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// Most rapid moves meet nothing, which is cheap to ask; the rest is looked at closely.
    void meet_rapidly(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// Shanks and holders.
    void meet_bodies(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// What does not cut at the centre.
    void meet_core(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// The same with what tiles saw of it; null: nothing.
    void meet_core(const toolpath::Step& step, const Observation* seen);
    /// What cuts above the limit of depth.
    void meet_too_high(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// Flutes that nobody told.
    void meet_uncertain(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// The wall of the thread where a thread mill starts to go up.
    void meet_wall(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// How high the material is into which the tool goes straight down.
    void meet_mouth(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// The flat tip of a chamfer mill.
    void meet_tip(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// The step removed `volume`, mm³; `is_exact`: if that is more than nothing, it met material.
    void take_off(const toolpath::Step& step, double volume, bool is_exact);
    /// Notes what was seen of the part, but for the core. Throws std::runtime_error if it cannot
    /// have been seen in this motion.
    void note(const Observation& seen);
    /// What the accuracy of the tools leaves open, finer ones may decide.
    void look_closer();

private:
    using Step = toolpath::Step;

    std::optional<cda::Vec3> contact(const cda::Cell& cell, double rounding,
                                     const cda::WorkpieceModel& part) const;
    bool is_away(const Body& body, const Step& step, double raise) const;
    Observation seen_now(Subject subject, std::size_t index = 0) const;
    void tell(Observation seen);
    bool wants_volume() const;
    void book(const std::optional<double>& volume);
    static double common_volume(const Step& step, const cda::WorkpieceModel& part);
    std::optional<cda::Vec3> find_material(const Step& step, const cda::WorkpieceModel& part,
                                           std::uint32_t& rank);
    std::optional<Certainty> second_look(std::string_view rule, std::optional<std::size_t> piece);
    std::optional<cda::Vec3> certain_point(const Step& step, const cda::WorkpieceModel& part);
    bool keeps_places() const { return kept_ || setup_.second_look; }
    double fall_on_material(const Step& step, const cda::WorkpieceModel& part, double fall,
                            double allowed);
    void follow_core(const Step& step,
                     const std::function<double(double fall, double allowed)>& on_material);
    double needed_above(Above& above, const Step& step, const cda::WorkpieceModel& part,
                        double known, double raise_step);
    const toolpath::Tool& tool_now() const { return setup_.tools.at(move_.motion->tool).tool; }

    const Setup& setup_;
    cda::Box stock_;
    cda::Lattice lattice_;
    Move& move_;
    bool volumes_;
    Watched* now_ = nullptr;
    std::uint64_t step_ = 0;
    bool meets_now_ = false;
    Evidence* kept_ = nullptr;       // of a tile
    std::optional<cda::Box> place_;  // where that is
    // Steps of faulty motions of which the volume was measured, each as dear as ten that are only
    // cut, and how many that may be: one fault has a number, thousands have "at least".
    std::uint64_t measured_ = 0;
    static constexpr std::uint64_t kMostMeasured = 16;
    std::vector<cda::Cell> cells_;  // kept for its memory
    // Of this motion: where it is open whether a piece, or what cuts, touches.
    std::map<std::optional<std::size_t>, std::vector<cda::Box>> open_;
};

}  // namespace ncsim::verify
