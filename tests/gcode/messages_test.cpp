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

enum class By : unsigned char { Default, Strict, Fanuc, Grbl, Mach3, Tip, Turning };

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
    options.dialect = c.by == By::Fanuc || c.by == By::Turning ? Dialect::Fanuc
                      : c.by == By::Grbl                       ? Dialect::Grbl
                      : c.by == By::Mach3                      ? Dialect::Mach3
                                                               : Dialect::Rs274;
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

TEST(Messages, NothingIsSaidOfTheWordsOfAnaloguePorts) {
    for (const char* program : {"M66 E0 L0", "M67 E1 Q5", "M68 E1 Q5"}) {
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
