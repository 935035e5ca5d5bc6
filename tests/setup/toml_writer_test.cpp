// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing of TOML by a schema, and reading of each file that ncsim writes.
#include "files/toml_writer.h"

#include "ncsim/setup/job_file.h"
#include "ncsim/setup/job_writer.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/machine_text.h"

#include "files/schema.h"
#include "files/toml_reader.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::setup {
namespace {

constexpr std::string_view kSchema = R"({
  "properties": {
    "size": {"description": "size of it, mm", "type": "number"},
    "count": {"type": "integer"},
    "kind": {"description": "kind of it", "enum": ["flat", "ball", "v"]},
    "copy": {"$ref": "#/properties/size"},
    "at": {"type": "object", "properties": {"x": {"type": "number"}, "y": {"type": "number"}}},
    "rows": {"type": "array", "items": {"$ref": "#/definitions/row"}},
    "codes": {"description": "codes by number", "type": "object", "properties": {"M1": {"type": "string"}},
              "patternProperties": {"^M[0-9. ]+$": {"type": "string"}}},
    "stock": {"anyOf": [{"type": "object", "properties": {"min": {"type": "number"}}},
                        {"type": "object", "properties": {"turn": {"type": "string"}, "file": {"type": "string"}}}]}
  },
  "definitions": {"row": {"type": "object",
                          "properties": {"size": {"type": "number"},
                                         "parts": {"type": "array", "items": {"$ref": "#/definitions/row"}}}}}
})";

std::string text_of(const TomlSection& document, TomlStyle style = {}) {
    return toml_text(kSchema, document, style);
}

TEST(TomlWriter, WritesKeysInTheOrderOfTheSchemaBeforeTables) {
    TomlSection document;
    TomlSection& codes = document.table("codes");
    codes.set("M2 a. 3", "odd");
    codes.set("M9", "n\"i\n");
    codes.set("M1", "one");
    TomlSection& row = document.add("rows");
    row.add("parts").set("size", 3.0);
    row.set("size", -0.0);
    document.set("at", {{"y", 2.5}, {"x", 1.0}});
    document.set("kind", "v");
    document.set("count", 7);
    document.set("size", 60.0);
    EXPECT_THROW(text_of(document), std::logic_error) << "M2 a. 3 is no code";
    codes.entries.front().key = "M2. 3";
    EXPECT_EQ(text_of(document),
              "size = 60.0\ncount = 7\nkind = \"v\"\nat = { x = 1.0, y = 2.5 }\n"
              "\n[[rows]]\nsize = 0.0\n[[rows.parts]]\nsize = 3.0\n"
              "\n[codes]\nM1 = \"one\"\n\"M2. 3\" = \"odd\"\nM9 = \"n\\\"i\\n\"\n");
    EXPECT_EQ(text_of(document, {.blank_lines = false, .decimal_point = false}),
              "size = 60\ncount = 7\nkind = \"v\"\nat = { x = 1, y = 2.5 }\n"
              "[[rows]]\nsize = 0\n[[rows.parts]]\nsize = 3\n"
              "[codes]\nM1 = \"one\"\n\"M2. 3\" = \"odd\"\nM9 = \"n\\\"i\\n\"\n");
}

TEST(TomlWriter, RefusesKeysThatTheSchemaDoesNotHave) {
    const auto refuses = [](const std::function<void(TomlSection&)>& add) {
        TomlSection document;
        add(document);
        EXPECT_THROW(text_of(document), std::logic_error);
    };
    refuses([](TomlSection& d) { d.set("sise", 1.0); });
    refuses([](TomlSection& d) { d.set("at", TomlValue::object({{"z", 1.0}})); });
    refuses([](TomlSection& d) { d.table("at").set("z", 1.0); });
    refuses([](TomlSection& d) { d.add("rows").set("count", 1); });
    refuses([](TomlSection& d) { d.add("rows").add("parts").set("count", 1); });
    refuses([](TomlSection& d) { d.add("row").set("size", 1); });
    refuses([](TomlSection& d) { d.set("rows", {TomlValue::object({{"count", 1}})}); });
    refuses([](TomlSection& d) { d.table("stock").set("size", 1.0); });
    // A key that only the user may switch on is checked, too.
    refuses([](TomlSection& d) { d.set("sise", 1.0).is_off = true; });
    refuses([](TomlSection& d) {
        TomlSection& stock = d.table("stock");
        stock.set("min", 1.0);
        stock.set("file", "a.stl");
    });
}

