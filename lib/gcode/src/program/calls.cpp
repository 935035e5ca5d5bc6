// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls of subprograms by O-words, M98, M97, G65: search, entry and return.
#include "ncsim/base/ascii.h"

#include "control/cycles/cycle_steps.h"
#include "program/runner.h"
#include "text/line_end.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {

void Runner::fault(const MessageText& message, SourceSpan span,
                   std::initializer_list<std::string_view> arguments) {
    log_.add(Severity::Error, message, span, arguments);
}

ProgramIndex& Runner::index() {
    OpenFile& open = file();
    if (!open.index) open.index = std::make_unique<ProgramIndex>(*open.source);
    return *open.index;
}

bool Runner::jump(std::size_t file_number, BlockReader::Place place) {
    if (file_number == current_ && place.line < file().reader.place().line) {
        count_repeats();
    }
    current_ = file_number;
    file().reader.seek(place);
    log_.set_file(current_ == 0 ? std::string() : file().source->name);
    return true;
}

std::optional<std::string> Runner::label_of(std::string_view label, SourceSpan span) {
    const bool plain =
        label.starts_with('<') || label.find_first_not_of("0123456789") == std::string_view::npos;
    if (plain) return plain_label(label);
    const std::optional<double> number = resolver_.value_of(label, span, false);
    if (!number) return std::nullopt;
    if (!(std::abs(*number) < 1e9)) return std::nullopt;
    return std::to_string(std::lround(*number));
}

std::optional<bool> Runner::condition(std::string_view text, SourceSpan span) {
    if (rules_.strict && !text.starts_with('[')) {
        fault(Message::ConditionBracket, span, {text});
        ended_ = true;
        return std::nullopt;
    }
    const std::optional<double> value = resolver_.value_of(text, span, !rules_.strict);
    if (!value) return std::nullopt;
    return !std::isnan(*value) && *value != 0.0;
}

std::optional<std::size_t> Runner::open_file(const std::string& name) {
    if (!options_.read_file) return std::nullopt;
    std::optional<SourceFile> source = options_.read_file(name);
    if (!source) return std::nullopt;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (files_[i].source->name == source->name) return i;
    }
    auto owned = keep_file(std::move(*source), files_.size());
    if (!owned) return std::nullopt;
    const SourceFile* kept = owned.get();
    files_.push_back(
        {kept, std::move(owned), BlockReader(*kept, {.strict = rules_.strict}), nullptr});
    return files_.size() - 1;
}

/// Finds a program or subroutine in the current file, then in the other open files, then, if
/// `in_files`, in a separate file.
std::optional<Runner::Target> Runner::find_target(ControlWord word, const std::string& label,
                                                  bool in_files) {
    const std::size_t here = current_;
    const auto look_in = [&](std::size_t n) -> std::optional<Target> {
        current_ = n;
        const std::optional<std::size_t> found = index().find(word, label);
        current_ = here;
        if (!found) return std::nullopt;
        return Target{n, *found};
    };
    if (const auto found = look_in(here)) return found;
    for (std::size_t n = 0; n < files_.size(); ++n) {
        if (n == here) continue;
        if (const auto found = look_in(n)) return found;
    }
    if (!in_files) return std::nullopt;
    const std::optional<std::size_t> opened =
        open_file(word == ControlWord::ProgramNumber ? join_label("O", label) : label);
    if (!opened) return std::nullopt;
    if (const auto found = look_in(*opened)) return found;
    if (word == ControlWord::ProgramNumber) {
        return Target{*opened, static_cast<std::size_t>(-1)};  // A file without the O number.
    }
    return std::nullopt;
}

