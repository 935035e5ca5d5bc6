// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limits and ends of programs.
#include "language/program_runner.h"

#include "text/line_end.h"
#include "text/message.h"

#include <algorithm>
#include <utility>

namespace ncsim::gcode::language {

ProgramRunner::ProgramRunner(const SourceFile& program, const InterpreterOptions& options,
                             const Rules& rules, ArcCentres& centres, const MotionSink& sink,
                             DiagnosticLog& log, Interpretation& result)
    : options_(options),
      log_(log),
      result_(result),
      path_(options, sink, log, result),
      machine_(options, rules, centres, log, path_, registers_),
      most_blocks_(options.limits.repeated_blocks + line_count(program.text)) {
    registers_.set_rules(rules);
}

void ProgramRunner::run() {
    if (options_.observe_state) options_.observe_state(0, 0, machine_.state());
    for (bool goes_on = true; goes_on && !ended_;) {
        const std::uint32_t file = current_file();
        const std::uint64_t lines = result_.lines;
        goes_on = step();
        if (options_.observe_state && result_.lines > lines)
            options_.observe_state(file, last_line(), machine_.state());
    }
    machine_.flush();
    path_.finish();
    machine_.report_to(result_);
    result_.stopped = ended_ && !result_.ended;
    if (!result_.ended && !ended_) report_missing_end(last_line());
}

void ProgramRunner::report_missing_end(std::uint32_t line) {
    log_.add(Message::ProgramEndMissing, {line, 1, 0});
}

std::unique_ptr<SourceFile> ProgramRunner::keep_file(SourceFile source, std::size_t count) {
    constexpr std::size_t kMostFiles = 1000;
    if (count >= kMostFiles) return nullptr;
    auto kept = std::make_unique<SourceFile>(std::move(source));
    most_blocks_ += line_count(kept->text);
    result_.files.push_back(kept->name);
    return kept;
}

bool ProgramRunner::fail(const MessageText& message, SourceSpan span,
                         std::initializer_list<std::string_view> arguments) {
    log_.add(message, span, arguments);
    return false;
}

bool ProgramRunner::stop() {
    result_.refused = true;
    ended_ = true;
    return false;
}

void ProgramRunner::end() {
    result_.ended = true;
    ended_ = true;
}

bool ProgramRunner::count_block(bool is_called, SourceSpan span) {
    if ((!is_called && repeated_ == 0) || ++repeated_ <= most_blocks_) return true;
    fail(Message::StepLimit, span);
    ended_ = true;
    return false;
}

void ProgramRunner::count_repeats() {
    repeated_ = std::max<std::uint64_t>(repeated_, 1);
}

void ProgramRunner::report_missing_program(std::string_view name, SourceSpan span) {
    if (std::ranges::find(options_.allow, name) == options_.allow.end())
        log_.add(Message::ProgramMissing, span, {name, name});
}

void ProgramRunner::note_deletable(std::size_t file, SourceSpan span) {
    if (!result_.deletable) result_.deletable = {static_cast<std::uint32_t>(file), span};
}

}  // namespace ncsim::gcode::language
