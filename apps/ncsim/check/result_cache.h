// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts that are known already: equal input gives equal bytes, so what was found once need not
// be looked for again. A folder that many processes may use at a time, on NFS, too: entries are
// written aside and renamed, and one that is not whole is none.
#pragma once

#include "ncsim/report/entry.h"
#include "ncsim/setup/recorded_input.h"

#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace ncsim::app {

/// A name of a file as reports make it relative: an absolute one means what it does from here.
std::string named_anywhere(const std::string& path);

class ResultCache {
public:
    /// `common`: all that decides a verdict but the program and what it reads: version, options,
    /// digests of files. `complain` is told once if the folder cannot be written.
    ResultCache(std::string folder, std::string common,
                std::function<void(const std::string&)> complain);

    /// What is known of a program, of which others say what is in `about`: nothing if it, or what
    /// was read with it, is not as it was. That is read through `inputs`.
    std::optional<report::Entry> find(const std::string& program, const std::string& about,
                                      setup::InputSet& inputs) const;
    /// Keeps it, unless it is no verdict; `read` is all that it depends on.
    void keep(const std::string& program, const std::string& about, const report::Entry& entry,
              const setup::ReadFiles& read);

private:
    std::string key_of(const std::string& program, const std::string& about) const;
    std::string path_of(const std::string& key) const;

    std::string folder_, common_;
    std::function<void(const std::string&)> complain_;
    std::once_flag complained_;
};

}  // namespace ncsim::app
