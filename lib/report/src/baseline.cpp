// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of findings with known findings, and the baseline file.
#include "ncsim/report/baseline.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/report/check_text.h"
#include "ncsim/verify/rule.h"

#include "fingerprint.h"
#include "json.h"
#include "shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

namespace ncsim::report {

namespace {

using verify::Finding;
using verify::Severity;

constexpr int kBaselineFormat = 1;

// Places of the part are the same within a thousandth of a millimetre, quantities within rounding.
constexpr double kSamePlace = 1e-3;
constexpr double kSameNumber = 1e-6;

// Returns the line in capitals, without its number and blanks. A long line is cut and gets a
// fingerprint.
std::string block_of(std::string_view line) {
    std::string block;
    for (const char c : line) {
        if (c == ' ' || c == '\t' || c == '\r') continue;
        block += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    const std::size_t skip = block.starts_with('/') ? 1 : 0;
    if (block.size() > skip && block[skip] == 'N') {
        const std::size_t end =
            std::min(block.find_first_not_of("0123456789", skip + 1), block.size());
        if (end > skip + 1) block.erase(skip, end - skip);
    }
    constexpr std::size_t kMost = 120;
    if (block.size() > kMost) block = block.substr(0, kMost) + "..." + fingerprint(block);
    return block;
}

// Returns `text` as a file would return it: bytes that are not UTF-8 change.
std::string round_trip_utf8(const std::string& text) {
    return Json::parse(to_line(Json(text))).get<std::string>();
}

KnownFinding known_of(const Checked& checked, const Finding& f, const std::string& line) {
    KnownFinding known;
    known.rule = f.rule;
    known.code = f.code;
    known.severity = verify::name_of(f.severity);
    known.message = round_trip_utf8(f.message);
    const auto& files = checked.verdict.files;
    if (f.place.file > 0 && f.place.file < files.size())
        known.file = round_trip_utf8(files[f.place.file]);
    known.line = f.place.span.line;
    known.block = round_trip_utf8(block_of(line));
    known.tool = f.tool;
    known.certain = f.certainty == verify::Certainty::Certain;
    known.count = f.count;
    known.goes_on = f.goes_on;
    known.quantity = f.quantity;
    if (f.row != 0) known.row = fmt::format("{:016x}", f.row);
    // For links of the machine, the box covers the whole path, so only the point counts.
    if (!f.point || !f.rule.starts_with("machine-")) known.box = f.box;
    if (f.point) known.box.add(*f.point);
    known.why = round_trip_utf8(f.accepted.value_or(""));
    return known;
}

Json to_json(const std::string& program, const KnownFinding& known) {
    Json json{{"program", program},       {"rule", known.rule},       {"severity", known.severity},
              {"message", known.message}, {"certain", known.certain}, {"count", known.count},
              {"line", known.line},       {"block", known.block}};
    if (!known.code.empty()) json["code"] = known.code;
    if (!known.file.empty()) json["file"] = known.file;
    if (known.tool != 0) json["tool"] = known.tool;
    if (known.goes_on) json["goes_on"] = true;
    if (!known.row.empty()) json["row"] = known.row;
    if (known.quantity) {
        json["quantity"] = {{"name", known.quantity->name},
                            {"value", round_value(known.quantity->value)},
                            {"unit", known.quantity->unit}};
    }
    if (!known.box.is_empty()) json["box"] = box_json(known.box);
    if (!known.why.empty()) json["why"] = known.why;
    return json;
}

Vec3 vector_from(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

// Throws: Json::exception, or std::runtime_error for an unknown key.
KnownFinding known_from(const Json& json) {
    KnownFinding known;
    for (const auto& [key, value] : json.items()) {
        if (key == "program") {
            continue;
        } else if (key == "rule") {
            value.get_to(known.rule);
        } else if (key == "code") {
            value.get_to(known.code);
        } else if (key == "severity") {
            value.get_to(known.severity);
        } else if (key == "message") {
            value.get_to(known.message);
        } else if (key == "file") {
            value.get_to(known.file);
        } else if (key == "line") {
            known.line = whole_number<std::uint32_t>(value);
        } else if (key == "block") {
            value.get_to(known.block);
        } else if (key == "tool") {
            known.tool = whole_number<int>(value);
        } else if (key == "certain") {
            value.get_to(known.certain);
        } else if (key == "count") {
            known.count = whole_number<std::uint64_t>(value);
        } else if (key == "goes_on") {
            value.get_to(known.goes_on);
        } else if (key == "row") {
            value.get_to(known.row);
        } else if (key == "quantity") {
            known.quantity = verify::Quantity{value.at("name").get<std::string>(),
                                              value.at("value").get<double>(),
                                              value.at("unit").get<std::string>()};
        } else if (key == "box") {
            known.box.add(vector_from(value.at("min")));
            known.box.add(vector_from(value.at("max")));
        } else if (key == "why") {
            value.get_to(known.why);
        } else {
            throw std::runtime_error(fmt::format("'{}' means nothing there", key));
        }
    }
    if (known.rule.empty() || known.message.empty() || known.severity.empty())
        throw std::runtime_error("rule, severity and message are required");
    return known;
}

// Returns a key for comparison: findings with different keys are never the same.
std::string name_of(const KnownFinding& f) {
    std::string name = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n", f.rule, f.code, f.severity,
                                   f.certain, f.tool, f.message, f.file);
    name += f.file.empty() ? f.block : fmt::format("{}", f.line);
    if (f.quantity) name += fmt::format("\n{}\n{}", f.quantity->name, f.quantity->unit);
    return name;
}

bool is_within(const Box& inner, const Box& outer) {
    if (inner.is_empty() || outer.is_empty()) return inner.is_empty() == outer.is_empty();
    const Vec3 room{kSamePlace, kSamePlace, kSamePlace};
    const Vec3 low = inner.min - (outer.min - room), high = outer.max + room - inner.max;
    return std::min({low.x, low.y, low.z, high.x, high.y, high.z}) >= 0.0;
}

// True if `now` is no worse than `known`.
// Requires: both have the same name and unit.
bool is_no_worse(const verify::Quantity& now, const verify::Quantity& known) {
    const double room = kSameNumber * std::max(1.0, std::abs(known.value));
    // Too low a speed is as wrong as too high a speed.
    if (now.unit == "rpm") return std::abs(now.value - known.value) <= room;
    if (verify::less_is_worse(now)) return now.value >= known.value - room;
    return now.value <= known.value + room;
}

// True if `now` is `known` or less severe.
// Requires: both have the same key.
bool is_covered(const KnownFinding& now, const KnownFinding& known) {
    if (now.quantity.has_value() != known.quantity.has_value()) return false;
    if (now.quantity && !is_no_worse(*now.quantity, *known.quantity)) return false;
    return now.row == known.row && now.count <= known.count && (!now.goes_on || known.goes_on) &&
           is_within(now.box, known.box);
}

constexpr std::size_t kNoOne = ~std::size_t{0};

// Sets the index of the known finding for each finding of `of_now`, or kNoOne. All findings have
// the same key.
void match(const std::vector<KnownFinding>& now, const std::vector<KnownFinding>& known,
           std::span<const std::size_t> of_now, std::span<const std::size_t> of_known,
           std::vector<std::size_t>& known_as) {
    std::set<std::size_t> free(of_known.begin(), of_known.end());
    // Exact matches come first, then less severe findings.
    for (const bool exactly : {true, false}) {
        for (const std::size_t i : of_now) {
            if (known_as[i] != kNoOne) continue;
            const auto found = std::ranges::find_if(free, [&](std::size_t k) {
                return is_covered(now[i], known[k]) && (!exactly || is_covered(known[k], now[i]));
            });
            if (found == free.end()) continue;
            known_as[i] = *found;
            free.erase(found);
        }
    }
    // The new finding cannot be distinguished from the known findings in the same place, so all of
    // these findings count as new.
    const auto known_before = known_as;
    for (const std::size_t i : of_now) {
        if (known_before[i] != kNoOne) continue;
        for (const std::size_t j : of_now) {
            if (known_before[j] != kNoOne && is_within(now[i].box, known[known_before[j]].box))
                known_as[j] = kNoOne;
        }
    }
}

std::vector<std::size_t> matched(const std::vector<KnownFinding>& now,
                                 const std::vector<KnownFinding>& known) {
    std::map<std::string, std::pair<std::vector<std::size_t>, std::vector<std::size_t>>> by_name;
    for (std::size_t i = 0; i < now.size(); ++i)
        by_name[name_of(now[i])].first.push_back(i);
    for (std::size_t k = 0; k < known.size(); ++k)
        by_name[name_of(known[k])].second.push_back(k);
    std::vector<std::size_t> known_as(now.size(), kNoOne);
    for (const auto& [name, both] : by_name)
        match(now, known, both.first, both.second, known_as);
    return known_as;
}

// True for findings that a baseline keeps: notes fail no program, and suppressed findings are
// accepted by a comment.
bool is_kept(const Finding& f) {
    return !f.suppressed && f.severity != Severity::Note;
}

// Returns the label of the program at the start of a message: "O0101: …" in a file with several
// programs.
std::string_view label_of(std::string_view message) {
    const std::size_t end = message.find(": ");
    const std::string_view label = message.substr(0, end == std::string_view::npos ? 0 : end);
    const bool is_number = label.size() > 1 && label[0] == 'O' &&
                           label.find_first_not_of("0123456789", 1) == std::string_view::npos;
    return is_number || label == "program 1" ? label : std::string_view();
}

// Returns the path of the program relative to the folder of the baseline.
std::string seen_from(const std::string& baseline, const std::string& program) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path folder =
        fs::absolute(fs::path(baseline), error).lexically_normal().parent_path();
    const fs::path path = fs::absolute(fs::path(program), error).lexically_normal();
    const fs::path seen = path.lexically_relative(folder);
    return round_trip_utf8((seen.empty() ? path : seen).generic_string());
}

}  // namespace

Baseline::Baseline(std::string file, const std::string& text) : file_(std::move(file)) {
    std::size_t number = 0;
    try {
        const Json json = Json::parse(text);
        if (!json.is_object() || !json.contains("ncsim-baseline"))
            throw std::runtime_error("it is no baseline of ncsim check");
        if (whole_number<int>(json.at("ncsim-baseline")) != kBaselineFormat)
            throw std::runtime_error("it was written by another version of ncsim");
        for (const Json& finding : json.at("findings")) {
            ++number;
            known_[finding.at("program").get<std::string>()].push_back(known_from(finding));
        }
    } catch (const std::exception& e) {
        const std::string where = number == 0 ? "" : fmt::format("finding {}: ", number);
        throw std::runtime_error(fmt::format("'{}': {}{}", file_, where, e.what()));
    }
}

const std::vector<KnownFinding>* Baseline::known_of(const std::string& program) const {
    const auto found = known_.find(seen_from(file_, program));
    return found == known_.end() ? nullptr : &found->second;
}

void Baseline::accept(Checked& checked, const verify::Selection& selection) const {
    checked.baseline = file_;
    const std::vector<KnownFinding>* known = known_of(checked.path);
    if (!known) return;
    verify::Verdict& verdict = checked.verdict;
    std::vector<KnownFinding> now;
    std::vector<Finding*> findings;
    for (std::size_t i = 0; i < verdict.findings.size(); ++i) {
        if (!is_kept(verdict.findings[i])) continue;
        findings.push_back(&verdict.findings[i]);
        now.push_back(report::known_of(checked, verdict.findings[i], checked.lines[i]));
    }
    const std::vector<std::size_t> known_as = matched(now, *known);
    std::vector<bool> is_found(known->size(), false);
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (known_as[i] == kNoOne) continue;
        findings[i]->accepted = (*known)[known_as[i]].why;
        is_found[known_as[i]] = true;
    }
    const auto was_asked = [&](const std::string& rule) {
        return selection.includes(rule) && !verdict.unlisted.contains(rule) &&
               std::ranges::find(verdict.skipped, rule, &verify::Skipped::rule) ==
                   verdict.skipped.end();
    };
    for (std::size_t k = 0; k < known->size(); ++k) {
        const KnownFinding& f = (*known)[k];
        const std::string_view label = label_of(f.message);
        if (!checked.program.empty() && !label.empty() && label != checked.program) continue;
        if (is_found[k] || !was_asked(f.rule)) continue;
        std::string what = f.message;
        if (f.quantity) what += ": " + verify::text_of(*f.quantity);
        checked.resolved.push_back({f.rule, f.severity, f.line, std::move(what)});
    }
}

