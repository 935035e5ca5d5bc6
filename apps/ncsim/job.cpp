// SPDX-License-Identifier: GPL-3.0-or-later
#include "job.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace ncsim::app {

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw std::runtime_error(
        fmt::format("cannot read '{}': {}", path, std::generic_category().message(error)));
}

std::string read_file(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) fail(path, errno);
    if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    if (!file) fail(path, errno);
    std::string text;
    if (S_ISREG(status.st_mode)) text.reserve(static_cast<std::size_t>(status.st_size));
    std::string chunk(1 << 16, '\0');
    while (const std::size_t n = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
        text.append(chunk, 0, n);
    }
    if (std::ferror(file.get()) != 0) fail(path, errno);
    return text;
}

// No control reads a program with NUL bytes in its text; punched tape had them as leader, before
// the first '%', and there they are harmless.
bool is_binary(std::string_view text) {
    const std::size_t begin = text.find_first_not_of('\0');
    if (begin == std::string_view::npos) return !text.empty();
    const std::size_t last = text.find_last_not_of(std::string_view("\0\x1a", 2));
    return text.substr(begin, last + 1 - begin).find('\0') != std::string_view::npos;
}

// Subprograms live in files beside the program: "O<probe>" in probe.ngc, "M98 P1234" in
// O1234. Only there: a program names no other place.
std::optional<gcode::SourceFile> read_beside(const std::filesystem::path& folder,
                                             std::string_view name) {
    if (name.empty() || name.front() == '.' || name.find('/') != std::string_view::npos) {
        return std::nullopt;
    }
    for (const char* ending : {"", ".ngc", ".nc", ".NC", ".tap"}) {
        const std::filesystem::path path = folder / std::string(name).append(ending);
        std::error_code ignored;
        if (std::filesystem::is_regular_file(path, ignored)) {
            return gcode::SourceFile{path.filename().string(), read_file(path.string())};
        }
    }
    return std::nullopt;
}

}  // namespace

std::string base_name(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

Job read_job(Options options) {
    Job job;
    job.program = {options.program, read_file(options.program)};
    if (is_binary(job.program.text)) {
        throw std::runtime_error(
            fmt::format("'{}' is not an NC program: it is binary data", options.program));
    }
    job.interpreter.default_units =
        options.inches ? gcode::DefaultUnits::Inches : gcode::DefaultUnits::Millimetres;
    job.interpreter.block_delete = options.block_delete;
    job.interpreter.dialect = options.dialect;
    job.interpreter.strict = options.strict;
    job.interpreter.allow = options.allow;
    job.interpreter.read_file = [folder = std::filesystem::path(options.program).parent_path()](
                                    std::string_view name) { return read_beside(folder, name); };
    for (gcode::Position& origin : job.interpreter.work_offsets) {
        origin.z = gcode::Length::from_mm(-kHomeHeight);
    }

    for (const toolpath::ToolSpec& spec : options.tools) {
        job.tools.push_back({spec, toolpath::ToldBy::Option, {}, spec.description});
    }
    toolpath::ProgramNotes notes = toolpath::read_notes(job.program, options.inches);
    for (toolpath::ToolEntry& entry : notes.tools) {
        if (!toolpath::find_tool(job.tools, entry.spec.number))
            job.tools.push_back(std::move(entry));
    }
    for (const toolpath::ToolEntry& entry : job.tools) {
        gcode::ToolTableEntry known;
        known.number = entry.spec.number;
        if (entry.spec.diameter) known.diameter = gcode::Length::from_mm(*entry.spec.diameter);
        job.interpreter.tools.push_back(known);
    }
    if (options.stock) {
        job.stock = toolpath::StockEntry{*options.stock, toolpath::ToldBy::Option, {}, {}};
    } else {
        job.stock = std::move(notes.stock);
    }
    job.diagnostics = std::move(notes.diagnostics);
    job.options = std::move(options);
    return job;
}

}  // namespace ncsim::app
