// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of set-ups: typed TOML, holders, fixtures by their sizes, options, job files and machine
// files that are written and read again, positions of machine bodies.
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/job_writer.h"
#include "ncsim/setup/machine_body.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/machine_text.h"
#include "ncsim/toolpath/tool_file.h"

#include "files/toml_reader.h"
#include "files/tool_keys.h"
#include "job/holder_file.h"
#include "job/job_keys.h"
#include "job/option_reader.h"
#include "machines/fixture_reader.h"
#include "machines/xml_root.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::setup {
namespace {

class Specified : public InputSet {
public:
    explicit Specified(std::string text) : text_(std::move(text)) {}
    std::string read(const std::string&, std::uintmax_t) override { return text_; }

private:
    std::string text_;
};

/// Returns the message of the exception of `read`; empty if it throws none.
std::string refusal(const std::function<void()>& read) {
    try {
        read();
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return {};
}

// --- TOML ---

TEST(TomlReader, PlacesAreLinesAndColumns) {
    const TomlReader reader("mill.toml", "a = 1\n\n[t]\n  b = [1, 2, 3]\n");
    const TomlTable root(reader.root(), "");
    EXPECT_EQ(reader.place_of(*root["a"]), "mill.toml:1:5");
    const TomlTable t = root.table("t");
    EXPECT_EQ(reader.place_of(*t["b"]), "mill.toml:4:7");
    EXPECT_EQ(t.name_of("b"), "t.b");
    EXPECT_EQ(root.name_of("a"), "a");
    EXPECT_EQ(refusal([&] { reader.fail(*t["b"], "no"); }), "mill.toml:4:7: no");
    EXPECT_TRUE(refusal([] { TomlReader("m.toml", "a = 1\nb = \n"); }).starts_with("m.toml:2:"));
    EXPECT_EQ(root["none"], nullptr);
    EXPECT_TRUE(root.table("none").node().empty());
}

TEST(TomlTable, ReadsTypesAndKeepsWhatIsMissing) {
    const TomlReader reader("a",
                            "n = 2\nr = 2.5\nt = \"x\"\nv = [1, 2.5, -3]\nl = [[1, 2], [3, 4]]\n"
                            "b = true\n[[e]]\nk = 1\n[[e]]\nk = 2\n[m]\nx = 1\ny = 2\n");
    const TomlTable root(reader.root(), "");
    double number = 7.0;
    root.read("none", number);
    EXPECT_EQ(number, 7.0);
    root.read("n", number);
    EXPECT_EQ(number, 2.0);
    std::optional<double> maybe;
    root.read("r", maybe);
    EXPECT_EQ(maybe, 2.5);
    std::string text;
    root.read("t", text);
    EXPECT_EQ(text, "x");
    Vec3 v;
    root.read("v", v);
    EXPECT_EQ(v, (Vec3{1, 2.5, -3}));
    std::vector<std::array<double, 2>> list;
    root.read("l", list);
    EXPECT_EQ(list, (decltype(list){{1, 2}, {3, 4}}));
    bool flag = false;
    root.read("b", flag);
    EXPECT_TRUE(flag);
    std::string seen;
    root.each("e", [&](const TomlTable& t) {
        t.read("k", number);
        seen += t.name() + std::to_string(static_cast<int>(number));
    });
    root.each("none", [&](const TomlTable&) { seen += '!'; });
    root.each_key("m", [&](const toml::node& node, const std::string& name) {
        seen += name + std::to_string(static_cast<int>(TomlReader::number(node)));
    });
    root.each_key("none", [&](const toml::node&, const std::string&) { seen += '!'; });
    EXPECT_EQ(seen, "e1e2x1y2");
}

TEST(TomlReader, OffsetsAreNumberedAsSystems) {
    const auto read = [](const std::string& text) {
        const TomlReader reader("a", text);
        return read_offsets(reader, TomlTable(reader.root(), ""));
    };
    EXPECT_TRUE(read("").empty());
    const std::map<int, Vec3> offsets = read(
        "[offsets]\nG54 = [1, 2, 3]\nG59 = [4, 5, 6]\n\"G59.3\" = [7, 8, 9]\n\"G54.1 P1\" = [0, 0, "
        "1]\n\"G54.1 P300\" = [0, 0, 2]\n");
    EXPECT_EQ(
        offsets,
        (std::map<int, Vec3>{
            {1, {1, 2, 3}}, {6, {4, 5, 6}}, {9, {7, 8, 9}}, {10, {0, 0, 1}}, {309, {0, 0, 2}}}));
    for (const char* name : {"G53", "G60", "\"G59.4\"", "\"G54.1 P0\"", "\"G54.1 P301\"", "g"})
        EXPECT_NE(refusal([&] { read("[offsets]\n" + std::string(name) + " = [1, 2, 3]\n"); }), "")
            << name;
}

TEST(OptionReader, ReadsTextsNumbersFlagsAndLists) {
    const TomlReader reader("n.toml",
                            "a = \"x\"\nb = 2.5\nc = 3\nd = false\ne = [\"y\", 4]\n"
                            "f = []\ng = [true]\nh = {i = 1}\n");
    const auto read = [&](const char* key) {
        return read_option(reader, "an-option", key, *reader.root().get(key));
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(read("a").values, Texts{"x"});
    EXPECT_EQ(read("a").option, "an-option");
    EXPECT_EQ(read("a").where, "n.toml:1:5");
    EXPECT_EQ(read("b").values, Texts{"2.5"});
    EXPECT_EQ(read("c").values, Texts{"3"});
    EXPECT_TRUE(read("d").is_flag);
    EXPECT_FALSE(read("d").is_on);
    EXPECT_FALSE(read("c").is_flag);
    EXPECT_EQ(read("e").values, (Texts{"y", "4"}));
    EXPECT_TRUE(read("f").values.empty());
    for (const char* key : {"g", "h"})
        EXPECT_TRUE(refusal([&] { read(key); }).starts_with("n.toml:")) << key;
}

TEST(XmlRoot, IsTheNamedElement) {
    const auto root = [](const std::string& text) {
        tinyxml2::XMLDocument document;
        return std::string(xml_root(document, text, "m.xml", "robot", " of URDF")->Name());
    };
    EXPECT_EQ(root("<?xml version=\"1.0\"?>\n<!-- c -->\n<robot/>"), "robot");
    EXPECT_EQ(refusal([&] { root("\n\n<Robot/>"); }), "m.xml:3: expected <robot> of URDF");
    EXPECT_TRUE(refusal([&] { root(""); }).starts_with("m.xml:1: "));
    EXPECT_TRUE(refusal([&] { root("<robot>\n<a>\n</robot>"); }).starts_with("m.xml:"));
}

// --- Holders ---

TEST(HolderFile, GivesToolsTheirHolders) {
    Specified inputs(
        "[[tool]]\nnumber = 3\nholder = \"ER16\"\nstick_out = 38\nflutes = 22\n"
        "shank = 12\nneck = [11.5, 10]\n[[tool]]\nnumber = 4\nstick_out = 30\n"
        "[[holder]]\nname = \"ER16\"\nsegments = [[28, 15], [28, 40, 10]]\n");
    const auto tools = read_holder_file("h.toml", inputs);
    ASSERT_EQ(tools.size(), 2U);
    EXPECT_EQ(tools[0].number, 3);
    EXPECT_EQ(tools[0].holder, (std::vector<toolpath::ToolSegment>{{28, 28, 15}, {28, 40, 10}}));
    EXPECT_EQ(tools[0].stick_out, 38.0);
    EXPECT_EQ(tools[0].length, 22.0);
    EXPECT_EQ(tools[0].shank_diameter, 12.0);
    EXPECT_EQ(tools[0].neck_diameter, 11.5);
    EXPECT_EQ(tools[0].neck_length, 10.0);
    EXPECT_TRUE(tools[1].holder.empty());
    EXPECT_FALSE(tools[1].length);
}

TEST(HolderFile, RefusesContradictions) {
    const std::string holder = "[[holder]]\nname = \"A\"\nsegments = [[28, 15]]\n";
    for (const std::string& text :
         {holder + holder, std::string("[[holder]]\nname = \"A\"\n"),
          std::string("[[holder]]\nsegments = [[28, 15]]\n"),
          holder + "[[tool]]\nnumber = 1\nholder = \"B\"\n", std::string("[[tool]]\nflutes = 3\n"),
          std::string("[[tool]]\nnumber = 1\n[[tool]]\nnumber = 1\n"),
          std::string("[[tool]]\nnumber = 1\nflutes = -3\n"),
          std::string("[[tool]]\nnumber = 1\nlength = 3\n"),
          std::string("[[holder]]\nname = \"A\"\nsegments = [[28, 1, 2, 3]]\n")}) {
        Specified inputs(text);
        EXPECT_TRUE(refusal([&] { read_holder_file("h.toml", inputs); }).starts_with("h.toml:"))
            << text;
    }
    Specified empty("");
    EXPECT_TRUE(read_holder_file("h.toml", empty).empty());
}

TEST(HolderFile, CompletesOnlyWhatIsUnspecified) {
    toolpath::ToolSpec more;
    more.length = 22, more.stick_out = 38, more.shank_diameter = 12;
    more.neck_diameter = 11, more.neck_length = 10;
    more.holder = {{28, 28, 15}};
    toolpath::ToolSpec bare;
    complete_assembly(bare, more);
    EXPECT_EQ(bare, more);
    toolpath::ToolSpec own = more;
    own.length = 5, own.stick_out = 6, own.shank_diameter = 7;
    own.neck_diameter = 8, own.neck_length = 9;
    own.holder = {{1, 2, 3}};
    const toolpath::ToolSpec before = own;
    complete_assembly(own, more);
    EXPECT_EQ(own, before);
    toolpath::ToolSpec shaft;
    shaft.shaft = {{10, 10, 20}};
    complete_assembly(shaft, more);
    EXPECT_FALSE(shaft.neck_diameter || shaft.shank_diameter) << "the shaft replaces both";
    EXPECT_EQ(shaft.length, 22.0);
    EXPECT_EQ(shaft.holder, more.holder);
    toolpath::ToolSpec neck;
    neck.neck_diameter = 4;
    complete_assembly(neck, more);
    EXPECT_FALSE(neck.neck_length) << "the length of another neck";
    complete_assembly(before == own ? own : bare, {});
    EXPECT_EQ(own, before);
}

// --- Fixtures ---

std::vector<verify::Fixture> fixtures_of(const std::string& text) {
    const TomlReader reader("m.toml", text);
    InputSet inputs;
    std::vector<verify::Fixture> fixtures;
    TomlTable(reader.root(), "").each("fixture", [&](const TomlTable& t) {
        read_fixture(reader, "", inputs, t, fixtures);
    });
    return fixtures;
}

Box swapped(const Box& b) {
    return {{b.min.y, b.min.x, b.min.z}, {b.max.y, b.max.x, b.max.z}};
}

TEST(FixtureReader, ViseIsMadeOfItsSizes) {
    const auto vise = [](const std::string& at, const std::string& along) {
        return fixtures_of("[[fixture]]\nname = \"V\"\nclearance = 2\nvise = { at = " + at +
                           ", along = \"" + along +
                           "\", opening = 50, jaw_width = 120, jaw_height = 40, jaw_depth = 25, "
                           "base_height = 60, parallels = [8, 30] }\n");
    };
    const auto y = vise("[10, 20, -30]", "Y");
    ASSERT_EQ(y.size(), 5U);
    const std::vector<std::pair<std::string, Box>> expected{
        {"V: fixed jaw", {{-50, -30, -30}, {70, -5, 10}}},
        {"V: moving jaw", {{-50, 45, -30}, {70, 70, 10}}},
        {"V: base", {{-50, -30, -90}, {70, 70, -30}}},
        {"V: parallel", {{-50, -5, -30}, {70, 3, 0}}},
        {"V: parallel", {{-50, 37, -30}, {70, 45, 0}}}};
    for (std::size_t i = 0; i < y.size(); ++i) {
        EXPECT_EQ(y[i].name, expected[i].first);
        EXPECT_EQ(y[i].box, expected[i].second) << y[i].name;
        EXPECT_EQ(y[i].clearance_mm, 2.0);
    }
    const auto x = vise("[20, 10, -30]", "X");
    for (std::size_t i = 0; i < y.size(); ++i)
        EXPECT_EQ(x[i].box, swapped(y[i].box)) << "X and Y exchanged";
}

TEST(FixtureReader, ClampIsMadeOfItsSizes) {
    const auto clamp = [](const std::string& at, const std::string& toward) {
        return fixtures_of("[[fixture]]\nclamp = { at = " + at + ", toward = \"" + toward +
                           "\", length = 80, width = 25, height = 15, table = -20, heel = 20, "
                           "bolt = [40, 12, 30] }\n");
    };
    const auto minus = clamp("[-40, 0, 5]", "-X");
    ASSERT_EQ(minus.size(), 3U);
    EXPECT_EQ(minus[0].name, "clamp: arm");
    EXPECT_EQ(minus[0].box, (Box{{-120, -12.5, 5}, {-40, 12.5, 20}}));
    EXPECT_EQ(minus[1].box, (Box{{-120, -12.5, -20}, {-100, 12.5, 5}}));
    EXPECT_EQ(minus[2].box, (Box{{-86, -6, -20}, {-74, 6, 50}}));
    const auto plus = clamp("[40, 0, 5]", "+X"), up = clamp("[0, 40, 5]", "+Y");
    for (std::size_t i = 0; i < minus.size(); ++i) {
        const Box& b = minus[i].box;
        EXPECT_EQ(plus[i].box, (Box{{-b.max.x, b.min.y, b.min.z}, {-b.min.x, b.max.y, b.max.z}}));
        EXPECT_EQ(up[i].box, swapped(plus[i].box));
    }
}

TEST(FixtureReader, RefusesWhatCannotBe) {
    const std::string vise =
        "vise = { at = [0, 0, 0], opening = 50, jaw_width = 120, jaw_height = 40, "
        "jaw_depth = 25";
    const std::string clamp =
        "clamp = { at = [0, 0, 0], toward = \"+X\", length = 80, width = 25, "
        "height = 15";
    for (const std::string& good :
         {std::string("box = [[0, 0, 0], [1, 2, 3]]"), vise + ", parallels = [25, 39.9] }",
          clamp + ", heel = 80, table = -1 }", clamp + ", bolt = [74, 12, 3] }"})
        EXPECT_EQ(refusal([&] { fixtures_of("[[fixture]]\n" + good + "\n"); }), "") << good;
    for (const std::string& bad :
         {std::string("name = \"x\""), std::string("box = [[0, 0, 0], [1, 0, 3]]"),
          "box = [[0, 0, 0], [1, 2, 3]]\n" + vise + " }", vise + ", parallels = [25.1, 30] }",
          vise + ", parallels = [8, 40] }", std::string("vise = { at = [0, 0, 0], opening = 5 }"),
          clamp + ", heel = 20 }", clamp + ", table = -20 }", clamp + ", table = 0, heel = 20 }",
          clamp + ", table = -20, heel = 81 }", clamp + ", bolt = [75, 12, 3] }",
          std::string("box = [[0, 0, 0], [1, 2, 3]]\noffset = \"G60\""),
          std::string("box = [[0, 0, 0], [1, 2, 3]]\nscale = 2"), clamp + " }\n" + vise + " }"})
        EXPECT_TRUE(
            refusal([&] { fixtures_of("[[fixture]]\n" + bad + "\n"); }).starts_with("m.toml:"))
            << bad;
    const auto box = fixtures_of("[[fixture]]\nbox = [[4, 5, 6], [1, 2, 3]]\noffset = \"G55\"\n");
    ASSERT_EQ(box.size(), 1U);
    EXPECT_EQ(box[0].box, (Box{{1, 2, 3}, {4, 5, 6}})) << "any two opposite corners";
    EXPECT_EQ(box[0].system, 2);
    EXPECT_EQ(box[0].name, "fixture");
}

// --- Files that are written and read again ---

std::vector<std::string> machine_files() {
    std::vector<std::string> files;
    for (const char* folder : {"/samples/machines", "/examples/rules"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(
                 std::string(NCSIM_SOURCE_DIR) + folder)) {
            const bool is_machine = entry.path().filename() == "machine.toml" ||
                                    entry.path().parent_path().filename() == "machines";
            if (is_machine && entry.path().extension() == ".toml")
                files.push_back(entry.path().string());
        }
    }
    return files;
}

TEST(MachineText, IsReadAgainAsTheSameMachine) {
    const std::vector<std::string> files = machine_files();
    ASSERT_GT(files.size(), 10U);
    for (const std::string& path : files) {
        SCOPED_TRACE(path);
        InputSet inputs;
        MachineFile first = read_machine(path, inputs);
        Specified text(machine_toml(first));
        const MachineFile second = read_machine("m.toml", text);
        EXPECT_EQ(machine_toml(second), machine_toml(first));
        EXPECT_EQ(not_in_machine_toml(second), "");
        EXPECT_EQ(first.kinematics.has_value(), second.kinematics.has_value());
        if (first.kinematics && second.kinematics) {
            EXPECT_EQ(first.kinematics->chain, second.kinematics->chain);
            EXPECT_EQ(first.kinematics->guess, second.kinematics->guess);
            EXPECT_EQ(first.kinematics->unspecified_pivots, second.kinematics->unspecified_pivots);
        }
        const verify::MachineDescription &a = first.machine, &b = second.machine;
        EXPECT_EQ(a.travel, b.travel);
        EXPECT_EQ(a.rotary_travel, b.rotary_travel);
        EXPECT_EQ(a.rapid, b.rapid);
        EXPECT_EQ(a.acceleration, b.acceleration);
        EXPECT_EQ(a.max_feed, b.max_feed);
        EXPECT_EQ(a.max_rpm, b.max_rpm);
        EXPECT_EQ(a.home, b.home);
        EXPECT_EQ(a.tool_change, b.tool_change);
        EXPECT_EQ(a.below_stock, b.below_stock);
        EXPECT_EQ(first.offsets, second.offsets);
        EXPECT_EQ(first.start, second.start);
        EXPECT_EQ(first.clamps.size(), second.clamps.size());
        // The sheets differ only by what the text leaves out.
        if (not_in_machine_toml(first).empty()) {
            EXPECT_EQ(machine_sheet(first), machine_sheet(second));
        }
    }
}

TEST(MachineText, NamesWhatItLeavesOut) {
    MachineFile file;
    EXPECT_EQ(not_in_machine_toml(file), "");
    file.machine.fixtures.resize(1);
    EXPECT_EQ(not_in_machine_toml(file), "1 fixture");
    file.machine.fixtures.resize(2);
    file.tools[1];
    EXPECT_EQ(not_in_machine_toml(file), "2 fixtures, limits of tools");
}

JobFile whole_job() {
    JobFile job;
    job.program = "a \"b\".nc";
    job.inches = true;
    job.dialect = gcode::Dialect::Fanuc;
    job.block_delete = true;
    job.variables = {{"#500", 1.5}, {"#<_depth>", -0.1}};
    job.compensation = {{1, 0.25}};
    job.allow = {"G187"};
    job.accept = {"stock-guess"};
    job.require = {"holder"};
    job.start = Vec3{1, 2, 0.1 + 0.2};
    job.offsets = {{1, {-100, -50, -300}}, {10, {1, 2, 3}}};
    job.stock.emplace();
    job.stock->box = {{0, 0, -10}, {40, 30, 0}};
    toolpath::ToolEntry& tool = job.tools.emplace_back();
    tool.spec.number = 7;
    tool.spec.kind = toolpath::ToolKind::BullNoseEndMill;
    tool.spec.diameter = 10, tool.spec.corner_radius = 1.0 / 3.0, tool.spec.length = 22;
    tool.spec.holder = {{28, 40, 15}};
    tool.spec.assumed = {"length"};
    tool.spec.description = "a \"long\" one";
    tool.offset = {0, 0, 120};
    verify::Fixture& fixture = job.fixtures.emplace_back();
    fixture.name = "jaw";
    fixture.box = {{50, 0, -10}, {60, 30, 5}};
    fixture.clearance_mm = 2;
    job.fixtures_specified = true;
    job.below_stock = 3.0;
    return job;
}

TEST(JobWriter, WritesWhatTheReaderReads) {
    const JobFile job = whole_job();
    JobRemarks remarks;
    remarks.stock = "a remark\nof two lines";
    remarks.tools = {{"first", "second\x01"}};
    remarks.unknown_tools = {};
    std::ostringstream out;
    write_job_file(out, job, remarks);
    const JobFile read = parse_job_file({"job.toml", out.str()});
    EXPECT_EQ(read.program, job.program);
    EXPECT_EQ(read.inches, job.inches);
    EXPECT_EQ(read.dialect, job.dialect);
    EXPECT_EQ(read.block_delete, job.block_delete);
    EXPECT_EQ(read.variables, job.variables);
    EXPECT_EQ(read.compensation, job.compensation);
    EXPECT_EQ(read.allow, job.allow);
    EXPECT_EQ(read.accept, job.accept);
    EXPECT_EQ(read.require, job.require);
    EXPECT_EQ(read.start, job.start) << "to the last bit";
    EXPECT_EQ(read.offsets, job.offsets);
    ASSERT_TRUE(read.stock);
    EXPECT_EQ(read.stock->box, job.stock->box);
    ASSERT_EQ(read.tools.size(), 1U);
    EXPECT_EQ(read.tools[0].spec, job.tools[0].spec);
    EXPECT_EQ(read.tools[0].offset, job.tools[0].offset);
    ASSERT_EQ(read.fixtures.size(), 1U);
    EXPECT_EQ(read.fixtures[0].box, job.fixtures[0].box);
    EXPECT_EQ(read.fixtures[0].clearance_mm, 2.0);
    EXPECT_TRUE(read.fixtures_specified);
    EXPECT_EQ(read.below_stock, 3.0);
    std::ostringstream again;
    write_job_file(again, read, remarks);
    EXPECT_EQ(parse_job_file({"job.toml", again.str()}).tools[0].spec, job.tools[0].spec);
}

TEST(JobWriter, ToolsOfEveryKindComeBack) {
    std::set<std::string_view> names;
    for (const auto& [name, kind] : kKindKeys) {
        EXPECT_TRUE(names.insert(name).second);
        JobFile job;
        toolpath::ToolSpec& spec = job.tools.emplace_back().spec;
        spec.number = 3;
        spec.kind = kind;
        double value = 8.0;
        for (const NamedValue& named : kValueKeys)
            spec.*named.value = value += 0.25;
        for (const NamedSegments& named : kSegmentKeys)
            spec.*named.value = {{value, value + 1, value + 2}};
        spec.corner_radius = 1.0, spec.tip_diameter = 2.0, spec.angle = 90.0, spec.taper = 10.0;
        std::ostringstream out;
        JobRemarks remarks;
        remarks.tools.resize(1);
        write_job_file(out, job, remarks);
        EXPECT_EQ(parse_job_file({"job.toml", out.str()}).tools.at(0).spec, spec) << name;
    }
}

TEST(JobWriter, ToolTableHasOffsetAndDiameterInTheUnit) {
    std::vector<toolpath::ToolEntry> tools(2);
    tools[0].spec.number = 1;
    tools[0].spec.kind = toolpath::ToolKind::BallEndMill;
    tools[0].spec.diameter = 12.7;
    tools[0].offset.z = 101.6;
    tools[1].spec.number = 12;
    tools[1].spec.kind = toolpath::ToolKind::Drill;
    tools[1].spec.diameter = 6.35;
    tools[1].spec.angle = 140.0;
    for (const bool inches : {false, true}) {
        std::ostringstream out;
        write_tool_table(out, tools, inches);
        EXPECT_TRUE(out.str().starts_with(inches ? "T1 P1 Z4 D0.5 ;" : "T1 P1 Z101.6 D12.7 ;"));
        const toolpath::ToolFile read = toolpath::read_tool_file({"tool.tbl", out.str()}, inches);
        ASSERT_EQ(read.tools.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(read.tools[i].spec.number, tools[i].spec.number);
            EXPECT_EQ(read.tools[i].spec.kind, tools[i].spec.kind);
            EXPECT_NEAR(read.tools[i].spec.diameter.value_or(0), *tools[i].spec.diameter, 1e-6);
            EXPECT_NEAR(read.tools[i].offset.z, tools[i].offset.z, 1e-6);
        }
        EXPECT_EQ(read.tools[1].spec.angle, 140.0);
    }
}

// --- Bodies of a machine ---

TEST(MachineBody, CornersMoveWithTheJointsInOrder) {
    MachineBody body;
    body.mesh.vertices = {{1, 0, 0}, {0, 2, 0}, {10, 0, 5}};
    machine::Values values{};
    EXPECT_EQ(corners_at(body, values), body.mesh.vertices) << "no joint";
    // The bed carries X, which carries C about X10 Y0.
    body.moved_by.joints = {machine::joint_of('X', false, {1, 0, 0}),
                            machine::joint_of('C', true, {0, 0, 1}, {10, 0, 0})};
    values[*machine::index_of('X')] = 100.0;
    values[*machine::index_of('C')] = 90.0;
    const std::vector<Vec3> moved = corners_at(body, values);
    const std::vector<Vec3> expected{{110, -9, 0}, {108, -10, 0}, {110, 0, 5}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(norm(moved[i] - expected[i]), 0.0, 1e-9);
        const Vec3 back = on_part(body.moved_by, values, moved[i]);
        EXPECT_NEAR(norm(back - body.mesh.vertices[i]), 0.0, 1e-9) << "the inverse";
    }
}

}  // namespace
}  // namespace ncsim::setup
