// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words and comments of blocks.
#include "language/notes.h"

#include "ncsim/base/ascii.h"
#include "ncsim/gcode/print.h"

#include "language/block_control.h"

#include <algorithm>
#include <utility>

namespace ncsim::gcode::language {

void NoteWriter::begin_block(Block& block) {
    texts_.clear();
    std::vector<Word> words = std::move(block.words);
    std::vector<Comment> comments = std::move(block.comments);
    words.clear();
    comments.clear();
    block = {};
    block.words = std::move(words);
    block.comments = std::move(comments);
}

int number_in_name(std::string_view name) {
    constexpr std::size_t kMostDigits = 4;
    if (name.empty() || name.size() > kMostDigits) return 0;
    int number = 0;
    for (const char digit : name) {
        if (!is_digit(digit)) return 0;
        number = 10 * number + (digit - '0');
    }
    return number < kFirstNamedTool ? number : 0;
}

void NoteWriter::add(Block& block, std::string text, SourceSpan span) {
    texts_.push_back(std::move(text));
    Comment comment;
    comment.text = texts_.back();
    comment.span = span;
    block.comments.push_back(comment);
}

void NoteWriter::add(Block& block, char letter, double number, SourceSpan span) {
    Word word;
    word.letter = letter;
    word.number = number;
    word.span = span;
    block.words.push_back(word);
}

void NoteWriter::add_tool(Block& block, std::string_view name, SourceSpan span) {
    if (const int number = number_in_name(name); number > 0) return add(block, 'T', number, span);
    const auto known = std::ranges::find(names_, name);
    const int number = kFirstNamedTool + static_cast<int>(known - names_.begin());
    // The number makes the text a description of this tool: "T9001 CUTTER 16".
    std::string words = "T" + std::to_string(number) + " " + std::string(name);
    std::ranges::replace(words, '_', ' ');
    add(block, std::move(words), span);
    add(block, 'T', number, span);
}

void NoteWriter::add_corner(Block& block, std::string_view head,
                            const std::array<double, 3>& corner, SourceSpan span) {
    std::string text(head);
    for (std::size_t i = 0; i < 3; ++i) {
        text += ' ';
        text += "XYZ"[i];
        if (corner[i] >= 0.0) text += '+';
        print_number(text, corner[i]);
    }
    add(block, std::move(text), span);
}

void append_with_single_blanks(std::string& text, std::string_view code) {
    for (const char c : code) {
        const bool blank = is_blank(c);
        if (blank && (text.empty() || text.back() == ' ')) continue;
        text += blank ? ' ' : c;
    }
}

}  // namespace ncsim::gcode::language
