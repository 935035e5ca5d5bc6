// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cache of verdicts. Equal input gives equal bytes, so a known verdict is not computed again. The
// cache is a folder that many processes may use at a time, also on NFS: entries are written under a
// temporary name and renamed, and an incomplete entry is ignored.
#pragma once

#include "ncsim/report/entry.h"
#include "ncsim/setup/recorded_input.h"

#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace ncsim::app {

/// Returns a name of a file that is valid as a cache key from every folder. Reports show paths
/// relative to the current folder, so an absolute path includes the current folder.
std::string absolute_name(const std::string& path);

class ResultCache {
public:
    /// Creates a cache. `common`: all values that determine a verdict, except the program and its
    /// files: version, options, digests of files. `complain` is called once if the folder cannot be
    /// written.
    ResultCache(std::string folder, std::string common,
                std::function<void(const std::string&)> complain);

    /// Returns the known entry of a program; empty if the program or a file read with it has
    /// changed. `about`: text of baselines about the program. Files are read through `inputs`.
    std::optional<report::Entry> find(const std::string& program, const std::string& program_key,
                                      setup::InputSet& inputs) const;
    /// Stores `entry` if it is a verdict; `read`: all files on which the verdict depends.
    void keep(const std::string& program, const std::string& program_key,
              const report::Entry& entry, const setup::ReadFiles& read);

private:
    std::string key_of(const std::string& program, const std::string& program_key) const;
    std::string path_of(const std::string& key) const;

    std::string folder_, common_;
    std::function<void(const std::string&)> complain_;
    std::once_flag complained_;
};

}  // namespace ncsim::app
