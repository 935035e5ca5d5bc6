// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transformations of coordinates: presets (cycle 247), datum shift (7), mirror image (8), rotation
// (10), scale (11, 26), tilted planes (19, PLANE), TCPM. Order: preset, datum, plane; then
// rotation, mirror images and scale about the datum.
#include "klartext/control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::klartext {
namespace {

std::size_t axis_of(std::string_view name) {
    return name.size() == 1 ? kAxisNames.find(name[0]) : std::string_view::npos;
}

}  // namespace

/// CYCL DEF 247: selects a preset. Presets 1 … 9 are the coordinate systems G54 … G59.3 of the
/// set-up.
bool Control::preset(const Block& block, double number) {
    constexpr double kMost = 290.0;
    constexpr double kPresetZero = 300.0;  // Number of the system that stands for preset 0.
    if (!(number >= 0.0 && number <= kMost) || number != std::floor(number)) {
        return fail(Message::KlartextPresetNumber, block.whole(),
                    {std::to_string(static_cast<long long>(std::clamp(number, -1e9, 1e9)))});
    }
    if (!end_compensation(block.whole())) return false;
    has_preset_ = true;
    Command command = make(block.whole());
    if (number >= 1.0 && number <= kExtended) {
        put(command, kSystemCodes[static_cast<std::size_t>(number) - 1]);
    } else {
        put(command, Code::G54_1);
        put(command, 'P', number == 0.0 ? kPresetZero : number);
    }
    if (!run(command)) return false;
    refresh();
    return true;
}

/// CYCL DEF 7.n: shifts the datum along the named axes.
bool Control::datum_shift(const Block& block, Scanner& scan) {
    Command command = make(block.whole());
    put(command, Code::G52);
    const MachineState& state = machine_.state();
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        if (scan.peek() == '#')
            return fail(Message::KlartextVerb, block.span(begin, 1), {"a datum table (cycle 7 #)"});
        std::string name = upper_of(scan.letters());
        const bool is_incremental = name.size() > 1 && name[0] == 'I';
        if (is_incremental) name.erase(0, 1);
        // "XQ1"
        if (name.size() > 1 && name[1] == 'Q') {
            scan.move_to(begin + (is_incremental ? 2 : 1));
            name.resize(1);
        }
        const std::size_t axis = axis_of(name);
        if (axis == std::string_view::npos) {
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        }
        const std::optional<double> value = parameters_.read_value(scan, block);
        if (!value) return false;
        put(command, kAxisNames[axis],
            *value + (is_incremental ? state.frames.offset_92[axis] : 0.0));
    }
    if (command.present == 0) return true;
    if (!has_preset_ && !is_preset_reported_) {
        is_preset_reported_ = true;
        log_.add(Message::PresetMissing, block.whole());
    }
    command.axis_words = true;
    machine_.flush();
    if (!run(command)) return false;
    refresh();
    return true;
}

/// Passes the rotation, mirror images and scale to the machine.
bool Control::apply(const Block& block) {
    const Transformation& t = transformation_;
    const bool is_mirrored = std::ranges::find(t.is_mirrored, true) != t.is_mirrored.end();
    const bool is_uneven = t.scale[0] != t.scale[1] || t.scale[1] != t.scale[2];
    if (t.angle != 0.0 && (is_mirrored || is_uneven)) {
        return fail(Message::KlartextVerb, block.whole(),
                    {"a rotation (cycle 10) together with a mirror image or a scale by axis"});
    }
    if (side_ != CutterSide::Off)
        return fail(Message::KlartextVerb, block.whole(), {"a transformation under RL or RR"});
    machine_.flush();
    std::array<double, 3> factors = t.scale;
    for (std::size_t i = 0; i < 3; ++i) {
        if (t.is_mirrored[i]) factors[i] = -factors[i];
    }
    machine_.state().frames.programmed.set(plane_, t.angle, factors, t.centre);
    refresh();
    tangent_.reset();
    return true;
}

/// CYCL DEF 8.1: mirrors the named axes; no axis ends the mirror image.
bool Control::mirror(const Block& block, Scanner& scan) {
    std::array<bool, 3> is_mirrored{};
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        const std::string name = upper_of(scan.letters());
        const std::size_t axis = axis_of(name);
        if (axis > kZ) {
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        }
        is_mirrored[axis] = true;
    }
    const std::size_t tool_axis = axes_of(plane_).third;
    if (is_mirrored[tool_axis])
        return fail(Message::KlartextVerb, block.whole(), {"a mirror image of the tool axis"});
    transformation_.is_mirrored = is_mirrored;
    return apply(block);
}

