// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/set_ups.h"

#include "support/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace ncsim::test {

namespace {

// Lengths are whole steps of the program: 1 um, or 0.0001 inch.
using Length = std::int64_t;
enum Axis : std::size_t { X, Y, Z };
constexpr std::array<char, 3> kLetters{'X', 'Y', 'Z'};

std::string decimal(std::int64_t value, int places) {
    std::string digits = std::to_string(std::abs(value));
    const auto least = static_cast<std::size_t>(places) + 1;
    if (digits.size() < least) digits.insert(0, least - digits.size(), '0');
    digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
    while (digits.back() == '0')
        digits.pop_back();
    return (value < 0 ? "-" : "") + digits;
}

struct Fixture {
    const char* name;
    std::array<Length, 3> min, max;
};

struct Tool {
    std::string kind;
    Length diameter = 0, flutes = 0, corner = 0, neck = 0, neck_length = 0, shank = 0;
    Length stick_out = 0, holder = 0;
    Length blind = 0;                                     // that does not cut about the axis
    Length longer_than = 0;                               // flutes, whatever is cut
    Length deepest = 0, highest_cut = 0;                  // below the top; in one pass
    std::vector<std::pair<std::size_t, Length>> heights;  // line, cut sideways
    std::size_t first_cut = 0, change = 0, spindle = 0, length = 0;  // lines
    bool told = true;
    bool slopes = false;
    bool has_cut = false;  // of which first_cut is the line, or 0: it is in a loop
};

// Everything that becomes files and options.
struct Draft {
    std::vector<std::string> lines;
    std::vector<Tool> tools;
    std::array<Length, 3> travel_min{}, travel_max{}, zero{}, start{};
    bool start_told = true;
    std::vector<Fixture> fixtures;
    Length below_stock = 0;
    std::array<Length, 3> stock_min{}, stock_max{};
    bool inches = false;

    // Lines count from 1.
    std::string& line(std::size_t number) { return lines.at(number - 1); }
    void insert_before(std::size_t number, const std::string& text) {
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(number) - 1, text);
    }
    void replace(std::size_t number, std::string_view old, const std::string& text) {
        std::string& there = line(number);
        const std::size_t at = there.find(old);
        if (at == std::string::npos)
            throw std::logic_error("no " + std::string(old) + " in " + there);
        there.replace(at, old.size(), text);
    }
    // A comment instead, so that all lines keep their numbers.
    void drop(std::size_t number) { line(number) = "(dropped)"; }
};

struct Fault {
    std::string name, verdict, tells;
    std::set<std::string> may_tell;
    /// Puts it in, and says in which line it shows; 0: somewhere.
    std::function<std::size_t(Draft&)> put_in;
};

// What a tool that is where it should not be meets besides.
const std::set<std::string> kCollisions{"rapid-in-material", "fixture-contact",
                                        "non-cutting-contact", "below-stock", "over-travel"};

class Writer {
public:
    explicit Writer(std::uint64_t seed) : random_(seed) {}

    void run() {
        draft_.inches = random_.one_in(6);
        choose_features();
        lay_out();
        write();
        finish_tools();
        set_machine();
        general_faults();
    }

    const Draft& draft() const { return draft_; }
    const std::vector<Fault>& faults() const { return faults_; }
    Random& random() { return random_; }

private:
    enum class Kind { OpenSlot, Loop, Pocket, Helix, Arcs, Drilling, Incremental, Rotated, Side };
    struct Feature {
        Kind kind = Kind::OpenSlot;
        std::size_t tool = 0;
        Length width = 0, x0 = 0;  // of its strip of the block
        Length depth = 0;
        std::vector<Length> passes;  // depths
        Length room = 0;             // from the middle of the strip for the middle of the tool
    };

    template <typename T>
    T one_of(std::initializer_list<T> choices) {
        return choices.begin()[random_.next() % choices.size()];
    }
    bool happens(int percent) { return random_.between(1, 100) <= percent; }
    Length mm(double value) const {
        return std::llround(value * 1000.0 / (draft_.inches ? 2.54 : 1.0));
    }
    Length within(double low, double high) { return random_.between(mm(low), mm(high)); }
    // Nothing, the least there is, or so much.
    Length margin(double low, double high) {
        return happens(35) ? 0 : happens(25) ? 1 : within(low, high);
    }
    Length little() { return one_of({Length{1}, Length{10}, Length{100}, Length{1000}}); }

