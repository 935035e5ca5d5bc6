// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions as JSON.
#include "motion_json.h"

#include <cmath>
#include <string>
#include <variant>

namespace ncsim::report {

namespace {

// Rounds to 1e-9 mm, as in the text of motions.
double round_mm(gcode::Length length) {
    const double mm = length.mm();
    return std::abs(mm) < 1e6 ? std::round(mm * 1e9) / 1e9 + 0.0 : mm;
}

Json to_json(const gcode::Position& p) {
    Json json{{"x", round_mm(p.x)}, {"y", round_mm(p.y)}, {"z", round_mm(p.z)}};
    const auto more = [&json](const char* name, double value) {
        if (value != 0.0) json[name] = value;
    };
    more("a", p.a.degrees());
    more("b", p.b.degrees());
    more("c", p.c.degrees());
    more("u", round_mm(p.u));
    more("v", round_mm(p.v));
    more("w", round_mm(p.w));
    return json;
}

const char* plane_name(gcode::Plane plane) {
    switch (plane) {
        case gcode::Plane::XY: return "XY";
        case gcode::Plane::ZX: return "ZX";
        case gcode::Plane::YZ: return "YZ";
        case gcode::Plane::UV: return "UV";
        case gcode::Plane::WU: return "WU";
        case gcode::Plane::VW: break;
    }
    return "VW";
}

const char* feed_mode_name(gcode::FeedMode mode) {
    switch (mode) {
        case gcode::FeedMode::PerMinute: return "per_minute";
        case gcode::FeedMode::InverseTime: return "inverse_time";
        case gcode::FeedMode::PerRevolution: break;
    }
    return "per_revolution";
}

struct WhatJson {
    Json& json;

    void operator()(const gcode::Linear& line) const {
        json["what"] = "line";
        json["from"] = to_json(line.from);
        json["to"] = to_json(line.to);
    }
    void operator()(const gcode::Arc& arc) const {
        json["what"] = "arc";
        json["from"] = to_json(arc.from);
        json["to"] = to_json(arc.to);
        json["plane"] = plane_name(arc.plane);
        json["centre"] = {round_mm(arc.centre_1), round_mm(arc.centre_2)};
        json["turns"] = arc.turns;
        if (!arc.tilted) return;
        json["tilted"] = {{"origin", arc.tilted->origin}, {"rows", arc.tilted->rows}};
    }
    void operator()(const gcode::Spline& spline) const {
        json["what"] = "spline";
        json["from"] = to_json(spline.from);
        json["to"] = to_json(spline.to);
        json["order"] = spline.order;
        for (const auto& p : spline.control_points) {
            json["control_points"].push_back({round_mm(p.x), round_mm(p.y), p.weight});
        }
        json["knots"] = spline.knots;
    }
    void operator()(const gcode::Dwell& dwell) const {
        json["what"] = "dwell";
        json["seconds"] = dwell.seconds;
    }
    void operator()(const gcode::ToolChange& change) const {
        json["what"] = "tool_change";
        json["tool"] = change.tool;
        json["at"] = to_json(change.at);
    }
};

}  // namespace

Json to_json(const gcode::Motion& motion) {
    Json json{{"line", motion.span.line}};
    if (motion.file != 0) json["file"] = motion.file;
    std::visit(WhatJson{json}, motion.action);
    if (!gcode::start_of(motion)) return json;
    json["kind"] = name_of(motion.kind);
    if (motion.kind != gcode::MoveKind::Rapid) {
        json["feed"] = motion.feed;
        json["feed_mode"] = feed_mode_name(motion.feed_mode);
    }
    if (motion.spindle != gcode::SpindleTurning::Stopped) {
        const bool clockwise = motion.spindle == gcode::SpindleTurning::Clockwise;
        json["spindle_rpm"] = clockwise ? motion.spindle_rpm : -motion.spindle_rpm;
    }
    json["tool"] = motion.tool;
    if (motion.machine_coordinates) json["machine_coordinates"] = true;
    std::string unknown;
    if (!motion.known_start.x) unknown += 'x';
    if (!motion.known_start.y) unknown += 'y';
    if (!motion.known_start.z) unknown += 'z';
    if (!unknown.empty()) json["unknown_start"] = unknown;
    if (motion.start_assumed) json["start_assumed"] = true;
    return json;
}

}  // namespace ncsim::report
