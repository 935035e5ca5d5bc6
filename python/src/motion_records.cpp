// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts motions and rows of the ledger to records.
#include "motion_records.h"

#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/verify/distances.h"

#include <pybind11/numpy.h>

#include <mutex>
#include <variant>

namespace ncsim::python {

namespace {

using gcode::Motion;

RecordKind kind_of(const Motion& motion) {
    if (std::holds_alternative<gcode::Dwell>(motion.action)) return RecordKind::Dwell;
    if (std::holds_alternative<gcode::ToolChange>(motion.action)) return RecordKind::ToolChange;
    return static_cast<RecordKind>(motion.kind);
}

RecordShape shape_of(const Motion& motion) {
    if (std::holds_alternative<gcode::Linear>(motion.action)) return RecordShape::Line;
    if (std::holds_alternative<gcode::Arc>(motion.action)) return RecordShape::Arc;
    if (std::holds_alternative<gcode::Spline>(motion.action)) return RecordShape::Spline;
    return RecordShape::None;
}

std::array<double, 3> place_of(const gcode::Position* p, const gcode::KnownAxes& known) {
    if (!p) return {kUnknown, kUnknown, kUnknown};
    return {known.x ? p->x.mm() : kUnknown, known.y ? p->y.mm() : kUnknown,
            known.z ? p->z.mm() : kUnknown};
}

std::array<double, 3> angles_of(const gcode::Position* p) {
    if (!p) return {kUnknown, kUnknown, kUnknown};
    return {p->a.degrees(), p->b.degrees(), p->c.degrees()};
}

// Sets path and time of a motion with a known start, of a dwell or a tool change.
void measure(MotionRecord& record, const Motion& motion, const toolpath::Kinematics* machine) {
    const bool moves = gcode::start_of(motion) != nullptr;
    if (moves && !(motion.known_start.all() && motion.known_end.all())) return;
    verify::Distances distances;
    verify::add(distances, motion, machine);
    if (moves) record.length = distances.rapid_mm + distances.feed_mm;
    if (const auto* dwell = std::get_if<gcode::Dwell>(&motion.action)) {
        record.seconds = dwell->seconds;
    } else if (moves && motion.kind == gcode::MoveKind::Feed) {
        record.seconds = distances.feed_seconds.value_or(kUnknown);
    }
}

MotionRecord record_of(const Motion& motion, const toolpath::Kinematics* machine) {
    MotionRecord record;
    record.file = motion.file;
    record.line = motion.span.line;
    record.column = motion.span.column;
    const auto* change = std::get_if<gcode::ToolChange>(&motion.action);
    record.tool = change ? change->tool : motion.tool;
    record.kind = static_cast<std::uint8_t>(kind_of(motion));
    record.shape = static_cast<std::uint8_t>(shape_of(motion));
    record.start = place_of(gcode::start_of(motion), motion.known_start);
    record.end = place_of(gcode::end_of(motion), motion.known_end);
    record.start_angles = angles_of(gcode::start_of(motion));
    record.end_angles = angles_of(gcode::end_of(motion));
    if (motion.feed > 0.0) record.feed = motion.feed;
    if (motion.spindle != gcode::SpindleTurning::Stopped) record.speed = motion.spindle_rpm;
    measure(record, motion, machine);
    return record;
}

}  // namespace

std::vector<MotionRecord> motion_records(const simulation::Plan& plan) {
    std::vector<MotionRecord> records;
    gcode::interpret(plan.job.program, plan.job.interpreter, [&](const Motion& motion) {
        records.push_back(record_of(motion, plan.placed.get()));
    });
    return records;
}

std::vector<LedgerRecord> ledger_records(const verify::Ledger& ledger) {
    std::vector<LedgerRecord> records;
    records.reserve(ledger.rows.size());
    for (const verify::LedgerRow& row : ledger.rows) {
        records.push_back({row.file, row.line, row.first_motion, row.last_motion, row.tool,
                           static_cast<std::uint8_t>(row.kind), row.length_mm, row.removed_mm3,
                           row.seconds.value_or(kUnknown)});
    }
    return records;
}

void register_records() {
    static std::mutex mutex;
    static bool is_registered = false;
    std::unique_lock lock(mutex, std::defer_lock);
    {
        // The thread that has the mutex may wait for the interpreter.
        const pybind11::gil_scoped_release release;
        lock.lock();
    }
    if (is_registered) return;
    PYBIND11_NUMPY_DTYPE(MotionRecord, file, line, column, tool, kind, shape, start, end,
                         start_angles, end_angles, feed, speed, length, seconds);
    PYBIND11_NUMPY_DTYPE(LedgerRecord, file, line, first_motion, last_motion, tool, kind, length,
                         removed, seconds);
    is_registered = true;
}

}  // namespace ncsim::python
