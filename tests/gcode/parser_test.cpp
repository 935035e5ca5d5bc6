// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parsing of lines: text as input, canonical text as output.
#include "ncsim/gcode/parser.h"

#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ncsim::gcode {
namespace {

/// Returns the lines of `text` as blocks, separated by "; ", each followed by the codes of its
/// diagnostics.
std::string read(const std::string& text, ParserOptions options = {}) {
    const SourceFile file{"test.nc", text};
    BlockReader reader(file, options);
    Block block;
    DiagnosticLog log;
    std::string out;
    while (reader.next(block, log)) {
        if (!out.empty()) out += "\n";
        print(out, block);
    }
    for (const Diagnostic& d : log.diagnostics())
        out += " [" + d.code + "]";
    return out;
}

struct Case {
    const char* text;
    const char* expected;
};

TEST(Parser, ReadsWordsInOneFixedSpelling) {
    const Case cases[] = {
        {"G1X10Y-2.5", "G1 X10 Y-2.5"},
        {"g01 x10. y.5 z+3", "G1 X10 Y0.5 Z3"},
        {"G 0 X + 1 2 . 5", "G0 X12.5"},
        {"N10G1X1", "N10 G1 X1"},
        {"n20 (go) g1 (there) x1", "N20 G1 X1 (go) (there)"},
        {"", ""},
        {"   \t ", ""},
        {"%", "%"},
        {"% name", "%"},
        {"/G1X1", "/ G1 X1"},
        {"/2 N5 G1X1", "/ N5 G1 X1"},
        {"N5 /G1X1", "/ N5 G1 X1"},
        {"/1/3 N5 / G1X1", "/ N5 G1 X1"},
        {"/2#1=3", "/ #1=3"},
        {"/2(text)", "/ (text)"},
        {"N5 G1 X1 /2 M8 / F3 (a)", "N5 G1 X1 / M8 F3 (a)"},
        {"X[6/2] Y#1/2.5 /M8", "X[6/2] Y#1/2.5 / M8"},
        {"X#1 /2 M8", "X#1 / M8"},
        {"X#1/2 M8", "X#1/2 M8 [slash-after-value]"},
        {"X#1/#2 Y#1/12", "X#1/#2 Y#1/12"},
        {"#1=#2 /M8", "#1=#2 / M8"},
        {"#1=#2/sin[#3]", "#1=#2/sin[#3]"},
        {"#1=#2/2", "#1=#2/2"},
        {"G1 X1 ; to the right", "G1 X1 ; to the right"},
        {"(T1 D=6.) M6 T1", "M6 T1 (T1 D=6.)"},
        {"X[#1+2] Y-#3 Z#<depth>", "X[#1+2] Y-#3 Z#<depth>"},
        {"X sin [ 30 ] Y -[1+2]", "Xsin[30] Y-[1+2]"},
        {"Xatan[1]/[2]", "Xatan[1]/[2]"},
        {"#1 = 2 #<Depth Of Cut>=[#1*2]", "#1=2 #<depthofcut>=[#1*2]"},
        {"G1 X1,R2", "G1 X1 ,R2"},
        {"X1 e-3", "X1 E-3"},
        {"M67e2q3", "M67 E2 Q3"},
        {"G65P3F600E41", "G65 P3 F600 E41"},
        {"O100 sub", "O100 sub"},
        {"o<Name> call [1] [#2]", "O<name> call [1][#2]"},
        {"o100 while [#1 LT 3]", "O100 while [#1lt3]"},
        {"O1234 (PART)", "O1234 program (PART)"},
        {":0007", "O0007 program"},
        {"IF[#1LT3]GOTO10", "if [#1lt3] -> 10"},
        {"IF [#1 EQ #0] THEN #2=3", "if [#1eq#0] #2=3"},
        {"WHILE[#1LE10]DO1", "while [#1le10] -> 1"},
        {"END1", "end -> 1"},
        {"GOTO[#1+5]", "goto -> [#1+5]"},
        {"#1=#2+3*#4", "#1=#2+3*#4"},
        {"X1\r\nX2\rX3\nX4", "X1\nX2\nX3\nX4"},
        {"\xEF\xBB\xBFG21", "G21"},
        {"X12345678901234567890", "X1.2345678901234567e+19"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.text);
        EXPECT_EQ(read(c.text), c.expected);
    }
}

TEST(Parser, SaysWhatItCannotReadAndGoesOn) {
    const Case cases[] = {
        {"G1 X Y2\nX3", "unreadable\nX3 [number-expected]"},
        {"X.", "unreadable [number-expected]"},
        {"12", "unreadable [letter-expected]"},
        {"X1 \xC3\xA4", "unreadable [letter-expected]"},
        {"X[1", "unreadable [bracket-unclosed]"},
        {"#<a=1", "unreadable [name-unclosed]"},
        {"#1 X2", "unreadable [assignment-expected]"},
        {"X1 N5", "unreadable [line-number-not-first]"},
        {"o100 wile [1]", "unreadable [o-word-unknown]"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.text);
        EXPECT_EQ(read(c.text), c.expected);
    }
}

TEST(Parser, ToleratesWhatOtherControlsWrite) {
    const Case cases[] = {
        {"(a (b) c) X1", "X1 (a (b) c) [comment-nested]"},
        {"(a (b) X1", "X1 (a (b) [comment-nested]"},
        {"X1 (open", "X1 (open) [comment-unclosed]"},
        {"X1) Y2", "X1 Y2 [comment-unopened]"},
        {"X1*23", "X1 [checksum-ignored]"},
        {"$H", "command [console-command]"},
        {"$X", "command [console-text]"},
        {"$$", "command [console-text]"},
        {"?", "command [console-text]"},
        {"$X=1", "command [console-command]"},
        {"$C", "command [console-command]"},
        {"$10=1", "command [console-command]"},
        {"<PART-1> (HOUSING)", "O<part-1> program (HOUSING)"},
        {"M98 <Sub-1.NC> L2", "M98 L2 <Sub-1.NC>"},
        {"<PART> G1", "command [console-command]"},
        {"DPRNT[X#1]", "command [console-text]"},
        {"X1e-3", "unreadable [exponent]"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.text);
        EXPECT_EQ(read(c.text), c.expected);
        EXPECT_TRUE(read(c.text, {.strict = true}).starts_with("unreadable"));
    }
}

TEST(Parser, KeepsThePlaceOfEachWordAndComment) {
    const SourceFile file{"t.nc", "N1  G1 X 1 2 (go) Y-3.5\n"};
    BlockReader reader(file);
    Block block;
    ASSERT_TRUE(reader.next(block));
    ASSERT_EQ(block.words.size(), 3U);
    EXPECT_EQ(block.words[0].span, (SourceSpan{1, 5, 2}));
    EXPECT_EQ(block.words[1].span, (SourceSpan{1, 8, 5}));
    EXPECT_EQ(block.words[2].span, (SourceSpan{1, 19, 5}));
    ASSERT_EQ(block.comments.size(), 1U);
    EXPECT_EQ(block.comments[0].span, (SourceSpan{1, 14, 4}));
    EXPECT_FALSE(reader.next(block));
}

TEST(Parser, CanGoBackToAPlace) {
    const SourceFile file{"t.nc", "X1\nX2\nX3\n"};
    BlockReader reader(file);
    Block block;
    reader.next(block);
    const BlockReader::Place second = reader.place();
    reader.next(block);
    reader.next(block);
    reader.seek(second);
    ASSERT_TRUE(reader.next(block));
    EXPECT_EQ(block.line, 2U);
    EXPECT_EQ(block.words[0].number, 2.0);
}

// A repeated line of a loop is parsed to the same block with the same diagnostics, also if there
// are more lines than the cache holds.
TEST(Parser, ReadsLinesThatItKeepsAsBefore) {
    std::string text =
        "%\n\nG1 X1 (plain)\nX[#1+2] (x)\n#1=[#1+1]\n(a (b) c) X#2\nX[1\no1 while [#1 lt 3]\n"
        "#2\n/N5 G1 X#1 ; y\nX1 2.5\n$H\nX1 ]\n[a line of WinCNC]\n" +
        std::string(3000, ' ') + "Y[1]\n";
    for (std::size_t i = 0; i < BlockReader::kMostKept + 10; ++i)
        text += "X#" + std::to_string(i) + "\n";
    const SourceFile file{"t.nc", text};
    BlockReader reader(file);
    BlockReader keeper(file);
    const BlockReader::Place start = reader.place();
    keeper.keep_lines();
    DiagnosticLog log;
    DiagnosticLog of_keeper;
    for (int turn = 0; turn < 3; ++turn) {
        reader.seek(start);
        keeper.seek(start);
        Block block;
        Block kept;
        while (reader.next(block, log)) {
            ASSERT_TRUE(keeper.next(kept, of_keeper));
            std::string expected;
            std::string out;
            print(expected, block);
            print(out, kept);
            ASSERT_EQ(out, expected);
            ASSERT_EQ(kept.line, block.line);
            ASSERT_EQ(kept.text, block.text);
            ASSERT_EQ(kept.kind, block.kind);
            ASSERT_EQ(keeper.place(), reader.place());
            ASSERT_TRUE(std::ranges::equal(kept.words, block.words, {}, &Word::span, &Word::span));
        }
        EXPECT_FALSE(keeper.next(kept, of_keeper));
    }
    EXPECT_EQ(of_keeper.diagnostics(), log.diagnostics());
    ASSERT_FALSE(log.diagnostics().empty());
    EXPECT_GE(log.diagnostics().front().count, 3U);
}

TEST(Diagnostic, IsRenderedWithItsLineAndACaret) {
    const SourceFile file{"pocket.nc", "G1\nG1 X Y2\n"};
    BlockReader reader(file);
    Block block;
    DiagnosticLog log;
    while (reader.next(block, log)) {
    }
    ASSERT_EQ(log.diagnostics().size(), 1U);
    EXPECT_EQ(render(log.diagnostics()[0], file),
              "pocket.nc:2:4: error: expected a number after X [number-expected]\n"
              "  | G1 X Y2\n"
              "  |    ^\n");
}

TEST(Diagnostic, BeginsNoLineWithWhatACiServiceObeys) {
    const SourceFile file{"::add-mask::x.nc", "::stop-commands::pause\n##[error]X\n"};
    BlockReader reader(file);
    Block block;
    DiagnosticLog log;
    while (reader.next(block, log)) {
    }
    ASSERT_GE(log.diagnostics().size(), 2U);
    for (const Diagnostic& d : log.diagnostics()) {
        const std::string text = render(d, file);
        EXPECT_TRUE(text.starts_with("./::add-mask::x.nc:")) << text;
        EXPECT_EQ(text.find("\n:"), std::string::npos) << text;
        EXPECT_EQ(text.find("\n#"), std::string::npos) << text;
    }
}

TEST(Diagnostic, ThatSaysTheSameIsToldOnceWithACount) {
    const SourceFile file{"t.nc", "X\nX\nY\nX\n"};
    BlockReader reader(file);
    Block block;
    DiagnosticLog log;
    while (reader.next(block, log)) {
    }
    ASSERT_EQ(log.diagnostics().size(), 2U);
    EXPECT_EQ(log.diagnostics()[0].count, 3U);
    EXPECT_EQ(log.diagnostics()[1].count, 1U);
    EXPECT_EQ(log.errors(), 4U);
}

}  // namespace
}  // namespace ncsim::gcode
