// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads job files.
#include "ncsim/setup/job_file.h"

#include "ncsim/base/ascii.h"
#include "ncsim/base/file_names.h"
#include "ncsim/base/number_text.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/verify/doubt.h"

#include "files/schema.h"
#include "files/toml_reader.h"
#include "files/toml_text.h"
#include "files/tool_keys.h"
#include "job/job_keys.h"
#include "job/option_reader.h"
#include "job/three_points.h"
#include "machines/fixture_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace ncsim::setup {

namespace {

// Formats of outputs in a job file, with the endings of their files.
constexpr std::pair<std::string_view, std::string_view> kOutputs[] = {
    {"png", ".png"},   {"gltf", ".glb"},    {"stl", ".stl"},       {"step", ".step"},
    {"ply", ".ply"},   {"3mf", ".3mf"},     {"vrml", ".wrl"},      {"gif", ".gif"},
    {"apng", ".apng"}, {"report", ".json"}, {"stock", ".ncstock"}, {"html", ".html"}};

constexpr std::size_t kMostSetUps = 100;

class JobReader {
public:
    /// Meshes of fixtures are relative to `folder`.
    JobReader(const gcode::SourceFile& file, std::string folder, InputSet& inputs)
        : r_(file.name, file.text, kJobSchema, is_job_option),
          folder_(std::move(folder)),
          inputs_(inputs) {}

    JobFile read() {
        const TomlTable t(r_.root(), "");
        JobFile job;
        note_values(r_.root(), "", job.values);
        const auto is_reason = [](const std::string& name) {
            return name == "all" || verify::find_reason(name);
        };
        t.read("accept", job.accept);
        if (!std::ranges::all_of(job.accept, is_reason))
            r_.fail(*t["accept"],
                    "'accept': expected reasons for doubt, as ncsim rules lists them");
        t.read("allow", job.allow);
        for (const AssumedValue& value : assumed_values(t)) {
            if (value.name == "units" || value.name == "dialect") {
                (value.name == "units" ? job.units_assumed : job.dialect_assumed) = true;
            } else {
                job.assumed.push_back(value);
            }
        }
        t.read("below_stock", job.below_stock);
        t.read("block_delete", job.block_delete);
        job.compensation = read_compensation(t);
        if (const toml::node* const n = t["dialect"]) job.dialect = dialect_named(*n);
        job.fixtures_specified = t["fixture"] != nullptr;
        job.fixtures = read_fixtures(t);
        t.read("holders", job.holders);
        t.read("increments", job.increments);
        job.offsets = read_offsets(r_, t);
        job.outputs = read_outputs(t);
        if (const toml::node* const n = t["program"]) job.program = read_program(*n, "program");
        t.read("require", job.require);
        t.each("setup", [&](const TomlTable& one) { job.set_ups.push_back(read_set_up(one)); });
        t.read("start", job.start);
        if (t["stock"]) job.stock = read_stock(t, job);
        t.read("strict", job.strict);
        t.each("tool", [&](const TomlTable& one) {
            toolpath::ToolEntry entry = read_tool(one);
            const int number = entry.spec.number;
            if (toolpath::find_tool(job.tools, number))
                r_.fail(one.node(), fmt::format("tool {} is described twice", number));
            job.values[fmt::format("tool {}", number)] = {r_.place_of(one.node()), {}};
            job.tools.push_back(std::move(entry));
        });
        if (const toml::node* const n = t["units"]) job.inches = TomlReader::text(*n) == "inch";
        job.variables = read_variables(t);
        std::optional<std::int64_t> version = kJobVersion;
        if (const toml::node* const n = t["version"]) version = n->value<std::int64_t>();
        if (version != kJobVersion && version != kVersionWithoutOrigin)
            r_.fail(*t["version"], "this version of job files is not known; expected 2");
        job.has_unknown_origin = version == kVersionWithoutOrigin;
        for (const auto& [key, node] : r_.root()) {
            const std::string name(key.str());
            if (is_job_option(name))
                job.settings.push_back(read_option(r_, option_of(name), name, node));
        }
        check_set_ups(job);
        return job;
    }

private:
    // Returns the option of a key: "tool-table" of "tool_table".
    static std::string option_of(std::string key) {
        std::ranges::replace(key, '_', '-');
        return key;
    }
    static bool is_job_option(const std::string& key) {
        return key.find('-') == std::string::npos &&
               std::ranges::find(kJobOptions, option_of(key)) != std::end(kJobOptions);
    }

