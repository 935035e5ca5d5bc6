// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses a line with two readers for the same grammar. Nearly every line of a real program consists
// of letters with plain numbers; read_plain() parses such a line in place, in a single pass. Any
// other text makes read_general() parse the line from a clean copy (lower case, no blanks, no
// comments) with the column of each byte, so blanks may occur anywhere, as RS274/NGC allows.
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

/// Parses a line. Must not outlive the line.
class LineParser {
public:
    /// `columns`: buffer for the columns of the clean copy. Without `log` faults are not reported.
    LineParser(ParserOptions options, std::vector<std::uint32_t>& columns, std::string_view line,
               Block& block, DiagnosticLog* log)
        : options_(options), columns_(columns), line_(line), block_(block), log_(log) {}

    /// True if the line has a fault.
    bool has_fault() const { return has_fault_; }

    /// Parses words with plain numbers and comments.
    /// Returns: false if the line has other text.
    bool read_plain();

    /// Parses any line. The block points into `clean`, which receives the clean copy.
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
    /// Reports a fault that other controls accept: a warning, or an error under strict rules.
    /// Returns: true if it was a warning.
    bool tolerate(const MessageText& message, SourceSpan span,
                  std::initializer_list<std::string_view> arguments = {});
    /// Returns the span of the bytes `first` … `last` - 1 of the clean copy.
    SourceSpan span(std::size_t first, std::size_t last) const;

    // line_parser.cpp
    void add_comment(std::size_t open, std::size_t close);
    void add_semicolon_comment(std::size_t at);
    /// True for "[VCarve: sign.crv]" at the beginning of a line: a comment for WinCNC.
    bool is_bracket_comment(std::size_t at, std::string_view before) const;
    /// Fills the clean copy.
    /// Returns: false if the line must not be executed.
    bool make_clean_copy(std::string& clean);
    bool is_percent();
    bool is_console_command();
    /// Reads block delete ('/', "/2", "/1/3") and the line number, in either order.
    void read_prefix();
    /// Reads a '/' and the number of its switch.
    void read_slash();

    // line_words.cpp
    bool read_words();
    bool read_word(std::size_t start, bool comma);
    bool is_block_delete_at(std::size_t at) const;
    bool read_assignment();
    bool read_checksum();
    /// Reads "<NAME>" behind M98, M198, G65 or G66.
    bool read_program_name();

    // line_control.cpp
    /// Reads "o100 sub", "o<name> call [1]", and the Fanuc program number "O1234".
    bool read_o_word();
    /// Reads IF, WHILE, GOTO, END n of Fanuc Macro B.
    /// Returns: true if there is such a word, accepted or refused (`good_`).
    bool reads_macro_word();
    std::size_t find_outside_brackets(std::size_t from, std::string_view what) const;

    // line_values.cpp
    /// True, after reporting the fault, if the number from `start` to the present position
    /// continues with an exponent.
    bool has_exponent(std::size_t start);
    bool skip_brackets();
    bool skip_name();
    /// Skips a value: sign, then a number, a parameter, brackets, or a function of brackets.
    bool skip_value();
    /// Skips operations without brackets, as in "#1=#2+3*#4" of Fanuc.
    bool skip_operations();

    ParserOptions options_;
    std::vector<std::uint32_t>& columns_;  // Columns of the clean copy.
    std::string_view line_;
    Block& block_;
    DiagnosticLog* log_;
    std::string_view text_;
    std::size_t at_ = 0;
    bool reported_ = false;
    bool has_fault_ = false;
    bool good_ = true;
};

}  // namespace ncsim::gcode
