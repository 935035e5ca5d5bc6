// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accessors of motions.
#include "ncsim/gcode/motion.h"

namespace ncsim::gcode {

namespace {

// Returns the start or end of a move; nullptr if `motion` does not move.
const Position* place(const Motion& motion, bool start) {
    if (const auto* linear = std::get_if<Linear>(&motion.action))
        return start ? &linear->from : &linear->to;
    if (const auto* arc = std::get_if<Arc>(&motion.action)) return start ? &arc->from : &arc->to;
    if (const auto* spline = std::get_if<Spline>(&motion.action))
        return start ? &spline->from : &spline->to;
    return nullptr;
}

}  // namespace

Position to_parent(const FeatureFrame& frame, const Position& p) {
    const Triple at = frame.to_parent({p.x.mm(), p.y.mm(), p.z.mm()});
    Position out = p;
    out.x = Length::from_mm(at[0]);
    out.y = Length::from_mm(at[1]);
    out.z = Length::from_mm(at[2]);
    return out;
}

Arc in_own_frame(const Arc& arc) {
    if (!arc.tilted) return arc;
    const auto from_parent = [&](Position p) {
        const Triple at = arc.tilted->from_parent({p.x.mm(), p.y.mm(), p.z.mm()});
        p.x = Length::from_mm(at[0]);
        p.y = Length::from_mm(at[1]);
        p.z = Length::from_mm(at[2]);
        return p;
    };
    Arc own = arc;
    own.from = from_parent(arc.from);
    own.to = from_parent(arc.to);
    own.tilted.reset();
    return own;
}

const Position* start_of(const Motion& motion) {
    return place(motion, true);
}
const Position* end_of(const Motion& motion) {
    return place(motion, false);
}

const char* name_of(MoveKind kind) {
    switch (kind) {
        case MoveKind::Rapid: return "rapid";
        case MoveKind::Feed: return "feed";
        case MoveKind::Probe: break;
    }
    return "probe";
}

}  // namespace ncsim::gcode
