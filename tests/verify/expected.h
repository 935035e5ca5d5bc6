// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common code of rule tests: the start of a program, and checks of a finding.
#pragma once

#include "verify/verified.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace ncsim::verify_test {

/// Line 1; the slots that follow begin at line 2.
inline const std::string kStart = "G21 G90 G17 T1 M6 S1000 M3 F500 G0 X-30 Y0 Z5\n";

inline verify::Finding only(const verify::Verdict& verdict, const std::string& rule) {
    const auto found = findings_of(verdict, rule);
    EXPECT_EQ(found.size(), 1U) << rule;
    return found.empty() ? verify::Finding{} : found.front();
}

inline void expect_at(const verify::Finding& f, std::uint32_t line, double value,
                      double tolerance = 1e-9) {
    EXPECT_EQ(f.place.span.line, line) << f.message;
    ASSERT_TRUE(f.quantity.has_value()) << f.message;
    EXPECT_NEAR(f.quantity->value, value, tolerance) << f.message;
}

inline verify::Setup not_simulated() {
    verify::Setup setup = plain_setup();
    setup.not_simulated = "tool 7 is not described";
    return setup;
}

}  // namespace ncsim::verify_test
