// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values on both sides of each limit of G-code, and words that must not outlive their block.
#include "ncsim/gcode/control_codes.h"
#include "ncsim/gcode/file_programs.h"

#include "gcode/cradle.h"
#include "gcode/language_made.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

using language_test::Made;

/// Returns the codes of errors and warnings of a program that starts at X0 Y0 Z0; "" for none.
std::string codes(const std::string& blocks, bool strict = false, bool inches = false) {
    InterpreterOptions options;
    options.dialect = Dialect::Rs274;
    options.strict = strict;
    std::string out;
    const std::string head = std::string(inches ? "G20" : "G21") + " G90 G17 G94 F100\n";
    const Interpretation made = interpret({"t.nc", head + "G0 X0 Y0 Z0\n" + blocks + "\nM2\n"},
                                          options, [](const Motion&) {});
    for (const Diagnostic& d : made.diagnostics) {
        if (d.severity == Severity::Note) continue;
        out += (out.empty() ? "" : " ") + std::string(d.severity == Severity::Error ? "!" : "") +
               d.code;
    }
    return out;
}

Made run(const std::string& blocks, Dialect dialect = Dialect::Rs274) {
    return language_test::run("G21 G90 G17 G94 F100\nG0 X0 Y0 Z0\n" + blocks + "\nM2\n", {},
                              dialect, false, "t.nc");
}

Position last(const std::string& blocks, Dialect dialect = Dialect::Rs274) {
    const Made made = run(blocks, dialect);
    EXPECT_EQ(made.errors(), "") << blocks;
    return made.end();
}

// --- Arcs ---

struct Limit {
    const char* block;
    const char* strict;   ///< Code under strict rules; the tolerance is that of LinuxCNC.
    const char* lenient;  ///< Code under default rules.
};

TEST(Limits, RadiiOfTheEndsOfAnArc) {
    // Strict: at most 0.0283 mm, or 0.1 % of the radius and 2.83 mm. Default: at most 0.1 mm, or 5
    // % of the radius and 0.5 mm, is a spiral.
    const Limit limits[] = {
        {"G2 X20.028 I10", "", ""},
        {"G2 X20.029 I10", "!arc-radius-mismatch", "arc-spiral"},
        {"G2 X19.972 I10", "", ""},
        {"G2 X19.971 I10", "!arc-radius-mismatch", "arc-spiral"},
        {"G2 X200.099 I100", "", ""},
        {"G2 X200.102 I100", "!arc-radius-mismatch", "arc-spiral"},
        {"G2 X8000.282 I4000", "", ""},
        {"G2 X8002.829 I4000", "", ""},
        {"G2 X8002.831 I4000", "!arc-radius-mismatch", "!arc-radius-mismatch"},
        {"G2 X2.099 I1", "!arc-radius-mismatch", "arc-spiral"},
        {"G2 X2.11 I1", "!arc-radius-mismatch", "!arc-radius-mismatch"},
        {"G2 X20.49 I10", "!arc-radius-mismatch", "arc-spiral"},
        {"G2 X20.51 I10", "!arc-radius-mismatch", "!arc-radius-mismatch"},
        {"G2 X10.27 I5", "!arc-radius-mismatch", "!arc-radius-mismatch"},
        {"G2 X10.24 I5", "!arc-radius-mismatch", "arc-spiral"},
        {"G2 X8.195 I4", "!arc-radius-mismatch", "arc-spiral"},
    };
    for (const Limit& limit : limits) {
        EXPECT_EQ(codes(limit.block, true), limit.strict) << limit.block;
        EXPECT_EQ(codes(limit.block), limit.lenient) << limit.block;
    }
    EXPECT_EQ(codes("G2 X2.0027 I1", true, true), "");
    EXPECT_EQ(codes("G2 X2.0029 I1", true, true), "!arc-radius-mismatch");
}

