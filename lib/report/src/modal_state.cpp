// SPDX-License-Identifier: GPL-3.0-or-later
//
// Describes the modes of a control.
#include "ncsim/report/modal_state.h"

#include "plain_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace ncsim::report {

namespace {

using gcode::MachineState;

// "G1", "G43.4"; empty for none.
std::string code_text(gcode::Code code) {
    const int tenths = static_cast<int>(code);
    if (tenths < 0) return {};
    return tenths % 10 == 0 ? fmt::format("G{}", tenths / 10)
                            : fmt::format("G{}.{}", tenths / 10, tenths % 10);
}

std::string with_code(std::string_view words, const std::string& code, bool with_codes) {
    return with_codes && !code.empty() ? fmt::format("{} ({})", words, code) : std::string(words);
}

// "X1 Y2" of the axes that are not 0; empty for none.
std::string axes_text(const gcode::Axes& axes, bool zeros = false) {
    static constexpr std::string_view kLetters = "XYZABCUVW";
    std::string text;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i] == 0.0 && !(zeros && i < 3)) continue;
        if (!text.empty()) text += ' ';
        text += kLetters[i] + plain_number(axes[i]);
    }
    return text;
}

const char* unit_of(const MachineState& s) {
    return s.inches ? "inch" : "mm";
}

std::string motion_text(const MachineState& s, bool with_codes) {
    const std::string code = code_text(s.motion);
    switch (static_cast<int>(s.motion)) {
        case -1: return "none yet";
        case 0: return with_code("rapid", code, with_codes);
        case 10: return with_code("feed", code, with_codes);
        case 20: return with_code("clockwise arc", code, with_codes);
        case 30: return with_code("counter-clockwise arc", code, with_codes);
        case 800: return with_code("none", code, with_codes);
        default: return with_codes ? code : "cycle";
    }
}

std::string plane_text(const MachineState& s, bool with_codes) {
    switch (s.plane) {
        case gcode::Plane::XY: return with_code("XY", "G17", with_codes);
        case gcode::Plane::ZX: return with_code("ZX", "G18", with_codes);
        case gcode::Plane::YZ: return with_code("YZ", "G19", with_codes);
        case gcode::Plane::UV: return with_code("UV", "G17.1", with_codes);
        case gcode::Plane::WU: return with_code("WU", "G18.1", with_codes);
        case gcode::Plane::VW: break;
    }
    return with_code("VW", "G19.1", with_codes);
}

std::string distance_text(const MachineState& s, bool with_codes) {
    std::string text = s.incremental ? with_code("incremental", "G91", with_codes)
                                     : with_code("absolute", "G90", with_codes);
    if (s.absolute_centres) text += with_code(", centres of arcs absolute", "G90.1", with_codes);
    return text;
}

std::string feed_text(const MachineState& s, bool with_codes) {
    const std::string value = s.feed > 0.0 ? plain_number(s.feed) : "not set,";
    switch (s.feed_mode) {
        case gcode::FeedMode::PerMinute:
            return with_code(fmt::format("{} {}/min", value, unit_of(s)), "G94", with_codes);
        case gcode::FeedMode::PerRevolution:
            return with_code(fmt::format("{} {}/rev", value, unit_of(s)), "G95", with_codes);
        case gcode::FeedMode::InverseTime: break;
    }
    return with_code(value + " 1/min", "G93", with_codes);
}

std::string spindle_text(const MachineState& s, bool) {
    const std::string speed =
        s.spindle_rpm > 0.0
            ? plain_number(s.spindle_rpm) + (s.constant_surface_speed ? " (G96)" : "/min")
            : "no speed";
    std::string text = s.spindle == gcode::SpindleTurning::Stopped     ? "stopped, "
                       : s.spindle == gcode::SpindleTurning::Clockwise ? "clockwise, "
                                                                       : "counter-clockwise, ";
    text += speed;
    if (s.spindle_in_doubt) text += ", perhaps stopped by M0";
    if (s.spindle_oriented) text += ", oriented";
    return text;
}

std::string coolant_text(const MachineState& s, bool) {
    if (s.coolant.mist && s.coolant.flood) return "mist and flood";
    return s.coolant.mist ? "mist" : s.coolant.flood ? "flood" : "off";
}

std::string tool_text(const MachineState& s, bool) {
    std::string text = s.tool == 0 ? "none" : fmt::format("T{}", s.tool);
    if (s.selected_tool > 0 && s.selected_tool != s.tool)
        text += fmt::format(", T{} selected", s.selected_tool);
    return text;
}

std::string length_text(const MachineState& s, bool) {
    const auto& offset = s.frames.tool_offset;
    switch (s.length_register) {
        case gcode::kNoLength: return "none";
        case gcode::kStatedLength: return axes_text(offset, true) + " from the program";
        case gcode::kNegatedLength: return "negated (G44)";
        default: break;
    }
    const std::string name = fmt::format("H{}", s.length_register);
    return s.length_specified
               ? fmt::format("{}, {} {}", name, plain_number(offset[gcode::kZ]), unit_of(s))
               : name + ", length not specified";
}

