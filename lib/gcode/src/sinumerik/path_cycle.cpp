// SPDX-License-Identifier: GPL-3.0-or-later
//
// CYCLE72: milling along a contour, which is a subprogram or blocks between two labels.
// Source: SINUMERIK 840D sl/840D/840Di/810D, Programming Manual Cycles, 11/2006; SINUMERIK ONE, NC
// Programming, 12/2019.
#include "sinumerik/sinumerik_control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::sinumerik {

/// Reads _AS1, _LP1 or _AS2, _LP2: the way to the contour or back, of the centre of the tool.
bool Control::read_lead(const CycleCall& call, std::size_t form, double radius,
                        language::Lead& lead) {
    const double kind = argument(call, form, 0.0);
    const double size = std::abs(argument(call, form + 1, 0.0));
    using enum language::Lead::Form;
    switch (digit(kind, 0)) {
        case 1: lead.form = Line; break;
        case 2: lead.form = Quadrant; break;
        case 3: lead.form = Semicircle; break;
        default:
            return fail(Message::NotRead, call.span, {"CYCLE72 with this approach (_AS1, _AS2)"});
    }
    if (digit(kind, 1) > 1)
        return fail(Message::NotRead, call.span, {"CYCLE72 with this approach (_AS1, _AS2)"});
    lead.in_space = digit(kind, 1) == 1;
    lead.size = lead.form == Line ? size + radius : size;
    if (!(size > 0.0))
        return fail(Message::BlockNeeds, call.span,
                    {"CYCLE72", "a length of the approach (_LP1) above 0"});
    return true;
}

/// CYCLE72(_KNAME, _RTP, _RFP, _SDIS, _DP, _MID, _FAL, _FALD, _FFP1, _FFD, _VARI, _RL, _AS1, _LP1,
/// _FF3, _AS2, _LP2, _UMODE, _FS, _ZFS, _GMODE, _DMODE, _AMODE).
bool Control::mill_path_cycle(const CycleCall& call, double radius) {
    constexpr std::size_t kGeometryMode = 20;
    constexpr std::size_t kMode = 22;
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    const bool has_name = !call.arguments.empty() && call.arguments[0] &&
                          call.arguments[0]->is_text && !call.arguments[0]->text.empty();
    if (!has_name)
        return fail(Message::BlockNeeds, call.span, {"CYCLE72", "the name of a contour (_KNAME)"});
    // RTP, RFP, SDIS and the depth as in hole cycles; the depth may be relative (_AMODE).
    CycleCall heights = call;
    heights.arguments.erase(heights.arguments.begin());
    heights.arguments.resize(4);
    if (digit(at(kMode), 0) == 1)
        heights.arguments = {heights.arguments[0], heights.arguments[1], heights.arguments[2],
                             std::nullopt, Value::of(at(4))};
    Hole hole;
    if (!read_hole(heights, hole)) return false;
    const int kind = digit(at(10), 0);
    const int side = static_cast<int>(at(11));
    if ((kind != 1 && kind != 2) || at(10) >= 1000.0 || digit(at(10), 2) > 3)
        return fail(Message::NotRead, call.span, {"CYCLE72 with this _VARI"});
    if (side < 40 || side > 42)
        return fail(Message::BlockNeeds, call.span, {"CYCLE72", "_RL of 40, 41 or 42"});
    if (at(kGeometryMode) >= 1000.0)
        return fail(Message::NotRead, call.span, {"CYCLE72 with this _GMODE"});
    language::ContourPath m;
    const bool is_compensated = side != 40;
    if (!read_lead(call, 12, is_compensated ? radius : 0.0, m.in)) return false;
    m.out = m.in;
    if (at(15) != 0.0 && !read_lead(call, 15, is_compensated ? radius : 0.0, m.out)) return false;
    using enum language::Lead::Form;
    if (!is_compensated && (m.in.form != Line || m.out.form != Line))
        return fail(Message::BlockNeeds, call.span, {"CYCLE72", "lines (_AS1 1) with _RL 40"});
    const std::optional<language::Pass> contour = read_contour_(call.arguments[0]->text, call.span);
    if (!contour) return false;
    if (contour->empty()) return true;
    log_.add(Message::ContourLead, call.span, {"CYCLE72"});
    const PlaneAxes axes = axes_of(plane_);
    m.contour = *contour;
    m.side = side == 41 ? CutterSide::Left : side == 42 ? CutterSide::Right : CutterSide::Off;
    m.is_mirrored = (chain_.scale[axes.first] < 0.0) != (chain_.scale[axes.second] < 0.0);
    m.offset = is_compensated ? radius + (kind == 1 ? std::abs(at(6)) : 0.0) : 0.0;
    m.surface = hole.surface;
    m.bottom = hole.bottom + (kind == 1 ? std::abs(at(7)) : 0.0);
    m.clear = hole.clear;
    if (m.bottom > m.surface) return fail(Message::HoleUpwards, call.span, {call.name});
    m.infeed = std::abs(at(5));
    m.has_equal_infeeds = true;
    m.feed = feed_of(at(8));
    m.plunge_feed = at(9) > 0.0 ? feed_of(at(9)) : m.feed;
    const int lift = digit(at(10), 2);
    if (lift == 0) m.lift_to = hole.retract;
    if (lift == 1) m.lift_to = hole.clear;
    if (lift == 2) m.lift_by = hole.clear - hole.surface;
    if (digit(at(10), 1) == 1 || lift == 3)
        m.transfer_feed = at(14) > 0.0 ? feed_of(at(14)) : m.feed;
    return rise(hole.retract) && mill_along(m, "CYCLE72") && move_to(hole.retract, std::nullopt);
}

}  // namespace ncsim::gcode::sinumerik