void Runner::enter(Frame frame, const Target& target) {
    constexpr std::size_t kDeepestStrict = 9;  // Limit of LinuxCNC.
    if (frames_.size() >= options_.limits.call_depth ||
        (rules_.strict && frames_.size() >= kDeepestStrict)) {
        fault(Message::CallDepth, block_.line_span());
        ended_ = true;
        return;
    }
    const BlockReader::Place start = [&] {
        const OpenFile& open = files_[target.file];
        if (open.index && target.marker < open.index->markers().size()) {
            return (*open.index)[target.marker].after;
        }
        return BlockReader(*open.source).place();
    }();
    frame.file = current_;
    frame.back = file().reader.place();
    frame.own_file = target.file;
    frame.start = start;
    frame.repeats = repeats_.size();
    frames_.push_back(std::move(frame));
    registers_.view.call_level = static_cast<int>(frames_.size());
    count_repeats();
    jump(target.file, start);
}

/// Repeats the subprogram if runs remain, or returns to the caller.
void Runner::finish_subprogram() {
    Frame& frame = frames_.back();
    repeats_.resize(std::min(repeats_.size(), frame.repeats));
    if (frame.remaining > 0) {
        --frame.remaining;
        (void)count_block(true, block_.line_span());
        jump(frame.own_file, frame.start);
        return;
    }
    if (frame.has_locals) registers_.restore_locals(std::move(frame.locals), frame.local_count);
    const auto modes = frame.restores ? frame.modes : nullptr;
    const std::size_t back_file = frame.file;
    const BlockReader::Place back = frame.back;
    frames_.pop_back();
    registers_.view.call_level = static_cast<int>(frames_.size());
    if (modes) machine_.restore_modes(*modes, block_.line_span());
    jump(back_file, back);
}

/// M70 and M73 save the modes of the call level, M71 discards the saved modes, M72 restores the
/// modes.
void Runner::save_or_restore(int m) {
    std::shared_ptr<const Controller::SavedModes>& modes =
        frames_.empty() ? main_modes_ : frames_.back().modes;
    switch (m) {
        case 70: modes = machine_.save_modes(); break;
        case 71: modes.reset(); break;
        case 73:
            modes = machine_.save_modes();
            if (!frames_.empty()) frames_.back().restores = true;
            break;
        default:
            if (!modes) {
                log_.add(rules_.strict ? Severity::Error : Severity::Warning,
                         Message::ModesNotSaved, command_.span);
                if (rules_.strict) ended_ = true;
                return;
            }
            machine_.restore_modes(*modes, command_.span);
            break;
    }
}

bool Runner::call_code(int m) {
    switch (m) {
        case 97: call_lines(); break;
        case 98:
        // M198 calls a program in a different memory of the control.
        case 198: call_subprogram(); break;
        default: return_from_subprogram(); break;
    }
    return true;
}

/// True for programs stored in the control or in external memory: O8xxx and O9xxx of Fanuc and
/// Haas, and programs called by M198.
bool Runner::is_control_program(double number) const {
    if (rules_.strict) return false;
    if (command_.group(MGroup::Call) == 198) return true;
    return rules_.macro_b && number >= 8000.0 && number <= 9999.0;
}

/// Reports the call of a program of the control, unless the program is declared harmless.
void Runner::report_control_program(double number, SourceSpan span) {
    if (resolver_.is_allowed('O', number)) return;
    const std::string label = std::to_string(std::lround(number));
    log_.add(Message::MacroMissing, span, {join_label("O", label), label});
}

/// Finds the program `name`: a line "<NAME>" of an open file, otherwise a file with the name.
std::optional<Runner::Target> Runner::find_named_program(std::string_view name) {
    const std::string lower_name = lowercase(name);
    if (const auto found = find_target(ControlWord::ProgramNumber, lower_name, false)) return found;
    for (const std::string& file_name : {std::string(name), lower_name, uppercase(name)}) {
        const std::optional<std::size_t> opened = open_file(file_name);
        if (opened) return Target{*opened, static_cast<std::size_t>(-1)};
    }
    return std::nullopt;
}