TEST(TomlWriter, ChoosesTheAlternativeThatHasTheKeys) {
    TomlSection document;
    TomlSection& stock = document.table("stock");
    stock.set("file", "a.stl");
    stock.set("turn", "X90");
    EXPECT_EQ(text_of(document), "[stock]\nturn = \"X90\"\nfile = \"a.stl\"\n");
}

TEST(TomlWriter, WritesCommentsAndSentencesOfTheSchema) {
    TomlSection document;
    document.comments = {":schema a.json", "", "First."};
    document.set("size", 1.0).describes = true;
    document.set("copy", 1.0).describes = true;
    TomlEntry& kind = document.set("kind", "v");
    kind.above = {"Choose:"};
    kind.describes = kind.is_off = true;
    document.set("count", 2).comment = "two";
    TomlSection& codes = document.table("codes");
    codes.describes = codes.is_off = true;
    codes.above = {"Codes."};
    codes.comments = {"None."};
    codes.set("M1", "a");
    EXPECT_EQ(text_of(document),
              "#:schema a.json\n#\n# First.\nsize = 1.0  # size of it, mm\ncount = 2  # two\n"
              "# Choose:\n#kind = \"v\"  # kind of it (flat, ball, v)\n"
              "copy = 1.0  # size of it, mm\n"
              "\n# Codes.\n#[codes]  # codes by number\n## None.\n#M1 = \"a\"\n");
}

TEST(TomlWriter, LeavesOutEmptyValuesWhereAsked) {
    TomlSection document;
    document.set_filled("kind", "");
    document.set_filled("at", TomlValue());
    document.set_filled("rows", TomlValue::array());
    document.set_filled("count", 0);
    EXPECT_EQ(text_of(document), "count = 0\n");
}

// --- Files that ncsim writes ---

// Returns the text without the sign # before keys and heads of tables.
std::string switched_on(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const bool is_form = line.starts_with("#[") || (line.size() > 1 && line[0] == '#' &&
                                                        line[1] >= 'a' && line[1] <= 'z');
        result += line.substr(is_form ? 1 : 0) + '\n';
    }
    return result;
}

JobFile job_with_all() {
    JobFile job;
    job.program = "part.nc";
    job.settings = {{"machine", {"mill.toml"}, false, true, {}}};
    job.inches = true;
    job.dialect = gcode::Dialect::Haas;
    job.units_assumed = job.dialect_assumed = true;
    job.strict = true;
    job.increments = false;
    job.block_delete = true;
    job.variables = {{"#500", 1.5}, {"#<_depth>", -0.1}};
    job.compensation = {{1, 0.25}, {12, 0.0}};
    job.allow = {"G187"};
    job.accept = {"stock-guess"};
    job.require = {"holder"};
    job.start = Vec3{1, 2, 3};
    job.below_stock = 3.0;
    job.offsets = {{1, {-100, -50, -300}}, {7, {1, 0, 0}}, {16, {1, 2, 3}}};
    job.stock.emplace().box = {{0, 0, -10}, {40, 10, 0}};
    job.stock->is_round = true;
    job.stock->axis = 0;
    job.stock_assumed = job.stock_place_assumed = true;
    toolpath::ToolEntry& tool = job.tools.emplace_back();
    tool.spec.number = 7;
    tool.spec.kind = toolpath::ToolKind::Other;
    tool.spec.diameter = 10;
    tool.spec.description = "a form";
    tool.spec.assumed = {"length"};
    tool.spec.holder = {{28, 40, 15}};
    tool.spec.pieces = {{{{0, 0, 0}, {5, 5, 0}, {5, 20, 0}}, true}};
    tool.offset = {0, 0, 120};
    verify::Fixture& fixture = job.fixtures.emplace_back();
    fixture.name = "jaw";
    fixture.system = 16;
    fixture.clearance_mm = 2;
    fixture.box = {{50, 0, -10}, {60, 30, 5}};
    job.fixtures_specified = true;
    return job;
}

JobRemarks remarks_of(const JobFile& job) {
    JobRemarks remarks;
    remarks.stock = "line 3";
    remarks.tools.resize(job.tools.size(), {"line 4"});
    remarks.unknown_tools = {{3, 17}};
    return remarks;
}

