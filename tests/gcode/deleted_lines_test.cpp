// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of samples, tests/programs and tests/verdicts with a deleted block between two lines, or
// a '/' between two words: with block delete the deleted text has no effect, whatever it contains.
#include "ncsim/gcode/executed_text.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include "gcode/program_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <variant>
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
std::string outcome(const Program& program, const std::string& text, bool block_delete = true) {
    std::string out;
    InterpreterOptions options = program.options;
    options.block_delete = block_delete;
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

/// Returns the places in `line`, a block of G-code, where a word begins behind another word.
std::vector<std::size_t> places_between_words(const std::string& line) {
    std::vector<std::size_t> places;
    // Lines with operations, control words, slashes and text for other devices.
    if (line.find_first_of("=oO:%$/*") != std::string::npos || line.find("IF") != std::string::npos)
        return places;
    const std::size_t end = std::min(line.find_first_of("(;"), line.size());
    int depth = 0;
    std::size_t words = 0;
    for (std::size_t at = 0; at < end; ++at) {
        if (line[at] == '[') ++depth;
        if (line[at] == ']') --depth;
        const bool is_letter = std::isalpha(static_cast<unsigned char>(line[at])) != 0;
        const bool continues =
            at > 0 &&
            (std::isalpha(static_cast<unsigned char>(line[at - 1])) != 0 || line[at - 1] == ',');
        if (depth > 0 || !is_letter || continues) continue;
        if (words++ > 0) places.push_back(at);
    }
    return places;
}

/// A slash between two words: block delete skips the rest of the block, and the block without
/// block delete is the same as without the slash.
TEST(DeletedLines, ASlashBetweenWordsSkipsTheRestOfTheBlock) {
    constexpr std::size_t kMostPlaces = 12;
    const std::array<std::string, 6> slashes = {" /", " /2", " / ", " /9 ", " /1/3", " /7/ "};
    std::mt19937 random(20261201);
    std::size_t count = 0;
    std::vector<Program> programs = all_programs();
    for (Program& program : programs) {
        if (language_of(program.file) != Language::GCode || program.options.strict) continue;
        // A slash may hide a sign of the dialect.
        if (program.options.dialect == Dialect::Auto)
            program.options.dialect = detect_dialect(program.file).dialect;
        const std::vector<std::string> lines = lines_of(program.file.text);
        if (lines.empty()) continue;
        for (std::size_t i = 0; i < kMostPlaces; ++i) {
            const std::size_t at = random() % lines.size();
            const std::vector<std::size_t> places = places_between_words(lines[at]);
            if (places.empty()) continue;
            const std::size_t place = places[random() % places.size()];
            const auto text_with = [&](const std::string& line) {
                std::vector<std::string> other = lines;
                other[at] = line;
                return joined(other, other.size(), "");
            };
            const std::string kept = lines[at].substr(0, place);
            const std::string rest = lines[at].substr(place);
            const std::string slash = slashes[random() % slashes.size()];
            ++count;
            EXPECT_EQ(outcome(program, text_with(kept + slash + rest)),
                      outcome(program, text_with(kept)))
                << program.file.name << ':' << at + 1 << ": " << kept + slash + rest;
            EXPECT_EQ(outcome(program, text_with(kept + slash + rest), false),
                      outcome(program, text_with(lines[at]), false))
                << program.file.name << ':' << at + 1 << ": " << kept + slash + rest;
        }
    }
    EXPECT_GT(count, 500U);
}

/// A division is no block delete, and a slash where a control accepts none is an error.
TEST(DeletedLines, DivisionsAreNoBlockDelete) {
    const auto end_of = [](const std::string& name, const std::string& text, bool block_delete) {
        InterpreterOptions options;
        options.block_delete = block_delete;
        double x = -1.0;
        const Interpretation result = interpret({name, text}, options, [&](const Motion& motion) {
            if (const auto* line = std::get_if<Linear>(&motion.action)) x = line->to.x.mm();
        });
        return has_errors(result.diagnostics) ? -2.0 : x;
    };
    for (const bool block_delete : {false, true}) {
        for (const char* const text :
             {"O1\n#1=6.\n#1=#1/2\nG0 X#1\nM30\n", "O1\n#1=6.\nG0 X[#1/2]\nM30\n",
              "O1\n#1=6.\nIF [#1/2 EQ 3] THEN #1=#1/2\nG0 X#1 /2M8\nM30\n",
              "O1\n#2=6.\nG0 X[#2 / [1 + 1]] / M8\nM30\n"}) {
            EXPECT_EQ(end_of("a.nc", text, block_delete), 3.0) << text;
        }
        EXPECT_EQ(end_of("a.mpf", "R1=6\nR1=R1/2\nG0 X=R1/1\nM30\n", block_delete), 3.0);
        EXPECT_EQ(end_of("a.mpf", "G0 X1\nG0 X3 /Y5\nM30\n", block_delete), -2.0);
        const std::string head = "BEGIN PGM A MM\nTOOL CALL 1 Z S100\n";
        EXPECT_EQ(end_of("a.h", head + "Q1 = 6\nQ1 = Q1 / 2\nL X+Q1 R0 FMAX\nEND PGM A MM\n",
                         block_delete),
                  3.0);
        EXPECT_EQ(end_of("a.h", head + "L X+1 / Y+2 R0 FMAX\nEND PGM A MM\n", block_delete), -2.0);
    }
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
    EXPECT_EQ(text_of("N1 G1 X1 /2 Y1 ?\n (a) /G1 /X1\n", Language::GCode),
              "N1 G1 X1        \n (a)        \n");
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
