// SPDX-License-Identifier: GPL-3.0-or-later
//
// Detection of dialects; a specified dialect has priority over a detected dialect.
#include "ncsim/gcode/dialect.h"

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"
#include "ncsim/gcode/subprogram_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Case {
    const char* text;
    Dialect dialect;
    Kind kind;
};

TEST(Dialect, IsConcludedFromSignsInTheProgram) {
    const Case cases[] = {
        {"G21\nG1 X1 Y1 F1\n", Dialect::Rs274, Kind::Milling},
        {"%\nO1234 (PART)\nG28 G91 Z0\n", Dialect::Fanuc, Kind::Milling},
        {"#1=2\nIF[#1LT3]GOTO10\nN10 X1 Y1\n", Dialect::Fanuc, Kind::Milling},
        {"o<a> sub\nG0 X1 Y1\no<a> endsub\n", Dialect::Rs274, Kind::Milling},
        {"%\nO00001\nG187 P1\nG0 X1 Y1\n", Dialect::Haas, Kind::Milling},
        {"G1 X50,C2\nY30,R4\nX0 F100\n", Dialect::Fanuc, Kind::Milling},
        {"G187 P1\nG1 X50,C2\nY30,R4\nG28 G91 Z0\n", Dialect::Haas, Kind::Milling},
        {"G1 X50 (a, C2)\nY30 F100\n", Dialect::Rs274, Kind::Milling},
        {"$H\nG0 X1 Y1\n", Dialect::Grbl, Kind::Milling},
        {"(Mach3 post)\nG0 X1 Y1\n", Dialect::Mach3, Kind::Milling},
        {"0 BEGIN PGM A MM\n1 L X+1 Y+1 R0 FMAX\n", Dialect::Rs274, Kind::Heidenhain},
        {"WORKPIECE(,\"\",,\"BOX\")\nG0 X1 Y1\n", Dialect::Rs274, Kind::Siemens},
        {"N10 G0 X1\nN20 MCALL CYCLE81(10,0,2,-5)\n", Dialect::Rs274, Kind::Siemens},
        {"T=\"CUTTER 6\"\nM6\nG0 X1 Y1\n", Dialect::Rs274, Kind::Siemens},
        {"%PART G71 *\nN10 G30 G17 X+0 Y+0 Z-40*\nN20 G31 G90 X+100 Y+100 Z+0*\n", Dialect::Rs274,
         Kind::HeidenhainIso},
        {"10 L X+10 Y+10\n11 L Z-5\n", Dialect::Rs274, Kind::Heidenhain},
        {"10 L X+Q1 Y+Q2\n11 L ZQ5\n", Dialect::Rs274, Kind::Heidenhain},
        {"1 TOOL DEF 1 L+0 R+5\n", Dialect::Rs274, Kind::Heidenhain},
        {"L  IX-10\nL Y+2 F100\n", Dialect::Rs274, Kind::Heidenhain},
        {"CC X+0 Y+0\nC X+5 Y+0 DR-\n", Dialect::Rs274, Kind::Heidenhain},
        {"G2 X10 Y10 CR=10 F100\n", Dialect::Rs274, Kind::Siemens},
        {"G1 X=AC(20) Y=IC(5)\n", Dialect::Rs274, Kind::Siemens},
        {"R1=5 R2 = 10\nG0 X1 Y1\n", Dialect::Rs274, Kind::Siemens},
        {"G0 X=R1 Y1\n", Dialect::Rs274, Kind::Siemens},
        {"G1 X10 RND=5\n", Dialect::Rs274, Kind::Siemens},
        {"G0 X1 Y1\nCYCLE83(10,0,2,-5)\n", Dialect::Rs274, Kind::Siemens},
        {"G0 X1 Y1\nMSG (\"roughing\")\n", Dialect::Rs274, Kind::Siemens},
        {"$PART.MIN%\nG15 H1\nG0 X1 Y1\n", Dialect::Rs274, Kind::Okuma},
        {"#SLOPE[TYPE=STEP]\nG0 X1 Y1\n", Dialect::Rs274, Kind::Isg},
        {"G28 G91 Z0\nG65 P9810 Z10.\n(a comment names $H and MCALL)\n", Dialect::Fanuc,
         Kind::Milling},
        {"M104 S200\nM140 S60\nG1 X1 Y1 E1\n", Dialect::Rs274, Kind::Printer},
        {"T0101\nG96 S200 M3\nG0 X20 Z2\n", Dialect::Rs274, Kind::Lathe},
        {"T0101\nG97 S900 M3\nG0 X20 Z2\n", Dialect::Rs274, Kind::Lathe},
        {"G96 S200 M3\nG0 X20 Z2\nG1 Z-5\n", Dialect::Rs274, Kind::Lathe},
        {"G50 S2500\nG0 X20 Z2\nG1 Z-5\n", Dialect::Rs274, Kind::Lathe},
        {"M104\nM109\nG96 S200 M3\nG0 X20 Z2\n", Dialect::Rs274, Kind::Lathe},
        {"M4 S0\nG0 X0 Y0\nG1 X9 S500\nX5 S9\nX2 S0\n", Dialect::Rs274, Kind::Laser},
        {"G21 G90\nM4 S0\nG0 X0 Y0\nG1 X10 S500 F1000\nY10\nM5\n", Dialect::Rs274, Kind::Laser},
        {"M106 S9\nM107\nM4 S0\nG1 X9 Y2\n", Dialect::Rs274, Kind::Laser},
        {"; LightBurn 1.0\nM4 S0\nG1 X1 Y1 S100\n", Dialect::Rs274, Kind::Laser},
        {"(plasma cut)\nM3\nG1 X1 Y1\n", Dialect::Rs274, Kind::Plasma},
        {"Dear reader,\nthis is prose.\n", Dialect::Rs274, Kind::NotAProgram},
        {"", Dialect::Rs274, Kind::NotAProgram},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.text);
        const DialectFindings findings = detect_dialect({"t.nc", c.text});
        EXPECT_EQ(name_of(findings.dialect), name_of(c.dialect));
        EXPECT_EQ(name_of(findings.kind), name_of(c.kind));
    }
}

