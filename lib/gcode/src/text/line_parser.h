// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two readers for one grammar. Nearly every line of a real program is a row of letters with plain
// numbers; those are read in place, in one pass. The first thing that is anything else sends
// the line to the general reader, which works on a clean copy (lower case, no blanks, no comments)
// with a column for each byte, so that blanks may stand anywhere, as RS274/NGC allows.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/parser_options.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Reads one line. Lives as long as the line.
class LineParser {
public:
    /// `columns`: room for those of the clean copy. Without a log nothing is said.
    LineParser(ParserOptions options, std::vector<std::uint32_t>& columns, std::string_view line,
               Block& block, DiagnosticLog* log)
        : options_(options), columns_(columns), line_(line), block_(block), log_(log) {}

    /// Something was to be said of the line.
    bool said_something() const { return said_; }

    /// Words with plain numbers, comments at the end, nothing else; false if there is more.
    bool read_plain();

    /// Everything else. The block points into `clean`, which is written into.
    void read_general(std::string& clean);

private:
    void refuse() {
        block_.kind = BlockKind::Unreadable;
        block_.words.clear();
        block_.assignments.clear();
        block_.control = {};
    }
    void set_number(double value) {
        block_.has_number = true;
        block_.number = value >= 0 && value < 4e9 ? static_cast<std::uint32_t>(value) : 0U;
    }
    void report(const MessageText& message, SourceSpan span,
                std::initializer_list<std::string_view> arguments = {});
    /// For what other controls accept: a warning, and under strict rules an error.
    bool tolerate(const MessageText& message, SourceSpan span,
                  std::initializer_list<std::string_view> arguments = {});
    /// Of bytes of the clean copy.
    SourceSpan span(std::size_t first, std::size_t last) const;

    // line_parser.cpp
    void add_comment(std::size_t open, std::size_t close);
    void add_semicolon_comment(std::size_t at);
    /// "[VCarve: sign.crv]" at the beginning of a line: a comment for WinCNC, and no word anywhere.
    bool is_bracket_comment(std::size_t at, std::string_view before) const;
    /// Fills the clean copy. False if the line must not be executed.
    bool make_clean(std::string& clean);
    bool is_percent();
    bool is_console_command();
    /// Block delete ('/', "/2") and the line number, in either order.
    void read_prefix();

    // line_words.cpp
    bool read_words();
    bool read_word(std::size_t start, bool comma);
    bool read_assignment();
    bool read_checksum();

    // line_control.cpp
    /// "o100 sub", "o<name> call [1]", and the Fanuc program number "O1234".
    bool read_o_word();
    /// IF, WHILE, GOTO, END n of Fanuc Macro B. True if there was one, read or refused (`good_`).
    bool reads_macro_word();
    std::size_t find_outside_brackets(std::size_t from, std::string_view what) const;

    // line_values.cpp
    /// True, after a report, if the number from `start` to here goes on with an exponent.
    bool has_exponent(std::size_t start);
    bool skip_brackets();
    bool skip_name();
    /// One value: sign, then a number, a parameter, brackets, or a function of brackets.
    bool skip_value();
    /// Fanuc writes "#1=#2+3*#4" without brackets.
    bool skip_operations();

    ParserOptions options_;
    std::vector<std::uint32_t>& columns_;  // of the clean copy
    std::string_view line_;
    Block& block_;
    DiagnosticLog* log_;
    std::string_view text_;
    std::size_t at_ = 0;
    bool reported_ = false;
    bool said_ = false;
    bool good_ = true;
};

}  // namespace ncsim::gcode
