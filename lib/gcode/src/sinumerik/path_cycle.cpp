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
namespace {

// Places of arguments of CYCLE72.
constexpr std::size_t kPathVariant = 10;
constexpr std::size_t kPathSide = 11;
constexpr std::size_t kPathIn = 12;
constexpr std::size_t kPathOut = 15;
constexpr std::size_t kPathGeometry = 20;
constexpr std::size_t kPathMode = 22;

}  // namespace

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

/// Reads the retraction plane, the surface, the clearance and the depth, which may be relative
/// (_AMODE), and refuses modes that are not read.
bool Control::read_path_heights(const CycleCall& call, Hole& hole) {
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    const bool has_name = !call.arguments.empty() && call.arguments[0] &&
                          call.arguments[0]->is_text && !call.arguments[0]->text.empty();
    if (!has_name)
        return fail(Message::BlockNeeds, call.span, {"CYCLE72", "the name of a contour (_KNAME)"});
    // RTP, RFP, SDIS and the depth as in hole cycles.
    CycleCall heights = call;
    heights.arguments.erase(heights.arguments.begin());
    heights.arguments.resize(4);
    if (digit(at(kPathMode), 0) == 1) {
        heights.arguments[3].reset();
        heights.arguments.emplace_back(Value::of(at(4)));
    }
    if (!read_hole(heights, hole)) return false;
    const int kind = digit(at(kPathVariant), 0);
    if ((kind != 1 && kind != 2) || at(kPathVariant) >= 1000.0 || digit(at(kPathVariant), 2) > 3)
        return fail(Message::NotRead, call.span, {"CYCLE72 with this _VARI"});
    if (at(kPathGeometry) >= 1000.0)
        return fail(Message::NotRead, call.span, {"CYCLE72 with this _GMODE"});
    return true;
}

/// Reads the side of the tool and the ways to the contour and back.
bool Control::read_path_ways(const CycleCall& call, double radius, language::ContourPath& m) {
    const double side = argument(call, kPathSide, 0.0);
    if (side != 40.0 && side != 41.0 && side != 42.0)
        return fail(Message::BlockNeeds, call.span, {"CYCLE72", "_RL of 40, 41 or 42"});
    m.side = side == 41.0 ? CutterSide::Left : side == 42.0 ? CutterSide::Right : CutterSide::Off;
    const bool is_compensated = m.side != CutterSide::Off;
    const double edge = is_compensated ? radius : 0.0;
    if (!read_lead(call, kPathIn, edge, m.in)) return false;
    m.out = m.in;
    if (argument(call, kPathOut, 0.0) != 0.0 && !read_lead(call, kPathOut, edge, m.out))
        return false;
    using enum language::Lead::Form;
    if (!is_compensated && (m.in.form != Line || m.out.form != Line))
        return fail(Message::BlockNeeds, call.span, {"CYCLE72", "lines (_AS1 1) with _RL 40"});
    m.offset = edge;
    return true;
}

/// CYCLE72(_KNAME, _RTP, _RFP, _SDIS, _DP, _MID, _FAL, _FALD, _FFP1, _FFD, _VARI, _RL, _AS1, _LP1,
/// _FF3, _AS2, _LP2, _UMODE, _FS, _ZFS, _GMODE, _DMODE, _AMODE).
bool Control::mill_path_cycle(const CycleCall& call, double radius) {
    const auto at = [&](std::size_t index) { return argument(call, index, 0.0); };
    Hole hole;
    language::ContourPath m;
    if (!read_path_heights(call, hole) || !read_path_ways(call, radius, m)) return false;
    const std::optional<language::Pass> contour = read_contour_(call.arguments[0]->text, call.span);
    if (!contour) return false;
    if (contour->empty()) return true;
    log_.add(Message::ContourLead, call.span, {"CYCLE72"});
    m.contour = *contour;
    const PlaneAxes axes = axes_of(plane_);
    m.is_mirrored = (chain_.scale[axes.first] < 0.0) != (chain_.scale[axes.second] < 0.0);
    const bool is_roughing = digit(at(kPathVariant), 0) == 1;
    if (is_roughing && m.side != CutterSide::Off) m.offset += std::abs(at(6));
    m.surface = hole.surface;
    m.bottom = hole.bottom + (is_roughing ? std::abs(at(7)) : 0.0);
    m.clear = hole.clear;
    if (m.bottom > m.surface) return fail(Message::HoleUpwards, call.span, {call.name});
    m.infeed = std::abs(at(5));
    m.has_equal_infeeds = true;
    m.feed = feed_of(at(8));
    m.plunge_feed = at(9) > 0.0 ? feed_of(at(9)) : m.feed;
    const int lift = digit(at(kPathVariant), 2);
    if (lift == 0) m.lift_to = hole.retract;
    if (lift == 1) m.lift_to = hole.clear;
    if (lift == 2) m.lift_by = hole.clear - hole.surface;
    if (digit(at(kPathVariant), 1) == 1 || lift == 3)
        m.transfer_feed = at(14) > 0.0 ? feed_of(at(14)) : m.feed;
    return rise(hole.retract) && mill_along(m, "CYCLE72") && move_to(hole.retract, std::nullopt);
}

}  // namespace ncsim::gcode::sinumerik
