// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which file a path leads to, under whatever name: "x.nc", "./x.nc", a link.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

struct stat;

namespace ncsim::setup {

/// A file by its device and inode; one that does not exist yet by those of its folder, and its name
/// there.
struct FileId {
    std::uint64_t device = 0, inode = 0;
    std::string name;  ///< Empty: it exists.
    bool operator==(const FileId&) const = default;
    bool operator<(const FileId& other) const {
        return std::tie(device, inode, name) < std::tie(other.device, other.inode, other.name);
    }
};

/// Of a file that exists.
FileId id_of(const struct stat& status);
/// Of one that does not, by its path without links. Throws std::runtime_error if its folder does
/// not exist either.
FileId id_of_new(const std::string& path);

/// Where symbolic links at `path` lead in the end; they may lead to what does not exist yet. Links
/// in /proc, which stand for open files, are left: "/dev/stdout" becomes "/proc/self/fd/1". Throws
/// std::runtime_error, naming `path`, if they go round in circles.
std::string without_links(const std::string& path);

/// The descriptor of this process that `path`, without links, stands for; -1 if it is none.
int descriptor_named(const std::string& path);

}  // namespace ncsim::setup
