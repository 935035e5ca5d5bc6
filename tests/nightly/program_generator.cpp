// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses stock, tools and motions of random programs.
#include "nightly/program_generator.h"

#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace ncsim::nightly {

namespace {

constexpr double kPi = std::numbers::pi;

// Size of a program in mm, and number of decimals.
struct Scale {
    explicit Scale(test::Random& random) {
        // Mostly sizes of a workshop, sometimes anything from 0.01 mm to 5 m.
        size_mm = random.one_in(3) ? std::pow(10.0, random.within(-2.0, 3.7))
                                   : std::pow(10.0, random.within(0.7, 2.3));
        inches = random.one_in(6);
        // Fine enough that arcs remain valid when the ends are rounded; at most six decimals.
        int least = 0;
        double ticks = size_mm / (inches ? 25.4 : 1.0);
        for (; least < 6 && ticks < 3e5; ++least)
            ticks *= 10.0;
        decimals = static_cast<int>(random.between(least, 6));
        if (random.one_in(2)) decimals = std::max(decimals, 5);
    }
    double size_mm = 1.0;
    bool inches = false;
    int decimals = 3;
};

struct ToolTicks {
    Ticks radius = 1, length = 1;
};

class Generator {
public:
    explicit Generator(std::uint64_t seed, bool turning = false)
        : random_(seed),
          scale_(random_),
          nc_(scale_.inches, scale_.decimals),
          only_turns_(turning) {
        program_.seed = seed;
    }

    Program operator()() {
        choose_stock();
        choose_tools();
        choose_tolerances();
        nc_.begin(random_.one_in(4), random_place());
        line();
        const auto features = random_.between(1, 6);
        for (Ticks i = 0; i < features; ++i) {
            change_modes();
            feature();
        }
        nc_.end();
        program_.text = nc_.text();
        program_.moves = nc_.moves();
        return std::move(program_);
    }

private:
    // --- Stock and tools ---

    // A single argument, because a value may begin with a minus.
    void option(const std::string& name, const std::string& value) {
        std::string text = name;
        text += '=';
        program_.arguments.push_back(text += value);
    }
    std::string mm_text(Ticks t) const { return decimal(nc_.mm(t), 9); }
    std::string triple_text(const Triple& t) const {
        return mm_text(t[0]) + "," + mm_text(t[1]) + "," + mm_text(t[2]);
    }

    template <class... Values>
    double one_of(Values... values) {
        const std::array<double, sizeof...(Values)> all{values...};
        return all[static_cast<std::size_t>(random_.between(0, sizeof...(Values) - 1))];
    }

    void choose_stock() {
        StockShape& stock = program_.stock;
        Triple extent{};
        for (Ticks& e : extent) {
            e = 2 * std::max<Ticks>(8, nc_.ticks(scale_.size_mm * random_.within(0.1, 0.5)));
        }
        stock.is_round = random_.one_in(6);
        if (stock.is_round) extent[1] = extent[0];
        // Beyond 100 m a stock is refused.
        is_far_ = !only_turns_ && random_.one_in(12) && scale_.size_mm < 1000.0;
        for (std::size_t i = 0; i < 3; ++i) {
            // The program's zero is at either side or in the middle.
            min_[i] = -extent[i] / 2 * random_.between(0, 2);
            if (is_far_) min_[i] += nc_.ticks(scale_.size_mm * random_.within(-20.0, 20.0));
            max_[i] = min_[i] + extent[i];
            stock.min[i] = nc_.mm(min_[i]);
            stock.max[i] = nc_.mm(max_[i]);
        }
        std::string text;
        if (stock.is_round) {
            const Triple foot{min_[0] + extent[0] / 2, min_[1] + extent[1] / 2, min_[2]};
            text += 'D';
            text += mm_text(extent[0]) + "x" + mm_text(extent[2]) + "@" + triple_text(foot);
        } else {
            text = triple_text(min_) + ":" + triple_text(max_);
        }
        option("--stock", text);
    }

