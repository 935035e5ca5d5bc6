// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cutter radius compensation (G41, G42): offsets the path by the radius. Outside corners get an arc
// about the corner; inside corners end at the intersection of the offset paths. Each move is held
// back because the end depends on the next move.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/gcode/state.h"

#include "control/growing_list.h"
#include "control/paths/path.h"
#include "control/rare.h"
#include "text/message.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace ncsim::gcode {

/// State of cutter compensation between two moves.
struct CompensationState {
    using Vec = Vec2;  ///< A point in the plane, program coordinates.
    /// A programmed move in the plane.
    struct Element {
        MachineState state;  ///< State when the move was programmed.
        Axes end{};
        MoveKind kind = MoveKind::Feed;
        AxisMask mask = 0;
        SourceSpan span;
        std::uint32_t file = 0;
        bool is_arc = false;
        Vec from, to, centre;
        int turns = 1;
        bool is_open = false;  ///< See ProgramArc.
        bool operator==(const Element&) const = default;
    };
    /// A move outside the plane, or a pause, to make after the end of the preceding element.
    struct Follower {
        MachineState state;
        Axes end{};
        MoveKind kind = MoveKind::Feed;
        AxisMask mask = 0;
        SourceSpan span;
        std::uint32_t file = 0;
        bool is_dwell = false;
        double seconds = 0.0;
        bool operator==(const Follower&) const = default;
    };

    double side = 1.0;    ///< 1: left, -1: right.
    double radius = 0.0;  ///< Program units; 0: off.
    bool entering = true;
    CompensationStart start = CompensationStart::SquareToItself;
    bool held_enters = false;  ///< `held` is the move that begins compensation.
    /// Programmed end of the last move, if different from the position of the tool.
    std::optional<Axes> programmed;
    Rare<Element> held;
    /// The previous move, if made to the end before the next move was known (M0 on LinuxCNC).
    Rare<Element> made;
    GrowingList<Follower> followers;
    Axes at{};  ///< Position of the tool, program coordinates.

    /// Multiplies all lengths by `factor`, and converts states by `convert`.
    void convert_units(double factor, const std::function<void(MachineState&)>& convert);
    bool is_on() const { return radius > 0.0; }
    /// True if on, and the next move starts the compensation.
    bool is_entering() const { return is_on() && entering; }
    bool operator==(const CompensationState&) const = default;
};

/// Moves of the tool under cutter radius compensation.
class Compensation {
    using Vec = CompensationState::Vec;
    using Element = CompensationState::Element;
    using Follower = CompensationState::Follower;

public:
    /// `is_linuxcnc`: outside corners before a rapid are straight, and a first move not longer than
    /// the radius is an error. On other controls such a first move starts square to the next move.
    /// Requires: `state`, `path` and `log` outlive this object.
    Compensation(CompensationState& state, Path& path, DiagnosticLog& log, bool is_linuxcnc)
        : s_(state), path_(path), log_(log), is_linuxcnc_(is_linuxcnc) {}

    /// Starts compensation with the next move. `radius` > 0, program units.
    void begin(CutterSide side, double radius, CompensationStart start);
    /// Starts compensation with the tool already at the offset position `at` of the next move's
    /// start.
    void begin_at_offset(CutterSide side, double radius, const Axes& at);

    // Same as the functions of Path, for programmed moves. Return false after reporting a move that
    // cannot be made.
    bool linear_move(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                     SourceSpan span, std::uint32_t file);
    bool arc(MachineState& state, const ProgramArc& arc, AxisMask mask, SourceSpan span,
             std::uint32_t file);
    void dwell(const MachineState& state, double seconds, SourceSpan span, std::uint32_t file);

    /// Makes the held move to the end without regard to the next move, which continues from there
    /// (a stop on LinuxCNC).
    void finish_held();

    /// Makes the held move and sets `state.position` to the position of the tool.
    void flush(MachineState& state);
    void end(MachineState& state);

private:
    struct Circle {
        Vec centre;
        double radius = 0.0;
    };
    bool take(MachineState& state, Element element);
    bool enter(MachineState& state, Element& element);
    bool place_centre(Element& element, const Axes& at) const;
    bool join(const Element& next);
    bool meeting_point(const Element& a, const Element& b, Vec& point) const;
    void emit(Element element, Vec end);
    Vec start_tangent(const Element& e) const;
    Vec end_tangent(const Element& e) const;
    Vec offset_point(Vec point, Vec tangent) const;
    double offset_radius(const Element& e) const;
    double radius_of(const Element& e) const;

    CompensationState& s_;
    Path& path_;
    DiagnosticLog& log_;
    bool is_linuxcnc_;
};

}  // namespace ncsim::gcode
