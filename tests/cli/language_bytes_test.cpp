// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes of Klartext and SINUMERIK programs that must leave the same part, to the byte: block
// numbers, line ends, repeats and calls written out, a shift instead of a specified offset.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

/// Two offsets: G55 is shifted by 7, -4 and -1 mm against G54.
constexpr const char* kJob =
    "stock = \"80x60x20\"\n[offsets]\nG54 = [0, 0, 0]\nG55 = [7, -4, -1]\n";

/// A slot in G54, then `shift`, a path, and `back`.
std::string sinumerik(const std::string& shift, const std::string& back) {
    return "G710 G90 G17 G54 G94\nT1 M6\nS1000 M3 F300\nG0 X-50 Y0 D1\nZ-2\nG1 X-20\nG0 Z20\n" +
           shift + "\nG0 X0 Y0\nZ-2\nG1 X20\nG2 X30 Y10 CR=10\nG0 Z20\n" + back + "\nM30\n";
}

std::string klartext(const std::string& shift, const std::string& path) {
    return "BEGIN PGM A MM\nCYCL DEF 247 Q339=1\nTOOL CALL 1 Z S1000\nL X-50 Y+0 R0 FMAX M3\n"
           "L Z-2 FMAX\nL X-20 F300\nL Z+20 FMAX\n" +
           shift + "\nL X+0 Y+0 FMAX\nL Z-2 FMAX\n" + path + "\nL Z+20 FMAX\nM30\nEND PGM A MM\n";
}

/// Returns the cells of the part of `program`; `name` ends in .mpf or .h.
std::string part_of(const Folder& folder, const std::string& name, const std::string& program) {
    folder.write("job.toml", kJob);
    folder.write(name, program);
    const Ran ran =
        folder.run({"run", name, "--job", "job.toml", "--tool", "T1=flat:D10:L30", "--start",
                    "0,0,100", "--no-project", "-q", "--save-stock", "part.ncstock"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    std::string cells = folder.read_cells("part.ncstock");
    EXPECT_GT(cells.size(), 100U);
    return cells;
}

std::string with_ends(const std::string& text, const std::string& head, const std::string& end) {
    std::string out;
    int number = 1;
    for (std::size_t at = 0; at < text.size(); ++number) {
        const std::size_t stop = text.find('\n', at);
        out += head.empty() ? "" : head + std::to_string(number * 10) + " ";
        out += text.substr(at, stop - at) + end;
        at = stop + 1;
    }
    return out;
}

TEST(LanguageBytes, SinumerikShiftIsASpecifiedOffset) {
    const Folder folder;
    const std::string shifted = part_of(folder, "a.mpf", sinumerik("TRANS X7 Y-4 Z-1", "TRANS"));
    EXPECT_TRUE(shifted == part_of(folder, "a.mpf", sinumerik("G55", "G54")));
    EXPECT_FALSE(shifted == part_of(folder, "a.mpf", sinumerik("TRANS X7 Y-4", "TRANS")));
}

TEST(LanguageBytes, SinumerikNumbersAndLineEnds) {
    const Folder folder;
    const std::string program = sinumerik("G55", "G54");
    const std::string part = part_of(folder, "a.mpf", program);
    EXPECT_TRUE(part == part_of(folder, "a.mpf", with_ends(program, "N", "\n")));
    EXPECT_TRUE(part == part_of(folder, "a.mpf", with_ends(program, "", "\r\n")));
}

TEST(LanguageBytes, KlartextShiftIsASpecifiedOffset) {
    const Folder folder;
    const std::string path = "L X+20 F300\nCR X+30 Y+10 R+10 DR-";
    const std::string shift = "CYCL DEF 7.0\nCYCL DEF 7.1 X+7\nCYCL DEF 7.2 Y-4\nCYCL DEF 7.3 Z-1";
    EXPECT_TRUE(part_of(folder, "a.h", klartext(shift, path)) ==
                part_of(folder, "a.h", klartext("CYCL DEF 247 Q339=2", path)));
}

TEST(LanguageBytes, KlartextNumbersRepeatsAndCalls) {
    const Folder folder;
    const std::string step = "L IX+6 F300\nL IY-3\n";
    const std::string written_out = klartext("", step + step + step + "L IX+1");
    const std::string part = part_of(folder, "a.h", written_out);
    EXPECT_TRUE(part == part_of(folder, "a.h", with_ends(written_out, " ", "\n")));
    EXPECT_TRUE(part == part_of(folder, "a.h", with_ends(written_out, "", "\r\n")));
    EXPECT_TRUE(part == part_of(folder, "a.h",
                                klartext("", "LBL 1\n" + step + "CALL LBL 1 REP 2\nL IX+1")));
    folder.write("sub.h", "BEGIN PGM SUB MM\n" + step + step + "END PGM SUB MM\n");
    EXPECT_TRUE(part == part_of(folder, "a.h",
                                klartext("", "CALL PGM TNC:\\PARTS\\sub.h\n" + step + "L IX+1")));
}

}  // namespace
}  // namespace ncsim::cli_test