    // Returns the names in a list `assumed`.
    std::vector<AssumedValue> assumed_values(const TomlTable& t) const {
        std::vector<AssumedValue> values;
        if (!t["assumed"]) return values;
        for (const toml::node& name : TomlReader::list(*t["assumed"]))
            values.push_back({TomlReader::text(name), r_.place_of(name)});
        return values;
    }

    // Notes all keys of `in`, and variables, offsets and registers below.
    void note_values(const toml::table& in, const std::string& above,
                     std::map<std::string, PlacedValue>& values) const {
        for (const auto& [key, node] : in) {
            const std::string name = above + std::string(key.str());
            values[name] = {r_.place_of(node), text_of(node)};
            if (above.empty() && node.is_table()) note_values(*node.as_table(), name + " ", values);
        }
    }

    static std::string text_of(const toml::node& node) {
        if (node.is_string()) return quoted(node.as_string()->get());
        if (node.is_boolean()) return node.as_boolean()->get() ? "true" : "false";
        if (node.is_number()) return fmt::format("{}", node.value<double>().value_or(0.0));
        if (!node.is_array() || node.is_array_of_tables()) return {};
        std::vector<std::string> texts;
        for (const toml::node& one : *node.as_array())
            texts.push_back(text_of(one));
        return fmt::format("[{}]", fmt::join(texts, ", "));
    }

    std::string read_program(const toml::node& node, const std::string& key) const {
        std::string program = TomlReader::text(node);
        if (program.empty()) r_.fail(node, fmt::format("'{}': the name is empty", key));
        if (is_job_file(program))
            r_.fail(node, fmt::format("'{}': a job cannot contain a job; name NC programs", key));
        return program;
    }

    std::vector<verify::Fixture> read_fixtures(const TomlTable& t) const {
        std::vector<verify::Fixture> fixtures;
        t.each("fixture",
               [&](const TomlTable& one) { read_fixture(r_, folder_, inputs_, one, fixtures); });
        return fixtures;
    }

    std::map<std::string, std::string> read_outputs(const TomlTable& t) const {
        std::map<std::string, std::string> outputs;
        const std::string path = t.name_of("outputs");
        t.each_key("outputs", [&](const toml::node& n, const std::string& format) {
            const std::string name = TomlReader::text(n);
            const std::string_view ending =
                std::ranges::find(kOutputs, format, [](const auto& o) { return o.first; })->second;
            if (!name.ends_with(ending) || name.size() == ending.size()) {
                r_.fail(n, fmt::format("'{}.{}': expected a name that ends in {}", path, format,
                                       ending));
            }
            (void)output_below(folder_, name, r_.place_of(n));
            for (const auto& [other, same] : outputs) {
                if (same == name)
                    r_.fail(n, fmt::format("'{}' is also the output of {}", name, other));
            }
            outputs[format] = name;
        });
        return outputs;
    }