    void choose_tools() {
        const auto count = random_.between(1, 3);
        for (Ticks i = 1; i <= count; ++i) {
            std::string text(1, 'T');
            text += std::to_string(i) + "=";
            program_.tools.push_back(choose_tool(text));
            option("--tool", text);
        }
    }

    // Chooses a tool and appends its `--tool` value to `text`.
    RoundTool choose_tool(std::string& text) {
        const double size = scale_.size_mm;
        ToolTicks t;
        t.radius = std::max<Ticks>(4, nc_.ticks(size * std::pow(10.0, random_.within(-2.0, -0.6))));
        const double shortest = only_turns_ ? -0.3 : -1.0;
        t.length =
            std::max<Ticks>(4, nc_.ticks(size * std::pow(10.0, random_.within(shortest, 0.3))));
        tools_.push_back(t);
        const double d = nc_.mm(2 * t.radius);
        const double l = nc_.mm(t.length);
        const auto begin_shape = [&](const char* kind) {
            text += kind;
            text += ":D" + mm_text(2 * t.radius);
        };
        const auto flutes = [&](Ticks length) {
            tools_.back().length = length;
            text += ":L" + mm_text(length);
            return nc_.mm(length);
        };
        const auto begin = [&](const char* kind) {
            begin_shape(kind);
            (void)flutes(t.length);
        };
        // Height (mm) of a cone from the tip diameter to the diameter.
        const auto height_of_cone = [&](double tip, double half_angle) {
            return (d - tip) / 2 / std::tan(half_angle * std::numbers::pi / 180.0);
        };
        // ncsim refuses flutes that are shorter than the cone.
        const auto flutes_of_cone = [&](double tip, double angle) {
            return flutes(std::max(t.length, nc_.ticks(height_of_cone(tip, angle / 2)) + 1));
        };
        // Returns a part of `most`, or 0 with probability 1 / `n`.
        const auto some = [&](const char* letter, Ticks most, Ticks n) {
            if (random_.one_in(n)) return 0.0;
            const Ticks value = random_.between(1, std::max<Ticks>(1, most));
            text += letter + mm_text(value);
            return nc_.mm(value);
        };
        const auto angle = [&](double degrees) {
            text += ":A" + decimal(degrees, 3);
            return degrees;
        };
        constexpr Ticks kNever = 1 << 30;
        switch (random_.between(0, 10)) {
            case 0:
            case 1: begin("flat"); return RoundTool::end_mill(d, 0.0, l);
            case 2: begin("ball"); return RoundTool::end_mill(d, d / 2, l);
            case 3: begin("bull"); return RoundTool::end_mill(d, some(":R", t.radius, kNever), l);
            case 4: begin("face"); return RoundTool::end_mill(d, some(":R", t.radius, 2), l);
            case 5: {
                begin_shape(random_.one_in(2) ? "v" : "chamfer");
                const double tip = some(":P", 2 * t.radius, 2);
                const double any = static_cast<double>(random_.between(10, 170));
                const double usual = one_of(30.0, 45.0, 60.0, 90.0, 120.0);
                const double point = angle(random_.one_in(4) ? any : usual);
                return RoundTool::cone(d, tip, point, flutes_of_cone(tip, point));
            }
            case 6: {
                begin_shape("drill");
                const double point = angle(one_of(90.0, 118.0, 130.0, 135.0, 140.0));
                return RoundTool::cone(d, 0.0, point, flutes_of_cone(0.0, point));
            }
            case 7: {
                begin("slot");
                const double corner = some(":R", std::min(t.radius, t.length), 2);
                return RoundTool::end_mill(d, corner, l);
            }
            case 8: {
                // Catalogues list 60 between floor and flank, small angles from the axis.
                begin_shape("dovetail");
                const double listed = angle(one_of(1.0, 10.0, 15.0, 30.0, 45.0, 60.0));
                const double taper = listed == 60.0 ? 30.0 : listed;
                // ncsim refuses flutes that reach near the apex.
                const Ticks most = nc_.ticks(0.9 * height_of_cone(0.0, taper));
                const double height =
                    flutes(std::clamp<Ticks>(t.length, 1, std::max<Ticks>(1, most)));
                return RoundTool::dovetail(d, taper, height);
            }
            case 9:
                tools_.back().length = 2 * t.radius;
                text += "lollipop:D" + mm_text(2 * t.radius);
                return RoundTool::lollipop(d);
            default: {
                begin("taper");
                const double corner = some(":R", t.radius, 2);
                const double taper = angle(one_of(0.5, 1.0, 3.0, 5.0, 10.0, 20.0, 45.0));
                return RoundTool::tapered(d, corner, taper, l);
            }
        }
    }

