// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim check: findings, exit codes and reports.
#include "cli/run_program.h"
#include "support/count.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::cli_test {
namespace {

// Returns kSlot with the slot cut at rapid.
std::string rapid_slot() {
    std::string text(kSlot);
    text.replace(text.find("G1 X30. F500."), 13, "G0 X30.");
    return text.replace(text.find("G0 Z5.\nM30"), 6, "G1 Z5. F500.");
}

TEST(Check, FindsNothingInAGoodProgramAndSaysWhatItCouldNotAsk) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran = folder.run({"check", "slot.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_TRUE(contains(ran.out, "slot.nc: clean: 0 errors, 0 warnings, 0 notes, 0 doubts\n"))
        << ran.out;
    EXPECT_TRUE(contains(ran.out, "skipped  over-travel: no travels are specified")) << ran.out;
    EXPECT_EQ(folder.files(), std::vector<std::string>{"slot.nc"});
}

TEST(Check, ShowsTheLineWithACaretAndFails) {
    Folder folder;
    folder.write("slot.nc", rapid_slot());
    const Ran ran = folder.run({"check", "slot.nc", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.out,
              "slot.nc:8:1: error: rapid move through material: removed 800 mm3 "
              "[rapid-in-material]\n"
              "  | G0 X30.\n"
              "  | ^~\n"
              "  at X-20 Y-2.4786 Z0, within 40 x 10 x 2 mm, X -20 to 20, Y -5 to 5, Z -2 to 0\n"
              "  assumed tool: length 30 mm\n"
              "  assumed path: rapid moves are straight (--rapid linear)\n"
              "  hint: Retract before the move, or make it at feed.\n");
    EXPECT_EQ(ran.err, "");
}

TEST(Check, SelectsIgnoresAndWeighsRules) {
    Folder folder;
    folder.write("slot.nc", rapid_slot());
    EXPECT_EQ(folder.run({"check", "slot.nc", "--ignore", "rapid-in-material"}).exit_code, 0);
    EXPECT_EQ(folder.run({"check", "slot.nc", "--ignore", "collision"}).exit_code, 0);
    EXPECT_EQ(folder.run({"check", "slot.nc", "--select", "travel,process"}).exit_code, 0);
    EXPECT_EQ(folder.run({"check", "slot.nc", "--select", "rapid-in-material"}).exit_code, 1);
    EXPECT_EQ(folder.run({"check", "slot.nc", "--exit-zero"}).exit_code, 0);
    const std::vector<std::string> warning{"check", "slot.nc", "--severity",
                                           "rapid-in-material=warning"};
    EXPECT_EQ(folder.run(warning).exit_code, 0);
    std::vector<std::string> strict = warning;
    strict.emplace_back("--warnings-as-errors");
    EXPECT_EQ(folder.run(strict).exit_code, 1);
}

TEST(Check, RefusesWhatMakesNoSense) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    for (const auto& more : std::vector<std::vector<std::string>>{{"--select", "rapids"},
                                                                  {"--severity", "no-feed=bad"},
                                                                  {"--rapid", "curved"},
                                                                  {"--machine", "none.toml"}}) {
        std::vector<std::string> arguments{"check", "slot.nc"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = folder.run(arguments);
        EXPECT_EQ(ran.exit_code, 2) << more.front();
        EXPECT_TRUE(contains(ran.err, more.back().substr(0, 4))) << ran.err;
    }
    EXPECT_EQ(folder.run({"check"}).exit_code, 2);
}

TEST(Check, ABrokenProgramHidesNoOther) {
    Folder folder;
    folder.write("bad.nc", rapid_slot());
    folder.write("good.nc", kSlot);
    folder.write("binary.nc", std::string("\x7f\0ELF", 5));
    const Ran ran = folder.run({"check", "bad.nc", "missing.nc", "binary.nc", "good.nc"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.out, "bad.nc:8:1: error")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "missing.nc: not verified: cannot read 'missing.nc'"));
    EXPECT_TRUE(contains(ran.out, "binary.nc: not verified: 'binary.nc' is not an NC program"));
    EXPECT_FALSE(contains(ran.out, "good.nc"));
    EXPECT_TRUE(contains(ran.out, "failed:\n  bad.nc: 1 error")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "4 programs: 1 clean, 0 not proven, 1 failed, 2 not verified\n"));
}

TEST(Check, SaysTheSameForAnyNumberOfJobs) {
    Folder folder;
    std::vector<std::string> arguments{"check"};
    for (int i = 0; i < 8; ++i) {
        const std::string name = std::to_string(i).append(".nc");
        folder.write(name, i % 3 == 0 ? rapid_slot() : std::string(kSlot));
        arguments.push_back(name);
    }
    arguments.insert(arguments.end(), {"--jobs", "1"});
    const Ran one = folder.run(arguments);
    arguments.back() = "3";
    const Ran three = folder.run(arguments);
    EXPECT_EQ(one.out, three.out);
    EXPECT_EQ(one.exit_code, 1);
}

TEST(Check, OfAProgramThatCannotBeSimulatedStillReadsIt) {
    Folder folder;
    folder.write("part.nc", "G21 G90\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1\nM30\n");
    const Ran ran = folder.run({"check", "part.nc"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out, "tool 7 is not described")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "[tool-undefined:tool-unknown]")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "part.nc:4:1: error: feed move without a feed")) << ran.out;
    EXPECT_TRUE(
        contains(ran.out, "skipped  rapid-in-material, non-cutting-contact, fixture-contact"));
}

