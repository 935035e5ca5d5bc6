// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds words and comments to the blocks in which readers of comments see a program of another
// language.
#pragma once

#include "ncsim/gcode/block.h"

#include <array>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::language {

/// Adds words and comments to the present block.
class NoteWriter {
public:
    explicit NoteWriter(std::vector<std::string> tool_names) : names_(std::move(tool_names)) {}

    /// Begins the next block: clears `block` without its memory; the texts of the last block end.
    void begin_block(Block& block);
    /// Adds a comment with a text of its own, valid until begin_block().
    void add(Block& block, std::string text, SourceSpan span);
    static void add(Block& block, char letter, double number, SourceSpan span);
    /// Adds the number that stands for the tool `name`, and the name as a comment.
    void add_tool(Block& block, std::string_view name, SourceSpan span);
    /// Adds a corner of the blank: `head`, then X, Y and Z with signs.
    void add_corner(Block& block, std::string_view head, const std::array<double, 3>& corner,
                    SourceSpan span);

private:
    std::vector<std::string> names_;
    std::deque<std::string> texts_;
};

/// Sets `text` to `code` with single blanks.
void append_with_single_blanks(std::string& text, std::string_view code);

}  // namespace ncsim::gcode::language
