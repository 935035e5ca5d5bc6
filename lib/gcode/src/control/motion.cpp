// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/gcode/motion.h"

namespace ncsim::gcode {

namespace {

// Start or end of whatever moves; null for what does not.
const Position* place(const Motion& motion, bool start) {
    if (const auto* linear = std::get_if<Linear>(&motion.what))
        return start ? &linear->from : &linear->to;
    if (const auto* arc = std::get_if<Arc>(&motion.what)) return start ? &arc->from : &arc->to;
    if (const auto* spline = std::get_if<Spline>(&motion.what))
        return start ? &spline->from : &spline->to;
    return nullptr;
}

}  // namespace

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
