// SPDX-License-Identifier: GPL-3.0-or-later
//
// Entries as lines of JSON.
#include "ncsim/report/entry.h"

#include "ncsim/base/utf8.h"

#include "json.h"

#include <cstddef>
#include <cstdint>

namespace ncsim::report {

namespace {

// Calls `take` with the key and the value of each text of an entry.
template <class EntryType, class Take>
void for_each_text(EntryType& entry, Take take) {
    take("path", entry.path);
    take("program", entry.program);
    take("word", entry.word);
    take("text", entry.text);
    take("settings", entry.settings);
    take("baseline", entry.baseline);
    take("counts", entry.counts);
    take("scope", entry.scope);
    take("to_tell", entry.remedy_text);
    take("skipped", entry.skipped);
    take("json", entry.json);
    take("sarif", entry.sarif);
    take("junit", entry.junit);
    take("github", entry.github);
    take("csv", entry.csv);
    take("known", entry.known);
    take("reads", entry.reads);
}

// JSON is UTF-8, but programs need not be. A byte B that is not UTF-8 is stored as the character
// U+10FF00 + B: F4 8F BC..BF, then a byte with the low six bits of B. Each byte of a character in
// this range is stored the same way.
constexpr std::string_view kByteMark = "\xf4\x8f";

std::string mark_bytes(std::string_view text) {
    std::string marked;
    while (!text.empty()) {
        const Character c = first_character(text);
        const std::string_view bytes = text.substr(0, c.bytes);
        text.remove_prefix(c.bytes);
        if (c.is_valid() && !(c.bytes == 4 && bytes.starts_with(kByteMark) && bytes[2] >= '\xbc')) {
            marked.append(bytes);
            continue;
        }
        for (const char byte : bytes) {
            const auto b = static_cast<std::uint8_t>(byte);
            marked.append(kByteMark);
            marked += static_cast<char>(0xbc | b >> 6);
            marked += static_cast<char>(0x80 | (b & 0x3f));
        }
    }
    return marked;
}

std::string unmark_bytes(std::string_view marked) {
    std::string text;
    for (std::size_t at = 0; at < marked.size();) {
        const std::string_view rest = marked.substr(at);
        if (rest.size() >= 4 && rest.starts_with(kByteMark) && rest[2] >= '\xbc') {
            const auto high = static_cast<std::uint8_t>(rest[2]) & 0x03U;
            const auto low = static_cast<std::uint8_t>(rest[3]) & 0x3fU;
            text += static_cast<char>(high << 6 | low);
            at += 4;
        } else {
            text += rest.front();
            ++at;
        }
    }
    return text;
}

}  // namespace

namespace {

Json json_of(const Entry& entry) {
    Json json{{"code", entry.code}, {"is_subprogram", entry.is_subprogram}};
    for_each_text(entry,
                  [&](const char* key, const std::string& text) { json[key] = mark_bytes(text); });
    json["more"] = Json::array();
    for (const Entry& more : entry.more)
        json["more"].push_back(json_of(more));
    return json;
}

std::optional<Entry> entry_of(const Json& json) {
    if (!json.is_object() || !json.contains("code") || !json["code"].is_number_integer() ||
        !json.contains("is_subprogram") || !json["is_subprogram"].is_boolean() ||
        !json.contains("more") || !json["more"].is_array())
        return std::nullopt;
    Entry entry;
    entry.code = json["code"].get<int>();
    entry.is_subprogram = json["is_subprogram"].get<bool>();
    bool is_whole = true;
    for_each_text(entry, [&](const char* key, std::string& text) {
        is_whole = is_whole && json.contains(key) && json[key].is_string();
        if (is_whole) text = unmark_bytes(json[key].get<std::string>());
    });
    for (const Json& one : json["more"]) {
        std::optional<Entry> more = entry_of(one);
        if (!more || !more->more.empty()) return std::nullopt;
        entry.more.push_back(*std::move(more));
    }
    if (!is_whole) return std::nullopt;
    return entry;
}

}  // namespace

std::string line_of(const Entry& entry) {
    return to_line(json_of(entry));
}

std::optional<Entry> entry_from(std::string_view line) {
    return entry_of(Json::parse(line, nullptr, false));
}

void for_each_program(const Entry& entry, const std::function<void(const Entry&)>& take) {
    if (entry.more.empty()) return take(entry);
    Entry first = entry;
    first.more.clear();
    take(first);
    for (const Entry& more : entry.more)
        take(more);
}

}  // namespace ncsim::report
