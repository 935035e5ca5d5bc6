// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs as files. good/*.nc runs without an error and makes exactly the motions of the .motions
// file with the same name; NCSIM_UPDATE_GOLDENS=1 in the environment rewrites the .motions files.
// Each file in bad/ must be refused; the first line is a comment with the first expected error,
// word for word. A first line with "strict" selects strict rules.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace ncsim::gcode {
namespace {

namespace fs = std::filesystem;

const fs::path kDirectory = fs::path(NCSIM_SOURCE_DIR) / "tests/gcode";

std::string read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> programs(const char* directory) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kDirectory / directory)) {
        if (entry.path().extension() == ".nc") names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

/// Returns the motions of a program, one per line, followed by all diagnostics.
std::string motions_of(const SourceFile& file, const fs::path& directory) {
    InterpreterOptions options;
    const std::string head = first_line(file.text);
    options.strict = head.find("strict") != std::string::npos;
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Grbl, Dialect::Mach3}) {
        if (head.find("dialect: " + std::string(name_of(dialect))) != std::string::npos) {
            options.dialect = dialect;
        }
    }
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = false, .diameter = Length::from_mm(10.0)}};
    options.work_offsets_specified.fill(head.find("offsets: told") != std::string::npos);
    options.read_file = [&](std::string_view name) -> std::optional<SourceFile> {
        const fs::path path = directory / (std::string(name) + ".sub");
        if (!fs::exists(path)) return std::nullopt;
        return SourceFile{path.filename().string(), read_file(path)};
    };
    std::string out;
    const Interpretation result = interpret(file, options, [&](const Motion& motion) {
        print(out, motion);
        out += '\n';
    });
    for (const Diagnostic& d : result.diagnostics)
        out += "; " + render(d, SourceFile{file.name, ""});
    return out;
}

class GoodProgram : public testing::TestWithParam<std::string> {};

TEST_P(GoodProgram, MakesTheMotionsInTheFileBesideIt) {
    const fs::path directory = kDirectory / "good";
    const fs::path golden = directory / (GetParam() + ".motions");
    const SourceFile file{GetParam() + ".nc", read_file(directory / (GetParam() + ".nc"))};
    const std::string motions = motions_of(file, directory);
    EXPECT_EQ(motions.find(": error: "), std::string::npos) << motions;
    if (std::getenv("NCSIM_UPDATE_GOLDENS")) std::ofstream(golden, std::ios::binary) << motions;
    EXPECT_EQ(motions, read_file(golden));
}

INSTANTIATE_TEST_SUITE_P(Corpus, GoodProgram, testing::ValuesIn(programs("good")),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

class BadProgram : public testing::TestWithParam<std::string> {};

TEST_P(BadProgram, IsRefusedWithTheMessageInItsFirstLine) {
    const fs::path directory = kDirectory / "bad";
    const SourceFile file{"", read_file(directory / (GetParam() + ".nc"))};
    InterpreterOptions options;
    options.strict = first_line(file.text).find("strict: ") != std::string::npos;
    if (options.strict) {
        options.tools = {{.number = 1,
                          .offset = {},
                          .length_specified = false,
                          .diameter = Length::from_mm(10.0)}};
    }
    const Interpretation result = interpret(file, options, {});
    const auto error =
        std::ranges::find(result.diagnostics, Severity::Error, &Diagnostic::severity);
    ASSERT_NE(error, result.diagnostics.end());
    std::ostringstream expected;
    expected << (options.strict ? "; strict: " : "; ") << error->span.line << ':'
             << error->span.column << ": error: " << error->message << " [" << error->code << ']';
    EXPECT_EQ(first_line(file.text), expected.str());
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadProgram, testing::ValuesIn(programs("bad")),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

// A fault that the default rules report is a fault under strict rules, too.
TEST(Strict, IsNeverLaxerThanTheDefault) {
    for (const char* folder : {"good", "bad"}) {
        for (const std::string& name : programs(folder)) {
            const SourceFile file{"", read_file(kDirectory / folder / (name + ".nc"))};
            InterpreterOptions options;
            options.dialect = Dialect::Rs274;
            const bool fails = has_errors(interpret(file, options, {}).diagnostics);
            options.strict = true;
            EXPECT_TRUE(!fails || has_errors(interpret(file, options, {}).diagnostics)) << name;
        }
    }
}

}  // namespace
}  // namespace ncsim::gcode
