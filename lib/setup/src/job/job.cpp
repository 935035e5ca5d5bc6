// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes jobs of programs, options, job files, tool tables and comments.
#include "ncsim/setup/job.h"

#include "ncsim/base/file_names.h"
#include "ncsim/gcode/executed_text.h"
#include "ncsim/gcode/file_programs.h"
#include "ncsim/gcode/subprogram_file.h"
#include "ncsim/setup/coordinate_systems.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/setup/tool_library.h"
#include "ncsim/verify/machine_description.h"

#include "job/holder_file.h"
#include "job/setup_messages.h"
#include "job/unit_clues.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

// True for binary data. No control reads a program with NUL bytes in its text. Punched tape had NUL
// bytes as leader, before the first '%', where they are harmless.
bool is_binary(std::string_view text) {
    const std::size_t begin = text.find_first_not_of('\0');
    if (begin == std::string_view::npos) return !text.empty();
    const std::size_t last = text.find_last_not_of(std::string_view("\0\x1a", 2));
    return text.substr(begin, last + 1 - begin).find('\0') != std::string_view::npos;
}

// True if a line begins with the program number `digits`: "O1234", "O01234 (DRILL)", ":1234".
bool begins_program(std::string_view text, std::string_view digits) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto is_letter = [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; };
    for (std::size_t line = 0; line < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", line), text.size());
        std::size_t at = text.find_first_not_of(" \t", line);
        if (at < end && (text[at] == 'O' || text[at] == 'o' || text[at] == ':')) {
            at = text.find_first_not_of(" \t", at + 1);
            while (at < end && text[at] == '0')
                ++at;
            if (at < end && text.substr(at, digits.size()) == digits) {
                const std::size_t behind = at + digits.size();
                const bool ends = behind >= end || !is_digit(text[behind]);
                const std::size_t word = text.find_first_not_of(" \t", behind);
                // "O12 sub", "O12 while": labels of LinuxCNC.
                const bool is_label = word < end && word + 1 < end && is_letter(text[word]) &&
                                      is_letter(text[word + 1]);
                if (ends && !is_label) return true;
            }
        }
        line = std::max(end, line) + 1;
    }
    return false;
}