    JobSetUp read_set_up(const TomlTable& t) const {
        JobSetUp set_up;
        set_up.where = r_.place_of(t.node());
        set_up.assumed = assumed_values(t);
        t.read("below_stock", set_up.below_stock);
        set_up.fixtures_specified = t["fixture"] != nullptr;
        set_up.fixtures = read_fixtures(t);
        t.read("move", set_up.move);
        t.read("name", set_up.name);
        set_up.offsets = read_offsets(r_, t);
        set_up.outputs = read_outputs(t);
        if (t["points"]) {
            TurnAndMove motion = read_points(t.table("points"));
            set_up.turn = std::move(motion.turn);
            set_up.move = motion.move;
        }
        if (const toml::node* const n = t["program"])
            set_up.programs = {read_program(*n, t.name_of("program"))};
        if (const toml::node* const n = t["programs"]) {
            for (const toml::node& one : TomlReader::list(*n))
                set_up.programs.push_back(read_program(one, t.name_of("programs")));
        }
        t.read("start", set_up.start);
        if (t["turn"]) set_up.turn = read_turn(*t["turn"]);
        set_up.variables = read_variables(t);
        t.read("zero", set_up.zero);
        if (t["program"] && t["programs"])
            r_.fail(t.node(), "a set-up has program or programs, not both");
        if (set_up.programs.empty()) r_.fail(t.node(), "a set-up needs a program");
        if (t["points"] && (t["turn"] || t["move"]))
            r_.fail(*t["points"], "a set-up has points, or turn and move, not both");
        for (verify::Fixture& fixture : set_up.fixtures) {
            if (fixture.system != 0) continue;
            fixture.box.min = fixture.box.min - set_up.zero;
            fixture.box.max = fixture.box.max - set_up.zero;
            for (Vec3& p : fixture.mesh.vertices)
                p = p - set_up.zero;
        }
        return set_up;
    }

    // Checks that values of the only set-up and a list of set-ups do not contradict each other.
    void check_set_ups(const JobFile& job) const {
        if (job.set_ups.empty()) return;
        for (const char* key : {"program", "fixture"}) {
            if (const toml::node* node = r_.root().get(key))
                r_.fail(*node,
                        fmt::format("'{}': with [[setup]], write {} in each set-up", key, key));
        }
        if (job.set_ups.size() > kMostSetUps)
            r_.fail(r_.root(),
                    fmt::format("{} set-ups; at most {}", job.set_ups.size(), kMostSetUps));
        const toml::table& first = *r_.root().get("setup")->as_array()->get(0)->as_table();
        for (const char* key : {"turn", "move", "points"}) {
            if (const toml::node* node = first.get(key))
                r_.fail(*node, fmt::format("'{}': the stock is where [stock] places it", key));
        }
        std::set<std::string> outputs;
        for (const auto& [format, name] : job.outputs)
            outputs.insert(name);
        for (const JobSetUp& set_up : job.set_ups) {
            for (const auto& [format, name] : set_up.outputs) {
                if (!outputs.insert(name).second)
                    throw std::runtime_error(
                        fmt::format("{}: '{}' is the output of two set-ups", set_up.where, name));
            }
        }
    }

    TurnAndMove read_points(const TomlTable& t) const {
        std::array<Vec3, 3> before{}, now{};
        t.read("before", before);
        t.read("now", now);
        if (!t["before"] || !t["now"])
            r_.fail(t.node(), fmt::format("'{}': expected before and now", t.name()));
        try {
            return motion_of(before, now);
        } catch (const std::invalid_argument& e) {
            r_.fail(t.node(), fmt::format("'{}': {}", t.name(), e.what()));
        }
    }

    std::string read_turn(const toml::node& node) const {
        std::string turn = TomlReader::text(node);
        try {
            (void)parse_any_turn(turn);
        } catch (const std::invalid_argument& e) {
            r_.fail(node, e.what());
        }
        return turn;
    }

    static gcode::Dialect dialect_named(const toml::node& node) {
        return *std::ranges::find(gcode::kDialectList, TomlReader::text(node),
                                  [](gcode::Dialect dialect) { return gcode::name_of(dialect); });
    }

    std::map<std::string, double> read_variables(const TomlTable& t) const {
        std::map<std::string, double> variables;
        t.each_key("variables", [&](const toml::node& node, const std::string& name) {
            const auto variable = variable_name(name);
            if (!variable) {
                r_.fail(node, fmt::format("'{}.{}': expected \"#500\", \"#<_name>\", R5 or Q5",
                                          t.name_of("variables"), name));
            }
            variables.emplace(*variable, TomlReader::number(node));
        });
        return variables;
    }

    std::map<int, double> read_compensation(const TomlTable& t) const {
        std::map<int, double> radii;
        t.each_key("compensation", [&](const toml::node& node, const std::string& name) {
            const auto number = compensation_register(name);
            if (!number)
                r_.fail(node, fmt::format("'compensation.{}': expected a register, as D1", name));
            radii.emplace(*number, TomlReader::number(node));
        });
        return radii;
    }

