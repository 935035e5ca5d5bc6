// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls of programs by their names: M98 <NAME>, G65 <NAME>, M98 (folder/name.nc). A call by name
// makes the motions of a call by number.
#include "ncsim/gcode/file_programs.h"
#include "ncsim/gcode/interpreter.h"

#include "gcode/outcome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {
namespace {

using outcome::Files;
using outcome::Outcome;
using outcome::run;

const std::string kHead = "O1\nG21 G90 F100\nG1 X0 Y0 Z0\n";
const std::string kBody = "G91 G1 X1\nY1\nG90\nM99\n";
const std::string kThree = "0 0 0 \n1 0 0 \n1 1 0 \n2 1 0 \n2 2 0 \n3 2 0 \n3 3 0 \n";

TEST(NamedPrograms, InTheFileAndInFilesAreThoseOfNumbers) {
    const std::string by_number = run(kHead + "M98 P7 L3\nM30\nO7\n" + kBody, Dialect::Fanuc).moves;
    ASSERT_EQ(by_number, kThree);
    for (const std::string call : {"M98 <SIDE-1.NC> L3", "M98<SIDE-1.NC>L3", "m98 <Side-1.nc> l3",
                                   "N5 M98 <SIDE-1.NC> L3", "M198 <SIDE-1.NC> L3"}) {
        const std::string main = kHead + call + "\nM30\n";
        EXPECT_EQ(run(main + "<SIDE-1.NC>\n" + kBody, Dialect::Fanuc).moves, kThree) << call;
        EXPECT_EQ(
            run(main + "<OTHER>\nG1 X9\nM99\n<side-1.nc> (A)\n" + kBody, Dialect::Fanuc).moves,
            kThree)
            << call;
        const Outcome missing = run(main + "<SIDE-2>\n" + kBody, Dialect::Fanuc);
        EXPECT_TRUE(missing.says("sub-not-found")) << call;
        EXPECT_EQ(missing.moves, "0 0 0 \n") << call;
        // Names of files: as written, in lower case, in upper case.
        for (const std::string file : {"side-1.nc", "SIDE-1.NC"}) {
            const Outcome found = run(main, Dialect::Fanuc, {{file, kBody}});
            EXPECT_EQ(found.moves, kThree) << call << " " << file;
            EXPECT_FALSE(found.says("sub-not-found"));
        }
    }
}

TEST(NamedPrograms, TakeArgumentsOfG65) {
    const std::string sub = "G1 X#1 Y#24\nM99\n";
    const std::string moves = "0 0 0 \n4 5 0 \n";
    EXPECT_EQ(run(kHead + "G65 P7 A4 X5\nM30\nO7\n" + sub, Dialect::Fanuc).moves, moves);
    EXPECT_EQ(run(kHead + "G65 <HOLE> A4 X5\nM30\n<HOLE>\n" + sub, Dialect::Fanuc).moves, moves);
    EXPECT_TRUE(run(kHead + "G65 <HOLE> A4\nM30\n", Dialect::Fanuc).says("sub-not-found"));
    // G66: after each move, until G67.
    const std::string modal = "G1 X1\nX2\nG67\nX3\nM30\n";
    EXPECT_EQ(run(kHead + "G66 <HOLE> A4 X5\n" + modal + "<HOLE>\n" + sub, Dialect::Fanuc).moves,
              run(kHead + "G66 P7 A4 X5\n" + modal + "O7\n" + sub, Dialect::Fanuc).moves);
}

TEST(NamedPrograms, InACommentAreOfHaasAndMach3) {
    const Files files{{"side.nc", kBody}};
    for (const Dialect dialect : {Dialect::Haas, Dialect::Mach3, Dialect::Auto}) {
        for (const std::string name : {"(side.nc)", "( side.nc )", "(USB0/jobs/side.nc)",
                                       "(C:\\jobs\\side.nc)", "(SIDE.NC)"})
            EXPECT_EQ(run(kHead + "M98 " + name + " L3\nM30\n", dialect, files).moves, kThree)
                << name_of(dialect) << " " << name;
        EXPECT_TRUE(run(kHead + "M98 (gone.nc)\nM30\n", dialect, files).says("sub-not-found"));
        EXPECT_TRUE(run(kHead + "M98\nM30\n", dialect, files).says("call-without-number"));
        // With P, the comment is a comment.
        EXPECT_EQ(run(kHead + "M98 P7 L3 (gone.nc)\nM30\nO7\n" + kBody, dialect, files).moves,
                  kThree);
    }
    EXPECT_TRUE(
        run(kHead + "M98 (side.nc)\nM30\n", Dialect::Fanuc, files).says("call-without-number"));
}

TEST(NamedPrograms, DivideAFile) {
    const std::string sub = "<SIDE>\n" + kBody;
    const FilePrograms called(SourceFile{"a.nc", "<MAIN>\nG1 X1\nM98 <Side>\nM30\n" + sub});
    EXPECT_TRUE(called.unreached().empty());
    ASSERT_EQ(called.programs().size(), 1U);
    EXPECT_EQ(called.programs()[0].label, "<main>");
    const FilePrograms uncalled(SourceFile{"a.nc", "<MAIN>\nG1 X1\nM30\n" + sub});
    ASSERT_EQ(uncalled.unreached().size(), 1U);
    EXPECT_EQ(uncalled.unreached()[0].label, "<side>");
    const FilePrograms two(SourceFile{"a.nc", "<A>\nG1 X1\nM30\n<B>\nG1 X1\nM30\n"});
    EXPECT_EQ(two.programs().size(), 2U);
}

}  // namespace
}  // namespace ncsim::gcode
