// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces: CYCLE61, CYCLE71.
// Source: SINUMERIK 840D sl, Programming Manual Cycles, 11/2006 (CYCLE71), and NC Programming,
// 06/2019 (CYCLE61).
#include "sinumerik/sinumerik_control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::sinumerik {
namespace {

/// Width of strokes of CYCLE71 without a specified width, in diameters of the tool.
constexpr double kUsualStroke = 0.8;

}  // namespace

/// Reads RTP, RFP and SDIS; `depth`: height of the floor.
bool Control::read_face_heights(const CycleCall& call, double depth, language::FaceMilling& m,
                                double& retract) {
    retract = argument(call, 0, 0.0);
    m.surface = argument(call, 1, 0.0);
    m.clear = m.surface + std::abs(argument(call, 2, 0.0));
    m.bottom = depth;
    if (retract < m.surface)
        return fail(Message::BlockNeeds, call.span,
                    {call.name, "a retraction plane (RTP) not below the surface"});
    return true;
}

/// CYCLE61(_RTP, _Z0, _SDIS, _Z1, _X0, _Y0, _X1, _Y1, _DZ, _DXY, _UZ, _F, _VARI, _LIM, _DMODE,
/// _AMODE): mills a face.
bool Control::mill_face_cycle(const CycleCall& call, double radius) {
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    const double mode = at(15);
    if (at(13) != 0.0) return fail(Message::NotRead, call.span, {"CYCLE61 with limits (_LIM)"});
    language::FaceMilling m;
    double retract = 0.0;
    const double bottom = digit(mode, 0) == 1 ? at(1) - std::abs(at(3)) : at(3);
    if (!read_face_heights(call, bottom, m, retract)) return false;
    const int variant = digit(at(12), 0);
    const int way = digit(at(12), 1);
    if ((variant != 1 && variant != 2) || way < 1 || way > 4)
        return fail(Message::NotRead, call.span, {"CYCLE61 with this _VARI"});
    m.tool_radius = radius;
    if (variant == 1) m.bottom += std::abs(at(10));
    m.infeed = variant == 1 ? std::abs(at(8)) : 0.0;
    if (m.bottom > m.surface) return fail(Message::HoleUpwards, call.span, {call.name});
    // Digits 4 and 5 of _AMODE: the second corner is absolute (2), or a distance.
    const double length = digit(mode, 3) == 2 ? at(6) - at(4) : at(6);
    const double width = digit(mode, 4) == 2 ? at(7) - at(5) : at(7);
    m.corner = {at(4) + std::min(0.0, length), at(5) + std::min(0.0, width)};
    m.length = std::abs(length);
    m.width = std::abs(width);
    if (!(m.length > 0.0 && m.width > 0.0))
        return fail(Message::BlockNeeds, call.span, {call.name, "a length and a width above 0"});
    const double step = std::abs(at(9));
    m.step = digit(mode, 1) == 1 ? step / 100.0 * 2.0 * radius : step;
    m.is_along_second = way == 2 || way == 4;
    m.is_alternating = way >= 3;
    m.margin = std::abs(at(2));
    m.feed = feed_of(at(11));
    log_.add(Message::MillsOutside, call.span, {call.name});
    return rise(retract) && mill_face(m) && move_to(retract, std::nullopt);
}

/// CYCLE71(_RTP, _RFP, _SDIS, _DP, _PA, _PO, _LENG, _WID, _STA, _MID, _MIDA, _FDP, _FALD, _FFP1,
/// _VARI, _FDP1): mills a face from a corner.
bool Control::mill_old_face_cycle(const CycleCall& call, double radius) {
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    language::FaceMilling m;
    double retract = 0.0;
    if (call.arguments.size() < 8 || !argument(call, 3))
        return fail(Message::BlockNeeds, call.span, {call.name, "a depth, a length and a width"});
    if (!read_face_heights(call, at(3), m, retract)) return false;
    const int variant = digit(at(14), 0);
    const int way = digit(at(14), 1);
    if ((variant != 1 && variant != 2) || way < 1 || way > 4)
        return fail(Message::NotRead, call.span, {"CYCLE71 with this _VARI"});
    m.tool_radius = radius;
    if (variant == 1) m.bottom += std::abs(at(12));
    m.infeed = variant == 1 ? std::abs(at(9)) : 0.0;
    if (m.bottom > m.surface) return fail(Message::HoleUpwards, call.span, {call.name});
    m.corner = {at(4), at(5)};
    m.length = at(6);
    m.width = at(7);
    m.angle = at(8);
    if (m.length == 0.0 || m.width == 0.0)
        return fail(Message::BlockNeeds, call.span, {call.name, "a length and a width above 0"});
    m.step = std::abs(at(10));
    if (m.step == 0.0) m.step = kUsualStroke * 2.0 * radius;
    m.is_along_second = way == 2 || way == 4;
    m.is_alternating = way >= 3;
    m.margin = std::abs(at(11));
    m.overrun = std::abs(at(15));
    m.feed = feed_of(at(13));
    log_.add(Message::MillsOutside, call.span, {call.name});
    return rise(retract) && mill_face(m) && move_to(retract, std::nullopt);
}

}  // namespace ncsim::gcode::sinumerik
