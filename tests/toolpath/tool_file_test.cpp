// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/tool_file.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::toolpath {
namespace {

// Returns a line per tool, followed by all diagnostics.
std::string tools_of(const std::string& text, bool inches = false) {
    const ToolFile file = read_tool_file({"tools", text}, inches);
    std::string out = file.format + "\n";
    for (const ToolEntry& entry : file.tools) {
        out.append("T").append(std::to_string(entry.spec.number)).append(" ");
        out += describe(make_tool(entry.spec, 50));
        if (entry.offset.z != 0) out.append(" Z").append(std::to_string(entry.offset.z));
        EXPECT_EQ(entry.specified_by, ValueSource::Table);
        out += '\n';
    }
    for (const gcode::Diagnostic& d : file.diagnostics) {
        out.append(std::to_string(d.span.line)).append(":").append(std::to_string(d.span.column));
        out.append(" ").append(d.code).append("\n");
    }
    return out;
}

TEST(ToolFile, OfLinuxCncHasDiametersInMachineUnitsAndKindsInRemarks) {
    const std::string table =
        "; a remark\n"
        "T1 P1 D6.000000 Z+51.1000 ;6 mm flat end mill\n"
        "\n"
        "t2 p2 d4 ;ball end mill\r\n"
        "T4 P2 Z10 D16\n"
        "T5 P5 D10 ;60 deg v bit 10mm\n"
        "T6 P6 ;probe without a diameter\n"
        "T1 P9 D8 ;again\n";
    EXPECT_EQ(tools_of(table),
              "LinuxCNC tool table\n"
              "T1 flat end mill D6 L50 Z51.100000\n"
              "T2 ball end mill D4 L50\n"
              "T4 flat end mill D16 L50 Z10.000000\n"
              "T5 v-cutter D10 L50\n"
              "7:1 tool-unknown\n"
              "8:1 tool-conflict\n");
    EXPECT_EQ(tools_of("T1 P1 D0.25 ;1/4 end mill\n", true),
              "LinuxCNC tool table\nT1 flat end mill D6.35 L50\n");
}

TEST(ToolFile, OfLinuxCncHasShapesInRemarksAndSizesInTheColumn) {
    const auto described = [](const std::string& column, const std::string& remark) {
        std::string text = tools_of("T1 P1 D" + column + " ;" + remark + "\n");
        text.erase(0, text.find('\n') + 4);
        return text.substr(0, text.find('\n'));
    };
    EXPECT_EQ(described("8", "8mm drill"), "drill D8 L50");
    EXPECT_EQ(described("8", "drill"), "drill D8 L50");
    EXPECT_EQ(described("6.35", "V-bit 60 deg"), "v-cutter D6.35 L50");
    EXPECT_EQ(described("6", "ball"), "ball end mill D6 L50");
    EXPECT_EQ(described("6", "Kugelfraeser"), "ball end mill D6 L50");
    EXPECT_EQ(described("10", "NC-Anbohrer 90 Grad"), "v-cutter D10 L50");
    EXPECT_EQ(described("12", "chamfer 45"), "v-cutter D12 L50");
    EXPECT_EQ(described("8", "bull nose R1"), "bull nose end mill D8 R1 L50");
    EXPECT_EQ(described("8", "8mm R1 torus"), "bull nose end mill D8 R1 L50");
    EXPECT_EQ(described("6.8", "HSS-Bohrer"), "drill D6.8 L50");
    EXPECT_EQ(described("50", "Messerkopf"), "face mill D50 L50");
    EXPECT_EQ(described("5", "Tap M6"), "tap D5 L50");
    EXPECT_EQ(described("6", "bought in May"), "flat end mill D6 L50");
    // The column holds the diameter of the tip.
    const ToolFile file = read_tool_file({"t.tbl", "T1 P1 D0.1 ;60 deg V bit tip 0.1\n"}, false);
    ASSERT_EQ(file.tools.size(), 1U);
    EXPECT_EQ(file.tools[0].spec.tip_diameter, 0.1);
    EXPECT_EQ(file.tools[0].spec.angle, 60.0);
    EXPECT_FALSE(file.tools[0].spec.diameter);
}

TEST(ToolFile, OfCamoticsIsAProjectWithItsWorkpiece) {
    const std::string project =
        R"({"units":"imperial","tools":{
            "1":{"units":"metric","shape":"cylindrical","length":20,"diameter":2.5},
            "2":{"units":"imperial","shape":"ballnose","length":1,"diameter":0.25},
            "3":{"units":"metric","shape":"conical","length":5,"diameter":10},
            "4":{"units":"metric","shape":"snubnose","length":4,"diameter":10,"snub_diameter":2},
            "5":{"units":"metric","shape":"spheroid","length":4,"diameter":10}},
          "workpiece":{"automatic":false,"margin":0,"bounds":{"min":[-2,-1,-32],"max":[92,89,0]}},
          "files":["a.nc"]})";
    EXPECT_EQ(tools_of(project),
              "CAMotics project\n"
              "T1 flat end mill D2.5 L20\n"
              "T2 ball end mill D6.35 L25.4\n"
              "T3 v-cutter D10 L5\n"
              "T4 v-cutter D10 L4\n"
              "0:1 tool-unknown\n");
    const ToolFile file = read_tool_file({"a.camotics", project});
    EXPECT_EQ(file.inches, true);
    ASSERT_TRUE(file.stock);
    EXPECT_EQ(file.stock->box.min, (Vec3{-2, -1, -32}));
    EXPECT_EQ(file.stock->box.max, (Vec3{92, 89, 0}));
    EXPECT_EQ(file.tools.at(2).spec.angle, 90.0);
    EXPECT_FALSE(read_tool_file({"", R"({"workpiece":{"automatic":true,
        "bounds":{"min":[0,0,0],"max":[1,1,1]}}})"})
                     .stock);
}

