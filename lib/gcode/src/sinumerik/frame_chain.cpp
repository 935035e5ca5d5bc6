// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programmable frames (TRANS, ROT, SCALE, MIRROR and the additive forms), G58, G59, CYCLE800.
// Order: settable offset, swivel plane, programmable frames.
// Source: SINUMERIK 840D sl, Programming Manual Fundamentals, "Frames", 06/2019; SINUMERIK ONE,
// 12/2019 (G58, G59); for CYCLE800 the public description of its parameters.
#include "sinumerik/sinumerik_control.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::gcode::sinumerik {

bool Control::frame(std::string_view name, const Words& words, SourceSpan span) {
    if (side_ != CutterSide::Off) return fail(Message::NotRead, span, {"a frame under G41 or G42"});
    if (records_contour_) return fail(Message::NotRead, span, {"a frame in a contour"});
    const bool adds = name.starts_with('A');
    const std::string_view kind = adds ? name.substr(1) : name;
    const bool is_empty = !words.has_plain_axes() && !words.plane_angle;
    const bool has_fine = fine_ != std::array<double, 3>{};
    if (!adds) {
        if (kind == "TRANS" && !is_empty && is_plain_offset_ && has_fine)
            return fail(Message::FineOffset, span);
        chain_ = {};
        coarse_ = fine_ = {};
        is_plain_offset_ = true;
    }
    const auto value = [&](std::size_t axis) {
        return words.axis[axis] ? words.axis[axis]->value : 0.0;
    };
    if (kind == "TRANS") {
        chain_.translate({value(kX), value(kY), value(kZ)});
        for (std::size_t i = kA; i <= kW; ++i)
            chain_.shift[i] += value(i);
        for (std::size_t i = 0; i < 3; ++i)
            (adds ? fine_ : coarse_)[i] += value(i);
    } else if (kind == "ROT") {
        is_plain_offset_ = is_plain_offset_ && is_empty;
        const bool is_possible =
            words.plane_angle
                ? chain_.rotate(static_cast<int>(axes_of(plane_).third), *words.plane_angle)
                : chain_.rotate(2, value(kZ)) && chain_.rotate(1, value(kY)) &&
                      chain_.rotate(0, value(kX));
        if (!is_possible)
            return fail(Message::NotRead, span, {"a rotation behind a scale by axis"});
    } else {
        is_plain_offset_ = is_plain_offset_ && is_empty;
        for (std::size_t i = 0; i < words.axis.size(); ++i) {
            if (!words.axis[i]) continue;
            if (i > kZ) return fail(Message::NotRead, span, {"a scale of a rotary axis"});
            const double factor = kind == "MIRROR" ? -1.0 : words.axis[i]->value;
            if (!(std::abs(factor) > 1e-6 && std::abs(factor) < 1e6))
                return fail(Message::ScaleZero, words.axis[i]->span);
            chain_.scale[i] *= factor;
        }
    }
    return apply_frame(name, span);
}

/// G58, G59: set the coarse and the fine part of the programmable offset per axis.
bool Control::offset_part(int code, const Words& words, SourceSpan span) {
    const std::string_view name = code == 58 ? "G58" : "G59";
    if (side_ != CutterSide::Off) return fail(Message::NotRead, span, {"a frame under G41 or G42"});
    if (!is_plain_offset_)
        return fail(Message::NotRead, span,
                    {std::string(name) + " behind a rotation, a scale or a mirror image"});
    for (std::size_t i = 0; i < 3; ++i) {
        if (words.axis[i]) (code == 58 ? coarse_ : fine_)[i] = words.axis[i]->value;
    }
    const Axes shift = chain_.shift;
    chain_ = {};
    chain_.shift = shift;
    chain_.translate({coarse_[0] + fine_[0], coarse_[1] + fine_[1], coarse_[2] + fine_[2]});
    return apply_frame(name, span);
}

