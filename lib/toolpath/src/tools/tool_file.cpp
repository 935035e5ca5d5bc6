// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readers of tool tables: LinuxCNC, CSV, and JSON of CAMotics, Fusion and Kiri:Moto.
#include "ncsim/toolpath/tool_file.h"

#include "ncsim/base/angles.h"

#include "tools/comment_text.h"
#include "tools/csv_tools.h"
#include "tools/tool_collector.h"
#include "tools/tool_messages.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace ncsim::toolpath {

namespace {

using Json = nlohmann::json;

constexpr double kMostTools = 1e8;

// --- LinuxCNC ---

// Reads a line: T1 P1 Z0.511 D0.125 ;1/8 end mill. False if the line has another form.
bool read_table_line(std::string_view line, std::uint32_t number, double unit, Collector& out) {
    const std::size_t semicolon = line.find(';');
    const std::string words = uppercase(line.substr(0, semicolon));
    const std::string_view remark = semicolon == std::string_view::npos
                                        ? std::string_view()
                                        : trimmed(line.substr(semicolon + 1));
    std::string_view rest = trimmed(words);
    if (rest.empty()) return true;
    ToolSpec spec;
    Vec3 offset;
    bool has_tool = false;
    bool has_pocket = false;
    std::optional<double> diameter;
    while (!rest.empty()) {
        const char letter = rest.front();
        if (rest.size() < 2 || !text::is_letter(letter)) return false;
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        const text::Quantity value = text::quantity_at(rest, 1).value_or(text::Quantity{});
        if (value.end == 0 || value.end > end || value.unit != text::Unit::None) return false;
        switch (letter) {
            case 'T':
                if (value.value < 0 || value.value >= kMostTools) return false;
                spec.number = static_cast<int>(value.value);
                has_tool = true;
                break;
            case 'P': has_pocket = true; break;
            case 'D': diameter = unit * value.value; break;
            case 'X': offset.x = unit * value.value; break;
            case 'Y': offset.y = unit * value.value; break;
            case 'Z': offset.z = unit * value.value; break;
            default: break;  // further axes; angles and orientation of lathe tools
        }
        rest = trimmed(rest.substr(end));
    }
    if (!has_tool || !has_pocket) return false;
    if (diameter && *diameter > 0) spec.diameter = diameter;
    take_kind(remark, spec);
    spec.description = std::string(remark);
    const auto length = static_cast<std::uint32_t>(std::min<std::size_t>(line.size(), 1000));
    out.keep(std::move(spec), offset, {number, 1, length}, std::string(trimmed(line)));
    return true;
}

void read_table(const gcode::SourceFile& file, double unit, ToolFile& result) {
    Collector out(result.tools, result.diagnostics, file.name);
    std::uint32_t number = 0;
    bool any = false;
    for (std::string_view line : text::split(file.text, '\n')) {
        ++number;
        line = trimmed(line);
        if (line.empty() || line.front() == ';') continue;
        if (!read_table_line(line, number, unit, out)) {
            return out.add_remark(any ? Message::NoTableLine : Message::NoTable, {number, 1, 0});
        }
        any = true;
    }
    if (any) {
        result.format = "LinuxCNC tool table";
    } else {
        out.add_remark(Message::TableEmpty, {1, 1, 0});
    }
}

// --- JSON ---

std::optional<double> number_of(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number()) return std::nullopt;
    const auto value = found->get<double>();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> positive_of(const Json& json, const char* key) {
    const auto value = number_of(json, key);
    return value && *value > 0 ? value : std::nullopt;
}

std::string text_of(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

const Json& member(const Json& json, const char* key) {
    static const Json nothing = Json::object();
    const auto found = json.find(key);
    return found != json.end() && found->is_object() ? *found : nothing;
}

std::optional<double> scaled(std::optional<double> value, double factor) {
    if (value) *value *= factor;
    return value;
}

int tool_number(std::optional<double> number) {
    const bool good = number && *number >= 1 && *number < kMostTools;
    return good ? static_cast<int>(*number) : 0;
}

bool is_imperial(const std::string& units) {
    const std::string upper = uppercase(units);
    return upper == "IMPERIAL" || upper == "INCH" || upper == "INCHES" || upper == "IN";
}

// Returns the included angle, degrees, of a cone of this diameter and height. Rounding to 1e-9
// restores whole numbers.
double angle_of_cone(double diameter, double height) {
    const double degrees = 2 * angle_of(height, diameter / 2);
    return std::round(degrees * 1e9) / 1e9;
}

void read_camotics_tool(int number, const Json& json, Collector& out) {
    const double unit = is_imperial(text_of(json, "units")) ? 25.4 : 1.0;
    ToolSpec spec;
    spec.number = number;
    spec.diameter = scaled(positive_of(json, "diameter"), unit);
    spec.length = scaled(positive_of(json, "length"), unit);
    spec.description = text_of(json, "description");
    const std::string shape = uppercase(text_of(json, "shape"));
    const auto unknown = [&] {
        out.add_remark(Message::ShapeUnknown, {},
                       {std::to_string(number), text::quoted(text_of(json, "shape"))});
    };
    if (shape.empty() || shape == "CYLINDRICAL") {
        spec.kind = ToolKind::FlatEndMill;
    } else if (shape == "BALLNOSE") {
        spec.kind = ToolKind::BallEndMill;
    } else if ((shape == "CONICAL" || shape == "SNUBNOSE") && spec.diameter && spec.length) {
        spec.kind = ToolKind::VCutter;
        const double tip =
            shape == "SNUBNOSE" ? unit * positive_of(json, "snub_diameter").value_or(0.0) : 0.0;
        if (tip > 0) spec.tip_diameter = std::min(tip, *spec.diameter);
        spec.angle = angle_of_cone(*spec.diameter - spec.tip_diameter.value_or(0.0), *spec.length);
    } else {
        return unknown();
    }
    out.keep(std::move(spec), {}, {}, text_of(json, "description"));
}

bool read_camotics(const Json& json, ToolFile& result, Collector& out) {
    const auto tools = json.find("tools");
    const bool by_number =
        tools != json.end() && tools->is_object() &&
        std::all_of(tools->begin(), tools->end(), [](const Json& t) { return t.is_object(); });
    if (!by_number && !json.contains("workpiece") && !json.contains("resolution-mode"))
        return false;
    result.format = "CAMotics project";
    const std::string units = text_of(json, "units");
    if (!units.empty()) result.inches = is_imperial(units);
    if (by_number) {
        for (const auto& [key, tool] : tools->items()) {
            const auto number = text::quantity_at(key, 0);
            read_camotics_tool(
                tool_number(number && number->end == key.size() ? std::optional(number->value)
                                                                : number_of(tool, "number")),
                tool, out);
        }
    }
    const Json& workpiece = member(json, "workpiece");
    const Json& bounds = member(workpiece, "bounds");
    const auto corner = [&bounds](const char* key) -> std::optional<Vec3> {
        const auto found = bounds.find(key);
        if (found == bounds.end() || !found->is_array() || found->size() != 3) return std::nullopt;
        Vec3 v;
        for (int axis = 0; axis < 3; ++axis) {
            const Json& value = (*found)[static_cast<std::size_t>(axis)];
            if (!value.is_number() || !(std::abs(value.get<double>()) < 1e6)) return std::nullopt;
            v[axis] = value.get<double>();
        }
        return v;
    };
    const auto min = corner("min");
    const auto max = corner("max");
    // An automatic workpiece is only CAMotics' own guess.
    const auto automatic = workpiece.find("automatic");
    const bool is_automatic =
        automatic != workpiece.end() && automatic->is_boolean() && automatic->get<bool>();
    if (min && max && !is_automatic) {
        Box box;
        box.add(*min), box.add(*max);
        const Vec3 size = box.size();
        if (size.x > 0 && size.y > 0 && size.z > 0) {
            result.stock = StockEntry{{box}, ValueSource::Table, {}, "the workpiece"};
        }
    }
    return true;
}

std::optional<ToolKind> fusion_kind(const std::string& type) {
    static constexpr std::pair<std::string_view, ToolKind> kKinds[] = {
        {"FLAT END MILL", ToolKind::FlatEndMill},
        {"BALL END MILL", ToolKind::BallEndMill},
        {"BULL NOSE END MILL", ToolKind::BullNoseEndMill},
        {"FACE MILL", ToolKind::FaceMill},
        {"CHAMFER MILL", ToolKind::ChamferMill},
        {"TAPERED MILL", ToolKind::TaperedEndMill},
        {"DRILL", ToolKind::Drill},
        {"SPOT DRILL", ToolKind::VCutter},
        {"CENTER DRILL", ToolKind::VCutter},
        {"COUNTER SINK", ToolKind::Countersink},
        {"REAMER", ToolKind::Reamer},
        {"COUNTER BORE", ToolKind::FlatEndMill},
        {"BORING BAR", ToolKind::BoringBar},
        {"BORING HEAD", ToolKind::BoringBar},
        {"THREAD MILL", ToolKind::ThreadMill},
        {"SLOT MILL", ToolKind::SlotMill},
        {"DOVETAIL MILL", ToolKind::DovetailMill},
        {"LOLLIPOP MILL", ToolKind::LollipopMill},
        {"TAP RIGHT HAND", ToolKind::Tap},
        {"TAP LEFT HAND", ToolKind::Tap},
        {"RADIUS MILL", ToolKind::CornerRoundingMill},
        {"ENGRAVE", ToolKind::VCutter},
        {"ENGRAVER", ToolKind::VCutter}};
    const std::string upper = uppercase(type);
    for (const auto& [name, kind] : kKinds) {
        if (name == upper) return kind;
    }
    return std::nullopt;
}

// Reads {"segments": [{"height": 5, "lower-diameter": 6, "upper-diameter": 10}, …]}.
std::vector<ToolSegment> segments_of(const Json& json, double unit) {
    std::vector<ToolSegment> segments;
    const auto list = json.find("segments");
    if (list == json.end() || !list->is_array()) return segments;
    constexpr std::size_t kMost = 100;
    for (const Json& step : *list) {
        if (!step.is_object() || segments.size() == kMost) break;
        const auto height = positive_of(step, "height");
        const auto lower = positive_of(step, "lower-diameter");
        const auto upper = positive_of(step, "upper-diameter");
        if (!height || (!lower && !upper)) continue;
        segments.push_back({unit * lower.value_or(upper.value_or(0.0)),
                            unit * upper.value_or(lower.value_or(0.0)), unit * *height});
        const ToolSegment& s = segments.back();
        if (!text::is_sane_length(s.height) || !text::is_sane_length(s.lower_diameter) ||
            !text::is_sane_length(s.upper_diameter)) {
            segments.pop_back();
        }
    }
    return segments;
}

// Reads the parts above the flutes: a shoulder at most as thick as the cutter, and a shaft up to
// the holder.
void read_fusion_assembly(const Json& json, const Json& g, double unit, ToolSpec& spec) {
    spec.shank_diameter = scaled(positive_of(g, "SFDM"), unit);
    spec.stick_out = scaled(positive_of(g, "LB"), unit);
    const auto shoulder = scaled(positive_of(g, "shoulder-length"), unit);
    if (shoulder && spec.length && *shoulder > *spec.length && spec.shank_diameter) {
        spec.neck_diameter = scaled(positive_of(g, "shoulder-diameter"), unit);
        if (!spec.neck_diameter && !is_undercutting(*spec.kind)) spec.neck_diameter = spec.diameter;
        if (spec.neck_diameter) spec.neck_length = *shoulder - *spec.length;
    }
    spec.shaft = segments_of(member(json, "shaft"), unit);
    spec.holder = segments_of(member(json, "holder"), unit);
}

void read_fusion_tool(const Json& json, Collector& out) {
    const int number = tool_number(number_of(member(json, "post-process"), "number"));
    const std::string type = text_of(json, "type");
    if (number == 0 || uppercase(type) == "HOLDER" || uppercase(type) == "PROBE") return;
    const double unit = is_imperial(text_of(json, "unit")) ? 25.4 : 1.0;
    const Json& g = member(json, "geometry");
    ToolSpec spec;
    spec.number = number;
    spec.kind = fusion_kind(type);
    spec.description = text_of(json, "description");
    if (!spec.kind) {
        return out.add_remark(Message::FusionTypeUnknown, {},
                              {std::to_string(number), text::quoted(type)});
    }
    spec.diameter = scaled(positive_of(g, "DC"), unit);
    spec.corner_radius = scaled(positive_of(g, "RE"), unit);
    spec.length = scaled(positive_of(g, "LCF"), unit);
    spec.tip_diameter = scaled(positive_of(g, "tip-diameter"), unit);
    if (spec.kind == ToolKind::Tap) {
        spec.pitch = scaled(positive_of(g, "TP"), unit);
        spec.left_hand = uppercase(type) == "TAP LEFT HAND";
    }
    if (spec.kind == ToolKind::Drill) spec.angle = positive_of(g, "SIG");
    if (is_conical(spec.kind)) {
        spec.angle = positive_of(g, "SIG");
        if (!spec.angle) spec.angle = scaled(positive_of(g, "TA"), 2.0);
        if (!spec.angle) spec.angle = positive_of(g, "tip-angle");
    }
    if (spec.kind == ToolKind::TaperedEndMill) {
        spec.taper = positive_of(g, "TA");
        spec.tip_diameter.reset();
    }
    if (spec.kind == ToolKind::DovetailMill) spec.taper = positive_of(g, "TA");
    if (spec.kind == ToolKind::FlatEndMill) spec.corner_radius.reset();
    read_fusion_assembly(json, g, unit, spec);
    out.keep(
        std::move(spec), {}, {},
        type + (text_of(json, "description").empty() ? "" : ", ") + text_of(json, "description"));
}

void read_kiri_tool(const Json& json, Collector& out) {
    const auto metric = json.find("metric");
    const bool is_metric = metric == json.end() || !metric->is_boolean() || metric->get<bool>();
    const double unit = is_metric ? 1.0 : 25.4;
    const std::string type = uppercase(text_of(json, "type"));
    ToolSpec spec;
    spec.number = tool_number(number_of(json, "number"));
    spec.description = text_of(json, "name");
    spec.diameter = scaled(positive_of(json, "flute_diam"), unit);
    spec.length = scaled(positive_of(json, "flute_len"), unit);
    spec.shank_diameter = scaled(positive_of(json, "shaft_diam"), unit);
    spec.shank_length = scaled(positive_of(json, "shaft_len"), unit);
    if (type == "BALLMILL") {
        spec.kind = ToolKind::BallEndMill;
    } else if (type == "ENDMILL") {
        spec.kind = ToolKind::FlatEndMill;
    } else if (type == "DRILL") {
        spec.kind = ToolKind::Drill;
    } else if (type == "TAPERMILL" && spec.diameter && spec.length) {
        spec.kind = ToolKind::VCutter;
        const double tip = unit * positive_of(json, "taper_tip").value_or(0.0);
        if (tip > 0) spec.tip_diameter = std::min(tip, *spec.diameter);
        spec.angle = angle_of_cone(*spec.diameter - tip, *spec.length);
    } else {
        return out.add_remark(Message::TypeUnknown, {},
                              {std::to_string(spec.number), text::quoted(text_of(json, "type"))});
    }
    if (spec.number == 0) return;
    out.keep(std::move(spec), {}, {}, text_of(json, "name"));
}

gcode::SourceSpan place_of(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto lines = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
    return {lines + 1, static_cast<std::uint32_t>(before.size() - start + 1), 1};
}

void read_json(const gcode::SourceFile& file, ToolFile& result) {
    Collector out(result.tools, result.diagnostics, file.name);
    Json json;
    try {
        json = Json::parse(file.text);
    } catch (const Json::parse_error& e) {
        return out.add_remark(Message::JsonBroken,
                              place_of(file.text, e.byte > 0 ? e.byte - 1 : 0));
    } catch (const Json::exception&) {
        return out.add_remark(Message::JsonNumber, {1, 1, 0});
    }
    const Json& list = json.is_object() && json.contains("data") ? json["data"] : json;
    const bool is_list =
        list.is_array() && !list.empty() &&
        std::all_of(list.begin(), list.end(), [](const Json& tool) { return tool.is_object(); });
    if (is_list && list.front().contains("geometry")) {
        result.format = "Fusion tool library";
        for (const Json& tool : list)
            read_fusion_tool(tool, out);
    } else if (is_list && list.front().contains("flute_diam")) {
        result.format = "Kiri:Moto tools";
        for (const Json& tool : list)
            read_kiri_tool(tool, out);
    } else if (!json.is_object() || !read_camotics(json, result, out)) {
        out.add_remark(Message::JsonUnknown, {1, 1, 0});
    }
}

}  // namespace

ToolFile read_tool_file(const gcode::SourceFile& file, bool machine_inches) {
    ToolFile result;
    const std::size_t first = file.text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    const char opening = first == std::string::npos ? '\0' : file.text[first];
    if (opening == '{' || opening == '[') {
        read_json(file, result);
        if (result.stock) result.stock->file = file.name;
    } else if (is_csv_table(file.text)) {
        Collector out(result.tools, result.diagnostics, file.name);
        read_csv_table(file, machine_inches ? 25.4 : 1.0, out);
        if (result.tools.empty() && result.diagnostics.empty())
            out.add_remark(Message::TableEmpty, {1, 1, 0});
        result.format = "CSV tool table";
    } else {
        read_table(file, machine_inches ? 25.4 : 1.0, result);
    }
    return result;
}

}  // namespace ncsim::toolpath
