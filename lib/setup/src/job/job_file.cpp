// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading and writing of job files.
#include "ncsim/setup/job_file.h"

#include "ncsim/report/file_names.h"
#include "ncsim/report/json_string.h"
#include "ncsim/report/plain_text.h"
#include "ncsim/report/version.h"
#include "ncsim/setup/coordinate_systems.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/setup.h"

#include "files/toml_reader.h"
#include "files/toml_text.h"
#include "files/tool_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace ncsim::setup {

namespace {

using toolpath::ToolKind;
using toolpath::ToolSpec;

constexpr std::int64_t kVersionWithoutOrigin = 1, kVersion = 2;

constexpr std::pair<std::string_view, ToolKind> kKinds[] = {
    {"flat", ToolKind::FlatEndMill},
    {"ball", ToolKind::BallEndMill},
    {"bull", ToolKind::BullNoseEndMill},
    {"face", ToolKind::FaceMill},
    {"v", ToolKind::VCutter},
    {"chamfer", ToolKind::ChamferMill},
    {"countersink", ToolKind::Countersink},
    {"drill", ToolKind::Drill},
    {"taper", ToolKind::TaperedEndMill},
    {"slot", ToolKind::SlotMill},
    {"dovetail", ToolKind::DovetailMill},
    {"lollipop", ToolKind::LollipopMill},
    {"corner", ToolKind::CornerRoundingMill},
    {"tap", ToolKind::Tap},
    {"reamer", ToolKind::Reamer},
    {"boring-bar", ToolKind::BoringBar},
    {"thread", ToolKind::ThreadMill},
    {"form", ToolKind::Other}};

// Lengths and angles of a tool, by their names in the file.
struct NamedValue {
    const char* name;
    std::optional<double> ToolSpec::*value;
};
constexpr NamedValue kValues[] = {{"diameter", &ToolSpec::diameter},
                                  {"corner_radius", &ToolSpec::corner_radius},
                                  {"tip_diameter", &ToolSpec::tip_diameter},
                                  {"angle", &ToolSpec::angle},
                                  {"taper", &ToolSpec::taper},
                                  {"length", &ToolSpec::length},
                                  {"pitch", &ToolSpec::pitch},
                                  {"neck_diameter", &ToolSpec::neck_diameter},
                                  {"neck_length", &ToolSpec::neck_length},
                                  {"shank_diameter", &ToolSpec::shank_diameter},
                                  {"shank_length", &ToolSpec::shank_length},
                                  {"stick_out", &ToolSpec::stick_out}};

// Segments above the flutes, by their names in the file.
struct NamedSegments {
    const char* name;
    std::vector<toolpath::ToolSegment> ToolSpec::*value;
};
constexpr NamedSegments kSegments[] = {{"shaft", &ToolSpec::shaft}, {"holder", &ToolSpec::holder}};

// --- Reading ---

class JobReader {
public:
    explicit JobReader(const gcode::SourceFile& file) : r_(file.name, file.text) {}

