// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes of Klartext and SINUMERIK programs that must not change the motions: block numbers, line
// ends, repeats and calls written out, shifts instead of coordinates.
#include "gcode/klartext_made.h"
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

using klartext_test::klartext;
using language_test::Files;
using language_test::Made;
using sinumerik_test::sinumerik;

const std::vector<std::string> kKlartext{
    "L X+10 Y+5 F100\nCC X+0 Y+0\nC X-10 Y+5 DR+\nL X+0 RL\nL X+20\nRND R6\nL Y+20\nL X+0 R0",
    "CYCL DEF 200 DRILLING ~\n Q200=2 ;A ~\n Q201=-8 ;B ~\n Q206=150 ;C ~\n Q202=3 ;D ~\n Q203=0 "
    ";E\n"
    "L X+5 FMAX M99\nCYCL CALL POS X+10 Y+5 Z+0 FMAX",
    "FN 0: Q1=+3\nLBL 1\nL IX+Q1 F200\nL Z-1\nCALL LBL 1 REP 3\nCALL LBL 2\nL X+0\nSTOP\nLBL 2\n"
    "L IY+1\nLBL 0",
    "L X-10 Y-10 FMAX\nAPPR LCT X+10 Y+10 R5 RL F100\nL Y+50\nL X+50\nDEP CT CCA90 R8",
    "CYCL DEF 247 Q339=1\nCYCL DEF 7.0\nCYCL DEF 7.1 X+5\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+30\n"
    "L X+10 F100\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+0\nCYCL DEF 7.0\nCYCL DEF 7.1 X+0"};

const std::vector<std::string> kSinumerik{
    "G1 X10 Y5 F100\nG3 X-10 Y5 I-10 J-5\nG41 G1 X0\nX20 RND=6\nY20\nG40 X0",
    "MCALL CYCLE83(20,0,2,-12,,-4,,1,0,0,1,1)\nX5 Y5\nHOLES1(0,0,30,10,10,3)\nMCALL",
    "R1=3\nFOR R2=1 TO 4\nG1 X=IC(R1) F200\nENDFOR\nREPEAT_IT: G1 Y=IC(1)\nREPEATB REPEAT_IT P=2",
    "TRANS X5 Y5\nAROT RPL=30\nG1 X10 F100 CHR=2\nY10\nTRANS",
    "G111 X5 Y5\nG1 AP=90 RP=10 F100\nG3 AP=180\nIF R5==0\nG1 X0\nELSE\nG1 X9\nENDIF"};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// Writes `lines` with `head` in front of each line and `end` behind each line.
std::string joined(const std::vector<std::string>& lines, const std::string& end,
                   const std::function<std::string(std::size_t)>& head = {}) {
    std::string out;
    for (std::size_t i = 0; i < lines.size(); ++i)
        out += (head ? head(i) : std::string()) + lines[i] + end;
    return out;
}

void expect_equal(const Made& a, const Made& b, const std::string& what) {
    EXPECT_EQ(a.errors(), "") << what;
    EXPECT_EQ(b.errors(), "") << what;
    EXPECT_GT(a.texts.size(), 1U) << what;
    EXPECT_EQ(a.texts, b.texts) << what;
}

TEST(LanguageChanges, KlartextBlockNumbersAndLineEnds) {
    for (const std::string& blocks : kKlartext) {
        const std::string plain = klartext(blocks);
        const Made made = language_test::run(plain);
        const std::vector<std::string> lines = lines_of(plain);
        const auto is_continued = [&](std::size_t i) {
            return i > 0 && lines[i - 1].ends_with('~');
        };
        const auto numbers = [&](std::size_t i) {
            return is_continued(i) ? std::string() : std::to_string(10 * i) + " ";
        };
        const auto gaps = [&](std::size_t i) {
            return is_continued(i) || i % 3 == 0 ? std::string() : std::to_string(7 * i + 3) + " ";
        };
        expect_equal(made, language_test::run(joined(lines, "\n", numbers)), "numbers");
        expect_equal(made, language_test::run(joined(lines, "\n", gaps)), "gaps");
        expect_equal(made, language_test::run(joined(lines, "\r\n")), "CRLF");
        expect_equal(
            made,
            language_test::run(joined(lines, "\n", [](std::size_t) { return std::string("  "); })),
            "blanks");
        const auto comments = [&](std::size_t i) {
            return std::string(is_continued(i) ? "" : "; a comment \xDF\n\n");
        };
        expect_equal(made, language_test::run(joined(lines, "\n", comments)), "comments");
    }
}

