// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints a machine.
#include "commands/machine_command.h"

#include "ncsim/base/number_text.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/export/png.h"
#include "ncsim/report/describe.h"
#include "ncsim/setup/coordinate_systems.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/machine_text.h"
#include "ncsim/simulation/program_check.h"

#include "options/option_row.h"
#include "options/picture_options.h"
#include "run/machine_picture.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace ncsim::app {

namespace {

// Parses "A30,C-45".
machine::Values values_of(const std::string& pose) {
    machine::Values values{};
    for (std::string_view rest = pose; !rest.empty();) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        const std::string_view word = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const auto axis = word.empty() ? std::nullopt : machine::index_of(word[0]);
        const auto value = axis ? number_in<double>(word.substr(1)) : std::nullopt;
        constexpr double kLargest = 1e6;
        if (!value || !(std::abs(*value) <= kLargest)) {
            throw std::runtime_error(
                fmt::format("--pose '{}': expected axes and their values, as A30,C45", pose));
        }
        values[*axis] = *value;
    }
    return values;
}

std::string sheet_of_pose(const setup::MachineFile& file, const std::string& pose) {
    if (!file.kinematics)
        throw std::runtime_error(
            "--pose: the file does not specify the rotary axes of the machine");
    const machine::Values values = values_of(pose);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const char letter = machine::kLetters[i];
        if (values[i] != 0.0 && !file.kinematics->chain.find(letter))
            throw std::runtime_error(fmt::format("--pose: the machine has no axis {}", letter));
    }
    const machine::Pose X_WT = file.kinematics->chain.placed({}, 0.0).pose(values);
    const Vec3 axis = axis_of(X_WT), tip = X_WT.translation;
    return fmt::format(
        "  at {}: spindle nose at X{:.6g} Y{:.6g} Z{:.6g} of the part, whose zero is that of the "
        "machine, tool along {:.6g}, {:.6g}, {:.6g}\n",
        pose, tip.x + 0.0, tip.y + 0.0, tip.z + 0.0, axis.x + 0.0, axis.y + 0.0, axis.z + 0.0);
}

// Machine of a job, and a description of the set-ups.
struct MachineOfJob {
    std::string path;
    std::string set_ups;
};

std::string text_of(const std::map<int, Vec3>& offsets,
                    const std::vector<verify::Fixture>& fixtures) {
    std::string text;
    for (const auto& [system, at] : offsets)
        text += fmt::format("  {} at {:g}, {:g}, {:g}\n", setup::name_of_system(system), at.x + 0.0,
                            at.y + 0.0, at.z + 0.0);
    for (const verify::Fixture& fixture : fixtures)
        text += fmt::format("  fixture {}: {}\n", one_line(fixture.name),
                            report::describe(fixture.box));
    return text;
}

// Returns the machine of the job `path`; `path` if the file is not a job.
MachineOfJob machine_of(const std::string& path, setup::InputSet& inputs) {
    const bool may_be_job = setup::is_job_file(path);
    if (!may_be_job || !setup::is_job_text({path, inputs.read(path, setup::kMostSetUpBytes)}))
        return {path, {}};
    const setup::JobFile job = setup::read_job_file(path, inputs);
    MachineOfJob found;
    for (const setup::OptionSetting& setting : job.settings) {
        if (setting.option != "machine" || setting.values.empty()) continue;
        const std::string folder = std::filesystem::path(path).parent_path().string();
        found.path = setup::seen_in(folder, setting.values.front());
    }
    if (found.path.empty())
        throw std::runtime_error(
            fmt::format("'{}': the job names no machine; expected machine = \"mill.toml\"", path));
    found.set_ups = text_of(job.offsets, job.fixtures);
    for (std::size_t i = 0; i < job.set_ups.size(); ++i) {
        const setup::JobSetUp& set_up = job.set_ups[i];
        found.set_ups += fmt::format("set-up {}{}{}\n", i + 1, set_up.name.empty() ? "" : ", ",
                                     one_line(set_up.name)) +
                         text_of(set_up.offsets, set_up.fixtures);
    }
    return found;
}

}  // namespace

void add_options(cli::App& machine, MachineOptions& o) {
    using M = MachineOptions;
    static constexpr OptionRow<M> kRows[] = {
        {"machine", "FILE", kWork, "Machine: TOML, URDF, LinuxCNC INI, FreeCAD .fcm; or a job",
         store<&M::machine>, kRequired},
        {"--save", "FILE", kWork, "Write it as a machine.toml", store<&M::save>},
        {"--png", "FILE", kWork, "Picture of its links", store<&M::png>},
        {"--view", "VIEW", kWork, "iso, top, bottom, front, back, left, right [iso]",
         read<&M::view, view_named>},
        {"--transparent", "LINKS", kWork, "Links of the machine to look through, by name",
         store_list<&M::transparent>},
        {"--pose", "AXES", kWork, "Where the tool is with its axes there, as A30,C45",
         store<&M::pose>}};
    add_rows(machine, "Outputs", kRows, o);
}

int run(const MachineOptions& options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    inputs.expect(options.machine);
    outputs.reserve(options.save);
    outputs.reserve(options.png);
    const MachineOfJob named = machine_of(options.machine, inputs);
    setup::MachineFile file = setup::read_machine(named.path, inputs);
    simulation::bodies_of(file);  // rejects a mesh that check cannot use
    make_transparent(file, options.transparent);
    if (const std::string lost = setup::not_in_machine_toml(file);
        !options.save.empty() && !lost.empty()) {
        throw std::runtime_error(
            fmt::format("--save: {} of '{}' would be lost; it stays as it is", lost, named.path));
    }
    std::string text = setup::machine_sheet(file) + named.set_ups;
    if (!options.pose.empty()) text += sheet_of_pose(file, options.pose);
    put_text(text, outputs.takes_standard_output());
    outputs.write(options.save, [&](std::ostream& out) { out << setup::machine_toml(file); });
    if (!options.png.empty()) {
        const exporter::Image image = picture_of(file, values_of(options.pose), options.view);
        outputs.write(options.png, [&](std::ostream& out) { exporter::write_png(out, image); });
    }
    outputs.commit();
    return kClean;
}

}  // namespace ncsim::app