// Returns the only file of a folder in which the program with this number begins. Empty if there
// are several, because the program in the control is unknown.
std::optional<std::string> file_with_program(const std::filesystem::path& folder,
                                             std::string_view name) {
    constexpr std::size_t kMostFiles = 2000;
    constexpr std::uintmax_t kMostBytes = 4'000'000;
    std::string_view digits = name.substr(name.empty() ? 0 : 1);
    if (name.empty() || name[0] != 'O' || digits.empty() ||
        digits.find_first_not_of("0123456789") != std::string_view::npos) {
        return std::nullopt;
    }
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    if (digits.empty()) return std::nullopt;
    std::optional<std::string> found;
    std::error_code ignored;
    std::size_t files = 0;
    const std::filesystem::path here = folder.empty() ? "." : folder;
    for (const auto& entry : std::filesystem::directory_iterator(here, ignored)) {
        if (++files > kMostFiles) return std::nullopt;
        if (!gcode::is_program_file(entry.path().filename().string())) continue;
        if (!entry.is_regular_file(ignored) || entry.file_size(ignored) > kMostBytes) continue;
        std::ifstream in(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        if (!begins_program(text, digits)) continue;
        if (found) return std::nullopt;
        found = entry.path().filename().string();
    }
    return found;
}

// Reads a subprogram in the folder of the program or in the specified folders: "O<probe>" in
// probe.ngc, "M98 P1234" in O1234.nc, or in the file in which O1234 begins, whatever its name.
std::optional<gcode::SourceFile> read_subprogram(const std::vector<std::filesystem::path>& folders,
                                                 std::string_view name, InputSet& inputs) {
    const std::vector<std::string> files = gcode::subprogram_files(name);
    for (const std::filesystem::path& folder : folders) {
        for (const std::string& file : files) {
            const std::filesystem::path path = folder / file;
            if (inputs.is_there(path.string()))
                return gcode::SourceFile{file, inputs.read(path.string())};
        }
    }
    for (const std::filesystem::path& folder : folders) {
        inputs.look_through(folder.string());
        if (const std::optional<std::string> file = file_with_program(folder, name))
            return gcode::SourceFile{*file, inputs.read((folder / *file).string())};
    }
    return std::nullopt;
}

// Replaces the values of the only set-up by those of a step.
void select_step(JobFile& file, const JobStep& step) {
    if (file.set_ups.empty()) return;
    JobSetUp& set_up = file.set_ups[step.set_up - 1];
    file.fixtures = std::move(set_up.fixtures);
    file.fixtures_specified = set_up.fixtures_specified;
    if (set_up.below_stock) file.below_stock = set_up.below_stock;
    if (set_up.start) file.start = set_up.start;
    for (const auto& [system, origin] : set_up.offsets)
        file.offsets.insert_or_assign(system, origin);
    for (const auto& [name, value] : set_up.variables)
        file.variables.insert_or_assign(name, value);
    file.assumed.insert(file.assumed.end(), set_up.assumed.begin(), set_up.assumed.end());
    if (!file.stock) return;
    file.stock->box.min = file.stock->box.min - set_up.zero;
    file.stock->box.max = file.stock->box.max - set_up.zero;
    if (file.stock->from) file.stock->from->move = file.stock->from->move - set_up.zero;
}

// Fills in options from the job file unless the command line specifies them.
JobFile take_job_file(JobOptions& options, InputSet& inputs) {
    JobFile file = read_job_file(options.job, inputs);
    const std::string folder = std::filesystem::path(options.job).parent_path().string();
    std::error_code ignored;
    const bool is_read_again = !file.set_ups.empty() || !file.settings.empty();
    if (is_read_again && !std::filesystem::is_regular_file(options.job, ignored)) {
        throw std::runtime_error(
            fmt::format("'{}': a job with set-ups, a machine or options is read several times: "
                        "save it as a file",
                        name_of_input(options.job)));
    }
    if (const auto number = selected_step(options, inputs)) {
        const JobStep step = steps_of(file, folder).at(*number);
        options.job_step = number;
        if (options.program.empty()) options.program = step.program;
        select_step(file, step);
    }
    if (options.program.empty()) {
        if (file.program.empty()) {
            throw std::runtime_error(
                fmt::format("'{}' names no program, and neither does the command line",
                            name_of_input(options.job)));
        }
        options.program = seen_in(folder, file.program);
    }
    if (file.stock && file.stock->from) {
        file.stock->from->path = seen_in(folder, file.stock->from->path);
    }
    if (!options.inches) {
        options.inches = file.inches;
        options.inches_assumed = file.units_assumed;
    }
    if (file.dialect && !file.dialect_assumed && options.dialect == gcode::Dialect::Auto)
        options.dialect = *file.dialect;
    options.strict |= file.strict;
    if (!options.block_delete) options.block_delete = file.block_delete;
    if (!options.increments) options.increments = file.increments;
    options.variables.insert(file.variables.begin(), file.variables.end());
    options.compensation.insert(file.compensation.begin(), file.compensation.end());
    const auto append = [](auto& list, const auto& more) {
        list.insert(list.end(), more.begin(), more.end());
    };
    append(options.allow, file.allow);
    append(options.accept, file.accept);
    append(options.require, file.require);
    if (!options.start) options.start = file.start;
    options.offsets = file.offsets;
    if (options.holders.empty() && !file.holders.empty())
        options.holders = seen_in(folder, file.holders);
    return file;
}

// Reads the tool tables. A CAMotics project may also specify the unit of programs without G20 and
// G21.
std::vector<toolpath::ToolFile> read_tables(JobOptions& options, InputSet& inputs) {
    std::vector<toolpath::ToolFile> tables;
    for (const std::string& path : options.tool_tables) {
        tables.push_back(read_tool_library(path, inputs, options.inches.value_or(false)));
        for (const gcode::Diagnostic& d : tables.back().diagnostics) {
            if (d.severity != gcode::Severity::Error) continue;
            throw std::runtime_error(fmt::format("{}:{}:{}: {}", name_of_input(path), d.span.line,
                                                 d.span.column, d.message));
        }
        if (!options.inches) options.inches = tables.back().inches;
    }
    return tables;
}

std::string text_of(const Box& box) {
    return fmt::format("{:g},{:g},{:g}:{:g},{:g},{:g}", box.min.x, box.min.y, box.min.z, box.max.x,
                       box.max.y, box.max.z);
}

// Returns the point angle of drills, spot drills, V-cutters, chamfer mills and countersinks, which
// all have the shape of a cylinder above a cone; nullopt for other tools.
std::optional<double> point_angle(const toolpath::ToolSpec& spec) {
    using toolpath::ToolKind;
    constexpr double kDrill = 118.0;
    constexpr double kCutter = 90.0;
    if (!spec.kind || spec.tip_diameter.value_or(0.0) > 0.0) return std::nullopt;
    switch (*spec.kind) {
        case ToolKind::Drill: return spec.angle.value_or(kDrill);
        case ToolKind::VCutter:
        case ToolKind::ChamferMill:
        case ToolKind::Countersink:
            return spec.angle.value_or(spec.taper ? 2.0 * *spec.taper : kCutter);
        default: return std::nullopt;
    }
}

// True if the shapes differ by kind or angle: a spot drill of 90 degrees is a drill of 90 degrees,
// and no V-cutter of 60 degrees. Angles that are not specified count only if the kinds differ.
bool has_other_shape(const toolpath::ToolSpec& a, const toolpath::ToolSpec& b) {
    constexpr double kSameAngle = 0.01;
    if (!a.kind || !b.kind) return false;
    const bool is_same_kind = *a.kind == *b.kind;
    const std::optional<double> angle_a = point_angle(a);
    const std::optional<double> angle_b = point_angle(b);
    if (!angle_a || !angle_b) return !is_same_kind;
    const bool is_specified = (a.angle || a.taper) && (b.angle || b.taper);
    return (is_specified || !is_same_kind) && std::abs(*angle_a - *angle_b) > kSameAngle;
}

// Adds a doubt if --tool and a description in a file or comment are of different tools.
void doubt_contradiction(Job& job, const toolpath::ToolEntry& option,
                         const toolpath::ToolEntry& entry) {
    constexpr double kSame = 1e-3;  // mm; CAM systems round printed values
    const toolpath::ToolSpec &a = option.spec, &b = entry.spec;
    const bool has_other_kind = has_other_shape(a, b);
    const bool has_other_diameter =
        a.diameter && b.diameter && std::abs(*a.diameter - *b.diameter) > kSame;
    if (!has_other_kind && !has_other_diameter) return;
    const auto text_of = [](const toolpath::ToolSpec& spec) {
        std::string text = spec.kind ? std::string(toolpath::name_of(*spec.kind)) : "tool";
        if (spec.diameter) text += fmt::format(" D{:g}", *spec.diameter);
        return text;
    };
    const bool is_comment = entry.specified_by == toolpath::ValueSource::Comment;
    job.doubts.push_back({"contradiction",
                          fmt::format("T{} is a {} by --tool and a {} by {}", a.number, text_of(a),
                                      text_of(b), is_comment ? "its comment" : entry.file),
                          is_comment ? entry.span : gcode::SourceSpan{}});
}

// Adds a doubt if --stock and the comments of the program describe different blocks; a stock file
// may be a part of the block.
void doubt_contradiction(Job& job, const std::optional<toolpath::StockEntry>& noted) {
    constexpr double kSame = 0.01;  // mm
    if (!noted || !job.stock || job.stock->specified_by != toolpath::ValueSource::Option) return;
    const Box &option = job.stock->box, &block = noted->box;
    bool differs = false;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = block.min[axis] - option.min[axis];
        const double high = option.max[axis] - block.max[axis];
        if (noted->place_assumed) {
            differs |= std::abs(option.size()[axis] - block.size()[axis]) > kSame;
        } else {
            differs |= low > kSame || high > kSame;
            if (!job.stock->shape) differs |= low < -kSame || high < -kSame;
        }
    }
    if (!differs) return;
    job.doubts.push_back({"contradiction",
                          fmt::format("the stock is {} by --stock and {} by a comment",
                                      text_of(option), text_of(block)),
                          noted->span});
}