    void choose_tolerances() {
        // Returns a value with three digits in the range that `ncsim run` accepts.
        const auto choose = [&](const char* name, double mm) {
            std::array<char, 32> text{};
            std::snprintf(text.data(), text.size(), "%.2e", std::clamp(mm, 1e-4, 10.0));
            option(name, text.data());
            return std::strtod(text.data(), nullptr);
        };
        double largest = 0.0;
        for (const RoundTool& tool : program_.tools)
            largest = std::max(largest, tool.radius());
        // Tolerances finer than the lattice permits make polygons of a thousand sides
        // (tool_polytope.h), which are slow.
        const double unit = 1e-5 * std::max(1.0, scale_.size_mm / 100);
        const double finest = random_.one_in(20) ? 0.0 : 3 * std::sqrt(largest * unit);
        program_.tolerance_mm =
            choose("--tolerance", scale_.size_mm * std::pow(10.0, random_.within(-4.0, -2.3)));
        program_.tool_tolerance_mm =
            choose("--tool-tolerance",
                   std::max(finest, largest * std::pow(10.0, random_.within(-2.3, -1.3))));
    }

    // --- Positions ---

    const ToolTicks& tool() const { return tools_[nc_.tool()]; }
    Ticks extent(std::size_t axis) const { return max_[axis] - min_[axis]; }
    Ticks above() const { return max_[2] + extent(2) / 4; }

    // Returns a coordinate along an axis, mostly a coordinate that gives coincidences.
    Ticks coordinate(std::size_t axis) {
        const Ticks reach = axis == 2 ? tool().length : tool().radius;
        const Ticks sign = random_.one_in(2) ? 1 : -1;
        switch (random_.between(0, 9)) {
            case 0:
            case 1:
            case 2: return min_[axis] + extent(axis) * random_.between(-1, 9) / 8;
            case 3: return (random_.one_in(2) ? min_ : max_)[axis] + nearly(sign * reach);
            case 4: return nc_.at().x[axis] + nearly(0);
            case 5: return nc_.at().x[axis] + nearly(sign * 2 * reach);
            default:
                return min_[axis] + static_cast<Ticks>(static_cast<double>(extent(axis)) *
                                                       random_.within(-0.2, 1.2));
        }
    }
    Triple random_place() { return {coordinate(0), coordinate(1), coordinate(2)}; }

    // Returns `t`, mostly exactly, otherwise `t` plus a few ticks or nanometres.
    Ticks nearly(Ticks t) {
        if (!random_.one_in(3)) return t;
        if (random_.one_in(2)) return t + random_.between(-2, 2);
        return t + nc_.ticks(1e-6 * static_cast<double>(random_.between(-100, 100)));
    }

    // Returns 1 to 100 nm, rounded to the resolution of the program.
    Ticks thickness() {
        const double nm = one_of(1.0, 2.0, 5.0, 10.0, 10.0, 20.0, 30.0, 50.0, 100.0);
        return std::max<Ticks>(1, nc_.ticks(nm * 1e-6));
    }

    std::size_t some_axis() { return static_cast<std::size_t>(random_.between(0, 2)); }

    // --- Motions ---

