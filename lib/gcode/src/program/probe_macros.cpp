// SPDX-License-Identifier: GPL-3.0-or-later
//
// Probing macros of Renishaw (Inspection Plus), which most controls have, for programs without the
// text of the macros.
// Source: Renishaw, Inspection Plus software, programming guide.
#include "ncsim/gcode/print.h"

#include "program/runner.h"

#include <cmath>

namespace ncsim::gcode {
namespace {

/// Numbers of the local variables F, and X (then Y, Z).
constexpr std::size_t kF = 9;
constexpr std::size_t kFirstAxis = 24;
constexpr double kProbeFeed = 1000.0;  // mm/min, if neither the call nor the program sets a feed.

std::string word_text(char letter, double value) {
    std::string out(1, letter);
    print_number(out, value);
    return out;
}

}  // namespace

/// Executes the block `text` in place of the current block.
void Runner::execute_text(const std::string& text, SourceSpan span) {
    const SourceFile inside{{}, text};
    BlockReader reader(inside);
    Block block;
    Command command;
    if (!reader.next(block) || !resolver_.resolve(block, command)) return;
    command.span = span;
    machine_.set_origin(span, static_cast<std::uint32_t>(current_));
    machine_.execute(command);
}

/// Makes the moves of the macro `number`. P9832 and P9833 turn the probe on and off, P9810 moves to
/// X Y Z, and a contact on its way is an alarm; P9811 measures a surface and returns.
/// Returns: false if the macro is unknown.
bool Runner::probe_macro(int number, const std::array<double, Parameters::kLocals + 1>& values,
                         SourceSpan span) {
    const std::string name = "P" + std::to_string(number);
    if (number == 9832 || number == 9833) {
        log_.add(Message::ProbeMacro, span, {name, "moves nothing"});
        return true;
    }
    if (number != 9810 && number != 9811) return false;
    // The macros compute with coordinates, which G68, G51 and G16 transform.
    const ProgrammedTransform& programmed = machine_.state().frames.programmed;
    if (programmed.rotated || programmed.scaled || programmed.polar) return false;
    std::string there;
    std::string back;
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::isnan(values[kFirstAxis + i])) continue;
        const char letter = "XYZ"[i];
        there += word_text(letter, values[kFirstAxis + i]);
        back += word_text(letter, machine_.state().position[i]);
    }
    if (there.empty()) return false;
    const MachineState before = machine_.state();
    std::string feed;
    if (!std::isnan(values[kF])) {
        feed = word_text('F', values[kF]);
    } else if (!(before.feed > 0.0)) {
        feed = word_text('F', kProbeFeed / before.unit_mm());
    }
    log_.add(Message::ProbeMacro, span,
             {name, number == 9810 ? "moves there, protected" : "measures there and comes back"});
    execute_text((number == 9810 ? "G1" : "G31") + there + feed, span);
    if (number == 9811) execute_text("G90G1" + back, span);
    MachineState& after = machine_.state();
    after.motion = before.motion;
    after.last_straight = before.last_straight;
    after.incremental = before.incremental;
    after.feed = before.feed;
    return true;
}

}  // namespace ncsim::gcode
