// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where program coordinates become motions in W: offsets, units and rotation end here.
//
// Where W is, is known at the first cutting move only. What moves before it is held back, in
// machine coordinates.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/command.h"
#include "text/message.h"

#include <cstdint>
#include <optional>
#include <vector>

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

/// What is known of the place of the axes; see MachineState.
struct Knowledge {
    KnownAxes known, relative, of_machine;
};
/// After a move of the axes of `mask`, to a place of the machine or of the program.
Knowledge after_move(const MachineState& state, AxisMask mask, bool to_machine);
void set_knowledge(MachineState& state, const Knowledge& knows);

/// Program coordinates with G92 and G52, and out of a tilted plane.
Axes out_of_plane(const MachineState& state, const Axes& p);

class Path {
public:
    Path(const InterpreterOptions& options, const MotionSink& sink, DiagnosticLog& log,
         Interpretation& result)
        : options_(options), sink_(sink), log_(log), result_(result) {}

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
    /// The end of the program: lets out what is held back.
    void finish();

    std::uint64_t count() const { return result_.motions; }

private:
    /// A place as the machine has it, and the coordinate system it was said in: the place of its
    /// zero, mm, and its rotation.
    struct Place {
        Position machine;
        std::array<double, 3> zero{};
        double rotation = 0.0;
        OriginFrame frame{};
        AxisMask in_machine = 0;  ///< Axes that were said in machine coordinates.
    };
    struct Held {
        Motion motion;  // machine coordinates
        ProgramFrame frame;
        Place from, to;
        Position centre;                    // of an arc
        std::optional<Place> plane_origin;  // of the tilted plane it lies in
        Axes zero_92{};
        std::array<double, 3> carried_home{};
        OriginFrame origin_frame{};
    };

    static Place place(const MachineState& state, const Axes& p, AxisMask in_machine = 0);
    const Place& start(const MachineState& state);
    bool is_related(const Place& place, std::size_t axis) const;
    /// In W, once that is bound. Where no relation is known, as if the zeros were one.
    Position in_workpiece(const Place& place) const;
    void fill(const MachineState& state, MoveKind kind, AxisMask mask = 0);
    void emit(const MachineState& state, const Place& from, const Place& to,
              const Position& centre = {}, const std::optional<Place>& plane_origin = {});
    void let_out(Motion& motion, const ProgramFrame& frame, const Place& from, const Place& to,
                 const Position& centre, const std::optional<Place>& plane_origin);
    void bind(int system, const WorkOffset& workpiece);
    void bind(const Held& held);
    void arrive(MachineState& state, const Axes& end, const Place& target, AxisMask mask);

    const InterpreterOptions& options_;
    const MotionSink& sink_;
    DiagnosticLog& log_;
    Interpretation& result_;
    SourceSpan span_;
    std::uint32_t file_ = 0;
    bool machine_coordinates_ = false;
    std::optional<Place> at_;                    // where the last motion ended
    std::uint32_t length_changes_ = 0;           // of the state `at_` was told of
    std::optional<Position> at_machine_, at_W_;  // the same of the last one that was let out
    bool bound_ = false;
    std::vector<Held> held_;
    Motion motion_;  // reused: a motion is large
};

}  // namespace ncsim::gcode