TEST(Limits, HalfTheChordOfAnArcByRadius) {
    // LinuxCNC takes a radius that is at most 0.00127 mm too small; others up to 0.05 mm.
    const Limit limits[] = {
        {"G2 X20 R10", "", ""},
        {"G2 X20.0025 R10", "", ""},
        {"G2 X20.0027 R10", "!arc-radius-too-small", "arc-radius-too-small"},
        {"G3 X20.099 R-10", "!arc-radius-too-small", "arc-radius-too-small"},
        {"G2 X20.101 R10", "!arc-radius-too-small", "!arc-radius-too-small"},
        {"G2 X0.0026 I0.0013", "", ""},
        {"G2 X0.0024 I0.0012", "!arc-too-small", "arc-too-small"},
        {"G2 X20 I10 P1", "", ""},
        {"G2 X20 I10 P0", "!arc-turns", "arc-turns"},
        {"G2 X20 I10 P1.00009", "", ""},
        {"G2 X20 I10 P1.0002", "!arc-turns", "arc-turns"},
    };
    for (const Limit& limit : limits) {
        EXPECT_EQ(codes(limit.block, true), limit.strict) << limit.block;
        EXPECT_EQ(codes(limit.block), limit.lenient) << limit.block;
    }
    EXPECT_EQ(codes("G2 X0.0001 R0.00005", true, true), "");
    EXPECT_EQ(codes("G2 X2.00009 R1", true, true), "");
    EXPECT_EQ(codes("G2 X2.00011 R1", true, true), "!arc-radius-too-small");
}

TEST(Limits, TheCentreOfAnArcByRadiusIsOnTheSideOfItsSigns) {
    // Half chord 6, radius 10: the centre is 8 from the chord.
    struct Row {
        const char* block;
        double x, y;
    };
    for (const Row& row :
         {Row{"G2 X12 R10", 6, -8}, Row{"G3 X12 R10", 6, 8}, Row{"G2 X12 R-10", 6, 8},
          Row{"G3 X12 R-10", 6, -8}, Row{"G2 Y12 R10", 8, 6}, Row{"G3 Y12 R10", -8, 6},
          Row{"G2 Y12 R-10", -8, 6}, Row{"G3 Y12 R-10", 8, 6}}) {
        const Made made = run(row.block);
        const Arc& arc = std::get<Arc>(made.moves.back().action);
        EXPECT_NEAR(arc.centre_1.mm(), row.x, 1e-9) << row.block;
        EXPECT_NEAR(arc.centre_2.mm(), row.y, 1e-9) << row.block;
        EXPECT_EQ(arc.turns, row.block[1] == '2' ? -1 : 1);
    }
}

TEST(Limits, OnlyTheNextSplineContinuesATangent) {
    const std::string first = "G5 X4 Y4 I1 J2 P-1 Q-2\n";
    EXPECT_EQ(codes(first + "G5 X8 Y0 P1 Q2"), "");
    for (const char* between : {"G1 X5", "G0 X5", "G2 X6 Y4 I1", "G5.1 X6 Y5 I1 J1"})
        EXPECT_EQ(codes(first + between + "\nG5 X8 Y0 P1 Q2"), "!spline-words") << between;
    // A block without a move changes nothing.
    EXPECT_EQ(codes(first + "S100 M3\nG5 X8 Y0 P1 Q2"), "");
}

// --- Values ---

double value_of(const std::string& text, Dialect dialect = Dialect::Rs274) {
    const Made made = run("G0 X" + text, dialect);
    return made.errors().empty() ? made.end().x.mm() : std::nan("");
}

TEST(Limits, OfFunctions) {
    struct Row {
        const char* text;
        double value;  // NaN: refused
    };
    const double none = std::nan("");
    const Row rows[] = {
        {"[4**0.5]", 2.0},     {"[0**0.5]", 0.0},     {"[[-2]**2]", 4.0},      {"[[-2]**3]", -8.0},
        {"[[-2]**-1]", -0.5},  {"[[-2]**0.5]", none}, {"[[-0.5]**1.5]", none}, {"sqrt[0]", 0.0},
        {"sqrt[-0.01]", none}, {"acos[1]", 0.0},      {"asin[1]", 90.0},       {"asin[-1]", -90.0},
        {"acos[1.01]", none},  {"asin[-1.01]", none}, {"ln[1]", 0.0},          {"ln[0]", none},
        {"ln[-1]", none},      {"exp[0]", 1.0},       {"[1/0]", none},         {"[1 MOD 0]", none},
        {"[5 MOD -3]", 2.0},   {"[-5 MOD -3]", 1.0},  {"[1/0.5]", 2.0},        {"fup[2.0]", 2.0},
        {"fix[2.0]", 2.0},     {"fup[2.1]", 3.0},     {"fix[-0.5]", -1.0},     {"round[0.5]", 1.0},
        {"round[0.49]", 0.0},  {"[2 GE 2]", 1.0},     {"[2 GT 2]", 0.0},       {"[2 LE 2]", 1.0},
        {"[2 LT 2]", 0.0},     {"[1 AND 0]", 0.0},    {"[0 OR 1]", 1.0},       {"[1 XOR 0]", 1.0},
        {"[0 XOR 0]", 0.0},
    };
    for (const Row& row : rows) {
        const double value = value_of(row.text);
        if (std::isnan(row.value)) {
            EXPECT_TRUE(std::isnan(value)) << row.text;
        } else {
            EXPECT_NEAR(value, row.value, 1e-9) << row.text;
        }
    }
}

