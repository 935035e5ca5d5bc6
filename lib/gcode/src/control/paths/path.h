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
#include <map>
#include <optional>
#include <set>
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
    bool is_open = false;  ///< No full circle, however near its ends are to each other.
};

/// Which axes a block commanded: a bit per Axis.
using AxisMask = std::uint32_t;
constexpr AxisMask kAllAxes = 0x1FF;
constexpr AxisMask kRotaryAxes = 1U << kA | 1U << kB | 1U << kC;

/// What is known of the place of the axes; see MachineState.
struct Knowledge {
    KnownAxes known, relative, of_machine;
};
/// After a move of the axes of `mask`, to a place of the machine or of the program.
Knowledge after_move(const MachineState& state, AxisMask mask, bool to_machine);
void set_knowledge(MachineState& state, const Knowledge& knows);
/// Records a move of the axes of `mask`: what is known of their places, and in which frame.
void record_move(MachineState& state, AxisMask mask, bool to_machine);

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
    /// Adds `distance_mm` along `axis` to the machine coordinates of places and of W that are known
    /// in an unspecified frame. Requires: no used frame along `axis` is specified.
    void shift_unspecified(std::size_t axis, double distance_mm);
    /// The block at the current origin sets the origin of `system`.
    void record_offset(int system) { offset_places_[system] = {file_, span_}; }
    /// The end of the program: lets out what is held back.
    void finish();

    std::uint64_t count() const { return result_.motions; }

private:
    /// A place as the machine has it, and the frames in which X, Y and Z of it are known.
    struct Place {
        Position machine;
        OriginFrame frame{};
    };
    struct Held {
        Motion motion;  // machine coordinates
        ProgramFrame frame;
        Place from, to;
        Position centre;                    // of an arc
        std::optional<Place> plane_origin;  // of the tilted plane it lies in
        Axes zero_92{};
        std::array<bool, 3> is_zero_by_hand{};
        std::array<double, 3> carried_home{};
        OriginFrame origin_frame{};
    };

    static Place place(const MachineState& state, const Axes& p);
    const Place& start(const MachineState& state);
    /// Returns the end of a move of the axes of `mask` from `from` to `end`. Axes that do not move,
    /// and increments, stay in the frames of `from`.
    Place target(const MachineState& state, const Place& from, const Axes& end,
                 AxisMask mask) const;
    bool is_related(const Place& place, std::size_t axis) const;
    void warn_of_frame(const Motion& motion, const Place& to, int system);
    /// In W, once that is bound.
    Position in_workpiece(const Place& place) const;
    void compare_offset(const ProgramFrame& frame, const OriginFrame& origin_frame,
                        const std::array<bool, 3>& is_zero_by_hand);
    void fill(const MachineState& state, MoveKind kind, AxisMask mask = 0);
    void emit(const MachineState& state, const Place& from, const Place& to,
              const Position& centre = {}, const std::optional<Place>& plane_origin = {});
    void let_out(Motion& motion, const ProgramFrame& frame, const Place& from, const Place& to,
                 const Position& centre, const std::optional<Place>& plane_origin);
    void bind(int system, const WorkOffset& workpiece, const std::array<bool, 3>& is_zero_by_hand);
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
    OriginFrame frame_W_{};  // of W, once that is bound
    std::vector<Held> held_;
    std::map<int, ProgramPlace> offset_places_;  // of the blocks that set origins, by system
    std::set<int> compared_;                     // systems with a cut
    Motion motion_;                              // reused: a motion is large
};

}  // namespace ncsim::gcode
