// SPDX-License-Identifier: GPL-3.0-or-later
//
// O-words of RS274/NGC as in LinuxCNC: branches, loops, subroutines.
#include "program/runner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::gcode {

void Runner::o_word() {
    const Control& control = block_.control;
    switch (control.word) {
        case ControlWord::ProgramNumber: {
            if (frames_.empty()) {
                in_main_title_ = true;
                return;
            }
            // Execution reaches the next program because the current program has no M99.
            Frame& frame = frames_.back();
            if (frame.kind == CallKind::Subprogram && !rules_.strict) {
                finish_subprogram();
            } else if (rules_.strict) {
                fault(Message::CallForms, control.span, {join_label("O", control.label)});
            }
            return;
        }
        case ControlWord::Call: return o_call();
        default: break;
    }
    const std::optional<std::size_t> here = index().at_line(block_.line);
    if (!here) return;
    const std::size_t i = *here;
    const ProgramIndex& marks = index();
    const std::string& label = marks[i].label;
    if (rules_.strict && !check_label(i)) {
        ended_ = true;
        return;
    }
    switch (control.word) {
        case ControlWord::Sub: {
            // A subroutine is skipped; the body is executed by calls.
            const auto end = marks.next(i, label, ControlWord::EndSub);
            if (!end) {
                // The rest of the file belongs to the subroutine.
                log_.add(rules_.strict ? Severity::Error : Severity::Warning,
                         Message::SubEndMissing, control.span, {label});
                ended_ = true;
                return;
            }
            jump(current_, marks[*end].after);
            return;
        }
        case ControlWord::EndSub:
        case ControlWord::Return: {
            if (frames_.empty()) {
                if (!rules_.strict) return;
                fault(Message::ReturnOutside, control.span, {join_label("O", label)});
                ended_ = true;
                return;
            }
            Frame& frame = frames_.back();
            if (rules_.strict && frame.kind != CallKind::OWord) {
                return fault(Message::CallForms, control.span, {join_label("O", label)});
            }
            registers_.view.has_return_value = false;
            registers_.view.return_value = 0.0;
            if (!control.expression.empty()) {
                const std::optional<double> value =
                    resolver_.value_of(control.expression, control.span, false);
                if (value) {
                    registers_.view.return_value = std::isnan(*value) ? 0.0 : *value;
                    registers_.view.has_return_value = true;
                }
            }
            finish_subprogram();
            return;
        }
        case ControlWord::OIf:
        case ControlWord::OElseIf:
        case ControlWord::OElse: return o_branch(i);
        case ControlWord::OWhile:
        case ControlWord::OEndWhile:
        case ControlWord::ORepeat:
        case ControlWord::OEndRepeat: return o_loop(i);
        case ControlWord::OBreak:
        case ControlWord::OContinue: return o_leave(i);
        default: return;
    }
}

/// Reports the subroutine at marker `i` if LinuxCNC refuses the definition: a repeated name, a
/// nested definition, or a call before the definition.
/// Returns: false if refused.
bool Runner::check_sub(std::size_t i) {
    const ProgramIndex& marks = index();
    const std::string& label = marks[i].label;
    const auto refuse = [&](const MessageText& message) {
        fault(message, block_.control.span, {join_label("O", label)});
        return false;
    };
    if (in_main_title_ || !frames_.empty()) return refuse(Message::SubNested);
    const auto [defined, is_new] = subs_.try_emplace(label, current_, block_.line);
    if (!is_new && defined->second != std::pair{current_, block_.line})
        return refuse(Message::SubTwice);
    if (is_new && called_.contains(label)) return refuse(Message::SubNested);
    const auto end = marks.next(i, label, ControlWord::EndSub);
    for (std::size_t inner = i + 1; inner < (end ? *end : marks.markers().size()); ++inner) {
        if (marks[inner].word != ControlWord::Sub) continue;
        fault(Message::SubNested, {marks[inner].line, 1, 1}, {join_label("O", marks[inner].label)});
        return false;
    }
    return true;
}