TEST(Check, ReadsAMachine) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write(
        "machine.toml",
        "name = 'mill'\n[travel]\nx = [-25, 100]\n[position]\nwork_zero = [0, 0, 0]\n"
        "[feed]\nmax = 400\n[[fixture]]\nname = 'jaw'\nbox = [[-40, 4, -20], [40, 20, 9]]\n"
        "[[tool]]\nnumber = 1\nmax_depth = 1.5\n");
    const Ran ran = folder.run({"check", "slot.nc", "--machine", "machine.toml", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out, "X runs beyond its lower end at -25: by 5 mm")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "the machine's limit of 400 mm/min: feed 500 mm/min"));
    EXPECT_TRUE(contains(ran.out, "the cutter of T1 meets the fixture 'jaw'"));
    EXPECT_TRUE(contains(ran.out, "above the tool's limit of 1.5 mm: depth 2 mm")) << ran.out;
}

TEST(Check, LeadsG28AndG30WhereTheMachineSays) {
    // Through home over the jaw, then to the tool change position beyond the travel.
    Folder folder;
    const std::string head =
        "(T1 D=10. - flat end mill)\n(STOCK/BLOCK,40.,30.,10.,20.,15.,10.) (FROM/0,0,100)\n"
        "G21 G90 G17 T1 M6 S1000 M3 G0 X0 Y0 Z5\nG1 Z-1 F100\nG0 Z5\n";
    folder.write("home.nc", head + "G91 G28 Y0 Z0\nG90\nM30\n");
    folder.write("change.nc", head + "G91 G30 X0 Y0\nG90\nM30\n");
    const std::string machine =
        "[travel]\nx = [-400, 0]\ny = [-300, 0]\n[[fixture]]\nname = 'jaw'\n"
        "box = [[-40, 40, -20], [40, 60, 9]]\n[position]\nwork_zero = [-200, -150, -300]\n";
    folder.write("m.toml", machine);
    folder.write("told.toml",
                 machine + "home = [0, -100, -297]\ntool_change = [-401.5, -150, 0]\n");
    const auto check = [&folder](const char* program, const char* file) {
        return folder
            .run({"check", program, "--machine", file, "-q", "--select", "collision,travel",
                  "--rapid", "linear"})
            .out;
    };
    EXPECT_EQ(check("home.nc", "m.toml"), "") << "machine zero, up and away";
    EXPECT_TRUE(contains(check("home.nc", "told.toml"),
                         "home.nc:6:1: error: the cutter of T1 meets the fixture 'jaw'"))
        << check("home.nc", "told.toml");
    EXPECT_EQ(check("change.nc", "m.toml"), "");
    EXPECT_TRUE(contains(check("change.nc", "told.toml"),
                         "change.nc:6:1: error: X runs beyond its lower end at -400: by 1.5 mm"))
        << check("change.nc", "told.toml");
}

