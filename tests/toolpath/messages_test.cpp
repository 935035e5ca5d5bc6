// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages about comments and tool files, word for word: each row of tool_messages.def.
#include "support/messages.h"

#include "ncsim/toolpath/tool_file.h"
#include "ncsim/toolpath/tool_table.h"

#include "tools/tool_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::toolpath {
namespace {

struct Case {
    bool is_program;  // false: a tool file
    std::string text;
    std::string said;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> kCases = {
        {true, "G21\n(T1 D=6. CR=0. - flat end mill)\n(T1 D=8. CR=0. - flat end mill)\nT1 M6\n",
         "tool-conflict: this comment says tool 1 has a diameter of 8 mm, but line 2 said 6 mm, "
         "which is used"},
        {true, "(STOCK/BLOCK,999999,999999,999999,0,0,0)\nG20\n",
         "stock-size: this comment describes a block without volume, or one larger than a "
         "kilometre; it is not used"},
        {false, "T1 P1 D6\nT1 P9 D8\n",
         "tool-conflict: tool 1 is described twice; the first one is used"},
        {false, "T6 P6 ;probe without a diameter\n",
         "tool-unknown: tool 6 has no diameter; it is left out"},
        {false, R"({"tools":{"5":{"units":"metric","shape":"spheroid","length":4,"diameter":10}}})",
         "tool-unknown: tool 5 has the shape 'spheroid', which is not known; it is left out"},
        {false, R"([{"number":7,"type":"lasso","flute_diam":6}])",
         "tool-unknown: tool 7 is of the type 'lasso', which is not known; it is left out"},
        {false,
         R"({"data":[{"type":"form mill","geometry":{"DC":8},"post-process":{"number":6}}]})",
         "tool-unknown: tool 6 is of the type 'form mill', which is not known; it is left out. A "
         "job file can describe it by its profile ([[tool.piece]])"},
        {false, "T1 P1 D6\nG0 X1\n",
         "tool-table: this is no line of a tool table: expected T and P, as in T1 P1 D10 ;end "
         "mill"},
        {false, "G0 X1\n",
         "tool-table: this is no tool table that is known: neither LinuxCNC's (T1 P1 D10 ;end "
         "mill) nor CSV with columns such as number and diameter nor JSON of CAMotics, Fusion or "
         "Kiri:Moto"},
        {false, "; nothing\n", "tool-table: this tool table is empty"},
        {false, "T,D\nfirst,6\n", "tool-unknown: 'FIRST' is no tool number; the line is left out"},
        {false, "T,D\n1,thick\n",
         "tool-unknown: tool 1 has the value 'thick', which is no number or no possible length; it "
         "is left out"},
        {false, "[1,", "tool-table: this JSON is broken here"},
        {false, "[1e9999]", "tool-table: a number in this JSON is beyond what a computer can hold"},
        {false, "[1,2]",
         "tool-table: this JSON is neither a CAMotics project nor a tool library of Fusion or "
         "Kiri:Moto"},
    };
    return kCases;
}

std::vector<std::string> said_of(const Case& c) {
    const gcode::SourceFile file{"a", c.text};
    std::vector<std::string> out;
    for (const gcode::Diagnostic& d :
         c.is_program ? read_notes(file).diagnostics : read_tool_file(file).diagnostics)
        out.push_back(test::said(d));
    return out;
}

TEST(Messages, AreSaidInTheseWords) {
    for (const Case& c : cases())
        EXPECT_EQ(said_of(c), std::vector<std::string>{c.said}) << c.text;
}

TEST(Messages, AreAllSaidHere) {
    constexpr gcode::MessageText kRows[] = {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) Message::name,
#include "tools/tool_messages.def"
#undef NCSIM_DIAGNOSTIC
    };
    for (const gcode::MessageText& row : kRows) {
        EXPECT_TRUE(std::ranges::any_of(cases(), [&](const Case& c) {
            return test::says(c.said, row);
        })) << row.text;
    }
}

}  // namespace
}  // namespace ncsim::toolpath
