// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of programs with the ends of their moves and the codes of their messages.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::outcome {

/// Texts of files by name.
using Files = std::map<std::string, std::string, std::less<>>;

struct Outcome {
    std::string moves;  ///< Ends of the moves, a line each.
    std::vector<std::string> codes;
    bool says(std::string_view code) const { return std::ranges::find(codes, code) != codes.end(); }
};

/// Runs `text`, which may call the programs of `files`.
inline Outcome run(const std::string& text, Dialect dialect, const Files& files = {}) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.read_file = [&](std::string_view name) -> std::optional<SourceFile> {
        const auto found = files.find(name);
        if (found == files.end()) return std::nullopt;
        return SourceFile{found->first, found->second};
    };
    Outcome outcome;
    const Interpretation result = interpret({"a.nc", text}, options, [&](const Motion& motion) {
        const Position* end = end_of(motion);
        if (!end) return;
        for (const Length value : {end->x, end->y, end->z}) {
            print_number(outcome.moves, value.mm());
            outcome.moves += ' ';
        }
        outcome.moves += '\n';
    });
    for (const Diagnostic& d : result.diagnostics)
        outcome.codes.push_back(d.code);
    return outcome;
}

}  // namespace ncsim::gcode::outcome
