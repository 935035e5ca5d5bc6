// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/gcode/interpreter.h"

#include "message.h"
#include "rules.h"
#include "runner.h"

namespace ncsim::gcode {

Interpretation interpret(const SourceFile& program, const InterpreterOptions& options,
                         const MotionSink& sink) {
    Interpretation result;
    DiagnosticLog log;
    result.files.push_back(program.name);
    result.dialect = detect_dialect(program);
    if (options.dialect != Dialect::Auto) {
        result.dialect.dialect = options.dialect;
        result.dialect.stated = true;
    }
    if (options.strict) result.dialect.dialect = Dialect::Rs274;
    const Rules rules = Rules::of(result.dialect.dialect, options.strict);
    Runner runner(program, options, rules, sink, log, result);
    runner.run();
    result.diagnostics = log.take();
    return result;
}

}  // namespace ncsim::gcode
