// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two symmetries that each program keeps. In inches with lengths and feeds divided by 25.4, it
// makes the same motions as in mm. In G18 or G19 with its axes exchanged in a cycle (X to Z to Y to
// X), it makes the motions of G17 with their axes exchanged.
#include "gcode/language_made.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

using language_test::Made;

enum class Language { Fanuc, Klartext, Sinumerik };

/// The program is written in mm and G17: `{5}` is a length or a feed, `<5>` a feed of
/// Klartext (in inches: 0.1 inch/min). Small letters x y z i j k are axes to be exchanged.
struct Case {
    Language language;
    const char* blocks;
};

/// Plane 0: G17 with Z as tool axis. 1: G18 with Y. 2: G19 with X.
std::string render(const Case& test, bool inches, std::size_t plane) {
    constexpr std::array<std::array<char, 3>, 3> kAxes{
        {{'X', 'Y', 'Z'}, {'Z', 'X', 'Y'}, {'Y', 'Z', 'X'}}};
    std::string text;
    const std::string blocks = test.blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const char c = blocks[i];
        if (c >= 'x' && c <= 'z') {
            text += kAxes[plane][static_cast<std::size_t>(c - 'x')];
        } else if (c >= 'i' && c <= 'k') {
            text += static_cast<char>(kAxes[plane][static_cast<std::size_t>(c - 'i')] - 'X' + 'I');
        } else if (c == '{' || c == '<') {
            const std::size_t end = blocks.find_first_of("}>", i);
            const double mm = std::stod(blocks.substr(i + 1, end - i - 1));
            const double inch = c == '<' ? 2.54 : 25.4;
            std::array<char, 40> number{};
            std::snprintf(number.data(), number.size(), "%.12f", inches ? mm / inch : mm);
            text += number.data();
            i = end;
        } else {
            text += c;
        }
    }
    const std::string g_plane = std::to_string(17 + plane);
    const char tool_axis = kAxes[plane][2];
    switch (test.language) {
        case Language::Fanuc:
            return "%\nO0001\nG90 G40 G80 G" + g_plane + (inches ? " G20" : " G21") +
                   "\nT1 M6\nS1000 M3\n" + text + "\nM30\n%\n";
        case Language::Klartext:
            return std::string("BEGIN PGM T ") + (inches ? "INCH" : "MM") + "\nTOOL CALL 1 " +
                   tool_axis + " S1000\n" + text + "\nM30\nEND PGM T\n";
        case Language::Sinumerik:
            return std::string(inches ? "G700" : "G710") + " G90 G40 G94 G" + g_plane +
                   "\nT1 M6\nS1000 D1 M3\n" + text + "\nM30\n";
    }
    return {};
}

Made run(const Case& test, bool inches, std::size_t plane) {
    const std::string text = render(test, inches, plane);
    const Dialect dialect = test.language == Language::Fanuc      ? Dialect::Fanuc
                            : test.language == Language::Klartext ? Dialect::Auto
                                                                  : Dialect::Sinumerik;
    return language_test::run(text, {}, dialect, false,
                              test.language == Language::Sinumerik ? "test.mpf" : "test.h", nullptr,
                              inches ? 0.2 / 25.4 : 0.2);
}

bool has_compensation(const Case& test) {
    const std::string text = test.blocks;
    return text.find("G41") != std::string::npos || text.find("G42") != std::string::npos ||
           text.find(" RL") != std::string::npos;
}

std::array<double, 3> place(const Position& p) {
    return {p.x.mm(), p.y.mm(), p.z.mm()};
}

