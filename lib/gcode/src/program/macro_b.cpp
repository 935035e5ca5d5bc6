// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fanuc Macro B: IF, GOTO, WHILE … DO, END, and the calls G65, G66, G67.
#include "program/runner.h"

#include <array>
#include <cmath>

namespace ncsim::gcode {

/// Executes the control word.
/// Returns: true if the rest of the block is to be executed (IF … THEN).
bool Runner::macro_word() {
    const Control control = block_.control;
    switch (control.word) {
        case ControlWord::If: {
            const std::optional<bool> holds = condition(control.expression, control.span);
            if (!holds.value_or(false)) return false;
            if (control.label.empty()) return true;
            go_to(control.label);
            return false;
        }
        case ControlWord::Goto: go_to(control.label); return false;
        case ControlWord::While: {
            const std::optional<std::size_t> here = index().at_line(block_.line);
            if (!here) return false;
            // WHILE without a condition: DO n alone, an infinite loop unless a GOTO leaves the
            // loop.
            const bool holds = control.expression.empty() ||
                               condition(control.expression, control.span).value_or(false);
            if (holds) return false;
            const auto end = index().next(*here, index()[*here].label, ControlWord::End);
            if (!end || !index().are_in_one_program(block_.line, index()[*end].line)) {
                fault(Message::BlockEndMissing, control.span, {"END"});
                ended_ = true;
                return false;
            }
            jump(current_, index()[*end].after);
            return false;
        }
        default: {
            const std::optional<std::size_t> here = index().at_line(block_.line);
            if (!here) return false;
            const auto begin = index().previous(*here, index()[*here].label, ControlWord::While);
            if (!begin || !index().are_in_one_program(index()[*begin].line, block_.line)) {
                fault(Message::BlockEndMissing, control.span, {"WHILE"});
                return false;
            }
            jump(current_, index()[*begin].at);
            return false;
        }
    }
}

void Runner::go_to(std::string_view label) {
    const SourceSpan span = block_.control.span;
    const std::optional<double> number = resolver_.value_of(label, span, false);
    if (!number || !(*number >= 0.0 && *number < 4e9)) return;
    const auto n = static_cast<std::uint32_t>(std::lround(*number));
    const std::optional<BlockReader::Place> place = index().find_number(n, block_.line);
    if (!place) {
        fault(Message::LineNotFound, span, {join_label("N", std::to_string(n))});
        ended_ = true;
        return;
    }
    jump(current_, *place);
}

/// G65 calls once; G66 calls after each following move (`g` = 0: the call after a move); G67 ends
/// G66.
void Runner::macro_call(int g) {
    if (g == 67) return modal_call_.clear();
    if (g == 66) {
        modal_call_ = std::string(block_.text);
        modal_level_ = frames_.size();
        return;
    }
    // The arguments of a modal call are in the block with G66.
    Block block = block_;
    SourceFile modal;
    BlockReader modal_reader(modal);
    if (g == 0) {
        modal.text = modal_call_;
        if (!modal_reader.next(block)) return;
        block.line = block_.line;
    }
    constexpr std::array<int, 26> kLocals = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                             0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
    std::array<double, Parameters::kLocals + 1> values;
    values.fill(rules_.arithmetic.vacant ? kVacant : 0.0);
    // Unknown variable on which each value depends.
    std::array<std::string, Parameters::kLocals + 1> unknown;
    std::optional<double> program;
    double runs = 1.0;
    int triple = 0;  // I J K may occur several times: #4 … #6, #7 … #9, …
    char last = 0;
    bool is_argument = false;  // The word is after G65 or G66.
    for (const Word& word : block.words) {
        is_argument |= word.letter == 'G' && (word.number == 65.0 || word.number == 66.0);
        if (!is_argument || word.letter == 'G' || word.letter == 'O') continue;
        std::string depends_on;
        const std::optional<double> value = resolver_.value_to_keep(word, depends_on);
        if (!value) return;
        int n = 0;
        if (word.letter == 'P' || word.letter == 'L')
            resolver_.report_unknown(depends_on, word.span);
        if (word.letter == 'P') {
            program = value;
        } else if (word.letter == 'L') {
            runs = *value;
        } else if (word.letter >= 'I' && word.letter <= 'K') {
            if (last != 0 && word.letter <= last) ++triple;
            last = word.letter;
            n = 4 + 3 * triple + (word.letter - 'I');
        } else if (word.letter >= 'A' && word.letter <= 'Z') {
            n = kLocals[static_cast<std::size_t>(word.letter - 'A')];
        }
        if (n <= 0 || n > static_cast<int>(Parameters::kLocals)) continue;
        values[static_cast<std::size_t>(n)] = *value;
        unknown[static_cast<std::size_t>(n)] = std::move(depends_on);
    }
    const SourceSpan span = block.words.empty() ? block.line_span() : block.words.front().span;
    const std::string name(block.program_name);
    if (name.empty() && (!program || !(*program >= 0.0 && *program < 1e9))) {
        return fault(Message::CallWithoutNumber, span, {"G65"});
    }
    const std::string label = name.empty() ? std::to_string(std::lround(*program)) : name;
    const std::optional<Target> target = name.empty()
                                             ? find_target(ControlWord::ProgramNumber, label, true)
                                             : find_named_program(name);
    if (!target && !name.empty())
        return fault(Message::ProgramNotFound, span, {std::string("<").append(name).append(">")});
    if (!target) {
        if (rules_.macro_b && probe_macro(static_cast<int>(std::lround(*program)), values, span))
            return;
        if (is_control_program(*program)) return report_control_program(*program, span);
        return fault(Message::ProgramNotFound, span, {join_label("O", label)});
    }
    if (!(runs >= 1.0)) return;
    Frame frame;
    frame.kind = CallKind::Macro;
    frame.label = label;
    frame.remaining = static_cast<std::uint64_t>(std::min(runs, 1e9)) - 1;
    frame.has_locals = true;
    frame.local_count = Parameters::kLocals;
    frame.locals = registers_.take_locals(frame.local_count);
    for (std::size_t i = 1; i < values.size(); ++i) {
        registers_.set_numbered(static_cast<double>(i), values[i], unknown[i]);
    }
    enter(std::move(frame), *target);
}

}  // namespace ncsim::gcode
