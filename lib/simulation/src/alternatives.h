// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alternative readings of a program, or of how the machine moves. A verdict is proven only if all
// readings agree.
#pragma once

#include "ncsim/simulation/checked.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/doubt.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::simulation {

struct VerificationOptions;

/// A second reading of the program.
struct Alternative {
    /// Id in verify::reasons(), which has the option that decides the reading.
    std::string_view reason;
    std::string message;  ///< Condition of the second verdict: "with blocks skipped".
    verify::Place place;  ///< First place with two readings.
    std::function<void(Plan&, VerificationOptions&)> apply;
    bool compares_parts = false;  ///< True if a part of a different volume is a doubt, too.
};

/// Returns the further readings of `plan`, except where an option decides the reading.
std::vector<Alternative> alternatives_of(const Plan& plan, const Survey& survey,
                                         const VerificationOptions& verification_options);

/// Returns the most severe difference of `other` from `verdict`, or an empty string.
std::string difference(const Checked& verdict, const Checked& other);

/// Returns the doubt about `verdict` if `other`, the verdict of `alternative`, differs.
std::optional<verify::Doubt> doubt_from(const Checked& verdict, const Checked& other,
                                        const Alternative& alternative);

}  // namespace ncsim::simulation
