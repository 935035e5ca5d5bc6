// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs Klartext programs for the tests, and compares them with G-code.
#pragma once

#include "gcode/language_made.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::gcode::klartext_test {

using language_test::expect_end;
using language_test::Files;
using language_test::iso;
using language_test::Made;
using language_test::run;

/// A program with the tool T1 (D10) over X0 Y0 Z50.
inline std::string klartext(const std::string& blocks) {
    return "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX M3\n" + blocks +
           "\nM30\nEND PGM T MM\n";
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

/// Compares the moves of both programs within rounding.
inline void expect_close(const std::string& of_klartext, const std::string& of_iso) {
    language_test::expect_close(run(klartext(of_klartext)), run(iso(of_iso), {}, Dialect::Fanuc));
}

inline void expect_refused(const std::string& blocks, const std::string& error) {
    const Made r = run(klartext(blocks));
    EXPECT_EQ(r.errors(), error + "\n");
    EXPECT_TRUE(r.result.refused);
}

}  // namespace ncsim::gcode::klartext_test
