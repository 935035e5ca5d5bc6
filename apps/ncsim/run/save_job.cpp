// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the job of a run.
#include "run/save_job.h"

#include "ncsim/report/value_source.h"
#include "ncsim/setup/job_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

namespace ncsim::app {

namespace {

Vec3 offset_of(const setup::Job& job, int number) {
    const toolpath::ToolEntry* entry = toolpath::find_tool(job.tools, number);
    return entry ? entry->offset : Vec3{};
}

// Returns `path` relative to the folder of `job_file`.
std::string seen_from(const std::string& job_file, const std::string& path) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::absolute(job_file).lexically_normal().parent_path();
    return fs::absolute(path).lexically_normal().lexically_proximate(folder).generic_string();
}

void add_tools(setup::JobFile& file, setup::JobRemarks& remarks, const setup::Job& job,
               const simulation::Survey& survey) {
    for (const auto& [number, used] : survey.tools) {
        std::vector<std::string> lines{
            report::specified(used.specified_by, used.span, used.text, used.file, "--tool")};
        if (!used.assumed_values_text.empty())
            lines.push_back("assumed: " + used.assumed_values_text);
        toolpath::ToolEntry entry;
        entry.spec = used.spec;
        entry.offset = offset_of(job, number);
        file.tools.push_back(std::move(entry));
        remarks.tools.push_back(std::move(lines));
    }
    for (const toolpath::ToolEntry& entry : job.tools) {
        if (survey.tools.contains(entry.spec.number)) continue;
        file.tools.push_back(entry);
        remarks.tools.push_back(
            {"not used; " +
             report::specified(entry.specified_by, entry.span, entry.text, entry.file, "--tool")});
    }
    for (const auto& [number, first] : survey.unknown_tools)
        remarks.unknown_tools.emplace(number, first.line);
}

}  // namespace

std::string path_from(const std::string& job_file, const std::string& path) {
    return seen_from(job_file, path);
}

DescribedJob describe_job(const setup::Job& job, const simulation::Survey& survey,
                          const std::string& path) {
    DescribedJob described;
    setup::JobFile& file = described.file;
    setup::JobRemarks& remarks = described.remarks;
    if (job.options.program != "-") file.program = seen_from(path, job.options.program);
    file.inches = job.options.inches.value_or(false);
    file.units_assumed = !survey.interpretation.units_stated && job.units_assumed;
    file.dialect = survey.interpretation.dialect.dialect;
    file.dialect_assumed = job.options.dialect == gcode::Dialect::Auto;
    file.strict = job.options.strict;
    file.increments = job.options.increments;
    file.variables = job.options.variables;
    file.compensation = job.options.compensation;
    file.block_delete = job.options.block_delete;
    file.allow = job.options.allow;
    file.accept = job.options.accept;
    file.require = job.options.require;
    file.start = job.start;
    file.offsets = job.options.offsets;
    file.fixtures = job.fixtures;
    file.fixtures_specified = job.fixtures_specified;
    file.below_stock = job.below_stock;
    if (survey.stock) {
        file.stock = *survey.stock;
        if (file.stock->from) file.stock->from->path = seen_from(path, file.stock->from->path);
        file.stock_assumed = survey.stock->specified_by == toolpath::ValueSource::Assumption;
        file.stock_place_assumed = survey.stock->place_assumed;
        remarks.stock = report::specified(survey.stock->specified_by, survey.stock->span,
                                          survey.stock->text, survey.stock->file, "--stock");
    }
    add_tools(file, remarks, job, survey);
    return described;
}

void save_job(std::ostream& out, const setup::Job& job, const simulation::Survey& survey,
              const std::string& machine, const std::string& path) {
    for (const verify::Fixture& fixture : job.fixtures) {
        if (!fixture.mesh.triangles.empty())
            throw std::runtime_error(
                fmt::format("--save-job: the fixture '{}' is a mesh ({}); only "
                            "boxes, vises and clamps are written",
                            fixture.name, fixture.mesh_at));
    }
    DescribedJob described = describe_job(job, survey, path);
    if (!machine.empty())
        described.file.settings.push_back({"machine", {seen_from(path, machine)}, false, true, {}});
    setup::write_job_file(out, described.file, described.remarks);
}

}  // namespace ncsim::app