/// CYCL DEF 10.1 ROT+30, IROT+30.
bool Control::rotation(const Block& block, Scanner& scan) {
    if (scan.is_at_end()) return true;
    const std::size_t begin = scan.at();
    std::string name = upper_of(scan.letters());
    const bool is_incremental = name.starts_with('I');
    if (is_incremental) name.erase(0, 1);
    if (name == "ROTQ") scan.move_to(scan.at() - 1), name = "ROT";
    if (name != "ROT") {
        return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                    {block.code.substr(begin)});
    }
    const std::optional<double> angle = parameters_.read_value(scan, block);
    if (!angle) return false;
    transformation_.angle = is_incremental ? transformation_.angle + *angle : *angle;
    return apply(block);
}

/// CYCL DEF 11.1 SCL0.95, CYCL DEF 26.1 X1.2 Y0.8 CCX+5 CCY+10.
bool Control::scaling(const Block& block, Scanner& scan, bool by_axis) {
    Transformation& t = transformation_;
    if (by_axis) t.scale.fill(1.0), t.centre.fill(0.0);
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        std::string name = upper_of(scan.letters());
        if (name.size() > 1 && name.ends_with('Q')) {
            name.pop_back();
            scan.move_to(scan.at() - 1);
        }
        const bool is_centre = by_axis && name.size() == 3 && name.starts_with("CC");
        const std::size_t axis =
            by_axis ? axis_of(is_centre ? name.substr(2) : name) : std::string_view::npos;
        if (by_axis ? axis > kZ : name != "SCL") {
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        }
        const std::optional<double> value = parameters_.read_value(scan, block);
        if (!value) return false;
        if (is_centre) {
            t.centre[axis] = *value;
            continue;
        }
        if (!(*value > 1e-6 && *value < 1e6))
            return fail(Message::ScaleZero, block.span(begin, scan.at() - begin));
        if (by_axis) {
            t.scale[axis] = *value;
        } else {
            t.scale.fill(*value);
            t.centre.fill(0.0);
        }
    }
    return apply(block);
}

/// Sets or ends the tilted plane.
bool Control::tilt(const FeatureFrame& frame, std::string_view name, SourceSpan span) {
    if (side_ != CutterSide::Off)
        return fail(Message::KlartextVerb, span, {std::string(name) + " under RL or RR"});
    machine_.flush();
    machine_.set_origin(span, file_);
    if (!frame.is_turned()) {
        machine_.end_tilt();
    } else {
        const Transformation& t = transformation_;
        const bool is_changed = t.angle != 0.0 || t.scale != std::array<double, 3>{1.0, 1.0, 1.0} ||
                                std::ranges::find(t.is_mirrored, true) != t.is_mirrored.end();
        if (is_changed) {
            return fail(Message::KlartextVerb, span,
                        {std::string(name) + " after a rotation, mirror image or scale"});
        }
        if (plane_ != Plane::XY)
            return fail(Message::KlartextVerb, span,
                        {std::string(name) + " with a tool axis X or Y"});
        if (!machine_.tilt(frame, name, span)) return false;
    }
    refresh();
    tangent_.reset();
    return true;
}

/// CYCL DEF 19.1 A+0 B+45 C+0: spatial angles; no angle ends the tilted plane.
bool Control::working_plane(const Block& block, Scanner& scan) {
    std::array<double, 3> angle{};
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        std::string name = upper_of(scan.letters());
        if (name.size() > 1 && name.ends_with('Q')) {
            name.pop_back();
            scan.move_to(scan.at() - 1);
        }
        const std::size_t axis = axis_of(name);
        const bool is_angle = axis >= kA && axis <= kC;
        const bool is_other = name == "F" || name == "ABST" || name == "DIST" || name == "SETUP";
        if (!is_angle && !is_other) {
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        }
        const std::optional<double> value = parameters_.read_value(scan, block);
        if (!value) return false;
        if (is_angle) angle[axis - kA] = *value;
    }
    const FeatureFrame frame =
        turn_about(2, angle[2]) * turn_about(1, angle[1]) * turn_about(0, angle[0]);
    if (!tilt(frame, "CYCL DEF 19", block.whole())) return false;
    const auto axes = machine_.axes_of_tilt(LeadingAxis::Preferred, "CYCL DEF 19", block.whole());
    if (!axes) return false;
    for (std::size_t i = 0; i < 3; ++i)
        parameters_.set_system(static_cast<std::uint32_t>(120 + i),
                               frame.is_turned() ? (*axes)[kA + i] : 0.0);
    return true;
}