TEST(Check, ReadsFixturesAsMeshes) {
    // A part made by ncsim is the fixture: the block with the slot, next to the new block.
    Folder folder;
    folder.write("slot.nc", kSlot);
    ASSERT_EQ(folder.run({"run", "slot.nc", "-q", "--stl", "jaw.stl"}).exit_code, 0);
    folder.write("m.toml", "[[fixture]]\nname = 'jaw'\nstl = 'jaw.stl'\n");
    // The tool path through the slot of the fixture only touches the walls; half a millimetre
    // deeper it cuts.
    const Ran clear = folder.run({"check", "slot.nc", "--machine", "m.toml", "-q"});
    EXPECT_EQ(clear.exit_code, 0) << clear.out << clear.err;
    std::string deeper(kSlot);
    deeper.replace(deeper.find("G0 Z-2."), 7, "G0 Z-2.5");
    folder.write("deeper.nc", deeper);
    const Ran ran = folder.run({"check", "deeper.nc", "--machine", "m.toml", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out, "deeper.nc:8:1: error: the cutter of T1 meets the fixture 'jaw'"))
        << ran.out << ran.err;
    folder.write("jaw.stl", "solid nothing\nendsolid\n");
    const Ran broken = folder.run({"check", "slot.nc", "--machine", "m.toml"});
    EXPECT_EQ(broken.exit_code, 2);
    EXPECT_TRUE(
        contains(broken.err, "'jaw.stl': it is neither STL, OBJ, VRML97, binary glTF nor STEP"))
        << broken.err;
}

// Returns kSlot with a slot of the given depth.
std::string slot_at(const std::string& depth) {
    std::string text(kSlot);
    return text.replace(text.find("G0 Z-2."), 7, "G0 Z" + depth);
}

TEST(Check, ComparesThePartWithItsDesign) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("deeper.nc", slot_at("-2.1"));
    for (const char* design : {"design.stl", "design.glb"}) {
        const char* option = std::string(design).ends_with("stl") ? "--stl" : "--gltf";
        ASSERT_EQ(folder.run({"run", "slot.nc", "-q", option, design}).exit_code, 0);
        const Ran same = folder.run({"check", "slot.nc", "--design", design});
        EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
        EXPECT_TRUE(contains(same.out, "within 0.1 mm: nothing beyond; farthest apart "))
            << same.out;
        const Ran ran = folder.run(
            {"check", "deeper.nc", "--design", design, "--design-tol", "0.02", "--json", "a.json"});
        EXPECT_EQ(ran.exit_code, 1);
        EXPECT_TRUE(contains(ran.out,
                             "deeper.nc:8:1: error: the part is cut into the design: depth 0.1 mm "
                             "[gouge]\n  | G1 X30. F500.\n  | ^~\n  at X"))
            << ran.out;
        EXPECT_TRUE(contains(ran.out,
                             ", within 40 x 10 x 0.1 mm, X -20 to 20, Y -5 to 5, Z -2.1 to -2\n"
                             "  assumed design: 'design."))
            << ran.out;
        EXPECT_TRUE(contains(ran.out, "gouged in 1 place, up to 0.1 mm, 40 mm3 in all")) << ran.out;
        EXPECT_TRUE(contains(folder.read("a.json"), "\"design\": {\n    \"file\": \"design."));
        // The deviation of the circle from its polygon can explain the missing material.
        const Ran near =
            folder.run({"check", "deeper.nc", "--design", design, "--design-tol", "0.06", "-q"});
        EXPECT_EQ(near.exit_code, 4) << near.out;
        EXPECT_TRUE(
            contains(near.out, "doubt: the part is cut into the design [uncertain-contact]"))
            << near.out;
        EXPECT_TRUE(contains(near.out,
                             "warning: the part is cut into the design: depth 0.1 mm, "
                             "not certain: within the accuracy of the tool [gouge]"))
            << near.out;
    }
}