/// Reports the label of marker `i` if LinuxCNC refuses the label: not a whole number, used for two
/// structures in a subroutine, or without an opening word.
/// Returns: false if refused.
bool Runner::check_label(std::size_t i) {
    const ProgramIndex& marks = index();
    const Marker& here = marks[i];
    const auto refuse = [&](const MessageText& message) {
        fault(message, block_.control.span, {join_label("O", here.label)});
        return false;
    };
    const bool is_name = block_.control.label.starts_with('<');
    if (!is_name && block_.control.label.find('.') != std::string_view::npos)
        return refuse(Message::NotWhole);
    const std::pair key{frames_.empty() ? std::string() : frames_.back().label, here.label};
    const std::pair place{current_, here.line};
    const auto opens = [&] {
        const auto [known, is_new] = labels_.try_emplace(key, place);
        return is_new || known->second == place || refuse(Message::LabelTwice);
    };
    switch (here.word) {
        case ControlWord::Sub: return check_sub(i);
        case ControlWord::OIf:
        case ControlWord::ORepeat: return opens();
        case ControlWord::OWhile: {
            const auto opening = marks.previous(i, here.label, ControlWord::ODo,
                                                ControlWord::OWhile, ControlWord::OEndWhile);
            const bool closes = opening && marks[*opening].word == ControlWord::ODo;
            return closes || opens();
        }
        case ControlWord::ODo: labels_[key] = place; return true;
        case ControlWord::OElseIf:
        case ControlWord::OElse:
        case ControlWord::OEndIf:
        case ControlWord::OEndWhile:
        case ControlWord::OEndRepeat:
            return labels_.contains(key) || refuse(Message::LabelUnopened);
        default: return true;
    }
}

void Runner::o_branch(std::size_t i) {
    const ProgramIndex& marks = index();
    const Marker& here = marks[i];
    const bool jumped_to = else_if_line_ == here.line;
    else_if_line_ = 0;
    if (here.word != ControlWord::OIf && !jumped_to) {
        // The previous branch was executed: continue after the end.
        const SourceSpan rest = block_.control.rest;
        if (rules_.strict && rest.length > 0)
            return fault(Message::UnreadableText, rest,
                         {std::string_view(block_.text).substr(rest.column - 1, rest.length)});
        const auto end = marks.next(i, here.label, ControlWord::OEndIf);
        if (!end) return fault(Message::BlockEndMissing, block_.control.span, {"endif"});
        jump(current_, marks[*end].after);
        return;
    }
    if (here.word == ControlWord::OElse) return;
    const std::optional<bool> holds = condition(block_.control.expression, block_.control.span);
    if (holds.value_or(false)) return;
    const auto next =
        marks.next(i, here.label, ControlWord::OElseIf, ControlWord::OElse, ControlWord::OEndIf);
    if (!next) {
        fault(Message::BlockEndMissing, block_.control.span, {"endif"});
        ended_ = true;
        return;
    }
    if (marks[*next].word == ControlWord::OElseIf) {
        else_if_line_ = marks[*next].line;
        jump(current_, marks[*next].at);
    } else {
        jump(current_, marks[*next].after);
    }
}

