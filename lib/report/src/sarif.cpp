// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings as SARIF.
// Source: Static Analysis Results Interchange Format (SARIF) Version 2.1.0, OASIS Standard, 2020.
#include "ncsim/report/sarif.h"

#include "ncsim/base/ascii.h"
#include "ncsim/base/file_names.h"
#include "ncsim/base/version.h"
#include "ncsim/report/check_text.h"
#include "ncsim/verify/rule.h"

#include "fingerprint.h"
#include "json.h"
#include "json_stream.h"
#include "shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <string_view>

namespace ncsim::report {

namespace {

using verify::Finding;
using verify::Severity;

// Largest number of results of a run that GitHub accepts; GitHub rejects a file with more.
constexpr std::size_t kMaxResults = 25000;

// Escapes all characters except unreserved characters and '/', as RFC 3986 requires in a path.
std::string uri_of(const std::string& path) {
    std::string uri;
    for (const char c : path) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') ||
                           std::string_view("/-._~").find(c) != std::string_view::npos;
        if (plain) {
            uri += c;
        } else {
            uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return uri.starts_with('/') ? "file://" + uri : uri;
}

const char* level_of(Severity severity) {
    switch (severity) {
        case Severity::Note: return "note";
        case Severity::Warning: return "warning";
        case Severity::Error: break;
    }
    return "error";
}

// Levels in the order of output: highest severity first.
constexpr std::array<const char*, 3> kWeights{"error", "warning", "note"};

Json sarif_rules() {
    Json rules = Json::array();
    for (const verify::RuleInfo& rule : verify::rules()) {
        rules.push_back({{"id", rule.id},
                         {"shortDescription", {{"text", rule.what}}},
                         {"fullDescription", {{"text", rule.why}}},
                         {"help", {{"text", rule.fix}}},
                         {"defaultConfiguration", {{"level", level_of(rule.severity)}}},
                         {"properties",
                          {{"category", verify::name_of(rule.category)},
                           {"tags", {verify::name_of(rule.category)}}}}});
    }
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        rules.push_back({{"id", reason.id},
                         {"shortDescription", {{"text", reason.why}}},
                         {"fullDescription", {{"text", reason.why}}},
                         {"help", {{"text", fmt::format("Fix: {}.", reason.fix)}}},
                         {"defaultConfiguration", {{"level", "warning"}}},
                         {"properties", {{"category", "doubt"}, {"tags", {"doubt"}}}}});
    }
    return rules;
}

// Return the index in the list of rules, which the reasons for doubt follow. A few reasons have the
// id of a rule.
std::size_t index_of_rule(const std::string& id) {
    const auto rules = verify::rules();
    return static_cast<std::size_t>(std::ranges::find(rules, id, &verify::RuleInfo::id) -
                                    rules.begin());
}
std::size_t index_of_reason(const std::string& id) {
    return verify::rules().size() +
           static_cast<std::size_t>(verify::find_reason(id) - verify::reasons().data());
}

// Returns the location of a file, or of the text between two places in the file.
Json location(const std::string& path, const verify::Place& place = {},
              const verify::Place& last = {}) {
    Json physical{{"artifactLocation", {{"uri", uri_of(path)}}}};
    if (place.span.line > 0) {
        const gcode::SourceSpan& first = place.span;
        Json region{{"startLine", first.line}, {"startColumn", first.column}};
        if (last.file == place.file && last.span.line > first.line) {
            region["endLine"] = last.span.line;
            region["endColumn"] = last.span.column + std::max(1U, last.span.length);
        } else {
            region["endColumn"] = first.column + std::max(1U, first.length);
        }
        physical["region"] = std::move(region);
    }
    return {{"physicalLocation", std::move(physical)}};
}

std::string message_of(const Finding& f) {
    std::string text = headline(f) + ".";
    if (f.count > 1 && f.last_motion > 0 && f.rule != "air-cut") {
        text += fmt::format(" In {} motions{}.", f.count, f.goes_on ? " or more" : "");
    }
    for (const std::string& assumption : f.assumptions)
        text += " Assumed " + assumption + ".";
    return text + " " + f.hint;
}

// Number of earlier results with the same identity, from the top of the program down; makes
// fingerprints unique.
using Seen = std::map<std::string, int>;

Json result(const Checked& checked, const Finding& f, const std::string& line, Seen& seen) {
    const std::string path = file_of(checked, f.place);
    std::string identity = f.rule + '\n' + f.code + '\n' + path + '\n';
    if (!checked.program.empty()) identity += checked.program + '\n';
    identity += trimmed(line);
    const int nth = seen[identity]++;
    Json json{{"ruleId", f.rule},
              {"ruleIndex", index_of_rule(f.rule)},
              {"level", level_of(f.severity)},
              {"message", {{"text", message_of(f)}}},
              {"locations", {location(path, f.place, f.last)}},
              {"partialFingerprints",
               {{"ncsimFinding/v1", fingerprint(identity) + ":" + std::to_string(nth)}}}};
    if (f.suppressed) {
        json["suppressions"] = {{{"kind", "inSource"}}};
    } else if (f.accepted) {
        Json suppression{{"kind", "external"}, {"status", "accepted"}};
        if (!f.accepted->empty()) suppression["justification"] = *f.accepted;
        json["suppressions"] = {std::move(suppression)};
    }
    Json properties{{"certain", f.certainty == verify::Certainty::Certain}};
    if (f.quantity) {
        properties["quantity"] = f.quantity->name;
        properties["value"] = round_value(f.quantity->value);
        properties["unit"] = f.quantity->unit;
    }
    json["properties"] = std::move(properties);
    return json;
}

Json result(const Checked& checked, const verify::Doubt& d, Seen& seen) {
    const std::string path = file_of(checked, d.place);
    const std::string identity = d.reason + '\n' + path + '\n' + d.message;
    const int nth = seen[identity]++;
    const std::string_view fix = verify::find_reason(d.reason)->fix;
    Json json{{"ruleId", d.reason},
              {"ruleIndex", index_of_reason(d.reason)},
              {"level", "warning"},
              {"message", {{"text", fmt::format("Not proven: {}. Fix: {}.", d.message, fix)}}},
              {"locations", {location(path, d.place)}},
              {"partialFingerprints",
               {{"ncsimFinding/v1", fingerprint(identity) + ":" + std::to_string(nth)}}}};
    if (d.accepted) json["suppressions"] = {{{"kind", "external"}}};
    return json;
}

}  // namespace

Json sarif_share(const Checked& checked, bool notes) {
    Json share{{"verified", checked.failure.empty()},
               {"notifications", Json::array()},
               {"configuration", Json::array()}};
    for (const char* weight : kWeights)
        share[weight] = Json::array();
    const std::string path = relative_path(checked.path);
    if (!checked.failure.empty()) {
        share["notifications"].push_back(
            {{"level", "error"},
             {"message", {{"text", "not verified: " + checked.failure}}},
             {"locations", {location(path)}}});
        return share;
    }
    Seen seen;
    const auto& findings = checked.verdict.findings;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        Json json = result(checked, findings[i], checked.lines[i], seen);
        if (findings[i].severity != Severity::Note || notes)
            share[level_of(findings[i].severity)].push_back(std::move(json));
    }
    for (const verify::Doubt& d : checked.verdict.doubts)
        share["warning"].push_back(result(checked, d, seen));
    for (const auto& [rule, more] : checked.verdict.unlisted) {
        share["notifications"].push_back(
            {{"level", "warning"},
             {"message", {{"text", fmt::format("{} more findings of {}", more, rule)}}},
             {"locations", {location(path)}}});
    }
    for (const verify::Demotion& d : checked.verdict.demotions) {
        share["configuration"].push_back({{"level", "warning"},
                                          {"associatedRule", {{"id", d.rule}}},
                                          {"message", {{"text", demotion_text(d)}}},
                                          {"locations", {location(path)}}});
    }
    for (const verify::Skipped& s : checked.verdict.skipped) {
        share["configuration"].push_back({{"level", s.deselected ? "warning" : "note"},
                                          {"associatedRule", {{"id", s.rule}}},
                                          {"message", {{"text", s.rule + " skipped: " + s.reason}}},
                                          {"locations", {location(path)}}});
    }
    return share;
}

