// SPDX-License-Identifier: GPL-3.0-or-later
//
// Execution of a block.
#include "program/runner.h"

#include "text/line_end.h"
#include "text/number.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {

namespace {

bool is_macro_call(const Word& word) {
    return word.letter == 'G' && word.literal && word.number >= 65.0 && word.number <= 67.0 &&
           word.number == std::floor(word.number);
}

bool has_g(const Block& block, double number) {
    return std::ranges::any_of(block.words, [number](const Word& word) {
        return word.letter == 'G' && word.literal && word.number == number;
    });
}

bool uses_variables(const Block& block) {
    return !block.assignments.empty() ||
           std::ranges::any_of(block.words, [](const Word& word) { return !word.literal; });
}

}  // namespace

Runner::Runner(const SourceFile& program, const InterpreterOptions& options, const Rules& rules,
               ArcCentres& centres, const MotionSink& sink, DiagnosticLog& log,
               Interpretation& result)
    : ProgramRunner(program, options, rules, centres, sink, log, result),
      rules_(rules),
      resolver_(rules, registers_, log, options) {
    for (const auto& [name, value] : options.variables)
        registers_.specify(name, value);
    files_.push_back({&program, nullptr, BlockReader(program, {.strict = rules.strict}), nullptr});
}

void Runner::run() {
    ProgramRunner::run();
    result_.inherited_modes = head_modes_.unset(rules_.dialect);
}

void Runner::report_missing_end(std::uint32_t line) {
    log_.add(rules_.strict ? Severity::Error : Severity::Note, Message::ProgramEndMissing,
             {line, 1, 0});
}

bool Runner::step() {
    if (!file().reader.next(block_, log_)) {
        if (frames_.empty()) return false;
        // A subprogram file without M99 or endsub returns at the end.
        if (rules_.strict && frames_.back().kind == CallKind::OWord) {
            fault(Message::SubEndMissing, {block_.line, 1, 0}, {frames_.back().label});
        }
        finish_subprogram();
        return true;
    }
    ++result_.lines;
    // Blocks beyond the number of lines were read before, by a loop or a call.
    if (!frames_.empty() || repeated_ > 0) file().reader.keep_lines();
    if (!count_block(!frames_.empty(), block_.line_span())) return false;
    constexpr std::size_t kLongestStrict = 252;  // Limit of LinuxCNC.
    const bool is_long = rules_.strict && block_.text.size() > kLongestStrict;
    if (is_long && block_.text.find_first_not_of(' ') != std::string_view::npos) {
        fault(Message::LineTooLong, {block_.line, 1, 1});
        ended_ = true;
        return false;
    }
    registers_.view.line = block_.line;
    if (block_.kind != BlockKind::Words) {
        if (block_.kind == BlockKind::Percent) return percent();
        return true;
    }
    if (block_.deletable.length > 0) {
        const bool does_something = block_.control.word != ControlWord::None ||
                                    !block_.words.empty() || !block_.assignments.empty();
        if (does_something) note_deletable(current_, block_.deletable);
    }
    if (block_.control.word != ControlWord::None) {
        something_read_ = true;
        if (block_.control.word < ControlWord::If) {
            o_word();
            if (block_.control.word != ControlWord::ProgramNumber) return !ended_;
        } else if (!macro_word()) {
            return !ended_;
        }
    }
    if (block_.words.empty() && block_.assignments.empty()) {
        if (!block_.comments.empty() && !rules_.strict) tool_change_in_comment();
        return true;
    }
    something_read_ = true;
    if (rules_.only_grbl && uses_variables(block_)) {
        log_.add(Message::NotOfGrbl, block_.line_span(), {"variables"});
        return true;
    }
    if (!block_.words.empty()) act_on_words();
    if (!block_.assignments.empty()) assign(block_);
    return true;
}

/// Executes the first `count` words of the block. Words before G65, G66 or G67 are no arguments.
void Runner::execute_before(std::size_t count) {
    if (count == 0) return;
    Block before = block_;
    before.words.resize(count);
    if (!resolver_.resolve(before, command_)) return;
    machine_.set_origin(command_.span, static_cast<std::uint32_t>(current_));
    machine_.execute(command_);
}