TEST(ToolFile, OfFusionHasWholeAssemblies) {
    // Shoulder, shaft and holder; a separate shaft; mills with undercut.
    EXPECT_EQ(tools_of(R"({"data":[
          {"type":"flat end mill","unit":"millimeters",
           "geometry":{"DC":6,"SFDM":8,"LCF":10,"shoulder-length":16,"shoulder-diameter":5.5,"LB":30},
           "holder":{"segments":[{"height":15,"lower-diameter":20,"upper-diameter":28},
                                 {"height":25,"lower-diameter":40,"upper-diameter":40}]},
           "post-process":{"number":1}},
          {"type":"ball end mill","unit":"inches","geometry":{"DC":0.25,"LCF":0.5,"SFDM":0.25,"LB":1},
           "shaft":{"segments":[{"height":0.5,"lower-diameter":0.2,"upper-diameter":0.25}]},
           "holder":{"segments":[{"height":1,"lower-diameter":1}]},"post-process":{"number":2}},
          {"type":"slot mill","unit":"millimeters",
           "geometry":{"DC":20,"LCF":4,"SFDM":10,"LB":40},"post-process":{"number":3}},
          {"type":"dovetail mill","unit":"millimeters",
           "geometry":{"DC":20,"LCF":6,"TA":30,"SFDM":10,"LB":40},"post-process":{"number":4}},
          {"type":"thread mill","unit":"millimeters","geometry":{"DC":8,"LCF":15,"SFDM":8},
           "post-process":{"number":5}},
          {"type":"form mill","unit":"millimeters","geometry":{"DC":8,"LCF":15},
           "post-process":{"number":6}}]})"),
              "Fusion tool library\n"
              "T1 flat end mill D6 L10, D5.5 to 16, D8 to 30, D20-28 to 45, D40 to 70\n"
              "T2 ball end mill D6.35 L12.7, D5.08-6.35 to 25.4, D25.4 to 50.8\n"
              "T3 slot mill D20 L4, D10 to 40\n"
              "T4 dovetail mill D20 L6, D10 to 40\n"
              "T5 thread mill D8 L15, D8 to 39\n"
              "0:1 tool-unknown\n");
}

TEST(ToolFile, OfFusionHasTheToolsThatHaveANumber) {
    const std::string library =
        R"({"data":[
          {"type":"flat end mill","unit":"millimeters","description":"rough",
           "geometry":{"DC":6,"SFDM":6,"LCF":10,"RE":0},"post-process":{"number":1}},
          {"type":"bull nose end mill","unit":"inches",
           "geometry":{"DC":0.5,"RE":0.03125,"LCF":1},"post-process":{"number":2}},
          {"type":"drill","unit":"millimeters","geometry":{"DC":5,"SIG":140,"LCF":30},
           "post-process":{"number":3}},
          {"type":"chamfer mill","unit":"millimeters",
           "geometry":{"DC":8,"TA":45,"tip-diameter":1,"LCF":4},"post-process":{"number":4}},
          {"type":"tapered mill","unit":"millimeters",
           "geometry":{"DC":1,"RE":0.5,"TA":5,"LCF":15},"post-process":{"number":5}},
          {"type":"lollipop mill","unit":"millimeters","geometry":{"DC":1},
           "post-process":{"number":6}},
          {"type":"holder","unit":"millimeters","segments":[]},
          {"type":"flat end mill","geometry":{"DC":9}}],"version":2})";
    EXPECT_EQ(tools_of(library),
              "Fusion tool library\n"
              "T1 flat end mill D6 L10, D6 to 28\n"
              "T2 bull nose end mill D12.7 R0.79375 L25.4\n"
              "T3 drill D5 L30\n"
              "T4 chamfer mill D8 L4\n"
              "T5 tapered end mill D3.540991 R0.5 L15\n"
              "T6 lollipop mill D1 L1, D0.6 to 2.8\n");
    const ToolFile file = read_tool_file({"", library});
    EXPECT_EQ(file.tools.at(2).spec.angle, 140.0);
    EXPECT_EQ(file.tools.at(3).spec.angle, 90.0);
}

