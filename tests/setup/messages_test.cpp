// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages about a job that can be run, word for word: each row of setup_messages.def.
#include "support/messages.h"

#include "ncsim/setup/job.h"
#include "ncsim/setup/tool_library.h"

#include "job/setup_messages.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace ncsim::setup {
namespace {

// Returns the messages about a tool table and a comment that specify different data for tool 1.
std::vector<std::string> said_of_a_table_and_a_comment() {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("ncsim_setup_" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    const std::string table = (folder / "tool.tbl").string();
    std::ofstream(table) << "T1 P1 D8 ;flat end mill\n";
    JobOptions options;
    options.tool_tables = {table};
    const Job job = job_of({"a.nc", "G21\n(T1 D=6. CR=0. - flat end mill)\nT1 M6\nM30\n"}, options);
    std::filesystem::remove_all(folder);
    std::vector<std::string> out;
    for (const gcode::Diagnostic& d : job.diagnostics)
        out.push_back(test::said(d));
    return out;
}

// Returns the messages of a file with two programs, a move after an end, and an uncalled
// subprogram.
std::vector<std::string> said_of_a_file_with_two_programs() {
    const Job job = job_of({"a.nc", "O1\nX1\nM30\nX2\nO2\nX1\nM30\nO3\nX1\nM99\n"});
    std::vector<std::string> out;
    for (const gcode::Diagnostic& d : job.diagnostics)
        out.push_back(test::said(d));
    return out;
}

// Returns the messages of a library of FreeCAD with a bit of an unknown shape, and without a bit.
std::vector<std::string> said_of_a_library() {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("ncsim_setup_" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    std::ofstream(folder / "own.fctb") << R"({"shape": "own.fcstd"})";
    const std::string path = (folder / "a.fctl").string();
    std::ofstream(path)
        << R"({"tools": [{"nr": 1, "path": "gone.fctb"}, {"nr": 2, "path": "own.fctb"}]})";
    InputSet inputs;
    const toolpath::ToolFile file = read_tool_library(path, inputs);
    std::filesystem::remove_all(folder);
    std::vector<std::string> out;
    for (const gcode::Diagnostic& d : file.diagnostics)
        out.push_back(test::said(d));
    return out;
}

const std::vector<std::string> kSaid = {
    "tool-conflict: this says tool 1 has a diameter of 6 mm, but tool.tbl says 8 mm, which is used",
    "tool-unknown: tool 1: there is no tool bit 'gone.fctb'; it is left out",
    "tool-unknown: tool 2: the shape 'own.fcstd' is not read; it is left out",
    "moves-after-end: this moves the tool, but stands behind the end of the program in line 3, and "
    "no O number heads it; it is not simulated",
    "never-called: the subprogram O3 is called by no program of this file; it is not simulated",
    "other-programs: the file has more programs from here on (O2); only O1, the first, is read. "
    "ncsim check judges all of them",
};

TEST(Messages, AreSaidInTheseWords) {
    std::vector<std::string> said = said_of_a_table_and_a_comment();
    for (std::string& one : said_of_a_library())
        said.push_back(std::move(one));
    for (std::string& one : said_of_a_file_with_two_programs())
        said.push_back(std::move(one));
    EXPECT_EQ(said, kSaid);
}

TEST(Messages, AreAllSaidHere) {
    constexpr gcode::MessageText kRows[] = {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) Message::name,
#include "job/setup_messages.def"
#undef NCSIM_DIAGNOSTIC
    };
    for (const gcode::MessageText& row : kRows) {
        EXPECT_TRUE(std::ranges::any_of(kSaid, [&](const std::string& said) {
            return test::says(said, row);
        })) << row.text;
    }
}

}  // namespace
}  // namespace ncsim::setup
