// SPDX-License-Identifier: GPL-3.0-or-later
//
// Control words: O-words, and IF, WHILE, GOTO, END of Macro B.
#include "text/characters.h"
#include "text/line_parser.h"
#include "text/message.h"

#include <algorithm>
#include <array>

namespace ncsim::gcode {

namespace {

ControlWord o_command(std::string_view name) {
    struct Entry {
        std::string_view name;
        ControlWord word;
    };
    static constexpr auto kCommands = std::to_array<Entry>({
        {"sub", ControlWord::Sub},
        {"endsub", ControlWord::EndSub},
        {"call", ControlWord::Call},
        {"return", ControlWord::Return},
        {"if", ControlWord::OIf},
        {"elseif", ControlWord::OElseIf},
        {"else", ControlWord::OElse},
        {"endif", ControlWord::OEndIf},
        {"while", ControlWord::OWhile},
        {"endwhile", ControlWord::OEndWhile},
        {"do", ControlWord::ODo},
        {"repeat", ControlWord::ORepeat},
        {"endrepeat", ControlWord::OEndRepeat},
        {"break", ControlWord::OBreak},
        {"continue", ControlWord::OContinue},
    });
    const auto* found = std::ranges::find(kCommands, name, &Entry::name);
    return found == kCommands.end() ? ControlWord::None : found->word;
}

/// True for control words after which LinuxCNC ignores the rest of the line.
bool is_closing(ControlWord word) {
    switch (word) {
        case ControlWord::OElseIf:
        case ControlWord::OElse:
        case ControlWord::OEndIf:
        case ControlWord::OEndWhile:
        case ControlWord::ODo:
        case ControlWord::OEndRepeat:
        case ControlWord::OBreak:
        case ControlWord::OContinue: return true;
        default: return false;
    }
}

std::string_view upper_letter(char c) {
    static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    return kLetters.substr(static_cast<std::size_t>(upper(c) - 'A'), 1);
}

}  // namespace

bool LineParser::read_o_word() {
    const std::size_t start = at_++;
    const std::size_t label = at_;
    const bool is_name = at_ < text_.size() && is_letter(text_[at_]) && text_[start] == 'o';
    if (at_ < text_.size() && text_[at_] == '<') {
        if (!skip_name()) return false;
    } else if (is_name && !options_.strict) {
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_])))
            ++at_;
        block_.control = {};
        block_.control.word = ControlWord::ProgramNumber;
        block_.control.label = text_.substr(label, at_ - label);
        block_.control.span = span(start, at_);
        return true;  // "OCIRCLE": a program with a name.
    } else if (text_[start] == ':' && !options_.strict &&
               (at_ >= text_.size() || !is_digit(text_[at_]))) {
        at_ = text_.size();  // ": G90 …": a comment on some controls.
        block_.kind = BlockKind::Command;
        report(Message::ConsoleCommand, span(start, at_),
               {line_.substr(0, std::min<std::size_t>(line_.size(), 20))});
        return true;
    } else if (!skip_value()) {
        if (!reported_) {
            report(Message::NumberExpected, span(start, start + 1), {text_.substr(start, 1)});
        }
        return false;
    }
    block_.control.label = text_.substr(label, at_ - label);
    std::size_t end = at_;
    while (end < text_.size() && is_letter(text_[end]))
        ++end;
    const std::string_view command = text_.substr(at_, end - at_);
    block_.control.word = o_command(command);
    if (block_.control.word == ControlWord::None) {
        if (!options_.strict && end < text_.size() + 1 && !command.empty() && text_[label] != '[' &&
            text_[label] != '#') {
            at_ = end;  // "O7997A": a number followed by a letter.
            while (at_ < text_.size() && is_digit(text_[at_]))
                ++at_;
            if (command.size() > 2) at_ = end;
        }
        const bool is_word = command.size() > 2 && (end == text_.size() || text_[end] == '[');
        if (is_word || (options_.strict && !command.empty())) {
            report(Message::ControlWordUnknown, span(at_, end), {command});
            return false;
        }
        block_.control.word = ControlWord::ProgramNumber;
        block_.control.span = span(start, at_);
        return true;
    }
    at_ = end;
    const std::size_t arguments = at_;
    while (at_ < text_.size() && text_[at_] == '[') {
        if (!skip_brackets()) return false;
    }
    block_.control.expression = text_.substr(arguments, at_ - arguments);
    if (block_.control.expression.empty() && at_ < text_.size() && starts_value(text_[at_])) {
        // "o100 repeat #1": a value without brackets.
        if (!skip_value()) return false;
        block_.control.expression = text_.substr(arguments, at_ - arguments);
        const ControlWord word = block_.control.word;
        const bool is_condition = word == ControlWord::OIf || word == ControlWord::OElseIf ||
                                  word == ControlWord::OWhile;  // Runner requires the brackets.
        if (options_.strict && !is_condition && !is_closing(word)) {
            report(Message::ConditionBracket, span(arguments, at_), {block_.control.expression});
            return false;
        }
    }
    // "o1 if [#1] AND [#2]": the second half is not read, so the condition would not be the
    // intended condition.
    const std::string_view rest = text_.substr(at_);
    const bool goes_on =
        std::ranges::any_of(std::array{"and[", "or[", "xor["},
                            [&](std::string_view op) { return rest.starts_with(op); });
    const bool has_values =
        block_.control.word == ControlWord::Sub && !block_.control.expression.empty();
    const bool is_strange =
        options_.strict && !is_closing(block_.control.word) && (!rest.empty() || has_values);
    if (goes_on || is_strange) {
        report(Message::UnreadableText, span(at_, text_.size()), {rest.substr(0, 20)});
        return false;
    }
    block_.control.span = span(start, end);
    if (!rest.empty()) block_.control.rest = span(at_, text_.size());
    return true;
}