TEST(ToolFile, OfKiriIsAList) {
    EXPECT_EQ(tools_of(R"([{"number":5,"type":"ballmill","flute_diam":0.25,"flute_len":1,
                            "metric":false},
                           {"number":6,"type":"endmill","flute_diam":3,"flute_len":12,
                            "metric":true},
                           {"number":7,"type":"tapermill","flute_diam":6,"flute_len":3,
                            "taper_tip":0,"metric":true}])"),
              "Kiri:Moto tools\n"
              "T5 ball end mill D6.35 L25.4\n"
              "T6 flat end mill D3 L12\n"
              "T7 v-cutter D6 L3\n");
}

TEST(ToolFile, OfKiriHasShanksInTheUnitOfTheTool) {
    for (const bool metric : {true, false}) {
        const double unit = metric ? 1.0 : 25.4;
        const std::string text =
            std::string(R"([{"number":5,"type":"endmill","flute_diam":0.5,"flute_len":2,)") +
            R"("shaft_diam":0.75,"shaft_len":3,"metric":)" + (metric ? "true" : "false") + "}]";
        const ToolFile file = read_tool_file({"tools.json", text});
        ASSERT_EQ(file.tools.size(), 1U);
        const ToolSpec& spec = file.tools[0].spec;
        EXPECT_EQ(spec.diameter, 0.5 * unit);
        EXPECT_EQ(spec.length, 2 * unit);
        EXPECT_EQ(spec.shank_diameter, 0.75 * unit);
        EXPECT_EQ(spec.shank_length, 3 * unit);
    }
}

// Columns as Carbide Create writes them.
TEST(ToolFile, OfCsvHasNamedColumns) {
    EXPECT_EQ(
        tools_of("number,vendor,model,URL,name,type,diameter,cornerradius,flutelength,"
                 "shaftdiameter,angle,numflutes,stickout,coating,metric,notes\r\n"
                 "201,Carbide 3D,#201,,\"#201 .25\"\" Flat\",end,0.25,0,0.75,0.25,0,3,0,,0,\r\n"
                 "202,Carbide 3D,#202,,Ball,ball,6,3,19,6,0,2,0,,1,\"two\r\nlines\"\r\n"
                 "302,Carbide 3D,#302,,Vee,vee,12.7,0,0,6.35,60,2,0,,1,\r\n"
                 ",,,,,,,,,,,,,,,\r\n"
                 "0,,,,nothing,end,3,0,0,0,0,0,0,,1,\r\n"
                 "202,Carbide 3D,,,again,end,3,0,0,0,0,0,0,,1,\r\n"
                 "9,,,,broken,end,wide,0,0,0,0,0,0,,1,\r\n"
                 "x,,,,broken,end,3,0,0,0,0,0,0,,1,\r\n"
                 "10,,,,no size,end,,0,0,0,0,0,0,,1,"),
        "CSV tool table\n"
        "T201 flat end mill D6.35 L19.05, D6.35 to 38.1\n"
        "T202 ball end mill D6 L19, D6 to 37\n"
        "T302 v-cutter D12.7 L50, D6.35 to 69.05\n"
        "8:1 tool-conflict\n"
        "9:1 tool-unknown\n"
        "10:1 tool-unknown\n"
        "11:1 tool-unknown\n");
    const ToolFile file =
        read_tool_file({"tools", "T,Diameter,Type,Angle\n1,6,vee,60\n2,8,drill,140\n"});
    EXPECT_EQ(file.tools.at(0).spec.angle, 60.0);
    EXPECT_EQ(file.tools.at(1).spec.angle, 140.0);
}

