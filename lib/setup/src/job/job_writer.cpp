// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes job files.
#include "ncsim/setup/job_writer.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/setup/coordinate_systems.h"

#include "files/toml_text.h"
#include "job/job_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

// Forms of a first job: the beginning, and a set-up.
extern const std::string_view kFirstJob, kFirstSetUp;

namespace {

using toolpath::ToolKind;
using toolpath::ToolSpec;

// Returns the shortest text that reads back as the same number; always a TOML float.
std::string number(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string triple(Vec3 v) {
    return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
}

// Returns a comment line.
std::string remark(const std::string& text) {
    std::string line = one_line(text);
    // Comments must be UTF-8, too.
    line = json_string(line);
    return fmt::format("# {}\n", line.substr(1, line.size() - 2));
}

std::string_view key_of(ToolKind kind) {
    return std::find_if(std::begin(kKindKeys), std::end(kKindKeys),
                        [kind](const auto& k) { return k.second == kind; })
        ->first;
}

// Returns the line of a list of texts; empty for an empty list.
std::string list_line(const char* key, const std::vector<std::string>& words) {
    std::vector<std::string> texts(words.size());
    std::ranges::transform(words, texts.begin(), quoted);
    return words.empty() ? "" : fmt::format("{} = [{}]\n", key, fmt::join(texts, ", "));
}

// Adds the assumed values of the whole job to `assumed`.
std::vector<std::string> assumed_of(const JobFile& file, std::vector<std::string> assumed) {
    if (file.units_assumed) assumed.emplace_back("units");
    if (file.dialect_assumed) assumed.emplace_back("dialect");
    return assumed;
}

const char* units_of(const JobFile& file) {
    return file.inches.value_or(false) ? "inch" : "mm";
}

std::string_view dialect_of(const JobFile& file) {
    return gcode::name_of(file.dialect.value_or(gcode::Dialect::Auto));
}

// Returns the keys of a part that is turned over after the previous set-up. `height`: of the stock.
std::string turned_over(double height) {
    return fmt::format(
        "# Position of the part: the part of the last set-up, turned about its zero, then moved.\n"
        "turn = \"X180\"\nmove = {}\n",
        triple({0.0, 0.0, -height}));
}

void write_tool(std::ostream& out, const ToolSpec& spec, Vec3 offset) {
    out << "[[tool]]\nnumber = " << spec.number << '\n';
    out << list_line("assumed", spec.assumed);
    if (spec.kind) out << "kind = \"" << key_of(*spec.kind) << "\"\n";
    for (const NamedValue& named : kValueKeys) {
        if (const auto& value = spec.*named.value) {
            out << named.name << " = " << number(*value) << '\n';
        }
    }
    for (const NamedSegments& named : kSegmentKeys) {
        const auto& segments = spec.*named.value;
        if (segments.empty()) continue;
        out << named.name << " = [";
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const toolpath::ToolSegment& step = segments[i];
            out << (i == 0 ? "" : ", ")
                << triple({step.lower_diameter, step.upper_diameter, step.height});
        }
        out << "]\n";
    }
    if (!(offset == Vec3{})) out << "offset = " << triple(offset) << '\n';
    if (!spec.description.empty()) out << "description = " << quoted(spec.description) << '\n';
    for (const toolpath::ToolPiece& piece : spec.pieces) {
        out << "[[tool.piece]]\ncutting = " << (piece.cutting ? "true" : "false")
            << "\nprofile = [";
        for (std::size_t i = 0; i < piece.profile.size(); ++i) {
            const toolpath::ProfilePoint& p = piece.profile[i];
            out << (i == 0 ? "" : ", ") << triple({p.radius, p.height, p.fillet});
        }
        out << "]\n";
    }
}

void write_stock(std::ostream& out, const toolpath::Stock& stock) {
    if (!stock.from) {
        out << "min = " << triple(stock.box.min) << "\nmax = " << triple(stock.box.max) << '\n'
            << (stock.is_round ? "round = true\n" : "");
        if (stock.axis != 2)
            out << "axis = \""
                << "XYZ"[stock.axis] << "\"\n";
        return;
    }
    out << "file = " << quoted(stock.from->path) << '\n';
    if (!stock.from->turn.empty()) out << "turn = " << quoted(stock.from->turn) << '\n';
    if (!(stock.from->move == Vec3{})) out << "move = " << triple(stock.from->move) << '\n';
}

// Requires: no fixture is a mesh.
void write_fixtures(std::ostream& out, const std::vector<verify::Fixture>& fixtures) {
    for (const verify::Fixture& fixture : fixtures) {
        out << "\n[[fixture]]\nname = " << quoted(fixture.name) << '\n';
        if (fixture.system != 0)
            out << "offset = " << quoted(name_of_system(fixture.system)) << '\n';
        if (fixture.clearance_mm > 0.0)
            out << "clearance = " << number(fixture.clearance_mm) << '\n';
        out << "box = [" << triple(fixture.box.min) << ", " << triple(fixture.box.max) << "]\n";
    }
}

void write_stock_and_tools(std::ostream& out, const JobFile& file, const JobRemarks& remarks) {
    if (file.stock) {
        out << "\n[stock]\n" << remark(remarks.stock);
        std::vector<std::string> assumed_of_stock;
        if (file.stock_assumed) assumed_of_stock.emplace_back("size");
        if (file.stock_place_assumed) assumed_of_stock.emplace_back("place");
        out << list_line("assumed", assumed_of_stock);
        write_stock(out, *file.stock);
    }
    for (std::size_t i = 0; i < file.tools.size(); ++i) {
        out << '\n';
        for (const std::string& line : remarks.tools.at(i))
            out << remark(line);
        write_tool(out, file.tools[i].spec, file.tools[i].offset);
    }
    for (const auto& [number, line] : remarks.unknown_tools) {
        out << '\n'
            << remark(fmt::format("tool {} moves from line {} on and is not described: fill in",
                                  number, line))
            << "#[[tool]]\n#number = " << number << "\n#kind = \"flat\"\n#diameter = 10.0\n";
    }
}

}  // namespace

