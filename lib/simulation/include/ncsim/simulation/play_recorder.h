// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records path, tools and states of the part while a program is simulated.
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/play_data.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/toolpath/walk.h"

#include <cstdint>
#include <map>
#include <vector>

namespace ncsim::simulation {

/// Recorder of the tool path and of states of the part, from which a page plays the program.
class PlayRecorder {
public:
    /// Creates a recorder without states. `every`: number of moves between two states of the part;
    /// 0: chosen by the length of the program. Requires: `survey` outlives the object.
    PlayRecorder(const Plan& plan, const Survey& survey, std::uint64_t every);

    /// Records the uncut part.
    void begin(const cda::WorkpieceModel& part);
    /// Begins a motion of a tool.
    void begin_move(const gcode::Motion& motion);
    /// Adds a step of the motion.
    void add_step(const toolpath::Step& step);
    /// Ends the motion. `has_cut`: the motion met the stock.
    void end_move(bool has_cut, const cda::WorkpieceModel& part);
    /// Records the finished part and returns the data. No member function may be called afterwards.
    /// `line_of_origin`: line of each origin of the part.
    PlayData finish(const cda::WorkpieceModel& part, std::vector<std::uint32_t> line_of_origin);

private:
    void record_state(const cda::WorkpieceModel& part);
    bool is_too_large() const;
    void drop_states(bool keeps_last);
    void simplify_move();
    std::uint32_t tool_index(int number);

    const Survey& survey_;
    std::uint64_t every_;
    PlayData data_;
    std::map<int, std::uint32_t> tools_;
    const gcode::Motion* motion_ = nullptr;  // valid between begin_move() and end_move()
    std::uint32_t first_point_ = 0;
    bool has_steps_ = false;
    bool has_changed_ = false;  // cut since the last state
    std::uint64_t moves_since_state_ = 0;
    double seconds_ = 0.0;
};

}  // namespace ncsim::simulation
