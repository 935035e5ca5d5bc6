// SPDX-License-Identifier: GPL-3.0-or-later
//
// Detection of NC programs among text files, over typical files in folders of programs.
#include "ncsim/gcode/program_text.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

// For messages of tests.
static void PrintTo(TextKind kind, std::ostream* out) {
    *out << name_of(kind);
}

namespace {

struct Sample {
    const char* what;
    std::string text;
    TextKind kind;
};

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i)
        all += text;
    return all;
}

std::vector<Sample> samples() {
    using enum TextKind;
    return {
        // Programs
        {"Fanuc", "%\nO0001 (PART)\nG21 G90\nT1 M6\nG0 X0 Y0\nM30\n%\n", Program},
        {"a colon for O", ":1234\nG0X0Y0\nM30\n", Program},
        {"Haas with CRLF", "%\r\nO01000\r\nN10G0G90X0.Y0.\r\nN20G81Z-1.R2.F100.\r\nM30\r\n%\r\n",
         Program},
        {"CR alone", "G21\rG0 X1\rM30\r", Program},
        {"lower case", "g21 g90\ng1 x10 f100\nm2\n", Program},
        {"LinuxCNC",
         "o<probe> sub\n#<_z> = [#1 * 2]\no1 if [#2 GT 0]\nG38.2 Z-10 F50\no1 endif\n"
         "o<probe> endsub\nM2\n",
         Program},
        {"Macro B", "O9010\nIF[#26EQ#0]GOTO100\nWHILE[#1LT10]DO1\n#1=#1+1\nG1X#1\nEND1\nN100M99\n",
         Program},
        {"O-words only", "o1 if [#<_a> GT 1]\no<move> call [1]\no1 endif\n", Program},
        {"polar, expressions", "G1 X[#1+SIN[30]] Y-[#2/3] F[100]\nG0 @10 ^30\nM2\n", Program},
        {"tabs between words", "N10\tG0\tX1\tY2\tZ3\nN20\tM30\n", Program},
        {"one line", "G0 X1 Y2", Program},
        {"one code", "M30", Program},
        {"packed", "N1G90G80G40N2T1M6N3G0X0Y0S1000M3\n", Program},
        {"remarks only at the head",
         "(PART: bracket, 3 mm, Rev. B)\n(Tool 1: end mill)\n; by hand\n"
         "G0 X0\nM30\n",
         Program},
        {"grbl", "$H\nG21\nG0X0Y0\nM3 S1000\n", Program},
        {"Marlin", "M104 S200\nG28\nG1 X10 E0.5 F1200\n", Program},
        {"Klartext",
         "0 BEGIN PGM TEIL MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 TOOL CALL 5 Z S2000\n"
         "3 L X+10 Y+5 R0 FMAX\n4 CC X+0 Y+0\n5 C X+10 Y+0 DR-\n6 END PGM TEIL MM\n",
         Program},
        {"Heidenhain DIN/ISO",
         "%TEIL G71 *\nN10 G30 G17 X+0 Y+0 Z-40*\nN20 T1 G17 S3500*\n"
         "N30 G00 G40 G90 Z+250*\nN99999999 %TEIL G71 *\n",
         Program},
        {"SINUMERIK",
         "%_N_TEIL_MPF\n;$PATH=/_N_WKS_DIR\nN10 G54 G90\nT=\"FRAESER_10\"\nM6\nR1=5\n"
         "G1 X=AC(20) Y=R1 CR=5\nCYCLE83(5,0,1,-20)\nM30\n",
         Program},
        {"Okuma", "$PART.MIN%\nO1\nG15 H1\nG0 X0 Y0\nG56 HA\nVC1=10\nM02\n%\n", Program},
        {"Excellon", "M48\nMETRIC,TZ\nT1C0.8\n%\nG05\nT1\nX1000Y2000\nM30\n", Program},
        {"a leader of tape", std::string(40, '\0') + "%\nO1\nG0X0\nM30\n%\n", Program},
        {"DC control codes", "\x12%\nO1\nG0X0\nM30\n%\x14\n", Program},
        {"a byte order mark", "\xEF\xBB\xBFG21\nG0 X0\nM30\n", Program},
        {"Latin-1", "(Fr\xE4ser \xD8 10)\nG0 X0\nM30\n", Program},
        {"text behind the end", "G0 X0\nG1 Z-1 F100\nM30\n%\nsent by DNC at noon\n", Program},
        {"many blocks", repeated("N100 G1 X12.345 Y-6.7 F500\n", 5000), Program},
        // No programs
        {"nothing", "", Empty},
        {"blank lines", "\n\n  \n", Text},
        {"a picture", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), Binary},
        {"an archive", std::string("PK\x03\x04\x14\0\0\0\x08\0", 10), Binary},
        {"an object file",
         std::string("\x7f"
                     "ELF\x02\x01\x01\0\0\0\0",
                     11),
         Binary},
        {"UTF-16",
         std::string("\xff\xfeG\0"
                     "0\0 \0X\0",
                     10),
         Binary},
        {"zeros", std::string(100, '\0'), Binary},
        {"a C header", "#ifndef G1_H\n#define G1_H\n#define M3 5\nint G0(int X10);\n#endif\n",
         Source},
        {"C++", "#include <vector>\nint main() { return 0; }\n", Source},
        {"C without #", "/* pins */\nstatic const int X1 = 5;\nvoid stop(void);\n", Text},
        {"Python", "import sys\n\nprint(\"G0 X10\")\nG1 = 5\n", Source},
        {"Python that writes G-code", "def post():\n    out('G0 X0')\n    out('M30')\n", Source},
        {"a shell script", "#!/bin/sh\nncsim check G1.nc\n", Script},
        {"a script with a program in it", "#!/bin/sh\ncat <<END\nG0 X0\nG1 X1 F100\nM30\nEND\n",
         Script},
        {"Markdown", "# Parts\n\nRun G54 first.\n\n- M30 ends it\n", Markup},
        {"Markdown that is mostly a program", "Example:\n```\nG0 X0\nG1 X1 F1\nM30\n```\n", Markup},
        {"HTML", "<html><body>G0 X0</body></html>\n", Markup},
        {"XML", "<?xml version=\"1.0\"?>\n<a>G0 X1</a>\n", Markup},
        {"JSON", "{\"version\": 1,\n \"G0\": \"X10\"}\n", Data},
        {"Gerber", "%FSLAX24Y24*%\n%MOMM*%\nG04 pad*\nX100Y200D01*\nM02*\n", Data},
        {"a difference", "--- a/part.nc\n+++ b/part.nc\n@@ -1,3 +1,3 @@\n G0 X0\n-G1 X1\n+G1 X2\n",
         Data},
        {"CSV", "tool,diameter,length\n1,10.0,50\n2,6.0,40\n", Table},
        {"CSV with words", "T1,10.0,flat\nT2,6.0,ball\nT3,3.0,drill\n", Table},
        {"CSV with codes in it", "1,\"G0 X10\",ok\n2,\"M30\",ok\n", Table},
        {"a table of tabs", "1\t10.0\t50\n2\t6.0\t40\n", Table},
        {"LinuxCNC tools", "T1 P1 D6.000 Z+0.511 ;end mill\nT2 P2 D3.2 Z0.1 ;drill\n", Table},
        {"LinuxCNC parameters", "5161\t0.000000\n5162\t0.000000\n5220\t1.000000\n", Table},
        {"points", "1.0, 2.0, 3.0\n4.0, 5.0, 6.0\n", Table},
        {"points with blanks", "1.0 2.0 3.0\n4.0 5.0 6.0\n", Text},
        {"ASCII STL", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n",
         Text},
        {"OBJ", "v 1.0 2.0 3.0\nv 4.0 5.0 6.0\nf 1 2 3\n", Text},
        {"INI", "[EMC]\nMACHINE = mill\n[AXIS_X]\nMIN_LIMIT = -10\n", Settings},
        {"TOML", "version = 1\nmachine = \"mill.toml\"\n[travel]\nx = [0, 100]\n", Settings},
        {"TOML of codes", "version = 1\n[offsets]\nG54 = [0, 0, 0]\nG55 = [1, 0, 0]\n", Settings},
        {"TOML of tables", "[[tool]]\nnumber = 1\nx = [0, 100]\n", Settings},
        {"HAL", "loadrt trivkins\nnet xpos joint.0.motor-pos-cmd => stepgen.0.position-cmd\n",
         Text},
        {"settings of grbl", "$0=10\n$1=25\n$100=250.000\n", Settings},
        {"prose", "The part is clamped in G54, at X0 Y0.\nUse T1, then T2.\nThen press M30.\n",
         Text},
        {"a list of tools", "T1  D=10. CR=0. - ZMIN=-2. - flat end mill\nT2  D=3. - drill\n", Text},
        {"a Makefile", "all:\n\tncsim check .\nclean:\n\trm -f report.json\n", Text},
        {"HPGL", "IN;SP1;PU0,0;PD100,200;\n", Table},
        {"APT", "PARTNO BRACKET\nFEDRAT/100\nGOTO/10,20,30\nFINI\n", Text},
        {"Intel HEX", ":10010000214601360121470136007EFE09D2190140\n:00000001FF\n", Text},
        {"a key", "-----BEGIN KEY-----\nMIIEvQIBADANBgkqhkiG9w0BAQEFAASC\n-----END KEY-----\n",
         Text},
        {"YAML", "version: 2\njobs:\n  build: G1\n", Text},
        {"PostScript", "%!PS\n10 20 moveto\n30 40 lineto stroke\n", Text},
        {"remarks only", "(nothing)\n; to see\n", Text},
        {"a minified script", "var e=f;function t(){return e}t();", Text},
    };
}

