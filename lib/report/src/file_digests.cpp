// SPDX-License-Identifier: GPL-3.0-or-later
//
// Digests of files as a line of JSON.
#include "ncsim/report/file_digests.h"

#include "json.h"

namespace ncsim::report {

std::string line_of(const FileDigests& files) {
    Json json = Json::array();
    for (const auto& [name, digest] : files)
        json.push_back({name, digest ? Json(*digest) : Json(nullptr)});
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<FileDigests> file_digests_from(std::string_view line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_array()) return std::nullopt;
    FileDigests files;
    for (const Json& file : json) {
        if (!file.is_array() || file.size() != 2 || !file[0].is_string() ||
            !(file[1].is_string() || file[1].is_null()))
            return std::nullopt;
        auto& digest = files[file[0].get<std::string>()];
        if (file[1].is_string()) digest = file[1].get<std::string>();
    }
    return files;
}

}  // namespace ncsim::report