TEST(Limits, NumberOfAMacroCall) {
    const auto errors = [](const std::string& call) { return run(call, Dialect::Fanuc).errors(); };
    for (const char* call : {"G65 P-1 A1", "G65 P1000000000 A1", "G65 A1"})
        EXPECT_NE(errors(call).find("[call-without-number]"), std::string::npos) << call;
    EXPECT_EQ(errors("G65 P0 A1").find("[call-without-number]"), std::string::npos);
    EXPECT_EQ(errors("G65 P999999999 A1").find("[call-without-number]"), std::string::npos);
}

TEST(Limits, PositionsByNameInARotatedSystem) {
    // #<_x> is programmed, #<_abs_x> is of the machine: known for Z under a rotation, not for X.
    const std::string before = "G10 L2 P1 X5 Y6 Z7 R30\nG0 X1 Y2 Z3\n";
    EXPECT_NEAR(last(before + "G0 Z#<_abs_z>").z.mm(), 10.0, 1e-6);
    EXPECT_NE(run(before + "G0 Z#<_abs_x>").errors(), "");
    EXPECT_NE(run(before + "G0 Z#<_abs_y>").errors(), "");
    const std::string plain = "G10 L2 P1 X5 Y6 Z7\nG0 X1 Y2 Z3\n";
    EXPECT_NEAR(last(plain + "G0 Z#<_abs_x>").z.mm(), 6.0, 1e-6);
    EXPECT_NEAR(last(plain + "G0 Z#<_abs_y>").z.mm(), 8.0, 1e-6);
}

TEST(Limits, AngleOfTheExternalOffsetHasNoUnitOfLength) {
    const std::string set = "#5201=25.4\n#5204=90\n";
    const Made made = run(set + "G20\nG0 X#5201 Y[#5204/90]", Dialect::Fanuc);
    EXPECT_EQ(made.errors(), "");
    // The external offset of 1 inch acts on X, too.
    EXPECT_NEAR(made.end().x.mm(), 50.8, 1e-6);
    EXPECT_NEAR(made.end().y.mm(), 25.4, 1e-6);
}

// --- Modes in pairs ---

TEST(ModesInPairs, UnitsChangeInATiltedPlane) {
    // The origin of the plane was given in mm; Cradle turns about X.
    const auto joints = std::make_shared<language_test::Cradle>();
    const auto end = [&](const std::string& blocks) {
        const Made made =
            language_test::run("G21 G90 G17 G94 F100\nG0 X0 Y0 Z0\n" + blocks + "\nM30\n", {},
                               Dialect::Fanuc, false, "t.nc", joints);
        EXPECT_EQ(made.errors(), "") << blocks;
        return made.end();
    };
    for (const char* blocks : {"G68.2 X25.4 Y50.8 Z76.2 I0 J0 K0\nG53.1\nG0 X0 Y0 Z0",
                               "G68.2 X25.4 Y50.8 Z76.2 I0 J0 K0\nG20\nG53.1\nG0 X0 Y0 Z0",
                               "G20\nG68.2 X1 Y2 Z3 I0 J0 K0\nG21\nG53.1\nG0 X0 Y0 Z0",
                               "G20\nG68.2 X1 Y2 Z3 I0 J0 K0\nG53.1\nG21\nG0 X0 Y0 Z0"}) {
        const Position at = end(blocks);
        EXPECT_NEAR(at.x.mm(), 25.4, 1e-6) << blocks;
        EXPECT_NEAR(at.y.mm(), 50.8, 1e-6) << blocks;
        EXPECT_NEAR(at.z.mm(), 76.2, 1e-6) << blocks;
    }
}