    JobFile read() {
        JobFile job;
        const auto flag = [this](bool& into) {
            return [this, &into](const auto& n, const auto& k) { into = r_.yes_or_no(n, k); };
        };
        const auto optional_flag = [this](std::optional<bool>& into) {
            return [this, &into](const auto& n, const auto& k) { into = r_.yes_or_no(n, k); };
        };
        // Reads a list of words, each of which has to satisfy `known`.
        const auto words = [this](std::vector<std::string>& into, auto known,
                                  const char* expected) {
            return [this, &into, known, expected](const auto& n, const auto& k) {
                into = r_.texts(n, k);
                if (!std::ranges::all_of(into, known))
                    r_.fail(n, fmt::format("'{}': expected {}", k, expected));
            };
        };
        const auto any = [](const std::string&) { return true; };
        const auto is_reason = [](const std::string& name) {
            return name == "all" || verify::find_reason(name);
        };
        const auto is_requirement = [](const std::string& name) {
            return std::ranges::find(verify::kRequirements, name) !=
                   std::end(verify::kRequirements);
        };
        r_.each(
            r_.root(), "",
            {{"version",
              [&](const auto& n, const auto&) {
                  const auto version = n.template value<std::int64_t>();
                  if (version != kVersion && version != kVersionWithoutOrigin)
                      r_.fail(n, "this version of job files is not known; expected 2");
                  job.has_unknown_origin = version == kVersionWithoutOrigin;
              }},
             {"assumed",
              [&](const auto& n, const auto& k) {
                  for (const std::string& name : assumed_names(n, k, {"units", "dialect"}))
                      (name == "units" ? job.units_assumed : job.dialect_assumed) = true;
              }},
             {"program", [&](const auto& n, const auto& k) { job.program = r_.text(n, k); }},
             {"units",
              [&](const auto& n, const auto& k) {
                  const std::string name = r_.text(n, k);
                  if (name != "mm" && name != "inch") r_.fail(n, "expected \"mm\" or \"inch\"");
                  job.inches = name == "inch";
              }},
             {"dialect", [&](const auto& n, const auto& k) { job.dialect = read_dialect(n, k); }},
             {"strict", flag(job.strict)},
             {"block_delete", optional_flag(job.block_delete)},
             {"increments", optional_flag(job.increments)},
             {"variables",
              [&](const auto& n, const auto& k) { job.variables = read_variables(n, k); }},
             {"compensation",
              [&](const auto& n, const auto& k) { job.compensation = read_compensation(n, k); }},
             {"allow", words(job.allow, any, "words")},
             {"accept",
              words(job.accept, is_reason, "reasons for doubt, as ncsim rules lists them")},
             {"require", words(job.require, is_requirement,
                               "holder, fixtures, travels, offsets, links, lengths, modes")},
             {"start", [&](const auto& n, const auto& k) { job.start = r_.vector(n, k); }},
             {"offsets",
              [&](const auto& n, const auto& k) { job.offsets = read_offsets(r_, n, k); }},
             {"holders", [&](const auto& n, const auto& k) { job.holders = r_.text(n, k); }},
             {"stock", [&](const auto& n,
                           const auto& k) { job.stock = read_stock(r_.table(n, k), k, job); }},
             {"tool", [&](const auto& n, const auto& k) {
                  r_.each_of(n, k, [&](const toml::node& tool, const std::string& key) {
                      toolpath::ToolEntry entry = read_tool(r_.table(tool, key), key);
                      if (toolpath::find_tool(job.tools, entry.spec.number)) {
                          r_.fail(tool,
                                  fmt::format("tool {} is described twice", entry.spec.number));
                      }
                      job.tools.push_back(std::move(entry));
                  });
              }}});
        return job;
    }

private:
    // Returns the names in a list `assumed`; each has to be a name of `known`.
    template <class Known>
    std::vector<std::string> assumed_names(const toml::node& node, const std::string& key,
                                           const Known& known) const {
        std::vector<std::string> names = r_.texts(node, key);
        for (const std::string& name : names) {
            if (std::find(std::begin(known), std::end(known), name) == std::end(known)) {
                r_.fail(node, fmt::format("'{}': '{}' cannot be assumed here; expected {}", key,
                                          name, fmt::join(known, ", ")));
            }
        }
        return names;
    }
    std::vector<std::string> assumed_names(const toml::node& node, const std::string& key,
                                           std::initializer_list<std::string_view> known) const {
        return assumed_names(node, key, std::vector<std::string_view>(known));
    }

    gcode::Dialect read_dialect(const toml::node& node, const std::string& key) const {
        using gcode::Dialect;
        const std::string name = r_.text(node, key);
        for (const Dialect dialect : {Dialect::Auto, Dialect::Rs274, Dialect::Fanuc, Dialect::Haas,
                                      Dialect::Grbl, Dialect::Mach3, Dialect::Heidenhain}) {
            if (name == gcode::name_of(dialect)) return dialect;
        }
        r_.fail(node, "expected auto, rs274, fanuc, haas, grbl, mach3 or heidenhain");
    }

