// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/report/entry.h"

#include "json.h"

namespace ncsim::report {

namespace {

// The texts of an entry and how a line calls them.
template <class EntryType, class Take>
void for_each_text(EntryType& entry, Take take) {
    take("path", entry.path);
    take("word", entry.word);
    take("text", entry.text);
    take("settings", entry.settings);
    take("counts", entry.counts);
    take("to_tell", entry.to_tell);
    take("skipped", entry.skipped);
    take("json", entry.json);
    take("sarif", entry.sarif);
    take("junit", entry.junit);
    take("github", entry.github);
    take("csv", entry.csv);
}

}  // namespace

std::string line_of(const Entry& entry) {
    Json json{{"code", entry.code}};
    for_each_text(entry, [&](const char* key, const std::string& text) { json[key] = text; });
    return to_line(json);
}

std::optional<Entry> entry_from(std::string_view line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    Entry entry;
    bool is_whole = json.contains("code") && json["code"].is_number_integer();
    if (is_whole) entry.code = json["code"].get<int>();
    for_each_text(entry, [&](const char* key, std::string& text) {
        is_whole = is_whole && json.contains(key) && json[key].is_string();
        if (is_whole) text = json[key].get<std::string>();
    });
    if (!is_whole) return std::nullopt;
    return entry;
}

}  // namespace ncsim::report
