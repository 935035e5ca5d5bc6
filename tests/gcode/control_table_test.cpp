// SPDX-License-Identifier: GPL-3.0-or-later
//
// docs/controls.md is the table of control_codes.def.
// NCSIM_UPDATE_GOLDENS=1 in the environment writes the page anew.
#include "ncsim/gcode/control_codes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace ncsim::gcode {
namespace {

struct Asked {
    char letter;
    double number;
    const char* what;
};
constexpr Asked kAsked[] = {
    {'G', 5, "G5"},       {'G', 10, "G10"}, {'G', 28, "G28"}, {'G', 31, "G31"},
    {'G', 38.2, "G38.2"}, {'G', 41, "G41"}, {'G', 43, "G43"}, {'G', 52, "G52"},
    {'G', 59.1, "G59.1"}, {'G', 65, "G65"}, {'G', 68, "G68"}, {'G', 73, "G73"},
    {'G', 76, "G76"},     {'G', 81, "G81"}, {'G', 83, "G83"}, {'G', 84, "G84"},
    {'G', 93, "G93"},     {'G', 95, "G95"}, {'M', 1, "M1"},   {'M', 6, "M6"},
    {'M', 7, "M7"},       {'M', 19, "M19"}, {'M', 98, "M98"},
};

constexpr struct {
    std::uint32_t bit;
    const char* what;
} kFeatures[] = {
    {kVariables, "variables"},
    {kExpressions, "expressions"},
    {kOWords, "O-words"},
    {kMacroB, "Macro B"},
    {kArcsByRadius, "arcs by R"},
    {kCornerWords, ",R and ,C"},
    {kBlockDelete, "/ at line starts"},
    {kSkippedRest, "/ within lines"},
};

const char* mark_of(CodeSupport support) {
    switch (support) {
        case CodeSupport::Yes: return "yes";
        case CodeSupport::Option: return "option";
        case CodeSupport::No:
        case CodeSupport::Unknown: break;
    }
    return "–";
}

std::string or_dash(std::string_view text) {
    return std::string(text.empty() ? "–" : text);
}

std::string table() {
    std::string page;
    const auto controls = all_control_codes();
    page +=
        "# Codes of controls\n\n"
        "What `ncsim parse part.nc --for NAME` compares a program with. The tables are those of\n"
        "`lib/gcode/src/text/control_codes.def`; a test keeps this page current. Codes of options "
        "need a\n"
        "build option, a device, or an option of the maker.\n\n"
        "## Sources\n\n"
        "| name | control | axes | language | list | a code that it lacks | source |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const ControlCodes& control : controls) {
        std::string language;
        for (const auto& feature : kFeatures) {
            if ((control.features & feature.bit) == 0) continue;
            language += (language.empty() ? "" : "; ") + std::string(feature.what);
        }
        page += "| `" + std::string(control.name) + "` | " + std::string(control.title) + " | " +
                std::string(control.axes) + " | " + or_dash(language) + " | " +
                (control.is_complete ? "complete" : "may have gaps") + " | " +
                std::string(control.otherwise) + " | " + std::string(control.source) + " |\n";
    }
    page += "\n## Codes that programs use\n\n| code |";
    std::string line = "| --- |";
    for (const ControlCodes& control : controls) {
        page += " " + std::string(control.name) + " |";
        line += " --- |";
    }
    page += "\n" + line + "\n";
    for (const Asked& asked : kAsked) {
        page += "| " + std::string(asked.what) + " |";
        for (const ControlCodes& control : controls)
            page +=
                " " + std::string(mark_of(support_of(control, asked.letter, asked.number))) + " |";
        page += "\n";
    }
    page +=
        "\n## All codes\n\n| name | G | G of options | M | M of options |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const ControlCodes& control : controls) {
        page += "| `" + std::string(control.name) + "` | " + or_dash(control.g) + " | " +
                or_dash(control.optional_g) + " | " + or_dash(control.m) + " | " +
                or_dash(control.optional_m) + " |\n";
    }
    return page;
}

TEST(ControlTable, IsInTheDocumentation) {
    const std::string path = NCSIM_SOURCE_DIR "/docs/controls.md";
    const std::string page = table();
    if (std::getenv("NCSIM_UPDATE_GOLDENS")) std::ofstream(path, std::ios::binary) << page;
    std::ifstream file(path, std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), page);
}

}  // namespace
}  // namespace ncsim::gcode