    std::map<std::string, double> read_variables(const toml::node& node,
                                                 const std::string& key) const {
        std::map<std::string, double> variables;
        for (const auto& [name, value] : r_.table(node, key)) {
            const std::string where = fmt::format("{}.{}", key, name.str());
            const auto variable = variable_name(name.str());
            if (!variable)
                r_.fail(value, fmt::format("'{}': expected \"#500\" or \"#<_name>\"", where));
            variables.emplace(*variable, r_.number(value, where));
        }
        return variables;
    }

    std::map<int, double> read_compensation(const toml::node& node, const std::string& key) const {
        std::map<int, double> radii;
        for (const auto& [name, value] : r_.table(node, key)) {
            const std::string where = fmt::format("{}.{}", key, name.str());
            const auto number = compensation_register(name.str());
            if (!number) r_.fail(value, fmt::format("'{}': expected a register, as D1", where));
            radii.emplace(*number, r_.number(value, where));
        }
        return radii;
    }

    toolpath::Stock read_stock_from_file(const toml::table& t, const std::string& key) const {
        toolpath::StockFile from;
        r_.each(t, key,
                {{"file",
                  [&](const auto& n, const auto& k) {
                      from.path = r_.text(n, k);
                      if (!is_stock_file(from.path))
                          r_.fail(n, "expected a file .stl, .glb, .step or .ncstock");
                  }},
                 {"turn",
                  [&](const auto& n, const auto& k) {
                      from.turn = r_.text(n, k);
                      try {
                          parse_turn(from.turn);
                      } catch (const std::invalid_argument& e) {
                          r_.fail(n, e.what());
                      }
                  }},
                 {"move", [&](const auto& n, const auto& k) { from.move = r_.vector(n, k); }}});
        toolpath::Stock stock;
        stock.from = std::move(from);
        return stock;
    }

    toolpath::Stock read_stock(const toml::table& t, const std::string& key, JobFile& job) const {
        if (t.contains("file")) return read_stock_from_file(t, key);
        std::optional<cda::Vec3> min, max;
        toolpath::Stock stock;
        r_.each(t, key,
                {{"assumed",
                  [&](const auto& n, const auto& k) {
                      for (const std::string& name : assumed_names(n, k, {"size", "place"}))
                          (name == "size" ? job.stock_assumed : job.stock_place_assumed) = true;
                  }},
                 {"min", [&](const auto& n, const auto& k) { min = r_.vector(n, k); }},
                 {"max", [&](const auto& n, const auto& k) { max = r_.vector(n, k); }},
                 {"axis",
                  [&](const auto& n, const auto& k) {
                      const std::string name = r_.text(n, k);
                      if (name != "X" && name != "Y" && name != "Z")
                          r_.fail(n, "expected \"X\", \"Y\" or \"Z\"");
                      stock.axis = name[0] - 'X';
                  }},
                 {"round",
                  [&](const auto& n, const auto& k) { stock.is_round = r_.yes_or_no(n, k); }}});
        if (!min || !max) r_.fail(t, "a stock has two corners, min and max");
        if (!(min->x < max->x && min->y < max->y && min->z < max->z)) {
            r_.fail(*t.get("max"), "each number of max must be larger than that of min");
        }
        stock.box.add(*min), stock.box.add(*max);
        const cda::Vec3 size = stock.box.size();
        const int across = (stock.axis + 1) % 3, up = (stock.axis + 2) % 3;
        if (stock.is_round && std::abs(size[across] - size[up]) > 1e-9 * size[across]) {
            r_.fail(*t.get("max"), fmt::format("a round stock along {} is as wide in {} as in {}",
                                               "XYZ"[stock.axis], "XYZ"[std::min(across, up)],
                                               "XYZ"[std::max(across, up)]));
        }
        return stock;
    }

