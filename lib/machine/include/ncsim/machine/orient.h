// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of the ways to give the tool a direction a control takes.
#pragma once

#include "ncsim/machine/inverse.h"

#include <map>
#include <optional>

namespace ncsim::machine {

/// From where to where a joint goes; mm or degrees.
struct Travel {
    double min = 0.0, max = 0.0;
    bool operator==(const Travel&) const = default;
};
using Travels = std::map<char, Travel>;  ///< By the letter of the joint; others go anywhere.

/// Of the master joint, or of where it comes to stand.
enum class Prefer {
    Shortest,   ///< The shortest way.
    WayUp,      ///< Only positive ways (LinuxCNC's tilted planes, P1),
    WayDown,    ///< or only negative ones (P2).
    StandUp,    ///< Of both places the one at 0 or above, whatever the way (SEQ+),
    StandDown,  ///< or the one at 0 or below (SEQ-).
};

/// The joint that counts first, which carries the other one: next to the bed of two tables or of
/// two heads, the table of one each. Null without two joints that turn, or with more.
const Joint* master_of(const Chain& chain);

/// Of turns_for() and its whole turns within `travels`: the least way of the master, then of the
/// other joint, then the master's place nearest to 0, then the other's (Fanuc 16i/18i-MB operator's
/// manual, "Angle of rotation axis"). Nothing if no way leads there.
std::optional<Turns> orient(const Chain& placed, cda::Vec3 axis, const Values& now,
                            const Travels& travels = {}, Prefer prefer = Prefer::Shortest);

}  // namespace ncsim::machine