/// Returns the file of "M98 (folder/name.nc)" on Haas, Mach3 and unnamed controls: the last part of
/// the path in the first comment. Empty on controls whose M98 needs P.
std::optional<std::string_view> Runner::name_in_comment() const {
    const bool takes_comment = rules_.dialect == Dialect::Haas ||
                               rules_.dialect == Dialect::Mach3 ||
                               (rules_.dialect == Dialect::Rs274 && !rules_.is_linuxcnc());
    if (!takes_comment || block_.comments.empty()) return std::nullopt;
    std::string_view path = trimmed(block_.comments.front().text);
    const std::size_t slash = path.find_last_of("/\\");
    if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
    if (path.empty()) return std::nullopt;
    return path;
}

/// M98 <NAME>: calls the program of that name.
void Runner::call_program_file(std::string_view name) {
    const std::string label = std::string("<").append(name).append(">");
    const std::optional<Target> target = find_named_program(name);
    if (!target) return fault(Message::ProgramNotFound, command_.span, {label});
    const double runs = command_.get('L', 1.0);
    if (runs < 1.0) return;
    Frame frame;
    frame.kind = CallKind::Subprogram;
    frame.label = label;
    frame.remaining = static_cast<std::uint64_t>(std::min(runs, 1e9)) - 1;
    enter(std::move(frame), *target);
}

