// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/verify/finding.h"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace ncsim::verify {

/// Rules that the user deselected, and severities that the user changed, each with the option that
/// did it, or its place in a file: "--ignore", "ncsim.toml:3:1".
struct Selection {
    struct Weight {
        Severity severity = Severity::Error;
        std::string by;
    };
    std::map<std::string, std::string, std::less<>> ignored;  ///< By rule.
    std::map<std::string, Weight, std::less<>> severities;    ///< By rule.
    /// What accepted the reasons of Setup::accepted.
    std::string accepted_by = "--accept";

    bool includes(std::string_view id) const { return !ignored.contains(id); }
    /// Replaces the option `option` by the place that it comes from.
    void set_origin(std::string_view option, const std::string& place);
};

}  // namespace ncsim::verify
