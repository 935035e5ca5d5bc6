// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs programs in the languages of controls for the tests.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ncsim::gcode::language_test {

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
                bool block_delete = false, const std::string& name = "test.h",
                const std::shared_ptr<const JointSolver>& joints = nullptr,
                double peck_clearance = 0.2) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.block_delete = block_delete;
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = false, .diameter = Length::from_mm(10.0)}};
    options.limits.repeated_blocks = 20'000;
    options.peck_clearance = peck_clearance;
    options.joints = joints;
    options.read_file = [&](std::string_view path) -> std::optional<SourceFile> {
        const auto found = files.find(path);
        if (found == files.end()) return std::nullopt;
        return SourceFile{found->first, found->second};
    };
    Made out;
    const SourceFile file{name, text};
    out.result = interpret(file, options, [&](const Motion& motion) {
        if (start_of(motion)) out.moves.push_back(motion);
        if (std::holds_alternative<ToolChange>(motion.action)) return;
        std::string line;
        print(line, motion);
        out.texts.push_back(line.substr(line.find(' ') + 1));
    });
    // A message that the program is stopped is true.
    for (const Diagnostic& d : out.result.diagnostics) {
        if (d.message.find("the program is stopped here") == std::string::npos) continue;
        EXPECT_TRUE(out.result.refused || out.result.stopped) << d.message << '\n' << text;
    }
    return out;
}

/// A program for Fanuc with the tool T1 (D10) over X0 Y0 Z50.
inline std::string iso(const std::string& blocks) {
    return "%\nO0001\nG21 G90 G17 G40 G80\nT1 M6\nG43 H1\nS1000 G0 X0. Y0. Z50. M3\n" + blocks +
           "\nM30\n%\n";
}

/// Compares the moves of two programs: kinds, ends and centres within 1e-6 mm.
inline void expect_close(const Made& a, const Made& b) {
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(b.errors(), "");
    ASSERT_EQ(a.moves.size(), b.moves.size());
    EXPECT_GT(a.moves.size(), 1U);
    const auto expect_near = [](const Position& p, const Position& q, std::size_t move) {
        EXPECT_NEAR(p.x.mm(), q.x.mm(), 1e-6) << "move " << move;
        EXPECT_NEAR(p.y.mm(), q.y.mm(), 1e-6) << "move " << move;
        EXPECT_NEAR(p.z.mm(), q.z.mm(), 1e-6) << "move " << move;
    };
    for (std::size_t i = 0; i < a.moves.size(); ++i) {
        expect_near(*end_of(a.moves[i]), *end_of(b.moves[i]), i);
        const auto* const arc = std::get_if<Arc>(&a.moves[i].action);
        const auto* const other = std::get_if<Arc>(&b.moves[i].action);
        ASSERT_EQ(arc == nullptr, other == nullptr) << "move " << i;
        EXPECT_EQ(a.moves[i].kind, b.moves[i].kind) << "move " << i;
        if (!arc) continue;
        EXPECT_EQ(arc->turns, other->turns) << "move " << i;
        EXPECT_NEAR(arc->centre_1.mm(), other->centre_1.mm(), 1e-6) << "move " << i;
        EXPECT_NEAR(arc->centre_2.mm(), other->centre_2.mm(), 1e-6) << "move " << i;
    }
}

inline void expect_end(const Made& r, double x, double y, double z) {
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(r.end().x.mm(), x, 1e-9);
    EXPECT_NEAR(r.end().y.mm(), y, 1e-9);
    EXPECT_NEAR(r.end().z.mm(), z, 1e-9);
}

}  // namespace ncsim::gcode::language_test
