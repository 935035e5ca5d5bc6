// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where program coordinates become motions in W: offsets, units and rotation end here.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/state.h"

#include "command.h"

#include <cstdint>

namespace ncsim::gcode {

/// Indices of the first, second and third axis of each plane.
struct PlaneAxes {
    std::size_t first, second, third;
};
constexpr PlaneAxes axes_of(Plane plane) {
    switch (plane) {
        case Plane::XY: return {kX, kY, kZ};
        case Plane::ZX: return {kZ, kX, kY};
        case Plane::YZ: return {kY, kZ, kX};
        case Plane::UV: return {kU, kV, kW};
        case Plane::WU: return {kW, kU, kV};
        case Plane::VW: return {kV, kW, kU};
    }
    return {kX, kY, kZ};
}

/// An arc in program coordinates.
struct ProgramArc {
    Axes end{};
    double centre_1 = 0.0, centre_2 = 0.0;
    int turns = 1;
};

/// Which axes a block commanded: a bit per Axis.
using AxisMask = std::uint32_t;
constexpr AxisMask kAllAxes = 0x1FF;

class Path {
public:
    Path(const InterpreterOptions& options, const MotionSink& sink, Interpretation& result)
        : options_(options), sink_(sink), result_(result) {}

    /// What the following motions are made by.
    void set_origin(SourceSpan span, std::uint32_t file) { span_ = span, file_ = file; }

    // Each of these moves `state.position` to the end of the motion and makes the axes of `mask`
    // known.
    void straight(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask);
    void arc(MachineState& state, const ProgramArc& arc, AxisMask mask);
    /// `spline` in program coordinates of X and Y, lengths in active units.
    void spline(MachineState& state, const Spline& spline, const Axes& end, AxisMask mask);
    void dwell(const MachineState& state, double seconds);
    void tool_change(const MachineState& state);

    /// The end of the next motions was said in machine coordinates.
    void set_machine_coordinates(bool on) { machine_coordinates_ = on; }
    /// The tool length changed: the tip is elsewhere, though nothing moved.
    void refresh() { stale_ = true; }

    std::uint64_t count() const { return result_.motions; }

private:
    Position in_workpiece(const MachineState& state, const Axes& p) const;
    Position start(const MachineState& state);
    void fill(const MachineState& state, MoveKind kind);
    void emit(const MachineState& state);
    void arrive(MachineState& state, const Axes& end, const Position& target, AxisMask mask);

    const InterpreterOptions& options_;
    const MotionSink& sink_;
    Interpretation& result_;
    SourceSpan span_;
    std::uint32_t file_ = 0;
    bool machine_coordinates_ = false;
    bool stale_ = true;
    Position at_;    // where the last motion ended
    Motion motion_;  // reused: a motion is large
};

}  // namespace ncsim::gcode
