// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each message of diagnostics.def occurs in a test, word for word: in a program of bad/ (first
// line), of good/ (.motions), or in a case below.
#include "ncsim/gcode/interpreter.h"

#include "text/message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::gcode {
namespace {

namespace fs = std::filesystem;

enum class By : unsigned char {
    Default,
    Strict,
    Fanuc,
    Haas,
    Grbl,
    Mach3,
    Tip,
    Turning,
    Klartext,
    KlartextTool,
    Sinumerik,
    SinumerikTurning
};

// Machine with rotary axes that reaches no orientation, and no tip position with X > 50 mm.
class Stubborn : public JointSolver {
public:
    bool turns() const override { return true; }
    TipPose tip_pose(const Axes&, double) const override { return {}; }
    std::optional<Axes> joints_for(const Triple& tip, const Axes& joints, double) const override {
        return tip[0] > 50.0 ? std::nullopt : std::optional(joints);
    }
    Triple rotate_with_table(const Triple& v, const Axes&, const Axes&) const override { return v; }
    Solution joints_for_direction(const Triple&, const Axes&, Way) const override {
        return {std::nullopt, false, "it will not"};
    }
};

struct Case {
    By by;
    std::string program;  // '~' is a line end
    std::string said;     // with the position
};

// Returns all diagnostics of the program, one per line.
std::vector<std::string> said_of(const Case& c) {
    std::string text = c.program;
    std::ranges::replace(text, '~', '\n');
    InterpreterOptions options;
    options.strict = c.by == By::Strict;
    if (c.by == By::Tip) options.tip_control = {{{428, Coordinates::Tip}}, true, false};
    if (c.by == By::Turning) {
        options.joints = std::make_shared<Stubborn>();
        options.fixture_offsets = {{{1, {{1, 2, 3}, {}, {}}}}, true};
        options.setting_errors = {{{1, {{1, 2, 3}, {}, {0, 0, 0.5}}}, {2, {{}, {}, {1, 0, 0}}}},
                                  true};
    }
    options.dialect = c.by == By::Fanuc || c.by == By::Turning                ? Dialect::Fanuc
                      : c.by == By::Haas                                      ? Dialect::Haas
                      : c.by == By::Grbl                                      ? Dialect::Grbl
                      : c.by == By::Mach3                                     ? Dialect::Mach3
                      : c.by == By::Klartext || c.by == By::KlartextTool      ? Dialect::Heidenhain
                      : c.by == By::Sinumerik || c.by == By::SinumerikTurning ? Dialect::Sinumerik
                                                                              : Dialect::Rs274;
    if (c.by == By::SinumerikTurning) options.joints = std::make_shared<Stubborn>();
    if (c.by == By::SinumerikTurning || c.by == By::KlartextTool) {
        options.tools = {{.number = 1,
                          .offset = {},
                          .length_specified = false,
                          .diameter = Length::from_mm(10.0)}};
    }
    std::vector<std::string> said;
    for (const Diagnostic& d : interpret({"", text}, options, {}).diagnostics) {
        std::string line = render(d, SourceFile{});
        line.erase(line.find_last_not_of('\n') + 1);
        said.push_back(line.substr(line.starts_with(':') ? 1 : 0));
    }
    return said;
}

std::string many_points() {
    std::string text = "G21 G90 G17 F100 G0 X0 Y0~";
    for (int i = 0; i < 100'001; ++i)
        text.append("G5.2 X").append(std::to_string(i + 1)).append("~");
    return text;
}

const std::vector<Case>& cases() {
    static const std::string kSinumerik = "G710 G90~T1 M6~";
    static const std::string kKlartext = "BEGIN PGM T MM~TOOL CALL 1 Z S1~";
    static const std::string kStart = "G21 G90 G17 F100 G0 X0 Y0 Z0~";
    static const std::vector<Case> kCases = {
        {By::Grbl, "G21 G81 X5 Z-3 R1",
         "1:5: error: grbl 1.1 has no G81; the block is left out [not-of-control]"},
        // Reading lines
        {By::Default, "G1 !5 X1",
         "1:4: error: expected a letter with a number, found '!' [letter-expected]"},
        {By::Default, "G0 X[1+ATAN 30]", "1:4: error: cannot read 'atan30]' [unreadable-text]"},
        {By::Default, "G0 X1 (to the left",
         "1:7: warning: this comment is not closed; it is taken to reach the end of the line "
         "[comment-unclosed]"},
        {By::Default, "G0 X1 )",
         "1:7: warning: a closing parenthesis without an opening one [comment-unopened]"},
        {By::Default, "G0 X1~#<depth = 5",
         "2:2: error: this parameter name is not closed with '>' [name-unclosed]"},
        {By::Default, "G0 X1~#1 G0 X2",
         "2:1: error: expected '=' after the parameter [assignment-expected]"},
        {By::Default, "G0 X1~#5",
         "2:1: warning: #5 stands alone, without '='; it is left out [parameter-shown]"},
        {By::Default, "o1 repeet [2]",
         "1:11: error: 'repeet' is no control word (such as sub, call, if, while) "
         "[o-word-unknown]"},
        {By::Tip, "G0 X0 Y0 Z0 A10~G43.4 H1",
         "2:1: error: G43.4 with rotary axes that are not at 0: the machine file does not specify "
         "whether X, Y and Z turn with the table from there or from 0 (control.tip_frame_at); the "
         "program is stopped here [kinematics]"},
        {By::Tip, "M428~G0 X0 Y0 Z0 A10~G81 X1 R2 Z-5 F100",
         "3:1: error: G81 is not simulated under tip control with the tool tilted [kinematics]"},
        {By::Turning, "G43.4 H1",
         "1:1: error: G43.4: the machine file does not specify whether X, Y and Z turn with the "
         "table (control.tip_frame); the program is stopped here [kinematics]"},
        {By::Turning, "G68.2 P7",
         "1:1: error: G68.2 needs a form that is one (P); the program is stopped here "
         "[plane-form]"},
        {By::Turning, "G0 X0 Y0 Z0~G53.1",
         "2:1: error: G53.1 needs a tilted plane, and none is active (G68.2); the program is "
         "stopped "
         "here [plane-form]"},
        {By::Turning, "G68.2 J5~G92.1",
         "2:1: error: G92.1 is not simulated in a tilted plane; it ends with G69 [plane-form]"},
        {By::Turning, "G68.2 J5~G53.1",
         "2:1: error: G53.1 asks for a direction of the tool that this machine cannot give it: it "
         "will not; the program is stopped here [unreachable-orientation]"},
        {By::Fanuc, "G21 G90 G0 X0 Y0 Z5~IF [#500 EQ 1] GOTO 9~N9 M30",
         "2:1: warning: #500 decides here, and the program does not set it before; specify its "
         "value: "
         "[variables] \"#500\" = … in the job file [variable-unknown]"},
        {By::Fanuc, "#2001=5.~M30",
         "1:1: warning: what the control does when #2001 is set is not simulated; the value is "
         "kept as "
         "a number [variable-not-applied]"},
        {By::Fanuc, "#3000=1 (WRONG TOOL)~M30",
         "1:1: warning: the control stops here with the alarm 1 (WRONG TOOL); what follows is not "
         "simulated [control-alarm]"},
        {By::Fanuc, "G65 P9023~M30",
         "1:1: warning: O9023 is a program of the control and not in the folder; the call is left "
         "out "
         "(--subprograms DIR names a folder with it; --allow O9023, if it is harmless) "
         "[macro-missing]"},
        {By::Fanuc,
         "G21 G90 G0 X#101 Y#102 Z#103~X#104 Y#105 Z#106~X#107 Y#108 Z#109~X#110 Y#111 Z#112~"
         "X#113 Y#114 Z#115~X#116 Y#117 Z#118~X#119 Y#120 Z#121~M30",
         "7:13: warning: more variables decide here, and the program does not set them before "
         "[variable-unknown]"},
        {By::Fanuc, "DPRNT[X#1]~M30",
         "1:1: note: 'DPRNT[X#1]' shows or prints text and moves nothing [console-text]"},
        {By::Fanuc, "G65 P9832~M30",
         "1:1: note: P9832 is taken as the probing macro of that number: it moves nothing "
         "[probe-macro]"},
        {By::Fanuc, "G17 F100 G0 X0 Y0 Z0 C0~G7.1 C25~G2 Z-5 C10 R9",
         "3:1: error: G2 on a cylinder (G7.1) needs a plane with the cylinder's axis [plane-form]"},
        {By::Turning, "G54.2 P1~G28 A0",
         "2:1: error: G28 is not simulated while the zero goes with the table; G54.2 P0 ends that "
         "[plane-form]"},
        {By::Turning, "G68.2 X0 Y0 Z0~G54.2 P1",
         "2:1: error: G54.2 is not simulated under tip control, nor in a tilted plane; the program "
         "is stopped here [plane-form]"},
        {By::Turning, "G54.2 P2",
         "1:1: error: G54.2 P2 needs parameters of the control that are not specified: where the "
         "part is on the table (machine file, control.fixture_offsets), and whether the "
         "tool moves with the zero (control.fixture_offset_moves); the program is stopped here "
         "[kinematics]"},
        {By::Turning, "G54.4 P3",
         "1:1: error: G54.4 P3 needs parameters of the control that are not specified: by how much "
         "the setting of the part is off (machine file, control.setting_errors), and "
         "whether the tool moves with the zero (control.setting_error_moves); the program is "
         "stopped here [kinematics]"},
        {By::Turning, "G54.4 P2",
         "1:1: error: G54.4 P2: the part is tilted, and the machine file does not specify that "
         "rotary axes compensate it (control.setting_error_turns_axes); a tool that leans on the "
         "part is not "
         "simulated; the program is stopped here [kinematics]"},
        {By::Turning, "G54.4 P1",
         "1:1: warning: G54.4 P1: the part is turned by 0.5 degrees on the table; motions are "
         "reported in the frame of the part, and axis positions as if the part were straight "
         "[setting-error]"},
        {By::Turning, "G54.2 P1~G54.4 P1",
         "2:1: error: G54.4 while another code has the zero go with the table; end that one first; "
         "the program is stopped here [plane-form]"},
        {By::Turning, "G0 X0 Y0 Z0 A5~G254~G0 A0",
         "3:1: error: a rotary axis turns under G254, where the zero stays behind; G255 ends it "
         "[plane-form]"},
        {By::Turning, "G68.2 J5~G0 X60 A5",
         "2:1: error: the place cannot be reached with the rotary axes where they are "
         "[unreachable-orientation]"},
        // Values
        {By::Default, "G0 X" + std::string(200, '[') + "1" + std::string(200, ']'),
         "1:4: error: this expression is nested too deeply [expression-too-deep]"},
        {By::Default, "G0 X[10**400]",
         "1:4: error: the result is not a number a machine can use [not-a-number]"},
        {By::Default, "G0 X1~o1 repeat", "2:1: error: a value is missing here [number-expected]"},
        {By::Default, "G0 X[1 $]", "1:4: error: expected a bracket at '$]' [bracket-expected]"},
        {By::Default, "G0 X1~#5420=3",
         "2:1: error: the parameter #5420 can only be read [parameter-read-only]"},
        {By::Default, "G0 X[EXISTS[5]]",
         "1:4: error: EXISTS wants a parameter name: EXISTS[#<name>] [exists-argument]"},
        // Words and codes
        {By::Default, "G0 X1 E5",
         "1:7: warning: the word E means nothing here; it is left out [unknown-word]"},
        {By::Default, "M3 S900 E5",
         "1:9: warning: the word E means nothing here; it is left out [unknown-word]"},
        {By::Default, "T1 M6 T2",
         "1:7: note: T stands twice in this block; the first is changed to, the second waits "
         "[next-tool]"},
        {By::Fanuc, "G0 X50000",
         "1:4: note: X50000 has no decimal point; it is read as whole units. If the control counts "
         "least increments, say so with --increments [no-decimal-point]"},
        {By::Default, "G4", "1:1: warning: G4 needs a time (P) [dwell-without-time]"},
        {By::Default, kStart + "G53 G2 X1 I0.5", "2:1: warning: G53 needs G0 or G1 [g53-motion]"},
        {By::Default, kStart + "G1 X1~G55 G1 X2",
         "3:5: warning: the distance from the origin of G55 to that of G54 is not specified; it is "
         "taken to be 0 [offset-unknown]"},
        // Arcs and curves
        {By::Default, kStart + "G2 X10 I5 R5",
         "2:11: warning: G2 has a centre and a radius; the centre counts [arc-two-forms]"},
        {By::Fanuc, kStart + "G2 X10 I9 R5",
         "2:11: warning: G2 has a centre and a radius; the radius counts [arc-two-forms]"},
        {By::Default, kStart + "G2 X10 I5 P0.5",
         "2:11: warning: P must be a whole number of turns, 1 or more [arc-turns]"},
        {By::Default, kStart + "G2 X0 Y0 I0.0000000001",
         "2:1: warning: the radius of this G2 is next to nothing; moved straight [arc-too-small]"},
        {By::Default, kStart + "G2 X10.2 I5",
         "2:1: warning: the start of this G2 is 5 from its centre, the end 5.2; moved as a spiral "
         "[arc-spiral]"},
        {By::Mach3, kStart + "G2 X1 J20000",
         "2:1: warning: this G2 has a radius of 20000 and, as written, goes nearly all around; "
         "moved the short way to its end [arc-long-way]"},
        {By::Fanuc, kStart + "G51 X0 Y0 Z0 P2000~G81 X1 Z-1 R1",
         "3:1: warning: G51 scales the axis of G81: Fanuc scales R and the depth of the hole, Haas "
         "does not; they are scaled here; end G51 before the cycle, or scale the plane alone "
         "[cycle-scaled]"},
        {By::Fanuc, kStart + "#1=4~G1 X#1/2 M8",
         "3:4: warning: the / in this word is read as a division, Fanuc and Haas read block "
         "delete; "
         "write brackets, as in X[#1/2], or a blank before the / [slash-after-value]"},
        {By::Grbl, kStart + "$X",
         "2:1: note: '$X' is for the control's console and moves nothing [console-text]"},
        {By::Fanuc, kStart + "#1=2**3",
         "2:1: warning: Fanuc and Haas have no operator for powers and stop with an alarm here; it "
         "is read as a power; write the product [power-operator]"},
        {By::Fanuc, kStart + "G83 Q2 F9",
         "2:5: warning: Fanuc keeps Q of a cycle only from a block that drills; it is left out; "
         "write it in a block with X, Y, Z or R [cycle-words-lost]"},
        {By::Fanuc, kStart + "G60 X1",
         "2:1: note: G60 positions at rapid; how far it goes beyond the end first is a parameter "
         "of the machine and is not simulated [one-sided-move]"},
        {By::Mach3, kStart + "G1 X1~G60 X2",
         "3:1: warning: G60 without G0 and G1: Fanuc and Haas position at rapid, other controls "
         "stop exactly; moved as G1; write G0 or G1 [one-sided-feed]"},
        {By::Fanuc, kStart + "G10 L50~N1221 R0~G11",
         "3:1: warning: G10 L50 writes parameter 1221 of the control, which may change what the "
         "program does; it is left out. If it is harmless, say so with --allow N1221 [data-line]"},
        {By::Fanuc, kStart + "G10 L3~P1~G11",
         "2:1: warning: G10 L3 writes data of the control up to G11, which may change what the "
         "program does; they are left out [data-line]"},
        {By::Fanuc, kStart + "G10 L50~X1",
         "3:1: error: this block is behind G10 L50 and no line of its data; G11 is missing before "
         "it [data-lines-open]"},
        {By::Mach3, kStart + "G290~G0 X1",
         "3:1: warning: behind G290 the control reads the language of SINUMERIK; this is read as "
         "ISO code; write the program in one language [language-switch]"},
        {By::Haas, kStart + "G81 X1 Z-1 R1~Z-2",
         "3:1: warning: G81 without X and Y: Fanuc drills again at this place, the manual of Haas "
         "has holes for X and Y only; it is drilled; write X and Y [cycle-without-place]"},
        {By::Fanuc, kStart + "G16 G1 X1 Y30~G91 X1 Y30",
         "3:1: warning: controls read an increment of the radius together with an increment of the "
         "angle in different ways; the radius was taken from the tool, the angle from the last "
         "angle; program the angle in a block of its own, or in G90 [polar-increment]"},
        {By::Mach3, kStart + "G41.1 D6~G1 X2",
         "3:1: warning: the first move with cutter compensation is not longer than the cutter "
         "radius; read as Fanuc and Haas begin, LinuxCNC refuses it [compensation-entry]"},
        {By::Mach3, kStart + "G41.1 D6~G3 X20 I10",
         "3:1: warning: cutter compensation begins with an arc; read as LinuxCNC begins, Fanuc and "
         "Haas refuse it [compensation-entry]"},
        {By::Fanuc, kStart + "G41 D1~G53 G0 Z0",
         "3:5: warning: G53 while cutter compensation is on: some controls stop with an alarm, "
         "others move without the offset; end it with G40 first [forbidden-with-compensation]"},
        {By::Default, kStart + "G5.2 X1 Y1 L4~G5.3",
         "3:1: error: this curve has fewer control points than its order (L) [spline-points]"},
        {By::Default, kStart + "G6.2 P2 X1 Y1 K0~G1 X5",
         "3:1: error: a curve of G6.2 wants as many knots (K) as points and order (P) together, "
         "and none smaller than the one before [spline-knots]"},
        {By::Default, many_points(),
         "100001:1: error: this curve has more control points than a machine can hold "
         "[spline-points] (2 times, first here)"},
        // Cycles, threads
        {By::Strict, kStart + "G93 F5 G81 X1 Z-1 R1",
         "2:8: error: G81 does not work under G93 [cycle-inverse-time]"},
        {By::Default, kStart + "G81 X1 Z5 R1",
         "2:1: warning: G81 has its bottom above R [cycle-upside-down]"},
        {By::Default, kStart + "G33 Z-5", "2:1: warning: G33 needs a pitch (K) [pitch-missing]"},
        // The course of the program
        {By::Default,
         "o1 sub~o1 endsub~o1 call [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] "
         "[1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1]",
         "3:1: error: a call takes 30 arguments at most [call-arguments]"},
        {By::Strict, "o1 sub~G0 X1", "1:1: error: the subroutine 1 has no end [sub-end-missing]"},
        {By::Strict, "G21~o1 sub~o1 endsub~o1 sub~o1 endsub~M2",
         "4:1: error: the subroutine O1 is defined a second time [sub-twice]"},
        {By::Strict, "G21~o1 sub~o1 endsub~o1 return~M2",
         "4:1: error: endsub or return of O1 stands outside of a subroutine [return-outside]"},
        {By::Strict, "#1=3~o1 if #1~o1 endif~M2",
         "2:1: error: values of control words stand in brackets: [#1] [condition-bracket]"},
        {By::Strict, "o1 sub~o1 endsub~o1 call 5~M2",
         "3:9: error: values of control words stand in brackets: [5] [condition-bracket]"},
        {By::Strict, "G21~o1 if [1]~o1 endif~o1 if [1]~o1 endif~M2",
         "4:1: error: the label O1 is used a second time for another control structure "
         "[label-twice]"},
        {By::Strict, "G21~o1 endif~M2",
         "2:1: error: nothing before this opens O1 [block-begin-missing]"},
        {By::Strict, kStart + "G43 H1.5~M2",
         "2:5: error: the value of H must be a whole number [not-whole]"},
        {By::Strict, "M3 M8 M48 M0 M66 P0~M2",
         "1:1: error: a block has 4 M codes at most [too-many-m]"},
        {By::Strict, kStart + "M66~M2",
         "2:1: error: M66 needs an input, either P or E [word-missing]"},
        {By::Strict, kStart + "G1 @5 X4~M2",
         "2:7: error: X and Y do not go with the polar words @ and ^ [polar-with-axes]"},
        {By::Strict, "G21~G0 X0 (" + std::string(246, 'a') + ")~M2",
         "2:1: error: a line has 252 characters at most [line-too-long]"},
        {By::Strict, kStart + "G41.1 D2~G1 X[#5420+5]~M2",
         "3:4: error: the position #5420 must not be read while cutter compensation is on "
         "[parameter-range]"},
        {By::Default, "G0 X1~M99",
         "2:1: note: M99 starts the main program over; it was run once [main-repeats]"},
        // Cutter compensation
        {By::Default, kStart + "G41 D5 G1 X20",
         "2:1: warning: the diameter for D5 is not known; the path is taken as programmed, without "
         "compensation [compensation-radius-unknown]"},
        {By::Default, kStart + "G19 G41 D1 G1 Y20",
         "2:5: error: cutter compensation works in the XY and ZX planes (G17, G18) only "
         "[compensation-plane]"},
        {By::Default, "M140 S60~M104 S200~G92 E0~G1 X1 E1",
         "1:1: warning: this looks like a program for a 3-D printer: M140 heats a bed (line 1), "
         "M104 heats an extruder (line 2), G92 E (line 3); it is run as if it milled "
         "[foreign-kind]"},
        // Klartext
        {By::Klartext, kKlartext + "TCH PROBE 400",
         "3:1: error: TCH PROBE is not read; the program is stopped here [klartext-verb]"},
        {By::Klartext, kKlartext + "L X+1 FAMX",
         "3:7: error: 'FAMX' is no word of this block; the program is stopped here "
         "[klartext-word]"},
        {By::Klartext, kKlartext + "G91 G28 Z0",
         "3:1: error: 'G91 G28 Z0' is no block of Klartext; the program is stopped here "
         "[klartext-verb]"},
        {By::Klartext, "=====~" + kKlartext,
         "1:1: warning: the text before BEGIN PGM is no Klartext; it is left out [klartext-head]"},
        {By::Klartext, kKlartext + "CR X+1 DR+",
         "3:1: error: CR needs a radius (R); the program is stopped here [word-missing]"},
        {By::Klartext, kKlartext + "L X+Q5 F1",
         "3:3: warning: Q5 has no value before this block; 0 is taken [variable-unknown]"},
        {By::Klartext, kKlartext + "Q2000 = 1",
         "3:1: error: there is no parameter Q2000 = [parameter-range]"},
        {By::Klartext, kKlartext + "FN 18: SYSREAD Q1 = ID20 NR1",
         "3:1: warning: FN 18 reads data of the control, which are not known; Q1 is taken as 0 "
         "[variable-unknown]"},
        {By::Klartext, kKlartext + "FN 17: SYSWRITE ID50 NR1 = +0",
         "3:1: warning: FN 17 writes data of the control, which has no effect here "
         "[variable-not-applied]"},
        {By::Klartext, kKlartext + "CALL LBL 7",
         "3:1: error: there is no LBL 7; the program is stopped here [label-missing]"},
        {By::Klartext, kKlartext + "CALL LBL 7~M30~LBL 7~END PGM T MM",
         "6:1: error: there is no LBL 0 behind LBL 7; the program is stopped here "
         "[label-missing]"},
        {By::Klartext, kKlartext + "CALL PGM A",
         "3:1: warning: the program A is not in the folder; the call is left out (--subprograms "
         "DIR "
         "names a folder with it; --allow A, if it is harmless) [program-not-found]"},
        {By::Klartext, kKlartext + "CYCL CALL",
         "3:1: error: no machining cycle is defined before this call [cycle-undefined]"},
        {By::Klartext, kKlartext + "CYCL DEF 200 A Q200=1~CYCL CALL",
         "4:1: error: cycle 200 needs Q201; the program is stopped here [cycle-parameter]"},
        {By::Klartext, kKlartext + "CYCL DEF 200 A Q200=1 Q201=1~CYCL CALL",
         "4:1: error: the depth of cycle 200 is positive; the cycle is left out "
         "[depth-positive]"},
        {By::Klartext, kKlartext + "CYCL DEF 200 A Q200=1 Q201=0~CYCL CALL",
         "4:1: warning: the depth of cycle 200 is 0; the control does not run the cycle "
         "[depth-zero]"},
        {By::Klartext, kKlartext + "CC X+0 Y+0~CP IPA+9 DR-",
         "4:1: error: the sign of IPA and of DR differ; the block is left out "
         "[direction-differs]"},
        {By::Klartext, kKlartext + "CC X+5 Y+0~CP IPA+360 DR-",
         "4:1: warning: the sign of IPA and of DR differ; the tool turns in the direction of DR "
         "[direction-differs]"},
        {By::Klartext, kKlartext + "C X+1 Y+1 DR+",
         "3:1: error: C needs a centre (CC) before it; the block is left out "
         "[arc-without-centre]"},
        {By::Klartext, kKlartext + "CC X+0 Y+0~C X+1 Y+1",
         "4:1: error: C needs a direction (DR+ or DR-); the block is left out "
         "[direction-missing]"},
        {By::Klartext, kKlartext + "CT X+1 Y+1",
         "3:1: error: CT needs a move in the plane before it; the block is left out "
         "[tangent-missing]"},
        {By::Klartext, kKlartext + "L X+9 RL F1~L X+19 RR",
         "4:1: error: between RL and RR a block with R0 is needed; the program is stopped here "
         "[rl-change]"},
        {By::Klartext, kKlartext + "ERROR = L X",
         "3:1: error: the control rejected this block; the program is stopped here "
         "[control-error]"},
        {By::Klartext, kKlartext + "FN 14: ERROR = 1000",
         "3:1: warning: the control stops here with an error of the program (FN 14); what follows "
         "is not simulated [control-alarm]"},
        {By::Klartext, kKlartext + "L Z+0 FMAX M92",
         "3:1: warning: M92 refers to a point of the machine builder; it is read as the zero of "
         "the machine [machine-point]"},
        {By::Klartext, kKlartext + "CC X+0 Y+0~C X+0 Y+0 DR+ FMAX",
         "4:1: warning: FMAX in an arc is simulated at the last feed [arc-rapid]"},
        {By::Klartext, kKlartext + "TOOL CALL \"A\" Z",
         "3:11: note: the tool \"A\" has no number; it is T9001 here [tool-name]"},
        {By::Klartext, kKlartext + "CYCL DEF 247 A Q339=999",
         "3:1: error: the preset 999 of cycle 247 is no number from 0 to 290; the program is "
         "stopped here [preset-unknown]"},
        {By::KlartextTool,
         kKlartext +
             "CYCL DEF 258 A Q200=1 Q201=-1 Q203=0 Q202=1 Q206=9 Q207=9 Q571=9 Q222=20 Q572=6"
             "~CYCL CALL",
         "4:1: warning: where the corners of cycle 258 are is up to the control; one is taken in "
         "the "
         "direction of its angle [corner-direction]"},
        {By::KlartextTool,
         kKlartext + "CYCL DEF 263 A Q200=1 Q201=-1 Q203=0 Q356=-2 Q335=20 Q239=1 Q207=9~CYCL CALL",
         "4:1: warning: how far cycle 263 moves the tool outwards to countersink is up to the "
         "control; here the tool goes straight down [countersink]"},
        {By::KlartextTool,
         kKlartext + "CYCL DEF 14.1 LABEL1~CYCL DEF 20 A Q1=-1 Q8=1~CYCL DEF 22 A Q10=1 Q11=9 "
                     "Q12=9~CYCL CALL",
         "6:1: warning: Q8 of cycle 20 rounds the path at inner corners, which is not simulated; "
         "the corners are as round as the tool [inner-radius]"},
        {By::Klartext, kKlartext + "CYCL DEF 200 A Q200=1 Q201=-1 Q395=1",
         "3:1: warning: ncsim does not apply Q395 of cycle 200; the path is that without it "
         "[cycle-parameter-left-out]"},
        {By::Klartext, kKlartext + "TCH PROBE 480 CALIBRATE TT",
         "3:1: warning: TCH PROBE 480 measures the tool; its moves and its result are left out "
         "[tool-probe]"},
        {By::Klartext,
         kKlartext + "TOOL CALL 77 Z S9~CYCL DEF 252 A Q200=1 Q201=-1 Q223=9~CYCL CALL",
         "5:1: warning: cycle 252 is left out: the diameter of T77 is not known (--tool "
         "T77=flat:D…) [compensation-radius-unknown]"},
        {By::Klartext, kKlartext + "CYCL END",
         "3:1: warning: CYCL END is no block of the control; it is taken to end M89 "
         "[klartext-verb]"},
        // SINUMERIK
        {By::Sinumerik, kSinumerik + "CYCLE79(1)",
         "3:1: error: CYCLE79 is not read; the program is stopped here [not-read]"},
        {By::Sinumerik, kSinumerik + "?",
         "3:1: error: '?' is no block of SINUMERIK; the program is stopped here [not-read]"},
        {By::Sinumerik, kSinumerik + "G0 G1",
         "3:4: error: G1 and another code of its group are in one block; the program is stopped "
         "here [group-twice]"},
        {By::Sinumerik, kSinumerik + "G1 X=A",
         "3:6: error: there is no variable A; the program is stopped here [variable-missing]"},
        {By::Sinumerik, kSinumerik + "R1=$A_IN[1]",
         "3:4: error: $A_IN is data of the control, which are not known here; the program is "
         "stopped here [variable-missing]"},
        {By::Sinumerik, kSinumerik + "R1=\"A\"",
         "3:1: error: this needs a number; the program is stopped here [value-type]"},
        {By::Sinumerik, kSinumerik + "R[-1]=1",
         "3:2: error: this index is not in the array; the program is stopped here "
         "[parameter-range]"},
        {By::Sinumerik, kSinumerik + "IF 1==1 AND 1==1",
         "3:14: error: AND and OR bind more strongly than comparisons; put brackets around each "
         "comparison; the program is stopped here [comparison-brackets]"},
        {By::Sinumerik, kSinumerik + "GOTOF A",
         "3:1: error: there is no label A behind this block; the program is stopped here "
         "[label-missing]"},
        {By::Sinumerik, kSinumerik + "LOOP~GOTOF A~A: IF 1==2",
         "5:4: error: IF has no ENDIF; the program is stopped here [block-end-missing]"},
        {By::Sinumerik, kSinumerik + "ENDLOOP",
         "3:1: error: nothing before this block begins what ENDLOOP ends; the program is stopped "
         "here [block-begin-missing]"},
        {By::Sinumerik, "%_N_A_SPF~PROC A~%_N_B_MPF~A(1)",
         "2:1: error: the call has more arguments than PROC has parameters; the program is stopped "
         "here [call-arguments]"},
        {By::Sinumerik, "%_N_A_SPF~X1~%_N_B_MPF~G0 A",
         "4:1: error: a call needs a block of its own; the program is stopped here [call-forms]"},
        {By::Sinumerik, kSinumerik + "TRANS X1 F1",
         "3:1: error: TRANS needs a block of its own; the program is stopped here "
         "[frame-own-block]"},
        {By::Sinumerik, kSinumerik + "ATRANS X1~TRANS X1",
         "4:1: error: TRANS after ATRANS or G59 may keep or delete their part of the offset; write "
         "TRANS alone before it; the program is stopped here [reading-guess]"},
        {By::Sinumerik, kSinumerik + "CYCLE81(5,0,1,2)",
         "3:1: error: the depth of CYCLE81 is above the reference plane; the program is stopped "
         "here [depth-positive]"},
        {By::SinumerikTurning, kSinumerik + "POCKET4(9,0,1,1,20,0,0,1,0,0,9,9,0,11,5,,,,,,,,,1,1)",
         "3:1: warning: the size of POCKET4 with _GMODE is taken as a diameter; older controls "
         "have "
         "the radius here [pocket-size]"},
        {By::SinumerikTurning, kSinumerik + "LONGHOLE(9,0,1,-1,,1,20,0,0,5,0,0,9,9)",
         "3:1: warning: versions of LONGHOLE differ: the radius is taken as that of the inner ends "
         "of the slots, not of their middles [slot-position]"},
        {By::SinumerikTurning,
         kSinumerik + "CYCLE72(\"A:B\",9,0,1,-1,0,0,0,9,9,2,41,1,9)~M30~A:~G1 X0 Y0~B: G1 X9",
         "3:1: warning: versions of CYCLE72 differ in the ways to the contour and back: lengths "
         "are "
         "taken from the edge of the tool, radii of its centre [contour-lead]"},
        {By::SinumerikTurning, kSinumerik + "CYCLE61(9,0,1,-1,0,0,9,9,1,1,0,9,11)",
         "3:1: warning: how far CYCLE61 mills outside of its face or blank is up to the control; "
         "material there makes the part uncertain [mills-outside]"},
        {By::Sinumerik, kSinumerik + "G0 X0 Y0~G3 X1 Y1 I1 J0 TURN=1.5",
         "4:16: warning: TURN counts whole turns; the fraction is left out [turn-fraction]"},
        {By::Sinumerik, kSinumerik + "G70",
         "3:1: warning: G70 leaves the unit of feeds to the machine; mm is taken (--units names "
         "the unit of the machine; G700 sets both) [feed-unit]"},
        {By::Sinumerik, kSinumerik + "D3",
         "3:1: warning: D3 of T1 has no values of its own here; length and radius of the tool are "
         "taken [tool-edge]"},
        {By::Sinumerik, "T1~G0 X1",
         "1:1: warning: the program has no M6; T changes the tool at once [tool-change]"},
        {By::Sinumerik, kSinumerik + "G0 Z5~G1 Z-5 F9~G1 X9~T2 M6",
         "6:1: warning: the tool changes at the lowest height of its cut; retract it before "
         "[change-without-retract]"},
        {By::Sinumerik, kSinumerik + "MCALL CYCLE81(5,0,1,-2)~T2 M6",
         "4:1: warning: MCALL is active at the tool change; end it before with MCALL alone "
         "[left-on]"},
        {By::SinumerikTurning,
         kSinumerik + "TRAORI~G0 X1 Y1 Z1 A0 C0~ORIWKS ORIVECT~G1 X2 A30 C20 F100",
         "6:1: warning: the axes turn linearly here; ORIWKS and ORIVECT turn the tool along a "
         "great circle (ORIAXES with ORIMKS: linearly) [turn-by-vector]"},
        {By::Sinumerik, kSinumerik + "TRANS X1~M30",
         "4:1: warning: a programmable frame is active at the end of the program; end it with "
         "TRANS [left-on]"},
        {By::Klartext, kKlartext + "CYCL DEF 7.0~CYCL DEF 7.1 X+1",
         "4:1: warning: cycle 7 shifts a datum, and no cycle 247 selects the preset; program CYCL "
         "DEF 247 before [preset-missing]"},
    };
    return kCases;
}

TEST(Messages, AreSaidInTheseWords) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.program.substr(0, 200));
        const std::vector<std::string> said = said_of(c);
        std::ostringstream all;
        for (const std::string& line : said)
            all << line << '\n';
        EXPECT_TRUE(std::ranges::find(said, c.said) != said.end()) << c.said << "\nis not in\n"
                                                                   << all.str();
    }
}

