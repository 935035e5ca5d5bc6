// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of short programs as a control executes them.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace ncsim::gcode::controls {

/// Path and messages of a program.
struct Made {
    std::string path;
    Interpretation result;
    bool says(std::string_view code) const {
        return std::ranges::any_of(result.diagnostics,
                                   [code](const Diagnostic& d) { return d.code == code; });
    }
};

/// Returns the ends of the moves as "G0 1 2 3" (rapid) and "G1 1 2 3" (feed), a line each; X Y Z in
/// mm, rounded to thousandths.
inline Made run(const std::string& program, Dialect dialect) {
    Made made;
    InterpreterOptions options;
    options.dialect = dialect;
    options.tools.push_back({.number = 1,
                             .offset = {Length(), Length(), Length::from_mm(7)},
                             .length_specified = true,
                             .diameter = Length::from_mm(4.0)});
    made.result = interpret({"t.nc", program}, options, [&](const Motion& motion) {
        const Position* end = end_of(motion);
        if (!end) return;
        made.path += motion.kind == MoveKind::Rapid ? "G0" : "G1";
        for (const Length value : {end->x, end->y, end->z}) {
            made.path += ' ';
            print_number(made.path, std::round(value.mm() * 1e3) / 1e3 + 0.0);
        }
        made.path += '\n';
    });
    return made;
}

inline const std::string kHead = "G21 G90 G17 G54 G94 G40 G49 G80 F100 S100 T1 M6 M3\n";

inline Made run_body(const std::string& body, Dialect dialect) {
    return run(kHead + body + "M30\n", dialect);
}

inline void expect_path(const std::string& body, Dialect dialect, const std::string& path) {
    SCOPED_TRACE(std::string(name_of(dialect)) + "\n" + body);
    const Made made = run_body(body, dialect);
    EXPECT_EQ(made.path, path);
    EXPECT_FALSE(has_errors(made.result.diagnostics));
}

}  // namespace ncsim::gcode::controls
