// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a program to a file and simulates the file.
#include "nightly/simulated.h"

#include "commands/options.h"
#include "options/plan_options.h"

#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <variant>

namespace ncsim::nightly {

ProgramFile::ProgramFile() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "ncsim-nightly-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) throw std::runtime_error("mkdtemp failed");
    folder_ = pattern;
    path_ = folder_ + "/program.nc";
}

ProgramFile::~ProgramFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

simulation::Simulation ProgramFile::run(const Program& program,
                                        const std::vector<std::string>& more) const {
    std::ofstream(path_, std::ios::binary) << program.text;
    std::vector<std::string> words{"run", path_};
    words.insert(words.end(), program.arguments.begin(), program.arguments.end());
    words.insert(words.end(), more.begin(), more.end());
    app::Command command = app::parse_options(words);
    if (const auto* farewell = std::get_if<app::EarlyExit>(&command)) {
        throw std::runtime_error("the options are refused: " + farewell->text);
    }
    setup::InputSet inputs;
    simulation::Plan plan = app::plan_for(std::get<app::Options>(command), inputs);
    const simulation::Survey survey = simulation::survey(plan);
    for (const gcode::Diagnostic& d : survey.diagnostics) {
        if (d.severity != gcode::Severity::Error) continue;
        throw std::runtime_error("line " + std::to_string(d.span.line) + ": " + d.message);
    }
    if (!survey.is_ready()) throw std::runtime_error("the program is not simulated");
    return simulation::simulate(plan, survey, {}, {});
}

StatedAccuracy stated_accuracy(const simulation::Simulation& simulation, const Program& program) {
    StatedAccuracy stated;
    stated.unit = simulation.lattice.unit_mm;
    for (std::size_t i = 0; i < program.tools.size(); ++i) {
        const auto facts = simulation.cutters.find(static_cast<int>(i + 1));
        stated.tool_error.push_back(facts == simulation.cutters.end() ? 0.0
                                                                      : facts->second.error_mm);
    }
    stated.missed = simulation.bounds.missed_mm;
    stated.gained = simulation.bounds.gained_mm;
    return stated;
}

std::uint64_t hash_of(const cda::Boundary& boundary) {
    // FNV-1a, a word at a time.
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    const auto add = [&hash](std::uint64_t word) { hash = (hash ^ word) * 0x100000001b3ULL; };
    add(boundary.vertices.size());
    for (const Vec3& v : boundary.vertices) {
        for (const double x : {v.x, v.y, v.z})
            add(std::bit_cast<std::uint64_t>(x));
    }
    for (const cda::BoundaryFace& face : boundary.faces) {
        add(static_cast<std::uint64_t>(face.origin));
        add(face.shell);
        for (const double x : {face.normal.x, face.normal.y, face.normal.z, face.offset})
            add(std::bit_cast<std::uint64_t>(x));
        for (const auto& loop : face.loops) {
            add(loop.size());
            for (const std::uint32_t vertex : loop)
                add(vertex);
        }
    }
    return hash;
}

}  // namespace ncsim::nightly