/// Compares with the motions in mm and G17. Inches are rounded to the lattice of positions.
void expect_same(const Made& reference, const Made& made, std::size_t plane) {
    constexpr double kNear = 2e-6;
    EXPECT_EQ(made.errors(), "");
    ASSERT_EQ(made.moves.size(), reference.moves.size());
    EXPECT_EQ(made.texts.size(), reference.texts.size()) << "moves and dwells";
    for (std::size_t n = 0; n < made.moves.size(); ++n) {
        SCOPED_TRACE("move " + std::to_string(n));
        const Motion& a = reference.moves[n];
        const Motion& b = made.moves[n];
        const auto at = place(*end_of(a));
        const auto there = place(*end_of(b));
        for (std::size_t i = 0; i < 3; ++i)
            ASSERT_NEAR(at[i], there[(i + 3 - plane) % 3], kNear) << "axis " << i;
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.feed_mode, b.feed_mode);
        EXPECT_NEAR(a.feed, b.feed, 1e-6 * (1.0 + a.feed));
        EXPECT_EQ(a.spindle, b.spindle);
        EXPECT_EQ(a.spindle_rpm, b.spindle_rpm);
        EXPECT_EQ(a.spindle_oriented, b.spindle_oriented);
        EXPECT_EQ(a.steps_aside, b.steps_aside);
        EXPECT_EQ(a.coolant, b.coolant);
        EXPECT_EQ(a.machine_coordinates, b.machine_coordinates);
        ASSERT_EQ(a.action.index(), b.action.index());
        const Arc* const arc = std::get_if<Arc>(&a.action);
        if (!arc) continue;
        const Arc& other = std::get<Arc>(b.action);
        EXPECT_EQ(arc->turns, other.turns);
        EXPECT_NEAR(arc->centre_1.mm(), other.centre_1.mm(), kNear);
        EXPECT_NEAR(arc->centre_2.mm(), other.centre_2.mm(), kNear);
    }
}