// Adds a tool unless its number is known; the first tool of a number counts. Warns if a table and a
// later source specify different diameters, because either source then belongs to a different job.
// A tool of the command line causes a doubt instead. The offset of a table is kept if the command
// line specifies only the shape.
void add_tool(Job& job, const toolpath::ToolEntry& entry) {
    const auto known = std::ranges::find_if(job.tools, [&entry](const toolpath::ToolEntry& other) {
        return other.spec.number == entry.spec.number;
    });
    if (known == job.tools.end()) {
        job.tools.push_back(entry);
        return;
    }
    if (known->offset == Vec3{}) known->offset = entry.offset;
    if (known->specified_by == toolpath::ValueSource::Option)
        doubt_contradiction(job, *known, entry);
    constexpr double kSame = 1e-3;  // mm; CAM systems round printed values
    if (known->specified_by != toolpath::ValueSource::Table || !known->spec.diameter ||
        !entry.spec.diameter || std::abs(*known->spec.diameter - *entry.spec.diameter) <= kSame) {
        return;
    }
    gcode::Diagnostic d = gcode::diagnostic_of(
        Message::TableDisagrees, entry.span,
        {std::to_string(entry.spec.number), fmt::format("{:g}", *entry.spec.diameter), known->file,
         fmt::format("{:g}", *known->spec.diameter)});
    d.file = entry.file;
    job.diagnostics.push_back(std::move(d));
}