    // Estimates the number of hulls of a move (docs/accuracy.md). Programs are kept small.
    double hulls_of(const Course& course) const {
        const RoundTool& tool = program_.tools[nc_.tool()];
        const double tolerance = program_.tolerance_mm;
        double hulls = 1.0;
        if (const auto& c = course.circling()) {
            hulls += std::abs(c->sweep) * std::sqrt(c->start_radius / (8 * tolerance));
        }
        if (course.turns()) {
            const Vec turn = course.to().turn - course.from().turn;
            const double angle =
                (std::abs(turn[0]) + std::abs(turn[1]) + std::abs(turn[2])) * kPi / 180.0;
            const double reach = tool.height() + tool.radius();
            const double path = norm(course.to().x - course.from().x);
            const double far = std::max(norm(course.from().x), norm(course.to().x)) + reach;
            hulls += std::sqrt((angle * angle * far + 2 * angle * path) / (8 * tolerance));
            hulls += angle * (reach + tool.radius()) / (40 * tolerance);
        }
        return hulls;
    }

    bool fits(const Course& course) {
        const double most = only_turns_ ? 1500.0 : 250.0;
        const double more = hulls_of(course);
        if (hulls_ + more > most) return false;
        hulls_ += more;
        return true;
    }

    std::string feed() {
        if (feed_known_ && !random_.one_in(4)) return {};
        feed_known_ = true;
        std::string word = " F";
        return word += std::to_string(10 * random_.between(1, 20));
    }

    std::array<bool, 3> some_repeats() {
        return {random_.one_in(3), random_.one_in(3), random_.one_in(3)};
    }

    bool straight(const Place& to, bool rapid) {
        if (to == nc_.at() || !fits(nc_.way(to))) return false;
        nc_.straight(to, rapid, some_repeats(), rapid ? std::string() : feed());
        return true;
    }

    void change_modes() {
        if (random_.one_in(4)) nc_.set_incremental(!nc_.is_incremental());
        if (random_.one_in(10)) {
            Triple name{};
            for (std::size_t i = 0; i < 3; ++i)
                name[i] = random_.one_in(2) ? 0 : nc_.named(i, coordinate(i));
            nc_.name_place(name);
        }
        if (tools_.size() > 1 && random_.one_in(3)) {
            nc_.change_tool(static_cast<std::size_t>(
                random_.between(0, static_cast<Ticks>(tools_.size()) - 1)));
        }
    }

    // --- Features ---

    void feature() {
        if (only_turns_) return random_.one_in(4) ? turn() : turn_and_move();
        switch (random_.between(0, 11)) {
            case 0:
            case 1: line(); break;
            case 2: retrace(); break;
            case 3: thin_wall(); break;
            case 4: thin_floor(); break;
            case 5:
            case 6:
            case 7: arcs(); break;
            case 8: holes(); break;
            case 9: turn(); break;
            default: turn_and_move(); break;
        }
    }

    void line() {
        const auto count = random_.between(1, 3);
        for (Ticks i = 0; i < count; ++i) {
            Place to = nc_.at();
            if (random_.one_in(2)) {
                const std::size_t axis = some_axis();
                to.x[axis] = coordinate(axis);
            } else {
                to.x = random_place();
            }
            straight(to, i > 0 && random_.one_in(5));
        }
        if (!feed_known_) {  // a program without a cutting move is refused
            Place to = nc_.at();
            to.x[0] = to.x[0] == max_[0] ? min_[0] : max_[0];
            straight(to, false);
        }
    }

    // Writes a move there and back, on the same path or slightly off.
    void retrace() {
        Place back = nc_.at();
        Place end = back;
        end.x = random_place();
        if (!straight(end, false)) return;
        if (random_.one_in(2)) back.x[some_axis()] += nearly(0);
        straight(back, false);
    }

    // Returns both ends of a cut along an axis: across the stock, or within the stock.
    std::array<Ticks, 2> ends(std::size_t axis) {
        const Ticks beyond = random_.one_in(2) ? 2 * tool().radius : -extent(axis) / 4;
        return {min_[axis] - beyond, max_[axis] + beyond};
    }