/// Shapes in each plane: arcs, compensation, corners, frames, cycles.
const std::vector<Case> kInEachPlane{
    // Arcs and helices; a full circle; radii of both signs.
    {Language::Fanuc,
     "G0 x{0} y{0} z{50}\nG1 z{-1} F{100}\nG2 x{10} y{10} i{10}\nG3 x{0} y{0} z{-2} R{10}\n"
     "G3 x{10} y{10} R{-10}\nG2 i{4} j{3}\nG91 G3 x{4} y{4} j{4}\nG90"},
    // Corners, lines by two blocks; compensation about lines and arcs, on both sides.
    {Language::Fanuc,
     "G0 x{-20} y{-20} z{5}\nG1 z{-1} F{100}\nG41 D1 x{0} y{0}\ny{30}\nG2 x{15} y{45} R{15}\n"
     "G3 x{35} y{65} R{20}\nG1 x{60}\nG2 x{60} y{0} j{-32.5}\nG1 x{0}\nG40 x{-20} y{-20}"},
    {Language::Fanuc,
     "G0 x{-20} y{0} z{5}\nG1 F{100}\nG42 D1 x{0} y{0}\nG3 x{30} y{20} R{40}\nG2 x{50} y{40} "
     "R{20}\n"
     "G1 x{30} y{60}\nG3 x{10} y{60} R{30}\nG1 x{0} y{80}\nG40 x{-20}"},
    {Language::Fanuc,
     "G0 x{0} y{0} z{5}\nG1 x{20} ,R{5} F{100}\ny{20} ,C{3}\nx{0} y{40}\nG2 x{10} y{50} R{10}\n"
     "G1 x{40}"},
    // Rotation, absolute and incremental; scale; mirror; polar coordinates; local offset.
    {Language::Fanuc,
     "G0 x{0} y{0} z{5}\nG68 x{10} y{5} R30\nG1 x{20} y{0} F{100}\nG3 x{10} y{10} i{-10}\nG91 G1 "
     "x{5}\n"
     "G90\nG68 x{0} y{0} R-60\nG1 x{7} y{8}\nG69\nx{1} y{1}"},
    {Language::Fanuc,
     "G0 x{0} y{0} z{5}\nG51 x{4} y{2} z{0} P3\nG1 x{10} y{5} z{-1} F{100}\nG50\nG51.1 x{3}\n"
     "G2 x{20} y{10} R{32}\nG50.1 x{0}\nG52 x{5} y{6} z{7}\nG1 x{1} y{1} z{1}\nG52 x{0} y{0} z{0}\n"
     "x{2} y{2} z{2}"},
    {Language::Fanuc,
     "G0 x{0} y{0} z{5}\nG16 G1 x{10} y30 F{100}\ny75\nG91 x{4} y20\nG90 G15 x{0} y{0}"},
    // Cycles, from both heights of return, with pecks and with dwells; words that stay.
    {Language::Fanuc,
     "G0 x{0} y{0} z{50}\nF{100}\nG98 G81 x{10} y{0} z{-5} R{2}\nx{20}\nG99 y{30}\nG80\nG82 x{20} "
     "z{-3} R{1} P0.5\n"
     "G84 x{30} z{-8} R{2}\nG85 x{40}\nG86 x{50}\nG89 x{60} P0.2\nG80"},
    {Language::Fanuc,
     "G0 x{0} y{0} z{50}\nF{100}\nG98 G83 x{0} y{10} z{-10} R{1} Q{4}\nx{3}\n"
     "G99 G73 x{5} z{-10} R{1} Q{3}\ny{4}\nG80"},
    {Language::Fanuc,
     "G0 x{0} y{0} z{50}\nF{100}\nG76 x{10} z{-5} R{2} Q{0.5}\nG0 y{9}\nG76 x{20} z{-5} R{2}\n"
     "G80\nG91 G81 x{5} y{5} z{-6} R{-48} L3\nG90 G80 G0 z{60}"},
    {Language::Klartext,
     "L x+{0} y+{0} z+{50} R0 FMAX\nL z-{1} F<100>\nL x+{20} y+{5} RL\nRND R{8}\nL y+{40}\nCHF "
     "{4}\n"
     "L x+{60}\nCC x+{60} y+{30}\nC x+{70} y+{30} DR-\nCT x+{50} y+{0}\nCR x+{20} y+{5} R+{40} "
     "DR-\n"
     "L x-{20} y-{20} R0\nCC x+{0} y+{0}\nLP PR+{30} PA+20\nCP IPA+60 DR+\nCP IPA+450 Iz-{3} DR+"},
    {Language::Klartext,
     "CYCL DEF 247 Q339=1\nL x+{0} y+{0} z+{50} R0 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 x+{5}\n"
     "CYCL DEF 7.2 y-{3}\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+30\nL x+{10} y+{4} F<100>\nCYCL DEF "
     "10.0\n"
     "CYCL DEF 10.1 ROT+0\nCYCL DEF 8.0\nCYCL DEF 8.1 x\nL x+{3} y+{9}\nCYCL DEF 11.0\nCYCL DEF "
     "11.1 SCL 0.5\nL x+{8} y+{2} z+{7}"},
    {Language::Klartext,
     "L x+{0} y+{0} z+{50} R0 FMAX\nAPPR LCT x+{10} y+{20} R{8} RL F<100>\nL y+{40}\nL x+{50}\n"
     "DEP LCT x+{60} y+{70} R{6}\nAPPR CT x+{0} y+{0} CCA90 R{7} RR\nL x+{30} y+{10}\n"
     "DEP LN LEN{9}\nAPPR LT x+{0} y+{40} LEN{8} RL\nCR x+{20} y+{40} R+{11} DR-\nL x+{20} y+{20}\n"
     "DEP LT LEN{5}"},
    {Language::Klartext,
     "L x+{0} y+{0} z+{50} R0 FMAX\n"
     "CYCL DEF 200 Q200={2} Q201={-7} Q206=<150> Q202={3} Q210=0 Q203={1} Q204={20} Q211=0\n"
     "L x+{10} y+{5} FMAX M99\n"
     "CYCL DEF 203 Q200={2} Q201={-9} Q206=<150> Q202={3} Q203={0} Q204={20} Q212={0.5} Q213=1 "
     "Q205={1} Q208=<900> Q256={0.3}\nL x+{20} FMAX M99\n"
     "CYCL DEF 205 Q200={2} Q201={-9} Q206=<150> Q202={3} Q203={0} Q204={20} Q212={0.2} Q205={1} "
     "Q258={0.5} Q259={0.6} Q257={0.8} Q256={0.2}\nL x+{30} FMAX M99\n"
     "CYCL DEF 204 Q200={2} Q249={5} Q250={20} Q251={3} Q252={10} Q253=<700> Q254=<200> Q203={0} "
     "Q204={30} Q214=1\nL x+{40} FMAX M99\n"
     "CYCL DEF 208 Q200={2} Q201={-10} Q206=<300> Q334={3} Q203={0} Q204={20} Q335={30}\n"
     "L x+{50} FMAX M99\n"
     "CYCL DEF 209 Q200={2} Q201={-9} Q239={1} Q203={0} Q204={8} Q257={4} Q256=0\nL x+{60} FMAX "
     "M99"},
    {Language::Klartext,
     "L x+{0} y+{0} z+{50} R0 FMAX\n"
     "CYCL DEF 262 Q335={30} Q239={1.5} Q201={-9} Q355=0 Q253=<750> Q351=1 Q200={2} Q203={0} "
     "Q204={30} Q207=<300>\nL x+{5} y+{6} FMAX M99\n"
     "CYCL DEF 264 Q335={30} Q239={-1.5} Q201={-9} Q356={-12} Q253=<750> Q351=-1 Q202={5} "
     "Q258={0.2} "
     "Q257={0} Q256={0.2} Q358={0} Q359={0} Q200={2} Q203={0} Q204={30} Q206=<150> Q207=<300>\n"
     "L x+{40} FMAX M99\n"
     "CYCL DEF 267 Q335={30} Q239={1.5} Q201={-9} Q355=2 Q253=<750> Q351=1 Q200={2} Q358={-2} "
     "Q359={1} Q203={0} Q204={30} Q254=<150> Q207=<300>\nL x+{90} FMAX M99"},
    {Language::Sinumerik,
     "G0 x{0} y{0} z{50}\nG1 z{-1} F{100}\nG2 x{10} y{10} CR={10}\nG3 AR=90 i{4} j{3}\n"
     "G111 x{1} y{2}\nG1 AP=30 RP={20}\nG2 AP=0 RP={20}\nCT x{60} y{30}\nCIP x{70} y{50} z{-1} "
     "i1={72} j1={40} k1={-1}\nG3 x{70} y{50} z{-4} i{-5} j{0} TURN=2\nG1 x{80} RND={2}\ny{70} "
     "CHR={3}\nx{90}\nG41 x{100} y{80}\nG2 x{120} y{60} CR={20}\nG3 x{140} y{40} CR={20}\nG1 "
     "x{160}\n"
     "G40 y{100}"},
    {Language::Sinumerik,
     "G0 x{0} y{0} z{50}\nF{100}\nTRANS x{5} y{6} z{7}\nAROT RPL=30\nG1 x{10} y{3} z{0}\nATRANS "
     "x{2}\n"
     "G2 x{20} y{3} CR={9}\nASCALE x2 y2 z1\nG1 x{3} y{4}\nAMIRROR x0\nG1 x{5} y{1}\nTRANS\nx{0} "
     "y{0}"},
    {Language::Sinumerik,
     "G0 x{0} y{0} z{50}\nF{100}\nCYCLE81({10},{1},{2},,{5})\nCYCLE82({10},{0},{2},{-5},,1.5)\n"
     "G0 x{9}\nCYCLE83({5},{-1},{5},{-6.2},,{-2},,{0.1},0,0,1,1,,{0.5},0,0,{1})\nG0 x{19}\n"
     "CYCLE83({5},{0},{2},{-10},,,{4},{1},0,0,1,0,,,{0.5})\nG0 x{29}\n"
     "CYCLE84({16},{10},{5},{1},,0,3,,{1},0,500,400)\nCYCLE85({12},{0},{2},{-6},,1,{50},{80})\n"
     "MCALL CYCLE81({5},{0},{2},{-3})\nHOLES1({10},{20},90,{5},{10},3)\n"
     "HOLES2({5},{5},{10},30,0,3)\nCYCLE801({0},{0},20,{10},{5},2,2)\nMCALL\nG1 x{1}"},
    {Language::Sinumerik,
     "G0 x{0} y{0} z{50}\nF{100}\n"
     "POCKET3({20},{0},{2},{-6},{40},{30},{8},{2},{1},20,{3},{0.2},{0.1},{500},{150},0,11)\n"
     "POCKET4({20},{0},{2},{-6},{20},{2},{1},{3},{0.2},{0.1},{500},{150},0,21)\n"
     "SLOT1({20},{0},{2},{-6},,3,{20},{14},{2},{1},{8},20,120,{150},{500},{4},0,{0.3},10)\n"
     "SLOT2({20},{0},{2},{-6},,2,70,{14},{0},{0},{25},10,180,{150},{500},{4},2,{0.2},10)\n"
     "LONGHOLE({20},{0},{2},{-6},,4,{20},{2},{1},{8},20,0,{150},{500},{4})"},
};