TEST(ModesInPairs, UnitsChangeBeforeTheWordThatTurnsTheTool) {
    // LinuxCNC keeps the plane until G53.6; its origin was given in mm.
    const auto joints = std::make_shared<language_test::Cradle>();
    const auto end = [&](const std::string& units) {
        const Made made =
            language_test::run("G21 G90 G17 G94 F100\nG0 X0 Y0 Z0\nG68.2 X25.4 Y12.7 Z5 J90\n" +
                                   units + "\nG53.6\nG0 X0 Y0 Z0\nM2\n",
                               {}, Dialect::Rs274, false, "t.nc", joints);
        EXPECT_EQ(made.errors(), "");
        return made.end();
    };
    const Position mm = end("G21"), inches = end("G20");
    EXPECT_NEAR(mm.x.mm(), 25.4, 1e-6);
    EXPECT_NEAR(inches.x.mm(), 25.4, 1e-6);
    EXPECT_NEAR(inches.y.mm(), mm.y.mm(), 1e-6);
    EXPECT_NEAR(inches.z.mm(), mm.z.mm(), 1e-6);
}

TEST(ModesInPairs, FeedOfARefusedDwellIsNotKept) {
    const Made made = run("G1 X1\nG4 P-1 F500\nG1 X2");
    EXPECT_NE(made.errors(), "");
    EXPECT_EQ(made.moves.back().feed, 100.0);
}

TEST(ModesInPairs, ZeroThatTurnsWithTheTableInInches) {
    const auto joints = std::make_shared<language_test::Cradle>();
    const auto end = [&](const std::string& blocks) {
        return language_test::run(blocks + "\nM30\n", {}, Dialect::Haas, false, "t.nc", joints)
            .end();
    };
    const Position mm =
        end("G21 G90\nG10 L2 P1 X10. Y20. Z30.\nG54\nG0 X0. Y0. Z0. A90.\nG254\nG0 X1. Y2. Z3.");
    const Position inches =
        end("G20 G90\nG10 L2 P1 X[10/25.4] Y[20/25.4] Z[30/25.4]\nG54\nG0 X0. Y0. Z0. A90.\nG254\n"
            "G0 X[1/25.4] Y[2/25.4] Z[3/25.4]");
    EXPECT_NEAR(mm.x.mm(), inches.x.mm(), 1e-6);
    EXPECT_NEAR(mm.y.mm(), inches.y.mm(), 1e-6);
    EXPECT_NEAR(mm.z.mm(), inches.z.mm(), 1e-6);
}

TEST(ModesInPairs, AnArcOnACylinderMovesTheOtherAxesInProportion) {
    // Radius 10 mm: 90 degrees are 5 pi mm. X goes from 30 to 32 while C and Z follow the arc.
    const double degree = 10.0 * 3.14159265358979324 / 180.0;
    const Made made = run("G0 X30 C0\nG19 G7.1 C10\nG1 Z-10 F100\nG3 X32 Z-20 C" +
                              std::to_string(10 / degree) + " R10\nG7.1 C0",
                          Dialect::Fanuc);
    EXPECT_EQ(made.errors(), "");
    std::vector<double> x;
    for (const Motion& move : made.moves) {
        if (move.span.line == 6) x.push_back(end_of(move)->x.mm());
    }
    ASSERT_GT(x.size(), 3U);
    for (std::size_t i = 0; i < x.size(); ++i)
        EXPECT_NEAR(x[i], 30.0 + 2.0 * static_cast<double>(i + 1) / static_cast<double>(x.size()),
                    1e-6);
}