TEST(WrittenFiles, JobHasTheBytesThatItsReaderReads) {
    const JobFile job = job_with_all();
    std::ostringstream out;
    write_job_file(out, job, remarks_of(job));
    const std::string text = out.str();
    const std::string body = text.substr(text.find("version"));
    EXPECT_EQ(
        body,
        "version = 2\nassumed = [\"units\", \"dialect\"]\nprogram = \"part.nc\"\n"
        "machine = \"mill.toml\"\nunits = \"inch\"  # unit of programs without G20 and G21\n"
        "dialect = \"haas\"\nstrict = true\nincrements = false\nblock_delete = true\n"
        "allow = [\"G187\"]\naccept = [\"stock-guess\"]\nrequire = [\"holder\"]\n"
        "start = [1.0, 2.0, 3.0]  # position of the tool when the program starts, in G54, mm\n"
        "below_stock = 3.0\n"
        "\n[offsets]\nG54 = [-100.0, -50.0, -300.0]\n\"G59.1\" = [1.0, 0.0, 0.0]\n"
        "\"G54.1 P7\" = [1.0, 2.0, 3.0]\n"
        "\n[variables]\n\"#500\" = 1.5\n\"#<_depth>\" = -0.1\n"
        "\n[compensation]  # radii of G41 and G42 in the registers D, mm; 0: wear only\n"
        "D1 = 0.25\nD12 = 0.0\n"
        "\n[stock]\n# line 3\nassumed = [\"size\", \"place\"]\nmin = [0.0, 0.0, -10.0]\n"
        "max = [40.0, 10.0, 0.0]\nround = true\naxis = \"X\"\n"
        "\n# line 4\n[[tool]]\nnumber = 7\nassumed = [\"length\"]\nkind = \"form\"\n"
        "diameter = 10.0\nholder = [[28.0, 40.0, 15.0]]\noffset = [0.0, 0.0, 120.0]\n"
        "description = \"a form\"\n[[tool.piece]]\ncutting = true\n"
        "profile = [[0.0, 0.0, 0.0], [5.0, 5.0, 0.0], [5.0, 20.0, 0.0]]\n"
        "\n# tool 3 moves from line 17 on and is not described: fill in\n"
        "#[[tool]]\n#number = 3\n#kind = \"flat\"\n#diameter = 10.0\n"
        "\n[[fixture]]\nname = \"jaw\"\noffset = \"G54.1 P7\"\nclearance = 2.0\n"
        "box = [[50.0, 0.0, -10.0], [60.0, 30.0, 5.0]]\n");
    const JobFile read = parse_job_file({"job.toml", switched_on(text)});
    EXPECT_EQ(read.offsets, job.offsets);
    EXPECT_EQ(read.compensation, job.compensation);
    EXPECT_EQ(read.variables, job.variables);
    EXPECT_TRUE(read.units_assumed && read.dialect_assumed && read.stock_place_assumed);
    EXPECT_EQ(read.increments, job.increments);
    ASSERT_EQ(read.tools.size(), 2U);
    EXPECT_EQ(read.tools[0].spec, job.tools[0].spec);
    EXPECT_EQ(read.tools[1].spec.number, 3);
    ASSERT_EQ(read.fixtures.size(), 1U);
    EXPECT_EQ(read.fixtures[0].system, 16);
}

TEST(WrittenFiles, JobWithAStockFileAndWithoutFixturesIsRead) {
    JobFile job;
    job.stock.emplace().from.emplace();
    job.stock->from->path = "stock.stl";
    job.stock->from->turn = "X90";
    job.stock->from->move = {1, 2, 3};
    job.fixtures_specified = true;
    std::ostringstream out;
    write_job_file(out, job, {.stock = "--stock", .tools = {}, .unknown_tools = {}});
    const JobFile read = parse_job_file({"job.toml", out.str()});
    ASSERT_TRUE(read.stock && read.stock->from);
    EXPECT_EQ(read.stock->from->turn, "X90");
    EXPECT_EQ(read.stock->from->move, job.stock->from->move);
    EXPECT_TRUE(read.fixtures_specified);
    EXPECT_TRUE(read.fixtures.empty());
}

