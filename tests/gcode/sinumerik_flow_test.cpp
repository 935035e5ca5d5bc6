// SPDX-License-Identifier: GPL-3.0-or-later
//
// Variables, jumps, loops, repeats and subprograms of SINUMERIK.
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::gcode::sinumerik_test {
namespace {

/// Evaluates `expression`, which is assigned to R1, by a move to X=R1.
double value_of(const std::string& expression) {
    const Made r = run(sinumerik("R1=" + expression + "\nG1 X=R1 F100"));
    EXPECT_EQ(r.errors(), "") << expression;
    return r.end().x.mm();
}

// --- Expressions ---

TEST(SinumerikFlow, Operators) {
    EXPECT_DOUBLE_EQ(value_of("2+3*4-6/2"), 11.0);
    EXPECT_DOUBLE_EQ(value_of("7 DIV 2+7 MOD 4"), 6.0);
    EXPECT_DOUBLE_EQ(value_of("-(2+3)*-2"), 10.0);
    EXPECT_DOUBLE_EQ(value_of("(1==1)+(2<>2)+(3>=3)"), 2.0);
    EXPECT_DOUBLE_EQ(value_of("(1<2) AND (2<3)"), 1.0);
    EXPECT_DOUBLE_EQ(value_of("TRUE XOR FALSE OR NOT TRUE"), 1.0);
    EXPECT_DOUBLE_EQ(value_of("6 B_AND 3"), 2.0);
    EXPECT_DOUBLE_EQ(value_of("6 B_OR 1"), 7.0);
    EXPECT_DOUBLE_EQ(value_of("'H1F'+'B101'"), 36.0);
    EXPECT_DOUBLE_EQ(value_of("1.5EX2"), 150.0);
}

TEST(SinumerikFlow, Functions) {
    EXPECT_DOUBLE_EQ(value_of("SIN(30)+COS(60)"), 1.0);
    EXPECT_DOUBLE_EQ(value_of("ATAN2(30,30)"), 45.0);
    EXPECT_DOUBLE_EQ(value_of("SQRT(POT(3)+16)"), 5.0);
    EXPECT_DOUBLE_EQ(value_of("ABS(-2.5)+TRUNC(2.9)+ROUND(2.5)"), 7.5);
    EXPECT_DOUBLE_EQ(value_of("MINVAL(2,3)+MAXVAL(2,3)+BOUND(0,10,12)"), 15.0);
}

TEST(SinumerikFlow, ComparisonsBindLessThanLogic) {
    expect_refused("IF 1==1 AND 2==2 GOTOF E",
                   "5:14: AND and OR bind more strongly than comparisons; put brackets around each "
                   "comparison; the program is stopped here [comparison-brackets]");
}

TEST(SinumerikFlow, FaultsOfExpressions) {
    expect_refused("R1=1/0", "5:5: division by zero [division-by-zero]");
    expect_refused("R1=SQRT(-1)", "5:4: SQRT of this value does not exist [function-range]");
    expect_refused("R1=FOO",
                   "5:4: there is no variable FOO; the program is stopped here [variable-missing]");
    expect_refused("FOO=1",
                   "5:1: there is no variable FOO; the program is stopped here [variable-missing]");
    expect_refused("R1=\"A\"",
                   "5:1: this needs a number; the program is stopped here [value-type]");
}

TEST(SinumerikFlow, ParametersWithoutValueAreReported) {
    const Made r = run(sinumerik("G1 X=R7 F100"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("variable-unknown"));
    EXPECT_FALSE(run(sinumerik("R7=1\nG1 X=R7 F100")).says("variable-unknown"));
}

TEST(SinumerikFlow, DefinedVariables) {
    expect_same(
        "DEF REAL A=1.5, B\nDEF INT N[3]\nDEF BOOL F=TRUE\nDEF STRING[20] T=\"X\"\n"
        "N[1]=2.6 B=A*2\nR1=N[1]\nG1 X=A Y=B Z=R1 F100",
        "G1 X1.5 Y3. Z3. F100");
    expect_refused("DEF AXIS A",
                   "5:1: DEF AXIS is not read; the program is stopped here [not-read]");
    expect_refused("DEF FRAME A",
                   "5:1: DEF FRAME is not read; the program is stopped here [not-read]");
    expect_refused(
        "DEF REAL A[2]\nA[2]=1",
        "6:1: this index is not in the array; the program is stopped here [parameter-range]");
}

TEST(SinumerikFlow, TextsShowNumbersInShortestForm) {
    expect_same("DEF STRING[20] T\nR1=2.50\nT=\"P\"<<R1\nIF T==\"P2.5\"\nG1 X1 F100\nENDIF",
                "G1 X1. F100");
}

// --- Jumps ---

TEST(SinumerikFlow, VariablesWithTheNameOfAWord) {
    expect_equal("DEF REAL A1[3], X2=4\nA1[2]=5\nX2=X2+1\nG1 X=A1[2] Y=X2 F100", "G1 X5 Y5 F100");
}

TEST(SinumerikFlow, VariablesOfCharacters) {
    expect_equal("DEF CHAR C=65\nDEF BOOL B=1\nG1 X=C Y=B F100", "G1 X65 Y1 F100");
}

TEST(SinumerikFlow, JumpsForwardAndBackward) {
    expect_same(
        "GOTOF A\nG1 X9 F100\nA: R1=0\nB: R1=R1+1\nG1 X=R1 F100\nIF R1<3 GOTOB B\nGOTO "
        "N50\nX8\nN50 Y1",
        "G1 X1. F100\nX2.\nX3.\nY1.");
}

TEST(SinumerikFlow, LabelsMayRepeatAndTheNearestCounts) {
    expect_same("A: G1 X1 F100\nGOTOF A\nX9\nA: X2\nGOTOF B\nA: X8\nB: Y1",
                "G1 X1. F100\nX2.\nY1.");
}

TEST(SinumerikFlow, MissingLabels) {
    expect_same("IF 1==2 GOTOF NOWHERE\nGOTOC NOWHERE\nG1 X1 F100", "G1 X1. F100");
    expect_refused(
        "GOTOF A",
        "5:1: there is no label A behind this block; the program is stopped here [label-missing]");
    expect_refused(
        "GOTOB A\nA:",
        "5:1: there is no label A before this block; the program is stopped here [label-missing]");
}

TEST(SinumerikFlow, SeveralBranchesInABlock) {
    expect_same("R1=2\nIF R1==1 GOTOF A IF R1==2 GOTOF B\nG1 X9 F9\nA: G1 X8 F9\nB: G1 X1 F100",
                "G1 X1. F100");
}

TEST(SinumerikFlow, Case) {
    expect_same(
        "R1=2\nCASE R1 OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C\nA: G1 X9 F9\nB: G1 X1 F100\n"
        "CASE(R1+5) OF 1 GOTOF A DEFAULT GOTOF D\nC: X7\nD: Y1",
        "G1 X1. F100\nY1.");
}

// --- Structures ---

TEST(SinumerikFlow, IfElse) {
    expect_same(
        "FOR R1=1 TO 3\nIF R1==2\nG1 X1 F100\nELSE\nIF R1==3\nG1 X3 F100\nELSE\nG1 X2 "
        "F100\nENDIF\nENDIF\nENDFOR",
        "G1 X2. F100\nX1.\nX3.");
}

TEST(SinumerikFlow, Loops) {
    expect_same(
        "R1=0\nWHILE R1<2\nR1=R1+1\nG1 X=R1 F100\nENDWHILE\nREPEAT\nR1=R1-1\nX=R1\nUNTIL R1<=0\n"
        "LOOP\nR1=R1+5\nY=R1\nIF R1>9 GOTOF OUT\nENDLOOP\nOUT: Z1",
        "G1 X1. F100\nX2.\nX1.\nX0.\nY5.\nY10.\nZ1.");
}

TEST(SinumerikFlow, NestedLoopsAndAnEmptyFor) {
    expect_same(
        "DEF INT I, J\nFOR I=5 TO 4\nG1 X99 F1\nENDFOR\nFOR I=1 TO 2\nFOR J=1 TO 2\nG1 X=I*10+J "
        "F100\nENDFOR\nENDFOR",
        "G1 X11. F100\nX12.\nX21.\nX22.");
}

TEST(SinumerikFlow, StructuresWithoutAnEnd) {
    expect_refused("IF 1==2\nG1 X1",
                   "5:1: IF has no ENDIF; the program is stopped here [block-end-missing]");
    expect_refused(
        "ENDWHILE",
        "5:1: nothing before this block begins what ENDWHILE ends; the program is stopped "
        "here [block-begin-missing]");
}

TEST(SinumerikFlow, EndlessProgramsEndByTheBudget) {
    for (const std::string text :
         {"A: GOTOB A", "LOOP\nR1=1\nENDLOOP", "WHILE TRUE\nENDWHILE", "A: R1=1\nREPEAT A P=999999",
          "FOR R1=1 TO 1EX9\nENDFOR", "REPEAT\nUNTIL FALSE", "A:\nREPEATB A P=999999999",
          "LOOP\nA: R1=1\nREPEAT A P=5\nENDLOOP"}) {
        const Made r = run(sinumerik(text));
        EXPECT_TRUE(r.says("step-limit")) << text << r.errors();
        EXPECT_TRUE(r.result.stopped);
    }
}

// --- REPEAT of labels ---

TEST(SinumerikFlow, RepeatFromALabel) {
    expect_equal("A: G91 G1 X1 F100\nY1\nREPEAT A P=2\nG90 Z1",
                 "G91 G1 X1 F100\nY1\nX1\nY1\nX1\nY1\nG90 Z1");
    expect_equal("A: G91 G1 X1 F100\nREPEAT A", "G91 G1 X1 F100\nX1");
}

TEST(SinumerikFlow, RepeatBetweenLabels) {
    expect_equal("A: G91 G1 X1 F100\nB: Y1\nZ1\nREPEAT A B P=2\nX5",
                 "G91 G1 X1 F100\nY1\nZ1\nX1\nY1\nX1\nY1\nX5");
    expect_equal("A: G91 G1 X1 F100\nY1\nENDLABEL: Z1\nX2\nREPEAT A",
                 "G91 G1 X1 F100\nY1\nZ1\nX2\nX1\nY1\nZ1");
}

TEST(SinumerikFlow, RepeatOfABlock) {
    expect_equal("G91\nA: G1 X1 F100\nY1\nREPEATB A P=3\nZ1",
                 "G91\nG1 X1 F100\nY1\nX1\nX1\nX1\nZ1");
    expect_refused("REPEAT A",
                   "5:1: there is no label A; the program is stopped here [label-missing]");
}

// --- Subprograms ---

TEST(SinumerikFlow, SubprogramPastedIsTheSame) {
    const Files files{{"L6.spf", "G1 X5 F100\nY5\nM17\n"}};
    expect_equal("L6\nX0\nL6 P2\nZ1", "G1 X5 F100\nY5\nX0\nG1 X5 F100\nY5\nG1 X5 F100\nY5\nZ1",
                 files);
}

TEST(SinumerikFlow, LeadingZerosBelongToTheName) {
    const Files files{{"L6.SPF", "G1 X5 F100\n"}, {"L006.SPF", "G1 Y5 F100\nRET\n"}};
    expect_equal("L006\nL6", "G1 Y5 F100\nX5", files);
}

TEST(SinumerikFlow, Parameters) {
    const Files files{{"CUT.SPF",
                       "PROC CUT(REAL A, VAR INT B, REAL C=7, STRING[5] T) SAVE DISPLOF\nG91 G1 "
                       "X=A Y=B Z=C F100\nB=B+1\nRET\n"}};
    expect_equal(
        "EXTERN CUT(REAL, VAR INT, REAL, STRING)\nDEF INT N=2\nCUT(1,N)\nCUT(,N,1,\"A\")\nG1 X=N",
        "G1 F100 X1 Y2 Z57\nY5 Z58\nX4", files);
    const Made r = run(sinumerik("CUT(1,2,3,\"A\",5)"), files);
    EXPECT_TRUE(r.says("call-arguments"));
}

TEST(SinumerikFlow, VariablesOfAProgramAreItsOwn) {
    const Files files{{"CUT.SPF", "DEF REAL A=9\nR1=A\nM17\n"}};
    expect_equal("DEF REAL A=1\nCUT\nG1 X=A Y=R1 F100", "G1 X1 Y9 F100", files);
}

TEST(SinumerikFlow, MainProgramsEndTheSubprogramOnly) {
    const Files files{{"PART.MPF", "G1 X5 F100\nM30\n"}};
    expect_equal("PART\nG1 Y5", "G1 X5 F100\nY5", files);
}

TEST(SinumerikFlow, CallsByName) {
    const Files files{{"CUT.SPF", "G1 X5 F100\n"},
                      {"POCKET_A.SPF", "PROC POCKET_A(REAL A)\nG1 X=A F100\n"}};
    expect_equal(
        "DEF STRING[10] T=\"CUT\"\nCALL T\nCALL \"/_N_CUS_DIR/_N_CUT_SPF\"\nEXTCALL "
        "\"CUT\"\nEXTCALL(\"CUT\")\nG1 Y1",
        "G1 X5 F100\nG1 X5\nG1 X5\nG1 X5\nY1", files);
    expect_equal("PCALL /_N_WKS_DIR/_N_PART_WPD/POCKET_A(3)", "G1 X3 F100", files);
}

TEST(SinumerikFlow, ProgramsOfAnArchive) {
    const Made r =
        run("%_N_CUT_SPF\n;$PATH=/_N_SPF_DIR\nG1 X5 F100\nM17\n%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\n"
            "G710 G90\nT1 M6\nG0 X0 Y0 Z0\nCUT\nG1 Y3\nM30\n");
    expect_end(r, 5, 3, 0);
}

TEST(SinumerikFlow, MissingProgramIsLeftOutWithADoubt) {
    // M202: a macro of the machine builder. "R1=5 L77": the assignment acts.
    for (const char* call :
         {"L77", "L77 P3", "R1=5 L77", "CLAMP_PART", "CLAMP_PART(1,\"A\")", "M202(0.002)",
          "CALL \"L77\"", "PCALL /_N_CUS_DIR/L77(3)", "EXTCALL \"L77\"", "MCALL L77"}) {
        const Made r = run(sinumerik("R1=5\nG1 X1 F100\n" + std::string(call) + "\nY=R1"));
        expect_end(r, 1, 5, 50);
        EXPECT_TRUE(r.result.ended) << call;
        ASSERT_EQ(r.says("program-not-found"), true) << call;
        EXPECT_EQ(std::ranges::count(r.result.diagnostics, "program-not-found", &Diagnostic::code),
                  1)
            << call;
    }
}

TEST(SinumerikFlow, FoldersOfACalledProgramAreNotLookedAt) {
    const Files files{{"../L9.SPF", "G1 X9 F100\n"}, {"/etc/L9.SPF", "G1 X9 F100\n"}};
    for (const char* call : {"EXTCALL(\"../L9\")", "CALL \"/etc/L9\"", "PCALL ../L9",
                             "CYCLE72(\"../L9\",20,0,2,-4,0,0,0,300,100,2,41,1,8)"}) {
        const Made r = run(sinumerik("G1 X1 F100\n" + std::string(call)), files);
        expect_end(r, 1, 0, 50);
        EXPECT_TRUE(r.says("program-not-found")) << call;
    }
}

TEST(SinumerikFlow, MissingModalProgramEndsTheLastModalCall) {
    const Made r = run(sinumerik("F100\nMCALL CYCLE81(50,0,2,-5)\nX1\nMCALL L77\nX2\nMCALL"));
    expect_end(r, 2, 0, 50);
    EXPECT_EQ(r.texts, run(sinumerik("F100\nMCALL CYCLE81(50,0,2,-5)\nX1\nMCALL\nX2")).texts);
}

TEST(SinumerikFlow, MissingProgramIsRefusedIfItIsACycleOfTheControl) {
    expect_refused("CYCLE95(\"A\",1)",
                   "5:1: CYCLE95 is not read; the program is stopped here [not-read]");
}

TEST(SinumerikFlow, EndlessRecursionEnds) {
    const Files files{{"CUT.SPF", "CUT\n"}};
    EXPECT_TRUE(run(sinumerik("CUT"), files).says("call-depth"));
}

TEST(SinumerikFlow, ASubprogramAloneReportsItsParameters) {
    const Made r = run("PROC CUT(REAL A)\nG710 G90 G0 X0 Y0 Z0\nG1 X=A F100\nM17\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("variable-unknown"));
    EXPECT_TRUE(r.result.ended);
}

TEST(SinumerikFlow, ModalSubprogram) {
    const Files files{{"CUT.SPF", "PROC CUT(REAL A)\nG1 Z=A F100\nG0 Z5\nM17\n"}};
    expect_equal("G0 Z5\nMCALL CUT(-2)\nX10\nF200\nY10\nMCALL\nX0",
                 "G0 Z5\nX10\nG1 Z-2 F100\nG0 Z5\nY10\nG1 Z-2 F100\nG0 Z5\nX0", files);
    expect_equal("G0 Z5\nMCALL CUT(-2)\nHOLES1(0,0,0,10,20,2)\nMCALL",
                 "G0 Z5\nX10 Y0\nG1 Z-2 F100\nG0 Z5\nX30 Y0\nG1 Z-2 F100\nG0 Z5", files);
}

}  // namespace
}  // namespace ncsim::gcode::sinumerik_test