void Runner::o_loop(std::size_t i) {
    const ProgramIndex& marks = index();
    const Marker& here = marks[i];
    const SourceSpan span = block_.control.span;
    const auto stop = [&](std::string_view what) {
        fault(Message::BlockEndMissing, span, {what});
        ended_ = true;
    };
    switch (here.word) {
        case ControlWord::OWhile: {
            const std::optional<bool> holds = condition(block_.control.expression, span);
            const auto opening = marks.previous(i, here.label, ControlWord::ODo,
                                                ControlWord::OWhile, ControlWord::OEndWhile);
            if (opening && marks[*opening].word == ControlWord::ODo) {
                // do … while: jumps to the beginning while the condition holds.
                if (holds.value_or(false)) jump(current_, marks[*opening].after);
                return;
            }
            if (holds.value_or(false)) return;
            const auto end = marks.next(i, here.label, ControlWord::OEndWhile);
            if (!end) return stop("endwhile");
            jump(current_, marks[*end].after);
            return;
        }
        case ControlWord::OEndWhile: {
            const auto begin = marks.previous(i, here.label, ControlWord::OWhile);
            if (!begin) return stop("while");
            jump(current_, marks[*begin].at);
            return;
        }
        case ControlWord::ORepeat: {
            const std::optional<double> times =
                resolver_.value_of(block_.control.expression, span, !rules_.strict);
            const double whole = times && !std::isnan(*times) ? std::nearbyint(*times) : 0.0;
            if (whole < 1.0) {
                const auto end = marks.next(i, here.label, ControlWord::OEndRepeat);
                if (!end) return stop("endrepeat");
                jump(current_, marks[*end].after);
                return;
            }
            constexpr std::size_t kMostNested = 10'000;
            if (repeats_.size() >= kMostNested) return stop("endrepeat");
            repeats_.push_back(
                {here.label, current_, static_cast<std::uint64_t>(std::min(whole, 1e15)) - 1});
            return;
        }
        default: {
            const auto begin = marks.previous(i, here.label, ControlWord::ORepeat);
            if (!begin || repeats_.empty() || repeats_.back().label != here.label) return;
            if (repeats_.back().remaining == 0) {
                repeats_.pop_back();
                return;
            }
            --repeats_.back().remaining;
            jump(current_, marks[*begin].after);
            return;
        }
    }
}

void Runner::o_leave(std::size_t i) {
    const ProgramIndex& marks = index();
    const Marker& here = marks[i];
    const bool breaks = here.word == ControlWord::OBreak;
    const auto begin =
        marks.previous(i, here.label, ControlWord::OWhile, ControlWord::ODo, ControlWord::ORepeat);
    if (!begin) return fault(Message::BlockEndMissing, block_.control.span, {"while"});
    const ControlWord kind = marks[*begin].word;
    const ControlWord closing = kind == ControlWord::ODo       ? ControlWord::OWhile
                                : kind == ControlWord::ORepeat ? ControlWord::OEndRepeat
                                                               : ControlWord::OEndWhile;
    const auto end = marks.next(i, here.label, closing);
    if (!end) {
        fault(Message::BlockEndMissing, block_.control.span, {"endwhile"});
        ended_ = true;
        return;
    }
    if (kind == ControlWord::ORepeat && breaks && !repeats_.empty() &&
        repeats_.back().label == here.label) {
        repeats_.pop_back();
    }
    if (breaks) {
        jump(current_, marks[*end].after);
    } else {
        jump(current_, kind == ControlWord::OWhile ? marks[*begin].at : marks[*end].at);
    }
}

void Runner::o_call() {
    const Control control = block_.control;
    const std::optional<std::string> label = label_of(control.label, control.span);
    if (!label) return;
    std::array<double, 30> arguments{};
    std::array<std::string, 30> unknown;  // Variable on which each argument depends.
    std::size_t count = 0;
    std::string_view rest = control.expression;
    while (!rest.empty()) {
        ExpressionFault found;
        const std::optional<double> value =
            evaluate_first(rest, registers_, rules_.arithmetic, found);
        if (!value) {
            log_.add(Severity::Error, found.message, control.span, {found.argument});
            return;
        }
        if (count >= arguments.size()) return fault(Message::CallArguments, control.span);
        unknown[count] = registers_.take_unknown();
        arguments[count++] = std::isnan(*value) ? 0.0 : *value;
    }
    const std::optional<Target> target = find_target(ControlWord::Sub, *label, true);
    if (!target) {
        const bool other_form = find_target(ControlWord::ProgramNumber, *label, false).has_value();
        fault(other_form ? Message::CallForms : Message::SubNotFound, control.span,
              {join_label("O", *label)});
        // The following blocks assume the call; without the call the cuts would be arbitrary.
        if (rules_.strict) ended_ = true;
        return;
    }
    called_.insert(*label);
    Frame frame;
    frame.kind = CallKind::OWord;
    frame.label = *label;
    frame.has_locals = true;
    frame.local_count = 30;
    frame.locals = registers_.take_locals(frame.local_count);
    for (std::size_t i = 0; i < count; ++i) {
        registers_.set_numbered(static_cast<double>(i + 1), arguments[i], unknown[i]);
    }
    enter(std::move(frame), *target);
}

}  // namespace ncsim::gcode
