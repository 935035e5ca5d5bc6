// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the features: slots, loops, pockets, helices, arcs, holes.
#include "support/set_up_writer.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

namespace ncsim::test::set_ups {

void Writer::jaw_fault(std::size_t where, Length z) {
    if (!jaw_top_) return;
    const bool is_flat = tool().kind == "flat" || tool().kind == "face";
    const std::string old = word(Z, z);
    const std::string deep = word(Z, *jaw_top_ - (is_flat ? little() : mm(0.8)));
    fault("deeper than the jaws are low", "failed", "fixture-contact", kCollisions, [=](Draft& d) {
        d.replace(where, old, deep);
        return where;
    });
    const Length up = z + (is_flat ? little() : mm(0.8));
    fault("jaws higher than the floor", "failed", "fixture-contact", {}, [=](Draft& d) {
        for (Fixture& fixture : d.fixtures) {
            if (std::string_view(fixture.name).ends_with("jaw")) fixture.max[Z] = up;
        }
        return std::size_t{0};
    });
}

void Writer::open_slot(const Feature& f) {
    const Length gap = margin(0.5, 4);
    Length from = draft_.stock_min[Y] - radius() - gap;
    Length to = draft_.stock_max[Y] + radius() + margin(0.5, 4);
    if (happens(50)) std::swap(from, to);
    Length x = middle(f) + random_.between(-f.room, f.room);
    Length other = happens(50) ? x : middle(f) + random_.between(-f.room, f.room);
    traverse(x, from, false);
    const bool by_feed = tool().kind == "face" || happens(30);
    Length before = 0;
    for (const Length depth : f.passes) {
        const std::size_t down =
            by_feed ? feed_to({{Z, top_ - depth}}) : go("G0", {{Z, top_ - depth}});
        if (depth == f.depth) jaw_fault(down, top_ - depth);
        const std::size_t across = x == other ? feed_to({{Y, to}}) : feed_to({{X, other}, {Y, to}});
        cuts(across, depth, depth - before);
        cuts_if_rapid(across);
        if (tool().kind == "face" && by_feed) plunge_fault(down);
        if (depth != f.depth) {
            switch (random_.between(0, 2)) {
                case 0:  // along the floor and both walls
                    go("G0", {{X, x}, {Y, from}});
                    break;
                case 1:
                    retract(false);
                    go("G0", {{X, x}, {Y, from}});
                    break;
                default: std::swap(from, to), std::swap(x, other);
            }
        }
        before = depth;
    }
    if (happens(30)) go("G0", {{X, x}, {Y, from}});
    retract(false);
}

void Writer::plunge_fault(std::size_t down) {
    const std::string into = "G0 " + word(Y, middle_y());
    fault("plunge of a face mill", "failed", "plunge", kCollisions, [=](Draft& d) {
        d.insert_before(down, into);
        return down + 1;
    });
}

void Writer::loop(const Feature& f) {
    const Length from = draft_.stock_min[Y] - radius() - margin(0.5, 4);
    const Length to = draft_.stock_max[Y] + radius() + margin(0.5, 4);
    const Length x = middle(f) + random_.between(-f.room, f.room);
    const Length step = f.passes.front();
    const auto count = f.passes.size();
    traverse(x, from, false);
    go("G0", {{Z, top_}});
    const std::string f_word = feed();
    const std::vector<std::string> body{"G91 G0 " + word(Z, -step),
                                        "G1 " + word(Y, to - from) + f_word,
                                        "G0 " + word(Y, from - to), "G90"};
    reach(Y, to, 0);
    reach(Z, top_ - f.depth, 0);
    std::function<std::size_t(Draft&)> once_more;
    if (happens(50)) {
        const std::string name = "O" + std::to_string(100 + subprograms_.size());
        const std::size_t call = line(name + " repeat [" + std::to_string(count) + "]");
        for (const std::string& text : body)
            line(text);
        line(name + " endrepeat");
        note_feed(call + 2);
        cuts_in_loop(call + 2, step, f.depth);
        once_more = [=](Draft& d) {
            d.replace(call, "[" + std::to_string(count), "[" + std::to_string(count + 1));
            return call + 1;
        };
    } else {
        const std::string name = std::to_string(1000 + subprograms_.size());
        const std::size_t call = line("M98 P" + name + " L" + std::to_string(count));
        const std::string head = "O" + name;
        subprograms_.push_back(head);
        subprograms_.insert(subprograms_.end(), body.begin(), body.end());
        subprograms_.emplace_back("M99");
        has_feed_ |= !f_word.empty();
        cuts_in_loop(0, step, f.depth);
        once_more = [=](Draft& d) {
            d.replace(call, "L" + std::to_string(count), "L" + std::to_string(count + 1));
            const auto found = std::ranges::find(d.lines, head);
            return static_cast<std::size_t>(found - d.lines.begin()) + 2;
        };
        fault("subprogram missing", "failed", "program-fault", {"no-feed", "not-simulated"},
              [=](Draft& d) {
                  d.replace(call, "P" + name, "P4711");
                  return call;
              });
    }
    const bool meets = jaw_top_ && top_ - f.depth - step < *jaw_top_ - mm(0.8);
    if (meets) fault("loop once too often", "failed", "fixture-contact", kCollisions, once_more);
    retract(false);
}

void Writer::cuts_in_loop(std::size_t where, Length step, Length depth) {
    Tool& t = tool();
    if (!std::exchange(t.has_cut, true)) t.first_cut = where;
    t.deepest = std::max(t.deepest, depth);
    t.highest_cut = std::max(t.highest_cut, step);
    t.heights.emplace_back(where, step);
}

Length Writer::lower_to_start() {
    const Length z = std::min(clear_, top_ + margin(0.5, 3));
    if (z < clear_) go("G0", {{Z, z}});
    return z;
}

void Writer::pocket(const Feature& f) {
    const Length hx = f.room, hy = within(2, 10);
    const Length cx = middle(f), cy = middle_y() + within(-5, 5);
    traverse(cx - hx, cy - hy, true);
    lower_to_start();
    Length before = 0;
    for (const Length depth : f.passes) {
        const bool ramp = happens(30);
        if (ramp) {
            tool().slopes = true;
            const std::size_t along = feed_to({{X, cx + hx}, {Z, top_ - depth}});
            cuts(along, depth, depth - before);
            cuts_if_rapid(along);
            const std::size_t back = feed_to({{X, cx - hx}});
            cuts(back, depth, depth - before);
        } else {
            const std::size_t down = feed_to({{Z, top_ - depth}});
            cuts(down, depth, 0);
            cuts_if_rapid(down);
            blind_fault(down, depth - before);
            cuts(feed_to({{X, cx + hx}}), depth, depth - before);
        }
        if (ramp) cuts(feed_to({{X, cx + hx}}), depth, 0);
        const std::size_t side = feed_to({{Y, cy + hy}});
        cuts(side, depth, depth - before);
        cuts_if_rapid(side);
        cuts(feed_to({{X, cx - hx}}), depth, depth - before);
        if (happens(50)) {
            go("G0", {{X, cx + hx}});  // along the finished wall and back
            go("G0", {{X, cx - hx}});
        }
        cuts(feed_to({{Y, cy - hy}}), depth, depth - before);
        before = depth;
    }
    clamp_fault(f);
    retract(true);
}

void Writer::clamp_fault(const Feature& f) {
    const std::size_t here = next_line();
    const Length thinnest = radius() * 4 / 5;  // radius of the shank, which may be the part of the
                                               // tool at this height
    Length x = 0;
    if (clamp_max_ <= clamp_min_) return;
    if (clamp_max_ == f.x0) {
        x = clamp_max_ + thinnest - little();
    } else if (clamp_min_ == f.x0 + f.width) {
        x = clamp_min_ - thinnest + little();
    } else {
        return;
    }
    const std::string text = "G1 " + word(X, x);
    const bool upright = tool().kind == "flat";
    if (!upright) return;
    fault("feed into a clamp", "failed", "fixture-contact", kCollisions, [=](Draft& d) {
        d.insert_before(here, text);
        return here;
    });
}

void Writer::blind_fault(std::size_t where, Length by) {
    const Length blind = tool().diameter * 6 / 10;
    if (tool().kind != "flat" || by < blind / 10) return;
    const std::size_t index = tool_;
    fault("plunge of a mill with inserts", "failed", "plunge", {}, [=](Draft& d) {
        d.tools[index].blind = blind;
        return where;
    });
}

void Writer::spare(const Feature& f) {
    tool().slopes = true;
    tool().longer_than = std::max(tool().longer_than, f.passes.front() + mm(0.01));
}

void Writer::helix(const Feature& f) {
    const Length r = std::min(f.room, radius() - 1);
    const Length cx = middle(f), cy = middle_y() + within(-5, 5);
    traverse(cx + r, cy, true);
    go("G0", {{Z, top_ + (clear_ > top_ && happens(50) ? 1 : 0)}});
    const char* const code = one_of({"G2", "G3"});
    const std::string centre = " I" + number(-r) + " J0.";
    Length before = 0;
    const bool turns_word = f.passes.size() > 1 && happens(30);
    if (turns_word) {
        const std::size_t where = go(code, {{X, cx + r}, {Y, cy}, {Z, top_ - f.depth}},
                                     centre + " P" + std::to_string(f.passes.size()) + feed());
        arc_note(where, cx, cy, r);
        cuts(where, f.depth, f.passes.front());
        spare(f);
    } else {
        for (const Length depth : f.passes) {
            const std::size_t where =
                go(code, {{X, cx + r}, {Y, cy}, {Z, top_ - depth}}, centre + feed());
            arc_note(where, cx, cy, r);
            cuts(where, depth, depth - before);
            spare(f);
            before = depth;
        }
    }
    const std::size_t round = go(code, {{X, cx + r}, {Y, cy}}, centre + feed());
    arc_note(round, cx, cy, r);
    cuts(round, f.depth, f.passes.front());
    retract(true);
}

void Writer::arc_note(std::size_t where, Length cx, Length cy, Length r) {
    note_feed(where);
    for (const Length side : {-r, r}) {
        reach(X, cx + side, where);
        reach(Y, cy + side, where);
    }
}

void Writer::arcs(const Feature& f) {
    const Length r = f.room;
    const Length cx = middle(f), cy = middle_y() + within(-5, 5);
    traverse(cx + r, cy, true);
    lower_to_start();
    for (const Length depth : f.passes) {
        const Length pass = f.passes.front();
        const std::size_t down = feed_to({{Z, top_ - depth}});
        cuts(down, depth, 0);
        cuts_if_rapid(down);
        const bool by_radius = happens(50);
        const std::string form =
            by_radius ? " R" + number(r) : " I" + number(-r) + " J" + number(0);
        const std::size_t first = go("G3", {{X, cx}, {Y, cy + r}}, form + feed());
        note_feed(first);
        cuts(first, depth, pass);
        if (by_radius) {
            const std::string old = " R" + number(r);
            const std::string small = " R" + number(r / 2);
            fault("arc that does not reach its end", "failed", "program-fault", kCollisions,
                  [=](Draft& d) {
                      d.replace(first, old, small);
                      return first;
                  });
        }
        const std::size_t second = go("G3", {{X, cx}, {Y, cy - r}}, " I0. J" + number(-r) + feed());
        reach(X, cx - r, second);
        cuts(second, depth, pass);
        const std::size_t back = go("G2", {{X, cx}, {Y, cy + r}}, " I0. J" + number(r) + feed());
        reach(X, cx - r, back);
        go("G2", {{X, cx + r}, {Y, cy}}, " I0. J" + number(-r) + feed());
    }
    retract(true);
}

void Writer::drilling(const Feature& f) {
    const Length x = middle(f);
    const std::int64_t holes = random_.between(1, 3);
    const Length apart = tool().diameter + within(0.5, 2);
    const Length y = middle_y() - (holes - 1) * apart / 2;
    Length bottom = top_ - f.depth;
    const bool through = draft_.below_stock > 0 && happens(50);
    if (through) bottom = draft_.stock_min[Z] - draft_.below_stock + margin(0.5, 0.9);
    traverse(x, y, true);
    const Length r = std::min(clear_, top_ + margin(0.5, 3));
    const std::string code = one_of({"G81", "G82", "G83", "G73"});
    std::string more = " R" + number(r);
    const std::string r_word = more;
    if (code == "G82") more += " P0.1";
    if (code == "G83" || code == "G73") more += " Q" + number(std::max(f.depth / 3, mm(0.5)));
    const std::size_t cycle =
        go((one_of({"G98 ", "G99 "}) + code).c_str(), {{X, x}, {Y, y}, {Z, bottom}}, more + feed());
    note_feed(cycle);
    cuts(cycle, top_ - bottom, 0);
    const std::string low = " R" + number(top_ - within(0.05, 1));
    fault("R below the top", "failed", "rapid-in-material", kCollisions, [=](Draft& d) {
        d.replace(cycle, r_word, low);
        return cycle;
    });
    if (through) {
        const Length by = little();
        const Length beyond = draft_.stock_min[Z] - bottom;
        fault("hole into what is below", "not-proven", "below-stock", {}, [=](Draft& d) {
            d.below_stock = std::max<Length>(0, beyond - by);
            return std::size_t{0};
        });
    } else if (has_table_) {
        const std::string old = word(Z, bottom);
        const std::string deep = word(Z, draft_.stock_min[Z] - mm(1));
        fault("drill into the table", "failed", "fixture-contact", kCollisions, [=](Draft& d) {
            d.replace(cycle, old, deep);
            return cycle;
        });
    }
    for (std::int64_t i = 1; i < holes; ++i) {
        at_[Y] = y + i * apart;
        reach(Y, at_[Y], next_line());
        line(word(Y, at_[Y]));
    }
    line("G80");
    retract(true);
    closed_.reset();  // the tool is already above the block
}

void Writer::incremental(const Feature& f) {
    const Length start = std::min(clear_, top_ + margin(0.5, 3));
    const std::int64_t holes = random_.between(1, 3);
    const Length apart = tool().diameter + within(0.3, 2);
    const Length y = middle_y() - (holes - 1) * apart / 2;
    traverse(middle(f), y, true);
    go("G0", {{Z, start}});
    line("G91");
    const Length fall = start - top_ + f.depth;
    for (std::int64_t i = 0; i < holes; ++i) {
        const std::size_t down = line("G1 " + word(Z, -fall) + feed());
        reach(Z, start - fall, down);
        note_feed(down);
        cuts(down, f.depth, 0);
        cuts_if_rapid(down);
        if (i + 1 == holes) break;
        line("G0 " + word(Z, fall));
        at_[Y] += apart;
        reach(Y, at_[Y], next_line());
        const std::size_t aside = line("G0 " + word(Y, apart));
        fault("retract between holes dropped", "failed", "rapid-in-material", kCollisions,
              [=](Draft& d) {
                  d.drop(aside - 1);
                  return aside;
              });
    }
    const std::size_t absolute = line("G90");
    retract(true);
    if (clear_ < -mm(1)) {
        fault("incremental left on", "failed", "rapid-in-material", kCollisions, [=](Draft& d) {
            d.drop(absolute);
            return absolute + 1;
        });
    }
}

void Writer::rotated(const Feature& f) {
    const Length cx = middle(f), cy = middle_y();
    const Length half = f.room;
    const int angle = static_cast<int>(random_.between(-180, 180));
    traverse(cx, cy, true);
    lower_to_start();
    line("G68 " + word(X, cx) + ' ' + word(Y, cy) + " R" + std::to_string(angle) + '.');
    const std::size_t down = feed_to({{Z, top_ - f.depth}});
    cuts(down, f.depth, 0);
    cuts_if_rapid(down);
    for (const Length end : {half, -half}) {
        const std::size_t along = line("G1 " + word(X, cx + end) + ' ' + word(Y, cy) + feed());
        cuts(along, f.depth, f.depth);
        if (end > 0) cuts_if_rapid(along);
    }
    for (const Length side : {-half - 2, half + 2}) {
        within_[X].push_back(cx + side);
        within_[Y].push_back(cy + side);
    }
    clear_line_ = go("G0", {{Z, clear_}});
    line("G69");
    closed_ = clear_line_;
}

void Writer::side_slot(const Feature& f) {
    Tool& t = tool();
    t.neck = t.diameter / 4 * 2;
    t.flutes = mm(3);
    const Length in = radius() - t.neck / 2 - margin(0.1, 1);
    const bool front = happens(50);
    const Length face = front ? draft_.stock_min[Y] : draft_.stock_max[Y];
    const Length sign = front ? 1 : -1;
    const Length out = face - sign * (radius() + margin(0.5, 3));
    const Length x = middle(f) + random_.between(-f.room, f.room);
    traverse(x, out, false);
    const std::size_t down = go("G0", {{Z, top_ - f.depth}});
    jaw_fault(down, top_ - f.depth);
    const std::size_t into = feed_to({{Y, face - sign * radius() + sign * in}});
    cuts(into, f.depth, 0);
    cuts_if_rapid(into);
    const std::size_t back = go("G0", {{Y, out}});
    fault("undercut lifted", "failed", "rapid-in-material", kCollisions, [=](Draft& d) {
        d.drop(back);
        return back + 1;
    });
    retract(false);
}

}  // namespace ncsim::test::set_ups
