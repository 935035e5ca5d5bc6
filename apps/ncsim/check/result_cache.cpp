// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads and writes cached verdicts.
#include "check/result_cache.h"

#include "ncsim/report/file_digests.h"
#include "ncsim/setup/digest.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace fs = std::filesystem;

ResultCache::ResultCache(std::string folder, std::string common,
                         std::function<void(const std::string&)> complain)
    : folder_(std::move(folder)), common_(std::move(common)), complain_(std::move(complain)) {}

std::string absolute_name(const std::string& path) {
    std::error_code ignored;
    const bool is_absolute = fs::path(path).is_absolute();
    return is_absolute ? fs::current_path(ignored).string() + '\n' + path : path;
}

std::string ResultCache::key_of(const std::string& program, const std::string& program_key) const {
    return setup::digest_of(fmt::format("{} {}{} {}{}", common_.size(), common_, program_key.size(),
                                        program_key, absolute_name(program)));
}

std::string ResultCache::path_of(const std::string& key) const {
    return (fs::path(folder_) / key.substr(0, 2) / key.substr(2)).string();
}

// An entry has four lines: the key, the files that were read, the entry, the digest of the
// preceding lines. The key detects a file that was copied to the name of a different entry.
std::optional<report::Entry> ResultCache::find(const std::string& program,
                                               const std::string& program_key,
                                               setup::InputSet& inputs) const {
    const std::string key = key_of(program, program_key);
    std::ifstream in(path_of(key), std::ios::binary);
    std::string owner, files, entry, digest;
    if (!std::getline(in, owner) || !std::getline(in, files) || !std::getline(in, entry) ||
        !std::getline(in, digest) || owner != key ||
        digest != setup::digest_of(owner + '\n' + files + '\n' + entry)) {
        return std::nullopt;
    }
    const auto read = report::file_digests_from(files);
    if (!read) return std::nullopt;
    const bool is_same = std::ranges::all_of(*read, [&](const auto& file) {
        return setup::digest_of_file(file.first, inputs) == file.second;
    });
    return is_same ? report::entry_from(entry) : std::nullopt;
}

void ResultCache::keep(const std::string& program, const std::string& program_key,
                       const report::Entry& entry, const setup::ReadFiles& read) {
    bool is_verdict = true;
    report::for_each_program(entry, [&](const report::Entry& one) {
        is_verdict = is_verdict && one.word != "not-verified";
    });
    if (!is_verdict) return;
    const std::string files = report::line_of(read);
    const std::string line = report::line_of(entry);
    const std::string key = key_of(program, program_key);
    const std::string text = key + '\n' + files + '\n' + line;
    const std::string bytes = text + '\n' + setup::digest_of(text) + '\n';
    const fs::path path = path_of(key);
    static std::atomic<unsigned> number{0};
    const std::string aside = fmt::format("{}.{}.{}.tmp", path.string(), ::getpid(), number++);
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (!error) {
        std::ofstream out(aside, std::ios::binary);
        out << bytes;
        out.close();
        if (!out) error = std::make_error_code(std::errc::io_error);
    }
    if (!error) fs::rename(aside, path, error);
    if (!error) return;
    std::error_code ignored;
    fs::remove(aside, ignored);
    std::call_once(complained_, [&] {
        complain_(fmt::format("cannot write to the cache '{}': {}", folder_, error.message()));
    });
}

}  // namespace ncsim::app
