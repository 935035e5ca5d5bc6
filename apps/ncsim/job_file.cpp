// SPDX-License-Identifier: GPL-3.0-or-later
#include "job_file.h"

#include "findings.h"
#include "job.h"
#include "sheet.h"
#include "stock_file.h"
#include "survey.h"
#include "version.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace ncsim::app {

namespace {

using toolpath::ToolKind;
using toolpath::ToolSpec;

constexpr std::int64_t kVersion1 = 1;
constexpr double kLargest = 1e6;  // mm: a kilometre

constexpr std::pair<std::string_view, ToolKind> kKinds[] = {{"flat", ToolKind::FlatEndMill},
                                                            {"ball", ToolKind::BallEndMill},
                                                            {"bull", ToolKind::BullNoseEndMill},
                                                            {"face", ToolKind::FaceMill},
                                                            {"v", ToolKind::VCutter},
                                                            {"drill", ToolKind::Drill},
                                                            {"taper", ToolKind::TaperedEndMill},
                                                            {"form", ToolKind::Other}};

// The lengths and angles of a tool, by the names they have in the file.
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
                                  {"shank_diameter", &ToolSpec::shank_diameter}};

// --- Reading ---

class Reader {
public:
    explicit Reader(const gcode::SourceFile& file) : name_(file.name) {
        try {
            root_ = toml::parse(std::string_view(file.text), std::string_view(name_));
        } catch (const toml::parse_error& e) {
            refuse(e.source(), std::string(e.description()));
        }
    }

    JobFile read() {
        const toml::table& t = root_;
        only(t, {"version", "program", "units", "dialect", "strict", "block_delete", "increments",
                 "allow", "stock", "tool"});
        if (const auto* version = t.get("version")) {
            if (version->value<std::int64_t>() != kVersion1) {
                refuse(*version, "this version of job files is not known; expected 1");
            }
        }
        JobFile job;
        if (const auto* program = t.get("program")) job.program = string(*program);
        if (const auto* units = t.get("units")) {
            const std::string name = string(*units);
            if (name != "mm" && name != "inch") refuse(*units, "expected \"mm\" or \"inch\"");
            job.inches = name == "inch";
        }
        if (const auto* dialect = t.get("dialect")) job.dialect = read_dialect(*dialect);
        if (const auto* strict = t.get("strict")) job.strict = boolean(*strict);
        if (const auto* skip = t.get("block_delete")) job.block_delete = boolean(*skip);
        if (const auto* i = t.get("increments")) job.increments = boolean(*i);
        if (const auto* allow = t.get("allow")) {
            for (const toml::node& word : array(*allow))
                job.allow.push_back(string(word));
        }
        if (const auto* stock = t.get("stock")) job.stock = read_stock(table(*stock));
        if (const auto* tools = t.get("tool")) {
            for (const toml::node& tool : array(*tools)) {
                toolpath::ToolEntry entry = read_tool(table(tool));
                if (toolpath::find_tool(job.tools, entry.spec.number)) {
                    refuse(tool, fmt::format("tool {} is described twice", entry.spec.number));
                }
                job.tools.push_back(std::move(entry));
            }
        }
        return job;
    }

private:
    [[noreturn]] void refuse(const toml::source_region& where, const std::string& why) const {
        throw std::runtime_error(
            fmt::format("{}:{}:{}: {}", name_, where.begin.line, where.begin.column, why));
    }
    [[noreturn]] void refuse(const toml::node& node, const std::string& why) const {
        refuse(node.source(), why);
    }

    void only(const toml::table& table, std::initializer_list<std::string_view> keys) const {
        for (const auto& [key, value] : table) {
            if (std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
                refuse(value, fmt::format("'{}' is not known here", key.str()));
            }
        }
    }
    std::string string(const toml::node& node) const {
        const auto value = node.value_exact<std::string>();
        if (!value) refuse(node, "expected a text in quotes");
        return *value;
    }
    bool boolean(const toml::node& node) const {
        const auto value = node.value_exact<bool>();
        if (!value) refuse(node, "expected true or false");
        return *value;
    }
    double number(const toml::node& node) const {
        const auto value = node.value<double>();
        if (!node.is_number() || !value || !(std::abs(*value) <= kLargest)) {
            refuse(node, "expected a number, at most 1000000");
        }
        return *value;
    }
    const toml::array& array(const toml::node& node) const {
        const toml::array* value = node.as_array();
        if (!value) refuse(node, "expected a list in brackets");
        return *value;
    }
    const toml::table& table(const toml::node& node) const {
        const toml::table* value = node.as_table();
        if (!value) refuse(node, "expected a table");
        return *value;
    }
    cda::Vec3 triple(const toml::node& node) const {
        const toml::array& values = array(node);
        if (values.size() != 3) refuse(node, "expected three numbers, as in [0, 0, -10]");
        return {number(values[0]), number(values[1]), number(values[2])};
    }

