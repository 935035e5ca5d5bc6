// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages about a program: a severity, a stable code for searches and tests, a text for the user
// and a position. Each library has a table of messages (MessageText); the table of lib/gcode is
// src/text/diagnostics.def.
#pragma once

#include "ncsim/gcode/source.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode {

/// Severity of a diagnostic.
enum class Severity : std::uint8_t { Note, Warning, Error };

/// A message about a position in a program.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;     ///< Stable, kebab-case: "arc-without-centre".
    std::string message;  ///< Lower case, without a full stop, in machinists' terms.
    SourceSpan span;
    std::string file;         ///< Name of the file; empty for the main program.
    std::uint32_t count = 1;  ///< Number of occurrences; `span` is the first.
    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// True if `diagnostics` contains an error.
bool has_errors(const Diagnostics& diagnostics);

/// A row of a table of messages: severity, code and text with placeholders.
struct MessageText {
    /// Default severity; the caller may override the default.
    Severity severity = Severity::Error;
    std::string_view code;  ///< Value of Diagnostic::code.
    std::string_view text;  ///< Text in which each "{}" stands for an argument, in order.
};

/// Returns `message` for `span`, with each "{}" replaced by the next of `arguments`. Control
/// characters, which programs may contain, become blanks.
Diagnostic diagnostic_of(const MessageText& message, SourceSpan span,
                         std::initializer_list<std::string_view> arguments = {});

/// Collects diagnostics. Equal diagnostics (severity, code, message and file) are stored once, with
/// a count. After kMaxDifferent different diagnostics only kTooMany is added, so a corrupt file
/// costs little memory and gives a readable list.
class DiagnosticLog {
public:
    static constexpr std::size_t kMaxDifferent = 400;
    static constexpr MessageText kTooMany{
        Severity::Note, "too-many-diagnostics",
        "there are more faults than are worth listing; the rest is not shown"};

    /// Adds `message` for `span`, with each "{}" replaced by the next of `arguments`.
    void add(const MessageText& message, SourceSpan span,
             std::initializer_list<std::string_view> arguments = {});
    void add(Severity severity, const MessageText& message, SourceSpan span,
             std::initializer_list<std::string_view> arguments = {});

    /// Sets the name of the file of the following diagnostics; empty: the main program.
    void set_file(std::string name) { file_ = std::move(name); }

    /// Returns the number of added errors, repetitions included.
    std::size_t errors() const { return errors_; }

    const Diagnostics& diagnostics() const { return diagnostics_; }
    Diagnostics take() { return std::move(diagnostics_); }

private:
    Diagnostics diagnostics_;
    // Index into diagnostics_, by code, message, file and severity.
    std::map<std::string, std::size_t, std::less<>> index_;
    std::string file_;
    std::string key_;
    std::size_t errors_ = 0;
    bool closed_ = false;
};

/// Prefix of a quoted line of a program. With the prefix, a quoted line cannot be mistaken for a
/// message or for a command to the service that shows the log.
inline constexpr std::string_view kQuoteMark = "  | ";

/// Returns `diagnostic` as text, with the quoted line and a caret, ending in a newline:
///
///     pocket.nc:3:5: error: G2 needs a centre (I J) or a radius (R) [arc-without-centre]
///       | N30 G2 X10 Y0
///       |     ^~
///
/// A file name that begins like a command ("::", "##") gets the prefix "./".
std::string render(const Diagnostic& diagnostic, const SourceFile& file);

}  // namespace ncsim::gcode