TEST(ProgramText, IsKnownByWhatItSays) {
    ASSERT_GE(samples().size(), 60U);
    for (const Sample& sample : samples()) {
        if (sample.kind == TextKind::Program) {
            EXPECT_EQ(kind_of_text(sample.text), TextKind::Program) << sample.what;
        } else {
            EXPECT_NE(kind_of_text(sample.text), TextKind::Program) << sample.what;
            EXPECT_EQ(kind_of_text(sample.text), sample.kind) << sample.what;
        }
    }
}

TEST(ProgramText, DoesNotDependOnTheEndsOfLines) {
    for (const Sample& sample : samples()) {
        if (sample.kind == TextKind::Binary) continue;
        std::string crlf;
        for (const char c : sample.text)
            crlf += c == '\n' ? "\r\n" : std::string(1, c);
        EXPECT_EQ(kind_of_text(crlf) == TextKind::Program, sample.kind == TextKind::Program)
            << sample.what;
    }
}

// Only the beginning decides, for any length of the rest.
TEST(ProgramText, IsDecidedByTheHead) {
    const std::string program = repeated("N100 G1 X12.345 Y-6.7 F500\n", 5000);
    ASSERT_GT(program.size(), kMostHeadBytes);
    EXPECT_EQ(kind_of_text(program + repeated("prose about parts\n", 10000)), TextKind::Program);
    EXPECT_EQ(kind_of_text(std::string_view(program).substr(0, kMostHeadBytes + 1)),
              TextKind::Program);
    EXPECT_EQ(kind_of_text(repeated("prose about parts\n", 10000) + program), TextKind::Text);
}

