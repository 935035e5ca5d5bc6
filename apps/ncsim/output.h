// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that are written whole or not at all.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace ncsim::app {

/// The files of one run. Each is written under a temporary name in its own folder; commit() gives
/// all of them their names. Without it, and after SIGINT, SIGTERM or SIGHUP, nothing is left and
/// what stood there before still does. What is no regular file (a pipe, /dev/stdout) is written to
/// directly.
///
/// All members throw std::runtime_error, naming the file and what the system said, if the world
/// fails: no such folder, no permission, disk full.
class OutputSet {
public:
    OutputSet();
    ~OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// Opens the temporary file for `path`, so that a path that cannot be written is known before
    /// the work begins. Does nothing if `path` is empty.
    void reserve(const std::string& path);
    /// Fills a reserved file and makes sure that it is on the disk. Does nothing if `path` is
    /// empty.
    void write(const std::string& path, const std::function<void(std::ostream&)>& writer);
    /// Gives the files that were written their names; the other ones disappear.
    void commit();

private:
    struct File;
    std::vector<std::unique_ptr<File>> files_;
};

}  // namespace ncsim::app
