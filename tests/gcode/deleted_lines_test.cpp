// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of samples, tests/programs and tests/verdicts with a deleted block between two lines:
// with block delete the block is the same as a blank line, whatever it contains.
#include "ncsim/gcode/executed_text.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include "gcode/program_words.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace ncsim::gcode::deleted_lines_test {
namespace {

using program_words::goes_on;
using program_words::lines_of;
using stage_programs::fs::path;

struct Program {
    SourceFile file;
    InterpreterOptions options;
};

/// Reads the programs of `folder` that have the extension of a program.
void add_programs(const path& folder, std::vector<Program>& programs) {
    std::vector<path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".nc" || ending == ".ngc" || ending == ".h" || ending == ".mpf")
            paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    for (const path& one : paths) {
        SourceFile file{one.filename().string(), stage_programs::read_file(one)};
        InterpreterOptions options = stage_programs::interpreter_options(folder, file);
        options.limits.repeated_blocks = 2000;
        programs.push_back({std::move(file), std::move(options)});
    }
}

std::vector<Program> all_programs() {
    const path source = NCSIM_SOURCE_DIR;
    std::vector<Program> programs;
    add_programs(source / "samples", programs);
    add_programs(source / "samples/two-sides", programs);
    add_programs(source / "tests/verdicts", programs);
    for (const std::string& folder : stage_programs::folders())
        add_programs(stage_programs::kPrograms / folder, programs);
    return programs;
}

/// Blocks to delete: motions, cycles, ends, loops, subprograms, tools, text that cannot be read.
std::vector<std::string> deleted_blocks(Language language) {
    switch (language) {
        case Language::GCode: break;
        case Language::Klartext:
            return {"/ L X+999 Y-999 Z-99 R0 FMAX",
                    "99999 / CC X+7 Y+7",
                    "/99999 CYCL DEF 200 DRILLING Q200=2 Q201=-99 Q206=9 Q202=9 Q203=+9",
                    "/ M30",
                    "/ RND R77",
                    "/ END PGM OTHER MM",
                    "/ LBL 77",
                    "/ LBL 0",
                    "/ TOOL CALL 77 Z",
                    "/ CALL LBL 78",
                    "99999 / cannot be read ??",
                    "/",
                    "/ \" ~x",
                    "/ BLK FORM 0.1 Z X+0 Y+0 Z-77",
                    "/ FN 9: IF +1 EQU +1 GOTO LBL 79"};
        case Language::Sinumerik:
            return {"/G1 X999 Y-999 Z-99 F7",
                    "N99999 /G0 Z-99",
                    "/3 N99999 G91",
                    "/M30",
                    "/CYCLE81(",
                    "/ENDIF",
                    "/WHILE 1==1",
                    "/T=\"OTHER\" M6",
                    "/PROC OTHER",
                    "/DEF REAL OTHER",
                    "/ %? cannot be read",
                    "/",
                    "/RND=77 G1 X999",
                    "/OTHER: G1 X999",
                    "/WORKPIECE(,,,\"BOX\",48,0,-77,-77,0,0,7,7)"};
    }
    return {"/G1 X999. Y-999. Z-99. F7.",
            "N99999 /G0 Z-99.",
            "/N99999 G91",
            "/M30",
            "/G81 X7. Y7. Z-99. R7. F7.",
            "/M99",
            "/O9977",
            "/:9977",
            "/WHILE [1 EQ 1] DO 3",
            "/END 3",
            "/GOTO 99998",
            "/T77 M6",
            "/o77 sub",
            "/o77 endif",
            "/#1=[[",
            "/ %? cannot be read ((",
            "/%",
            "/",
            "(head) /G1 X999.",
            "/(T77 D=3. CR=0. - ball end mill)",
            "/$H",
            "/M98 P9976",
            "/TOOL CALL 5 Z S2000"};
}

/// Returns what interpret() makes of `text`: motions with their lines, and diagnostics.
std::string outcome(const Program& program, const std::string& text) {
    std::string out;
    InterpreterOptions options = program.options;
    options.block_delete = true;
    const Interpretation result =
        interpret({program.file.name, text}, options, [&](const Motion& motion) {
            print(out, motion);
            out += '\n';
        });
    for (const Diagnostic& d : result.diagnostics)
        out.append(d.code).append(" ").append(std::to_string(d.span.line)).append(d.message) +=
            '\n';
    for (const std::string& mode : result.inherited_modes)
        out += mode + '\n';
    out += std::string(name_of(result.dialect.dialect)) + (result.ended ? " ended" : "") +
           (result.refused ? " refused" : "") + (result.control_dependent ? " depends" : "") +
           (result.units_stated ? " units" : "") + std::to_string(result.lines);
    return out;
}

std::string joined(const std::vector<std::string>& lines, std::size_t at,
                   const std::string& inserted) {
    std::string text;
    for (std::size_t i = 0; i <= lines.size(); ++i) {
        if (i == at) text += inserted + '\n';
        if (i < lines.size()) text += lines[i] + '\n';
    }
    return text;
}