    toolpath::ToolPiece read_piece(const toml::node& node, const std::string& key) const {
        toolpath::ToolPiece piece;
        r_.each(
            r_.table(node, key), key,
            {{"cutting", [&](const auto& n, const auto& k) { piece.cutting = r_.yes_or_no(n, k); }},
             {"profile", [&](const toml::node& n, const std::string& k) {
                  double height = 0.0;
                  for (const toml::node& corner : r_.list(n, k)) {
                      const cda::Vec3 v = r_.vector(corner, k);
                      if (v.x < 0 || v.y < height || v.z < 0) {
                          r_.fail(corner,
                                  "expected [radius, height, fillet] from the lower end to the "
                                  "upper");
                      }
                      height = v.y;
                      piece.profile.push_back({v.x, v.y, v.z});
                  }
                  if (piece.profile.empty()) r_.fail(n, "a profile has corners");
              }}});
        if (piece.profile.empty()) r_.fail(node, "a piece of a tool has a profile");
        return piece;
    }

    toolpath::ToolEntry read_tool(const toml::table& t, const std::string& where) const {
        toolpath::ToolEntry entry;
        ToolSpec& spec = entry.spec;
        TomlReader::Keys keys{
            {"number",
             [&](const auto& n, const auto& k) {
                 spec.number = static_cast<int>(r_.integer(n, k, 0, kMostTools));
             }},
            {"kind",
             [&](const auto& n, const auto& k) {
                 const std::string name = r_.text(n, k);
                 const auto* found =
                     std::find_if(std::begin(kKinds), std::end(kKinds),
                                  [&name](const auto& kind) { return kind.first == name; });
                 if (found == std::end(kKinds)) {
                     r_.fail(n,
                             "expected flat, ball, bull, face, v, chamfer, countersink, drill, "
                             "taper, slot, dovetail, lollipop, corner, tap, reamer, boring-bar, "
                             "thread or form");
                 }
                 spec.kind = found->second;
             }},
            {"offset", [&](const auto& n, const auto& k) { entry.offset = r_.vector(n, k); }},
            {"description",
             [&](const auto& n, const auto& k) { spec.description = r_.text(n, k); }},
            {"assumed",
             [&](const auto& n, const auto& k) {
                 spec.assumed = assumed_names(n, k, toolpath::kAssumable);
             }},
            {"piece", [&](const auto& n, const auto& k) {
                 r_.each_of(n, k, [&](const auto& piece, const auto& key) {
                     spec.pieces.push_back(read_piece(piece, key));
                 });
             }}};
        for (const NamedValue& named : kValues) {
            keys[named.name] = [&, value = named.value](const auto& n, const auto& k) {
                spec.*value = r_.not_negative(n, k);
            };
        }
        for (const NamedSegments& named : kSegments) {
            keys[named.name] = [&, value = named.value](const auto& n, const auto& k) {
                spec.*value = read_segments(r_, n, k);
            };
        }
        r_.each(t, where, keys);
        if (!t.contains("number")) {
            r_.fail(t, "a tool has a number, 0 for a program that calls none");
        }
        if (!toolpath::is_complete(spec)) r_.fail(t, "a tool needs a diameter above 0");
        entry.specified_by = toolpath::ValueSource::Table;
        entry.span = {static_cast<std::uint32_t>(t.source().begin.line), 1, 0};
        entry.text = spec.description;
        entry.file = report::base_name(r_.name());
        return entry;
    }