/// Milling programs with elements that resemble the language of a different control.
TEST(Dialect, OfMillingProgramsStaysMilling) {
    for (const char* text : {
             "#1=5\n#<r>=2\n#<_r1> = 3\nG0 X#1 Y1\n",  // parameters, not R parameters
             "$100=250\n$N0=G54 X=1\nG0 X1 Y1\n",      // settings of grbl
             "M117 X=5 Y=2\nG0 X1 Y1\n",               // text on a display
             "DPRNT[X=#1]\nG0 X1 Y1\n",
             "X = 100\nY = 50\nG0 X1 Y1\n",   // prose without parentheses
             "(MSG, R1=5 CR=2)\nG0 X1 Y1\n",  // comments
             "o<cycle81> call [1]\no<pocket3> call\nG0 X1 Y1\n",
             "T0101 M6\nG0 Z5\nG1 Z-5\n",  // warms up, changes tools
             "T0101\nG0 X5 Z5\nG1 Y3\n",
             "G96 S200 M3\nG0 X5 Z5 A10\nG1 Z-1 A90\n",  // a wrap without Y
             "M104\nM109\nG0 X5 Y1 Z5\n",                // M codes of a machine
             "M3 S0\nG0 X5 Y1 Z5\nG1 X1 S1\nX2 S2\nX3 S3\n",
             "M3 S1000\nG0 X5 Y1 S900\nG1 X1 F1\n",
             "C X-axis to the left\nL Z-AXIS\nG0 X5 Y1\n",  // prose
             "C10 L2\nL1 X5\nG0 X5 Y1\n",
         }) {
        EXPECT_EQ(name_of(detect_dialect({"t.nc", text}).kind), name_of(Kind::Milling)) << text;
    }
}

