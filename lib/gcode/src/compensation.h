// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cutter radius compensation (G41, G42): the path is moved aside by the radius. Outside corners get
// an arc about the corner, inside corners end where the moved paths meet. One move is held back,
// because only the next one tells where it ends.
#pragma once

#include "ncsim/gcode/state.h"

#include "message.h"
#include "path.h"

#include <utility>
#include <vector>

namespace ncsim::gcode {

class Compensation {
    struct Vec {
        double x = 0.0, y = 0.0;
    };
    /// A programmed move in the plane.
    struct Element {
        MachineState state;  // as it was when it was programmed
        Axes end{};
        MoveKind kind = MoveKind::Feed;
        AxisMask mask = 0;
        SourceSpan span;
        std::uint32_t file = 0;
        bool is_arc = false;
        Vec from, to, centre;
        int turns = 1;
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
    };

public:
    /// All it remembers between two moves: a value, to go back to.
    struct State {
        double side = 1.0;  // 1: left
        double radius = 0.0;
        bool entering = true;
        bool holds = false;
        Element held;
        std::vector<Follower> followers;
        Axes at{};  // where the tool is, program coordinates
    };

    Compensation(Path& path, DiagnosticLog& log) : path_(path), log_(log) {}

    const State& state() const { return s_; }
    void set_state(State state) { s_ = std::move(state); }

    /// From the next move on. `radius` in program units, positive.
    void begin(CutterSide side, double radius);
    /// The same, with the tool beside the start of the next move already, at `at`.
    void begin_beside(CutterSide side, double radius, const Axes& at);
    bool is_on() const { return s_.radius > 0.0; }

    // Like those of Path, for programmed moves. False after reporting a move that cannot be made.
    bool straight(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                  SourceSpan span, std::uint32_t file);
    bool arc(MachineState& state, const ProgramArc& arc, AxisMask mask, SourceSpan span,
             std::uint32_t file);
    void dwell(const MachineState& state, double seconds, SourceSpan span, std::uint32_t file);

    /// Lets out the move held back, and puts `state.position` where the tool then is.
    void flush(MachineState& state);
    void end(MachineState& state);

private:
    struct Circle {
        Vec centre;
        double radius = 0.0;
    };
    bool take(MachineState& state, Element element);
    bool join(const Element& next);
    bool meeting_point(const Element& a, const Element& b, Vec& point) const;
    void emit(Element& element, Vec end);
    Vec start_tangent(const Element& e) const;
    Vec end_tangent(const Element& e) const;
    Vec beside(Vec point, Vec tangent) const;
    double offset_radius(const Element& e) const;
    double radius_of(const Element& e) const;

    Path& path_;
    DiagnosticLog& log_;
    State s_;
};

}  // namespace ncsim::gcode