// If a circle and a slot touch, the wall between them ends in a sharp edge. The polygon around
// the tool removes 0.05 mm from the sides of the edge and 0.7 mm from the end.
TEST(Check, SharpEdgesThatGoBackByTheErrorOfTheToolAreNotCertain) {
    Folder folder;
    const auto program = [](const std::string& last) {
        return "(T1 D=10. - flat end mill)\n(STOCK/BLOCK,100.,70.,10.,0.,0.,10.)\n"
               "G21 G90 G17 G54 G94\nT1 M6 S5000 M3\nG0 X50. Y35. Z5.\nG1 Z-4. F500.\n"
               "G3 X50. Y35. I12.5 J0\nG0 Z5.\nG0 X85. Y-10.\nG1 Z-4.\nG1 Y80.\n" +
               last + "G0 Z5.\nM30\n";
    };
    folder.write("part.nc", program(""));
    folder.write("wider.nc", program("G1 X84.8\nG1 Y-10.\n"));
    ASSERT_EQ(folder.run({"run", "part.nc", "-q", "--tool-tolerance", "0.001", "--stl", "part.stl"})
                  .exit_code,
              0);
    const Ran ran = folder.run({"check", "part.nc", "--design", "part.stl", "-q"});
    EXPECT_EQ(ran.exit_code, 4) << ran.out;
    EXPECT_TRUE(contains(ran.out, "warning: the part is cut into the design, around here by lines"))
        << ran.out;
    EXPECT_TRUE(contains(ran.out, "not certain: within the accuracy of the tool [gouge]"))
        << ran.out;
    EXPECT_EQ(folder.run({"check", "wider.nc", "--design", "part.stl", "-q"}).exit_code, 1);
}

// A straight path in short moves, with a bridge in the design between the ends. The findings name
// the lines that cut the bridge, although a run without a design merges several lines.
TEST(Check, NamesTheLinesOfAStraightWayThatCutIntoTheDesign) {
    Folder folder;
    const std::string head =
        "(T1 D=4. - flat end mill)\n(STOCK/BLOCK,80.,40.,10.,40.,20.,10.) (FROM/0,0,100)\n"
        "G21 G90 G17 T1 M6 S1000 M3 F500\nG0 X-50. Y0. Z5.\nG0 Z-2.\n";
    folder.write("right.nc", head + "G1 X0.\nG0 Z5.\nG0 X50.\nG0 Z-2.\nG1 X12.\nG0 Z5.\nM30\n");
    std::string through = head;
    for (int x = -49; x <= 50; ++x)
        through += "G1 X" + std::to_string(x) + ".\n";  // line 55 moves to X0
    folder.write("through.nc", through + "G0 Z5.\nM30\n");
    ASSERT_EQ(folder.run({"run", "right.nc", "-q", "--stl", "design.stl"}).exit_code, 0);
    const Ran ran = folder.run({"check", "through.nc", "--design", "design.stl"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out, "cut into the design, around here by lines 55-66: depth 2 mm"))
        << ran.out;
}

TEST(Check, TellsWhatIsLeftBeyondTheDesign) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("deeper.nc", slot_at("-2.1"));
    ASSERT_EQ(folder.run({"run", "deeper.nc", "-q", "--stl", "design.stl"}).exit_code, 0);
    const Ran ran =
        folder.run({"check", "slot.nc", "--design", "design.stl", "--design-tol", "0.05"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_TRUE(contains(ran.out,
                         "slot.nc:8:1: error: material is left that the design does not have, "
                         "adjacent to the cut of lines 8: thickness "))
        << ran.out;
    const Ran kept =
        folder.run({"check", "slot.nc", "--design", "design.stl", "--design-tol", "0.11"});
    EXPECT_FALSE(contains(kept.out, "[excess]")) << kept.out;
    const Ran none = folder.run({"check", "slot.nc"});
    EXPECT_TRUE(contains(none.out, "skipped  gouge, excess: no design is given (--design)"))
        << none.out;
}

TEST(Check, RefusesDesignsThatAreNoBodies) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\n";
    const std::vector<std::pair<std::string, std::string>> faults{
        {"nonsense", "'d': it is neither STL, OBJ, VRML97, binary glTF nor STEP"},
        {"solid s\n" + facet + "endsolid\n", "'d': its surface is not closed (3 open edges)"},
        {"glTF nonsense", "'d': "},
        {"solid s\nvertex 0 0 nan vertex 0 0 0 vertex 1 0 0", "'d': it has a corner"}};
    for (const auto& [text, message] : faults) {
        folder.write("d", text);
        const Ran ran = folder.run({"check", "slot.nc", "--design", "d"});
        EXPECT_EQ(ran.exit_code, 2) << text;
        EXPECT_TRUE(contains(ran.err, message)) << ran.err;
        EXPECT_EQ(ran.out, "");
    }
    EXPECT_EQ(folder.run({"check", "slot.nc", "--design", "none.stl"}).exit_code, 2);
    EXPECT_EQ(folder.run({"check", "slot.nc", "--design", "d", "--design-tol", "0"}).exit_code, 2);
}

