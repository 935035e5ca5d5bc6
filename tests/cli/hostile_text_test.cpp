// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hostile text in programs, set-up files and file names: neither a terminal nor a CI service
// executes the text, and each output stays valid in its format.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

// True if the line looks like a command to the runner of GitHub, the agent of Azure, or TeamCity.
bool is_obeyed(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(" \t\r\xc2\xa0");
    const std::string rest = begin == std::string::npos ? "" : line.substr(begin);
    return rest.starts_with("::") || rest.starts_with("##") ||
           line.find("##vso[") != std::string::npos ||
           line.find("##teamcity[") != std::string::npos ||
           line.find("##[error]") != std::string::npos || line.find('\x1b') != std::string::npos;
}

std::vector<std::string> lines_of(const Ran& ran) {
    std::vector<std::string> lines;
    for (const std::string* text : {&ran.out, &ran.err}) {
        std::istringstream in(*text);
        for (std::string line; std::getline(in, line);)
            lines.push_back(line);
    }
    return lines;
}

// Returns slots with a rapid move through material, and lines that cannot be read.
std::string hostile_program() {
    std::string text(kSlot);
    text.replace(text.find("G1 X30. F500."), 13,
                 "(::stop-commands::x) ##teamcity[buildStop] G0 X30. (##vso[task.complete]x)\n"
                 "   ::add-mask::secret\n##[error]wrong\n"
                 "(ncsim: ignore ::warning::)\nG0 X30. (\x1b[2J ##[error]x)");
    return "(T1 D=10. CR=0. - ##vso[a]\xc2\x9b - flat end mill)\n" + text;
}

constexpr const char* kHostileMachine =
    "name = \"m\"\n[[fixture]]\nname = \"vice\\n::error::##[error]\\u001b[31m\"\n"
    "box = [[-60, -40, -20], [60, 30, 5]]\n";

TEST(HostileText, IsNotObeyedWhereItIsShown) {
    const std::vector<std::string> names{"::add-mask::a.nc", " ::b.nc",
                                         "\xc2\xa0::c.nc",   "##[error]d.nc",
                                         "e\n::error::e.nc", "f\r\n##vso[x]\x1b[2J.nc"};
    Folder folder;
    folder.write("m.toml", kHostileMachine);
    folder.write("::error::bad.toml", "\"::x\\n::error::\\u001b[31m ##[error]\" = 1\n");
    folder.write("lib.json", R"({"version": 1, "data": [{"type": "flat end mill",
        "description": "mill\n::error::x ##[error]", "geometry": {"DC": 10, "LCF": 30},
        "post-process": {"number": 1}, "unit": "millimeters"}]})");
    for (const std::string& name : names) {
        folder.write(name, hostile_program());
        folder.write("slot.nc", kSlot);
        const std::vector<std::vector<std::string>> commands{
            {"run", name, "--tool-table", "lib.json"},
            {"run", name, "--at-line", "999"},
            {"run", name + "?"},
            {"run", name, "--job", "::error::bad.toml"},
            {"run", name, "--view", "\n::error::x"},
            {"run", name, "--\n::error::x"},
            {"run", name, "--png", name + "/a.png"},
            {"parse", name},
            {"parse", name, "--canonical"},
            {"parse", name, "--json"},
            {"tools", name},
            {"tools", name, "--json", "--tool-table", "lib.json"},
            {"check", name, name, "--machine", "m.toml", "--notes"},
            {"check", name, "--machine", "::error::bad.toml"},
            {"check", name + "?"},
            {"check", name, "--design", name},
            {"check", name, "--tool-table", "lib.json", "--job", "::error::bad.toml"},
            {"diff", name, "slot.nc"},
            {"diff", "slot.nc", name, "--stock", "20x20x20"},
        };
        for (const auto& command : commands) {
            SCOPED_TRACE(testing::PrintToString(command));
            const Ran ran = folder.run(command);
            EXPECT_LT(ran.exit_code, 5);
            EXPECT_NE(ran.exit_code, 3) << ran.err;
            EXPECT_FALSE((ran.out + ran.err).empty());
            for (const std::string& line : lines_of(ran))
                EXPECT_FALSE(is_obeyed(line)) << line;
        }
    }
}

TEST(HostileText, ForgesNoLineOfOurs) {
    Folder folder;
    folder.write("a.nc\nb.nc: clean: 0 errors", kSlot);
    const Ran ran = folder.run({"check", "a.nc\nb.nc: clean: 0 errors"});
    EXPECT_EQ(ran.out.find("\nb.nc"), std::string::npos) << ran.out;
}

TEST(HostileText, CommandsForGitHubAreOursAlone) {
    Folder folder;
    const std::string name = "a,b\n::error::c##vso[d].nc";
    folder.write(name, hostile_program());
    folder.write("m.toml", kHostileMachine);
    const Ran ran = folder.run({"check", name, "--machine", "m.toml", "--github", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    const auto lines = lines_of(ran);
    EXPECT_GT(lines.size(), 3U);
    for (const std::string& line : lines) {
        EXPECT_TRUE(line.starts_with("::error file=a%2Cb%0A") ||
                    line.starts_with("::warning file=a%2Cb%0A") ||
                    line.starts_with("::notice file=a%2Cb%0A"))
            << line;
        EXPECT_EQ(line.find("##"), std::string::npos) << line;
        EXPECT_EQ(line.find('\x1b'), std::string::npos) << line;
    }
}

// File names with control characters of Latin-1 and characters that change the direction of
// writing.
TEST(HostileText, InNamesOfFilesIsNotWrittenAsItIs) {
    const std::vector<std::string> characters{"\xc2\x85",     "\xc2\x9b",     "\xe2\x80\x8f",
                                              "\xe2\x80\xae", "\xe2\x81\xa6", "\xd8\x9c"};
    std::string name = "a";
    for (const std::string& character : characters)
        name += character;
    name += ".nc";
    const Folder folder;
    folder.write(name, kSlot);
    ASSERT_EQ(
        folder.run({"run", name, "--vrml", "a.wrl", "--ply", "a.ply", "--save-job", "a.toml", "-q"})
            .exit_code,
        0);
    const Ran shown = folder.run({"check", name});
    for (const std::string& character : characters) {
        for (const char* file : {"a.wrl", "a.ply", "a.toml"})
            EXPECT_EQ(folder.read(file).find(character), std::string::npos) << file;
        EXPECT_EQ((shown.out + shown.err).find(character), std::string::npos) << shown.out;
    }
    // A job file still names the program.
    EXPECT_EQ(folder.run({"run", "--job", "a.toml", "--stl", "a.stl", "-q"}).exit_code, 0);
}

TEST(HostileText, InATableIsNoFormula) {
    Folder folder;
    for (const char* name : {"=1+1.nc", "+1.nc", "@a.nc", "\tb.nc", "c\n=2.nc"}) {
        folder.write(name, kSlot);
        const Ran ran = folder.run({"check", name, "-q", "--csv", "a.csv"});
        EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
        std::istringstream table(folder.read("a.csv"));
        std::string row;
        std::getline(table, row);
        while (std::getline(table, row)) {
            EXPECT_TRUE(row.starts_with("./") || row.starts_with("c?")) << row;
            EXPECT_EQ(row.find(",="), std::string::npos) << row;
        }
    }
}

}  // namespace
}  // namespace ncsim::cli_test
