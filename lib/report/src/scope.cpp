// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subprograms judged with their callers, and files that are left out.
#include "ncsim/report/scope.h"

#include "ncsim/base/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

namespace ncsim::report {

namespace {

constexpr std::size_t kMostNamed = 3;

std::string same_path(const std::string& path) {
    return std::filesystem::path(path).lexically_normal().string();
}

/// Adds the files that `entry` reads, with the entry as their caller.
void add_reads(std::map<std::string, std::string>& callers, const Entry& entry) {
    if (entry.word == "not-verified") return;
    const std::string_view reads = entry.reads;
    for (std::size_t at = 0; at < reads.size();) {
        const std::size_t end = std::min(reads.find('\n', at), reads.size());
        callers.try_emplace(same_path(std::string(reads.substr(at, end - at))), entry.path);
        at = end + 1;
    }
}

}  // namespace

std::vector<CalledFile> called_files(const Entries& all) {
    std::map<std::string, std::string> callers;
    all([&](const Entry& entry) {
        if (!entry.is_subprogram) add_reads(callers, entry);
    });
    std::vector<CalledFile> called;
    all([&](const Entry& entry) {
        if (!entry.is_subprogram) return;
        const auto caller = callers.find(same_path(entry.path));
        if (caller == callers.end()) return add_reads(callers, entry);
        called.push_back({entry.path, caller->second});
    });
    return called;
}

Entries remove_called(const Entries& all, const std::vector<CalledFile>& called) {
    std::set<std::string> paths;
    for (const CalledFile& file : called)
        paths.insert(file.path);
    return [&all, paths](const std::function<void(const Entry&)>& take) {
        bool has_subprograms = false;
        all([&](const Entry& entry) {
            has_subprograms = has_subprograms || entry.is_subprogram;
            if (!entry.is_subprogram) take(entry);
        });
        if (!has_subprograms) return;
        all([&](const Entry& entry) {
            if (entry.is_subprogram && !paths.contains(entry.path)) take(entry);
        });
    };
}

std::string text_of(const std::vector<ExcludedEntry>& excluded) {
    if (excluded.empty()) return {};
    std::map<std::string, std::vector<std::string>> kinds;
    for (const ExcludedEntry& file : excluded)
        kinds[file.why].push_back(printable_path(file.path));
    std::string text =
        fmt::format("ncsim: {} left out: no NC program{}; to judge one all the same, name it\n",
                    excluded.size(), excluded.size() == 1 ? "" : "s");
    for (const auto& [why, names] : kinds) {
        text += fmt::format("ncsim:   {}: {}: ", why, names.size());
        for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i)
            text += (i == 0 ? "" : ", ") + names[i];
        if (names.size() > kMostNamed)
            text += fmt::format(" and {} more", names.size() - kMostNamed);
        text += '\n';
    }
    return text;
}

std::string worst_verdict(const Entries& all) {
    constexpr std::string_view kWords[] = {"clean", "accepted", "not-proven", "failed",
                                           "not-verified"};
    std::size_t worst = 0;
    all([&](const Entry& entry) {
        const auto* const at = std::ranges::find(kWords, entry.word);
        worst = std::max(worst, static_cast<std::size_t>(at - std::begin(kWords)));
    });
    return std::string(kWords[std::min(worst, std::size(kWords) - 1)]);
}

std::string counts_of(const Scope& scope) {
    std::string text;
    const std::size_t called = scope.called.size();
    if (called == 1) text += "; 1 subprogram, judged with its caller";
    if (called > 1) text += fmt::format("; {} subprograms, judged with their callers", called);
    const std::size_t excluded = scope.excluded.size();
    if (excluded > 0) text += fmt::format("; {} left out", excluded);
    return text;
}

}  // namespace ncsim::report
