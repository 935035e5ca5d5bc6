// SPDX-License-Identifier: GPL-3.0-or-later
#include "runner.h"

#include "number.h"

#include <algorithm>

namespace ncsim::gcode {

Runner::Runner(const SourceFile& program, const InterpreterOptions& options, const Rules& rules,
               const MotionSink& sink, DiagnosticLog& log, Interpretation& result)
    : program_(program),
      options_(options),
      rules_(rules),
      log_(log),
      result_(result),
      path_(options, sink, result),
      machine_(options, rules, log, path_, parameters_),
      resolver_(rules, parameters_, log, options.allow),
      reader_(program, {.strict = rules.strict}) {
    parameters_.set_rules(rules.arithmetic.vacant, rules.strict);
}

void Runner::run() {
    while (!ended_ && step()) {
    }
    if (!result_.ended) {
        log_.add(rules_.strict ? Severity::Error : Severity::Note, Message::ProgramEndMissing,
                 {block_.line, 1, 0});
    }
    result_.units_stated = machine_.units_stated();
    result_.uses_inches =
        machine_.first_length_seen() ? machine_.first_length_in_inches() : machine_.state().inches;
}

bool Runner::step() {
    if (!reader_.next(block_, log_)) return false;
    ++result_.lines;
    parameters_.view.line = block_.line;
    if (block_.kind != BlockKind::Words) {
        if (block_.kind == BlockKind::Percent) return percent();
        return true;
    }
    if (block_.block_delete && options_.block_delete) return true;
    if (block_.words.empty() && block_.assignments.empty()) {
        if (!block_.comments.empty() && !rules_.strict) tool_change_in_comment();
        return true;
    }
    something_read_ = true;
    if (!block_.words.empty()) {
        if (!resolver_.resolve(block_, command_)) return true;
        path_.set_origin(command_.span, 0);
        machine_.execute(command_);
        if (machine_.ended()) {
            result_.ended = true;
            ended_ = true;
        }
    }
    if (!block_.assignments.empty()) assign(block_);
    return true;
}

/// '%' as the first line opens a program, the next one closes it. Elsewhere it means nothing.
bool Runner::percent() {
    if (!something_read_ && !percent_opened_) {
        percent_opened_ = true;
        return true;
    }
    if (!percent_opened_) return true;
    result_.ended = true;
    ended_ = true;
    return true;
}

/// Assignments of a block take effect together, after its words and their own right sides are read.
void Runner::assign(const Block& block) {
    for (const Assignment& assignment : block.assignments) {
        const std::optional<double> value =
            resolver_.value_of(assignment.value, assignment.span, !rules_.strict);
        if (!value) return;
        std::string_view target = assignment.target;
        if (target.starts_with('<')) {
            target = target.substr(1, target.size() - 2);
            if (!parameters_.set_named(target, *value)) {
                log_.add(Message::ParameterReadOnly, assignment.span, {assignment.target});
            }
            continue;
        }
        const std::optional<double> number = resolver_.value_of(target, assignment.span, false);
        if (!number) return;
        if (!parameters_.set_numbered(*number, *value)) {
            log_.add(Parameters::is_read_only(*number) ? Message::ParameterReadOnly
                                                       : Message::ParameterRange,
                     assignment.span, {target});
        }
    }
}

/// FreeCAD's post for grbl writes the tool change as a comment, "( M6 T3 )", and means it.
void Runner::tool_change_in_comment() {
    for (const Comment& comment : block_.comments) {
        if (comment.text.size() > 20 || comment.text.find_first_of("Mm") == std::string_view::npos)
            continue;
        const SourceFile inside{{}, std::string(comment.text)};
        BlockReader reader(inside);
        Block block;
        if (!reader.next(block) || block.words.size() != 2) continue;
        const Word* change = find_word(block, 'M');
        const Word* tool = find_word(block, 'T');
        if (!change || !tool || change->number != 6.0 || !tool->literal) continue;
        log_.add(Message::ToolChangeInComment, comment.span);
        if (!resolver_.resolve(block, command_)) continue;
        command_.span = comment.span;
        path_.set_origin(comment.span, 0);
        machine_.execute(command_);
    }
}

}  // namespace ncsim::gcode