// Any bytes give a result.
TEST(ProgramText, TakesAnyBytes) {
    unsigned state = 1;
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        for (int n = 0; n < i % 97; ++n) {
            state = state * 1664525U + 1013904223U;
            const unsigned byte = state >> 24;
            text += static_cast<char>(i % 2 == 0 ? byte : 32 + byte % 95);
        }
        (void)kind_of_text(text);
        (void)is_subprogram_text(text, {});
    }
}

TEST(ProgramText, NamesOfProgramsAreInAnyCase) {
    for (const char* name :
         {"a.nc", "a.NC", "b.Ngc", "c.MPF", "d.spf", "e.EIA", "f.gcode", "x.y.tap"})
        EXPECT_TRUE(names_program(name)) << name;
    for (const char* name : {"nc", ".nc", "O0001", "a.txt", "a.h", "a.min", "a.nc.bak", "a.n"})
        EXPECT_FALSE(names_program(name)) << name;
}

TEST(SubprogramText, ReturnsOrHasNothingButSubroutines) {
    EXPECT_TRUE(is_subprogram_text("O100\nG1 X1\nM99\n", {}));
    EXPECT_TRUE(is_subprogram_text("%\nO100 (P)\nG1 X1\nM99\n%\n", {}));
    EXPECT_TRUE(is_subprogram_text("o<a> sub\nG1 X1\no<a> endsub\n", {}));
    EXPECT_TRUE(is_subprogram_text("(lib)\no<a> sub\nG1 X1\no<a> endsub\nM2\n", {}));
    EXPECT_TRUE(is_subprogram_text("O1\nG1 X1\n", "G1 X2\nM99\n"));
    EXPECT_FALSE(is_subprogram_text("G1 X1\nM30\n", {}));
    EXPECT_FALSE(is_subprogram_text("G1 X1\n", {}));
    EXPECT_FALSE(is_subprogram_text("M98 P2\nM30\nO2\nG1 X1\nM99\n", {}));
    EXPECT_FALSE(is_subprogram_text("o<a> sub\nG1 X1\no<a> endsub\no<a> call\nM2\n", {}));
    EXPECT_FALSE(is_subprogram_text("o<a> sub\nG1 X1\no<a> endsub\nG0 X1\nM2\n", {}));
    EXPECT_FALSE(is_subprogram_text("", {}));
}

}  // namespace
}  // namespace ncsim::gcode