std::string compensation_text(const MachineState& s, bool with_codes) {
    if (s.cutter_side == gcode::CutterSide::Off) return with_code("off", "G40", with_codes);
    const bool is_left = s.cutter_side == gcode::CutterSide::Left;
    return with_code(fmt::format("{} of the path, radius {} {}", is_left ? "left" : "right",
                                 plain_number(s.cutter_radius), unit_of(s)),
                     is_left ? "G41" : "G42", with_codes);
}

std::string system_name(int system) {
    if (system <= 6) return fmt::format("G{}", 53 + system);
    return system <= 9 ? fmt::format("G59.{}", system - 6) : fmt::format("G54.1 P{}", system - 9);
}

std::string system_text(const MachineState& s, bool) {
    std::string text = system_name(s.system);
    const bool is_of_machine = std::ranges::all_of(s.frame, [](int f) { return f == 0; });
    if (is_of_machine) {
        text += ", zero at " + axes_text(s.frames.work_offset, true) + " in the machine";
    } else {
        text += ", place in the machine not specified";
    }
    if (s.frames.rotation != 0.0)
        text += ", turned by " + plain_number(s.frames.rotation) + "° about Z";
    return text;
}

std::string shift_text(const MachineState& s, bool) {
    const std::string shift = axes_text(s.frames.offset_92);
    return shift.empty() ? "none" : shift;
}

std::string transform_text(const MachineState& s, bool) {
    const gcode::ProgrammedTransform& t = s.frames.programmed;
    std::string text;
    const auto add = [&text](const std::string& more) {
        text += (text.empty() ? "" : ", ") + more;
    };
    if (t.rotated) add("rotated by " + plain_number(t.angle) + "°");
    if (t.scaled) {
        add(fmt::format("scaled by {}, {}, {}", plain_number(t.scale[0]), plain_number(t.scale[1]),
                        plain_number(t.scale[2])));
    }
    if (t.polar) add("polar coordinates");
    if (s.polar_interpolation) add("polar interpolation");
    if (s.cylinder) add("cylinder of radius " + plain_number(s.cylinder->radius));
    return text.empty() ? "none" : text;
}

std::string tilted_text(const MachineState& s, bool) {
    if (!s.frames.tilt) return "none";
    const gcode::FeatureFrame& frame = *s.frames.tilt;
    const gcode::Triple normal = frame.normal();
    return fmt::format("zero at X{} Y{} Z{}, tool along {}, {}, {}", plain_number(frame.origin[0]),
                       plain_number(frame.origin[1]), plain_number(frame.origin[2]),
                       plain_number(normal[0]), plain_number(normal[1]), plain_number(normal[2]));
}

std::string defined_cycle_text(int number) {
    if (number == gcode::kModalProgram) return "MCALL of a subprogram";
    return number > 0 ? fmt::format("CYCL DEF {}", number) : fmt::format("MCALL CYCLE{}", -number);
}

std::string cycle_text(const MachineState& s, bool with_codes) {
    if (s.defined_cycle.number != 0) return defined_cycle_text(s.defined_cycle.number);
    if (!s.cycle.running) return "none";
    const std::string code = with_codes ? code_text(s.cycle.code) + ", " : "";
    std::string text = fmt::format("{}clearance {}, depth {}", code, plain_number(s.cycle.r),
                                   plain_number(s.cycle.z));
    if (s.cycle.q != 0.0) text += ", pecks of " + plain_number(s.cycle.q);
    return text + (s.retract_to_r ? ", back to the clearance" : ", back to the initial level");
}

std::string units_text(const MachineState& s, bool with_codes) {
    return with_code(unit_of(s), s.inches ? "G20" : "G21", with_codes);
}

std::string coordinates_text(const MachineState& s, bool) {
    return s.coordinates == gcode::Coordinates::Tip ? "of the tip, which the control keeps"
                                                    : "of the axes";
}

struct Mode {
    std::string_view name;
    std::string (*text)(const MachineState& s, bool with_codes);
};

// In the order of ModeGroup.
constexpr std::array<Mode, kModeGroups> kModes{{{"motion", motion_text},
                                                {"plane", plane_text},
                                                {"units", units_text},
                                                {"distances", distance_text},
                                                {"feed", feed_text},
                                                {"spindle", spindle_text},
                                                {"coolant", coolant_text},
                                                {"tool", tool_text},
                                                {"length", length_text},
                                                {"compensation", compensation_text},
                                                {"system", system_text},
                                                {"shift", shift_text},
                                                {"transformation", transform_text},
                                                {"tilted plane", tilted_text},
                                                {"coordinates", coordinates_text},
                                                {"cycle", cycle_text}}};

}  // namespace

