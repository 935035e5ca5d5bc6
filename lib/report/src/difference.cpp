// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text and JSON of the comparison of two programs.
#include "ncsim/report/difference.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/report/describe.h"

#include "append.h"
#include "json.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <utility>

namespace ncsim::report {

namespace {

std::string volume(double mm3, LengthUnit unit) {
    return in_unit(fmt::format("{:.6g} mm3", mm3), unit);
}

void put_side(std::string& text, const OneSidedMaterial& side, const std::string& has,
              const std::string& cuts, LengthUnit unit) {
    constexpr std::size_t kShown = 10;
    append(text, "only in {}: {}\n", has, volume(side.volume_mm3, unit));
    for (std::size_t i = 0; i < side.regions.size() && i < kShown; ++i) {
        const verify::Region& r = side.regions[i];
        append(text, "  {}, cut by {}:{}\n    within {}\n", volume(r.volume_mm3, unit), cuts,
               lines_text(r.lines), in_unit(describe(r.box), unit));
    }
    if (side.regions.size() > kShown) {
        append(text, "  and {} smaller regions\n", side.regions.size() - kShown);
    }
}

void put_runs(std::string& text, const char* sign, const std::vector<ProcessDifference::Run>& runs,
              LengthUnit unit) {
    constexpr std::size_t kShown = 5;
    for (std::size_t i = 0; i < runs.size() && i < kShown; ++i) {
        append(text, "  {} {}:{}: {}\n", sign, printable_path(runs[i].file), runs[i].line,
               in_unit(runs[i].condition, unit));
    }
    if (runs.size() > kShown) append(text, "  {} and {} more\n", sign, runs.size() - kShown);
}

Json to_json(const std::vector<ProcessDifference::Run>& runs) {
    Json json = Json::array();
    for (const ProcessDifference::Run& run : runs) {
        json.push_back(
            {{"file", relative_path(run.file)}, {"line", run.line}, {"condition", run.condition}});
    }
    return json;
}

Json to_json(const OneSidedMaterial& side, const std::string& cut_by) {
    Json json{{"volume_mm3", round_value(side.volume_mm3)}, {"regions", Json::array()}};
    for (const verify::Region& r : side.regions) {
        Json lines = Json::array();
        for (const verify::LineRange& range : r.lines) {
            const bool main = range.file == 0 || range.file >= side.files.size();
            lines.push_back({{"file", main ? relative_path(cut_by) : side.files[range.file]},
                             {"first", range.first},
                             {"last", range.last}});
        }
        json["regions"].push_back({{"volume_mm3", round_value(r.volume_mm3)},
                                   {"box", box_json(r.box)},
                                   {"lines", std::move(lines)}});
    }
    return json;
}

Json to_json(const Difference& d) {
    Json json;
    if (!d.set_up.empty()) json["set_up"] = d.set_up;
    json.update({{"old", relative_path(d.old_name)},
                 {"new", relative_path(d.new_name)},
                 {"differs", d.differs},
                 {"tolerance_mm3", d.tolerance_mm3},
                 {"same_motions", d.same_motions},
                 {"old_mm3", round_value(d.old_mm3)},
                 {"new_mm3", round_value(d.new_mm3)},
                 {"only_in_old", to_json(d.only_old, d.new_name)},
                 {"only_in_new", to_json(d.only_new, d.old_name)},
                 {"process",
                  {{"differs", d.process.differs()},
                   {"only_in_old", to_json(d.process.only_old)},
                   {"only_in_new", to_json(d.process.only_new)}}}});
    if (!d.stocks.empty()) json["stocks"] = d.stocks;
    return json;
}

}  // namespace

std::string text_of(const Difference& d, LengthUnit unit) {
    std::string text;
    if (!d.set_up.empty()) append(text, "{}\n", one_line(d.set_up));
    const std::string old_name = printable_path(d.old_name);
    const std::string new_name = printable_path(d.new_name);
    if (!d.stocks.empty()) append(text, "{}\n", one_line(in_unit(d.stocks, unit)));
    if (d.same_motions) {
        text += "both programs make the same motions with the same tools\n";
    } else {
        put_side(text, d.only_old, old_name, new_name, unit);
        put_side(text, d.only_new, new_name, old_name, unit);
    }
    if (d.process.differs()) {
        text += "feeds, speeds, coolant, tools or dwells differ\n";
        put_runs(text, "-", d.process.only_old, unit);
        put_runs(text, "+", d.process.only_new, unit);
    }
    append(text, "{}: {}; {}: {}: {}\n", old_name, volume(d.old_mm3, unit), new_name,
           volume(d.new_mm3, unit), d.differs ? "the parts differ" : "the same part");
    return text;
}

void write_differences(std::ostream& out, const std::vector<Difference>& differences) {
    Json json{{"version", 1}, {"ncsim", kVersion}};
    if (differences.size() == 1) {
        json.update(to_json(differences.front()));
    } else {
        json["differs"] = std::ranges::any_of(differences, &Difference::differs);
        json["set_ups"] = Json::array();
        for (const Difference& d : differences)
            json["set_ups"].push_back(to_json(d));
    }
    out << to_text(json);
}

}  // namespace ncsim::report
