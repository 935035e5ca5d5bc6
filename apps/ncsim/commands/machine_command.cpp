// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints a machine.
#include "commands/machine_command.h"

#include "ncsim/export/png.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/machine_text.h"
#include "ncsim/simulation/program_check.h"

#include "options/program_options.h"
#include "run/machine_picture.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string_view>

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
        double value = 0.0;
        const char* const last = word.data() + word.size();
        const auto read = axis ? std::from_chars(word.data() + 1, last, value)
                               : std::from_chars_result{nullptr, std::errc::invalid_argument};
        constexpr double kLargest = 1e6;
        if (read.ec != std::errc() || read.ptr != last || !(std::abs(value) <= kLargest)) {
            throw std::runtime_error(
                fmt::format("--pose '{}': expected axes and their values, as A30,C45", pose));
        }
        values[*axis] = value;
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
    const cda::Vec3 axis = axis_of(X_WT), tip = X_WT.translation;
    return fmt::format(
        "  at {}: spindle nose at X{:.6g} Y{:.6g} Z{:.6g} of the part, whose zero is that of the "
        "machine, tool along {:.6g}, {:.6g}, {:.6g}\n",
        pose, tip.x + 0.0, tip.y + 0.0, tip.z + 0.0, axis.x + 0.0, axis.y + 0.0, axis.z + 0.0);
}

}  // namespace

cli::App* add_machine(cli::App& app, MachineOptions& o) {
    cli::App* machine = app.add_subcommand("machine", "Show how a machine is built and turns");
    machine->add_option("machine", o.machine, "Machine: TOML, URDF, LinuxCNC INI, FreeCAD .fcm")
        ->required()
        ->type_name("FILE");
    machine->add_option("--save", o.save, "Write it as a machine.toml")->type_name("FILE");
    machine->add_option("--png", o.png, "Picture of its links")->type_name("FILE");
    machine->add_option("--view", o.view, "iso, top, bottom, front, back, left, right [iso]")
        ->type_name("VIEW");
    machine
        ->add_option("--transparent", o.transparent,
                     "Links whose back is seen in pictures: their names, with commas")
        ->delimiter(',')
        ->type_name("LINK,…");
    machine->add_option("--pose", o.pose, "Where the tool is with its axes there, as A30,C45")
        ->type_name("AXES");
    return machine;
}

int run(const MachineOptions& options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    inputs.expect(options.machine);
    outputs.reserve(options.save);
    outputs.reserve(options.png);
    const auto view = exporter::parse_view(options.view);
    if (!view) throw std::runtime_error(fmt::format("--view: '{}' is no view", options.view));
    setup::MachineFile file = setup::read_machine(options.machine, inputs);
    simulation::bodies_of(file);  // rejects a mesh that check cannot use
    make_transparent(file, options.transparent);
    if (const std::string lost = setup::not_in_machine_toml(file);
        !options.save.empty() && !lost.empty()) {
        throw std::runtime_error(fmt::format("--save: {} of '{}' would be lost; it stays as it is",
                                             lost, options.machine));
    }
    std::string text = setup::machine_sheet(file);
    if (!options.pose.empty()) text += sheet_of_pose(file, options.pose);
    put_text(text, outputs.takes_standard_output());
    outputs.write(options.save, [&](std::ostream& out) { out << setup::machine_toml(file); });
    if (!options.png.empty()) {
        const exporter::Image image = picture_of(file, values_of(options.pose), *view);
        outputs.write(options.png, [&](std::ostream& out) { exporter::write_png(out, image); });
    }
    outputs.commit();
    return kClean;
}

}  // namespace ncsim::app
