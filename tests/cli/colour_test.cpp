// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of text: --color, NO_COLOR, terminals.
#include "system/colour.h"

#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

constexpr const char* kProgram =
    "G21 G90 G17\n(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,60,40,20,30,20,20)\nT1 M6\nS900 "
    "M3\nG0 X0 Y0 Z5\nG0 "
    "Z-1\nX20\nM30\n";

std::string plain(const std::string& text) {
    static const std::regex kEscapes("\x1b\\[[0-9;]*m");
    return std::regex_replace(text, kEscapes, "");
}

TEST(Colour, IsOfPlacesSeveritiesVerdictsAndCarets) {
    EXPECT_EQ(app::coloured("a.nc:3:1: error: wrong [rule]\n  3 | G0 X: 1\n    | ^~~~\n"),
              "\x1b[1ma.nc:3:1\x1b[0m: \x1b[1;31merror\x1b[0m: wrong [rule]\n"
              "  3 | G0 X: 1\n\x1b[32m    | ^~~~\x1b[0m\n");
    EXPECT_EQ(app::coloured("a.nc: clean: 0 errors"),
              "\x1b[1ma.nc\x1b[0m: \x1b[32mclean\x1b[0m: 0 errors");
    EXPECT_EQ(app::coloured("a: b.nc: not proven: 1 doubt\n\n"),
              "\x1b[1ma: b.nc\x1b[0m: \x1b[1;33mnot proven\x1b[0m: 1 doubt\n\n");
    for (const char* const text : {"", "\n", "error: none", "a.nc: errors: 3", "x: notes"})
        EXPECT_EQ(app::coloured(text), text);
}

TEST(Colour, IsTakenFromAnyPlaceOfTheCommandLine) {
    const auto left = [](std::vector<std::string> words, const std::string& mode) {
        EXPECT_EQ(app::take_colour(words), mode);
        return words;
    };
    using Words = std::vector<std::string>;
    EXPECT_EQ(left({"--color", "never", "run", "a.nc"}, "never"), (Words{"run", "a.nc"}));
    EXPECT_EQ(left({"run", "--color=always", "a.nc"}, "always"), (Words{"run", "a.nc"}));
    EXPECT_EQ(left({"run", "--color=always", "--color", "auto"}, "auto"), (Words{"run"}));
    EXPECT_EQ(left({"run", "--", "--color=always"}, "auto"),
              (Words{"run", "--", "--color=always"}));
    EXPECT_EQ(left({"run", "--colour", "tool"}, "auto"), (Words{"run", "--colour", "tool"}));
    EXPECT_EQ(left({"run", "--color"}, ""), (Words{"run"}));
}

TEST(Colour, ChangesNoTextAndNoData) {
    Folder folder;
    folder.write("a.nc", kProgram);
    const Ran never = folder.run({"check", "a.nc"});
    EXPECT_EQ(plain(never.out), never.out);
    const Ran always = folder.run({"check", "a.nc", "--color", "always"});
    EXPECT_EQ(always.exit_code, never.exit_code);
    EXPECT_NE(always.out, never.out);
    EXPECT_EQ(plain(always.out), never.out);
    EXPECT_TRUE(contains(always.out, "\x1b[1;31merror\x1b[0m")) << always.out;
    EXPECT_EQ(folder.run({"check", "a.nc", "-q", "--json", "-"}).out,
              folder.run({"--color=always", "check", "a.nc", "-q", "--json", "-"}).out);
    const Ran wrong = folder.run({"check", "a.nc", "--color", "blue"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_EQ(wrong.err, "ncsim: --color 'blue': expected auto, always or never\n");
    EXPECT_TRUE(contains(folder.run({"check", "--help"}).out, "--color auto, always, never"));
}

TEST(Colour, IsOnTerminalsWithoutNoColour) {
    Folder folder;
    folder.write("a.nc", kProgram);
    const auto shown = [&](const std::string& environment) {
        const std::string folder_name = folder.path().string();
        const std::string command = "cd '" + folder_name + "' && env -u NO_COLOR " + environment +
                                    " script -qec \"" NCSIM_PROGRAM
                                    " check a.nc\" /dev/null > shown < /dev/null";
        EXPECT_NE(std::system(command.c_str()), -1);
        return folder.read("shown");
    };
    EXPECT_TRUE(contains(shown("TERM=xterm"), "\x1b[1;31merror\x1b[0m"));
    EXPECT_FALSE(contains(shown("TERM=dumb"), "\x1b[1"));
    EXPECT_FALSE(contains(shown("TERM=xterm NO_COLOR=1"), "\x1b[1"));
    EXPECT_TRUE(contains(shown("TERM=xterm NO_COLOR="), "\x1b[1"));
}

}  // namespace
}  // namespace ncsim::cli_test
