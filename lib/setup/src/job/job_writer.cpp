// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes job files and project files.
#include "ncsim/setup/job_writer.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/setup/coordinate_systems.h"

#include "files/schema.h"
#include "files/toml_text.h"
#include "files/toml_writer.h"
#include "job/job_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

using toolpath::ToolKind;
using toolpath::ToolSpec;

// Returns the text of a comment: one line of UTF-8.
std::string remark(const std::string& text) {
    const std::string line = json_string(one_line(text));
    return line.substr(1, line.size() - 2);
}

std::string_view key_of(ToolKind kind) {
    return std::find_if(std::begin(kKindKeys), std::end(kKindKeys),
                        [kind](const auto& k) { return k.second == kind; })
        ->first;
}

// Adds the assumed values of the whole job to `assumed`.
std::vector<std::string> assumed_of(const JobFile& file, std::vector<std::string> assumed) {
    if (file.units_assumed) assumed.emplace_back("units");
    if (file.dialect_assumed) assumed.emplace_back("dialect");
    return assumed;
}

// Adds what is common to a written job and a first job. `assumed`: in addition to the values of
// `file`.
void add_head(TomlSection& job, const JobFile& file, std::vector<std::string> assumed) {
    job.set("version", kJobVersion);
    job.set_filled("assumed", assumed_of(file, std::move(assumed)));
    job.set("units", file.inches.value_or(false) ? "inch" : "mm").describes = true;
    job.set("dialect", gcode::name_of(file.dialect.value_or(gcode::Dialect::Auto)));
}

// Returns lists of three numbers.
template <class Element>
TomlValue triples(const std::vector<Element>& elements, Vec3 (*three)(const Element&)) {
    TomlValue all = TomlValue::array();
    for (const Element& element : elements)
        all.push_back(toml_value(three(element)));
    return all;
}

void add_tool(TomlSection& tool, const ToolSpec& spec, Vec3 offset) {
    tool.set("number", spec.number);
    tool.set_filled("assumed", spec.assumed);
    if (spec.kind) tool.set("kind", key_of(*spec.kind));
    for (const NamedValue& named : kValueKeys)
        if (const auto& value = spec.*named.value) tool.set(named.name, *value);
    for (const NamedSegments& named : kSegmentKeys) {
        tool.set_filled(named.name,
                        triples<toolpath::ToolSegment>(spec.*named.value, [](const auto& s) {
                            return Vec3{s.lower_diameter, s.upper_diameter, s.height};
                        }));
    }
    if (!(offset == Vec3{})) tool.set("offset", toml_value(offset));
    tool.set_filled("description", spec.description);
    for (const toolpath::ToolPiece& piece : spec.pieces) {
        TomlSection& one = tool.add("piece");
        one.set("cutting", piece.cutting);
        one.set("profile", triples<toolpath::ProfilePoint>(piece.profile, [](const auto& p) {
                    return Vec3{p.radius, p.height, p.fillet};
                }));
    }
}

void add_stock(TomlSection& table, const JobFile& file) {
    const toolpath::Stock& stock = *file.stock;
    if (stock.from) {
        table.set("file", stock.from->path);
        table.set_filled("turn", stock.from->turn);
        if (!(stock.from->move == Vec3{})) table.set("move", toml_value(stock.from->move));
        return;
    }
    std::vector<std::string> assumed;
    if (file.stock_assumed) assumed.emplace_back("size");
    if (file.stock_place_assumed) assumed.emplace_back("place");
    table.set_filled("assumed", assumed);
    table.set("min", toml_value(stock.box.min));
    table.set("max", toml_value(stock.box.max));
    if (stock.is_round) table.set("round", true);
    if (stock.axis != 2) table.set("axis", std::string(1, "XYZ"[stock.axis]));
}

// Requires: no fixture is a mesh.
void add_fixtures(TomlSection& job, const JobFile& file) {
    if (file.fixtures_specified && file.fixtures.empty()) job.set("fixture", TomlValue::array());
    for (const verify::Fixture& fixture : file.fixtures) {
        TomlSection& one = job.add("fixture");
        one.set("name", fixture.name);
        if (fixture.system != 0) one.set("offset", name_of_system(fixture.system));
        if (fixture.clearance_mm > 0.0) one.set("clearance", fixture.clearance_mm);
        one.set("box", {toml_value(fixture.box.min), toml_value(fixture.box.max)});
    }
}

