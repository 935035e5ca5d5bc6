// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool comments, over a labelled set of comments in the forms of real programs.
#include "ncsim/toolpath/tool_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace ncsim::toolpath {
namespace {

struct Labelled {
    std::string expected, unit, comment;
    int line = 0;
};

std::vector<Labelled> labelled_comments() {
    std::ifstream file(NCSIM_SOURCE_DIR "/tests/toolpath/tool_comments.tsv");
    std::vector<Labelled> all;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        const std::size_t unit = line.find('\t');
        if (line.empty() || line.front() == '#' || unit == std::string::npos) continue;
        const std::size_t comment = line.find('\t', unit + 1);
        all.push_back({line.substr(0, unit), line.substr(unit + 1, comment - unit - 1),
                       line.substr(comment + 1), number});
    }
    return all;
}

std::string rounded(double value) {
    std::string text = std::to_string(std::round(value * 1e4) / 1e4);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

const char* name_of_kind(const ToolSpec& spec) {
    static const std::map<ToolKind, const char*> kNames = {{ToolKind::FlatEndMill, "flat"},
                                                           {ToolKind::BallEndMill, "ball"},
                                                           {ToolKind::BullNoseEndMill, "bull"},
                                                           {ToolKind::FaceMill, "face"},
                                                           {ToolKind::VCutter, "v"},
                                                           {ToolKind::ChamferMill, "v"},
                                                           {ToolKind::Countersink, "v"},
                                                           {ToolKind::Drill, "drill"},
                                                           {ToolKind::TaperedEndMill, "taper"},
                                                           {ToolKind::SlotMill, "slot"},
                                                           {ToolKind::DovetailMill, "dovetail"},
                                                           {ToolKind::LollipopMill, "lollipop"},
                                                           {ToolKind::CornerRoundingMill, "corner"},
                                                           {ToolKind::Tap, "tap"},
                                                           {ToolKind::Reamer, "reamer"},
                                                           {ToolKind::BoringBar, "boring-bar"},
                                                           {ToolKind::ThreadMill, "thread"}};
    if (!spec.kind && spec.corner_radius.value_or(0.0) <= 0.0) return "any";
    const auto name = kNames.find(*filled(spec, 50).kind);
    return name == kNames.end() ? "other" : name->second;
}

// Returns the tool data of a program with this single comment.
std::string said_by(const Labelled& labelled) {
    std::string program = labelled.unit == "in" ? "G20\n;" : "G21\n;";
    program.append(labelled.comment).append("\nG0 X0\n");
    const ProgramNotes notes = read_notes({"test.nc", program});
    if (notes.tools.empty()) return "none";
    const ToolSpec& spec = notes.tools.front().spec;
    std::string text = "T";
    text.append(std::to_string(spec.number)).append(" ").append(name_of_kind(spec));
    const auto add = [&text](const char* name, const std::optional<double>& value) {
        if (value) text.append(" ").append(name).append(rounded(*value));
    };
    add("D", filled(spec, 50).diameter);
    add("R", spec.corner_radius);
    add("A", spec.angle);
    add("taper", spec.taper);
    add("P", spec.tip_diameter);
    add("L", spec.length);
    add("S", spec.shank_diameter);
    add("E", spec.stick_out);
    return text;
}

TEST(ToolComments, AreFoundAndNothingElseIs) {
    int tools = 0, others = 0;
    for (const Labelled& labelled : labelled_comments()) {
        ++(labelled.expected != "none" ? tools : others);
        EXPECT_EQ(said_by(labelled), labelled.expected)
            << "tool_comments.tsv:" << labelled.line << ": " << labelled.comment;
    }
    EXPECT_GE(tools, 350);
    EXPECT_GE(others, 200);
}

// A mark behind the last word says nothing, and is not read beyond the end.
TEST(ToolComments, EndWithAnyMark) {
    const Labelled plain{"", "mm", "T1 6MM END MILL", 0};
    EXPECT_EQ(said_by(plain), "T1 flat D6");
    for (const char mark : std::string("#-/|;,.:=")) {
        const Labelled marked{"", "mm", plain.comment + " " + mark, 0};
        EXPECT_EQ(said_by(marked), "T1 flat D6") << mark;
    }
}

}  // namespace
}  // namespace ncsim::toolpath
