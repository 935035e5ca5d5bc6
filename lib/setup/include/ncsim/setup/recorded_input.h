// SPDX-License-Identifier: GPL-3.0-or-later
//
// Record of the inputs of a verdict, from which a later run can decide whether the verdict would be
// the same.
#pragma once

#include "ncsim/setup/input.h"

#include <map>
#include <optional>
#include <string>

namespace ncsim::setup {

/// Files that were requested, with the digests of the content; empty if the file did not exist.
using ReadFiles = std::map<std::string, std::optional<std::string>>;

/// Reads through a second set and records the requests. For a single program and a single thread.
class RecordedInput : public InputSet {
public:
    /// Requires: `inputs` outlives this object.
    explicit RecordedInput(InputSet& inputs) : inputs_(inputs) {}

    std::string read(const std::string& path, std::uintmax_t most = kMostBytes) override;
    bool is_there(const std::string& path) override;
    void look_through(const std::string& folder) override;

    const ReadFiles& files() const { return files_; }
    /// False if content was read that can change without being named: a whole folder, a device.
    bool knows_all() const { return knows_all_; }

private:
    InputSet& inputs_;
    ReadFiles files_;
    bool knows_all_ = true;
};

/// Returns the digest of a file as RecordedInput would record it, read through `inputs`.
std::optional<std::string> digest_of_file(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
