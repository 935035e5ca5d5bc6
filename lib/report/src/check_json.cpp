// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as JSON.
#include "ncsim/report/check_json.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/version.h"
#include "ncsim/report/design_facts.h"
#include "ncsim/verify/rule.h"

#include "json.h"
#include "json_stream.h"
#include "shares.h"

#include <ostream>

namespace ncsim::report {

namespace {

using verify::Finding;
using verify::Severity;

Json to_json(const Checked& checked, const Finding& f) {
    Json json{{"rule", f.rule}};
    if (!checked.program.empty()) json["program"] = checked.program;
    if (!f.code.empty()) json["code"] = f.code;
    json["severity"] = verify::name_of(f.severity);
    json["category"] = verify::name_of(f.category);
    json["certain"] = f.certainty == verify::Certainty::Certain;
    json["suppressed"] = f.suppressed;
    if (f.demoted) json["demoted"] = true;
    if (f.accepted) json["accepted"] = *f.accepted;
    json["file"] = file_of(checked, f.place);
    if (f.place.span.line > 0) {
        json["line"] = f.place.span.line;
        json["column"] = f.place.span.column;
        json["last_line"] = f.last.span.line;
    }
    if (f.last_motion > 0) {
        json["first_motion"] = f.first_motion;
        json["last_motion"] = f.last_motion;
        json["tool"] = f.tool;
    }
    json["count"] = f.count;
    if (f.goes_on) json["goes_on"] = true;
    if (f.quantity) {
        json["quantity"] = {{"name", f.quantity->name},
                            {"value", round_value(f.quantity->value)},
                            {"unit", f.quantity->unit}};
    }
    if (f.point) json["point"] = vector_json(*f.point);
    if (!f.box.is_empty()) json["box"] = box_json(f.box);
    json["message"] = f.message;
    json["hint"] = f.hint;
    json["assumptions"] = f.assumptions;
    return json;
}

Json to_json(const Checked& checked, const verify::Doubt& d) {
    Json json{{"reason", d.reason}, {"message", d.message}, {"file", file_of(checked, d.place)}};
    if (!checked.program.empty()) json["program"] = checked.program;
    if (d.place.span.line > 0) {
        json["line"] = d.place.span.line;
        json["column"] = d.place.span.column;
    }
    json["count"] = d.count;
    json["accepted"] = d.accepted;
    json["fix"] = verify::find_reason(d.reason)->fix;
    return json;
}

Json to_json(const verify::Ledger& ledger) {
    return {
        {"stock_mm3", round_value(ledger.stock_mm3)},
        {"rest_mm3", round_value(ledger.rest_mm3)},
        {"removed_mm3", ledger.measured ? Json(round_value(ledger.removed_mm3)) : Json(nullptr)},
        {"feed_mm", round_value(ledger.feed_mm)},
        {"rapid_mm", round_value(ledger.rapid_mm)},
        {"air_mm", ledger.air_known ? Json(round_value(ledger.air_mm)) : Json(nullptr)},
        {"feed_seconds", rounded_json(ledger.feed_seconds)},
        {"rapid_seconds", rounded_json(ledger.rapid_seconds)},
        {"other_seconds", rounded_json(ledger.other_seconds)}};
}

Json to_json(const DesignFacts::Side& side) {
    return {{"largest_mm", round_value(side.largest_mm)},
            {"volume_mm3", rounded_json(side.volume_mm3)},
            {"regions", side.regions}};
}

Json to_json(const DesignFacts& design) {
    return {{"file", relative_path(design.path)},
            {"tolerance_mm", design.tolerance_mm},
            {"resolution_mm", round_value(design.resolution_mm)},
            {"deviation_mm", round_value(design.deviation_mm)},
            {"gouge", to_json(design.gouge)},
            {"excess", to_json(design.excess)}};
}

Json baseline_json(const Checked& checked) {
    Json json{{"file", relative_path(checked.baseline)},
              {"accepted", checked.verdict.accepted()},
              {"no_longer_found", Json::array()}};
    for (const simulation::ResolvedFinding& known : checked.resolved) {
        json["no_longer_found"].push_back({{"rule", known.rule},
                                           {"severity", known.severity},
                                           {"line", known.line},
                                           {"message", known.what}});
    }
    return json;
}

Json to_json(const Checked& checked) {
    Json json{{"file", relative_path(checked.path)}};
    if (!checked.program.empty()) json["program"] = checked.program;
    if (!checked.failure.empty()) {
        json["verdict"] = "not-verified";
        json["failure"] = checked.failure;
        return json;
    }
    const verify::Verdict& v = checked.verdict;
    json["verdict"] = checked.word;
    json["simulated"] = checked.simulated;
    if (!checked.not_simulated.empty()) json["not_simulated"] = checked.not_simulated;
    if (!checked.settings.empty()) json["settings"] = relative_path(checked.settings);
    if (!checked.baseline.empty()) json["baseline"] = baseline_json(checked);
    if (!checked.stock.empty()) json["stock"] = checked.stock;
    if (!checked.stock_box.is_empty()) json["stock_mm"] = box_json(checked.stock_box);
    if (!checked.time.empty()) json["time"] = checked.time;
    if (checked.seconds) json["seconds"] = round_value(*checked.seconds);
    json["moves"] = checked.moves;
    json["counts"] = {{"error", v.count(Severity::Error)},
                      {"warning", v.count(Severity::Warning)},
                      {"note", v.count(Severity::Note)},
                      {"suppressed", v.suppressed()},
                      {"doubt", v.open_doubts()}};
    json["doubts"] = Json::array();
    for (const verify::Doubt& d : v.doubts)
        json["doubts"].push_back(to_json(checked, d));
    json["findings"] = Json::array();
    for (const Finding& f : v.findings)
        json["findings"].push_back(to_json(checked, f));
    json["unlisted"] = Json::object();
    for (const auto& [rule, more] : v.unlisted)
        json["unlisted"][rule] = more;
    json["skipped"] = Json::array();
    for (const verify::Skipped& s : v.skipped)
        json["skipped"].push_back(
            {{"rule", s.rule}, {"reason", s.reason}, {"deselected", s.deselected}});
    json["rules"] = {{"known", verify::rules().size()},
                     {"selected", verify::rules().size() - v.deselected()}};
    json["demoted"] = Json::array();
    for (const verify::Demotion& d : v.demotions)
        json["demoted"].push_back(
            {{"rule", d.rule}, {"severity", verify::name_of(d.severity)}, {"by", d.by}});
    if (checked.simulated) json["ledger"] = to_json(v.ledger);
    if (checked.design) json["design"] = to_json(*checked.design);
    return json;
}

}  // namespace

Json check_json_share(const Checked& checked) {
    return to_json(checked);
}

void write_check_json(std::ostream& out, const Entries& all, const Scope& scope) {
    JsonStream json(out);
    json.begin_object();
    json.value("version", 2);
    json.value("ncsim", kVersion);
    if (!scope.job.empty()) {
        json.value("job", relative_path(scope.job));
        json.value("job_verdict", worst_verdict(all));
    }
    json.begin_array("programs");
    all([&](const Entry& entry) { json.element(Json::parse(entry.json)); });
    json.end();
    json.begin_array("subprograms");
    for (const CalledFile& file : scope.called)
        json.element(
            {{"file", relative_path(file.path)}, {"judged_with", relative_path(file.caller)}});
    json.end();
    json.begin_array("left_out");
    for (const ExcludedEntry& file : scope.excluded)
        json.element({{"file", relative_path(file.path)}, {"why", file.why}});
    json.end();
    json.end();
}

}  // namespace ncsim::report