TEST(DeletedLines, ChangeNothing) {
    constexpr std::size_t kMostPlaces = 12;
    std::mt19937 random(20261130);
    std::size_t count = 0;
    for (const Program& program : all_programs()) {
        const std::vector<std::string> lines = lines_of(program.file.text);
        const std::vector<std::string> blocks = deleted_blocks(language_of(program.file));
        const std::size_t places = std::min(kMostPlaces, lines.size() + 1);
        for (std::size_t i = 0; i < places; ++i) {
            const std::size_t at = random() % (lines.size() + 1);
            const std::string& block = blocks[random() % blocks.size()];
            if (at > 0 && goes_on(lines[at - 1])) continue;
            ++count;
            EXPECT_EQ(outcome(program, joined(lines, at, block)),
                      outcome(program, joined(lines, at, "")))
                << program.file.name << ':' << at + 1 << ": " << block;
        }
    }
    EXPECT_GT(count, 2000U);
}

/// A deleted line between the blocks of a contour, between a block and its corner, and between a
/// cycle and its parameters.
TEST(DeletedLines, AreNoPartOfWhatContinuesInTheNextLine) {
    InterpreterOptions options;
    options.block_delete = true;
    options.compensation[1] = Length::from_mm(1.0);
    const auto same = [&](const std::string& name, const std::string& head,
                          const std::string& deleted, const std::string& tail) {
        const Program one{{name, head + tail}, options};
        const std::string with = outcome(one, head + deleted + "\n" + tail);
        EXPECT_EQ(with, outcome(one, head + "\n" + tail)) << deleted;
        EXPECT_NE(with, outcome(one, head + deleted.substr(1) + "\n" + tail)) << deleted;
    };
    const std::string contour =
        "O1\nG0 X0. Y0. Z1.\nT1 M6\nF9.\nG150 P77 X0. Y0. Z-1. R1. J1. G41 D1\nG40\nM30\nN77 G1 "
        "X5. Y0.\n";
    same("a.nc", contour, "/X50.", "Y5.\nX-5.\nY-5.\nX5.\nY0.\nM99\n");
    const std::string head = "BEGIN PGM A MM\nTOOL CALL 1 Z S100\nL X+0 Y+0 Z+5 R0 FMAX\n";
    same("a.h", head + "L X+10 F100\n", "/L X+50", "RND R2\nL Y+10\nEND PGM A MM\n");
    same("a.h", head + "APPR LCT X+10 Y+10 R2 RL F100\n", "/L X+50", "L X+30\nEND PGM A MM\n");
    same("a.h", head + "CYCL DEF 200 DRILLING\nQ200=2\n", "/Q211=7",
         "Q201=-5\nQ206=9\nQ202=5\nQ203=0\nQ204=5\nL X+5 M99\nEND PGM A MM\n");
}

TEST(DeletedLines, KeepNumbersAndLabelsForJumps) {
    const auto text_of = [](const std::string& text, Language language, bool strict = false) {
        SourceFile file{"a", text};
        remove_deleted_blocks(file, language, strict);
        return file.text;
    };
    EXPECT_EQ(text_of("/N10 G0\r\nN20/X1\n /2 n 30 G1 / (a)\n#1=4/2\n", Language::GCode),
              " N10   \r\nN20   \n    n 30         \n#1=4/2\n");
    EXPECT_EQ(text_of("\xEF\xBB\xBF/G0\rG1\r/(open", Language::GCode, true),
              "\xEF\xBB\xBF   \rG1\r      ");
    EXPECT_EQ(text_of("G1 X1 /Y1 ?\n", Language::GCode), "           \n");
    EXPECT_EQ(text_of("/N10 A: G0 ;c\nN20 /1 B:G1\nR1=4/2 ; /\n", Language::Sinumerik),
              " N10 A:      \nN20    B:  \nR1=4/2 ; /\n");
    EXPECT_EQ(text_of("1 / CYCL DEF 200 ~\n Q200=2\n2 L X+1 ; /\n* / a\n", Language::Klartext),
              "                  \n       \n2 L X+1 ; /\n* / a\n");
}

/// The called subprogram is read without deleted blocks, too.
TEST(DeletedLines, OfSubprogramFilesAreSkipped) {
    const auto motions = [](bool block_delete) {
        InterpreterOptions options;
        options.block_delete = block_delete;
        options.dialect = Dialect::Fanuc;
        options.read_file = [](std::string_view) {
            return std::optional(SourceFile{"O7", "O7\nG0 X1.\n/X2.\nM99\n"});
        };
        return interpret({"a.nc", "M98 P7\nM30\n"}, options, {}).motions;
    };
    EXPECT_EQ(motions(true), 1U);
    EXPECT_EQ(motions(false), 2U);
}

}  // namespace
}  // namespace ncsim::gcode::deleted_lines_test