namespace {

/// Words of PLANE.
struct PlaneWords {
    std::array<std::optional<double>, 3> angle;  ///< SPA SPB SPC, EULPR EULNU EULROT …
    std::array<double, 3> base{}, normal{};
    bool has_base = false, has_normal = false;
    enum class Way : std::uint8_t { None, Stay, Turn, Move } way = Way::None;
    LeadingAxis leading = LeadingAxis::Preferred;
    bool is_rapid = false;
    std::optional<double> feed;
    bool turns_table = true;
};

}  // namespace

bool Control::plane(const Block& block) {
    Scanner scan(block.code, block.rest);
    scan.skip_blanks();
    const std::string kind = upper_of(scan.letters());
    const std::string name = "PLANE " + kind;
    const SourceSpan span = block.whole();
    const bool resets = kind == "RESET";
    if (!resets && kind != "SPATIAL" && kind != "EULER" && kind != "VECTOR" && kind != "AXIAL")
        return fail(Message::KlartextVerb, span, {name});
    PlaneWords words;
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        std::string word = upper_of(scan.letters());
        const auto refuse = [&] {
            std::size_t end = begin + 1;
            while (end < block.code.size() && !is_blank(block.code[end]))
                ++end;
            return fail(Message::KlartextWord, block.span(begin, end - begin),
                        {block.code.substr(begin, end - begin)});
        };
        if (word == "STAY") {
            words.way = PlaneWords::Way::Stay;
            continue;
        }
        if (word == "TURN" || word == "MOVE") {
            words.way = word == "TURN" ? PlaneWords::Way::Turn : PlaneWords::Way::Move;
            continue;
        }
        if (word == "SEQ" || word == "SYM") {
            const char sign = scan.peek();
            if (sign != '+' && sign != '-') return refuse();
            scan.move_to(scan.at() + 1);
            words.leading = sign == '+' ? LeadingAxis::Positive : LeadingAxis::Negative;
            continue;
        }
        if (word == "FMAX" || (word == "F" && scan.take_word("MAX"))) {
            words.is_rapid = true;
            continue;
        }
        if (word == "TABLE" || word == "COORD") {
            if (!scan.take_word("ROT")) return refuse();
            words.turns_table = word == "TABLE";
            continue;
        }
        if (word == "MB") {
            if (scan.take_word("MAX")) continue;
            if (!parameters_.read_value(scan, block)) return false;
            continue;
        }
        if (word.size() > 1 && word.ends_with('Q')) {
            word.pop_back();
            scan.move_to(scan.at() - 1);
        }
        constexpr std::array<std::string_view, 3> kSpatial{"SPA", "SPB", "SPC"};
        constexpr std::array<std::string_view, 3> kEuler{"EULPR", "EULNU", "EULROT"};
        constexpr std::array<std::string_view, 3> kAxial{"A", "B", "C"};
        constexpr std::array<std::string_view, 3> kBase{"BX", "BY", "BZ"};
        constexpr std::array<std::string_view, 3> kNormal{"NX", "NY", "NZ"};
        const bool is_distance = word == "DIST" || word == "ABST" || word == "F";
        const auto index = [&word](const auto& names) {
            return static_cast<std::size_t>(std::ranges::find(names, word) - names.begin());
        };
        const std::size_t of_angle = kind == "SPATIAL" ? index(kSpatial)
                                     : kind == "EULER" ? index(kEuler)
                                     : kind == "AXIAL" ? index(kAxial)
                                                       : 3;
        const std::size_t of_base = kind == "VECTOR" ? index(kBase) : 3;
        const std::size_t of_normal = kind == "VECTOR" ? index(kNormal) : 3;
        if (!is_distance && of_angle == 3 && of_base == 3 && of_normal == 3) return refuse();
        const std::optional<double> value = parameters_.read_value(scan, block);
        if (!value) return false;
        if (of_angle < 3) words.angle[of_angle] = *value;
        if (of_base < 3) words.base[of_base] = *value, words.has_base = true;
        if (of_normal < 3) words.normal[of_normal] = *value, words.has_normal = true;
        if (word == "F") words.feed = *value;
    }
    const auto angle = [&](std::size_t i) { return words.angle[i].value_or(0.0); };
    FeatureFrame frame;
    if (kind == "SPATIAL") {
        frame = turn_about(2, angle(2)) * turn_about(1, angle(1)) * turn_about(0, angle(0));
    } else if (kind == "EULER") {
        frame = turn_about(2, angle(0)) * turn_about(0, angle(1)) * turn_about(2, angle(2));
    } else if (kind == "AXIAL") {
        const bool is_zero = angle(0) == 0.0 && angle(1) == 0.0 && angle(2) == 0.0;
        if (!is_zero) return fail(Message::KlartextVerb, span, {"PLANE AXIAL"});
    } else if (kind == "VECTOR") {
        const auto& n = words.normal;
        const auto& b = words.base;
        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (!words.has_base || !words.has_normal || !(length > 1e-9))
            return fail(Message::BlockNeeds, span, {name, "BX BY BZ and NX NY NZ"});
        std::array<double, 3> z{n[0] / length, n[1] / length, n[2] / length};
        const double along = b[0] * z[0] + b[1] * z[1] + b[2] * z[2];
        std::array<double, 3> x{b[0] - along * z[0], b[1] - along * z[1], b[2] - along * z[2]};
        const double size = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (!(size > 1e-9))
            return fail(Message::BlockNeeds, span, {name, "a base that is not the normal"});
        for (double& v : x)
            v /= size;
        const std::array<double, 3> y{z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2],
                                      z[0] * x[1] - z[1] * x[0]};
        for (std::size_t i = 0; i < 3; ++i)
            frame.rows[i] = {x[i], y[i], z[i]};
    }
    if (!tilt(frame, name, span)) return false;
    const bool is_turned = frame.is_turned();
    Axes axes{};
    if (is_turned) {
        const auto found = machine_.axes_of_tilt(words.leading, name, span);
        if (!found) return false;
        axes = *found;
    }
    for (std::size_t i = 0; i < 3; ++i)
        parameters_.set_system(static_cast<std::uint32_t>(120 + i), axes[kA + i]);
    if (words.way == PlaneWords::Way::Turn || words.way == PlaneWords::Way::Move) {
        const bool feeds = words.feed && !words.is_rapid;
        const double before = machine_.state().feed;
        if (feeds) machine_.state().feed = feed_of(*words.feed);
        const bool is_rotated = machine_.state().position[kA] != axes[kA] ||
                                machine_.state().position[kB] != axes[kB] ||
                                machine_.state().position[kC] != axes[kC];
        if (is_rotated) {
            machine_.turn_axes(axes, feeds ? MoveKind::Feed : MoveKind::Rapid,
                               words.way == PlaneWords::Way::Move && is_turned);
        }
        machine_.state().feed = before;
    }
    refresh();
    return true;
}

/// FUNCTION TCPM, FUNCTION RESET TCPM, FUNCTION MODE MILL.
bool Control::function(const Block& block) {
    Scanner scan(block.code, block.rest);
    const bool resets = scan.take_word("RESET");
    if (scan.take_word("TCPM")) {
        const std::string words = upper_of(scan.remaining());
        if (words.find("AXIS SPAT") != std::string::npos)
            return fail(Message::KlartextVerb, block.whole(), {"FUNCTION TCPM AXIS SPAT"});
        if (!resets && side_ != CutterSide::Off)
            return fail(Message::KlartextVerb, block.whole(), {"FUNCTION TCPM under RL or RR"});
        Command command = make(block.whole());
        command.m[static_cast<std::size_t>(MGroup::Kinematics)] = resets ? 129 : 128;
        if (!run(command)) return false;
        refresh();
        return true;
    }
    const std::string words = upper_of(scan.remaining());
    if (words == "MODE MILL" && !resets) return true;
    return fail(Message::KlartextVerb, block.whole(), {block.code});
}

}  // namespace ncsim::gcode::klartext
