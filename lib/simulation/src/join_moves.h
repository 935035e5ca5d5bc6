// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joining of successive short moves on a line, for drafts. Post-processors that write a curve as
// points 0.1 mm apart make a program of a thousand cuts whose picture fifty cuts would show as
// well.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/operation_name.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::simulation {

/// Joins successive straight moves.
class MoveJoiner {
public:
    /// Receives a motion and the number of motions that were joined to it, at least 1.
    using Sink = std::function<void(const gcode::Motion&, std::size_t count)>;

    /// Passes motions on to `sink`, in order. A joined move stays within `tolerance_mm` of every
    /// end of its moves, passes the ends in order, and has the block of its first move; 0 joins no
    /// moves. Moves in front of and behind one of `names`, which must outlive the object, are not
    /// joined.
    MoveJoiner(double tolerance_mm, Sink sink, std::span<const toolpath::OperationName> names);

    /// Adds a motion. Cost: the length of the current row, at most 256 places.
    void take(const gcode::Motion& motion);
    /// Passes on the held move. Requires: the last motion was added.
    void flush();
    /// True if any moves were joined.
    bool has_joined() const { return has_joined_; }

private:
    bool can_join(const gcode::Motion& next) const;
    bool has_name_before(const gcode::Motion& next) const;

    double tolerance_mm_;
    Sink sink_;
    std::span<const toolpath::OperationName> names_;
    std::uint32_t last_line_ = 0;  ///< Last line of the held move.
    /// Joined move from the start of the row to its current end.
    std::optional<gcode::Motion> held_;
    std::vector<Vec3> intermediate_ends_;  ///< Intermediate ends, mm.
    bool has_joined_ = false;
};

}  // namespace ncsim::simulation