TEST(LanguageChanges, SinumerikBlockNumbersAndLineEnds) {
    for (const std::string& blocks : kSinumerik) {
        const std::string plain = sinumerik(blocks);
        const Made made = sinumerik_test::run(plain);
        const std::vector<std::string> lines = lines_of(plain);
        const auto numbers = [](std::size_t i) { return "N" + std::to_string(10 * i + 10) + " "; };
        const auto gaps = [](std::size_t i) {
            return i % 3 == 0 ? std::string() : "N" + std::to_string(7 * i + 3) + " ";
        };
        expect_equal(made, sinumerik_test::run(joined(lines, "\n", numbers)), "numbers");
        expect_equal(made, sinumerik_test::run(joined(lines, "\n", gaps)), "gaps");
        expect_equal(made, sinumerik_test::run(joined(lines, "\r\n")), "CRLF");
        expect_equal(made, sinumerik_test::run(joined(lines, " ; a comment \xDF\n\n")), "comments");
    }
}

TEST(LanguageChanges, KlartextRepeatWrittenOut) {
    const std::string body = "L IX+3 F200\nL IZ-1\nL IZ+1\n";
    expect_equal(language_test::run(klartext("LBL 1\n" + body + "CALL LBL 1 REP 3\nL Y+5")),
                 language_test::run(klartext(body + body + body + body + "L Y+5")), "REP");
    expect_equal(language_test::run(
                     klartext("L X+1 F200\nCALL LBL 2\nCALL LBL 2\nM30\nLBL 2\n" + body + "LBL 0")),
                 language_test::run(klartext("L X+1 F200\n" + body + body + "M30")), "LBL");
}

TEST(LanguageChanges, KlartextProgramPasted) {
    const std::string body = "L IX+3 F200\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+30\nL X+20 Y+0\n";
    const Files files{{"sub.h", "BEGIN PGM SUB MM\n" + body + "END PGM SUB MM\n"}};
    const std::string rest = "L Y+5\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+0";
    expect_equal(language_test::run(klartext("CALL PGM TNC:\\PARTS\\sub.h\n" + rest), files),
                 language_test::run(klartext(body + rest)), "CALL PGM");
}

TEST(LanguageChanges, SinumerikCallsAndLoopsWrittenOut) {
    const std::string body = "G1 X=IC(3) F200\nZ=IC(-1)\nZ=IC(1)\n";
    const Files files{{"L10.SPF", body + "M17\n"}};
    const Made pasted = sinumerik_test::run(sinumerik(body + body + body + "Y5"));
    expect_equal(sinumerik_test::run(sinumerik("L10 P3\nY5"), files), pasted, "L10 P3");
    expect_equal(sinumerik_test::run(sinumerik("FOR R1=1 TO 3\n" + body + "ENDFOR\nY5")), pasted,
                 "FOR");
    expect_equal(sinumerik_test::run(sinumerik("A: " + body + "B:\nREPEAT A B P=2\nY5")), pasted,
                 "REPEAT");
}

TEST(LanguageChanges, ShiftInsteadOfCoordinates) {
    const std::string shifted =
        "G1 X15 Y25 F100\nG2 X25 Y15 I10 J0\nG1 X5\nMCALL CYCLE81(10,0,2,-5)\n"
        "X30 Y30\nMCALL";
    const std::string plain =
        "G1 X10 Y20 F100\nG2 X20 Y10 I10 J0\nG1 X0\nMCALL CYCLE81(10,0,2,-5)\n"
        "X25 Y25\nMCALL";
    expect_equal(sinumerik_test::run(sinumerik("TRANS X5 Y5\n" + plain + "\nTRANS")),
                 sinumerik_test::run(sinumerik(shifted)), "TRANS");
    expect_equal(language_test::run(klartext("CYCL DEF 247 Q339=1\nCYCL DEF 7.0\nCYCL DEF 7.1 X+5\n"
                                             "CYCL DEF 7.2 Y+5\nL X+10 Y+20 F100\nCC X+20 Y+20\n"
                                             "C X+20 Y+10 DR+")),
                 language_test::run(klartext("L X+15 Y+25 F100\nCC X+25 Y+25\nC X+25 Y+15 DR+")),
                 "cycle 7");
}

}  // namespace
}  // namespace ncsim::gcode
