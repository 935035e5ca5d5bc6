// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output files that are written completely or not at all.
#pragma once

#include "ncsim/setup/input.h"

#include <functional>
#include <iosfwd>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace ncsim::app {

/// Output files of one run. Each file is written under a temporary name in its folder; commit()
/// renames all files. Without commit(), and after SIGINT, SIGTERM or SIGHUP, no temporary file
/// remains, and existing files are unchanged. Links stay; their targets are replaced. "-" is the
/// standard output. The standard output and special files (a pipe, /dev/stdout) are written
/// directly.
///
/// An output may be neither an input, by any name, nor named twice.
///
/// Throws: all members throw std::runtime_error with the file and the system's message if a folder
///   does not exist, permission is missing, or the disk is full.
class OutputSet {
public:
    /// Creates an empty set.
    /// Requires: `inputs` outlives the set.
    explicit OutputSet(setup::InputSet& inputs);
    ~OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// Opens the temporary file for `path`, so an unwritable path is detected before the work
    /// begins. Does nothing if `path` is empty.
    void reserve(const std::string& path);
    /// Reserves `path` like reserve(), but refuses an existing file or link. commit() does not
    /// replace a file that appears in the meantime.
    void reserve_new(const std::string& path);
    /// Reserves the standard output for `what`; files may no longer use it.
    void claim_standard_output(const std::string& what);
    /// True if a file is written to the standard output; text for the user then goes to stderr.
    bool takes_standard_output() const { return takes_standard_output_; }

    /// Fills a reserved file and flushes the contents to the disk. Does nothing if `path` is empty.
    void write(const std::string& path, const std::function<void(std::ostream&)>& writer);
    /// Renames the written files; removes the remaining files.
    void commit();
    /// Reserves, writes and renames one further file at once.
    void write_now(const std::string& path, const std::function<void(std::ostream&)>& writer);

private:
    struct File;

    std::unique_ptr<File> opened(const std::string& path);
    void open_directly(File& file, int descriptor);
    void add(const std::string& path, const setup::FileId& id);
    static void fill(File& file, const std::function<void(std::ostream&)>& writer);
    static void name(File& file);

    setup::InputSet* inputs_;
    std::vector<std::unique_ptr<File>> files_;
    std::set<setup::FileId> ids_;
    std::string standard_output_;  // user of the standard output
    bool takes_standard_output_ = false;
};

}  // namespace ncsim::app
