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
        JobFile job;
        note_values(r_.root(), "", job.values);
        // Reads a list of words, each of which has to satisfy `known`.
        const auto words = [this](std::vector<std::string>& values, auto known,
                                  const char* expected) {
            return [this, &values, known, expected](const auto& n, const auto& k) {
                values = TomlReader::texts(n);
                if (!std::ranges::all_of(values, known))
                    r_.fail(n, fmt::format("'{}': expected {}", k, expected));
            };
        };
        const auto is_reason = [](const std::string& name) {
            return name == "all" || verify::find_reason(name);
        };
        TomlReader::Keys keys{
            {"version",
             [&](const auto& n, const auto&) {
                 const auto version = n.template value<std::int64_t>();
                 if (version != kJobVersion && version != kVersionWithoutOrigin)
                     r_.fail(n, "this version of job files is not known; expected 2");
                 job.has_unknown_origin = version == kVersionWithoutOrigin;
             }},
            {"assumed",
             [&](const auto& n, const auto&) {
                 for (const AssumedValue& value : assumed_values(n)) {
                     if (value.name == "units" || value.name == "dialect") {
                         (value.name == "units" ? job.units_assumed : job.dialect_assumed) = true;
                     } else {
                         job.assumed.push_back(value);
                     }
                 }
             }},
            {"program", [&](const auto& n, const auto& k) { job.program = read_program(n, k); }},
            {"units",
             [&](const auto& n, const auto&) { job.inches = TomlReader::text(n) == "inch"; }},
            {"dialect", [&](const auto& n, const auto&) { job.dialect = dialect_named(n); }},
            {"strict", into(job.strict)},
            {"block_delete", into(job.block_delete)},
            {"increments", into(job.increments)},
            {"variables",
             [&](const auto& n, const auto& k) { job.variables = read_variables(n, k); }},
            {"compensation",
             [&](const auto& n, const auto& k) { job.compensation = read_compensation(n, k); }},
            {"allow", into(job.allow)},
            {"accept",
             words(job.accept, is_reason, "reasons for doubt, as ncsim rules lists them")},
            {"require", into(job.require)},
            {"start", into(job.start)},
            {"offsets", [&](const auto& n, const auto&) { job.offsets = read_offsets(r_, n); }},
            {"holders", into(job.holders)},
            {"stock",
             [&](const auto& n, const auto& k) {
                 job.stock = n.is_string() ? read_stock_text(n, k)
                                           : read_stock(TomlReader::table(n), k, job);
             }},
            {"fixture",
             [&](const auto& n, const auto& k) {
                 job.fixtures_specified = true;
                 job.fixtures = read_fixtures(n, k);
             }},
            {"below_stock", into(job.below_stock)},
            {"outputs", [&](const auto& n, const auto& k) { job.outputs = read_outputs(n, k); }},
            {"setup", tables([&](const toml::node& one, const std::string& key) {
                 job.set_ups.push_back(read_set_up(TomlReader::table(one), key));
             })},
            {"tool", tables([&](const toml::node& tool, const std::string& key) {
                 toolpath::ToolEntry entry = read_tool(TomlReader::table(tool), key);
                 const int number = entry.spec.number;
                 if (toolpath::find_tool(job.tools, number))
                     r_.fail(tool, fmt::format("tool {} is described twice", number));
                 job.values[fmt::format("tool {}", number)] = {r_.place_of(tool), {}};
                 job.tools.push_back(std::move(entry));
             })}};
        for (const std::string_view option : kJobOptions) {
            std::string key(option);
            std::ranges::replace(key, '-', '_');
            keys[key] = [&, option](const auto& n, const auto& k) {
                job.settings.push_back(read_option(r_, std::string(option), k, n));
            };
        }
        TomlReader::each(r_.root(), "", keys);
        check_set_ups(job);
        return job;
    }

