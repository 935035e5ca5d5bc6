// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a program: reads blocks, follows its loops and calls, hands commands to the machine.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/parser.h"

#include "machine.h"
#include "resolve.h"

namespace ncsim::gcode {

class Runner {
public:
    Runner(const SourceFile& program, const InterpreterOptions& options, const Rules& rules,
           const MotionSink& sink, DiagnosticLog& log, Interpretation& result);

    void run();

private:
    bool step();
    bool percent();
    void assign(const Block& block);
    void tool_change_in_comment();

    const SourceFile& program_;
    const InterpreterOptions& options_;
    const Rules& rules_;
    DiagnosticLog& log_;
    Interpretation& result_;
    Parameters parameters_;
    Path path_;
    Machine machine_;
    Resolver resolver_;
    BlockReader reader_;
    Block block_;
    Command command_;
    bool percent_opened_ = false;
    bool something_read_ = false;
    bool ended_ = false;
};

}  // namespace ncsim::gcode
