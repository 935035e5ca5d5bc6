// SPDX-License-Identifier: GPL-3.0-or-later
//
// Follows a program up to a block, and collects what the block does.
#include "ncsim/report/explain.h"

#include "ncsim/base/file_names.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/report/value_source.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/toolpath/tool.h"

#include "source_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::report {

namespace {

// File and line; line 0: the start of the program.
struct Place {
    std::uint32_t file = 0, line = 0;
};

// Line of a file of a program.
struct LineState {
    std::uint64_t executions = 0;
    gcode::MachineState before, after;
    std::array<Place, kModeGroups> set_by;
    std::array<bool, kModeGroups> is_changed{};
    std::vector<gcode::Motion> motions;
    std::uint64_t motion_count = 0;
    verify::Distances distances;
};

// Follows a program, and keeps the effect of a line, by file.
class LineWatch {
public:
    LineWatch(std::uint32_t line, const toolpath::Kinematics* machine)
        : line_(line), machine_(machine) {}

    void take(std::uint32_t file, std::uint32_t line, const gcode::MachineState& state) {
        const ModeNumbers numbers = numbers_of(state);
        std::array<bool, kModeGroups> is_changed{};
        for (std::size_t i = 0; i < kModeGroups; ++i) {
            is_changed[i] = line > 0 && numbers[i] != numbers_[i];
            if (is_changed[i]) set_by_[i] = {file, line};
        }
        if (line == line_) {
            LineState& seen = by_file_[file];
            if (++seen.executions == 1) {
                seen.before = state_;
                seen.after = state;
                seen.set_by = set_by_;
                seen.is_changed = is_changed;
            }
        }
        numbers_ = numbers;
        state_ = state;
    }

    void take(const gcode::Motion& motion) {
        if (motion.span.line != line_) return;
        LineState& seen = by_file_[motion.file];
        ++seen.motion_count;
        if (seen.motions.size() < Explanation::kMostMotions) seen.motions.push_back(motion);
        if (gcode::start_of(motion))
            verify::add_path(seen.distances, motion, verify::coarse_samples(motion, machine_));
        else
            verify::add_rest(seen.distances, motion);
    }

    // Returns null if the line of the file was not reached.
    const LineState* of(std::uint32_t file) const {
        const auto found = by_file_.find(file);
        return found == by_file_.end() ? nullptr : &found->second;
    }

private:
    std::uint32_t line_;
    const toolpath::Kinematics* machine_;
    gcode::MachineState state_;
    ModeNumbers numbers_{};
    std::array<Place, kModeGroups> set_by_;
    std::map<std::uint32_t, LineState> by_file_;
};

// Returns X, Y and Z in the machine, in active units; no value under a tilted plane, tip control or
// interpolation.
std::optional<std::array<double, 3>> known_machine_position(const gcode::MachineState& s) {
    const bool is_plain = !s.frames.tilt && s.coordinates == gcode::Coordinates::Axes &&
                          !s.polar_interpolation && !s.cylinder;
    const bool is_placed = std::ranges::all_of(s.frame, [](int frame) { return frame == 0; });
    const bool has_length = s.length_register == gcode::kNoLength || s.length_specified;
    const bool is_known = s.known.all() && !s.of_machine.any() && !s.relative.any();
    if (!is_plain || !is_placed || !has_length || !is_known) return std::nullopt;
    const gcode::Axes p = s.machine_position();
    return std::array{p[gcode::kX], p[gcode::kY], p[gcode::kZ]};
}

// Returns the index of a called file; 0 for the main program.
std::uint32_t file_number(const std::vector<std::string>& files, const std::string& name) {
    if (name.empty()) return 0;
    const auto found = std::ranges::find_if(files, [&](const std::string& file) {
        return file == name || base_name(file) == base_name(name);
    });
    if (found == files.end())
        throw std::runtime_error(fmt::format("the program does not call a file '{}'", name));
    return static_cast<std::uint32_t>(found - files.begin());
}

// Returns a line. Throws: std::runtime_error.
std::string line_of(const gcode::SourceFile& file, std::uint32_t line) {
    const std::vector<std::string_view> lines = lines_of(file.text);
    if (line > lines.size()) {
        throw std::runtime_error(fmt::format("{}: there is no line {}: the file has {} lines",
                                             file.name, line, lines.size()));
    }
    return std::string(lines[line - 1]);
}

// Returns the line in which the Klartext block with `line` begins: "~" continues a block.
std::uint32_t first_line_of(const gcode::SourceFile& file, std::uint32_t line) {
    const std::vector<std::string_view> lines = lines_of(file.text);
    const auto continues = [&](std::uint32_t number) {
        const std::string_view text = lines[number - 1];
        const std::size_t last = text.find_last_not_of(" \t");
        return last != std::string_view::npos && text[last] == '~';
    };
    while (line > 1 && line <= lines.size() && continues(line - 1))
        --line;
    return line;
}

// Adds the removed volume of the block, or the reason why the volume is unknown.
void add_removed(const simulation::Plan& plan, const simulation::Survey& survey, std::uint32_t file,
                 Explanation& explanation) {
    if (!survey.is_ready()) {
        explanation.not_simulated = "the program cannot be simulated";
        return;
    }
    simulation::Plan cut = plan;
    cut.block_volumes = true;
    cut.keep_boundary = cut.keep_paths = false;
    if (file == 0 && explanation.executions == 1) cut.at_line = explanation.line;
    const simulation::Simulation simulation = simulation::simulate(cut, survey, {}, {});
    const auto found = simulation.removed_by_block.find({file, explanation.line});
    explanation.removed_mm3 = found == simulation.removed_by_block.end() ? 0.0 : found->second;
}

void add_tool(const simulation::Survey& survey, Explanation& explanation) {
    const auto used = survey.tools.find(explanation.after.tool);
    if (used == survey.tools.end()) return;
    const simulation::UsedTool& tool = used->second;
    explanation.tool = toolpath::describe(tool.tool);
    explanation.tool_source =
        tool.is_guess ? "assumed"
                      : specified(tool.specified_by, tool.span, tool.text, tool.file, "--tool");
}

}  // namespace

