// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/verify/finding.h"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace ncsim::verify {

/// Which rules are asked, and how much they weigh.
struct Selection {
    std::set<std::string, std::less<>> ignored;
    std::map<std::string, Severity, std::less<>> severities;

    bool includes(std::string_view id) const { return !ignored.contains(id); }
};

}  // namespace ncsim::verify