    std::string number(Length value) const { return decimal(value, draft_.inches ? 4 : 3); }
    std::string word(Axis axis, Length value) const { return kLetters[axis] + number(value); }

    void fault(std::string name, std::string verdict, std::string tells,
               std::set<std::string> may_tell, std::function<std::size_t(Draft&)> put_in) {
        faults_.push_back({std::move(name), std::move(verdict), std::move(tells),
                           std::move(may_tell), std::move(put_in)});
    }

    // --- what is made of what

    void choose_features() {
        const std::int64_t tools = random_.between(1, 3);
        for (std::int64_t i = 0; i < tools; ++i) {
            Tool tool;
            tool.kind =
                one_of({"flat", "flat", "flat", "ball", "bull", "drill", "face", "v", "slot"});
            tool.diameter = 2 * (tool.kind == "face"   ? within(10, 18)
                                 : tool.kind == "slot" ? within(6, 10)
                                                       : within(1.5, 7));
            if (tool.kind == "bull") tool.corner = tool.diameter / random_.between(4, 8);
            draft_.tools.push_back(tool);
            for (std::int64_t n = random_.between(1, 2); n > 0; --n)
                features_.push_back(feature_for(draft_.tools.size() - 1));
        }
    }

    Feature feature_for(std::size_t index) {
        const Tool& tool = draft_.tools[index];
        Feature f;
        f.tool = index;
        if (tool.kind == "face" || tool.kind == "v") {
            f.kind = Kind::OpenSlot;
        } else if (tool.kind == "drill") {
            f.kind = one_of({Kind::Drilling, Kind::Drilling, Kind::Incremental});
        } else if (tool.kind == "slot") {
            f.kind = Kind::Side;
        } else {
            f.kind = one_of({Kind::OpenSlot, Kind::Loop, Kind::Pocket, Kind::Pocket, Kind::Helix,
                             Kind::Arcs, Kind::Incremental, Kind::Rotated});
        }
        f.room = within(2, 6);
        f.width = tool.diameter + 2 * f.room + 2 * within(0.5, 2);
        // Cones cut no higher than they are, and one pass has to do for what is not round a shank.
        const bool single = tool.kind == "v" || tool.kind == "face" || tool.kind == "slot" ||
                            f.kind == Kind::Rotated;
        const std::int64_t passes = single ? 1 : random_.between(1, 3);
        Length pass = within(0.5, 4);
        if (tool.kind == "v") pass = std::min(pass, tool.diameter / 2 - mm(0.3));
        if (tool.kind == "face") pass = tool.diameter / 10 + within(0.2, 1);
        if (tool.kind == "drill") pass = within(3, 12);
        for (std::int64_t i = 1; i <= passes; ++i)
            f.passes.push_back(i * pass);
        if (tool.kind == "slot") f.passes = {within(6, 10)};
        f.depth = f.passes.back();
        return f;
    }

    bool is_open(const Feature& f) const {
        return f.kind == Kind::OpenSlot || f.kind == Kind::Loop || f.kind == Kind::Side;
    }

    void lay_out() {
        Length deepest = 0, open = 0;
        for (const Feature& f : features_) {
            deepest = std::max(deepest, f.depth);
            if (is_open(f)) open = std::max(open, f.depth);
        }
        const Length height = deepest + within(6, 20);
        Length at = within(-60, 20);
        draft_.stock_min = {at, within(-50, 10), 0};
        draft_.stock_max[Y] = draft_.stock_min[Y] + within(50, 80);
        top_ = one_of({Length{0}, height, within(-60, -30), within(-10, 10)});
        draft_.stock_max[Z] = top_;
        draft_.stock_min[Z] = top_ - height;

        // Strips in an order of their own, so that the way from one to the next crosses others.
        std::vector<std::size_t> order(features_.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[random_.next() % i]);
        const bool clamp = features_.size() > 1 && happens(60);
        const std::size_t before = clamp ? 1 + random_.next() % (features_.size() - 1) : 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (clamp && i == before) {
                clamp_min_ = at;
                at += within(8, 15);
                clamp_max_ = at;
            }
            features_[order[i]].x0 = at;
            at += features_[order[i]].width;
        }
        draft_.stock_max[X] = at;

