// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the interpreter asks of somebody who knows how the machine is built: this library itself
// knows no joints.
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/state.h"

#include <optional>
#include <string>

namespace ncsim::gcode {

/// Places are machine coordinates of the controlled point, without the length of the tool: mm and
/// degrees. While no axis is turned they are those of the tip on the part, W; where one is, the
/// part turns with its table, and its places are told as they are when all stand at 0.
class JointSolver {
public:
    virtual ~JointSolver() = default;

    /// Does the machine turn at all?
    virtual bool turns() const = 0;

    /// The tip of a tool of `length_mm`, and the direction from it to the spindle, on the part.
    struct Stand {
        Triple tip{};
        Triple axis{0, 0, 1};
    };
    virtual Stand stand_of(const Axes& joints, double length_mm) const = 0;

    /// X, Y and Z that bring the tip there with the rest of `joints` as it is; nothing where they
    /// cannot.
    virtual std::optional<Axes> joints_for(const Triple& tip, const Axes& joints,
                                           double length_mm) const = 0;

    /// A direction with a length that is fixed to the table, as the machine has it with the joints
    /// at `to`: with those at `from` it is `v`.
    virtual Triple with_table(const Triple& v, const Axes& from, const Axes& to) const = 0;

    /// Which of several ways to take, of the joint that counts first.
    enum class Way : unsigned char { Told, Up, Down };
    /// The turns that give the tool the direction `axis`, of unit length, from where `joints`
    /// stand.
    struct Turned {
        std::optional<Axes> joints;
        bool singular = false;  ///< One of the joints might stand anywhere: it stays.
        std::string why_not;
    };
    virtual Turned turned_to(const Triple& axis, const Axes& joints, Way way) const = 0;
};

}  // namespace ncsim::gcode
