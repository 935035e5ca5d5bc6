// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads INDEX.tsv, or searches a folder for programs.
#include "entries.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace ncsim::corpus {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> out;
    std::stringstream in(line);
    std::string field;
    while (std::getline(in, field, '\t'))
        out.push_back(field);
    return out;
}

}  // namespace

std::string read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Entry> entries_of(const fs::path& directory) {
    std::vector<Entry> entries;
    if (fs::is_regular_file(directory)) {
        Entry e;
        e.path = directory;
        e.name = directory.filename().string();
        return {std::move(e)};
    }
    if (std::ifstream index(directory / "INDEX.tsv"); index) {
        std::string line;
        std::getline(index, line);
        const std::vector<std::string> head = split(line);
        const auto column = [&](const char* name) {
            return static_cast<std::size_t>(std::ranges::find(head, name) - head.begin());
        };
        while (std::getline(index, line)) {
            std::vector<std::string> fields = split(line);
            fields.resize(std::max(fields.size(), head.size()));
            Entry e;
            e.name = fields[column("program")];
            e.path = directory / "programs" / e.name;
            e.kind = fields[column("kind")];
            e.status = fields[column("reference_status")];
            if (const std::string& r = fields[column("reference")]; !r.empty())
                e.reference = directory / r;
            entries.push_back(std::move(e));
        }
        return entries;
    }
    for (const auto& file : fs::recursive_directory_iterator(directory)) {
        if (!file.is_regular_file() || file.path().extension() == ".gz") continue;
        static constexpr const char* kExtensions[] = {".nc",    ".ngc", ".tap", ".cnc",
                                                      ".gcode", ".gc",  ".mpf", ".h",
                                                      ".eia",   ".txt", ".ncc", ".min"};
        std::string extension = file.path().extension().string();
        std::ranges::transform(extension, extension.begin(), [](char c) {
            return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
        });
        if (std::ranges::find(kExtensions, extension) == std::end(kExtensions)) continue;
        Entry e;
        e.path = file.path();
        e.name = fs::relative(file.path(), directory).string();
        const fs::path reference = file.path().string() + ".canon.gz";
        if (fs::exists(reference)) {
            e.reference = reference;
            e.status = "ok";
        }
        entries.push_back(std::move(e));
    }
    std::ranges::sort(entries, {}, &Entry::name);
    return entries;
}

}  // namespace ncsim::corpus
