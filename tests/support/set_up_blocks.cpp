// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks of the program: words, moves, and the moves from feature to feature.
#include "support/set_up_writer.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

namespace ncsim::test::set_ups {

void Writer::fault(std::string name, std::string verdict, std::string tells,
                   std::set<std::string> may_tell, std::function<std::size_t(Draft&)> put_in) {
    faults_.push_back({std::move(name), std::move(verdict), std::move(tells), std::move(may_tell),
                       std::move(put_in)});
}

std::size_t Writer::line(const std::string& text) {
    draft_.lines.push_back(text);
    return draft_.lines.size();
}

void Writer::reach(Axis axis, Length value, std::size_t where) {
    reached_[axis].push_back({where, value});
}

std::size_t Writer::go(const char* code, std::initializer_list<std::pair<Axis, Length>> to,
                       const std::string& more) {
    std::string text = code;
    for (const auto& [axis, value] : to) {
        at_[axis] = value;
        reach(axis, value, next_line());
        text += ' ' + word(axis, value);
    }
    return line(text + more);
}

std::string Writer::feed() {
    if (has_feed_ && happens(60)) return {};
    return " F" +
           std::to_string(draft_.inches ? random_.between(4, 30) : random_.between(100, 900));
}

std::size_t Writer::feed_to(std::initializer_list<std::pair<Axis, Length>> to) {
    const std::string f = feed();
    const std::size_t where = go("G1", to, f);
    note_feed(where);
    return where;
}

void Writer::note_feed(std::size_t where) {
    if (has_feed_) return;
    has_feed_ = true;
    first_feed_ = where;
}

void Writer::cuts(std::size_t where, Length depth, Length sideways) {
    Tool& t = tool();
    if (!std::exchange(t.has_cut, true)) {
        t.first_cut = where;
        const char* const stop = one_of({"M5", "M19"});
        fault(stop == std::string_view("M5") ? "spindle stopped" : "spindle oriented", "failed",
              "spindle-off", {}, [=](Draft& d) {
                  d.insert_before(where, stop);
                  return where + 1;
              });
        fault("M0 before the cut", "not-proven", "spindle-after-stop", {"control-guess"},
              [=](Draft& d) {
                  d.insert_before(where, "M0");
                  return where + 1;
              });
    }
    t.deepest = std::max(t.deepest, depth);
    if (sideways > 0) t.heights.emplace_back(where, sideways);
    t.highest_cut = std::max(t.highest_cut, sideways);
}

void Writer::cuts_if_rapid(std::size_t where) {
    fault("rapid instead of feed", "failed", "rapid-in-material", kCollisions, [=](Draft& d) {
        d.replace(where, "G1", "G0");
        return where;
    });
}

void Writer::write() {
    line("(" + std::string(one_of({"part", "housing", "plate", "flange"})) + ")");
    header_ = line(std::string(draft_.inches ? "G20" : "G21") + " G90 G17 G40 G49 G80 G94");
    home_ = line("G91 G28 Z0.");
    line("G90");
    offset_ = line("G54");
    std::optional<std::size_t> in_spindle;
    for (std::size_t i = 0; i < features_.size(); ++i) {
        const Feature& f = features_[i];
        tool_ = f.tool;
        const bool is_new = in_spindle != f.tool;
        if (is_new && in_spindle) {
            line("M9");
            line("G91 G28 Z0.");
            line("G90");
            if (happens(50)) line("M5");
            if (happens(50)) {
                line("G49");
                cancelled_.insert(f.tool);
            }
        }
        if (is_new) change_tool();
        approaching_ = is_new;
        in_spindle = f.tool;
        cut(f);
    }
    line("M5");
    line("G91 G28 Z0.");
    line("G90");
    line("M30");
    for (const std::string& text : subprograms_)
        line(text);
}

void Writer::change_tool() {
    const std::string number = std::to_string(tool_ + 1);
    tool().change = line("T" + number + " M6");
    const std::string speed = "S" + std::to_string(random_.between(500, 9000));
    tool().spindle = line(speed + " M3");
    if (happens(30)) line("M8");
}

void Writer::traverse(Length x, Length y, bool above_stock) {
    const Length from = at_[X];
    const std::size_t where = go("G0", {{X, x}, {Y, y}});
    const bool first = approaching_;
    if (first) {
        const std::string h = "G43 H" + std::to_string(tool_ + 1) + ' ';
        const std::size_t down = line(h + "G0 " + word(Z, clear_));
        reach(Z, clear_, down);
        tool().length = down;
        if (above_stock) {
            const std::string old = word(Z, clear_);
            const std::string deep = word(Z, top_ - mm(1));
            fault("first approach into the part", "failed", "rapid-in-material", kCollisions,
                  [=](Draft& d) {
                      d.replace(down, old, deep);
                      return down;
                  });
        }
        clear_line_ = down;
        approaching_ = false;
    } else {
        traverse_faults(from, x, where);
    }
    at_[Z] = clear_;
    closed_.reset();
}

void Writer::traverse_faults(Length from, Length to, std::size_t where) {
    const std::size_t up = clear_line_;
    if (closed_) {
        fault("retract dropped", "failed", "rapid-in-material", kCollisions, [=](Draft& d) {
            d.drop(up);
            return where;
        });
    }
    const bool crosses = clamp_max_ > clamp_min_ && std::min(from, to) < clamp_min_ &&
                         std::max(from, to) > clamp_max_;
    if (crosses) {
        const bool is_flat = tool().kind == "flat" || tool().kind == "face" ||
                             tool().kind == "slot" || tool().kind == "bull";
        const Length by = std::min(is_flat ? little() : mm(0.5), high_ - top_);
        const std::string old = word(Z, clear_);
        const std::string low = word(Z, high_ - by);
        fault("safe height in a clamp", "failed", "fixture-contact", {}, [=](Draft& d) {
            d.replace(up, old, low);
            return where;
        });
    }
    fault("offset that nobody tells", "not-proven", "offset-guess", {}, [=](Draft& d) {
        d.insert_before(where, "G55");
        return where + 1;
    });
}

void Writer::retract(bool closed) {
    clear_line_ = go("G0", {{Z, clear_}});
    if (closed) closed_ = clear_line_;
}

void Writer::cut(const Feature& f) {
    switch (f.kind) {
        case Kind::OpenSlot: open_slot(f); break;
        case Kind::Loop: loop(f); break;
        case Kind::Pocket: pocket(f); break;
        case Kind::Helix: helix(f); break;
        case Kind::Arcs: arcs(f); break;
        case Kind::Drilling: drilling(f); break;
        case Kind::Incremental: incremental(f); break;
        case Kind::Rotated: rotated(f); break;
        case Kind::Side: side_slot(f); break;
    }
}

}  // namespace ncsim::test::set_ups