private:
    static bool is_job_option(std::string key) {
        std::ranges::replace(key, '_', '-');
        return std::ranges::find(kJobOptions, key) != std::end(kJobOptions);
    }

    // Returns the names in a list `assumed`.
    std::vector<AssumedValue> assumed_values(const toml::node& list) const {
        std::vector<AssumedValue> values;
        for (const toml::node& name : TomlReader::list(list))
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

    std::vector<verify::Fixture> read_fixtures(const toml::node& node,
                                               const std::string& key) const {
        std::vector<verify::Fixture> fixtures;
        TomlReader::each_of(node, key, [&](const toml::node& one, const std::string&) {
            read_fixture(r_, folder_, inputs_, one, key, fixtures);
        });
        return fixtures;
    }

    std::map<std::string, std::string> read_outputs(const toml::node& node,
                                                    const std::string& key) const {
        std::map<std::string, std::string> outputs;
        TomlReader::Keys keys;
        for (const auto& [format, ending] : kOutputs) {
            keys[std::string(format)] = [&, format = std::string(format), ending = ending](
                                            const toml::node& n, const std::string& k) {
                const std::string name = TomlReader::text(n);
                if (!name.ends_with(ending) || name.size() == ending.size())
                    r_.fail(n, fmt::format("'{}': expected a name that ends in {}", k, ending));
                (void)output_below(folder_, name, r_.place_of(n));
                for (const auto& [other, same] : outputs) {
                    if (same == name)
                        r_.fail(n, fmt::format("'{}' is also the output of {}", name, other));
                }
                outputs[format] = name;
            };
        }
        TomlReader::each(TomlReader::table(node), key, keys);
        return outputs;
    }

    JobSetUp read_set_up(const toml::table& t, const std::string& key) const {
        JobSetUp set_up;
        set_up.where = r_.place_of(t);
        TomlReader::each(
            t, key,
            {{"name", into(set_up.name)},
             {"program",
              [&](const auto& n, const auto& k) { set_up.programs = {read_program(n, k)}; }},
             {"programs",
              [&](const toml::node& n, const std::string& k) {
                  for (const toml::node& one : TomlReader::list(n))
                      set_up.programs.push_back(read_program(one, k));
              }},
             {"turn", [&](const auto& n, const auto&) { set_up.turn = read_turn(n); }},
             {"move", into(set_up.move)},
             {"points",
              [&](const auto& n, const auto& k) {
                  TurnAndMove motion = read_points(n, k);
                  set_up.turn = std::move(motion.turn);
                  set_up.move = motion.move;
              }},
             {"zero", into(set_up.zero)},
             {"start", into(set_up.start)},
             {"offsets", [&](const auto& n, const auto&) { set_up.offsets = read_offsets(r_, n); }},
             {"variables",
              [&](const auto& n, const auto& k) { set_up.variables = read_variables(n, k); }},
             {"fixture",
              [&](const auto& n, const auto& k) {
                  set_up.fixtures_specified = true;
                  set_up.fixtures = read_fixtures(n, k);
              }},
             {"below_stock", into(set_up.below_stock)},
             {"outputs",
              [&](const auto& n, const auto& k) { set_up.outputs = read_outputs(n, k); }},
             {"assumed", [&](const auto& n, const auto&) { set_up.assumed = assumed_values(n); }}});
        if (t.contains("program") && t.contains("programs"))
            r_.fail(t, "a set-up has program or programs, not both");
        if (set_up.programs.empty()) r_.fail(t, "a set-up needs a program");
        if (t.contains("points") && (t.contains("turn") || t.contains("move")))
            r_.fail(*t.get("points"), "a set-up has points, or turn and move, not both");
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

    TurnAndMove read_points(const toml::node& node, const std::string& key) const {
        std::array<Vec3, 3> before{}, now{};
        const auto three = [](std::array<Vec3, 3>& points) {
            return [&points](const toml::node& n, const std::string&) {
                std::ranges::transform(TomlReader::list(n), points.begin(), TomlReader::vector);
            };
        };
        const toml::table& table = TomlReader::table(node);
        TomlReader::each(table, key, {{"before", three(before)}, {"now", three(now)}});
        if (table.size() != 2) r_.fail(node, fmt::format("'{}': expected before and now", key));
        try {
            return motion_of(before, now);
        } catch (const std::invalid_argument& e) {
            r_.fail(node, fmt::format("'{}': {}", key, e.what()));
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

    std::map<std::string, double> read_variables(const toml::node& node,
                                                 const std::string& key) const {
        std::map<std::string, double> variables;
        for (const auto& [name, value] : TomlReader::table(node)) {
            const std::string where = fmt::format("{}.{}", key, name.str());
            const auto variable = variable_name(name.str());
            if (!variable)
                r_.fail(value,
                        fmt::format("'{}': expected \"#500\", \"#<_name>\", R5 or Q5", where));
            variables.emplace(*variable, TomlReader::number(value));
        }
        return variables;
    }

    std::map<int, double> read_compensation(const toml::node& node, const std::string& key) const {
        std::map<int, double> radii;
        for (const auto& [name, value] : TomlReader::table(node)) {
            const std::string where = fmt::format("{}.{}", key, name.str());
            const auto number = compensation_register(name.str());
            if (!number) r_.fail(value, fmt::format("'{}': expected a register, as D1", where));
            radii.emplace(*number, TomlReader::number(value));
        }
        return radii;
    }

    toolpath::Stock read_stock_from_file(const toml::table& t, const std::string& key) const {
        toolpath::StockFile from;
        TomlReader::each(
            t, key,
            {{"file",
              [&](const auto& n, const auto&) {
                  from.path = TomlReader::text(n);
                  if (!is_stock_file(from.path))
                      r_.fail(n, "expected a file .stl, .obj, .glb, .wrl, .step or .ncstock");
              }},
             {"turn", [&](const auto& n, const auto&) { from.turn = read_turn(n); }},
             {"move", into(from.move)}});
        toolpath::Stock stock;
        stock.from = std::move(from);
        return stock;
    }

    toolpath::Stock read_stock_text(const toml::node& node, const std::string& key) const {
        std::string message;
        auto stock = toolpath::parse_stock_option(TomlReader::text(node), message);
        if (!stock) r_.fail(node, fmt::format("'{}': {}", key, message));
        return *stock;
    }

    toolpath::Stock read_stock(const toml::table& t, const std::string& key, JobFile& job) const {
        if (t.contains("file")) return read_stock_from_file(t, key);
        std::optional<Vec3> min, max;
        toolpath::Stock stock;
        TomlReader::each(
            t, key,
            {{"assumed",
              [&](const auto& n, const auto&) {
                  for (const AssumedValue& value : assumed_values(n))
                      (value.name == "size" ? job.stock_assumed : job.stock_place_assumed) = true;
              }},
             {"min", into(min)},
             {"max", into(max)},
             {"axis",
              [&](const auto& n, const auto&) { stock.axis = TomlReader::text(n)[0] - 'X'; }},
             {"round", into(stock.is_round)}});
        if (!min || !max) r_.fail(t, "a stock has two corners, min and max");
        if (!(min->x < max->x && min->y < max->y && min->z < max->z)) {
            r_.fail(*t.get("max"), "each number of max must be larger than that of min");
        }
        stock.box.add(*min), stock.box.add(*max);
        const Vec3 size = stock.box.size();
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
        TomlReader::each(
            TomlReader::table(node), key,
            {{"cutting", into(piece.cutting)},
             {"profile", [&](const toml::node& n, const std::string&) {
                  double height = 0.0;
                  for (const toml::node& corner : TomlReader::list(n)) {
                      const Vec3 v = TomlReader::vector(corner);
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
        toolpath::ToolSpec& spec = entry.spec;
        TomlReader::Keys keys{
            {"number", into(spec.number)},
            {"kind",
             [&](const auto& n, const auto&) {
                 spec.kind =
                     std::ranges::find(kKindKeys, TomlReader::text(n), [](const auto& kind) {
                         return kind.first;
                     })->second;
             }},
            {"offset", into(entry.offset)},
            {"description", into(spec.description)},
            {"assumed", into(spec.assumed)},
            {"piece", tables([&](const toml::node& piece, const std::string& key) {
                 spec.pieces.push_back(read_piece(piece, key));
             })}};
        for (const NamedValue& named : kValueKeys)
            keys[named.name] = into(spec.*named.value);
        for (const NamedSegments& named : kSegmentKeys) {
            keys[named.name] = [&, value = named.value](const auto& n, const auto& k) {
                spec.*value = read_segments(r_, n, k);
            };
        }
        TomlReader::each(t, where, keys);
        if (!t.contains("number")) {
            r_.fail(t, "a tool has a number, 0 for a program that calls none");
        }
        if (!toolpath::is_complete(spec)) r_.fail(t, "a tool needs a diameter above 0");
        entry.specified_by = toolpath::ValueSource::Table;
        entry.span = {static_cast<std::uint32_t>(t.source().begin.line), 1, 0};
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
