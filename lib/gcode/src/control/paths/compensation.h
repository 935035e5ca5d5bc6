// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cutter radius compensation (G41, G42): the path is moved aside by the radius. Outside corners get
// an arc about the corner, inside corners end where the moved paths meet. One move is held back,
// because only the next one tells where it ends.
#pragma once

#include "ncsim/gcode/state.h"

#include "control/growing_list.h"
#include "control/paths/path.h"
#include "control/rare.h"
#include "text/message.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace ncsim::gcode {

/// All that cutter compensation remembers between two moves.
struct CompensationState {
    /// A place in the plane, program coordinates.
    struct Vec {
        double x = 0.0, y = 0.0;
        bool operator==(const Vec&) const = default;
    };
    /// A programmed move in the plane.
    struct Element {
        MachineState state;  ///< As it was when it was programmed.
        Axes end{};
        MoveKind kind = MoveKind::Feed;
        AxisMask mask = 0;
        SourceSpan span;
        std::uint32_t file = 0;
        bool is_arc = false;
        Vec from, to, centre;
        int turns = 1;
        bool is_open = false;  ///< As ProgramArc.
        bool operator==(const Element&) const = default;
    };
    /// A move that leaves the plane alone, or a pause, to be made when the element before has
    /// ended.
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
    /// The programmed end of the last move, while that differs from where the tool is.
    std::optional<Axes> programmed;
    Rare<Element> held;
    /// The move before, if it was made to its end before the next one was known (M0 on LinuxCNC).
    Rare<Element> made;
    GrowingList<Follower> followers;
    Axes at{};  ///< Where the tool is, program coordinates.
    bool operator==(const CompensationState&) const = default;
};

class Compensation {
    using Vec = CompensationState::Vec;
    using Element = CompensationState::Element;
    using Follower = CompensationState::Follower;

public:
    /// Works on `state`, which somebody else keeps.
    Compensation(CompensationState& state, Path& path, DiagnosticLog& log)
        : s_(state), path_(path), log_(log) {}

    /// From the next move on. `radius` in program units, positive.
    void begin(CutterSide side, double radius, CompensationStart start);
    /// The same, with the tool beside the start of the next move already, at `at`.
    void begin_beside(CutterSide side, double radius, const Axes& at);
    bool is_on() const { return s_.radius > 0.0; }
    /// On, and the next move is the first one.
    bool is_entering() const { return is_on() && s_.entering; }

    // Like those of Path, for programmed moves. False after reporting a move that cannot be made.
    bool straight(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                  SourceSpan span, std::uint32_t file);
    bool arc(MachineState& state, const ProgramArc& arc, AxisMask mask, SourceSpan span,
             std::uint32_t file);
    void dwell(const MachineState& state, double seconds, SourceSpan span, std::uint32_t file);

    /// Makes the move held back to its end, without regard to the next one, which goes on from
    /// there (a stop on LinuxCNC).
    void make_held();
    /// The programmed end of the last move; nothing before the first one.
    std::optional<Axes> programmed_end() const { return s_.programmed; }
    /// Does what LinuxCNC does: outside corners before a rapid are cut straight, and a first move
    /// that is not longer than the radius is an error. Other controls begin square to the next
    /// move then.
    void set_linuxcnc(bool on) { is_linuxcnc_ = on; }
    /// Converts all lengths by `factor`, and states by `convert`.
    void convert_units(double factor, const std::function<void(MachineState&)>& convert);

    /// Lets out the move held back, and puts `state.position` where the tool then is.
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
    Vec beside(Vec point, Vec tangent) const;
    double offset_radius(const Element& e) const;
    double radius_of(const Element& e) const;

    CompensationState& s_;
    Path& path_;
    DiagnosticLog& log_;
    bool is_linuxcnc_ = false;
};

}  // namespace ncsim::gcode