TEST(WrittenFiles, FirstJobIsReadAgainAlsoWithItsForms) {
    const JobFile file = job_with_all();
    const std::vector<FirstSetUp> set_ups{{"front", "a.nc", "G59.1", {0, 0, 100}, true, 10.0},
                                          {"back", "b.nc", "G54.1 P7", {}, false, 10.0}};
    std::ostringstream out;
    write_first_job(out, file, remarks_of(file), set_ups);
    const JobFile read = parse_job_file({"job.toml", out.str()});
    ASSERT_EQ(read.set_ups.size(), 2U);
    EXPECT_EQ(read.set_ups[1].turn, "X180");
    EXPECT_EQ(read.set_ups[1].move, (Vec3{0, 0, -10}));
    EXPECT_EQ(read.set_ups[0].start, (Vec3{0, 0, 100}));
    EXPECT_TRUE(read.set_ups[0].fixtures_specified);
    EXPECT_TRUE(read.settings.empty());
    std::string complete = switched_on(out.str());
    constexpr std::string_view kNone = "\nfixture = []";
    for (std::size_t at = 0; (at = complete.find(kNone, at)) != std::string::npos;)
        complete.erase(at, kNone.size());
    const JobFile whole = parse_job_file({"job.toml", complete});
    EXPECT_EQ(whole.set_ups.at(0).offsets, (std::map<int, Vec3>{{7, {-250, -200, -300}}}));
    EXPECT_EQ(whole.set_ups.at(1).offsets, (std::map<int, Vec3>{{16, {-250, -200, -300}}}));
    // Two jaws; the arm, the heel and the bolt of the clamp.
    EXPECT_EQ(whole.set_ups[0].fixtures.size(), 5U);
    EXPECT_EQ(whole.outputs.at("step"), "part.step");
    ASSERT_EQ(whole.settings.size(), 1U);
    EXPECT_EQ(whole.settings[0].option, "machine");
}

TEST(WrittenFiles, FirstProjectFollowsItsSchemaAlsoWithItsForms) {
    std::ostringstream out;
    write_first_project(out, {"a \"b\"\\c", "parts"});
    const std::string text = out.str();
    for (const std::string& one : {text, switched_on(text)})
        EXPECT_NO_THROW(TomlReader("ncsim.toml", one, kProjectSchema)) << one;
    const TomlReader reader("ncsim.toml", switched_on(text));
    const toml::array& programs = *reader.root()["program"].as_array();
    ASSERT_EQ(programs.size(), 2U);
    const auto files = programs[0].as_table()->get("files")->as_array();
    EXPECT_EQ(files->at(0).value<std::string>(), "a \"b\"\\c/*");
    EXPECT_TRUE(text.find("#max-time = 600  # seconds for a program, after which") !=
                std::string::npos)
        << text;
}

constexpr const char* kMachine = R"(name = "mill \"A\""
assumed = "direction of the table"
below_stock = 2
path_deviation = 0.05
fixture = []
clamps = { A = ["M10", "M11"], C = ["M12", "M13"] }
control = { m_codes = { M428 = "tip", M429 = "axes" }, kinematics = ["axes", "tip"], at_start = "tip", tip_frame = "table", tip_frame_at = "zero", orient = "positive", fixture_offsets = { P1 = { offset = [1, 2, 3], at = { A = 30 } } }, fixture_offset_moves = true, setting_errors = { P2 = { offset = [0, 0, 0.1], at = {}, turns = [0, 0, 1.5] } }, setting_error_moves = false, setting_error_turns_axes = true }
part = { link = "C" }
[travel]
x = [-300, 300]
z = [-450, 0]
[rapid]
y = 12000
[acceleration]
z = 800.5
[spindle]
link = "Z"
min = 50
max = 12000
[feed]
max = 5000
[position]
home = [0, 0, 0]
tool_change = [-1, -2, 0]
start = [0, 0, 3]
[time]
tool_change = 6
junction_deviation = 0.02
[offsets]
G54 = [4, 5, 6]
"G54.1 P7" = [-1, 0, 2.5]
[[link]]
name = "bench"
[[link]]
name = "A"
axis = "A"
turns_about = [-1, 0, 0]
through = [0, 0, -320]
travel = [-40, 30]
[[link]]
name = "C"
parent = "A"
axis = "C"
turns_about = [0, 0, -1]
through = [0, 0, 0]
way = "shortest"
[[link]]
name = "X"
axis = "X"
moves_along = [1, 0, 0]
[[link]]
name = "Y"
parent = "X"
axis = "Y"
moves_along = [0, 1, 0]
[[link]]
name = "Z"
parent = "Y"
axis = "Z"
moves_along = [0, 0, 1]
)";

class OneFile : public InputSet {
public:
    explicit OneFile(std::string text) : text_(std::move(text)) {}
    std::string read(const std::string&, std::uintmax_t) override { return text_; }

private:
    std::string text_;
};

TEST(WrittenFiles, MachineHasTheBytesThatItsReaderReads) {
    OneFile file(kMachine);
    EXPECT_EQ(machine_toml(read_machine("m.toml", file)), kMachine);
    OneFile straight("way = { A = \"sign\", C = \"positive\" }\n[position]\nstart = [0, 0, 1]\n");
    EXPECT_EQ(machine_toml(read_machine("m.toml", straight)),
              "way = { A = \"sign\", C = \"positive\" }\n[position]\nstart = [0, 0, 1]\n");
}

}  // namespace
}  // namespace ncsim::setup