TEST(Dialect, ThatIsStatedEndsARefusal) {
    InterpreterOptions options;
    const SourceFile file{"t.nc", "T0101\nG96 S200 M3\nG0 X20 Z2\nM2\n"};
    EXPECT_TRUE(interpret(file, options, {}).refused);
    options.dialect = Dialect::Fanuc;
    const Interpretation result = interpret(file, options, {});
    EXPECT_FALSE(result.refused);
    EXPECT_EQ(result.motions, 1U);
    EXPECT_EQ(std::ranges::count(result.diagnostics, "foreign-kind", &Diagnostic::code), 1);
}

// A subprogram of plain moves has no further evidence. D0 and G4 F2 have a different meaning in
// Sinumerik.
TEST(Dialect, FileNamesOfSinumerikDecideUnlessTheTextIsOfAnotherControl) {
    const auto kind = [](const char* name, const char* text) {
        return detect_dialect({name, text}).kind;
    };
    const char* plain = "N10 G0 X1 Y1 D1\nN20 G4 F2\nN30 G1 X5 F100\nM17\n";
    EXPECT_EQ(kind("PART.MPF", plain), Kind::Siemens);
    EXPECT_EQ(kind("dir/l106.spf", plain), Kind::Siemens);
    EXPECT_EQ(kind("part.nc", plain), Kind::Milling);
    EXPECT_EQ(kind("mpf", plain), Kind::Milling);
    EXPECT_EQ(kind("a.mpf", "G21 G90 G17\nG0 X1 Y1\nM30\n"), Kind::Milling);
    EXPECT_EQ(kind("a.mpf", "G90\nG43 H1 Z5\nM30\n"), Kind::Milling);
    EXPECT_EQ(kind("a.mpf", "%\nO1005\nG65 P9810 Z10.\nM99\n"), Kind::Milling);
}

