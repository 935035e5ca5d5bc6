// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools and machine, chosen after all features, and the faults in both.
#include "support/set_up_writer.h"

#include <algorithm>
#include <utility>

namespace ncsim::test::set_ups {

void Writer::finish_tools() {
    const Length clamp = high_ - top_;
    for (std::size_t i = 0; i < draft_.tools.size(); ++i) {
        Tool& t = draft_.tools[i];
        const Length reach = t.deepest + clamp;
        const bool plain = t.kind == "flat" || t.kind == "ball" || t.kind == "bull";
        if (t.kind == "drill") {
            t.flutes = t.deepest + t.diameter + margin(1, 20);
        } else if (t.kind == "slot") {
            t.neck_length = reach + margin(1, 20);
        } else {
            Length least = std::max(t.highest_cut, t.longer_than);
            // A rounded corner leaves part of the wall for the next pass.
            if (t.kind == "ball") least += t.diameter / 2;
            least = std::max(least + t.corner, mm(1));
            if (t.kind == "v") least = std::max(least, t.diameter / 2 + mm(0.5));
            t.flutes = least + margin(0.5, 15);
        }
        if (plain) {
            const int shank = static_cast<int>(random_.between(0, 3));
            if (shank == 1) t.shank = t.diameter;
            if (shank == 2) t.shank = t.diameter * 4 / 5;
            if (shank == 3) {
                t.shank = t.diameter + within(1, 6);
                t.flutes = std::max(t.flutes, reach + margin(0.5, 5));
            }
        }
        const Length above = std::max(reach, t.flutes + t.neck_length);
        if (happens(60)) {
            t.stick_out = above + margin(0.5, 20);
            t.holder = t.diameter + within(10, 30);
        }
        tool_faults(i, clamp);
    }
}

void Writer::tool_faults(std::size_t index, Length clamp) {
    const Tool& t = draft_.tools[index];
    // At the end of a ramp or helix, or in a corner, a difference of 1 µm has no visible effect.
    const bool upright = t.kind == "flat" && !t.slopes;
    const Length by = upright ? little() : mm(0.2);
    if (!t.heights.empty() && t.highest_cut - by > t.corner + mm(0.1) && t.kind != "v" &&
        t.kind != "ball") {
        const Length flutes = t.highest_cut - by;
        const std::size_t where = first_above(t.heights, flutes);
        fault("flutes shorter than the pass", "failed", "non-cutting-contact", kCollisions,
              [=](Draft& d) {
                  d.tools[index].flutes = flutes;
                  if (d.tools[index].shank > d.tools[index].diameter)
                      d.tools[index].shank = d.tools[index].diameter;
                  return where;
              });
    }
    // The lowest possible holder begins directly above flutes and neck.
    const Length stick_out = t.deepest - by;
    const bool is_wide = std::ranges::all_of(features_, [&](const Feature& f) {
        return f.tool != index ||
               (f.kind != Kind::Pocket && f.kind != Kind::Side && f.kind != Kind::Helix &&
                f.kind != Kind::Arcs && f.kind != Kind::Rotated);
    });
    if (t.holder > 0 && is_wide && clamp == 0 && stick_out > t.diameter / 2 + mm(1)) {
        fault("holder in the part", "failed", "non-cutting-contact", {}, [=](Draft& d) {
            d.tools[index].stick_out = stick_out;
            return std::size_t{0};  // next to the block the holder may already be above it
        });
    }
    length_faults(index);
    const std::size_t spindle = t.spindle, cut = t.first_cut;
    fault("M3 dropped", "failed", "spindle-off", {}, [=](Draft& d) {
        d.replace(spindle, " M3", "");
        return cut;
    });
    fault("M4 instead of M3", "failed", "spindle-reversed", {}, [=](Draft& d) {
        d.replace(spindle, "M3", "M4");
        return cut;
    });
    if (index > 0) return;
    fault("S dropped", "failed", "spindle-off", {}, [=](Draft& d) {
        d.line(spindle) = "M3";
        return cut;
    });
}

std::size_t Writer::first_above(const std::vector<std::pair<std::size_t, Length>>& all,
                                Length limit) {
    for (const auto& [where, value] : all) {
        if (value > limit) return where;
    }
    return 0;
}

void Writer::length_faults(std::size_t index) {
    const std::size_t tools = draft_.tools.size();
    const std::size_t block = draft_.tools[index].length;
    // The length matters only if the tool moves down.
    const std::size_t where = home_height_ > clear_ ? block : 0;
    fault("tool without a description", "not-proven", "tool-guess", {"not-simulated"},
          [=](Draft& d) {
              d.tools[index].specified = false;
              return std::size_t{0};
          });
    if (tools < 2) return;
    const std::string own = "G43 H" + std::to_string(index + 1) + ' ';
    const std::size_t other = index == 0 ? 2 : index;
    const bool kept = index > 0 && !cancelled_.contains(index);
    fault("G43 dropped", "failed", kept ? "wrong-length-offset" : "no-length-offset", {},
          [=](Draft& d) {
              d.replace(block, own, "");
              return where;
          });
    fault("H of another tool", "failed", "wrong-length-offset", {}, [=](Draft& d) {
        d.replace(block, own, "G43 H" + std::to_string(other) + ' ');
        return where;
    });
    fault("H0", "failed", "no-length-offset", {}, [=](Draft& d) {
        d.replace(block, own, "G43 H0 ");
        return where;
    });
}

void Writer::set_machine() {
    const Length home = home_height_;
    draft_.zero = {within(-300, -200), within(-300, -200), -home};
    reach(Z, home, home_);
    const Length first_x = reached_[X].front().second;
    const Length first_y = reached_[Y].front().second;
    draft_.start = {first_x, first_y, home};
    if (happens(40)) draft_.start[Z] = home - 1;
    for (const Axis axis : {X, Y, Z}) {
        Length low = reached_[axis].front().second, high = low;
        for (const auto& [where, value] : reached_[axis]) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
        const bool exact_low =
            std::ranges::none_of(within_[axis], [&](Length v) { return v <= low; });
        const bool exact_high =
            std::ranges::none_of(within_[axis], [&](Length v) { return v >= high; });
        for (const Length value : within_[axis]) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
        draft_.travel_min[axis] = low - margin(1, 100);
        draft_.travel_max[axis] = high + (axis == Z ? 0 : margin(1, 100));
        if (low == high) draft_.travel_min[axis] -= mm(1);
        if (high - low < mm(2)) continue;
        if (exact_low) travel_fault(axis, low, -1);
        if (exact_high && axis != Z) travel_fault(axis, high, 1);
    }
}

void Writer::travel_fault(Axis axis, Length end, int sign) {
    const Length limit = end - sign * little();
    std::size_t first = 0;
    for (const auto& [where, value] : reached_[axis]) {
        if (sign * value <= sign * limit) continue;
        if (where == 0) {  // a line in a loop
            first = 0;
            break;
        }
        first = first == 0 ? where : std::min(first, where);
    }
    fault(sign > 0 ? "over the upper end" : "over the lower end", "failed", "over-travel", {},
          [=](Draft& d) {
              (sign > 0 ? d.travel_max : d.travel_min)[axis] = limit;
              return first;
          });
}

void Writer::general_faults() {
    const std::size_t header = header_, home = home_, offset = offset_;
    const std::size_t feed = first_feed_;
    if (feed > 0) {
        fault("F dropped", "failed", "no-feed", {}, [=](Draft& d) {
            std::string& text = d.line(feed);
            text.erase(text.find(" F"));
            return feed;
        });
    }
    fault("word that nobody knows", "not-proven", "left-out", {}, [=](Draft& d) {
        d.insert_before(offset, "M777");
        return offset;
    });
    fault("G code that nobody knows", "failed", "unsupported-word", {}, [=](Draft& d) {
        d.insert_before(offset, "G199");
        return offset;
    });
    fault("start that nobody tells", "not-proven", "start-unknown", {}, [=](Draft& d) {
        d.start_specified = false;
        d.drop(home);
        return std::size_t{0};
    });
    if (!draft_.inches) {
        fault("unit that nobody tells", "not-proven", "units-guess", {}, [=](Draft& d) {
            d.replace(header, "G21 ", "");
            return std::size_t{0};
        });
    }
    const std::size_t down = draft_.tools[0].length;
    const std::string old = word(Z, clear_);
    std::set<std::string> may_tell = kCollisions;
    may_tell.insert("no-length-offset");
    fault("letter O for a zero", "failed", "program-fault", may_tell, [=](Draft& d) {
        d.replace(down, old, "Z1O.");
        return down;
    });
    fault("word twice", "not-proven", "reading-guess", {}, [=](Draft& d) {
        d.replace(down, old, old + ' ' + old);
        return down;
    });
    const std::string probe = "G38.2 " + word(Z, clear_ - 1) + (draft_.inches ? " F2" : " F50");
    if (clear_ - 1 >= high_) {
        fault("probe", "not-proven", "probe-guess", {}, [=](Draft& d) {
            d.insert_before(down + 1, probe);
            return std::size_t{0};
        });
    }
}

}  // namespace ncsim::test::set_ups
