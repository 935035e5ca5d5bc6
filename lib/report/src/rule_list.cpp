// SPDX-License-Identifier: GPL-3.0-or-later
//
// List of the rules as text and JSON.
#include "ncsim/report/rule_list.h"

#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"

#include "append.h"
#include "json.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace ncsim::report {

std::string rules_text() {
    std::string text;
    std::string_view category;
    for (const verify::RuleInfo& rule : verify::rules()) {
        if (verify::name_of(rule.category) != category) {
            category = verify::name_of(rule.category);
            append(text, "{}{}\n", text.empty() ? "" : "\n", category);
        }
        append(text, "  {:<22} {:<8} {}\n", rule.id, verify::name_of(rule.severity), rule.what);
        append(text, "{:34}why: {}\n{:34}fix: {}\n", "", rule.why, "", rule.fix);
    }
    text += "\nreasons for doubt, for --accept\n";
    for (const verify::ReasonInfo& reason : verify::reasons())
        append(text, "  {:<22} {}\n  {:<22} fix: {}\n", reason.id, reason.why, "", reason.fix);
    return text;
}

std::string rule_text(const std::string& id) {
    std::string text;
    for (const verify::RuleInfo& rule : verify::rules()) {
        const std::string_view category = verify::name_of(rule.category);
        if (id != rule.id && id != category) continue;
        append(text,
               "{}{}: {} of the category {}\n  what      {}\n  why       {}\n  fix       {}\n",
               text.empty() ? "" : "\n", rule.id, verify::name_of(rule.severity), category,
               rule.what, rule.why, rule.fix);
        append(text,
               "  off       --ignore {0}; for one block: the comment (ncsim: ignore {0})\n"
               "  severity  --severity {0}=note\n",
               rule.id);
    }
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        if (id != reason.id) continue;
        append(
            text,
            "{}{}: a reason for doubt\n  why       {}\n  fix       {}\n  accept    --accept {}\n",
            text.empty() ? "" : "\n", reason.id, reason.why, reason.fix, reason.id);
    }
    return text;
}

std::string rules_json() {
    auto rules = Json::array();
    for (const verify::RuleInfo& rule : verify::rules()) {
        rules.push_back({{"id", rule.id},
                         {"category", verify::name_of(rule.category)},
                         {"severity", verify::name_of(rule.severity)},
                         {"what", rule.what},
                         {"why", rule.why},
                         {"fix", rule.fix}});
    }
    auto reasons = Json::array();
    for (const verify::ReasonInfo& reason : verify::reasons())
        reasons.push_back({{"id", reason.id}, {"why", reason.why}, {"fix", reason.fix}});
    Json json{{"rules", std::move(rules)}, {"reasons", std::move(reasons)}};
    return json.dump(1) + "\n";
}

}  // namespace ncsim::report
