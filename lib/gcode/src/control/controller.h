// SPDX-License-Identifier: GPL-3.0-or-later
//
// Controller: executes commands. Modes, offsets and moves take effect in the order of execution of
// RS274/NGC, not in the order of writing.
// Source: Kramer, Proctor, Messina, 2000, table 8.
//
// Controller owns the state and the context. The steps of a block are free functions; the
// parameters of a step say what the step may read and change: block_steps.h, paths/path_steps.h,
// frames/frame_steps.h, cycles/cycle_steps.h.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/command.h"
#include "control/context.h"
#include "control/control_rules.h"
#include "control/control_state.h"
#include "control/frames/frame_steps.h"
#include "control/parameters.h"
#include "control/system_variable.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace ncsim::gcode {

/// Executes the commands of a program.
class Controller {
public:
    Controller(const InterpreterOptions& options, const Rules& rules, ArcCentres& centres,
               DiagnosticLog& log, Path& path, Parameters& parameters);
    Controller(const Controller&) = delete;  // `parameters` show the state of this object.
    Controller& operator=(const Controller&) = delete;

    /// Executes `command`.
    /// Returns: false after reporting an error. If the command made no motion before the error,
    /// control() is restored, except that a curve that the command should have ended is discarded.
    bool execute(const Command& command);

    // Saves and restores the modes of a call level: M70 … M73 of LinuxCNC.
    struct SavedModes;
    std::shared_ptr<const SavedModes> save_modes() const;
    bool restore_modes(const SavedModes& saved, SourceSpan span);

    /// Starts cutter compensation with the tool at the offset position of `contour`, a programmed
    /// position; the next move begins at `contour`.
    void begin_compensation_at(CutterSide side, double radius, const Axes& contour);

    // Outline of a G150: between begin_contour() and end_outline(), moves are recorded and not
    // made.
    bool begin_contour(const Command& command);
    void end_outline();

    bool ended() const { return context_.ended; }  ///< M2 or M30 was executed.
    /// True after a code that makes correct simulation impossible; the code was reported.
    bool stopped() const { return context_.stopped; }
    const ControlState& control() const { return control_; }
    const MachineState& state() const { return control_.machine; }
    MachineState& state() { return control_.machine; }

    /// Makes held moves (a corner, cutter compensation).
    void flush();
    /// Sets the block and the file of the following motions.
    void set_origin(SourceSpan span, std::uint32_t file);

    /// Sets an offset that the program writes as a variable. `is_relative`: `value` depends on an
    /// unknown position.
    /// Returns: true if the variable shows the state of the machine afterwards; false if the
    /// variable keeps the assigned number.
    bool set_variable(const SystemVariable& variable, double value, bool is_relative,
                      SourceSpan span);
    /// Acts as M0 does.
    void pause();

    // For languages other than G-code, whose blocks have no words of G-code for these actions.
    /// Sets the tilted plane `frame`, in coordinates of the datum and active units. The rotary axes
    /// do not turn. `name`: the words of the program.
    bool tilt(const FeatureFrame& frame, std::string_view name, SourceSpan span);
    /// Ends the tilted plane, if any.
    void end_tilt();
    /// Returns the positions of the rotary axes that make the tool normal to the tilted plane;
    /// nullopt after reporting an error.
    std::optional<Axes> axes_of_tilt(LeadingAxis leading, std::string_view name, SourceSpan span);
    /// Turns the rotary axes to `axes`. `tip_stays`: the tip stays in place; otherwise X, Y and Z
    /// of the machine stay.
    void turn_axes(const Axes& axes, MoveKind kind, bool tip_stays);

    /// Ends the program and resets the modes to the start values of the control.
    void finish();

    /// Adds units, lengths, registers and guesses of the executed program to `result`.
    void report_to(Interpretation& result) const;

private:
    ControlState control_;
    Context context_;
};

}  // namespace ncsim::gcode
