// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that are read: all of them here, up to a limit, and never what the same run overwrites.
#pragma once

#include "ncsim/setup/file_id.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>

namespace ncsim::setup {

/// The most that is read of one file: programs, surfaces, stock; what describes tools, machines and
/// jobs; anything from a device such as /dev/zero, which may never end. Bytes.
inline constexpr std::uintmax_t kMostBytes = 1'000'000'000;
inline constexpr std::uintmax_t kMostSetUpBytes = 64'000'000;
inline constexpr std::uintmax_t kMostDeviceBytes = 64'000'000;

/// The files one run reads. "-" is the standard input. All members throw std::runtime_error, naming
/// the file and what the system said, and may be called from several threads.
class InputSet {
public:
    InputSet() = default;
    InputSet(const InputSet&) = delete;
    InputSet& operator=(const InputSet&) = delete;
    virtual ~InputSet() = default;

    /// All bytes of a file; whoever asks again for the standard input gets the same. Throws if it
    /// cannot be read, is a folder, has more bytes than `most`, or is an output of the same run.
    /// Throws for a FIFO or a device, unless `path` is expected.
    virtual std::string read(const std::string& path, std::uintmax_t most = kMostBytes);
    /// Is there a file to be read?
    virtual bool is_there(const std::string& path);
    /// Whatever stands in `folder` is going to be looked at.
    virtual void look_through(const std::string& folder);

    /// `path` is named to be read, which may happen later. Throws if the standard input is named
    /// for the second time.
    void expect(const std::string& path);

    /// `path` is going to be overwritten. Throws if it was read or is expected to be.
    void forbid(const std::string& path, const FileId& id);
    /// Throws if something that is going to be overwritten was read after all.
    void check() const;

private:
    std::string read_open(const std::string& path, int descriptor, std::uintmax_t most);
    void add(const std::string& path, const FileId& id);

    mutable std::mutex mutex_;
    std::map<FileId, std::string> read_, forbidden_;  // with the path that was told first
    std::map<std::string, std::string> streams_;      // what FIFOs gave, which give it once
    std::set<std::string> expected_;
    std::string conflict_;
    std::mutex standard_input_mutex_;
    std::optional<std::string> standard_input_;
    bool expects_standard_input_ = false;
};

/// How messages name an input: "<stdin>" for "-", else its path.
std::string name_of_input(const std::string& path);

/// How a file in `folder` names the file `name`; "-" is no standard input there.
std::string seen_in(const std::string& folder, const std::string& name);

}  // namespace ncsim::setup