std::string Baseline::key_of_program(const std::string& program) const {
    Json all = Json::array();
    if (const auto* known = known_of(program)) {
        for (const KnownFinding& f : *known)
            all.push_back(to_json({}, f));
    }
    return to_line(all);
}

std::map<std::string, std::size_t> Baseline::programs() const {
    const std::filesystem::path folder = std::filesystem::path(file_).parent_path();
    std::map<std::string, std::size_t> programs;
    for (const auto& [program, known] : known_)
        programs[(folder / program).lexically_normal().string()] = known.size();
    return programs;
}

Json baseline_share(const Checked& checked) {
    Json share = Json::array();
    const auto& findings = checked.verdict.findings;
    const std::string program = relative_path(checked.path);
    for (std::size_t i = 0; i < findings.size(); ++i) {
        if (is_kept(findings[i]))
            share.push_back(to_json(program, known_of(checked, findings[i], checked.lines[i])));
    }
    return share;
}

void write_baseline(std::ostream& out, const std::string& file, const Entries& all,
                    const Baseline* before) {
    std::map<std::string, std::vector<KnownFinding>> known;
    if (before) known = before->known_;
    // All programs of a file share an entry.
    std::map<std::string, std::vector<KnownFinding>> found;
    all([&](const Entry& entry) {
        if (entry.word == "not-verified") return;
        std::vector<KnownFinding>& now = found[seen_from(file, entry.path)];
        for (const Json& finding : Json::parse(entry.known))
            now.push_back(known_from(finding));
    });
    for (auto& [program, now] : found) {
        std::vector<KnownFinding>& kept = known[program];
        const std::vector<std::size_t> known_as = matched(now, kept);
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (known_as[i] != kNoOne && now[i].why.empty()) now[i].why = kept[known_as[i]].why;
        }
        kept = std::move(now);
    }
    // Each finding is on a line of its own, so changes of different findings do not conflict.
    out << "{\"ncsim-baseline\": " << kBaselineFormat << ", \"findings\": [";
    const char* comma = "";
    for (const auto& [program, findings] : known) {
        for (const KnownFinding& f : findings) {
            out << comma << '\n' << to_line(to_json(program, f));
            comma = ",";
        }
    }
    out << "\n]}\n";
}

}  // namespace ncsim::report