// Adds holders to tools without a specified holder.
void add_holders(Job& job, const std::string& path, InputSet& inputs) {
    for (const toolpath::ToolSpec& specified : read_holder_file(path, inputs)) {
        for (toolpath::ToolEntry& entry : job.tools) {
            if (entry.spec.number == specified.number) complete_assembly(entry.spec, specified);
        }
    }
}

std::optional<toolpath::StockEntry> choose_stock(const JobOptions& options, const JobFile& file,
                                                 const std::vector<toolpath::ToolFile>& tables,
                                                 std::optional<toolpath::StockEntry> noted,
                                                 InputSet& inputs) {
    if (options.left_stock) {
        toolpath::StockEntry entry{
            *options.left_stock, toolpath::ValueSource::Table, {}, "the part of the last set-up"};
        entry.file = base_name(name_of_input(options.job));
        return entry;
    }
    const bool is_placed = options.stock_turn || options.stock_move;
    if (is_placed && !(options.stock && options.stock->from)) {
        throw std::runtime_error("--stock-turn and --stock-move are for --stock FILE");
    }
    if (options.stock) {
        toolpath::Stock stock = *options.stock;
        if (stock.from && !stock.shape) {
            if (options.stock_turn) stock.from->turn = *options.stock_turn;
            if (options.stock_move) stock.from->move = *options.stock_move;
            stock = read_stock_file(*stock.from, inputs);
        }
        return toolpath::StockEntry{stock, toolpath::ValueSource::Option, {}, {}};
    }
    if (file.stock && options.job_step.value_or(0) == 0) {
        toolpath::StockEntry entry{*file.stock, toolpath::ValueSource::Table, {}, "the stock"};
        entry.file = base_name(name_of_input(options.job));
        entry.place_assumed = file.stock_place_assumed;
        if (file.stock_assumed) {
            entry.specified_by = toolpath::ValueSource::Assumption;
            entry.text = fmt::format("the block is marked as assumed in {}", entry.file);
        }
        if (entry.from) static_cast<toolpath::Stock&>(entry) = read_stock_file(*entry.from, inputs);
        return entry;
    }
    for (const toolpath::ToolFile& table : tables) {
        if (table.stock) return table.stock;
    }
    return noted;
}

