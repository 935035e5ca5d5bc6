// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for programs in folders.
#include "ncsim/setup/program_folder.h"

#include "ncsim/gcode/program_text.h"
#include "ncsim/setup/input_observer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::setup {

namespace {

namespace fs = std::filesystem;

/// A regular file, opened for reading; opening never waits for the second end of a FIFO.
class RegularFile {
public:
    explicit RegularFile(const std::string& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {
        struct stat status {};
        if (descriptor_ < 0) return;
        is_regular_ = ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
        size_ = is_regular_ ? static_cast<std::size_t>(status.st_size) : 0;
    }
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;
    ~RegularFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    bool is_regular() const { return is_regular_; }
    std::size_t size() const { return size_; }

    /// Reads at most `most` bytes from `offset` on; empty after an error.
    std::optional<std::string> read(std::size_t offset, std::size_t most) const {
        std::string bytes(most, '\0');
        std::size_t length = 0;
        while (length < most) {
            const ssize_t n = ::pread(descriptor_, bytes.data() + length, most - length,
                                      static_cast<off_t>(offset + length));
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) return std::nullopt;
            if (n == 0) break;
            length += static_cast<std::size_t>(n);
        }
        bytes.resize(length);
        return bytes;
    }

private:
    int descriptor_ = -1;
    bool is_regular_ = false;
    std::size_t size_ = 0;
};

/// Returns the kind of an entry that is never opened; null for regular files.
const char* name_of(fs::file_type type) {
    switch (type) {
        case fs::file_type::regular: return nullptr;
        case fs::file_type::fifo: return "FIFO";
        case fs::file_type::socket: return "socket";
        case fs::file_type::block:
        case fs::file_type::character: return "device";
        case fs::file_type::directory: return "link to a folder";
        case fs::file_type::not_found: return "link that leads nowhere";
        default: return "no regular file";
    }
}

bool is_below(const fs::path& path, const fs::path& folder) {
    const auto [end, rest] = std::ranges::mismatch(folder, path);
    return end == folder.end() && rest != path.end();
}

/// Returns the reason not to follow `link`; empty if `link` leads to a regular file of `folder`.
std::optional<std::string> why_not_followed(const fs::path& link, const fs::path& folder) {
    std::error_code error;
    const fs::file_status status = fs::status(link, error);
    if (const char* type = name_of(status.type())) return type;
    const fs::path target = fs::canonical(link, error);
    if (error || !is_below(target, folder)) return "link out of the folder";
    return std::nullopt;
}

bool is_version_control(const fs::path& name) {
    constexpr std::array kFolders = {".git", ".hg", ".svn", ".bzr", "CVS"};
    return std::ranges::find(kFolders, name.string()) != kFolders.end();
}

}  // namespace

std::optional<std::string> why_no_program(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found || status.type() == fs::file_type::none)
        return std::nullopt;
    if (const char* type = name_of(status.type())) return type;
    const std::string name = fs::path(path).filename().string();
    if (gcode::names_program(name)) return std::nullopt;
    const RegularFile file(path);
    if (!file.is_regular()) return std::nullopt;
    const std::optional<std::string> head = file.read(0, gcode::kMostHeadBytes + 1);
    if (!head) return std::nullopt;
    const gcode::TextKind kind = gcode::kind_of_text(*head);
    if (kind == gcode::TextKind::Program) return std::nullopt;
    return std::string(gcode::name_of(kind));
}

bool is_subprogram_file(const std::string& path) {
    const RegularFile file(path);
    if (!file.is_regular()) return false;
    const std::size_t head_bytes = std::min(file.size(), gcode::kMostHeadBytes);
    const std::size_t tail_bytes = std::min(file.size() - head_bytes, gcode::kMostHeadBytes);
    const auto head = file.read(0, head_bytes);
    const auto tail = file.read(file.size() - tail_bytes, tail_bytes);
    return head && tail && gcode::is_subprogram_text(*head, *tail);
}

ProgramFolder programs_in_folder(const std::string& folder) {
    note_input(folder);
    ProgramFolder found;
    std::error_code error;
    const fs::path whole = fs::canonical(folder, error);
    fs::recursive_directory_iterator entry;
    if (!error) entry = fs::recursive_directory_iterator(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        const fs::path& path = entry->path();
        if (entry->is_symlink(ignored)) {
            if (auto why = why_not_followed(path, whole)) {
                found.excluded.push_back({path.string(), std::move(*why)});
                continue;
            }
        } else if (entry->is_directory(ignored)) {
            if (!is_version_control(path.filename())) continue;
            entry.disable_recursion_pending();
            found.excluded.push_back({path.string(), "folder of version control"});
            continue;
        }
        if (auto why = why_no_program(path.string())) {
            found.excluded.push_back({path.string(), std::move(*why)});
        } else {
            found.programs.push_back(path.string());
        }
    }
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot read the folder '{}': {}", folder, error.message()));
    }
    std::ranges::sort(found.programs);
    std::ranges::sort(found.excluded, {}, &ExcludedEntry::path);
    return found;
}

}  // namespace ncsim::setup
