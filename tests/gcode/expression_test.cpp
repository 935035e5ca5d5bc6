// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of expressions, evaluated in the program G0 X<expression>.
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

/// Returns the X to which "G0 X<text>" leads; NaN if the block was refused.
double value_of(const std::string& text, Dialect dialect = Dialect::Rs274, bool strict = false) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.strict = strict;
    double x = std::nan("");
    const SourceFile file{"t.nc", "#1=6 #2=-2.5 #<depth>=3\nG21 G0 X" + text + "\nM2\n"};
    const Interpretation result = interpret(file, options, [&](const Motion& motion) {
        if (const Position* end = end_of(motion)) x = end->x.mm();
    });
    return has_errors(result.diagnostics) ? std::nan("") : x;
}

struct Case {
    const char* text;
    double expected;
};

TEST(Expression, IsWorthWhatTheReferenceSays) {
    const Case cases[] = {
        {"[1+2*3]", 7.0},
        {"[[1+2]*3]", 9.0},
        {"[2**3**2]", 64.0},
        {"[-3**2]", 9.0},
        {"[-10 MOD 3]", 2.0},
        {"[10 / 4]", 2.5},
        {"[1 OR 0 AND 0]", 0.0},
        {"[2 GT 1 AND 1 LE 1]", 1.0},
        {"[1 EQ 1.0000001]", 1.0},
        {"[1 NE 2]", 1.0},
        {"[1 XOR 1]", 0.0},
        {"#1", 6.0},
        {"-#1", -6.0},
        {"#<Depth>", 3.0},
        {"[#1 + #<de pth>]", 9.0},
        {"#[3-2]", 6.0},
        {"#99", 0.0},
        {"abs[#2]", 2.5},
        {"fix[-2.8]", -3.0},
        {"fup[-2.8]", -2.0},
        {"round[-2.5]", -3.0},
        {"sin[30]", 0.5},
        {"cos[90]", 0.0},
        {"sin[-30]", -0.5},
        {"cos[720]", 1.0},
        {"atan[1]/[1]", 45.0},
        {"atan[-1]/[-1]", -135.0},
        {"acos[0]", 90.0},
        {"sqrt[2]", std::sqrt(2.0)},
        {"ln[exp[1]]", 1.0},
        {"exists[#<depth>]", 1.0},
        {"exists[#<nothing>]", 0.0},
        {"[.1 + .2]", .1 + .2},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.text);
        EXPECT_NEAR(value_of(c.text), c.expected, 1e-12);
        EXPECT_NEAR(value_of(c.text, Dialect::Rs274, true), c.expected, 1e-12);
    }
}

TEST(Expression, TruncatesAndCountsBitsOnFanuc) {
    const Case cases[] = {
        {"FIX[-2.8]", -2.0}, {"FUP[-2.2]", -3.0}, {"[6 AND 3]", 2.0}, {"[6 OR 1]", 7.0},
        {"[6 XOR 3]", 5.0},  {"#1-#2", 8.5},      {"POW[2,3]", 8.0},  {"ATAN[1,1]", 45.0},
        {"BIN[18]", 12.0},   {"BCD[12]", 18.0},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.text);
        EXPECT_NEAR(value_of(c.text, Dialect::Fanuc), c.expected, 1e-12);
        EXPECT_TRUE(std::isnan(value_of(c.text, Dialect::Rs274, true)) ||
                    value_of(c.text, Dialect::Rs274, true) != c.expected);
    }
}

TEST(Expression, IsExactWhereMachinistsExpectIt) {
    EXPECT_EQ(value_of("[cos[60] * 2]"), value_of("[sin[30] * 2]"));
    EXPECT_EQ(value_of("[sin[30] * 2]"), 1.0);
    EXPECT_EQ(value_of("tan[45]"), 1.0);
    EXPECT_EQ(value_of("fix[tan[225]]"), 1.0);
    EXPECT_EQ(value_of("atan[1]/[1]"), 45.0);
    EXPECT_EQ(value_of("atan[0*-1]/[-1]"), 180.0);
    EXPECT_EQ(value_of("sin[180]"), 0.0);
    EXPECT_EQ(value_of("cos[270]"), 0.0);
}

TEST(Expression, AgreesWithTheLibraryOnManyAngles) {
    constexpr double kPi = 3.14159265358979323846;
    for (int i = -400; i < 400; ++i) {
        const double degrees = i * 1.37;
        SCOPED_TRACE(degrees);
        const std::string text = std::to_string(degrees);
        const double radians = std::stod(text) * kPi / 180.0;
        EXPECT_NEAR(value_of("sin[" + text + "]"), std::sin(radians), 1e-14);
        EXPECT_NEAR(value_of("cos[" + text + "]"), std::cos(radians), 1e-14);
        EXPECT_NEAR(value_of("atan[" + text + "]/[3]"),
                    std::atan2(std::stod(text), 3.0) * 180 / kPi, 1e-12);
    }
}

}  // namespace
}  // namespace ncsim::gcode
