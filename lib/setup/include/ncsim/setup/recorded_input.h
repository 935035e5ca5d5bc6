// SPDX-License-Identifier: GPL-3.0-or-later
//
// What was read on the way to a verdict, so that one can tell later whether it would be the same.
#pragma once

#include "ncsim/setup/input.h"

#include <map>
#include <optional>
#include <string>

namespace ncsim::setup {

/// The files that were asked for, with the digests of what was read; nothing: there was none.
using ReadFiles = std::map<std::string, std::optional<std::string>>;

/// Reads through another set and keeps what it was asked. For one program, and one thread.
class RecordedInput : public InputSet {
public:
    /// `inputs` must outlive it.
    explicit RecordedInput(InputSet& inputs) : inputs_(inputs) {}

    std::string read(const std::string& path, std::uintmax_t most = kMostBytes) override;
    bool is_there(const std::string& path) override;
    void look_through(const std::string& folder) override;

    const ReadFiles& files() const { return files_; }
    /// Something was read that can change without being named: a whole folder, a device.
    bool knows_all() const { return knows_all_; }

private:
    InputSet& inputs_;
    ReadFiles files_;
    bool knows_all_ = true;
};

/// What a file is now, as RecordedInput would keep it, read through `inputs`.
std::optional<std::string> digest_of_file(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
