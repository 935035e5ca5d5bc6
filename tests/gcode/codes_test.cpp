// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each code (codes.txt), and each situation in which controls differ (traps.txt), as a line: the
// block and the resulting motions.
#include "control/codes.h"

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

enum class By : unsigned char { Default, Strict, Fanuc, Haas, Grbl, Unspecified };

struct Case {
    std::string what;
    By by = By::Default;
    std::string program;  // '~' is a line end
    std::string made;
};

// Runs the block between a start at the origin (metric, F100) and an end; returns the motions in
// order.
std::string made_of(const Case& c) {
    std::string text = std::string("G21 G90 G17 F100\nG0 X0 Y0 Z0\n") + c.program + "\nM2\n";
    std::ranges::replace(text, '~', '\n');
    InterpreterOptions options;
    options.strict = c.by == By::Strict;
    options.dialect = c.by == By::Fanuc  ? Dialect::Fanuc
                      : c.by == By::Haas ? Dialect::Haas
                      : c.by == By::Grbl ? Dialect::Grbl
                                         : Dialect::Rs274;
    options.limits.repeated_blocks = 20;
    options.limits.call_depth = 5;
    options.work_offsets[0].z = Length::from_mm(-300);  // home is above the part
    options.work_offsets_specified.fill(c.by != By::Unspecified);
    if (c.by == By::Unspecified) options.work_offsets.fill(options.work_offsets[0]);
    ToolTableEntry tool;
    tool.number = 1;
    tool.offset[2] = Length::from_mm(50);
    tool.diameter = Length::from_mm(4);
    options.tools = {tool};
    std::string out;
    std::size_t motions = 0;
    const Interpretation result = interpret({"t.nc", text}, options, [&](const Motion& motion) {
        if (++motions == 1) return;  // the start
        if (motions > 12) return;
        std::string line;
        print(line, motion);
        line.erase(0, line.find(' ') + 1);
        out.append(out.empty() ? "" : "; ").append(line);
    });
    std::vector<std::string> said;
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity != Severity::Note) {
            said.push_back((d.severity == Severity::Error ? "error " : "") + d.code);
        }
    }
    for (const std::string& s : said)
        out.append(" ! ").append(s);
    return out;
}

void expect_all(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
        SCOPED_TRACE(c.what + ": " + c.program);
        EXPECT_EQ(made_of(c), c.made);
    }
}

// Reads the cases of a file of this folder.
std::vector<Case> cases_of(const std::string& name) {
    const std::map<std::string, By> rules{
        {"default", By::Default}, {"strict", By::Strict}, {"fanuc", By::Fanuc},
        {"haas", By::Haas},       {"grbl", By::Grbl},     {"unspecified", By::Unspecified}};
    std::ifstream file(std::string(NCSIM_SOURCE_DIR) + "/tests/gcode/" + name);
    std::vector<Case> cases;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream columns(line);
        std::string by;
        Case c;
        std::getline(columns, c.what, '\t');
        std::getline(columns, by, '\t');
        std::getline(columns, c.program, '\t');
        std::getline(columns, c.made);
        if (c.made == "-") c.made.clear();
        c.by = rules.at(by);
        cases.push_back(c);
    }
    return cases;
}

TEST(Codes, DoWhatTheyDoOnAMachine) {
    const std::vector<Case> cases = cases_of("codes.txt");
    EXPECT_GE(cases.size(), 182u);
    expect_all(cases);
}

// Codes of a group that behave alike; a single case covers the group.
void expect_like_its_group(const std::string& name, Group group) {
    const std::string text = name + "~G1 X1";
    const std::string made = made_of({name, By::Default, text, ""});
    // G290 of SINUMERIK changes the language of the blocks behind it.
    const std::string moves =
        name == "G290" ? "feed X1 Y0 Z0 F100 ! language-switch" : "feed X1 Y0 Z0 F100";
    const std::set<std::string> expected =
        group == Group::Ignored        ? std::set<std::string>{moves}
        : group == Group::NotSimulated ? std::set<std::string>{moves + " ! error not-simulated"}
        : group == Group::Unsupported
            ? std::set<std::string>{" ! error tilted-plane", " ! error lathe-cycle",
                                    " ! error kinematics"}
            : std::set<std::string>{made};
    EXPECT_TRUE(expected.contains(made)) << made;
}

TEST(Codes, AreAllInTheTable) {
    std::set<std::string> tested;
    for (const Case& c : cases_of("codes.txt"))
        tested.insert(c.what);
    const auto expect_tested = [&](Code code) {
        const GCode& entry = entry_of(code);
        const std::string name(name_of(code));
        SCOPED_TRACE(name);
        EXPECT_EQ(entry.code, code);
        EXPECT_EQ(find_g(tenths_of(code)), code);
        std::string number = "G";
        print_number(number, tenths_of(code) / 10.0);
        EXPECT_EQ(name, number);
        if (entry.availability == Availability::Haas) return;  // below
        expect_like_its_group(name, entry.group);
        const bool alike = entry.group == Group::Ignored || entry.group == Group::NotSimulated ||
                           entry.group == Group::Unsupported;
        EXPECT_TRUE(alike || tested.contains(name)) << name << " is not";
    };
#define NCSIM_G(name, group, takes_axes, letters, availability) expect_tested(Code::name);
#include "control/codes.def"
#undef NCSIM_G
}

TEST(Codes, OfHaasAloneAreOffsets) {
    // G110 … G129 are G154 P1 …, without P3 and P4.
    int count = 0;
    for (int number = 110; number < 130; ++number) {
        const Code code = find_g(number * 10);
        if (entry_of(code).availability != Availability::Haas) continue;
        ++count;
        SCOPED_TRACE(name_of(code));
        const std::string name(name_of(code));
        const std::string set = "G10 L20 P" + std::to_string(number - 109) + " X5~";
        const std::string by_name = set + name + " G0 X1";
        const std::string by_number = set + "G154 P" + std::to_string(number - 109) + " G0 X1";
        EXPECT_EQ(made_of({"", By::Haas, by_name, ""}), made_of({"", By::Haas, by_number, ""}));
        EXPECT_EQ(made_of({"", By::Haas, by_name, ""}).find("unknown-g"), std::string::npos);
        EXPECT_EQ(made_of({"", By::Fanuc, name, ""}), " ! error unknown-g");
    }
    EXPECT_EQ(count, 18);
}

TEST(Traps, AreNotSteppedInto) {
    const std::vector<Case> cases = cases_of("traps.txt");
    EXPECT_GE(cases.size(), 198u);
    expect_all(cases);
}

}  // namespace
}  // namespace ncsim::gcode
