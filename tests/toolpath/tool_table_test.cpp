// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/tool_table.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::toolpath {
namespace {

ProgramNotes notes(const std::string& text) {
    return read_notes({"test.nc", text});
}

// Returns the known data of the tool, in a line, for a metric program with a single comment and a
// call of tool 1.
std::string tool_of(const std::string& comment) {
    const ProgramNotes n = notes(std::string("G21\n(").append(comment).append(")\nT1 M6\nG0 X0\n"));
    if (n.tools.empty()) return "nothing";
    const ToolSpec& spec = n.tools[0].spec;
    std::string line = "T";
    return line.append(std::to_string(spec.number))
        .append(" ")
        .append(describe(make_tool(spec, 50)));
}

TEST(ToolComments, OfAToolSurviveTheWayHomeBeforeItsCall) {
    for (const char* between : {"G28 G91 Z0.", "G53 G0 Z0", "G30 Z0", "G10 L2 P1 X0 Y0 Z0",
                                "G92 X0", "G52 X0 Y0", "G0 G49", "G0 Z50"}) {
        const ProgramNotes n =
            notes(std::string("G21\nT7 M6\nG0 X1 Y1\nG1 Z-1 F100\n(M6X1 TAP)\n") + between +
                  "\nT2 M6\nG0 X0\n");
        ASSERT_EQ(n.tools.size(), 1U) << between;
        EXPECT_EQ(n.tools[0].spec.number, 2) << between;
        EXPECT_EQ(n.tools[0].spec.pitch, 1.0);
    }
    // After a feed move the comment is about the tool in the spindle.
    const ProgramNotes n = notes("G21\nT7 M6\n(M6X1 TAP)\nG0 X1 Y1\nT2 M6\nG0 X0\n");
    ASSERT_EQ(n.tools.size(), 1U);
    EXPECT_EQ(n.tools[0].spec.number, 7);
}

// A title describes the work; a title with a number of a tool describes the tool.
TEST(ToolComments, InTheTitleOfAProgramNeedTheNumberOfATool) {
    for (const std::string head : {"O600", "O0600 ", ":600", "N1 O600"}) {
        for (const std::string title :
             {"(TAP M8)", "(THREAD MILL M20X1.5)", "(DRILL 6MM)", "(D=10)"})
            EXPECT_TRUE(notes(head + title + "\nG21\nT2 M6\nG0 X1\n").tools.empty())
                << head << title;
        const ProgramNotes n = notes(head + "(T3 D=8. - drill)\nG21\nT2 M6\nT3 M6\nG0 X1\n");
        ASSERT_EQ(n.tools.size(), 1U) << head;
        EXPECT_EQ(n.tools[0].spec.number, 3);
    }
    // The comment of the next line is about the tool.
    EXPECT_EQ(notes("O600\n(TAP M8)\nG21\nT2 M6\nG0 X1\n").tools.size(), 1U);
}

TEST(ToolComments, AreReadInAllTheirForms) {
    const std::pair<const char*, const char*> table[] = {
        {"T1 D=3.175 CR=0. - ZMIN=-4.2 - FLAT END MILL", "T1 flat end mill D3.175 L50"},
        {"T1  D=3 CR=0 - ZMIN=-10 - flat end mill", "T1 flat end mill D3 L50"},
        {"T3 D=1.5 CR=0.75 - ZMIN=-29.522 - BALL END MILL", "T3 ball end mill D1.5 L50"},
        {"T2 D=6 CR=0.5 - ZMIN=-1 - bull nose end mill", "T2 bull nose end mill D6 R0.5 L50"},
        {"T4 D=6. - drill", "T4 drill D6 L50"},
        {"T4 D=2.705 CR=0. TAPER=118deg - ZMIN=-9.144 - drill", "T4 drill D2.705 L50"},
        {"T3 D=6.35 CR=0. TAPER=45deg - ZMIN=-1.054 - chamfer mill", "T3 chamfer mill D6.35 L50"},
        {"T1 D=6 CR=0 - ZMIN=-35 - Schaftfr\xe4ser", "T1 flat end mill D6 L50"},
        {"T5 D=3. CR=0. - ZMIN=-2.5 - FRESA CON PUNTA PLANA", "T5 flat end mill D3 L50"},
        {"T7  End mill  D=0.25 SD=0.25 FL=1 BL=3 - flat end mill",
         "T7 flat end mill D0.25 L1, D0.25 to 3"},
        {"TOOL/MILL,3.17, 0.00, 0.00, 0.00", "T1 flat end mill D3.17 L50"},
        {"TOOL/MILL,6, 3, 20, 0", "T1 ball end mill D6 L20"},
        {"TOOL/DRILL,8,118,60", "T1 drill D8 L60"},
        {"TOOL/CHAMFER,10,90,20,2", "T1 chamfer mill D10 L20"},
        {"TOOL/CDRILL,2,118,3,6,60,30", "T1 v-cutter D6 L30"},
        {"@MKR|TOOL|number=7|name=End mill|type=Flat End|diameter=0.25|flutelength=1",
         "T7 flat end mill D0.25 L1"},
        {"@FC|TOOL|number=3|name=x|type=Chamfer|diameter=3.175|tipdiameter=0.1|cuttingedgeangle=90",
         "T3 v-cutter D3.175 L50"},
        {"T4 = End Mill {.75 inches}", "T4 flat end mill D19.05 L50"},
        {"1 = End Mill {6 mm}", "T1 flat end mill D6 L50"},
        {" T1 = End Mill 4 mm ", "T1 flat end mill D4 L50"},
        {"TOOL: V-BIT {90 DEG 0.5\"}", "T1 v-cutter D12.7 L50"},
        {"TOOL 1 - DIA 3.", "T1 flat end mill D3 L50"},
        {"1/16 FLAT ENDMILL TOOL - 1 DIA. OFF. - 1 LEN. - 1 DIA. - .0625",
         "T1 flat end mill D0.0625 L50"},
        {"T1 | 1/4 FLAT ENDMILL | H1 | D1 | TOOL DIA. - .25 ", "T1 flat end mill D0.25 L50"},
        {"T02 ID=002  DIA-0.5000                   1/2 ENDMILL", "T2 flat end mill D0.5 L50"},
        {"T17: 1/16\"drill", "T17 drill D1.5875 L50"},
        {"TOOL DIA. 4", "T1 flat end mill D4 L50"},
        {"Endmill Dia. 0.250", "T1 flat end mill D0.25 L50"},
        {"Tool 2mm dia.", "T1 flat end mill D2 L50"},
        {"60deg. 1/2\" V bit", "T1 v-cutter D12.7 L50"},
        {"Tool 8 = .250 Vee bit", "T8 v-cutter D0.25 L50"},
        {"Tool change - D = 2.0 mm  type BALL flutes 2", "T1 ball end mill D2 L50"},
        {"End mill 3mm", "T1 flat end mill D3 L50"},
        {"tool#=1 flute=6 len=20 unit=metric", "T1 flat end mill D6 L20"},
        {"tool#=2 flute=0.25 len=1 unit=imperial", "T2 flat end mill D6.35 L25.4"},
        {"DIAMETER: 6.0", "T1 flat end mill D6 L50"},
        {"Change tool: End mill 3mm", "T1 flat end mill D3 L50"},
        // Comments that do not describe a tool.
        {"", "nothing"},
        {"drill 4 holes", "nothing"},
        {"DRILL 6MM HOLES", "nothing"},
        {"Machining time about 00:00:08 hours", "nothing"},
        {"STOCK 100 x 50 mm", "nothing"},
        {"Tool change", "nothing"},
        {"tool.jetDiameter = 1.5", "nothing"},
        {"Tool Holder Diameter: 40", "nothing"},
        {"TIP RADIUS: 0.5", "nothing"},
        {"DIAMETER: about 6", "nothing"},
        {"tool#=1 flute=0", "nothing"},
        {"TOOL/MILL,0,0,0,0", "nothing"},
        {"TOOL/CRMILL,1,2,3,4,5", "T1 corner rounding mill D2 P1 R3 L5"},
        {"TOOL/CRMILL,4,10,3,12,3", "T1 corner rounding mill D10 P4 R3 L3"},
        {"TOOL/CRMILL,0.508,6.35,3.175,7.9375,3.175",
         "T1 corner rounding mill D6.35 P0.508 R3.175 L3.175"},
        {"TOOL/CRMILL,4,3,3,12,3", "nothing"},
        {"T7 CORNER ROUNDING END MILL D10 R3", "T7 corner rounding mill D10 P4 R3 L3"},
        {"T7 D=10. CR=3. - ZMIN=-3. - radius mill", "T7 corner rounding mill D10 P4 R3 L3"},
        {"T7 VIERTELKREISFRAESER D12 R4", "T7 corner rounding mill D12 P4 R4 L4"},
        {"T4 SENKER D12 90 GRAD", "T4 countersink D12 L50"},
        {"T4 CHAMFER MILL D10 TIP 2", "T4 chamfer mill D10 L50"},
    };
    for (const auto& [comment, expected] : table) {
        SCOPED_TRACE(comment);
        EXPECT_EQ(tool_of(comment), expected);
    }
}

TEST(ToolComments, InInchProgramsAreInches) {
    const ProgramNotes n = notes("(T1 D=0.25 CR=0. - ZMIN=-0.3 - FLAT END MILL)\nG20\nT1 M6\n");
    ASSERT_EQ(n.tools.size(), 1U);
    EXPECT_EQ(n.tools[0].spec.diameter, 6.35);
}

TEST(ToolComments, KeepTheirOwnUnitInAProgramOfTheOther) {
    const ProgramNotes n = notes("G21\n(T4 = End Mill {0.5 inches})\nT4 M6\n");
    EXPECT_EQ(n.tools.at(0).spec.diameter, 12.7);
}

// FreeCAD posts: the tool change is a comment, and the diameter is in mm in any program.
TEST(ToolComments, BelongToTheToolThatACommentCalls) {
    const ProgramNotes n =
        notes("G20\nG0 Z1\n( M6 T3 )\n(Compensated Tool Path. Diameter: 8.0)\nG0 X0\n");
    ASSERT_EQ(n.tools.size(), 1U);
    EXPECT_EQ(n.tools[0].spec.number, 3);
    EXPECT_EQ(n.tools[0].spec.diameter, 8.0);
}

TEST(ToolComments, WithoutANumberBelongToTheNextToolBeforeAnyMove) {
    const ProgramNotes n = notes("G21\n(End mill 3mm)\nT7 M6\nG0 X0\n(Ball end mill 4mm)\nT8 M6\n");
    ASSERT_EQ(n.tools.size(), 2U);
    EXPECT_EQ(n.tools[0].spec.number, 7);
    EXPECT_EQ(n.tools[1].spec.number, 8);
}

TEST(ToolComments, WithoutANumberAfterACallBelongToTheToolInTheSpindle) {
    const ProgramNotes n = notes("G21\nT7 M6\n(End mill 3mm)\nG0 X0\nT8 M6\n");
    ASSERT_EQ(n.tools.size(), 1U);
    EXPECT_EQ(n.tools[0].spec.number, 7);
}

TEST(ToolComments, InAProgramThatCallsNoToolSpeakOfToolZero) {
    const ProgramNotes n = notes("G21\n(End mill 3mm)\nG0 X0\n");
    ASSERT_EQ(n.tools.size(), 1U);
    EXPECT_EQ(n.tools[0].spec.number, 0);
}

TEST(ToolComments, OnTheLineOfTheCallBelongToIt) {
    EXPECT_EQ(notes("G21\nM6 T7(TOOL DIA. 4)\n").tools.at(0).spec.number, 7);
}

TEST(ToolComments, AStatedDiameterBeatsASizeInAName) {
    const ProgramNotes n =
        notes("G21\n(T1 = 6 mm end mill)\n(T1 D=5.9 CR=0. - flat end mill)\nT1 M6\n");
    ASSERT_EQ(n.tools.size(), 1U);
    EXPECT_EQ(n.tools[0].spec.diameter, 5.9);
    EXPECT_TRUE(n.diagnostics.empty());
}

TEST(ToolComments, ThatContradictEachOtherAreReportedAndTheFirstIsUsed) {
    const ProgramNotes n =
        notes("G21\n(T1 D=6. CR=0. - flat end mill)\n(T1 D=8. CR=0. - flat end mill)\nT1 M6\n");
    EXPECT_EQ(n.tools.at(0).spec.diameter, 6);
    ASSERT_EQ(n.diagnostics.size(), 1U);
    EXPECT_EQ(n.diagnostics[0].code, "tool-conflict");
    EXPECT_EQ(n.diagnostics[0].span.line, 3U);
}

TEST(ToolComments, RememberWhereTheyStand) {
    const ProgramNotes n = notes("%\nN10 G21 (T1 D=6. CR=0. - flat end mill)\nT1 M6\n");
    EXPECT_EQ(n.tools.at(0).span.line, 2U);
    EXPECT_EQ(n.tools.at(0).span.column, 9U);
    EXPECT_EQ(n.tools.at(0).text, "T1 D=6. CR=0. - flat end mill");
}

TEST(ToolComments, OfPowerMillTellOneThingEach) {
    const ProgramNotes n = notes(
        "G21\n(Tool Number: 3)\n(TOOL TYPE: Tip Radiused)\n(DIAMETER: 10.0)\n(TIP RADIUS: 1.5)\n"
        "T3 M6\nG0 X0\n(DIAMETER: 6.0)\n(TIP RADIUS: 3.0)\nT4 M6\nG0 X0\n");
    ASSERT_EQ(n.tools.size(), 2U);
    EXPECT_EQ(n.tools[0].spec.number, 3);
    EXPECT_EQ(describe(make_tool(n.tools[0].spec, 50)), "bull nose end mill D10 R1.5 L50");
    EXPECT_EQ(n.tools[1].spec.number, 4);
    EXPECT_EQ(describe(make_tool(n.tools[1].spec, 50)), "ball end mill D6 L50");
}

TEST(ToolComments, OfPyCamTellOneThingEach) {
    const auto tool = [](const char* shape) {
        const ProgramNotes n = notes(std::string(";torus_radius = 0.5\n;speed = 900.0\n;shape = ")
                                         .append(shape)
                                         .append("\n;tool_radius = 3.0\nG21\nG0 X0\n"));
        return n.tools.empty() ? "nothing" : describe(make_tool(n.tools[0].spec, 50));
    };
    EXPECT_EQ(tool("CylindricalCutter"), "flat end mill D6 L50");
    EXPECT_EQ(tool("SphericalCutter"), "ball end mill D6 L50");
    EXPECT_EQ(tool("ToroidalCutter"), "bull nose end mill D6 R0.5 L50");
}

TEST(ToolComments, OfEngraversTellAngleAndTip) {
    const ProgramNotes n = notes("G21\n(\"30degree0.2mm\")\nT1 M6\n");
    ASSERT_EQ(n.tools.size(), 1U);
    const ToolSpec& spec = n.tools[0].spec;
    EXPECT_FALSE(spec.diameter);
    EXPECT_EQ(spec.tip_diameter, 0.2);
    EXPECT_EQ(filled(spec, 30).diameter, 3.175);
    EXPECT_EQ(assumed_values_text(spec, 30), "diameter 3.175 mm, length 30 mm");
    EXPECT_TRUE(guesses_shape(spec));
}

TEST(ToolComments, OfEstlcamsListAreInTheOrderOfTheCalls) {
    const char* list = "(Required tools:)\n(End mill 3mm)\n(Ball nose 6mm)\n\n";
    const ProgramNotes n = notes(std::string("G21\n") + list + "T5 M6\nG0 X0\nT6 M6\nG0 X0\n");
    ASSERT_EQ(n.tools.size(), 2U);
    EXPECT_EQ(n.tools[0].spec.number, 5);
    EXPECT_EQ(n.tools[0].spec.diameter, 3);
    EXPECT_EQ(n.tools[1].spec.number, 6);
    EXPECT_EQ(n.tools[1].spec.kind, ToolKind::BallEndMill);
    // The comment of the tool change has priority over the list. A program without tool calls has a
    // single tool.
    const ProgramNotes said =
        notes(std::string("G21\n") + list + "T5 M06 (Change tool: Drill 2mm)\nG0 X0\n");
    EXPECT_EQ(said.tools.at(0).spec.diameter, 2);
    const ProgramNotes one = notes("G21\n(Required tools:)\n(End mill 3mm)\nG0 X0\n");
    EXPECT_EQ(one.tools.at(0).spec.number, 0);
}

TEST(StockComments, OfVectricAreASizeAndAPlace) {
    const std::string size = "( Material Size)\n( X= 80.000, Y= 40.000, Z= 10.000)\nG21\n";
    const ProgramNotes corner = notes(size);
    ASSERT_TRUE(corner.stock);
    EXPECT_EQ(corner.stock->box.min, (Vec3{0, 0, -10}));
    EXPECT_EQ(corner.stock->box.max, (Vec3{80, 40, 0}));
    EXPECT_EQ(corner.stock->span.line, 2U);
    const ProgramNotes centre = notes(size +
                                      "( Z Origin for Material = Table Surface)\n"
                                      "( XY Origin for Material = Center)\n");
    EXPECT_EQ(centre.stock->box.min, (Vec3{-40, -20, 0}));
    EXPECT_EQ(centre.stock->box.max, (Vec3{40, 20, 10}));
    const ProgramNotes right = notes(size + "( XY Origin for Material = Top Right Corner)\n");
    EXPECT_EQ(right.stock->box.min, (Vec3{-80, -40, -10}));
    EXPECT_FALSE(notes("( Material Size)\n( soft wood)\n( X= 80, Y= 40, Z= 10)\n").stock);
    EXPECT_FALSE(notes("( X= 80, Y= 40, Z= 10)\n").stock) << "extents of something";
}

TEST(StockComments, OfSimulatorsAndPostsAreRead) {
    const Box block{{0, 0, -10}, {80, 40, 0}};
    const auto box = [](const char* text) {
        const auto stock = notes(text).stock;
        return stock ? stock->box : Box{};
    };
    EXPECT_EQ(box("($SetPartSize(80,40,10,1))\nG21\n"), block);
    EXPECT_EQ(box("$SetPartSize(80,40,0)\n"), Box{});
    EXPECT_EQ(box("(BLK FORM 0.1 Z X+0 Y+0 Z-10)\n(BLK FORM 0.2 X+80 Y+40 Z+0)\nG21\n"), block);
    EXPECT_EQ(box("(BLK FORM 0.2 X+80 Y+40 Z+0)\nG21\n"), Box{});
    EXPECT_EQ(box("( X Min = 0.000   Y Min = 0.000  Z Min = -10.000)\n"
                  "( X Max = 80.000   Y Max = 40.000  Z Max = 0.000)\nG21\n"),
              block);
    EXPECT_EQ(box("; Material Size: X80.0 Y40.0 Z10.0\n; Material Origin: X0.0 Y0.0 Z0.0\nG21\n"),
              block);
    // The position of the material relative to the zero is unknown here.
    EXPECT_EQ(box("; Material Size: X80 Y40 Z10\n; Material Origin: X5 Y0 Z0\nG21\n"), Box{});
    // Extents of a tool path.
    EXPECT_EQ(box("(X Min: 0 - X Max: 80)\n(Y Min: 0 - Y Max: 40)\n(Z Min: -10 - Z Max: 0)\n"),
              Box{});
}

TEST(StockComments, OfPeopleAreThreeLengthsBehindAName) {
    const auto size = [](const std::string& text) {
        const auto stock = notes(text + "\nG21\n").stock;
        return stock ? stock->box.size() : Vec3{};
    };
    const Vec3 block{100, 50, 10};
    for (const char* text :
         {"(STOCK 100x50x10)", "(Stock: 100 x 50 x 10 mm)",
          "; Stock Size: 100(X) * 50(Y) * 10(Z) mm", "(RAW STOCK = 100MM X 50MM X 10MM ALUMINIUM)",
          "(blank 100*50*10)", "(Rohteil 100x50x10)", "[Workpiece size 100 x 50 x 10]",
          "(BLOCK 100mmx50mmx10mm)"}) {
        EXPECT_EQ(size(text), block) << text;
    }
    EXPECT_EQ(size("(STOCK 4in x 2in x 1/2in)"), (Vec3{101.6, 50.8, 12.7}));
    EXPECT_EQ(size("(MATERIAL 4\" X 2\" X 1\" PINE)"), (Vec3{101.6, 50.8, 25.4}));
    for (const char* text :
         {"(STOCK 100 x 50 mm)", "(STOCK TO LEAVE 1 x 1 x 1)", "(STOCK 100x50x10x2)",
          "(STOCKS 100x50x10)", "(STOCK 100x50x0)", "(STOCK 100x50x10, 2 PIECES)",
          "(STOCK 4in x 50mm x 10)", "(100x50x10)", "(MATERIAL 6061 100x50x10)"}) {
        EXPECT_EQ(size(text), Vec3{}) << text;
    }
    EXPECT_TRUE(notes("(STOCK 100x50x10)\nG21\n").stock->place_assumed);
    EXPECT_FALSE(notes("(STOCK/BLOCK,100,50,10,0,0,10)\nG21\n").stock->place_assumed);
    EXPECT_FALSE(notes("; Stock Size: 9(X) * 9(Y) * 9(Z) mm\n; Material Origin: X0 Y0 Z0\nG21\n")
                     .stock->place_assumed);
}

TEST(StockComments, OfSetUpSheetsHaveLengthsByAxisAndANamedZero) {
    const auto box = [](const std::string& text) {
        const auto stock = notes(text + "\nG21\n").stock;
        return stock ? stock->box : Box{};
    };
    const std::string block = "(STOCK 6061 DX 90MM DY 60MM DZ 20MM, AFTER SQUARING)\n";
    EXPECT_EQ(box(block + "(WCS G54 FRONT-LEFT-TOP)"), (Box{{0, 0, -20}, {90, 60, 0}}));
    EXPECT_EQ(box(block + "(WCS G55 BACK RIGHT BOTTOM)"), (Box{{-90, -60, 0}, {0, 0, 20}}));
    EXPECT_EQ(box(block + "(ZERO: CENTER, TOP OF STOCK)"), (Box{{-45, -30, -20}, {45, 30, 0}}));
    EXPECT_FALSE(notes(block + "(ORIGIN LEFT FRONT TOP)\nG21\n").stock->place_assumed);
    EXPECT_EQ(box(block + "(ORIGIN LOWER LEFT CORNER, TOP)"), (Box{{0, 0, -20}, {90, 60, 0}}));
    EXPECT_EQ(box(block + "(ORIGIN UPPER LEFT CORNER, TOP)"), (Box{{0, -60, -20}, {90, 0, 0}}));
    EXPECT_EQ(box(block + "(ZERO LEFT CENTER TOP)"), (Box{{0, -30, -20}, {90, 30, 0}}));
    // The corner may be of a drawing or of the part: the position is unknown.
    EXPECT_TRUE(notes(block + "(ZERO TOP LEFT)\nG21\n").stock->place_assumed);
    // Words with a different meaning.
    EXPECT_TRUE(notes(block + "(WORK ON THE LEFT TOP CLAMP)\nG21\n").stock->place_assumed);
    EXPECT_TRUE(notes(block + "(ZERO LEFT)\nG21\n").stock->place_assumed);
    EXPECT_EQ(box("(STOCK DX 4IN DY 2IN DZ 1/2IN)").size(), (Vec3{101.6, 50.8, 12.7}));
    EXPECT_EQ(box("(STOCK DX 3.5IN DY 50MM DZ 10)"), Box{});
    EXPECT_EQ(box("(STOCK DX 90 DY 60)"), Box{});
}

TEST(StockComments, OfKiriAreASize) {
    EXPECT_EQ(notes("; Stock X:100 Y:50 Z:10\nG21\n").stock->box.max, (Vec3{100, 50, 0}));
    EXPECT_FALSE(notes("; Stock X:100 Y:0 Z:10\nG21\n").stock);
}

TEST(StockComments, BlockIsSizeAndTheZeroSeenFromItsCorner) {
    const ProgramNotes n = notes("(STOCK/BLOCK,100.00, 50.00, 10.00,20.00, 0.00, 10.00)\nG21\n");
    ASSERT_TRUE(n.stock);
    EXPECT_EQ(n.stock->box.min, (Vec3{-20, 0, -10}));
    EXPECT_EQ(n.stock->box.max, (Vec3{80, 50, 0}));
    EXPECT_EQ(n.stock->span.line, 1U);
}

TEST(StockComments, CornersHaveTheirOwnUnits) {
    const ProgramNotes n =
        notes("(stockMin:0.00mm, 0.00mm, -1.00mm)\n(stockMax:100.00mm, 90.00mm, 0.00mm)\nG20\n");
    ASSERT_TRUE(n.stock);
    EXPECT_EQ(n.stock->box.min, (Vec3{0, 0, -1}));
    EXPECT_EQ(n.stock->box.max, (Vec3{100, 90, 0}));
}

TEST(StockComments, WithoutUnitsAreInThoseOfTheProgram) {
    EXPECT_EQ(notes("(STOCK/BLOCK,4,2,1,0,0,1)\nG20\n").stock->box.max.x, 101.6);
}

TEST(StockComments, OneCornerIsNoBlock) {
    EXPECT_FALSE(notes("(stockMin:0,0,-1)\n").stock);
}

TEST(StockComments, OfAbsurdSizeAreReported) {
    EXPECT_FALSE(notes("(STOCK/BLOCK,0,50,10,0,0,0)\n").stock);
    const ProgramNotes n = notes("(STOCK/BLOCK,999999,999999,999999,0,0,0)\nG20\n");
    EXPECT_FALSE(n.stock);
    EXPECT_EQ(n.diagnostics.at(0).code, "stock-size");
}

TEST(StockComments, StartPosition) {
    EXPECT_EQ(notes("(FROM/0,0,50)\nG21\n").start, (Vec3{0, 0, 50}));
}

TEST(Notes, OfAnyBytesAreATable) {
    EXPECT_TRUE(notes("").tools.empty());
    EXPECT_TRUE(notes(std::string("\0\xff(T\x01(((D=\n(T1 D=", 17)).tools.empty());
    EXPECT_TRUE(notes("(T99999999999999999999 D=5. CR=0. - flat end mill)").tools.size() <= 1);
}

TEST(ToolOption, NamesKindAndValues) {
    std::string message;
    const auto spec = parse_tool_option("T12=bull:D10:R1.5:L40", message);
    ASSERT_TRUE(spec) << message;
    EXPECT_EQ(spec->number, 12);
    EXPECT_EQ(describe(make_tool(*spec, 50)), "bull nose end mill D10 R1.5 L40");
    EXPECT_EQ(parse_tool_option("3=ball:d1/4in", message)->diameter, 6.35);
    EXPECT_EQ(parse_tool_option("t3=v:D6:A60:P0.2", message)->tip_diameter, 0.2);
    EXPECT_EQ(parse_tool_option("T3=taper:D3:R1.5:A5", message)->taper, 5);
}

TEST(ToolOption, TellsTheWholeAssembly) {
    const auto described = [](const char* text) {
        std::string message;
        const auto spec = parse_tool_option(text, message);
        return spec ? describe(make_tool(*spec, 50)) : message;
    };
    EXPECT_EQ(described("T1=flat:D10:L22:S12x30:H28x15,40x25"),
              "flat end mill D10 L22, D12 to 52, D28 to 67, D40 to 92");
    EXPECT_EQ(described("T1=flat:D10:L22:S12:E60:H20-32x10"),
              "flat end mill D10 L22, D12 to 60, D20-32 to 70");
    EXPECT_EQ(described("T1=flat:D10:L22:N9x10:S12:E60"),
              "flat end mill D10 L22, D9 to 32, D12 to 60");
    // The length of the shank is unknown, so the holder begins as low as possible.
    EXPECT_EQ(described("T1=flat:D10:L22:S12:H28x15,40x25"),
              "flat end mill D10 L22, D28 to 37, D40 to 62");
    // The body between flutes and holder is unknown, so the cutter's diameter is used.
    EXPECT_EQ(described("T1=flat:D10:L22:E40:H28x15"),
              "flat end mill D10 L22, D10 to 40, D28 to 55");
    EXPECT_EQ(described("T1=flat:D10:E40:H28x15"), "flat end mill D10 L40, D28 to 55");
    EXPECT_EQ(described("T1=slot:D20:L4:N8:S10:E50"), "slot mill D20 L4, D8 to 12, D10 to 50");
    EXPECT_EQ(described("T1=dovetail:D20:A30:L6:N8x10:S10:E50"),
              "dovetail mill D20 L6, D8 to 16, D10 to 50");
    // Catalogues list cutters for metal by the angle between floor and flank.
    EXPECT_DOUBLE_EQ(dovetail_taper(60), 30);
    EXPECT_DOUBLE_EQ(dovetail_taper(45), 45);
    EXPECT_DOUBLE_EQ(dovetail_taper(14), 14);
    std::string said;
    EXPECT_EQ(parse_tool_option("T1=dovetail:D20:A60", said)->taper, 30.0);
    EXPECT_EQ(described("T1=lollipop:D6:N3x20"), "lollipop mill D6 L6, D3 to 26");
}

TEST(ToolSpec, KnowsWhatIsAGuess) {
    const auto guessed = [](const char* text) {
        std::string message;
        return guesses_shape(parse_tool_option(text, message).value());
    };
    EXPECT_TRUE(guessed("T1=D6"));
    EXPECT_TRUE(guessed("T1=v:D6"));
    EXPECT_TRUE(guessed("T1=slot:D6"));
    EXPECT_FALSE(guessed("T1=D6:R1"));
    EXPECT_FALSE(guessed("T1=flat:D6"));
    EXPECT_FALSE(guessed("T1=D6:A60"));
    EXPECT_FALSE(guessed("T1=slot:D6:L2"));
    const auto least = [](const char* text) {
        std::string message;
        return least_flute_length(make_tool(parse_tool_option(text, message).value(), 100));
    };
    EXPECT_EQ(least("T1=flat:D10"), 12.5);
    EXPECT_EQ(least("T1=ball:D10"), 12.5);
    EXPECT_NEAR(least("T1=drill:D10:A90"), 35.0, 1e-9);
    EXPECT_NEAR(least("T1=v:D10:A90"), 5.0, 1e-9);
    EXPECT_EQ(least("T1=face:D50"), 5.0);
    EXPECT_EQ(least("T1=slot:D20:L4:N8x10"), 4.0);
}

TEST(ToolOption, SaysWhatIsWrong) {
    for (const char* bad : {"",
                            "T1",
                            "T0=D5",
                            "flat:D5",
                            "T1=flat",
                            "T1=flat:D0",
                            "T1=flat:Dx",
                            "T1=flat:Q5",
                            "T1=round:D5",
                            "T1=flat:D1e9",
                            "T1=flat:D10:L99999999",
                            "T1.5=D5",
                            "T1=flat:D-5",
                            "T1=:",
                            "T1=taper:D10:A180",
                            "T1=taper:D10:A85",
                            "T1=v:D10:A0",
                            "T1=v:D10:A180",
                            "T1=flat:D6:S12y3",
                            "T1=flat:D6:S12x",
                            "T1=flat:D6:H28",
                            "T1=flat:D6:H28x",
                            "T1=flat:D6:H-5x3",
                            "T1=flat:D6:H28x15,",
                            "T1=flat:D6:L5x3"}) {
        SCOPED_TRACE(bad);
        std::string message;
        EXPECT_FALSE(parse_tool_option(bad, message));
        EXPECT_FALSE(message.empty());
    }
}

TEST(ToolSpec, SaysWhatWasFilledIn) {
    ToolSpec spec;
    spec.diameter = 5;
    EXPECT_EQ(assumed_values_text(spec, 40), "kind flat end mill, length 40 mm");
    spec.kind = ToolKind::Drill;
    spec.length = 30;
    EXPECT_EQ(assumed_values_text(spec, 40), "angle 118 deg");
}

}  // namespace
}  // namespace ncsim::toolpath