void Runner::call_subprogram() {
    if (!block_.program_name.empty()) return call_program_file(block_.program_name);
    const Word* p = find_word(block_, 'P');
    const std::optional<std::string_view> in_comment = name_in_comment();
    if (!p && in_comment) return call_program_file(*in_comment);
    const SourceSpan span = command_.span;
    if (!p || !command_.has('P') || command_['P'] < 0.0 || command_['P'] > 1e9) {
        return fault(Message::CallWithoutNumber, span, {"M98"});
    }
    auto number = static_cast<std::uint64_t>(std::lround(command_['P']));
    double runs = command_.get('L', 1.0);
    std::optional<Target> target =
        find_target(ControlWord::ProgramNumber, std::to_string(number), true);
    if (!target && !rules_.strict && !command_.has('L') && number > 9999) {
        // Old Fanuc form: P68003 means six runs of O8003.
        target = find_target(ControlWord::ProgramNumber, std::to_string(number % 10'000), true);
        const std::uint64_t repeats = number / 10'000;
        if (target) runs = static_cast<double>(repeats), number %= 10'000;
    }
    const std::string label = std::to_string(number);
    if (!target) {
        const std::optional<Target> sub = find_target(ControlWord::Sub, label, false);
        const auto called = static_cast<double>(command_.has('L') ? number : number % 10'000);
        if (!sub && is_control_program(called)) return report_control_program(called, p->span);
        if (!sub || rules_.strict) {
            return fault(sub ? Message::CallForms : Message::ProgramNotFound, p->span,
                         {join_label("O", label)});
        }
        target = sub;
    }
    if (runs < 1.0) return;
    Frame frame;
    frame.kind = CallKind::Subprogram;
    frame.label = label;
    frame.remaining = static_cast<std::uint64_t>(std::min(runs, 1e9)) - 1;
    enter(std::move(frame), *target);
}

/// M97 P100 of Haas: calls the lines from N100 to M99 of the same program.
void Runner::call_lines() {
    if (!command_.has('P') || command_['P'] < 0.0 || command_['P'] > 4e9) {
        return fault(Message::CallWithoutNumber, command_.span, {"M97"});
    }
    const auto number = static_cast<std::uint32_t>(command_['P']);
    const std::optional<BlockReader::Place> place = index().find_number(number, block_.line);
    if (!place)
        return fault(Message::LineNotFound, command_.span,
                     {join_label("N", std::to_string(number))});
    const double runs = command_.get('L', 1.0);
    if (runs < 1.0) return;
    Frame frame;
    frame.kind = CallKind::Lines;
    frame.label = std::to_string(number);
    frame.remaining = static_cast<std::uint64_t>(std::min(runs, 1e9)) - 1;
    enter(std::move(frame), {current_, static_cast<std::size_t>(-1)});
    if (frames_.empty() || ended_) return;
    frames_.back().start = *place;
    jump(current_, *place);
}

/// G150 P100: records the outline from N100 of the program, or in O100, to M99. The outline is
/// never executed.
/// Returns: false after reporting a fault.
bool Runner::record_outline() {
    constexpr int kMostBlocks = 1000;
    const double p = command_['P'];
    if (!(p >= 0.0 && p <= 4e9) || p != std::floor(p)) {
        fault(Message::CallWithoutNumber, command_.span, {"G150"});
        return false;
    }
    std::size_t where = current_;
    std::optional<BlockReader::Place> place =
        index().find_number(static_cast<std::uint32_t>(p), block_.line);
    const std::string label = std::to_string(std::lround(p));
    if (!place) {
        const auto target = find_target(ControlWord::ProgramNumber, label, true);
        if (!target) {
            fault(Message::ProgramNotFound, command_.span, {join_label("O", label)});
            return false;
        }
        const OpenFile& open = files_[where = target->file];
        const bool marked = open.index && target->marker < open.index->markers().size();
        place = marked ? (*open.index)[target->marker].after : BlockReader(*open.source).place();
    }
    if (!machine_.begin_contour(command_)) return false;
    log_.set_file(where == 0 ? std::string() : files_[where].source->name);
    BlockReader reader(*files_[where].source, {.strict = rules_.strict});
    reader.seek(*place);
    Block block;
    Command command;
    bool good = false;
    for (int i = 0; i < kMostBlocks && reader.next(block, log_); ++i) {
        const bool plain = block.kind == BlockKind::Words && block.assignments.empty() &&
                           (block.control.word == ControlWord::None ||
                            (i == 0 && block.control.word == ControlWord::ProgramNumber));
        if (!plain && block.kind == BlockKind::Words) {
            fault(Message::PocketWord, block.line_span(), {"the outline of G150", "plain blocks"});
            break;
        }
        if (block.words.empty()) continue;
        if (!resolver_.resolve(block, command)) break;
        good = command.group(MGroup::Call) == 99;
        if (good) break;
        if (!belongs_to_outline(command)) {
            fault(Message::PocketWord, command.span,
                  {"the outline of G150", "lines and arcs (G1, G2, G3) alone"});
            break;
        }
        machine_.set_origin(command.span, static_cast<std::uint32_t>(where));
        machine_.execute(command);
    }
    machine_.end_outline();
    log_.set_file(current_ == 0 ? std::string() : file().source->name);
    machine_.set_origin(command_.span, static_cast<std::uint32_t>(current_));
    if (!good) fault(Message::PocketWord, command_.span, {"G150", "an outline that ends in M99"});
    return good;
}

void Runner::return_from_subprogram() {
    if (frames_.empty()) {
        if (command_.has('P') && !rules_.strict && continue_at(command_['P'], true)) return;
        // M99 in the main program restarts the program; a single run shows all motions.
        if (!rules_.strict) log_.add(Message::MainRepeats, command_.span);
        machine_.finish();
        end();
        return;
    }
    const Frame& frame = frames_.back();
    if (frame.kind == CallKind::OWord && rules_.strict) {
        return fault(Message::CallForms, command_.span, {join_label("O", frame.label)});
    }
    const bool has_target = command_.has('P') && !rules_.strict;
    const double number = has_target ? command_['P'] : 0.0;
    if (!has_target) return finish_subprogram();
    frames_.back().remaining = 0;
    finish_subprogram();
    (void)continue_at(number, false);
}

/// M99 P100 continues in line N100 of the program that runs after the return. `is_main`: M99 is in
/// the main program, where a jump back restarts the program.
/// Returns: false without a jump if the main program would restart.
bool Runner::continue_at(double number, bool is_main) {
    if (!(number >= 0.0 && number <= 4e9)) return !is_main;
    const std::uint32_t line = file().reader.place().line;
    const std::optional<BlockReader::Place> place =
        index().find_number(static_cast<std::uint32_t>(number), line);
    if (!place) {
        fault(Message::LineNotFound, command_.span,
              {join_label("N", std::to_string(std::lround(number)))});
        if (is_main) ended_ = true;
        return true;
    }
    if (is_main && place->line < line) return false;
    return jump(current_, *place);
}

}  // namespace ncsim::gcode