Explanation explain(const simulation::Plan& plan, const simulation::Survey& survey,
                    std::uint32_t line, const std::string& file, bool with_volume) {
    const bool is_klartext = survey.interpretation.dialect.dialect == gcode::Dialect::Heidenhain;
    if (is_klartext) {
        const auto read = plan.job.interpreter.read_file;
        const auto other = file.empty() || !read ? std::nullopt : read(file);
        if (other || file.empty()) line = first_line_of(other ? *other : plan.job.program, line);
    }
    LineWatch watch(line, plan.placed.get());
    gcode::InterpreterOptions options = plan.job.interpreter;
    options.observe_state = [&](std::uint32_t of, std::uint32_t at,
                                const gcode::MachineState& state) { watch.take(of, at, state); };
    std::map<std::string, gcode::SourceFile> called;
    options.read_file = [&](std::string_view name) {
        auto source =
            plan.job.interpreter.read_file ? plan.job.interpreter.read_file(name) : std::nullopt;
        if (source) called.insert_or_assign(source->name, *source);
        return source;
    };
    const gcode::Interpretation interpretation = gcode::interpret(
        plan.job.program, options, [&](const gcode::Motion& motion) { watch.take(motion); });

    const std::uint32_t number = file_number(interpretation.files, file);
    Explanation result;
    result.program = relative_path(plan.job.program.name);
    result.file = number == 0 ? result.program : interpretation.files[number];
    result.line = line;
    const auto source = called.find(result.file);
    result.text =
        line_of(number == 0 || source == called.end() ? plan.job.program : source->second, line);
    const LineState* const seen = watch.of(number);
    if (!seen || seen->executions == 0) return result;
    result.executions = seen->executions;
    result.before = seen->before;
    result.after = seen->after;
    result.machine_position = known_machine_position(seen->after);
    result.is_changed = seen->is_changed;
    for (std::size_t i = 0; i < kModeGroups; ++i) {
        const Place& place = seen->set_by[i];
        result.set_by[i] = {place.file == 0 ? result.program : interpretation.files[place.file],
                            place.line};
    }
    result.has_codes = !is_klartext;
    result.motions = seen->motions;
    result.motion_count = seen->motion_count;
    result.distances = seen->distances;
    result.assumptions = interpretation.inherited_modes;
    for (const gcode::Diagnostic& d : interpretation.diagnostics) {
        if (d.span.line == line && (number == 0 ? d.file.empty() : d.file == result.file))
            result.diagnostics.push_back(d);
    }
    add_tool(survey, result);
    if (with_volume) {
        add_removed(plan, survey, number, result);
    } else {
        result.not_simulated = "--no-volume";
    }
    return result;
}

}  // namespace ncsim::report
