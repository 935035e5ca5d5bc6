// SPDX-License-Identifier: GPL-3.0-or-later
//
// Explains a block as text and JSON.
#include "ncsim/report/explanation.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/report/length_unit.h"
#include "ncsim/verify/finding.h"
#include "ncsim/verify/machining_time.h"

#include "append.h"
#include "json.h"
#include "motion_json.h"
#include "plain_number.h"

#include <fmt/format.h>

#include <string_view>

namespace ncsim::report {

namespace {

constexpr std::string_view kLetters = "XYZABCUVW";

bool is_known(const gcode::MachineState& s, std::size_t axis) {
    return axis > gcode::kZ || (s.known[axis] && !s.of_machine[axis] && !s.relative[axis]);
}

// "X1 Y? Z-2 A90": X, Y and Z, and further axes that are not 0 before or after the block.
std::string position_text(const Explanation& e, const gcode::MachineState& s) {
    const gcode::Axes position = s.programmed_position();
    std::string text;
    for (std::size_t i = 0; i < position.size(); ++i) {
        if (i > gcode::kZ && e.before.position[i] == 0.0 && e.after.position[i] == 0.0) continue;
        if (i > 0) text += ' ';
        text += kLetters[i];
        text += is_known(s, i) ? plain_number(position[i]) : "?";
    }
    return text;
}

std::string setter_text(const Explanation& e, std::size_t group) {
    const Explanation::Setter& by = e.set_by[group];
    if (e.is_changed[group]) return "this block";
    if (by.line == 0) return "as at the start";
    return by.file == e.file ? fmt::format("line {}", by.line)
                             : fmt::format("{}:{}", printable_path(by.file), by.line);
}

std::string motion_text(const gcode::Motion& motion) {
    if (const auto* dwell = std::get_if<gcode::Dwell>(&motion.action))
        return fmt::format("waits {} s", plain_number(dwell->seconds));
    if (const auto* change = std::get_if<gcode::ToolChange>(&motion.action))
        return fmt::format("changes to T{}", change->tool);
    const gcode::Position& to = *gcode::end_of(motion);
    std::string text(name_of(motion.kind));
    if (std::holds_alternative<gcode::Arc>(motion.action)) text += " arc";
    if (std::holds_alternative<gcode::Spline>(motion.action)) text += " spline";
    append(text, " to X{} Y{} Z{} mm", plain_number(to.x.mm()), plain_number(to.y.mm()),
           plain_number(to.z.mm()));
    for (const auto& [letter, angle] : {std::pair{'A', to.a}, {'B', to.b}, {'C', to.c}}) {
        if (angle.degrees() != 0.0) append(text, " {}{}", letter, plain_number(angle.degrees()));
    }
    return text;
}

void add_row(std::string& text, std::string_view name, std::string_view value,
             std::string_view from = {}) {
    append(text, "  {:<15}{}", name, value);
    if (!from.empty()) append(text, "  [{}]", from);
    text += '\n';
}

void add_motions(std::string& text, const Explanation& e, LengthUnit unit) {
    for (const gcode::Motion& motion : e.motions)
        add_row(text, "moves", in_unit(motion_text(motion), unit));
    if (e.motion_count > e.motions.size())
        add_row(text, "moves", fmt::format("{} more", e.motion_count - e.motions.size()));
    if (e.motions.empty()) return add_row(text, "moves", "none");
    const verify::Distances& d = e.distances;
    std::string path =
        in_unit(fmt::format("{:.6g} mm at feed, {:.6g} mm rapid", d.feed_mm, d.rapid_mm), unit);
    if (const auto seconds = time_of(d).total()) append(path, ", {:.3g} s", *seconds);
    add_row(text, "path", path);
    add_row(text, "removes",
            e.removed_mm3 ? in_unit(fmt::format("{:.6g} mm3", *e.removed_mm3), unit)
                          : "not known: " + e.not_simulated);
}

Json position_json(const gcode::MachineState& s) {
    const gcode::Axes position = s.programmed_position();
    Json json = Json::object();
    for (std::size_t i = 0; i < position.size(); ++i) {
        const std::string name(1, static_cast<char>(kLetters[i] + ('a' - 'A')));
        if (i > gcode::kZ && position[i] == 0.0) continue;
        json[name] = is_known(s, i) ? Json(round_value(position[i])) : Json();
    }
    return json;
}

}  // namespace

std::string text_of(const Explanation& e) {
    const std::string file = printable_path(e.file);
    std::string text = fmt::format("{}:{}: {}\n", file, e.line, one_line(e.text));
    if (e.executions == 0) return text + "  not executed\n";
    const LengthUnit unit = e.after.inches ? LengthUnit::Inch : LengthUnit::Millimetre;
    if (e.executions > 1)
        add_row(text, "executed", fmt::format("{} times; modes after the first", e.executions));
    const std::string_view name = name_of(unit);
    add_row(text, "position", fmt::format("{} {}", position_text(e, e.after), name));
    add_row(text, "  before", fmt::format("{} {}", position_text(e, e.before), name));
    if (const auto& p = e.machine_position) {
        add_row(text, "in the machine",
                fmt::format("X{} Y{} Z{} {}", plain_number((*p)[0]), plain_number((*p)[1]),
                            plain_number((*p)[2]), name));
    } else {
        add_row(text, "in the machine", "not known");
    }
    add_motions(text, e, unit);
    for (std::size_t i = 0; i < kModeGroups; ++i) {
        const auto group = static_cast<ModeGroup>(i);
        add_row(text, name_of(group), one_line(text_of(group, e.after, e.has_codes)),
                setter_text(e, i));
        if (group == ModeGroup::Tool && !e.tool.empty()) {
            add_row(text, "  shape", one_line(tool_in_unit(e.tool, unit)), one_line(e.tool_source));
        }
    }
    for (const std::string& assumption : e.assumptions)
        add_row(text, "assumed", one_line(assumption));
    for (const gcode::Diagnostic& d : e.diagnostics)
        add_row(text, verify::name_of(d.severity), one_line(d.message));
    return text;
}

std::string json_of(const Explanation& e) {
    Json json{{"ncsim", std::string(kVersion)}, {"program", printable_json(e.program)},
              {"file", printable_json(e.file)}, {"line", e.line},
              {"text", printable_json(e.text)}, {"executions", e.executions}};
    if (e.executions == 0) return to_text(json);
    json["unit"] = e.after.inches ? "inch" : "mm";
    json["position"] = {{"before", position_json(e.before)}, {"after", position_json(e.after)}};
    json["machine_position"] = nullptr;
    if (const auto& p = e.machine_position) {
        json["machine_position"] = {
            {"x", round_value((*p)[0])}, {"y", round_value((*p)[1])}, {"z", round_value((*p)[2])}};
    }
    json["modes"] = Json::array();
    for (std::size_t i = 0; i < kModeGroups; ++i) {
        const auto group = static_cast<ModeGroup>(i);
        Json mode{{"name", std::string(name_of(group))},
                  {"value", text_of(group, e.after, e.has_codes)},
                  {"changed", e.is_changed[i]},
                  {"set_by", nullptr}};
        if (e.set_by[i].line > 0) {
            mode["set_by"] = {{"file", printable_json(e.set_by[i].file)},
                              {"line", e.set_by[i].line}};
        }
        json["modes"].push_back(std::move(mode));
    }
    json["tool"] = nullptr;
    if (!e.tool.empty())
        json["tool"] = {{"description", e.tool}, {"source", printable_json(e.tool_source)}};
    json["motion_count"] = e.motion_count;
    json["motions"] = Json::array();
    for (const gcode::Motion& motion : e.motions)
        json["motions"].push_back(to_json(motion));
    json["feed_mm"] = round_value(e.distances.feed_mm);
    json["rapid_mm"] = round_value(e.distances.rapid_mm);
    const auto seconds = time_of(e.distances).total();
    json["seconds"] = seconds ? Json(round_value(*seconds)) : Json();
    json["removed_mm3"] = e.removed_mm3 ? Json(round_value(*e.removed_mm3)) : Json();
    if (!e.not_simulated.empty()) json["not_simulated"] = printable_json(e.not_simulated);
    json["assumptions"] = e.assumptions;
    json["findings"] = findings_json(e.diagnostics);
    return to_text(json);
}

}  // namespace ncsim::report
