// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a file under another name, then renames it.
#include "output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace ncsim::python {

namespace {

// Removes the file unless it was renamed.
class TemporaryFile {
public:
    explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        if (!path_.empty()) std::filesystem::remove(path_, ignored);
    }
    void rename(const std::string& path) {
        std::filesystem::rename(path_, path);
        path_.clear();
    }

private:
    std::string path_;
};

std::runtime_error failure(const std::string& path) {
    return std::runtime_error(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

}  // namespace

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
    const std::string partial = fmt::format("{}.{}.part", path, ::getpid());
    errno = 0;
    std::ofstream out(partial, std::ios::binary);
    if (!out) throw failure(path);
    TemporaryFile file(partial);
    write(out);
    out.close();
    if (!out) throw failure(path);
    file.rename(path);
}

}  // namespace ncsim::python
