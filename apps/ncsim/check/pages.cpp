// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes HTML pages.
#include "check/pages.h"

#include "ncsim/base/file_names.h"
#include "ncsim/report/page.h"
#include "ncsim/report/page_index.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <ostream>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

/// Returns `text` with all characters replaced that differ between a file name and a link.
std::string plain_name(const std::string& text) {
    std::string name;
    for (const char c : text) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                              (c >= '0' && c <= '9') || c == '-' || (c == '.' && !name.empty());
        name += is_plain ? c : '_';
    }
    return name;
}

/// Returns a unique name for each program, from its path; equal names get the number of the
/// program.
std::vector<std::string> names_of(const std::vector<std::string>& programs) {
    std::multiset<std::string> taken;
    std::vector<std::string> names;
    for (const std::string& program : programs) {
        // File systems may ignore letter case.
        names.push_back(plain_name(relative_path(program)).substr(0, 150));
        std::string lower = names.back();
        for (char& c : lower)
            c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
        taken.insert(lower);
        names.back() += '\n' + lower;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t end = names[i].find('\n');
        const std::string lower = names[i].substr(end + 1);
        names[i].resize(end);
        if (taken.count(lower) > 1 || lower == "index") names[i] += fmt::format("~{}", i + 1);
    }
    return names;
}

void make_folder(const std::string& folder) {
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot make the folder '{}': {}", folder, error.message()));
    }
}

bool names_folder(const std::string& html) {
    std::error_code ignored;
    return html.ends_with('/') || fs::is_directory(html, ignored);
}

}  // namespace

std::string page_file(const std::string& html) {
    if (html.empty()) return html;
    return names_folder(html) ? (fs::path(html) / "index.html").string() : html;
}

std::string page_folder(const std::string& html) {
    if (html.empty() || names_folder(html)) return html;
    const fs::path file(html);
    return (file.parent_path() / (plain_name(file.stem().string()) + "-pages")).string();
}

Pages::Pages(const CheckOptions& options, const std::vector<std::string>& programs,
             OutputSet& outputs)
    : unit_(options.report_unit), outputs_(outputs), names_(names_of(programs)) {
    if (options.html.empty()) return;
    index_ = page_file(options.html);
    has_index_ = names_folder(options.html) || programs.size() > 1;
    folder_ = page_folder(options.html);
    if (names_folder(options.html)) {
        make_folder(folder_);
    } else {
        prefix_ = fs::path(folder_).filename().string() + '/';
    }
    outputs_.reserve(index_);
}

void Pages::add(std::size_t number, report::Checked checked) {
    if (index_.empty()) return;
    const std::lock_guard lock(mutex_);
    if (has_index_) return write_one(number, checked);
    kept_.emplace_back(number, std::move(checked));
}

void Pages::write_one(std::size_t number, const report::Checked& checked) {
    const std::string program = checked.program.empty() ? "" : '~' + plain_name(checked.program);
    const std::string name = names_.at(number) + program;
    make_folder(folder_);
    // Returns the address of the file from the index.
    const auto write_file = [&](const char* ending,
                                const std::function<void(std::ostream&)>& writer) {
        const std::string path = (fs::path(folder_) / (name + ending)).string();
        outputs_.reserve(path);
        outputs_.write(path, writer);
        return prefix_ + name + ending;
    };
    report::IndexFacts facts = report::index_facts(checked);
    facts.page =
        write_file(".html", [&](std::ostream& out) { report::write_page(out, checked, unit_); });
    if (checked.page_data && !checked.page_data->thumbnail.empty()) {
        facts.picture =
            write_file(".png", [&](std::ostream& out) { out << checked.page_data->thumbnail; });
    }
    facts_.emplace(Name(checked.path, checked.program), std::move(facts));
}

void Pages::write(const report::Entries& all, const report::Scope& scope) {
    if (index_.empty()) return;
    if (!has_index_ && kept_.size() == 1) {
        return outputs_.write(index_, [&](std::ostream& out) {
            report::write_page(out, kept_.front().second, unit_);
        });
    }
    for (const auto& [number, checked] : kept_)
        write_one(number, checked);
    const auto facts = [&](const report::Entry& entry) {
        const auto found = facts_.find(Name(entry.path, entry.program));
        return found == facts_.end() ? nullptr : &found->second;
    };
    outputs_.write(index_, [&](std::ostream& out) {
        report::write_page_index(out, all, facts, scope, unit_);
    });
}

}  // namespace ncsim::app
