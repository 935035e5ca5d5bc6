// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs Klartext programs for the tests, and compares them with G-code.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ncsim::gcode::klartext_test {

struct Made {
    Interpretation result;
    std::vector<Motion> moves;       // Lines and arcs.
    std::vector<std::string> texts;  // All motions, without line numbers and tool changes.

    bool says(const std::string& code) const {
        return std::ranges::any_of(result.diagnostics,
                                   [&](const Diagnostic& d) { return d.code == code; });
    }
    std::string errors() const {
        std::string out;
        for (const Diagnostic& d : result.diagnostics) {
            if (d.severity == Severity::Error)
                out += std::to_string(d.span.line) + ":" + std::to_string(d.span.column) + ": " +
                       d.message + " [" + d.code + "]\n";
        }
        return out;
    }
    Position end() const { return moves.empty() ? Position{} : *end_of(moves.back()); }
};

using Files = std::map<std::string, std::string, std::less<>>;

inline Made run(const std::string& text, const Files& files = {}, Dialect dialect = Dialect::Auto,
                bool block_delete = false) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.block_delete = block_delete;
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = false, .diameter = Length::from_mm(10.0)}};
    options.limits.repeated_blocks = 20'000;
    options.peck_clearance = 0.2;
    options.read_file = [&](std::string_view name) -> std::optional<SourceFile> {
        const auto found = files.find(name);
        if (found == files.end()) return std::nullopt;
        return SourceFile{found->first, found->second};
    };
    Made out;
    const SourceFile file{"test.h", text};
    out.result = interpret(file, options, [&](const Motion& motion) {
        if (start_of(motion)) out.moves.push_back(motion);
        if (std::holds_alternative<ToolChange>(motion.action)) return;
        std::string line;
        print(line, motion);
        out.texts.push_back(line.substr(line.find(' ') + 1));
    });
    return out;
}

/// A program with the tool T1 (D10) over X0 Y0 Z50.
inline std::string klartext(const std::string& blocks) {
    return "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX M3\n" + blocks +
           "\nM30\nEND PGM T MM\n";
}
inline std::string iso(const std::string& blocks) {
    return "%\nO0001\nG21 G90 G17 G40 G80\nT1 M6\nG43 H1\nS1000 G0 X0. Y0. Z50. M3\n" + blocks +
           "\nM30\n%\n";
}

/// Compares the motions of both programs, word for word.
inline void expect_same(const std::string& of_klartext, const std::string& of_iso) {
    const Made a = run(klartext(of_klartext));
    const Made b = run(iso(of_iso), {}, Dialect::Fanuc);
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(b.errors(), "");
    EXPECT_GT(a.texts.size(), 1U);
    EXPECT_EQ(a.texts, b.texts);
}

inline void expect_refused(const std::string& blocks, const std::string& error) {
    const Made r = run(klartext(blocks));
    EXPECT_EQ(r.errors(), error + "\n");
    EXPECT_TRUE(r.result.refused);
}

inline void expect_end(const Made& r, double x, double y, double z) {
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(r.end().x.mm(), x, 1e-9);
    EXPECT_NEAR(r.end().y.mm(), y, 1e-9);
    EXPECT_NEAR(r.end().z.mm(), z, 1e-9);
}

}  // namespace ncsim::gcode::klartext_test
