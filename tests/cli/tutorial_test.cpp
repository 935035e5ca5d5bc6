// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the steps of docs/first-job.md. A block "```nc FILE" is a file, "```toml FILE +" is appended
// to a file, "```sh" are commands, and each line of "```text" is a part of the output before.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace ncsim::cli_test {
namespace {

// Runs a line of a block of commands: "ncsim check job.toml  # exit code 4".
std::string output_of(const Folder& folder, const std::string& line) {
    constexpr const char* kProgram = "ncsim ";
    constexpr const char* kExit = "# exit code ";
    EXPECT_TRUE(line.starts_with(kProgram)) << line;
    const std::size_t exit = line.find(kExit);
    const int expected =
        exit == std::string::npos ? 0 : std::stoi(line.substr(exit + std::string(kExit).size()));
    const std::string command = line.substr(std::string(kProgram).size(), line.find('#'));
    const Ran ran = folder.shell("\"$0\" " + command);
    EXPECT_EQ(ran.exit_code, expected) << line << '\n' << ran.out << ran.err;
    return ran.out + ran.err;
}

TEST(Tutorial, OfTheFirstJobHasStepsThatRun) {
    const Folder folder;
    std::ifstream page(std::string(NCSIM_SOURCE_DIR) + "/docs/first-job.md");
    ASSERT_TRUE(page);
    std::string line, output;
    int commands = 0, expectations = 0;
    while (std::getline(page, line)) {
        if (!line.starts_with("```")) continue;
        std::istringstream info(line.substr(3));
        std::string language, name, mode, text;
        info >> language >> name >> mode;
        while (std::getline(page, line) && line != "```") {
            if (language == "sh") {
                output = output_of(folder, line);
                ++commands;
            } else if (language == "text") {
                EXPECT_TRUE(contains(output, line)) << line << '\n' << output;
                ++expectations;
            }
            text += line + '\n';
        }
        if (name.empty()) continue;
        folder.write(name, mode == "+" ? folder.read(name) + text : text);
    }
    EXPECT_EQ(commands, 6);
    EXPECT_GE(expectations, 7);
    EXPECT_TRUE(folder.has("slot.png"));
}

}  // namespace
}  // namespace ncsim::cli_test