void add_stock_and_tools(TomlSection& job, const JobFile& file, const JobRemarks& remarks) {
    if (file.stock) {
        TomlSection& stock = job.table("stock");
        stock.comments.push_back(remark(remarks.stock));
        add_stock(stock, file);
    }
    for (std::size_t i = 0; i < file.tools.size(); ++i) {
        TomlSection& tool = job.add("tool");
        tool.above.resize(remarks.tools.at(i).size());
        std::ranges::transform(remarks.tools[i], tool.above.begin(), remark);
        add_tool(tool, file.tools[i].spec, file.tools[i].offset);
    }
    for (const auto& [number, line] : remarks.unknown_tools) {
        TomlSection& tool = job.add("tool");
        tool.above.push_back(fmt::format(
            "tool {} moves from line {} on and is not described: fill in", number, line));
        tool.is_off = true;
        tool.set("number", number);
        tool.set("kind", "flat");
        tool.set("diameter", 10.0);
    }
}

// Adds examples of fixtures, for the user to complete.
void add_fixture_forms(TomlSection& set_up) {
    TomlEntry& none = set_up.set("fixture", TomlValue::array());
    none.above = {"Fixtures, in the frame of the program. None: keep the empty list."};
    TomlSection& vise = set_up.add("fixture");
    vise.comment = "instead of fixture = []";
    vise.set("vise", {{"at", {0, 0, -40}},
                      {"along", "Y"},
                      {"opening", 50},
                      {"jaw_width", 120},
                      {"jaw_height", 30},
                      {"jaw_depth", 25}});
    TomlSection& clamp = set_up.add("fixture");
    clamp.set("clamp", {{"at", {-40, 0, 0}},
                        {"toward", "-X"},
                        {"length", 80},
                        {"width", 25},
                        {"height", 15},
                        {"table", -20},
                        {"heel", 20},
                        {"bolt", {40, 20, 18}}});
    vise.is_off = clamp.is_off = true;
}

// `is_first`: the first set-up of the job.
void add_set_up(TomlSection& job, const FirstSetUp& set_up, bool is_first) {
    TomlSection& table = job.add("setup");
    table.set("name", set_up.name);
    table.set("program", set_up.program);
    std::vector<std::string> open{"fixtures"};
    if (!set_up.start_is_specified) open.insert(open.begin(), "start");
    if (!is_first) open.emplace_back("place");
    table.set("assumed", open);
    if (!is_first) {
        table.set("turn", "X180").above = {
            std::string("Position of the part: the part of the last set-up, turned about its zero, "
                        "then moved.")};
        table.set("move", toml_value({0.0, 0.0, -set_up.height}));
    }
    table.set("start", toml_value(set_up.start)).above = {
        "Position of the tool when the program starts, from the zero of G54."};
    TomlEntry& offsets = table.set(
        "offsets", TomlValue::object({{set_up.zero, toml_value({-250.0, -200.0, -300.0})}}));
    offsets.above = {fmt::format(
        "Origin of {} in machine coordinates, from the offset table of the control.", set_up.zero)};
    offsets.is_off = true;
    add_fixture_forms(table);
}

}  // namespace

void write_job_file(std::ostream& out, const JobFile& file, const JobRemarks& remarks) {
    TomlSection job;
    job.comments = {fmt::format("Written by ncsim {}: what a program stood on. Lengths in mm, "
                                "angles in degrees.",
                                kVersion),
                    std::string("Values that are named in a list \"assumed\" were not specified: "
                                "correct them and remove the name.")};
    add_head(job, file, {});
    job.set_filled("program", file.program);
    for (const OptionSetting& setting : file.settings)
        job.set(setting.option, setting.values.at(0));
    if (file.strict) job.set("strict", true);
    if (file.increments) job.set("increments", *file.increments);
    if (file.block_delete) job.set("block_delete", *file.block_delete);
    job.set_filled("allow", file.allow);
    job.set_filled("accept", file.accept);
    job.set_filled("require", file.require);
    if (file.start) job.set("start", toml_value(*file.start)).describes = true;
    if (file.below_stock) job.set("below_stock", *file.below_stock);
    const auto add_table = [&job](const char* name, const auto& values, const auto& key,
                                  const auto& value) -> TomlSection* {
        if (values.empty()) return nullptr;
        TomlSection& table = job.table(name);
        for (const auto& [number, one] : values)
            table.set(key(number), value(one));
        return &table;
    };
    add_table("offsets", file.offsets, name_of_system, toml_value);
    add_table("variables", file.variables, std::identity(), std::identity());
    const auto name_of_register = [](int number) { return fmt::format("D{}", number); };
    if (TomlSection* const radii =
            add_table("compensation", file.compensation, name_of_register, std::identity()))
        radii->describes = true;
    add_stock_and_tools(job, file, remarks);
    add_fixtures(job, file);
    out << toml_text(kJobSchema, job, {});
}