    TomlReader r_;
};

// --- Writing ---

// Returns the shortest text that reads back as the same number; always a TOML float.
std::string number(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string triple(cda::Vec3 v) {
    return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
}

// Returns a comment line.
std::string remark(const std::string& text) {
    std::string line = report::one_line(text);
    // Comments must be UTF-8, too.
    line = report::json_string(line);
    return fmt::format("# {}\n", line.substr(1, line.size() - 2));
}

std::string_view key_of(ToolKind kind) {
    return std::find_if(std::begin(kKinds), std::end(kKinds),
                        [kind](const auto& k) { return k.second == kind; })
        ->first;
}

// Writes a list of texts, unless it is empty.
void write_list(std::ostream& out, const char* key, const std::vector<std::string>& words) {
    if (words.empty()) return;
    out << key << " = [";
    for (std::size_t i = 0; i < words.size(); ++i)
        out << (i == 0 ? "" : ", ") << quoted(words[i]);
    out << "]\n";
}

void write_tool(std::ostream& out, const ToolSpec& spec, cda::Vec3 offset) {
    out << "[[tool]]\nnumber = " << spec.number << '\n';
    write_list(out, "assumed", spec.assumed);
    if (spec.kind) out << "kind = \"" << key_of(*spec.kind) << "\"\n";
    for (const NamedValue& named : kValues) {
        if (const auto& value = spec.*named.value) {
            out << named.name << " = " << number(*value) << '\n';
        }
    }
    for (const NamedSegments& named : kSegments) {
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
    if (!(offset == cda::Vec3{})) out << "offset = " << triple(offset) << '\n';
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
    if (!(stock.from->move == cda::Vec3{})) out << "move = " << triple(stock.from->move) << '\n';
}

}  // namespace

std::optional<std::string> variable_name(std::string_view text) {
    std::string name;
    for (const char c : text)
        name += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    if (name.starts_with("#<") && name.ends_with('>') && name.size() > 3) return name;
    constexpr std::size_t kMostDigits = 5;
    const bool is_number = name.starts_with('#') && name.size() > 1 &&
                           name.size() <= kMostDigits + 1 && name[1] != '0' &&
                           name.find_first_not_of("0123456789", 1) == std::string::npos;
    if (!is_number) return std::nullopt;
    return name;
}

std::optional<int> compensation_register(std::string_view text) {
    constexpr int kMost = 9999;
    int number = 0;
    const char* const end = text.data() + text.size();
    if (text.size() < 2 || (text[0] != 'D' && text[0] != 'd')) return std::nullopt;
    if (std::from_chars(text.data() + 1, end, number) != std::from_chars_result{end, std::errc{}})
        return std::nullopt;
    if (number < 1 || number > kMost) return std::nullopt;
    return number;
}

JobFile parse_job_file(const gcode::SourceFile& file) {
    return JobReader(file).read();
}

void write_job_file(std::ostream& out, const JobFile& file, const JobRemarks& remarks) {
    out << "# Written by ncsim " << report::kVersion
        << ": what a program stood on. Lengths in mm, angles in degrees.\n"
        << "# Values that are named in a list \"assumed\" were not specified: correct them and "
           "remove the name.\n"
        << "version = " << kVersion << '\n';
    std::vector<std::string> assumed;
    if (file.units_assumed) assumed.emplace_back("units");
    if (file.dialect_assumed) assumed.emplace_back("dialect");
    write_list(out, "assumed", assumed);
    if (!file.program.empty()) out << "program = " << quoted(file.program) << '\n';
    out << "units = \"" << (file.inches.value_or(false) ? "inch" : "mm")
        << "\"  # where neither G20 nor G21 stands before the first length\ndialect = \""
        << gcode::name_of(file.dialect.value_or(gcode::Dialect::Auto)) << "\"\n";
    if (file.strict) out << "strict = true\n";
    const auto flag = [&out](const char* key, const std::optional<bool>& value) {
        if (value) out << key << (*value ? " = true\n" : " = false\n");
    };
    flag("increments", file.increments);
    flag("block_delete", file.block_delete);
    write_list(out, "allow", file.allow);
    write_list(out, "accept", file.accept);
    write_list(out, "require", file.require);
    if (file.start) out << "start = " << triple(*file.start) << "  # in G54\n";
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
    if (file.stock) {
        out << "\n[stock]\n" << remark(remarks.stock);
        std::vector<std::string> assumed_of_stock;
        if (file.stock_assumed) assumed_of_stock.emplace_back("size");
        if (file.stock_place_assumed) assumed_of_stock.emplace_back("place");
        write_list(out, "assumed", assumed_of_stock);
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

}  // namespace ncsim::setup