void write_sarif(std::ostream& out, const Entries& all) {
    const auto each = [&](const auto& take) {
        all([&](const Entry& entry) { take(Json::parse(entry.sarif)); });
    };
    bool all_verified = true;
    std::size_t results = 0;
    each([&](const Json& share) {
        all_verified = all_verified && share["verified"].get<bool>();
        for (const char* weight : kWeights)
            results += share[weight].size();
    });
    JsonStream json(out);
    json.begin_object();
    json.value("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
    json.value("version", "2.1.0");
    json.begin_array("runs");
    json.begin_object();
    json.value("tool",
               {{"driver", {{"name", "ncsim"}, {"version", kVersion}, {"rules", sarif_rules()}}}});
    json.begin_array("invocations");
    json.begin_object();
    json.value("executionSuccessful", all_verified);
    const auto put_all = [&](const char* key) {
        each([&](const Json& share) {
            for (const Json& element : share[key])
                json.element(element);
        });
    };
    json.begin_array("toolExecutionNotifications");
    put_all("notifications");
    if (results > kMaxResults) {
        json.element({{"level", "warning"},
                      {"message",
                       {{"text", fmt::format("{} results of the least weight were left out: no "
                                             "more than {} are accepted",
                                             results - kMaxResults, kMaxResults)}}}});
    }
    json.end();
    json.begin_array("toolConfigurationNotifications");
    put_all("configuration");
    json.end();
    json.end();
    json.end();
    json.value("columnKind", "utf16CodeUnits");
    json.begin_array("results");
    std::size_t room = kMaxResults;
    for (const char* weight : kWeights) {
        each([&](const Json& share) {
            for (const Json& element : share[weight]) {
                if (room == 0) return;
                --room;
                json.element(element);
            }
        });
    }
    json.end();
    json.end();
    json.end();
    json.end();
}

}  // namespace ncsim::report
