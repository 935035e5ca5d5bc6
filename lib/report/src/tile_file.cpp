// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tile files: writing, reading, and the order of tiles.
#include "ncsim/report/tile_file.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"

#include "json.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::report {

namespace {

constexpr int kTileFormat = 3;
constexpr std::uint32_t kMost = 1'000'000;

[[noreturn]] void refuse_tile(const std::string& file, const std::string& why) {
    throw std::runtime_error(fmt::format("'{}': {}", file, why));
}

// Returns the bytes as numbers, for words and file names that are not UTF-8.
Json bytes_json(const std::string& text) {
    Json json = Json::array();
    for (const char c : text)
        json.push_back(static_cast<std::uint8_t>(c));
    return json;
}

Json text_json(const std::string& text) {
    try {
        (void)Json(text).dump();
        return text;
    } catch (const Json::exception&) {
        return bytes_json(text);
    }
}

std::string text_from(const Json& json) {
    if (json.is_string()) return json.get<std::string>();
    std::string text;
    for (const Json& byte : json)
        text += static_cast<char>(whole_number<std::uint8_t>(byte));
    return text;
}

std::string line_of(const TileHead& head) {
    Json words = Json::array(), files = Json::array();
    for (const std::string& word : head.words)
        words.push_back(text_json(word));
    for (const auto& [name, digest] : head.files)
        files.push_back({text_json(name), digest ? Json(*digest) : Json(nullptr)});
    return Json{{"ncsim-tile", kTileFormat},
                {"version", kVersion},
                {"tile", head.tile},
                {"of", head.of},
                {"words", words},
                {"files", files},
                {"all-files", head.knows_all_files}}
        .dump();
}

TileHead head_from(const Json& json) {
    TileHead head;
    for (const Json& word : json.at("words"))
        head.words.push_back(text_from(word));
    for (const Json& file : json.at("files")) {
        auto& digest = head.files[text_from(file.at(0))];
        if (!file.at(1).is_null()) digest = file.at(1).get<std::string>();
    }
    head.tile = whole_number<std::uint32_t>(json.at("tile"));
    head.of = whole_number<std::uint32_t>(json.at("of"));
    head.knows_all_files = json.at("all-files").get<bool>();
    return head;
}

}  // namespace

std::string tile_file_name(std::uint32_t tile, std::uint32_t of) {
    return fmt::format("tile-{:04}-of-{:04}.nctile", tile, of);
}

std::string bytes_of(const TileFile& file, Digest digest_of) {
    std::string bytes = line_of(file.head) + '\n';
    for (const auto& [motion, hulls] : file.stock_contacts)
        bytes += fmt::format("{} {}\n", motion, hulls);
    bytes += '\n' + file.evidence + '\n' + file.tile;
    bytes += '\n' + digest_of(bytes) + '\n';
    return bytes;
}

TileFile tile_file_from(std::string bytes, const std::string& name, Digest digest_of) {
    const std::size_t line = bytes.find('\n');
    TileFile file;
    try {
        const Json json = Json::parse(std::string_view(bytes).substr(0, line));
        if (!json.is_object() || whole_number<int>(json.at("ncsim-tile")) != kTileFormat)
            throw std::invalid_argument("");
        const auto version = json.at("version").get<std::string>();
        if (version != kVersion)
            refuse_tile(name, fmt::format("it was written by ncsim {}", one_line(version)));
        file.head = head_from(json);
    } catch (const Json::exception&) {
        refuse_tile(name, "it is no result of --tile");
    } catch (const std::invalid_argument&) {
        refuse_tile(name, "it is no result of --tile");
    }
    constexpr std::size_t kDigest = 64;
    constexpr std::size_t kEnd = kDigest + 2;
    const std::size_t end = bytes.size() < line + 1 + kEnd ? 0 : bytes.size() - kEnd;
    if (end == 0 || bytes[end] != '\n' || bytes.back() != '\n' ||
        digest_of(std::string_view(bytes).substr(0, end)) !=
            std::string_view(bytes).substr(end + 1, kDigest))
        refuse_tile(name, "it is cut off, or was changed");
    if (file.head.of == 0 || file.head.of > kMost || file.head.tile >= file.head.of)
        refuse_tile(name, "there is no such tile");
    file.digest = bytes.substr(end + 1, kDigest);
    bytes.resize(end);
    std::size_t at = line + 1;
    while (at < bytes.size() && bytes[at] != '\n') {
        simulation::StockContact met;
        const char* const last = bytes.data() + bytes.size();
        const auto motion = std::from_chars(bytes.data() + at, last, met.motion);
        if (motion.ec != std::errc() || motion.ptr == last || *motion.ptr != ' ')
            refuse_tile(name, "its motions cannot be read");
        const auto hulls = std::from_chars(motion.ptr + 1, last, met.hulls);
        if (hulls.ec != std::errc() || hulls.ptr == last || *hulls.ptr != '\n')
            refuse_tile(name, "its motions cannot be read");
        at = static_cast<std::size_t>(hulls.ptr - bytes.data()) + 1;
        file.stock_contacts.push_back(met);
    }
    // The evidence ends at the next empty line.
    const std::size_t begin = std::min(at + 1, bytes.size());
    at = begin;
    while (at < bytes.size() && bytes[at] != '\n')
        at = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
    if (at >= bytes.size()) refuse_tile(name, "what was seen cannot be read");
    file.evidence = bytes.substr(begin, at - begin);
    bytes.erase(0, at + 1);
    file.tile = std::move(bytes);
    return file;
}

std::vector<std::size_t> order_tiles(const std::vector<TileFile>& files,
                                     const std::vector<std::string>& names) {
    if (files.empty()) throw std::runtime_error("there are no tiles");
    const TileHead& first = files[0].head;
    constexpr std::size_t kNowhere = ~std::size_t{0};
    std::vector<std::size_t> found(first.of, kNowhere);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const TileHead& head = files[i].head;
        if (head.of != first.of) refuse_tile(names[i], "it is of another number of tiles");
        if (head.words != first.words) refuse_tile(names[i], "something else was asked for");
        if (head.files != first.files) refuse_tile(names[i], "it was made of other files");
        const std::uint32_t tile = head.tile;
        if (found[tile] != kNowhere && files[found[tile]].digest != files[i].digest) {
            refuse_tile(names[i],
                        fmt::format("'{}' is the same tile, and not the same", names[found[tile]]));
        }
        found[tile] = i;
    }
    const auto missing = std::ranges::count(found, kNowhere);
    if (missing > 0)
        throw std::runtime_error(fmt::format("{} of {} tiles are missing", missing, first.of));
    return found;
}

}  // namespace ncsim::report
