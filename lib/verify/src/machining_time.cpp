// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machining times as text.
#include "ncsim/verify/machining_time.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace ncsim::verify {

std::optional<double> MachiningTime::total() const {
    if (!feed) return std::nullopt;
    return *feed + rapid + tool_changes + dwells;
}

MachiningTime time_of(const Distances& distances) {
    MachiningTime time;
    time.feed = distances.feed_seconds;
    time.rapid = 60.0 * distances.rapid_mm / kAssumedRapid;
    time.tool_changes = kAssumedToolChange * static_cast<double>(distances.tool_changes);
    time.dwells = distances.dwell_seconds;
    return time;
}

std::string time_line(const Distances& distances) {
    const MachiningTime time = time_of(distances);
    std::string text;
    if (time.total()) {
        text += fmt::format("{}: feed {}, ", time_text(*time.total()), time_text(*time.feed));
    } else {
        text += "unknown, a feed is not specified: ";
    }
    text += fmt::format("rapid {} at {:g} m/min", time_text(time.rapid), 1e-3 * kAssumedRapid);
    if (distances.tool_changes > 0) {
        text += fmt::format(", {} tool change{} of {:g} s", distances.tool_changes,
                            distances.tool_changes == 1 ? "" : "s", kAssumedToolChange);
    }
    if (time.dwells > 0.0) text += fmt::format(", dwells {}", time_text(time.dwells));
    return text + "; without acceleration";
}

std::optional<double> seconds_of(const Ledger& ledger) {
    if (!ledger.feed_seconds || !ledger.rapid_seconds || !ledger.other_seconds) return {};
    return *ledger.feed_seconds + *ledger.rapid_seconds + *ledger.other_seconds;
}

std::string time_line(const Ledger& ledger) {
    const std::optional<double> total = seconds_of(ledger);
    if (!total) return {};
    return fmt::format("{}: feed {}, rapid {}, the rest {}; as the machine is described",
                       time_text(*total), time_text(*ledger.feed_seconds),
                       time_text(*ledger.rapid_seconds), time_text(*ledger.other_seconds));
}

std::string time_text(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
    if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02} h", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace ncsim::verify
