// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common part of the runners of all languages: the control, the limits of repeated blocks, further
// files, the end of the program.
#pragma once

#include "ncsim/gcode/interpretation.h"

#include "control/controller.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string_view>

namespace ncsim::gcode::language {

/// Runs a program, block by block.
class ProgramRunner {
public:
    ProgramRunner(const ProgramRunner&) = delete;
    ProgramRunner& operator=(const ProgramRunner&) = delete;

    void run();

protected:
    ProgramRunner(const SourceFile& program, const InterpreterOptions& options, const Rules& rules,
                  ArcCentres& centres, const MotionSink& sink, DiagnosticLog& log,
                  Interpretation& result);
    virtual ~ProgramRunner() = default;

    /// Executes the next block.
    /// Returns: false at the end of the program.
    virtual bool step() = 0;
    /// Returns the line of the last block.
    virtual std::uint32_t last_line() const = 0;
    /// Returns the file of the next block, as an index into Interpretation::files.
    virtual std::uint32_t current_file() const = 0;

    /// Reports that the program has no end. `line`: the last line.
    virtual void report_missing_end(std::uint32_t line);
    /// Keeps `source` as a further file of the program, and counts its lines.
    /// Returns: null if the program already has the number `count` of files.
    std::unique_ptr<SourceFile> keep_file(SourceFile source, std::size_t count);
    /// Reports an error.
    /// Returns: false.
    bool fail(const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments = {});
    /// Ends the program at a block that is not read.
    /// Returns: false.
    bool stop();
    /// Ends the program as M30 does.
    void end();
    /// Counts a block. Ends the program after too many repeated blocks.
    bool count_block(bool is_called, SourceSpan span);
    /// Starts the count of repeated blocks: a call, or a jump backwards.
    void count_repeats();
    /// Reports a call of the program `name`, which is not found and left out, unless the program is
    /// declared harmless.
    void report_missing_program(std::string_view name, SourceSpan span);
    /// Records the first executed block that begins with '/'.
    void note_deletable(std::size_t file, SourceSpan span);

    const InterpreterOptions& options_;
    DiagnosticLog& log_;
    Interpretation& result_;
    Parameters registers_;  // #1 …; G-code alone reads the registers.
    Path path_;
    Controller machine_;
    std::uint64_t repeated_ = 0;  // Blocks since the first jump or call.
    /// Limit of `repeated_`: the option plus the number of lines.
    std::uint64_t most_blocks_ = 0;
    bool ended_ = false;
};

}  // namespace ncsim::gcode::language
