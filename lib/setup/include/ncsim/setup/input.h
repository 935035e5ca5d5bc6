// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading of files: every input is read through InputSet, up to a size limit, and never if the same
// run overwrites it.
#pragma once

#include "ncsim/setup/file_id.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ncsim::setup {

/// Largest sizes of inputs, in bytes: kMostBytes for programs, surfaces and stock; kMostSetUpBytes
/// for files of tools, machines and jobs; kMostDeviceBytes for devices such as /dev/zero, which may
/// never end.
inline constexpr std::uintmax_t kMostBytes = 1'000'000'000;
inline constexpr std::uintmax_t kMostSetUpBytes = 64'000'000;
inline constexpr std::uintmax_t kMostDeviceBytes = 64'000'000;

/// The files that a run reads. "-" is the standard input. All members may be called from several
/// threads.
/// Throws: std::runtime_error with the file and the system's message.
class InputSet {
public:
    InputSet() = default;
    /// Expects `paths`.
    explicit InputSet(const std::vector<std::string>& paths) {
        for (const std::string& path : paths)
            expect(path);
    }
    InputSet(const InputSet&) = delete;
    InputSet& operator=(const InputSet&) = delete;
    virtual ~InputSet() = default;

    /// Returns all bytes of a file. Repeated reads of the standard input return the same bytes.
    /// Throws if the file cannot be read, is a folder, has more bytes than `most`, or is an output
    /// of the same run. Throws for a FIFO or a device, unless `path` is expected.
    virtual std::string read(const std::string& path, std::uintmax_t most = kMostBytes);
    /// True if `path` is a regular file.
    virtual bool is_there(const std::string& path);
    /// Announces that the content of `folder` will be searched.
    virtual void look_through(const std::string& folder);

    /// Announces that `path` may be read later. Throws if the standard input is named a second
    /// time.
    void expect(const std::string& path);

    /// Announces that `path` will be overwritten. Throws if the file was read or is expected.
    void forbid(const std::string& path, const FileId& id);
    /// Throws if a file that will be overwritten was read.
    void check() const;

private:
    std::string read_open(const std::string& path, int descriptor, std::uintmax_t most);
    void add(const std::string& path, const FileId& id);

    mutable std::mutex mutex_;
    std::map<FileId, std::string> read_, forbidden_;  // by file, with the path named first
    std::map<std::string, std::string> streams_;  // content of FIFOs, which can be read only once
    std::set<std::string> expected_;
    std::string conflict_;
    std::mutex standard_input_mutex_;
    std::optional<std::string> standard_input_;
    bool expects_standard_input_ = false;
};

/// Returns the name of an input in messages: "<stdin>" for "-", otherwise the path.
std::string name_of_input(const std::string& path);

/// Returns the path of the file `name` that a file in `folder` mentions; "-" is not the standard
/// input there.
std::string seen_in(const std::string& folder, const std::string& name);

}  // namespace ncsim::setup