void Runner::act_on_words() {
    if (data_lines_ != 0 && take_data_line()) return;
    if (!rules_.strict) {
        const auto call = std::ranges::find_if(block_.words, is_macro_call);
        if (call != block_.words.end()) {
            const int g = static_cast<int>(call->number);
            execute_before(static_cast<std::size_t>(call - block_.words.begin()));
            return macro_call(g);
        }
    }
    if (!resolver_.resolve(block_, command_)) return;
    note_control_dependent();
    note_language();
    head_modes_.note(command_);
    if (options_.least_increments) {
        scale_increments();
    } else if (rules_.macro_b) {
        check_points();
        note_points();
    }
    machine_.set_origin(command_.span, static_cast<std::uint32_t>(current_));
    const std::uint64_t motions = path_.count();
    const int call = command_.group(MGroup::Call);
    if (call != kNone) {
        // P, L, Q belong to the call. The rest of the block is executed before the call.
        Command rest = command_;
        rest.present &= ~(!rules_.strict ? letters('P', 'L', 'Q')
                          : call == 98   ? letters('P', 'L')
                                         : 0U);
        rest.m[static_cast<std::size_t>(MGroup::Call)] = kNone;
        rest.axis_words = rest.has_any(kAxisLetters);
        if (block_.words.size() > 1) machine_.execute(rest);
        call_code(call);
        return;
    }
    if (command_.group(Group::Pocket) == Code::G150 && !record_outline()) return;
    if (command_.group(MGroup::Other) != kNone && !rules_.macro_b)
        save_or_restore(command_.group(MGroup::Other));
    machine_.execute(command_);
    begin_data_lines();
    note_blend();
    if (machine_.stopped()) {
        stop();
        return;
    }
    if (machine_.ended()) return end();
    // Moves of the macro itself trigger no calls.
    if (!modal_call_.empty() && path_.count() > motions && frames_.size() <= modal_level_)
        macro_call(0);
}

/// Reports moves behind G290, with which SINUMERIK leaves the ISO language that G291 selects.
void Runner::note_language() {
    constexpr double kNative = 290.0;
    constexpr double kIso = 291.0;
    if (has_g(block_, kNative)) is_native_ = true;
    if (has_g(block_, kIso)) is_native_ = false;
    if (!is_native_ || !command_.axis_words) return;
    log_.add(Message::LanguageSwitch, command_.span);
    is_native_ = false;
}

/// Records the first block that controls execute in different ways (Rules).
void Runner::note_control_dependent() {
    if (result_.control_dependent) return;
    const Code one_shot = command_.group(Group::OneShot);
    const Code side = command_.group(Group::CutterSide);
    const auto is_zero = [this](char letter) {
        return command_.has(letter) && command_[letter] == 0.0;
    };
    if (!is_cycle(command_.group(Group::Motion)) && (side == Code::None || side == Code::G40) &&
        one_shot != Code::G10 && one_shot != Code::G28 && one_shot != Code::G30 &&
        command_.group(MGroup::Other) == kNone && command_.group(MGroup::Call) == kNone &&
        !is_zero('H') && !is_zero('D') && !command_.from_one_side && !uses_variables(block_))
        return;
    result_.control_dependent = {static_cast<std::uint32_t>(current_), command_.span};
}

namespace {

constexpr std::string_view kLengthLetters = "XYZUVWIJKRQABC";

bool has_point(const Block& block, const Word& word) {
    const std::string_view text = block.text.substr(word.span.column - 1, word.span.length);
    return !word.literal || text.find('.') != std::string_view::npos;
}

}  // namespace