TEST(Messages, NothingIsSaidOfTheWordsOfAnaloguePortsAndOfSmoothness) {
    for (const char* program :
         {"M66 E0 L0", "M67 E1 Q5", "M68 E1 Q5", "G187 P2 E0.05", "G187 E.1"}) {
        for (const std::string& line : said_of({By::Default, program, ""}))
            EXPECT_EQ(line.find("word"), std::string::npos) << program << ": " << line;
    }
}

TEST(Messages, EndWithOneThatThereAreMore) {
    std::string text;
    for (int i = 0; i < 402; ++i)
        text += "M" + std::to_string(1000 + i) + "~";
    const std::vector<std::string> said = said_of({By::Default, text, ""});
    ASSERT_EQ(said.size(), DiagnosticLog::kMaxDifferent + 1);
    EXPECT_EQ(said.back(),
              "401:1: note: there are more faults than are worth listing; the rest is not shown "
              "[too-many-diagnostics]");
}

struct Row {
    const char* name;
    MessageText message;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> kRows = {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) {#name, Message::name},
#include "text/diagnostics.def"
#undef NCSIM_DIAGNOSTIC
    };
    return kRows;
}

// Returns the lines of the tests that hold expected messages.
std::vector<std::string> expected_lines() {
    std::vector<std::string> lines;
    for (const Case& c : cases())
        lines.push_back(c.said);
    const fs::path directory = fs::path(NCSIM_SOURCE_DIR) / "tests/gcode";
    for (const char* folder : {"bad", "good"}) {
        for (const auto& entry : fs::directory_iterator(directory / folder)) {
            const bool bad = entry.path().extension() == ".nc" && std::string(folder) == "bad";
            if (!bad && entry.path().extension() != ".motions") continue;
            std::ifstream in(entry.path());
            std::string line;
            for (int number = 1; std::getline(in, line); ++number) {
                if (line.starts_with(';') && (!bad || number == 1)) lines.push_back(line);
            }
        }
    }
    return lines;
}

