// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of formulas in three languages, and the part of a formula that a message names.
#include "gcode/klartext_made.h"
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::gcode::formula_values_test {
namespace {

using language_test::Made;

enum class Language { Klartext, Sinumerik, Rs274 };

/// Moves to X of the formula.
std::string program_of(Language language, const std::string& formula) {
    switch (language) {
        case Language::Klartext:
            return klartext_test::klartext("Q1 = " + formula + "\nL X+Q1 Y+1 FMAX");
        case Language::Sinumerik: return sinumerik_test::sinumerik("G0 Y1 X=" + formula);
        case Language::Rs274: break;
    }
    return "G21 G90 G17 T1 M6\nG0 Z5\nG0 Y1 X[" + formula + "]\nM2\n";
}

Made run(Language language, const std::string& formula) {
    const std::string program = program_of(language, formula);
    switch (language) {
        case Language::Klartext: return language_test::run(program);
        case Language::Sinumerik: return sinumerik_test::run(program);
        case Language::Rs274: break;
    }
    return language_test::run(program, {}, Dialect::Rs274, false, "t.ngc");
}

struct Formula {
    const char* text;
    double value;
};

void expect_values(Language language, const std::vector<Formula>& formulas) {
    for (const Formula& formula : formulas) {
        const Made made = run(language, formula.text);
        EXPECT_EQ(made.errors(), "") << formula.text;
        EXPECT_NEAR(made.end().x.mm(), formula.value, 1e-8) << formula.text;
    }
}

/// A formula that is refused, and the part of the program that the message marks.
struct Refused {
    const char* text;
    const char* marked;
};

void expect_refused(Language language, const std::vector<Refused>& formulas) {
    for (const Refused& formula : formulas) {
        const std::string program = program_of(language, formula.text);
        const Made made = run(language, formula.text);
        const auto error =
            std::ranges::find(made.result.diagnostics, Severity::Error, &Diagnostic::severity);
        ASSERT_NE(error, made.result.diagnostics.end()) << formula.text;
        std::size_t begin = 0;
        for (std::uint32_t line = 1; line < error->span.line; ++line)
            begin = program.find('\n', begin) + 1;
        EXPECT_EQ(program.substr(begin + error->span.column - 1, error->span.length),
                  formula.marked)
            << formula.text << ": " << error->message;
    }
}

TEST(FormulaValues, OfSinumerik) {
    expect_values(Language::Sinumerik, {{"1+2*3", 7},
                                        {"(1+2)*3", 9},
                                        {"10-4-3", 3},
                                        {"24/4/2", 3},
                                        {"-3+5", 2},
                                        {"-(3-5)", 2},
                                        {"17 DIV 5", 3},
                                        {"-17 DIV 5", -3},
                                        {"17 MOD 5", 2},
                                        {"SIN(30)", 0.5},
                                        {"COS(60)", 0.5},
                                        {"TAN(45)", 1},
                                        {"TAN(0)", 0},
                                        {"ASIN(0.5)", 30},
                                        {"ASIN(-1)", -90},
                                        {"ACOS(0.5)", 60},
                                        {"ACOS(-1)", 180},
                                        {"ATAN2(30,30)", 45},
                                        {"ATAN2(10,0)", 90},
                                        {"ATAN2(0,-10)", 180},
                                        {"SQRT(9)", 3},
                                        {"SQRT(0)", 0},
                                        {"POT(4)", 16},
                                        {"ABS(-5)", 5},
                                        {"TRUNC(2.7)", 2},
                                        {"TRUNC(-2.7)", -2},
                                        {"ROUND(2.5)", 3},
                                        {"ROUND(2.4)", 2},
                                        {"LN(1)", 0},
                                        {"EXP(1)", 2.718281828},
                                        {"MINVAL(4,3)", 3},
                                        {"MAXVAL(4,3)", 4},
                                        {"BOUND(2,8,9)", 8},
                                        {"BOUND(2,8,1)", 2},
                                        {"BOUND(8,2,5)", 5},
                                        {"PI", 3.141592654},
                                        {"TRUE+TRUE+FALSE", 2},
                                        {"STRLEN(\"four\")", 4},
                                        {"STRLEN(\"a\"<<12<<\"b\")", 4},
                                        {"(3<4)+2*(4<=4)+4*(5>5)", 3},
                                        {"(3>=4)+2*(3<>4)+4*(4==4)", 6},
                                        {"(\"a\"<\"b\")+2*(\"a\"==\"a\")", 3},
                                        {"(1 AND 0)+2*(1 OR 0)+4*(1 XOR 1)+8*(NOT 0)", 10},
                                        {"12 B_AND 10", 8},
                                        {"12 B_OR 10", 14},
                                        {"12 B_XOR 10", 6},
                                        {"(B_NOT 3)+10", 6},
                                        {"'H1F'", 31},
                                        {"'hfe'", 254},
                                        {"'B1101'", 13},
                                        {"2EX3", 2000},
                                        {"25EX-1", 2.5}});
    expect_refused(Language::Sinumerik, {{"SQRT(-1)", "SQRT(-1)"},
                                         {"LN(0)", "LN(0)"},
                                         {"ASIN(1.1)", "ASIN(1.1)"},
                                         {"ACOS(-1.1)", "ACOS(-1.1)"},
                                         {"TAN(90)", "TAN(90)"},
                                         {"1/0", "/"},
                                         {"SIN(1,2)", "SIN(1,2)"},
                                         {"STRLEN(5)", "STRLEN(5)"},
                                         {"ABS(\"a\")", "ABS(\"a\")"},
                                         {"NONSENSE+1", "NONSENSE"},
                                         {"'H1G'", "'H1G'"},
                                         {"'B2'", "'B2'"},
                                         {"1<2<3", "<"},
                                         {"1+\"a\"", "+"}});
}

TEST(FormulaValues, OfKlartext) {
    expect_values(Language::Klartext,
                  {{"1 + 2 * 3", 7},       {"( 1 + 2 ) * 3", 9}, {"10 - 4 - 3", 3},
                   {"24 / 4 / 2", 3},      {"2 ^ 3", 8},         {"17 % 5", 2},
                   {"SIN 30", 0.5},        {"COS 60", 0.5},      {"TAN 45", 1},
                   {"TAN 0", 0},           {"ASIN 0.5", 30},     {"ACOS 0.5", 60},
                   {"ATAN 1", 45},         {"ATAN -1", -45},     {"SQRT 9", 3},
                   {"SQ 4", 16},           {"ABS -5", 5},        {"INT 2.7", 2},
                   {"INT -2.7", -2},       {"FRAC 2.75", 0.75},  {"FRAC -2.75", -0.75},
                   {"NEG 4", -4},          {"SGN -9", -1},       {"SGN 9", 1},
                   {"SGN 0", 0},           {"LN 1", 0},          {"LOG 1000", 3},
                   {"EXP 1", 2.718281828}, {"PI", 3.141592654},  {"SQRT ( 9 + 16 )", 5},
                   {"1 + SIN 90 * 2", 3}});
    expect_refused(Language::Klartext, {{"SQRT -1", "SQRT"},
                                        {"LN 0", "LN"},
                                        {"LOG 0", "LOG"},
                                        {"ASIN 2", "ASIN"},
                                        {"TAN 90", "TAN"},
                                        {"1 / 0", "/"}});
}

TEST(FormulaValues, OfLinuxCnc) {
    expect_values(
        Language::Rs274,
        {{"1+2*3", 7},        {"[1+2]*3", 9},          {"10-4-3", 3},     {"24/4/2", 3},
         {"2**3", 8},         {"17 MOD 5", 2},         {"-17 MOD 5", 3},  {"SIN[30]", 0.5},
         {"COS[60]", 0.5},    {"TAN[45]", 1},          {"ASIN[0.5]", 30}, {"ACOS[0.5]", 60},
         {"ATAN[1]/[1]", 45}, {"ATAN[-1]/[-1]", -135}, {"SQRT[9]", 3},    {"ABS[-5]", 5},
         {"FIX[2.7]", 2},     {"FIX[-2.7]", -3},       {"FUP[2.1]", 3},   {"ROUND[2.5]", 3},
         {"LN[1]", 0},        {"EXP[1]", 2.718281828}, {"1 AND 0", 0},    {"1 OR 0", 1},
         {"1 XOR 1", 0},      {"3 LT 4", 1},           {"4 LE 4", 1},     {"5 GT 5", 0},
         {"5 GE 5", 1},       {"3 NE 4", 1},           {"3 EQ 4", 0},     {"EXISTS[#<a>]", 0}});
    expect_refused(Language::Rs274, {{"SQRT[-1]", "X[SQRT[-1]]"},
                                     {"LN[0]", "X[LN[0]]"},
                                     {"ASIN[2]", "X[ASIN[2]]"},
                                     {"1/0", "X[1/0]"}});
}

}  // namespace
}  // namespace ncsim::gcode::formula_values_test