TEST(ToolFile, OfCsvHasUnitsOfItsNamesAndValues) {
    const std::string six = "CSV tool table\nT1 flat end mill D6.35 L19.05\n";
    for (const char* const table : {"Tool No.,Dia (in),Flute length [mm]\n1,.25,19.05\n",
                                    "tool number;diameter_mm;flute_length_mm\n1;6,35;19,05\n",
                                    "Unit\tT\tD\tFLUTELENGTH\nINCH\tT1\t0.25\t3/4\n",
                                    "\xef\xbb\xbf\nnr,d,flute length\n1,1/4,19.05mm\n",
                                    "Description,D,T,flute length\n1/4 end mill,6.35,1,19.05\n"}) {
        EXPECT_EQ(tools_of(table), six) << table;
    }
    EXPECT_EQ(tools_of("T,D,flute length\n1,.25,.75\n", true), six);
    EXPECT_EQ(tools_of("T,D,Height,Description\n3,8,40.5,8mm drill\n"),
              "CSV tool table\nT3 drill D8 L50 Z40.500000\n");
    // A unit, a kind or a number that is not known leaves the tool out.
    EXPECT_EQ(tools_of("T,D,Unit\n1,.25,in.\n2,.25,Zoll\n3,.25,\"\"\"\"\n4,2,cm\n"),
              "CSV tool table\n"
              "T1 flat end mill D6.35 L50\n"
              "T2 flat end mill D6.35 L50\n"
              "T3 flat end mill D6.35 L50\n"
              "5:1 tool-unknown\n");
    EXPECT_EQ(tools_of("T,D,Metric\n1,.25,no\n2,6,1.0\n3,6,\n4,6,2\n"),
              "CSV tool table\n"
              "T1 flat end mill D6.35 L50\n"
              "T2 flat end mill D6 L50\n"
              "T3 flat end mill D6 L50\n"
              "5:1 tool-unknown\n");
    EXPECT_EQ(tools_of("T,D,Type,Corner radius\n1,6,flat,0.5\n2,6,foo mill,\n3,6,laser,\n"
                       "4,6,chamfer,\nTotal,4,,\n"),
              "CSV tool table\n"
              "T1 bull nose end mill D6 R0.5 L50\n"
              "T4 chamfer mill D6 L50\n"
              "3:1 tool-unknown\n4:1 tool-unknown\n6:1 tool-unknown\n");
    EXPECT_EQ(tools_of("T,D\n"), "CSV tool table\n1:1 tool-table\n");
    // Lines of spreadsheets and scripts that are no rows; ends of lines of any system.
    for (const char* const table :
         {"sep=;\r\nT;D;flute length\r\n1;6,35;19,05\r\n",
          "SEP=,\nT,D,flute length\n1,6.35,19.05\n", "sep=\t\nT\tD\tflute length\n1\t6.35\t19.05\n",
          "T,D,flute length\r1,6.35,19.05\r",
          "# tools, of June\nT,D,flute length\n# T,D\n1,6.35,19.05\n",
          "#name,T,D,flute length\n#201 end,1,6.35,19.05\n#\n"}) {
        EXPECT_EQ(tools_of(table), six) << table;
    }
    EXPECT_EQ(tools_of("# a\rT,D\r\"1\",\"6\r7\"\r1,6\rx,2\r"),
              "CSV tool table\nT1 flat end mill D6 L50\n3:1 tool-unknown\n6:1 tool-unknown\n");
    // A remark of LinuxCNC.
    EXPECT_EQ(tools_of("; tool, dia\nT1 P1 D6\n"),
              "LinuxCNC tool table\nT1 flat end mill D6 L50\n");
}

TEST(ToolFile, ThatIsNoneIsAnErrorWithItsPlace) {
    const std::pair<const char*, const char*> table[] = {
        {"", "\n1:1 tool-table\n"},
        {"; nothing\n", "\n1:1 tool-table\n"},
        {"G21\nG0 X1\n", "\n1:1 tool-table\n"},
        {"T1 D5\n", "\n1:1 tool-table\n"},
        {"T1 P1 D\n", "\n1:1 tool-table\n"},
        {"{}", "\n1:1 tool-table\n"},
        {"[]", "\n1:1 tool-table\n"},
        {"[1,2]", "\n1:1 tool-table\n"},
        {"{\"tools\":\n  {,}}", "\n2:4 tool-table\n"},
        {"[1e9999]", "\n1:1 tool-table\n"},
        {"{\"data\":[{\"geometry\":3}]}", "Fusion tool library\n"},
        {"{\"tools\":{\"x\":{\"diameter\":\"big\"}}}", "CAMotics project\n0:1 tool-unknown\n"},
    };
    for (const auto& [text, expected] : table) {
        SCOPED_TRACE(text);
        EXPECT_EQ(tools_of(text), expected);
    }
}

}  // namespace
}  // namespace ncsim::toolpath