TEST(ModesInPairs, StepAsideIsOfItsCycleAlone) {
    const Made made =
        run("G0 Z50\nM3 S100\nG76 X10 Z-5 R2 Q0.5\nG80 G0 X0\nG76 X10 Z-5 R2 Q0\nG80\nG81 X20 Z-5 "
            "R2\nG80",
            Dialect::Fanuc);
    EXPECT_EQ(made.errors(), "");
    const auto aside = [&](std::uint32_t line) {
        std::string out;
        for (const Motion& move : made.moves) {
            if (move.span.line == line && move.steps_aside) out += *move.steps_aside ? 'y' : 'n';
        }
        return out;
    };
    EXPECT_NE(aside(5).find('y'), std::string::npos);
    EXPECT_EQ(aside(5).find('n'), std::string::npos);
    EXPECT_EQ(aside(6), "");
    EXPECT_NE(aside(7).find('n'), std::string::npos);
    EXPECT_EQ(aside(7).find('y'), std::string::npos);
    EXPECT_EQ(aside(9), "");
}

TEST(ModesInPairs, WordsOfACycleEndWithG80OrG0) {
    // R, Z and Q of a cycle are kept while cycles follow, and dropped by G80 and by a move.
    EXPECT_EQ(codes("G0 Z50\nG99 G81 X1 Z-5 R2\nG82 X2 P1\nG80"), "");
    for (const char* end : {"G80", "G0 X9", "G1 X9"}) {
        const std::string first = "G0 Z50\nG99 G83 X1 Z-5 R2 Q1\n" + std::string(end) + "\n";
        const auto missing = [&](const std::string& block) {
            EXPECT_EQ(codes(first + block + "\nG80", true), "!cycle-word-missing") << end << block;
            EXPECT_EQ(codes(first + block + "\nG80"), "cycle-word-missing") << end << block;
        };
        EXPECT_EQ(codes(first + "G81 X3 Z-5 R2\nG80", true), "") << end;
        missing("G81 X3 Z-5");
        missing("G83 X3 Z-5 R2");
        EXPECT_EQ(codes(first + "G81 X3 R2\nG80", true), "!cycle-word-missing") << end;
    }
}

TEST(ModesInPairs, RotationInIncrementsTurnsAboutTheNamedCentre) {
    // G68 R90 about (10, 0), then G91: 5 along X is 5 along Y of the part.
    const Made made = run("G68 X10 Y0 R90\nG1 X10 Y0\nG91 G1 X5\nY5\nG90 G69", Dialect::Fanuc);
    EXPECT_EQ(made.errors(), "");
    const auto at = [&](std::size_t back) { return *end_of(made.moves[made.moves.size() - back]); };
    EXPECT_NEAR(at(3).x.mm(), 10.0, 1e-6);
    EXPECT_NEAR(at(3).y.mm(), 0.0, 1e-6);
    EXPECT_NEAR(at(2).x.mm(), 10.0, 1e-6);
    EXPECT_NEAR(at(2).y.mm(), 5.0, 1e-6);
    EXPECT_NEAR(at(1).x.mm(), 5.0, 1e-6);
    EXPECT_NEAR(at(1).y.mm(), 5.0, 1e-6);
}

// --- Files ---

TEST(Limits, AJumpToAComputedLineReachesEachLine) {
    const auto unreached = [](const std::string& text) {
        const SourceFile source{"a.nc", text};
        const FilePrograms file(source);
        return file.unreached().size();
    };
    EXPECT_EQ(unreached("O1\nG1 X1\nM97 P20\nM30\nN10 X1\nM99\nN20 X2\nM99\n"), 1U);
    EXPECT_EQ(unreached("O1\nG1 X1\nM97 P#1\nM30\nN10 X1\nM99\nN20 X2\nM99\n"), 0U);
}

TEST(Limits, TheRadiusOfALineOrACycleIsNoArc) {
    const auto lacks_radius = [](const std::string& program) {
        for (const CodeUse& use :
             missing_codes({"p.nc", program}, *find_control_codes("smoothieware"))) {
            if (use.what == "arcs by radius (R)") return true;
        }
        return false;
    };
    for (const char* none : {"G1 X1 R5\n", "G81 X1 Z-1 R2\nX2 R3\n", "G2 X1 I5\nG1 X2\nX3 R4\n"})
        EXPECT_FALSE(lacks_radius(none)) << none;
    for (const char* arc : {"G2 X1 R5\n", "G3 Y1 R-5\n", "G2 X1 I1\nX3 R4\n", "G1 X1\nG3 Z2 R4\n"})
        EXPECT_TRUE(lacks_radius(arc)) << arc;
}

}  // namespace
}  // namespace ncsim::gcode