/// Passes the frames to the machine: an offset and a rotation in the plane, or a tilted plane.
bool Control::apply_frame(std::string_view name, SourceSpan span) {
    machine_.flush();
    machine_.set_origin(span, file_);
    machine_.end_tilt();
    const Frame all = swivel_.then(chain_);
    const bool is_flat =
        !all.rigid.is_turned() || (all.turn && all.turn->axis == axes_of(plane_).third);
    ProgrammedTransform& programmed = machine_.state().frames.programmed;
    programmed.rotated = false;
    programmed.scaled = false;
    Command command = make(span);
    put(command, Code::G52);
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        const double shift = i > kZ ? all.shift[i] : is_flat ? all.rigid.origin[i] : 0.0;
        if (i <= kZ || shift != machine_.state().frames.offset_92[i])
            put(command, kAxisNames[i], shift);
    }
    command.axis_words = true;
    if (!run(command)) return false;
    if (!is_flat && !machine_.tilt(all.rigid, name, span)) return false;
    machine_.state().frames.programmed.set(plane_, is_flat && all.turn ? all.turn->angle : 0.0,
                                           all.scale, {});
    refresh();
    tangent_.reset();
    return true;
}

/// CYCLE800(FR, TC, ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, DIR, FR_I, DMODE): swivels the
/// working plane.
bool Control::swivel(const CycleCall& call) {
    const SourceSpan span = call.span;
    if (side_ != CutterSide::Off)
        return fail(Message::NotRead, span, {"CYCLE800 under G41 or G42"});
    if (!chain_.is_identity())
        return fail(Message::NotRead, span, {"CYCLE800 behind TRANS, ROT, SCALE or MIRROR"});
    const auto at = [&](std::size_t i) { return argument(call, i, 0.0); };
    const bool is_named = call.arguments.size() > 1 && call.arguments[1] &&
                          call.arguments[1]->is_text && call.arguments[1]->text == "0";
    const bool clears = is_named || std::ranges::none_of(call.arguments, [](const auto& value) {
                            return value.has_value();
                        });
    if (clears) {
        swivel_ = {};
        return apply_frame("CYCLE800", span);
    }
    const auto st = static_cast<long>(std::llround(std::clamp(at(2), -1e9, 1e9)));
    const auto mode = static_cast<unsigned>(std::llround(std::clamp(at(3), 0.0, 255.0)));
    const bool adds = st % 10 == 1;
    if (st < 0 || st % 10 > 1 || st / 10 % 1000 != 0)
        return fail(Message::NotRead, span, {"CYCLE800 with ST=" + std::to_string(st)});
    const std::array<double, 3> angle{at(7), at(8), at(9)};
    const bool turns = angle != std::array<double, 3>{};
    if (mode >> 6U != 0 && turns)
        return fail(Message::NotRead, span,
                    {"CYCLE800 with solid, projected or direct angles (MODE)"});
    Frame frame = adds ? swivel_ : Frame{};
    frame.translate({at(4), at(5), at(6)});
    for (std::size_t i = 0; i < 3; ++i) {
        const unsigned axis = mode >> (2 * i) & 3U;  // 1: X, 2: Y, 3: Z.
        if (angle[i] == 0.0) continue;
        if (axis == 0) return fail(Message::BlockNeeds, span, {"CYCLE800", "the axes of MODE"});
        (void)frame.rotate(static_cast<int>(axis) - 1, angle[i]);
    }
    frame.translate({at(10), at(11), at(12)});
    const bool was_tilted = machine_.state().frames.tilt.has_value();
    swivel_ = frame;
    if (!apply_frame("CYCLE800", span)) return false;
    const double direction = at(13);
    const bool is_tilted = machine_.state().frames.tilt.has_value();
    if (direction == 0.0 || (!is_tilted && !was_tilted)) return true;
    Axes axes = machine_.state().position;
    if (is_tilted) {
        const auto found = machine_.axes_of_tilt(
            direction < 0.0 ? LeadingAxis::Least : LeadingAxis::Greatest, "CYCLE800", span);
        if (!found) return false;
        axes = *found;
    } else {
        axes[kA] = axes[kB] = axes[kC] = 0.0;
    }
    const Axes& before = machine_.state().position;
    const bool moves = before[kA] != axes[kA] || before[kB] != axes[kB] || before[kC] != axes[kC];
    if (moves && at(0) != 0.0) {
        // The point of retraction is data of the machine builder.
        log_.add(Message::MachinePoint, span, {"the retraction of CYCLE800"});
        Command command = make(span);
        put(command, Code::G0);
        put(command, Code::G53);
        put(command, 'Z', 0.0);
        command.axis_words = true;
        if (!run(command)) return false;
    }
    if (moves) machine_.turn_axes(axes, MoveKind::Rapid, false);
    refresh();
    return true;
}

}  // namespace ncsim::gcode::sinumerik
