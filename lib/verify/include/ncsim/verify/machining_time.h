// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machining time without a machine description: constant feeds, and typical values of a
// medium-sized machine for rapid moves and tool changes. Real machines accelerate and are slower.
// With `ncsim check --machine`, the rates and accelerations of the machine are used.
#pragma once

#include "ncsim/verify/distances.h"
#include "ncsim/verify/ledger.h"

#include <optional>
#include <string>

namespace ncsim::verify {

inline constexpr double kAssumedRapid = 10'000.0;  ///< mm/min along the path
inline constexpr double kAssumedToolChange = 8.0;  ///< s

/// Times in seconds; `feed` is nullopt if some feed is not specified.
struct MachiningTime {
    std::optional<double> feed = 0.0;
    double rapid = 0.0, tool_changes = 0.0, dwells = 0.0;

    /// Returns the sum; nullopt if a feed is not specified.
    std::optional<double> total() const;
};

/// Returns the machining time for `distances`.
MachiningTime time_of(const Distances& distances);

/// Returns "33:12 min: feed 22:38 min, rapid 1:56 min at 10 m/min, …", with the assumptions.
std::string time_line(const Distances& distances);
/// Returns the sum of the times, s; empty if one of them is not known.
std::optional<double> seconds_of(const Ledger& ledger);
/// Returns a line with the times on a described machine; empty if some rate is not specified.
std::string time_line(const Ledger& ledger);

/// Returns "0:07 min" or "1:02:03 h".
std::string time_text(double seconds);

}  // namespace ncsim::verify