/// Chooses a program of the file in `job`. A file for a different kind of control is left as a
/// whole, to be refused.
void choose_program(Job& job, const JobOptions& options) {
    if (options.dialect == gcode::Dialect::Heidenhain ||
        options.dialect == gcode::Dialect::Sinumerik)
        return;
    const gcode::ExecutedText executed(job.program, job.interpreter);
    const gcode::FilePrograms file(executed.file());
    const std::vector<gcode::FileProgram>& programs = file.programs();
    if (programs.size() < 2 && file.unreached().empty()) return;
    auto findings =
        std::make_shared<gcode::DialectFindings>(gcode::detect_dialect(executed.file()));
    const bool is_other = findings->kind != gcode::Kind::Milling;
    if (is_other && options.dialect == gcode::Dialect::Auto && !options.strict) return;
    const std::size_t number = options.number_in_file.value_or(0);
    // The first program reports for the whole file.
    if (number == 0) {
        for (const gcode::Unreached& part : file.unreached()) {
            const std::string end = std::to_string(part.end_line);
            job.diagnostics.push_back(
                part.label.empty()
                    ? gcode::diagnostic_of(Message::MovesAfterEnd, part.span, {end})
                    : gcode::diagnostic_of(Message::NeverCalled, part.span, {part.label}));
        }
    }
    if (programs.size() < 2) return;
    if (!options.number_in_file) {
        std::string others;
        for (std::size_t i = 1; i < programs.size(); ++i)
            others += (i == 1 ? "" : ", ") + programs[i].label;
        job.diagnostics.push_back(gcode::diagnostic_of(Message::OtherPrograms, programs[1].span,
                                                       {others, programs[0].label}));
    }
    job.label = programs.at(number).label;
    job.programs_in_file = programs.size();
    job.program.text = file.text_of(number, std::move(job.program.text));
    job.interpreter.of_file = std::move(findings);
}

// Combines the program with `options`, tables, comments and the job file.
Job composed(gcode::SourceFile program, JobOptions options, const JobFile& from_file,
             InputSet& inputs) {
    Job job;
    job.program = std::move(program);
    if (is_binary(job.program.text)) {
        throw std::runtime_error(
            fmt::format("'{}' is not an NC program: it is binary data", job.program.name));
    }
    const std::vector<toolpath::ToolFile> tables = read_tables(options, inputs);
    job.interpreter.block_delete = options.block_delete.value_or(false);
    job.interpreter.dialect = options.dialect;
    job.interpreter.strict = options.strict;
    job.interpreter.allow = options.allow;
    job.interpreter.least_increments = options.increments.value_or(false);
    job.interpreter.variables = options.variables;
    for (const auto& [number, radius] : options.compensation)
        job.interpreter.compensation.emplace(number, gcode::Length::from_mm(radius));
    for (gcode::Position& origin : job.interpreter.work_offsets) {
        origin.z = gcode::Length::from_mm(-verify::kHomeHeight);
    }
    for (const auto& [system, origin] : options.offsets)
        tell_offset(job.interpreter, system, origin);

    for (const toolpath::ToolSpec& spec : options.tools) {
        job.tools.push_back({spec, toolpath::ValueSource::Option, {}, spec.description});
    }
    choose_program(job, options);
    bool inches = options.inches.value_or(false);
    const gcode::ExecutedText executed(job.program, job.interpreter);
    toolpath::ProgramNotes notes = toolpath::read_notes(executed.file(), inches);
    if (!options.inches && suggests_inches(executed.file(), notes.tools)) {
        inches = true;
        notes = toolpath::read_notes(executed.file(), inches);
    }
    job.interpreter.default_units =
        inches ? gcode::DefaultUnits::Inches : gcode::DefaultUnits::Millimetres;
    job.diagnostics.insert(job.diagnostics.end(), notes.diagnostics.begin(),
                           notes.diagnostics.end());
    job.operations = std::move(notes.operations);
    for (const toolpath::ToolEntry& entry : from_file.tools)
        add_tool(job, entry);
    for (const toolpath::ToolFile& table : tables) {
        for (const toolpath::ToolEntry& entry : table.tools)
            add_tool(job, entry);
        job.diagnostics.insert(job.diagnostics.end(), table.diagnostics.begin(),
                               table.diagnostics.end());
    }
    for (const toolpath::ToolEntry& entry : notes.tools)
        add_tool(job, entry);
    if (!options.holders.empty()) add_holders(job, options.holders, inputs);
    job.start = options.start ? options.start : notes.start;
    for (int axis = 0; axis < 3 && job.start; ++axis)
        job.interpreter.start[static_cast<std::size_t>(axis)] =
            gcode::Length::from_mm((*job.start)[axis]);
    for (const toolpath::ToolEntry& entry : job.tools) {
        gcode::ToolTableEntry known;
        known.length_specified = entry.offset.z != 0.0;
        known.number = entry.spec.number;
        for (int axis = 0; axis < 3; ++axis) {
            known.offset[static_cast<std::size_t>(axis)] =
                gcode::Length::from_mm(entry.offset[axis]);
        }
        if (entry.spec.diameter) known.diameter = gcode::Length::from_mm(*entry.spec.diameter);
        job.interpreter.tools.push_back(known);
    }
    job.stock = choose_stock(options, from_file, tables, notes.stock, inputs);
    doubt_contradiction(job, notes.stock);
    job.fixtures = from_file.fixtures;
    job.fixtures_specified = from_file.fixtures_specified;
    job.below_stock = from_file.below_stock;
    for (const AssumedValue& value : from_file.assumed) {
        job.doubts.push_back({"file-origin", fmt::format("{}: '{}' is marked as assumed; measure "
                                                         "or correct it, then remove the mark",
                                                         value.where, value.name)});
    }
    job.units_assumed = !options.inches || options.inches_assumed;
    if (from_file.has_unknown_origin) {
        job.doubts.push_back(
            {"file-origin", fmt::format("{}: version 1 of job files does not record what was "
                                        "assumed: check its values, then write version = 2",
                                        name_of_input(options.job))});
    }
    if (job.stock && job.stock->shape) {
        for (const std::string& assumed : job.stock->shape->assumed)
            job.doubts.push_back(
                {"file-origin",
                 fmt::format("stock {}: {}", name_of_input(job.stock->from->path), assumed)});
    }
    job.options = std::move(options);
    return job;
}

}  // namespace

