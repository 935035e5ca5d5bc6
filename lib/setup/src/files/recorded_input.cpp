// SPDX-License-Identifier: GPL-3.0-or-later
//
// Digests of all files read for a verdict.
#include "ncsim/setup/recorded_input.h"

#include "ncsim/setup/digest.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace ncsim::setup {

std::string RecordedInput::read(const std::string& path, std::uintmax_t most) {
    std::error_code ignored;
    knows_all_ = knows_all_ && std::filesystem::is_regular_file(path, ignored);
    files_[path];
    std::string bytes = inputs_.read(path, most);
    files_[path] = digest_of(bytes);
    return bytes;
}

bool RecordedInput::is_there(const std::string& path) {
    const bool is_so = inputs_.is_there(path);
    const auto [file, is_new] = files_.try_emplace(path);
    // The digest distinguishes a file that was not read from a missing file.
    if (is_new && is_so) file->second = digest_of_file(path, inputs_);
    return is_so;
}

void RecordedInput::look_through(const std::string& folder) {
    knows_all_ = false;
    inputs_.look_through(folder);
}

std::optional<std::string> digest_of_file(const std::string& path, InputSet& inputs) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
    try {
        return digest_of(inputs.read(path));
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace ncsim::setup
