// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that are written whole or not at all.
#pragma once

#include "ncsim/setup/input.h"

#include <functional>
#include <iosfwd>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace ncsim::app {

/// The files one run writes. Each is written under a temporary name in its own folder; commit()
/// gives all of them their names. Without it, and after SIGINT, SIGTERM or SIGHUP, nothing is left
/// and what stood there before still does. Links stay, and what they lead to is replaced. "-" is
/// the standard output; it and what is no regular file (a pipe, /dev/stdout) are written to
/// directly.
///
/// No output may be an input, by whatever name, nor be named twice.
///
/// All members throw std::runtime_error, naming the file and what the system said, if the world
/// fails: no such folder, no permission, disk full.
class OutputSet {
public:
    /// `inputs` must outlive it.
    explicit OutputSet(setup::InputSet& inputs);
    ~OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// Opens the temporary file for `path`, so that a path that cannot be written is known before
    /// the work begins. Does nothing if `path` is empty.
    void reserve(const std::string& path);
    /// No file may be written to the standard output: `what` is.
    void claim_standard_output(const std::string& what);
    /// Is one of the files written to the standard output? What is for people goes to stderr then.
    bool takes_standard_output() const { return takes_standard_output_; }

    /// Fills a reserved file and makes sure that it is on the disk. Does nothing if `path` is
    /// empty.
    void write(const std::string& path, const std::function<void(std::ostream&)>& writer);
    /// Gives the files that were written their names; the other ones disappear.
    void commit();
    /// All of this for one file more, now.
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
    std::string standard_output_;  // who has it
    bool takes_standard_output_ = false;
};

}  // namespace ncsim::app
