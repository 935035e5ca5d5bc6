// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading of files and of the standard input, and conflicts between inputs and outputs.
#include "ncsim/setup/input.h"

#include "ncsim/setup/input_observer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace ncsim::setup {

namespace {

constexpr const char* kStandardInput = "-";

[[noreturn]] void fail(const std::string& path, const std::string& why) {
    throw std::runtime_error(fmt::format("cannot read '{}': {}", name_of_input(path), why));
}

[[noreturn]] void fail(const std::string& path, int error) {
    fail(path, std::generic_category().message(error));
}

[[noreturn]] void fail_size(const std::string& path, std::uintmax_t most) {
    fail(path, fmt::format("it is larger than {} MB, the most that is read of such a file",
                           1e-6 * static_cast<double>(most)));
}

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }

private:
    int number_;
};

std::string conflict_of(const std::string& output, const std::string& input) {
    const std::string also =
        input == output ? std::string() : fmt::format(", as '{}'", name_of_input(input));
    return fmt::format(
        "'{}' is read, too{}: an output may overwrite neither an input nor another output", output,
        also);
}

}  // namespace

void InputSet::add(const std::string& path, const FileId& id) {
    const std::lock_guard lock(mutex_);
    read_.try_emplace(id, path);
    const auto found = forbidden_.find(id);
    if (found == forbidden_.end()) return;
    conflict_ = conflict_of(found->second, path);
    throw std::runtime_error(conflict_);
}

void InputSet::forbid(const std::string& path, const FileId& id) {
    const std::lock_guard lock(mutex_);
    forbidden_.try_emplace(id, path);
    const auto found = read_.find(id);
    if (found != read_.end()) throw std::runtime_error(conflict_of(path, found->second));
}

void InputSet::check() const {
    const std::lock_guard lock(mutex_);
    if (!conflict_.empty()) throw std::runtime_error(conflict_);
}

void InputSet::expect(const std::string& path) {
    if (path.empty()) return;
    {
        const std::lock_guard lock(mutex_);
        expected_.insert(path);
    }
    struct stat status {};
    if (path == kStandardInput) {
        if (expects_standard_input_) {
            throw std::runtime_error("'-' is named twice: the standard input can be one file");
        }
        expects_standard_input_ = true;
        if (::fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode))
            add(path, id_of(status));
        return;
    }
    // A file that cannot be read is reported when it is read.
    if (::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode)) add(path, id_of(status));
}

std::string InputSet::read_open(const std::string& path, int descriptor, std::uintmax_t most) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) fail(path, errno);
    if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
    std::string text;
    if (S_ISREG(status.st_mode)) {
        add(path, id_of(status));
        const auto size = static_cast<std::uintmax_t>(std::max<off_t>(status.st_size, 0));
        if (size > most) fail_size(path, most);
        text.reserve(size);
    } else if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) {
        most = std::min(most, kMostDeviceBytes);
    }
    std::string chunk(1 << 16, '\0');
    for (;;) {
        const ssize_t n = ::read(descriptor, chunk.data(), chunk.size());
        if (n == 0) return text;
        if (n < 0) {
            if (errno == EINTR) continue;
            fail(path, errno);
        }
        text.append(chunk, 0, static_cast<std::size_t>(n));
        if (text.size() > most) fail_size(path, most);
    }
}

std::string InputSet::read(const std::string& path, std::uintmax_t most) {
    note_input(path);
    if (path == kStandardInput) {
        const std::lock_guard lock(standard_input_mutex_);
        if (!standard_input_) standard_input_ = read_open(path, STDIN_FILENO, most);
        return *standard_input_;
    }
    struct stat status {};
    const bool is_stream = ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
    if (is_stream && !S_ISDIR(status.st_mode)) {
        const std::lock_guard lock(mutex_);
        // A file may name any path, and reading a FIFO without a writer would never end.
        if (!expected_.contains(path))
            fail(path, "it is no regular file, and only the command line may name such a file");
        if (const auto known = streams_.find(path); known != streams_.end()) return known->second;
    }
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (file.number() < 0) fail(path, errno);
    std::string text = read_open(path, file.number(), most);
    if (is_stream) {
        const std::lock_guard lock(mutex_);
        streams_.emplace(path, text);
    }
    return text;
}

bool InputSet::is_there(const std::string& path) {
    note_input(path);
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

void InputSet::look_through(const std::string& /*folder*/) {}

std::string name_of_input(const std::string& path) {
    return path == kStandardInput ? "<stdin>" : path;
}

std::string seen_in(const std::string& folder, const std::string& name) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    return path == kStandardInput ? "./-" : path;
}

}  // namespace ncsim::setup
