// SPDX-License-Identifier: GPL-3.0-or-later
//
// List of the rules as text and JSON.
#include "ncsim/report/rule_list.h"

#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"

#include "append.h"
#include "json.h"
#include "rule_examples.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::report {

namespace {

void append_file(std::string& text, std::string_view heading, const ExampleFile& file) {
    append(text, "\n{} ({}):\n\n", heading, file.name);
    for (std::string_view rest = file.text; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        append(text, "  {}\n", line);
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
}

// Appends the program that fails the rule, the program that passes, and the settings of both.
void append_example(std::string& text, std::string_view rule) {
    const std::vector<ExampleFile> files = rule_example(rule);
    const auto append_named = [&](std::string_view heading, std::string_view name) {
        for (const ExampleFile& file : files)
            if (file.name == name) append_file(text, heading, file);
    };
    append_named("A program that fails", "fails.nc");
    append_named("A program that passes", "passes.nc");
    append_named("Settings of both", "ncsim.toml");
    append_named("Machine", "machine.toml");
    for (const ExampleFile& file : files)
        if (file.text.empty()) append(text, "\nMesh: {}\n", file.name);
    append(text, "\nThe files are in examples/rules/{} of the documentation folder.\n", rule);
}

}  // namespace

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
        if (id == rule.id) append_example(text, rule.id);
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