    gcode::Dialect read_dialect(const toml::node& node) const {
        using gcode::Dialect;
        const std::string name = string(node);
        for (const Dialect dialect : {Dialect::Auto, Dialect::Rs274, Dialect::Fanuc, Dialect::Haas,
                                      Dialect::Grbl, Dialect::Mach3}) {
            if (name == gcode::name_of(dialect)) return dialect;
        }
        refuse(node, "expected auto, rs274, fanuc, haas, grbl or mach3");
    }

    toolpath::Stock read_stock_from_file(const toml::table& t) const {
        only(t, {"file", "turn", "move"});
        toolpath::StockFile from;
        const toml::node& name = *t.get("file");
        from.path = string(name);
        if (!is_stock_file(from.path)) refuse(name, "expected a file .stl, .glb or .ncstock");
        if (const auto* turn = t.get("turn")) {
            from.turn = string(*turn);
            try {
                parse_turn(from.turn);
            } catch (const std::invalid_argument& e) {
                refuse(*turn, e.what());
            }
        }
        if (const auto* move = t.get("move")) from.move = triple(*move);
        toolpath::Stock stock;
        stock.from = std::move(from);
        return stock;
    }

    toolpath::Stock read_stock(const toml::table& t) const {
        if (t.contains("file")) return read_stock_from_file(t);
        only(t, {"min", "max", "round"});
        const auto* min = t.get("min");
        const auto* max = t.get("max");
        if (!min || !max) refuse(t, "a stock has two corners, min and max");
        const cda::Vec3 a = triple(*min);
        const cda::Vec3 b = triple(*max);
        if (!(a.x < b.x && a.y < b.y && a.z < b.z)) {
            refuse(*max, "each number of max must be larger than that of min");
        }
        cda::Box box;
        box.add(a), box.add(b);
        toolpath::Stock stock{box};
        if (const auto* round = t.get("round")) stock.is_round = boolean(*round);
        if (stock.is_round && std::abs(box.size().x - box.size().y) > 1e-9 * box.size().x) {
            refuse(*max, "a round stock is as wide in X as in Y");
        }
        return stock;
    }

    toolpath::ToolPiece read_piece(const toml::table& t) const {
        only(t, {"cutting", "profile"});
        toolpath::ToolPiece piece;
        if (const auto* cutting = t.get("cutting")) piece.cutting = boolean(*cutting);
        const auto* profile = t.get("profile");
        if (!profile) refuse(t, "a piece of a tool has a profile");
        double height = 0.0;
        for (const toml::node& corner : array(*profile)) {
            const cda::Vec3 v = triple(corner);
            if (v.x < 0 || v.y < height || v.z < 0) {
                refuse(corner, "expected [radius, height, fillet] from the lower end to the upper");
            }
            height = v.y;
            piece.profile.push_back({v.x, v.y, v.z});
        }
        if (piece.profile.empty()) refuse(*profile, "a profile has corners");
        return piece;
    }

    toolpath::ToolEntry read_tool(const toml::table& t) const {
        only(t, {"number", "kind", "diameter", "corner_radius", "tip_diameter", "angle", "taper",
                 "length", "shank_diameter", "offset", "description", "piece"});
        toolpath::ToolEntry entry;
        ToolSpec& spec = entry.spec;
        const auto* n = t.get("number");
        const auto value = n ? n->value_exact<std::int64_t>() : std::nullopt;
        if (!value || *value < 0 || *value > 99999999) {
            refuse(n ? *n : t, "a tool has a number, 0 for a program that calls none");
        }
        spec.number = static_cast<int>(*value);
        if (const auto* kind = t.get("kind")) {
            const std::string name = string(*kind);
            const auto* found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                             [&name](const auto& k) { return k.first == name; });
            if (found == std::end(kKinds)) {
                refuse(*kind, "expected flat, ball, bull, face, v, drill, taper or form");
            }
            spec.kind = found->second;
        }
        for (const NamedValue& named : kValues) {
            const auto* node = t.get(named.name);
            if (!node) continue;
            const double mm = number(*node);
            if (mm < 0) refuse(*node, "must not be negative");
            spec.*named.value = mm;
        }
        if (const auto* pieces = t.get("piece")) {
            for (const toml::node& piece : array(*pieces))
                spec.pieces.push_back(read_piece(table(piece)));
        }
        if (const auto* offset = t.get("offset")) entry.offset = triple(*offset);
        if (const auto* description = t.get("description")) spec.description = string(*description);
        if (!toolpath::is_complete(spec)) refuse(t, "a tool needs a diameter above 0");
        entry.told_by = toolpath::ToldBy::Table;
        entry.span = {static_cast<std::uint32_t>(t.source().begin.line), 1, 0};
        entry.text = spec.description;
        entry.file = base_name(name_);
        return entry;
    }

    std::string name_;
    toml::table root_;
};

