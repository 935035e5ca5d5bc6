// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slots on a circle: SLOT1, LONGHOLE (straight, pointing outwards), SLOT2 (along the circle).
// Source: SINUMERIK 840D sl/840D/840Di/810D, Programming Manual Cycles, 11/2006.
#include "ncsim/base/angles.h"

#include "sinumerik/sinumerik_control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::sinumerik {
namespace {

constexpr double kMostSlots = 10'000.0;
/// Arguments of SLOT1 up to _STA2; more arguments are those of newer versions.
constexpr std::size_t kOldSlotArguments = 24;

}  // namespace

/// Returns the number of slots (NUM); nullopt after reporting an error.
std::optional<int> Control::count_of_slots(const CycleCall& call) {
    const double count = std::round(argument(call, 5, 1.0));
    if (count >= 1.0 && count <= kMostSlots) return static_cast<int>(count);
    fail(Message::BlockNeeds, call.span, {call.name, "a number of slots (NUM) from 1 to 10000"});
    return std::nullopt;
}

/// Reads what the slot cycles share: heights, FFD, FFP1 and MID from the argument `feeds` on.
bool Control::read_slot_passes(const CycleCall& call, std::size_t feeds, double radius, Hole& hole,
                               language::Milling& m) {
    if (!read_hole(call, hole)) return false;
    m.tool_radius = radius;
    m.surface = hole.surface;
    m.bottom = hole.bottom;
    m.clear = hole.clear;
    m.plunge_feed = feed_of(argument(call, feeds, 0.0));
    m.feed = feed_of(argument(call, feeds + 1, 0.0));
    if (!(m.feed > 0.0)) m.feed = hole.feed;
    if (!(m.plunge_feed > 0.0)) m.plunge_feed = m.feed;
    m.infeed = std::abs(argument(call, feeds + 2, 0.0));
    m.has_equal_infeeds = true;
    m.finishing_feed = m.feed;
    return true;
}

/// Reads CDIR, FAL, VARI, MIDF, FFP2 and SSF of SLOT1 and SLOT2; `direction`: place of CDIR.
bool Control::read_slot_variant(const CycleCall& call, std::size_t direction,
                                language::Milling& m) {
    const auto at = [&](std::size_t index) { return argument(call, direction + index, 0.0); };
    const int kind = digit(at(2), 0);
    if (kind > 2) return fail(Message::NotRead, call.span, {call.name + " with this VARI"});
    const bool turns_left = machine_.state().spindle == SpindleTurning::Counterclockwise;
    if (at(0) != 0.0 && at(0) != 1.0 && at(0) != 2.0 && at(0) != 3.0)
        return fail(Message::BlockNeeds, call.span, {call.name, "a direction (CDIR) from 0 to 3"});
    // 0: climb milling, counter-clockwise in a slot; 1: up-cut; 2: G2; 3: G3.
    m.is_clockwise = at(0) >= 2.0 ? at(0) == 2.0 : (at(0) == 0.0) == turns_left;
    m.side_allowance = std::abs(at(1));
    m.roughs = kind != 2;
    m.finishes_side = kind == 2 || (kind == 0 && m.side_allowance > 0.0);
    m.finishing_infeed = std::abs(at(3));
    if (at(4) > 0.0) m.finishing_feed = feed_of(at(4));
    if (at(5) > 0.0) m.finishing_speed = at(5);
    return true;
}

