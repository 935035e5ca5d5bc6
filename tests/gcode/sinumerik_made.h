// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs SINUMERIK programs for the tests, and compares them with G-code.
#pragma once

#include "gcode/language_made.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace ncsim::gcode::sinumerik_test {

using language_test::expect_end;
using language_test::Files;
using language_test::iso;
using language_test::Made;

inline Made run(const std::string& text, const Files& files = {},
                Dialect dialect = Dialect::Sinumerik, bool block_delete = false,
                const std::shared_ptr<const JointSolver>& joints = nullptr) {
    return language_test::run(text, files, dialect, block_delete, "test.mpf", joints);
}

/// A program with the tool T1 (D10) over X0 Y0 Z50.
inline std::string sinumerik(const std::string& blocks) {
    return "G710 G90 G17 G40 G94\nT1 M6\nS1000 D1\nG0 X0 Y0 Z50 M3\n" + blocks + "\nM30\n";
}

/// Compares the motions of both programs, word for word.
inline void expect_same(const std::string& of_sinumerik, const std::string& of_iso) {
    const Made a = run(sinumerik(of_sinumerik));
    const Made b = language_test::run(iso(of_iso), {}, Dialect::Fanuc);
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(b.errors(), "");
    EXPECT_GT(a.texts.size(), 1U);
    EXPECT_EQ(a.texts, b.texts);
}

/// Compares the moves of both programs within rounding.
inline void expect_close(const std::string& of_sinumerik, const std::string& of_iso) {
    language_test::expect_close(run(sinumerik(of_sinumerik)),
                                language_test::run(iso(of_iso), {}, Dialect::Fanuc));
}

/// Compares the motions of two SINUMERIK programs.
inline void expect_equal(const std::string& one, const std::string& other,
                         const Files& files = {}) {
    const Made a = run(sinumerik(one), files);
    const Made b = run(sinumerik(other), files);
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(b.errors(), "");
    EXPECT_GT(a.texts.size(), 1U);
    EXPECT_EQ(a.texts, b.texts);
}

inline void expect_refused(const std::string& blocks, const std::string& error) {
    const Made r = run(sinumerik(blocks));
    EXPECT_EQ(r.errors(), error + "\n");
    EXPECT_TRUE(r.result.refused);
}

}  // namespace ncsim::gcode::sinumerik_test