// --- Writing ---

// JSON's strings are TOML's basic strings, but for the two characters that only TOML escapes.
std::string quoted(const std::string& text) {
    std::string result = to_line(nlohmann::ordered_json(text));
    for (std::size_t at = 0; (at = result.find('\x7f', at)) != std::string::npos;)
        result.replace(at, 1, "\\u007F");
    return result;
}

// As few digits as read back to the same number; always a TOML float.
std::string number(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string triple(cda::Vec3 v) {
    return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
}

// A remark of one line.
std::string remark(const std::string& text) {
    std::string line = printable(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    // Comments must be UTF-8, too.
    line = to_line(nlohmann::ordered_json(line));
    return fmt::format("# {}\n", line.substr(1, line.size() - 2));
}

std::string_view key_of(ToolKind kind) {
    return std::find_if(std::begin(kKinds), std::end(kKinds),
                        [kind](const auto& k) { return k.second == kind; })
        ->first;
}

void write_tool(std::ostream& out, const ToolSpec& spec, cda::Vec3 offset) {
    out << "[[tool]]\nnumber = " << spec.number << '\n';
    if (spec.kind) out << "kind = \"" << key_of(*spec.kind) << "\"\n";
    for (const NamedValue& named : kValues) {
        if (const auto& value = spec.*named.value) {
            out << named.name << " = " << number(*value) << '\n';
        }
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

cda::Vec3 offset_of(const Job& job, int number) {
    const toolpath::ToolEntry* entry = toolpath::find_tool(job.tools, number);
    return entry ? entry->offset : cda::Vec3{};
}

// How a job file names another file.
std::string seen_from(const std::string& job_file, const std::string& path) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::absolute(job_file).lexically_normal().parent_path();
    return fs::absolute(path).lexically_normal().lexically_proximate(folder).generic_string();
}

void write_stock(std::ostream& out, const toolpath::Stock& stock, const std::string& job_file) {
    if (!stock.from) {
        out << "min = " << triple(stock.box.min) << "\nmax = " << triple(stock.box.max) << '\n'
            << (stock.is_round ? "round = true\n" : "");
        return;
    }
    out << "file = " << quoted(seen_from(job_file, stock.from->path)) << '\n';
    if (!stock.from->turn.empty()) out << "turn = " << quoted(stock.from->turn) << '\n';
    if (!(stock.from->move == cda::Vec3{})) out << "move = " << triple(stock.from->move) << '\n';
}

}  // namespace

JobFile parse_job_file(const gcode::SourceFile& file) {
    return Reader(file).read();
}

void write_job_file(std::ostream& out, const Job& job, const Survey& survey,
                    const std::string& path) {
    out << "# Written by ncsim " << kVersion
        << ": what a program stood on. Lengths in mm, angles in degrees.\n"
        << "version = 1\nprogram = " << quoted(seen_from(path, job.options.program))
        << "\nunits = \"" << (job.options.inches.value_or(false) ? "inch" : "mm")
        << "\"  # where neither G20 nor G21 stands before the first length\ndialect = \""
        << gcode::name_of(survey.interpretation.dialect.dialect) << "\"\n";
    if (job.options.strict) out << "strict = true\n";
    if (job.options.increments) out << "increments = true\n";
    if (job.options.block_delete) out << "block_delete = true\n";
    if (!job.options.allow.empty()) {
        out << "allow = [";
        for (std::size_t i = 0; i < job.options.allow.size(); ++i)
            out << (i == 0 ? "" : ", ") << quoted(job.options.allow[i]);
        out << "]\n";
    }
    if (survey.stock) {
        out << "\n[stock]\n"
            << remark(told(survey.stock->told_by, survey.stock->span, survey.stock->text,
                           survey.stock->file, "--stock"));
        write_stock(out, *survey.stock, path);
    }
    for (const auto& [number, used] : survey.tools) {
        out << '\n' << remark(told(used.told_by, used.span, used.text, used.file, "--tool"));
        if (!used.filled_in.empty()) out << remark("assumed: " + used.filled_in);
        write_tool(out, used.spec, offset_of(job, number));
    }
    for (const toolpath::ToolEntry& entry : job.tools) {
        if (survey.tools.contains(entry.spec.number)) continue;
        out << '\n'
            << remark("not used; " +
                      told(entry.told_by, entry.span, entry.text, entry.file, "--tool"));
        write_tool(out, entry.spec, entry.offset);
    }
    for (const auto& [number, first] : survey.unknown_tools) {
        out << '\n'
            << remark(fmt::format("tool {} moves from line {} on and nobody describes it: fill in",
                                  number, first.line))
            << "#[[tool]]\n#number = " << number << "\n#kind = \"flat\"\n#diameter = 10.0\n";
    }
}

}  // namespace ncsim::app
