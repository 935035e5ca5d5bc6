// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts moves in program coordinates to motions in W; applies offsets, units and rotation.
//
// W is known only at the first cutting move. Motions before the first cut are held back in machine
// coordinates.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/command.h"
#include "text/message.h"

#include <cstdint>
#include <map>
#include <memory>
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
    bool is_open = false;  ///< Not a full circle, however close the ends are.
    bool operator==(const ProgramArc&) const = default;
};

/// Axes that a block names: a bit per Axis.
using AxisMask = std::uint32_t;
constexpr AxisMask kAllAxes = 0x1FF;
constexpr AxisMask kRotaryAxes = 1U << kA | 1U << kB | 1U << kC;

/// Knowledge of the positions of the axes; see MachineState.
struct Knowledge {
    KnownAxes known, relative, of_machine;
};
/// Returns the knowledge after a move of the axes `mask` to a position of the machine
/// (`to_machine`) or of the program.
Knowledge after_move(const MachineState& state, AxisMask mask, bool to_machine);
void set_knowledge(MachineState& state, const Knowledge& knows);
/// Records a move of the axes `mask`: knowledge and reference of the positions.
void record_move(MachineState& state, AxisMask mask, bool to_machine);

/// Makes motions and passes the motions to the sink.
class Path {
public:
    Path(const InterpreterOptions& options, const MotionSink& sink, DiagnosticLog& log,
         Interpretation& result)
        : options_(options), sink_(sink), log_(log), result_(result) {}

    /// Sets the block and the file of the following motions.
    void set_origin(SourceSpan span, std::uint32_t file) { span_ = span, file_ = file; }

    // Each of the functions moves `state.position` to the end of the motion and makes the axes of
    // `mask` known.
    void linear_move(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask);
    void arc(MachineState& state, const ProgramArc& arc, AxisMask mask);
    /// `spline` is in program coordinates of X and Y, lengths in active units.
    void spline(MachineState& state, const Spline& spline, const Axes& end, AxisMask mask);
    void dwell(const MachineState& state, double seconds);
    void tool_change(const MachineState& state);

    /// States that the ends of the following motions are in machine coordinates.
    void set_machine_coordinates(bool on) { machine_coordinates_ = on; }
    /// Adds `distance_mm` along `axis` to the machine coordinates of positions and of W with an
    /// unspecified reference.
    /// Requires: no used reference along `axis` is specified.
    void shift_unspecified(std::size_t axis, double distance_mm);
    /// Records that the block of the current origin sets the origin of `system`.
    void record_offset(int system) { offset_places_[system] = {file_, span_}; }
    /// Ends the program: passes held motions to the sink.
    void finish();

    std::uint64_t count() const { return result_.motions; }

private:
    /// A position in machine coordinates, and the references in which X, Y and Z are known.
    struct Place {
        Position machine;
        OriginFrame frame{};
    };
    struct HeldMotion {
        Motion motion;  // Machine coordinates.
        ProgramFrame frame;
        Place from, to;
        Position centre;                    // Centre of an arc.
        std::optional<Place> plane_origin;  // Origin of the tilted plane of an arc.
        Axes zero_92{};
        std::array<bool, 3> is_zero_by_hand{};
        std::array<double, 3> dynamic_offset_home{};
        OriginFrame origin_frame{};
    };

    static Place place(const MachineState& state, const Axes& p);
    const Place& start(const MachineState& state);
    /// Returns the end of a move of the axes `mask` from `from` to `end`. Axes at rest, and
    /// increments, keep the references of `from`.
    Place target(const MachineState& state, const Place& from, const Axes& end,
                 AxisMask mask) const;
    bool is_related(const Place& place, std::size_t axis) const;
    void warn_of_frame(const Motion& motion, const Place& to, int system);
    /// Returns `place` in W.
    /// Requires: W is chosen.
    Position in_workpiece(const Place& place) const;
    void compare_offset(const ProgramFrame& frame, const OriginFrame& origin_frame,
                        const std::array<bool, 3>& is_zero_by_hand);
    void fill(const MachineState& state, MoveKind kind, AxisMask mask = 0);
    void emit(const MachineState& state, const Place& from, const Place& to,
              const Position& centre = {}, const std::optional<Place>& plane_origin = {});
    void emit_motion(Motion& motion, const ProgramFrame& frame, const Place& from, const Place& to,
                     const Position& centre, const std::optional<Place>& plane_origin);
    void bind(int system, const WorkOffset& workpiece, const std::array<bool, 3>& is_zero_by_hand);
    void bind(const HeldMotion& held);
    void set_end(MachineState& state, const Axes& end, const Place& target, AxisMask mask);

    const InterpreterOptions& options_;
    const MotionSink& sink_;
    DiagnosticLog& log_;
    Interpretation& result_;
    SourceSpan span_;
    std::uint32_t file_ = 0;
    bool machine_coordinates_ = false;
    std::optional<Place> at_;           // End of the last motion.
    std::uint32_t length_changes_ = 0;  // Value of MachineState::length_changes for `at_`.
    // End of the last motion passed to the sink.
    std::optional<Position> last_end_machine_, last_end_workpiece_;
    std::shared_ptr<const ProgramFrame> last_frame_;  // of the last motion
    bool bound_ = false;
    OriginFrame frame_W_{};  // Reference of W. Valid if bound_.
    std::vector<HeldMotion> held_;
    std::map<int, ProgramPlace> offset_places_;  // Blocks that set origins, by system.
    std::set<int> compared_;                     // Systems with a cut.
    Motion motion_;                              // Reused because a motion is large.
};

}  // namespace ncsim::gcode