    toolpath::Stock read_stock(const TomlTable& root, JobFile& job) const {
        const toml::node& node = *root["stock"];
        if (node.is_table()) {
            const TomlTable t = root.table("stock");
            return t["file"] ? read_stock_from_file(t) : read_box(t, job);
        }
        std::string message;
        auto stock = toolpath::parse_stock_option(TomlReader::text(node), message);
        if (!stock) r_.fail(node, fmt::format("'stock': {}", message));
        return *stock;
    }

    toolpath::Stock read_stock_from_file(const TomlTable& t) const {
        toolpath::StockFile from;
        t.read("file", from.path);
        if (!is_stock_file(from.path))
            r_.fail(*t["file"], "expected a file .stl, .obj, .glb, .wrl, .step or .ncstock");
        t.read("move", from.move);
        if (t["turn"]) from.turn = read_turn(*t["turn"]);
        toolpath::Stock stock;
        stock.from = std::move(from);
        return stock;
    }

    toolpath::Stock read_box(const TomlTable& t, JobFile& job) const {
        std::optional<Vec3> min, max;
        std::string axis = "Z";
        toolpath::Stock stock;
        for (const AssumedValue& value : assumed_values(t))
            (value.name == "size" ? job.stock_assumed : job.stock_place_assumed) = true;
        t.read("axis", axis);
        t.read("max", max);
        t.read("min", min);
        t.read("round", stock.is_round);
        stock.axis = axis[0] - 'X';
        if (!min || !max) r_.fail(t.node(), "a stock has two corners, min and max");
        if (!(min->x < max->x && min->y < max->y && min->z < max->z)) {
            r_.fail(*t["max"], "each number of max must be larger than that of min");
        }
        stock.box.add(*min), stock.box.add(*max);
        const Vec3 size = stock.box.size();
        const int across = (stock.axis + 1) % 3, up = (stock.axis + 2) % 3;
        if (stock.is_round && std::abs(size[across] - size[up]) > 1e-9 * size[across]) {
            r_.fail(*t["max"], fmt::format("a round stock along {} is as wide in {} as in {}",
                                           "XYZ"[stock.axis], "XYZ"[std::min(across, up)],
                                           "XYZ"[std::max(across, up)]));
        }
        return stock;
    }

    toolpath::ToolPiece read_piece(const TomlTable& t) const {
        toolpath::ToolPiece piece;
        t.read("cutting", piece.cutting);
        if (!t["profile"]) r_.fail(t.node(), "a piece of a tool has a profile");
        double height = 0.0;
        for (const toml::node& corner : TomlReader::list(*t["profile"])) {
            const Vec3 v = TomlReader::vector(corner);
            if (v.x < 0 || v.y < height || v.z < 0) {
                r_.fail(corner,
                        "expected [radius, height, fillet] from the lower end to the upper");
            }
            height = v.y;
            piece.profile.push_back({v.x, v.y, v.z});
        }
        if (piece.profile.empty()) r_.fail(*t["profile"], "a profile has corners");
        return piece;
    }

    toolpath::ToolEntry read_tool(const TomlTable& t) const {
        toolpath::ToolEntry entry;
        toolpath::ToolSpec& spec = entry.spec;
        t.read("assumed", spec.assumed);
        t.read("description", spec.description);
        if (const toml::node* const n = t["kind"]) {
            const auto kind = [](const auto& known) { return known.first; };
            spec.kind = std::ranges::find(kKindKeys, TomlReader::text(*n), kind)->second;
        }
        t.read("number", spec.number);
        t.read("offset", entry.offset);
        for (const NamedValue& named : kValueKeys)
            t.read(named.name, spec.*named.value);
        for (const NamedSegments& named : kSegmentKeys)
            spec.*named.value = read_segments(r_, t, named.name);
        t.each("piece", [&](const TomlTable& piece) { spec.pieces.push_back(read_piece(piece)); });
        if (!t["number"]) r_.fail(t.node(), "a tool has a number, 0 for a program that calls none");
        if (!toolpath::is_complete(spec)) r_.fail(t.node(), "a tool needs a diameter above 0");
        entry.specified_by = toolpath::ValueSource::Table;
        entry.span = {static_cast<std::uint32_t>(t.node().source().begin.line), 1, 0};
        entry.text = spec.description;
        entry.file = base_name(r_.name());
        return entry;
    }

