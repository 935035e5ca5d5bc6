// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks and motions of the programs in tests/programs, as blocks.txt and motions.txt have them.
// tests/programs/run.py compares all stages by the program ncsim; here the library alone does.
#include "ncsim/gcode/language.h"
#include "ncsim/gcode/parser.h"
#include "ncsim/gcode/print.h"

#include "gcode/stage_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace ncsim::gcode {
namespace {

using namespace stage_programs;

/// Lines of a stage that belong to a line of the program: "L12 feed X10 Y0 Z-1".
std::string numbered_lines(const std::string& stage) {
    std::istringstream in(stage);
    std::string line, all;
    while (std::getline(in, line)) {
        if (line.size() > 1 && line[0] == 'L' && line[1] >= '0' && line[1] <= '9')
            all += line + '\n';
    }
    return all;
}

class ProgramStages : public testing::TestWithParam<std::string> {};

TEST_P(ProgramStages, AreTheBlocksAndMotionsOfTheFolder) {
    const fs::path folder = kPrograms / GetParam();
    const SourceFile program = program_of(folder);
    std::string blocks;
    DiagnosticLog log;
    if (const auto listing = listing_of(program)) {
        ListedBlock line;
        while (listing->next(line, log))
            blocks += "L" + std::to_string(line.line) + ' ' + line.text + '\n';
    } else {
        BlockReader reader(program, {});
        Block block;
        while (reader.next(block, log)) {
            std::string text;
            print(text, block);
            if (!text.empty()) blocks += "L" + std::to_string(block.line) + ' ' + text + '\n';
        }
    }
    EXPECT_EQ(blocks, numbered_lines(read_file(folder / "blocks.txt")));
    std::string motions;
    interpret(program, interpreter_options(folder, program), [&](const Motion& motion) {
        print(motions, motion);
        motions += '\n';
    });
    EXPECT_EQ(motions, numbered_lines(read_file(folder / "motions.txt")));
}

INSTANTIATE_TEST_SUITE_P(Programs, ProgramStages, testing::ValuesIn(folders()),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace ncsim::gcode