TEST(Dialect, SignsFarBehindTheBeginningCount) {
    std::string text = "G21 G90\n";
    for (int i = 0; i < 20'000; ++i)
        text.append("G1 X").append(std::to_string(i)).append(" Y1.5 F100\n");
    EXPECT_EQ(detect_dialect({"t.nc", text}).dialect, Dialect::Rs274);
    EXPECT_EQ(detect_dialect({"t.nc", text + "M97 P100\n"}).dialect, Dialect::Haas);
    EXPECT_EQ(detect_dialect({"t.nc", text + "END PGM A MM\n"}).kind, Kind::Heidenhain);
}

TEST(Dialect, OfBinaryBytesIsNone) {
    std::string bytes(4096, '\x01');
    EXPECT_EQ(detect_dialect({"t.bin", bytes}).kind, Kind::NotAProgram);
    const Interpretation result = interpret({"t.bin", bytes}, {}, {});
    EXPECT_TRUE(result.refused);
    EXPECT_TRUE(has_errors(result.diagnostics));
}

TEST(Dialect, ThatIsStatedWins) {
    InterpreterOptions options;
    options.dialect = Dialect::Grbl;
    const Interpretation result = interpret({"t.nc", "%\nO1234\nG0 X1 Y1\nM30\n"}, options, {});
    EXPECT_EQ(result.dialect.dialect, Dialect::Grbl);
    EXPECT_TRUE(result.dialect.stated);
}

TEST(Interpreter, PassesOverAllowedWordsInSilence) {
    InterpreterOptions options;
    options.allow = {"G199", "m333", "E"};
    const SourceFile file{"t.nc", "G21 G0 X1 Y1\nG199 P1\nM333\nG1 X2 E4 F1\nM2\n"};
    options.dialect = Dialect::Haas;
    EXPECT_TRUE(interpret(file, options, {}).diagnostics.empty());
    options.allow.clear();
    EXPECT_EQ(interpret(file, options, {}).diagnostics.size(), 3U);
}

TEST(Interpreter, CountsLeastIncrementsWhenAskedTo) {
    InterpreterOptions options;
    options.dialect = Dialect::Fanuc;
    const SourceFile file{"t.nc",
                          "G21 G0 X12345 Y0. Z0\nG3 X2345 I-5000 J0 F100\nG4 P500\n"
                          "G20 G0 X10000 A90000\nM2\n"};
    const auto motions = [&] {
        std::string out;
        interpret(file, options, [&](const Motion& motion) {
            if (const Position* end = end_of(motion)) {
                print_number(out, end->x.mm());
                out += ' ';
                print_number(out, end->y.mm());
                out += ' ';
                print_number(out, end->a.degrees());
                out += ";";
            }
        });
        return out;
    };
    EXPECT_EQ(motions(), "12345 0 0;2345 0 0;254000 0 90000;");
    options.least_increments = true;
    EXPECT_EQ(motions(), "12.345 0 0;2.345 0 0;25.4 0 90;");
}

TEST(Interpreter, AsksOnceAboutNumbersWithoutAPoint) {
    InterpreterOptions options;
    options.dialect = Dialect::Fanuc;
    const auto hints = [&options](const char* text) {
        const Interpretation result = interpret({"t.nc", text}, options, {});
        return std::ranges::count(result.diagnostics, "no-decimal-point", &Diagnostic::code);
    };
    EXPECT_EQ(hints("G0 X12345 Y5000 Z1\nX3000\nM2\n"), 1);
    EXPECT_EQ(hints("G0 X123 Y5000. Z1\nM2\n"), 0);
    options.dialect = Dialect::Rs274;
    EXPECT_EQ(hints("G0 X12345\nM2\n"), 0);
}

TEST(SubprogramFiles, AreWhatControlsCallThem) {
    const std::vector<std::string> number = subprogram_files("O12");
    for (const char* file : {"O12.nc", "O0012.nc", "O00012.NC", "12.nc", "0012.txt", "O0012"})
        EXPECT_NE(std::ranges::find(number, file), number.end()) << file;
    EXPECT_EQ(subprogram_files("probe").front(), "probe.ngc");
    for (const char* bad : {"", ".", "../x", "a/b", "a\\b"})
        EXPECT_TRUE(subprogram_files(bad).empty()) << bad;
}

TEST(SubprogramFiles, HaveTheEndingOfAProgram) {
    for (const char* name : {"a.ngc", "O12.NC", "x.tap", "b.txt", "dir/c.sub", "a.b.cnc"})
        EXPECT_TRUE(is_program_file(name)) << name;
    for (const char* name : {"", "a", ".nc", "nc", "a.ng", "a.nc.png", "a.", "Makefile"})
        EXPECT_FALSE(is_program_file(name)) << name;
}

TEST(Interpreter, SaysWhichUnitsTheFirstLengthHad) {
    EXPECT_FALSE(interpret({"t.nc", "G0 X1\nG20\n"}, {}, {}).units_stated);
    const Interpretation inches = interpret({"t.nc", "G20 G0 X1\nG21\n"}, {}, {});
    EXPECT_TRUE(inches.units_stated);
    EXPECT_TRUE(inches.uses_inches);
}

TEST(Interpreter, SkipsDeletedBlocksOnlyWhenAsked) {
    InterpreterOptions options;
    const SourceFile file{"t.nc", "G0 X1\n/X2\nM2\n"};
    EXPECT_EQ(interpret(file, options, {}).motions, 2U);
    options.block_delete = true;
    EXPECT_EQ(interpret(file, options, {}).motions, 1U);
}

TEST(Interpreter, TellsTheFrameAMotionWasProgrammedIn) {
    std::vector<ProgramFrame> frames;
    interpret({"t.nc", "G20 G55 G92 X1\nG18 G0 X2\nM2\n"}, {},
              [&](const Motion& motion) { frames.push_back(*motion.frame); });
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_TRUE(frames[0].inches);
    EXPECT_EQ(frames[0].system, 2);
    EXPECT_EQ(frames[0].offset_92[kX], -1.0);
    EXPECT_EQ(frames[0].plane, Plane::ZX);
}

TEST(Interpreter, StaysWithinItsLimits) {
    InterpreterOptions options;
    options.limits.repeated_blocks = 100;
    const Interpretation result =
        interpret({"t.nc", "o1 while [1]\nG91 G0 X1\no1 endwhile\n"}, options, {});
    EXPECT_TRUE(result.stopped);
    EXPECT_LE(result.motions, 110U);
}

}  // namespace
}  // namespace ncsim::gcode
