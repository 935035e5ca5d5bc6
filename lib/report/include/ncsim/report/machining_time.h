// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long a program takes, where no machine is described: constant feeds, and what a machine of
// middling size takes for the rest. Real machines accelerate, and are slower. With a machine
// (ncsim check --machine) its rates count, and its accelerations.
#pragma once

#include "ncsim/verify/distances.h"
#include "ncsim/verify/ledger.h"

#include <optional>
#include <string>

namespace ncsim::report {

inline constexpr double kAssumedRapid = 10'000.0;  ///< mm/min, straight
inline constexpr double kAssumedToolChange = 8.0;  ///< s

/// Seconds. Without a value: some feed is not told.
struct MachiningTime {
    std::optional<double> feed = 0.0;
    double rapid = 0.0, tool_changes = 0.0, dwells = 0.0;

    std::optional<double> total() const;
};

MachiningTime time_of(const verify::Distances& distances);

/// "33:12 min: feed 22:38 min, rapid 1:56 min at 10 m/min, …", with the model.
std::string time_line(const verify::Distances& distances);
/// The same of a machine that is described; empty if some of its rates are not.
std::string time_line(const verify::Ledger& ledger);

/// "0:07 min", "1:02:03 h"
std::string time_text(double seconds);

}  // namespace ncsim::report
