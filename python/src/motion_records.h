// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions of a program, and rows of its ledger, as records of NumPy arrays.
#pragma once

#include "ncsim/simulation/plan.h"
#include "ncsim/verify/ledger.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace ncsim::python {

/// Kind of a motion; the values are those of ncsim.Kind.
enum class RecordKind : std::uint8_t { Rapid, Feed, Probe, Dwell, ToolChange };
/// Path of a motion; the values are those of ncsim.Shape.
enum class RecordShape : std::uint8_t { None, Line, Arc, Spline };

/// Value of an unknown number.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A motion. Positions of X, Y, Z in mm in W; of A, B, C in degrees. NaN: unknown.
struct MotionRecord {
    std::uint32_t file = 0;  ///< Number of the file: 0 is the program.
    std::uint32_t line = 0, column = 0;
    std::int32_t tool = 0;
    std::uint8_t kind = 0;   ///< A RecordKind.
    std::uint8_t shape = 0;  ///< A RecordShape.
    std::array<double, 3> start{}, end{}, start_angles{}, end_angles{};
    double feed = kUnknown;     ///< mm/min, 1/min or mm/rev as programmed.
    double speed = 0.0;         ///< Speed of the spindle, 1/min.
    double length = kUnknown;   ///< Path of the tip, mm.
    double seconds = kUnknown;  ///< Time at the programmed feed; unknown for rapid moves.
};

/// A row of the ledger: one execution of a block.
struct LedgerRecord {
    std::uint32_t file = 0, line = 0;
    std::uint64_t first_motion = 0, last_motion = 0;  ///< From 1, in the order of execution.
    std::int32_t tool = 0;
    std::uint8_t kind = 0;  ///< A RecordKind.
    double length = 0.0, removed = 0.0, seconds = kUnknown;
};

/// Returns the motions of the program in the order of execution.
std::vector<MotionRecord> motion_records(const simulation::Plan& plan);
std::vector<LedgerRecord> ledger_records(const verify::Ledger& ledger);

/// Registers the types of the records with NumPy, once. NumPy is loaded only then.
/// Requires: the caller holds the global interpreter lock.
void register_records();

}  // namespace ncsim::python
