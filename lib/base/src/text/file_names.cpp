// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of files in reports.
#include "ncsim/base/file_names.h"

#include <filesystem>
#include <system_error>

namespace ncsim {

std::string base_name(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string relative_path(const std::string& path) {
    std::error_code error;
    const std::filesystem::path given(path);
    std::filesystem::path relative = given.lexically_normal();
    if (given.is_absolute()) {
        const auto here = std::filesystem::current_path(error);
        const auto seen = relative.lexically_relative(here);
        if (!error && !seen.empty() && *seen.begin() != "..") relative = seen;
    }
    return relative.generic_string();
}

}  // namespace ncsim