TEST(Check, NamesThePlaceOfAFaultInTheMachine) {
    const std::vector<std::pair<std::string, std::string>> faults{
        {"[travel]\nx = [3, 1]\n", "m.toml:2:5: 'travel.x': the first end"},
        {"[travel]\nq = 1\n", "m.toml:2:5: 'q' is not known in travel; expected a, b, c, x, y, z"},
        {"[spindle]\nmax = 'fast'\n", "m.toml:2:7: 'spindle.max': expected a number"},
        {"travel = [\n", "m.toml:1:12: "},
        {"[[fixture]]\nname = 'jaw'\n", "a fixture needs a box or a mesh"},
        {"[[tool]]\nmax_feed = 3\n", "a tool needs its number"}};
    for (const auto& [text, message] : faults) {
        Folder folder;
        folder.write("slot.nc", kSlot);
        folder.write("m.toml", text);
        const Ran ran = folder.run({"check", "slot.nc", "--machine", "m.toml"});
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_TRUE(contains(ran.err, message)) << ran.err;
    }
}

TEST(Check, WritesJUnitWithACaseARule) {
    Folder folder;
    folder.write("slot.nc", rapid_slot());
    const Ran ran = folder.run({"check", "slot.nc", "missing.nc", "--junit", "a.xml", "-q"});
    EXPECT_EQ(ran.exit_code, 2);
    const std::string xml = folder.read("a.xml");
    EXPECT_TRUE(contains(xml, "<testsuite name=\"slot.nc\"")) << xml;
    EXPECT_EQ(ncsim::test::count(xml, "<testcase "),
              ncsim::test::count(folder.run({"rules", "--json"}).out, "\"category\"") + 2)
        << "a case a rule, one for all doubts, one for the program that is missing";
    EXPECT_EQ(ncsim::test::count(xml, "<failure "), 1U);
    EXPECT_TRUE(contains(xml, "type=\"rapid-in-material\">slot.nc:8:1: error: rapid move"));
    EXPECT_TRUE(contains(xml, "<skipped message=\"no fixtures are specified\"/>"));
    EXPECT_TRUE(contains(xml, "<error message=\"cannot read 'missing.nc'"));
    const std::string checked = "xmllint --noout '" + (folder.path() / "a.xml").string() + "'";
    EXPECT_EQ(std::system(checked.c_str()), 0) << "well-formed";
}

TEST(Check, WritesALedgerThatAddsUp) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    EXPECT_EQ(folder.run({"check", "slot.nc", "--csv", "a.csv", "--json", "a.json"}).exit_code, 0);
    const std::string csv = folder.read("a.csv");
    EXPECT_EQ(csv.substr(0, 13), "program,file,");
    EXPECT_TRUE(contains(csv, "\nslot.nc,slot.nc,8,4,4,1,feed,60,800,7.2,6666.66")) << csv;
    const std::string json = folder.read("a.json");
    EXPECT_TRUE(contains(json, "\"rest_mm3\": 11200.0")) << json;
    EXPECT_TRUE(contains(json, "\"removed_mm3\": 800.0"));
}