        const Length far = mm(45);
        high_ = top_;
        if (clamp) {
            high_ += within(4, 12);
            draft_.fixtures.push_back({"clamp",
                                       {clamp_min_, draft_.stock_min[Y] - far, top_},
                                       {clamp_max_, draft_.stock_max[Y] + far, high_}});
        }
        clear_ = high_ + margin(1, 10);
        home_height_ = clear_ + margin(1, 60);
        // What is no higher than a clamp may meet it.
        draft_.start_told = home_height_ == high_ || happens(70);
        const int rest = static_cast<int>(random_.between(0, 2));
        if (rest == 0) {
            const Length jaw = open > 0 ? top_ - open - margin(0.1, 2) : top_ - mm(3);
            jaw_top_ = std::max(jaw, draft_.stock_min[Z] + 1);
            const Length low = draft_.stock_min[Z] - mm(10);
            draft_.fixtures.push_back(
                {"fixed jaw",
                 {draft_.stock_min[X] - far, draft_.stock_max[Y], low},
                 {draft_.stock_max[X] + far, draft_.stock_max[Y] + far, *jaw_top_}});
            draft_.fixtures.push_back(
                {"moving jaw",
                 {draft_.stock_min[X] - far, draft_.stock_min[Y] - far, low},
                 {draft_.stock_max[X] + far, draft_.stock_min[Y], *jaw_top_}});
            if (happens(50)) draft_.below_stock = mm(10);
        } else if (rest == 1) {
            const Length low = draft_.stock_min[Z];
            draft_.fixtures.push_back(
                {"table",
                 {draft_.stock_min[X] - far, draft_.stock_min[Y] - far, low - mm(20)},
                 {draft_.stock_max[X] + far, draft_.stock_max[Y] + far, low}});
            has_table_ = true;
        } else {
            draft_.below_stock = within(1, 8);
        }
    }

    // --- blocks

    std::size_t line(const std::string& text) {
        draft_.lines.push_back(text);
        return draft_.lines.size();
    }
    std::size_t next_line() const { return draft_.lines.size() + 1; }

    void reach(Axis axis, Length value, std::size_t where) {
        reached_[axis].push_back({where, value});
    }
    std::size_t go(const char* code, std::initializer_list<std::pair<Axis, Length>> to,
                   const std::string& more = {}) {
        std::string text = code;
        for (const auto& [axis, value] : to) {
            at_[axis] = value;
            reach(axis, value, next_line());
            text += ' ' + word(axis, value);
        }
        return line(text + more);
    }
    // Feed moves name F when they like to; the first has to.
    std::string feed() {
        if (has_feed_ && happens(60)) return {};
        return " F" +
               std::to_string(draft_.inches ? random_.between(4, 30) : random_.between(100, 900));
    }
    std::size_t feed_to(std::initializer_list<std::pair<Axis, Length>> to) {
        const std::string f = feed();
        const std::size_t where = go("G1", to, f);
        note_feed(where);
        return where;
    }
    void note_feed(std::size_t where) {
        if (has_feed_) return;
        has_feed_ = true;
        first_feed_ = where;
    }
    Tool& tool() { return draft_.tools[tool_]; }

    // This move cuts, by construction: no other feature is there.
    void cuts(std::size_t where, Length depth, Length sideways) {
        Tool& t = tool();
        if (!std::exchange(t.has_cut, true)) {
            t.first_cut = where;
            const char* const stop = one_of({"M5", "M19"});
            fault(stop == std::string_view("M5") ? "spindle stopped" : "spindle oriented", "failed",
                  "spindle-off", {}, [=](Draft& d) {
                      d.insert_before(where, stop);
                      return where + 1;
                  });
            fault("M0 before the cut", "not-proven", "spindle-after-stop", {}, [=](Draft& d) {
                d.insert_before(where, "M0");
                return where + 1;
            });
        }
        t.deepest = std::max(t.deepest, depth);
        if (sideways > 0) t.heights.emplace_back(where, sideways);
        t.highest_cut = std::max(t.highest_cut, sideways);
    }
    void cuts_if_rapid(std::size_t where) {
        fault("rapid instead of feed", "failed", "rapid-in-material", kCollisions, [=](Draft& d) {
            d.replace(where, "G1", "G0");
            return where;
        });
    }

    // --- from feature to feature

    void write() {
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

    void change_tool() {
        const std::string number = std::to_string(tool_ + 1);
        tool().change = line("T" + number + " M6");
        const std::string speed = "S" + std::to_string(random_.between(500, 9000));
        tool().spindle = line(speed + " M3");
        if (happens(30)) line("M8");
    }

    // To where a feature begins, above all.
    void traverse(Length x, Length y, bool above_stock) {
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

    void traverse_faults(Length from, Length to, std::size_t where) {
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

    void retract(bool closed) {
        clear_line_ = go("G0", {{Z, clear_}});
        if (closed) closed_ = clear_line_;
    }

    void cut(const Feature& f) {
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

    Length middle(const Feature& f) const { return f.x0 + f.width / 2; }
    Length radius() { return tool().diameter / 2; }
    Length middle_y() const { return (draft_.stock_min[Y] + draft_.stock_max[Y]) / 2; }

    // A tool beside the block at this depth is above the jaws, or in them.
    void jaw_fault(std::size_t where, Length z) {
        if (!jaw_top_) return;
        const bool is_flat = tool().kind == "flat" || tool().kind == "face";
        const std::string old = word(Z, z);
        const std::string deep = word(Z, *jaw_top_ - (is_flat ? little() : mm(0.8)));
        fault("deeper than the jaws are low", "failed", "fixture-contact", kCollisions,
              [=](Draft& d) {
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

    void open_slot(const Feature& f) {
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
            const std::size_t across =
                x == other ? feed_to({{Y, to}}) : feed_to({{X, other}, {Y, to}});
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

    // What does not cut at its centre, from above.
    void plunge_fault(std::size_t down) {
        const std::string into = "G0 " + word(Y, middle_y());
        fault("plunge of a face mill", "failed", "plunge", kCollisions, [=](Draft& d) {
            d.insert_before(down, into);
            return down + 1;
        });
    }

    // The same pass again and again, each a step deeper.
    void loop(const Feature& f) {
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
            fault("subprogram missing", "failed", "program-fault", {"no-feed"}, [=](Draft& d) {
                d.replace(call, "P" + name, "P4711");
                return call;
            });
        }
        const bool meets = jaw_top_ && top_ - f.depth - step < *jaw_top_ - mm(0.8);
        if (meets)
            fault("loop once too often", "failed", "fixture-contact", kCollisions, once_more);
        retract(false);
    }
    void cuts_in_loop(std::size_t where, Length step, Length depth) {
        Tool& t = tool();
        if (!std::exchange(t.has_cut, true)) t.first_cut = where;
        t.deepest = std::max(t.deepest, depth);
        t.highest_cut = std::max(t.highest_cut, step);
        t.heights.emplace_back(where, step);
    }

    Length lower_to_start() {
        const Length z = std::min(clear_, top_ + margin(0.5, 3));
        if (z < clear_) go("G0", {{Z, z}});
        return z;
    }

    void pocket(const Feature& f) {
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
                go("G0", {{X, cx + hx}});  // along the wall that is finished, and back
                go("G0", {{X, cx - hx}});
            }
            cuts(feed_to({{Y, cy - hy}}), depth, depth - before);
            before = depth;
        }
        clamp_fault(f);
        retract(true);
    }

    // The next pass around the pocket goes on sideways, into the clamp.
    void clamp_fault(const Feature& f) {
        const std::size_t here = next_line();
        const Length thinnest = radius() * 4 / 5;  // of the shank, which may be what is that high
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

    // Straight down by more than any ramp allows.
    void blind_fault(std::size_t where, Length by) {
        const Length blind = tool().diameter * 6 / 10;
        if (tool().kind != "flat" || by < blind / 10) return;
        const std::size_t index = tool_;
        fault("plunge of a mill with inserts", "failed", "plunge", {}, [=](Draft& d) {
            d.tools[index].blind = blind;
            return where;
        });
    }

    // The chords of a turn lie a rounding beside those of the last: flutes have to be longer.
    void spare(const Feature& f) {
        tool().slopes = true;
        tool().longer_than = std::max(tool().longer_than, f.passes.front() + mm(0.01));
    }
    void helix(const Feature& f) {
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
    void arc_note(std::size_t where, Length cx, Length cy, Length r) {
        note_feed(where);
        for (const Length side : {-r, r}) {
            reach(X, cx + side, where);
            reach(Y, cy + side, where);
        }
    }

    // A slot along three quarters of a circle.
    void arcs(const Feature& f) {
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
            const std::size_t second =
                go("G3", {{X, cx}, {Y, cy - r}}, " I0. J" + number(-r) + feed());
            reach(X, cx - r, second);
            cuts(second, depth, pass);
            const std::size_t back =
                go("G2", {{X, cx}, {Y, cy + r}}, " I0. J" + number(r) + feed());
            reach(X, cx - r, back);
            go("G2", {{X, cx + r}, {Y, cy}}, " I0. J" + number(-r) + feed());
        }
        retract(true);
    }

    void drilling(const Feature& f) {
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
        const std::size_t cycle = go((one_of({"G98 ", "G99 "}) + code).c_str(),
                                     {{X, x}, {Y, y}, {Z, bottom}}, more + feed());
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
        closed_.reset();  // it stands above already
    }

    void incremental(const Feature& f) {
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

    void rotated(const Feature& f) {
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

    // With a neck that is thinner than the cutter: in from the side, and out again.
    void side_slot(const Feature& f) {
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

    // --- tools and machine, once all is known

    void finish_tools() {
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
                // A round corner leaves some of the wall, which is the next pass's to cut.
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

    void tool_faults(std::size_t index, Length clamp) {
        const Tool& t = draft_.tools[index];
        // At the end of a ramp or a turn only, or in a corner, a micrometre shows nowhere.
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
        // The lowest the holder may begin is right above flutes and neck.
        const Length stick_out = t.deepest - by;
        const bool is_wide = std::ranges::all_of(features_, [&](const Feature& f) {
            return f.tool != index ||
                   (f.kind != Kind::Pocket && f.kind != Kind::Side && f.kind != Kind::Helix &&
                    f.kind != Kind::Arcs && f.kind != Kind::Rotated);
        });
        if (t.holder > 0 && is_wide && clamp == 0 && stick_out > t.diameter / 2 + mm(1)) {
            fault("holder in the part", "failed", "non-cutting-contact", {}, [=](Draft& d) {
                d.tools[index].stick_out = stick_out;
                return std::size_t{0};  // already beside the block, it may be above it
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

    static std::size_t first_above(const std::vector<std::pair<std::size_t, Length>>& all,
                                   Length limit) {
        for (const auto& [where, value] : all) {
            if (value > limit) return where;
        }
        return 0;
    }

    void length_faults(std::size_t index) {
        const std::size_t tools = draft_.tools.size();
        const std::size_t block = draft_.tools[index].length;
        // Only on the way down does the length count.
        const std::size_t where = home_height_ > clear_ ? block : 0;
        fault("tool that nobody describes", "failed", "tool-undefined", {"not-simulated"},
              [=](Draft& d) {
                  d.tools[index].told = false;
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

    void set_machine() {
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

    void travel_fault(Axis axis, Length end, int sign) {
        const Length limit = end - sign * little();
        std::size_t first = 0;
        for (const auto& [where, value] : reached_[axis]) {
            if (sign * value <= sign * limit) continue;
            if (where == 0) {  // somewhere in a loop
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

    void general_faults() {
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
            d.start_told = false;
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

    Random random_;
    Draft draft_;
    std::vector<Fault> faults_;
    std::vector<Feature> features_;
    Length top_ = 0, high_ = 0, clear_ = 0;  // of the block; of all; where traverses are
    Length home_height_ = 0;
    Length clamp_min_ = 0, clamp_max_ = 0;
    std::optional<Length> jaw_top_;
    bool has_table_ = false;

    std::array<Length, 3> at_{};
    std::size_t tool_ = 0;
    bool approaching_ = false, has_feed_ = false;
    std::size_t header_ = 0, home_ = 0, offset_ = 0, first_feed_ = 0, clear_line_ = 0;
    std::optional<std::size_t> closed_;  // line of the retract out of a closed pocket
    std::set<std::size_t> cancelled_;    // tools before which stands G49
    std::array<std::vector<std::pair<std::size_t, Length>>, 3> reached_;  // line and place
    std::array<std::vector<Length>, 3> within_;                           // nothing goes beyond
    std::vector<std::string> subprograms_;
};

Judged written(const Draft& d) {
    const auto mm = [&](Length value) { return decimal(value * (d.inches ? 254 : 100), 5) + "0"; };
    const auto point = [&](const std::array<Length, 3>& p) {
        return mm(p[X]) + ", " + mm(p[Y]) + ", " + mm(p[Z]);
    };
    Judged j;
    for (const std::string& line : d.lines)
        j.text += line + '\n';
    std::string machine = "name = \"mill\"\n";
    if (d.below_stock > 0) machine += "below_stock = " + mm(d.below_stock) + "\n";
    machine += d.fixtures.empty() ? "fixture = []\n" : "";
    machine += "[travel]\n";
    for (const Axis axis : {X, Y, Z}) {
        machine += static_cast<char>(kLetters[axis] + ('x' - 'X'));
        machine += " = [" + mm(d.travel_min[axis] + d.zero[axis]) + ", " +
                   mm(d.travel_max[axis] + d.zero[axis]) + "]\n";
    }
    machine += "[position]\nhome = [0, 0, 0]\n";
    if (d.start_told) {
        machine += "start = [" + mm(d.start[X] + d.zero[X]) + ", " + mm(d.start[Y] + d.zero[Y]) +
                   ", " + mm(d.start[Z] + d.zero[Z]) + "]\n";
    }
    machine += "[offsets]\nG54 = [" + point(d.zero) + "]\n";
    for (const Fixture& f : d.fixtures) {
        machine += "[[fixture]]\nname = \"" + std::string(f.name) + "\"\nbox = [[" + point(f.min) +
                   "], [" + point(f.max) + "]]\n";
    }
    for (std::size_t i = 0; i < d.tools.size(); ++i) {
        const Tool& t = d.tools[i];
        if (t.blind > 0) {
            machine += "[[tool]]\nnumber = " + std::to_string(i + 1) +
                       "\nblind_diameter = " + mm(t.blind) + "\n";
        }
        if (!t.told) continue;
        std::string text = "T" + std::to_string(i + 1) + "=" + t.kind + ":D" + mm(t.diameter) +
                           ":L" + mm(t.flutes);
        if (t.corner > 0) text += ":R" + mm(t.corner);
        if (t.kind == "v") text += ":A90";
        if (t.kind == "drill") text += ":A118";
        if (t.neck > 0) text += ":N" + mm(t.neck) + "x" + mm(t.neck_length);
        if (t.shank > 0) text += ":S" + mm(t.shank);
        if (t.holder > 0) text += ":E" + mm(t.stick_out) + ":H" + mm(t.holder) + "x40";
        j.options.insert(j.options.end(), {"--tool", text});
    }
    j.options.insert(
        j.options.end(),
        {"--stock", mm(d.stock_min[X]) + "," + mm(d.stock_min[Y]) + "," + mm(d.stock_min[Z]) + ":" +
                        mm(d.stock_max[X]) + "," + mm(d.stock_max[Y]) + "," + mm(d.stock_max[Z])});
    j.machine = machine;
    return j;
}

}  // namespace

Judged right_set_up(std::uint64_t seed) {
    Writer writer(seed);
    writer.run();
    return written(writer.draft());
}

std::set<std::string> faults_of(std::uint64_t seed) {
    Writer writer(seed);
    writer.run();
    std::set<std::string> names;
    for (const Fault& fault : writer.faults())
        names.insert(fault.name);
    return names;
}

Judged wrong_set_up(std::uint64_t seed, const std::string& name) {
    Writer writer(seed);
    writer.run();
    std::set<std::string> names;
    for (const Fault& fault : writer.faults())
        names.insert(fault.name);
    std::string wanted = name;
    if (!names.contains(name))
        wanted = *std::next(names.begin(), writer.random().between(0, std::ssize(names) - 1));
    std::vector<const Fault*> those;
    for (const Fault& fault : writer.faults()) {
        if (fault.name == wanted) those.push_back(&fault);
    }
    const Fault& fault = *those[writer.random().next() % those.size()];
    Draft draft = writer.draft();
    const std::size_t line = fault.put_in(draft);
    Judged judged = written(draft);
    judged.fault = fault.name;
    judged.verdict = fault.verdict;
    judged.tells = fault.tells;
    judged.line = line;
    judged.may_tell = fault.may_tell;
    return judged;
}

}  // namespace ncsim::test
