// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pages of `--html`: a single page for one program, or a page for each program and an index.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/report/length_unit.h"
#include "ncsim/report/page_index.h"
#include "ncsim/report/scope.h"

#include "options/check_options.h"
#include "system/output.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::app {

class Pages {
public:
    /// Creates pages for `programs`. Nothing is written unless options.html names a file.
    /// Requires: all arguments outlive the object.
    Pages(const CheckOptions& options, const std::vector<std::string>& programs,
          OutputSet& outputs);

    /// Adds a program that was judged; `number`: its place in the list. Thread-safe.
    /// Throws: std::runtime_error if the page cannot be written.
    void add(std::size_t number, report::Checked checked);
    /// Writes the page, or the index of `all`.
    void write(const report::Entries& all, const report::Scope& scope);

private:
    using Name = std::pair<std::string, std::string>;  // path and program

    void write_one(std::size_t number, const report::Checked& checked);

    std::string index_;   // file of --html
    std::string folder_;  // folder of the pages
    std::string prefix_;  // from the index to a page
    bool has_index_ = false;
    report::LengthUnit unit_;
    OutputSet& outputs_;
    std::vector<std::string> names_;  // of pages, by program
    std::mutex mutex_;
    std::vector<std::pair<std::size_t, report::Checked>> kept_;  // pages while there is no index
    std::map<Name, report::IndexFacts> facts_;
};

/// Returns the file of the index or only page of `--html`: "DIR/index.html" for a folder.
std::string page_file(const std::string& html);
/// Returns the folder of the pages of several programs; empty without `--html`.
std::string page_folder(const std::string& html);

}  // namespace ncsim::app