bool LineParser::reads_macro_word() {
    const std::string_view rest = text_.substr(at_);
    const std::size_t start = at_;
    const bool is_if = rest.starts_with("if");
    const bool is_do = rest.size() > 2 && rest.starts_with("do") && is_digit(rest[2]);
    const bool is_short = rest.starts_with("wh[");  // Fanuc reads only the first two letters.
    const bool is_while = rest.starts_with("while") || is_short || is_do;
    if (!is_if && !is_while && !rest.starts_with("goto") &&
        !(rest.starts_with("end") && rest.size() > 3 && is_digit(rest[3]))) {
        return false;
    }
    if (options_.strict || block_.control.word == ControlWord::If) {
        // RS274/NGC has no such words: the first letter lacks a number.
        report(Message::NumberExpected, span(start, start + 1), {upper_letter(rest[0])});
        return good_ = false, true;
    }
    Control& control = block_.control;
    control.span = span(start, start + (is_while ? 5 : is_if ? 2 : rest[0] == 'g' ? 4 : 3));
    if (is_do) {
        at_ = start + 2;
    } else if (is_if || is_while) {
        const std::size_t condition = start + (is_if || is_short ? 2 : 5);
        const std::size_t jump = find_outside_brackets(condition, is_if ? "goto" : "do");
        const std::size_t then =
            is_if ? find_outside_brackets(condition, "then") : std::string_view::npos;
        at_ = condition;
        if (jump != std::string_view::npos) {
            control.expression = text_.substr(condition, jump - condition);
            at_ = jump + (is_if ? 4 : 2);
        } else if (then != std::string_view::npos) {
            control.expression = text_.substr(condition, then - condition);
            control.word = ControlWord::If;
            at_ = then + 4;
            return true;
        } else if (is_if && at_ < text_.size() && text_[at_] == '[' && skip_brackets()) {
            control.expression = text_.substr(condition, at_ - condition);  // IF[…] M99.
            control.word = ControlWord::If;
            return true;
        } else {
            report(Message::UnreadableText, span(start, text_.size()), {rest.substr(0, 20)});
            return good_ = false, true;
        }
    } else {
        at_ = start + (rest[0] == 'g' ? 4 : 3);
        if (rest[0] == 'g' && at_ < text_.size() && text_[at_] == 'n') ++at_;
    }
    control.word = is_if            ? ControlWord::If
                   : is_while       ? ControlWord::While
                   : rest[0] == 'g' ? ControlWord::Goto
                                    : ControlWord::End;
    if (is_if && at_ < text_.size() && text_[at_] == 'n') ++at_;
    const std::size_t label = at_;
    if (!skip_value()) {
        if (!reported_) report(Message::NumberExpected, control.span, {upper_letter(rest[0])});
        return good_ = false, true;
    }
    control.label = text_.substr(label, at_ - label);
    return true;
}

std::size_t LineParser::find_outside_brackets(std::size_t from, std::string_view what) const {
    int depth = 0;
    for (std::size_t i = from; i < text_.size(); ++i) {
        if (text_[i] == '[') ++depth;
        if (text_[i] == ']') --depth;
        if (depth == 0 && text_.substr(i).starts_with(what)) return i;
    }
    return std::string_view::npos;
}

}  // namespace ncsim::gcode