/// SLOT1(RTP, RFP, SDIS, DP, DPR, NUM, LENG, WID, CPA, CPO, RAD, STA1, INDA, FFD, FFP1, MID, CDIR,
/// FAL, VARI, MIDF, FFP2, SSF, _FALD, _STA2). LONGHOLE has no WID, and ends with MID: the tool is
/// as wide as the slot.
bool Control::mill_slots_cycle(const CycleCall& call, double radius) {
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    const bool is_slot = call.name == "SLOT1";
    const std::size_t place = is_slot ? 8 : 7;  // Of CPA.
    const std::optional<int> count = count_of_slots(call);
    language::Milling m;
    Hole hole;
    if (!count || !read_slot_passes(call, place + 5, radius, hole, m)) return false;
    language::MilledArea& area = m.area;
    area.length = std::abs(at(6));
    area.width = is_slot ? std::abs(at(7)) : 2.0 * radius;
    area.corner = area.width / 2.0;
    if (!(area.length >= area.width && area.width > 0.0))
        return fail(Message::BlockNeeds, call.span,
                    {call.name, "a length (LENG) of at least the width of the slot"});
    if (is_slot) {
        const int plunge = digit(at(18), 1);
        if (plunge != 0 && plunge != 1 && plunge != 3)
            return fail(Message::NotRead, call.span, {"SLOT1 with this VARI"});
        using enum language::Plunge;
        m.plunge = plunge == 0 ? Rapid : plunge == 3 ? Ramp : Vertical;
        if (!read_slot_variant(call, 16, m)) return false;
        m.floor_allowance = std::abs(at(22));
        m.finishes_floor = m.finishes_side && m.floor_allowance > 0.0;
    }
    const double ring = at(place + 2);
    const bool is_new = is_slot && call.arguments.size() > kOldSlotArguments;
    if (is_new && (*count > 1 || ring != 0.0))
        return fail(Message::NotRead, call.span, {"SLOT1 with _GMODE and several slots"});
    log_.add(Message::SlotPosition, call.span, {call.name});
    m.repeats = *count;
    const double step = at(place + 4) != 0.0 ? at(place + 4) : 360.0 / *count;
    // Newer versions give the middle of a single slot.
    const double middle = is_new ? 0.0 : ring + area.length / 2.0;
    if (!rise(hole.retract)) return false;
    for (int i = 0; i < *count; ++i) {
        area.angle = at(place + 3) + i * step;
        const SinCos direction = sin_cos(area.angle);
        area.centre = {at(place) + middle * direction.cos, at(place + 1) + middle * direction.sin};
        if (!mill(m, call.name) || !move_to(hole.retract, std::nullopt)) return false;
    }
    return true;
}

/// SLOT2(RTP, RFP, SDIS, DP, DPR, NUM, AFSL, WID, CPA, CPO, RAD, STA1, INDA, FFD, FFP1, MID, CDIR,
/// FAL, VARI, MIDF, FFP2, SSF, _FFCP): slots along a circle.
bool Control::mill_circular_slots_cycle(const CycleCall& call, double radius) {
    constexpr std::size_t kArguments = 23;
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    const std::optional<int> count = count_of_slots(call);
    language::Milling m;
    Hole hole;
    if (!count || !read_slot_passes(call, 13, radius, hole, m)) return false;
    if (call.arguments.size() > kArguments)
        return fail(Message::NotRead, call.span, {"SLOT2 with _GMODE or _AMODE"});
    language::MilledArea& area = m.area;
    area.opening = at(6);
    area.width = std::abs(at(7));
    area.centre = {at(8), at(9)};
    area.arc_radius = at(10);
    if (!(area.opening > 0.0 && area.width > 0.0 && area.arc_radius > 0.0))
        return fail(Message::BlockNeeds, call.span,
                    {call.name, "an angle (AFSL), a width (WID) and a radius (RAD) above 0"});
    const int way = digit(at(18), 1);
    if (way > 1 || at(18) >= 100.0)
        return fail(Message::NotRead, call.span, {"SLOT2 with this VARI"});
    if (!read_slot_variant(call, 16, m)) return false;
    m.repeats = *count;
    const double step = at(12) != 0.0 ? at(12) : 360.0 / *count;
    if (!rise(hole.retract)) return false;
    for (int i = 0; i < *count; ++i) {
        const Vec2 from = point_in_plane();
        area.angle = at(11) + i * step;
        const Vec2 to = language::middle_of(area);
        // VARI 1x: from slot to slot along the circle, with the feed _FFCP.
        const bool is_arc = i > 0 && way == 1;
        const double feed = at(22) > 0.0 ? feed_of(at(22)) : m.feed;
        if (is_arc && !cut({from, to, area.centre, step > 0.0 ? 1 : -1}, hole.retract, feed))
            return false;
        if (!mill(m, call.name) || !move_to(hole.retract, std::nullopt)) return false;
    }
    return true;
}

}  // namespace ncsim::gcode::sinumerik
