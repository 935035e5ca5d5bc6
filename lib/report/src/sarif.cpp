// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static Analysis Results Interchange Format (SARIF) Version 2.1.0, OASIS Standard, 2020.
#include "ncsim/report/sarif.h"

#include "ncsim/report/file_names.h"
#include "ncsim/report/version.h"
#include "ncsim/verify/rule.h"

#include "json.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <string_view>

namespace ncsim::report {

namespace {

using verify::Finding;
using verify::Severity;

// What GitHub takes in of one run; more would refuse the whole file.
constexpr std::size_t kMaxResults = 25000;

// Everything but unreserved characters and '/', as RFC 3986 wants it in a path.
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

// 64 bits, FNV-1a (Fowler, Noll, Vo): told apart, not kept secret.
std::string fingerprint(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3ULL;
    }
    return fmt::format("{:016x}", hash);
}

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

Json rules_json() {
    Json rules = Json::array();
    for (const verify::RuleInfo& rule : verify::rules()) {
        rules.push_back({{"id", rule.id},
                         {"shortDescription", {{"text", rule.why}}},
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
                         {"help", {{"text", fmt::format("To tell: {}.", reason.tell)}}},
                         {"defaultConfiguration", {{"level", "warning"}}},
                         {"properties", {{"category", "doubt"}, {"tags", {"doubt"}}}}});
    }
    return rules;
}

// Rules first, then reasons for doubt.
std::size_t index_of(const std::string& id) {
    const auto rules = verify::rules();
    const auto rule = std::ranges::find(rules, id, &verify::RuleInfo::id);
    auto index = static_cast<std::size_t>(rule - rules.begin());
    if (rule == rules.end())
        index += static_cast<std::size_t>(verify::find_reason(id) - verify::reasons().data());
    return index;
}

// Of a file, or of what lies between two places in it.
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

// Numbers the fingerprints that would be equal, from the top of the program down.
using Seen = std::map<std::string, int>;

Json result(const Checked& checked, const Finding& f, const std::string& line, Seen& seen) {
    const std::string path = file_of(checked, f.place);
    std::string identity = f.rule + '\n' + f.code + '\n' + path + '\n';
    identity += trimmed(line);
    const int nth = seen[identity]++;
    Json json{{"ruleId", f.rule},
              {"ruleIndex", index_of(f.rule)},
              {"level", level_of(f.severity)},
              {"message", {{"text", message_of(f)}}},
              {"locations", {location(path, f.place, f.last)}},
              {"partialFingerprints",
               {{"ncsimFinding/v1", fingerprint(identity) + ":" + std::to_string(nth)}}}};
    if (f.suppressed) json["suppressions"] = {{{"kind", "inSource"}}};
    Json properties{{"certain", f.certainty == verify::Certainty::Certain}};
    if (f.quantity) {
        properties["quantity"] = f.quantity->name;
        properties["value"] = f.quantity->value;
        properties["unit"] = f.quantity->unit;
    }
    json["properties"] = std::move(properties);
    return json;
}

Json result(const Checked& checked, const verify::Doubt& d, Seen& seen) {
    const std::string path = file_of(checked, d.place);
    const std::string identity = d.reason + '\n' + path + '\n' + d.message;
    const int nth = seen[identity]++;
    const std::string_view tell = verify::find_reason(d.reason)->tell;
    Json json{{"ruleId", d.reason},
              {"ruleIndex", index_of(d.reason)},
              {"level", "warning"},
              {"message", {{"text", fmt::format("Not proven: {}. To tell: {}.", d.message, tell)}}},
              {"locations", {location(path, d.place)}},
              {"partialFingerprints",
               {{"ncsimFinding/v1", fingerprint(identity) + ":" + std::to_string(nth)}}}};
    if (d.accepted) json["suppressions"] = {{{"kind", "external"}}};
    return json;
}

}  // namespace

void write_sarif(std::ostream& out, std::span<const Checked> all) {
    Json notifications = Json::array();
    Json configuration = Json::array();
    std::vector<std::pair<Severity, Json>> results;
    bool all_verified = true;
    for (const Checked& checked : all) {
        const std::string path = relative_path(checked.path);
        if (!checked.failure.empty()) {
            all_verified = false;
            notifications.push_back({{"level", "error"},
                                     {"message", {{"text", "not verified: " + checked.failure}}},
                                     {"locations", {location(path)}}});
            continue;
        }
        Seen seen;
        const auto& findings = checked.verdict.findings;
        for (std::size_t i = 0; i < findings.size(); ++i) {
            results.emplace_back(findings[i].severity,
                                 result(checked, findings[i], checked.lines[i], seen));
        }
        for (const verify::Doubt& d : checked.verdict.doubts)
            results.emplace_back(Severity::Warning, result(checked, d, seen));
        for (const auto& [rule, more] : checked.verdict.unlisted) {
            notifications.push_back(
                {{"level", "warning"},
                 {"message", {{"text", fmt::format("{} more findings of {}", more, rule)}}},
                 {"locations", {location(path)}}});
        }
        for (const verify::Skipped& s : checked.verdict.skipped) {
            configuration.push_back({{"level", "note"},
                                     {"associatedRule", {{"id", s.rule}}},
                                     {"message", {{"text", s.rule + " skipped: " + s.reason}}},
                                     {"locations", {location(path)}}});
        }
    }
    if (results.size() > kMaxResults) {
        // The heaviest stay, in their order.
        std::ranges::stable_sort(results, std::greater<>{},
                                 [](const auto& r) { return static_cast<int>(r.first); });
        notifications.push_back(
            {{"level", "warning"},
             {"message",
              {{"text", fmt::format("{} results of the least weight were left out: no "
                                    "more than {} are accepted",
                                    results.size() - kMaxResults, kMaxResults)}}}});
        results.resize(kMaxResults);
    }
    Json run;
    run["tool"]["driver"] = {{"name", "ncsim"}, {"version", kVersion}, {"rules", rules_json()}};
    run["invocations"] = {{{"executionSuccessful", all_verified},
                           {"toolExecutionNotifications", std::move(notifications)},
                           {"toolConfigurationNotifications", std::move(configuration)}}};
    run["columnKind"] = "utf16CodeUnits";
    run["results"] = Json::array();
    for (auto& [severity, json] : results)
        run["results"].push_back(std::move(json));
    Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
             {"version", "2.1.0"},
             {"runs", {std::move(run)}}};
    out << to_text(log);
}

}  // namespace ncsim::report