// True if `line` is the text of `message` with any text in place of each "{}".
bool says(const std::string& line, const MessageText& message) {
    const std::string end = " [" + std::string(message.code) + "]";
    const std::size_t code = line.find(end);
    if (code == std::string::npos) return false;
    std::size_t at = 0;
    for (const char* severity : {": error: ", ": warning: ", ": note: "}) {
        const std::size_t found = line.find(severity);
        if (found != std::string::npos) at = found + std::string(severity).size();
    }
    std::string_view rest = message.text;
    for (bool first = true;; first = false) {
        const std::size_t hole = rest.find("{}");
        const std::string_view part = rest.substr(0, hole);
        const std::size_t found = line.find(part, first ? at : at + 1);
        if (found == std::string::npos || (first && found != at)) return false;
        at = found + part.size();
        if (hole == std::string_view::npos) return at == code;
        rest.remove_prefix(hole + 2);
        if (rest.empty()) return at < code;
    }
}

TEST(Messages, AreAllSaidInSomeTest) {
    const std::vector<std::string> lines = expected_lines();
    for (const Row& row : rows()) {
        EXPECT_TRUE(std::ranges::any_of(
            lines, [&](const std::string& line) { return says(line, row.message); }))
            << row.name << ": no test expects it";
    }
}

TEST(Messages, AreWrittenAlike) {
    std::set<std::pair<std::string_view, std::string_view>> texts;
    for (const Row& row : rows()) {
        SCOPED_TRACE(row.name);
        const auto [severity, code, text] = row.message;
        EXPECT_TRUE(std::regex_match(std::string(code), std::regex("[a-z0-9]+(-[a-z0-9]+)*")));
        EXPECT_FALSE(text.ends_with('.'));
        EXPECT_TRUE(texts.emplace(code, text).second) << "two rows say the same";
    }
}

}  // namespace
}  // namespace ncsim::gcode