std::optional<std::size_t> selected_step(const JobOptions& options, InputSet& inputs) {
    if (options.job.empty()) return std::nullopt;
    namespace fs = std::filesystem;
    const JobFile file = read_job_file(options.job, inputs);
    if (file.set_ups.empty()) return std::nullopt;
    const std::vector<JobStep> steps = steps_of(file, fs::path(options.job).parent_path().string());
    if (options.job_step && *options.job_step >= steps.size()) {
        throw std::runtime_error(fmt::format("{}: there is no program {}: the job has {}",
                                             name_of_input(options.job), *options.job_step + 1,
                                             steps.size()));
    }
    if (options.job_step) return *options.job_step;
    const auto place_of = [](const std::string& path) {
        return fs::absolute(path).lexically_normal();
    };
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (options.program.empty() || place_of(steps[i].program) == place_of(options.program))
            found.push_back(i);
    }
    const std::string name = name_of_input(options.job);
    if (found.empty()) {
        throw std::runtime_error(
            fmt::format("'{}' is no program of '{}'", name_of_input(options.program), name));
    }
    if (found.size() > 1) {
        if (options.program.empty()) {
            throw std::runtime_error(
                fmt::format("'{}' has {} programs: choose one with step=, from 1 to {}", name,
                            found.size(), found.size()));
        }
        throw std::runtime_error(
            fmt::format("'{}' has {} programs of this name: name the job instead of a program, as "
                        "in ncsim check {}",
                        name, found.size(), name));
    }
    return found.front();
}

Job read_job(JobOptions options, InputSet& inputs) {
    JobFile from_file;
    if (!options.job.empty()) from_file = take_job_file(options, inputs);
    gcode::SourceFile program{name_of_input(options.program), inputs.read(options.program)};
    std::vector<std::filesystem::path> folders{
        std::filesystem::path(options.program).parent_path()};
    folders.insert(folders.end(), options.subprograms.begin(), options.subprograms.end());
    std::string label;
    if (!from_file.set_ups.empty()) {
        const std::string folder = std::filesystem::path(options.job).parent_path().string();
        const std::vector<JobStep> steps = steps_of(from_file, folder);
        if (steps.size() > 1) label = steps[options.job_step.value()].label;
    }
    Job job = composed(std::move(program), std::move(options), from_file, inputs);
    if (!label.empty()) job.label = job.label.empty() ? label : label + ", " + job.label;
    job.interpreter.read_file = [folders, &inputs](std::string_view name) {
        return read_subprogram(folders, name, inputs);
    };
    return job;
}

Job job_of(gcode::SourceFile program, JobOptions options) {
    InputSet inputs;
    JobFile from_file;
    options.program = program.name;
    if (!options.job.empty()) from_file = take_job_file(options, inputs);
    return composed(std::move(program), std::move(options), from_file, inputs);
}

}  // namespace ncsim::setup