    TomlReader r_;
    std::string folder_;
    InputSet& inputs_;
};

}  // namespace

std::optional<std::string> variable_name(std::string_view text) {
    std::string name = lowercase(text);
    if (name.starts_with("#<") && name.ends_with('>') && name.size() > 3) return name;
    constexpr std::size_t kMostDigits = 5;
    // Q parameters of Klartext and R parameters of SINUMERIK begin at 0.
    const bool is_parameter = name.starts_with('q') || name.starts_with('r');
    const bool begins = name.starts_with('#') ? name.size() > 1 && name[1] != '0' : is_parameter;
    const bool is_number = begins && name.size() > 1 && name.size() <= kMostDigits + 1 &&
                           name.find_first_not_of("0123456789", 1) == std::string::npos;
    if (!is_number) return std::nullopt;
    return name;
}

std::optional<int> compensation_register(std::string_view text) {
    constexpr int kMost = 9999;
    if (text.size() < 2 || (text[0] != 'D' && text[0] != 'd')) return std::nullopt;
    const auto number = number_in<int>(text.substr(1));
    return number && *number >= 1 && *number <= kMost ? number : std::nullopt;
}

JobFile parse_job_file(const gcode::SourceFile& file) {
    InputSet inputs;
    return JobReader(file, std::filesystem::path(file.name).parent_path().string(), inputs).read();
}

JobFile read_job_file(const std::string& path, InputSet& inputs) {
    const gcode::SourceFile file{name_of_input(path), inputs.read(path, kMostSetUpBytes)};
    return JobReader(file, std::filesystem::path(path).parent_path().string(), inputs).read();
}

bool is_job_file(const std::string& path) {
    constexpr std::string_view kEnding = ".toml";
    return path.size() > kEnding.size() && path.ends_with(kEnding);
}

bool is_job_text(const gcode::SourceFile& file) {
    const TomlReader reader(file.name, file.text);
    constexpr std::string_view kKeysOfJobs[] = {"version", "program", "setup", "stock", "machine"};
    return std::ranges::any_of(kKeysOfJobs,
                               [&](std::string_view key) { return reader.root().contains(key); });
}

std::string output_below(const std::string& folder, const std::string& name,
                         const std::string& where) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path here = fs::weakly_canonical(folder.empty() ? "." : folder, error);
    const fs::path path = fs::weakly_canonical(here / name, error);
    const fs::path relative = path.lexically_relative(here);
    if (error || fs::path(name).is_absolute() || relative.empty() || *relative.begin() == ".." ||
        !relative.has_filename() || relative == ".") {
        throw std::runtime_error(fmt::format(
            "{}: '{}': outputs of a job are below the folder of the job file", where, name));
    }
    return seen_in(folder, name);
}

std::vector<JobStep> steps_of(const JobFile& file, const std::string& folder) {
    std::vector<JobStep> steps;
    if (file.set_ups.empty() && !file.program.empty())
        steps.push_back({1, {}, seen_in(folder, file.program), true, {}});
    for (std::size_t i = 0; i < file.set_ups.size(); ++i) {
        const JobSetUp& set_up = file.set_ups[i];
        for (std::size_t k = 0; k < set_up.programs.size(); ++k) {
            JobStep step{i + 1, set_up.name, seen_in(folder, set_up.programs[k]), k == 0, {}};
            step.label = fmt::format("set-up {}", i + 1);
            if (!set_up.name.empty()) step.label += ", " + one_line(set_up.name);
            if (set_up.programs.size() > 1)
                step.label += fmt::format(", program {} of {}", k + 1, set_up.programs.size());
            steps.push_back(std::move(step));
        }
    }
    return steps;
}

}  // namespace ncsim::setup