    bool stand_upright() {
        Place to = nc_.at();
        to.turn = {};
        straight(to, true);
        return nc_.at().turn == Triple{};
    }

    // Writes two adjacent passes with a thin wall between them.
    void thin_wall() {
        if (!stand_upright()) return;
        const std::size_t along = random_.one_in(2) ? 0 : 1;
        const std::size_t aside = 1 - along;
        const Ticks step = 2 * tool().radius + thickness();
        const auto [begin, end] = ends(along);
        Triple x{};
        x[along] = begin;
        x[aside] = min_[aside] + extent(aside) * random_.between(1, 7) / 8 - tool().radius;
        x[2] = min_[2] + extent(2) * random_.between(0, 6) / 8;
        for (const Ticks moved : {Ticks{0}, step}) {
            Place to = nc_.at();
            to.x[2] = above();
            straight(to, true);
            to.x[along] = begin;
            to.x[aside] = x[aside] + moved;
            straight(to, true);
            to.x[2] = x[2];
            straight(to, false);
            to.x[along] = end;
            straight(to, false);
        }
        Place up = nc_.at();
        up.x[2] = above();
        straight(up, true);
        const double top = std::min(nc_.mm(max_[2]), nc_.mm(x[2] + tool().length));
        for (int i = 0; i < 6; ++i) {
            Vec p{};
            p[along] = random_.within(nc_.mm(begin), nc_.mm(end));
            p[aside] = nc_.mm(x[aside]) + nc_.mm(step) / 2;
            p[2] = random_.within(nc_.mm(x[2]), top);
            program_.probes.push_back(p);
        }
    }

    // Writes two passes with a thin floor between the top of the tool in the first pass and the tip
    // in the second.
    void thin_floor() {
        if (!stand_upright()) return;
        const std::size_t along = random_.one_in(2) ? 0 : 1;
        const Ticks thick = thickness();
        const auto [begin, end] = ends(along);
        Triple x = random_place();
        x[along] = begin;
        x[2] = min_[2] + extent(2) * random_.between(-1, 6) / 8;
        for (int pass = 0; pass < 2; ++pass) {
            Place to = nc_.at();
            to.x[along] = begin;
            straight(to, true);
            to.x = x;
            straight(to, true);
            to.x[along] = end;
            straight(to, false);
            if (pass == 0) x[2] += tool().length + thick;
        }
        for (int i = 0; i < 6; ++i) {
            Vec p{nc_.mm(x[0]), nc_.mm(x[1]), nc_.mm(x[2]) - nc_.mm(thick) / 2};
            p[along] = random_.within(nc_.mm(begin), nc_.mm(end));
            program_.probes.push_back(p);
        }
    }

    void arcs() {
        const auto count = random_.between(1, 3);
        const Plane& plane = kPlanes[some_axis()];
        for (Ticks i = 0; i < count; ++i)
            arc(plane);
    }