/// Programs that need G17, or no plane: tables of positions and parameters in program units.
const std::vector<Case> kInBothUnits{
    {Language::Fanuc,
     "G0 X{0} Y{0} Z{5}\nG92 X{3} Y{4} Z{5}\nG1 X{10} F{100}\n#1=#5041\nG92.1\nG1 Y#1\n"
     "#2=[#5042+{1}]\nX#2\nG10 L2 P2 X{5} Y{6} Z{7}\nG55 X{1} Y{1} Z{1}\nG10 L20 P2 X{2}\nX{0}\n"
     "#5242={9}\nG55 Y{1}\nG54"},
    {Language::Fanuc,
     "G10 L11 P1 R{20}\nG10 L10 P1 R{30}\nG43 H1\nG0 X{0} Y{0} Z{5}\nG49\nG53 G0 Z{0}\n"
     "G28 X{10}\nG91 G30 Z{5}\nG90 G0 X{0} Y{0} Z{50}\nG1 F{200} X{4}\nG93 X{9} F3\nG94 X{0} "
     "F{90}\n"
     "G95 X{5} F{0.2}\nG4 P1.5"},
    {Language::Klartext,
     "L X+{0} Y+{0} Z+{50} R0 FMAX\n"
     "CYCL DEF 251 Q215=0 Q218={40} Q219={30} Q220={8} Q368={0.2} Q224=20 Q367=0 Q207=<500> Q351=1 "
     "Q201={-6} Q202={3} Q369={0.1} Q206=<150> Q338={0} Q200={2} Q203={0} Q204={20} Q370=1 Q366=1 "
     "Q385=<400>\nL X+{2} Y+{1} FMAX M99\n"
     "CYCL DEF 252 Q215=0 Q223={40} Q368={0.2} Q207=<500> Q351=1 Q201={-6} Q202={3} Q369={0.1} "
     "Q206=<150> Q338={2} Q200={2} Q203={0} Q204={20} Q370=1 Q366=0 Q385=<400>\n"
     "L X+{52} Y+{1} FMAX M99\n"
     "CYCL DEF 253 Q215=0 Q218={40} Q219={14} Q368={0.2} Q374=30 Q367=1 Q207=<500> Q351=1 "
     "Q201={-6} "
     "Q202={3} Q369={0.1} Q206=<150> Q338={0} Q200={2} Q203={0} Q204={20} Q366=0\n"
     "L X+{2} Y+{61} FMAX M99\n"
     "CYCL DEF 221 Q225={5} Q226={6} Q237={50} Q238={40} Q242=2 Q243=2 Q224=10 Q200={4} Q203={1} "
     "Q204={30} Q301=0"},
    {Language::Sinumerik,
     "G0 X{0} Y{0} Z{50}\nF{100}\n"
     "CYCLE71({20},{3},{2},{0},{0},{0},{60},{40},0,{2},{8},{3},{0.2},{500},31)\n"
     "CYCLE90({20},{0},{2},{-9},,{30},{27},{1.5},{300},2,0,{5},{6})\n"
     "R1={7}\nG1 X=R1 Y=IC({3})\nG55 X{1}\nG64 SUPA G0 Z{0}\nG153 G0 X{0}"},
};

TEST(Symmetry, OfUnits) {
    for (const auto* table : {&kInEachPlane, &kInBothUnits}) {
        for (const Case& test : *table) {
            SCOPED_TRACE(test.blocks);
            const Made mm = run(test, false, 0);
            EXPECT_EQ(mm.errors(), "");
            EXPECT_GT(mm.moves.size(), 3U);
            expect_same(mm, run(test, true, 0), 0);
        }
    }
}

TEST(Symmetry, OfPlanes) {
    for (const Case& test : kInEachPlane) {
        SCOPED_TRACE(test.blocks);
        const Made reference = run(test, false, 0);
        EXPECT_GT(reference.moves.size(), 3U);
        expect_same(reference, run(test, false, 1), 1);
        // Compensation is only in G17 and G18.
        if (!has_compensation(test)) expect_same(reference, run(test, false, 2), 2);
    }
}

}  // namespace
}  // namespace ncsim::gcode
