// SPDX-License-Identifier: GPL-3.0-or-later
//
// Context of the execution of a block: the set-up, the outputs, and what a refused block does not
// restore.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/source.h"

#include "control/command.h"
#include "control/control_rules.h"
#include "control/control_state.h"
#include "control/cycles/outline.h"
#include "control/paths/arc_centres.h"
#include "control/paths/compensation.h"
#include "control/paths/distance_evidence.h"
#include "control/paths/path.h"
#include "text/message.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Options and rules of the control. Constant during the program.
struct Setup {
    const InterpreterOptions& options;
    const Rules& rules;
};

/// Facts about the executed program, for Interpretation.
struct ProgramEvidence {
    bool uses_length_offsets = false;
    bool requested_tip_positions = false;
    bool distance_is_stated = false;  ///< G90 or G91 was executed.
    DistanceEvidence distance;
    std::set<int> unread_registers;  ///< Specified registers that no G41 and no G42 has read.
    double setting_askew = 0.0;
};

/// The outline of a G150.
struct OutlineRecord {
    std::optional<ControlState> before;  ///< State before the outline, while moves are recorded.
    std::vector<OutlineMove> moves;
    bool is_foreign = true;  ///< A move changed axes other than X and Y, or there is no outline.

    bool is_recording() const { return before.has_value(); }
};

/// See the head of the file.
struct Context : Setup {
    ArcCentres& centres;
    DiagnosticLog& log;
    Path& path;
    SourceSpan span = {};  ///< Block and file of the motions.
    std::uint32_t file = 0;
    ProgramEvidence facts = {};
    OutlineRecord outline = {};
    /// If the block is refused, the curve that contains the block is discarded.
    bool curve_fails = false;
    bool ended = false;  ///< M2 or M30 was executed.
    /// A code that makes correct simulation impossible was reported.
    bool stopped = false;
};

/// Sets the block and the file of the following motions.
void set_origin(SourceSpan span, std::uint32_t file, Context& context);

/// Returns cutter compensation for moves of `control`. Valid as long as both arguments.
inline Compensation compensation_of(ControlState& control, Context& context) {
    return {control.compensation, context.path, context.log, context.rules.is_linuxcnc()};
}

// --- Reports ---

/// Returns the place of the word `letter`, or of the block.
SourceSpan span_of(const Command& command, char letter);
/// Returns the place of the G code `code`, or of the block.
SourceSpan span_of_g(const Command& command, Code code);

/// Reports an error.
/// Returns: false.
bool fail(Context& context, const MessageText& message, SourceSpan span,
          std::initializer_list<std::string_view> arguments = {});
/// Reports an error that makes correct simulation impossible.
/// Returns: false.
bool stop_with(Context& context, const MessageText& message, SourceSpan span,
               std::initializer_list<std::string_view> arguments = {});
/// Reports that `name` needs `what`.
/// Returns: false.
bool lacks(Context& context, const Command& command, std::string_view name, std::string_view what);
void warn(Context& context, const MessageText& message, SourceSpan span,
          std::initializer_list<std::string_view> arguments = {});
/// Reports a warning, or an error under strict rules.
/// Returns: true if it was a warning.
bool tolerate(Context& context, const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments = {});

}  // namespace ncsim::gcode