void write_tool_table(std::ostream& out, const std::vector<toolpath::ToolEntry>& tools,
                      bool inches) {
    const double unit = inches ? 25.4 : 1.0;
    for (const toolpath::ToolEntry& entry : tools) {
        const ToolSpec& spec = entry.spec;
        constexpr double kAnyLength = 50.0;
        const double diameter =
            toolpath::cutting_diameter_of(toolpath::make_tool(spec, kAnyLength));
        std::string remark(toolpath::name_of(spec.kind.value_or(ToolKind::FlatEndMill)));
        if (spec.corner_radius) remark += fmt::format(" R{:.6g}mm", *spec.corner_radius);
        if (spec.angle) remark += fmt::format(" {:.6g} deg", *spec.angle);
        if (spec.tip_diameter) remark += fmt::format(" tip {:.6g}mm", *spec.tip_diameter);
        if (spec.pitch) remark += fmt::format(" pitch {:.6g}mm", *spec.pitch);
        if (!spec.description.empty()) remark += ", " + one_line(spec.description);
        out << fmt::format("T{0} P{0} Z{1:.9g} D{2:.9g} ;{3}\n", spec.number, entry.offset.z / unit,
                           diameter / unit, remark);
    }
}

void write_first_job(std::ostream& out, const JobFile& file, const JobRemarks& remarks,
                     const std::vector<FirstSetUp>& set_ups) {
    TomlSection job;
    job.comments = {
        ":schema /usr/share/doc/ncsim/docs/schemas/job.schema.json",
        "Written by ncsim init. Lengths in mm, angles in degrees.", "",
        std::string(
            "A name in a list \"assumed\" stands for a value that no file specifies. Measure "
            "the value at"),
        std::string(
            "the machine, correct it here, and remove the name. Until then ncsim check says "
            "\"not proven\".")};
    add_head(job, file, {"machine"});
    job.entries.back().describes = true;  // the dialect
    const auto form = [&job](const char* key, TomlValue value, const char* comment) {
        TomlEntry& entry = job.set(key, std::move(value));
        entry.above = {comment};
        entry.is_off = true;
    };
    form("machine", "mill.toml",
         "The machine: travels, rates, kinematics. Without a machine, remove the name above.");
    form("require", {"holder", "fixtures", "travels", "offsets"},
         "What has to be known for a clean check:");
    form("outputs", {{"png", "part.png"}, {"step", "part.step"}},
         "Files of ncsim run, below the folder of this file:");
    add_stock_and_tools(job, file, remarks);
    if (file.stock) {
        job.tables.front().above = {
            std::string("Measure the blank. Its corners are in the frame of the first set-up: "
                        "distances from the"),
            "program zero. A file: file = \"blank.stl\"."};
    }
    for (const FirstSetUp& set_up : set_ups)
        add_set_up(job, set_up, &set_up == &set_ups.front());
    out << toml_text(kJobSchema, job, {});
}

void write_first_project(std::ostream& out, const std::set<std::string>& folders) {
    TomlSection project;
    project.comments = {
        ":schema /usr/share/doc/ncsim/docs/schemas/project.schema.json",
        "Written by ncsim init: options for all NC programs in this folder and below.",
        "A key is a long option of ncsim check. The command line and job files come first."};
    project.set("version", 1);
    const auto form = [&project](const char* key, TomlValue value) -> TomlEntry& {
        TomlEntry& entry = project.set(key, std::move(value));
        entry.is_off = true;
        return entry;
    };
    form("machine", "machines/mill.toml").comment = "relative to this file";
    form("require", {"holder", "fixtures"});
    form("max-time", 600).describes = true;
    for (const std::string& folder : folders) {
        TomlSection& programs = project.add("program");
        programs.is_off = true;
        programs.set("files", TomlValue::array({folder + "/*"}));
        programs.set("job", "job.toml");
    }
    out << toml_text(kProjectSchema, project, {});
}

}  // namespace ncsim::setup