    void arc(const Plane& plane) {
        // Below some micrometres an arc is refused (docs/dialect.md).
        const double radius = scale_.size_mm * std::pow(10.0, random_.within(-1.7, -0.2));
        if (radius < 0.004) return;
        ArcMove arc;
        arc.plane = plane;
        arc.counter_clockwise = random_.one_in(2);
        const double towards = random_.one_in(2)
                                   ? kPi / 2 * static_cast<double>(random_.between(0, 3))
                                   : random_.within(0.0, 2 * kPi);
        arc.centre = {nc_.ticks(radius * std::cos(towards)), nc_.ticks(radius * std::sin(towards))};
        arc.to = nc_.at();
        const bool is_full = random_.one_in(6);
        const double angle = random_.one_in(3)
                                 ? kPi / 2 * static_cast<double>(random_.between(1, 3))
                                 : random_.within(0.05, 2 * kPi - 0.05);
        if (!is_full) {
            const double a = arc.counter_clockwise ? angle : -angle;
            const double x = -nc_.mm(arc.centre[0]);
            const double y = -nc_.mm(arc.centre[1]);
            arc.to.x[plane.first] += arc.centre[0] + nc_.ticks(std::cos(a) * x - std::sin(a) * y);
            arc.to.x[plane.second] += arc.centre[1] + nc_.ticks(std::sin(a) * x + std::cos(a) * y);
        }
        if (random_.one_in(3)) arc.to.x[plane.third] = coordinate(plane.third);
        if (may_turn() && random_.one_in(8)) {
            arc.to.turn[some_axis()] += kDegree * random_.between(-30, 30);
        }
        if (random_.one_in(5)) arc.turns = static_cast<int>(random_.between(1, 3));
        // R is ambiguous for a full circle, and inaccurate for half a circle.
        if (!is_full && arc.turns == 0 && std::abs(angle - kPi) > 0.2 && random_.one_in(3)) {
            arc.radius = nc_.ticks(angle > kPi ? -radius : radius);
        }
        const auto course = nc_.way(arc);
        if (course && fits(*course)) nc_.arc(arc, some_repeats(), feed());
    }

    void holes() {
        Drilling d;
        d.plane = kPlanes[random_.one_in(3) ? some_axis() : 0];
        const std::size_t depth = d.plane.third;
        d.r = coordinate(depth);
        d.bottom = d.r - std::max<Ticks>(1, extent(depth) * random_.between(1, 12) / 10);
        d.to_r = random_.one_in(2);
        constexpr std::array<const char*, 7> kCodes{"G81", "G82", "G83", "G73",
                                                    "G85", "G86", "G89"};
        const auto code = static_cast<std::size_t>(random_.between(0, 6));
        d.code = kCodes[code];
        if (code == 2 || code == 3)
            d.peck = std::max<Ticks>(1, (d.r - d.bottom) / random_.between(1, 5));
        if (code == 1 || code >= 5) d.words = " P0.1";
        d.words += feed();
        if (nc_.is_incremental()) d.repeats = random_.between(1, 3);
        const auto count = nc_.is_incremental() ? 1 : random_.between(1, 3);
        for (Ticks i = 0; i < count; ++i)
            d.holes.push_back(random_place());
        nc_.drill(d);
    }

    // Far from the axes each step of a rotary move is long.
    bool may_turn() const { return !is_far_; }

    Ticks angle() {
        if (random_.one_in(2)) return kDegree * 15 * random_.between(-12, 12);
        if (random_.one_in(3)) return kDegree * 90 * random_.between(-4, 4);
        return random_.between(-180 * kDegree, 180 * kDegree);
    }

    // Writes a move to an indexed position, and a cut there.
    void turn() {
        if (!may_turn()) return line();
        Place to = nc_.at();
        if (random_.one_in(2)) {
            to.x[2] = above();
            straight(to, true);
        }
        to.turn[some_axis()] = angle();
        if (random_.one_in(3)) to.turn[some_axis()] = angle();
        straight(to, random_.one_in(2));
        line();
    }

    void turn_and_move() {
        if (!may_turn()) return line();
        Place to = nc_.at();
        if (!random_.one_in(3)) to.x = random_place();
        for (Ticks& turn : to.turn) {
            if (random_.one_in(2)) turn += random_.between(-60 * kDegree, 60 * kDegree);
        }
        straight(to, random_.one_in(4));
    }

    test::Random random_;
    Scale scale_;
    NcWriter nc_;
    Program program_;
    bool only_turns_ = false;
    bool is_far_ = false;
    Triple min_{}, max_{};  // corners of the stock
    std::vector<ToolTicks> tools_;
    bool feed_known_ = false;
    double hulls_ = 0.0;
};

}  // namespace

Program random_program(std::uint64_t seed) {
    return Generator(seed)();
}

Program random_turning_program(std::uint64_t seed) {
    return Generator(seed, true)();
}

}  // namespace ncsim::nightly
