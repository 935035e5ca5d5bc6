// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shard files: writing, reading and the distribution of programs.
#include "ncsim/report/shard.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"

#include "json.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <numeric>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace ncsim::report {

namespace {

constexpr int kFormat = 3;
constexpr std::uint64_t kMostPrograms = 100'000'000;

[[noreturn]] void fail(const std::string& file, const std::string& why) {
    throw std::runtime_error(fmt::format("'{}': {}", file, why));
}

struct Head {
    std::string version;
    ShardHead head;
    std::vector<ExcludedEntry> excluded;
};

std::optional<Head> head_from(const std::string& line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("ncsim-shard")) return std::nullopt;
    try {
        if (whole_number<int>(json.at("ncsim-shard")) != kFormat ||
            whole_number<std::uint64_t>(json.at("programs")) > kMostPrograms)
            return std::nullopt;
        std::vector<ExcludedEntry> excluded;
        for (const Json& file : json.at("left_out"))
            excluded.push_back({file.at(0).get<std::string>(), file.at(1).get<std::string>()});
        return Head{json.at("version").get<std::string>(),
                    {json.at("list").get<std::string>(), json.at("options").get<std::string>(),
                     whole_number<std::uint32_t>(json.at("shard")),
                     whole_number<std::uint32_t>(json.at("of")),
                     whole_number<std::uint64_t>(json.at("programs"))},
                    std::move(excluded)};
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

// Returns the position in the list from a line "17 {…}".
std::optional<std::uint64_t> index_in(const std::string& line) {
    std::uint64_t index = 0;
    std::size_t at = 0;
    for (; at < line.size() && line[at] >= '0' && line[at] <= '9' && at < 18; ++at)
        index = 10 * index + static_cast<std::uint64_t>(line[at] - '0');
    if (at == 0 || at >= line.size() || line[at] != ' ') return std::nullopt;
    return index;
}

std::string end_of(std::uint64_t programs) {
    return fmt::format("end {}", programs);
}

// True if the line is the end line for `programs` programs and the last line of the file.
bool is_end(std::ifstream& in, const std::string& line, std::uint64_t programs) {
    return line == end_of(programs) && !in.eof() && in.peek() == std::ifstream::traits_type::eof();
}

}  // namespace

std::string shard_file_name(std::uint32_t shard, std::uint32_t of) {
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(of).size());
    return fmt::format("shard-{0:0{2}}-of-{1:0{2}}.ndjson", shard, of, digits);
}

void write_shard(std::ostream& out, const ShardHead& head,
                 const std::vector<ExcludedEntry>& excluded, std::span<const Placed> entries) {
    Json rest = Json::array();
    for (const ExcludedEntry& file : excluded)
        rest.push_back(Json::array({file.path, file.why}));
    out << to_line({{"ncsim-shard", kFormat},
                    {"version", kVersion},
                    {"list", head.list},
                    {"options", head.options},
                    {"shard", head.shard},
                    {"of", head.of},
                    {"programs", head.programs},
                    {"left_out", std::move(rest)}})
        << '\n';
    for (const Placed& placed : entries)
        out << placed.index << ' ' << line_of(placed.entry) << '\n';
    out << end_of(entries.size()) << '\n';
}

bool is_whole(const std::string& file, const ShardHead& head) {
    std::ifstream in(file, std::ios::binary);
    std::string line;
    if (!std::getline(in, line)) return false;
    const std::optional<Head> found = head_from(line);
    if (!found || found->version != kVersion || found->head != head) return false;
    std::uint64_t programs = 0;
    while (std::getline(in, line)) {
        if (!index_in(line)) return is_end(in, line, programs);
        ++programs;
    }
    return false;
}

std::vector<std::size_t> programs_of_shard(std::span<const std::uint64_t> sizes,
                                           std::uint32_t shard, std::uint32_t of) {
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t i) { return sizes[i]; });
    // Smallest load first, then smallest number.
    using Load = std::pair<std::uint64_t, std::uint32_t>;
    std::vector<Load> loads;
    for (std::uint32_t i = 0; i < of; ++i)
        loads.emplace_back(0, i);
    const std::greater<> comes_later;
    std::vector<std::size_t> mine;
    for (const std::size_t program : order) {
        std::ranges::pop_heap(loads, comes_later);
        Load& least = loads.back();
        if (least.second == shard) mine.push_back(program);
        // Constant cost of a program of any size.
        constexpr std::uint64_t kStart = 1000;
        least.first += sizes[program] + kStart;
        std::ranges::push_heap(loads, comes_later);
    }
    std::ranges::sort(mine);
    return mine;
}

Shards::Shards(const std::vector<std::string>& files) : files_(files) {
    if (files_.empty()) throw std::runtime_error("there are no shards");
    std::ranges::sort(files_);
    for (std::uint32_t file = 0; file < files_.size(); ++file)
        take(file);
    const auto missing = std::ranges::count(places_, kNowhere, &Place::offset);
    if (missing > 0) {
        throw std::runtime_error(
            fmt::format("{} of {} programs are in no shard: not all {} shards are there", missing,
                        places_.size(), head_.of));
    }
}

void Shards::take(std::uint32_t number) {
    const std::string& file = files_[number];
    std::ifstream in(file, std::ios::binary);
    std::string line;
    if (!in) fail(file, "it cannot be read");
    std::optional<Head> head;
    if (std::getline(in, line)) head = head_from(line);
    if (!head) fail(file, "it is no result of ncsim check --shard");
    if (head->version != kVersion)
        fail(file, fmt::format("it was written by ncsim {}", one_line(head->version)));
    for (ExcludedEntry& excluded : head->excluded) {
        if (std::ranges::find(excluded_, excluded) == excluded_.end())
            excluded_.push_back(std::move(excluded));
    }
    ShardHead same = head->head;
    same.shard = head_.shard;
    if (number == 0) {
        head_ = head->head;
        places_.resize(head_.programs);
    } else if (same != head_) {
        fail(file, same.list != head_.list         ? "it is of another list of programs"
                   : same.options != head_.options ? "other options were asked for"
                                                   : "it is of another number of shards");
    }
    std::uint64_t programs = 0;
    for (auto offset = static_cast<std::uint64_t>(in.tellg()); std::getline(in, line);
         offset = static_cast<std::uint64_t>(in.tellg())) {
        const std::optional<std::uint64_t> index = index_in(line);
        if (!index) {
            if (!is_end(in, line, programs)) break;
            return;
        }
        if (in.eof() || *index >= places_.size()) break;
        ++programs;
        Place& place = places_[*index];
        if (place.offset == kNowhere) {
            place = {number, offset};
        } else if (line_at(place) != line) {
            fail(file, fmt::format("program {} of the list is in '{}', too, with another "
                                   "result",
                                   *index + 1, files_[place.file]));
        }
    }
    fail(file, "it is cut off");
}

std::string Shards::line_at(const Place& place) const {
    std::ifstream in(files_[place.file], std::ios::binary);
    in.seekg(static_cast<std::streamoff>(place.offset));
    std::string line;
    if (!std::getline(in, line)) fail(files_[place.file], "it cannot be read");
    return line;
}

Entries Shards::entries() const {
    return [this](const std::function<void(const Entry&)>& take) {
        for (const Place& place : places_) {
            const std::string line = line_at(place);
            const std::optional<Entry> entry =
                entry_from(std::string_view(line).substr(line.find(' ') + 1));
            if (!entry) fail(files_[place.file], "it is no result of ncsim check --shard");
            for_each_program(*entry, take);
        }
    };
}

}  // namespace ncsim::report