// Names in comments divide a ledger and its page; a name is a field of its own.
TEST(Check, WritesOperationsOfALedger) {
    Folder folder;
    folder.write("part.nc",
                 "G21 G90 G17\n(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,60,40,20,0,0,20)\n"
                 "T1 M6\nS5000 M3\n(FACING, \"TOP\")\nG0 X-10 Y10 Z5\nG1 Z-1 F500\nG1 X70\nG0 Z5\n"
                 "(POCKET <1>)\nG0 X30 Y20\nG1 Z-5\nG1 X40\nG0 Z20\nM30\n");
    folder.run({"check", "part.nc", "--csv", "a.csv", "--html", "a.html"});
    const std::string csv = folder.read("a.csv");
    EXPECT_TRUE(contains(csv, "contact_max_z,operation\n")) << csv;
    EXPECT_TRUE(contains(csv,
                         "part.nc,part.nc,9,4,4,1,feed,80,600,9.6,3750,0,5,-1,60,15,0,"
                         "\"FACING, \"\"TOP\"\"\"\n"))
        << csv;
    EXPECT_TRUE(contains(csv,
                         "part.nc,part.nc,14,8,8,1,feed,10,500,1.2,25000,25,15,-5,45,25,0,"
                         "POCKET <1>\n"))
        << csv;
    const std::string page = folder.read("a.html");
    EXPECT_TRUE(contains(page,
                         "<tr><td>6</td><td>FACING, &quot;TOP&quot;</td><td>T1</td>"
                         "<td>86 mm</td><td>0:00:10</td><td>600 mm³</td></tr>"))
        << page.substr(page.find("<h2>Ledger"), 20000);
    EXPECT_TRUE(contains(page,
                         "<td>POCKET &lt;1&gt;</td><td>T1</td><td>20 mm</td>"
                         "<td>0:00:02</td><td>894.958 mm³</td></tr>"));
}

TEST(Check, KeepsTheBooksOfABar) {
    // The stock is the polygon around the circle, not the bounding box of the polygon.
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.run({"check", "slot.nc", "--stock", "D40x10", "--csv", "a.csv", "--json", "a.json"});
    const auto ledger = nlohmann::json::parse(folder.read("a.json"))["programs"][0]["ledger"];
    const double stock = ledger["stock_mm3"];
    EXPECT_GT(stock, 3.14159 * 400 * 10);
    EXPECT_LT(stock, 3.16 * 400 * 10);
    EXPECT_NEAR(ledger["rest_mm3"].get<double>() + ledger["removed_mm3"].get<double>(), stock,
                1e-5);
}

TEST(Check, AnnotatesForGitHub) {
    Folder folder;
    folder.write("100%, a:b.nc", rapid_slot());
    const Ran ran = folder.run({"check", "100%, a:b.nc", "--github", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out,
                         "::error file=100%25%2C a%3Ab.nc,line=8,col=1,title=rapid-in-material::"
                         "rapid move through material: removed 800 mm3%0Aassumed tool"))
        << ran.out;
}

TEST(Check, MakesTheSamePageForAnyNumberOfThreads) {
    Folder folder;
    folder.write("slot.nc", rapid_slot());
    EXPECT_EQ(folder.run({"check", "slot.nc", "--html", "a.html", "--threads", "1"}).exit_code, 1);
    folder.run({"check", "slot.nc", "--html", "b.html", "--threads", "3"});
    const std::string page = folder.read("a.html");
    EXPECT_EQ(page, folder.read("b.html"));
    EXPECT_EQ(page.substr(0, 15), "<!DOCTYPE html>");
    EXPECT_TRUE(contains(page, "rapid move through material: removed 800 mm3"));
    EXPECT_EQ(folder.run({"check", "none.nc", "--html", "c.html"}).exit_code, 2);
    EXPECT_TRUE(contains(folder.read("c.html"), "not verified: cannot read"));
}