void write_job_file(std::ostream& out, const JobFile& file, const JobRemarks& remarks) {
    out << "# Written by ncsim " << kVersion
        << ": what a program stood on. Lengths in mm, angles in degrees.\n"
        << "# Values that are named in a list \"assumed\" were not specified: correct them and "
           "remove the name.\n"
        << "version = " << kJobVersion << '\n';
    out << list_line("assumed", assumed_of(file, {}));
    if (!file.program.empty()) out << "program = " << quoted(file.program) << '\n';
    for (const OptionSetting& setting : file.settings)
        out << setting.option << " = " << quoted(setting.values.at(0)) << '\n';
    out << "units = \"" << units_of(file)
        << "\"  # where neither G20 nor G21 stands before the first length\ndialect = \""
        << dialect_of(file) << "\"\n";
    if (file.strict) out << "strict = true\n";
    const auto flag = [&out](const char* key, const std::optional<bool>& value) {
        if (value) out << key << (*value ? " = true\n" : " = false\n");
    };
    flag("increments", file.increments);
    flag("block_delete", file.block_delete);
    out << list_line("allow", file.allow);
    out << list_line("accept", file.accept);
    out << list_line("require", file.require);
    if (file.start) out << "start = " << triple(*file.start) << "  # in G54\n";
    if (file.below_stock) out << "below_stock = " << number(*file.below_stock) << '\n';
    if (file.fixtures_specified && file.fixtures.empty()) out << "fixture = []\n";
    if (!file.offsets.empty()) {
        out << "\n[offsets]\n";
        for (const auto& [system, origin] : file.offsets)
            out << quoted(name_of_system(system)) << " = " << triple(origin) << '\n';
    }
    if (!file.variables.empty()) {
        out << "\n[variables]\n";
        for (const auto& [name, value] : file.variables)
            out << quoted(name) << " = " << number(value) << '\n';
    }
    if (!file.compensation.empty()) {
        out << "\n[compensation]  # radii of G41 and G42, mm\n";
        for (const auto& [d, radius] : file.compensation)
            out << 'D' << d << " = " << number(radius) << '\n';
    }
    write_stock_and_tools(out, file, remarks);
    write_fixtures(out, file.fixtures);
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
    out << fmt::format(fmt::runtime(kFirstJob), fmt::arg("version", kJobVersion),
                       fmt::arg("assumed", list_line("assumed", assumed_of(file, {"machine"}))),
                       fmt::arg("units", units_of(file)), fmt::arg("dialect", dialect_of(file)));
    if (file.stock) {
        out << "\n# Measure the blank. Its corners are in the frame of the first set-up: distances "
               "from the\n# program zero. A file: file = \"blank.stl\".";
    }
    write_stock_and_tools(out, file, remarks);
    for (const FirstSetUp& set_up : set_ups) {
        const bool is_first = &set_up == &set_ups.front();
        std::vector<std::string> open;
        if (!set_up.start_is_specified) open.emplace_back("start");
        open.emplace_back("fixtures");
        if (!is_first) open.emplace_back("place");
        const bool is_key = set_up.zero.find(' ') == std::string::npos;
        out << fmt::format(fmt::runtime(kFirstSetUp), fmt::arg("name", quoted(set_up.name)),
                           fmt::arg("program", quoted(set_up.program)),
                           fmt::arg("assumed", list_line("assumed", open)),
                           fmt::arg("start", triple(set_up.start)),
                           fmt::arg("place", is_first ? std::string() : turned_over(set_up.height)),
                           fmt::arg("zero", set_up.zero),
                           fmt::arg("key", is_key ? set_up.zero : quoted(set_up.zero)));
    }
}

}  // namespace ncsim::setup
