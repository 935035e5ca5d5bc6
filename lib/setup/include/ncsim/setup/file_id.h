// SPDX-License-Identifier: GPL-3.0-or-later
//
// Identity of a file under different names: "x.nc", "./x.nc", a link.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

struct stat;

namespace ncsim::setup {

/// A file by its device and inode. A file that does not exist yet has the device and inode of its
/// folder, and its name.
struct FileId {
    std::uint64_t device = 0, inode = 0;
    std::string name;  ///< Empty if the file exists.
    bool operator==(const FileId&) const = default;
    bool operator<(const FileId& other) const {
        return std::tie(device, inode, name) < std::tie(other.device, other.inode, other.name);
    }
};

/// Returns the identity of an existing file.
FileId id_of(const struct stat& status);
/// Returns the identity of a file that does not exist. Requires: `path` has no links. Throws:
/// std::runtime_error if the folder does not exist, either.
FileId id_of_new(const std::string& path);

/// Returns the target of the symbolic links at `path`, which may not exist yet. Links in /proc,
/// which denote open files, are kept: "/dev/stdout" becomes "/proc/self/fd/1". Throws:
/// std::runtime_error with `path` if the links are circular.
std::string without_links(const std::string& path);

/// Returns the descriptor of this process that `path` denotes; -1 if there is none. Requires:
/// `path` has no links.
int descriptor_named(const std::string& path);

}  // namespace ncsim::setup