TEST(Check, FindsTheBlockThatCutsAPieceFree) {
    // Slots through the block on the sides of a square of 10 mm; the last side, line 10, detaches
    // the square.
    Folder folder;
    const std::string ring =
        "(T1 D=4. - flat end mill)\n(STOCK/BLOCK,40.,40.,5.,20.,20.,5.) (FROM/0,0,100)\n"
        "G21 G90 G17 T1 M6 S1000 M3 F500\nG0 X-7. Y-7. Z5.\nG1 Z-5.\nG1 X7.\nG1 Y7.\nG1 X-7.\n"
        "G1 Y0.\nG1 Y-6.\nG1 Y-7.\nG0 Z5.\nM30\n";
    folder.write("ring.nc", ring);
    const Ran ran = folder.run({"check", "ring.nc", "--cut-free"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out,
                         "ring.nc:10:1: error: a piece of the part is cut free: left of it at the "
                         "end 500 mm3 [part-cut-free]"))
        << ran.out;
    // A deeper pass removes the same walls; the earlier pass detaches the piece.
    std::string again = ring;
    again.insert(again.find("G0 Z5.\nM30"), "G1 Z-5.5\nG1 X7.\nG1 Y7.\nG1 X-7.\nG1 Y-7.\n");
    folder.write("again.nc", again);
    EXPECT_TRUE(contains(folder.run({"check", "again.nc", "--cut-free"}).out,
                         "again.nc:10:1: error: a piece of the part is cut free"));
    // With a skin of 0.1 mm left the piece stays attached.
    std::string skin = ring;
    skin.replace(skin.find("Z-5.\n"), 4, "Z-4.9");
    folder.write("skin.nc", skin);
    EXPECT_FALSE(contains(folder.run({"check", "skin.nc", "--cut-free"}).out, "part-cut-free]"));
    EXPECT_TRUE(
        contains(folder.run({"check", "ring.nc"}).out, "skipped  part-cut-free: pieces are"));
}

TEST(Check, NeverOverwritesAProgram) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    for (const char* output : {"slot.nc", "./slot.nc"}) {
        const Ran ran = folder.run({"check", "slot.nc", "--json", output});
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_TRUE(contains(ran.err, "is read, too")) << ran.err;
    }
    EXPECT_EQ(folder.read("slot.nc"), kSlot);
}

TEST(Check, OfAFolderWithAProjectNeedsNoName) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran bare = folder.run({"check"});
    EXPECT_EQ(bare.exit_code, 2);
    EXPECT_TRUE(contains(bare.err, "the folder has no ncsim.toml")) << bare.err;
    folder.write("ncsim.toml", "version = 1\n");
    const Ran ran = folder.run({"check"});
    EXPECT_TRUE(contains(ran.out, "slot.nc")) << ran.out << ran.err;
    EXPECT_EQ(ran.out, folder.run({"check", "."}).out);
}

TEST(Rules, AreExplainedOneByOne) {
    const Folder folder;
    const auto all = nlohmann::json::parse(folder.run({"rules", "--json"}).out);
    for (const char* list : {"rules", "reasons"}) {
        for (const auto& rule : all[list]) {
            const std::string id = rule["id"];
            const Ran ran = folder.run({"rules", id});
            EXPECT_EQ(ran.exit_code, 0) << id;
            EXPECT_TRUE(contains(ran.out, id + ": ")) << ran.out;
            EXPECT_TRUE(contains(ran.out, rule["why"])) << ran.out;
            EXPECT_TRUE(contains(ran.out, rule["fix"])) << ran.out;
        }
    }
    EXPECT_GT(test::count(folder.run({"rules", "collision"}).out, "of the category collision"), 2U);
    const Ran wrong = folder.run({"rules", "rapid-in-materal"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_TRUE(contains(wrong.err, "did you mean rapid-in-material?")) << wrong.err;
}

TEST(Rules, AreListedForPeopleAndForPrograms) {
    Folder folder;
    const Ran text = folder.run({"rules"});
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_TRUE(
        contains(text.out, "  rapid-in-material      error    Rapid moves that meet material.\n"));
    const Ran json = folder.run({"rules", "--json"});
    for (const auto& rule : nlohmann::json::parse(json.out)["rules"]) {
        const std::string what = rule["what"];
        EXPECT_TRUE(what.ends_with(".")) << rule["id"];
        EXPECT_LE(what.size(), 80U) << what;
        EXPECT_NE(what, rule["why"]) << rule["id"];
    }
    EXPECT_TRUE(contains(json.out, "\"id\": \"rapid-in-material\""));
}

}  // namespace
}  // namespace ncsim::cli_test
