// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places of words, and reports.
#include "control/context.h"

#include <cmath>

namespace ncsim::gcode {

void set_origin(SourceSpan span, std::uint32_t file, Context& context) {
    context.span = span;
    context.file = file;
    context.path.set_origin(span, file);
}

SourceSpan span_of(const Command& command, char letter) {
    const Word* word = find_word(*command.block, letter);
    return word ? word->span : command.span;
}

SourceSpan span_of_g(const Command& command, Code code) {
    for (const Word& word : command.block->words) {
        if (word.letter == 'G' && word.literal &&
            std::lround(word.number * 10) == tenths_of(code)) {
            return word.span;
        }
    }
    return command.span;
}

bool fail(Context& context, const MessageText& message, SourceSpan span,
          std::initializer_list<std::string_view> arguments) {
    context.log.add(Severity::Error, message, span, arguments);
    return false;
}

bool stop_with(Context& context, const MessageText& message, SourceSpan span,
               std::initializer_list<std::string_view> arguments) {
    context.stopped = true;
    return fail(context, message, span, arguments);
}

bool lacks(Context& context, const Command& command, std::string_view name, std::string_view what) {
    return fail(context, Message::WordMissing, command.span, {name, what});
}

void warn(Context& context, const MessageText& message, SourceSpan span,
          std::initializer_list<std::string_view> arguments) {
    context.log.add(message, span, arguments);
}

bool tolerate(Context& context, const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments) {
    if (context.rules.strict) return fail(context, message, span, arguments);
    context.log.add(Severity::Warning, message, span, arguments);
    return true;
}

}  // namespace ncsim::gcode
