// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rules and severities that the user selected.
#pragma once

#include "ncsim/verify/finding.h"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace ncsim::verify {

/// Rules that the user deselected, and severities that the user changed. Each entry names the
/// option or the place in a file: "--ignore", "ncsim.toml:3:1".
struct Selection {
    /// Changed severity of a rule, and the option or the place that changed it.
    struct Weight {
        Severity severity = Severity::Error;
        std::string by;
    };
    std::map<std::string, std::string, std::less<>> ignored;  ///< Origin by rule.
    std::map<std::string, Weight, std::less<>> severities;    ///< Severity by rule.
    /// Option or place that accepted the reasons of Setup::accepted.
    std::string accepted_by = "--accept";

    bool includes(std::string_view id) const { return !ignored.contains(id); }
    /// Replaces the option `option` by the place in a file, `place`, that contains the setting.
    void set_origin(std::string_view option, const std::string& place);
};

}  // namespace ncsim::verify
