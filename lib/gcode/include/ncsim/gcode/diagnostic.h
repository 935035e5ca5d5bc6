// SPDX-License-Identifier: GPL-3.0-or-later
//
// What we have to say about a program: a severity, a stable code for searching and for
// tests, a message for people and a place. Each library has its messages in one table of rows
// (MessageText); those of this one stand in src/text/diagnostics.def.
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

enum class Severity : std::uint8_t { Note, Warning, Error };

struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;     ///< Stable, kebab-case: "arc-without-centre".
    std::string message;  ///< Lower case, no full stop, in the machinist's words.
    SourceSpan span;
    std::string file;         ///< Set where the place is not in the main program (O-files).
    std::uint32_t count = 1;  ///< How often it was met; the span is the first place.
    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

bool has_errors(const Diagnostics& diagnostics);

/// A row of a table of messages: what can be said, before it is said of something.
struct MessageText {
    Severity severity = Severity::Error;  ///< Unless who says it knows better.
    std::string_view code;                ///< As in Diagnostic.
    std::string_view text;                ///< "{}" is filled in order.
};

/// `message` said of `span`, with its "{}" filled. Control characters, which programs may contain,
/// become blanks.
Diagnostic diagnostic_of(const MessageText& message, SourceSpan span,
                         std::initializer_list<std::string_view> arguments = {});

/// Collects diagnostics. What says the same (code and message) in the same file is told once,
/// with a count; after kMaxDifferent different ones only a closing one is added, so that a file of
/// garbage costs neither memory nor the reader's patience.
class DiagnosticLog {
public:
    static constexpr std::size_t kMaxDifferent = 400;
    static constexpr MessageText kTooMany{
        Severity::Note, "too-many-diagnostics",
        "there are more faults than are worth listing; the rest is not shown"};

    /// Adds `message` with its "{}" filled in order.
    void add(const MessageText& message, SourceSpan span,
             std::initializer_list<std::string_view> arguments = {});
    void add(Severity severity, const MessageText& message, SourceSpan span,
             std::initializer_list<std::string_view> arguments = {});

    /// The name of the file that spans belong to from here on; empty: the main program.
    void set_file(std::string name) { file_ = std::move(name); }

    /// How many errors were added, repetitions included.
    std::size_t errors() const { return errors_; }

    const Diagnostics& diagnostics() const { return diagnostics_; }
    Diagnostics take() { return std::move(diagnostics_); }

private:
    Diagnostics diagnostics_;
    std::map<std::string, std::size_t, std::less<>> index_;  // code, message, file -> place
    std::string file_;
    std::string key_;
    std::size_t errors_ = 0;
    bool closed_ = false;
};

/// What stands before a line that is quoted, so that nothing in it is taken for a message, or for a
/// command to the service whose log it ends in.
inline constexpr std::string_view kQuoteMark = "  | ";

/// The diagnostic as people read it, with the line and a caret, ending in a newline:
///
///     pocket.nc:3:5: error: G2 needs a centre (I J) or a radius (R) [arc-without-centre]
///       | N30 G2 X10 Y0
///       |     ^~
///
/// A name that begins like a command ("::", "##") has "./" before it.
std::string render(const Diagnostic& diagnostic, const SourceFile& file);

}  // namespace ncsim::gcode