std::string_view name_of(ModeGroup group) {
    return kModes.at(static_cast<std::size_t>(group)).name;
}

std::string text_of(ModeGroup group, const MachineState& s, bool with_codes) {
    return kModes.at(static_cast<std::size_t>(group)).text(s, with_codes);
}

ModeNumbers numbers_of(const MachineState& s) {
    ModeNumbers all{};
    const auto set = [&all](ModeGroup group, std::initializer_list<double> numbers) {
        std::ranges::copy(numbers, all[static_cast<std::size_t>(group)].begin());
    };
    const auto n = [](auto value) { return static_cast<double>(value); };
    // A change of units changes no length.
    const auto mm = [&s](double value) { return std::round(value * s.unit_mm() * 1e7) / 1e7; };
    set(ModeGroup::Motion, {n(s.motion)});
    set(ModeGroup::Plane, {n(s.plane)});
    set(ModeGroup::Units, {n(s.inches)});
    set(ModeGroup::Distance, {n(s.incremental), n(s.absolute_centres)});
    set(ModeGroup::Feed, {s.feed, n(s.feed_mode)});
    set(ModeGroup::Spindle, {s.spindle_rpm, n(s.spindle), n(s.constant_surface_speed),
                             n(s.spindle_in_doubt), n(s.spindle_oriented)});
    set(ModeGroup::Coolant, {n(s.coolant.mist), n(s.coolant.flood)});
    set(ModeGroup::Tool, {n(s.tool), n(s.selected_tool)});
    set(ModeGroup::Length,
        {n(s.length_register), n(s.length_specified), mm(s.frames.tool_offset[0]),
         mm(s.frames.tool_offset[1]), mm(s.frames.tool_offset[2]), s.frames.tool_offset[3],
         s.frames.tool_offset[4], s.frames.tool_offset[5], mm(s.frames.tool_offset[6]),
         mm(s.frames.tool_offset[7]), mm(s.frames.tool_offset[8])});
    set(ModeGroup::Compensation,
        {n(s.cutter_side), n(s.cutter_side) == 0.0 ? 0.0 : mm(s.cutter_radius)});
    set(ModeGroup::System,
        {n(s.system), s.frames.rotation, n(s.frame[0]), n(s.frame[1]), n(s.frame[2]),
         mm(s.frames.work_offset[0]), mm(s.frames.work_offset[1]), mm(s.frames.work_offset[2]),
         s.frames.work_offset[3], s.frames.work_offset[4], s.frames.work_offset[5],
         mm(s.frames.work_offset[6]), mm(s.frames.work_offset[7]), mm(s.frames.work_offset[8])});
    set(ModeGroup::Shift,
        {mm(s.frames.offset_92[0]), mm(s.frames.offset_92[1]), mm(s.frames.offset_92[2]),
         s.frames.offset_92[3], s.frames.offset_92[4], s.frames.offset_92[5],
         mm(s.frames.offset_92[6]), mm(s.frames.offset_92[7]), mm(s.frames.offset_92[8])});
    const gcode::ProgrammedTransform& t = s.frames.programmed;
    if (t.rotated || t.scaled) {
        set(ModeGroup::Transform,
            {n(t.rotated), n(t.scaled), t.rotated ? t.angle : 0.0, mm(t.centre_1), mm(t.centre_2),
             t.scale[0], t.scale[1], t.scale[2], mm(t.scale_centre[0]), mm(t.scale_centre[1]),
             mm(t.scale_centre[2])});
    }
    auto& transform = all[static_cast<std::size_t>(ModeGroup::Transform)];
    transform[11] = n(t.polar);
    transform[12] = n(s.polar_interpolation.has_value());
    transform[13] = s.cylinder ? mm(s.cylinder->radius) : -1.0;
    if (s.frames.tilt) {
        const gcode::FeatureFrame& f = *s.frames.tilt;
        set(ModeGroup::TiltedPlane,
            {1.0, mm(f.origin[0]), mm(f.origin[1]), mm(f.origin[2]), f.rows[0][0], f.rows[0][1],
             f.rows[0][2], f.rows[1][0], f.rows[1][1], f.rows[1][2], f.rows[2][0], f.rows[2][1],
             f.rows[2][2]});
    }
    set(ModeGroup::Controlled, {n(s.coordinates)});
    if (s.defined_cycle.number != 0) {
        set(ModeGroup::Cycle, {2.0, n(s.defined_cycle.number), n(s.defined_cycle.line)});
    } else if (s.cycle.running) {
        set(ModeGroup::Cycle, {1.0, n(s.cycle.code), mm(s.cycle.r), mm(s.cycle.z), mm(s.cycle.q),
                               s.cycle.p, n(s.retract_to_r)});
    }
    return all;
}

}  // namespace ncsim::report