/// True for words whose numbers are lengths or angles.
bool Runner::counts_increments(const Word& word) const {
    if (kLengthLetters.find(word.letter) == std::string_view::npos) return false;
    if (command_.group(Group::OneShot) == Code::G4) return false;
    // K is the number of repeats.
    const Code motion = command_.group(Group::Motion);
    const bool drills = is_cycle(motion == Code::None ? machine_.state().motion : motion);
    return !(word.letter == 'K' && rules_.k_repeats && drills);
}

/// Records the largest tolerance of G64, as in G64 P0.05 of LinuxCNC; G64 of Fanuc has no P.
void Runner::note_blend() {
    if (rules_.macro_b || command_.group(Group::PathMode) != Code::G64 || !command_.has('P'))
        return;
    const double mm = command_['P'] * machine_.state().unit_mm();
    if (mm <= result_.blend_mm) return;
    result_.blend_mm = mm;
    result_.blend = {static_cast<std::uint32_t>(current_), command_.span};
}

void Runner::note_points() {
    if (result_.has_points && result_.without_point) return;
    for (const Word& word : block_.words) {
        if (!word.literal || !counts_increments(word)) continue;
        if (has_point(block_, word)) {
            result_.has_points = true;
        } else if (word.number != 0.0 && !result_.without_point) {
            result_.without_point = {static_cast<std::uint32_t>(current_), word.span};
        }
    }
}

/// Scales numbers without a decimal point by 0.001 mm, 0.001 degrees or 0.0001 inch.
void Runner::scale_increments() {
    const Code units = command_.group(Group::Units);
    const bool inches =
        units == Code::None ? machine_.state().inches : units == Code::G20 || units == Code::G70;
    const bool pattern =
        command_.group(Group::HolePattern) != Code::None;  // J and K are angles in hole patterns.
    for (const Word& word : block_.words) {
        if (!counts_increments(word) || has_point(block_, word)) continue;
        if (word.comma) {
            // A block has each comma word at most once; repeated comma words are errors.
            if (word.letter == 'A') {
                command_.angle *= 1e-3;
            } else {
                command_.corner_size *= inches ? 1e-4 : 1e-3;
            }
            continue;
        }
        const bool is_angle = (word.letter >= 'A' && word.letter <= 'C') ||
                              (pattern && (word.letter == 'J' || word.letter == 'K'));
        command_.value[letter_index(word.letter)] *= inches && !is_angle ? 1e-4 : 1e-3;
    }
}

/// Reports values of 1000 or more without a decimal point, which may be in least increments.
void Runner::check_points() {
    constexpr double kSuspicious = 1000.0;
    for (const char letter : {'X', 'Y', 'Z'}) {
        if (!command_.has(letter) || std::abs(command_[letter]) < kSuspicious) continue;
        const Word* word = find_word(block_, letter);
        if (!word || has_point(block_, *word)) continue;
        const std::string_view text = block_.text.substr(word->span.column - 1, word->span.length);
        if (!has_reported_points_) log_.add(Message::NoPoint, word->span, {text});
        has_reported_points_ = true;
    }
}

/// True if the lines before the block are blank.
bool Runner::is_first_text() const {
    const std::string_view text = files_[current_].source->text;
    const std::string_view blank = text.substr(0, text.find_first_not_of(" \t\r\n"));
    return std::ranges::count(blank, '\n') + 1 == block_.line;
}

/// A '%' in the first line opens a program, the next '%' closes the program. Any other '%' is
/// ignored; LinuxCNC refuses it, and a '%' with text behind it.
bool Runner::percent() {
    if (current_ != 0) return true;
    const std::string_view text = block_.text;
    const bool bare = text.find_first_not_of(" \t%") == std::string_view::npos;
    if (rules_.strict && (!bare || (!percent_opened_ && !is_first_text()))) {
        fault(Message::LetterExpected, {block_.line, 1, 1}, {"%"});
        return false;
    }
    if (!something_read_ && !percent_opened_) {
        percent_opened_ = true;
        return true;
    }
    if (!percent_opened_) return true;
    if (!rules_.strict) {
        // "% spindle on" is a comment. A '%' before the first block does not close the program.
        if (!bare || !something_read_) return true;
    }
    machine_.flush();
    end();
    return true;
}

