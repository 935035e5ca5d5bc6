// SPDX-License-Identifier: GPL-3.0-or-later
//
// Identity of files, and resolution of symbolic links.
#include "ncsim/setup/file_id.h"

#include "ncsim/base/number_text.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace ncsim::setup {

namespace {

namespace fs = std::filesystem;

// Returns the folder of `path` without links; empty if there is none.
fs::path folder_of(const fs::path& path) {
    const fs::path folder = path.parent_path();
    std::error_code error;
    fs::path real = fs::canonical(folder.empty() ? "." : folder, error);
    return error ? fs::path() : real;
}

bool is_in_proc(const fs::path& path) {
    const std::string folder = folder_of(path).string();
    return folder.starts_with("/proc/");
}

}  // namespace

FileId id_of(const struct stat& status) {
    return {status.st_dev, status.st_ino, {}};
}

FileId id_of_new(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    struct stat status {};
    if (::stat(folder.empty() ? "." : folder.c_str(), &status) != 0) {
        throw std::runtime_error(
            fmt::format("cannot write '{}': {}", path, std::generic_category().message(errno)));
    }
    return {status.st_dev, status.st_ino, fs::path(path).filename().string()};
}

std::string without_links(const std::string& path) {
    constexpr int kMostLinks = 40;  // limit of the kernel
    fs::path at(path);
    for (int links = 0;; ++links) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(at, error)) || is_in_proc(at)) return at.string();
        const fs::path to = fs::read_symlink(at, error);
        if (links == kMostLinks || error) {
            throw std::runtime_error(
                fmt::format("cannot write '{}': {}", path,
                            std::generic_category().message(error ? error.value() : ELOOP)));
        }
        at = to.is_absolute() ? to : at.parent_path() / to;
    }
}

int descriptor_named(const std::string& path) {
    // "/proc/self" links to the process, "/proc/thread-self" to a thread of the process.
    const std::string folder = folder_of(path).string();
    if (!folder.starts_with(fmt::format("/proc/{}/", ::getpid())) || !folder.ends_with("/fd"))
        return -1;
    return number_in<int>(fs::path(path).filename().string()).value_or(-1);
}

}  // namespace ncsim::setup