/// Assigns variables. All assignments of a block take effect together, after the words and
/// right-hand sides of the block are evaluated.
bool Runner::assign(const Block& block) {
    struct Pending {
        const Assignment* assignment;
        double value;
        double number;
        std::string unknown;  // The variable on which the value depends.
    };
    std::vector<Pending> pending;
    for (const Assignment& assignment : block.assignments) {
        std::string unknown;
        const std::optional<double> value =
            resolver_.value_to_keep(assignment.value, assignment.span, !rules_.strict, unknown);
        if (!value) return false;
        double number = 0.0;
        if (!assignment.target.starts_with('<')) {
            const std::optional<double> n =
                resolver_.value_of(assignment.target, assignment.span, false);
            if (!n) return false;
            number = *n;
        }
        pending.push_back({&assignment, *value, number, std::move(unknown)});
    }
    if (!pending.empty() && !result_.control_dependent)
        result_.control_dependent = {static_cast<std::uint32_t>(current_),
                                     block.assignments.front().span};
    for (const Pending& p : pending) {
        std::string_view target = p.assignment->target;
        if (target.starts_with('<')) {
            target = target.substr(1, target.size() - 2);
            if (!registers_.set_named(target, p.value, p.unknown)) {
                log_.add(Message::ParameterReadOnly, p.assignment->span, {p.assignment->target});
            }
        } else if (!assign_number(*p.assignment, p.number, p.value, p.unknown)) {
            log_.add(Parameters::is_read_only(p.number) ? Message::ParameterReadOnly
                                                        : Message::ParameterRange,
                     p.assignment->span, {target});
        }
        if (ended_) break;
    }
    return true;
}

/// Sets #`number` and makes the control act on the value.
/// Returns: false if there is no such parameter.
bool Runner::assign_number(const Assignment& assignment, double number, double value,
                           const std::string& unknown) {
    if (!registers_.set_numbered(number, value, unknown)) return false;
    const int n = static_cast<int>(std::lround(number));
    const SystemVariable variable = system_variable(n, rules_);
    if (variable.effect == SystemVariable::Effect::Stored) return true;
    resolver_.report_unknown(unknown, assignment.span);
    const std::string name = std::string("#").append(std::to_string(n));
    if (std::isnan(value)) return true;
    switch (variable.effect) {
        case SystemVariable::Effect::Alarm: {
            std::string text(assignment.value);
            for (const Comment& comment : block_.comments)
                text.append(" (").append(comment.text).append(")");
            log_.add(Message::ControlAlarm, assignment.span, {text});
            machine_.flush();
            ended_ = true;
            return true;
        }
        case SystemVariable::Effect::Stop: machine_.pause(); return true;
        case SystemVariable::Effect::NotApplied:
            if (std::ranges::find(options_.allow, name) != options_.allow.end()) return true;
            log_.add(Message::VariableNotApplied, assignment.span, {name});
            return true;
        default: break;
    }
    machine_.set_origin(assignment.span, static_cast<std::uint32_t>(current_));
    if (machine_.set_variable(variable, value, !unknown.empty(), assignment.span))
        registers_.show_machine(n);
    return true;
}

void Runner::tool_change_in_comment() {
    for (const Comment& comment : block_.comments) {
        const int tool = tool_called_in(comment);
        if (tool < 0) continue;
        // Before the first tool and the first feed, the operator loads the tool in any case.
        const MachineState& state = machine_.state();
        const bool is_first = state.tool == 0 && state.feed == 0.0;
        log_.add(is_first || state.tool == tool ? Severity::Note : Severity::Warning,
                 Message::ToolChangeInComment, comment.span);
        const SourceFile inside{{}, std::string(comment.text)};
        Block block;
        BlockReader(inside).next(block);
        if (!resolver_.resolve(block, command_)) continue;
        command_.span = comment.span;
        machine_.set_origin(comment.span, static_cast<std::uint32_t>(current_));
        machine_.execute(command_);
    }
}

}  // namespace ncsim::gcode
